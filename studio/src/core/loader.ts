// The first worker: unpacks its own script and the module, and goes on as worker.ts.
/// <reference lib="webworker.importscripts" />
import type { Begin, Packed, Unpacked } from './protocol';
import { unpacked } from './lzma';
import { decoded } from './text93';

addEventListener('message', ({ data: { text, packedBytes, bytes, scriptBytes } }: MessageEvent<Packed>) => {
  const all = unpacked(decoded(text, packedBytes), bytes);
  const script = new TextDecoder().decode(all.subarray(0, scriptBytes)), module = all.slice(scriptBytes).buffer;
  postMessage({ script, module } satisfies Unpacked);
  importScripts(URL.createObjectURL(new Blob([script], { type: 'text/javascript' })));
  dispatchEvent(new MessageEvent('message', { data: { begin: module, isFirst: true } satisfies Begin }));
}, { once: true });
