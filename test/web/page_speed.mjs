// Measures how fast the page is drawn in Chromium without a graphics card, while a crowd walks.
// usage: node page_speed.mjs ADDRESS [SECONDS] [EXPRESSION TO EVALUATE FIRST]
// Prints simulated seconds in a second, frames in a second, and the processor time of the browser for each frame: on a
// busy machine the last tells more.
import {readdirSync, readFileSync} from 'node:fs';
import {launchBrowser, openPage, PATIENCE} from './browser.mjs';

const HERTZ = 100;  // of the clock in /proc

/** Returns the processor time of a process and its descendants [s]. */
function processorTime(root) {
  const parents = new Map();
  const times = new Map();
  for (const pid of readdirSync('/proc').filter((name) => /^\d+$/.test(name)).map(Number)) {
    try {
      const text = readFileSync(`/proc/${pid}/stat`, 'utf8');
      const fields = text.slice(text.lastIndexOf(')') + 2).split(' ');
      parents.set(pid, Number(fields[1]));
      times.set(pid, (Number(fields[11]) + Number(fields[12])) / HERTZ);
    } catch {
      continue;  // has just ended
    }
  }
  const belongs = (pid) => pid === root || (parents.has(pid) && belongs(parents.get(pid)));
  return [...times].reduce((sum, [pid, time]) => sum + (belongs(pid) ? time : 0), 0);
}

const [address, seconds = '10', expression = 'null'] = process.argv.slice(2);
const browser = await launchBrowser();
try {
  const page = await openPage(browser, address);
  await page.evaluate(expression);
  await page.evaluate('socialCrowd.send({command: "play"})');
  await page.waitForFunction('socialCrowd.status?.playing', {timeout: PATIENCE});
  const look = async () => ({frame: await page.evaluate('socialCrowd.picture.view.renderer.info.render.frame'),
    people: await page.evaluate('socialCrowd.picture.crowd.count'),
    walked: await page.evaluate('socialCrowd.status.time'), time: performance.now() / 1000,
    processor: processorTime(browser.process().pid)});
  const begin = await look();
  await new Promise((resolve) => setTimeout(resolve, 1000 * Number(seconds)));
  const end = await look();
  const frames = end.frame - begin.frame;
  console.log(`${begin.people} to ${end.people} people: ` +
    `${((end.walked - begin.walked) / (end.time - begin.time)).toFixed(2)} times real time, ` +
    `${(frames / (end.time - begin.time)).toFixed(1)} frames/s, ` +
    `${(1000 * (end.processor - begin.processor) / frames).toFixed(0)} ms of processor time a frame`);
} finally {
  await browser.close();
}
