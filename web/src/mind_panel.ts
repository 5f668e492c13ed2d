import {css, VALUE_TABLE} from './colours';
import {Mind, Point} from './messages';
import {shares} from './mind_layer';
import {element, setText} from './page';

/** The part of the panel for the selected agent: values of its candidate actions. */
export class MindPanel {
  private readonly canvas = element<HTMLCanvasElement>('actions');
  private shown: Mind | null | undefined;

  show(selected: number | null, mind: Mind | null, speed: number, goal: Point | null): void {
    element('mind').hidden = selected === null;
    if (selected === null) {
      return;
    }
    const goalText = goal ? ` to (${goal[0].toFixed(1)}, ${goal[1].toFixed(1)})` : '';
    setText('agent', `Agent ${selected}: ${speed.toFixed(2)} m/s${goalText}`);
    const known = mind && mind.agent === selected && mind.actions.length > 0 ? mind : null;
    this.canvas.hidden = !known;
    if (!known) {
      setText('choice', 'Its candidate actions are shown when it decides next.');
    } else if (known !== this.shown) {
      const {direction, speed: chosenSpeed, value, visits} = known.actions[known.chosen] ?? known.actions[0];
      setText('choice', `Chosen of ${known.actions.length}: ${Math.round(direction * 180 / Math.PI)}° at ` +
        `${chosenSpeed.toFixed(2)} m/s, value ${value.toFixed(2)}, ${visits} visits; ` +
        `${known.neighbours.length} neighbours`);
      this.draw(known);
    }
    this.shown = known;
  }

  /** Draws a bar for each action, from right (negative directions) to left as it is seen from the agent. */
  private draw(mind: Mind): void {
    const context = this.canvas.getContext('2d')!;
    const {width, height} = this.canvas;
    context.clearRect(0, 0, width, height);
    const share = shares(mind);
    const order = mind.actions.map((_, i) => i).sort((a, b) =>
      mind.actions[b].direction - mind.actions[a].direction || mind.actions[a].speed - mind.actions[b].speed);
    const step = width / order.length;
    order.forEach((action, place) => {
      const length = 4 + share[action] * (height - 16);
      context.fillStyle = css(VALUE_TABLE[Math.round(255 * share[action])]);
      context.fillRect(place * step + 0.5, height - length, Math.max(step - 1, 1), length);
      if (action === mind.chosen) {
        context.fillStyle = '#172033';
        context.beginPath();
        context.moveTo((place + 0.5) * step, height - length - 3);
        context.lineTo((place + 0.5) * step - 4, height - length - 10);
        context.lineTo((place + 0.5) * step + 4, height - length - 10);
        context.fill();
      }
    });
  }
}
