import {Colours} from './colours';
import {Crowd} from './crowd';
import {DensityGrid} from './density_grid';
import {Discs} from './discs';
import {Figures} from './figures';
import {GoalsLayer} from './goals_layer';
import {HeatMap} from './heat_map';
import {History} from './history';
import {Mind, Point, Scene} from './messages';
import {MindLayer} from './mind_layer';
import {RobotsLayer} from './robots_layer';
import {Scenery} from './scenery';
import {Trails} from './trails';
import {View} from './view';

const MOST_FIGURES = 2000;     // more people are discs unless figures are asked for
const MOST_DETAILED = 250;     // more figures have few triangles
const FAR = 0.035;             // [m/pixel]; from here on figures have few triangles as well
const HEAT_INTERVAL = 0.2;     // [s]
const USUAL_RADIUS = 0.25;     // [m]

export type People = 'auto' | 'figures' | 'discs';
export type SceneContent = Pick<Scene, 'bounds' | 'walls' | 'obstacles' | 'map' | 'agents' | 'robots'>;

/** All that is drawn of a crowd. */
export class Picture {
  readonly view: View;
  readonly colours = new Colours();
  readonly crowd = new Crowd();
  readonly grid = new DensityGrid();
  readonly robots = new RobotsLayer();
  people: People = 'auto';
  bounds: Scene['bounds'] = [-5, -5, 5, 5];
  private readonly figures = new Figures();
  private readonly shadows = new Discs(true);
  private readonly discs = new Discs(false);
  private readonly trails = new Trails();
  private readonly heatMap = new HeatMap(this.grid);
  private readonly goals = new GoalsLayer();
  private readonly mindLayer = new MindLayer();
  private readonly scenery = new Scenery();
  private readonly radii = new Map<number, number>();
  private readonly goalPlaces = new Map<number, Point>();
  private heatTime = NaN;

  readonly radiusOf = (id: number): number => this.radii.get(id) ?? USUAL_RADIUS;

  constructor(canvas: HTMLCanvasElement) {
    this.view = new View(canvas);
    this.view.scene.add(this.scenery.group, this.heatMap.mesh, this.trails.mesh, this.shadows.mesh, this.discs.mesh,
      this.figures.mesh, this.goals.mesh, this.mindLayer.group, this.robots.group);
    this.goals.mesh.visible = false;
  }

  get showsFigures(): boolean {
    return this.people === 'figures' || (this.people === 'auto' && this.crowd.count <= MOST_FIGURES);
  }

  get showsDensities(): boolean {
    return this.heatMap.mesh.visible;
  }

  /** Shows another scene, or changes of the present one. */
  setScene(scene: SceneContent): void {
    this.bounds = scene.bounds;
    this.radii.clear();
    this.goalPlaces.clear();
    for (const {id, radius, goal} of scene.agents) {
      this.radii.set(id, radius);
      this.goalPlaces.set(id, goal);
    }
    this.scenery.show(scene);
    this.robots.show(scene.robots);
    this.goals.show(scene.agents, this.colours);
    this.grid.cover(scene.bounds);
    this.heatMap.cover();
    this.heatTime = NaN;
  }

  goalOf(id: number | null): Point | null {
    return id === null ? null : this.goalPlaces.get(id) ?? null;
  }

  setPaths(shown: boolean): void {
    this.trails.mesh.visible = shown;
    this.trails.clear();
  }

  setGoals(shown: boolean): void {
    this.goals.mesh.visible = shown;
  }

  setDensities(shown: boolean): void {
    this.heatMap.mesh.visible = shown;
    this.heatTime = NaN;
  }

  /** Draws the crowd at a time of its history. */
  draw(history: History, time: number, selected: number | null, mind: Mind | null): void {
    const {crowd, view} = this;
    crowd.interpolate(history, time);
    const figures = this.showsFigures;
    this.figures.mesh.visible = this.shadows.mesh.visible = figures;
    this.discs.mesh.visible = !figures;
    if (figures) {
      const isFar = crowd.count > MOST_DETAILED || view.metresPerPixel > FAR;
      this.figures.update(crowd, this.colours, this.radiusOf, isFar);
      this.shadows.update(crowd, this.colours, this.radiusOf);
    } else {
      this.discs.update(crowd, this.colours, this.radiusOf);
    }
    if (this.trails.mesh.visible) {
      this.trails.update(history, time, this.colours, view.metresPerPixel);
    }
    if (this.showsDensities && !(Math.abs(time - this.heatTime) < HEAT_INTERVAL)) {
      this.heatTime = time;
      this.grid.compute(crowd);
      this.heatMap.draw();
    }
    this.mindLayer.update(crowd, selected, mind, this.goalOf(selected), this.radiusOf, this.colours);
    view.draw();
  }

  /** Returns the agent at a pixel, or null. */
  agentAt([x, y]: Point): number | null {
    let nearest: number | null = null;
    let distance = 16;  // [pixels]
    for (let i = 0; i < this.crowd.count; ++i) {
      for (const z of this.showsFigures ? [0, 0.8, 1.6] : [0]) {
        const [px, py] = this.view.pixelOf([this.crowd.x[i], this.crowd.y[i]], z);
        const d = Math.hypot(px - x, py - y);
        if (d < distance) {
          distance = d;
          nearest = this.crowd.id[i];
        }
      }
    }
    return nearest;
  }
}
