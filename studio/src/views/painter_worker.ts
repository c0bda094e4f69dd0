// The other end of painter.ts.
import { GlMesh } from '../../../viewer/src/gl_mesh';
import { onceAFrame } from './frames';
import type { ToPainter } from './painter';

let mesh: GlMesh | undefined;
let last: unknown[] = []; // only the last of several pictures that came meanwhile is drawn
const call = (name: string, args: unknown[]): void => (mesh as unknown as Record<string, (...args: unknown[]) => void>)[name]!(...args);
const draw = onceAFrame(() => call('draw', last));

addEventListener('message', ({ data }: MessageEvent<ToPainter>) => {
  if ('canvas' in data) {
    mesh = GlMesh.on(data.canvas);
    postMessage(mesh !== undefined);
  } else if (!mesh) return;
  else if (data.call !== 'draw') call(data.call, data.args);
  else last = data.args, draw();
});
