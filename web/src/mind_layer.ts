import * as THREE from 'three';
import {Colours, Rgb, VALUE_TABLE} from './colours';
import {Crowd} from './crowd';
import {FlatShapes} from './flat_shapes';
import {Mind, Point} from './messages';

const ACCENT: Rgb = [37, 99, 235];
const DARK: Rgb = [23, 32, 51];
const LONGEST = 1.3;  // [m] of the arrow of the fastest action

/** Returns how good each action is among all, from 0 (the worst) to 1. */
export function shares({actions}: Mind): number[] {
  const values = actions.map(({value}) => value);
  const [low, high] = [Math.min(...values), Math.max(...values)];
  return values.map((value) => high > low ? (value - low) / (high - low) : 1);
}

/** The selected agent: where it goes, whom it perceives, and the actions from which it chooses, coloured by value. */
export class MindLayer {
  readonly group = new THREE.Group();
  private readonly rings = new FlatShapes('ring', 64, 0.035);
  private readonly lines = new FlatShapes('line', 65, 0.025, 0.55);
  private readonly borders = new FlatShapes('arrow', 1, 0.04);
  private readonly arrows = new FlatShapes('arrow', 512, 0.045);
  private readonly target = new FlatShapes('target', 1, 0.03);

  constructor() {
    for (const shapes of [this.rings, this.lines, this.borders, this.arrows, this.target]) {
      this.group.add(shapes.mesh);
    }
  }

  update(crowd: Crowd, selected: number | null, mind: Mind | null, goal: Point | null,
         radiusOf: (id: number) => number, colours: Colours): void {
    const layers = [this.rings, this.lines, this.borders, this.arrows, this.target];
    layers.forEach((shapes) => shapes.begin());
    const i = crowd.find(selected);
    if (i >= 0) {
      const [x, y] = [crowd.x[i], crowd.y[i]];
      const radius = radiusOf(crowd.id[i]);
      this.rings.add(x, y, radius + 0.16, radius + 0.16, 0, ACCENT);
      if (goal) {
        this.target.add(goal[0], goal[1], 0.35, 0.35, 0, ACCENT);
        this.lines.addBetween(x, y, goal[0], goal[1], 0.025, ACCENT);
      }
      if (mind && mind.agent === selected) {
        this.addNeighbours(crowd, mind, x, y, radiusOf, colours);
        this.addActions(mind, x, y, crowd.heading[i], radius);
      }
    }
    layers.forEach((shapes) => shapes.finish());
  }

  private addNeighbours(crowd: Crowd, mind: Mind, x: number, y: number, radiusOf: (id: number) => number,
                        colours: Colours): void {
    for (const neighbour of mind.neighbours) {
      const i = crowd.find(neighbour);
      if (i >= 0) {
        const radius = radiusOf(neighbour) + 0.08;
        this.rings.add(crowd.x[i], crowd.y[i], radius, radius, 0, colours.of(crowd, i));
        this.lines.addBetween(x, y, crowd.x[i], crowd.y[i], 0.018, DARK);
      }
    }
  }

  private addActions(mind: Mind, x: number, y: number, heading: number, radius: number): void {
    const scale = LONGEST / Math.max(...mind.actions.map(({speed}) => speed), 0.1);
    shares(mind).forEach((share, i) => {
      const {direction, speed} = mind.actions[i];
      const angle = heading + direction;
      const length = Math.max(scale * speed, 0.15);
      const [fromX, fromY] = [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
      if (i === mind.chosen) {
        this.borders.add(fromX - 0.05 * Math.cos(angle), fromY - 0.05 * Math.sin(angle), length + 0.16, 0.17, angle, DARK);
      }
      this.arrows.add(fromX, fromY, length, 0.1, angle, VALUE_TABLE[Math.round(255 * share)]);
    });
  }
}
