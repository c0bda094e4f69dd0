// What the screens do beyond the first need: margins and marks of pages, all files as one, order lanes and single creases,
// patterns changed by numbers.  usage: node features.mjs PAGE.html MESH.obj; PICTURES as in drive.mjs
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { accessible, complaintsOf, drop, openStudio, picture, projectText, reopenOnPages, startBrowser, status, until } from './browser.mjs';

const [pagePath, meshPath] = process.argv.slice(2);

const path = (page) => page.$eval('.part path', (part) => part.getAttribute('d').slice(0, 24));
async function partAfter(page, key) {
  const before = await path(page);
  await page.press('.part', key);
  await until(page, (d) => document.querySelector('.part path')?.getAttribute('d').slice(0, 24) !== d, before);
  return page.$eval('.part path', (part) => {
    const { x, y, width, height } = part.getBBox(), { width: w, height: h } = part.ownerSVGElement.viewBox.baseVal;
    return { left: x, right: w - x - width, top: y, bottom: h - y - height };
  });
}
const near = (a, b, what) => assert.ok(Math.abs(a - b) < 0.05, `${what}: ${a} and ${b}`);

async function pagesAreFilledIn(page) {
  await page.click('#tab-pages');
  await page.waitForSelector('.part');
  await page.selectOption('select[name=measure]', 'height');
  await page.fill('input[name=size]', '25');
  await page.click('#page-form summary');
  await page.fill('input[name=margin]', '14');
  await page.check('input[data-value=start]');
  await until(page, () => /x 25.0 mm/.test(document.getElementById('page-report').textContent));
  const middle = await partAfter(page, 'c');
  near(middle.left, middle.right, 'left and right');
  near(middle.top, middle.bottom, 'top and bottom');
  near((await partAfter(page, 'Home')).left, 14, 'left margin');
  near((await partAfter(page, 'End')).right, 14, 'right margin');
  near((await partAfter(page, 't')).top, 14, 'top margin');
  near((await partAfter(page, 'b')).bottom, 14, 'bottom margin');
  await picture(page, 'pages-form');
  await accessible(page, 'pages, filled in');
}

async function allIsOneArchive(page) {
  const folder = mkdtempSync(join(tmpdir(), 'studio-'));
  try {
    const saving = page.waitForEvent('download');
    await page.click('text=Save all (ZIP)');
    await (await saving).saveAs(join(folder, 'all.zip'));
    const told = execFileSync('python3', ['-c', 'import sys, zipfile; z = zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; print(*z.namelist())', join(folder, 'all.zip')], { encoding: 'utf8' });
    for (const kind of ['pdf', 'svg', 'dxf', 'fold', 'plico', 'html', 'glb']) assert.match(told, new RegExp(`bird[\\w-]*\\.${kind}\\b`), kind);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

async function aReloadKeepsTheForm(page) {
  await reopenOnPages(page, 'bird');
  assert.deepEqual(await page.evaluate(() => Object.fromEntries(['measure', 'size', 'margin'].map((name) => [name, document.querySelector(`[name=${name}]`).value]))),
    { measure: 'height', size: '25', margin: '14' });
  assert.ok(await page.isChecked('input[data-value=start]'));
}

async function creasesAreShown(page) {
  await page.click('#tab-net');
  await page.click('#tab-fold');
  await page.waitForSelector('#lanes [role=option]');
  assert.match(await page.getAttribute('#lanes [role=option]', 'aria-label'), /lane 1 of 1: 299 creases move from 0 to 100 %/);
  await page.click('#prove');
  await until(page, () => /collide at/.test(document.getElementById('motion').textContent));
  await page.$eval('#time', (slider) => { slider.value = '0.2'; slider.dispatchEvent(new Event('input')); });
  await page.press('#motion-jump', 'x');
  await until(page, () => Number(document.getElementById('time').value) > 0.4);
  await picture(page, 'fold-collision');
  await page.press('#check-now', 'c');
  await until(page, () => /faces \d+ and \d+ collide at this moment/.test(document.getElementById('moment').textContent));
  await page.$eval('#time', (slider) => { slider.value = '0.2'; slider.dispatchEvent(new Event('input')); });
  await page.press('#check-now', 'c');
  await until(page, () => document.getElementById('moment').textContent === 'nothing collides at this moment');
}

/** One crease turns alone; the picture follows, and the core says whether it collides. */
async function oneCreaseTurnsByHand(page) {
  await page.focus('#lanes [role=option]');
  await page.keyboard.press('Enter'); // nothing is chosen yet
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  await until(page, () => /crease \d+, (mountain|valley), -?\d+° now/.test(document.getElementById('crease').textContent));
  const before = await page.evaluate(() => document.getElementById('hand-now').textContent);
  await page.keyboard.press('Enter');
  for (let i = 0; i < 25; ++i) await page.keyboard.press('ArrowRight');
  await until(page, (was) => document.getElementById('hand-now').textContent !== was, before);
  await picture(page, 'fold-by-hand');
  await page.click('#hand-check');
  await until(page, () => /crease \d+ turns from .* proven free|collide at -?\d+°/.test(document.getElementById('moment').textContent));
  await accessible(page, 'fold, by hand');
  await page.click('#hand-back');
  await until(page, (was) => document.getElementById('hand-now').textContent === was, before);
}

async function panelsAreThickAndMotionsStandBeside(page) {
  await page.focus('#space');
  await page.keyboard.press('t');
  await until(page, () => /%/.test(document.getElementById('thickness-now').textContent));
  await picture(page, 'fold-thick');
  await page.click('#foldable');
  await until(page, () => /proven \(/.test(document.getElementById('motion').textContent));
  await page.selectOption('#beside', 'kept');
  await page.waitForSelector('#beside-view:not([hidden])');
  await until(page, () => /as it folds/.test(document.getElementById('beside-space').getAttribute('aria-label')));
  await page.$eval('#time', (slider) => { slider.value = '0.5'; slider.dispatchEvent(new Event('input')); });
  await page.waitForTimeout(300);
  await picture(page, 'fold-beside');
  await page.click('#check-margin');
  await until(page, () => /\d+ of 40 folds with every crease off by up to 5°/.test(document.getElementById('moment').textContent));
  await accessible(page, 'fold, beside');
}

const kinds = (page) => page.evaluate(() => JSON.parse(window.studio.pattern.text).edges_assignment.join(''));
const creases = (page) => page.locator('#pattern .crease').count();

async function patternsHaveNumbers(page) {
  await page.click('#tab-pattern');
  await page.selectOption('#pattern-name', 'miura');
  await until(page, () => document.querySelectorAll('#pattern .crease').length > 30);
  const before = await creases(page);
  await page.fill('#pattern-numbers [name=size]', '3x4');
  await page.press('#pattern-numbers [name=size]', 'Tab');
  await until(page, (n) => document.querySelectorAll('#pattern .crease').length < n, before);
  assert.equal(await creases(page), 31); // 3 x 4 parallelograms
  await page.fill('#pattern-numbers [name=sector]', '45');
  await page.press('#pattern-numbers [name=sector]', 'Tab');
  await until(page, () => /miura, size 3x4, sector 45deg/.test(document.getElementById('status').textContent));
  await picture(page, 'pattern-numbers');
  await accessible(page, 'pattern, with numbers');
}

/** An SVG becomes a drawing like any other; its letters are found again, but for one that is locked. */
async function anSvgIsEditedAndAssigned(page) {
  const svg = await page.evaluate(async () => {
    const { session, pattern } = window.studio;
    const { files } = await session.job('export', [['file', 'p.fold'], ['output', 'p.svg']], { 'p.fold': new TextEncoder().encode(pattern.text) });
    return new TextDecoder().decode(files['p.svg']);
  });
  await page.click('#pattern-new');
  await drop(page, 'drawn.svg', svg);
  await until(page, () => document.querySelectorAll('#pattern .crease').length === 31);
  const first = await kinds(page);
  assert.match(first, /M/);
  await page.focus('#pattern');
  for (let i = 0; !/, (mountain|valley),/.test(await status(page)) && i < 31; ++i) await page.keyboard.press(']');
  const [, index, kind] = /line (\d+), (mountain|valley)/.exec(await status(page));
  await page.keyboard.press(kind === 'mountain' ? 'v' : 'm'); // the other way round, and so it shall stay
  for (let i = 0; !(await status(page)).startsWith(`line ${index},`) && i < 32; ++i) await page.keyboard.press(']');
  await page.keyboard.press('l');
  assert.equal(await page.locator('#pattern .lock').count(), 1);
  await until(page, () => /wrong/.test(document.getElementById('pattern-verdict').textContent));
  await page.click('#pattern-anew');
  await until(page, () => /creases assigned/.test(document.getElementById('status').textContent));
  assert.match(await status(page), /every vertex folds flat by itself.*verified/);
  await until(page, () => /vertices fine/.test(document.getElementById('pattern-verdict').textContent));
  assert.equal((await kinds(page))[index], kind === 'mountain' ? 'V' : 'M');
  await picture(page, 'pattern-assigned');
  await page.keyboard.press('Control+z');
  await until(page, () => /wrong/.test(document.getElementById('pattern-verdict').textContent));
  await page.keyboard.press('Control+Shift+z');
}

/** Three edits of a net; the list of steps goes back before the first and on to the last. */
async function stepsAreJumpedTo(page) {
  await page.click('#tab-net');
  const first = await projectText(page);
  await page.evaluate(async () => {
    const { session } = window.studio;
    for (let edge = 0, made = 0; made < 3; ++edge) {
      const edit = session.shape.isBorder(edge) ? null : await session.editFor(edge);
      if (edit) await session.edit(`${edit.edit} edge ${edge}`, edit), ++made;
    }
  });
  const last = await projectText(page), steps = await page.locator('#history option').count();
  await page.selectOption('#history', String(steps - 4));
  await until(page, (n) => document.getElementById('history').value === String(n), steps - 4);
  assert.equal(await projectText(page), first);
  await page.selectOption('#history', String(steps - 1));
  await until(page, () => document.getElementById('redo').disabled);
  assert.equal(await projectText(page), last);
}
/** A net with a motion of its own: half of the creases first, then the others. */
async function theMotionOfAFileIsShown(page) {
  const [name, text] = await page.evaluate(async () => {
    const { session } = window.studio, { files } = await session.job('sample', [['name', 'cube'], ['output', 'cube.obj']], {});
    await session.open('cube.obj', files['cube.obj']);
    const file = JSON.parse(new TextDecoder().decode(await session.net())), goal = file.edges_foldAngle, points = file.vertices_coords.map(([x, y]) => [x, y, 0]);
    const first = goal.findIndex((angle) => angle), frame = (time, angles) => ({ frame_classes: ['foldedForm'], frame_attributes: ['3D'], frame_parent: 0, frame_inherit: true, 'plico:time': time, edges_foldAngle: angles, vertices_coords: points });
    file.file_frames = [file.file_frames[0], frame(0, goal.map(() => 0)), frame(0.4, goal.map((angle, e) => (e === first ? angle : 0))), frame(1, goal)];
    return ['steps.fold', JSON.stringify(file)];
  });
  await drop(page, name, text);
  await until(page, () => document.getElementById('name').textContent === 'steps');
  await page.click('#tab-fold');
  await until(page, () => document.querySelectorAll('#lanes [role=option]').length === 2);
  assert.equal(await page.textContent('#motion'), 'the motion of the file, not judged');
  assert.deepEqual(await page.$$eval('#lanes [role=option]', (all) => all.map((lane) => lane.getAttribute('aria-label').replace(/crease \d+ /, ''))),
    ['lane 1 of 2: moves from 0 to 40 %', 'lane 2 of 2: 4 creases move from 40 to 100 %']);
  await page.click('#prove');
  await until(page, () => document.getElementById('motion').textContent === 'folds, proven (the file’s)');
  await page.$eval('#time', (slider) => { slider.value = '0.4'; slider.dispatchEvent(new Event('input')); });
  await page.click('#lanes [role=option]');
  await until(page, () => /, -90° now, -90° at the end · lane: crease/.test(document.getElementById('crease').textContent));
  await picture(page, 'fold-lanes');
  await page.click('#plan'); // another one is sought: the net's own
  await until(page, () => document.getElementById('motion').textContent === 'folds, proven (linear)');
}

async function textIsPasted(page) {
  await page.evaluate(() => {
    const data = new DataTransfer();
    data.setData('text/plain', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n');
    document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true }));
  });
  await until(page, () => document.getElementById('name').textContent === 'pasted');
}

/** A sheet without a motion is not shown coming apart: one is found, with its lanes. */
async function anUnevenSheetGetsAMotion(page) {
  await page.click('#tab-jobs');
  await page.click('button[data-job="origami make"]');
  await until(page, () => /^plico origami make/.test(document.getElementById('job-command').textContent));
  await page.selectOption('#job-form select', 'letter');
  await page.click('#job-run');
  await until(page, () => /the file holds no motion · shown is one that was found \(md-frog\) · proven free/.test(document.querySelector('#job-result .motion .report')?.textContent ?? ''));
  const lanes = await page.$$eval('#job-result [role=option]', (all) => all.map((lane) => lane.getAttribute('aria-label')));
  assert.equal(lanes.length, 3);
  assert.match(lanes[0], /lane 1 of 3: 2 creases move from 0 to \d+ %/);
  await page.focus('#job-result [role=option]');
  for (const key of ['ArrowDown', 'ArrowDown']) await page.keyboard.press(key); // the first, then the second
  assert.equal(await page.getAttribute('#job-result [role=option]:nth-child(2)', 'aria-selected'), 'true');
  await picture(page, 'tools-lanes');
  await accessible(page, 'tools, lanes');
}

const browser = await startBrowser(), complaints = [];
try {
  const context = await browser.newContext({ viewport: { width: 1280, height: 820 }, reducedMotion: 'reduce' });
  const page = await context.newPage();
  complaintsOf(page, complaints);
  await openStudio(page, pathToFileURL(pagePath).href);
  await drop(page, 'bird.obj', readFileSync(meshPath));
  await until(page, () => document.getElementById('name').textContent === 'bird');
  await pagesAreFilledIn(page);
  await allIsOneArchive(page);
  await aReloadKeepsTheForm(page);
  await creasesAreShown(page);
  await oneCreaseTurnsByHand(page);
  await panelsAreThickAndMotionsStandBeside(page);
  await patternsHaveNumbers(page);
  await anSvgIsEditedAndAssigned(page);
  await anUnevenSheetGetsAMotion(page);
  await stepsAreJumpedTo(page);
  await theMotionOfAFileIsShown(page);
  await textIsPasted(page);
  await page.setViewportSize({ width: 390, height: 844 });
  for (const tab of ['pages', 'fold', 'pattern', 'jobs']) {
    await page.evaluate((t) => window.studio.tab(t), tab);
    await page.waitForTimeout(400);
    await picture(page, `${tab}-features-390`);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390, `${tab} fits a small screen`);
  }
  assert.deepEqual(complaints, []);
} finally {
  await browser.close();
}
