// The flat sheet beside the folding one: outlines as shapes one can point at, creases as three paths.
import { kindOf, type Kind, type Model } from './model';

const kSvg = 'http://www.w3.org/2000/svg';
const round = (x: number): number => Number(x.toPrecision(7));

export class NetView {
  private readonly shapes: SVGPolygonElement[] = [];

  constructor(
    private readonly model: Model,
    svg: SVGSVGElement,
    onHover: (panel: number) => void,
    onSelect: (panel: number) => void,
  ) {
    this.frame(svg);
    const panels = svg.appendChild(document.createElementNS(kSvg, 'g'));
    panels.setAttribute('class', 'panels');
    model.data.panels.forEach((outline, p) => {
      const shape = panels.appendChild(document.createElementNS(kSvg, 'polygon'));
      const points: string[] = [];
      for (let i = 0; i < outline.length; i += 2) points.push(`${round(outline[i]!)},${round(-outline[i + 1]!)}`);
      shape.setAttribute('points', points.join(' '));
      shape.dataset['panel'] = String(p);
      this.shapes.push(shape);
    });
    for (const kind of ['flat', 'valley', 'mountain'] as const) svg.appendChild(this.creases(kind));
    const panelOf = (event: Event): number => Number((event.target as SVGElement).dataset?.['panel'] ?? -1);
    svg.addEventListener('pointermove', (event) => onHover(panelOf(event)));
    svg.addEventListener('pointerleave', () => onHover(-1));
    svg.addEventListener('click', (event) => onSelect(panelOf(event)));
  }

  mark(hovered: number, selected: number, colliding: Set<number>): void {
    const mates = new Set(selected >= 0 ? this.model.gluedTo(selected) : []);
    this.shapes.forEach((shape, p) => {
      const marks = [p === hovered && 'hovered', p === selected && 'selected', mates.has(p) && 'mate',
        colliding.has(p) && 'colliding'];
      const wanted = marks.filter(Boolean).join(' ');
      if ((shape.getAttribute('class') ?? '') !== wanted) shape.setAttribute('class', wanted);
    });
  }

  private creases(kind: Kind): SVGPathElement {
    const path = document.createElementNS(kSvg, 'path');
    path.setAttribute('class', `crease ${kind}`);
    path.setAttribute('d', this.model.data.hinges
      .filter((hinge) => kindOf(hinge.target) === kind)
      .map(({ from, to }) => `M${round(from[0])} ${round(-from[1])}L${round(to[0])} ${round(-to[1])}`)
      .join(''));
    return path;
  }

  private frame(svg: SVGSVGElement): void {
    let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
    for (const outline of this.model.data.panels) {
      for (let i = 0; i < outline.length; i += 2) {
        left = Math.min(left, outline[i]!);
        right = Math.max(right, outline[i]!);
        top = Math.min(top, -outline[i + 1]!);
        bottom = Math.max(bottom, -outline[i + 1]!);
      }
    }
    // As in space: on a fine net the lines become thinner.
    const fineness = this.model.typicalSide() / Math.max(right - left, bottom - top);
    svg.style.setProperty('--weight', String(Math.min(1, Math.max(0.35, 24 * fineness))));
    const margin = 0.03 * Math.max(right - left, bottom - top);
    svg.setAttribute('viewBox', [left - margin, top - margin, right - left + 2 * margin, bottom - top + 2 * margin].join(' '));
  }
}
