import {Frame} from './frame';
import {History, Moment} from './history';

const CAPACITY = 3e6;       // agents in the frames of the recent past: some 90 MB
const CATCH_UP = 0.25;      // [s]; a late picture reaches the last frame in about this time
const USUAL_INTERVAL = 0.1; // [s] between frames, until it is known
const LONGEST_INTERVAL = 2;

/** Chooses the time that is shown: that of a live run, of its recent past, or of a recording. */
export class Player {
  time = 0;
  /** Whether a recording or the past of a live run plays. */
  playing = false;
  speed = 1;
  private live = new History(CAPACITY);
  private recording: History | null = null;
  private followsLive = true;
  private arrival = 0;
  private interval = USUAL_INTERVAL;
  private pace = 1;

  get history(): History {
    return this.recording ?? this.live;
  }

  get isRecording(): boolean {
    return this.recording !== null;
  }

  /** Whether the present of a live run is shown. */
  get isLive(): boolean {
    return this.recording === null && this.followsLive;
  }

  /** Takes a frame of a live run, which plays or is stepped, at the given wall time [s]. */
  receive(frame: Frame, now: number, plays: boolean): Moment {
    const last = this.live.last;
    const moment = this.live.append(frame);
    if (!last || frame.tick < last.tick) {
      this.followsLive ||= this.recording === null;
      this.time = this.recording ? this.time : frame.time;
    } else if (plays && now - this.arrival < LONGEST_INTERVAL) {
      const elapsed = Math.max(now - this.arrival, 0.001);
      this.interval += 0.2 * (elapsed - this.interval);
      this.pace += 0.2 * ((frame.time - last.time) / elapsed - this.pace);
    }
    this.arrival = now;
    return moment;
  }

  /** Shows a recording; null: the live run again. */
  open(frames: Frame[] | null): void {
    this.recording = null;
    this.followsLive = true;
    this.playing = false;
    if (frames) {
      const recording = new History();
      frames.forEach((frame) => recording.append(frame));
      this.recording = recording;
      this.playing = true;
    }
    this.time = frames ? frames[0].time : this.live.last?.time ?? 0;
  }

  /** Shows a time of the past, or of the recording. */
  seek(time: number): void {
    const {first, last} = this.history;
    if (first && last) {
      this.followsLive = false;
      this.time = Math.min(Math.max(time, first.time), last.time);
    }
  }

  /** Shows the present of a live run. */
  follow(): void {
    this.open(null);
  }

  /** Shows the frame before (-1) or after (1) the present one. */
  step(direction: number): void {
    const {moments} = this.history;
    const index = this.history.indexAt(this.time) + direction;
    this.playing = false;
    if (moments[index]) {
      this.seek(moments[index].time);
    }
  }

  /** Goes on by a wall time [s]. Returns whether the picture has changed. */
  update(elapsed: number): boolean {
    const last = this.history.last;
    const before = this.time;
    if (!last) {
      return false;
    }
    if (this.isLive) {
      this.chase(last.time, elapsed);
    } else if (this.playing) {
      this.time = Math.min(this.time + elapsed * (this.speed || 8), last.time);
      if (this.time === last.time) {
        this.playing = false;
        this.followsLive = this.recording === null;
      }
    }
    return this.time !== before;
  }

  /** Follows the last frame, late by one interval, so that motion is even. */
  private chase(target: number, elapsed: number): void {
    const lag = target - this.time;
    const usual = Math.max(this.pace * this.interval, 1e-6);
    const pace = Math.max(this.pace * Math.min(Math.max(lag / usual, 0.5), 2), lag > 2 * usual ? lag / CATCH_UP : 0);
    this.time = lag <= 0 ? target : Math.min(this.time + pace * elapsed, target);
  }
}
