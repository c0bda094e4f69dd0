// The worker: Plico's module, one model at a time.
import createPlico from 'plico-module';
import type { Begin, Calls, Edit, Failure, JobDescription, PackedModule, Reply, Request, Snapshot, Unpacked, Verdict } from './protocol';
import { unpacked } from './lzma';
import { decoded } from './text91';

const refused = (failure: Failure): Error => Object.assign(new Error(failure.message), { failure });

function parsed<T>(text: string): T {
  const value = JSON.parse(text) as T & { error?: Failure };
  if (value?.error) throw refused(value.error);
  return value;
}

function start(plico: any, report: (phase: string, done: number, total: number, note: string) => void): Calls {
  let editor = new plico.Editor();
  const snapshot = (verdict: Verdict): Snapshot => ({
    flat: editor.flatCorners(), folds: editor.folds(), locks: editor.locks(), parts: editor.parts(), verdict,
  });
  let verdict: Verdict;
  return {
    open(name, bytes) {
      const fresh = new plico.Editor();
      const summary = parsed<any>(fresh.open(bytes, name, report));
      editor.delete();
      editor = fresh;
      verdict = summary.verdict;
      const model = {
        ...summary, offsets: editor.offsets(), cornerEdges: editor.cornerEdges(), corners: editor.meshCorners(),
      };
      return { model, snapshot: snapshot(verdict) };
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
    project: () => editor.projectBytes(),
    mesh: () => editor.meshBytes(),
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
}

function failureOf(error: unknown): Failure {
  const known = (error as { failure?: Failure }).failure;
  return known ?? { code: 'internal', message: `the core stopped: ${String(error)}`, where: '', suggestion: 'reload the page' };
}

let calls: Promise<Calls>;
let current = 0, lastReport = 0;
function report(phase: string, done: number, total: number, note: string): void {
  const now = performance.now();
  if (now - lastReport < 100) return;
  lastReport = now;
  postMessage({ id: current, progress: { phase, done, total, note } } satisfies Reply);
}

function moduleOf({ text, packedBytes, bytes }: PackedModule): ArrayBuffer {
  const { buffer } = unpacked(decoded(text, packedBytes), bytes);
  postMessage({ module: buffer } satisfies Unpacked);
  return buffer;
}

async function begin(from: PackedModule | ArrayBuffer): Promise<Calls> {
  const wasmBinary = from instanceof ArrayBuffer ? from : moduleOf(from);
  return start(await createPlico({ wasmBinary, locateFile: (path: string) => path }), report);
}

addEventListener('message', async (event: MessageEvent<Request | Begin>) => {
  if ('begin' in event.data) {
    calls = begin(event.data.begin);
    calls.catch(() => undefined); // told to whoever asks
    return;
  }
  const { id, call, args } = event.data;
  try {
    const all = await calls;
    current = id;
    const result = (all[call] as (...args: unknown[]) => unknown)(...args);
    postMessage({ id, result } satisfies Reply);
  } catch (error) {
    postMessage({ id, failure: failureOf(error) } satisfies Reply);
  }
});
