import * as THREE from 'three';
import {Command, Point, Scene} from './messages';
import {element, Icon, notify, setIcon} from './page';
import {Picture} from './picture';

const CLICK = 4;            // [pixels]; a longer way is a drag
const OBSTACLE_RADIUS = 0.4;
const SHORTEST_WALL = 0.1;  // [m]
const REACH = 12;           // [pixels] from a wall or obstacle

export type ToolName = 'select' | 'person' | 'obstacle' | 'wall' | 'goal' | 'remove';

const TOOLS: {name: ToolName; label: string; hint: string; needs?: string}[] = [
  {name: 'select', label: 'Select', hint: 'Select an agent; drag moves the picture'},
  {name: 'person', label: 'Add person', hint: 'Press at the place, drag to the goal', needs: 'add_agent'},
  {name: 'obstacle', label: 'Add obstacle', hint: 'Press at the middle, drag to the size', needs: 'add_obstacle'},
  {name: 'wall', label: 'Add wall', hint: 'Drag from one end to the other', needs: 'add_wall'},
  {name: 'goal', label: 'Set goal', hint: 'Click at a new goal of the selected agent', needs: 'set_goal'},
  {name: 'remove', label: 'Remove', hint: 'Click at an agent, obstacle or wall', needs: 'remove_agent'},
];

/** What the user does in the picture: move it, select agents, and change the scene. */
export class Tools {
  selected: number | null = null;
  scene: Scene | null = null;
  private tool: ToolName = 'select';
  private start: {pixel: Point; floor: Point | null} | null = null;
  private last: Point = [0, 0];
  private button = -1;
  private readonly preview = new THREE.LineSegments(new THREE.BufferGeometry(),
    new THREE.LineBasicMaterial({color: 0x2563eb, depthTest: false}));

  constructor(private readonly picture: Picture, private readonly send: (command: Command) => void,
              private readonly select: (agent: number | null) => void) {
    const canvas = picture.view.renderer.domElement;
    this.preview.frustumCulled = false;
    this.preview.renderOrder = 9;
    picture.view.scene.add(this.preview);
    for (const {name, label, hint} of TOOLS) {
      const button = document.createElement('button');
      button.id = `tool-${name}`;
      button.title = `${label}: ${hint} (${TOOLS.findIndex((tool) => tool.name === name) + 1})`;
      button.setAttribute('aria-label', label);
      setIcon(button, name as Icon);
      button.onclick = () => this.use(name);
      element('tools').append(button);
    }
    canvas.addEventListener('pointerdown', (event) => this.press(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.release(event));
    canvas.addEventListener('pointercancel', () => this.cancel());
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
      picture.view.zoom(Math.exp(-0.0015 * lines * event.deltaY), event.offsetX, event.offsetY);
    }, {passive: false});
    this.use('select');
  }

  /** Takes a tool, by its name or its number. */
  use(tool: ToolName | number): void {
    const name = typeof tool === 'number' ? TOOLS[tool - 1].name : tool;
    if (element<HTMLButtonElement>(`tool-${name}`).disabled) {
      return;
    }
    this.cancel();
    this.tool = name;
    for (const {name: other} of TOOLS) {
      element(`tool-${other}`).setAttribute('aria-pressed', String(other === name));
    }
    this.picture.view.renderer.domElement.style.cursor = name === 'select' ? 'default' : 'crosshair';
  }

  /** Allows the tools whose commands the source knows. */
  allow(commands: string[]): void {
    for (const {name, needs} of TOOLS) {
      element<HTMLButtonElement>(`tool-${name}`).disabled = needs !== undefined && !commands.includes(needs);
    }
    if (element<HTMLButtonElement>(`tool-${this.tool}`).disabled) {
      this.use('select');
    }
  }

  /** Forgets what is being dragged. */
  cancel(): void {
    this.start = null;
    this.preview.visible = false;
  }

  private press(event: PointerEvent): void {
    const pixel: Point = [event.offsetX, event.offsetY];
    this.picture.view.renderer.domElement.setPointerCapture(event.pointerId);
    this.button = event.button === 0 && event.shiftKey ? 2 : event.button;
    this.start = {pixel, floor: this.picture.view.floorAt(...pixel)};
    this.last = pixel;
  }

  private move(event: PointerEvent): void {
    if (!this.start) {
      return;
    }
    const {view} = this.picture;
    const pixel: Point = [event.offsetX, event.offsetY];
    if (this.button === 2 && view.isPerspective) {
      view.orbit(pixel[0] - this.last[0], pixel[1] - this.last[1]);
    } else if (this.button !== 0 || this.tool === 'select') {
      if (this.isDrag(pixel)) {
        view.pan(...this.last, ...pixel);
      }
    } else {
      this.draw(this.start.floor, view.floorAt(...pixel));
    }
    this.last = pixel;
  }

  private release(event: PointerEvent): void {
    const start = this.start;
    const pixel: Point = [event.offsetX, event.offsetY];
    const isDrag = start !== null && this.isDrag(pixel);
    const end = this.picture.view.floorAt(...pixel);
    this.cancel();
    if (start && this.button === 0) {
      if (this.tool === 'select') {
        if (!isDrag) {
          this.select(this.picture.agentAt(pixel));
        }
      } else if (start.floor && end) {
        this.apply(start.floor, end, isDrag, pixel);
      }
    }
  }

  private isDrag([x, y]: Point): boolean {
    return this.start !== null && Math.hypot(x - this.start.pixel[0], y - this.start.pixel[1]) > CLICK;
  }

  private apply(from: Point, to: Point, isDrag: boolean, pixel: Point): void {
    const [x0, y0, x1, y1] = this.picture.bounds;
    switch (this.tool) {
      case 'person':  // without a drag, the goal is on the other side of the middle
        this.send({command: 'add_agent', position: from, goal: isDrag ? to : [x0 + x1 - from[0], y0 + y1 - from[1]]});
        break;
      case 'obstacle':
        this.send({command: 'add_obstacle', position: from, radius: isDrag ? distance(from, to) : OBSTACLE_RADIUS});
        break;
      case 'wall':
        if (isDrag && distance(from, to) > SHORTEST_WALL) {
          this.send({command: 'add_wall', from, to});
        } else {
          notify('Drag from one end of the wall to the other.', false);
        }
        break;
      case 'goal':
        if (this.selected === null) {
          notify('Select an agent first.', false);
        } else {
          this.send({command: 'set_goal', agent: this.selected, goal: to});
        }
        break;
      case 'remove':
        this.remove(to, pixel);
    }
  }

  /** Removes the agent, obstacle or wall at a place. */
  private remove(at: Point, pixel: Point): void {
    const agent = this.picture.agentAt(pixel);
    const reach = REACH * this.picture.view.metresPerPixel;
    const obstacle = this.scene?.obstacles.find(({position, radius}) => distance(position, at) < radius + reach);
    const wall = this.scene?.walls.find(({from, to}) => distanceToLine(at, from, to) < reach);
    if (agent !== null) {
      this.send({command: 'remove_agent', agent});
    } else if (obstacle) {
      this.send({command: 'remove_obstacle', obstacle: obstacle.id});
    } else if (wall) {
      this.send({command: 'remove_wall', wall: wall.id});
    }
  }

  /** Draws what is being dragged. */
  private draw(from: Point | null, to: Point | null): void {
    this.preview.visible = from !== null && to !== null && this.tool !== 'remove' && this.tool !== 'goal';
    if (!from || !to) {
      return;
    }
    const points = this.tool === 'obstacle' ? circle(from, distance(from, to)) : [...from, 0.05, ...to, 0.05];
    if (this.tool === 'person') {
      points.push(...circle(from, 0.25), ...circle(to, 0.15));
    }
    this.preview.geometry.dispose();
    this.preview.geometry.setAttribute('position', new THREE.Float32BufferAttribute(points, 3));
  }
}

function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

function distanceToLine(at: Point, from: Point, to: Point): number {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const share = ((at[0] - from[0]) * dx + (at[1] - from[1]) * dy) / Math.max(dx * dx + dy * dy, 1e-12);
  const part = Math.min(Math.max(share, 0), 1);
  return distance(at, [from[0] + part * dx, from[1] + part * dy]);
}

/** Returns the ends of lines around a circle. */
function circle([x, y]: Point, radius: number): number[] {
  const at = (i: number) => [x + radius * Math.cos(i * Math.PI / 16), y + radius * Math.sin(i * Math.PI / 16), 0.05];
  return Array.from({length: 32}, (_, i) => [...at(i), ...at(i + 1)]).flat();
}
