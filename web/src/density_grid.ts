import {Crowd} from './crowd';
import {Scene} from './messages';

const MOST_CELLS = 40000;
const SMALLEST_CELL = 0.25;  // [m]
const REACH = 0.6;           // [m] of each of two means; people within twice this count, near ones more
const MARGIN = 2;            // [m]

/** Densities of people on a grid over the floor [people/m²]. */
export class DensityGrid {
  columns = 1;
  rows = 1;
  cell = 1;
  left = 0;
  low = 0;
  values = new Float32Array(1);
  private sums = new Float32Array(1);

  /** Covers the floor of a scene. */
  cover([x0, y0, x1, y1]: Scene['bounds']): void {
    const [width, height] = [x1 - x0 + 2 * MARGIN, y1 - y0 + 2 * MARGIN];
    this.cell = Math.max(SMALLEST_CELL, Math.sqrt(width * height / MOST_CELLS));
    this.columns = Math.ceil(width / this.cell);
    this.rows = Math.ceil(height / this.cell);
    this.left = x0 - MARGIN;
    this.low = y0 - MARGIN;
    this.values = new Float32Array(this.columns * this.rows);
    this.sums = new Float32Array(this.columns * this.rows);
  }

  compute(crowd: Crowd): void {
    this.values.fill(0);
    for (let i = 0; i < crowd.count; ++i) {
      const cell = this.cellAt(crowd.x[i], crowd.y[i]);
      if (cell >= 0) {
        ++this.values[cell];
      }
    }
    const reach = Math.max(1, Math.round(REACH / this.cell));
    for (let pass = 0; pass < 2; ++pass) {
      this.sumUp(this.values, this.sums, this.columns, 1, reach);
      this.sumUp(this.sums, this.values, this.rows, this.columns, reach);
    }
    const weight = 1 / ((2 * reach + 1) ** 4 * this.cell ** 2);
    for (let cell = 0; cell < this.values.length; ++cell) {
      this.values[cell] *= weight;
    }
  }

  /** Returns the mean of the densities at the places of all people. */
  meanAt(crowd: Crowd): number {
    let sum = 0;
    for (let i = 0; i < crowd.count; ++i) {
      sum += this.values[Math.max(this.cellAt(crowd.x[i], crowd.y[i]), 0)];
    }
    return crowd.count > 0 ? sum / crowd.count : 0;
  }

  private cellAt(x: number, y: number): number {
    const column = Math.floor((x - this.left) / this.cell);
    const row = Math.floor((y - this.low) / this.cell);
    return column >= 0 && column < this.columns && row >= 0 && row < this.rows ? row * this.columns + column : -1;
  }

  /** Sums of `reach` cells on both sides along all rows (step 1) or columns of cells: running sums. */
  private sumUp(from: Float32Array, to: Float32Array, length: number, step: number, reach: number): void {
    const lineStep = step === 1 ? length : 1;
    for (let line = 0; line < from.length / length; ++line) {
      const start = line * lineStep;
      let sum = 0;
      for (let i = -reach; i < length; ++i) {
        const entering = i + reach;
        const leaving = entering - 2 * reach - 1;
        sum += entering < length ? from[start + entering * step] : 0;
        sum -= leaving >= 0 ? from[start + leaving * step] : 0;
        if (i >= 0) {
          to[start + i * step] = sum;
        }
      }
    }
  }
}
