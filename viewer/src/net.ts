// The flat sheet beside the folding one: outlines as shapes one can point at, creases as three paths.
import { kindOf, type Kind, type Model } from './model';

const kSvg = 'http://www.w3.org/2000/svg';
const round = (x: number): number => Number(x.toPrecision(7));

export class NetView {
  private readonly shapes: SVGPolygonElement[] = [];
  private readonly ids: SVGGElement[] = [];

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
      const colour = model.data.colors?.[p];
      if (colour) shape.style.cssText = `--front: ${colour}; --tint: 0.9`;
      this.shapes.push(shape);
    });
    for (const kind of ['flat', 'valley', 'mountain'] as const) svg.appendChild(this.creases(kind));
    model.data.sideIds.forEach((_, p) => this.ids.push(svg.appendChild(this.idsOf(p))));
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
    this.ids.forEach((group, p) => {
      const wanted = p === hovered || p === selected || mates.has(p) ? 'ids shown' : 'ids';
      if (group.getAttribute('class') !== wanted) group.setAttribute('class', wanted);
    });
  }

  // The ids at the sides of a panel, as on paper; shown while it is pointed at.
  private idsOf(panel: number): SVGGElement {
    const group = document.createElementNS(kSvg, 'g');
    group.setAttribute('class', 'ids');
    const outline = this.model.data.panels[panel]!;
    const at = (i: number): [number, number] => [outline[(2 * i) % outline.length]!, outline[(2 * i + 1) % outline.length]!];
    this.model.data.sideIds[panel]!.forEach((id, side) => {
      if (!id) return;
      const [x, y] = at(side);
      const [u, v] = at(side + 1);
      const text = group.appendChild(document.createElementNS(kSvg, 'text'));
      text.setAttribute('x', String(round((x + u) / 2)));
      text.setAttribute('y', String(round(-(y + v) / 2)));
      text.setAttribute('font-size', String(round(0.3 * this.model.typicalSide())));
      text.textContent = id;
    });
    return group;
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
