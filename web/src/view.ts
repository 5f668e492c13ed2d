import * as THREE from 'three';
import {Point} from './messages';

const FIELD_OF_VIEW = 35;  // [degrees]
const STEEPEST = 0.02;
const FLATTEST = 1.45;
const SMALLEST = 1;  // heights of the picture [m]
const LARGEST = 2000;

/** The three-dimensional picture and its camera, which looks at a point of the floor. */
export class View {
  readonly scene = new THREE.Scene();
  readonly renderer: THREE.WebGLRenderer;
  /** Whether there is no graphics card, so that less detail is drawn. */
  readonly isSoftware: boolean;
  /** Whether the camera looks in perspective, or straight down. */
  isPerspective = true;
  width = 1;
  height = 1;
  /** Pixels at the edges that the panels cover: left, top, right, bottom. */
  private readonly covered = [64, 62, 0, 62];
  private readonly perspective = new THREE.PerspectiveCamera(FIELD_OF_VIEW);
  private readonly orthographic = new THREE.OrthographicCamera();
  private readonly target = new THREE.Vector3();
  private readonly ray = new THREE.Raycaster();
  private readonly pointer = new THREE.Vector2();
  private readonly projected = new THREE.Vector3();
  private extent = 20;  // height of the picture at the target [m]
  private azimuth = -0.35;
  private polar = 0.9;

  constructor(canvas: HTMLCanvasElement) {
    this.isSoftware = drawsInSoftware();
    this.renderer = new THREE.WebGLRenderer({
      canvas, antialias: !this.isSoftware, powerPreference: 'high-performance', stencil: false});
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.renderer.setClearColor(0xe9edf2);
    this.perspective.up.set(0, 0, 1);
    this.scene.matrixAutoUpdate = false;
  }

  get camera(): THREE.Camera {
    return this.isPerspective ? this.perspective : this.orthographic;
  }

  /** Angle between the view and straight down. */
  get polarAngle(): number {
    return this.isPerspective ? this.polar : 0;
  }

  get azimuthAngle(): number {
    return this.isPerspective ? this.azimuth : 0;
  }

  /** Metres of a pixel at the middle of the picture. */
  get metresPerPixel(): number {
    return this.extent / this.height;
  }

  /** Adapts to the size of the canvas. */
  resize(): void {
    const canvas = this.renderer.domElement;
    this.width = Math.max(canvas.clientWidth, 1);
    this.height = Math.max(canvas.clientHeight, 1);
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(this.width, this.height, false);
    this.place();
  }

  draw(): void {
    this.renderer.render(this.scene, this.camera);
  }

  /** Leaves room for a panel at the right [pixels]. */
  setCovered(right: number): void {
    this.covered[2] = right;
    this.place();
  }

  /** Shows the whole of a box of the floor. */
  fit([x0, y0, x1, y1]: [number, number, number, number]): void {
    const [left, top, right, bottom] = this.covered;
    const [freeWidth, freeHeight] = [Math.max(this.width - left - right, 100), Math.max(this.height - top - bottom, 100)];
    this.target.set((x0 + x1) / 2, (y0 + y1) / 2, 0);
    this.extent = Math.max(1.06 * Math.max((x1 - x0) * this.height / freeWidth, (y1 - y0) * this.height / freeHeight), 4);
    this.place();
    for (let i = 0; i < 2 && this.isPerspective; ++i) {
      const pixels = [[x0, y0], [x0, y1], [x1, y0], [x1, y1]].map((corner) => this.pixelOf(corner as Point));
      const [xs, ys] = [0, 1].map((axis) => pixels.map((pixel) => pixel[axis]));
      const [width, height] = [xs, ys].map((values) => Math.max(...values) - Math.min(...values));
      this.extent *= 1.04 * Math.max(width / freeWidth, height / freeHeight);
      this.pan((Math.max(...xs) + Math.min(...xs)) / 2, (Math.max(...ys) + Math.min(...ys)) / 2,
        (left + this.width - right) / 2, (top + this.height - bottom) / 2);
    }
  }

  setPerspective(isPerspective: boolean): void {
    this.isPerspective = isPerspective;
    this.place();
  }

  /** Moves the picture by pixels. */
  pan(fromX: number, fromY: number, toX: number, toY: number): void {
    const from = this.floorAt(fromX, fromY);
    const to = this.floorAt(toX, toY);
    if (from && to) {
      this.target.x += from[0] - to[0];
      this.target.y += from[1] - to[1];
      this.place();
    }
  }

  /** Turns the camera by pixels. */
  orbit(dx: number, dy: number): void {
    this.azimuth -= 0.006 * dx;
    this.polar = Math.min(Math.max(this.polar - 0.006 * dy, STEEPEST), FLATTEST);
    this.place();
  }

  /** Enlarges the picture around a place in pixels. */
  zoom(factor: number, x: number, y: number): void {
    const before = this.floorAt(x, y);
    this.extent = Math.min(Math.max(this.extent / factor, SMALLEST), LARGEST);
    this.place();
    const after = this.floorAt(x, y);
    if (before && after && Math.hypot(before[0] - after[0], before[1] - after[1]) < this.extent) {
      this.target.x += before[0] - after[0];
      this.target.y += before[1] - after[1];
      this.place();
    }
  }

  /** Returns the place on the floor at a pixel; null: the sky. */
  floorAt(x: number, y: number): Point | null {
    this.pointer.set(2 * x / this.width - 1, 1 - 2 * y / this.height);
    this.ray.setFromCamera(this.pointer, this.camera);
    const {origin, direction} = this.ray.ray;
    const distance = -origin.z / direction.z;
    return direction.z < -1e-6 && distance < 1e5
      ? [origin.x + distance * direction.x, origin.y + distance * direction.y] : null;
  }

  /** Returns the pixel at which a place on the floor is seen. */
  pixelOf([x, y]: Point, z = 0): Point {
    this.projected.set(x, y, z).project(this.camera);
    return [(this.projected.x + 1) / 2 * this.width, (1 - this.projected.y) / 2 * this.height];
  }

  private place(): void {
    const aspect = this.width / this.height;
    const distance = this.extent / (2 * Math.tan(FIELD_OF_VIEW / 2 * Math.PI / 180));
    this.perspective.aspect = aspect;
    this.perspective.near = Math.max(distance / 50, 0.1);
    this.perspective.far = 20 * distance + 100;
    this.perspective.position.set(
      this.target.x + distance * Math.sin(this.polar) * Math.sin(this.azimuth),
      this.target.y - distance * Math.sin(this.polar) * Math.cos(this.azimuth),
      distance * Math.cos(this.polar));
    this.perspective.lookAt(this.target);
    this.perspective.updateProjectionMatrix();
    this.perspective.updateMatrixWorld();
    const [left, top, right, bottom] = this.covered;
    const offset = [this.width, this.height, (right - left) / 2, (bottom - top) / 2, this.width, this.height] as const;
    this.perspective.setViewOffset(...offset);
    this.orthographic.setViewOffset(...offset);
    const half = this.extent / 2;
    Object.assign(this.orthographic, {left: -half * aspect, right: half * aspect, top: half, bottom: -half,
      near: 0.1, far: 200});
    this.orthographic.position.set(this.target.x, this.target.y, 100);
    this.orthographic.updateProjectionMatrix();
    this.orthographic.updateMatrixWorld();
  }
}

/** Returns whether WebGL draws without a graphics card. */
function drawsInSoftware(): boolean {
  const context = document.createElement('canvas').getContext('webgl2');
  const names = context?.getExtension('WEBGL_debug_renderer_info');
  const name = context && names ? String(context.getParameter(names.UNMASKED_RENDERER_WEBGL)) : '';
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software/i.test(name);
}
