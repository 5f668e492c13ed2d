import {Command} from './messages';
import {Source} from './source';

const SCRIPT = 'social_crowd.js';

declare global {
  interface Window {
    /** The code of the worker, in social_crowd.js. */
    socialCrowdWorker?: () => void;
  }
}

/** The core as WebAssembly, in a worker of the page. */
export class WorkerSource implements Source {
  private worker: Worker | null = null;
  private isClosed = false;
  private readonly waiting: Command[] = [];

  send(command: Command): void {
    if (this.worker) {
      this.worker.postMessage(command);
    } else {
      this.waiting.push(command);
    }
  }

  onMessage(handler: (message: object | ArrayBuffer) => void): void {
    const fail = (message: string) => handler({type: 'error', command: null, message});
    const script = document.createElement('script');
    script.src = SCRIPT;
    script.onerror = () => fail('No server answers, and the simulation for browsers is not beside this page. ' +
      'A recording can be dropped on the page.');
    script.onload = () => {
      if (this.isClosed) {
        return;
      }
      // A page that was opened as a file cannot start a worker from another file.
      const code = URL.createObjectURL(new Blob([`(${window.socialCrowdWorker})()`]));
      this.worker = new Worker(code);
      this.worker.onmessage = ({data}) => handler(data as object | ArrayBuffer);
      this.worker.onerror = ({message}) => fail(`The simulation has ended: ${message}`);
      this.waiting.forEach((command) => this.send(command));
    };
    document.head.append(script);
  }

  close(): void {
    this.isClosed = true;
    this.worker?.terminate();
  }
}
