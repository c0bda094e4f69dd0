// What folds but is not the document, in space: turned by hand, and played at the rate of the screen.
import { kPointedAt } from '../../../viewer/src/gl_mesh';
import type { JobValues, Progress } from '../core/protocol';
import { MotionFile } from '../motion_file';
import type { PlayedFile, Session } from '../session';
import { Shape } from '../views/shape';
import { SpaceView, type SpaceColors } from '../views/space_view';
import { Lanes } from './lanes';
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
  async open(file: PlayedFile): Promise<Shape> {
    const { model, snapshot } = await this.session.play(file);
    this.file = file;
    this.shape = new Shape(model, snapshot);
    this.canvas.setAttribute('aria-label', `${file.name} as it folds. Drag or use the arrow keys to turn it, plus and minus to zoom.`);
    this.fresh = true;
    return this.shape;
  }
  /** The panels at these edges. */
  mark(edges: number[]): void {
    const { shape } = this;
    if (!shape) return;
    const marks = new Float32Array(shape.faceOf.length), { offsets } = shape.model;
    for (const f of edges.flatMap((edge) => shape.facesOf(edge))) marks.fill(kPointedAt, offsets[f]!, offsets[f + 1]!);
    this.space.decorate({ marks, corners: [], kinds: [] });
    this.space.redraw();
  }
  async draw(time: number): Promise<boolean> {
    const { shape, file } = this;
    if (!shape || !file) return false;
    const at = await this.session.playAt(time, file);
    if (shape !== this.shape || at.length !== shape.model.corners.length) return false;
    if (this.fresh) this.space.decorate(undefined), this.space.show(shape, at, true);
    else this.space.place(at);
    this.fresh = false;
    return this.canvas.isConnected;
  }
}

/** With a slider, the lanes of its creases, and in words what is played when the file has no motion. */
export class MotionView {
  readonly element = document.createElement('div');
  private readonly view: PlayedView;
  private readonly player: Player;
  private readonly lanes: Lanes;
  private readonly list = document.createElement('div');
  private readonly note = document.createElement('p');
  private readonly find = document.createElement('button');
  private file?: PlayedFile;

  constructor(private readonly session: Session, painter: string, colors: () => SpaceColors, private readonly progress: (p: Progress) => void) {
    const canvas = document.createElement('canvas'), bar = document.createElement('div');
    const play = document.createElement('button'), slider = document.createElement('input'), now = document.createElement('span');
    play.type = this.find.type = 'button';
    Object.assign(slider, { type: 'range', min: '0', max: '1', step: '0.001' });
    slider.setAttribute('aria-label', 'Folded');
    bar.className = 'row';
    bar.append(play, slider, now);
    this.note.className = 'report';
    this.find.textContent = 'Find a motion';
    this.find.addEventListener('click', () => void this.search(''));
    this.list.className = 'lanes';
    this.list.setAttribute('role', 'listbox');
    this.list.setAttribute('aria-label', 'Order of the creases');
    this.element.className = 'motion';
    this.element.append(canvas, bar, this.note, this.find, this.list);
    this.view = new PlayedView(session, canvas, painter, colors);
    this.lanes = new Lanes(this.list, ({ edges }, edge) => (this.lanes.mark(edge), this.view.mark(edges)), () => slider.focus());
    this.player = new Player({ slider, play, now }, (time) => (this.lanes.at(time), this.view.draw(time)));
  }

  /** Once the element is on the page. */
  async show(file: PlayedFile): Promise<void> {
    this.file = file;
    const { comesApart, edges } = await this.open(file);
    this.find.hidden = !comesApart;
    this.note.textContent = comesApart ? kUneven : '';
    if (comesApart && edges.length <= kFoundAtOnce) await this.search(kTimeAtOnce);
  }
  private async open(file: PlayedFile): Promise<MotionFile> {
    this.player.stop();
    const { model, snapshot } = await this.view.open(file);
    const motion = new MotionFile(file.name, file.bytes, model, snapshot.folds), lanes = motion.hasMotion ? motion.lanes() : [];
    this.lanes.show(lanes);
    this.list.hidden = !lanes.length;
    await this.player.set(0.6);
    return motion;
  }
  /** A motion of the same sheet, as the fold job finds it. */
  private async search(limit: string): Promise<void> {
    const { file } = this, found = 'motion.fold';
    if (!file) return;
    try {
      const values: JobValues = [['net', file.name], ['output', found], ...(limit ? [['time-limit', limit] as [string, string]] : [])];
      const { files, report, messages } = await this.session.job('fold', values, { [file.name]: file.bytes }, this.progress);
      const bytes = files[found], [motion] = report['motions'] as { planner: string; verdict: string }[], share = Number(report['progress'] ?? 1);
      if (!bytes || !motion || file !== this.file) return;
      await this.open({ name: file.name, bytes });
      const bends = messages.find(({ text }) => /panels bend/.test(text))?.text.trim();
      this.note.textContent = [
        'the file holds no motion', share > 1 - 1e-6 ? `shown is one that was found (${motion.planner})` : `none was found to the end: shown is how far it came, ${Math.round(100 * share)} % (${motion.planner})`,
        motion.verdict === 'free' ? 'proven free of collision' : motion.verdict, bends,
      ].filter(Boolean).join(' · ');
      this.find.hidden = !limit || share > 1 - 1e-6;
    } catch {
      this.note.textContent = `no motion was found · ${kUneven}`;
    }
  }
}

const kUneven = 'the file holds no motion: all creases turn evenly, so the sheet comes apart between flat and folded';
const kFoundAtOnce = 200; // creases
const kTimeAtOnce = '8s';
