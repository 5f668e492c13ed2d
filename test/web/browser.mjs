// Chromium without a display, and what tests need of a page in it.
import puppeteer from 'puppeteer-core';

export const PATIENCE = 60000;  // [ms]

/** Starts Chromium with the renderer that needs no graphics card. Its profile is temporary. */
export function launchBrowser(chromium = process.env.CHROMIUM ?? '/usr/bin/chromium') {
  return puppeteer.launch({
    executablePath: chromium, headless: true, protocolTimeout: 3 * PATIENCE,
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
      '--ignore-gpu-blocklist', '--disable-dev-shm-usage', '--window-size=1280,720'],
    defaultViewport: {width: 1280, height: 720},
  });
}

/** Opens the page and waits for its first ticks. `problems` collects the errors in its console. */
export async function openPage(browser, address, problems = []) {
  const page = await browser.newPage();
  page.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
  page.on('pageerror', (error) => problems.push(String(error)));
  await page.goto(address, {timeout: PATIENCE});
  await page.waitForFunction(() => window.socialCrowd?.player.history.last, {timeout: PATIENCE});
  return page;
}
