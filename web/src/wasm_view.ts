import {Point, Scene} from './messages';
import {AgentArrays, WasmCrowd} from './wasm_module';

const MAGIC = 0x57524331;
const HEADER_SIZE = 24;
const BYTES_PER_AGENT = 21;
const IN_CONTACT = 16;  // added to a state
const MARGIN = 1;       // [m] of the bounds about what is there

/** Returns the binary frame of the present tick. */
export function frameOf(crowd: WasmCrowd): ArrayBuffer {
  const [tick, time, agents] = [crowd.tick(), crowd.time(), crowd.agents()];
  const count = agents.ids.length;
  const buffer = new ArrayBuffer(HEADER_SIZE + BYTES_PER_AGENT * count);
  const view = new DataView(buffer);
  view.setUint32(0, MAGIC, true);
  view.setUint32(4, tick, true);
  view.setFloat64(8, time, true);
  view.setUint32(16, count, true);
  const column = (index: number) => new Float32Array(buffer, HEADER_SIZE + 4 * index * count, count);
  new Uint32Array(buffer, HEADER_SIZE, count).set(agents.ids);
  const [x, y, heading, speed] = [1, 2, 3, 4].map(column);
  heading.set(agents.headings);
  const states = new Uint8Array(buffer, HEADER_SIZE + 20 * count, count);
  for (let i = 0; i < count; ++i) {
    x[i] = agents.positions[2 * i];
    y[i] = agents.positions[2 * i + 1];
    speed[i] = Math.hypot(agents.velocities[2 * i], agents.velocities[2 * i + 1]);
    states[i] = agents.statuses[i] + (agents.inContact[i] ? IN_CONTACT : 0);
  }
  return buffer;
}

/** Returns agents as a scene has them; only those of which the predicate is true. */
export function agentsOf(agents: AgentArrays, isWanted: (id: number, goal: Point) => boolean): Scene['agents'] {
  const found: Scene['agents'] = [];
  agents.ids.forEach((id, i) => {
    const goal: Point = [agents.goals[2 * i], agents.goals[2 * i + 1]];
    if (isWanted(id, goal)) {
      found.push({id, radius: agents.radii[i], goal});
    }
  });
  return found;
}

/** Returns the scene as it is now. */
export function sceneOf(crowd: WasmCrowd, scenario: string): Scene {
  const grid = crowd.map();
  const map = grid && {...grid, cells: toBase64(grid.cells)};
  const [walls, obstacles, robots] = [crowd.walls(), crowd.obstacles(), crowd.robots()];
  const arrays = crowd.agents();
  const points: Point[] = [...walls.flatMap(({from, to}) => [from, to]), ...obstacles.map(({position}) => position)];
  if (map) {
    const [x, y, yaw] = map.origin;
    for (const [i, j] of [[0, 0], [map.width, 0], [0, map.height], [map.width, map.height]]) {
      const [along, across] = [i * map.resolution, j * map.resolution];
      points.push([x + Math.cos(yaw) * along - Math.sin(yaw) * across,
        y + Math.sin(yaw) * along + Math.cos(yaw) * across]);
    }
  }
  for (const places of [arrays.positions, arrays.goals]) {
    for (let i = 0; i < places.length; i += 2) {
      points.push([places[i], places[i + 1]]);
    }
  }
  return {
    type: 'scene', scenario, tick_duration: crowd.tickDuration(), bounds: boundsAbout(points), walls, obstacles, map,
    agents: agentsOf(arrays, () => true), robots: robots.map(({name, radius}) => ({name, radius})),
  };
}

function boundsAbout(points: Point[]): Scene['bounds'] {
  const box: Scene['bounds'] = points.length > 0 ? [Infinity, Infinity, -Infinity, -Infinity] : [0, 0, 0, 0];
  for (const [x, y] of points) {
    box[0] = Math.min(box[0], x);
    box[1] = Math.min(box[1], y);
    box[2] = Math.max(box[2], x);
    box[3] = Math.max(box[3], y);
  }
  return [box[0] - MARGIN, box[1] - MARGIN, box[2] + MARGIN, box[3] + MARGIN];
}

function toBase64(bytes: Uint8Array): string {
  let text = '';
  bytes.forEach((byte) => text += String.fromCharCode(byte));
  return btoa(text);
}
