// Unpacks LZMA (the old .lzma files that `xz --format=lzma` writes): the module is a quarter smaller than as gzip, which
// is all that browsers unpack by themselves. Source: LZMA specification, Igor Pavlov, public domain; names are its own.

const kTop = 0x1000000; // of the range: below, another byte is read
const kBitModelTotal = 2048, kMoveBits = 5;
const kHeaderBytes = 13;
const kStates = 12, kPosStates = 16, kFullDistances = 128, kEndPosModelIndex = 14;

// Places of the probabilities in one array.
const kLengths = 2 + 2 * 8 * kPosStates + 256; // two choices, low and mid by position, high
const kIsMatch = 0, kIsRep0Long = kIsMatch + kStates * kPosStates, kIsRep = kIsRep0Long + kStates * kPosStates;
const kIsRepG0 = kIsRep + kStates, kIsRepG1 = kIsRepG0 + kStates, kIsRepG2 = kIsRepG1 + kStates;
const kPosSlot = kIsRepG2 + kStates, kPosDecoders = kPosSlot + 4 * 64, kAlign = kPosDecoders + 1 + kFullDistances - kEndPosModelIndex;
const kMatchLength = kAlign + 16, kRepLength = kMatchLength + kLengths, kLiterals = kRepLength + kLengths;

/** A stream of bits, each decoded with what is known of those before it. */
class RangeDecoder {
  private range = 0xffffffff;
  private code = 0;
  private at = kHeaderBytes + 1; // the first byte is always 0

  constructor(private readonly packed: Uint8Array, private readonly probabilities: Uint16Array) {
    for (let i = 0; i < 4; ++i) this.code = ((this.code << 8) | packed[this.at++]!) >>> 0;
  }
  private normalize(): void {
    if (this.range >= kTop) return;
    this.range = (this.range << 8) >>> 0;
    this.code = ((this.code << 8) | this.packed[this.at++]!) >>> 0;
  }
  bit(place: number): number {
    const p = this.probabilities[place]!, bound = (this.range >>> 11) * p;
    if (this.code < bound) {
      this.range = bound;
      this.probabilities[place] = p + ((kBitModelTotal - p) >> kMoveBits);
      this.normalize();
      return 0;
    }
    this.range -= bound;
    this.code -= bound;
    this.probabilities[place] = p - (p >> kMoveBits);
    this.normalize();
    return 1;
  }
  /** Bits that are 0 or 1 alike. */
  direct(count: number): number {
    let value = 0;
    for (; count > 0; --count) {
      this.range >>>= 1;
      const one = this.code >= this.range ? 1 : 0;
      if (one) this.code -= this.range;
      value = (value << 1) | one;
      this.normalize();
    }
    return value;
  }
  tree(place: number, bits: number): number {
    let m = 1;
    for (let i = 0; i < bits; ++i) m = (m << 1) | this.bit(place + m);
    return m - (1 << bits);
  }
  reverseTree(place: number, bits: number): number {
    let m = 1, value = 0;
    for (let i = 0; i < bits; ++i) {
      const one = this.bit(place + m);
      m = (m << 1) | one;
      value |= one << i;
    }
    return value;
  }
  length(place: number, posState: number): number {
    if (!this.bit(place)) return 2 + this.tree(place + 2 + 8 * posState, 3);
    if (!this.bit(place + 1)) return 10 + this.tree(place + 2 + 8 * (kPosStates + posState), 3);
    return 18 + this.tree(place + 2 + 16 * kPosStates, 8);
  }
  distance(length: number): number {
    const slot = this.tree(kPosSlot + 64 * Math.min(length - 2, 3), 6);
    if (slot < 4) return slot;
    const bits = (slot >> 1) - 1, start = (2 | (slot & 1)) << bits;
    if (slot < kEndPosModelIndex) return start + this.reverseTree(kPosDecoders + start - slot, bits);
    return start + (this.direct(bits - 4) << 4) + this.reverseTree(kAlign, 4);
  }
}

/** `size` is that of what was packed. */
export function unpacked(packed: Uint8Array, size: number): Uint8Array<ArrayBuffer> {
  const properties = packed[0]!;
  const lc = properties % 9, lp = Math.floor(properties / 9) % 5, pb = Math.floor(properties / 45);
  const decoder = new RangeDecoder(packed, new Uint16Array(kLiterals + (0x300 << (lc + lp))).fill(kBitModelTotal / 2));
  const out = new Uint8Array(size);
  const reps = [0, 0, 0, 0]; // the latest distances, less one
  let state = 0, at = 0;

  const literal = (): void => {
    const context = ((at & ((1 << lp) - 1)) << lc) + ((at ? out[at - 1]! : 0) >> (8 - lc));
    const place = kLiterals + 0x300 * context;
    let symbol = 1;
    if (state >= 7) { // after a match: what would have gone on there is a good guess
      let guess = out[at - reps[0]! - 1]!;
      while (symbol < 0x100) {
        const guessed = (guess >> 7) & 1, one = decoder.bit(place + ((1 + guessed) << 8) + symbol);
        guess <<= 1;
        symbol = (symbol << 1) | one;
        if (one !== guessed) break;
      }
    }
    while (symbol < 0x100) symbol = (symbol << 1) | decoder.bit(place + symbol);
    out[at++] = symbol;
    state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
  };
  /** The length of a repeated match; its distance becomes the latest. */
  const repeated = (posState: number): number => {
    if (!decoder.bit(kIsRepG0 + state)) {
      if (!decoder.bit(kIsRep0Long + kPosStates * state + posState)) {
        state = state < 7 ? 9 : 11;
        return 1;
      }
    } else {
      const which = !decoder.bit(kIsRepG1 + state) ? 1 : !decoder.bit(kIsRepG2 + state) ? 2 : 3;
      reps.unshift(...reps.splice(which, 1));
    }
    const length = decoder.length(kRepLength, posState);
    state = state < 7 ? 8 : 11;
    return length;
  };
  const fresh = (posState: number): number => {
    const length = decoder.length(kMatchLength, posState);
    reps.pop();
    reps.unshift(decoder.distance(length));
    state = state < 7 ? 7 : 10;
    return length;
  };

  while (at < size) {
    const posState = at & ((1 << pb) - 1);
    if (!decoder.bit(kIsMatch + kPosStates * state + posState)) literal();
    else {
      const length = decoder.bit(kIsRep + state) ? repeated(posState) : fresh(posState);
      for (let i = 0, from = at - reps[0]! - 1; i < length && at < size; ++i) out[at++] = out[from++]!;
    }
  }
  return out;
}
