// The first worker: unpacks its own script and the module, and goes on as worker.ts.
/// <reference lib="webworker.importscripts" />
import type { Begin, Packed, Unpacked } from './protocol';
import { unpacked } from './lzma';
import { decoded } from './text93';

addEventListener('message', ({ data: { text, packedBytes, bytes, scriptBytes } }: MessageEvent<Packed>) => {
  const all = unpacked(decoded(text, packedBytes), bytes);
  const script = new TextDecoder().decode(all.subarray(0, scriptBytes)), module = WebAssembly.compile(all.subarray(scriptBytes));
  importScripts(URL.createObjectURL(new Blob([script], { type: 'text/javascript' })));
  dispatchEvent(new MessageEvent('message', { data: { begin: module } satisfies Begin }));
  module.then((compiled) => postMessage({ script, module: compiled } satisfies Unpacked), () => undefined); // worker.ts tells why
}, { once: true });
