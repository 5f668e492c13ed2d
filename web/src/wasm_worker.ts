// The source of the page without a server: the core as WebAssembly, in a worker. scripts/web puts both into social_crowd.js.
import {Command} from './messages';
import {COMMANDS} from './wasm_commands';
import {WasmModule} from './wasm_module';
import {WasmSource} from './wasm_source';

declare const socialCrowd: () => Promise<WasmModule>;
const worker = self as unknown as {
  postMessage(message: unknown, transfer?: Transferable[]): void;
  onmessage: (event: MessageEvent) => void;
};

const send = (message: object) => worker.postMessage(message, message instanceof ArrayBuffer ? [message] : []);
const waiting: Command[] = [];
worker.onmessage = ({data}) => waiting.push(data as Command);
socialCrowd().then((module) => {
  const source = new WasmSource(module, send);
  send({type: 'hello', protocol: 1, back_end: 'wasm', scenarios: module.scenarioNames(), commands: COMMANDS});
  source.begin();
  waiting.forEach((command) => source.receive(command));
  worker.onmessage = ({data}) => source.receive(data as Command);
}).catch((error: Error) => send({
  type: 'error', command: null, message: `The simulation for browsers could not be started: ${error.message}`,
}));
