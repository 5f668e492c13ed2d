// Walks scenarios with the WebAssembly module, and prints as JSON what is to be the same natively.
// Arguments: the module; a JSON list of {scenario, table, seed, agent_ticks, least_ticks, few_agents}
import {createHash} from 'node:crypto';
import {createRequire} from 'node:module';

const [file, walks] = process.argv.slice(2);
const module = await createRequire(import.meta.url)(file)();

/** Returns a digest of all agents after each tick, and the processor time of all ticks [s]. */
function walk({scenario, table, seed, agent_ticks: agentTicks, least_ticks: leastTicks, few_agents: fewAgents}) {
  const crowd = new module.Crowd(scenario, table, seed, 0);
  const digests = [];
  let [time, walked] = [0, 0];
  while (walked <= agentTicks || digests.length <= leastTicks) {
    const {ids, statuses, positions, headings} = crowd.agents();
    const hash = createHash('sha256');
    for (const {buffer, byteOffset, byteLength} of [ids, statuses, positions, headings]) {
      hash.update(new Uint8Array(buffer, byteOffset, byteLength));
    }
    digests.push(hash.digest('hex').slice(0, 12));
    walked += Math.max(ids.length, fewAgents);
    const start = process.cpuUsage().user;
    const goesOn = crowd.step();
    time += (process.cpuUsage().user - start) / 1e6;
    if (!goesOn) {
      break;
    }
  }
  crowd.delete();
  return {digests, time};
}

console.log(JSON.stringify({names: module.scenarioNames(), walks: JSON.parse(walks).map(walk)}));
