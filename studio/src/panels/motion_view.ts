// What a job made and folds, in space: turned by hand, played, at the rate of the screen.
import type { Session } from '../session';
import { Shape } from '../views/shape';
import { SpaceView, type SpaceColors } from '../views/space_view';
import { Player } from './player';

export class MotionView {
  readonly element = document.createElement('div');
  private readonly space: SpaceView;
  private readonly player: Player;
  private shape?: Shape;
  private fresh = false; // not drawn yet

  constructor(private readonly session: Session, painter: string, colors: () => SpaceColors) {
    const canvas = document.createElement('canvas'), bar = document.createElement('div');
    const play = document.createElement('button'), slider = document.createElement('input'), now = document.createElement('span');
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    play.type = 'button';
    Object.assign(slider, { type: 'range', min: '0', max: '1', step: '0.001' });
    slider.setAttribute('aria-label', 'Folded');
    bar.className = 'row';
    bar.append(play, slider, now);
    this.element.className = 'motion';
    this.element.append(canvas, bar);
    this.space = new SpaceView(canvas, painter, colors, () => undefined, () => undefined, () => undefined);
    canvas.addEventListener('keydown', (event) => {
      if (this.space.key(event)) event.preventDefault(), event.stopPropagation();
    });
    this.player = new Player({ slider, play, now }, (time) => this.draw(time));
  }

  /** Once the element is on the page. */
  async show(name: string, bytes: Uint8Array): Promise<void> {
    this.player.stop();
    const { model, snapshot } = await this.session.play(name, bytes);
    this.shape = new Shape(model, snapshot);
    this.element.firstElementChild!.setAttribute('aria-label', `${name} as it folds. Drag or use the arrow keys to turn it, plus and minus to zoom.`);
    this.fresh = true;
    await this.player.set(0.6);
  }
  private async draw(time: number): Promise<boolean> {
    const at = await this.session.playAt(time), { shape } = this;
    if (!shape || at.length !== shape.model.corners.length) return false;
    if (this.fresh) this.space.show(shape, at, true);
    else this.space.place(at);
    this.fresh = false;
    return this.element.isConnected;
  }
}
