// Numbers of the surfaces of panels, panel by panel: front, back, and the wall below each side. Those of a sheet without
// thickness are one, the front. And which of them a line lies in, as src/plico/io/motion/render.cpp finds it.
import type { PageData } from './model';

const kInPlane = 1e-9; // distance from a surface's plane, of the panel's size, that counts as in it

export class Surfaces {
  private readonly first: number[] = [];
  private readonly panel: number[] = []; // of each surface
  private readonly hinges: number[][];

  constructor(private readonly data: PageData) {
    data.panels.forEach((outline, p) => {
      this.first.push(this.panel.length);
      for (let i = 0; i < 2 + outline.length / 2; i++) this.panel.push(p);
    });
    this.hinges = data.hinges.map(({ left, right, from, to }) => [left, right].flatMap((p) => this.holding(p, from, to)));
  }

  front(panel: number): number {
    return this.first[panel]!;
  }
  back(panel: number): number {
    return this.first[panel]! + (this.data.thickness > 0 ? 1 : 0);
  }
  wall(panel: number, side: number): number {
    return this.first[panel]! + 2 + side;
  }
  panelOf(surface: number): number {
    return surface < 0 ? -1 : this.panel[surface]!;
  }

  ofSide(panel: number, side: number, z: number): number[] {
    return [z < 0 ? this.back(panel) : this.front(panel), this.wall(panel, side)];
  }
  ofHinge(hinge: number): readonly number[] {
    return this.hinges[hinge]!;
  }

  // The surfaces of a panel that hold the line from a to b, in the flat state.
  private holding(panel: number, a: readonly number[], b: readonly number[]): number[] {
    const outline = this.data.panels[panel]!;
    const half = this.data.thickness / 2;
    const n = outline.length;
    let size = 0;
    for (let i = 0; i < n; i += 2) size = Math.max(size, Math.hypot(outline[i]! - outline[0]!, outline[i + 1]! - outline[1]!));
    const near = (away: (p: readonly number[]) => number): boolean =>
      Math.max(Math.abs(away(a)), Math.abs(away(b))) <= kInPlane * size;
    const held: number[] = [];
    if (near((p) => p[2]! - half)) held.push(this.front(panel));
    if (half > 0 && near((p) => p[2]! + half)) held.push(this.back(panel));
    for (let i = 0; half > 0 && i < n; i += 2) {
      const [x, y] = [outline[i]!, outline[i + 1]!];
      const [dx, dy] = [outline[(i + 2) % n]! - x, outline[(i + 3) % n]! - y];
      if (near((p) => ((p[0]! - x) * dy - (p[1]! - y) * dx) / Math.hypot(dx, dy))) held.push(this.wall(panel, i / 2));
    }
    return held;
  }
}
