import {Command} from './messages';
import {Source} from './source';

const SCRIPT = 'social_crowd.js';

declare global {
  interface Window {
    /** What the worker runs; defined by the script beside the page. */
    socialCrowdWorker?: () => void;
  }
}

/** The core as WebAssembly, in a worker of the page. Works from a file too. */
export class WorkerSource implements Source {
  /** Resolves when the worker has been started; rejects if its script is not beside the page. */
  static open(): Promise<WorkerSource> {
    return new Promise((resolve, reject) => {
      const script = document.createElement('script');
      script.src = SCRIPT;
      script.onload = () => {
        const address = URL.createObjectURL(new Blob([`(${window.socialCrowdWorker})()`]));
        resolve(new WorkerSource(new Worker(address)));
      };
      script.onerror = () => reject(new Error('No server answers, and the simulation for browsers ' +
        `(${SCRIPT}) is not beside this page. A recording can be dropped on the page.`));
      document.head.append(script);
    });
  }

  private constructor(private readonly worker: Worker) {}

  send(command: Command): void {
    this.worker.postMessage(command);
  }

  onMessage(handler: (message: object | ArrayBuffer) => void): void {
    this.worker.onmessage = ({data}) => handler(data as object | ArrayBuffer);
    this.worker.onerror = ({message}) => handler({
      type: 'error', command: null, message: `The simulation in the browser has ended: ${message}`,
    });
  }

  close(): void {
    this.worker.terminate();
  }
}
