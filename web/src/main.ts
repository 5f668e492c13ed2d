import './screen_colours';
import {App} from './app';
import {notify} from './page';
import {addSettings} from './settings';
import {addShortcuts} from './shortcuts';
import {Source} from './source';
import {WebSocketSource} from './web_socket_source';
import {WorkerSource} from './worker_source';

const PATIENCE = 5000;  // [ms] until a server answers

declare global {
  interface Window {
    socialCrowd: App;
  }
}

/** Returns the source of the address: a server if one answers, else the core in a worker. */
async function findSource(): Promise<Source> {
  const parameters = new URLSearchParams(location.search);
  const server = parameters.get('server');
  if (parameters.get('source') !== 'wasm' && (server || location.protocol.startsWith('http'))) {
    const address = new URL(server ?? 'ws', location.href.replace(/^http/, 'ws'));
    address.hash = '';
    if (parameters.has('token')) {
      address.searchParams.set('token', parameters.get('token')!);
    }
    try {
      return await WebSocketSource.open(address.href, PATIENCE);
    } catch (error) {
      if (server) {
        throw error;
      }
    }
  }
  return WorkerSource.open();
}

/** Without WebGL there is no picture. */
function open(): App {
  try {
    return new App();
  } catch (error) {
    notify(`This page needs WebGL 2, which the browser does not offer: ${(error as Error).message}`);
    throw error;
  }
}

const app = window.socialCrowd = open();
app.picture.view.resize();
addSettings(app);
addShortcuts(app);
let last = performance.now() / 1000;
requestAnimationFrame(function animate(milliseconds: number) {
  const now = milliseconds / 1000;
  app.animate(now, Math.max(now - last, 0));
  last = now;
  requestAnimationFrame(animate);
});
findSource().then((source) => app.connect(source), (error: Error) => notify(error.message));
