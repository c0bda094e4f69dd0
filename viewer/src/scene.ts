// The folding sheet in space: a camera that goes round it, drawing, and which panel is under the pointer.
import { apply, kindOf, type Kind, type Model, type Pose } from './model';
import { Raster, rgbOf, type Rgb } from './raster';
import { Surfaces } from './surfaces';

export interface Look {
  front: Rgb;
  back: Rgb;
  ink: Rgb;
  accent: Rgb;
  alarm: Rgb;
  mountain: Rgb;
  valley: Rgb;
  flat: Rgb;
}

type Vec = [number, number, number];
const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const mix = (a: Rgb, b: Rgb, t: number): Rgb => [
  a[0] + (b[0] - a[0]) * t,
  a[1] + (b[1] - a[1]) * t,
  a[2] + (b[2] - a[2]) * t,
];

// The middle of everything, and the floor, at one moment.
interface Place {
  centre: Vec;
  floor: number;
}
// With the sphere around everything.
interface Extent extends Place {
  radius: number;
}

// A thick hinge: the sides of its panels, flat, from its beginning to its end and back, and the way to its left panel.
interface Joint {
  hinge: number;
  left: { panel: number; ends: [number, number][] };
  right: { panel: number; ends: [number, number][] };
  across: [number, number];
  roll: number;
}
const kStripTriangles = [[0, 1, 5], [0, 5, 4], [4, 5, 2], [4, 2, 3]] as const;

function jointsOf(model: Model): Joint[] {
  const { hinges, panels } = model.data;
  const side = (panel: number, x: number, y: number): [number, number][] => {
    const outline = panels[panel]!;
    const n = outline.length;
    const ends = (i: number): [number, number][] =>
      [[outline[i]!, outline[i + 1]!], [outline[(i + 2) % n]!, outline[(i + 3) % n]!]];
    const away = (i: number): number => {
      const [a, b] = ends(i);
      return Math.hypot(a![0] + b![0] - x, a![1] + b![1] - y);
    };
    let nearest = 0;
    for (let i = 2; i < n; i += 2) if (away(i) < away(nearest)) nearest = i;
    return ends(nearest);
  };
  return hinges.flatMap(({ left, right, from, to, roll }, hinge) => {
    if (!roll) return [];
    const [x, y] = [from[0] + to[0], from[1] + to[1]];
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    const across: [number, number] = [-(to[1] - from[1]) / length, (to[0] - from[0]) / length];
    return [{ hinge, roll, across, left: { panel: left, ends: side(left, x, y) }, right: { panel: right, ends: side(right, x, y) } }];
  });
}
const turned = (m: Pose, [x, y]: [number, number]): Vec => [m[0]! * x + m[1]! * y, m[3]! * x + m[4]! * y, m[6]! * x + m[7]! * y];

const kHome = { azimuth: -0.6, elevation: 0.62, zoom: 1 };
const kFieldOfView = 0.42;
const kMargin = 0.92; // of the view that the sphere around everything fills, at home
const kMoments = 16; // at which the place is measured

export class Scene {
  hovered = -1;
  selected = -1;
  showLines = true;
  private time = 0;
  private camera = { ...kHome };
  private readonly raster = new Raster();
  private readonly surfaces: Surfaces;
  private readonly joints: readonly Joint[];
  private readonly buffer = document.createElement('canvas');
  private readonly places: Place[] = [];
  private readonly typicalSide: number;
  private readonly painted: readonly Rgb[]; // fronts of panels; empty: all alike
  private quality = 1; // of pictures in motion; lowered where drawing is slow
  private pending = 0;
  private idle = 0;
  private eye: Vec = [0, 0, 0];
  private axes: { right: Vec; up: Vec; backward: Vec } = { right: [1, 0, 0], up: [0, 1, 0], backward: [0, 0, 1] };

  constructor(
    private readonly model: Model,
    private readonly canvas: HTMLCanvasElement,
    private readonly shadow: HTMLCanvasElement,
    private look: Look,
    private readonly onHover: (panel: number) => void,
    private readonly onSelect: (panel: number) => void,
  ) {
    for (let i = 0; i <= kMoments; i++) this.places.push(this.placeAt(i / kMoments));
    this.typicalSide = model.typicalSide();
    this.painted = (model.data.colors ?? []).map(rgbOf);
    this.surfaces = new Surfaces(model.data);
    this.joints = jointsOf(model);
    this.listen();
    new ResizeObserver(() => this.redraw()).observe(canvas);
  }

  setTime(time: number): void {
    this.time = time;
    this.redraw();
  }
  setLook(look: Look): void {
    this.look = look;
    this.redraw();
  }
  turn(azimuth: number, elevation: number): void {
    this.camera.azimuth += azimuth;
    this.camera.elevation = Math.min(1.55, Math.max(-1.55, this.camera.elevation + elevation));
    this.redraw();
  }
  zoom(factor: number): void {
    this.camera.zoom = Math.min(12, Math.max(0.3, this.camera.zoom * factor));
    this.redraw();
  }
  home(): void {
    Object.assign(this.camera, kHome);
    this.redraw();
  }

  // A quick picture now, a fine one as soon as nothing moves.
  redraw(): void {
    clearTimeout(this.idle);
    if (!this.pending) {
      this.pending = requestAnimationFrame(() => {
        this.pending = 0;
        const begin = performance.now();
        this.draw(this.quality * devicePixelRatio);
        const spent = performance.now() - begin;
        if (spent > 40 && this.quality > 0.4) this.quality *= 0.8;
        if (spent < 12 && this.quality < 1) this.quality = Math.min(1, this.quality * 1.1);
      });
    }
    this.idle = window.setTimeout(() => this.draw(2 * Math.min(2, Math.max(1, devicePixelRatio))), 120);
  }

  private placeAt(time: number): Place {
    const low: Vec = [Infinity, Infinity, Infinity];
    const high: Vec = [-Infinity, -Infinity, -Infinity];
    for (const points of this.model.positions(time)) {
      for (let i = 0; i < points.length; i++) {
        low[i % 3] = Math.min(low[i % 3]!, points[i]!);
        high[i % 3] = Math.max(high[i % 3]!, points[i]!);
      }
    }
    return { centre: low.map((x, i) => (x + high[i]!) / 2) as Vec, floor: low[2] };
  }
  // The centre glides from moment to moment; the radius is that of all panels as they are now.
  private extent(poses: Pose[]): Extent {
    const at = this.time * kMoments;
    const i = Math.min(kMoments - 1, Math.floor(at));
    const s = at - i;
    const a = this.places[i]!;
    const b = this.places[i + 1]!;
    const centre = a.centre.map((x, k) => (1 - s) * x + s * b.centre[k]!) as Vec;
    return { centre, radius: this.radiusAround(centre, poses), floor: (1 - s) * a.floor + s * b.floor };
  }
  private radiusAround(centre: Vec, poses: Pose[]): number {
    const { panels, thickness } = this.model.data;
    let radius = 0;
    panels.forEach((outline, p) => {
      for (let i = 0; i < outline.length; i += 2) {
        const [x, y, z] = apply(poses[p]!, outline[i]!, outline[i + 1]!, 0);
        radius = Math.max(radius, Math.hypot(x - centre[0], y - centre[1], z - centre[2]));
      }
    });
    return radius + thickness / 2 || 1;
  }

  private aim(width: number, height: number, extent: Extent): (p: Vec) => Vec {
    const { azimuth, elevation, zoom } = this.camera;
    const [ca, sa, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(elevation), Math.sin(elevation)];
    const backward: Vec = [sa * ce, -ca * ce, se];
    const right: Vec = [ca, sa, 0];
    const up: Vec = [-sa * se, ca * se, ce];
    const shorter = Math.min(width, height);
    const distance = extent.radius / Math.sin(kFieldOfView / 2) / zoom;
    this.eye = extent.centre.map((x, i) => x + backward[i]! * distance) as Vec;
    this.axes = { right, up, backward };
    const scale = (kMargin * shorter) / 2 / Math.tan(kFieldOfView / 2);
    return (p) => {
      const q: Vec = [p[0] - this.eye[0], p[1] - this.eye[1], p[2] - this.eye[2]];
      const away = Math.max(1e-6 * extent.radius, -dot(q, backward));
      return [width / 2 + (scale * dot(q, right)) / away, height / 2 - (scale * dot(q, up)) / away, -1 / away];
    };
  }

  private draw(scale: number): void {
    const box = this.canvas.getBoundingClientRect();
    if (box.width < 2 || box.height < 2) return;
    const raster = this.raster;
    raster.resize(Math.max(1, Math.round(box.width * scale)), Math.max(1, Math.round(box.height * scale)));
    raster.clear();
    const poses = this.model.poses(this.time);
    const extent = this.extent(poses);
    const project = this.aim(raster.width, raster.height, extent);
    this.drawPanels(poses, project, scale);
    this.drawJoints(poses, project, scale);
    if (this.showLines) this.drawLines(poses, project, scale, extent.radius);
    this.present();
    this.drawShadow(poses, extent);
  }

  private present(): void {
    const { raster, buffer, canvas } = this;
    buffer.width = raster.width;
    buffer.height = raster.height;
    buffer.getContext('2d')!.putImageData(raster.image, 0, 0);
    const box = canvas.getBoundingClientRect();
    canvas.width = Math.round(box.width * devicePixelRatio);
    canvas.height = Math.round(box.height * devicePixelRatio);
    const context = canvas.getContext('2d')!;
    context.imageSmoothingQuality = 'high';
    context.drawImage(buffer, 0, 0, canvas.width, canvas.height);
  }

  private drawPanels(poses: Pose[], project: (p: Vec) => Vec, scale: number): void {
    const { panels, triangles, thickness } = this.model.data;
    const colliding = this.model.colliding(this.time);
    panels.forEach((outline, p) => {
      const pose = poses[p]!;
      const hit = colliding.has(p);
      const side = (z: number): { points: Vec[]; screen: Vec[] } => {
        const points: Vec[] = [];
        for (let i = 0; i < outline.length; i += 2) points.push(apply(pose, outline[i]!, outline[i + 1]!, z));
        return { points, screen: points.map(project) };
      };
      const top = side(thickness / 2);
      const bottom = thickness > 0 ? side(-thickness / 2) : top;
      const normal: Vec = [pose[2]!, pose[5]!, pose[8]!];
      const toEye = (q: Vec): Vec => [this.eye[0] - q[0], this.eye[1] - q[1], this.eye[2] - q[2]];
      const frontSeen = dot(normal, toEye(top.points[0]!)) > 0;
      const facing: Vec = frontSeen ? normal : [-normal[0], -normal[1], -normal[2]];
      const colour = this.colour(p, frontSeen, hit, facing);
      const seen = frontSeen ? top : bottom;
      const surface = frontSeen ? this.surfaces.front(p) : this.surfaces.back(p);
      const list = triangles[p]!;
      for (let i = 0; i < list.length; i += 3) {
        const [a, b, c] = [seen.screen[list[i]!]!, seen.screen[list[i + 1]!]!, seen.screen[list[i + 2]!]!];
        this.raster.triangle(a, b, c, colour, surface, hit ? 4 * scale : 0);
      }
      if (thickness > 0) this.drawWalls(top.screen, bottom.screen, mix(colour, this.look.ink, 0.3), p);
    });
  }
  private drawWalls(top: Vec[], bottom: Vec[], colour: Rgb, panel: number): void {
    top.forEach((a, i) => {
      const j = (i + 1) % top.length;
      const wall = this.surfaces.wall(panel, i);
      this.raster.triangle(a, bottom[i]!, bottom[j]!, colour, wall);
      this.raster.triangle(a, bottom[j]!, top[j]!, colour, wall);
    });
  }

  // What joins the trimmed panels of thick hinges, as src/plico/io/motion/render.cpp draws it: a strip between their
  // mid-planes that gives way outwards a little, striped where it is a valley.
  private drawJoints(poses: Pose[], project: (p: Vec) => Vec, scale: number): void {
    this.joints.forEach(({ hinge, left, right, across, roll }) => {
      const { target } = this.model.data.hinges[hinge]!;
      const [from, to] = [poses[left.panel]!, poses[right.panel]!];
      const ends = [...left.ends.map((p) => apply(from, ...p, 0)), ...right.ends.map((p) => apply(to, ...p, 0))];
      const into = turned(from, across), away = turned(to, across);
      const out = into.map((x, i) => -0.3 * roll * (x - away[i]!));
      const middle = (a: Vec, b: Vec): Vec => a.map((x, i) => (x + b[i]!) / 2 + out[i]!) as Vec;
      ends.push(middle(ends[0]!, ends[3]!), middle(ends[1]!, ends[2]!));
      const kind = kindOf(target);
      const colour = mix(this.look.back, this.look[kind], kind === 'flat' ? 0.6 : 0.85);
      const on = ends.map(project);
      for (const [a, b, c] of kStripTriangles)
        this.raster.triangle(on[a]!, on[b]!, on[c]!, colour, -1, kind === 'valley' ? 3 * scale : 0);
    });
  }

  // A key light from the upper left behind the eye, and soft light from above.
  private colour(panel: number, front: boolean, hit: boolean, facing: Vec): Rgb {
    const { right, up, backward } = this.axes;
    const key = backward.map((x, i) => x + 0.55 * up[i]! - 0.6 * right[i]!) as Vec;
    const towards = 0.5 + (0.5 * dot(facing, key)) / Math.hypot(...key); // wrapped around: no side is black
    const light = 0.58 + 0.38 * towards * towards + 0.08 * (0.5 + 0.5 * facing[2]);
    let colour: Rgb = front ? (this.painted[panel] ?? this.look.front) : this.look.back;
    if (hit) colour = mix(colour, this.look.alarm, 0.75);
    if (panel === this.hovered) colour = mix(colour, this.look.accent, 0.45);
    if (panel === this.selected) colour = mix(colour, this.look.accent, 0.8);
    return mix([0, 0, 0], colour, Math.min(1, light));
  }

  private drawLines(poses: Pose[], project: (p: Vec) => Vec, scale: number, radius: number): void {
    const { panels, hinges, thickness } = this.model.data;
    // Lines stay lighter than the panels they bound, however many panels there are.
    const onScreen = (this.typicalSide / radius) * Math.min(this.raster.width, this.raster.height) * 0.5 * this.camera.zoom;
    const weight = Math.min(1, Math.max(0.38, onScreen / (30 * scale))) * scale;
    const thin = 1.3 * weight;
    panels.forEach((outline, p) => {
      for (const z of thickness > 0 ? [thickness / 2, -thickness / 2] : [0]) {
        const at = (i: number): Vec =>
          project(apply(poses[p]!, outline[(2 * i) % outline.length]!, outline[(2 * i + 1) % outline.length]!, z));
        for (let i = 0; 2 * i < outline.length; i++)
          this.raster.line(at(i), at(i + 1), thin, this.look.ink, this.surfaces.ofSide(p, i, z));
      }
    });
    hinges.forEach((hinge, h) => {
      if (hinge.roll) return; // drawJoints()
      const pose = poses[hinge.left]!;
      const within = this.surfaces.ofHinge(h);
      this.drawCrease(apply(pose, ...hinge.from), apply(pose, ...hinge.to), kindOf(hinge.target), project, weight, radius, within);
    });
  }
  // Mountains solid, valleys dashed, flat creases thin.
  private drawCrease(a: Vec, b: Vec, kind: Kind, project: (p: Vec) => Vec, weight: number, radius: number,
    within: readonly number[]): void {
    const colour = this.look[kind];
    if (kind !== 'valley') {
      this.raster.line(project(a), project(b), (kind === 'flat' ? 1 : 2.1) * weight, colour, within);
      return;
    }
    const dash = radius / 45;
    const length = Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    const dashes = Math.max(2, Math.round(length / dash));
    const point = (s: number): Vec => project([a[0] + (b[0] - a[0]) * s, a[1] + (b[1] - a[1]) * s, a[2] + (b[2] - a[2]) * s]);
    for (let i = 0; i < dashes; i++)
      this.raster.line(point((i + 0.15) / dashes), point((i + 0.75) / dashes), 2.1 * weight, colour, within);
  }

  // The outline of the panels on the floor, drawn small; the style sheet blurs it.
  private drawShadow(poses: Pose[], extent: Extent): void {
    const box = this.shadow.getBoundingClientRect();
    this.shadow.width = Math.max(1, Math.round(box.width / 3));
    this.shadow.height = Math.max(1, Math.round(box.height / 3));
    if (this.camera.elevation <= 0.05) return;
    const project = this.aim(this.shadow.width, this.shadow.height, extent);
    const context = this.shadow.getContext('2d')!;
    context.fillStyle = '#000';
    context.beginPath();
    this.model.data.panels.forEach((outline, p) => {
      for (let i = 0; i < outline.length; i += 2) {
        const [x, y] = apply(poses[p]!, outline[i]!, outline[i + 1]!, 0);
        const [sx, sy] = project([x, y, extent.floor - 0.01 * extent.radius]);
        if (i === 0) context.moveTo(sx, sy);
        else context.lineTo(sx, sy);
      }
      context.closePath();
    });
    context.fill();
  }

  private panelAt(event: PointerEvent): number {
    const box = this.canvas.getBoundingClientRect();
    const scale = this.raster.width / box.width;
    return this.surfaces.panelOf(this.raster.at((event.clientX - box.left) * scale, (event.clientY - box.top) * scale));
  }

  private listen(): void {
    let drag: { x: number; y: number; moved: number } | null = null;
    const canvas = this.canvas;
    canvas.addEventListener('pointerdown', (event) => {
      drag = { x: event.clientX, y: event.clientY, moved: 0 };
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!drag) {
        this.onHover(this.panelAt(event));
        return;
      }
      const dx = event.clientX - drag.x;
      const dy = event.clientY - drag.y;
      drag = { x: event.clientX, y: event.clientY, moved: drag.moved + Math.abs(dx) + Math.abs(dy) };
      this.turn(-dx * 0.008, dy * 0.008);
    });
    canvas.addEventListener('pointerup', (event) => {
      if (drag && drag.moved < 5) this.onSelect(this.panelAt(event));
      drag = null;
    });
    canvas.addEventListener('pointerleave', () => this.onHover(-1));
    canvas.addEventListener('dblclick', () => this.home());
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY * 0.0012));
    }, { passive: false });
  }
}
