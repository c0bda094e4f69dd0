// The document on the page: the model in the worker, what was done to it, and its copy in the browser's storage.
import type { Core } from './core/client';
import type { Edit, Inflated, InflateOptions, JobDescription, JobResult, JobValues, Model, Progress, Snapshot } from './core/protocol';
import { History, type Step } from './history';
import { keepEdits, keepForm, keepPlaces, keepProject, type Filled, type Kept, type Places } from './store';
import { Shape } from './views/shape';

const kSaveAfter = 100; // milliseconds without an edit
const kEditsAtMost = 200; // until the project is written as a whole again

/** A file that folds, to be looked at beside the document. */
export interface PlayedFile {
  name: string;
  bytes: Uint8Array;
}

export class Session {
  readonly history = new History<Step>();
  shape?: Shape;
  busy = false; // with something long that can be stopped
  private places: Places = new Map();
  private saved?: Kept & { edits: Edit[] }; // what a fresh worker needs to stand where we are
  private restoring = false; // a worker that ends at this is not given it again
  private played?: PlayedFile;
  private timer = 0;
  private writing: Promise<unknown> = Promise.resolve();
  private queue: Promise<unknown> = Promise.resolve();

  constructor(
    private readonly core: Core, private readonly onModel: (shape: Shape, notes: string[]) => void,
    private readonly onEdit: (shape: Shape, moved: boolean) => void, // moved: all parts lie anew
    private readonly onKept: (fine: boolean) => void,
  ) {
    core.onRestart = () => void this.inOrder(() => this.restore()); // whoever stopped it need not wait for that
  }

  /** One thing after the other: an edit never overtakes another. */
  private inOrder<T>(work: () => Promise<T>): Promise<T> {
    const next = this.queue.then(work, work);
    this.queue = next.catch(() => undefined);
    return next;
  }

  open(name: string, bytes: Uint8Array, progress?: (p: Progress) => void): Promise<void> {
    return this.long(async () => {
      const { model, snapshot } = await this.core.call('open', [name, bytes], progress);
      this.history.clear();
      this.places = new Map();
      this.begin(model, snapshot);
      void this.inOrder(() => this.save());
    });
  }
  /** What was kept: the project, and the edits since, which can be undone. */
  async resume({ name, project, edits }: Kept & { edits: Edit[] }): Promise<void> {
    await this.open(name, project);
    for (const edit of edits) await this.edit(edit.edit, edit);
  }
  private begin(model: Model, snapshot: Snapshot): void {
    this.shape = new Shape(model, snapshot);
    this.onModel(this.shape, model.notes);
  }

  edit(name: string, edit: Edit): Promise<void> {
    return this.inOrder(async () => {
      const inverse = await this.change(edit);
      this.history.add({ name, edit, inverse });
      this.onEdit(this.shape!, false);
    });
  }
  /** Something that the page itself does and takes back. */
  own(name: string, again: () => void, back: () => void): Promise<void> {
    return this.inOrder(async () => {
      again();
      this.history.add({ name, again, back });
      this.onEdit(this.shape!, false);
    });
  }
  undo(): Promise<string | undefined> {
    return this.inOrder(async () => {
      const step = this.history.undoable;
      if (!step) return undefined;
      if ('inverse' in step) await this.change(step.inverse);
      else step.back();
      this.history.undone();
      this.onEdit(this.shape!, false);
      return step.name;
    });
  }
  redo(): Promise<string | undefined> {
    return this.inOrder(async () => {
      const step = this.history.redoable;
      if (!step) return undefined;
      if ('edit' in step) await this.change(step.edit);
      else step.again();
      this.history.redone();
      this.onEdit(this.shape!, false);
      return step.name;
    });
  }
  private async change(edit: Edit): Promise<Edit> {
    const { inverse, snapshot } = await this.core.call('apply', [edit]);
    this.saved?.edits.push(edit);
    this.shape!.take(snapshot);
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.keepEdits(), kSaveAfter);
    return inverse;
  }
  arrange(): Promise<void> {
    return this.inOrder(async () => {
      this.shape!.take(await this.core.call('arrange', []));
      this.onEdit(this.shape!, true);
    });
  }

  private async save(): Promise<void> {
    if (!this.shape) return;
    const project = await this.core.call('project', []);
    const kept = { name: `${this.shape.model.name}.plico`, project, id: Date.now() };
    this.saved = { ...kept, edits: [] };
    const { places } = this;
    this.write(() => keepProject(kept, places));
  }
  private keepEdits(): void {
    if (!this.saved) return;
    const { id, edits } = this.saved;
    if (edits.length > kEditsAtMost) void this.inOrder(() => this.save());
    else this.write(() => keepEdits(id, [...edits]));
  }
  /** Where parts lie on their pages, which is no part of the document. */
  keepPlaces(places: Places): void {
    this.places = places;
    if (!this.saved) return;
    const { id } = this.saved;
    this.write(() => keepPlaces(id, places));
  }
  keepForm(form: Filled): void {
    this.write(() => keepForm(form));
  }
  /** In order among themselves; nothing else waits for the disk. */
  private write(work: () => Promise<boolean>): void {
    this.writing = this.writing.then(async () => this.onKept(await work()));
  }

  /** Something that may take long; stop() ends it, and the document stays as it was. */
  long<T>(work: () => Promise<T>): Promise<T> {
    return this.inOrder(async () => {
      this.busy = true;
      try {
        return await work();
      } finally {
        this.busy = false;
      }
    });
  }
  stop(): void {
    if (this.busy) this.core.restart();
  }
  private async restore(): Promise<void> {
    if (this.restoring) return;
    this.restoring = true;
    try {
      if (this.saved) await this.replay(this.saved);
      if (this.played) await this.core.call('play', [this.played.name, this.played.bytes]);
    } finally {
      this.restoring = false;
    }
  }
  private async replay({ project, edits }: { project: Uint8Array; edits: Edit[] }): Promise<void> {
    let { snapshot } = await this.core.call('open', ['project.plico', project]);
    for (const edit of edits) ({ snapshot } = await this.core.call('apply', [edit]));
    this.shape!.take(snapshot);
    this.onEdit(this.shape!, false);
  }

  search(folds: boolean, progress: (p: Progress) => void): Promise<Edit> {
    return this.long(() => this.core.call('search', [folds], progress));
  }
  motion(plan: boolean, progress: (p: Progress) => void) {
    return this.long(() => this.core.call('motion', [plan], progress));
  }
  fold(time: number): Promise<Float32Array> {
    return this.core.call('fold', [time]);
  }
  play(file: PlayedFile): Promise<{ model: Model; snapshot: Snapshot }> {
    this.played = file;
    return this.inOrder(() => this.core.call('play', [file.name, file.bytes]));
  }
  /** The worker has one file at a time. */
  async playAt(time: number, file: PlayedFile): Promise<Float32Array> {
    if (this.played !== file) await this.play(file);
    return this.core.call('playAt', [time]);
  }
  net(): Promise<Uint8Array> {
    return this.core.call('net', []);
  }
  project(): Promise<Uint8Array> {
    return this.core.call('project', []);
  }
  mesh(): Promise<Uint8Array> {
    return this.core.call('mesh', []);
  }
  jobs(): Promise<JobDescription[]> {
    return this.core.call('jobs', []);
  }
  editFor(edge: number): Promise<Edit | null> {
    return this.core.call('editFor', [edge]);
  }
  preview(edit: Edit) {
    return this.core.call('preview', [edit]);
  }
  inflateBegin(options: InflateOptions): Promise<Inflated> {
    return this.core.call('inflateBegin', [options]);
  }
  inflateStep(): Promise<Inflated> {
    return this.core.call('inflateStep', []);
  }
  inflatedMesh(): Promise<Uint8Array> {
    return this.core.call('inflatedMesh', []);
  }
  job(name: string, values: JobValues, files: Record<string, Uint8Array>, progress?: (p: Progress) => void): Promise<JobResult> {
    return this.long(() => this.core.call('job', [name, values, files], progress));
  }
}
