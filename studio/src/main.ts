// The page: joins the document, the views, the keyboard and what is said about it all.
import { Core, Refused, Stopped } from './core/client';
import type { Edit, Progress } from './core/protocol';
import { FoldPanel } from './panels/fold_panel';
import { InflatePanel } from './panels/inflate_panel';
import { JobsPanel } from './panels/jobs_panel';
import { MotionView } from './panels/motion_view';
import { PagesPanel } from './panels/pages_panel';
import { PatternPanel } from './panels/pattern_panel';
import { Session } from './session';
import { kept } from './store';
import { byId, bytesOf, colors } from './page';
import { SheetView } from './views/sheet_view';
import { SpaceView } from './views/space_view';
import type { Shape } from './views/shape';

type Tab = 'inflate' | 'net' | 'fold' | 'pages' | 'pattern' | 'jobs';
const kTabs: Tab[] = ['inflate', 'net', 'fold', 'pages', 'pattern', 'jobs'];
const kWithoutModel: Tab[] = ['pattern', 'jobs']; // need no shape
const kLargestFile = 80_000_000; // bytes: no kind of file holds 5 million faces in less
const kStepsListed = 100; // to either side
const kHint = 'point at an edge in either picture: a click cuts or joins it';
const kSamples = ['bird', 'dinosaur', 'fish', 'dog', 'torus', 'truncated-icosahedron'];

declare global {
  interface Window {
    studio: { session: Session; tab: (tab: Tab) => void; pattern: PatternPanel; inflate: InflatePanel };
  }
}

class Studio {
  readonly session: Session;
  private readonly space: SpaceView;
  private readonly sheet: SheetView;
  private readonly foldPanel: FoldPanel;
  private readonly pagesPanel: PagesPanel;
  private readonly jobsPanel: JobsPanel;
  readonly inflatePanel: InflatePanel;
  readonly patternPanel: PatternPanel;
  private tab: Tab = 'net';
  private corner = -1; // where the keys stand on the net
  private asked = 0;
  private atWork = false; // what is said is how far something is

  constructor(core: Core) {
    this.session = new Session(core, (shape, notes) => this.showModel(shape, notes), (shape, moved) => this.showEdit(shape, moved),
      (fine) => (byId('unkept').hidden = fine));
    const point = (edge: number): void => void this.point(edge);
    const click = (edge: number, event: PointerEvent): void => void this.act(edge, event.shiftKey);
    this.space = new SpaceView(byId('space'), byId('painter').textContent!, colors.space, point, click, (works) => (byId('no-space').hidden = works));
    this.sheet = new SheetView(byId('sheet'), byId('painter').textContent!, colors.sheet, point, click);
    this.foldPanel = new FoldPanel(this.session, this.space, (work) => this.guarded(work), (p) => this.progress(p),
      (edge) => void this.point(edge), (text) => this.say(text));
    this.pagesPanel = new PagesPanel(this.session, (work) => this.guarded(work));
    this.jobsPanel = new JobsPanel(this.session, (work) => this.guarded(work), (p) => this.progress(p), (name, bytes) => this.openMade(name, bytes),
      () => (byId('no-space').hidden ? new MotionView(this.session, byId('painter').textContent!, colors.space, (p) => this.progress(p)) : undefined));
    this.inflatePanel = new InflatePanel(this.session, this.space, (work) => this.guarded(work), (p) => this.progress(p), (text) => this.say(text), (name, bytes) => this.openMade(name, bytes));
    this.patternPanel = new PatternPanel(this.session, (work) => this.guarded(work), (text, kind) => this.say(text, kind), (p) => this.progress(p), () => this.steps(), (name, bytes, job) => this.toTools(name, bytes, job));
    this.listen();
  }

  private say(text: string, kind: 'fine' | 'bad' = 'fine'): void {
    this.atWork = false;
    const status = byId('status');
    status.textContent = text;
    status.dataset['kind'] = kind;
  }
  private progress({ phase, done, total, note }: Progress): void {
    byId('stop').hidden = false;
    this.say([`${phase} ${done}${total ? ` of ${total}` : ''}`, note].filter(Boolean).join(', '));
    this.atWork = true;
  }
  /** Does it, and says what went wrong: code, place, and what to try. */
  async guarded(work: () => Promise<void>): Promise<void> {
    byId('stop').hidden = true;
    const waiting = setTimeout(() => (byId('stop').hidden = !this.session.busy), 150);
    try {
      await work();
    } catch (error) {
      if (error instanceof Stopped) this.say('stopped; nothing was changed');
      else if (error instanceof Refused) {
        const { code, message, where, suggestion } = error.failure;
        this.say([message, where && `at ${where}`, suggestion && `try: ${suggestion}`, `(${code})`].filter(Boolean).join(' · '), 'bad');
      } else this.say(`something is wrong with the page: ${String(error)}`, 'bad');
    } finally {
      clearTimeout(waiting);
      byId('stop').hidden = true;
      if (this.atWork) this.say(''); // how far it was is no news any more
    }
  }

  open(name: string, bytes: Uint8Array): Promise<void> {
    return this.guarded(async () => {
      this.say(`opening ${name} …`);
      await this.openBytes(name, bytes);
    });
  }
  private openBytes(name: string, bytes: Uint8Array): Promise<void> {
    this.foldPanel.expect(/\.fold$/i.test(name) ? { name, bytes } : undefined);
    return this.session.open(name, bytes, (p) => this.progress(p));
  }
  private async openFile(file: File | undefined): Promise<void> {
    if (!file) return;
    if (/\.(cp|opx|ori|svg)$/i.test(file.name)) return this.openPattern(file);
    let isPattern = false;
    await this.guarded(async () => {
      const { name, size } = file;
      this.say(`opening ${name} …`);
      if (size > kLargestFile)
        throw new Refused({ code: 'studio/file-too-large', message: `a file of ${size} bytes, where ${kLargestFile} fit`, where: name, suggestion: 'plico craft, on the command line' });
      try {
        await this.openBytes(name, new Uint8Array(await file.arrayBuffer()));
      } catch (error) {
        isPattern = error instanceof Refused && error.failure.code === 'fold/no-mesh';
        if (!isPattern) throw error;
      }
    });
    if (isPattern) await this.openPattern(file);
  }
  /** A file, or the text of one. */
  private paste(event: ClipboardEvent): void {
    const data = event.clipboardData;
    if (!data || event.target instanceof HTMLInputElement) return;
    const text = data.getData('text/plain').trim(), line = text.split('\n', 1)[0]!;
    const kind = /^[1-4]( +-?[\d.e-]+){4}\s*$/.test(line) ? 'cp' : /^<(\?xml|svg)/.test(line) ? 'svg' : line.startsWith('{') ? 'fold' : line.startsWith('OFF') ? 'off' : line.startsWith('ply') ? 'ply' : line.startsWith('solid') ? 'stl' : 'obj';
    const file = data.files[0] ?? (text ? new File([text], `pasted.${kind}`) : undefined);
    if (!file) return;
    event.preventDefault();
    void this.openFile(file);
  }
  private openPattern(file: File): Promise<void> {
    this.show('pattern');
    return this.patternPanel.open(file);
  }
  private async openMade(name: string, bytes: Uint8Array): Promise<void> {
    const before = this.session.shape;
    await this.open(name, bytes);
    if (this.session.shape !== before) this.show('net');
  }
  private async toTools(name: string, bytes: Uint8Array, job: string): Promise<void> {
    this.show('jobs');
    await this.guarded(() => this.jobsPanel.give(name, bytes, job));
  }
  private openSample(name: string): Promise<void> {
    return this.guarded(async () => {
      const made = await this.session.job('sample', [['name', name], ['output', `${name}.obj`]], {});
      await this.openBytes(`${name}.obj`, made.files[`${name}.obj`]!);
    });
  }

  private showModel(shape: Shape, notes: string[]): void {
    byId('start').hidden = true;
    byId('name').textContent = shape.model.name;
    document.title = `${shape.model.name} · Plico studio`;
    this.corner = -1;
    byId('hint').textContent = kHint;
    this.sheet.show(shape);
    requestAnimationFrame(() => this.foldPanel.newModel(shape)); // the net is drawn first, and no frame takes long
    this.pagesPanel.newModel();
    this.inflatePanel.newModel(shape);
    this.jobsPanel.newModel();
    this.show(this.tab === 'pages' || this.tab === 'pattern' ? 'net' : this.tab);
    this.words(shape);
    const folds = shape.model.faces;
    this.say([`${folds} faces`, ...notes].join(' · '));
  }
  private showEdit(shape: Shape, moved: boolean): void {
    this.sheet.preview(undefined);
    if (moved) this.sheet.fit();
    else this.sheet.redraw();
    this.foldPanel.edited(shape);
    this.inflatePanel.edited(shape);
    this.pagesPanel.edited();
    if (this.tab === 'pages') void this.pagesPanel.shown();
    this.words(shape);
  }
  private words(shape: Shape): void {
    this.steps();
    const { valid, parts, overlaps, defects } = shape.snapshot.verdict;
    const badge = byId('verdict');
    badge.dataset['status'] = valid ? 'good' : 'bad';
    const inParts = parts === 1 ? 'one net' : `${parts} parts`;
    badge.textContent = valid ? `${inParts}, verified` : overlaps ? `${overlaps} overlaps` : (defects[0] ?? 'not a net');
  }
  private steps(): void {
    const history = this.tab === 'pattern' ? this.patternPanel.steps : this.session.history, { names, done } = history.list;
    for (const [id, step] of [['undo', history.undoable], ['redo', history.redoable]] as const) {
      const button = byId<HTMLButtonElement>(id);
      button.disabled = !step;
      button.title = step ? `${id} ${step.name}` : id;
    }
    const list = byId<HTMLSelectElement>('history'), first = Math.max(0, done - kStepsListed);
    list.hidden = !names.length;
    list.replaceChildren(...(first ? [] : [new Option('as it was opened', '0')]), ...names.slice(first, done + kStepsListed).map((name, i) => new Option(`${first + i + 1} ${name}`, String(first + i + 1))));
    list.value = String(done);
  }
  /** To the state after so many steps. */
  private async jump(to: number): Promise<void> {
    const done = (): number => (this.tab === 'pattern' ? this.patternPanel.steps : this.session.history).list.done;
    for (let left = Math.abs(to - done()); left > 0; --left) await (to < done() ? this.undo() : this.redo());
  }

  /** What lies under the pointer, and what a click would do. */
  private async point(under: number): Promise<void> {
    const onFold = this.tab === 'fold', edge = onFold && under < 0 ? this.foldPanel.chosen : under;
    if (onFold) this.foldPanel.pointed(edge);
    if (edge === this.sheet.edge) return;
    this.sheet.edge = edge;
    this.sheet.preview(undefined);
    this.space.point(edge);
    const ticket = ++this.asked;
    byId('hint').textContent = edge < 0 ? kHint : '';
    if (edge < 0 || this.tab !== 'net' || this.session.busy) return;
    const edit = await this.session.editFor(edge);
    if (ticket !== this.asked) return;
    byId('hint').textContent = this.spoken(edge, edit);
    if (!edit || edit.edit === 'cut') return;
    const ghost = await this.session.preview(edit);
    if (ticket === this.asked) this.sheet.preview(ghost);
  }
  private spoken(edge: number, edit: Edit | null): string {
    const shape = this.session.shape!;
    const [a, b] = shape.facesOf(edge);
    const state = b < 0 ? 'border' : shape.snapshot.folds[edge] ? 'fold' : 'cut';
    const locked = shape.snapshot.locks[edge] ? ', locked' : '';
    const meaning = { cut: 'cut here', join: 'join here', move: 'join here, cut elsewhere', lock: '', net: '' };
    return `edge ${edge}, ${state}${locked}, face ${a}${b < 0 ? '' : ` and ${b}`}${edit ? ` · click: ${meaning[edit.edit]}` : ''}`;
  }

  private act(edge: number, lock: boolean): Promise<void> {
    if (this.tab === 'fold') this.foldPanel.pick(edge);
    if (this.tab !== 'net') return Promise.resolve();
    return this.guarded(async () => {
      const edit = lock ? this.lockOf(edge) : await this.session.editFor(edge);
      if (!edit) return this.say(`edge ${edge} stays as it is: it is at the border, locked, or all folds in the way are locked`);
      const before = this.session.shape!.snapshot.verdict.overlaps;
      const proven = this.foldPanel.proven;
      await this.session.edit(`${edit.edit} edge ${edge}`, edit);
      ++this.asked;
      const after = this.session.shape!.snapshot.verdict;
      const gone = proven && edit.edit !== 'lock' ? ' · the folding proof is gone (undo brings the net back)' : '';
      const worse = after.overlaps > before ? ` · ${after.overlaps} pairs of faces overlap now` : '';
      this.say(`${edit.edit} edge ${edge}${worse}${gone}`);
      byId('hint').textContent = this.spoken(edge, null);
    });
  }
  private lockOf(edge: number): Edit | null {
    const shape = this.session.shape!;
    return shape.isBorder(edge) ? null : { edit: 'lock', edge, locked: !shape.snapshot.locks[edge] };
  }

  private undo(): Promise<void> {
    if (this.tab === 'pattern') return Promise.resolve(this.patternPanel.undo());
    return this.guarded(async () => this.say(`undone: ${(await this.session.undo()) ?? 'nothing'}`));
  }
  private redo(): Promise<void> {
    if (this.tab === 'pattern') return Promise.resolve(this.patternPanel.redo());
    return this.guarded(async () => this.say(`done again: ${(await this.session.redo()) ?? 'nothing'}`));
  }
  private heal(): Promise<void> {
    return this.guarded(async () => {
      const edit = await this.session.search(false, (p) => this.progress(p));
      await this.session.edit('search a net', edit);
      await this.session.arrange();
      this.say('a net was searched');
    });
  }

  show(tab: Tab): void {
    if (tab !== this.tab && byId('status').dataset['kind'] === 'bad') this.say(''); // it was about another screen
    this.tab = tab;
    document.body.dataset['tab'] = tab;
    const open = this.session.shape !== undefined;
    for (const t of kTabs) {
      const button = byId<HTMLButtonElement>(`tab-${t}`);
      button.setAttribute('aria-selected', String(t === tab));
      button.tabIndex = t === tab ? 0 : -1;
    }
    byId('start').hidden = open || kWithoutModel.includes(tab);
    byId('space-view').hidden = !open || !['inflate', 'net', 'fold'].includes(tab);
    byId('sheet-view').hidden = !open || !['net', 'fold'].includes(tab);
    byId('panel-inflate').hidden = !open || tab !== 'inflate';
    byId('panel-net').hidden = tab !== 'net';
    byId('panel-fold').hidden = tab !== 'fold';
    byId('fold-more').hidden = !open || tab !== 'fold';
    byId('panel-pages').hidden = !open || tab !== 'pages';
    byId('panel-pattern').hidden = tab !== 'pattern';
    byId('panel-jobs').hidden = tab !== 'jobs';
    this.steps();
    if (tab === 'jobs') void this.guarded(() => this.jobsPanel.shown());
    if (tab === 'pattern') void this.patternPanel.shown();
    if (!open) return;
    this.foldPanel.shown(tab === 'fold');
    this.inflatePanel.shown(tab === 'inflate');
    if (tab === 'pages') void this.pagesPanel.shown();
  }

  private showStart(): void {
    for (const id of ['space-view', 'sheet-view', 'fold-more', 'panel-inflate', 'panel-pages', 'panel-pattern', 'panel-jobs']) byId(id).hidden = true;
    byId('start').hidden = false;
    this.foldPanel.shown(false);
    this.inflatePanel.shown(false);
    byId('file-start').focus();
  }

  private listen(): void {
    for (const id of ['file', 'file-start'])
      byId<HTMLInputElement>(id).addEventListener('change', (e) => void this.openFile((e.target as HTMLInputElement).files?.[0]));
    const choice = byId<HTMLSelectElement>('sample');
    for (const name of kSamples) {
      const words = name.replaceAll('-', ' ');
      choice.append(new Option(words, name));
      const button = document.createElement('button');
      button.textContent = words;
      button.addEventListener('click', () => void this.openSample(name));
      byId('samples').append(button);
    }
    choice.addEventListener('change', () => {
      if (choice.value) void this.openSample(choice.value);
      choice.value = '';
    });
    const on = (id: string, action: () => unknown): void => byId(id).addEventListener('click', () => void action());
    on('start-pattern', () => this.show('pattern'));
    on('home', () => this.showStart());
    on('undo', () => this.undo());
    on('redo', () => this.redo());
    on('heal', () => this.heal());
    on('fit', () => this.sheet.fit());
    on('arrange', () => this.guarded(() => this.session.arrange()));
    on('stop', () => this.session.stop());
    on('help-button', () => byId<HTMLDialogElement>('help').showModal());
    for (const tab of kTabs) on(`tab-${tab}`, () => this.show(tab));
    addEventListener('dragover', (e) => e.preventDefault());
    addEventListener('drop', (e) => {
      e.preventDefault();
      void this.openFile(e.dataTransfer?.files[0]);
    });
    addEventListener('paste', (e) => this.paste(e));
    byId('history').addEventListener('change', ({ target }) => void this.jump(Number((target as HTMLSelectElement).value)));
    addEventListener('keydown', (e) => this.key(e));
    addEventListener('keyup', (e) => this.inflatePanel.keyUp(e));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => (this.sheet.redraw(), this.space.redraw()));
  }

  private key(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey) {
      const redo = event.key === 'y' || (event.key.toLowerCase() === 'z' && event.shiftKey);
      if (!redo && event.key !== 'z') return;
      event.preventDefault();
      return void (redo ? this.redo() : this.undo());
    }
    const isSlider = target instanceof HTMLInputElement && target.type === 'range' && this.tab === 'inflate' && event.key === ' ';
    if (event.altKey || (['INPUT', 'SELECT', 'SUMMARY'].includes(target.tagName) && !isSlider) || byId<HTMLDialogElement>('help').open) return;
    const handled =
      target.id === 'sheet' ? this.sheetKey(event) : target.id === 'space' && this.spaceKey(event) ? true :
      target.id === 'pattern' ? this.patternPanel.key(event) :
      target.getAttribute('role') === 'tab' ? this.tabKey(event) : false;
    if (handled || this.anyKey(event, target.tagName === 'BUTTON')) event.preventDefault();
  }
  private anyKey(event: KeyboardEvent, onButton: boolean): boolean {
    const actions: Record<string, () => unknown> = {
      ...Object.fromEntries(kTabs.map((tab, i) => [String(i + 1), () => this.show(tab)])),
      '?': () => byId<HTMLDialogElement>('help').showModal(), Escape: () => this.session.stop(),
    };
    if (this.tab === 'fold' && this.session.shape) {
      if (this.foldPanel.key(event.key)) return true;
      if (!onButton) actions[' '] = () => this.foldPanel.play();
    }
    const onInflate = this.tab === 'inflate' && this.session.shape !== undefined && !(onButton && (event.key === ' ' || event.key === 'Enter'));
    if (onInflate && this.inflatePanel.key(event)) return true;
    const action = actions[event.key];
    action?.();
    return action !== undefined;
  }
  private tabKey(event: KeyboardEvent): boolean {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return false;
    const next = kTabs[(kTabs.indexOf(this.tab) + step + kTabs.length) % kTabs.length]!;
    this.show(next);
    byId(`tab-${next}`).focus();
    return true;
  }
  private spaceKey(event: KeyboardEvent): boolean {
    if (event.key !== 'f') return this.space.key(event);
    this.foldPanel.frame();
    return true;
  }
  private sheetKey(event: KeyboardEvent): boolean {
    const { shape } = this.session;
    if (!shape) return false;
    const edge = this.corner >= 0 ? shape.model.cornerEdges[this.corner]! : -1;
    const actions: Record<string, () => unknown> = {
      ArrowRight: () => this.walk(shape, this.corner < 0 ? 0 : shape.next[this.corner]!),
      ArrowLeft: () => this.walk(shape, this.corner < 0 ? 0 : shape.next.indexOf(this.corner)),
      ArrowUp: () => this.walk(shape, this.corner < 0 ? 0 : shape.across(this.corner)),
      ArrowDown: () => this.walk(shape, this.corner < 0 ? 0 : shape.across(this.corner)),
      Enter: () => edge >= 0 && this.act(edge, false),
      l: () => edge >= 0 && this.act(edge, true),
      f: () => this.sheet.fit(), '+': () => this.sheet.zoom(1.2), '-': () => this.sheet.zoom(1 / 1.2),
    };
    void actions[event.key]?.();
    return event.key in actions;
  }
  private walk(shape: Shape, corner: number): void {
    this.corner = corner;
    const edge = shape.model.cornerEdges[corner]!;
    void this.point(edge);
    this.say(this.spoken(edge, null));
  }

  async begin(): Promise<void> {
    const inlined = JSON.parse(byId('inlined').textContent!) as { name: string; bytes: string } | null;
    if (inlined) await this.open(inlined.name, bytesOf(atob(inlined.bytes)));
    const last = inlined ? undefined : await kept();
    const button = byId<HTMLButtonElement>('continue');
    button.hidden = !last;
    button.addEventListener('click', () => last && void this.guarded(async () => {
      await this.session.resume(last);
      this.pagesPanel.resumed(last.places, last.form);
    }));
    document.documentElement.dataset['ready'] = 'true';
  }
}

async function start(): Promise<void> {
  try {
    const { textContent: text, dataset } = byId('core'), size = (name: string): number => Number(dataset[name]);
    const packed = { text: text!.trim(), packedBytes: size('packed'), bytes: size('bytes'), scriptBytes: size('script') };
    const studio = new Studio(new Core(byId('loader').textContent!, packed));
    window.studio = { session: studio.session, tab: (tab) => studio.show(tab), pattern: studio.patternPanel, inflate: studio.inflatePanel };
    await studio.begin();
  } catch (error) {
    byId('status').textContent = `this browser cannot run the studio: ${String(error)}`;
  }
}
void start();
