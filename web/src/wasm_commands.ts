import {Command, Point} from './messages';

const GREATEST_PLACE = 1e6;  // [m]
const GREATEST_LENGTH = 1000;  // [m], [m/s]
const MOST_TICKS = 10000;  // of a step
const FASTEST = 1e6;

type Check = (value: unknown) => boolean;

const number = (low: number, high: number): Check => (value) =>
  typeof value === 'number' && value >= low && value <= high;
const whole = (low: number, high: number): Check => (value) => Number.isInteger(value) && number(low, high)(value);
const coordinate = number(-GREATEST_PLACE, GREATEST_PLACE);
const point: Check = (value) => Array.isArray(value) && value.length === 2 && value.every(coordinate);
const text: Check = (value) => typeof value === 'string' && value !== '';
const id = whole(0, 2 ** 31 - 1);
const length = number(0.001, GREATEST_LENGTH);
const orNone = (check: Check): Check => (value) => value === null || check(value);

/** By command its keys: what each must be. Those with a default may be left out. */
const KEYS: Record<string, Record<string, Check>> = {
  play: {}, pause: {}, step: {ticks: whole(1, MOST_TICKS)}, speed: {factor: number(0, FASTEST)}, scenario: {name: text},
  reset: {seed: orNone(whole(0, Number.MAX_SAFE_INTEGER))},
  add_agent: {position: point, goal: point, radius: length, max_speed: length, heading: orNone(number(-1e3, 1e3))},
  remove_agent: {agent: id}, set_goal: {agent: id, goal: point},
  add_obstacle: {position: point, radius: length}, remove_obstacle: {obstacle: id},
  add_wall: {from: point, to: point}, remove_wall: {wall: id}, select: {agent: orNone(id)},
};
const DEFAULTS: Record<string, Arguments> = {
  step: {ticks: 1}, reset: {seed: null}, add_agent: {radius: 0.25, max_speed: 1.3, heading: null},
};

export const COMMANDS = Object.keys(KEYS);

/** The keys of a command after checkedArguments(). */
export type Arguments = Partial<{
  ticks: number; factor: number; name: string; seed: number | null; position: Point; goal: Point; radius: number;
  max_speed: number; heading: number | null; agent: number | null; obstacle: number; wall: number; from: Point; to: Point;
}>;

/** Returns the keys of a command, with defaults for what is missing. Fails with what was expected. */
export function checkedArguments({command, ...given}: Command): Required<Arguments> {
  const keys = Object.hasOwn(KEYS, command) ? KEYS[command] : undefined;
  if (!keys) {
    throw new Error(`unknown command '${command}', expected one of ${COMMANDS.join(', ')}`);
  }
  const unknown = Object.keys(given).find((key) => !Object.hasOwn(keys, key));
  if (unknown !== undefined) {
    throw new Error(`unknown key '${unknown}', expected ${Object.keys(keys).join(', ') || 'no keys beside command'}`);
  }
  const values: Record<string, unknown> = {...DEFAULTS[command], ...given};
  for (const [key, check] of Object.entries(keys)) {
    if (!check(values[key])) {
      throw new Error(`${key}: not valid for ${command}: ${JSON.stringify(values[key])?.slice(0, 60) ?? 'missing'}`);
    }
  }
  return values as Required<Arguments>;
}
