import * as THREE from 'three';
import {Colours} from './colours';
import {History, isShown, Moment} from './history';
import {Copies, READ_RECORD, Records, square} from './records';

const SEGMENTS = 20000;
const SEGMENTS_SOFTWARE = 5000;
const LONGEST = 8;        // [s] that a path is shown
const SHORTEST = 1.5;
const SPACING = 0.3;      // [s] between corners of a path, at least
const MOST_PEOPLE = 2500; // more have no paths
const MOST_PEOPLE_SOFTWARE = 500;
const WIDTH = 0.035;      // half of it [m]

const SHADERS = {
  vertexShader: `${READ_RECORD}
uniform float now;
uniform float width;
uniform float span;
varying vec4 shade;

void main() {
  vec4 ends, look;  // x, y of both ends; time at the second, colour
  readRecord(VERTICES, ends, look);
  float age = (now - look.x) / span;
  vec2 along = normalize(ends.zw - ends.xy + vec2(1e-6, 0.0));
  vec2 at = mix(ends.xy, ends.zw, 0.5 + 0.5 * position.x) + width * position.y * vec2(-along.y, along.x);
  shade = vec4(unpackColour(look.y), 0.75 * (1.0 - age));
  gl_Position = age < 0.0 || age > 1.0 ? vec4(2.0, 2.0, 2.0, 1.0)
    : projectionMatrix * viewMatrix * vec4(at, 0.016, 1.0);
}`,
  fragmentShader: `
varying vec4 shade;
void main() { gl_FragColor = shade; }`,
  uniforms: {now: {value: 0}, width: {value: WIDTH}, span: {value: LONGEST}},
};

/** The paths of the last seconds: ribbons on the floor that fade. */
export class Trails {
  readonly mesh: THREE.Mesh<THREE.BufferGeometry, THREE.ShaderMaterial>;
  private readonly segments: number;
  private readonly mostPeople: number;
  private readonly records: Records;
  private readonly ribbons: Copies;
  isShown = false;
  private next = 0;
  private used = 0;
  private newest: Moment | undefined;

  /** isSoftware: few segments, since there is no graphics card. */
  constructor(isSoftware: boolean) {
    this.segments = isSoftware ? SEGMENTS_SOFTWARE : SEGMENTS;
    this.mostPeople = isSoftware ? MOST_PEOPLE_SOFTWARE : MOST_PEOPLE;
    this.records = new Records(this.segments);
    this.ribbons = new Copies(square(), this.records, {
      ...SHADERS, transparent: true, depthWrite: false, side: THREE.DoubleSide});
    this.mesh = this.ribbons.mesh;
    this.mesh.renderOrder = 2;
  }

  /** Shows the paths before a time. Adds what is missing; after a jump in time, all. */
  update(history: History, time: number, colours: Colours, metresPerPixel: number): void {
    const {moments} = history;
    const end = history.indexAt(time);
    this.mesh.visible = false;
    if (!this.isShown || !moments[end] || moments[end].count > this.mostPeople) {
      this.clear();
      return;
    }
    const length = Math.min(Math.max(SPACING * this.segments / moments[end].count, SHORTEST), LONGEST);
    let last = this.newest ? moments.lastIndexOf(this.newest) : -1;
    if (last < 0 || last > end) {
      this.clear();
      last = history.indexAt(time - length);
    }
    const spacing = length * moments[end].count / this.segments;
    for (let i = last + 1; i <= end; ++i) {
      if (moments[i].time - moments[last].time >= spacing) {
        this.add(moments, last, i, colours);
        last = i;
      }
    }
    this.newest = moments[last];
    const {uniforms} = this.mesh.material;
    uniforms.now.value = time;
    uniforms.span.value = length;
    uniforms.width.value = Math.max(WIDTH, metresPerPixel);
    this.ribbons.show(this.used);
  }

  clear(): void {
    this.newest = undefined;
    this.next = 0;
    this.used = 0;
  }

  /** Adds the ways of all agents from one moment to another. */
  private add(moments: Moment[], from: number, to: number, colours: Colours): void {
    const after = moments[to];
    const before = moments[from];
    const {data} = this.records;
    for (let i = 0; i < after.count; ++i) {
      let j = i;
      for (let m = to; m > from && j >= 0; --m) {
        j = moments[m].previous[j];
      }
      if (j < 0 || !isShown(after.state[i]) || (before.x[j] === after.x[i] && before.y[j] === after.y[i])) {
        continue;
      }
      const [r, g, b] = colours.ofPerson(after.id[i]);
      const k = 8 * this.next;
      data[k] = before.x[j];
      data[k + 1] = before.y[j];
      data[k + 2] = after.x[i];
      data[k + 3] = after.y[i];
      data[k + 4] = after.time;
      data[k + 5] = Math.round(r) * 65536 + Math.round(g) * 256 + Math.round(b);
      this.next = (this.next + 1) % this.segments;
      this.used = Math.max(this.used, this.next, this.next === 0 ? this.segments : 0);
    }
    this.records.upload();
  }
}
