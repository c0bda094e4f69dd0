// One page as it will be printed, with its parts to take hold of: dragged, turned by the wheel, moved by keys.
import type { PartPlace } from './page_parts';

export interface PageGestures {
  /** Onto which page, from 1, and by how many millimetres, y upwards. */
  drop(part: PartPlace, page: number, dx: number, dy: number): void;
  turn(part: PartPlace, degrees: number): void;
  key(part: PartPlace, event: KeyboardEvent): boolean;
}

const kStill = 1; // millimetres that a press may travel
const kWheelTurn = 15, kWheelSmallTurn = 1; // degrees
const kWheelRest = 250; // milliseconds after the last notch

function made(tag: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}

export class PageView {
  readonly element = document.createElement('figure');
  private readonly overlay: SVGSVGElement;
  private readonly url: string;
  readonly size: readonly [number, number]; // across and up, in millimetres

  constructor(private readonly page: number, pages: number, svg: Uint8Array, private readonly gestures: PageGestures) {
    this.url = URL.createObjectURL(new Blob([svg as Uint8Array<ArrayBuffer>], { type: 'image/svg+xml' }));
    const box = /viewBox="([\d.]+) ([\d.]+) ([\d.]+) ([\d.]+)"/.exec(new TextDecoder().decode(svg.subarray(0, 1000)));
    const [width, height] = [Number(box?.[3] ?? 210), Number(box?.[4] ?? 297)];
    this.size = [width, height];
    const image = document.createElement('img'), caption = document.createElement('figcaption');
    image.src = this.url;
    image.alt = `Page ${page} of ${pages}`;
    image.draggable = false;
    caption.textContent = `Page ${page} of ${pages}`;
    this.overlay = made('svg', { viewBox: `0 0 ${width} ${height}`, role: 'group', 'aria-label': `Parts of page ${page}` }) as SVGSVGElement;
    const paper = document.createElement('div');
    paper.className = 'paper';
    paper.append(image, this.overlay);
    this.element.className = 'page';
    this.element.dataset['page'] = String(page);
    this.element.append(paper, caption);
  }
  dispose(): void {
    URL.revokeObjectURL(this.url);
  }

  add(part: PartPlace, polygons: [number, number][][], byHand: boolean): SVGElement {
    const shown = made('g', {
      class: byHand ? 'part by-hand' : 'part', tabindex: 0, role: 'button',
      'aria-label': `Part ${part.part}, page ${part.page}${byHand ? ', placed by hand' : ''}. Arrows move it, R turns it, S straightens it, C puts it in the middle, Home, End, T and B at a margin, Page Down sends it on, U lets it go.`,
    });
    const path = polygons.map((polygon) => `M${polygon.map(([x, y]) => `${x.toFixed(2)} ${(this.size[1] - y).toFixed(2)}`).join('L')}Z`).join('');
    shown.append(made('path', { d: path }));
    this.overlay.append(shown);
    shown.addEventListener('pointerdown', (event) => this.take(shown, part, event as PointerEvent));
    shown.addEventListener('wheel', (event) => this.wheel(shown, part, event as WheelEvent), { passive: false });
    shown.addEventListener('keydown', (event) => {
      const e = event as KeyboardEvent;
      if (!e.ctrlKey && !e.metaKey && !e.altKey && this.gestures.key(part, e)) e.preventDefault(), e.stopPropagation();
    });
    return shown;
  }

  /** Millimetres of the page under the pointer. */
  private at(event: PointerEvent, overlay: SVGSVGElement = this.overlay): { x: number; y: number } {
    const box = overlay.getBoundingClientRect(), scale = overlay.viewBox.baseVal.width / box.width;
    return { x: (event.clientX - box.left) * scale, y: overlay.viewBox.baseVal.height - (event.clientY - box.top) * scale };
  }
  private take(shown: SVGElement, part: PartPlace, event: PointerEvent): void {
    if (event.button !== 0) return;
    event.preventDefault();
    shown.focus({ preventScroll: true });
    shown.setPointerCapture(event.pointerId);
    this.overlay.append(shown); // above the others
    const from = this.at(event);
    const move = (e: PointerEvent): void => {
      const to = this.at(e);
      shown.setAttribute('transform', `translate(${to.x - from.x} ${from.y - to.y})`);
      shown.classList.add('held');
    };
    const end = (e: PointerEvent): void => {
      shown.removeEventListener('pointermove', move as EventListener);
      for (const type of ['pointerup', 'pointercancel']) shown.removeEventListener(type, end as EventListener);
      shown.classList.remove('held');
      const under = e.type === 'pointerup' ? document.elementsFromPoint(e.clientX, e.clientY).map((one) => one.closest<HTMLElement>('.page')).find(Boolean) : undefined;
      const overlay = under?.querySelector<SVGSVGElement>('.paper > svg');
      const to = this.at(e, overlay ?? this.overlay);
      const page = overlay ? Number(under!.dataset['page']) : this.page;
      if (e.type === 'pointerup' && (page !== this.page || Math.hypot(to.x - from.x, to.y - from.y) > kStill)) this.gestures.drop(part, page, to.x - from.x, to.y - from.y);
      else shown.removeAttribute('transform');
    };
    shown.addEventListener('pointermove', move as EventListener);
    for (const type of ['pointerup', 'pointercancel']) shown.addEventListener(type, end as EventListener);
  }

  /** Only a part that was chosen turns: the wheel scrolls the pages otherwise. */
  private wheel(shown: SVGElement, part: PartPlace, event: WheelEvent): void {
    if (document.activeElement !== shown) return;
    event.preventDefault();
    const turn = Number(shown.dataset['turn'] ?? 0) + Math.sign(event.deltaY || event.deltaX) * -(event.shiftKey ? kWheelSmallTurn : kWheelTurn);
    shown.dataset['turn'] = String(turn);
    const box = (shown.firstElementChild as SVGGraphicsElement).getBBox();
    shown.setAttribute('transform', `rotate(${-turn} ${box.x + box.width / 2} ${box.y + box.height / 2})`);
    clearTimeout(Number(shown.dataset['timer'] ?? 0));
    shown.dataset['timer'] = String(window.setTimeout(() => this.gestures.turn(part, turn), kWheelRest));
  }
}
