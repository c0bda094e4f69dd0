// Where parts lie on their pages: what the core tells of it, what someone moved by hand, and the shapes to take hold of.
import type { Place } from '../store';
import type { Shape } from '../views/shape';

export interface PartPlace extends Place {
  part: string;
  panels: number[];
}

export const keyOf = ({ panels }: PartPlace): string => panels.join(' ');
export const putOf = ({ panel, page, x, y, angle_deg }: Place): string => [panel, page, x, y, angle_deg].join(',');
const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** The panels of a part as they lie: x, y of each corner in millimetres, y upwards. */
export function polygonsOf(shape: Shape, place: PartPlace, scale: number): [number, number][][] {
  const { flat } = shape.snapshot, { offsets } = shape.model;
  const c = offsets[place.panel]!, [x, y] = [flat[2 * c]!, flat[2 * c + 1]!];
  const turn = radians(place.angle_deg) - Math.atan2(flat[2 * c + 3]! - y, flat[2 * c + 2]! - x);
  const cos = scale * Math.cos(turn), sin = scale * Math.sin(turn);
  return place.panels.map((f) => {
    const polygon: [number, number][] = [];
    for (let i = offsets[f]!; i < offsets[f + 1]!; ++i) {
      const u = flat[2 * i]! - x, v = flat[2 * i + 1]! - y;
      polygon.push([place.x + cos * u - sin * v, place.y + sin * u + cos * v]);
    }
    return polygon;
  });
}

export function boxOf(polygons: [number, number][][]): { low: [number, number]; high: [number, number] } {
  const low: [number, number] = [Infinity, Infinity], high: [number, number] = [-Infinity, -Infinity];
  for (const p of polygons.flat()) for (const axis of [0, 1] as const) low[axis] = Math.min(low[axis], p[axis]), high[axis] = Math.max(high[axis], p[axis]);
  return { low, high };
}
export function middleOf(polygons: [number, number][][]): [number, number] {
  const { low, high } = boxOf(polygons);
  return [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
}

export function turned<P extends Place>(place: P, degrees: number, [x, y]: [number, number]): P {
  const cos = Math.cos(radians(degrees)), sin = Math.sin(radians(degrees)), u = place.x - x, v = place.y - y;
  return { ...place, x: x + cos * u - sin * v, y: y + sin * u + cos * v, angle_deg: place.angle_deg + degrees };
}

/** By how many degrees to turn so that the longest side lies along the paper. */
export function straightening(polygons: [number, number][][]): number {
  let longest = 0, angle = 0;
  for (const polygon of polygons)
    polygon.forEach(([x, y], i) => {
      const [u, v] = polygon[(i + 1) % polygon.length]!, length = Math.hypot(u - x, v - y);
      if (length > longest * (1 + 1e-9)) longest = length, angle = (Math.atan2(v - y, u - x) * 180) / Math.PI;
    });
  return Math.round(angle / 90) * 90 - angle;
}
