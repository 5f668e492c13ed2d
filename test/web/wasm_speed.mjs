// Measures in node how fast the WebAssembly module walks a crowd. Prints simulated seconds in a second of processor time.
// usage: node wasm_speed.mjs MODULE SCENARIO [PEOPLE [SECONDS TO WALK]]
// On a map, people are added at random places, with random goals, until PEOPLE walk.
import {createRequire} from 'node:module';
import {resolve} from 'node:path';

const [file, scenario, people = '0', seconds = '10'] = process.argv.slice(2);
const RADIUS = 0.2;     // [m]
const SPEED = 1.3;      // [m/s]
const WARM_UP = 5;      // ticks
const MOST_TRIES = 50;  // for each person

/** Returns a function that draws numbers below 1, always the same ones. */
function numbers() {
  let state = 1;
  return () => (state = state * 16807 % 2147483647) / 2147483647;
}

/** Returns how many people walk. */
function walking(crowd) {
  return crowd.agents().statuses.filter((status) => status === 0).length;
}

/** Adds a person, unless one of the places is not free. */
function add(crowd, {origin, width, height, resolution}, draw) {
  const place = () => [origin[0] + draw() * width * resolution, origin[1] + draw() * height * resolution];
  try {
    crowd.addAgent(place(), place(), 0, SPEED, RADIUS);
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) {
      throw error;
    }
  }
}

/** Walks at most this number of ticks. Returns how many it were. */
function walk(crowd, ticks) {
  let walked = 0;
  while (walked < ticks && crowd.step()) {
    ++walked;
  }
  return walked;
}

const module = await createRequire(import.meta.url)(resolve(file))();
const crowd = new module.Crowd(scenario, scenario.startsWith('place_') ? 'human' : 'anticipation', 1, 0);
const [map, draw] = [crowd.map(), numbers()];
for (let i = 0; i < MOST_TRIES * Number(people) && walking(crowd) < Number(people); ++i) {
  add(crowd, map, draw);
}
walk(crowd, WARM_UP);
const before = walking(crowd);
const start = process.cpuUsage();
const ticks = walk(crowd, Math.round(Number(seconds) / crowd.tickDuration()));
const {user, system} = process.cpuUsage(start);
const time = (user + system) / 1e6;
console.log(`${before} to ${walking(crowd)} people walk: ${(ticks * crowd.tickDuration() / time).toFixed(1)} times real ` +
  `time, ${(1000 * time / ticks).toFixed(1)} ms of processor time a tick`);
