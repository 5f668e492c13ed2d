import * as THREE from 'three';
import {Colours} from './colours';
import {History, isShown, Moment} from './history';

const SEGMENTS = 60000;
const LENGTH = 8;      // [s] that a path is shown
const WIDTH = 0.035;   // half of it [m]

const VERTEX_SHADER = `
attribute vec4 ends;   // from x, y to x, y
attribute float time;  // at its end
attribute vec3 colour;
uniform float now;
uniform float width;
varying vec4 shade;

void main() {
  float age = (now - time) / ${LENGTH.toFixed(1)};
  vec2 along = normalize(ends.zw - ends.xy + vec2(1e-6, 0.0));
  vec2 at = mix(ends.xy, ends.zw, position.x) + width * position.y * vec2(-along.y, along.x);
  shade = vec4(colour, 0.75 * (1.0 - age));
  gl_Position = age < 0.0 || age > 1.0 ? vec4(2.0, 2.0, 2.0, 1.0)
    : projectionMatrix * viewMatrix * vec4(at, 0.016, 1.0);
}`;

const FRAGMENT_SHADER = `
varying vec4 shade;
void main() { gl_FragColor = shade; }`;

/** The paths of the last seconds: ribbons on the floor that fade. A ring of segments, of which only new ones are uploaded. */
export class Trails {
  readonly mesh: THREE.Mesh<THREE.InstancedBufferGeometry, THREE.ShaderMaterial>;
  private readonly ends = new THREE.InstancedBufferAttribute(new Float32Array(4 * SEGMENTS), 4);
  private readonly time = new THREE.InstancedBufferAttribute(new Float32Array(SEGMENTS).fill(-1e9), 1);
  private readonly colour = new THREE.InstancedBufferAttribute(new Uint8Array(3 * SEGMENTS), 3, true);
  private next = 0;
  private used = 0;
  private newest: Moment | undefined;

  constructor() {
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0], 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    geometry.setAttribute('ends', this.ends.setUsage(THREE.DynamicDrawUsage));
    geometry.setAttribute('time', this.time.setUsage(THREE.DynamicDrawUsage));
    geometry.setAttribute('colour', this.colour.setUsage(THREE.DynamicDrawUsage));
    geometry.instanceCount = 0;
    this.mesh = new THREE.Mesh(geometry, new THREE.ShaderMaterial({
      vertexShader: VERTEX_SHADER, fragmentShader: FRAGMENT_SHADER, transparent: true, depthWrite: false,
      side: THREE.DoubleSide, uniforms: {now: {value: 0}, width: {value: WIDTH}},
    }));
    this.mesh.frustumCulled = false;
    this.mesh.matrixAutoUpdate = false;
    this.mesh.renderOrder = 2;
  }

  /** Shows the paths before a time. Adds what is missing; after a jump in time, all. */
  update(history: History, time: number, colours: Colours, metresPerPixel: number): void {
    const {uniforms} = this.mesh.material;
    uniforms.now.value = time;
    uniforms.width.value = Math.max(WIDTH, metresPerPixel);
    const {moments} = history;
    const end = history.indexAt(time);
    let begin = this.newest ? moments.lastIndexOf(this.newest) + 1 : 0;
    if (moments[end] === this.newest && this.newest) {
      return;
    }
    if (begin === 0 || begin > end) {
      this.clear();
      begin = history.indexAt(time - LENGTH) + 1;
    }
    const first = this.next;
    let added = 0;
    for (let i = Math.max(begin, 1); i <= end; ++i) {
      added += this.add(moments[i - 1], moments[i], colours);
    }
    this.newest = moments[end];
    this.upload(first, added);
  }

  clear(): void {
    this.newest = undefined;
    this.next = 0;
    this.used = 0;
    (this.time.array as Float32Array).fill(-1e9);
    this.time.clearUpdateRanges();
    this.mesh.geometry.instanceCount = 0;
  }

  private add(before: Moment, after: Moment, colours: Colours): number {
    const ends = this.ends.array as Float32Array;
    const times = this.time.array as Float32Array;
    const bytes = this.colour.array as Uint8Array;
    let added = 0;
    for (let i = 0; i < after.count; ++i) {
      const j = after.previous[i];
      if (j < 0 || !isShown(after.state[i]) || (before.x[j] === after.x[i] && before.y[j] === after.y[i])) {
        continue;
      }
      const k = this.next;
      ends[4 * k] = before.x[j];
      ends[4 * k + 1] = before.y[j];
      ends[4 * k + 2] = after.x[i];
      ends[4 * k + 3] = after.y[i];
      times[k] = after.time;
      bytes.set(colours.ofPerson(after.id[i]), 3 * k);
      this.next = (k + 1) % SEGMENTS;
      ++added;
    }
    return added;
  }

  private upload(first: number, added: number): void {
    this.used = Math.min(Math.max(this.used, first + added), SEGMENTS);
    this.mesh.geometry.instanceCount = this.used;
    const wraps = first + added > SEGMENTS;
    for (const attribute of [this.ends, this.time, this.colour]) {
      attribute.clearUpdateRanges();
      const [begin, count] = wraps ? [0, SEGMENTS] : [first, added];
      attribute.addUpdateRange(begin * attribute.itemSize, count * attribute.itemSize);
      attribute.needsUpdate = added > 0;
    }
  }
}
