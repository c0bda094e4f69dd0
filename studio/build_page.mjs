// node build_page.mjs ESBUILD MODULE_FOLDER OUTPUT: the studio as one HTML file, with the module of MODULE_FOLDER inside.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [esbuild, modules, output] = process.argv.slice(2);
const source = join(dirname(fileURLToPath(import.meta.url)), 'src');

function bundle(entry, format) {
  const text = execFileSync(esbuild, [join(source, entry), '--bundle', '--minify', '--target=es2022', '--charset=utf8',
    '--log-level=error', `--format=${format}`, `--alias:plico-module=${join(modules, 'plico.mjs')}`], { maxBuffer: 1 << 26 });
  // What ends a script element must not stand in one.
  return text.toString().replaceAll('</script', '<\\/script');
}

// What src/core/text93.ts reads; the last two characters may hold more bits than there are.
function text93(bytes) {
  const digits = [...Array(94).keys()].map((i) => String.fromCharCode(33 + i)).filter((c) => c !== '<');
  const text = [];
  let bits = 0, held = 0;
  const write = (pair) => text.push(digits[pair % 93], digits[Math.floor(pair / 93)]);
  for (const byte of bytes) {
    bits |= byte << held;
    held += 8;
    if (held <= 13) continue;
    const short = (bits & 8191) > 456;
    write(bits & (short ? 8191 : 16383));
    bits >>>= short ? 13 : 14;
    held -= short ? 13 : 14;
  }
  if (held) write(bits);
  return text.join('');
}

const script = bundle('main.ts', 'iife');
const hash = createHash('sha256').update(script).digest('base64');
const policy = "default-src 'none'; script-src 'sha256-HASH' 'wasm-unsafe-eval' blob:; worker-src blob:; img-src data: blob:; " +
  "style-src 'unsafe-inline'; connect-src 'none'; base-uri 'none'; form-action 'none'";
// No position bits: code of this kind has no rhythm of 4 or 8 bytes.
const worker = Buffer.from(bundle('core/worker.ts', 'iife')), core = Buffer.concat([worker, readFileSync(join(modules, 'plico.wasm'))]);
const packed = execFileSync('xz', ['--format=lzma', '--lzma1=preset=9e,lc=4,lp=0,pb=0', '--stdout'], { input: core, maxBuffer: 1 << 26 });
const parts = {
  POLICY: policy.replace('HASH', hash),
  STYLE: execFileSync(esbuild, ['--minify', '--log-level=error', join(source, 'style.css')]).toString(),
  CORE: text93(packed),
  PACKED: String(packed.length),
  BYTES: String(core.length),
  SCRIPTBYTES: String(worker.length),
  LOADER: bundle('core/loader.ts', 'iife'),
  PAINTER: bundle('views/painter_worker.ts', 'iife'),
  FILE: 'null',
  SCRIPT: script,
};
writeFileSync(output, readFileSync(join(source, 'page.html'), 'utf8').replace(/@([A-Z]+)@/g, (all, name) => parts[name] ?? all));
