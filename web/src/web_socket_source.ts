import {Command} from './messages';
import {Source} from './source';

/** A server that speaks the page's protocol on a WebSocket. */
export class WebSocketSource implements Source {
  /** Resolves when the connection is open; rejects if there is none within the given time [ms]. */
  static open(address: string, patience: number): Promise<WebSocketSource> {
    return new Promise((resolve, reject) => {
      const socket = new WebSocket(address);
      const timer = setTimeout(() => socket.close(), patience);
      socket.binaryType = 'arraybuffer';
      socket.onopen = () => {
        clearTimeout(timer);
        resolve(new WebSocketSource(socket));
      };
      socket.onclose = () => {
        clearTimeout(timer);
        reject(new Error(`no server answers at ${address.split('?')[0]}`));
      };
    });
  }

  private constructor(private readonly socket: WebSocket) {}

  send(command: Command): void {
    if (this.socket.readyState === WebSocket.OPEN) {
      this.socket.send(JSON.stringify(command));
    }
  }

  onMessage(handler: (message: object | ArrayBuffer) => void): void {
    this.socket.onmessage = ({data}) => handler(typeof data === 'string' ? JSON.parse(data) as object : data);
    this.socket.onclose = ({reason}) => handler({
      type: 'error', command: null,
      message: `The connection to the server has ended${reason ? `: ${reason}` : ''}. Reload the page to connect again.`,
    });
  }

  close(): void {
    this.socket.onclose = null;
    this.socket.close();
  }
}
