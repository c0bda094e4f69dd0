// What was done, so that it can be undone and done again without limit.
import type { Edit } from './core/protocol';

export interface Step {
  name: string;
  edit: Edit;
  inverse: Edit;
}

export class History {
  private steps: Step[] = [];
  private at = 0; // steps before it are done

  add(step: Step): void {
    this.steps.splice(this.at, Infinity, step);
    this.at = this.steps.length;
  }
  clear(): void {
    this.steps = [];
    this.at = 0;
  }
  get undoable(): Step | undefined {
    return this.steps[this.at - 1];
  }
  get redoable(): Step | undefined {
    return this.steps[this.at];
  }
  undone(): void {
    --this.at;
  }
  redone(): void {
    ++this.at;
  }
  /** The edits that lead from the first state to this one, as `plico edit` reads them. */
  edits(): Edit[] {
    return this.steps.slice(0, this.at).map((step) => step.edit);
  }
}
