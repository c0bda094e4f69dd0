// Folding: the slider, play, and the proof that nothing collides on the way.
import type { MotionVerdict, Progress } from '../core/protocol';
import { byId } from '../page';
import type { Session } from '../session';
import type { Shape } from '../views/shape';
import type { SpaceView } from '../views/space_view';

const kSecondsForAll = 4;

type Guarded = (work: () => Promise<void>) => Promise<void>;

export class FoldPanel {
  private time = 1;
  private shape?: Shape;
  private open = false;
  private playing = false;
  private asking = false;
  private wanted?: number;
  private verdict?: MotionVerdict;

  constructor(
    private readonly session: Session, private readonly space: SpaceView, private readonly guarded: Guarded,
    private readonly progress: (p: Progress) => void,
  ) {
    const slider = byId<HTMLInputElement>('time');
    slider.addEventListener('input', () => void this.setTime(Number(slider.value)));
    byId('play').addEventListener('click', () => this.play());
    byId('prove').addEventListener('click', () => void this.judge(false));
    byId('plan').addEventListener('click', () => void this.judge(true));
    byId('foldable').addEventListener('click', () => void this.findFoldable());
  }

  get proven(): boolean {
    return this.verdict?.verdict === 'free';
  }

  newModel(shape: Shape): void {
    this.shape = shape;
    this.time = 1;
    this.say(undefined);
    this.space.show(shape, shape.model.corners, true);
  }
  edited(shape: Shape): void {
    this.shape = shape;
    this.say(undefined);
    if (this.open) void this.setTime(this.time, true);
    else this.space.show(shape, shape.model.corners, false);
  }
  /** The net step shows the mesh, the fold step the panels on their way. */
  shown(open: boolean): void {
    const changed = open !== this.open;
    this.open = open;
    if (!this.shape || !changed) return;
    if (open) void this.setTime(this.time, true);
    else {
      this.playing = false;
      this.space.show(this.shape, this.shape.model.corners, true);
    }
  }
  frame(): void {
    if (this.shape) this.space.frame(this.shape.model.corners);
  }

  step(by: number): void {
    void this.setTime(this.time + by);
  }
  play(): void {
    this.playing = !this.playing;
    if (this.playing && this.time >= 1) this.time = 0;
    this.showButton();
    let last = performance.now();
    const tick = async (now: number): Promise<void> => {
      if (!this.playing || !this.open) return;
      await this.setTime(this.time + (now - last) / 1000 / kSecondsForAll);
      last = now;
      if (this.time >= 1) this.playing = false;
      this.showButton();
      requestAnimationFrame((next) => void tick(next));
    };
    requestAnimationFrame((now) => void tick(now));
  }
  private showButton(): void {
    byId('play').textContent = this.playing ? '⏸' : '▶';
    byId('play').setAttribute('aria-label', this.playing ? 'Pause' : 'Play');
  }

  /** Only the last wish counts while the worker is at one. */
  private async setTime(time: number, fresh = false): Promise<void> {
    this.time = Math.max(0, Math.min(1, time));
    const percent = `${Math.round(100 * this.time)} %`;
    const slider = byId<HTMLInputElement>('time');
    slider.value = String(this.time);
    slider.setAttribute('aria-valuetext', `${percent} folded`);
    byId('now').textContent = percent;
    this.wanted = this.time;
    if (this.asking) return;
    this.asking = true;
    try {
      while (this.wanted !== undefined) {
        const now = this.wanted;
        this.wanted = undefined;
        const at = await this.session.fold(now);
        if (!this.open || !this.shape || at.length !== this.shape.model.corners.length) break;
        if (fresh) this.space.show(this.shape, at, true);
        else this.space.place(at);
        fresh = false;
      }
    } finally {
      this.asking = false;
    }
  }

  private judge(plan: boolean): Promise<void> {
    return this.guarded(async () => {
      this.say(await this.session.motion(plan, this.progress));
      await this.setTime(this.time);
    });
  }
  private findFoldable(): Promise<void> {
    return this.guarded(async () => {
      const edit = await this.session.search(true, this.progress);
      await this.session.edit('search a net that folds', edit);
      await this.session.arrange();
      this.say(await this.session.motion(false, this.progress));
      await this.setTime(this.time, true);
    });
  }

  private say(verdict: MotionVerdict | undefined): void {
    this.verdict = verdict;
    const badge = byId('motion');
    badge.dataset['status'] = !verdict ? 'none' : verdict.verdict === 'free' ? 'good' : 'bad';
    badge.textContent = !verdict ? 'not judged'
      : verdict.verdict === 'free' ? `folds, proven (${verdict.method})`
      : verdict.verdict === 'collides' ? `faces ${verdict.panels.join(' and ')} collide at ${Math.round(100 * verdict.to)} %`
      : verdict.verdict;
  }
}
