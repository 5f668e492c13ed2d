import {GridMap, Mind, Obstacle, Point, RobotState, Wall} from './messages';

/** Arrays of all agents, by ascending id: they show the memory of the module until its next call. */
export interface AgentArrays {
  ids: Uint32Array;
  statuses: Uint8Array;
  positions: Float64Array;
  headings: Float64Array;
  velocities: Float64Array;
  radii: Float64Array;
  goals: Float64Array;
  inContact: Uint8Array;
}

/** A crowd of src/wasm, with the functions of WasmCrowd. Its memory is freed by delete(). */
export interface WasmCrowd {
  step(): boolean;
  isOver(): boolean;
  tick(): number;
  time(): number;
  tickDuration(): number;
  arrived(): number;
  agents(): AgentArrays;
  walls(): Wall[];
  obstacles(): Obstacle[];
  robots(): (RobotState & {radius: number})[];
  map(): Omit<GridMap, 'cells'> & {cells: Uint8Array} | null;
  mind(agent: number): Omit<Mind, 'type'> | null;
  addAgent(position: Point, goal: Point, heading: number, maxSpeed: number, radius: number): number;
  removeAgent(agent: number): void;
  setGoal(agent: number, goal: Point): void;
  addObstacle(position: Point, radius: number): number;
  removeObstacle(obstacle: number): void;
  addWall(from: Point, to: Point): number;
  removeWall(wall: number): void;
  delete(): void;
}

/** The module of src/wasm. */
export interface WasmModule {
  Crowd: new (scenario: string, table: string, seed: number, episode: number) => WasmCrowd;
  scenarioNames(): string[];
}
