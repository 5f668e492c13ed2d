import {Command} from './messages';

/** What the page shows and controls: a server, or the core in a worker. */
export interface Source {
  send(command: Command): void;
  /** Calls the handler with each message: an object, or a frame. */
  onMessage(handler: (message: object | ArrayBuffer) => void): void;
  close(): void;
}
