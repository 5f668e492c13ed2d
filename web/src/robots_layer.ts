import * as THREE from 'three';
import {FlatShapes} from './flat_shapes';
import {RobotState, Scene} from './messages';
import {Rgb} from './colours';

const BODY = 0xf28c28;
const BEAM = 0xd62839;
const SCAN: Rgb = [214, 40, 57];
const ORANGE: Rgb = [242, 140, 40];
const USUAL_RADIUS = 0.3;

/** Robots with their goals, and the ends of the rays of their laser scans. */
export class RobotsLayer {
  readonly group = new THREE.Group();
  private readonly bodies = new Map<string, THREE.Group>();
  private readonly scans = new FlatShapes('dot', 1024, 0.05);
  private readonly goals = new FlatShapes('target', 256, 0.03);
  private readonly beams: THREE.Mesh<THREE.BufferGeometry, THREE.MeshBasicMaterial>;

  constructor() {
    this.beams = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial({
      color: BEAM, transparent: true, opacity: 0.09, depthWrite: false, side: THREE.DoubleSide}));
    this.beams.frustumCulled = false;
    this.beams.renderOrder = 1;
    this.group.add(this.scans.mesh, this.goals.mesh, this.beams);
  }

  /** Makes the robots of a scene. */
  show(robots: Scene['robots']): void {
    this.bodies.forEach((body) => this.group.remove(body));
    this.bodies.clear();
    robots.forEach(({name, radius}) => this.makeBody(name, radius));
    this.update([]);
  }

  update(robots: RobotState[]): void {
    this.scans.begin(robots.reduce((sum, {scan}) => sum + (scan?.ranges.length ?? 0), 0));
    this.goals.begin(robots.length);
    const beams: number[] = [];
    for (const robot of robots) {
      const body = this.bodies.get(robot.name) ?? this.makeBody(robot.name, USUAL_RADIUS);
      body.position.set(robot.pose[0], robot.pose[1], 0);
      body.rotation.z = robot.pose[2];
      if (robot.goal) {
        this.goals.add(robot.goal[0], robot.goal[1], 0.35, 0.35, 0, ORANGE);
      }
      this.addScan(robot, beams);
    }
    this.beams.geometry.dispose();
    this.beams.geometry.setAttribute('position', new THREE.Float32BufferAttribute(beams, 3));
    this.scans.finish();
    this.goals.finish();
  }

  private addScan({pose: [x, y, heading], scan}: RobotState, beams: number[]): void {
    if (!scan) {
      return;
    }
    let before: [number, number] | null = null;
    scan.ranges.forEach((range, i) => {
      const angle = heading + scan.angle_min + i * scan.angle_increment;
      const end: [number, number] | null = range !== null && range > 0 && Number.isFinite(range)
        ? [x + range * Math.cos(angle), y + range * Math.sin(angle)] : null;
      if (end) {
        this.scans.add(end[0], end[1], 0.05, 0.05, 0, SCAN);
      }
      if (end && before) {
        beams.push(x, y, 0.022, ...before, 0.022, ...end, 0.022);
      }
      before = end;
    });
  }

  private makeBody(name: string, radius: number): THREE.Group {
    const body = new THREE.Group();
    const part = (geometry: THREE.BufferGeometry, colour: number) =>
      body.add(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({color: colour})));
    const cylinder = (size: number, low: number, high: number) =>
      new THREE.CylinderGeometry(size, size, high - low, 24).rotateX(Math.PI / 2).translate(0, 0, (low + high) / 2);
    part(cylinder(radius, 0.04, 0.28), 0x374151);
    part(cylinder(0.92 * radius, 0.28, 0.34), BODY);
    part(cylinder(0.35 * radius, 0.34, 0.46), 0x1f2937);
    part(new THREE.BoxGeometry(0.5 * radius, 0.16 * radius, 0.03).translate(0.6 * radius, 0, 0.35), 0xffffff);
    this.bodies.set(name, body);
    this.group.add(body);
    return body;
  }
}
