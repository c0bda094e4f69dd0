// What was done, so that it can be undone and done again without limit.
import type { Edit } from './core/protocol';

/** An edit of the document, or something of the page's own. */
export type Step = { name: string } & ({ edit: Edit; inverse: Edit } | { again: () => void; back: () => void });

export class History<S extends { name: string }> {
  private steps: S[] = [];
  private at = 0; // steps before it are done

  add(step: S): void {
    this.steps.splice(this.at, Infinity, step);
    this.at = this.steps.length;
  }
  clear(): void {
    this.steps = [];
    this.at = 0;
  }
  get undoable(): S | undefined {
    return this.steps[this.at - 1];
  }
  get redoable(): S | undefined {
    return this.steps[this.at];
  }
  /** All steps, also those that were undone, and how many are done. */
  get list(): { names: string[]; done: number } {
    return { names: this.steps.map(({ name }) => name), done: this.at };
  }
  undone(): void {
    --this.at;
  }
  redone(): void {
    ++this.at;
  }
}
