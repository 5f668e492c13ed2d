// Checks of the page in a browser, against the server at the given address. Prints a JSON object: the result of each
// check by its name.
// usage: node page_checks.mjs ADDRESS
import {launchBrowser, openPage, PATIENCE} from './browser.mjs';

/** Waits until an expression is true in the page. */
const until = (page, expression) => page.waitForFunction(expression, {timeout: PATIENCE, polling: 50});
const value = (page, expression) => page.evaluate(expression);
const press = (page, label) => page.locator(`::-p-aria(${label}[role="button"])`).setTimeout(PATIENCE).click();
/** Makes steps until an expression is true: nodes may not have heard yet what the steps depend on. */
async function stepUntil(page, expression) {
  const end = Date.now() + PATIENCE;
  for (let isTrue = false; !isTrue;) {
    const tick = await value(page, TICK);
    await press(page, 'Step');
    await until(page, `${TICK} > ${tick}`);
    isTrue = await page.waitForFunction(expression, {timeout: 1000, polling: 50}).then(() => true, () => false);
    if (!isTrue && Date.now() > end) {
      throw new Error(`no step led to ${expression}`);
    }
  }
}
/** Waits until the last tick is shown, so that nobody moves any more. */
const untilStill = (page) => until(page, 'socialCrowd.player.time >= socialCrowd.player.history.last.time - 1e-6');
const TICK = 'socialCrowd.player.history.last.tick';
const PEOPLE = 'socialCrowd.picture.crowd.count';

/** Pauses, and waits until no more ticks come. Returns the last one. */
async function pause(page) {
  if (await value(page, 'socialCrowd.status.playing')) {
    await press(page, 'Pause');
  }
  await until(page, '!socialCrowd.status.playing');
  return value(page, TICK);
}

/** Looks down, and returns the pixel of a place on the floor. */
async function pixelOf(page, place) {
  if (await value(page, 'socialCrowd.picture.view.isPerspective')) {
    await press(page, 'Perspective');
  }
  return value(page, `socialCrowd.picture.view.pixelOf(${JSON.stringify(place)})`);
}

async function drag(page, from, to) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
  await page.mouse.move(...to);
  await page.mouse.up();
}

async function dropFile(page, name, text) {
  await page.evaluate((fileName, content) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([content], fileName));
    document.dispatchEvent(new DragEvent('drop', {dataTransfer: transfer, cancelable: true}));
  }, name, text);
}

const message = (text) =>
  `[...document.querySelectorAll('#messages p')].some((p) => p.textContent.includes('${text}'))`;
const WALK = ['instance,tick,agent,x,y',
  ...Array.from({length: 202}, (_, i) => [0, i >> 1, i % 2, (i >> 1) / 10, i % 2].join(','))].join('\n');

/** Each begins with the page as the one before has left it. */
const CHECKS = {
  async ticks_move(page) {
    if (!await value(page, 'socialCrowd.status.playing')) {
      await press(page, 'Play');
    }
    const tick = await value(page, TICK);
    await until(page, `${TICK} > ${tick} + 3`);
    await until(page, 'socialCrowd.framesPerSecond > 0 && document.getElementById("fps").textContent !== "0"');
    await until(page, 'parseFloat(document.getElementById("clock").textContent) > 0');
  },
  async pause_stops_them_and_step_makes_one(page) {
    const tick = await pause(page);
    await press(page, 'Step');
    await until(page, `${TICK} === ${tick} + 1`);
    await page.keyboard.press('.');
    await until(page, `${TICK} === ${tick} + 2`);
  },
  async a_click_adds_a_person(page) {
    const people = await value(page, PEOPLE);
    await press(page, 'Add person');
    await page.mouse.click(...await pixelOf(page, [0.5, 3]));
    await until(page, `${PEOPLE} === ${people} + 1`);
    await drag(page, await pixelOf(page, [1, -3]), await pixelOf(page, [-1, 3]));
    await until(page, `${PEOPLE} === ${people} + 2`);
  },
  async a_person_is_selected_gets_a_goal_and_is_removed(page) {
    await press(page, 'Select');
    const people = await value(page, PEOPLE);
    const place = () => value(page,
      `(({picture: {crowd: {x, y, count}}}) => [x[count - 1], y[count - 1]])(socialCrowd)`);
    await page.mouse.click(...await pixelOf(page, await place()));
    await until(page, 'socialCrowd.tools.selected !== null && !document.getElementById("mind").hidden');
    await press(page, 'Set goal');
    await page.mouse.click(...await pixelOf(page, [2, 2]));
    await until(page, 'Math.abs(socialCrowd.picture.goalOf(socialCrowd.tools.selected)[0] - 2) < 0.1');
    // The learner listens to who is selected a while after the selection.
    await stepUntil(page, 'socialCrowd.mind?.agent === socialCrowd.tools.selected && socialCrowd.mind.actions.length > 1');
    await press(page, 'Remove');
    await untilStill(page);
    await page.mouse.click(...await pixelOf(page, await place()));
    await until(page, `${PEOPLE} === ${people} - 1`);
  },
  async walls_and_obstacles(page) {  // in a corner, where nobody walks; each is awaited, as a new scene may fit the view
    const walls = await value(page, 'socialCrowd.scene.walls.length');
    const obstacles = await value(page, 'socialCrowd.scene.obstacles.length');
    const [, , x, y] = await value(page, 'socialCrowd.picture.bounds');
    await press(page, 'Add wall');
    await drag(page, await pixelOf(page, [x - 0.9, y - 0.1]), await pixelOf(page, [x - 0.1, y - 0.1]));
    await until(page, `socialCrowd.scene.walls.length === ${walls + 1}`);
    await press(page, 'Add obstacle');
    await drag(page, await pixelOf(page, [x - 0.3, y - 0.8]), await pixelOf(page, [x - 0.1, y - 0.8]));
    await until(page, `socialCrowd.scene.obstacles.length === ${obstacles + 1}`);
    await press(page, 'Remove');
    await page.mouse.click(...await pixelOf(page, [x - 0.5, y - 0.1]));
    await until(page, `socialCrowd.scene.walls.length === ${walls}`);
    await page.mouse.click(...await pixelOf(page, [x - 0.3, y - 0.8]));
    await until(page, `socialCrowd.scene.obstacles.length === ${obstacles}`);
    await press(page, 'Select');
  },
  async an_error_is_shown_and_goes_away(page) {
    await page.evaluate('socialCrowd.send({command: "remove_wall", wall: 987654})');
    await until(page, message('remove_wall:'));
    await until(page, '!document.querySelector("#messages p.error")');
  },
  async the_recent_past(page) {
    const time = await value(page, 'socialCrowd.player.history.last.time');
    await page.focus('#time-line');
    await page.keyboard.press('Home');
    await until(page, `socialCrowd.player.time < ${time} && !document.getElementById("live").hidden`);
    await press(page, 'Live');
    await until(page, `socialCrowd.player.isLive && socialCrowd.player.time >= ${time} - 1e-6`);
  },
  async a_recording_is_scrubbed(page) {
    await dropFile(page, 'walk.csv', WALK);
    await until(page, 'socialCrowd.player.isRecording && socialCrowd.player.time > 0.2');
    await press(page, 'Pause');
    await page.focus('#time-line');
    await page.keyboard.press('End');
    await until(page, `socialCrowd.player.time === 10 && ${PEOPLE} === 2`);
    await until(page, `Math.abs(socialCrowd.picture.crowd.x[0] - 10) < 1e-3`);
    await page.keyboard.press('Home');
    await until(page, 'socialCrowd.player.time === 0 && Math.abs(socialCrowd.picture.crowd.x[0]) < 1e-3');
    await page.evaluate('document.activeElement.blur()');
    await press(page, 'Step');
    await until(page, 'Math.abs(socialCrowd.player.time - 0.1) < 1e-6');
    await dropFile(page, 'broken.csv', WALK.replace('0,50,0', '0,50,zero'));
    await until(page, message('broken.csv: line 102: expected five numbers'));
    await press(page, 'Live');
    await until(page, 'socialCrowd.player.isLive');
  },
  async keys_and_layers(page) {
    await page.keyboard.press('d');
    await until(page, 'socialCrowd.picture.showsDensities && !document.getElementById("legend").hidden');
    await page.select('#people', 'discs');
    await until(page, '!socialCrowd.picture.showsFigures');
    await page.evaluate('document.activeElement.blur()');
    await page.keyboard.press('p');
    await until(page, 'document.getElementById("panel").hidden');
    await page.setViewport({width: 400, height: 500});
    await until(page, 'socialCrowd.picture.view.width === 400');
    const hidden = await value(page, `['play', 'step', 'time-line', 'scenario', 'toggle-panel'].filter((id) => {
      const {left, right, top, bottom} = document.getElementById(id).getBoundingClientRect();
      return left < 0 || right > 400 || top < 0 || bottom > 500;
    })`);
    if (hidden.length > 0) {
      throw new Error(`outside of a small window: ${hidden}`);
    }
    await page.setViewport({width: 1280, height: 720});
  },
  async another_scenario(page) {
    const names = await value(page, '[...document.getElementById("scenario").options].map(({value}) => value)');
    const other = names.includes('circle12') ? 'circle12' : names[1];
    await page.select('#scenario', other);
    await until(page, `socialCrowd.scene.scenario === '${other}' || socialCrowd.player.history.last.tick < 5`);
  },
};

const results = {};
const problems = [];
const browser = await launchBrowser();
try {
  const page = await openPage(browser, process.argv[2], problems);
  for (const [name, check] of Object.entries(CHECKS)) {
    try {
      await check(page);
      results[name] = 'ok';
    } catch (error) {
      const shown = await value(page, 'document.getElementById("messages").textContent');
      const places = (error.stack.match(/page_checks\.mjs:\d+/g) ?? []).join(', ');
      results[name] = `${places}: ${error.message} (messages: ${shown})`;
    }
  }
} finally {
  await browser.close();
}
results.no_errors_in_the_console = problems.length === 0 ? 'ok' : problems.join('\n');
console.log(JSON.stringify(results, null, 1));
