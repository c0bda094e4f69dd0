// One model as the views see it: its tables, and the net as it lies.
import type { Model, Snapshot } from '../core/protocol';
import { linesOf } from './net_lines';

export class Shape {
  overlapping = new Set<number>();

  constructor(readonly model: Model, public snapshot: Snapshot) {
    this.take(snapshot);
  }

  get triangles(): Uint32Array {
    return this.model.tables.triangles;
  }
  get triangleFaces(): Uint32Array {
    return this.model.tables.triangleFaces;
  }
  get next(): Uint32Array {
    return this.model.tables.next;
  }
  get edgeCorners(): Int32Array {
    return this.model.tables.edgeCorners;
  }
  get faceOf(): Int32Array {
    return this.model.tables.faceOf;
  }

  take(snapshot: Snapshot): void {
    this.snapshot = snapshot;
    this.overlapping = new Set(snapshot.verdict.pairs.flat());
  }
  isBorder(edge: number): boolean {
    return this.edgeCorners[2 * edge + 1]! < 0;
  }
  facesOf(edge: number): [number, number] {
    const other = this.edgeCorners[2 * edge + 1]!;
    return [this.faceOf[this.edgeCorners[2 * edge]!]!, other < 0 ? -1 : this.faceOf[other]!];
  }
  /** The same edge, seen from its other face; the same corner at a border. */
  across(corner: number): number {
    const edge = this.model.cornerEdges[corner]!;
    const [a, b] = [this.edgeCorners[2 * edge]!, this.edgeCorners[2 * edge + 1]!];
    return b < 0 ? a : corner === a ? b : a;
  }

  /** Pairs of corners: every edge of the mesh. */
  edgesOnce(): Uint32Array {
    const { edgeCorners, next, model: { edges } } = this, ends = new Uint32Array(2 * edges);
    for (let e = 0; e < edges; ++e) ends[2 * e] = edgeCorners[2 * e]!, ends[2 * e + 1] = next[edgeCorners[2 * e]!]!;
    return ends;
  }
  /** Pairs of corners: each fold once, each cut as often as there are copies of it. */
  lines(): { folds: Uint32Array; cuts: Uint32Array } {
    const { next, edgeCorners, model: { cornerEdges }, snapshot } = this;
    return linesOf({ next, edgeCorners, cornerEdges }, snapshot.folds);
  }
}
