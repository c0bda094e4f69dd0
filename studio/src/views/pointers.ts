// Mouse, pen and fingers on a canvas: pointing, clicking, dragging with one, pinching with two, and the wheel.

export interface Place {
  x: number;
  y: number;
}

export interface Gestures {
  point(at: Place | undefined): void; // nothing is under a pointer that left
  click(at: Place, event: PointerEvent): void;
  drag(dx: number, dy: number, to: Place): void;
  press?(at: Place): void; // the first finger or the button goes down
  /** Larger than 1: nearer; around a place of the canvas. */
  zoom(factor: number, around: Place): void;
}

const kStill = 6; // pixels that a click may travel
const kWheel = 400; // pixels of the wheel that make e times as large

export function listen(canvas: HTMLCanvasElement, gestures: Gestures): void {
  const down = new Map<number, Place>();
  let travelled = 0;
  const place = (event: MouseEvent): Place => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const distance = (a: Place, b: Place): number => Math.hypot(a.x - b.x, a.y - b.y);

  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, place(event));
    travelled = down.size > 1 ? Infinity : 0;
    if (down.size === 1) gestures.press?.(place(event));
  });
  canvas.addEventListener('pointermove', (event) => {
    const to = place(event), from = down.get(event.pointerId);
    if (!from) return gestures.point(to);
    const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
    if (other) gestures.zoom(distance(to, other) / Math.max(1, distance(from, other)), other);
    else gestures.drag(to.x - from.x, to.y - from.y, to);
    travelled += distance(from, to);
    down.set(event.pointerId, to);
  });
  canvas.addEventListener('pointerup', (event) => {
    if (down.delete(event.pointerId) && travelled <= kStill) gestures.click(place(event), event);
  });
  canvas.addEventListener('pointercancel', (event) => down.delete(event.pointerId));
  canvas.addEventListener('pointerleave', () => down.size === 0 && gestures.point(undefined));
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    gestures.zoom(Math.exp(-event.deltaY / kWheel), place(event));
  }, { passive: false });
}
