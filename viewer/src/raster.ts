// Triangles and lines into a depth buffer, in plain arrays. The page has no need of a graphics card: a net of a
// thousand panels is drawn faster this way than by a browser that imitates one.

export type Rgb = readonly [number, number, number];

type Point = readonly number[];

export class Raster {
  width = 0;
  height = 0;
  image = new ImageData(1, 1);
  private pixels = new Uint32Array(1);
  private depth = new Float32Array(1); // grows away from the eye
  private lineDepth = new Float32Array(1);
  private surfaces = new Int32Array(1); // seen at each pixel, -1 for none

  resize(width: number, height: number): void {
    if (width === this.width && height === this.height) return;
    this.width = width;
    this.height = height;
    this.image = new ImageData(width, height);
    this.pixels = new Uint32Array(this.image.data.buffer);
    this.depth = new Float32Array(width * height);
    this.lineDepth = new Float32Array(width * height);
    this.surfaces = new Int32Array(width * height);
  }

  clear(): void {
    this.pixels.fill(0);
    this.depth.fill(Infinity);
    this.lineDepth.fill(Infinity);
    this.surfaces.fill(-1);
  }

  // The surface at a pixel, -1 for none.
  at(x: number, y: number): number {
    const i = Math.floor(x);
    const j = Math.floor(y);
    return i < 0 || j < 0 || i >= this.width || j >= this.height ? -1 : this.surfaces[j * this.width + i]!;
  }

  // Corners as x, y, depth. `stripe` above 0 darkens every other diagonal band of that many pixels: a mark that does not
  // need colour.
  triangle(a: Point, b: Point, c: Point, colour: Rgb, surface: number, stripe = 0): void {
    const plain = pack(colour, 1);
    const dark = stripe > 0 ? pack(colour, 0.55) : plain;
    const { pixels, depth, surfaces, width } = this;
    this.eachPixel(a, b, c, (i, z) => {
      if (z >= depth[i]!) return;
      depth[i] = z;
      surfaces[i] = surface;
      pixels[i] = stripe > 0 && Math.floor(((i % width) + Math.floor(i / width)) / stripe) % 2 ? dark : plain;
    });
  }

  // A line `thick` pixels wide, drawn when all surfaces are. It lies in the surfaces `within`, so only others hide it:
  // were it moved towards the eye instead, edges of the back would shine through near corners of the outline. Of two
  // lines that are equally far, the later is seen.
  line(a: Point, b: Point, thick: number, colour: Rgb, within: readonly number[]): void {
    const dx = b[0]! - a[0]!;
    const dy = b[1]! - a[1]!;
    const length = Math.hypot(dx, dy);
    if (!(length > 1e-9)) return;
    const sx = (-dy / length) * (thick / 2);
    const sy = (dx / length) * (thick / 2);
    const p = [a[0]! + sx, a[1]! + sy, a[2]!], q = [a[0]! - sx, a[1]! - sy, a[2]!];
    const r = [b[0]! + sx, b[1]! + sy, b[2]!], s = [b[0]! - sx, b[1]! - sy, b[2]!];
    const ink = pack(colour, 1);
    const { pixels, depth, lineDepth, surfaces } = this;
    const paint = (i: number, z: number): void => {
      const tie = kTie * Math.abs(z);
      if (z > lineDepth[i]! + tie || (z >= depth[i]! - tie && !within.includes(surfaces[i]!))) return;
      lineDepth[i] = z;
      pixels[i] = ink;
    };
    this.eachPixel(p, q, r, paint);
    this.eachPixel(r, q, s, paint);
  }

  // Calls paint(pixel, depth) for the pixels of a triangle, whichever way it turns.
  private eachPixel(a: Point, b: Point, c: Point, paint: (i: number, z: number) => void): void {
    const [ax, ay, az] = a as [number, number, number];
    const [bx, by, bz] = b as [number, number, number];
    const [cx, cy, cz] = c as [number, number, number];
    const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    if (!(Math.abs(area) > 1e-12)) return;
    const left = Math.max(0, Math.floor(Math.min(ax, bx, cx)));
    const right = Math.min(this.width - 1, Math.ceil(Math.max(ax, bx, cx)));
    const top = Math.max(0, Math.floor(Math.min(ay, by, cy)));
    const bottom = Math.min(this.height - 1, Math.ceil(Math.max(ay, by, cy)));
    // Weights of b and c, linear over the screen.
    const ub = (cy - ay) / area, vb = -(cx - ax) / area;
    const uc = -(by - ay) / area, vc = (bx - ax) / area;
    const dz = ub * (bz - az) + uc * (cz - az);
    for (let y = top; y <= bottom; y++) {
      const py = y + 0.5 - ay;
      const px = left + 0.5 - ax;
      let wb = ub * px + vb * py;
      let wc = uc * px + vc * py;
      let z = az + wb * (bz - az) + wc * (cz - az);
      let i = y * this.width + left;
      for (let x = left; x <= right; x++, i++, wb += ub, wc += uc, z += dz)
        if (wb >= 0 && wc >= 0 && wb + wc <= 1) paint(i, z);
    }
  }
}

const kTie = 1e-6; // relative difference of depth below which two things are equally far: rounding

// Of "#rrggbb".
export function rgbOf(hex: string): Rgb {
  return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)) as unknown as Rgb;
}

function pack(colour: Rgb, light: number): number {
  return (0xff000000 | ((colour[2] * light) << 16) | ((colour[1] * light) << 8) | (colour[0] * light)) >>> 0;
}
