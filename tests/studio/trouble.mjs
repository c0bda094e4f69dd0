// Everything that can go wrong on the page: files that are none, browsers that lack something, memory that runs out, jobs
// that are stopped and tabs that die. Each is told with a code, and the page and its document stay.
// usage: node trouble.mjs PAGE.html MESH.obj
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, truncateSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { complaintsOf, drop, openStudio, projectText, startBrowser, status, until } from './browser.mjs';

const [pagePath, meshPath] = process.argv.slice(2);
const url = pathToFileURL(pagePath).href;
const mesh = readFileSync(meshPath, 'utf8');
const folder = mkdtempSync(join(tmpdir(), 'studio-'));
const kAtOnce = 1000; // milliseconds, on a machine with other work; the bar of 200 is kept by bench/studio
let browser = await startBrowser();

const kCube = [...Array(8).keys()].map((i) => `v ${i & 1} ${(i >> 1) & 1} ${i >> 2}\n`).join('') + 'f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 2 4 8 6\nf 4 3 7 8\nf 3 1 5 7\n';

// Each is refused: `code` is what the message ends with.
const kRefused = {
  'empty.obj': '', 'no-faces.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\n', 'nan.obj': 'v 0 0 nan\nf 1 1 1\n',
  'huge-numbers.obj': kCube.replaceAll(' 1', ' 1e300').replace(/f[^]*/, '') + kCube.slice(kCube.indexOf('f')),
  'range.obj': 'v 0 0 0\nf 1 2 3\n', 'three-faces-at-an-edge.obj': `${kCube}v 2 2 2\nf 1 2 9\n`,
  'newer.plico': '{"plico_project": 9}', 'corrupt.plico': '{"plico_project": 1, "mesh": ', 'not-a-project.plico': '[]',
  'none.fold': '{"file_spec": 1.2}', 'other-version.fold': '{"file_spec": 99}', 'none.xyz': 'hello',
  'frames.fold': `{"file_spec": 1.2, "file_frames": [${'{},'.repeat(1e6 - 1)}{}]}`,
};
const twoCubes = (apart) => kCube + kCube.split('\n').slice(0, 8).map((line) => `v ${line.slice(2).split(' ').map((x) => Number(x) + apart).join(' ')}\n`).join('') +
  kCube.slice(kCube.indexOf('f')).replace(/\d+/g, (i) => String(Number(i) + 8));
// Each becomes a net, perhaps of several parts and with a note.
const kUnusual = {
  'open.obj': kCube.replace('f 1 3 4 2\n', ''), 'flipped.obj': kCube.replace('f 5 6 8 7', 'f 7 8 6 5'),
  'two.obj': twoCubes(5), 'self-crossing.obj': twoCubes(0.5),
  'no-area.obj': `${kCube}f 1 2 2\n`,
};
const kNames = ['<script>alert(1)</script>.obj', '<img src=x onerror=alert(1)>.obj', '\u202egpj.obj', `${'long '.repeat(40)}.obj`, "'\"&;`$(x).obj", '..\\..\\x.obj'];

async function isRefused(page, name, give) {
  await page.evaluate(() => (document.getElementById('status').textContent = ''));
  await give();
  await until(page, () => document.getElementById('status').dataset.kind === 'bad' && /\([\w/-]+\)$/.test(document.getElementById('status').textContent));
  console.log(`${name.slice(0, 40)}: ${await status(page)}`);
  assert.doesNotMatch(await status(page), /\(internal\)|something is wrong/);
}

async function badFilesAreTold(page) {
  const before = await projectText(page);
  for (const [name, text] of Object.entries(kRefused)) await isRefused(page, name, () => drop(page, name, text));
  assert.equal(await projectText(page), before);
}

async function unusualShapesBecomeNets(page) {
  for (const [name, text] of Object.entries(kUnusual)) {
    await drop(page, name, text);
    await until(page, (stem) => document.getElementById('name').textContent === stem, name.replace('.obj', ''));
    console.log(`${name}: ${await page.textContent('#verdict')}; ${await status(page)}`);
  }
}

async function namesAreText(page) {
  for (const name of kNames) {
    await page.evaluate(() => (document.getElementById('name').textContent = ''));
    await drop(page, name, mesh);
    await until(page, () => document.getElementById('name').textContent !== '');
    assert.equal(await page.locator('header img, header script').count(), 0);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${name} fits`);
  }
  const name = await page.evaluate(async (text) => {
    const long = 'x'.repeat(10_000);
    await window.studio.session.open(`${long}.obj`, new TextEncoder().encode(text));
    return document.documentElement.scrollWidth <= innerWidth;
  }, mesh);
  assert.ok(name, 'a name of 10,000 letters fits');
}

// Sparse files: nothing of them is on the disk.
function sparse(name, bytes) {
  const path = join(folder, name);
  writeFileSync(path, '');
  truncateSync(path, bytes);
  return path;
}
async function whatIsTooLargeIsTold(page) {
  await drop(page, 'kept.obj', mesh);
  await until(page, () => document.getElementById('name').textContent === 'kept');
  const before = await projectText(page);
  await isRefused(page, '2 GB', () => page.setInputFiles('#file', sparse('two-gigabytes.stl', 2 ** 31)));
  assert.match(await status(page), /studio\/file-too-large/);
  await isRefused(page, '5 M faces', () => page.setInputFiles('#file', sparse('five-million.stl', 84 + 50 * 5e6)));
  assert.match(await status(page), /studio\/file-too-large/);
  assert.equal(await projectText(page), before);
}

async function aWorkerWithoutMemoryIsReplaced(page) {
  const before = await projectText(page);
  const told = await page.evaluate(async () => {
    const { session } = window.studio;
    const done = session.job('check', [['mesh', 'large.obj']], { 'large.obj': new Uint8Array(3.6e8) });
    return done.then(() => 'done', ({ failure }) => `${failure?.message} (${failure?.code})`);
  });
  console.log(`360 MB into a job: ${told}`);
  assert.match(told, /\(studio\/out-of-memory\)$/);
  assert.equal(await projectText(page), before);
}

async function anyJobStopsAtOnce(page) {
  const before = await projectText(page);
  const slowest = await page.evaluate(async (text) => {
    const { session } = window.studio;
    const bytes = new TextEncoder().encode(text);
    const jobs = (await session.jobs()).map(({ name }) => [name, () => session.job(name, [], {})]);
    const all = [...jobs, ['open', () => session.open('other.obj', bytes)], ['search', () => session.search(true, () => undefined)],
      ['motion', () => session.motion(true, () => undefined)]];
    const took = [];
    for (const [name, start] of all) {
      await session.project(); // the worker is there
      const ended = start().then(() => 'done', (error) => (error.failure ? 'refused' : 'stopped'));
      while (!session.busy) await undefined;
      const from = performance.now();
      session.stop();
      if ((await ended) !== 'stopped') throw new Error(`${name} was not stopped but ${await ended}`);
      took.push([performance.now() - from, name]);
    }
    return took.sort((a, b) => b[0] - a[0])[0];
  }, mesh);
  console.log(`stopped after ${slowest[0].toFixed(1)} ms at most (${slowest[1]})`);
  assert.ok(slowest[0] < kAtOnce);
  assert.equal(await projectText(page), before);
}

async function longWorkIsStoppedByItsButton(page) {
  const before = await projectText(page);
  await page.evaluate(() => {
    const { session } = window.studio;
    window.ended = session.job('sample', [['name', 'dinosaur'], ['faces', '20000'], ['output', 'm.obj']], {})
      .then(({ files }) => session.open('large.obj', files['m.obj'])).then(() => 'done', (error) => (error.failure ? 'refused' : 'stopped'));
  });
  await page.waitForTimeout(1500);
  const took = await page.evaluate(async () => {
    const from = performance.now();
    window.studio.session.stop();
    return [await window.ended, performance.now() - from];
  });
  console.log(`opening 20,000 faces: ${took[0]} after ${took[1].toFixed(0)} ms`);
  assert.equal(took[0], 'stopped');
  assert.ok(took[1] < kAtOnce);
  assert.equal(await projectText(page), before);
}

async function aDeadTabLosesAtMostASecond(context, page) {
  const edges = await page.evaluate(() => [...Array(window.studio.session.shape.model.edges).keys()].filter((e) => !window.studio.session.shape.isBorder(e)));
  for (const edge of edges.slice(0, 5))
    await page.evaluate(async (e) => {
      const { session } = window.studio, edit = await session.editFor(e);
      if (edit) await session.edit('test', edit);
    }, edge);
  const before = await projectText(page);
  await page.waitForTimeout(1000);
  const crash = await context.newCDPSession(page);
  const died = page.waitForEvent('crash');
  crash.send('Page.crash').catch(() => undefined);
  await died;
  const next = await context.newPage();
  const complaints = complaintsOf(next);
  await openStudio(next, url);
  await next.click('#continue');
  await until(next, async (text) => {
    const { session } = window.studio;
    return session.shape && new TextDecoder().decode(await session.project()) === text; // edits are done again one by one
  }, before);
  assert.deepEqual(complaints, []);
  return next;
}

async function editsThatNoLongerFitAreTold(context, page) {
  await page.waitForTimeout(1000); // until what was done again is kept
  await page.evaluate(() => new Promise((done) => {
    const opening = indexedDB.open('plico-studio', 1);
    opening.onsuccess = () => {
      const writing = opening.result.transaction('projects', 'readwrite'), store = writing.objectStore('projects');
      store.get('current').onsuccess = ({ target }) => store.put({ id: target.result.id, edits: [{ edit: 'join', edge: 123456 }] }, 'edits');
      writing.oncomplete = done;
    };
  }));
  const next = await context.newPage();
  await openStudio(next, url);
  await isRefused(next, 'edits that no longer fit', () => next.click('#continue'));
  assert.match(await next.textContent('#verdict'), /verified|parts/);
}

async function withPage(change, use, at = url) {
  const context = await browser.newContext({ viewport: { width: 1000, height: 700 } });
  const page = await context.newPage();
  const complaints = complaintsOf(page);
  if (change) await page.addInitScript(change);
  await openStudio(page, at);
  await use(page, context);
  await context.close();
  return complaints;
}

async function aPageWithoutStorageWorks() {
  const changes = {
    'no IndexedDB': () => Object.defineProperty(window, 'indexedDB', { value: undefined }),
    'IndexedDB refused': () => (IDBFactory.prototype.open = () => { throw new DOMException('private', 'SecurityError'); }),
    'storage full': () => (IDBObjectStore.prototype.put = () => { throw new DOMException('full', 'QuotaExceededError'); }),
  };
  for (const [name, change] of Object.entries(changes)) {
    const complaints = await withPage(change, async (page) => {
      await drop(page, 'bird.obj', mesh);
      await page.waitForSelector('#verdict[data-status=good]');
      await page.waitForSelector('#unkept:not([hidden])');
      console.log(`${name}: ${await page.textContent('#unkept')}`);
    });
    assert.deepEqual(complaints, [], name);
  }
}

async function aPageThatMayNotRunWebAssemblySaysSo() {
  const path = join(folder, 'refused.html');
  writeFileSync(path, readFileSync(pagePath, 'utf8').replace("'wasm-unsafe-eval' ", ''));
  await withPage(undefined, async (page) => {
    await isRefused(page, 'wasm refused', () => drop(page, 'bird.obj', mesh));
    assert.match(await status(page), /studio\/no-webassembly/);
  }, pathToFileURL(path).href);
}

async function aPageWithoutWebGlWorks() {
  await browser.close();
  browser = await startBrowser(['--disable-gpu', '--disable-software-rasterizer']);
  const complaints = await withPage(undefined, async (page) => {
    await drop(page, 'bird.obj', mesh);
    await page.waitForSelector('#verdict[data-status=good]');
    await page.waitForSelector('#no-space:not([hidden])');
  });
  assert.deepEqual(complaints, []);
}

try {
  const complaints = await withPage(undefined, async (page, context) => {
    await drop(page, 'bird.obj', mesh);
    await page.waitForSelector('#verdict[data-status=good]');
    await badFilesAreTold(page);
    await unusualShapesBecomeNets(page);
    await namesAreText(page);
    await whatIsTooLargeIsTold(page);
    await aWorkerWithoutMemoryIsReplaced(page);
    await anyJobStopsAtOnce(page);
    await longWorkIsStoppedByItsButton(page);
    const next = await aDeadTabLosesAtMostASecond(context, page);
    await editsThatNoLongerFitAreTold(context, next);
  });
  assert.deepEqual(complaints, []);
  await aPageWithoutStorageWorks();
  await aPageThatMayNotRunWebAssemblySaysSo();
  await aPageWithoutWebGlWorks();
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
