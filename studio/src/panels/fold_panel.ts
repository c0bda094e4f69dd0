// Folding: the slider, play, the proof that nothing collides on the way, and a second motion beside the first.
import { kAlarmed, kPointedAt } from '../../../viewer/src/gl_mesh';
import type { MotionVerdict, Progress } from '../core/protocol';
import { byId, colors } from '../page';
import { hasMotionOf } from '../motion_file';
import type { PlayedFile, Session } from '../session';
import type { Shape } from '../views/shape';
import type { SpaceView } from '../views/space_view';
import { ThickShape } from '../views/thick_shape';
import { CreasePanel } from './crease_panel';
import { PlayedView } from './motion_view';
import { Player } from './player';

type Guarded = (work: () => Promise<void>) => Promise<void>;

const kThickest = 0.02; // of the model's size, at the end of the slider
const kAround = 2.5; // times the colliding panels
const kSpeeds = [0.25, 0.5, 1, 2, 4];

export class FoldPanel {
  private shape?: Shape;
  private thick?: ThickShape; // while panels have a thickness
  private size = 1; // of the model
  private expected?: PlayedFile; // what is being opened
  private given?: PlayedFile; // whose motion is shown: that of the file, until something is edited or sought
  private open = false;
  private drawn?: Shape; // with or without thickness
  private fresh = false; // a net that was not drawn yet
  private near = false; // where panels collide is looked at
  private readonly player: Player;
  private verdict?: MotionVerdict;
  private beside?: PlayedView;
  private readonly creases: CreasePanel;

  constructor(
    private readonly session: Session, private readonly space: SpaceView, private readonly guarded: Guarded,
    private readonly progress: (p: Progress) => void, private readonly pointAt: (edge: number) => void, private readonly tell: (text: string) => void,
  ) {
    this.player = new Player({ slider: byId<HTMLInputElement>('time'), play: byId('play'), now: byId('now') }, (time) => this.draw(time));
    const time = (): number => this.player.time, redraw = (): Promise<boolean> => this.player.set(this.player.time);
    this.creases = new CreasePanel(session, { time, redraw, mark: (edge, panels, collide) => this.mark(edge, panels, collide) }, guarded, progress);
    byId('prove').addEventListener('click', () => void this.judge(false));
    byId('plan').addEventListener('click', () => void this.judge(true));
    byId('foldable').addEventListener('click', () => void this.findFoldable());
    byId('motion-jump').addEventListener('click', () => void this.jump());
    byId('thickness').addEventListener('input', () => void this.guarded(() => this.reframe(false)));
    byId('beside').addEventListener('change', () => void this.guarded(() => this.showBeside()));
  }

  get proven(): boolean {
    return this.verdict?.verdict === 'free';
  }

  /** A file that may have a motion of its own, before it is opened. */
  expect(file: PlayedFile | undefined): void {
    this.expected = file;
  }
  newModel(shape: Shape): void {
    this.shape = shape;
    this.given = undefined;
    if (this.expected?.name.replace(/\.fold$/i, '') === shape.model.name) { // and not a model that was still to be drawn
      if (hasMotionOf(shape.model, this.expected.bytes)) this.given = this.expected;
      this.expected = undefined;
    }
    this.size = diagonalOf(shape.model.corners);
    this.player.time = 1;
    this.say(undefined);
    byId<HTMLSelectElement>('beside').value = '';
    byId('beside-view').hidden = true;
    this.space.show(shape, shape.model.corners, true);
    void this.changed();
  }
  edited(shape: Shape): void {
    this.shape = shape;
    this.given = undefined;
    this.say(undefined);
    if (this.open) void this.reframe();
    else this.space.show(shape, shape.model.corners, false);
    void this.changed();
  }
  private changed(): Promise<void> {
    return this.guarded(() => this.creases.refresh(this.shape!, this.open, this.given));
  }
  /** The net step shows the mesh, the fold step the panels on their way. */
  shown(open: boolean): void {
    const changed = open !== this.open;
    this.open = open;
    if (!this.shape || !changed) return;
    if (open) {
      void this.reframe();
      if (!this.creases.isRead) void this.changed();
      return;
    }
    this.player.stop();
    this.space.decorate(undefined);
    this.space.show(this.shape, this.shape.model.corners, true);
  }
  frame(): void {
    if (this.shape) this.space.frame(this.shape.model.corners);
  }

  /** Keys of this step that are not on a control. */
  key(key: string): boolean {
    const select = byId<HTMLSelectElement>('beside'), thickness = byId<HTMLInputElement>('thickness');
    const actions: Record<string, () => unknown> = {
      ',': () => this.step(-0.02), '.': () => this.step(0.02), '[': () => this.hurry(-1), ']': () => this.hurry(1),
      n: () => this.walk(1), N: () => this.walk(-1), h: () => byId('by-hand').focus(), c: () => byId('check-now').click(),
      x: () => this.jump(),
      t: () => ((thickness.value = Number(thickness.value) ? '0' : '0.5'), thickness.dispatchEvent(new Event('input'))),
      b: () => ((select.selectedIndex = (select.selectedIndex + 1) % select.options.length), select.dispatchEvent(new Event('change'))),
    };
    actions[key]?.();
    return key in actions;
  }
  private step(by: number): void {
    void this.player.set(this.player.time + by);
  }
  private hurry(by: number): void {
    const at = kSpeeds.indexOf(this.player.speed) + by;
    this.player.speed = kSpeeds[Math.max(0, Math.min(kSpeeds.length - 1, at))]!;
    this.tell(`plays at ${this.player.speed} times the usual speed`);
  }
  private walk(by: number): void {
    this.creases.step(by);
    this.tell(byId('crease').textContent!);
  }
  play(): void {
    this.player.toggle();
  }
  pick(edge: number): void {
    this.creases.pick(edge);
  }
  /** The pointer is over this edge, or over none. */
  pointed(edge: number): void {
    this.creases.tell(edge);
  }
  get chosen(): number {
    return this.creases.chosen;
  }

  private async draw(time: number): Promise<boolean> {
    this.creases.follow();
    const held = this.creases.held(time), at = await (held ?? this.placesAt(time));
    if (!this.open || !this.shape || at.length !== this.shape.model.corners.length) return false;
    const { thick } = this, places = thick ? thick.places(at, this.thickness) : at;
    if (this.fresh) this.begin(thick ?? this.shape, places);
    else this.space.place(places);
    if (this.near && time !== this.verdict?.to) this.space.frame(places), (this.near = false);
    if (!held && !byId('beside-view').hidden) await this.beside?.draw(time);
    return true;
  }
  private placesAt(time: number): Promise<Float32Array> {
    return this.given ? this.session.playAt(time, this.given) : this.session.fold(time);
  }
  private begin(shape: Shape, places: Float32Array): void {
    this.space.decorate(undefined); // it was of another
    this.space.show(shape, places, this.whole);
    this.drawn = shape;
    this.fresh = this.whole = false;
    this.creases.pick(this.creases.chosen);
  }
  private whole = true; // the next picture is to show all of it
  private async reframe(whole = true): Promise<void> {
    if (!this.shape) return;
    byId('thickness-now').textContent = this.thickness ? `${((100 * this.thickness) / this.size).toFixed(1)} %` : 'none';
    this.thick = this.thickness ? new ThickShape(this.shape) : undefined;
    this.fresh = true;
    this.whole ||= whole;
    await this.player.set(this.player.time);
  }
  private get thickness(): number {
    return Number(byId<HTMLInputElement>('thickness').value) * kThickest * this.size;
  }
  private mark(edge: number, panels: number[], collide: boolean): void {
    const { shape, drawn } = this;
    if (!shape || !drawn || !this.open || this.fresh) return;
    const marks = new Float32Array(drawn.faceOf.length), own = shape.faceOf.length;
    for (const f of panels)
      for (let c = shape.model.offsets[f]!; f >= 0 && c < shape.model.offsets[f + 1]!; ++c) for (let i = c; i < marks.length; i += own) marks[i] = collide ? kAlarmed : kPointedAt;
    this.space.decorate(panels.length ? { marks, corners: [], kinds: [] } : undefined);
    this.space.redraw();
    this.pointAt(edge);
  }

  private judge(plan: boolean): Promise<void> {
    return this.guarded(async () => {
      const told = this.given && !plan ? (await this.creases.judged(this.given.bytes)).motion : undefined;
      if (!told) this.given = undefined;
      this.say(told ? { ...told, method: 'the file’s' } : await this.session.motion(plan, this.progress));
      await this.creases.refresh(this.shape!, this.open, this.given);
      await this.jump();
    });
  }
  private findFoldable(): Promise<void> {
    return this.guarded(async () => {
      const edit = await this.session.search(true, this.progress);
      await this.session.edit('search a net that folds', edit);
      await this.session.arrange();
      this.say(await this.session.motion(false, this.progress));
      await this.creases.refresh(this.shape!, this.open, this.given);
      await this.reframe();
    });
  }
  /** To where it collides, if it does: what is in front of the two panels is cut away. */
  private async jump(): Promise<void> {
    const { verdict, shape } = this, collides = verdict?.verdict === 'collides';
    await this.player.set(collides ? verdict.to : this.player.time);
    if (!collides || !shape) return;
    this.mark(this.creases.chosen, verdict.panels, true);
    const at = await this.placesAt(verdict.to), { offsets } = shape.model;
    const corners = verdict.panels.flatMap((f) => [...at.subarray(3 * offsets[f]!, 3 * offsets[f + 1]!)]);
    const middle = [0, 1, 2].map((k) => corners.reduce((sum, x, i) => sum + (i % 3 === k ? x : 0), 0) / (corners.length / 3));
    this.space.frame(Float32Array.from(corners, (x, i) => middle[i % 3]! + kAround * (x - middle[i % 3]!)));
    this.space.zoom(1); // stays so
    this.near = true;
  }

  private say(verdict: MotionVerdict | undefined): void {
    this.verdict = verdict;
    const badge = byId('motion'), collides = verdict?.verdict === 'collides';
    badge.dataset['status'] = !verdict ? 'none' : verdict.verdict === 'free' ? 'good' : 'bad';
    badge.textContent = !verdict ? (this.given ? 'the motion of the file, not judged' : 'not judged')
      : verdict.verdict === 'free' ? `folds, proven (${verdict.method})`
      : collides ? `faces ${verdict.panels.join(' and ')} collide at ${Math.round(100 * verdict.to)} %`
      : verdict.verdict;
    byId('motion-jump').hidden = !collides;
  }

  /** A second motion of the same net, at the same time. */
  private async showBeside(): Promise<void> {
    const wanted = byId<HTMLSelectElement>('beside').value, view = byId('beside-view');
    view.hidden = !wanted;
    if (!wanted) return;
    const motion = await this.creases.motion();
    this.beside ??= new PlayedView(this.session, byId<HTMLCanvasElement>('beside-space'), byId('painter').textContent!, colors.space);
    byId('beside-name').textContent = wanted === 'straight' ? 'all creases at once' : `kept: ${byId('motion').textContent}`;
    await this.beside.open({ name: wanted === 'straight' ? 'The straight motion' : 'The motion kept', bytes: wanted === 'straight' ? motion.straight() : motion.bytes });
    await this.player.set(this.player.time);
  }
}

function diagonalOf(at: Float32Array): number {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  at.forEach((x, i) => ((low[i % 3] = Math.min(low[i % 3]!, x)), (high[i % 3] = Math.max(high[i % 3]!, x))));
  return Math.hypot(...high.map((x, k) => x - low[k]!)) || 1;
}
