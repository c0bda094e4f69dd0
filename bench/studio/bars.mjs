// The studio's performance bars in a browser without a screen (software drawing): JSON on standard output.
// usage: node bars.mjs PAGE.html [MESH...]; playwright-core must be found, as in build/wasm/studio-tests.
// Without meshes, dinosaurs of 128, 312, 1376 and 20,000 faces. Median of RUNS (9) fresh pages a mesh, a third of them
// at 20,000.
import { readFileSync, statSync } from 'node:fs';
import { basename } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import { chromium } from 'playwright-core';

const [pagePath, ...meshPaths] = process.argv.slice(2);
const kRuns = Number(process.env.RUNS ?? 9);
const kLarge = 5000; // faces

// Bars by what is measured and by size class; milliseconds.
const kBars = {
  'open, ready to drop': [500, 500, 500, 500], 'drop, net drawn': [100, 120, 200, 4000], 'net and proven linear motion, cold': [200, 500, null, null],
  'click, judged and drawn': [16, 16, 16, 60], 'slider frame': [16, 16, 16, 33], undo: [16, 16, 16, 60],
  'inflation frame': [16, 16, 16, 16], 'a Miura of 24 x 24, a frame': [16, 16, 16, 16], 'a search, stopped': [200, 200, 200, 200], 'main thread blocked at most': [50, 50, 50, 50],
};
const classOf = (faces) => (faces <= 200 ? 0 : faces <= 700 ? 1 : faces <= kLarge ? 2 : 3);
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run',
    '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});

async function openPage() {
  const page = await (await browser.newContext({ viewport: { width: 1280, height: 820 } })).newPage();
  await page.addInitScript(() => {
    window.longest = 0;
    new PerformanceObserver((list) => { for (const task of list.getEntries()) window.longest = Math.max(window.longest, task.duration); }).observe({ entryTypes: ['longtask'] });
    new MutationObserver(() => { if (document.documentElement?.dataset.ready) window.readyAt ??= performance.now(); }).observe(document, { attributes: true, subtree: true });
  });
  await page.goto(pathToFileURL(pagePath).href);
  await page.waitForSelector('html[data-ready=true]');
  return page;
}

async function samples() {
  const page = await openPage();
  const meshes = [];
  for (const faces of [128, 312, 1376, 20000]) {
    const bytes = await page.evaluate(async (n) => {
      const { files } = await window.studio.session.job('sample', [['name', 'dinosaur'], ['faces', String(n)], ['output', 'm.obj']], {});
      return [...files['m.obj']];
    }, faces);
    meshes.push({ name: `dinosaur-${faces}`, bytes: Buffer.from(bytes) });
  }
  await page.context().close();
  return meshes;
}

async function timesOf(mesh) {
  const page = await openPage();
  const text = mesh.bytes.toString('latin1');
  const times = await page.evaluate(async ({ name, text }) => {
    const { session } = window.studio;
    const bytes = Uint8Array.from(text, (c) => c.charCodeAt(0));
    const drawn = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const time = async (work) => {
      const start = performance.now();
      await work();
      return performance.now() - start;
    };
    const several = async (n, work) => {
      const all = [];
      for (let i = 0; i < n; ++i) all.push(await time(() => work(i)));
      return all.sort((a, b) => a - b)[n >> 1];
    };
    const times = { 'open, ready to drop': window.readyAt };
    await session.mesh().catch(() => undefined); // nothing is open, says the module when it is there
    times['the module is there'] = performance.now();
    await new Promise((done) => setTimeout(done, 2000)); // nobody drops a file in the first seconds; but see atOnce()
    window.longest = 0;
    times['drop, net drawn'] = await time(async () => (await session.open(name, bytes), await new Promise(requestAnimationFrame)));
    const faces = session.shape.model.faces;
    const inside = [...Array(session.shape.model.edges).keys()].filter((e) => !session.shape.isBorder(e));
    const count = faces > 5000 ? 9 : 31;
    // Without the wait for the next frame, which is the screen's and not ours.
    times['click, judged and drawn'] = await several(count, async (i) => {
      const edge = inside[(i * 37) % inside.length];
      const edit = await session.editFor(edge);
      if (edit) await session.edit('bench', edit);
    });
    times.undo = await several(count >> 1, () => session.undo());
    while (await session.undo());
    times['slider frame'] = await several(count, (i) => session.fold(i / count));
    // Short steps where edges are short: an inflation that has come to its end takes no time.
    const inflating = { pressure: 0.1, max_growth: 5, time_step: faces > 5000 ? 0.001 : 0.01, stiffness: 1, stiff_edges: 10, anchors: 0.05, deep_angle_deg: 70, constrained: true, max_steps: 1e5, keep: [], keep_vertices: [] };
    if (await session.inflateBegin(inflating).then(() => true, () => false)) { // ten steps of time and a look for faces that meet
      let ended = false;
      times['inflation frame'] = await several(9, async () => (ended ||= (await session.inflateStep()).ended));
      if (ended) delete times['inflation frame'];
    }
    const { files } = await session.job('origami make', [['name', 'miura'], ['size', '24x24'], ['output', 'miura.fold']], {});
    const miura = { name: 'miura.fold', bytes: files['miura.fold'] };
    await session.play(miura);
    times['a Miura of 24 x 24, a frame'] = await several(31, (i) => session.playAt(i / 31, miura));
    await drawn();
    times['main thread blocked at most'] = window.longest;
    times['a search, stopped'] = await time(async () => {
      const ended = session.search(true, () => undefined).catch(() => undefined);
      while (!session.busy) await undefined;
      session.stop();
      await ended;
    });
    await session.project(); // a new worker stands where the old one did
    if (faces < 700)
      times['net and proven linear motion, cold'] = await time(async () => {
        await session.edit('bench', await session.search(true, () => undefined));
        times.verdict = (await session.motion(false, () => undefined)).verdict;
      });
    return { faces, times };
  }, { name: `${mesh.name}.obj`, text });
  await page.context().close();
  return times;
}

/** A file that is dropped before the module is there: from the beginning of the page to the net. */
async function atOnce({ name, bytes }) {
  const page = await openPage();
  const ms = await page.evaluate(async ({ name, text }) => {
    await window.studio.session.open(name, Uint8Array.from(text, (c) => c.charCodeAt(0)));
    await new Promise(requestAnimationFrame);
    return performance.now();
  }, { name: `${name}.obj`, text: bytes.toString('latin1') });
  await page.context().close();
  return ms;
}

const meshes = meshPaths.length
  ? meshPaths.map((path) => ({ name: basename(path).replace(/\..*$/, ''), bytes: readFileSync(path) })) : await samples();
const rows = [];
for (const mesh of meshes) {
  const all = [];
  do {
    const measured = await timesOf(mesh);
    measured.times['page opened, net of a file dropped at once'] = await atOnce(mesh);
    all.push(measured);
  } while (all.length < (all[0].faces > kLarge ? Math.ceil(kRuns / 3) : kRuns));
  const [first] = all;
  for (const what of Object.keys(first.times).filter((key) => typeof first.times[key] === 'number')) {
    const bar = kBars[what]?.[classOf(first.faces)] ?? null;
    const ms = Math.round(10 * median(all.map(({ times }) => times[what]))) / 10;
    rows.push({ mesh: mesh.name, faces: first.faces, what, ms, bar_ms: bar, held: bar === null ? null : ms <= bar });
  }
}
await browser.close();
const size = statSync(pagePath).size, zipped = gzipSync(readFileSync(pagePath)).length;
console.log(JSON.stringify({
  browser: `chromium ${browser.version()}, software drawing`, runs: kRuns,
  page: { bytes: size, bar_bytes: 1.6e6, gzip_bytes: zipped, bar_gzip_bytes: 750e3 }, rows,
}, null, 2));
