// A crease pattern: draw, assign, mirror, undo; the core judges it after every edit.
import { Refused } from '../core/client';
import type { Progress } from '../core/protocol';
import { History } from '../history';
import { byId, download } from '../page';
import {
  distance, keyOf, kindsIn, kKindNames, kKinds, mirrored, Pattern, patternOf, patternOfCp, square, type Kind, type Line, type Mirror, type PatternEdit, type Point,
} from '../pattern';
import type { Session } from '../session';
import { keepPattern, keptPattern } from '../store';
import { PatternView, type VertexNote } from '../views/pattern_view';

type Guarded = (work: () => Promise<void>) => Promise<void>;
type Tool = 'draw' | 'assign' | 'lock' | 'erase';
const kTools: Tool[] = ['draw', 'assign', 'lock', 'erase'];
interface PatternStep {
  name: string;
  edit: PatternEdit;
  inverse: PatternEdit;
}
interface Problem {
  severity: 'error' | 'warning' | 'note';
  code: string;
  message: string;
  suggestion: string;
  edges: number[];
  vertices: number[];
}

const kFile = 'pattern.fold';
const kStep = 1 / 16, kSmallStep = 1 / 64; // of the sheet, for the keys
const kMostListed = 30;
const kLargestFile = 4_000_000; // bytes

export class PatternPanel {
  private pattern = square();
  private readonly history = new History<PatternStep>();
  private readonly view: PatternView;
  private tool: Tool = 'draw';
  private kind: Kind = 'M';
  private from?: Point; // where a line begins that is not yet drawn
  private cursor: Point = { x: 0.5, y: 0.5 }; // of the keys
  private chosen?: Line;
  private judged = 0;
  private loading?: Promise<void>;
  private problems: Problem[] = [];
  private readonly locks = new Set<string>(); // keys of lines that keep their kind when mountains and valleys are sought
  private named = ''; // the pattern that the numbers are of

  constructor(
    private readonly session: Session, private readonly guarded: Guarded, private readonly say: (text: string, kind?: 'fine' | 'bad') => void,
    private readonly progress: (p: Progress) => void, private readonly stepped: () => void,
    private readonly hand: (name: string, bytes: Uint8Array, job: string) => Promise<void>,
  ) {
    const svg = document.getElementById('pattern') as unknown as SVGSVGElement;
    this.view = new PatternView(svg);
    svg.addEventListener('pointermove', (e) => this.moved(e));
    svg.addEventListener('pointerdown', (e) => this.pressed(e));
    svg.addEventListener('pointerup', (e) => this.released(e));
    svg.addEventListener('pointerleave', () => this.view.draft(this.from, undefined));
    for (const tool of kTools) byId(`tool-${tool}`).addEventListener('click', () => this.use(tool));
    for (const kind of kKinds) byId(`kind-${kind}`).addEventListener('click', () => this.setKind(kind));
    byId('pattern-new').addEventListener('click', () => this.replace('a new sheet', square()));
    byId<HTMLSelectElement>('pattern-name').addEventListener('change', (e) => void this.makeNamed(e.target as HTMLSelectElement));
    byId<HTMLInputElement>('pattern-file').addEventListener('change', ({ target }) => {
      const input = target as HTMLInputElement, file = input.files?.[0];
      if (file) void this.open(file).then(() => (input.value = ''));
    });
    byId('pattern-find').addEventListener('click', () => void this.find(false));
    byId('pattern-anew').addEventListener('click', () => void this.find(true));
    byId('pattern-numbers').addEventListener('change', () => void this.make());
    byId('pattern-numbers').addEventListener('submit', (e) => e.preventDefault());
    byId('pattern-save').addEventListener('click', () => download(kFile, this.bytes()));
    byId('pattern-fold').addEventListener('click', () => void this.hand(kFile, this.bytes(), 'fold'));
    byId('pattern-print').addEventListener('click', () => void this.hand(kFile, this.bytes(), 'print'));
  }

  private load(): Promise<void> {
    return (this.loading ??= (async () => {
      const kept = await keptPattern();
      this.pattern = (kept && patternOf(kept)) || this.pattern;
      await this.guarded(() => this.fillNames());
    })());
  }
  async shown(): Promise<void> {
    await this.load();
    this.show();
    await this.judge();
  }
  private bytes(): Uint8Array<ArrayBuffer> {
    return new TextEncoder().encode(this.pattern.fold('pattern'));
  }
  get text(): string {
    return this.pattern.fold('pattern');
  }

  // --- edits

  edit(name: string, edit: PatternEdit): void {
    if (!edit.add.length && !edit.remove.length) return;
    const inverse = this.pattern.apply(edit);
    this.history.add({ name, edit, inverse });
    this.chosen = undefined;
    this.changed();
    this.say(name);
  }
  undo(): void {
    const step = this.history.undoable;
    if (!step) return this.say('undone: nothing');
    this.pattern.apply(step.inverse);
    this.history.undone();
    this.changed();
    this.say(`undone: ${step.name}`);
  }
  redo(): void {
    const step = this.history.redoable;
    if (!step) return this.say('done again: nothing');
    this.pattern.apply(step.edit);
    this.history.redone();
    this.changed();
    this.say(`done again: ${step.name}`);
  }
  get steps(): History<PatternStep> {
    return this.history;
  }
  replace(name: string, by: Pattern): void {
    this.from = undefined;
    byId('pattern-numbers').hidden = true;
    this.locks.clear();
    this.edit(name, { remove: this.pattern.lines, add: by.lines });
  }
  private changed(): void {
    this.chosen = undefined;
    this.problems = [];
    this.show();
    void keepPattern(this.text);
    void this.judge();
  }

  draw(from: Point, to: Point): void {
    const mirror = byId<HTMLSelectElement>('pattern-mirror').value as Mirror, size = this.view.extent;
    const edit = this.pattern.drawing(from, to, this.kind);
    const image = [mirrored(from, mirror, size), mirrored(to, mirror, size)] as const;
    if (mirror === 'none') return this.edit(`draw a ${kKindNames[this.kind]}`, edit);
    // The second line is drawn on a sheet that has the first; both are one step.
    const inverse = this.pattern.apply(edit), second = this.pattern.drawing(...image, this.kind);
    this.pattern.apply(inverse);
    this.edit(`draw a ${kKindNames[this.kind]} and its mirror image`, bothOf(edit, second));
  }
  private mirrorOf(line: Line): Line[] {
    const mirror = byId<HTMLSelectElement>('pattern-mirror').value as Mirror, size = this.view.extent;
    if (mirror === 'none') return [line];
    const ends = [line.a, line.b].map((p) => mirrored(p, mirror, size)) as [Point, Point];
    const near = (p: Point, q: Point): boolean => distance(p, q) < 1e-9;
    const other = this.pattern.lines.find(({ a, b }) => (near(a, ends[0]) && near(b, ends[1])) || (near(a, ends[1]) && near(b, ends[0])));
    return other && other !== line ? [line, other] : [line];
  }
  private assign(line: Line, kind: Kind): void {
    const lines = this.mirrorOf(line);
    this.edit(`${kKindNames[line.kind]} to ${kKindNames[kind]}`, { remove: lines, add: lines.map((l) => ({ ...l, kind })) });
  }
  private lock(line: Line): void {
    const is = this.locks.has(keyOf(line));
    for (const one of this.mirrorOf(line)) this.locks[is ? 'delete' : 'add'](keyOf(one));
    this.show();
    this.say(`${is ? 'unlocked' : 'locked'}: a ${kKindNames[line.kind]}${is ? '' : ' keeps its kind when mountains and valleys are sought'}`);
  }
  private erase(line: Line): void {
    this.edit(`erase a ${kKindNames[line.kind]}`, this.pattern.erasing(this.mirrorOf(line)));
  }

  // --- pointer

  private moved(event: PointerEvent): void {
    if (this.tool !== 'draw') return;
    this.view.draft(this.from, this.view.snapped(this.view.place(event), this.from));
  }
  private pressed(event: PointerEvent): void {
    if (this.tool !== 'draw' || this.from) return;
    this.from = this.view.snapped(this.view.place(event));
    this.view.draft(this.from, this.from);
  }
  /** A line is two clicks, or one drag. */
  private released(event: PointerEvent): void {
    const p = this.view.place(event), line = this.view.lineAt(p);
    if (this.tool === 'assign') {
      if (line) this.assign(line, line.kind === this.kind ? kKinds[(kKinds.indexOf(line.kind) + 1) % kKinds.length]! : this.kind);
      return;
    }
    if (this.tool === 'erase' || this.tool === 'lock') {
      if (line) this.tool === 'erase' ? this.erase(line) : this.lock(line);
      return;
    }
    if (!this.from) return;
    const to = this.view.snapped(p, this.from);
    if (distance(this.from, to) < 1e-3) return; // the first of two clicks
    const from = this.from;
    this.from = undefined;
    this.draw(from, to);
    this.view.draft(undefined, undefined);
  }

  // --- keys

  key(event: KeyboardEvent): boolean {
    const letter = kKinds.find((kind) => kind === event.key.toUpperCase());
    if (letter) {
      if (this.chosen) this.assign(this.chosen, letter);
      else this.setKind(letter);
      return true;
    }
    const step = event.shiftKey ? kSmallStep : kStep;
    const actions: Record<string, () => void> = {
      ArrowLeft: () => this.go(-step, 0), ArrowRight: () => this.go(step, 0), ArrowUp: () => this.go(0, step), ArrowDown: () => this.go(0, -step),
      Enter: () => this.strike(), n: () => this.nextPoint(1), N: () => this.nextPoint(-1), '[': () => this.choose(-1), ']': () => this.choose(1),
      Delete: () => this.chosen && this.erase(this.chosen), Backspace: () => this.chosen && this.erase(this.chosen),
      Escape: () => this.forget(), d: () => this.use('draw'), a: () => this.use('assign'), e: () => this.use('erase'),
      l: () => (this.chosen ? this.lock(this.chosen) : this.use('lock')),
    };
    actions[event.key]?.();
    return event.key in actions;
  }
  private forget(): void {
    this.from = this.chosen = undefined;
    this.show();
  }
  private go(x: number, y: number): void {
    const { extent } = this.view, onGrid = (value: number, by: number): number => (by ? Math.round((value + by) / Math.abs(by)) * Math.abs(by) : value);
    this.cursor = { x: Math.max(0, Math.min(extent.x, onGrid(this.cursor.x, x))), y: Math.max(0, Math.min(extent.y, onGrid(this.cursor.y, y))) };
    this.tellCursor();
  }
  private nextPoint(by: number): void {
    const { points } = this.pattern;
    const here = points.findIndex((p) => distance(p, this.cursor) < 1e-9);
    this.cursor = points[(here + by + points.length) % points.length] ?? this.cursor;
    this.tellCursor();
  }
  private tellCursor(): void {
    this.view.draft(this.from, this.cursor);
    const at = `${this.cursor.x.toFixed(3)} ${this.cursor.y.toFixed(3)}`;
    this.say(this.from ? `to ${at}: Enter draws the ${kKindNames[this.kind]}` : `at ${at}: Enter begins a line`);
  }
  private strike(): void {
    if (!this.from) {
      this.from = this.cursor;
      return this.tellCursor();
    }
    const from = this.from;
    this.from = undefined;
    this.draw(from, this.cursor);
    this.view.draft(undefined, this.cursor);
  }
  private choose(by: number): void {
    const { lines } = this.pattern;
    const here = this.chosen ? lines.indexOf(this.chosen) : by > 0 ? -1 : 0;
    this.chosen = lines[(here + by + lines.length) % lines.length];
    this.show();
    if (!this.chosen) return;
    const { a, b, kind } = this.chosen;
    this.say(`line ${lines.indexOf(this.chosen)}, ${kKindNames[kind]}${this.locks.has(keyOf(this.chosen)) ? ', locked' : ''}, ${a.x.toFixed(3)} ${a.y.toFixed(3)} to ${b.x.toFixed(3)} ${b.y.toFixed(3)} · M V F U B give it a kind, L locks it, Delete erases it`);
  }

  private use(tool: Tool): void {
    this.tool = tool;
    this.from = undefined;
    for (const t of kTools) byId(`tool-${t}`).setAttribute('aria-pressed', String(t === tool));
    byId('pattern').dataset['tool'] = tool;
    this.view.draft(undefined, undefined);
  }
  private setKind(kind: Kind): void {
    this.kind = kind;
    for (const k of kKinds) byId(`kind-${k}`).setAttribute('aria-pressed', String(k === kind));
  }

  // --- what the core says of it

  private async judge(): Promise<void> {
    const ticket = ++this.judged;
    try {
      const { report } = await this.session.job('origami info', [['PATTERN', kFile]], { [kFile]: this.bytes() });
      if (ticket !== this.judged) return;
      this.problems = (report['problems'] as Problem[] | undefined) ?? [];
      this.tell((report['real_vertices'] as { vertex: number; mountains: number; valleys: number; kawasaki_deg: number; edges: number[] }[] | undefined) ?? []);
    } catch (error) {
      if (ticket !== this.judged) return;
      const { message, suggestion } = (error as { failure?: { message: string; suggestion: string } }).failure ?? { message: String(error), suggestion: '' };
      this.problems = [{ severity: 'error', code: '', message, suggestion, edges: [], vertices: [] }];
      this.tell([]);
    }
  }
  private tell(real: { vertex: number; mountains: number; valleys: number; kawasaki_deg: number; edges: number[] }[]): void {
    const { points } = this.pattern;
    const wrong = this.problems.filter(({ severity }) => severity !== 'note');
    const notes: VertexNote[] = real.map(({ vertex, mountains, valleys, kawasaki_deg, edges }) => {
      const told = wrong.filter(({ vertices }) => vertices.includes(vertex)).map(({ message }) => message);
      const facts = `vertex ${vertex}: ${edges.length} creases, ${mountains} mountain, ${valleys} valley, Kawasaki off by ${kawasaki_deg.toFixed(3)}°`;
      return { name: String(vertex), at: points[vertex]!, fine: !told.length, text: [facts, ...told].join('; ') };
    });
    this.show(notes);
    const badge = byId('pattern-verdict');
    const errors = this.problems.filter(({ severity }) => severity === 'error').length;
    badge.dataset['status'] = wrong.length ? 'bad' : 'good';
    badge.textContent = errors ? 'not a pattern' : wrong.length ? `${wrong.length} ${wrong.length === 1 ? 'thing' : 'things'} wrong` : real.length ? `${real.length} ${real.length === 1 ? 'vertex' : 'vertices'} fine` : 'nothing to fold yet';
    byId('pattern-problems').replaceChildren(...this.problems.slice(0, kMostListed).map(({ severity, message, suggestion }) => {
      const item = document.createElement('li');
      item.className = severity;
      item.textContent = suggestion && severity !== 'note' ? `${message}; ${suggestion}` : message;
      return item;
    }));
  }
  private notes: VertexNote[] = [];
  private show(notes: VertexNote[] = []): void {
    this.notes = notes.length || !this.chosen ? notes : this.notes;
    const { lines } = this.pattern;
    const wrong = new Set(this.problems.filter(({ severity }) => severity !== 'note').flatMap(({ edges }) => edges.map((e) => lines[e]!)));
    this.view.show(this.pattern, this.chosen, this.notes, wrong, lines.filter((line) => this.locks.has(keyOf(line))));
    this.stepped();
  }

  // --- from elsewhere

  private async fillNames(): Promise<void> {
    const { report } = await this.session.job('origami make', [['list', 'true']], {});
    for (const { name, description } of report['patterns'] as { name: string; description: string }[])
      byId<HTMLSelectElement>('pattern-name').append(new Option(`${name} · ${description}`, name));
  }
  private makeNamed(choice: HTMLSelectElement): Promise<void> {
    this.named = choice.value || this.named;
    choice.value = '';
    byId<HTMLFormElement>('pattern-numbers').reset();
    return this.make();
  }
  /** The named pattern, with the numbers that were filled in. */
  private make(): Promise<void> {
    const { named } = this, form = byId<HTMLFormElement>('pattern-numbers');
    if (!named) return Promise.resolve();
    return this.guarded(async () => {
      const filled = [...new FormData(form)].filter(([, value]) => value).map(([name, value]): [string, string] => [name, name === 'diagonals' ? 'true' : `${String(value)}${name === 'size' ? '' : 'deg'}`]);
      const { files } = await this.session.job('origami make', [['name', named], ...filled, ['output', kFile]], {});
      this.replace([named, ...filled.map(([name, value]) => `${name} ${value}`)].join(', '), patternOf(new TextDecoder().decode(files[kFile]))!);
      byId('pattern-made').textContent = `${named}: its numbers`;
      form.hidden = false;
    });
  }

  /** Mountains and valleys for lines that are either; `anew`: for all that are not locked. */
  private find(anew: boolean): Promise<void> {
    return this.guarded(async () => {
      const { lines } = this.pattern, free = new Set(lines.filter((line) => line.kind === 'U' || (anew && 'MV'.includes(line.kind) && !this.locks.has(keyOf(line)))));
      if (!free.size) return this.say('no line is either a mountain or a valley: give some the kind U, or seek all anew');
      const asked = new Pattern(lines.map((line) => (free.has(line) ? { ...line, kind: 'U' as Kind } : line))).fold('pattern');
      const { files, messages } = await this.session.job('origami assign', [['PATTERN', 'asked.fold'], ['output', kFile]], { 'asked.fold': new TextEncoder().encode(asked) }, this.progress);
      const told = messages.filter(({ tone }) => tone !== 'detail').map(({ text }) => text.trim()), found = files[kFile];
      if (!found) return this.say(told.at(-1) ?? 'none was found', 'bad');
      const kinds = kindsIn(new TextDecoder().decode(found), [...free]), changed = [...kinds].filter(([line, kind]) => line.kind !== kind);
      this.edit('find mountains and valleys', { remove: changed.map(([line]) => line), add: changed.map(([line, kind]) => ({ ...line, kind })) });
      this.say(told.slice(-2).join(' · '));
    });
  }
  /** A drawing of another kind, as the core reads it. */
  private async read(file: File): Promise<Pattern | undefined> {
    const bytes = new Uint8Array(await file.arrayBuffer());
    const { files } = await this.session.job('export', [['file', file.name], ['output', kFile]], { [file.name]: bytes }, this.progress);
    return files[kFile] && patternOf(new TextDecoder().decode(files[kFile]));
  }
  open(file: File): Promise<void> {
    return this.guarded(async () => {
      await this.load();
      if (file.size > kLargestFile) throw refused('studio/pattern-too-large', `a file of ${file.size} bytes, where ${kLargestFile} fit`, file.name);
      const text = await file.text(), kind = file.name.slice(file.name.lastIndexOf('.') + 1).toLowerCase();
      const pattern = kind === 'cp' ? patternOfCp(text) : kind === 'fold' ? patternOf(text) : await this.read(file);
      if (!pattern) throw refused('studio/no-pattern', 'no crease pattern is in this file', file.name);
      this.replace(`open ${file.name}`, pattern);
    });
  }
}

const refused = (code: string, message: string, where: string): Refused =>
  new Refused({ code, message, where, suggestion: 'a drawing with lines: .cp, .opx, .ori, SVG, or FOLD with vertices and edges' });

/** What two edits one after the other change. */
function bothOf(first: PatternEdit, second: PatternEdit): PatternEdit {
  const isIn = (line: Line, lines: Line[]): boolean => lines.includes(line);
  return {
    remove: [...first.remove, ...second.remove.filter((line) => !isIn(line, first.add))],
    add: [...first.add.filter((line) => !isIn(line, second.remove)), ...second.add],
  };
}
