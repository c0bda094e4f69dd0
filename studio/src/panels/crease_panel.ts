// Creases of the motion that is shown: lanes of which moves when, one turned by hand, and what the core says of a moment.
import type { MotionVerdict, Progress } from '../core/protocol';
import { MotionFile, type Lane } from '../motion_file';
import { byId } from '../page';
import type { PlayedFile, Session } from '../session';
import type { Shape } from '../views/shape';
import { Lanes, spokenLane } from './lanes';

type Guarded = (work: () => Promise<void>) => Promise<void>;
/** What the fold screen shows and does for it. */
export interface Stage {
  time: () => number;
  redraw: () => Promise<unknown>;
  /** Marks panels, hatched when they collide, and one crease. */
  mark: (edge: number, panels: number[], collide: boolean) => void;
}
interface Hand {
  edge: number;
  base: number; // the time at which the other creases are
  file: PlayedFile;
  degrees: number;
}

const kAtOnce = 3000; // faces of which lanes are made unasked
const kNoise = 5; // degrees by which creases of a fold by hand are off
const kTurn = 180; // degrees that a crease turns to either side

export class CreasePanel {
  private shape?: Shape;
  private file?: MotionFile;
  private given?: PlayedFile; // whose motion it is, if not the net's own
  private lane?: Lane;
  private hand?: Hand;
  private edge = -1;
  private asked = 0;
  private readonly lanes: Lanes;
  private readonly slider = byId<HTMLInputElement>('by-hand');

  constructor(private readonly session: Session, private readonly stage: Stage, private readonly guarded: Guarded, private readonly progress: (p: Progress) => void) {
    this.lanes = new Lanes(byId('lanes'), (lane, edge) => this.pick(edge, lane), () => this.slider.focus());
    this.slider.addEventListener('input', () => void this.turn(Number(this.slider.value)));
    byId('hand-back').addEventListener('click', () => void this.release());
    byId('hand-check').addEventListener('click', () => void this.checkHand());
    byId('check-now').addEventListener('click', () => void this.checkNow());
    byId('check-margin').addEventListener('click', () => void this.checkMargin());
    byId('lanes-show').addEventListener('click', () => void this.guarded(() => this.read()));
  }

  get isRead(): boolean {
    return this.file !== undefined;
  }
  async motion(): Promise<MotionFile> {
    if (!this.file) await this.read();
    return this.file ?? this.motion(); // another came in between
  }
  /** The net or its motion is another now. */
  async refresh(shape: Shape, open: boolean, given?: PlayedFile): Promise<void> {
    this.shape = shape;
    this.given = given;
    this.file = undefined;
    this.hand = undefined;
    this.say('');
    this.lanes.show([]);
    const many = shape.model.faces > kAtOnce;
    byId('lanes-show').hidden = !many;
    this.pick(-1);
    if (open && !many) await this.read();
  }
  private async read(): Promise<void> {
    const ticket = ++this.asked, shape = this.shape!, bytes = this.given?.bytes ?? (await this.session.net());
    if (ticket !== this.asked || shape !== this.shape) return;
    this.file = new MotionFile('net.fold', bytes, shape.model, shape.snapshot.folds);
    byId('lanes-show').hidden = true;
    this.lanes.show(this.file.lanes());
    this.pick(this.file.has(this.edge) ? this.edge : -1);
  }

  // --- one crease

  pick(edge: number, lane?: Lane): void {
    const { file } = this, has = file?.has(edge) ?? false;
    if (this.hand && this.hand.edge !== edge) void this.release();
    this.edge = has ? edge : -1;
    this.lane = has ? (this.lanes.mark(edge), lane ?? this.laneOf(edge)) : undefined;
    this.slider.disabled = !has;
    byId('hand-panel').hidden = !has;
    this.follow();
    this.stage.mark(this.edge, this.panels(), false);
  }
  private laneOf(edge: number): Lane | undefined {
    return this.lanes.mark(edge);
  }
  /** Of the lane, unless that is nearly all there are. */
  private panels(): number[] {
    if (this.edge < 0) return [];
    const { edges } = this.lane!, few = 2 * edges.length < this.file!.edges.length;
    return (few ? edges : [this.edge]).flatMap((edge) => this.shape!.facesOf(edge));
  }
  step(by: number): void {
    const edges = this.file?.edges ?? [];
    if (edges.length) this.pick(edges[(Math.max(-1, edges.indexOf(this.edge)) + by + edges.length) % edges.length]!);
  }
  /** What stands there of a crease under the pointer, else of the chosen one. */
  tell(edge: number): void {
    const { file } = this, shown = file?.has(edge) ? edge : this.edge;
    byId('crease').textContent = !file ? '' : shown < 0 ? `${file.edges.length} creases; point at one, or choose a lane` : `${file.spoken(shown, this.stage.time())}${
      this.lane && shown === this.edge ? ` · lane: ${spokenLane(this.lane)}` : ''}`;
  }
  get chosen(): number {
    return this.edge;
  }
  /** The moment that is shown is another. */
  follow(): void {
    const time = this.stage.time(), { hand } = this;
    this.lanes.at(time);
    if (hand && hand.base !== time) this.hand = undefined;
    byId('hand-back').hidden = byId('hand-check').hidden = !this.hand;
    if (!this.hand && this.edge >= 0) this.setSlider(this.file!.angle(this.edge, time));
    this.tell(this.edge);
  }
  private setSlider(degrees: number): void {
    this.slider.value = String(Math.round(degrees));
    const text = `${Math.round(degrees)}°`;
    byId('hand-now').textContent = text;
    this.slider.setAttribute('aria-valuetext', `crease ${this.edge} at ${text}`);
  }
  private turn(degrees: number): Promise<unknown> {
    const { file, edge } = this, base = this.stage.time();
    if (!file || edge < 0) return Promise.resolve();
    if (this.hand?.edge !== edge) this.hand = { edge, base, degrees, file: { name: 'one crease.fold', bytes: file.turning(base, edge, -kTurn, kTurn) } };
    this.hand.degrees = degrees;
    this.setSlider(degrees);
    byId('hand-back').hidden = byId('hand-check').hidden = false;
    this.stage.mark(edge, this.shape!.facesOf(edge), false);
    return this.stage.redraw();
  }
  private release(): Promise<unknown> {
    this.hand = undefined;
    this.follow();
    return this.stage.redraw();
  }
  /** Places of the corners while a crease is held; nothing when the motion has its way. */
  held(time: number): Promise<Float32Array> | undefined {
    const { hand } = this;
    return hand?.base === time ? this.session.playAt((hand.degrees + kTurn) / (2 * kTurn), hand.file) : undefined;
  }

  // --- what the core says

  private say(text: string, status: 'good' | 'bad' | 'none' = 'none'): void {
    byId('moment').textContent = text;
    byId('moment').dataset['status'] = status;
  }
  async judged(bytes: Uint8Array, more: [string, string][] = []): Promise<{ motion?: MotionVerdict; noise?: { folded: number; samples: number } }> {
    const name = 'motion.fold';
    return (await this.session.job('verify', [['file', name], ...more], { [name]: bytes }, this.progress)).report;
  }
  private tellVerdict(told: MotionVerdict | undefined, free: string, where: (at: number) => string): void {
    if (!told) return this.say('not judged: the parts of this net fold one by one');
    const { verdict, panels, from } = told;
    const collide = verdict === 'collides';
    this.say(verdict === 'free' ? free : collide ? `faces ${panels.join(' and ')} collide${where(from)}` : verdict, verdict === 'free' ? 'good' : 'bad');
    this.stage.mark(this.edge, collide ? panels : [], collide);
  }
  private checkNow(): Promise<void> {
    return this.guarded(async () => {
      const time = this.stage.time(), bytes = this.hand ? this.file!.turning(time, this.hand.edge, this.hand.degrees, this.hand.degrees) : this.file?.turning(time);
      if (bytes) this.tellVerdict((await this.judged(bytes)).motion, 'nothing collides at this moment', () => ' at this moment');
    });
  }
  private checkHand(): Promise<void> {
    return this.guarded(async () => {
      const { hand, file } = this;
      if (!hand || !file) return;
      const from = file.angle(hand.edge, hand.base), turn = `from ${from.toFixed(0)}° to ${hand.degrees}°`;
      const { motion } = await this.judged(file.turning(hand.base, hand.edge, from, hand.degrees));
      this.tellVerdict(motion, `crease ${hand.edge} turns ${turn}, proven free`, (at) => ` at ${(from + at * (hand.degrees - from)).toFixed(0)}° as it turns ${turn}`);
    });
  }
  /** How many folds whose creases are off by a few degrees reach the end. */
  private checkMargin(): Promise<void> {
    return this.guarded(async () => {
      if (!this.file) return;
      const told = (await this.judged(this.file.bytes, [['angle-noise', `${kNoise}deg`], ['samples', '40']])).noise;
      this.say(told ? `${told.folded} of ${told.samples} folds with every crease off by up to ${kNoise}° end without a collision` : 'prove a motion first', told && told.folded === told.samples ? 'good' : told ? 'bad' : 'none');
    });
  }
}
