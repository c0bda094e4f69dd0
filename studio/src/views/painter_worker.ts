// The other end of painter.ts.
import { onceAFrame } from './frames';
import { kPainters, type ToPainter } from './painter';

let painter: Record<string, (...args: unknown[]) => void> | undefined;
let last: unknown[] = []; // only the last of several pictures that came meanwhile is drawn
const draw = onceAFrame(() => painter!['draw']!(...last));

addEventListener('message', ({ data }: MessageEvent<ToPainter>) => {
  if ('canvas' in data) {
    painter = kPainters[data.kind](data.canvas) as unknown as typeof painter;
    postMessage(painter !== undefined);
  } else if (!painter) return;
  else if (data.call !== 'draw') painter[data.call]!(...data.args);
  else last = data.args, draw();
});
