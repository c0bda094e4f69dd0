// Bytes as printable text that may stand in a script element: 13 or 14 bits in two characters (as basE91 does), so a
// module takes a twelfth less than in base64. Written by build_page.mjs.
const kDigits = [...Array(94).keys()].map((i) => String.fromCharCode(33 + i)).filter((c) => c !== '<').join('');

const kSmall = 456; // of 93 * 93 = 8192 + 457 values, those up to here are taken twice: with 13 bits more would not fit

export function decoded(text: string, size: number): Uint8Array<ArrayBuffer> {
  const digit = new Uint8Array(128);
  for (let i = 0; i < kDigits.length; ++i) digit[kDigits.charCodeAt(i)] = i;
  const bytes = new Uint8Array(size);
  let bits = 0, held = 0, at = 0;
  for (let i = 0; i < text.length; i += 2) {
    const pair = digit[text.charCodeAt(i)]! + 93 * digit[text.charCodeAt(i + 1)]!;
    bits |= pair << held;
    held += (pair & 8191) > kSmall ? 13 : 14;
    for (; held > 7; held -= 8, bits >>>= 8) bytes[at++] = bits & 255; // what lies beyond the end is not kept
  }
  return bytes;
}
