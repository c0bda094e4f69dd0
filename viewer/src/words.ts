// What the page says: badge, panel details, report table.
import { angleAt, degrees, kindOf, type Model, type PageData } from './model';

export const percent = (time: number): string => `${Number((100 * time).toFixed(1))} %`;

export function badge(data: PageData): { mark: string; text: string; title: string } {
  const motion = { linear: 'linear motion', uniform: 'uniform motion', planned: 'planned motion' }[data.motion];
  const tail = motion ? ` · ${motion}` : '';
  const title = data.proof.note;
  switch (data.proof.status) {
    case 'proven': return { mark: '✓', text: `Proven free of collision${tail}`, title };
    case 'collides': return { mark: '✗', text: `Panels collide${tail}`, title };
    case 'undecided': return { mark: '?', text: `Proof undecided${tail}`, title };
    case 'unchecked': return { mark: '–', text: `Collision not checked${tail}`, title };
  }
}

export function panelDetails(model: Model, panel: number, time: number): string {
  const folds = model.hingesOf[panel]!.map((h) => {
    const hinge = model.data.hinges[h]!;
    const other = hinge.left === panel ? hinge.right : hinge.left;
    const now = degrees(angleAt(model.data.keys[h]!, time));
    return `${kindOf(hinge.target)} to panel ${other}: ${now.toFixed(1)}° of ${degrees(hinge.target).toFixed(1)}°`;
  });
  const glued = model.seamsOf(panel).map(({ id, other }) => (id ? `${id} to panel ${other}` : `to ${other}`));
  const part = model.data.partOf[panel];
  const name = part ? `Panel ${panel} of part ${part}` : `Panel ${panel}`;
  return [name, ...folds, ...(glued.length ? [`glued ${glued.join(', ')}`] : [])].join(' · ');
}

// Nested objects become dotted names; short lists stay on one line.
export function rows(value: unknown, name = ''): [string, string][] {
  if (Array.isArray(value)) {
    const simple = value.every((x) => x === null || typeof x !== 'object');
    const text = simple ? value.join(', ') : JSON.stringify(value);
    return [[name, text.length > 160 ? `${value.length} entries` : text]];
  }
  if (value !== null && typeof value === 'object') {
    return Object.entries(value).flatMap(([key, inner]) => rows(inner, name ? `${name}.${key}` : key));
  }
  return [[name, typeof value === 'boolean' ? (value ? 'yes' : 'no') : String(value)]];
}
export const plainName = (name: string): string => name.replace(/_/g, ' ').replace(/\./g, ' › ');
