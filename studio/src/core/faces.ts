// What the page needs to draw faces and to find what is under the pointer; the worker makes it once a model.
import type { Tables } from './protocol';

type Point = [number, number];

const cross = (a: Point, b: Point, c: Point): number => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

function contains(a: Point, b: Point, c: Point, p: Point): boolean {
  return cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;
}

/** Corner numbers of the triangles of one counter-clockwise polygon, by cutting ears. */
function ears(points: Point[]): number[] {
  const left = points.map((_, i) => i);
  const triangles: number[] = [];
  while (left.length > 3) {
    const n = left.length;
    const isEar = (i: number): boolean => {
      const [a, b, c] = [left[(i + n - 1) % n]!, left[i]!, left[(i + 1) % n]!];
      if (cross(points[a]!, points[b]!, points[c]!) <= 0) return false;
      return left.every((p) => p === a || p === b || p === c || !contains(points[a]!, points[b]!, points[c]!, points[p]!));
    };
    const found = left.findIndex((_, i) => isEar(i));
    const ear = found < 0 ? 1 : found; // degenerate: any will do
    triangles.push(left[(ear + n - 1) % n]!, left[ear]!, left[(ear + 1) % n]!);
    left.splice(ear, 1);
  }
  triangles.push(left[0]!, left[1]!, left[2]!);
  return triangles;
}

function triangulate(offsets: Int32Array, flat: Float32Array): { triangles: Uint32Array; triangleFaces: Uint32Array } {
  const faces = offsets.length - 1, count = offsets[faces]! - 2 * faces;
  const triangles = new Uint32Array(3 * count), triangleFaces = new Uint32Array(count);
  let at = 0;
  for (let f = 0; f < faces; ++f) {
    const start = offsets[f]!, corners = offsets[f + 1]! - start;
    triangleFaces.fill(f, at, at + corners - 2);
    if (corners === 3) {
      triangles[3 * at] = start, triangles[3 * at + 1] = start + 1, triangles[3 * at + 2] = start + 2;
    } else {
      const points = Array.from({ length: corners }, (_, i): Point => [flat[2 * (start + i)]!, flat[2 * (start + i) + 1]!]);
      triangles.set(ears(points).map((corner) => start + corner), 3 * at);
    }
    at += corners - 2;
  }
  return { triangles, triangleFaces };
}

function nextCorners(offsets: Int32Array): Uint32Array {
  const next = new Uint32Array(offsets[offsets.length - 1]!);
  for (let f = 0; f + 1 < offsets.length; ++f)
    for (let c = offsets[f]!; c < offsets[f + 1]!; ++c) next[c] = c + 1 === offsets[f + 1] ? offsets[f]! : c + 1;
  return next;
}

function cornersOfEdges(edges: number, cornerEdges: Int32Array): Int32Array {
  const corners = new Int32Array(2 * edges).fill(-1);
  cornerEdges.forEach((e, corner) => {
    corners[corners[2 * e]! < 0 ? 2 * e : 2 * e + 1] = corner;
  });
  return corners;
}

function faceOfCorners(offsets: Int32Array): Int32Array {
  const faces = new Int32Array(offsets[offsets.length - 1]!);
  for (let f = 0; f + 1 < offsets.length; ++f) faces.fill(f, offsets[f]!, offsets[f + 1]!);
  return faces;
}

export function tablesOf(edges: number, offsets: Int32Array, cornerEdges: Int32Array, flat: Float32Array): Tables {
  return {
    ...triangulate(offsets, flat), next: nextCorners(offsets), edgeCorners: cornersOfEdges(edges, cornerEdges),
    faceOf: faceOfCorners(offsets),
  };
}
