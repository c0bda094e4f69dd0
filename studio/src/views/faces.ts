// Faces as triangles, for drawing and for finding what is under the pointer.

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

/** Three corners a triangle, and the face of each triangle. */
export function triangulate(offsets: Int32Array, flat: Float32Array): { corners: Uint32Array; faces: Uint32Array } {
  const corners: number[] = [], faces: number[] = [];
  for (let f = 0; f + 1 < offsets.length; ++f) {
    const start = offsets[f]!, count = offsets[f + 1]! - start;
    const points = Array.from({ length: count }, (_, i): Point => [flat[2 * (start + i)]!, flat[2 * (start + i) + 1]!]);
    for (const corner of count === 3 ? [0, 1, 2] : ears(points)) corners.push(start + corner);
    for (let i = 0; i < count - 2; ++i) faces.push(f);
  }
  return { corners: new Uint32Array(corners), faces: new Uint32Array(faces) };
}

/** The next corner of the same face. */
export function nextCorners(offsets: Int32Array): Uint32Array {
  const next = new Uint32Array(offsets[offsets.length - 1]!);
  for (let f = 0; f + 1 < offsets.length; ++f)
    for (let c = offsets[f]!; c < offsets[f + 1]!; ++c) next[c] = c + 1 === offsets[f + 1] ? offsets[f]! : c + 1;
  return next;
}

/** The two corners at which each edge starts in its faces; -1 for the second at a border. */
export function cornersOfEdges(edges: number, cornerEdges: Int32Array): Int32Array {
  const corners = new Int32Array(2 * edges).fill(-1);
  cornerEdges.forEach((e, corner) => {
    corners[corners[2 * e]! < 0 ? 2 * e : 2 * e + 1] = corner;
  });
  return corners;
}

export function faceOfCorners(offsets: Int32Array): Int32Array {
  const faces = new Int32Array(offsets[offsets.length - 1]!);
  for (let f = 0; f + 1 < offsets.length; ++f) faces.fill(f, offsets[f]!, offsets[f + 1]!);
  return faces;
}
