import type {App} from './app';
import {ColourMode, css, DENSITY_TABLE} from './colours';
import {HIGHEST_DENSITY} from './heat_map';
import {element, notify, setIcon} from './page';
import {Shape} from './picture';

const ZOOM = 1.3;
const NARROW = 760;  // [pixels]; the panel is hidden at first in a narrower window
const PANEL_WIDTH = 272;

/** Connects the settings of the picture with their buttons, and takes files that are dropped. */
export function addSettings(app: App): void {
  const {picture} = app;
  const {view} = picture;
  const redraw = () => app.isDirty = true;
  const leaveRoom = () => view.setCovered(element('panel').hidden || window.innerWidth < NARROW ? 0 : PANEL_WIDTH);
  const check = (id: string, act: (shown: boolean) => void) => {
    const box = element<HTMLInputElement>(id);
    box.onchange = () => {
      act(box.checked);
      redraw();
    };
    act(box.checked);
  };
  check('paths', (shown) => picture.setPaths(shown));
  check('goals', (shown) => picture.setGoals(shown));
  check('densities', (shown) => {
    picture.setDensities(shown);
    element('legend').hidden = !shown;
  });
  drawLegend();
  element<HTMLSelectElement>('people').onchange = ({target}) => {
    picture.shape = (target as HTMLSelectElement).value as Shape;
    redraw();
  };
  element<HTMLSelectElement>('colour').onchange = ({target}) => {
    picture.colours.mode = (target as HTMLSelectElement).value as ColourMode;
    redraw();
  };
  setIcon(element('fit'), 'fit');
  setIcon(element('toggle-panel'), 'panel');
  const buttons: Record<string, () => void> = {
    'fit': () => view.fit(picture.bounds),
    'zoom-in': () => view.zoom(ZOOM, view.width / 2, view.height / 2),
    'zoom-out': () => view.zoom(1 / ZOOM, view.width / 2, view.height / 2),
    'perspective': () => {
      view.setPerspective(!view.isPerspective);
      view.fit(picture.bounds);
    },
    'toggle-panel': () => {
      element('panel').hidden = !element('panel').hidden;
      leaveRoom();
    },
  };
  for (const [id, act] of Object.entries(buttons)) {
    element(id).onclick = () => {
      act();
      element('perspective').setAttribute('aria-pressed', String(view.isPerspective));
      element('toggle-panel').setAttribute('aria-pressed', String(!element('panel').hidden));
      redraw();
    };
  }
  element('panel').hidden = window.innerWidth < NARROW;
  element('perspective').setAttribute('aria-pressed', 'true');
  element('toggle-panel').setAttribute('aria-pressed', String(!element('panel').hidden));
  for (const event of ['pointerdown', 'pointermove', 'wheel']) {
    view.renderer.domElement.addEventListener(event, redraw);
  }
  new ResizeObserver(() => {
    view.resize();
    leaveRoom();
    redraw();
  }).observe(view.renderer.domElement);
  takeFiles(app);
}

function drawLegend(): void {
  const context = element<HTMLCanvasElement>('legend').getContext('2d')!;
  context.font = '11px system-ui, sans-serif';
  context.fillStyle = '#66728a';
  context.fillText('people per m²', 10, 14);
  for (let x = 0; x < 160; ++x) {
    context.fillStyle = css(DENSITY_TABLE[Math.round(255 * x / 159)]);
    context.fillRect(10 + x, 19, 1, 8);
  }
  context.fillStyle = '#66728a';
  for (let value = 0; value <= HIGHEST_DENSITY; ++value) {
    context.fillText(`${value}`, 8 + value / HIGHEST_DENSITY * 156, 39);
  }
}

function takeFiles(app: App): void {
  const mark = (dropping: boolean) => document.body.classList.toggle('dropping', dropping);
  document.addEventListener('dragover', (event) => {
    event.preventDefault();
    mark(true);
  });
  document.addEventListener('dragleave', () => mark(false));
  document.addEventListener('drop', async (event) => {
    event.preventDefault();
    mark(false);
    const file = event.dataTransfer?.files[0];
    if (file) {
      try {
        app.openRecording(file.name, await file.text());
      } catch (error) {
        notify(`${file.name}: ${(error as Error).message}`);
      }
    }
  });
}
