import {Command, Obstacle, Point} from './messages';
import {Arguments, checkedArguments} from './wasm_commands';
import {WasmCrowd, WasmModule} from './wasm_module';
import {agentsOf, frameOf, sceneOf} from './wasm_view';

const FRAME_PERIOD = 1000 / 30;  // [ms]
const STATUS_PERIOD = 100;       // [ms]
const LATEST = 500;              // [ms] by which ticks may be behind real time and still catch up
const PATIENCE = 20;             // [ms] that ticks may take before commands are looked at

type Act = (values: Required<Arguments>) => void;

/** Walks a crowd and speaks the page's protocol. */
export class WasmSource {
  private crowd: WasmCrowd;
  private scenario = 'circle6';
  private seed = 1;
  private episode = 0;
  private speed = 1;
  private isPlaying = false;
  private selected: number | null = null;
  private due = 0;       // when the next tick is to be walked [ms]
  private frameDue = 0;  // when the next frame may be sent
  private statusDue = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private goals = new Map<number, string>();  // that the page knows
  private status = '';                        // the latest one
  private obstacles = '';

  constructor(private readonly module: WasmModule, private readonly send: (message: object) => void) {
    this.crowd = this.make(this.scenario, this.seed, this.episode);
  }

  /** Shows the first scene. */
  begin(): void {
    this.showScene();
  }

  /** Carries out a command, or says why it is refused. */
  receive(command: Command): void {
    try {
      const name = typeof command?.command === 'string' ? command.command : '';
      const values = checkedArguments({...command, command: name});
      this.acts[name](values);
    } catch (error) {
      this.send({type: 'error', command: command?.command ?? null, message: (error as Error).message});
    }
  }

  private readonly acts: Record<string, Act> = {
    play: () => {
      if (this.crowd.isOver()) {
        this.restart(this.scenario, this.seed, this.episode + 1);
      }
      this.isPlaying = true;
      this.due = performance.now();
      this.schedule();
      this.showStatus(true);
    },
    pause: () => {
      this.isPlaying = false;
      this.schedule();
      this.show(true);
    },
    step: ({ticks}) => {
      if (this.isPlaying || this.crowd.isOver()) {
        throw new Error(this.isPlaying ? 'expected a pause before' : 'the episode is over');
      }
      for (let i = 0; i < ticks && this.crowd.step(); ++i) {
        this.show(false);
      }
      this.show(true);
    },
    speed: ({factor}) => {
      this.speed = factor;
      this.due = performance.now();
      this.schedule();
      this.showStatus(true);
    },
    scenario: ({name}) => {
      if (!this.module.scenarioNames().includes(name)) {
        throw new Error(`there is no scenario '${name}'`);
      }
      this.restart(name, this.seed, 0);
    },
    reset: ({seed}) => this.restart(this.scenario, seed ?? this.seed, 0),
    add_agent: ({position, goal, radius, max_speed: maxSpeed, heading}) => {
      const towards = Math.atan2(goal[1] - position[1], goal[0] - position[0]);
      this.crowd.addAgent(position, goal, heading ?? towards, maxSpeed, radius);
      this.show(true);
    },
    remove_agent: ({agent}) => {
      this.crowd.removeAgent(agent!);
      this.show(true);
    },
    set_goal: ({agent, goal}) => {
      this.crowd.setGoal(agent!, goal);
      this.show(true);
    },
    add_obstacle: ({position, radius}) => this.edit(() => this.crowd.addObstacle(position, radius)),
    remove_obstacle: ({obstacle}) => this.edit(() => this.crowd.removeObstacle(obstacle)),
    add_wall: ({from, to}) => this.edit(() => this.crowd.addWall(from, to)),
    remove_wall: ({wall}) => this.edit(() => this.crowd.removeWall(wall)),
    select: ({agent}) => {
      this.selected = agent;
      this.showMind();
    },
  };

  /** A crowd with the Q-table with which demo.launch shows the scenario. */
  private make(scenario: string, seed: number, episode: number): WasmCrowd {
    return new this.module.Crowd(scenario, scenario.startsWith('place_') ? 'human' : 'anticipation', seed, episode);
  }

  private restart(scenario: string, seed: number, episode: number): void {
    const crowd = this.make(scenario, seed, episode);
    this.crowd.delete();
    [this.crowd, this.scenario, this.seed, this.episode] = [crowd, scenario, seed, episode];
    this.due = performance.now();
    this.showScene();
  }

  private edit(act: () => void): void {
    act();
    this.showScene();
  }

  /** Walks when the next tick is due, or not at all in a pause. */
  private schedule(): void {
    clearTimeout(this.timer);
    if (this.isPlaying) {
      this.timer = setTimeout(() => this.walk(), Math.max(0, this.due - performance.now()));
    }
  }

  /** Walks the ticks that are due. */
  private walk(): void {
    try {
      const start = performance.now();
      do {
        this.isPlaying = this.crowd.step() && !this.crowd.isOver();
        this.show(!this.isPlaying);
        const now = performance.now();
        const period = this.speed > 0 ? 1000 * this.crowd.tickDuration() / this.speed : 0;
        this.due = this.speed > 0 ? Math.max(this.due + period, now - LATEST) : now;
      } while (this.isPlaying && this.due <= performance.now() && performance.now() - start < PATIENCE);
    } catch (error) {
      this.isPlaying = false;
      this.send({type: 'error', command: null, message: (error as Error).message});
      this.showStatus(true);
    }
    this.schedule();
  }

  private showScene(): void {
    const scene = sceneOf(this.crowd, this.scenario);
    this.goals = new Map(scene.agents.map(({id, goal}) => [id, String(goal)]));
    this.obstacles = JSON.stringify(scene.obstacles);
    this.send(scene);
    this.show(true);
  }

  /** Sends what there is to see, if it is time for it or it must be seen. */
  private show(must: boolean): void {
    const now = performance.now();
    if (!must && now < this.frameDue) {
      return;
    }
    this.frameDue = Math.max(this.frameDue + FRAME_PERIOD, now);
    this.showNewAgents();
    this.showObstacles();
    this.send(frameOf(this.crowd));
    const robots = this.crowd.robots();
    if (robots.length > 0) {
      const states = robots.map(({name, pose, goal, scan}) => ({name, pose, goal, scan}));
      this.send({type: 'robots', tick: this.crowd.tick(), robots: states});
    }
    this.showMind();
    this.showStatus(must);
  }

  private showNewAgents(): void {
    const isNew = (id: number, goal: Point) => this.goals.get(id) !== String(goal);
    const agents = agentsOf(this.crowd.agents(), isNew);
    if (agents.length > 0) {
      agents.forEach(({id, goal}) => this.goals.set(id, String(goal)));
      this.send({type: 'agents', agents});
    }
  }

  private showObstacles(): void {
    const obstacles: Obstacle[] = this.crowd.obstacles();
    const text = JSON.stringify(obstacles);
    if (text !== this.obstacles) {
      this.obstacles = text;
      this.send({type: 'obstacles', tick: this.crowd.tick(), obstacles});
    }
  }

  private showMind(): void {
    const mind = this.selected === null ? null : this.crowd.mind(this.selected);
    if (mind) {
      this.send({...mind, type: 'mind'});
    }
  }

  private showStatus(must: boolean): void {
    const now = performance.now();
    if (!must && now < this.statusDue) {
      return;
    }
    this.statusDue = now + STATUS_PERIOD;
    const {statuses, inContact} = this.crowd.agents();
    const status = {
      type: 'status', playing: this.isPlaying, speed: this.speed, tick: this.crowd.tick(), time: this.crowd.time(),
      walking: statuses.filter((state) => state === 0).length, arrived: this.crowd.arrived(),
      contacts: inContact.filter((contact) => contact !== 0).length, episode: this.episode, over: this.crowd.isOver(),
    };
    const text = JSON.stringify(status);
    if (text !== this.status) {
      this.status = text;
      this.send(status);
    }
  }
}
