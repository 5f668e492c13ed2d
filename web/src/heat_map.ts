import * as THREE from 'three';
import {DENSITY_TABLE} from './colours';
import {DensityGrid} from './density_grid';

/** Density of the legend's last colour [people/m²]. */
export const HIGHEST_DENSITY = 3;

/** Densities of people as a picture on the floor. */
export class HeatMap {
  readonly mesh: THREE.Mesh<THREE.PlaneGeometry, THREE.MeshBasicMaterial>;
  private texels = new Uint8Array(4);

  constructor(private readonly grid: DensityGrid) {
    this.mesh = new THREE.Mesh(new THREE.PlaneGeometry(1, 1), new THREE.MeshBasicMaterial({
      transparent: true, depthWrite: false}));
    this.mesh.visible = false;
  }

  /** Has the size of the grid. */
  cover(): void {
    const {columns, rows, cell, left, low} = this.grid;
    this.texels = new Uint8Array(4 * columns * rows);
    this.mesh.material.map?.dispose();
    const texture = new THREE.DataTexture(this.texels, columns, rows);
    texture.magFilter = THREE.LinearFilter;
    texture.minFilter = THREE.LinearFilter;
    this.mesh.material.map = texture;
    this.mesh.material.needsUpdate = true;
    this.mesh.scale.set(columns * cell, rows * cell, 1);
    this.mesh.position.set(left + columns * cell / 2, low + rows * cell / 2, 0.008);
  }

  draw(): void {
    const {values} = this.grid;
    for (let cell = 0; cell < values.length; ++cell) {
      const share = Math.min(Math.max(values[cell], 0) / HIGHEST_DENSITY, 1);
      const colour = DENSITY_TABLE[Math.round(255 * share)];
      this.texels[4 * cell] = colour[0];
      this.texels[4 * cell + 1] = colour[1];
      this.texels[4 * cell + 2] = colour[2];
      this.texels[4 * cell + 3] = 215 * Math.min(6 * share, 1);
    }
    this.mesh.material.map!.needsUpdate = true;
  }
}
