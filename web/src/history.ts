import {ARRIVED, Frame, REMOVED, STATE_MASK} from './frame';

/** A frame with what relates it to the frame before it. */
export interface Moment extends Frame {
  /** Index of each agent in the frame before; -1: it has just appeared. */
  previous: Int32Array;
  /** Way that each agent has walked [m]. */
  walked: Float32Array;
  /** Agents that have been in the picture so far, and are not any more. */
  arrived: number;
}

const LONGEST_MOVE = 3;  // [m]; further between two frames is not walked

/** Returns whether an agent is in the picture. */
export function isShown(state: number): boolean {
  const kind = state & STATE_MASK;
  return kind !== ARRIVED && kind !== REMOVED;
}

/** Frames in the order of time: the recent past of a live run, or a recording. */
export class History {
  readonly moments: Moment[] = [];
  private readonly indices = new Map<number, number>();
  private readonly seen = new Set<number>();

  /** capacity: agents in all frames together; the oldest frames make place for new ones. */
  constructor(private readonly capacity = Infinity) {}

  private stored = 0;

  get first(): Moment | undefined {
    return this.moments[0];
  }

  get last(): Moment | undefined {
    return this.moments[this.moments.length - 1];
  }

  /** Appends a frame. One of the last tick replaces the last; an earlier one begins anew. */
  append(frame: Frame): Moment {
    if (this.last && frame.tick < this.last.tick) {
      this.clear();
    } else if (this.last && frame.tick === this.last.tick) {
      this.stored -= this.moments.pop()!.count;
    }
    const moment = this.relate(frame, this.last);
    this.moments.push(moment);
    this.stored += frame.count;
    while (this.stored > this.capacity && this.moments.length > 2) {
      this.stored -= this.moments.shift()!.count;
    }
    return moment;
  }

  clear(): void {
    this.moments.length = 0;
    this.stored = 0;
    this.seen.clear();
  }

  /** Returns the index of the first moment that is not before the given time, at most that of the last. */
  indexAt(time: number): number {
    let low = 0;
    let high = this.moments.length - 1;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.moments[middle].time < time) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  private relate(frame: Frame, before: Moment | undefined): Moment {
    const previous = new Int32Array(frame.count).fill(-1);
    const walked = new Float32Array(frame.count);
    if (before) {
      this.findPrevious(frame, before, previous);
    }
    let shown = 0;
    for (let i = 0; i < frame.count; ++i) {
      const j = previous[i];
      const length = j < 0 ? 0 : Math.hypot(frame.x[i] - before!.x[j], frame.y[i] - before!.y[j]);
      if (length > LONGEST_MOVE) {
        previous[i] = -1;
      } else if (j >= 0) {
        walked[i] = before!.walked[j] + length;
      }
      if (isShown(frame.state[i])) {
        this.seen.add(frame.id[i]);
        ++shown;
      }
    }
    return {...frame, previous, walked, arrived: this.seen.size - shown};
  }

  private findPrevious(frame: Frame, before: Moment, previous: Int32Array): void {
    let known = false;
    for (let i = 0; i < frame.count; ++i) {
      if (frame.id[i] === before.id[i]) {
        previous[i] = i;
        continue;
      }
      if (!known) {
        this.indices.clear();
        before.id.forEach((id, index) => this.indices.set(id, index));
        known = true;
      }
      previous[i] = this.indices.get(frame.id[i]) ?? -1;
    }
  }
}
