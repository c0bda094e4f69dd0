// The flat sheet beside the folding one, as printed where there are pages: outlines as shapes one can point at, creases
// as three paths.
import { kindOf, type Kind, type Model } from './model';

const kSvg = 'http://www.w3.org/2000/svg';
const kKinds = ['flat', 'valley', 'mountain'] as const;
const round = (x: number): number => Number(x.toPrecision(7));

const pathOf = (outline: number[]): string => {
  const points: string[] = [];
  for (let i = 0; i < outline.length; i += 2) points.push(`${round(outline[i]!)} ${round(-outline[i + 1]!)}`);
  return `M${points.join('L')}`;
};

export class NetView {
  private readonly outlines: number[][]; // of panels, where they lie flat
  private readonly side: number; // a typical one
  private readonly shapes: SVGPolygonElement[] = [];
  private readonly ids: SVGGElement[] = [];

  constructor(
    private readonly model: Model,
    svg: SVGSVGElement,
    onHover: (panel: number) => void,
    onSelect: (panel: number) => void,
  ) {
    const paper = model.data.paper;
    this.outlines = paper?.panels ?? model.data.panels;
    this.side = model.typicalSide(this.outlines);
    const [pages, tabs] = [paper && paper.pages.length > 1 ? paper.pages : [], paper?.tabs ?? []];
    this.frame(svg, [...pages, ...this.outlines, ...tabs]);
    for (const [name, shapes] of [['pages', pages], ['tabs', tabs]] as const)
      this.path(svg, name, shapes.map((shape) => `${pathOf(shape)}Z`));
    const panels = svg.appendChild(document.createElementNS(kSvg, 'g'));
    panels.setAttribute('class', 'panels');
    this.outlines.forEach((outline, p) => {
      const shape = panels.appendChild(document.createElementNS(kSvg, 'polygon'));
      const points: string[] = [];
      for (let i = 0; i < outline.length; i += 2) points.push(`${round(outline[i]!)},${round(-outline[i + 1]!)}`);
      shape.setAttribute('points', points.join(' '));
      shape.dataset['panel'] = String(p);
      const colour = model.data.colors?.[p];
      if (colour) shape.style.cssText = `--front: ${colour}; --tint: 0.9`;
      this.shapes.push(shape);
    });
    for (const kind of kKinds) this.path(svg, `crease ${kind}`, this.creases(kind));
    for (const { text, at } of paper?.names ?? []) svg.appendChild(this.text(text, at[0]!, at[1]!, 12)).setAttribute('class', 'name');
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
    const outline = this.outlines[panel]!;
    const at = (i: number): [number, number] => [outline[(2 * i) % outline.length]!, outline[(2 * i + 1) % outline.length]!];
    this.model.data.sideIds[panel]!.forEach((id, side) => {
      if (!id) return;
      const [x, y] = at(side);
      const [u, v] = at(side + 1);
      group.appendChild(this.text(id, (x + u) / 2, (y + v) / 2, 0.3 * this.side));
    });
    return group;
  }

  private text(words: string, x: number, y: number, size: number): SVGTextElement {
    const text = document.createElementNS(kSvg, 'text');
    text.setAttribute('x', String(round(x)));
    text.setAttribute('y', String(round(-y)));
    text.setAttribute('font-size', String(round(size)));
    text.textContent = words;
    return text;
  }

  private path(svg: SVGSVGElement, name: string, pieces: string[]): void {
    const path = svg.appendChild(document.createElementNS(kSvg, 'path'));
    path.setAttribute('class', name);
    path.setAttribute('d', pieces.join(''));
  }

  private creases(kind: Kind): string[] {
    const { paper, hinges } = this.model.data;
    if (paper) return paper.folds[kind].map(pathOf);
    return hinges.filter((hinge) => kindOf(hinge.target) === kind)
      .map(({ from, to }) => pathOf([from[0], from[1], to[0], to[1]]));
  }

  private frame(svg: SVGSVGElement, shapes: number[][]): void {
    let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
    for (const outline of shapes) {
      for (let i = 0; i < outline.length; i += 2) {
        left = Math.min(left, outline[i]!);
        right = Math.max(right, outline[i]!);
        top = Math.min(top, -outline[i + 1]!);
        bottom = Math.max(bottom, -outline[i + 1]!);
      }
    }
    // As in space: on a fine net the lines become thinner.
    const fineness = this.side / Math.max(right - left, bottom - top);
    svg.style.setProperty('--weight', String(Math.min(1, Math.max(0.35, 24 * fineness))));
    const margin = 0.03 * Math.max(right - left, bottom - top);
    svg.setAttribute('viewBox', [left - margin, top - margin, right - left + 2 * margin, bottom - top + 2 * margin].join(' '));
  }
}
