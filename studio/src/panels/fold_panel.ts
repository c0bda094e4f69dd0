// Folding: the slider, play, and the proof that nothing collides on the way.
import type { MotionVerdict, Progress } from '../core/protocol';
import { byId } from '../page';
import type { Session } from '../session';
import type { Shape } from '../views/shape';
import type { SpaceView } from '../views/space_view';
import { Player } from './player';

type Guarded = (work: () => Promise<void>) => Promise<void>;

export class FoldPanel {
  private shape?: Shape;
  private open = false;
  private fresh = false; // a net that was not drawn yet
  private readonly player: Player;
  private verdict?: MotionVerdict;

  constructor(
    private readonly session: Session, private readonly space: SpaceView, private readonly guarded: Guarded,
    private readonly progress: (p: Progress) => void,
  ) {
    this.player = new Player({ slider: byId<HTMLInputElement>('time'), play: byId('play'), now: byId('now') }, (time) => this.draw(time));
    byId('prove').addEventListener('click', () => void this.judge(false));
    byId('plan').addEventListener('click', () => void this.judge(true));
    byId('foldable').addEventListener('click', () => void this.findFoldable());
  }

  get proven(): boolean {
    return this.verdict?.verdict === 'free';
  }

  newModel(shape: Shape): void {
    this.shape = shape;
    this.player.time = 1;
    this.say(undefined);
    this.space.show(shape, shape.model.corners, true);
  }
  edited(shape: Shape): void {
    this.shape = shape;
    this.say(undefined);
    if (this.open) void this.reframe();
    else this.space.show(shape, shape.model.corners, false);
  }
  /** The net step shows the mesh, the fold step the panels on their way. */
  shown(open: boolean): void {
    const changed = open !== this.open;
    this.open = open;
    if (!this.shape || !changed) return;
    if (open) void this.reframe();
    else {
      this.player.stop();
      this.space.show(this.shape, this.shape.model.corners, true);
    }
  }
  frame(): void {
    if (this.shape) this.space.frame(this.shape.model.corners);
  }

  step(by: number): void {
    void this.player.set(this.player.time + by);
  }
  play(): void {
    this.player.toggle();
  }
  private async draw(time: number): Promise<boolean> {
    const at = await this.session.fold(time);
    if (!this.open || !this.shape || at.length !== this.shape.model.corners.length) return false;
    if (this.fresh) this.space.show(this.shape, at, true);
    else this.space.place(at);
    this.fresh = false;
    return true;
  }
  private async reframe(): Promise<void> {
    this.fresh = true;
    await this.player.set(this.player.time);
  }

  private judge(plan: boolean): Promise<void> {
    return this.guarded(async () => {
      this.say(await this.session.motion(plan, this.progress));
      await this.player.set(this.player.time);
    });
  }
  private findFoldable(): Promise<void> {
    return this.guarded(async () => {
      const edit = await this.session.search(true, this.progress);
      await this.session.edit('search a net that folds', edit);
      await this.session.arrange();
      this.say(await this.session.motion(false, this.progress));
      await this.reframe();
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
