// A browser for the tests of the page, and what they ask of it.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import axe from 'axe-core';
import { chromium } from 'playwright-core';

export function startBrowser(more = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader']) {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync', ...more],
  });
}

/** All that a page says in its console, that it does not catch, and that it asks of the network. */
export function complaintsOf(page, complaints = []) {
  page.on('console', (m) => ['error', 'warning'].includes(m.type()) && !/GPU stall|GL Driver/.test(m.text()) && complaints.push(m.text()));
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('request', (request) => /^(https?|wss?):/.test(request.url()) && complaints.push(`network: ${request.url()}`));
  return complaints;
}

export async function openStudio(page, url) {
  page.setDefaultTimeout(120_000); // for a machine with other work
  await page.goto(url);
  await page.waitForSelector('html[data-ready=true]');
}

/** page.waitForFunction() needs eval, which the page forbids. */
export async function until(page, holds, argument) {
  for (const end = Date.now() + 120_000; Date.now() < end; await page.waitForTimeout(50)) if (await page.evaluate(holds, argument)) return;
  assert.fail(`never came: ${holds}; the page says: ${await status(page)}`);
}

export const status = (page) => page.textContent('#status');
export const projectText = (page) => page.evaluate(async () => new TextDecoder().decode(await window.studio.session.project()));

export async function drop(page, name, bytes) {
  await page.setInputFiles('#file', { name, mimeType: 'application/octet-stream', buffer: Buffer.from(bytes) });
}

/** The page opened anew, with the project that it kept, on the step of pages. */
export async function reopenOnPages(page, name) {
  await page.waitForTimeout(500); // until it is kept
  await page.reload();
  await page.waitForSelector('html[data-ready=true]');
  await page.click('#continue');
  await until(page, (wanted) => document.getElementById('name').textContent === wanted, name);
  await page.click('#tab-pages');
  await page.waitForSelector('.part');
}

/** With PICTURES=FOLDER in the environment. */
export async function picture(page, name) {
  if (!process.env.PICTURES) return;
  await page.waitForTimeout(300);
  await page.screenshot({ path: join(process.env.PICTURES, `${name}.png`) });
}

/** axe-core finds nothing serious. */
export async function accessible(page, name) {
  await page.evaluate(axe.source); // by the debugger, so that the page's policy stays as it is
  const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ['violations'] }));
  const serious = violations.filter((v) => ['serious', 'critical'].includes(v.impact));
  assert.deepEqual(serious.map((v) => `${v.id}: ${v.nodes.map((n) => n.html).join(' ')}`), [], name);
}
