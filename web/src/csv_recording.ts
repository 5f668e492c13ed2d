import {Frame} from './frame';

const HEADER = 'instance,tick,agent,x,y';
const STANDING = 0.02;  // [m]; a shorter move does not turn a person

interface Track {
  heading: number;
  tick: number;
  x: number;
  y: number;
}

/** Reads the first instance of a recording in CSV. Fails at the first line that is not as expected. */
export function readRecording(csv: string, tickDuration: number): Frame[] {
  const ticks = readTicks(csv);
  const tracks = new Map<number, Track>();
  const frames = [...ticks.keys()].sort((a, b) => a - b).map((tick) =>
    makeFrame(tick, ticks.get(tick)!, tickDuration, tracks));
  if (frames.length > 1) {  // the first headings are those of the first moves
    const {id, heading} = frames[1];
    const headings = new Map(Array.from(id, (agent, i) => [agent, heading[i]]));
    frames[0].id.forEach((agent, i) => frames[0].heading[i] = headings.get(agent) ?? 0);
  }
  return frames;
}

/** Returns the rows of each tick: agent, x, y, one after the other. */
function readTicks(csv: string): Map<number, number[]> {
  const lines = csv.split(/\r?\n/);
  if (lines[0].trim() !== HEADER) {
    throw new Error(`line 1: expected ${HEADER}`);
  }
  const ticks = new Map<number, number[]>();
  let instance: number | undefined;
  for (let i = 1; i < lines.length; ++i) {
    if (lines[i] === '') {
      continue;
    }
    const cells = lines[i].split(',');
    const row = cells.map((cell) => cell.trim() === '' ? NaN : Number(cell));
    if (row.length !== 5 || !row.every(Number.isFinite)) {
      throw new Error(`line ${i + 1}: expected five numbers (${HEADER})`);
    }
    instance ??= row[0];
    if (row[0] === instance) {
      const rows = ticks.get(row[1]) ?? [];
      rows.push(row[2], row[3], row[4]);
      ticks.set(row[1], rows);
    }
  }
  if (ticks.size === 0) {
    throw new Error('no rows');
  }
  return ticks;
}

function makeFrame(tick: number, rows: number[], tickDuration: number, tracks: Map<number, Track>): Frame {
  const count = rows.length / 3;
  const frame: Frame = {
    tick, time: tick * tickDuration, count, id: new Uint32Array(count), x: new Float32Array(count),
    y: new Float32Array(count), heading: new Float32Array(count), speed: new Float32Array(count),
    state: new Uint8Array(count),
  };
  for (let i = 0; i < count; ++i) {
    const [id, x, y] = rows.slice(3 * i, 3 * i + 3);
    const track = tracks.get(id) ?? {heading: 0, tick, x, y};
    const length = Math.hypot(x - track.x, y - track.y);
    frame.speed[i] = tick > track.tick ? length / ((tick - track.tick) * tickDuration) : 0;
    const heading = length > STANDING ? Math.atan2(y - track.y, x - track.x) : track.heading;
    tracks.set(id, {heading, tick, x, y});
    frame.id[i] = id;
    frame.x[i] = x;
    frame.y[i] = y;
    frame.heading[i] = heading;
  }
  return frame;
}

/** Returns the smallest box around all places: x0, y0, x1, y1. */
export function boundsOf(frames: Frame[]): [number, number, number, number] {
  const bounds: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const {x, y} of frames) {
    for (let i = 0; i < x.length; ++i) {
      bounds[0] = Math.min(bounds[0], x[i]);
      bounds[1] = Math.min(bounds[1], y[i]);
      bounds[2] = Math.max(bounds[2], x[i]);
      bounds[3] = Math.max(bounds[3], y[i]);
    }
  }
  return bounds;
}
