import * as THREE from 'three';
import {mapCells, occupiedRectangles} from './map_cells';
import {GridMap, Obstacle, Scene, Wall} from './messages';

const HEIGHT = 0.9;      // [m] of walls; low, so that people behind are seen
const WALL_WIDTH = 0.12;
const WALL = new THREE.Color(0x66738a);
const OBSTACLE = new THREE.Color(0x8d9aae);
const FLOOR = 0xfafbfc;
const MARGIN = 2;        // [m] of floor around the scene
const SIDES = 24;        // of an obstacle

/** Floor, walls, obstacles and map of a scene. */
export class Scenery {
  readonly group = new THREE.Group();
  private obstacles = new Solids().mesh();

  /** Shows a scene instead of the one before. */
  show(scene: Pick<Scene, 'bounds' | 'walls' | 'obstacles' | 'map'>): void {
    for (const child of [...this.group.children] as THREE.Mesh[]) {
      this.remove(child);
    }
    const solids = new Solids();
    scene.walls.forEach((wall) => addWall(solids, wall));
    if (scene.map) {
      addMap(solids, scene.map);
    }
    this.addFloor(scene.bounds);
    this.group.add(solids.mesh());
    this.showObstacles(scene.obstacles);
  }

  /** Shows obstacles instead of those before. */
  showObstacles(obstacles: Obstacle[]): void {
    this.remove(this.obstacles);
    const solids = new Solids();
    obstacles.forEach((obstacle) => addObstacle(solids, obstacle));
    this.obstacles = solids.mesh();
    this.group.add(this.obstacles);
  }

  private remove(part: THREE.Mesh): void {
    this.group.remove(part);
    part.geometry.dispose();
    (part.material as THREE.Material).dispose();
  }

  private addFloor([x0, y0, x1, y1]: Scene['bounds']): void {
    const [left, right] = [Math.floor(x0 - MARGIN), Math.ceil(x1 + MARGIN)];
    const [low, high] = [Math.floor(y0 - MARGIN), Math.ceil(y1 + MARGIN)];
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(right - left, high - low),
      new THREE.MeshBasicMaterial({color: FLOOR, depthWrite: false}));
    floor.position.set((left + right) / 2, (low + high) / 2, 0);
    floor.renderOrder = -2;
    const spacing = Math.max(right - left, high - low) > 60 ? 5 : 1;
    const points: number[] = [];
    for (let x = Math.ceil(left / spacing) * spacing; x <= right; x += spacing) {
      points.push(x, low, 0, x, high, 0);
    }
    for (let y = Math.ceil(low / spacing) * spacing; y <= high; y += spacing) {
      points.push(left, y, 0, right, y, 0);
    }
    const grid = new THREE.LineSegments(new THREE.BufferGeometry(),
      new THREE.LineBasicMaterial({color: 0xe8ecf2, depthWrite: false}));
    grid.geometry.setAttribute('position', new THREE.Float32BufferAttribute(points, 3));
    grid.renderOrder = -1;
    this.group.add(floor, grid);
  }
}

function addWall(solids: Solids, {from, to}: Wall): void {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
  const along = [(to[0] - from[0]) / length * WALL_WIDTH / 2, (to[1] - from[1]) / length * WALL_WIDTH / 2];
  const corner = (end: number[], ahead: number, left: number): number[] =>
    [end[0] + ahead * along[0] - left * along[1], end[1] + ahead * along[1] + left * along[0]];
  solids.add([corner(from, -1, -1), corner(to, 1, -1), corner(to, 1, 1), corner(from, -1, 1)], WALL);
}

function addObstacle(solids: Solids, {position, radius}: Obstacle): void {
  solids.add(Array.from({length: SIDES}, (_, i) => {
    const angle = 2 * Math.PI * i / SIDES;
    return [position[0] + radius * Math.cos(angle), position[1] + radius * Math.sin(angle)];
  }), OBSTACLE);
}

function addMap(solids: Solids, map: GridMap): void {
  const [x, y, yaw] = map.origin;
  const place = (column: number, row: number): number[] => {
    const [u, v] = [column * map.resolution, row * map.resolution];
    return [x + u * Math.cos(yaw) - v * Math.sin(yaw), y + u * Math.sin(yaw) + v * Math.cos(yaw)];
  };
  for (const {column, row, width, height} of occupiedRectangles(map, mapCells(map))) {
    solids.add([place(column, row), place(column + width, row), place(column + width, row + height),
      place(column, row + height)], WALL);
  }
}

/** Upright prisms on the floor, lit from one side: one draw call for all. */
class Solids {
  private readonly position: number[] = [];
  private readonly colour: number[] = [];

  /** Adds a prism on a convex outline, whose corners are counter-clockwise. */
  add(outline: number[][], colour: THREE.Color): void {
    outline.forEach(([x0, y0], i) => {
      const [x1, y1] = outline[(i + 1) % outline.length];
      const length = Math.hypot(x1 - x0, y1 - y0) || 1;
      const light = 0.72 + 0.2 * (-0.6 * (y1 - y0) + 0.8 * (x1 - x0)) / length;
      this.triangle([x0, y0, 0], [x1, y1, 0], [x1, y1, HEIGHT], colour, light);
      this.triangle([x0, y0, 0], [x1, y1, HEIGHT], [x0, y0, HEIGHT], colour, light);
      if (i > 0 && i + 1 < outline.length) {
        this.triangle([...outline[0], HEIGHT], [x0, y0, HEIGHT], [x1, y1, HEIGHT], colour, 1.12);
      }
    });
  }

  mesh(): THREE.Mesh {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(this.position, 3));
    geometry.setAttribute('color', new THREE.Float32BufferAttribute(this.colour, 3));
    const mesh = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({vertexColors: true}));
    mesh.frustumCulled = false;
    return mesh;
  }

  private triangle(a: number[], b: number[], c: number[], {r, g, b: blue}: THREE.Color, light: number): void {
    this.position.push(...a, ...b, ...c);
    for (let i = 0; i < 3; ++i) {
      this.colour.push(r * light, g * light, blue * light);
    }
  }
}
