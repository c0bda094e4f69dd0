// A net and its motion as FOLD has it, crease by crease: which of them move when, and files of other motions of the same net.
// Nothing is folded here: what panels do, and whether they collide, the core says.
import type { Model } from './core/protocol';

interface Frame {
  'plico:time'?: number;
  edges_foldAngle?: (number | null)[];
  [key: string]: unknown;
}
interface Fold extends Frame {
  vertices_coords: number[][];
  edges_vertices: [number, number][];
  edges_assignment: string[];
  faces_vertices: number[][];
  file_frames?: Frame[];
}
/** Fold angles of the edges of the file, in degrees, at a time in [0, 1]. */
interface Waypoint {
  time: number;
  angles: number[];
}
/** Creases that move in the same parts of the motion. */
export interface Lane {
  edges: number[]; // of the model
  spans: [number, number][]; // of the time; none: they stay
}

const kStill = 0.05; // degrees that count as no turn
const kShare = 0.004; // of all that a crease turns: less in a step counts as no turn
const kMostLanes = 16;
const kRoundings = [0.01, 0.02, 0.05, 0.1, 0.25, 0.5]; // of the time; coarser until there are few lanes

const kWords: Record<string, string> = { M: 'mountain', V: 'valley', F: 'flat', U: 'free' };

export class MotionFile {
  private readonly file: Fold;
  private readonly path: Waypoint[];
  private readonly edgeOf = new Map<number, number>(); // edges of the file by those of the model; hinges only
  readonly hasMotion: boolean;
  private readonly panels: number;

  constructor(readonly name: string, readonly bytes: Uint8Array, model: Model, folds: Uint8Array) {
    const file = (this.file = JSON.parse(new TextDecoder().decode(bytes)) as Fold);
    const goal = (file.edges_foldAngle ?? []).map((angle) => angle ?? 0);
    const frames = (file.file_frames ?? []).filter((frame) => typeof frame['plico:time'] === 'number' && frame.edges_foldAngle);
    this.hasMotion = frames.length > 0;
    this.panels = file.faces_vertices.length;
    this.path = frames.length
      ? frames.map((frame) => ({ time: frame['plico:time']!, angles: frame.edges_foldAngle!.map((angle) => angle ?? 0) }))
      : [{ time: 0, angles: goal.map(() => 0) }, { time: 1, angles: goal }];
    const ends = (a: number, b: number): string => (a < b ? `${a} ${b}` : `${b} ${a}`);
    const number = new Map(file.edges_vertices.map(([a, b], e) => [ends(a, b), e]));
    file.faces_vertices.forEach((face, f) => face.forEach((v, i) => {
      const edge = model.cornerEdges[model.offsets[f]! + i]!, own = number.get(ends(v, face[(i + 1) % face.length]!));
      if (own !== undefined && folds[edge] && file.edges_assignment[own]! in kWords) this.edgeOf.set(edge, own);
    }));
  }

  get edges(): number[] {
    return [...this.edgeOf.keys()];
  }
  /** Without a motion the angles turn evenly, which vertices inside a sheet do not allow. */
  get comesApart(): boolean {
    return !this.hasMotion && this.edgeOf.size >= this.panels;
  }
  has(edge: number): boolean {
    return this.edgeOf.has(edge);
  }
  private anglesAt(time: number): number[] {
    const next = Math.max(1, this.path.findIndex((point) => point.time >= time));
    const from = this.path[next - 1]!, to = this.path[next]!, share = (time - from.time) / (to.time - from.time || 1);
    return from.angles.map((angle, e) => angle + share * (to.angles[e]! - angle));
  }
  /** Degrees, valley > 0. */
  angle(edge: number, time: number): number {
    return this.anglesAt(time)[this.edgeOf.get(edge)!]!;
  }
  spoken(edge: number, time: number): string {
    const own = this.edgeOf.get(edge)!, word = kWords[this.file.edges_assignment[own]!];
    return `crease ${edge}, ${word}, ${this.angle(edge, time).toFixed(0)}° now, ${this.path.at(-1)!.angles[own]!.toFixed(0)}° at the end`;
  }

  /** In the order in which they begin; those that never move last. */
  lanes(): Lane[] {
    const spans = new Map(this.edges.map((edge) => [edge, this.spansOf(this.edgeOf.get(edge)!)]));
    for (const by of kRoundings) {
      const lanes = new Map<string, Lane>();
      for (const [edge, exact] of spans) {
        const rounded = merged(exact.map((span) => span.map((t) => Math.round(t / by) * by) as [number, number]));
        const lane = lanes.get(String(rounded)) ?? { edges: [], spans: rounded };
        lane.edges.push(edge);
        lanes.set(String(rounded), lane);
      }
      if (lanes.size > kMostLanes && by !== kRoundings.at(-1)) continue;
      const first = ({ spans: [one] }: Lane): number => one?.[0] ?? 2;
      return [...lanes.values()].sort((a, b) => first(a) - first(b) || (a.spans.at(-1)?.[1] ?? 0) - (b.spans.at(-1)?.[1] ?? 0));
    }
    return [];
  }
  private spansOf(own: number): [number, number][] {
    const turns = this.path.slice(1).map(({ angles }, i) => Math.abs(angles[own]! - this.path[i]!.angles[own]!));
    const least = Math.max(kShare * turns.reduce((sum, turn) => sum + turn, 0), kStill / turns.length);
    return merged(turns.flatMap((turn, i) => (turn > least ? [[this.path[i]!.time, this.path[i + 1]!.time] as [number, number]] : [])));
  }

  // --- other motions of the same net

  private written(frames: Frame[]): Uint8Array {
    const { 'plico:report': _, ...rest } = this.file;
    const others = (this.file.file_frames ?? []).filter((frame) => frame['plico:time'] === undefined);
    return new TextEncoder().encode(JSON.stringify({ ...rest, file_frames: [...others, ...frames] }));
  }
  straight(): Uint8Array {
    return this.written([]);
  }
  /** As it is at `time`, but one crease turns from one angle to another; without a crease nothing moves. */
  turning(time: number, edge = -1, from = 0, to = 0): Uint8Array {
    const own = this.edgeOf.get(edge), now = this.anglesAt(time);
    const points = this.file.vertices_coords.map(([x, y]) => [x, y, 0]); // told by the angles, but asked for in each frame
    return this.written([from, to].map((angle, i) => ({
      frame_classes: ['foldedForm'], frame_attributes: ['3D'], frame_parent: 0, frame_inherit: true, 'plico:time': i,
      edges_foldAngle: now.map((other, e) => (e === own ? angle : other)), vertices_coords: points,
    })));
  }
}

/** Whether a file has a motion of these panels, one by one. */
export function hasMotionOf({ offsets }: Model, bytes: Uint8Array): boolean {
  const text = new TextDecoder().decode(bytes);
  if (!text.includes('"plico:time"')) return false;
  const { faces_vertices: faces, 'faces_plico:mesh_face': order } = JSON.parse(text) as Fold & { 'faces_plico:mesh_face'?: number[] };
  const fits = faces?.every((face, f) => face.length === offsets[f + 1]! - offsets[f]! && (order?.[f] ?? f) === f);
  return Boolean(fits) && faces.length === offsets.length - 1;
}

/** Those that touch as one; those of no length are left out. */
function merged(spans: [number, number][]): [number, number][] {
  const all: [number, number][] = [];
  for (const [from, to] of spans) {
    const last = all.at(-1);
    if (last && from - last[1] < 1e-9) last[1] = Math.max(last[1], to);
    else if (to > from) all.push([from, to]);
  }
  return all;
}
