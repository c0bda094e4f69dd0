/** An option of a job. */
export interface JobOption {
  /** With its dashes; a positional has none. */
  name: string;
  /** What stands for the value, as "FILE" or "N"; empty for a flag. */
  value: string;
  /** Of a plain number: "mm", "deg", "s"; empty where there is none. */
  unit: string;
  default: string;
  /** Empty: any value. */
  choices: string[];
  help: string;
  positional: boolean;
  required: boolean;
  repeatable: boolean;
  /** Bounds of a number, in its unit, with the words of JSON Schema. */
  minimum?: number;
  exclusiveMinimum?: number;
  maximum?: number;
  exclusiveMaximum?: number;
}

export interface JobDescription {
  /** One word or two: "unfold", "origami make". */
  name: string;
  summary: string;
  /** Command lines, and what they do. */
  examples: [string, string][];
  options: JobOption[];
}

/** Options by name, with or without dashes; numbers are in the option's unit, a list repeats the option. */
export type Values = Record<string, string | number | boolean | readonly (string | number)[]>;

export interface Message {
  tone: 'result' | 'line' | 'detail' | 'warning';
  text: string;
}

export interface JobResult {
  /** 0 done and verified; 1 the answer is no; 5 time limit, the best so far is there. */
  exitCode: number;
  /** What `--json` prints on the command line. */
  report: Record<string, unknown>;
  messages: Message[];
  /** What the job wrote, by path. */
  files: Record<string, Uint8Array>;
}

/** `total` is 0 when nobody knows it. */
export type OnProgress = (phase: string, done: number, total: number, note: string) => void;

/** Input that cannot be used, or a wrong option. */
export declare class PlicoError extends Error {
  /** Stable, for programs: "mesh/edge-with-three-faces". */
  readonly code: string;
  readonly where: string;
  readonly suggestion: string;
  /** 2 usage, 3 input, 4 file, 70 a bug, 71 out of memory. */
  readonly exitCode: number;
}

export interface Plico {
  readonly version: string;
  readonly jobs: JobDescription[];
  /**
   * Runs a job to its end: same input and seed, same bytes as the command line. It blocks, so pages call it in a worker.
   * Throws PlicoError.
   */
  run(job: string, values?: Values, files?: Record<string, Uint8Array | string>, onProgress?: OnProgress): JobResult;
}

export interface CreateOptions {
  /** The bytes of plico.wasm; without them it is read, or fetched, from beside this module. */
  wasm?: ArrayBuffer | Uint8Array;
}

/** A module of its own, with its own memory (at most 1 GiB). */
export declare function createPlico(options?: CreateOptions): Promise<Plico>;
