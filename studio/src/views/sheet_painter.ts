// A net of many thousand faces drawn with WebGL 2 on a canvas of its own: on a plain canvas it takes a tenth of a second.
import { program } from '../../../viewer/src/gl_mesh';
import { linesOf, type Sides } from './net_lines';

const kVertex = `#version 300 es
in vec2 at; in float tint; uniform vec4 view; flat out float shown;
void main() { shown = tint; gl_Position = vec4((at - view.xy) * view.zw, 0.0, 1.0); }`;
const kFragment = `#version 300 es
precision mediump float; flat in float shown; uniform vec3 colors[8]; out vec4 color;
void main() { color = vec4(colors[int(shown + 0.5)], 1.0); }`;

export type Rgb01 = readonly number[];

/** What is seen: a window of the table, in the model's unit, y upwards. */
export interface Window {
  left: number; top: number; scale: number; width: number; height: number; // the last two in pixels
}

/** What stays through all edits. */
export interface SheetModel extends Sides {
  triangles: Uint32Array;
  faceOf: Int32Array;
}

export class SheetPainter {
  private readonly buffers: Record<'at' | 'tint' | 'triangles' | 'folds' | 'cuts', WebGLBuffer>;
  private readonly drawing: WebGLProgram;
  private readonly counts = { triangles: 0, folds: 0, cuts: 0 };
  private model?: SheetModel;

  /** Nothing where there is no WebGL 2. */
  static on(canvas: HTMLCanvasElement | OffscreenCanvas): SheetPainter | undefined {
    const gl = canvas.getContext('webgl2', { antialias: true, depth: false }) as WebGL2RenderingContext | null;
    return gl ? new SheetPainter(gl) : undefined;
  }
  private constructor(private readonly gl: WebGL2RenderingContext) {
    this.drawing = program(gl, kVertex, kFragment, ['at', 'tint']);
    const names = ['at', 'tint', 'triangles', 'folds', 'cuts'] as const;
    this.buffers = Object.fromEntries(names.map((name) => [name, gl.createBuffer()!])) as typeof this.buffers;
  }

  setModel(model: SheetModel): void {
    this.model = model;
    this.setElements('triangles', model.triangles);
  }
  /** After a new model or an edit. `tints` is how many colours parts take turns with. */
  setNet(flat: Float32Array, isFold: Uint8Array, parts: Int32Array, tints: number): void {
    const { gl, buffers, model } = this;
    if (!model) return;
    const fill = (buffer: WebGLBuffer, values: Float32Array): void => {
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, values, gl.DYNAMIC_DRAW);
    };
    fill(buffers.at, flat);
    fill(buffers.tint, Float32Array.from(model.faceOf, (face) => parts[face]! % tints));
    const { folds, cuts } = linesOf(model, isFold);
    this.setElements('folds', folds);
    this.setElements('cuts', cuts);
  }
  private setElements(name: 'triangles' | 'folds' | 'cuts', values: Uint32Array): void {
    const { gl } = this;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.buffers[name]);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, values, gl.DYNAMIC_DRAW);
    this.counts[name] = values.length;
  }

  draw(window: Window, tints: Rgb01[], fold: Rgb01, cut: Rgb01): void {
    const { gl, gl: { canvas }, drawing, buffers } = this, { width, height, scale, left, top } = window;
    if (canvas.width !== width || canvas.height !== height) canvas.width = width, canvas.height = height;
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.useProgram(drawing);
    gl.uniform4f(gl.getUniformLocation(drawing, 'view'), left + width / scale / 2, top - height / scale / 2, (2 * scale) / width, (2 * scale) / height);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffers.at);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffers.tint);
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 1, gl.FLOAT, false, 0, 0);
    this.elements(gl.TRIANGLES, 'triangles', tints);
    this.elements(gl.LINES, 'folds', tints.map(() => fold));
    this.elements(gl.LINES, 'cuts', tints.map(() => cut));
  }
  private elements(kind: number, name: 'triangles' | 'folds' | 'cuts', colors: Rgb01[]): void {
    const { gl } = this;
    gl.uniform3fv(gl.getUniformLocation(this.drawing, 'colors'), colors.flat());
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.buffers[name]);
    gl.drawElements(kind, this.counts[name], gl.UNSIGNED_INT, 0);
  }
}
