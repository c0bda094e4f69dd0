// Draws in a worker of its own: to open WebGL takes a fifth of a second where there is no graphics card, and the page must
// not wait for that.
import { GlMesh } from '../../../viewer/src/gl_mesh';
import { SheetPainter } from './sheet_painter';

export const kPainters = { mesh: (canvas: Canvas) => GlMesh.on(canvas), sheet: (canvas: Canvas) => SheetPainter.on(canvas) };

type Canvas = HTMLCanvasElement | OffscreenCanvas;
type Kind = keyof typeof kPainters;
type Methods<T> = { [Name in keyof T]: T[Name] }; // what is public, none of which answers
export type Painter<K extends Kind> = Methods<NonNullable<ReturnType<(typeof kPainters)[K]>>>;
export type ToPainter = { kind: Kind; canvas: OffscreenCanvas } | { call: string; args: unknown[] };

/** `works` is told whether there is WebGL 2. Where a canvas cannot go to a worker, the page draws by itself. */
export function painterOn<K extends Kind>(kind: K, canvas: HTMLCanvasElement, script: string, works: (fine: boolean) => void): Painter<K> | undefined {
  if (!('transferControlToOffscreen' in canvas)) {
    const painter = kPainters[kind](canvas);
    works(painter !== undefined);
    return painter as Painter<K> | undefined;
  }
  const worker = new Worker(URL.createObjectURL(new Blob([script], { type: 'text/javascript' })));
  worker.onmessage = ({ data }: MessageEvent<boolean>) => works(data);
  worker.onerror = () => works(false);
  const far = (canvas as HTMLCanvasElement).transferControlToOffscreen();
  worker.postMessage({ kind, canvas: far } satisfies ToPainter, [far]);
  const told = (call: string) => (...args: unknown[]): void => worker.postMessage({ call, args } satisfies ToPainter);
  return new Proxy({}, { get: (_, call) => told(call as string) }) as Painter<K>;
}
