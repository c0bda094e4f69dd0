// One model with the tables that both views need.
import type { Model, Snapshot } from '../core/protocol';
import { cornersOfEdges, faceOfCorners, nextCorners, triangulate } from './faces';

export class Shape {
  readonly triangles: Uint32Array;
  readonly triangleFaces: Uint32Array;
  readonly next: Uint32Array;
  readonly edgeCorners: Int32Array;
  readonly faceOf: Int32Array;
  overlapping = new Set<number>();

  constructor(readonly model: Model, public snapshot: Snapshot) {
    const { corners, faces } = triangulate(model.offsets, snapshot.flat);
    this.triangles = corners;
    this.triangleFaces = faces;
    this.next = nextCorners(model.offsets);
    this.edgeCorners = cornersOfEdges(model.edges, model.cornerEdges);
    this.faceOf = faceOfCorners(model.offsets);
    this.take(snapshot);
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
}
