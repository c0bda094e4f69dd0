// In which part of the motion which creases move: a lane for those that move together, with a line at the moment shown.
import type { Lane } from '../motion_file';

const percent = (time: number): string => `${Math.round(100 * time)}`;

export function spokenLane({ edges, spans }: Lane): string {
  const who = edges.length === 1 ? `crease ${edges[0]}` : `${edges.length} creases`;
  const many = edges.length > 1;
  if (!spans.length) return `${who} ${many ? 'stay' : 'stays'} as ${many ? 'they are' : 'it is'}`;
  return `${who} ${many ? 'move' : 'moves'} from ${spans.map(([from, to]) => `${percent(from)} to ${percent(to)} %`).join(', and ')}`;
}

/** A list box: up and down go from lane to lane, left and right from crease to crease of one. */
export class Lanes {
  private lanes: Lane[] = [];
  private chosen = -1;

  constructor(private readonly list: HTMLElement, private readonly choose: (lane: Lane, edge: number) => void, private readonly enter: () => void) {
    list.addEventListener('keydown', (event) => {
      if (this.key(event)) event.preventDefault(), event.stopPropagation();
    });
  }

  show(lanes: Lane[]): void {
    this.lanes = lanes;
    this.chosen = -1;
    this.list.replaceChildren(...lanes.map((lane, i) => {
      const row = document.createElement('div'), name = document.createElement('span'), bar = document.createElement('span');
      row.setAttribute('role', 'option');
      row.setAttribute('aria-selected', 'false');
      row.setAttribute('aria-label', `lane ${i + 1} of ${lanes.length}: ${spokenLane(lane)}`);
      row.tabIndex = i ? -1 : 0;
      row.className = 'lane';
      name.textContent = lane.edges.length === 1 ? `crease ${lane.edges[0]}` : `${lane.edges.length} creases`;
      bar.className = 'lane-bar';
      for (const [from, to] of lane.spans) {
        const span = document.createElement('i');
        span.style.left = `${100 * from}%`;
        span.style.width = `${100 * (to - from)}%`;
        span.textContent = `${percent(from)}–${percent(to)} %`;
        bar.append(span);
      }
      if (!lane.spans.length) bar.textContent = 'still';
      row.append(name, bar);
      row.addEventListener('click', () => this.take(i));
      return row;
    }));
  }
  /** The moment that is shown. */
  at(time: number): void {
    this.list.style.setProperty('--now', String(time));
  }
  /** Marks the lane of this crease. */
  mark(edge: number): Lane | undefined {
    this.chosen = this.lanes.findIndex(({ edges }) => edges.includes(edge));
    [...this.list.children].forEach((row, i) => {
      row.setAttribute('aria-selected', String(i === this.chosen));
      (row as HTMLElement).tabIndex = i === Math.max(0, this.chosen) ? 0 : -1;
    });
    return this.lanes[this.chosen];
  }

  private take(index: number, edge?: number): void {
    const lane = this.lanes[index];
    if (!lane) return;
    (this.list.children[index] as HTMLElement).focus();
    this.edge = edge ?? lane.edges[0]!;
    this.choose(lane, this.edge);
  }
  private edge = -1;
  private key({ key }: KeyboardEvent): boolean {
    const lane = this.lanes[this.chosen], walk = (by: number) => (): void => {
      if (!lane) return this.take(0);
      const here = lane.edges.indexOf(this.edge);
      this.take(this.chosen, lane.edges[(here + by + lane.edges.length) % lane.edges.length]);
    };
    const actions: Record<string, () => void> = {
      ArrowDown: () => this.take(Math.min(this.lanes.length - 1, this.chosen + 1)), ArrowUp: () => this.take(Math.max(0, this.chosen - 1)),
      Home: () => this.take(0), End: () => this.take(this.lanes.length - 1), ArrowRight: walk(1), ArrowLeft: walk(-1), Enter: () => this.enter(), ' ': () => this.take(Math.max(0, this.chosen)),
    };
    actions[key]?.();
    return key in actions;
  }
}
