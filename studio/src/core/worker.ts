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

// The engine compiles a function when it is called first, and better when it was called often. What the first file will
// call is called before, with a bumpy ball that nobody sees.
function ball(): string {
  const lines = ['v 0 0 1', 'v 0 0 -1'], n = 8;
  const corner = (ring: number, i: number): number => (ring === 0 ? 1 : ring === n ? 2 : 3 + (ring - 1) * n + (i % n));
  for (let ring = 1; ring < n; ++ring)
    for (let i = 0; i < n; ++i) {
      const u = (2 * Math.PI * i) / n, v = (Math.PI * ring) / n, r = 1 + 0.15 * Math.sin(3 * u + 2 * v);
      lines.push(`v ${r * Math.sin(v) * Math.cos(u)} ${r * Math.sin(v) * Math.sin(u)} ${r * Math.cos(v)}`);
    }
  for (let ring = 0; ring < n; ++ring)
    for (let i = 0; i < n; ++i) {
      if (ring > 0) lines.push(`f ${corner(ring, i)} ${corner(ring + 1, i)} ${corner(ring, i + 1)}`);
      if (ring + 1 < n) lines.push(`f ${corner(ring, i + 1)} ${corner(ring + 1, i)} ${corner(ring + 1, i + 1)}`);
    }
  return lines.join('\n');
}
function warm(all: Calls): void {
  all.open('warm.obj', new TextEncoder().encode(ball()));
  const edge = all.editFor(7);
  if (edge) all.preview(edge), all.apply(edge);
  all.apply(all.search(true));
  for (let i = 0; i < 8; ++i) all.search(true); // what is called often is compiled better
  all.motion(false);
  all.fold(0.5);
  all.project();
  close();
}

let calls: Promise<Calls>;
let current = 0, lastReport = 0;
function report(phase: string, done: number, total: number, note: string): void {
  const now = performance.now();
  if (now - lastReport < 100) return;
  lastReport = now;
  postMessage({ id: current, progress: { phase, done, total, note } } satisfies Reply);
}

async function begin(source: WebAssembly.Module | Promise<WebAssembly.Module>): Promise<Calls> {
  const module = await source;
  const plico = await new Promise((done, refuse) => {
    const instantiateWasm = (imports: WebAssembly.Imports, receive: (instance: WebAssembly.Instance) => void): object => {
      WebAssembly.instantiate(module, imports).then(receive, refuse);
      return {};
    };
    createPlico({ instantiateWasm, locateFile: (path: string) => path }).then(done, refuse);
  });
  return start(plico, report);
}

addEventListener('message', async (event: MessageEvent<Request | Begin>) => {
  if ('warm' in event.data) return warm(await begin(event.data.warm));
  if ('begin' in event.data) {
    calls = begin(event.data.begin);
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
