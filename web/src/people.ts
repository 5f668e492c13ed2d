import * as THREE from 'three';
import {Colours} from './colours';
import {Crowd} from './crowd';
import {figureMesh} from './figure_mesh';
import {CLOTH_UNIFORM, DISC_SHADERS, FIGURE_SHADERS, SHADOW_SHADERS, SPRITE_SHADERS} from './people_shaders';
import {Copies, Records} from './records';
import {Sprites} from './sprites';
import {View} from './view';

const STRIDE = 1.35;       // [m] of two steps
const FULL_SWING = 0.9;    // [m/s]; slower people make smaller steps
const SWING = 0.38;        // [rad]
const MARGIN = 1.1;        // of the picture in which people are drawn

/** People as walking figures with shadows, or as discs. Limbs swing by the distance walked. */
export class People {
  readonly group = new THREE.Group();
  private readonly records = new Records(256);
  private readonly sprites = new Sprites();
  private readonly camera = {screenHeight: {value: 1}, flatness: {value: 1}, azimuth: {value: 0}};
  private readonly figures = new Copies(figureMesh(), this.records, {
    ...FIGURE_SHADERS, side: THREE.DoubleSide, uniforms: CLOTH_UNIFORM});
  private buffer!: THREE.InterleavedBuffer;
  private readonly points = new THREE.BufferGeometry();
  private readonly shadows = this.makePoints({...SHADOW_SHADERS, transparent: true, depthWrite: false});
  private readonly discs = this.makePoints(DISC_SHADERS);
  private readonly distant = this.makePoints(SPRITE_SHADERS);
  private readonly matrix = new THREE.Matrix4();

  constructor() {
    this.shadows.renderOrder = 3;
    this.group.add(this.figures.mesh, this.shadows, this.discs, this.distant);
    this.makeAttributes();
  }

  /** Shows all people in view. More figures than given are pictures of figures. */
  update(crowd: Crowd, colours: Colours, radiusOf: (id: number) => number, view: View, areFigures: boolean,
         mostMeshes: number): void {
    if (this.records.reserve(crowd.count)) {
      this.makeAttributes();
    }
    const count = this.write(crowd, colours, radiusOf, view);
    const areMeshes = areFigures && count <= mostMeshes;
    this.figures.show(areMeshes ? count : 0);
    if (areMeshes) {
      this.records.upload();
    } else if (areFigures) {
      this.sprites.update(view.renderer, view.polarAngle);
    }
    this.buffer.needsUpdate = true;
    this.points.setDrawRange(0, count);
    this.distant.visible = areFigures && !areMeshes;
    this.shadows.visible = areFigures;
    this.discs.visible = !areFigures;
    this.camera.screenHeight.value = view.height * view.renderer.getPixelRatio();
    this.camera.flatness.value = Math.max(Math.cos(view.polarAngle), 0.05);
    this.camera.azimuth.value = view.azimuthAngle;
  }

  /** Writes the records of all people in view. Returns their number. */
  private write(crowd: Crowd, colours: Colours, radiusOf: (id: number) => number, view: View): number {
    const {data} = this.records;
    const m = this.matrix.multiplyMatrices(view.camera.projectionMatrix, view.camera.matrixWorldInverse).elements;
    let k = 0;
    for (let i = 0; i < crowd.count; ++i) {
      const [x, y] = [crowd.x[i], crowd.y[i]];
      const reach = MARGIN * (m[3] * x + m[7] * y + m[15]) + 0.02;
      if (Math.abs(m[0] * x + m[4] * y + m[12]) > reach || Math.abs(m[1] * x + m[5] * y + m[13]) > reach) {
        continue;
      }
      const colour = colours.of(crowd, i);
      data[k] = x;
      data[k + 1] = y;
      data[k + 2] = crowd.heading[i];
      data[k + 3] = crowd.walked[i] / STRIDE * 2 * Math.PI % (2 * Math.PI);
      data[k + 4] = radiusOf(crowd.id[i]);
      data[k + 5] = SWING * Math.min(crowd.speed[i] / FULL_SWING, 1);
      data[k + 6] = crowd.id[i] % 1024;
      data[k + 7] = Math.round(colour[0]) * 65536 + Math.round(colour[1]) * 256 + Math.round(colour[2]);
      k += 8;
    }
    return k / 8;
  }

  private makePoints(parameters: THREE.ShaderMaterialParameters): THREE.Points {
    const points = new THREE.Points(this.points, new THREE.ShaderMaterial({
      ...parameters, uniforms: {...CLOTH_UNIFORM, ...this.camera, atlas: this.sprites.uniform}}));
    points.frustumCulled = false;
    points.matrixAutoUpdate = false;
    return points;
  }

  private makeAttributes(): void {
    this.buffer = new THREE.InterleavedBuffer(this.records.data, 8).setUsage(THREE.DynamicDrawUsage);
    this.points.dispose();
    this.points.setAttribute('place', new THREE.InterleavedBufferAttribute(this.buffer, 4, 0));
    this.points.setAttribute('look', new THREE.InterleavedBufferAttribute(this.buffer, 4, 4));
  }
}
