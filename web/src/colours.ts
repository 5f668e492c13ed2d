import {Crowd} from './crowd';
import {IN_CONTACT} from './frame';

export type Rgb = [number, number, number];
export type ColourMode = 'person' | 'speed' | 'direction' | 'contact';

const CLOTHES = ['#d1495b', '#2e86ab', '#edae49', '#3b8f6e', '#8464a8', '#e07a3f', '#4f9dc9', '#c65b8e', '#7a9e3f',
  '#5668b8', '#b7553c', '#3fa7a0', '#dfd9cf', '#8c6d52', '#e5989b', '#566476'].map(parse);
const SPEEDS = ['#b5304a', '#ee8a4f', '#f3d26b', '#5bbf8a', '#2c7fb0'].map(parse);
const VALUES = ['#3b2a78', '#2f6f9f', '#2fa58c', '#95d155', '#fde445'].map(parse);
const DENSITIES = ['#3f6fd8', '#35b6c4', '#6fcf70', '#f2d64b', '#f08a3c', '#c9302c'].map(parse);
const FASTEST = 1.5;  // [m/s]
const DIRECTIONS = 64;

function parse(hex: string): Rgb {
  return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)) as Rgb;
}

/** Returns the colour at a share (0 to 1) of a scale. */
function mix(scale: Rgb[], share: number): Rgb {
  const place = Math.min(Math.max(share, 0), 1) * (scale.length - 1);
  const i = Math.min(Math.floor(place), scale.length - 2);
  return scale[i].map((value, k) => value + (place - i) * (scale[i + 1][k] - value)) as Rgb;
}

/** Returns a table of 256 colours, so that none is made while drawing. */
function table(scale: Rgb[]): Rgb[] {
  return Array.from({length: 256}, (_, i) => mix(scale, i / 255));
}

const SPEED_TABLE = table(SPEEDS);
const DIRECTION_TABLE = Array.from({length: DIRECTIONS}, (_, i) => {
  const angle = 2 * Math.PI * i / DIRECTIONS;
  return [0, 2.1, 4.2].map((shift) => 140 + 85 * Math.cos(angle - shift)) as Rgb;
});
const GREY: Rgb = [140, 150, 163];
const RED: Rgb = [214, 40, 57];

/** Colour of the value of an action, from the lowest (0) to the highest (1). */
export const VALUE_TABLE = table(VALUES);
export const DENSITY_TABLE = table(DENSITIES);

/** Returns a colour in CSS. */
export function css([r, g, b]: Rgb): string {
  return `rgb(${Math.round(r)} ${Math.round(g)} ${Math.round(b)})`;
}

/** Colours of people. */
export class Colours {
  mode: ColourMode = 'person';

  of(crowd: Crowd, i: number): Rgb {
    switch (this.mode) {
      case 'speed':
        return SPEED_TABLE[Math.round(255 * Math.min(crowd.speed[i] / FASTEST, 1))];
      case 'direction':
        return DIRECTION_TABLE[(Math.round(crowd.heading[i] / (2 * Math.PI) * DIRECTIONS) % DIRECTIONS + DIRECTIONS)
          % DIRECTIONS];
      case 'contact':
        return crowd.state[i] & IN_CONTACT ? RED : GREY;
      case 'person':
        return this.ofPerson(crowd.id[i]);
    }
  }

  ofPerson(id: number): Rgb {
    return CLOTHES[(Math.imul(id, 0x9e3779b1) >>> 20) % CLOTHES.length];
  }
}
