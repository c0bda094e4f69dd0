// A model in space, drawn with WebGL 2: the mesh as it is, or its panels on the way from flat to folded.
import { onceAFrame } from './frames';
import { painterOn, type Painter } from './painter';
import { listen } from './pointers';
import type { Shape } from './shape';

export interface SpaceColors {
  front: number[]; back: number[]; ink: number[]; alarm: number[]; accent: number[]; fold: number[];
}

/** What is shown on a model besides itself: marks of its corners, and small beads at some of them, marked alike. */
export interface Decor {
  marks: Float32Array;
  corners: number[];
  kinds: number[]; // gl_mesh.ts: alarmed, pointed at, selected
}
/** A pointer that marks instead of turning the model: the ids of faces or vertices as it goes over them. */
export interface Brush {
  what: 'faces' | 'vertices';
  begin: () => void;
  paint: (id: number) => void;
}

type Vec = [number, number, number];

const kPixelsPerRadian = 150;
const kBead = 0.014; // of the model's radius
const kReach = 16; // pixels between the pointer and a vertex
// An octahedron: places about its middle, and corners of its faces.
const kBeadPoints = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]] as const;
const kBeadFaces = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];

const minus = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec, b: Vec): Vec => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

export class SpaceView {
  private readonly mesh?: Painter<'mesh'>;
  private shape?: Shape;
  private at: Float32Array = new Float32Array();
  private center: Vec = [0, 0, 0];
  private radius = 1;
  private azimuth = -0.6;
  private elevation = 0.5;
  private distance = 1; // times what shows the sphere around all
  private chosen = false; // by someone, who wants to keep it
  readonly redraw = onceAFrame(() => this.draw());
  private edge = -1;
  private decor?: Decor;
  private plain?: Uint32Array; // the triangles that the painter has, when there are no beads among them
  private brush?: Brush;

  constructor(
    private readonly canvas: HTMLCanvasElement, painter: string, private readonly colors: () => SpaceColors,
    private readonly onPoint: (edge: number) => void, private readonly onClick: (edge: number, event: PointerEvent) => void,
    onWorks: (works: boolean) => void,
  ) {
    this.mesh = painterOn('mesh', canvas, painter, onWorks);
    this.paint(64, 64); // the first picture takes 20 ms more than others
    new ResizeObserver(() => (this.chosen ? this.redraw() : this.frame(this.at))).observe(canvas);
    listen(canvas, {
      point: (at) => this.onPoint(at ? this.edgeAt(at.x, at.y) : -1),
      click: (at, event) => {
        const edge = this.edgeAt(at.x, at.y);
        if (edge >= 0) this.onClick(edge, event);
      },
      drag: (dx, dy, at) => (this.brush ? this.stroke(at) : this.turn(dx / kPixelsPerRadian, dy / kPixelsPerRadian)),
      press: (at) => this.brush && (this.brush.begin(), this.stroke(at)),
      zoom: (factor) => this.zoom(1 / factor),
    });
  }

  /** A new model, or the same after an edit; `at` are the places of its corners. */
  show(shape: Shape, at: Float32Array, reframe: boolean, whole = false): void {
    const moved = at !== this.at || shape !== this.shape;
    this.shape = shape;
    this.whole = whole;
    this.at = at;
    if (reframe) this.frame(at);
    const { mesh } = this;
    if (!mesh) return;
    const { folds, cuts } = whole ? { folds: new Uint32Array(), cuts: shape.edgesOnce() } : shape.lines();
    mesh.setLines('folds', folds);
    mesh.setLines('cuts', cuts);
    this.dress();
    this.point(this.edge < shape.model.edges ? this.edge : -1);
    if (moved) this.place(at);
  }
  private whole = false; // as a mesh, not as a net

  /** Shown until something else is; the beads follow the corners. */
  decorate(decor: Decor | undefined): void {
    this.decor = decor;
    this.dress();
  }
  private dress(): void {
    const { shape, mesh, decor } = this;
    if (!shape || !mesh) return;
    const own = shape.faceOf.length, marks = new Float32Array(own + 6 * (decor?.corners.length ?? 0));
    if (decor) marks.set(decor.marks);
    else if (!this.whole) for (const f of shape.overlapping) marks.fill(1, shape.model.offsets[f]!, shape.model.offsets[f + 1]!);
    decor?.kinds.forEach((kind, i) => marks.fill(kind, own + 6 * i, own + 6 * i + 6));
    mesh.setMarks(marks);
    const beads = decor?.corners.length ?? 0;
    if (!beads && this.plain === shape.triangles) return;
    this.plain = beads ? undefined : shape.triangles;
    const triangles = new Uint32Array(shape.triangles.length + 24 * beads);
    triangles.set(shape.triangles);
    for (let i = 0; i < beads; ++i) kBeadFaces.forEach((p, k) => (triangles[shape.triangles.length + 24 * i + k] = own + 6 * i + p));
    mesh.setTriangles(triangles);
  }

  place(at: Float32Array): void {
    this.at = at;
    if (!this.chosen) this.distance *= Math.max(1, this.largest(at) / 0.96); // panels on their way stay in view
    this.mesh?.setPlaces(this.withBeads(at));
    this.redraw();
  }
  private withBeads(at: Float32Array): Float32Array {
    const { decor } = this;
    if (!decor?.corners.length) return at;
    const all = new Float32Array(at.length + 18 * decor.corners.length), size = kBead * this.radius;
    all.set(at);
    decor.corners.forEach((c, i) => kBeadPoints.forEach((p, k) => {
      for (let axis = 0; axis < 3; ++axis) all[at.length + 18 * i + 3 * k + axis] = at[3 * c + axis]! + size * p[axis]!;
    }));
    return all;
  }

  setBrush(brush: Brush | undefined): void {
    this.brush = brush;
    this.canvas.style.cursor = brush ? 'crosshair' : '';
  }
  private stroke({ x, y }: { x: number; y: number }): void {
    const face = this.faceAt(x, y), { shape, brush } = this;
    if (!shape || !brush || face < 0) return;
    if (brush.what === 'faces') return brush.paint(face);
    const { offsets, vertexOf } = shape.model;
    for (let c = offsets[face]!; c < offsets[face + 1]!; ++c) {
      const [px, py] = this.onCanvas(this.corner(c));
      if (Math.hypot(px - x, py - y) < kReach) brush.paint(vertexOf[c]!);
    }
  }

  point(edge: number): void {
    this.edge = edge;
    const { shape } = this;
    if (!shape || !this.mesh) return;
    const ends: number[] = [];
    for (const c of edge < 0 || this.whole ? [] : [shape.edgeCorners[2 * edge]!, shape.edgeCorners[2 * edge + 1]!]) if (c >= 0) ends.push(c, shape.next[c]!);
    this.mesh.setLines('pointed at', new Uint32Array(ends));
    this.redraw();
  }

  /** Shows all of these places, and keeps showing from the same side. */
  frame(at: Float32Array): void {
    if (!at.length) return;
    const low: Vec = [Infinity, Infinity, Infinity], high: Vec = [-Infinity, -Infinity, -Infinity];
    for (let k = 0; k < 3; ++k)
      for (let i = k; i < at.length; i += 3) {
        if (at[i]! < low[k]!) low[k] = at[i]!;
        if (at[i]! > high[k]!) high[k] = at[i]!;
      }
    this.center = [0, 1, 2].map((k) => (low[k]! + high[k]!) / 2) as Vec;
    this.radius = Math.hypot(...minus(high, low)) / 2 || 1;
    this.distance = 1;
    this.distance = this.largest(at) / 0.9;
    this.chosen = false;
    this.redraw();
  }
  /** How much of the view the places take, of its half width or height. */
  private largest(at: Float32Array): number {
    const { eye, right, up, toward, focal, aspect } = this.camera();
    let most = 0;
    for (let i = 0; i + 2 < at.length; i += 3) {
      const x = at[i]! - eye[0], y = at[i + 1]! - eye[1], z = at[i + 2]! - eye[2];
      const depth = -(x * toward[0] + y * toward[1] + z * toward[2]);
      const across = ((x * right[0] + y * right[1] + z * right[2]) * focal) / aspect, along = (x * up[0] + y * up[1] + z * up[2]) * focal;
      most = Math.max(most, Math.abs(across / depth), Math.abs(along / depth));
    }
    return Number.isFinite(most) && most > 0 ? most : 0.9;
  }
  turn(right: number, up: number): void {
    this.azimuth -= right;
    this.elevation = Math.max(-1.55, Math.min(1.55, this.elevation + up));
    this.redraw();
  }
  zoom(factor: number): void {
    this.distance = Math.max(0.05, Math.min(8, this.distance * factor));
    this.chosen = true;
    this.redraw();
  }

  /** Arrows turn it, plus and minus zoom. */
  key({ key }: KeyboardEvent): boolean {
    const actions: Record<string, () => void> = {
      ArrowLeft: () => this.turn(0.15, 0), ArrowRight: () => this.turn(-0.15, 0), ArrowUp: () => this.turn(0, 0.15), ArrowDown: () => this.turn(0, -0.15),
      '+': () => this.zoom(0.85), '-': () => this.zoom(1.18),
    };
    actions[key]?.();
    return key in actions;
  }

  private camera(): { eye: Vec; right: Vec; up: Vec; toward: Vec; focal: number; aspect: number } {
    const c = Math.cos(this.elevation);
    const from: Vec = [c * Math.sin(this.azimuth), -c * Math.cos(this.azimuth), Math.sin(this.elevation)];
    const aspect = this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight);
    const focal = 2.4;
    const far = (this.distance * this.radius * focal * 1.08) / Math.min(1, aspect);
    const eye = this.center.map((x, k) => x + far * from[k]!) as Vec;
    const right: Vec = [Math.cos(this.azimuth), Math.sin(this.azimuth), 0];
    return { eye, right, up: cross(from, right), toward: from, focal, aspect };
  }

  private matrix(): Float32Array {
    const { eye, right, up, toward, focal, aspect } = this.camera();
    const far = dot(minus(eye, this.center), toward) + 2 * this.radius, near = Math.max(far / 1000, far - 6 * this.radius);
    const rows = [
      [...right.map((x) => (x * focal) / aspect), (-dot(right, eye) * focal) / aspect],
      [...up.map((x) => x * focal), -dot(up, eye) * focal],
      [...toward.map((x) => (x * (far + near)) / (near - far)), (-dot(toward, eye) * (far + near)) / (near - far) + (2 * far * near) / (near - far)],
      [...toward.map((x) => -x), dot(toward, eye)],
    ];
    return new Float32Array([0, 1, 2, 3].flatMap((column) => rows.map((row) => row[column]!)));
  }

  private draw(): void {
    const { canvas } = this;
    if (!this.mesh || !this.shape) return;
    const width = Math.round(canvas.clientWidth * devicePixelRatio), height = Math.round(canvas.clientHeight * devicePixelRatio);
    this.paint(width, height);
  }
  private paint(width: number, height: number): void {
    const { eye, right, up, toward } = this.camera(), { fold, ink, accent, front, back, alarm } = this.colors();
    this.mesh?.draw(width, height, { view: this.matrix(), eye, right, up, backward: toward }, { front, back, alarm, accent }, [
      { name: 'folds', color: fold }, { name: 'cuts', color: ink }, { name: 'pointed at', color: accent, above: true },
    ]);
  }

  private corner(c: number): Vec {
    return [this.at[3 * c]!, this.at[3 * c + 1]!, this.at[3 * c + 2]!];
  }
  private onCanvas(p: Vec): [number, number] {
    const { eye, right, up, toward, focal, aspect } = this.camera();
    const d = minus(p, eye), depth = -dot(d, toward);
    return [(1 + (dot(d, right) * focal) / aspect / depth) * this.canvas.clientWidth / 2, (1 - (dot(d, up) * focal) / depth) * this.canvas.clientHeight / 2];
  }

  /** The edge nearest to the pointer, of the face that is seen there. */
  private edgeAt(x: number, y: number): number {
    const face = this.faceAt(x, y), { shape } = this;
    if (!shape || face < 0) return -1;
    let best = -1, least = Infinity;
    for (let c = shape.model.offsets[face]!; c < shape.model.offsets[face + 1]!; ++c) {
      const [ax, ay] = this.onCanvas(this.corner(c)), [bx, by] = this.onCanvas(this.corner(shape.next[c]!));
      const ux = bx - ax, uy = by - ay;
      const t = Math.max(0, Math.min(1, ((x - ax) * ux + (y - ay) * uy) / (ux * ux + uy * uy || 1)));
      const distance = Math.hypot(ax + t * ux - x, ay + t * uy - y);
      if (distance < least) least = distance, best = shape.model.cornerEdges[c]!;
    }
    return best;
  }
  private faceAt(x: number, y: number): number {
    const { shape } = this;
    if (!shape) return -1;
    const { eye, right, up, toward, focal, aspect } = this.camera();
    const u = ((2 * x) / this.canvas.clientWidth - 1) * aspect / focal, v = (1 - (2 * y) / this.canvas.clientHeight) / focal;
    const ray = [0, 1, 2].map((k) => u * right[k]! + v * up[k]! - toward[k]!) as Vec;
    let best = -1, nearest = Infinity;
    for (let t = 0; t < shape.triangleFaces.length; ++t) {
      const a = this.corner(shape.triangles[3 * t]!), b = this.corner(shape.triangles[3 * t + 1]!), c = this.corner(shape.triangles[3 * t + 2]!);
      const ab = minus(b, a), ac = minus(c, a), p = cross(ray, ac), det = dot(ab, p);
      if (Math.abs(det) < 1e-30) continue;
      const s = minus(eye, a), q = cross(s, ab), i = dot(s, p) / det, j = dot(ray, q) / det, far = dot(ac, q) / det;
      if (i >= 0 && j >= 0 && i + j <= 1 && far > 0 && far < nearest) nearest = far, best = shape.triangleFaces[t]!;
    }
    return best;
  }
}
