import * as THREE from 'three';
import {Colours} from './colours';
import {Crowd} from './crowd';
import {ELBOW, figureMesh, HIP, KNEE, SHOULDER} from './figure_mesh';

const STRIDE = 1.35;       // [m] of two steps
const FULL_SWING = 0.9;    // [m/s]; slower people make smaller steps
const USUAL_RADIUS = 0.25; // [m] of a person of usual size

const VERTEX_SHADER = `
attribute vec3 limb;   // cloth, leg (1) or arm (2) with the sign of its side, whether below knee or elbow
attribute vec4 place;  // x, y, heading, phase of the walk
attribute vec3 shape;  // size, swing, number of the person
attribute vec3 colour;
uniform vec3 cloths[18];
varying vec3 shade;

void bend(inout vec3 p, inout vec3 n, float pivot, float angle) {
  float s = sin(angle), c = cos(angle);
  p = vec3(c * p.x - s * (p.z - pivot), p.y, s * p.x + c * (p.z - pivot) + pivot);
  n = vec3(c * n.x - s * n.z, n.y, s * n.x + c * n.z);
}

vec3 clothColour(float cloth, float person) {
  if (cloth < 0.5) return colour;
  float choice = floor(fract(sin(person * 12.9898 + cloth * 78.233) * 43758.5453) * 6.0);
  if (cloth < 1.5) return cloths[int(choice)];
  if (cloth < 2.5) return cloths[6 + int(choice)];
  if (cloth < 3.5) return cloths[12 + int(choice)];
  return vec3(0.16, 0.15, 0.17);
}

void main() {
  vec3 p = position, n = normal;
  float kind = abs(limb.y);
  float side = sign(limb.y);
  float phase = place.w + (side < 0.0 ? 3.14159265 : 0.0);
  float swing = shape.y * sin(phase);
  if (kind > 1.5) {
    if (limb.z > 0.5) bend(p, n, ${ELBOW}, 0.22 + 0.5 * shape.y - 0.3 * swing);
    bend(p, n, ${SHOULDER}, -0.8 * swing);
  } else if (kind > 0.5) {
    float lift = max(cos(phase), 0.0);
    if (limb.z > 0.5) bend(p, n, ${KNEE}, -2.2 * shape.y * lift * lift - 0.05);
    bend(p, n, ${HIP}, 1.05 * swing + 0.25 * shape.y * lift * lift);
  } else {
    float lean = 0.05 * shape.y;
    p.x += lean * (p.z - ${HIP});
  }
  p.z -= ${HIP} * (1.0 - cos(swing)) * 0.9;
  float s = sin(place.z), c = cos(place.z);
  vec3 world = vec3(place.xy + shape.x * vec2(c * p.x - s * p.y, s * p.x + c * p.y), shape.x * p.z);
  vec3 direction = vec3(c * n.x - s * n.y, s * n.x + c * n.y, n.z);
  float light = 0.66 + 0.3 * dot(direction, vec3(-0.48, -0.6, 0.64)) + 0.08 * direction.z + 0.06 * (p.z - 0.9);
  shade = clothColour(limb.x, shape.z) * light;
  gl_Position = projectionMatrix * viewMatrix * vec4(world, 1.0);
}`;

const FRAGMENT_SHADER = `
varying vec3 shade;
void main() { gl_FragColor = vec4(shade, 1.0); }`;

const CLOTHS = [
  0x2f3e5c, 0x4a4f57, 0x6b5b4b, 0x22262e, 0x5d6f86, 0x8a8172,  // trousers
  0xf0c8a6, 0xe0ac82, 0xc68a5e, 0x9a6541, 0x6d452c, 0xf3d3b8,  // skin
  0x2a211c, 0x4b3323, 0x7a5636, 0xb58d55, 0x1c1a1b, 0x8e8a86,  // hair
].map((colour) => new THREE.Color(colour));

/** People as walking figures: one draw call for all. Limbs swing by the distance walked. */
export class Figures {
  readonly mesh: THREE.Mesh<THREE.InstancedBufferGeometry, THREE.ShaderMaterial>;
  private place!: THREE.InstancedBufferAttribute;
  private shape!: THREE.InstancedBufferAttribute;
  private colour!: THREE.InstancedBufferAttribute;
  private readonly near = figureMesh(false);
  private readonly far = figureMesh(true);

  constructor() {
    const material = new THREE.ShaderMaterial({
      vertexShader: VERTEX_SHADER, fragmentShader: FRAGMENT_SHADER, uniforms: {cloths: {value: CLOTHS}},
      side: THREE.DoubleSide,
    });
    this.mesh = new THREE.Mesh(this.near, material);
    this.mesh.frustumCulled = false;
    this.mesh.matrixAutoUpdate = false;
    this.reserve(64);
  }

  /** Shows the crowd; far: with few triangles. */
  update(crowd: Crowd, colours: Colours, radiusOf: (id: number) => number, isFar: boolean): void {
    this.reserve(crowd.count);
    const place = this.place.array as Float32Array;
    const shape = this.shape.array as Float32Array;
    for (let i = 0; i < crowd.count; ++i) {
      place[4 * i] = crowd.x[i];
      place[4 * i + 1] = crowd.y[i];
      place[4 * i + 2] = crowd.heading[i];
      place[4 * i + 3] = crowd.walked[i] / STRIDE * 2 * Math.PI;
      shape[3 * i] = 0.7 + 0.3 * Math.min(Math.max(radiusOf(crowd.id[i]) / USUAL_RADIUS, 0.4), 1.4);
      shape[3 * i + 1] = 0.44 * Math.min(crowd.speed[i] / FULL_SWING, 1);
      shape[3 * i + 2] = crowd.id[i] % 1024;
    }
    colours.write(crowd, this.colour.array as Uint8Array);
    for (const attribute of [this.place, this.shape, this.colour]) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, crowd.count * attribute.itemSize);
      attribute.needsUpdate = true;
    }
    this.mesh.geometry = isFar ? this.far : this.near;
    this.mesh.geometry.instanceCount = crowd.count;
  }

  private reserve(count: number): void {
    if (this.place && count <= this.place.count) {
      return;
    }
    const size = Math.ceil(1.5 * count);
    this.place = new THREE.InstancedBufferAttribute(new Float32Array(4 * size), 4);
    this.shape = new THREE.InstancedBufferAttribute(new Float32Array(3 * size), 3);
    this.colour = new THREE.InstancedBufferAttribute(new Uint8Array(3 * size), 3, true);
    for (const attribute of [this.place, this.shape, this.colour]) {
      attribute.setUsage(THREE.DynamicDrawUsage);
    }
    for (const geometry of [this.near, this.far]) {
      geometry.dispose();
      geometry.setAttribute('place', this.place);
      geometry.setAttribute('shape', this.shape);
      geometry.setAttribute('colour', this.colour);
    }
  }
}
