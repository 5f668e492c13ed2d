// Walks scenarios with the WebAssembly module, and prints as JSON what is to be the same natively.
// Arguments: the module; a JSON list of {scenario, table, seed, ticks}
import {createHash} from 'node:crypto';
import {createRequire} from 'node:module';

const [file, walks] = process.argv.slice(2);
const module = await createRequire(import.meta.url)(file)();

/** Returns a digest of all agents after each tick, and the time of all ticks [s]. */
function walk({scenario, table, seed, ticks}) {
  const crowd = new module.Crowd(scenario, table, seed, 0);
  const digests = [];
  let time = 0;
  for (let i = 0; i <= ticks; ++i) {
    const {ids, statuses, positions, headings} = crowd.agents();
    const hash = createHash('sha256');
    for (const {buffer, byteOffset, byteLength} of [ids, statuses, positions, headings]) {
      hash.update(new Uint8Array(buffer, byteOffset, byteLength));
    }
    digests.push(hash.digest('hex').slice(0, 12));
    const start = performance.now();
    const walked = crowd.step();
    time += (performance.now() - start) / 1000;
    if (!walked) {
      break;
    }
  }
  crowd.delete();
  return {digests, time};
}

console.log(JSON.stringify({names: module.scenarioNames(), walks: JSON.parse(walks).map(walk)}));
