// A model in space, drawn with WebGL 2: the mesh as it is, or its panels on the way from flat to folded.
import { listen } from './pointers';
import type { Shape } from './shape';

export interface SpaceColors {
  front: number[]; back: number[]; ink: number[]; alarm: number[]; accent: number[]; fold: number[];
}

type Vec = [number, number, number];

const kPixelsPerRadian = 150;

const kFaceVertex = `#version 300 es
in vec3 at; in float mark; uniform mat4 view; out vec3 place; flat out float marked;
void main() { place = at; marked = mark; gl_Position = view * vec4(at, 1.0); }`;
const kFaceFragment = `#version 300 es
precision highp float;
in vec3 place; flat in float marked; uniform vec3 eye, front, back, alarm; out vec4 color;
void main() {
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  vec3 toEye = normalize(eye - place);
  float light = 0.45 + 0.55 * abs(dot(normal, toEye));
  vec3 base = gl_FrontFacing ? front : back;
  float stripe = step(0.5, fract((gl_FragCoord.x + gl_FragCoord.y) / 9.0));
  color = vec4(mix(base, alarm, marked > 0.5 ? 0.35 + 0.5 * stripe : 0.0) * light, 1.0);
}`;
const kLineVertex = `#version 300 es
in vec3 at; uniform mat4 view; void main() { gl_Position = view * vec4(at, 1.0); gl_Position.z -= 0.0004 * gl_Position.w; }`;
const kLineFragment = `#version 300 es
precision mediump float; uniform vec3 ink; out vec4 color; void main() { color = vec4(ink, 1.0); }`;

function program(gl: WebGL2RenderingContext, vertex: string, fragment: string): WebGLProgram {
  const made = gl.createProgram()!;
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]] as const) {
    const shader = gl.createShader(kind)!;
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.bindAttribLocation(made, 0, 'at');
  gl.bindAttribLocation(made, 1, 'mark');
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made) ?? 'no program');
  return made;
}

const minus = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec, b: Vec): Vec => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

export class SpaceView {
  private readonly gl: WebGL2RenderingContext | null;
  private faces?: WebGLProgram;
  private lines?: WebGLProgram;
  private buffers!: { at: WebGLBuffer; mark: WebGLBuffer; triangles: WebGLBuffer; folds: WebGLBuffer; cuts: WebGLBuffer; pick: WebGLBuffer };
  private counts = { triangles: 0, folds: 0, cuts: 0, pick: 0 };
  private shape?: Shape;
  private at: Float32Array = new Float32Array();
  private center: Vec = [0, 0, 0];
  private radius = 1;
  private azimuth = -0.6;
  private elevation = 0.5;
  private distance = 1; // times what shows the sphere around all
  private chosen = false; // by someone, who wants to keep it
  private queued = false;
  private edge = -1;

  constructor(
    private readonly canvas: HTMLCanvasElement, private readonly colors: () => SpaceColors,
    private readonly onPoint: (edge: number) => void, private readonly onClick: (edge: number, event: PointerEvent) => void,
  ) {
    this.gl = canvas.getContext('webgl2', { antialias: true, alpha: true });
    if (this.gl) this.prepare(this.gl);
    new ResizeObserver(() => (this.chosen ? this.redraw() : this.frame(this.at))).observe(canvas);
    listen(canvas, {
      point: (at) => this.onPoint(at ? this.edgeAt(at.x, at.y) : -1),
      click: (at, event) => {
        const edge = this.edgeAt(at.x, at.y);
        if (edge >= 0) this.onClick(edge, event);
      },
      drag: (dx, dy) => this.turn(dx / kPixelsPerRadian, dy / kPixelsPerRadian),
      zoom: (factor) => this.zoom(1 / factor),
    });
  }

  get works(): boolean {
    return this.gl !== null;
  }

  /** A new model, or the same after an edit; `at` are the places of its corners. */
  show(shape: Shape, at: Float32Array, reframe: boolean): void {
    this.shape = shape;
    this.at = at;
    if (reframe) this.frame(at);
    const { gl } = this;
    if (!gl) return;
    const marks = new Float32Array(at.length / 3);
    for (const f of shape.overlapping) marks.fill(1, shape.model.offsets[f]!, shape.model.offsets[f + 1]!);
    this.fill(this.buffers.mark, marks);
    this.counts.triangles = this.index(this.buffers.triangles, shape.triangles);
    const folds: number[] = [], cuts: number[] = [];
    for (let c = 0; c < shape.next.length; ++c) {
      const e = shape.model.cornerEdges[c]!;
      if (!shape.snapshot.folds[e]) cuts.push(c, shape.next[c]!);
      else if (shape.edgeCorners[2 * e] === c) folds.push(c, shape.next[c]!);
    }
    this.counts.folds = this.index(this.buffers.folds, new Uint32Array(folds));
    this.counts.cuts = this.index(this.buffers.cuts, new Uint32Array(cuts));
    this.point(this.edge < shape.model.edges ? this.edge : -1);
    this.place(at);
  }

  place(at: Float32Array): void {
    this.at = at;
    if (!this.chosen) this.distance *= Math.max(1, this.largest(at) / 0.96); // panels on their way stay in view
    if (this.gl) this.fill(this.buffers.at, at);
    this.redraw();
  }

  point(edge: number): void {
    this.edge = edge;
    const { shape } = this;
    if (!shape || !this.gl) return;
    const ends: number[] = [];
    for (const c of edge < 0 ? [] : [shape.edgeCorners[2 * edge]!, shape.edgeCorners[2 * edge + 1]!]) if (c >= 0) ends.push(c, shape.next[c]!);
    this.counts.pick = this.index(this.buffers.pick, new Uint32Array(ends));
    this.redraw();
  }

  /** Shows all of these places, and keeps showing from the same side. */
  frame(at: Float32Array): void {
    if (!at.length) return;
    const low: Vec = [Infinity, Infinity, Infinity], high: Vec = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < at.length; ++i) {
      low[i % 3] = Math.min(low[i % 3]!, at[i]!);
      high[i % 3] = Math.max(high[i % 3]!, at[i]!);
    }
    this.center = [0, 1, 2].map((k) => (low[k]! + high[k]!) / 2) as Vec;
    this.radius = Math.hypot(...minus(high, low)) / 2 || 1;
    this.distance = 1;
    this.distance = this.largest(at) / 0.9;
    this.chosen = false;
    this.redraw();
  }
  /** How much of the view the places take, of its half width or height. */
  private largest(at: Float32Array): number {
    const { eye, right, up, toward, focal, aspect } = this.camera();
    let most = 0;
    for (let i = 0; i + 2 < at.length; i += 3) {
      const x = at[i]! - eye[0], y = at[i + 1]! - eye[1], z = at[i + 2]! - eye[2];
      const depth = -(x * toward[0] + y * toward[1] + z * toward[2]);
      const across = ((x * right[0] + y * right[1] + z * right[2]) * focal) / aspect, along = (x * up[0] + y * up[1] + z * up[2]) * focal;
      most = Math.max(most, Math.abs(across / depth), Math.abs(along / depth));
    }
    return Number.isFinite(most) && most > 0 ? most : 0.9;
  }
  turn(right: number, up: number): void {
    this.azimuth -= right;
    this.elevation = Math.max(-1.55, Math.min(1.55, this.elevation + up));
    this.redraw();
  }
  zoom(factor: number): void {
    this.distance = Math.max(0.05, Math.min(8, this.distance * factor));
    this.chosen = true;
    this.redraw();
  }
  redraw(): void {
    if (this.queued) return;
    this.queued = true;
    requestAnimationFrame(() => {
      this.queued = false;
      this.draw();
    });
  }

  private prepare(gl: WebGL2RenderingContext): void {
    this.faces = program(gl, kFaceVertex, kFaceFragment);
    this.lines = program(gl, kLineVertex, kLineFragment);
    const buffer = (): WebGLBuffer => gl.createBuffer()!;
    this.buffers = { at: buffer(), mark: buffer(), triangles: buffer(), folds: buffer(), cuts: buffer(), pick: buffer() };
    gl.enable(gl.DEPTH_TEST);
  }
  private fill(buffer: WebGLBuffer, values: Float32Array): void {
    const gl = this.gl!;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.DYNAMIC_DRAW);
  }
  private index(buffer: WebGLBuffer, values: Uint32Array): number {
    const gl = this.gl!;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, values, gl.DYNAMIC_DRAW);
    return values.length;
  }

  private camera(): { eye: Vec; right: Vec; up: Vec; toward: Vec; focal: number; aspect: number } {
    const c = Math.cos(this.elevation);
    const from: Vec = [c * Math.sin(this.azimuth), -c * Math.cos(this.azimuth), Math.sin(this.elevation)];
    const aspect = this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight);
    const focal = 2.4;
    const far = (this.distance * this.radius * focal * 1.08) / Math.min(1, aspect);
    const eye = this.center.map((x, k) => x + far * from[k]!) as Vec;
    const right: Vec = [Math.cos(this.azimuth), Math.sin(this.azimuth), 0];
    return { eye, right, up: cross(from, right), toward: from, focal, aspect };
  }

  private matrix(): Float32Array {
    const { eye, right, up, toward, focal, aspect } = this.camera();
    const far = dot(minus(eye, this.center), toward) + 2 * this.radius, near = Math.max(far / 1000, far - 6 * this.radius);
    const rows = [
      [...right.map((x) => (x * focal) / aspect), (-dot(right, eye) * focal) / aspect],
      [...up.map((x) => x * focal), -dot(up, eye) * focal],
      [...toward.map((x) => (x * (far + near)) / (near - far)), (-dot(toward, eye) * (far + near)) / (near - far) + (2 * far * near) / (near - far)],
      [...toward.map((x) => -x), dot(toward, eye)],
    ];
    return new Float32Array([0, 1, 2, 3].flatMap((column) => rows.map((row) => row[column]!)));
  }

  private draw(): void {
    const { gl, canvas } = this;
    if (!gl || !this.shape) return;
    const width = Math.round(canvas.clientWidth * devicePixelRatio), height = Math.round(canvas.clientHeight * devicePixelRatio);
    if (canvas.width !== width || canvas.height !== height) canvas.width = width, canvas.height = height;
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const view = this.matrix(), colors = this.colors();
    const uniform = (of: WebGLProgram, name: string, value: number[]): void => gl.uniform3fv(gl.getUniformLocation(of, name), value);
    const attribute = (place: number, buffer: WebGLBuffer, size: number): void => {
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, gl.FLOAT, false, 0, 0);
    };
    gl.useProgram(this.faces!);
    gl.uniformMatrix4fv(gl.getUniformLocation(this.faces!, 'view'), false, view);
    uniform(this.faces!, 'eye', this.camera().eye);
    for (const name of ['front', 'back', 'alarm'] as const) uniform(this.faces!, name, colors[name]);
    attribute(0, this.buffers.at, 3);
    attribute(1, this.buffers.mark, 1);
    this.elements(gl.TRIANGLES, this.buffers.triangles, this.counts.triangles);
    gl.useProgram(this.lines!);
    gl.uniformMatrix4fv(gl.getUniformLocation(this.lines!, 'view'), false, view);
    uniform(this.lines!, 'ink', colors.fold);
    this.elements(gl.LINES, this.buffers.folds, this.counts.folds);
    uniform(this.lines!, 'ink', colors.ink);
    this.elements(gl.LINES, this.buffers.cuts, this.counts.cuts);
    if (!this.counts.pick) return;
    gl.disable(gl.DEPTH_TEST);
    uniform(this.lines!, 'ink', colors.accent);
    this.elements(gl.LINES, this.buffers.pick, this.counts.pick);
    gl.enable(gl.DEPTH_TEST);
  }
  private elements(kind: number, buffer: WebGLBuffer, count: number): void {
    const gl = this.gl!;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    gl.drawElements(kind, count, gl.UNSIGNED_INT, 0);
  }

  private corner(c: number): Vec {
    return [this.at[3 * c]!, this.at[3 * c + 1]!, this.at[3 * c + 2]!];
  }
  private onCanvas(p: Vec): [number, number] {
    const { eye, right, up, toward, focal, aspect } = this.camera();
    const d = minus(p, eye), depth = -dot(d, toward);
    return [(1 + (dot(d, right) * focal) / aspect / depth) * this.canvas.clientWidth / 2, (1 - (dot(d, up) * focal) / depth) * this.canvas.clientHeight / 2];
  }

  /** The edge nearest to the pointer, of the face that is seen there. */
  private edgeAt(x: number, y: number): number {
    const face = this.faceAt(x, y), { shape } = this;
    if (!shape || face < 0) return -1;
    let best = -1, least = Infinity;
    for (let c = shape.model.offsets[face]!; c < shape.model.offsets[face + 1]!; ++c) {
      const [ax, ay] = this.onCanvas(this.corner(c)), [bx, by] = this.onCanvas(this.corner(shape.next[c]!));
      const ux = bx - ax, uy = by - ay;
      const t = Math.max(0, Math.min(1, ((x - ax) * ux + (y - ay) * uy) / (ux * ux + uy * uy || 1)));
      const distance = Math.hypot(ax + t * ux - x, ay + t * uy - y);
      if (distance < least) least = distance, best = shape.model.cornerEdges[c]!;
    }
    return best;
  }
  private faceAt(x: number, y: number): number {
    const { shape } = this;
    if (!shape) return -1;
    const { eye, right, up, toward, focal, aspect } = this.camera();
    const u = ((2 * x) / this.canvas.clientWidth - 1) * aspect / focal, v = (1 - (2 * y) / this.canvas.clientHeight) / focal;
    const ray = [0, 1, 2].map((k) => u * right[k]! + v * up[k]! - toward[k]!) as Vec;
    let best = -1, nearest = Infinity;
    for (let t = 0; t < shape.triangleFaces.length; ++t) {
      const a = this.corner(shape.triangles[3 * t]!), b = this.corner(shape.triangles[3 * t + 1]!), c = this.corner(shape.triangles[3 * t + 2]!);
      const ab = minus(b, a), ac = minus(c, a), p = cross(ray, ac), det = dot(ab, p);
      if (Math.abs(det) < 1e-30) continue;
      const s = minus(eye, a), q = cross(s, ab), i = dot(s, p) / det, j = dot(ray, q) / det, far = dot(ac, q) / det;
      if (i >= 0 && j >= 0 && i + j <= 1 && far > 0 && far < nearest) nearest = far, best = shape.triangleFaces[t]!;
    }
    return best;
  }
}
