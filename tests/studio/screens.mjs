// The screens where shapes are inflated, crease patterns drawn and parts placed, used as someone would, by pointer and by
// keys alone; and what is typed into forms.  usage: node screens.mjs PAGE.html MESH.obj; PICTURES as in drive.mjs
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { accessible, complaintsOf, drop, openStudio, picture, reopenOnPages, startBrowser, status, until } from './browser.mjs';

const [pagePath, meshPath] = process.argv.slice(2);

const facts = (page) => page.textContent('#inflate-facts');
const patternText = (page) => page.evaluate(() => window.studio.pattern.text);
const lines = async (page) => JSON.parse(await patternText(page)).edges_vertices.length;
const verdict = (page) => page.textContent('#pattern-verdict');

/** Where a place of the unit square is on the screen. */
async function onSheet(page, x, y) {
  return page.$eval('#pattern', (svg, [px, py]) => {
    const at = new DOMPoint(px, 1 - py).matrixTransform(svg.getScreenCTM());
    return [at.x, at.y];
  }, [x, y]);
}
async function stroke(page, from, to) {
  const [a, b] = [await onSheet(page, ...from), await onSheet(page, ...to)];
  await page.mouse.move(...a);
  await page.mouse.down();
  await page.mouse.move(...b, { steps: 3 });
  await page.mouse.up();
}

export async function aPatternIsDrawn(page) {
  await page.click('#tab-pattern');
  await page.click('#pattern-new');
  await page.waitForSelector('#pattern-verdict[data-status=good]');
  const empty = await patternText(page);
  await stroke(page, [0.01, 0.99], [0.98, 0.01]); // a diagonal: its ends are drawn to the corners
  assert.equal(await lines(page), 5);
  await page.click('#kind-V');
  await stroke(page, [0.01, 0.01], [0.99, 0.99]); // crosses it: both are cut there
  assert.equal(await lines(page), 8);
  await until(page, () => /wrong/.test(document.getElementById('pattern-verdict').textContent)); // 2 mountains, 2 valleys
  assert.match(await page.textContent('#pattern-problems'), /vertex \d has 2 mountains and 2 valleys, must differ by 2/);
  assert.equal(await page.locator('#pattern .vertex.wrong').count(), 1);
  await picture(page, 'pattern-wrong');
  await accessible(page, 'pattern');
  await page.click('#tool-assign');
  await page.click('#kind-M');
  await page.mouse.click(...(await onSheet(page, 0.25, 0.25))); // one valley becomes a mountain
  await until(page, () => document.getElementById('pattern-verdict').textContent === '1 vertex fine');
  // Nearly along 22.5 degrees from a corner: taken to be so, and to end at the border.
  await page.click('#tool-draw');
  await stroke(page, [0, 0], [0.985, 0.42]);
  const { vertices_coords: points } = JSON.parse(await patternText(page));
  const tip = points.find(([x, y]) => x === 1 && y > 0 && y < 1);
  assert.ok(tip && Math.abs(tip[1] - Math.tan(Math.PI / 8)) < 1e-9, JSON.stringify(points));
  await picture(page, 'pattern-drawn');
  const drawn = await patternText(page);
  for (let i = 0; i < 4; ++i) await page.keyboard.press('Control+z');
  assert.equal(await patternText(page), empty);
  for (let i = 0; i < 4; ++i) await page.keyboard.press('Control+Shift+z');
  assert.equal(await patternText(page), drawn);
  await page.keyboard.press('Control+z');
}

export async function aPatternIsDrawnByKeys(page) {
  await page.click('#pattern-new');
  await page.focus('#pattern');
  for (const key of ['m', 'n', 'Enter', 'n', 'n', 'Enter']) await page.keyboard.press(key); // corner to corner
  assert.equal(await lines(page), 5);
  for (let i = 0; !/line \d, mountain/.test(await status(page)) && i < 9; ++i) await page.keyboard.press(']');
  assert.match(await status(page), /line \d, mountain/);
  await page.keyboard.press('v');
  assert.match(await status(page), /mountain to valley/);
  for (let i = 0; !/line \d, valley/.test(await status(page)) && i < 9; ++i) await page.keyboard.press(']');
  await page.keyboard.press('Delete');
  assert.equal(await lines(page), 4);
  await page.selectOption('#pattern-mirror', 'left-right');
  await page.focus('#pattern');
  for (let i = 0; !/^at 0.000 0.000/.test(await status(page)) && i < 9; ++i) await page.keyboard.press('n');
  await page.keyboard.press('Enter'); // from the lower left corner
  for (const key of ['ArrowRight', 'ArrowRight', 'ArrowUp', 'ArrowUp']) await page.keyboard.press(key);
  await page.keyboard.press('Enter');
  const mirrored = await lines(page);
  assert.equal(mirrored, 6);
  await page.selectOption('#pattern-mirror', 'none');
  await page.keyboard.press('Control+z');
  assert.equal(await lines(page), 4);
}

const kCrossing = '1 0 0 400 0\n1 400 0 400 400\n1 400 400 0 400\n1 0 400 0 0\n2 0 0 400 400\n3 0 400 400 0\n';
export async function patternFilesAreOpened(page) {
  const give = (name, text) => page.setInputFiles('#pattern-file', { name, mimeType: 'text/plain', buffer: Buffer.from(text) });
  await page.click('#tab-net');
  await drop(page, 'crossing.cp', kCrossing); // opens where it belongs
  await until(page, () => document.querySelectorAll('#pattern .crease').length === 8); // cut where they cross
  for (const [name, text] of [['broken.fold', '{"vertices_coords": '], ['none.cp', 'hello'], ['nan.cp', '2 0 0 x 1\n']]) {
    const before = await patternText(page);
    await give(name, text);
    await until(page, () => /\(studio\/no-pattern\)$/.test(document.getElementById('status').textContent));
    assert.equal(await patternText(page), before);
    await page.evaluate(() => (document.getElementById('status').textContent = ''));
  }
  await page.selectOption('#pattern-name', 'miura');
  await until(page, () => document.querySelectorAll("#pattern .crease").length > 30);
  await until(page, () => /vertices fine/.test(document.getElementById('pattern-verdict').textContent));
  await picture(page, 'pattern-miura');
  await page.click('#pattern-fold');
  await until(page, () => /^plico fold pattern.fold/.test(document.getElementById('job-command').textContent));
}

export async function typedNumbersAreChecked(page) {
  await page.click('#tab-jobs');
  await page.click('button[data-job=inflate]');
  const field = page.locator('#job-form input[aria-describedby=help-inflate-pressure]');
  await field.fill('-1');
  assert.equal(await field.getAttribute('aria-invalid'), 'true');
  assert.match(await field.getAttribute('title'), /pressure = -1 must be at least 0/);
  await page.click('#job-run');
  assert.equal(await page.textContent('#job-result'), '');
  await field.fill('0.2');
  await field.press('ArrowUp');
  assert.equal(await field.inputValue(), '0.21');
  assert.equal(await field.getAttribute('aria-invalid'), 'false');
  await field.fill('');
}

export async function aShapeIsInflated(page) {
  await page.click('#tab-inflate');
  await until(page, () => /hyperbolic/.test(document.getElementById('inflate-facts').textContent));
  const first = await facts(page);
  assert.match(first, /0 steps/);
  await accessible(page, 'inflate');
  await page.focus('#space');
  await page.keyboard.press('v'); // pin a vertex by keys, then a face
  await page.keyboard.press(']');
  await page.keyboard.press('Enter');
  await page.keyboard.press('p');
  await page.keyboard.press(']');
  await page.keyboard.press(']');
  await page.keyboard.press('Enter');
  assert.equal(await page.textContent('#pins'), '1 face and 1 vertex stay');
  const box = await page.locator('#space').boundingBox(); // and faces by painting
  await page.mouse.move(box.x + box.width / 2 - 8, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 8, box.y + box.height / 2 + 8, { steps: 6 });
  await page.mouse.up();
  assert.match(await page.textContent('#pins'), /^\d+ faces and 1 vertex stay/);
  await page.keyboard.press('t');
  await page.press('#space', ' ');
  await until(page, () => /10 steps/.test(document.getElementById('inflate-facts').textContent));
  await page.press('#space', ' ');
  await until(page, () => /20 steps/.test(document.getElementById('inflate-facts').textContent));
  await picture(page, 'inflate');
  await theResultIsThatOfTheCommandLine(page);
  await page.click('#inflate-best');
  await until(page, () => /stopped by/.test(document.getElementById('inflate-facts').textContent));
  assert.match(await page.textContent('#inflate-command'), /^plico inflate bird.obj --max-growth 5% --keep/);
  await picture(page, 'inflate-best');
}
/** The words that the page shows, run as a job, give the bytes that it saves. */
async function theResultIsThatOfTheCommandLine(page) {
  const same = await page.evaluate(async () => {
    const { session } = window.studio;
    const words = document.getElementById('inflate-command').textContent.split(' ').slice(3, -2), values = [['mesh', 'bird.obj'], ['output', 'round.obj']];
    while (words.length) values.push([words.shift().slice(2), words.shift()]);
    const { files } = await session.job('inflate', values, { 'bird.obj': await session.mesh() });
    const [made, live] = [files['round.obj'], await session.inflatedMesh()].map((bytes) => new TextDecoder().decode(bytes));
    return made === live && live !== new TextDecoder().decode(await session.mesh());
  });
  assert.ok(same);
}

const places = (page) => page.$$eval('.part', (parts) => parts.map((part) => part.getAttribute('aria-label')));
export async function partsArePlacedByHand(page) {
  await page.click('#tab-pages');
  await page.waitForSelector('.part');
  const transform = () => page.$eval('.part path', (path) => path.getAttribute('d').slice(0, 24));
  const before = await transform();
  const settled = async (was) => until(page, (d) => document.querySelector('.part path')?.getAttribute('d').slice(0, 24) !== d, was);
  await page.focus('.part');
  await page.keyboard.press('Shift+ArrowUp');
  await settled(before);
  const moved = await transform();
  assert.match((await places(page))[0], /placed by hand/);
  await page.keyboard.press('r');
  await settled(moved);
  assert.match(await page.textContent('#page-report'), /part/);
  await picture(page, 'pages-moved');
  await accessible(page, 'pages');
  await page.keyboard.press('Control+z');
  await until(page, (d) => document.querySelector('.part path')?.getAttribute('d').slice(0, 24) === d, moved);
  await page.keyboard.press('Control+z');
  await until(page, (d) => document.querySelector('.part path')?.getAttribute('d').slice(0, 24) === d, before);
  const at = await page.$eval('.part path', (path) => {
    const { x, y, width, height } = path.getBBox();
    for (let i = 1; i < 40; ++i)
      for (let j = 1; j < 40; ++j) {
        const p = new DOMPoint(x + (width * i) / 40, y + (height * j) / 40);
        if (!path.isPointInFill(p)) continue;
        const on = p.matrixTransform(path.getScreenCTM());
        if (on.y > 80 && on.y < innerHeight - 80) return [on.x, on.y];
      }
    return undefined;
  });
  // By the wheel, once it is chosen.
  await page.focus('.part');
  await page.mouse.move(...at);
  await page.mouse.wheel(0, 100);
  await settled(before);
  await page.keyboard.press('Control+z');
  await until(page, (d) => document.querySelector('.part path')?.getAttribute('d').slice(0, 24) === d, before);
  // By the pointer: 20 mm to the right.
  await page.mouse.move(...at);
  await page.mouse.down();
  await page.mouse.move(at[0] + 40, at[1], { steps: 4 });
  await page.mouse.up();
  await settled(before);
  await page.click('#repack');
  await until(page, (d) => document.querySelector('.part path')?.getAttribute('d').slice(0, 24) === d, before);
}

/** A part that was sent to another page is there again when the page is opened anew. */
export async function partsStayWhereTheyWerePut(page) {
  const corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], sides = [[1, 3, 2], [1, 2, 4], [1, 4, 3], [2, 3, 4]];
  const lines = [0, 1].flatMap((k) => [...corners.map(([x, y, z]) => `v ${x + 3 * k} ${y} ${z}`), ...sides.map((f) => `f ${f.map((v) => v + 4 * k).join(' ')}`)]);
  await drop(page, 'two.obj', lines.join('\n'));
  await until(page, () => document.getElementById('name').textContent === 'two');
  await page.click('#tab-pages');
  await until(page, () => document.querySelectorAll('.part').length === 2);
  const unsized = await page.$eval('.part path', (part) => part.getAttribute('d'));
  await page.fill('input[name=size]', '60');
  await page.click('#page-form .strong');
  await until(page, (d) => document.querySelector('.part path')?.getAttribute('d') !== d, unsized);
  await until(page, () => [...document.querySelectorAll('.part')].filter((part) => part.getAttribute('aria-label').includes('page 1')).length === 2);
  await page.focus('.part');
  await page.keyboard.press('PageDown');
  await until(page, () => [...document.querySelectorAll('.part')].some((part) => part.getAttribute('aria-label').includes('page 2, placed by hand')));
  const before = (await places(page)).sort();
  await reopenOnPages(page, 'two');
  await until(page, () => document.querySelectorAll('.part').length === 2);
  assert.deepEqual((await places(page)).sort(), before);
  assert.equal(await page.inputValue('input[name=size]'), '60');
}

const kDotsPerMm = 100; // 2540 dots an inch
/** Millimetres between the outermost red lines that cross the middle of the page, as poppler sees them: across, and up. */
function redExtent(pdf, width, height) {
  const along = (slice, n) => {
    const ppm = execFileSync('pdftoppm', ['-r', String(25.4 * kDotsPerMm), '-f', '1', '-l', '1', ...slice, pdf], { maxBuffer: 1 << 26 });
    const pixels = ppm.subarray(ppm.length - 3 * n), red = [...Array(n).keys()].filter((i) => pixels[3 * i] - pixels[3 * i + 1] > 60);
    const middleOfLine = (first, way) => {
      let i = first;
      while (red[i + way] === red[i] + way) i += way;
      return (red[first] + red[i]) / 2;
    };
    return (middleOfLine(red.length - 1, -1) - middleOfLine(0, 1)) / kDotsPerMm;
  };
  const [w, h] = [Math.floor(width * kDotsPerMm), Math.floor(height * kDotsPerMm)];
  const across = along(['-x', '0', '-y', String(h >> 1), '-W', String(w), '-H', '1'], w);
  return [across, along(['-x', String(w >> 1), '-y', '0', '-W', '1', '-H', String(h)], h)];
}
export async function aHundredMillimetresAreAHundred(page) {
  const folder = mkdtempSync(join(tmpdir(), 'studio-'));
  try {
    await drop(page, 'square.obj', 'v 0 0 0\nv 100 0 0\nv 100 60 0\nv 0 60 0\nf 1 2 3 4\n');
    await until(page, () => document.getElementById('name').textContent === 'square');
    await page.click('#tab-pages');
    await page.fill('input[name=size]', '100');
    await page.selectOption('select[name=style]', 'laser');
    await page.click('#page-form .strong');
    await until(page, () => /model 100.0 x 60.0/.test(document.getElementById('page-report').textContent));
    const saving = page.waitForEvent('download');
    await page.click('text=Save PDF');
    const pdf = join(folder, 'page.pdf');
    await (await saving).saveAs(pdf);
    const size = redExtent(pdf, 210, 297).sort((a, b) => a - b);
    console.log(`60 and 100 mm in the PDF of the page: ${size.map((mm) => mm.toFixed(3)).join(' and ')}`);
    assert.ok(Math.abs(size[0] - 60) <= 0.01 && Math.abs(size[1] - 100) <= 0.01, String(size));
    // Its layers; that its bytes are those of the command line, bytes_test says.
    const layers = [...readFileSync(pdf, 'latin1').matchAll(/\/Type \/OCG \/Name \((\w+)\)/g)].map(([, name]) => name);
    assert.ok(layers.includes('CUT') && layers.includes('MARK'), String(layers));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** A tab in the background draws nothing; the job goes on, and its answer is there. */
export async function aJobEndsInAHiddenTab(context, page) {
  await page.click('#tab-net');
  const other = await context.newPage();
  await page.evaluate(() => {
    window.ended = window.studio.session.search(true, () => undefined).then(() => 'done');
  });
  await other.bringToFront();
  assert.equal(await page.evaluate(() => window.ended), 'done');
  await other.close();
  await page.bringToFront();
  assert.ok(await page.evaluate(() => window.studio.session.shape !== undefined));
}

if (process.argv[1]?.endsWith('screens.mjs')) {
  const browser = await startBrowser(), complaints = [];
  try {
    const context = await browser.newContext({ viewport: { width: 1280, height: 820 }, reducedMotion: 'reduce' });
    const page = await context.newPage();
    complaintsOf(page, complaints);
    await openStudio(page, pathToFileURL(pagePath).href);
    await page.click('#start-pattern');
    await aPatternIsDrawn(page);
    await aPatternIsDrawnByKeys(page);
    await patternFilesAreOpened(page);
    await drop(page, 'bird.obj', readFileSync(meshPath));
    await until(page, () => document.getElementById('name').textContent === 'bird');
    await typedNumbersAreChecked(page);
    await aShapeIsInflated(page);
    await partsArePlacedByHand(page);
    await aJobEndsInAHiddenTab(context, page);
    await partsStayWhereTheyWerePut(page);
    await aHundredMillimetresAreAHundred(page);
    await page.setViewportSize({ width: 390, height: 844 });
    for (const tab of ['inflate', 'pattern', 'pages']) {
      await page.evaluate((t) => window.studio.tab(t), tab);
      await page.waitForTimeout(400);
      await picture(page, `${tab}-390`);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390, `${tab} fits a small screen`);
    }
    assert.deepEqual(complaints, []);
  } finally {
    await browser.close();
  }
}
