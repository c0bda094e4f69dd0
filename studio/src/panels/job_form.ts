// A form for any job, made from what the core tells of its options, and the values that were filled in.
import type { JobDescription, JobOption, JobValues } from '../core/protocol';

// Those that are the terminal's, the page's own affair, or a list that the page reads by itself.
const kHidden = new Set(['output', 'force', 'json', 'quiet', 'verbose', 'progress', 'report', 'threads', 'list', 'motions']);
const kRare = new Set(['seed', 'time-limit']); // of every job
const kShownAtOnce = 6;

const kMeshKinds = ['obj', 'off', 'stl', 'ply', 'glb', 'gltf'], kSheetKinds = ['fold', 'cp', 'opx', 'ori', 'svg', 'json'];
const kKindsOfInputs: Record<string, string[]> = {
  mesh: kMeshKinds, shape: kMeshKinds, net: kSheetKinds, pattern: kSheetKinds, file: kSheetKinds,
};

const plain = (option: JobOption): string => option.name.replace(/^-+/, '');
const words = (option: JobOption): string => plain(option).toLowerCase().replaceAll('-', ' ');
export const kindOf = (file: string): string => file.slice(file.lastIndexOf('.') + 1).toLowerCase();

function made<Tag extends keyof HTMLElementTagNameMap>(tag: Tag, className = '', text = ''): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  if (className) element.className = className;
  element.textContent = text;
  return element;
}

// What a page has no standard input or list option for.
const helpOf = (option: JobOption): string =>
  option.help.replace(/[;,] '?-'? (is|for) standard input/, '').replace('; --list shows all', '').replace('; repeatable', '');

const kNumber = /^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*([a-z%]*)$/i;

/** "at least 0, at most 90"; nothing where any number is taken. */
function rangeOf({ minimum, exclusiveMinimum, maximum, exclusiveMaximum }: JobOption): string {
  const least = minimum !== undefined ? `at least ${minimum}` : exclusiveMinimum !== undefined ? `above ${exclusiveMinimum}` : '';
  const most = maximum !== undefined ? `at most ${maximum}` : exclusiveMaximum !== undefined ? `below ${exclusiveMaximum}` : '';
  return [least, most].filter(Boolean).join(', ');
}
/** What is wrong with it before the core sees it; a number in another unit than the option's is left to the core. */
function wrongNumber(option: JobOption, text: string): string {
  if (!text) return '';
  const [, number, unit] = kNumber.exec(text) ?? [];
  if (number === undefined) return `${words(option)}: '${text}' is not a number`;
  const value = Number(number);
  if (unit && unit !== option.unit) return '';
  const { minimum = -Infinity, maximum = Infinity, exclusiveMinimum = -Infinity, exclusiveMaximum = Infinity } = option;
  const fits = value >= minimum && value <= maximum && value > exclusiveMinimum && value < exclusiveMaximum;
  return fits ? '' : `${words(option)} = ${text} must be ${rangeOf(option)}`;
}

interface Field {
  option: JobOption;
  isFile: boolean;
  read: () => string[]; // nothing: as the core has it
  set?: (value: string) => void;
}

export class JobForm {
  private readonly fields: Field[] = [];

  /** `filesOf` names the files there are; `namesOf` is a list to choose from, for jobs that have one. */
  constructor(
    readonly job: JobDescription, form: HTMLFormElement, private readonly filesOf: () => string[],
    private readonly names: { name: string; description: string }[],
  ) {
    const shown = job.options.filter((option) => !kHidden.has(plain(option)));
    const first = shown.filter((option) => option.positional || option.required);
    const others = shown.filter((option) => !first.includes(option));
    const plainOnes = others.filter((option) => !kRare.has(plain(option)));
    const atOnce = [...first, ...plainOnes.slice(0, kShownAtOnce)];
    const more = others.filter((option) => !atOnce.includes(option));
    const grid = made('div', 'fields');
    grid.append(...atOnce.map((option) => this.field(option)));
    form.replaceChildren(grid);
    if (!more.length) return;
    const rest = made('div', 'fields');
    rest.append(...more.map((option) => this.field(option)));
    const details = made('details');
    details.append(made('summary', '', `${more.length} more options`), rest);
    form.append(details);
  }

  values(): JobValues {
    return this.fields.flatMap(({ option, read }) => read().map((value): [string, string] => [plain(option), value]));
  }
  /** The files that the values name. */
  inputs(): string[] {
    return this.fields.filter((field) => field.isFile).flatMap((field) => field.read());
  }
  /** Takes this file as the first input. */
  fill(file: string): void {
    this.fields.find((field) => field.isFile)?.set?.(file);
  }
  /** The words of the command line that does the same. */
  command(): string[] {
    const quoted = (word: string): string => (/^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`);
    return ['plico', ...this.job.name.split(' '), ...this.fields.flatMap(({ option, read }) => read().flatMap((value) =>
      option.positional ? [quoted(value)] : option.value ? [option.name, quoted(value)] : [option.name]))];
  }

  private field(option: JobOption): HTMLElement {
    const kinds = option.positional ? kKindsOfInputs[plain(option).toLowerCase()] : undefined;
    const isFile = kinds !== undefined || option.value === 'FILE';
    const { control, read } = isFile ? this.file(option, kinds) : this.plainControl(option);
    this.fields.push({ option, isFile, read, ...(isFile && { set: (value: string) => ((control as HTMLSelectElement).value = value) }) });
    const label = made('label', 'field');
    const name = made('span', 'field-name', words(option));
    if (option.unit) name.append(made('span', 'unit', ` ${option.unit}`));
    if (control instanceof HTMLInputElement && control.type === 'checkbox') {
      const line = made('span', 'check');
      line.append(control, name);
      label.append(line);
    } else label.append(name, control);
    const range = rangeOf(option);
    const help = made('span', 'help', range ? `${helpOf(option)}; ${range}` : helpOf(option));
    help.id = `help-${this.job.name.replace(' ', '-')}-${plain(option)}`;
    control.setAttribute('aria-describedby', help.id);
    label.append(help);
    return label;
  }

  /** Up and down in a number, as in a number field; with a unit too. */
  private nudge(option: JobOption, input: HTMLInputElement, event: KeyboardEvent): void {
    const way = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    const [, number, unit] = kNumber.exec(input.value.trim() || option.default) ?? [];
    if (!way || number === undefined) return;
    event.preventDefault();
    const by = 10 ** Math.floor(Math.log10(Math.max(Math.abs(Number(number)), 1e-9)) - 0.999);
    const step = Number(number) % 1 === 0 && Math.abs(Number(number)) < 100 ? 1 : by;
    const next = Number((Number(number) + way * step).toPrecision(6));
    if (wrongNumber(option, `${next}${unit}`)) return;
    input.value = `${next}${unit}`;
    input.dispatchEvent(new Event('input', { bubbles: true }));
  }

  private file(option: JobOption, kinds?: string[]): { control: HTMLElement; read: () => string[] } {
    const fitting = this.filesOf().filter((file) => !kinds || kinds.includes(kindOf(file)));
    const choice = made('select');
    if (!option.required || !fitting.length) choice.append(new Option(fitting.length ? 'none' : 'no file yet: open one', ''));
    for (const file of fitting) choice.append(new Option(file, file));
    return { control: choice, read: () => (choice.value ? [choice.value] : []) };
  }

  private plainControl(option: JobOption): { control: HTMLElement; read: () => string[] } {
    if (plain(option) === 'name' && option.positional && this.names.length) {
      const choice = made('select');
      for (const { name, description } of this.names) choice.append(new Option(`${name} · ${description}`, name));
      return { control: choice, read: () => [choice.value] };
    }
    if (option.choices.length) {
      const choice = made('select');
      choice.append(new Option(option.default ? `${option.default} (as usual)` : 'as usual', ''));
      for (const name of option.choices) if (name !== option.default) choice.append(new Option(name, name));
      return { control: choice, read: () => (choice.value ? [choice.value] : []) };
    }
    const input = made('input');
    if (!option.value && !option.positional) {
      input.type = 'checkbox';
      return { control: input, read: () => (input.checked ? ['true'] : []) };
    }
    input.placeholder = option.default || (option.repeatable ? 'one or more, with spaces' : option.value);
    input.spellcheck = false;
    const told = (): void => {
      const wrong = wrongNumber(option, input.value.trim());
      input.setCustomValidity(wrong);
      input.setAttribute('aria-invalid', String(wrong !== ''));
      input.title = wrong;
    };
    if (rangeOf(option)) {
      input.inputMode = 'decimal';
      input.addEventListener('input', told);
      input.addEventListener('keydown', (event) => this.nudge(option, input, event));
    }
    const read = (): string[] => (option.repeatable ? input.value.trim().split(/[\s;]+/) : [input.value.trim()]).filter(Boolean);
    return { control: input, read };
  }
}
