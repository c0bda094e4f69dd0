// Plico's jobs for Node and browsers; the types and their words are in index.d.ts.
// @ts-check
import createModule from './plico.mjs';

export class PlicoError extends Error {
  /** @param {{code: string, message: string, where: string, suggestion: string, exit_code: number}} told */
  constructor({ code, message, where, suggestion, exit_code }) {
    super(message);
    this.name = 'PlicoError';
    this.code = code;
    this.where = where;
    this.suggestion = suggestion;
    this.exitCode = exit_code;
  }
}

async function besideThis() {
  const url = new URL('plico.wasm', import.meta.url);
  if (url.protocol !== 'file:') return new Uint8Array(await (await fetch(url)).arrayBuffer());
  const { readFile } = await import('node:fs/promises');
  return new Uint8Array(await readFile(url));
}

/**
 * @param {import('./index.js').Values} values
 * @returns {[string, string][]}
 */
function pairs(values) {
  /** @type {(value: unknown) => string[]} */
  const texts = (value) => (Array.isArray(value) ? value.map(String) : value === false ? [] : [String(value)]);
  return Object.entries(values).flatMap(([name, value]) => texts(value).map((text) => /** @type {[string, string]} */ ([name, text])));
}

/** @param {import('./index.js').CreateOptions} [options] */
export async function createPlico({ wasm } = {}) {
  const module = await createModule({ wasmBinary: wasm ?? (await besideThis()), locateFile: (/** @type {string} */ path) => path });
  const encoder = new TextEncoder();

  /** @type {import('./index.js').Plico['run']} */
  function run(job, values = {}, files = {}, onProgress = undefined) {
    const workspace = new module.Workspace();
    try {
      for (const [path, bytes] of Object.entries(files)) workspace.put(path, typeof bytes === 'string' ? encoder.encode(bytes) : bytes);
      const told = JSON.parse(workspace.run(job, JSON.stringify(pairs(values)), onProgress));
      if (told.error) throw new PlicoError(told.error);
      const written = JSON.parse(workspace.list()).filter((/** @type {string} */ path) => !(path in files));
      return {
        exitCode: told.exit_code, report: told.report, messages: told.messages,
        files: Object.fromEntries(written.map((/** @type {string} */ path) => [path, workspace.get(path)])),
      };
    } finally {
      workspace.delete();
    }
  }
  return { version: module.version(), jobs: JSON.parse(module.describeJobs()), run };
}
