import * as THREE from 'three';
import {Rgb} from './colours';
import {repeat} from './records';

/** Flat shapes of size 1 around the origin, which point along x. */
const SHAPES = {
  ring: () => new THREE.RingGeometry(0.78, 1, 28),
  target: () => new THREE.RingGeometry(0.6, 1, 10),
  dot: () => new THREE.CircleGeometry(1, 6),
  /** From 0 to 1, with half its width 1 at the head. */
  arrow: () => new THREE.ShapeGeometry(new THREE.Shape([[0, -0.4], [0.66, -0.4], [0.66, -1], [1, 0], [0.66, 1],
    [0.66, 0.4], [0, 0.4]].map(([x, y]) => new THREE.Vector2(x, y)))),
  /** From 0 to 1. */
  line: () => new THREE.PlaneGeometry(1, 2).translate(0.5, 0, 0),
};

/** Copies of a flat shape on the floor: one draw call for all. */
export class FlatShapes {
  readonly mesh: THREE.Mesh<THREE.BufferGeometry, THREE.MeshBasicMaterial>;
  private readonly base: THREE.BufferGeometry;
  private readonly vertices: number;
  private count = 0;

  constructor(shape: keyof typeof SHAPES, private capacity: number, private readonly height: number, opacity = 1) {
    this.base = SHAPES[shape]();
    this.base.deleteAttribute('uv');
    this.base.deleteAttribute('normal');
    this.vertices = this.base.getAttribute('position').count;
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial({
      transparent: true, opacity, depthWrite: false, side: THREE.DoubleSide, vertexColors: true,
    }));
    this.mesh.frustumCulled = false;
    this.mesh.matrixAutoUpdate = false;
    this.mesh.renderOrder = 4 + height;
    this.begin(capacity);
    this.finish();
  }

  /** Begins anew, with room for a number of shapes. */
  begin(capacity = this.capacity): void {
    this.count = 0;
    if (capacity > this.capacity || !this.mesh.geometry.index) {
      this.capacity = capacity;
      this.mesh.geometry.dispose();
      this.mesh.geometry = repeat(this.base, capacity);
      this.mesh.geometry.setAttribute('color',
        new THREE.BufferAttribute(new Uint8Array(3 * capacity * this.vertices), 3, true));
    }
  }

  add(x: number, y: number, length: number, width: number, angle: number, colour: Rgb): void {
    if (this.count === this.capacity) {
      return;
    }
    const shape = this.base.getAttribute('position').array;
    const {position, color} = this.mesh.geometry.attributes;
    const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
    for (let i = 0; i < this.vertices; ++i) {
      const [u, v] = [length * shape[3 * i], width * shape[3 * i + 1]];
      const k = 3 * (this.count * this.vertices + i);
      position.array[k] = x + cosine * u - sine * v;
      position.array[k + 1] = y + sine * u + cosine * v;
      position.array[k + 2] = this.height;
      color.array.set(colour, k);
    }
    ++this.count;
  }

  /** Adds a shape between two places. */
  addBetween(x0: number, y0: number, x1: number, y1: number, width: number, colour: Rgb): void {
    this.add(x0, y0, Math.hypot(x1 - x0, y1 - y0), width, Math.atan2(y1 - y0, x1 - x0), colour);
  }

  /** Shows what has been added. */
  finish(): void {
    this.mesh.visible = this.count > 0;
    this.mesh.geometry.setDrawRange(0, this.count * this.base.index!.count);
    this.mesh.geometry.attributes.position.needsUpdate = true;
    this.mesh.geometry.attributes.color.needsUpdate = true;
  }
}
