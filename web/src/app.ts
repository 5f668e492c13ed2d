import {boundsOf, readRecording} from './csv_recording';
import {decodeFrame} from './frame';
import {Command, Hello, Message, Mind, Obstacle, RobotState, Scene, Status} from './messages';
import {MindPanel} from './mind_panel';
import {element, notify, setText} from './page';
import {Picture} from './picture';
import {Player} from './player';
import {Plots} from './plots';
import {Source} from './source';
import {Statistics} from './statistics';
import {Tools} from './tools';
import {Transport} from './transport';

const PANEL_INTERVAL = 0.2;  // [s]
const TRANSPORT_INTERVAL = 0.08;
const RECORDING_TICK = 0.1;  // [s], unless it is known
const NEW_BOUNDS = 0.5;      // [m]; a scene whose bounds differ by more is looked at as a whole

/** The page: shows what the source says, and tells it what the user wants. */
export class App {
  readonly player = new Player();
  readonly picture = new Picture(element<HTMLCanvasElement>('picture'));
  readonly tools = new Tools(this.picture, (command) => this.send(command), (agent) => this.select(agent));
  status: Status | null = null;
  /** Frames drawn in the last second. */
  framesPerSecond = 0;
  /** Whether the picture is to be drawn again. */
  isDirty = true;
  private readonly statistics = new Statistics(this.picture.grid);
  private readonly plots = new Plots();
  private readonly mindPanel = new MindPanel();
  private readonly transport = new Transport(this);
  private source: Source | null = null;
  private hello: Hello | null = null;
  private scene: Scene | null = null;
  private mind: Mind | null = null;
  private fitted: Scene['bounds'] | null = null;
  private panelTime = 0;
  private transportTime = 0;
  private readonly drawn: number[] = [];

  /** Shows another source. */
  connect(source: Source): void {
    this.source?.close();
    this.source = source;
    source.onMessage((message) => this.receive(message));
  }

  send(command: Command): void {
    if (this.source) {
      this.source.send(command);
    } else {
      notify('There is no simulation: drop a recording on the page.', false);
    }
  }

  select(agent: number | null): void {
    this.tools.selected = agent;
    this.mind = null;
    this.isDirty = true;
    if (this.knows('select') && this.player.isLive) {
      this.source!.send({command: 'select', agent});
    }
  }

  knows(command: string): boolean {
    return this.hello?.commands.includes(command) ?? false;
  }

  /** Shows a recording in CSV. Fails if it is not one, and shows what was shown before. */
  openRecording(name: string, csv: string, tickDuration = RECORDING_TICK): void {
    const frames = readRecording(csv, tickDuration);
    this.select(null);
    this.player.open(frames);
    const scene = name.replace(/\.csv$/, '').endsWith(this.scene?.scenario ?? ' ') ? this.scene : null;
    const bounds = scene?.bounds ?? boundsOf(frames);
    const {walls, obstacles, map} = scene ?? {walls: [], obstacles: [], map: null};
    this.picture.setScene({bounds, walls, obstacles, map, agents: [], robots: []});
    this.statistics.sampleAll(this.player.history);
    this.tools.allow([]);
    this.picture.view.fit(bounds);
    this.isDirty = true;
    notify(`Recording ${name}: ${frames.length} ticks`, false);
  }

  /** Shows the present of the live run. */
  showLive(): void {
    if (this.player.isRecording) {
      this.statistics.clear();
      this.tools.allow(this.hello?.commands ?? []);
      if (this.scene) {
        this.picture.setScene(this.scene);
        this.picture.view.fit(this.scene.bounds);
      }
    }
    this.player.follow();
    this.isDirty = true;
  }

  /** Draws a frame, given the wall time [s] and the time since the last one. */
  animate(now: number, elapsed: number): void {
    const moved = this.player.update(elapsed);
    if (moved || this.isDirty) {
      this.isDirty = false;
      const mind = this.player.isLive ? this.mind : null;
      this.picture.draw(this.player.history, this.player.time, this.tools.selected, mind);
      this.drawn.push(now);
    }
    while (this.drawn.length > 0 && this.drawn[0] <= now - 1) {
      this.drawn.shift();
    }
    this.framesPerSecond = this.drawn.length;
    if (now - this.transportTime > TRANSPORT_INTERVAL) {
      this.transportTime = now;
      this.transport.update(this.player, this.status);
    }
    if (now - this.panelTime > PANEL_INTERVAL) {
      this.panelTime = now;
      this.updatePanel();
    }
  }

  private receive(message: object | ArrayBuffer): void {
    try {
      if (message instanceof ArrayBuffer) {
        this.receiveFrame(message);
      } else {
        this.receiveMessage(message as Message);
      }
    } catch (error) {
      notify((error as Error).message);
    }
  }

  private receiveFrame(buffer: ArrayBuffer): void {
    const moment = this.player.receive(decodeFrame(buffer), performance.now() / 1000, this.status?.playing ?? false);
    if (!this.player.isRecording) {
      const isOld = this.status === null || this.status.tick > moment.tick;  // of the run before
      this.statistics.sample(this.player.history, isOld ? undefined : this.status!.arrived);
      this.isDirty = true;
    }
  }

  private receiveMessage(message: Message): void {
    switch (message.type) {
      case 'hello':
        this.greet(message);
        break;
      case 'scene':
        this.receiveScene(message);
        break;
      case 'agents':
        this.receiveAgents(message.agents);
        break;
      case 'obstacles':
        this.receiveObstacles(message.obstacles);
        break;
      case 'status':
        this.status = message;
        break;
      case 'robots':
        this.receiveRobots(message.robots);
        break;
      case 'mind':
        this.mind = message;
        this.isDirty = true;
        break;
      case 'error':
        notify(message.command ? `${message.command}: ${message.message}` : message.message);
        break;
      case 'recordings':
        this.transport.listRecordings(message.names);
        break;
      case 'recording':
        this.openRecording(message.name, message.csv, message.tick_duration);
    }
  }

  private greet(hello: Hello): void {
    this.hello = hello;
    this.tools.allow(hello.commands);
    this.transport.listScenarios(hello.scenarios);
    setText('back-end', {ros: 'ROS', python: 'local server', wasm: 'in the browser'}[hello.back_end] ?? hello.back_end);
    element('recordings').hidden = !this.knows('recordings');
    if (this.knows('recordings')) {
      this.send({command: 'recordings'});
    }
    const wanted = new URLSearchParams(location.search).get('recording');
    if (wanted && this.knows('open_recording')) {
      this.send({command: 'open_recording', name: wanted});
    }
  }

  private receiveScene(scene: Scene): void {
    if (this.scene?.scenario !== scene.scenario) {
      this.select(null);
      this.statistics.clear();
    }
    this.scene = scene;
    this.tools.scene = scene;
    this.transport.showScenario(scene.scenario);
    if (this.player.isRecording) {
      return;
    }
    this.picture.setScene(scene);
    if (!this.fitted || scene.bounds.some((value, i) => Math.abs(value - this.fitted![i]) > NEW_BOUNDS)) {
      this.fitted = scene.bounds;
      this.picture.view.fit(scene.bounds);
    }
    this.isDirty = true;
  }

  private receiveAgents(agents: Scene['agents']): void {
    if (this.scene) {
      const known = new Map(this.scene.agents.map((agent) => [agent.id, agent]));
      agents.forEach((agent) => known.set(agent.id, agent));
      this.scene.agents = [...known.values()];
      if (!this.player.isRecording) {
        this.picture.setAgents(this.scene.agents);
        this.isDirty = true;
      }
    }
  }

  private receiveObstacles(obstacles: Obstacle[]): void {
    if (this.scene) {
      this.scene.obstacles = obstacles;
      if (!this.player.isRecording) {
        this.picture.setObstacles(obstacles);
        this.isDirty = true;
      }
    }
  }

  private receiveRobots(robots: RobotState[]): void {
    if (!this.player.isRecording) {
      this.picture.robots.update(robots);
      this.isDirty = true;
    }
  }

  private updatePanel(): void {
    const {crowd} = this.picture;
    const history = this.player.history;
    const isLive = this.player.isLive;
    const arrived = history.moments[history.indexAt(this.player.time)]?.arrived ?? 0;
    setText('walking', String(isLive ? this.status?.walking ?? crowd.count : crowd.count));
    setText('arrived', String(isLive ? this.status?.arrived ?? arrived : arrived));
    setText('contacts', isLive && this.status ? String(this.status.contacts) : '–');
    setText('fps', String(this.framesPerSecond));
    const {selected} = this.tools;
    const i = crowd.find(selected);
    this.mindPanel.show(i >= 0 ? selected : null, isLive ? this.mind : null, i >= 0 ? crowd.speed[i] : 0,
      this.picture.goalOf(selected));
    if (!element('panel').hidden) {
      this.plots.draw(this.statistics.samples, this.player.time);
    }
  }
}
