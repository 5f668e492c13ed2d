import * as THREE from 'three';
import {Rgb} from './colours';

/** Outlines of flat shapes of size 1 around the origin, which point along x. */
export const SHAPES = {
  ring: () => new THREE.RingGeometry(0.78, 1, 28),
  target: () => new THREE.ShapeGeometry(targetShapes(), 8),
  disc: () => new THREE.CircleGeometry(1, 20),
  /** From 0 to 1, with half its width 1 at the head. */
  arrow: () => new THREE.ShapeGeometry(new THREE.Shape([[0, -0.4], [0.66, -0.4], [0.66, -1], [1, 0], [0.66, 1],
    [0.66, 0.4], [0, 0.4]].map(([x, y]) => new THREE.Vector2(x, y)))),
  /** From 0 to 1. */
  line: () => new THREE.PlaneGeometry(1, 2).translate(0.5, 0, 0),
};

function targetShapes(): THREE.Shape[] {
  const ring = new THREE.Shape().absarc(0, 0, 1, 0, 2 * Math.PI);
  ring.holes.push(new THREE.Path().absarc(0, 0, 0.72, 0, 2 * Math.PI));
  return [ring, new THREE.Shape().absarc(0, 0, 0.38, 0, 2 * Math.PI)];
}

/** Copies of a flat shape on the floor: one draw call for all. */
export class FlatShapes {
  readonly mesh: THREE.InstancedMesh<THREE.BufferGeometry, THREE.MeshBasicMaterial>;
  private readonly matrix = new THREE.Matrix4();
  private readonly size = new THREE.Vector3();
  private readonly colour = new THREE.Color();

  constructor(shape: keyof typeof SHAPES, private readonly capacity: number, private readonly height: number,
              opacity = 1) {
    this.mesh = new THREE.InstancedMesh(SHAPES[shape](), new THREE.MeshBasicMaterial({
      transparent: true, opacity, depthWrite: false, side: THREE.DoubleSide,
    }), capacity);
    this.mesh.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
    this.mesh.frustumCulled = false;
    this.mesh.matrixAutoUpdate = false;
    this.mesh.renderOrder = 4 + height;
    this.clear();
  }

  clear(): void {
    this.mesh.count = 0;
  }

  add(x: number, y: number, length: number, width: number, angle: number, [r, g, b]: Rgb): void {
    const i = this.mesh.count;
    if (i === this.capacity) {
      return;
    }
    this.matrix.makeRotationZ(angle).scale(this.size.set(length, width, 1)).setPosition(x, y, this.height);
    this.mesh.count = i + 1;
    this.mesh.setMatrixAt(i, this.matrix);
    this.mesh.setColorAt(i, this.colour.setRGB(r / 255, g / 255, b / 255));
  }

  /** Adds a shape between two places. */
  addBetween(x0: number, y0: number, x1: number, y1: number, width: number, colour: Rgb): void {
    this.add(x0, y0, Math.hypot(x1 - x0, y1 - y0), width, Math.atan2(y1 - y0, x1 - x0), colour);
  }

  /** Shows what has been added. */
  finish(): void {
    this.mesh.instanceMatrix.needsUpdate = true;
    if (this.mesh.instanceColor) {
      this.mesh.instanceColor.needsUpdate = true;
    }
  }
}
