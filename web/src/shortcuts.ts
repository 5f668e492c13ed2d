import type {App} from './app';
import {element} from './page';

const KEYS: [key: string, meaning: string, act: (app: App) => void][] = [
  ['space', 'play or pause', () => element('play').click()],
  ['.', 'one tick on', () => element('step').click()],
  [',', 'one tick back', (app) => {
    app.player.step(-1);
    app.isDirty = true;
  }],
  ['l', 'back to the present', (app) => app.showLive()],
  ['r', 'begin anew', () => element('reset').click()],
  ['1', 'tools 1 to 6: select, person, obstacle, wall, goal, remove', (app) => app.tools.use(1)],
  ['v', 'perspective, or from above', () => element('perspective').click()],
  ['f', 'show everything', () => element('fit').click()],
  ['+', 'zoom in', () => element('zoom-in').click()],
  ['-', 'zoom out', () => element('zoom-out').click()],
  ['d', 'densities', () => element('densities').click()],
  ['w', 'walked paths', () => element('paths').click()],
  ['g', 'goals', () => element('goals').click()],
  ['p', 'panel', () => element('toggle-panel').click()],
  ['delete', 'remove the selected agent', (app) => {
    if (app.tools.selected !== null) {
      app.send({command: 'remove_agent', agent: app.tools.selected});
    }
  }],
  ['escape', 'select nothing', (app) => {
    app.tools.use('select');
    app.select(null);
  }],
  ['?', 'this help', () => element('help').click()],
];
const MOUSE: [string, string][] = [
  ['click', 'select an agent, or use the tool'],
  ['drag', 'move the picture, or use the tool'],
  ['right drag, shift + drag', 'turn the camera'],
  ['wheel', 'zoom'],
  ['drop a CSV file', 'show a recording: instance,tick,agent,x,y'],
];

/** Keys that do what buttons do, and the page that lists them. */
export function addShortcuts(app: App): void {
  const dialog = element<HTMLDialogElement>('keys');
  dialog.innerHTML = '<h2>Keys and mouse</h2><dl>' + [...MOUSE, ...KEYS].map(([key, meaning]) =>
    `<dt>${key === '1' ? '1 … 6' : key}</dt><dd>${meaning}</dd>`).join('') + '</dl>';
  dialog.onclick = () => dialog.close();
  element('help').onclick = () => dialog.showModal();
  document.addEventListener('keydown', (event) => {
    const target = event.target as HTMLElement;
    const typing = ['SELECT', 'INPUT'].includes(target.tagName) && target.getAttribute('type') !== 'checkbox';
    if (event.ctrlKey || event.altKey || event.metaKey || typing || dialog.open) {
      return;
    }
    const key = event.key === ' ' ? 'space' : event.key.toLowerCase();
    const shortcut = KEYS.find(([name]) => name === key);
    if (/^[1-6]$/.test(key)) {
      app.tools.use(Number(key));
    } else if (shortcut) {
      event.preventDefault();
      shortcut[2](app);
    }
  });
}
