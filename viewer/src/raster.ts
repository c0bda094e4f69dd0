// Triangles and lines into a depth buffer, in plain arrays. The page has no need of a graphics card: a net of a
// thousand panels is drawn faster this way than by a browser that imitates one.

export type Rgb = readonly [number, number, number];

export class Raster {
  width = 0;
  height = 0;
  image = new ImageData(1, 1);
  private pixels = new Uint32Array(1);
  private depth = new Float32Array(1); // grows away from the eye
  private ids = new Int32Array(1);

  resize(width: number, height: number): void {
    if (width === this.width && height === this.height) return;
    this.width = width;
    this.height = height;
    this.image = new ImageData(width, height);
    this.pixels = new Uint32Array(this.image.data.buffer);
    this.depth = new Float32Array(width * height);
    this.ids = new Int32Array(width * height);
  }

  clear(): void {
    this.pixels.fill(0);
    this.depth.fill(Infinity);
    this.ids.fill(-1);
  }

  // The panel at a pixel, -1 for none.
  at(x: number, y: number): number {
    const i = Math.floor(x);
    const j = Math.floor(y);
    return i < 0 || j < 0 || i >= this.width || j >= this.height ? -1 : this.ids[j * this.width + i]!;
  }

  // Corners as x, y, depth. An id of -1 leaves the panel underneath as what is picked. `stripe` above 0 darkens every
  // other diagonal band of that many pixels: a mark that does not need colour.
  triangle(a: readonly number[], b: readonly number[], c: readonly number[], colour: Rgb, id: number, stripe = 0): void {
    const [ax, ay, az] = a as [number, number, number];
    const [bx, by, bz] = b as [number, number, number];
    const [cx, cy, cz] = c as [number, number, number];
    const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    if (!(Math.abs(area) > 1e-12)) return;
    const left = Math.max(0, Math.floor(Math.min(ax, bx, cx)));
    const right = Math.min(this.width - 1, Math.ceil(Math.max(ax, bx, cx)));
    const top = Math.max(0, Math.floor(Math.min(ay, by, cy)));
    const bottom = Math.min(this.height - 1, Math.ceil(Math.max(ay, by, cy)));
    const pack = (k: number): number =>
      (0xff000000 | ((colour[2] * k) << 16) | ((colour[1] * k) << 8) | (colour[0] * k)) >>> 0;
    const plain = pack(1);
    const dark = stripe > 0 ? pack(0.55) : plain;
    // Weights of b and c, linear over the screen.
    const ub = (cy - ay) / area, vb = -(cx - ax) / area;
    const uc = -(by - ay) / area, vc = (bx - ax) / area;
    const dz = ub * (bz - az) + uc * (cz - az);
    const { pixels, depth, ids, width } = this;
    for (let y = top; y <= bottom; y++) {
      const py = y + 0.5 - ay;
      const px = left + 0.5 - ax;
      let wb = ub * px + vb * py;
      let wc = uc * px + vc * py;
      let z = az + wb * (bz - az) + wc * (cz - az);
      let i = y * width + left;
      for (let x = left; x <= right; x++, i++, wb += ub, wc += uc, z += dz) {
        if (wb < 0 || wc < 0 || wb + wc > 1 || z >= depth[i]!) continue;
        depth[i] = z;
        pixels[i] = stripe > 0 && Math.floor((x + y) / stripe) % 2 ? dark : plain;
        if (id >= 0) ids[i] = id;
      }
    }
  }

  // A line `thick` pixels wide, a little nearer than it is, so that its own panels do not hide it.
  line(a: readonly number[], b: readonly number[], thick: number, colour: Rgb): void {
    const dx = b[0]! - a[0]!;
    const dy = b[1]! - a[1]!;
    const length = Math.hypot(dx, dy);
    if (!(length > 1e-9)) return;
    const sx = (-dy / length) * (thick / 2);
    const sy = (dx / length) * (thick / 2);
    const za = a[2]! * kNearer;
    const zb = b[2]! * kNearer;
    const p = [a[0]! + sx, a[1]! + sy, za], q = [a[0]! - sx, a[1]! - sy, za];
    const r = [b[0]! + sx, b[1]! + sy, zb], s = [b[0]! - sx, b[1]! - sy, zb];
    this.triangle(p, q, r, colour, -1);
    this.triangle(r, q, s, colour, -1);
  }
}

const kNearer = 1.004; // depth is -1 / distance: nearer is more negative
