import * as THREE from 'three';
import {figureMesh} from './figure_mesh';
import {ANGLES, BOX, CLOTH_UNIFORM, FIGURE_SHADERS, MIDDLE, POSES} from './people_shaders';
import {Copies, Records} from './records';

const CELL = 96;            // [pixels]
const SWING = 0.38;         // [rad]
const TOLERANCE = 0.05;     // [rad] between the camera's angle and that of the pictures

/** Pictures of a figure from all sides in all poses, which stand for distant figures. */
export class Sprites {
  /** Of the sprites' material. */
  readonly uniform: {value: THREE.Texture};
  private readonly target = new THREE.WebGLRenderTarget(ANGLES * CELL, POSES * CELL, {
    samples: 4, generateMipmaps: true, minFilter: THREE.LinearMipmapNearestFilter});
  private readonly camera = new THREE.OrthographicCamera(-BOX / 2, BOX / 2, BOX / 2, -BOX / 2, 0.1, 20);
  private readonly scene = new THREE.Scene();
  private polar = NaN;

  constructor() {
    const count = ANGLES * POSES;
    const records = new Records(count);
    for (let i = 0; i < count; ++i) {
      const pose = Math.floor(i / ANGLES);
      records.data.set([0, 0, 2 * Math.PI * (i % ANGLES) / ANGLES, 2 * Math.PI * (pose + 0.5) / (POSES - 1),
        0.25, pose === POSES - 1 ? 0 : SWING], 8 * i);
    }
    records.upload();
    const figures = new Copies(figureMesh(), records, {
      ...FIGURE_SHADERS, side: THREE.DoubleSide, uniforms: CLOTH_UNIFORM, defines: {ATLAS: 1}});
    figures.show(count);
    this.scene.add(figures.mesh);
    this.camera.up.set(0, 0, 1);
    this.uniform = {value: this.target.texture};
  }

  /** Draws the pictures as a camera at the given angle from straight down sees figures, if they are others. */
  update(renderer: THREE.WebGLRenderer, polar: number): void {
    if (Math.abs(polar - this.polar) < TOLERANCE) {
      return;
    }
    this.polar = polar;
    const angle = Math.max(polar, 0.001);
    this.camera.position.set(0, -5 * Math.sin(angle), MIDDLE + 5 * Math.cos(angle));
    this.camera.lookAt(0, 0, MIDDLE);
    const [colour, alpha] = [renderer.getClearColor(new THREE.Color()), renderer.getClearAlpha()];
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0, 0);
    renderer.render(this.scene, this.camera);
    renderer.setRenderTarget(null);
    renderer.setClearColor(colour, alpha);
  }
}
