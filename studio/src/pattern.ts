// A crease pattern under the hands of someone: straight lines that meet only at their ends. Edits are values: lines that go
// and lines that come; the inverse has them the other way round. What is right or wrong with it, the core says.
export type Kind = 'M' | 'V' | 'F' | 'U' | 'B';
export const kKinds: Kind[] = ['M', 'V', 'F', 'U', 'B'];
export const kKindNames: Record<Kind, string> = { M: 'mountain', V: 'valley', F: 'flat', U: 'unassigned', B: 'border' };

export interface Point {
  x: number;
  y: number;
}
export interface Line {
  a: Point;
  b: Point;
  kind: Kind;
}
export interface PatternEdit {
  remove: Line[];
  add: Line[];
}

export const kNear = 1e-9; // of the sheet's side: places nearer than this are one

const minus = (p: Point, q: Point): Point => ({ x: p.x - q.x, y: p.y - q.y });
const cross = (p: Point, q: Point): number => p.x * q.y - p.y * q.x;
const dot = (p: Point, q: Point): number => p.x * q.x + p.y * q.y;
export const distance = (p: Point, q: Point): number => Math.hypot(p.x - q.x, p.y - q.y);
export const isSame = (p: Point, q: Point): boolean => distance(p, q) < kNear;
const at = (l: { a: Point; b: Point }, t: number): Point => ({ x: l.a.x + t * (l.b.x - l.a.x), y: l.a.y + t * (l.b.y - l.a.y) });

/** How far along the line, in [0, 1], its nearest place is. */
export function along({ a, b }: { a: Point; b: Point }, p: Point): number {
  const d = minus(b, a);
  return Math.max(0, Math.min(1, dot(minus(p, a), d) / (dot(d, d) || 1)));
}
export const nearestOn = (l: { a: Point; b: Point }, p: Point): Point => at(l, along(l, p));

/** Where two lines meet, the ends included; nothing when they are parallel. */
export function meeting(l: { a: Point; b: Point }, m: { a: Point; b: Point }): Point | undefined {
  const d = minus(l.b, l.a), e = minus(m.b, m.a), turn = cross(d, e);
  if (Math.abs(turn) < kNear * Math.hypot(d.x, d.y) * Math.hypot(e.x, e.y)) return undefined;
  const from = minus(m.a, l.a), t = cross(from, e) / turn, s = cross(from, d) / turn;
  const give = kNear / Math.max(kNear, Math.hypot(d.x, d.y)), giveS = kNear / Math.max(kNear, Math.hypot(e.x, e.y));
  if (t < -give || t > 1 + give || s < -giveS || s > 1 + giveS) return undefined;
  return at(l, t);
}

export const keyOf = ({ a, b }: { a: Point; b: Point }): string => [[a.x, a.y], [b.x, b.y]].sort((p, q) => p[0]! - q[0]! || p[1]! - q[1]!).join(' ');

export class Pattern {
  private readonly byKey = new Map<string, Line>();

  constructor(lines: Line[] = []) {
    for (const line of lines) this.byKey.set(keyOf(line), line);
  }
  /** In an order of their own, whatever the edits were. */
  get lines(): Line[] {
    return [...this.byKey].sort(([p], [q]) => (p < q ? -1 : 1)).map(([, line]) => line);
  }
  get points(): Point[] {
    const seen = new Map<string, Point>();
    for (const { a, b } of this.lines) for (const p of [a, b]) seen.set(`${p.x} ${p.y}`, p);
    return [...seen.values()];
  }
  apply({ remove, add }: PatternEdit): PatternEdit {
    for (const line of remove) this.byKey.delete(keyOf(line));
    for (const line of add) this.byKey.set(keyOf(line), line);
    return { remove: add, add: remove };
  }

  /** The edit that draws a line: it and what it crosses are cut where they meet; where it lies on another, it gives the kind. */
  drawing(from: Point, to: Point, kind: Kind): PatternEdit {
    const edit: PatternEdit = { remove: [], add: [] };
    const { lines } = this;
    const snapped = (p: Point): Point => this.points.find((q) => isSame(p, q)) ?? p;
    const drawn = { a: snapped(from), b: snapped(to) };
    if (isSame(drawn.a, drawn.b)) return edit;
    const stops: Point[] = [drawn.a, drawn.b];
    const stop = (p: Point): Point => {
      const known = stops.find((q) => isSame(p, q));
      if (!known) stops.push(p);
      return known ?? p;
    };
    for (const p of this.points) if (isSame(nearestOn(drawn, p), p)) stop(p);
    const cuts = new Map<Line, Point[]>();
    for (const line of lines) {
      const places = [drawn.a, drawn.b].filter((p) => isSame(nearestOn(line, p), p));
      const met = meeting(drawn, line);
      if (met) places.push(stop(snapped(met)));
      cuts.set(line, places.filter((p) => !isSame(p, line.a) && !isSame(p, line.b)));
    }
    for (const [line, places] of cuts) {
      if (!places.length) continue;
      edit.remove.push(line);
      edit.add.push(...pieces([line.a, ...places, line.b], line).map(([a, b]) => ({ a, b, kind: line.kind })));
    }
    for (const [a, b] of pieces(stops, drawn)) {
      const fresh: Line = { a, b, kind }, key = keyOf(fresh);
      const cut = edit.add.findIndex((line) => keyOf(line) === key), whole = this.byKey.get(key);
      const old = cut >= 0 ? edit.add[cut]! : whole;
      if (old?.kind === 'B' && kind !== 'B') continue; // the border stays one
      if (cut >= 0) edit.add.splice(cut, 1);
      else if (whole) edit.remove.push(whole);
      edit.add.push(fresh);
    }
    return edit;
  }

  /** Erases, and joins what went through: two lines of one kind that go straight on become one again. */
  erasing(lines: Line[]): PatternEdit {
    const edit: PatternEdit = { remove: [...lines], add: [] };
    const gone = new Set(lines.map(keyOf));
    let left = this.lines.filter((line) => !gone.has(keyOf(line)));
    for (const end of lines.flatMap(({ a, b }) => [a, b])) {
      const here = left.filter(({ a, b }) => isSame(a, end) || isSame(b, end));
      if (here.length !== 2 || here[0]!.kind !== here[1]!.kind) continue;
      const [p, q] = here.map(({ a, b }) => (isSame(a, end) ? b : a)) as [Point, Point];
      const u = minus(p, end), v = minus(q, end);
      if (Math.abs(cross(u, v)) > kNear * Math.hypot(u.x, u.y) * Math.hypot(v.x, v.y) || dot(u, v) > 0) continue;
      const joined: Line = { a: p, b: q, kind: here[0]!.kind };
      left = [...left.filter((line) => !here.includes(line)), joined];
      for (const line of here) {
        const made = edit.add.indexOf(line);
        if (made >= 0) edit.add.splice(made, 1);
        else edit.remove.push(line);
      }
      edit.add.push(joined);
    }
    return edit;
  }

  kindOf(line: Line, kind: Kind): PatternEdit {
    return { remove: [line], add: [{ ...line, kind }] };
  }

  /** FOLD 1.2, with the lines and points in the order that `lines` and `points` have. */
  fold(title: string): string {
    const { points, lines } = this, number = new Map(points.map((p, i) => [`${p.x} ${p.y}`, i]));
    const id = (p: Point): number => number.get(`${p.x} ${p.y}`)!;
    return JSON.stringify({
      file_spec: 1.2, file_creator: 'Plico studio', file_classes: ['singleModel'], frame_title: title, frame_classes: ['creasePattern'],
      frame_attributes: ['2D'], frame_unit: 'unit', vertices_coords: points.map(({ x, y }) => [x, y]),
      edges_vertices: lines.map(({ a, b }) => [id(a), id(b)]), edges_assignment: lines.map(({ kind }) => kind),
    });
  }
}

/** Between neighbouring places along a line, without those of no length. */
function pieces(places: Point[], line: { a: Point; b: Point }): [Point, Point][] {
  const inOrder = [...places].sort((p, q) => dot(minus(p, line.a), minus(line.b, line.a)) - dot(minus(q, line.a), minus(line.b, line.a)));
  return inOrder.slice(1).map((p, i): [Point, Point] => [inOrder[i]!, p]).filter(([p, q]) => !isSame(p, q));
}

export function square(): Pattern {
  const corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(([x, y]) => ({ x: x!, y: y! }));
  return new Pattern(corners.map((a, i) => ({ a, b: corners[(i + 1) % 4]!, kind: 'B' })));
}

const kCutUpTo = 1500; // lines: whether more of them cross is left to the core

/** In the unit square; lines that cross are cut where they meet. */
function scaled(lines: Line[]): Pattern | undefined {
  const points = lines.flatMap(({ a, b }) => [a, b]);
  if (!lines.length || !points.every(({ x, y }) => Number.isFinite(x) && Number.isFinite(y))) return undefined;
  const [xs, ys] = [points.map((p) => p.x), points.map((p) => p.y)];
  const least = (of: number[]): number => of.reduce((a, b) => Math.min(a, b)), most = (of: number[]): number => of.reduce((a, b) => Math.max(a, b));
  const low = { x: least(xs), y: least(ys) }, size = Math.max(most(xs) - low.x, most(ys) - low.y) || 1;
  const known = new Map<string, Point>();
  const at = ({ x, y }: Point): Point => {
    const p = { x: (x - low.x) / size, y: (y - low.y) / size }, key = `${p.x.toFixed(9)} ${p.y.toFixed(9)}`;
    return known.get(key) ?? (known.set(key, p), p);
  };
  const inUnit = lines.map(({ a, b, kind }) => ({ a: at(a), b: at(b), kind }));
  if (inUnit.length > kCutUpTo) return new Pattern(inUnit);
  const pattern = new Pattern();
  for (const { a, b, kind } of inUnit) pattern.apply(pattern.drawing(a, b, kind));
  return pattern;
}

/** The kinds that a FOLD file gives to lines of this pattern: by their ends, which it left where they were. */
export function kindsIn(text: string, lines: Line[]): Map<Line, Kind> {
  const file = JSON.parse(text) as { vertices_coords: number[][]; edges_vertices: [number, number][]; edges_assignment: Kind[] };
  const rounded = (p: Point): Point => ({ x: Number(p.x.toFixed(7)), y: Number(p.y.toFixed(7)) });
  const at = (v: number): Point => rounded({ x: file.vertices_coords[v]![0]!, y: file.vertices_coords[v]![1]! });
  const told = new Map(file.edges_vertices.map(([a, b], i) => [keyOf({ a: at(a), b: at(b) }), file.edges_assignment[i]!]));
  const kinds = lines.map((line): [Line, Kind | undefined] => [line, told.get(keyOf({ a: rounded(line.a), b: rounded(line.b) }))]);
  return new Map(kinds.filter((pair): pair is [Line, Kind] => pair[1] !== undefined && kKinds.includes(pair[1])));
}

/** The drawing of a FOLD file; nothing when there is none. */
export function patternOf(text: string): Pattern | undefined {
  let file: { vertices_coords?: number[][]; edges_vertices?: [number, number][]; edges_assignment?: string[] };
  try {
    file = JSON.parse(text);
  } catch {
    return undefined;
  }
  const points = file?.vertices_coords, edges = file?.edges_vertices;
  if (!Array.isArray(points) || !Array.isArray(edges)) return undefined;
  const at = (i: number): Point => ({ x: Number(points[i]?.[0]), y: Number(points[i]?.[1]) });
  return scaled(edges.map(([a, b], i) => ({ a: at(a), b: at(b), kind: kKinds.find((kind) => kind === file.edges_assignment?.[i]) ?? 'U' })));
}

/** Lines of "kind x1 y1 x2 y2", where 1 is border, 2 mountain, 3 valley and 4 an aid. */
export function patternOfCp(text: string): Pattern | undefined {
  const kinds: Record<string, Kind> = { '1': 'B', '2': 'M', '3': 'V', '4': 'F' };
  const words = text.split('\n').map((line) => line.trim().split(/\s+/)).filter((line) => line.length === 5);
  return scaled(words.map(([kind, ...xy]) => {
    const [x1, y1, x2, y2] = xy.map(Number) as [number, number, number, number];
    return { a: { x: x1, y: y1 }, b: { x: x2, y: y2 }, kind: kinds[kind!] ?? 'U' };
  }));
}

export type Mirror = 'none' | 'left-right' | 'up-down' | 'diagonal';
/** The mirror images of a place in the middle of the sheet `size`. */
export function mirrored({ x, y }: Point, mirror: Mirror, size: Point): Point {
  if (mirror === 'left-right') return { x: size.x - x, y };
  if (mirror === 'up-down') return { x, y: size.y - y };
  return mirror === 'diagonal' ? { x: y, y: x } : { x, y };
}
