// Takes a picture of the page in Chromium without a graphics card, while the crowd of a server walks.
// usage: node page_picture.mjs ADDRESS FILE.png SECONDS [EXPRESSION TO EVALUATE FIRST]
// The picture is that after the given time of the crowd. Prints the number of people, and frames in a second.
import {launchBrowser, openPage, PATIENCE} from './browser.mjs';

const [address, file, seconds, expression = 'null'] = process.argv.slice(2);
const browser = await launchBrowser();
try {
  const page = await openPage(browser, address);
  await page.evaluate(expression);
  await page.evaluate('socialCrowd.send({command: "play"})');
  await page.waitForFunction(`socialCrowd.player.history.last.time >= ${Number(seconds)}`,
    {timeout: 5 * PATIENCE, polling: 100});
  await page.screenshot({path: file});
  console.log(`${await page.evaluate('socialCrowd.picture.crowd.count')} people: ` +
    `${(await page.evaluate('socialCrowd.framesPerSecond')).toFixed(0)} frames/s`);
} finally {
  await browser.close();
}
