import {Sample} from './statistics';
import {element} from './page';

const PLOTS: {name: string; key: 'speed' | 'density' | 'arrived'; unit: string; colour: string; least: number;
  digits: number}[] = [
  {name: 'mean speed', key: 'speed', unit: 'm/s', colour: '#2563eb', least: 1.5, digits: 2},
  {name: 'density around people', key: 'density', unit: '/m²', colour: '#d97706', least: 0.5, digits: 2},
  {name: 'arrived', key: 'arrived', unit: '', colour: '#059669', least: 1, digits: 0},
];

/** Plots of speed, density and arrivals over time. */
export class Plots {
  private readonly parts = PLOTS.map((plot) => {
    const figure = document.createElement('figure');
    figure.className = 'plot';
    figure.innerHTML = `<figcaption>${plot.name} <span><b></b> ${plot.unit}</span></figcaption>` +
      `<canvas aria-label="Plot of ${plot.name}"></canvas>`;
    element('plots').append(figure);
    return {...plot, value: figure.querySelector('b')!, canvas: figure.querySelector('canvas')!};
  });

  /** Draws all samples; the numbers are those at the given time. */
  draw(samples: Sample[], now: number): void {
    const present = samples.findLast(({time}) => time <= now + 1e-6) ?? samples[0];
    for (const {key, value, canvas, colour, least, digits} of this.parts) {
      value.textContent = present ? present[key].toFixed(digits) : '–';
      const ratio = Math.min(window.devicePixelRatio, 2);
      const [width, height] = [canvas.clientWidth, canvas.clientHeight];
      if (width === 0) {
        continue;
      }
      canvas.width = width * ratio;
      canvas.height = height * ratio;
      const context = canvas.getContext('2d')!;
      context.scale(ratio, ratio);
      drawCurve(context, samples.map((sample) => [sample.time, sample[key]]), now, width, height, colour, least);
    }
  }
}

function drawCurve(context: CanvasRenderingContext2D, points: [number, number][], now: number, width: number,
                   height: number, colour: string, least: number): void {
  context.strokeStyle = '#dfe4ec';
  context.beginPath();
  context.moveTo(0, height - 0.5);
  context.lineTo(width, height - 0.5);
  context.stroke();
  if (points.length < 2) {
    return;
  }
  const [begin, end] = [points[0][0], Math.max(points[points.length - 1][0], points[0][0] + 10)];
  const highest = points.reduce((most, point) => Math.max(most, point[1]), least) * 1.08;
  const x = (time: number) => (time - begin) / (end - begin) * width;
  const y = (value: number) => height - 1 - value / highest * (height - 4);
  context.beginPath();
  points.forEach(([time, value]) => context.lineTo(x(time), y(value)));
  context.strokeStyle = colour;
  context.lineWidth = 1.6;
  context.lineJoin = 'round';
  context.stroke();
  context.lineTo(x(points[points.length - 1][0]), height);
  context.lineTo(0, height);
  context.globalAlpha = 0.1;
  context.fillStyle = colour;
  context.fill();
  context.globalAlpha = 1;
  context.strokeStyle = '#9aa5b8';
  context.lineWidth = 1;
  context.setLineDash([2, 2]);
  context.beginPath();
  context.moveTo(x(now), 0);
  context.lineTo(x(now), height);
  context.stroke();
}
