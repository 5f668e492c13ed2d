// Runs the worker of the page in node. Prints as JSON the answers to each command, the greeting first.
// Arguments: social_crowd.js; a JSON list of commands, in which {"until": TICK} waits for a tick of a crowd that plays, and
// {"later": true} until what was to be done at once is done
const {readFileSync} = require('node:fs');

const [file, commands] = process.argv.slice(2);
const PATIENCE = 60000;  // [ms]

let answers = [];
let awaken = () => undefined;
globalThis.self = globalThis;
globalThis.postMessage = (message) => {
  answers.push(message instanceof ArrayBuffer ? shownFrame(message) : message);
  awaken();
};

/** Returns what the head of a binary frame says, and its first agent. */
function shownFrame(buffer) {
  const view = new DataView(buffer);
  const count = view.getUint32(16, true);
  const first = [0, 1, 2, 3, 4].map((field) => 24 + 4 * field * count);
  return {
    type: 'frame', magic: view.getUint32(0, true), tick: view.getUint32(4, true), time: view.getFloat64(8, true), count,
    bytes: buffer.byteLength, id: count && view.getUint32(first[0], true), x: count && view.getFloat32(first[1], true),
  };
}

/** Resolves when an answer fulfils a condition. */
function until(condition) {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error('no answer')), PATIENCE);
    awaken = () => {
      if (answers.some(condition)) {
        clearTimeout(timer);
        awaken = () => undefined;
        resolve();
      }
    };
    awaken();
  });
}

async function main() {
  eval(readFileSync(file, 'utf8'));
  self.socialCrowdWorker();
  await until(({type}) => type === 'status' || type === 'error');
  const all = [answers];
  for (const command of JSON.parse(commands)) {
    answers = [];
    if (command?.until !== undefined) {
      await until(({type, tick}) => type === 'frame' && tick >= command.until);
    } else if (command?.later) {
      await new Promise((resolve) => setTimeout(resolve));
    } else {
      self.onmessage({data: command});
    }
    all.push(answers);
  }
  process.stdout.write(JSON.stringify(all), () => process.exit());  // a crowd may still be playing
}

main();
