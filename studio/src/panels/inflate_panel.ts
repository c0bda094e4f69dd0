// Inflation, step by step or as far as it helps, with faces and vertices that stay where they are.
import type { Inflated, InflateOptions, JobValues, Progress } from '../core/protocol';
import { byId, download } from '../page';
import type { Session } from '../session';
import type { Shape } from '../views/shape';
import type { Decor, SpaceView } from '../views/space_view';

type Guarded = (work: () => Promise<void>) => Promise<void>;
type Brush = 'turn' | 'faces' | 'vertices';

// Of the dissertation's page, in the library's units; [option of plico inflate, what it is, least, most, as it begins, step].
const kSliders = [
  ['pressure', 'Pressure', 0.01, 1, 0.1, 0.01], ['stiffness', 'Stiffness of edges', 0.5, 5, 1, 0.1], ['time-step', 'Step of time', 0.002, 0.04, 0.01, 0.002],
  ['stiff-edges', 'Features stiffer by', 1, 50, 10, 1], ['deep-angle', 'Deep valleys from', 1, 180, 70, 1], ['anchors', 'Held to its place', 0, 2, 0.05, 0.05],
  ['max-growth', 'Best: volume may change by', 1, 50, 5, 1],
] as const;
const kUnits: Partial<Record<string, string>> = { 'deep-angle': '°', 'max-growth': ' %' };
const kMostSteps = 100_000;
const kLiveGrowth = 5; // of the volume, as a share: who steps sees it, and stops
const kHoldAfter = 300; // milliseconds: a longer press runs

export class InflatePanel {
  private shape?: Shape;
  private open = false;
  private fresh = false; // what the core has begun is of these options and this model
  private running = false;
  private now?: Inflated;
  private best?: { bytes: Uint8Array; corners: Float32Array };
  private readonly faces = new Set<number>();
  private readonly vertices = new Set<number>();
  private brush: Brush = 'turn';
  private at = -1; // the face or vertex that the keys stand at
  private holding = 0;
  private painted = new Set<number>(); // of this drag

  constructor(
    private readonly session: Session, private readonly space: SpaceView, private readonly guarded: Guarded,
    private readonly progress: (p: Progress) => void, private readonly say: (text: string) => void,
    private readonly openModel: (name: string, bytes: Uint8Array) => Promise<void>,
  ) {
    for (const [name, label, least, most, value, step] of kSliders) byId('inflate-sliders').append(this.slider(name, label, least, most, value, step));
    byId('inflate-uniform').addEventListener('change', () => this.changed());
    const on = (id: string, act: () => unknown): void => byId(id).addEventListener('click', () => void act());
    on('inflate-step', () => this.step());
    on('inflate-run', () => this.run(!this.running));
    on('inflate-reset', () => this.reset());
    on('inflate-best', () => this.findBest());
    on('inflate-use', () => this.use());
    on('inflate-save', () => this.save());
    on('pins-clear', () => this.clearPins());
    for (const brush of ['turn', 'faces', 'vertices'] as const) on(`brush-${brush}`, () => this.setBrush(brush));
    const before = byId('inflate-before');
    before.addEventListener('pointerdown', () => this.shape && this.space.place(this.shape.model.corners));
    for (const end of ['pointerup', 'pointerleave', 'blur']) before.addEventListener(end, () => this.draw());
    before.addEventListener('keydown', (e) => (e.key === 'Enter' || e.key === ' ') && this.shape && this.space.place(this.shape.model.corners));
    before.addEventListener('keyup', () => this.draw());
  }

  private slider(name: string, label: string, least: number, most: number, value: number, step: number): HTMLElement {
    const row = document.createElement('label'), input = document.createElement('input'), now = document.createElement('output');
    const unit = kUnits[name] ?? '';
    Object.assign(input, { type: 'range', min: String(least), max: String(most), step: String(step), value: String(value), id: `inflate-${name}` });
    const tell = (): void => {
      now.textContent = `${input.value}${unit}`;
      input.setAttribute('aria-valuetext', `${input.value}${unit}`);
    };
    input.addEventListener('input', () => (tell(), this.changed()));
    tell();
    const text = document.createElement('span');
    text.textContent = label;
    row.append(text, input, now);
    return row;
  }
  private value(name: string): number {
    return Number(byId<HTMLInputElement>(`inflate-${name}`).value);
  }

  newModel(shape: Shape): void {
    this.shape = shape;
    this.faces.clear();
    this.vertices.clear();
    this.at = -1;
    this.changed();
  }
  edited(shape: Shape): void {
    this.shape = shape; // the mesh is the same
  }
  shown(open: boolean): void {
    if (open === this.open) return;
    this.open = open;
    this.running = false;
    this.space.setBrush(undefined);
    this.space.decorate(undefined);
    if (!open || !this.shape) return;
    this.space.show(this.shape, this.shape.model.corners, true, true);
    this.setBrush(this.brush);
    this.draw();
    if (!this.fresh) void this.guarded(() => this.begin());
  }

  options(): InflateOptions {
    return {
      pressure: this.value('pressure'), stiffness: this.value('stiffness'), time_step: this.value('time-step'), stiff_edges: this.value('stiff-edges'),
      deep_angle_deg: this.value('deep-angle'), anchors: this.value('anchors'), max_growth: kLiveGrowth, max_steps: kMostSteps,
      constrained: !byId<HTMLInputElement>('inflate-uniform').checked, keep: this.kept(this.faces), keep_vertices: this.kept(this.vertices),
    };
  }
  private kept(of: Set<number>): number[] {
    return [...of].sort((a, b) => a - b);
  }
  /** What makes this shape on the command line. */
  private values(steps: number): JobValues {
    const numbers = ['pressure', 'stiffness', 'time-step', 'stiff-edges', 'anchors'].map((name): [string, string] => [name, String(this.value(name))]);
    return [['method', 'explicit'], ['max-steps', String(steps)], ...numbers, ['deep-angle', `${this.value('deep-angle')}deg`], ...this.pins(100 * kLiveGrowth)];
  }
  private pins(growth: number): JobValues {
    return [
      ['max-growth', `${growth}%`], ...(byId<HTMLInputElement>('inflate-uniform').checked ? [['uniform', 'true'] as [string, string]] : []),
      ...this.kept(this.faces).map((f): [string, string] => ['keep', String(f)]), ...this.kept(this.vertices).map((v): [string, string] => ['keep-vertex', String(v)]),
    ];
  }

  // --- running

  private async begin(): Promise<void> {
    this.best = undefined;
    this.now = await this.session.inflateBegin(this.options());
    this.fresh = true;
    this.tell();
  }
  step(): Promise<void> {
    return this.guarded(() => this.advance());
  }
  private async advance(): Promise<void> {
    if (!this.shape) return;
    if (!this.fresh || this.best) await this.begin();
    this.now = await this.session.inflateStep();
    if (this.now.ended) this.run(false);
    this.tell();
  }
  run(wanted: boolean): void {
    const start = wanted && !this.running;
    this.running = wanted;
    byId('inflate-run').textContent = wanted ? 'Pause' : 'Run';
    if (!start) return;
    const tick = async (): Promise<void> => {
      if (!this.running || !this.open) return;
      await this.step();
      if (this.now?.ended || !this.fresh) return this.run(false);
      requestAnimationFrame(() => void tick());
    };
    void tick();
  }
  private reset(): Promise<void> {
    this.run(false);
    return this.guarded(() => this.begin());
  }
  private changed(): void {
    this.run(false);
    this.fresh = false;
    this.now = this.best = undefined;
    byId('inflate-facts').textContent = '';
    byId('inflate-command').textContent = '';
    if (this.open && this.shape) this.draw();
  }
  /** Space: a press is a step, holding it runs. */
  key(event: KeyboardEvent): boolean {
    if (event.key === ' ') {
      if (!event.repeat && !this.holding) {
        void this.step();
        this.holding = window.setTimeout(() => this.run(true), kHoldAfter);
      }
      return true;
    }
    const actions: Record<string, () => void> = {
      r: () => void this.reset(), t: () => this.setBrush('turn'), p: () => this.setBrush('faces'), v: () => this.setBrush('vertices'),
      '[': () => this.walk(-1), ']': () => this.walk(1), Enter: () => this.at >= 0 && this.pin(this.at),
    };
    actions[event.key]?.();
    return event.key in actions;
  }
  keyUp(event: KeyboardEvent): void {
    if (event.key !== ' ' || !this.holding) return;
    clearTimeout(this.holding);
    this.holding = 0;
    this.run(false);
  }

  private findBest(): Promise<void> {
    this.run(false);
    return this.guarded(async () => {
      const { shape } = this;
      if (!shape) return;
      const pins = this.pins(this.value('max-growth'));
      const result = await this.session.job('inflate', [['mesh', 'model.obj'], ['output', 'round.obj'], ...pins], { 'model.obj': await this.session.mesh() }, this.progress);
      const bytes = result.files['round.obj'];
      if (!bytes) return this.say(result.messages.map(({ text }) => text.trim()).join(' · '));
      this.best = { bytes, corners: cornersOf(bytes, shape) };
      const { report } = result;
      this.facts(Number(report['hyperbolic']), Number(report['hyperbolic_before']), Number(report['growth']), Number(report['largest_move']), `stopped by ${String(report['stopped_by'])}`);
      this.command(pins);
      this.draw();
    });
  }
  private async bytes(): Promise<Uint8Array | undefined> {
    return this.best?.bytes ?? (this.fresh && this.now?.steps ? await this.session.inflatedMesh() : undefined);
  }
  private name(): string {
    return `${this.shape?.model.name ?? 'model'}-round.obj`;
  }
  private use(): Promise<void> {
    return this.guarded(async () => {
      const bytes = await this.bytes();
      if (bytes) await this.openModel(this.name(), bytes);
      else this.say('nothing is inflated yet: step, run, or find the best');
    });
  }
  private save(): Promise<void> {
    return this.guarded(async () => {
      const bytes = await this.bytes();
      if (bytes) download(this.name(), bytes);
      else this.say('nothing is inflated yet: step, run, or find the best');
    });
  }

  // --- pins

  setBrush(brush: Brush): void {
    this.brush = brush;
    this.at = -1;
    for (const b of ['turn', 'faces', 'vertices']) byId(`brush-${b}`).setAttribute('aria-pressed', String(b === brush));
    this.space.setBrush(brush === 'turn' ? undefined : { what: brush, begin: () => this.painted.clear(), paint: (id) => this.paint(id) });
    if (this.open) this.draw();
  }
  private paint(id: number): void {
    if (this.painted.has(id)) return;
    this.painted.add(id);
    this.pin(id);
  }
  private pin(id: number): void {
    const pins = this.brush === 'vertices' ? this.vertices : this.faces;
    if (!pins.delete(id)) pins.add(id);
    this.changed();
    this.tellPins();
  }
  private clearPins(): void {
    this.faces.clear();
    this.vertices.clear();
    this.changed();
    this.tellPins();
  }
  private tellPins(): void {
    const count = (n: number, one: string, many: string): string => (n === 1 ? `1 ${one}` : `${n} ${many}`);
    byId('pins').textContent = this.faces.size + this.vertices.size ? `${count(this.faces.size, 'face', 'faces')} and ${count(this.vertices.size, 'vertex', 'vertices')} stay` : 'nothing is pinned';
  }
  private walk(by: number): void {
    const { shape } = this;
    if (!shape) return;
    if (this.brush === 'turn') this.setBrush('faces');
    const all = this.brush === 'vertices' ? shape.model.vertices : shape.model.faces;
    this.at = (this.at + by + all) % all;
    if (this.at < 0) this.at = all - 1;
    const pins = this.brush === 'vertices' ? this.vertices : this.faces;
    this.say(`${this.brush === 'vertices' ? 'vertex' : 'face'} ${this.at}${pins.has(this.at) ? ', pinned' : ''} · Enter: ${pins.has(this.at) ? 'let it go' : 'pin it'}`);
    this.draw();
  }

  // --- drawing

  private tell(): void {
    if (!this.now) return;
    const { hyperbolic, hyperbolic_before, growth, largest_move, steps, ended, limit } = this.now;
    this.facts(hyperbolic, hyperbolic_before, growth, largest_move, `${steps} steps${ended ? `, stopped by ${limit}` : ''}`);
    if (steps) this.command(this.values(steps));
    this.draw();
  }
  private facts(hyperbolic: number, before: number, growth: number, move: number, more: string): void {
    byId('inflate-facts').textContent = `${hyperbolic} of ${before} hyperbolic vertices are left · volume ${growth >= 0 ? '+' : '−'}${Math.abs(100 * growth).toFixed(2)} % · moved ${move.toPrecision(3)} at most · ${more}`;
  }
  private command(values: JobValues): void {
    const words = values.flatMap(([name, value]) => (name === 'uniform' ? ['--uniform'] : [`--${name}`, value]));
    byId('inflate-command').textContent = ['plico inflate', `${this.shape?.model.name}.obj`, ...words, '-o', this.name()].join(' ');
  }
  private draw(): void {
    const { shape } = this;
    if (!shape || !this.open) return;
    const { vertexOf, offsets } = shape.model;
    const corners = this.best?.corners ?? (this.fresh ? this.now?.corners : undefined) ?? shape.model.corners;
    const marks = new Float32Array(vertexOf.length);
    for (const f of this.faces) marks.fill(3, offsets[f]!, offsets[f + 1]!);
    if (this.brush === 'faces' && this.at >= 0) marks.fill(2, offsets[this.at]!, offsets[this.at + 1]!);
    const decor: Decor = { marks, corners: [], kinds: [] };
    const seen = new Set<number>();
    const { hyperbolicCorners } = this.now ?? {};
    vertexOf.forEach((v, c) => {
      if (seen.has(v)) return;
      const isAt = this.brush === 'vertices' && this.at === v, isPinned = this.vertices.has(v), isBad = !this.best && this.fresh && hyperbolicCorners?.[c] === 1;
      if (!isAt && !isPinned && !isBad) return;
      seen.add(v);
      decor.corners.push(c);
      decor.kinds.push(isAt ? 2 : isPinned ? 3 : 1);
    });
    this.space.decorate(decor);
    this.space.place(corners);
  }
}

/** Where an OBJ with the vertices of the model has its corners. */
function cornersOf(obj: Uint8Array, { model }: Shape): Float32Array {
  const points = new TextDecoder().decode(obj).split('\n').filter((line) => line.startsWith('v ')).map((line) => line.split(' ').slice(1, 4).map(Number));
  return Float32Array.from([...model.vertexOf].flatMap((v) => points[v]!));
}
