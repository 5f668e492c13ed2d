import * as THREE from 'three';
import {GridMap, Obstacle, Scene, Wall} from './messages';
import {Rectangle, mapCells, occupiedRectangles} from './map_cells';

const WALL_HEIGHT = 0.9;  // [m]; low, so that people behind are seen
const WALL_WIDTH = 0.12;
const WALL = 0x5b6678;
const OBSTACLE = 0x8b97a8;
const FLOOR = 0xfafbfc;
const MARGIN = 2;

/** Floor, walls, obstacles and map of a scene. */
export class Scenery {
  readonly group = new THREE.Group();
  private readonly box = new THREE.BoxGeometry(1, 1, 1).translate(0, 0, 0.5);
  private readonly cylinder = new THREE.CylinderGeometry(1, 1, 1, 24).rotateX(Math.PI / 2).translate(0, 0, 0.5);
  private readonly wallMaterial = shaded(WALL);
  private readonly obstacleMaterial = shaded(OBSTACLE);
  private readonly matrix = new THREE.Matrix4();

  /** Shows a scene instead of the one before. */
  show(scene: Pick<Scene, 'bounds' | 'walls' | 'obstacles' | 'map'>): void {
    for (const child of [...this.group.children] as (THREE.Mesh | THREE.LineSegments | THREE.InstancedMesh)[]) {
      this.group.remove(child);
      if (child.geometry !== this.box && child.geometry !== this.cylinder) {
        child.geometry.dispose();
      }
      if (child instanceof THREE.InstancedMesh) {
        child.dispose();
      }
    }
    this.addFloor(scene.bounds);
    this.addWalls(scene.walls);
    this.addObstacles(scene.obstacles);
    if (scene.map) {
      this.addMap(scene.map);
    }
    this.group.traverse((part) => part.updateMatrix());
  }

  private addFloor([x0, y0, x1, y1]: Scene['bounds']): void {
    const [left, right] = [Math.floor(x0 - MARGIN), Math.ceil(x1 + MARGIN)];
    const [low, high] = [Math.floor(y0 - MARGIN), Math.ceil(y1 + MARGIN)];
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(right - left, high - low),
      new THREE.MeshBasicMaterial({color: FLOOR}));
    floor.position.set((left + right) / 2, (low + high) / 2, 0);
    floor.renderOrder = -2;
    floor.material.depthWrite = false;
    const spacing = Math.max(right - left, high - low) > 60 ? 5 : 1;
    const points: number[] = [];
    for (let x = Math.ceil(left / spacing) * spacing; x <= right; x += spacing) {
      points.push(x, low, 0, x, high, 0);
    }
    for (let y = Math.ceil(low / spacing) * spacing; y <= high; y += spacing) {
      points.push(left, y, 0, right, y, 0);
    }
    const grid = new THREE.LineSegments(new THREE.BufferGeometry(),
      new THREE.LineBasicMaterial({color: 0xe6eaf0, depthWrite: false}));
    grid.geometry.setAttribute('position', new THREE.Float32BufferAttribute(points, 3));
    grid.renderOrder = -1;
    this.group.add(floor, grid);
  }

  private addWalls(walls: Wall[]): void {
    const mesh = new THREE.InstancedMesh(this.box, this.wallMaterial, walls.length);
    walls.forEach(({from, to}, i) => {
      const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
      this.matrix.makeRotationZ(Math.atan2(dy, dx));
      this.matrix.scale(new THREE.Vector3(Math.hypot(dx, dy) + WALL_WIDTH, WALL_WIDTH, WALL_HEIGHT));
      this.matrix.setPosition((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, 0);
      mesh.setMatrixAt(i, this.matrix);
    });
    this.group.add(mesh);
  }

  private addObstacles(obstacles: Obstacle[]): void {
    const mesh = new THREE.InstancedMesh(this.cylinder, this.obstacleMaterial, obstacles.length);
    obstacles.forEach(({position, radius}, i) => {
      this.matrix.makeScale(radius, radius, WALL_HEIGHT);
      this.matrix.setPosition(position[0], position[1], 0);
      mesh.setMatrixAt(i, this.matrix);
    });
    this.group.add(mesh);
  }

  private addMap(map: GridMap): void {
    const cells = mapCells(map);
    const rectangles = occupiedRectangles(map, cells);
    const mesh = new THREE.InstancedMesh(this.box, this.wallMaterial, rectangles.length);
    const origin = new THREE.Matrix4().makeRotationZ(map.origin[2]);
    origin.setPosition(map.origin[0], map.origin[1], 0);
    rectangles.forEach(({column, row, width, height}: Rectangle, i) => {
      this.matrix.makeScale(width * map.resolution, height * map.resolution, WALL_HEIGHT);
      this.matrix.setPosition((column + width / 2) * map.resolution, (row + height / 2) * map.resolution, 0);
      mesh.setMatrixAt(i, this.matrix.premultiply(origin));
    });
    this.group.add(mesh);
  }
}

/** Returns a material with its sides darker than its top, without lights in the scene. */
function shaded(colour: number): THREE.ShaderMaterial {
  return new THREE.ShaderMaterial({
    uniforms: {colour: {value: new THREE.Color(colour)}},
    vertexShader: `varying float light;
void main() {
  vec3 n = normalize(mat3(instanceMatrix) * (normal / vec3(dot(instanceMatrix[0].xyz, instanceMatrix[0].xyz),
    dot(instanceMatrix[1].xyz, instanceMatrix[1].xyz), dot(instanceMatrix[2].xyz, instanceMatrix[2].xyz))));
  light = 0.82 + 0.3 * dot(n, vec3(-0.42, -0.5, 0.76));
  gl_Position = projectionMatrix * viewMatrix * instanceMatrix * vec4(position, 1.0);
}`,
    fragmentShader: `uniform vec3 colour;
varying float light;
void main() { gl_FragColor = vec4(colour * light, 1.0); }`,
  });
}
