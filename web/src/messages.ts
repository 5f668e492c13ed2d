/** Messages between the page and a source. SI units, frame `map`, angles counter-clockwise. */

export type Point = [number, number];

export interface Hello {
  type: 'hello';
  protocol: number;
  back_end: string;
  scenarios: string[];
  commands: string[];
}

export interface Wall {
  id: number;
  from: Point;
  to: Point;
}

export interface Obstacle {
  id: number;
  position: Point;
  radius: number;
}

/** An occupancy grid; row 0 is the lowest; cells: 0 free, 100 occupied, 255 unknown. */
export interface GridMap {
  width: number;
  height: number;
  resolution: number;
  origin: [number, number, number];
  cells: string;
}

export interface Scene {
  type: 'scene';
  scenario: string;
  tick_duration: number;
  bounds: [number, number, number, number];
  agents: {id: number; radius: number; goal: Point}[];
  obstacles: Obstacle[];
  walls: Wall[];
  map: GridMap | null;
  robots: {name: string; radius: number}[];
}

/** What a live source does at the moment. */
export interface Status {
  type: 'status';
  playing: boolean;
  speed: number;
  tick: number;
  time: number;
  walking: number;
  arrived: number;
  contacts: number;
  episode: number;
  over: boolean;
}

export interface RobotState {
  name: string;
  pose: [number, number, number];
  goal: Point | null;
  scan: null | {angle_min: number; angle_increment: number; ranges: (number | null)[]};
}

export interface CandidateAction {
  direction: number;
  speed: number;
  value: number;
  visits: number;
}

/** What the selected agent chose from. */
export interface Mind {
  type: 'mind';
  agent: number;
  tick: number;
  actions: CandidateAction[];
  chosen: number;
  neighbours: number[];
}

export type Message = Hello | Scene | Status | Mind
  | {type: 'agents'; agents: Scene['agents']}
  | {type: 'obstacles'; tick: number; obstacles: Obstacle[]}
  | {type: 'robots'; tick: number; robots: RobotState[]}
  | {type: 'error'; command: string | null; message: string}
  | {type: 'recordings'; names: string[]}
  | {type: 'recording'; name: string; csv: string; tick_duration?: number};

export interface Command {
  command: string;
  [key: string]: unknown;
}
