import {Crowd} from './crowd';
import {DensityGrid} from './density_grid';
import {STATE_MASK} from './frame';
import {History} from './history';

const SPACING = 0.5;   // [s] between samples
const MOST = 600;      // samples; with more, every second one is left out

/** What is plotted at one time. */
export interface Sample {
  time: number;
  speed: number;
  density: number;
  arrived: number;
}

/** Speed, density and arrivals of a run over time. */
export class Statistics {
  readonly samples: Sample[] = [];
  private spacing = SPACING;
  private readonly crowd = new Crowd();

  constructor(private readonly grid: DensityGrid) {}

  clear(): void {
    this.samples.length = 0;
    this.spacing = SPACING;
  }

  /** Takes a sample of the last frame, if the time has come. arrived: if it is known better than from the frames. */
  sample(history: History, arrived?: number): void {
    const moment = history.last!;
    const last = this.samples[this.samples.length - 1];
    if (last && moment.time < last.time) {
      this.clear();
    } else if (last && moment.time < last.time + this.spacing) {
      return;
    }
    this.take(history, moment.time, arrived ?? moment.arrived);
    if (this.samples.length > MOST) {
      this.samples.splice(0, MOST, ...this.samples.filter((_, i) => i % 2 === 0).slice(0, MOST / 2));
      this.spacing *= 2;
    }
  }

  /** Takes samples of a whole recording. */
  sampleAll(history: History): void {
    this.clear();
    const step = Math.max(1, Math.floor(history.moments.length / (MOST / 2)));
    for (let i = 0; i < history.moments.length; i += step) {
      this.take(history, history.moments[i].time, history.moments[i].arrived);
    }
  }

  private take(history: History, time: number, arrived: number): void {
    this.crowd.interpolate(history, time);
    this.grid.compute(this.crowd);
    let sum = 0;
    let walking = 0;
    for (let i = 0; i < this.crowd.count; ++i) {
      if ((this.crowd.state[i] & STATE_MASK) === 0) {
        sum += this.crowd.speed[i];
        ++walking;
      }
    }
    this.samples.push({
      time, speed: walking > 0 ? sum / walking : 0, density: this.grid.meanAt(this.crowd), arrived,
    });
  }
}
