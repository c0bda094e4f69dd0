// Which lines a net has: pairs of corners.

/** Of every corner; see protocol.ts. */
export interface Sides {
  next: Uint32Array;
  edgeCorners: Int32Array;
  cornerEdges: Int32Array;
}

/** Each fold once, each cut as often as there are copies of it. */
export function linesOf({ next, edgeCorners, cornerEdges }: Sides, isFold: Uint8Array): { folds: Uint32Array; cuts: Uint32Array } {
  const folds = new Uint32Array(next.length), cuts = new Uint32Array(2 * next.length);
  let f = 0, k = 0;
  for (let c = 0; c < next.length; ++c) {
    const e = cornerEdges[c]!;
    if (!isFold[e]) cuts[k++] = c, cuts[k++] = next[c]!;
    else if (edgeCorners[2 * e] === c) folds[f++] = c, folds[f++] = next[c]!;
  }
  return { folds: folds.subarray(0, f), cuts: cuts.subarray(0, k) };
}
