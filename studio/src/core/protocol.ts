// What the page and its worker say to each other. Arrays are per corner: all corners of face 0, then of face 1, ...
import type { JobDescription, JobOption } from '../../package/index';

export type { JobDescription, JobOption };

export type Edit =
  | { edit: 'cut' | 'join'; edge: number }
  | { edit: 'move'; join: number; cut: number }
  | { edit: 'lock'; edge: number; locked: boolean }
  | { edit: 'net'; folds: number[] };

export interface Verdict {
  valid: boolean;
  parts: number;
  overlaps: number;
  pairs: [number, number][]; // faces that overlap; at most 1,000
  defects: string[];
}

/** All that an edit may change. */
export interface Snapshot {
  flat: Float32Array; // x, y of every corner as it lies on the table
  folds: Uint8Array; // per edge
  locks: Uint8Array; // per edge
  parts: Int32Array; // per face
  verdict: Verdict;
}

export interface Model {
  name: string;
  faces: number;
  edges: number;
  vertices: number;
  notes: string[];
  offsets: Int32Array; // face f has corners offsets[f] .. offsets[f + 1]
  cornerEdges: Int32Array; // the edge from each corner to the next
  corners: Float32Array; // x, y, z of every corner of the mesh
  vertexOf: Int32Array; // of each corner
  tables: Tables;
}

/** What follows from the faces and stays through all edits. */
export interface Tables {
  triangles: Uint32Array; // three corners a triangle
  triangleFaces: Uint32Array; // the face of each triangle
  next: Uint32Array; // the next corner of the same face
  edgeCorners: Int32Array; // the two corners at which each edge starts in its faces; -1 for the second at a border
  faceOf: Int32Array; // of each corner
}

export interface MotionVerdict {
  method: string;
  verdict: 'free' | 'collides' | 'undecided' | 'not closed';
  from: number;
  to: number;
  panels: [number, number];
}

export interface JobResult {
  exit_code: number;
  report: Record<string, unknown>;
  messages: { tone: string; text: string }[];
  files: Record<string, Uint8Array>; // what it wrote
}

export type JobValues = [string, string][];

/** Of the explicit method; what is left out is as the command line has it. */
export interface InflateOptions {
  pressure: number; max_growth: number; time_step: number; stiffness: number; stiff_edges: number; anchors: number;
  deep_angle_deg: number; constrained: boolean; max_steps: number; keep: number[]; keep_vertices: number[];
}
export interface Inflated {
  steps: number; hyperbolic: number; hyperbolic_before: number; growth: number; largest_move: number; ended: boolean; limit: string;
  corners: Float32Array; // of the mesh as it is now
  hyperbolicCorners: Uint8Array; // of each corner whether its vertex is hyperbolic
}

export interface Calls {
  open(name: string, bytes: Uint8Array): { model: Model; snapshot: Snapshot };
  editFor(edge: number): Edit | null;
  preview(edit: Edit): { flat: Float32Array; verdict: Verdict };
  apply(edit: Edit): { inverse: Edit; snapshot: Snapshot };
  search(folds: boolean): Edit;
  arrange(): Snapshot;
  motion(plan: boolean): MotionVerdict;
  fold(time: number): Float32Array;
  play(name: string, bytes: Uint8Array): { model: Model; snapshot: Snapshot }; // FOLD
  playAt(time: number): Float32Array;
  project(): Uint8Array;
  mesh(): Uint8Array; // OBJ
  inflateBegin(options: InflateOptions): Inflated;
  inflateStep(): Inflated; // ten steps of time, or fewer at the end
  inflatedMesh(): Uint8Array; // OBJ
  jobs(): JobDescription[];
  net(): Uint8Array; // FOLD, with the motion if it is proven
  job(name: string, values: JobValues, files: Record<string, Uint8Array>): JobResult;
}

export interface Failure {
  code: string;
  message: string;
  where: string;
  suggestion: string;
  exit_code?: number;
}

export interface Progress {
  phase: string;
  done: number;
  total: number;
  note: string;
}

/** The worker's script and after it the module, as the page holds them: LZMA in text93. */
export interface Packed {
  text: string;
  packedBytes: number;
  bytes: number;
  scriptBytes: number;
}
/** What the loader sends back: later workers need no loader, and go on with all that the engine has compiled. */
export interface Unpacked {
  script: string;
  module: WebAssembly.Module;
}
/** What a worker begins with, or only warms up for the others. */
export type Begin = { begin: WebAssembly.Module | Promise<WebAssembly.Module> } | { warm: WebAssembly.Module };

export type Request = { id: number; call: keyof Calls; args: unknown[] };
/** `ended`: this worker can do no more. */
export type Reply = { id: number } & ({ result: unknown } | { failure: Failure; ended: boolean } | { progress: Progress });
