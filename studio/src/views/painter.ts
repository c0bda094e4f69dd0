// Draws in a worker of its own: to open WebGL takes a fifth of a second where there is no graphics card, and the page must
// not wait for that.
import { GlMesh } from '../../../viewer/src/gl_mesh';

export type MeshPainter = Pick<GlMesh, 'setPlaces' | 'setMarks' | 'setTriangles' | 'setLines' | 'draw'>;
export type ToPainter = { canvas: OffscreenCanvas } | { call: keyof MeshPainter; args: unknown[] };

/** `works` is told whether there is WebGL 2. Where a canvas cannot go to a worker, the page draws by itself. */
export function painterOn(canvas: HTMLCanvasElement, script: string, works: (fine: boolean) => void): MeshPainter | undefined {
  if (!('transferControlToOffscreen' in canvas)) {
    const mesh = GlMesh.on(canvas);
    works(mesh !== undefined);
    return mesh;
  }
  const worker = new Worker(URL.createObjectURL(new Blob([script], { type: 'text/javascript' })));
  worker.onmessage = ({ data }: MessageEvent<boolean>) => works(data);
  worker.onerror = () => works(false);
  const far = (canvas as HTMLCanvasElement).transferControlToOffscreen();
  worker.postMessage({ canvas: far } satisfies ToPainter, [far]);
  const told = (call: keyof MeshPainter) => (...args: unknown[]): void => worker.postMessage({ call, args } satisfies ToPainter);
  return {
    setPlaces: told('setPlaces'), setMarks: told('setMarks'), setTriangles: told('setTriangles'), setLines: told('setLines'), draw: told('draw'),
  };
}
