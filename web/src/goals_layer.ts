import * as THREE from 'three';
import {Colours} from './colours';
import {FlatShapes} from './flat_shapes';
import {Scene} from './messages';

/** The goals of all agents, in their colours. */
export class GoalsLayer {
  private readonly targets = new FlatShapes('target', 64, 0.02, 0.85);
  readonly group = new THREE.Group().add(this.targets.mesh);

  show(agents: Scene['agents'], colours: Colours): void {
    this.targets.begin(agents.length);
    for (const {id, goal} of agents) {
      this.targets.add(goal[0], goal[1], 0.2, 0.2, 0, colours.ofPerson(id));
    }
    this.targets.finish();
  }
}
