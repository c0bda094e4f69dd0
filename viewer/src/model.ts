// What the page is told (written by src/plico/io/viewer.cpp) and the folding map over it.

export interface PageData {
  title: string;
  unit: string;
  thickness: number;
  stand: { axis: [number, number, number]; angle: number }; // turn of the whole at time 1, in proportion before
  panels: number[][]; // outline of each panel: x0, y0, x1, y1, ...; flat, front up
  triangles: number[][]; // corners of each panel, three a triangle
  hinges: Hinge[];
  order: number[];
  parentPanel: number[];
  parentHinge: number[];
  seams: [number, number, number, number][]; // panel, side, panel, side
  sideIds: string[][]; // of each side of each panel, as printed; empty when there are no pages
  partOf: string[]; // the letter of each panel's part on the pages; empty when there are none
  paper?: Paper; // the printed pages; absent when there are none
  colors?: string[]; // "#rrggbb" of the front of each panel; absent: all alike
  keys: { times: number[]; angles: number[] }[]; // of each hinge, radians; linear in between
  motion: string;
  start: number; // the moment shown first, in [0, 1]
  proof: { status: 'proven' | 'collides' | 'undecided' | 'unchecked'; note: string };
  collisions: { begin: number; end: number; panels: [number, number] }[];
  report: Record<string, unknown> | null;
  links: { label: string; href: string }[];
  pictures: { caption: string; png: string }[]; // base64
  folded: number; // the moment from which folded pieces are put together; 1 when they are not
  home: Home[]; // of each panel; empty when pieces stay where they fold
}

// Pages side by side, in millimetres, y upwards; outlines as above.
export interface Paper {
  pages: number[][];
  panels: number[][]; // in the order of the panels
  tabs: number[][];
  folds: Record<Kind, number[][]>;
  names: { text: string; at: number[] }[]; // of parts, when there are several
}

// How a folded piece comes to where it belongs: it turns about its centre while that moves.
export interface Home {
  axis: [number, number, number];
  angle: number;
  centre: [number, number, number];
  shift: [number, number, number];
}

export interface Hinge {
  left: number;
  right: number;
  from: [number, number, number];
  to: [number, number, number];
  target: number;
  roll?: number; // of a thick hinge: half the thickness; beyond 90 degrees it turns about the line of contact
}

export type Kind = 'mountain' | 'valley' | 'flat';
export const kindOf = (angle: number): Kind => (angle > 1e-9 ? 'valley' : angle < -1e-9 ? 'mountain' : 'flat');
export const degrees = (angle: number): number => (angle * 180) / Math.PI;

// A rigid motion: nine entries of the rotation row by row, then the translation.
export type Pose = Float64Array;

export function apply(m: Pose, x: number, y: number, z: number): [number, number, number] {
  return [
    m[0]! * x + m[1]! * y + m[2]! * z + m[9]!,
    m[3]! * x + m[4]! * y + m[5]! * z + m[10]!,
    m[6]! * x + m[7]! * y + m[8]! * z + m[11]!,
  ];
}

function compose(a: Pose, b: Pose): Pose {
  const c = new Float64Array(12);
  for (let i = 0; i < 3; i++) {
    for (let j = 0; j < 3; j++) {
      c[3 * i + j] = a[3 * i]! * b[j]! + a[3 * i + 1]! * b[3 + j]! + a[3 * i + 2]! * b[6 + j]!;
    }
  }
  const t = apply(a, b[9]!, b[10]!, b[11]!);
  c.set(t, 9);
  return c;
}

// Right-handed about the line through `from` and `to` (Rodrigues).
function rotationAbout(from: readonly number[], to: readonly number[], angle: number): Pose {
  const d = [to[0]! - from[0]!, to[1]! - from[1]!, to[2]! - from[2]!];
  const length = Math.hypot(d[0]!, d[1]!, d[2]!);
  const [x, y, z] = [d[0]! / length, d[1]! / length, d[2]! / length];
  const s = Math.sin(angle);
  const c = Math.cos(angle);
  const k = 1 - c;
  const m = Float64Array.of(
    c + x * x * k, x * y * k - z * s, x * z * k + y * s,
    y * x * k + z * s, c + y * y * k, y * z * k - x * s,
    z * x * k - y * s, z * y * k + x * s, c + z * z * k,
    0, 0, 0);
  const t = apply(m, from[0]!, from[1]!, from[2]!);
  m.set([from[0]! - t[0], from[1]! - t[1], from[2]! - t[2]], 9);
  return m;
}

// The motion of one panel of a hinge, seen from the other: as turn() in src/plico/fold/linkage.cpp.
function turnOf(hinge: Hinge, foldAngle: number, rightMoves: boolean): Pose {
  const { from, to } = hinge;
  const roll = hinge.roll ?? 0;
  const angle = rightMoves ? -foldAngle : foldAngle;
  const quarter = (Math.sign(angle) * Math.PI) / 2;
  if (roll === 0 || Math.abs(angle) <= Math.PI / 2) return rotationAbout(from, to, angle);
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const side = ((rightMoves ? 1 : -1) * roll) / length;
  const shift = [-(to[1] - from[1]) * side, (to[0] - from[0]) * side, Math.sign(foldAngle) * roll];
  const contact = (p: readonly number[]): number[] => p.map((x, i) => x + shift[i]!);
  return compose(rotationAbout(contact(from), contact(to), angle - quarter), rotationAbout(from, to, quarter));
}

export function angleAt(keys: { times: number[]; angles: number[] }, time: number): number {
  const { times, angles } = keys;
  if (time <= times[0]!) return angles[0]!;
  let low = 0;
  let high = times.length - 1;
  if (time >= times[high]!) return angles[high]!;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= time) low = middle;
    else high = middle;
  }
  const s = (time - times[low]!) / (times[high]! - times[low]!);
  return (1 - s) * angles[low]! + s * angles[high]!;
}

function onTheWay(home: Home, share: number): Pose {
  const { axis, angle, centre, shift } = home;
  const m = rotationAbout(centre, centre.map((c, i) => c + axis[i]!), share * angle);
  for (let i = 0; i < 3; i++) m[9 + i]! += share * shift[i]!;
  return m;
}

export class Model {
  readonly hingesOf: number[][]; // of each panel
  constructor(readonly data: PageData) {
    this.hingesOf = data.panels.map(() => []);
    data.hinges.forEach((hinge, h) => {
      this.hingesOf[hinge.left]!.push(h);
      this.hingesOf[hinge.right]!.push(h);
    });
  }

  // Where each panel is at a time in [0, 1]: the same walk along the tree as the library's folding_map.
  poses(time: number): Pose[] {
    const { order, parentPanel, parentHinge, hinges, keys, stand } = this.data;
    const poses: Pose[] = new Array(order.length);
    const upright = rotationAbout([0, 0, 0], stand.axis, stand.angle * time);
    for (const p of order) {
      const h = parentHinge[p]!;
      if (h < 0) {
        poses[p] = upright;
        continue;
      }
      const hinge = hinges[h]!;
      const angle = angleAt(keys[h]!, time);
      const turn = turnOf(hinge, angle, p === hinge.right);
      poses[p] = compose(poses[parentPanel[p]!]!, turn);
    }
    const { home, folded } = this.data;
    const share = (time - folded) / (1 - folded);
    return home.length > 0 && share > 0 ? poses.map((pose, p) => compose(onTheWay(home[p]!, share), pose)) : poses;
  }

  // Corners of all panels at a time, panel by panel: x, y, z, ...
  positions(time: number): number[][] {
    const poses = this.poses(time);
    return this.data.panels.map((outline, p) => {
      const points: number[] = [];
      for (let i = 0; i < outline.length; i += 2) points.push(...apply(poses[p]!, outline[i]!, outline[i + 1]!, 0));
      return points;
    });
  }

  colliding(time: number): Set<number> {
    const panels = new Set<number>();
    for (const c of this.data.collisions) if (c.begin <= time && time <= c.end) c.panels.forEach((p) => panels.add(p));
    return panels;
  }

  // The median length of a side: how fine the sheet is.
  typicalSide(outlines: number[][] = this.data.panels): number {
    const sides: number[] = [];
    for (const outline of outlines) {
      const n = outline.length;
      for (let i = 0; i < n; i += 2) {
        sides.push(Math.hypot(outline[(i + 2) % n]! - outline[i]!, outline[(i + 3) % n]! - outline[i + 1]!));
      }
    }
    return sides.sort((a, b) => a - b)[sides.length >> 1]!;
  }

  // What the sides of a panel are glued to: the id on paper, and the panel.
  seamsOf(panel: number): { id: string; other: number }[] {
    const id = (p: number, side: number): string => this.data.sideIds[p]?.[side] ?? '';
    return this.data.seams.flatMap(([a, i, b, j]) => [
      ...(a === panel ? [{ id: id(a, i), other: b }] : []),
      ...(b === panel ? [{ id: id(b, j), other: a }] : []),
    ]);
  }

  gluedTo(panel: number): number[] {
    return this.data.seams.flatMap(([a, , b]) => (a === panel ? [b] : b === panel ? [a] : []));
  }
}
