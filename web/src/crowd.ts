import {History, isShown} from './history';

/** The agents in the picture at one time, between two frames. Its arrays are reused. */
export class Crowd {
  count = 0;
  time = 0;
  id = new Uint32Array(0);
  x = new Float32Array(0);
  y = new Float32Array(0);
  heading = new Float32Array(0);
  speed = new Float32Array(0);
  walked = new Float32Array(0);
  state = new Uint8Array(0);

  /** Places all agents where they are at the given time. */
  interpolate(history: History, time: number): void {
    this.count = 0;
    this.time = time;
    if (history.moments.length === 0) {
      return;
    }
    const index = history.indexAt(time);
    const after = history.moments[index];
    const before = history.moments[Math.max(index - 1, 0)];
    const duration = after.time - before.time;
    const part = duration > 0 ? Math.min(Math.max((time - before.time) / duration, 0), 1) : 1;
    this.reserve(after.count);
    for (let i = 0; i < after.count; ++i) {
      if (!isShown(after.state[i])) {
        continue;
      }
      const j = index > 0 ? after.previous[i] : -1;
      const k = this.count++;
      const share = j < 0 ? 1 : part;
      const from = j < 0 ? after : before;
      const old = j < 0 ? i : j;
      this.id[k] = after.id[i];
      this.state[k] = after.state[i];
      this.x[k] = from.x[old] + share * (after.x[i] - from.x[old]);
      this.y[k] = from.y[old] + share * (after.y[i] - from.y[old]);
      this.speed[k] = from.speed[old] + share * (after.speed[i] - from.speed[old]);
      this.walked[k] = from.walked[old] + share * (after.walked[i] - from.walked[old]);
      const turn = after.heading[i] - from.heading[old];
      this.heading[k] = from.heading[old] + share * (turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI)));
    }
  }

  /** Returns the index of an agent, or -1. */
  find(id: number | null): number {
    if (id !== null) {
      for (let i = 0; i < this.count; ++i) {
        if (this.id[i] === id) {
          return i;
        }
      }
    }
    return -1;
  }

  private reserve(count: number): void {
    if (count <= this.x.length) {
      return;
    }
    const size = Math.ceil(1.5 * count);
    this.id = new Uint32Array(size);
    this.state = new Uint8Array(size);
    for (const name of ['x', 'y', 'heading', 'speed', 'walked'] as const) {
      this[name] = new Float32Array(size);
    }
  }
}
