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

interface Field {
  option: JobOption;
  isFile: boolean;
  read: () => string[]; // nothing: as the core has it
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
    this.fields.push({ option, isFile, read });
    const label = made('label', 'field');
    const name = made('span', 'field-name', words(option));
    if (option.unit) name.append(made('span', 'unit', ` ${option.unit}`));
    if (control instanceof HTMLInputElement && control.type === 'checkbox') {
      const line = made('span', 'check');
      line.append(control, name);
      label.append(line);
    } else label.append(name, control);
    const help = made('span', 'help', helpOf(option));
    help.id = `help-${this.job.name.replace(' ', '-')}-${plain(option)}`;
    control.setAttribute('aria-describedby', help.id);
    label.append(help);
    return label;
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
    const read = (): string[] => (option.repeatable ? input.value.trim().split(/[\s;]+/) : [input.value.trim()]).filter(Boolean);
    return { control: input, read };
  }
}
