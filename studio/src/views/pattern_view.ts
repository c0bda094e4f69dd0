// A crease pattern as SVG: what is drawn, what the pointer would draw, and what is wrong at which vertex.
import { along, distance, kKindNames, nearestOn, type Line, type Pattern, type Point } from '../pattern';

export interface VertexNote {
  name: string; // as the problems call it
  at: Point;
  fine: boolean;
  text: string;
}

const kReach = 14; // pixels
const kTurn = Math.PI / 8; // 22.5 degrees
const kAround = 0.06; // of the sheet, left free

function made(tag: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}

export class PatternView {
  private pattern?: Pattern;
  private size: Point = { x: 1, y: 1 };
  private readonly layers: Record<'lines' | 'locks' | 'notes' | 'draft', SVGElement>;

  constructor(private readonly svg: SVGSVGElement) {
    this.layers = { lines: made('g', {}), locks: made('g', {}), notes: made('g', {}), draft: made('g', { 'pointer-events': 'none' }) };
    svg.append(...Object.values(this.layers));
    new ResizeObserver(() => this.redraw()).observe(svg);
  }
  redraw = (): void => undefined; // set by show()

  show(pattern: Pattern, chosen: Line | undefined, notes: VertexNote[], wrong: ReadonlySet<Line>, locked: Line[]): void {
    this.pattern = pattern;
    this.redraw = () => this.show(pattern, chosen, notes, wrong, locked);
    const points = pattern.points;
    this.size = { x: Math.max(1e-9, ...points.map((p) => p.x)), y: Math.max(1e-9, ...points.map((p) => p.y)) };
    const most = Math.max(this.size.x, this.size.y), free = kAround * most;
    this.svg.setAttribute('viewBox', [-free, -free, this.size.x + 2 * free, this.size.y + 2 * free].join(' '));
    const unit = this.unit();
    this.layers.lines.replaceChildren(...pattern.lines.map((line) => {
      const place = { x1: line.a.x, y1: this.size.y - line.a.y, x2: line.b.x, y2: this.size.y - line.b.y };
      return made('line', { ...place, class: `crease ${kKindNames[line.kind]}${line === chosen ? ' chosen' : ''}${wrong.has(line) ? ' wrong' : ''}` });
    }));
    this.layers.locks.replaceChildren(...locked.map(({ a, b }) => {
      const x = (a.x + b.x) / 2, y = this.size.y - (a.y + b.y) / 2;
      return made('rect', { x: x - 5 * unit, y: y - 5 * unit, width: 10 * unit, height: 10 * unit, class: 'lock' });
    }));
    this.layers.notes.replaceChildren(...notes.flatMap(({ name, at, fine, text }) => {
      const mark = made('circle', { cx: at.x, cy: this.size.y - at.y, r: (fine ? 4 : 8) * unit, class: fine ? 'vertex fine' : 'vertex wrong' });
      const title = made('title', {});
      title.textContent = text;
      mark.append(title);
      if (fine) return [mark];
      const number = made('text', { x: at.x + 11 * unit, y: this.size.y - at.y - 8 * unit, 'font-size': 15 * unit, class: 'vertex-name' });
      number.textContent = name;
      return [mark, number];
    }));
  }

  /** The line that would be drawn, and where the pointer is taken to be. */
  draft(from: Point | undefined, to: Point | undefined): void {
    const unit = this.unit(), y = (p: Point): number => this.size.y - p.y;
    const parts: SVGElement[] = [];
    if (from && to) parts.push(made('line', { x1: from.x, y1: y(from), x2: to.x, y2: y(to), class: 'draft' }));
    for (const p of [from, to]) if (p) parts.push(made('circle', { cx: p.x, cy: y(p), r: 5 * unit, class: 'draft' }));
    this.layers.draft.replaceChildren(...parts);
  }

  place(event: MouseEvent): Point {
    const matrix = this.svg.getScreenCTM();
    if (!matrix) return { x: 0, y: 0 };
    const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    return { x: p.x, y: this.size.y - p.y };
  }
  get extent(): Point {
    return this.size;
  }
  /** Of the sheet, in a pixel. */
  private unit(): number {
    const scale = this.svg.getScreenCTM()?.a ?? 0;
    return scale > 0 ? 1 / scale : Math.max(this.size.x, this.size.y) / 500;
  }

  lineAt(p: Point): Line | undefined {
    let best: Line | undefined, least = kReach * this.unit();
    for (const line of this.pattern?.lines ?? []) {
      const far = distance(nearestOn(line, p), p);
      if (far < least) least = far, best = line;
    }
    return best;
  }

  /** A vertex nearby; else, from a place, a multiple of 22.5 degrees up to a line that it meets; else a line nearby. */
  snapped(p: Point, from?: Point): Point {
    const pattern = this.pattern!, reach = kReach * this.unit();
    const near = pattern.points.filter((q) => distance(p, q) < reach).sort((a, b) => distance(p, a) - distance(p, b))[0];
    if (near) return near;
    const line = this.lineAt(p);
    if (!from) {
      if (!line) return this.inside(p);
      const t = along(line, p), middle = { x: (line.a.x + line.b.x) / 2, y: (line.a.y + line.b.y) / 2 };
      return t > 0 && t < 1 && distance(middle, p) < reach ? middle : nearestOn(line, p);
    }
    const angle = Math.round(Math.atan2(p.y - from.y, p.x - from.x) / kTurn) * kTurn;
    const u = { x: Math.cos(angle), y: Math.sin(angle) };
    const far = (p.x - from.x) * u.x + (p.y - from.y) * u.y;
    const stops = this.stops(from, u).filter((t) => Math.abs(t - far) < 2 * reach).sort((a, b) => Math.abs(a - far) - Math.abs(b - far));
    const t = stops[0] ?? far, straight = { x: from.x + t * u.x, y: from.y + t * u.y };
    if (line && !stops.length && distance(straight, p) > reach) return nearestOn(line, p);
    return stops.length ? straight : this.inside(straight);
  }
  /** How far along a ray other lines are. */
  stops(from: Point, u: Point): number[] {
    const found: number[] = [];
    for (const { a, b } of this.pattern!.lines) {
      const e = { x: b.x - a.x, y: b.y - a.y }, turn = u.x * e.y - u.y * e.x;
      if (Math.abs(turn) < 1e-12) continue;
      const d = { x: a.x - from.x, y: a.y - from.y };
      const t = (d.x * e.y - d.y * e.x) / turn, s = (d.x * u.y - d.y * u.x) / turn;
      if (t > 1e-9 && s > -1e-9 && s < 1 + 1e-9) found.push(t);
    }
    return found.sort((a, b) => a - b);
  }
  private inside({ x, y }: Point): Point {
    return { x: Math.max(0, Math.min(this.size.x, x)), y: Math.max(0, Math.min(this.size.y, y)) };
  }
}
