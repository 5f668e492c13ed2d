import {Colours} from './colours';
import {Crowd} from './crowd';
import {DensityGrid} from './density_grid';
import {GoalsLayer} from './goals_layer';
import {HeatMap} from './heat_map';
import {History} from './history';
import {Mind, Point, Scene} from './messages';
import {MindLayer} from './mind_layer';
import {People} from './people';
import {RobotsLayer} from './robots_layer';
import {Scenery} from './scenery';
import {Trails} from './trails';
import {View} from './view';

const MOST_FIGURES = 2000;     // more people are discs unless figures are asked for
const MOST_MESHES = 400;       // more figures in view are pictures of figures
const MOST_MESHES_SOFTWARE = 60;
const HEAT_INTERVAL = 0.2;     // [s]
const USUAL_RADIUS = 0.25;     // [m]

export type Shape = 'auto' | 'figures' | 'discs';
export type SceneContent = Pick<Scene, 'bounds' | 'walls' | 'obstacles' | 'map' | 'agents' | 'robots'>;

/** All that is drawn of a crowd. */
export class Picture {
  readonly view: View;
  readonly colours = new Colours();
  readonly crowd = new Crowd();
  readonly grid = new DensityGrid();
  readonly robots = new RobotsLayer();
  shape: Shape = 'auto';
  bounds: Scene['bounds'] = [-5, -5, 5, 5];
  private readonly figures = new People();
  private readonly trails: Trails;
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
    this.trails = new Trails(this.view.isSoftware);
    this.view.scene.add(this.scenery.group, this.heatMap.mesh, this.trails.mesh, this.figures.group,
      this.goals.group, this.mindLayer.group, this.robots.group);
    this.goals.group.visible = false;
  }

  get showsFigures(): boolean {
    return this.shape === 'figures' || (this.shape === 'auto' && this.crowd.count <= MOST_FIGURES);
  }

  get showsDensities(): boolean {
    return this.heatMap.mesh.visible;
  }

  /** Shows another scene, or changes of the present one. */
  setScene(scene: SceneContent): void {
    this.bounds = scene.bounds;
    this.setAgents(scene.agents);
    this.scenery.show(scene);
    this.robots.show(scene.robots);
    this.grid.cover(scene.bounds);
    this.heatMap.cover();
    this.heatTime = NaN;
  }

  /** Shows all agents that there are in the scene. */
  setAgents(agents: Scene['agents']): void {
    this.radii.clear();
    this.goalPlaces.clear();
    for (const {id, radius, goal} of agents) {
      this.radii.set(id, radius);
      this.goalPlaces.set(id, goal);
    }
    this.goals.show(agents, this.colours);
  }

  setObstacles(obstacles: Scene['obstacles']): void {
    this.scenery.showObstacles(obstacles);
  }

  goalOf(id: number | null): Point | null {
    return id === null ? null : this.goalPlaces.get(id) ?? null;
  }

  setPaths(shown: boolean): void {
    this.trails.isShown = shown;
  }

  setGoals(shown: boolean): void {
    this.goals.group.visible = shown;
  }

  setDensities(shown: boolean): void {
    this.heatMap.mesh.visible = shown;
    this.heatTime = NaN;
  }

  /** Draws the crowd at a time of its history. */
  draw(history: History, time: number, selected: number | null, mind: Mind | null): void {
    const {crowd, view} = this;
    crowd.interpolate(history, time);
    this.figures.update(crowd, this.colours, this.radiusOf, view, this.showsFigures,
      view.isSoftware ? MOST_MESHES_SOFTWARE : MOST_MESHES);
    this.trails.update(history, time, this.colours, view.metresPerPixel);
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
