// Panels and lines drawn with WebGL 2: what the viewer page and the studio's fold view share. Corners are numbered through
// all panels; who uses it says where they are, which triangles and lines they make, and which are marked.

export type Rgb01 = readonly number[]; // red, green, blue in [0, 1]

/** Looks along -backward; `view` takes a place to clip space, column by column. */
export interface Camera {
  view: Float32Array;
  eye: readonly number[];
  right: readonly number[];
  up: readonly number[];
  backward: readonly number[];
}

/** What is said of a corner, and so of its panel. */
export const kPlain = 0, kAlarmed = 1, kPointedAt = 2, kSelected = 3;

export interface Paint {
  front: Rgb01; back: Rgb01; alarm: Rgb01; accent: Rgb01;
}
/** Drawn in this order; those `above` are never hidden. */
export interface Lines {
  name: string;
  color: Rgb01;
  above?: boolean;
}

// A key light from the upper left behind the eye, wrapped around so that no side is black, and soft light from above.
const kFaceVertex = `#version 300 es
in vec3 at; in float mark; uniform mat4 view; out vec3 place; flat out float marked;
void main() { place = at; marked = mark; gl_Position = view * vec4(at, 1.0); }`;
const kFaceFragment = `#version 300 es
precision highp float;
in vec3 place; flat in float marked; uniform vec3 eye, key, front, back, alarm, accent; out vec4 color;
void main() {
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  normal *= sign(dot(normal, eye - place));
  float towards = 0.5 + 0.5 * dot(normal, key);
  float light = min(1.0, 0.58 + 0.38 * towards * towards + 0.08 * (0.5 + 0.5 * normal.z));
  vec3 base = gl_FrontFacing ? front : back;
  float stripe = step(0.5, fract((gl_FragCoord.x + gl_FragCoord.y) / 9.0));
  if (marked == 1.0) base = mix(base, alarm, 0.35 + 0.5 * stripe);
  if (marked > 1.5) base = mix(base, accent, marked > 2.5 ? 0.8 : 0.45);
  color = vec4(base * light, 1.0);
}`;
const kLineVertex = `#version 300 es
in vec3 at; uniform mat4 view; void main() { gl_Position = view * vec4(at, 1.0); gl_Position.z -= 0.0004 * gl_Position.w; }`;
const kLineFragment = `#version 300 es
precision mediump float; uniform vec3 ink; out vec4 color; void main() { color = vec4(ink, 1.0); }`;

/** Two shaders, whose attributes get places 0, 1, ... */
export function program(gl: WebGL2RenderingContext, vertex: string, fragment: string, attributes: string[]): WebGLProgram {
  const made = gl.createProgram()!;
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]] as const) {
    const shader = gl.createShader(kind)!;
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  attributes.forEach((name, place) => gl.bindAttribLocation(made, place, name));
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made) ?? 'no program');
  return made;
}

interface Indices {
  buffer: WebGLBuffer;
  count: number;
}

export class GlMesh {
  private readonly faces: WebGLProgram;
  private readonly edges: WebGLProgram;
  private readonly at: WebGLBuffer;
  private readonly mark: WebGLBuffer;
  private readonly indices = new Map<string, Indices>();
  private readonly places = new Map<string, WebGLUniformLocation | null>();

  /** Nothing where there is no WebGL 2. */
  static on(canvas: HTMLCanvasElement | OffscreenCanvas): GlMesh | undefined {
    const gl = canvas.getContext('webgl2', { antialias: true, alpha: true }) as WebGL2RenderingContext | null;
    return gl ? new GlMesh(gl) : undefined;
  }
  private constructor(private readonly gl: WebGL2RenderingContext) {
    this.faces = program(gl, kFaceVertex, kFaceFragment, ['at', 'mark']);
    this.edges = program(gl, kLineVertex, kLineFragment, ['at']);
    this.at = gl.createBuffer()!;
    this.mark = gl.createBuffer()!;
    gl.enable(gl.DEPTH_TEST);
  }

  setPlaces(at: Float32Array): void {
    this.fill(this.at, at);
  }
  setMarks(marks: Float32Array): void {
    this.fill(this.mark, marks);
  }
  setTriangles(corners: Uint32Array): void {
    this.setIndices('', corners);
  }
  setLines(name: string, ends: Uint32Array): void {
    this.setIndices(name, ends);
  }

  draw(width: number, height: number, camera: Camera, paint: Paint, lines: Lines[]): void {
    const { gl, faces, edges } = this, { canvas } = gl;
    if (canvas.width !== width || canvas.height !== height) canvas.width = width, canvas.height = height;
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const { right, up, backward } = camera;
    const key = backward.map((x, i) => x + 0.55 * up[i]! - 0.6 * right[i]!), long = Math.hypot(...key);
    gl.useProgram(faces);
    gl.uniformMatrix4fv(this.place(faces, 'view'), false, camera.view);
    for (const [name, value] of Object.entries({ ...paint, eye: camera.eye, key: key.map((x) => x / long) }))
      gl.uniform3fv(this.place(faces, name), value);
    this.attribute(0, this.at, 3);
    this.attribute(1, this.mark, 1);
    this.elements(gl.TRIANGLES, '');
    gl.useProgram(edges);
    gl.uniformMatrix4fv(this.place(edges, 'view'), false, camera.view);
    for (const { name, color, above } of lines) {
      if (above) gl.disable(gl.DEPTH_TEST);
      gl.uniform3fv(this.place(edges, 'ink'), color);
      this.elements(gl.LINES, name);
      if (above) gl.enable(gl.DEPTH_TEST);
    }
  }

  private place(of: WebGLProgram, name: string): WebGLUniformLocation | null {
    const key = `${of === this.faces ? 'face' : 'line'} ${name}`;
    if (!this.places.has(key)) this.places.set(key, this.gl.getUniformLocation(of, name));
    return this.places.get(key)!;
  }
  private attribute(place: number, buffer: WebGLBuffer, size: number): void {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, size, gl.FLOAT, false, 0, 0);
  }
  private fill(buffer: WebGLBuffer, values: Float32Array): void {
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, buffer);
    this.gl.bufferData(this.gl.ARRAY_BUFFER, values, this.gl.DYNAMIC_DRAW);
  }
  private setIndices(name: string, values: Uint32Array): void {
    const { gl } = this, buffer = this.indices.get(name)?.buffer ?? gl.createBuffer()!;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, values, gl.DYNAMIC_DRAW);
    this.indices.set(name, { buffer, count: values.length });
  }
  private elements(kind: number, name: string): void {
    const found = this.indices.get(name);
    if (!found?.count) return;
    this.gl.bindBuffer(this.gl.ELEMENT_ARRAY_BUFFER, found.buffer);
    this.gl.drawElements(kind, found.count, this.gl.UNSIGNED_INT, 0);
  }
}
