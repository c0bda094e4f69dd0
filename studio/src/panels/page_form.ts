// How pages are to be: fields named as options of the print job; what is left empty is as the job has it.
import type { JobValues } from '../core/protocol';
import type { Filled } from '../store';

const kChoices: Record<string, string[]> = {
  page: ['A4', 'A3', 'A2', 'A5', 'Letter', 'Legal', 'Tabloid'], tabs: ['auto', 'alternate', 'left', 'right', 'both', 'none'],
  style: ['paper', 'origami', 'laser', 'bw'], side: ['outside', 'inside', 'both'],
};
const kMeasures: Record<string, string> = { longest: 'mm', height: 'mm', width: 'mm', scale: '' };

type Field = HTMLInputElement | HTMLSelectElement;

export class PageForm {
  private readonly fields: Field[];

  constructor(private readonly form: HTMLFormElement) {
    this.fields = [...form.elements].filter((e): e is Field => (e instanceof HTMLInputElement || e instanceof HTMLSelectElement) && e.name !== '');
    for (const [name, choices] of Object.entries(kChoices))
      for (const choice of choices) (form.elements.namedItem(name) as HTMLSelectElement).append(new Option(choice, choice));
    form.addEventListener('change', () => this.nameUnit());
  }
  private named(name: string): Field {
    return this.form.elements.namedItem(name) as Field;
  }
  private nameUnit(): void {
    this.form.querySelector('.size-unit')!.textContent = kMeasures[this.named('measure').value] || 'mm a unit';
  }

  get splits(): boolean {
    return (this.named('split') as HTMLInputElement).checked;
  }
  get margin(): number {
    const { value, placeholder } = this.named('margin') as HTMLInputElement;
    return Number(value || placeholder);
  }
  values(): JobValues {
    const size = this.named('size').value, measure = this.named('measure').value;
    const values: JobValues = size ? [[measure, `${size}${kMeasures[measure]}`]] : [];
    for (const field of this.fields) {
      if (field.name === 'size' || field.name === 'measure' || !field.value) continue;
      if (field instanceof HTMLSelectElement || field.type === 'number') values.push([field.name, `${field.value}${field.dataset['unit'] ?? ''}`]);
      else if (field.checked) values.push([field.name, field.dataset['value'] ?? 'true']);
    }
    return values;
  }

  get filled(): Filled {
    return Object.fromEntries(this.fields.map((field) => [keyOf(field), field.type === 'checkbox' ? (field as HTMLInputElement).checked : field.value]));
  }
  fill(filled: Filled): void {
    for (const field of this.fields) {
      const value = filled[keyOf(field)];
      if (typeof value === 'boolean') (field as HTMLInputElement).checked = value;
      else if (value !== undefined) field.value = value;
    }
    this.nameUnit();
  }
}

const keyOf = ({ name, dataset }: Field): string => [name, dataset['value']].filter(Boolean).join(' ');
