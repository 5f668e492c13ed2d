import * as THREE from 'three';
import {Crowd} from './crowd';
import {Colours} from './colours';

const VERTEX_SHADER = `
attribute vec4 place;  // x, y, heading, radius
attribute vec3 colour;
uniform float height;
uniform float scale;
varying vec2 at;
varying vec3 tint;

void main() {
  at = position.xy;
  tint = colour;
  float s = sin(place.z), c = cos(place.z);
  vec2 corner = place.w * scale * vec2(c * at.x - s * at.y, s * at.x + c * at.y);
  gl_Position = projectionMatrix * viewMatrix * vec4(place.xy + corner, height, 1.0);
}`;

/** A disc with a bright nose where it looks. */
const DISC_SHADER = `
varying vec2 at;
varying vec3 tint;
void main() {
  float d = length(at);
  if (d > 1.0) discard;
  float nose = step(length(at - vec2(0.55, 0.0)), 0.3);
  vec3 shade = mix(tint * (d > 0.84 ? 0.72 : 1.0), vec3(1.0), 0.75 * nose);
  gl_FragColor = vec4(shade, 1.0);
}`;

const SHADOW_SHADER = `
varying vec2 at;
varying vec3 tint;
void main() { gl_FragColor = vec4(0.1, 0.13, 0.2, 0.34 * clamp(1.3 * (1.0 - length(at)), 0.0, 1.0)); }`;

/** Discs on the floor, one for each agent: one draw call for all. */
export class Discs {
  readonly mesh: THREE.Mesh<THREE.InstancedBufferGeometry, THREE.ShaderMaterial>;
  private place!: THREE.InstancedBufferAttribute;
  private colour!: THREE.InstancedBufferAttribute;

  /** isShadow: a soft shadow under a figure in place of a disc. */
  constructor(private readonly isShadow: boolean) {
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.mesh = new THREE.Mesh(geometry, new THREE.ShaderMaterial({
      vertexShader: VERTEX_SHADER, fragmentShader: isShadow ? SHADOW_SHADER : DISC_SHADER, transparent: isShadow,
      depthWrite: !isShadow, uniforms: {height: {value: isShadow ? 0.012 : 0.03}, scale: {value: isShadow ? 1.5 : 1}},
    }));
    this.mesh.frustumCulled = false;
    this.mesh.matrixAutoUpdate = false;
    this.mesh.renderOrder = isShadow ? 3 : 0;
    this.reserve(64);
  }

  update(crowd: Crowd, colours: Colours, radiusOf: (id: number) => number): void {
    this.reserve(crowd.count);
    const place = this.place.array as Float32Array;
    for (let i = 0; i < crowd.count; ++i) {
      place[4 * i] = crowd.x[i];
      place[4 * i + 1] = crowd.y[i];
      place[4 * i + 2] = crowd.heading[i];
      place[4 * i + 3] = radiusOf(crowd.id[i]);
    }
    if (!this.isShadow) {
      colours.write(crowd, this.colour.array as Uint8Array);
    }
    for (const attribute of this.isShadow ? [this.place] : [this.place, this.colour]) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, crowd.count * attribute.itemSize);
      attribute.needsUpdate = true;
    }
    this.mesh.geometry.instanceCount = crowd.count;
  }

  private reserve(count: number): void {
    if (this.place && count <= this.place.count) {
      return;
    }
    const size = Math.ceil(1.5 * count);
    this.place = new THREE.InstancedBufferAttribute(new Float32Array(4 * size), 4);
    this.colour = new THREE.InstancedBufferAttribute(new Uint8Array(3 * size), 3, true);
    this.mesh.geometry.dispose();
    this.mesh.geometry.setAttribute('place', this.place.setUsage(THREE.DynamicDrawUsage));
    this.mesh.geometry.setAttribute('colour', this.colour.setUsage(THREE.DynamicDrawUsage));
  }
}
