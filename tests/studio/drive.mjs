// Uses the studio as someone would, in a browser, from the disk.  usage: node drive.mjs PAGE.html MESH.obj
// With PICTURES=FOLDER in the environment it leaves screenshots there.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { accessible, complaintsOf, drop, openStudio, picture, projectText, startBrowser, status, until } from './browser.mjs';

const [pagePath, meshPath] = process.argv.slice(2);
const browser = await startBrowser();

async function aFileBecomesANet(page) {
  await drop(page, '<img src=x onerror=alert(1)>.obj', readFileSync(meshPath));
  await page.waitForSelector('#verdict[data-status=good]');
  assert.match(await page.textContent('#verdict'), /one net, verified/);
  assert.equal(await page.locator('img[src=x]').count(), 0);
  await drop(page, 'bird.obj', readFileSync(meshPath));
  await until(page, () => document.getElementById('name').textContent === 'bird');
  await accessible(page, 'net');
  await picture(page, 'net');
}

async function editsAreUndoneAndDoneAgain(page) {
  const first = await projectText(page);
  const made = await page.evaluate(async () => {
    const { session } = window.studio;
    let state = 1, count = 0;
    const draw = (n) => (state = (state * 48271) % 2147483647) % n;
    while (count < 200) {
      const edge = draw(session.shape.model.edges);
      const edit = draw(5) ? await session.editFor(edge) : { edit: 'lock', edge, locked: draw(3) === 0 };
      if (!edit || session.shape.isBorder(edge)) continue;
      await session.edit('random', edit);
      ++count;
    }
    return count;
  });
  assert.equal(made, 200);
  const last = await projectText(page);
  assert.notEqual(first, last);
  await page.evaluate(async () => { while (await window.studio.session.undo()); });
  assert.equal(await projectText(page), first);
  await page.evaluate(async () => { while (await window.studio.session.redo()); });
  assert.equal(await projectText(page), last);
  await page.evaluate(async () => { while (await window.studio.session.undo()); });
  assert.equal(await projectText(page), first);
}

async function keysAreEnough(page) {
  const first = await projectText(page);
  await page.focus('#sheet');
  for (let i = 0; i < 40; ++i) {
    await page.keyboard.press(i % 3 === 2 ? 'ArrowUp' : 'ArrowRight');
    if (/ fold/.test(await status(page))) break;
  }
  assert.match(await status(page), /edge \d+, fold/);
  await page.keyboard.press('Enter');
  await until(page, () => /cut edge/.test(document.getElementById('status').textContent));
  assert.match(await page.textContent('#verdict'), /2 parts/);
  await picture(page, 'cut');
  await page.keyboard.press('Control+z');
  await until(page, () => /undone/.test(document.getElementById('status').textContent));
  assert.equal(await projectText(page), first);
}

async function theModelFolds(page) {
  await page.click('#tab-fold');
  await page.click('#foldable');
  await until(page, () => /proven|collide|undecided/.test(document.getElementById('motion').textContent));
  console.log(`fold: ${await page.textContent('#motion')}`);
  await page.$eval('#time', (slider) => { slider.value = '0.5'; slider.dispatchEvent(new Event('input')); });
  await page.waitForTimeout(300);
  await picture(page, 'fold');
  await accessible(page, 'fold');
}

async function thePagesAreDrawn(page) {
  await page.click('#tab-pages');
  await page.waitForSelector('#pages img');
  assert.match(await page.textContent('#page-report'), /part/);
  const saving = page.waitForEvent('download');
  await page.click('text=Save SVG');
  assert.match((await saving).suggestedFilename(), /^bird.*\.svg$/);
  await picture(page, 'pages');
  await accessible(page, 'pages');
}

async function theToolsDoTheirJobs(page) {
  await page.click('#tab-jobs');
  await page.click('button[data-job=inflate]');
  assert.match(await page.textContent('#job-command'), /^plico inflate bird.obj -o bird-round.obj$/);
  await picture(page, 'tools-inflate');
  await accessible(page, 'tools');
  await page.click('#job-run');
  await page.waitForSelector('#job-result [data-status=good]', { timeout: 60000 });
  assert.match(await page.textContent('#job-result'), /hyperbolic.*bird-round.obj/s);
  await page.click('button[data-job="origami make"]');
  await until(page, () => /^plico origami make/.test(document.getElementById('job-command').textContent));
  await page.selectOption('#job-form select', 'waterbomb');
  assert.match(await page.textContent('#job-command'), /waterbomb/);
  await page.click('#job-run');
  await page.waitForSelector('#job-result canvas', { timeout: 60000 });
  assert.match(await page.textContent('#job-result'), /waterbomb.fold/);
  await until(page, () => / one that was found \(\w+\) · proven free/.test(document.querySelector('#job-result .motion .report').textContent));
  await until(page, () => document.querySelector('#job-result .motion span').textContent === '60 %');
  await page.click('#job-result .motion button');
  await until(page, () => document.querySelector('#job-result .motion span').textContent === '100 %');
  await picture(page, 'tools-pattern');
  await page.click('button[data-job=check]');
  await page.click('#job-run');
  await page.waitForSelector('#job-result [data-status=good]', { timeout: 60000 });
  await accessible(page, 'tools, a result');
}

async function aReloadLosesNothing(page) {
  const before = await projectText(page);
  await page.waitForTimeout(1000);
  await page.reload();
  await page.waitForSelector('html[data-ready=true]');
  await page.click('#continue');
  await page.waitForSelector('#verdict:not(:empty)', { state: 'attached' });
  await until(page, () => window.studio.session.shape);
  assert.equal(await projectText(page), before);
}

const complaints = [];
try {
  const context = await browser.newContext({ viewport: { width: 1280, height: 820 }, reducedMotion: 'reduce' });
  const page = await context.newPage();
  complaintsOf(page, complaints);
  await openStudio(page, pathToFileURL(pagePath).href);
  await accessible(page, 'start');
  await picture(page, 'start');
  await aFileBecomesANet(page);
  await editsAreUndoneAndDoneAgain(page);
  await keysAreEnough(page);
  await theModelFolds(page);
  await thePagesAreDrawn(page);
  await theToolsDoTheirJobs(page);
  await aReloadLosesNothing(page);
  await page.setViewportSize({ width: 390, height: 844 });
  for (const tab of ['net', 'fold', 'pages', 'jobs']) {
    await page.evaluate((t) => window.studio.tab(t), tab);
    await page.waitForTimeout(400);
    await picture(page, `${tab}-390`);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= 390, `${tab} is ${wide} pixels wide on a small screen`);
  }
  assert.deepEqual(complaints, []);
} finally {
  await browser.close();
}
