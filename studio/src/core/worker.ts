// The worker: Plico's module, one model at a time.
import createPlico from 'plico-module';
import type { Begin, Calls, Edit, Failure, Inflated, JobDescription, Reply, Request, Snapshot, Verdict } from './protocol';
import { tablesOf } from './faces';

const refused = (failure: Failure): Error => Object.assign(new Error(failure.message), { failure });

function parsed<T>(text: string): T {
  const value = JSON.parse(text) as T & { error?: Failure };
  if (value?.error) throw refused(value.error);
  return value;
}

// Of what is only looked at.
const kNoVerdict: Verdict = { valid: true, parts: 0, overlaps: 0, pairs: [], defects: [] };

function start(plico: any, report: (phase: string, done: number, total: number, note: string) => void): Calls {
  let editor = new plico.Editor();
  let isOpen = false;
  const player = new plico.MotionPlayer();
  const snapshot = (verdict: Verdict): Snapshot => ({
    flat: editor.flatCorners(), folds: editor.folds(), locks: editor.locks(), parts: editor.parts(), verdict,
  });
  const inflated = (facts: string): Inflated => ({
    ...parsed<any>(facts), corners: editor.inflatedCorners(), hyperbolicCorners: editor.hyperbolicCorners(),
  });
  let verdict: Verdict;
  const calls: Calls = {
    open(name, bytes) {
      const fresh = new plico.Editor();
      const summary = parsed<any>(fresh.open(bytes, name, report));
      editor.delete();
      editor = fresh;
      verdict = summary.verdict;
      isOpen = true;
      const first = snapshot(verdict), offsets = editor.offsets(), cornerEdges = editor.cornerEdges();
      const tables = tablesOf(summary.edges, offsets, cornerEdges, first.flat);
      return { model: { ...summary, offsets, cornerEdges, corners: editor.meshCorners(), vertexOf: editor.vertices(), tables }, snapshot: first };
    },
    editFor: (edge) => parsed<Edit | null>(editor.editFor(edge)),
    preview(edit) {
      const corners: Float32Array[] = [];
      const seen = parsed<Verdict>(editor.preview(JSON.stringify(edit), corners));
      return { flat: corners[0]!, verdict: seen };
    },
    apply(edit) {
      const done = parsed<{ inverse: Edit; verdict: Verdict }>(editor.apply(JSON.stringify(edit)));
      verdict = done.verdict;
      return { inverse: done.inverse, snapshot: snapshot(verdict) };
    },
    search: (folds) => parsed<{ edit: Edit }>(editor.search(folds, report)).edit,
    arrange() {
      editor.arrange();
      return snapshot(verdict);
    },
    motion: (plan) => parsed(editor.motion(plan, report)),
    fold: (time) => editor.foldedCorners(time),
    play(name, bytes) {
      const facts = parsed<{ faces: number; edges: number }>(player.open(bytes, name));
      const offsets: Int32Array = player.offsets(), cornerEdges: Int32Array = player.cornerEdges(), flat: Float32Array = player.flatCorners();
      const tables = tablesOf(facts.edges, offsets, cornerEdges, flat), folds = Uint8Array.from({ length: facts.edges }, (_, e) => Number(tables.edgeCorners[2 * e + 1]! >= 0));
      const model = { ...facts, name, vertices: 0, notes: [], offsets, cornerEdges, corners: player.cornersAt(0), vertexOf: new Int32Array(cornerEdges.length), tables };
      return { model, snapshot: { flat, folds, locks: new Uint8Array(facts.edges), parts: new Int32Array(facts.faces), verdict: kNoVerdict } };
    },
    playAt: (time) => player.cornersAt(time),
    project: () => editor.projectBytes(),
    mesh: () => editor.meshBytes(),
    inflateBegin: (options) => inflated(editor.inflateBegin(JSON.stringify(options))),
    inflateStep: () => inflated(editor.inflateStep()),
    inflatedMesh: () => editor.inflatedBytes(),
    jobs: () => JSON.parse(plico.describeJobs()) as JobDescription[],
    net: () => editor.foldBytes(),
    job(name, values, files) {
      const workspace = new plico.Workspace();
      try {
        for (const [path, bytes] of Object.entries(files)) workspace.put(path, bytes);
        const result = parsed<any>(workspace.run(name, JSON.stringify(values), report));
        const written = (JSON.parse(workspace.list()) as string[]).filter((path) => !(path in files));
        return { ...result, files: Object.fromEntries(written.map((path) => [path, workspace.get(path)])) };
      } finally {
        workspace.delete();
      }
    },
  };
  const needsNone = new Set<keyof Calls>(['open', 'jobs', 'job', 'play', 'playAt']);
  return new Proxy(calls, {
    get(all, name: keyof Calls) {
      if (!isOpen && name in all && !needsNone.has(name)) throw refused({ code: 'studio/nothing-open', message: 'nothing is open', where: '', suggestion: 'open a file' });
      return all[name];
    },
  });
}

// Memory that was taken is never given back, and a module that trapped is in no known state: both end this worker.
const kOutOfMemory = 71; // an exit code
function failureOf(error: unknown): { failure: Failure; ended: boolean } {
  const known = (error as { failure?: Failure }).failure;
  if (known && known.exit_code !== kOutOfMemory) return { failure: known, ended: false };
  // Where files cross, nothing of C++ throws but for want of memory; all else comes back as a value.
  const isOfCpp = error instanceof (WebAssembly as unknown as { Exception: new () => object }).Exception;
  const hadNoMemory = known || error instanceof RangeError || isOfCpp;
  const failure = hadNoMemory
    ? { code: 'studio/out-of-memory', message: 'this takes more memory than a page has', where: '', suggestion: 'fewer faces (plico simplify), or the command line' }
    : { code: 'studio/core-stopped', message: `the core stopped, your document is kept: ${String(error)}`, where: '', suggestion: 'something else' };
  return { failure, ended: true };
}
const notStarted = (error: unknown): Error => refused({
  code: 'studio/no-webassembly', message: `the core did not start: ${String(error)}`, where: '', suggestion: 'a browser that runs WebAssembly',
});

/** Arrays that go over to the page instead of being copied: each is made for its answer. */
function arraysIn(value: unknown, found = new Set<ArrayBuffer>()): ArrayBuffer[] {
  if (ArrayBuffer.isView(value)) found.add(value.buffer as ArrayBuffer);
  else if (value && typeof value === 'object' && !Array.isArray(value)) for (const part of Object.values(value)) arraysIn(part, found);
  return [...found];
}

// The engine compiles a function when it is called first. What the first file will call is called once before, with
// shapes that nobody sees: a bumpy torus and a tetrahedron.
const kTetrahedron = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n';
function torus(): string {
  const lines: string[] = [], n = 8;
  const corner = (i: number, j: number): number => 1 + (i % n) * n + (j % n);
  for (let i = 0; i < n; ++i)
    for (let j = 0; j < n; ++j) {
      const u = (2 * Math.PI * i) / n, v = (2 * Math.PI * j) / n, r = 3 + (1 + 0.2 * Math.sin(3 * u + v)) * Math.cos(v);
      lines.push(`v ${r * Math.cos(u)} ${r * Math.sin(u)} ${Math.sin(v)}`);
    }
  for (let i = 0; i < n; ++i)
    for (let j = 0; j < n; ++j)
      lines.push(`f ${corner(i, j)} ${corner(i + 1, j)} ${corner(i + 1, j + 1)}`, `f ${corner(i, j)} ${corner(i + 1, j + 1)} ${corner(i, j + 1)}`);
  return lines.join('\n');
}
/** Call by call, so that one of the page's never waits long. */
function* warming(plico: any): Generator {
  const all = start(plico, () => undefined), bytes = (text: string): Uint8Array => new TextEncoder().encode(text);
  yield all.open('warm.obj', bytes(torus()));
  const edge = all.editFor(7);
  if (edge) yield all.preview(edge), yield all.apply(edge);
  yield all.open('warm.obj', bytes(kTetrahedron));
  const net = all.search(true);
  yield all.apply(net);
  yield all.motion(false);
  yield all.fold(0.5);
  yield all.project();
}
async function warm(plico: any): Promise<void> {
  for (const _ of warming(plico)) await new Promise((done) => setTimeout(done));
}

let calls: Promise<Calls>;
let current = 0, lastReport = 0;
function report(phase: string, done: number, total: number, note: string): void {
  const now = performance.now();
  if (now - lastReport < 100) return;
  lastReport = now;
  postMessage({ id: current, progress: { phase, done, total, note } } satisfies Reply);
}

async function begin({ begin: wasmBinary, isFirst }: Begin): Promise<Calls> {
  const plico = await createPlico({ wasmBinary, locateFile: (path: string) => path });
  if (isFirst) setTimeout(() => void warm(plico));
  return start(plico, report);
}

addEventListener('message', async (event: MessageEvent<Request | Begin>) => {
  if ('begin' in event.data) {
    calls = begin(event.data);
    calls.catch(() => undefined); // told to whoever asks
    return;
  }
  const { id, call, args } = event.data;
  try {
    const all = await calls.catch((error) => Promise.reject(notStarted(error)));
    current = id;
    const result = (all[call] as (...args: unknown[]) => unknown)(...args);
    postMessage({ id, result } satisfies Reply, { transfer: arraysIn(result) });
  } catch (error) {
    postMessage({ id, ...failureOf(error) } satisfies Reply);
  }
});
