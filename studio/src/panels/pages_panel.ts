// Pages to print, as the print job lays them out, and everything that can be taken away as a file.
import type { JobResult, JobValues } from '../core/protocol';
import { byId, download } from '../page';
import type { Session } from '../session';
import { zipped } from '../zip';
import type { Filled, Places } from '../store';
import { PageForm } from './page_form';
import { boxOf, keyOf, middleOf, polygonsOf, putOf, straightening, turned, type PartPlace } from './page_parts';
import { PageView } from './page_view';

type Guarded = (work: () => Promise<void>) => Promise<void>;

const kExports = [['html', 'folding page'], ['glb', 'animation (glTF)'], ['urdf', 'robot (URDF)'], ['xml', 'robot (MuJoCo)'], ['csv', 'angles (CSV)']] as const;
const kAll = 'all (ZIP)';
const kTurn = 15, kSmallTurn = 1; // degrees
const kMove = 1, kLargeMove = 10; // millimetres

export class PagesPanel {
  private fresh = false; // the pages shown are of the net as it is
  private views: PageView[] = [];
  private kept: Places = new Map();
  private parts: PartPlace[] = []; // as the pages shown have them
  private scale = 1; // millimetres per unit of the model
  private ownChange = false; // what was edited is where parts lie
  private focused = '';
  private readonly form: PageForm;

  constructor(private readonly session: Session, private readonly guarded: Guarded) {
    const form = byId<HTMLFormElement>('page-form');
    this.form = new PageForm(form);
    form.addEventListener('submit', (e) => {
      e.preventDefault();
      void this.layOut(this.byHand());
    });
    form.addEventListener('change', () => {
      this.session.keepForm(this.form.filled);
      void this.layOut(this.byHand());
    });
    byId('repack').addEventListener('click', () => void this.keep('lay all out anew', new Map()));
    byId('repack-others').addEventListener('click', () => void this.keep('lay the others out anew', this.byHand()));
    this.offer('PDF', () => this.pages('pdf'));
    this.offer('SVG', () => this.pages('svg'));
    this.offer('DXF', () => this.pages('dxf'));
    this.offer('FOLD', async () => ({ [`${this.name()}.fold`]: await this.session.net() }));
    this.offer('project', async () => ({ [`${this.name()}.plico`]: await this.session.project() }));
    for (const [kind, label] of kExports) this.offer(label, () => this.exported(kind));
    this.offer(kAll, async () => ({ [`${this.name()}.zip`]: zipped(await this.everything()) }));
  }

  newModel(): void {
    this.fresh = false;
    this.kept = new Map();
    this.parts = [];
  }
  /** Places set by hand stay with parts that are the same; the others lie where there is room. */
  edited(): void {
    if (!this.ownChange) this.kept = this.byHand();
    this.ownChange = false;
    this.fresh = false;
  }
  /** Where parts lay when the project was left, and what was filled in. */
  resumed(places: Places, filled: Filled): void {
    this.form.fill(filled);
    this.kept = places;
    this.session.keepPlaces(places);
  }
  private byHand(): Places {
    return new Map([...this.kept].filter(([, { byHand }]) => byHand));
  }
  shown(): Promise<void> {
    return this.fresh ? Promise.resolve() : this.layOut();
  }

  private name(): string {
    return this.session.shape!.model.name.replace(/[^\p{L}\p{N}_.-]+/gu, '-').slice(0, 80) || 'model';
  }

  private async pages(kind: 'pdf' | 'svg' | 'dxf'): Promise<Record<string, Uint8Array>> {
    const net = `${this.name()}.fold`;
    const values: JobValues = [['net', net], ['output', `${this.name()}.${kind}`], ['title', this.session.shape!.model.name], ...this.form.values()];
    const { parts, panels } = this.partsOfNet();
    for (const [key, place] of this.kept)
      if (this.form.splits || panels.has(key)) values.push(['put', putOf({ ...place, page: Math.min(place.page, parts) })]);
    const result = await this.session.job('print', values, { [net]: await this.session.net() });
    this.tell(result);
    const print = result.report['print'] as { places: PartPlace[]; scale_mm_per_unit: number };
    this.parts = print.places;
    this.scale = print.scale_mm_per_unit;
    return result.files;
  }
  /** What is wrong first, and once; what --up would change is for the command line. */
  private tell({ messages }: JobResult): void {
    const lines = (wanted: boolean): string => [...new Set(messages.filter((m) => m.tone !== 'detail' && (m.tone === 'warning') === wanted).map((m) => m.text.trim()))]
      .filter((text) => !text.includes('--up ')).join('\n');
    const alarm = document.createElement('strong');
    alarm.textContent = lines(true);
    byId('page-report').replaceChildren(alarm, ...(alarm.textContent ? ['\n'] : []), lines(false));
  }
  /** The parts that the net has now, as keys of places. */
  private partsOfNet(): { parts: number; panels: Set<string> } {
    const byPart: number[][] = [];
    this.session.shape!.snapshot.parts.forEach((part, face) => (byPart[part] ??= []).push(face));
    return { parts: Math.max(byPart.length, this.parts.length), panels: new Set(byPart.map((faces) => faces.join(' '))) };
  }
  private async everything(): Promise<Record<string, Uint8Array>> {
    const files: Record<string, Uint8Array> = {};
    for (const make of this.makers) Object.assign(files, await make());
    return files;
  }
  private async exported(kind: string): Promise<Record<string, Uint8Array>> {
    const net = `${this.name()}.fold`;
    const result = await this.session.job('export', [['file', net], ['output', `${this.name()}.${kind}`]], { [net]: await this.session.net() });
    return result.files;
  }

  private layOut(kept: Places = this.kept): Promise<void> {
    return this.guarded(async () => {
      this.kept = kept;
      const files = await this.pages('svg');
      this.views.forEach((view) => view.dispose());
      this.views = Object.values(files).map((svg, i, all) => new PageView(i + 1, all.length, svg, {
        drop: (part, page, dx, dy) => void this.move(part, page, dx, dy), turn: (part, by) => void this.turn(part, by),
        key: (part, event) => this.key(part, event),
      }));
      byId('pages').replaceChildren(...this.views.map((view) => view.element));
      for (const part of this.parts) {
        const shown = this.views[part.page - 1]?.add(part, polygonsOf(this.session.shape!, part, this.scale), this.kept.get(keyOf(part))?.byHand ?? false);
        if (keyOf(part) === this.focused) shown?.focus({ preventScroll: true });
      }
      byId('repack').hidden = byId('repack-others').hidden = !this.byHand().size;
      this.fresh = true;
    });
  }

  // --- by hand

  /** One step that can be undone: from now on the parts lie like this. */
  private async keep(name: string, kept: Places): Promise<void> {
    const before = this.kept;
    const set = (to: Places) => (): void => {
      this.kept = to;
      this.ownChange = true;
      this.session.keepPlaces(to);
    };
    await this.session.own(name, set(kept), set(before));
  }
  private place(part: PartPlace, moved: PartPlace, name: string): Promise<void> {
    const kept = new Map(this.parts.map((p) => [keyOf(p), { ...p, byHand: this.kept.get(keyOf(p))?.byHand ?? false }]));
    kept.set(keyOf(part), { ...moved, byHand: true });
    this.focused = keyOf(part);
    return this.keep(`${name} part ${part.part}`, kept);
  }
  private move(part: PartPlace, page: number, dx: number, dy: number): Promise<void> {
    return this.place(part, { ...part, page, x: part.x + dx, y: part.y + dy }, page === part.page ? 'move' : 'send to another page:');
  }
  private turn(part: PartPlace, degrees: number): Promise<void> {
    const middle = middleOf(polygonsOf(this.session.shape!, part, this.scale));
    return this.place(part, turned(part, degrees, middle), 'turn');
  }
  /** Into the middle of its page, or to a margin: -1 is left or below, 1 right or above, 0 the middle. */
  private align(part: PartPlace, across: number | undefined, up: number | undefined): Promise<void> {
    const { low, high } = boxOf(polygonsOf(this.session.shape!, part, this.scale)), { size } = this.views[part.page - 1]!, { margin } = this.form;
    const by = (axis: 0 | 1, way: number | undefined): number => {
      if (way === undefined) return 0;
      if (way < 0) return margin - low[axis];
      return way > 0 ? size[axis] - margin - high[axis] : (size[axis] - low[axis] - high[axis]) / 2;
    };
    return this.place(part, { ...part, x: part.x + by(0, across), y: part.y + by(1, up) }, 'align');
  }
  private key(part: PartPlace, event: KeyboardEvent): boolean {
    const far = event.shiftKey ? kLargeMove : kMove;
    const by = (dx: number, dy: number) => () => this.move(part, part.page, dx, dy);
    const actions: Record<string, () => unknown> = {
      ArrowLeft: by(-far, 0), ArrowRight: by(far, 0), ArrowUp: by(0, far), ArrowDown: by(0, -far),
      r: () => this.turn(part, kTurn), R: () => this.turn(part, -kTurn), '[': () => this.turn(part, kSmallTurn), ']': () => this.turn(part, -kSmallTurn),
      s: () => this.turn(part, straightening(polygonsOf(this.session.shape!, part, this.scale))),
      c: () => this.align(part, 0, 0), Home: () => this.align(part, -1, undefined), End: () => this.align(part, 1, undefined),
      t: () => this.align(part, undefined, 1), b: () => this.align(part, undefined, -1),
      PageUp: () => part.page > 1 && this.move(part, part.page - 1, 0, 0),
      PageDown: () => part.page < this.parts.length && this.move(part, part.page + 1, 0, 0),
      u: () => this.keep(`let part ${part.part} go`, new Map([...this.byHand()].filter(([key]) => key !== keyOf(part)))),
    };
    actions[event.key]?.();
    return event.key in actions;
  }

  private readonly makers: (() => Promise<Record<string, Uint8Array>>)[] = [];
  private offer(label: string, make: () => Promise<Record<string, Uint8Array>>): void {
    if (label !== kAll) this.makers.push(make);
    const button = document.createElement('button');
    button.textContent = `Save ${label}`;
    button.addEventListener('click', () => void this.guarded(async () => {
      for (const [name, bytes] of Object.entries(await make())) download(name, bytes);
    }));
    byId('downloads').append(button);
  }
}
