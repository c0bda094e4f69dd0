// node build_page.mjs ESBUILD MODULE_FOLDER OUTPUT: the studio as one HTML file, with plico.wasm of MODULE_FOLDER inside.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const [esbuild, modules, output] = process.argv.slice(2);
const source = join(dirname(fileURLToPath(import.meta.url)), 'src');

function bundle(entry, format) {
  const text = execFileSync(esbuild, [join(source, entry), '--bundle', '--minify', '--target=es2022', '--charset=utf8',
    '--log-level=error', `--format=${format}`, `--alias:plico-module=${join(modules, 'plico.mjs')}`], { maxBuffer: 1 << 26 });
  // What ends a script element must not stand in one.
  return text.toString().replaceAll('</script', '<\\/script');
}

const script = bundle('main.ts', 'iife');
const hash = createHash('sha256').update(script).digest('base64');
const policy = "default-src 'none'; script-src 'sha256-HASH' 'wasm-unsafe-eval' blob:; worker-src blob:; img-src data: blob:; " +
  "style-src 'unsafe-inline'; connect-src 'none'; base-uri 'none'; form-action 'none'";
const parts = {
  POLICY: policy.replace('HASH', hash),
  STYLE: readFileSync(join(source, 'style.css'), 'utf8'),
  WASM: gzipSync(readFileSync(join(modules, 'plico.wasm')), { level: 9 }).toString('base64'),
  WORKER: bundle('core/worker.ts', 'iife'),
  FILE: 'null',
  SCRIPT: script,
};
writeFileSync(output, readFileSync(join(source, 'page.html'), 'utf8').replace(/@([A-Z]+)@/g, (all, name) => parts[name] ?? all));
