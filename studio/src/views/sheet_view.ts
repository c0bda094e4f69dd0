// The net on the table, drawn on a canvas: parts in tints, folds dashed, cuts solid, overlaps hatched in red.
import type { Model, Snapshot, Verdict } from '../core/protocol';
import { onceAFrame } from './frames';
import { painterOn, type Painter } from './painter';
import { listen } from './pointers';
import type { Shape } from './shape';

export interface SheetColors {
  ink: string; fold: string; alarm: string; accent: string; lock: string; tints: string[];
}

const kMany = 6000; // edges that are drawn thin and by the graphics card
const kReach = 14; // pixels between the pointer and an edge

export class SheetView {
  private shape?: Shape;
  private ghost?: { flat: Float32Array; verdict: Verdict };
  private scale = 1;
  private left = 0; // model coordinates at the canvas' left and top
  private top = 0;
  private painter?: Painter<'sheet'>; // of large nets, on a canvas under this one
  private withoutGl = false;
  private readonly under = document.createElement('canvas');
  private painted: { model?: Model; snapshot?: Snapshot } = {}; // that it knows
  readonly redraw = onceAFrame(() => this.draw());
  private readonly context: CanvasRenderingContext2D;
  private fitted = true; // shows all; a view that someone chose is kept when the window changes
  edge = -1; // under the pointer or the keys

  constructor(
    private readonly canvas: HTMLCanvasElement, private readonly script: string, private readonly colors: () => SheetColors,
    private readonly onPoint: (edge: number) => void, private readonly onClick: (edge: number, event: PointerEvent) => void,
  ) {
    this.context = canvas.getContext('2d')!;
    this.context.fillRect(0, 0, 1, 1); // the first stroke on a canvas takes 40 ms: now, not when a file was dropped
    new ResizeObserver(() => this.resized()).observe(canvas);
    listen(canvas, {
      point: (at) => this.onPoint(at ? this.edgeAt(at.x, at.y) : -1),
      click: (at, event) => {
        const edge = this.edgeAt(at.x, at.y);
        if (edge >= 0) this.onClick(edge, event);
      },
      drag: (dx, dy) => this.move(dx, dy),
      zoom: (factor, { x, y }) => this.zoom(factor, x, y),
    });
  }

  show(shape: Shape): void {
    this.shape = shape;
    this.ghost = undefined;
    this.edge = -1;
    this.fit();
  }
  preview(ghost?: { flat: Float32Array; verdict: Verdict }): void {
    this.ghost = ghost;
    this.redraw();
  }

  fit(): void {
    if (!this.shape) return;
    const flat = this.shape.snapshot.flat;
    let [x0, x1, y0, y1] = [Infinity, -Infinity, Infinity, -Infinity];
    for (let i = 0; i < flat.length; i += 2) {
      const x = flat[i]!, y = flat[i + 1]!;
      if (x < x0) x0 = x;
      if (x > x1) x1 = x;
      if (y < y0) y0 = y;
      if (y > y1) y1 = y;
    }
    this.fitted = true;
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.scale = 0.92 * Math.min(width / Math.max(x1 - x0, 1e-30), height / Math.max(y1 - y0, 1e-30));
    this.left = (x0 + x1 - width / this.scale) / 2;
    this.top = (y0 + y1 + height / this.scale) / 2;
    this.redraw();
  }

  private resized(): void {
    if (this.fitted) this.fit();
    else this.redraw();
  }
  private move(dx: number, dy: number): void {
    this.left -= dx / this.scale;
    this.top += dy / this.scale;
    this.fitted = false;
    this.redraw();
  }
  zoom(factor: number, x = this.canvas.clientWidth / 2, y = this.canvas.clientHeight / 2): void {
    const before = this.toModel(x, y);
    this.scale *= factor;
    this.fitted = false;
    this.left = before[0] - x / this.scale;
    this.top = before[1] + y / this.scale;
    this.redraw();
  }

  private toModel(x: number, y: number): [number, number] {
    return [this.left + x / this.scale, this.top - y / this.scale];
  }

  /** The edge nearest to a place of the canvas, as it lies; -1 when none is near. */
  private edgeAt(x: number, y: number): number {
    if (!this.shape) return -1;
    const [px, py] = this.toModel(x, y);
    const { model, next, snapshot: { flat } } = this.shape;
    let best = -1, least = (kReach / this.scale) ** 2;
    for (let c = 0; c < next.length; ++c) {
      const d = next[c]!;
      const ax = flat[2 * c]!, ay = flat[2 * c + 1]!, ux = flat[2 * d]! - ax, uy = flat[2 * d + 1]! - ay;
      const t = Math.max(0, Math.min(1, ((px - ax) * ux + (py - ay) * uy) / (ux * ux + uy * uy)));
      const distance = (ax + t * ux - px) ** 2 + (ay + t * uy - py) ** 2;
      if (distance < least) least = distance, best = model.cornerEdges[c]!;
    }
    return best;
  }

  private draw(): void {
    const { canvas, context, shape } = this;
    const ratio = devicePixelRatio;
    if (canvas.width !== Math.round(canvas.clientWidth * ratio)) canvas.width = Math.round(canvas.clientWidth * ratio);
    if (canvas.height !== Math.round(canvas.clientHeight * ratio)) canvas.height = Math.round(canvas.clientHeight * ratio);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    if (!shape) return;
    const s = this.scale * ratio;
    const drawn = shape.model.edges > kMany && this.drawMany(shape, s);
    this.under.hidden = !drawn;
    context.setTransform(s, 0, 0, -s, -this.left * s, this.top * s);
    if (!drawn) this.drawFaces(shape);
    if (shape.overlapping.size) this.hatch(this.outline(shape, shape.snapshot.flat, shape.overlapping), this.colors().alarm, ratio);
    this.drawLines(shape, ratio, drawn);
    if (this.edge >= 0) this.drawEdge(shape, this.edge, ratio);
    if (this.ghost) this.drawGhost(shape, this.ghost, ratio);
  }

  private outline(shape: Shape, flat: Float32Array, faces: Iterable<number>): Path2D {
    const path = new Path2D();
    for (const f of faces) {
      const start = shape.model.offsets[f]!, end = shape.model.offsets[f + 1]!;
      path.moveTo(flat[2 * start]!, flat[2 * start + 1]!);
      for (let c = start + 1; c < end; ++c) path.lineTo(flat[2 * c]!, flat[2 * c + 1]!);
      path.lineTo(flat[2 * start]!, flat[2 * start + 1]!); // closePath() takes 2 s in 20,000 faces
    }
    return path;
  }

  private drawMany(shape: Shape, scale: number): boolean {
    if (this.withoutGl) return false;
    const { model, snapshot } = shape, painter = (this.painter ??= this.putUnder());
    if (!painter) return false;
    const { tints, fold, ink } = this.colors();
    if (this.painted.model !== model) painter.setModel({ ...model.tables, cornerEdges: model.cornerEdges });
    if (this.painted.snapshot !== snapshot) painter.setNet(snapshot.flat, snapshot.folds, snapshot.parts, tints.length);
    this.painted = { model, snapshot };
    const { width, height, offsetLeft, offsetTop, clientWidth, clientHeight } = this.canvas;
    const rgb = (hex: string): number[] => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);
    painter.draw({ left: this.left, top: this.top, scale, width, height }, tints.map(rgb), rgb(fold), rgb(ink));
    Object.assign(this.under.style, { left: `${offsetLeft}px`, top: `${offsetTop}px`, width: `${clientWidth}px`, height: `${clientHeight}px` });
    return true;
  }
  private putUnder(): Painter<'sheet'> | undefined {
    this.under.className = 'under';
    this.under.ariaHidden = 'true';
    this.canvas.before(this.under);
    return painterOn('sheet', this.under, this.script, (works) => {
      this.withoutGl = !works;
      if (!works) this.redraw();
    });
  }

  private drawFaces(shape: Shape): void {
    const { parts, flat } = shape.snapshot;
    const { tints } = this.colors();
    const byTint: number[][] = tints.map(() => []);
    parts.forEach((part, f) => byTint[part % tints.length]!.push(f));
    byTint.forEach((faces, t) => {
      this.context.fillStyle = tints[t]!;
      this.context.fill(this.outline(shape, flat, faces));
    });
  }

  private hatch(path: Path2D, color: string, ratio: number): void {
    const tile = document.createElement('canvas');
    tile.width = tile.height = Math.round(8 * ratio);
    const pen = tile.getContext('2d')!;
    pen.strokeStyle = color;
    pen.lineWidth = 2 * ratio;
    pen.beginPath();
    pen.moveTo(0, tile.height), pen.lineTo(tile.width, 0);
    pen.stroke();
    const pattern = this.context.createPattern(tile, 'repeat')!;
    pattern.setTransform(new DOMMatrix().scale(1 / (this.scale * ratio)));
    this.context.fillStyle = pattern;
    this.context.fill(path);
  }

  private drawLines(shape: Shape, ratio: number, onlyLocks: boolean): void {
    const { folds, locks, flat } = shape.snapshot;
    if (onlyLocks && !locks.includes(1)) return;
    const paths = { fold: new Path2D(), cut: new Path2D(), lock: new Path2D() };
    for (let c = 0; c < shape.next.length; ++c) {
      const e = shape.model.cornerEdges[c]!, d = shape.next[c]!;
      if (folds[e] && shape.edgeCorners[2 * e] !== c) continue;
      for (const path of [...(onlyLocks ? [] : [folds[e] ? paths.fold : paths.cut]), ...(locks[e] ? [paths.lock] : [])]) {
        path.moveTo(flat[2 * c]!, flat[2 * c + 1]!);
        path.lineTo(flat[2 * d]!, flat[2 * d + 1]!);
      }
    }
    const { ink, fold, lock } = this.colors();
    const many = shape.model.edges > kMany;
    this.stroke(paths.lock, lock, 5 * ratio);
    this.stroke(paths.fold, fold, (many ? 0.5 : 1) * ratio, many ? [] : [4, 3]);
    this.stroke(paths.cut, ink, (many ? 0.8 : 1.6) * ratio);
  }

  private stroke(path: Path2D, color: string, pixels: number, dash: number[] = []): void {
    const unit = 1 / (this.scale * devicePixelRatio);
    this.context.strokeStyle = color;
    this.context.lineWidth = pixels * unit;
    this.context.lineJoin = this.context.lineCap = 'round';
    this.context.setLineDash(dash.map((d) => (d * devicePixelRatio) * unit));
    this.context.stroke(path);
    this.context.setLineDash([]);
  }

  /** Both copies of an edge, and a line between them when it is cut. */
  private drawEdge(shape: Shape, edge: number, ratio: number): void {
    const path = new Path2D(), flat = shape.snapshot.flat;
    const middles: [number, number][] = [];
    for (const c of [shape.edgeCorners[2 * edge]!, shape.edgeCorners[2 * edge + 1]!]) {
      if (c < 0) continue;
      const d = shape.next[c]!;
      path.moveTo(flat[2 * c]!, flat[2 * c + 1]!);
      path.lineTo(flat[2 * d]!, flat[2 * d + 1]!);
      middles.push([(flat[2 * c]! + flat[2 * d]!) / 2, (flat[2 * c + 1]! + flat[2 * d + 1]!) / 2]);
    }
    const { accent } = this.colors();
    this.stroke(path, accent, 5 * ratio);
    if (middles.length < 2 || shape.snapshot.folds[edge]) return;
    const bridge = new Path2D();
    bridge.moveTo(...middles[0]!);
    bridge.lineTo(...middles[1]!);
    this.stroke(bridge, accent, 1.5 * ratio, [2, 5]);
  }

  private drawGhost(shape: Shape, ghost: { flat: Float32Array; verdict: Verdict }, ratio: number): void {
    const moved: number[] = [], now = shape.snapshot.flat, eps = 2 / this.scale;
    for (let f = 0; f + 1 < shape.model.offsets.length; ++f) {
      const c = 2 * shape.model.offsets[f]!;
      if (Math.abs(ghost.flat[c]! - now[c]!) + Math.abs(ghost.flat[c + 1]! - now[c + 1]!) > eps) moved.push(f);
    }
    const { accent, alarm } = this.colors();
    const path = this.outline(shape, ghost.flat, moved);
    this.context.globalAlpha = 0.22;
    this.context.fillStyle = accent;
    this.context.fill(path);
    this.context.globalAlpha = 1;
    this.stroke(path, accent, 1.2 * ratio);
    const clash = new Set(ghost.verdict.pairs.flat());
    if (clash.size) this.hatch(this.outline(shape, ghost.flat, clash), alarm, ratio);
  }
}
