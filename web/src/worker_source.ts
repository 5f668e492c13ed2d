import {Command} from './messages';
import {Source} from './source';

/** The core as WebAssembly, in a worker of the page. */
export class WorkerSource implements Source {
  private readonly worker = new Worker('wasm_worker.js');

  send(command: Command): void {
    this.worker.postMessage(command);
  }

  onMessage(handler: (message: object | ArrayBuffer) => void): void {
    this.worker.onmessage = ({data}) => handler(data as object | ArrayBuffer);
    this.worker.onerror = () => handler({
      type: 'error', command: null,
      message: 'No server answers, and the simulation for browsers is not beside this page. ' +
        'A recording can be dropped on the page.',
    });
  }

  close(): void {
    this.worker.terminate();
  }
}
