// Opens the page as a file, without a server, and plays. Prints the errors in its console as JSON.
// usage: node file_page.mjs INDEX_HTML
import {pathToFileURL} from 'node:url';
import {launchBrowser, openPage, PATIENCE} from './browser.mjs';

const problems = [];
const browser = await launchBrowser();
try {
  const page = await openPage(browser, pathToFileURL(process.argv[2]).href, problems);
  await page.locator('::-p-aria(Play[role="button"])').setTimeout(PATIENCE).click();
  await page.waitForFunction('socialCrowd.player.history.last.tick > 10', {timeout: PATIENCE, polling: 50});
} finally {
  await browser.close();
}
console.log(JSON.stringify(problems));
