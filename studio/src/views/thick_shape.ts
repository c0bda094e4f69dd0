// A shape whose panels have a thickness: to be looked at. Corners are numbered as those of the shape, then once more for
// the other side.
import { Shape } from './shape';

export class ThickShape extends Shape {
  constructor(private readonly thin: Shape) {
    const { model, snapshot } = thin, corners = thin.next.length;
    const both = (of: ArrayLike<number>, more: number): number[] => [...Array.from(of), ...Array.from(of, (value) => value + more)];
    const walls: number[] = [], wallFaces: number[] = [];
    thin.next.forEach((n, c) => {
      walls.push(c, corners + c, corners + n, c, corners + n, n);
      wallFaces.push(thin.faceOf[c]!, thin.faceOf[c]!);
    });
    const sides = both(thin.triangles, corners), faces = both(thin.triangleFaces, 0);
    super({
      ...model, tables: {
        triangles: Uint32Array.from([...sides, ...walls]), triangleFaces: Uint32Array.from([...faces, ...wallFaces]), next: Uint32Array.from(both(thin.next, corners)),
        edgeCorners: thin.edgeCorners, faceOf: Int32Array.from(both(thin.faceOf, 0)),
      },
    }, snapshot);
  }

  /** Where its corners are when those of the shape are here: half the thickness to either side. */
  places(at: Float32Array, thickness: number): Float32Array {
    const all = new Float32Array(2 * at.length), { offsets } = this.thin.model;
    for (let f = 0; f + 1 < offsets.length; ++f) {
      const normal = normalOf(at, offsets[f]!, offsets[f + 1]!);
      for (let i = 3 * offsets[f]!; i < 3 * offsets[f + 1]!; ++i) {
        all[i] = at[i]! + (thickness / 2) * normal[i % 3]!;
        all[at.length + i] = at[i]! - (thickness / 2) * normal[i % 3]!;
      }
    }
    return all;
  }
  override lines(): { folds: Uint32Array; cuts: Uint32Array } {
    const { folds, cuts } = this.thin.lines(), corners = this.thin.next.length;
    const doubled = (ends: Uint32Array): Uint32Array => Uint32Array.from([...ends, ...ends.map((c) => c + corners)]);
    return { folds: doubled(folds), cuts: doubled(cuts) };
  }
}

/** Of one polygon in space, of length 1. */
function normalOf(at: Float32Array, begin: number, end: number): [number, number, number] {
  const normal: [number, number, number] = [0, 0, 0];
  for (let c = begin; c < end; ++c) {
    const p = 3 * c, q = 3 * (c + 1 < end ? c + 1 : begin);
    for (const k of [0, 1, 2] as const) normal[k] += (at[p + ((k + 1) % 3)]! - at[q + ((k + 1) % 3)]!) * (at[p + ((k + 2) % 3)]! + at[q + ((k + 2) % 3)]!);
  }
  const length = Math.hypot(...normal) || 1;
  return normal.map((x) => x / length) as [number, number, number];
}
