// Drives viewer pages in a browser.  usage: node page.js NAME...      reads NAME.html and NAME.json, which is
// {"moments": [{"time": 0.5, "panels": [[x, y, z, ...], ...]}, ...], "size": largest coordinate}
// With PICTURES=FOLDER in the environment it leaves screenshots there.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync'],
});
try {
  for (const name of process.argv.slice(2)) await drive(name);
} finally {
  await browser.close();
}

async function drive(name) {
  const expected = JSON.parse(readFileSync(`${name}.json`, 'utf8'));
  const page = await browser.newPage({ viewport: { width: 1280, height: 820 }, reducedMotion: 'reduce' });
  const complaints = [];
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('request', (request) => /^https?:/.test(request.url()) && complaints.push(`network: ${request.url()}`));
  await page.goto(pathToFileURL(`${name}.html`).href);
  await page.waitForSelector('html[data-ready=true]');
  await theSliderMovesThePanels(page, name, expected);
  await theKeyboardReachesEverything(page);
  await theViewsAreLinked(page);
  await theHeaderIsOneRow(page, name);
  await nothingIsClipped(page, name);
  await itFitsASmallScreen(page, name);
  assert.deepEqual(complaints, []);
  await page.close();
}

async function screenshot(page, name) {
  if (!process.env.PICTURES) return;
  await page.waitForTimeout(500);
  await page.screenshot({ path: join(process.env.PICTURES, `${name}.png`) });
}

async function theSliderMovesThePanels(page, name, expected) {
  for (const { time, panels } of expected.moments) {
    await page.$eval('#time', (slider, value) => {
      slider.value = value;
      slider.dispatchEvent(new Event('input'));
    }, String(time));
    const shown = await page.evaluate(() => window.plico.positions());
    assert.equal(shown.length, panels.length);
    let worst = 0;
    panels.forEach((points, p) => {
      assert.equal(shown[p].length, points.length);
      points.forEach((x, i) => { worst = Math.max(worst, Math.abs(x - shown[p][i])); });
    });
    assert.ok(worst <= 1e-6 * expected.size, `${name} at ${time}: panels are off by ${worst}`);
    console.log(`${name} at ${time}: ${panels.length} panels, off by at most ${worst.toExponential(1)}`);
    await screenshot(page, `${name}-${Math.round(100 * time)}`);
  }
}

async function theKeyboardReachesEverything(page) {
  const time = () => page.evaluate(() => window.plico.time());
  await page.locator('body').press('Home');
  assert.equal(await time(), 0);
  await page.keyboard.press('ArrowRight');
  assert.equal(await time(), 0.01);
  await page.keyboard.press('.');
  assert.equal(await time(), 0.02);
  await page.keyboard.press(',');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await time(), 0);
  await page.keyboard.press('ArrowUp');
  assert.equal(await time(), 0.1);
  await page.keyboard.press('End');
  assert.equal(await time(), 1);
  assert.equal(await page.getAttribute('#time', 'aria-valuetext'), '100 % folded');
  await page.keyboard.press('Home');
  await page.keyboard.press('Space');
  while (await time() <= 0.01) await page.waitForTimeout(20);  // the page forbids the eval of waitForFunction
  assert.equal(await page.getAttribute('#play', 'aria-label'), 'Pause');
  await page.keyboard.press('Space');
  const paused = await time();
  await page.waitForTimeout(150);
  assert.equal(await time(), paused);
  await page.keyboard.press('?');
  assert.ok(await page.isVisible('#help'));
  await page.keyboard.press('Escape');
  assert.ok(!await page.isVisible('#help'));
}

async function theViewsAreLinked(page) {
  const isPictured = await page.$eval('#space', (canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    return data.some((x, i) => i % 4 === 3 && x === 255);
  });
  assert.ok(isPictured, 'nothing is drawn');
  await page.fill('#panel', '0');
  await page.press('#panel', 'Enter');
  assert.equal(await page.evaluate(() => window.plico.selected()), 0);
  assert.equal(await page.getAttribute('polygon[data-panel="0"]', 'class'), 'selected');
  assert.match(await page.textContent('#details'), /^Panel 0/);
  await page.locator('polygon[data-panel="1"]').dispatchEvent('click');
  assert.equal(await page.evaluate(() => window.plico.selected()), 1);
  const nameless = await page.$$eval('button, input, select, a', (all) => all.filter((element) =>
    !(element.getAttribute('aria-label') || element.textContent.trim() || element.closest('label'))).length);
  assert.equal(nameless, 0, 'controls without a name');
}

// However many files there are, they leave the views their place, and each can be reached.
async function theHeaderIsOneRow(page, name) {
  await page.setViewportSize({ width: 1280, height: 800 });
  const high = await page.$eval('header', (header) => header.getBoundingClientRect().height);
  assert.ok(high < 50, `the header of ${name} is ${high} pixels high`);
  const [links, shown] = await page.evaluate(() => {
    const all = [...document.querySelectorAll('#links a')];
    document.querySelector('#more').open = true;
    const seen = all.filter((link) => link.getClientRects().length > 0).length;
    document.querySelector('#more').open = false;
    return [JSON.parse(document.querySelector('#plico-data').textContent).links.length, seen];
  });
  assert.equal(shown, links, `links of ${name} that can be reached`);
}

// The outermost pixels of the view stay empty, whatever its shape and the moment.
async function nothingIsClipped(page, name) {
  for (const size of [{ width: 1280, height: 800 }, { width: 800, height: 1100 }]) {
    await page.setViewportSize(size);
    for (const time of [0, 0.25, 0.5, 0.75, 1]) {
      await page.evaluate((now) => window.plico.setTime(now), time);
      await page.waitForTimeout(200);  // the fine picture comes when nothing moves
      const clipped = await page.$eval('#space', (canvas) => {
        const { width, height } = canvas;
        const copy = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
        copy.drawImage(canvas, 0, 0);
        const { data } = copy.getImageData(0, 0, width, height);
        return data.some((alpha, i) => {
          const x = (i >> 2) % width, y = Math.floor((i >> 2) / width);
          return i % 4 === 3 && alpha > 0 && (x === 0 || y === 0 || x === width - 1 || y === height - 1);
        });
      });
      assert.ok(!clipped, `${name} is clipped at ${time} of the motion at ${size.width} x ${size.height}`);
    }
  }
}

async function itFitsASmallScreen(page, name) {
  await page.setViewportSize({ width: 360, height: 740 });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 360, `the page is ${wide} pixels wide on a screen of 360`);
  await screenshot(page, `${name}-phone`);
}
