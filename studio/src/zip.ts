// Several files as one: a ZIP archive without compression, dated 1980-01-01 so that equal files give equal bytes.
const kTable = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});
function crc32(bytes: Uint8Array): number {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = kTable[(crc ^ byte) & 255]! ^ (crc >>> 8);
  return ~crc >>> 0;
}

/** Little-endian numbers, each with its size in bytes. */
function packed(...numbers: [value: number, size: 2 | 4][]): Uint8Array {
  const view = new DataView(new ArrayBuffer(numbers.reduce((sum, [, size]) => sum + size, 0)));
  let at = 0;
  for (const [value, size] of numbers) {
    if (size === 2) view.setUint16(at, value, true);
    else view.setUint32(at, value, true);
    at += size;
  }
  return new Uint8Array(view.buffer);
}

const kVersion = 20, kNamesAreUtf8 = 0x800, kFirstDay = 0x21;

export function zipped(files: Record<string, Uint8Array>): Uint8Array {
  const parts: Uint8Array[] = [], directory: Uint8Array[] = [];
  const sizeOf = (all: Uint8Array[]): number => all.reduce((sum, part) => sum + part.length, 0);
  for (const [name, bytes] of Object.entries(files)) {
    const title = new TextEncoder().encode(name), at = sizeOf(parts);
    const facts: [number, 2 | 4][] = [
      [kVersion, 2], [kNamesAreUtf8, 2], [0, 2], [0, 2], [kFirstDay, 2], [crc32(bytes), 4], [bytes.length, 4], [bytes.length, 4], [title.length, 2], [0, 2],
    ];
    parts.push(packed([0x04034b50, 4], ...facts), title, bytes);
    directory.push(packed([0x02014b50, 4], [kVersion, 2], ...facts, [0, 2], [0, 2], [0, 2], [0, 4], [at, 4]), title);
  }
  const count = directory.length / 2;
  const end = packed([0x06054b50, 4], [0, 2], [0, 2], [count, 2], [count, 2], [sizeOf(directory), 4], [sizeOf(parts), 4], [0, 2]);
  const whole = new Uint8Array(sizeOf([...parts, ...directory, end]));
  let at = 0;
  for (const part of [...parts, ...directory, end]) whole.set(part, at), (at += part.length);
  return whole;
}
