const MAGIC = 0x57524331;
const HEADER_SIZE = 24;
const BYTES_PER_AGENT = 21;

export const ARRIVED = 1;
export const REMOVED = 2;
export const STATE_MASK = 15;
export const IN_CONTACT = 16;

/** All agents after a tick. */
export interface Frame {
  tick: number;
  /** [s] */
  time: number;
  count: number;
  id: Uint32Array;
  x: Float32Array;
  y: Float32Array;
  heading: Float32Array;
  speed: Float32Array;
  state: Uint8Array;
}

/** Reads a binary message. The frame's arrays are views of it. Fails if it is not a frame. */
export function decodeFrame(buffer: ArrayBuffer): Frame {
  const view = new DataView(buffer);
  if (buffer.byteLength < HEADER_SIZE || view.getUint32(0, true) !== MAGIC) {
    throw new Error('a binary message is not a frame');
  }
  const count = view.getUint32(16, true);
  if (buffer.byteLength !== HEADER_SIZE + BYTES_PER_AGENT * count) {
    throw new Error(`a frame of ${count} agents has ${buffer.byteLength} bytes`);
  }
  const start = (index: number) => HEADER_SIZE + 4 * index * count;
  return {
    tick: view.getUint32(4, true), time: view.getFloat64(8, true), count,
    id: new Uint32Array(buffer, start(0), count),
    x: new Float32Array(buffer, start(1), count),
    y: new Float32Array(buffer, start(2), count),
    heading: new Float32Array(buffer, start(3), count),
    speed: new Float32Array(buffer, start(4), count),
    state: new Uint8Array(buffer, start(5), count),
  };
}
