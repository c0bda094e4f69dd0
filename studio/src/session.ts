// The document on the page: the model in the worker, what was done to it, and its copy in the browser's storage.
import { type Core, Stopped } from './core/client';
import type { Edit, JobDescription, JobResult, JobValues, Model, Progress, Snapshot } from './core/protocol';
import { History } from './history';
import { keep } from './store';
import { Shape } from './views/shape';

const kSaveAfter = 400; // milliseconds without an edit

export class Session {
  readonly history = new History();
  shape?: Shape;
  busy = false; // with something long that can be stopped
  private saved?: { bytes: Uint8Array; since: Edit[] }; // what a fresh worker needs to stand where we are
  private timer = 0;
  private queue: Promise<unknown> = Promise.resolve();

  constructor(
    private readonly core: Core, private readonly onModel: (shape: Shape, notes: string[]) => void,
    private readonly onEdit: (shape: Shape, moved: boolean) => void, // moved: all parts lie anew
  ) {}

  /** One thing after the other: an edit never overtakes another. */
  private inOrder<T>(work: () => Promise<T>): Promise<T> {
    const next = this.queue.then(work, work);
    this.queue = next.catch(() => undefined);
    return next;
  }

  open(name: string, bytes: Uint8Array, progress?: (p: Progress) => void): Promise<void> {
    return this.inOrder(async () => {
      const { model, snapshot } = await this.core.call('open', [name, bytes], progress);
      this.history.clear();
      this.begin(model, snapshot);
      await this.save();
    });
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
  undo(): Promise<string | undefined> {
    return this.inOrder(async () => {
      const step = this.history.undoable;
      if (!step) return undefined;
      await this.change(step.inverse);
      this.history.undone();
      this.onEdit(this.shape!, false);
      return step.name;
    });
  }
  redo(): Promise<string | undefined> {
    return this.inOrder(async () => {
      const step = this.history.redoable;
      if (!step) return undefined;
      await this.change(step.edit);
      this.history.redone();
      this.onEdit(this.shape!, false);
      return step.name;
    });
  }
  private async change(edit: Edit): Promise<Edit> {
    const { inverse, snapshot } = await this.core.call('apply', [edit]);
    this.saved?.since.push(edit);
    this.shape!.take(snapshot);
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.inOrder(() => this.save()), kSaveAfter);
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
    const bytes = await this.core.call('project', []);
    this.saved = { bytes, since: [] };
    await keep({ name: `${this.shape.model.name}.plico`, project: bytes });
  }

  /** Something that may take long; stop() ends it, and the document stays as it was. */
  long<T>(work: () => Promise<T>): Promise<T> {
    return this.inOrder(async () => {
      this.busy = true;
      try {
        return await work();
      } catch (error) {
        if (error instanceof Stopped) await this.restore();
        throw error;
      } finally {
        this.busy = false;
      }
    });
  }
  stop(): void {
    if (this.busy) this.core.restart();
  }
  private async restore(): Promise<void> {
    if (!this.saved) return;
    const { bytes, since } = this.saved;
    let { snapshot } = await this.core.call('open', ['project.plico', bytes]);
    for (const edit of since) ({ snapshot } = await this.core.call('apply', [edit]));
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
  job(name: string, values: JobValues, files: Record<string, Uint8Array>, progress?: (p: Progress) => void): Promise<JobResult> {
    return this.long(() => this.core.call('job', [name, values, files], progress));
  }
}
