import {Colours} from './colours';
import {FlatShapes} from './flat_shapes';
import {Scene} from './messages';

const SHOWN = 20000;

/** The goals of all agents, in their colours. */
export class GoalsLayer {
  private readonly targets = new FlatShapes('target', SHOWN, 0.02, 0.85);
  readonly mesh = this.targets.mesh;

  show(agents: Scene['agents'], colours: Colours): void {
    this.targets.clear();
    for (const {id, goal} of agents) {
      this.targets.add(goal[0], goal[1], 0.2, 0.2, 0, colours.ofPerson(id));
    }
    this.targets.finish();
  }
}
