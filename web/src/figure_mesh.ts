import * as THREE from 'three';

/** What a part of a figure wears: the index of its colour. */
enum Cloth { SHIRT, TROUSERS, SKIN, HAIR, SHOES }

/** Height of hips, knees, shoulders and elbows [m]; the shaders bend limbs there. */
export const HIP = 0.92;
export const KNEE = 0.49;
export const SHOULDER = 1.42;
export const ELBOW = 1.13;

/** A ring around a limb: height, half depth, half width, and how far ahead its middle is [m]. */
type Ring = [z: number, depth: number, width: number, ahead?: number];

interface Limb {
  rings: Ring[];
  cloth: Cloth;
  /** Place across the body [m]; left is positive. */
  side?: number;
  /** 0: the trunk; 1: a leg; 2: an arm. */
  kind?: number;
  /** Whether it hangs below knee or elbow. */
  isLower?: boolean;
}

const TRUNK: Limb[] = [
  {cloth: Cloth.SHIRT, rings: [[0.86, 0.105, 0.165], [1.0, 0.1, 0.145], [1.27, 0.12, 0.185], [1.4, 0.1, 0.195],
    [1.47, 0.06, 0.08]]},
  {cloth: Cloth.SKIN, rings: [[1.44, 0.05, 0.05], [1.53, 0.055, 0.055, 0.01], [1.58, 0.09, 0.075, 0.015],
    [1.66, 0.105, 0.082, 0.015], [1.74, 0.07, 0.06, 0.0]]},
  {cloth: Cloth.HAIR, rings: [[1.57, 0.07, 0.078, -0.035], [1.66, 0.1, 0.09, -0.018], [1.735, 0.09, 0.077, -0.008],
    [1.775, 0.04, 0.035, -0.01]]},
];
const LIMBS: Limb[] = [
  {cloth: Cloth.TROUSERS, kind: 1, side: 0.09, rings: [[KNEE - 0.02, 0.06, 0.058], [0.72, 0.08, 0.075], [HIP, 0.1, 0.085]]},
  {cloth: Cloth.TROUSERS, kind: 1, side: 0.09, isLower: true, rings: [[0.07, 0.048, 0.045], [0.33, 0.065, 0.055],
    [KNEE + 0.02, 0.06, 0.056]]},
  {cloth: Cloth.SHOES, kind: 1, side: 0.09, isLower: true, rings: [[0.0, 0.13, 0.05, 0.05], [0.05, 0.12, 0.048, 0.045],
    [0.1, 0.05, 0.042, 0.0]]},
  {cloth: Cloth.SHIRT, kind: 2, side: 0.212, rings: [[ELBOW - 0.02, 0.042, 0.04], [1.3, 0.05, 0.045], [SHOULDER, 0.05, 0.042]]},
  {cloth: Cloth.SHIRT, kind: 2, side: 0.212, isLower: true, rings: [[0.9, 0.034, 0.032], [ELBOW + 0.02, 0.042, 0.039]]},
  {cloth: Cloth.SKIN, kind: 2, side: 0.212, isLower: true, rings: [[0.78, 0.035, 0.018], [0.85, 0.045, 0.024],
    [0.91, 0.03, 0.028]]},
];
/** Collects the triangles of limbs. */
class MeshBuilder {
  private readonly position: number[] = [];
  private readonly normal: number[] = [];
  private readonly limb: number[] = [];
  private readonly index: number[] = [];

  /** Adds a limb with the given number of sides; mirror: -1 for that of the right side. */
  add({rings, cloth, side = 0, kind = 0, isLower = false}: Limb, sides: number, mirror: number): void {
    const start = this.position.length / 3;
    for (const [z, depth, width, ahead = 0] of rings) {
      for (let i = 0; i < sides; ++i) {
        const angle = 2 * Math.PI * (i + 0.5) / sides;
        this.position.push(ahead + depth * Math.cos(angle), mirror * side + width * Math.sin(angle), z);
        const length = Math.hypot(Math.cos(angle) / depth, Math.sin(angle) / width);
        this.normal.push(Math.cos(angle) / depth / length, Math.sin(angle) / width / length, 0);
        this.limb.push(cloth, kind * mirror, isLower ? 1 : 0);
      }
    }
    for (let ring = 0; ring + 1 < rings.length; ++ring) {
      for (let i = 0; i < sides; ++i) {
        const [a, b] = [start + ring * sides + i, start + ring * sides + (i + 1) % sides];
        this.index.push(a, b, a + sides, b, b + sides, a + sides);
      }
    }
    this.close(start + (rings.length - 1) * sides, sides, rings[rings.length - 1][0] > 1.4);
  }

  /** Closes the upper end, which is seen from above: lit as a top. */
  private close(first: number, sides: number, isTop: boolean): void {
    if (!isTop) {
      return;
    }
    for (let i = 0; i < sides; ++i) {
      this.normal.splice(3 * (first + i), 3, 0, 0, 1);
    }
    for (let i = 1; i + 1 < sides; ++i) {
      this.index.push(first, first + i, first + i + 1);
    }
  }

  geometry(): THREE.BufferGeometry {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(this.position, 3));
    geometry.setAttribute('normal', new THREE.Float32BufferAttribute(this.normal, 3));
    geometry.setAttribute('limb', new THREE.Float32BufferAttribute(this.limb, 3));
    geometry.setIndex(this.index);
    return geometry;
  }
}

/** Returns the mesh of a standing person who looks along x. */
export function figureMesh(): THREE.BufferGeometry {
  const builder = new MeshBuilder();
  for (const limb of [...TRUNK, ...LIMBS]) {
    const sides = limb.kind === 2 ? 4 : limb.kind === 1 ? 5 : 8;
    builder.add(limb, sides, 1);
    if (limb.kind) {
      builder.add(limb, sides, -1);
    }
  }
  return builder.geometry();
}
