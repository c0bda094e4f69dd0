// What folds but is not the document, in space: turned by hand, and played at the rate of the screen.
import type { PlayedFile, Session } from '../session';
import { Shape } from '../views/shape';
import { SpaceView, type SpaceColors } from '../views/space_view';
import { Player } from './player';

/** A file on a canvas, at whatever time is asked for. */
export class PlayedView {
  private readonly space: SpaceView;
  private shape?: Shape;
  private file?: PlayedFile;
  private fresh = false; // not drawn yet

  constructor(private readonly session: Session, private readonly canvas: HTMLCanvasElement, painter: string, colors: () => SpaceColors) {
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    this.space = new SpaceView(canvas, painter, colors, () => undefined, () => undefined, () => undefined);
    canvas.addEventListener('keydown', (event) => {
      if (this.space.key(event)) event.preventDefault(), event.stopPropagation();
    });
  }
  async open(file: PlayedFile): Promise<void> {
    const { model, snapshot } = await this.session.play(file);
    this.file = file;
    this.shape = new Shape(model, snapshot);
    this.canvas.setAttribute('aria-label', `${file.name} as it folds. Drag or use the arrow keys to turn it, plus and minus to zoom.`);
    this.fresh = true;
  }
  async draw(time: number): Promise<boolean> {
    const { shape, file } = this;
    if (!shape || !file) return false;
    const at = await this.session.playAt(time, file);
    if (shape !== this.shape || at.length !== shape.model.corners.length) return false;
    if (this.fresh) this.space.show(shape, at, true);
    else this.space.place(at);
    this.fresh = false;
    return this.canvas.isConnected;
  }
}

export class MotionView {
  readonly element = document.createElement('div');
  private readonly view: PlayedView;
  private readonly player: Player;

  constructor(session: Session, painter: string, colors: () => SpaceColors) {
    const canvas = document.createElement('canvas'), bar = document.createElement('div');
    const play = document.createElement('button'), slider = document.createElement('input'), now = document.createElement('span');
    play.type = 'button';
    Object.assign(slider, { type: 'range', min: '0', max: '1', step: '0.001' });
    slider.setAttribute('aria-label', 'Folded');
    bar.className = 'row';
    bar.append(play, slider, now);
    this.element.className = 'motion';
    this.element.append(canvas, bar);
    this.view = new PlayedView(session, canvas, painter, colors);
    this.player = new Player({ slider, play, now }, (time) => this.view.draw(time));
  }

  /** Once the element is on the page. */
  async show(file: PlayedFile): Promise<void> {
    this.player.stop();
    await this.view.open(file);
    await this.player.set(0.6);
  }
}
