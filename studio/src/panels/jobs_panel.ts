// Every job of the core as a form: what it reads, its options, what it says, and the files it makes.
import type { JobDescription, JobResult, JobValues, Progress } from '../core/protocol';
import { byId, download } from '../page';
import type { Session } from '../session';
import { JobForm, kindOf } from './job_form';
import type { MotionView } from './motion_view';

type Guarded = (work: () => Promise<void>) => Promise<void>;

const kGroups: [string, string[]][] = [
  ['Shape', ['check', 'info', 'simplify', 'inflate', 'segment', 'shell', 'sample']],
  ['Net', ['unfold', 'craft']],
  ['Crease pattern', ['origami make', 'origami info', 'origami settle', 'origami assign', 'fold']],
  ['Squares', ['voxelize', 'stack']],
  ['Files', ['print', 'export', 'verify']],
];
const kTitles: Record<string, string> = {
  'origami make': 'Make a pattern', 'origami info': 'Check a pattern', 'origami settle': 'Settle a pattern', 'origami assign': 'Assign a pattern', fold: 'Fold', info: 'Measure',
};
const kMesh = ['obj', 'off', 'stl', 'ply'];
const kWrites: Record<string, string[]> = {
  check: ['', ...kMesh], simplify: kMesh, inflate: kMesh, sample: kMesh, shell: ['obj', 'stl'], segment: ['fold'], unfold: ['fold'],
  craft: ['a folder'], 'origami make': ['fold'], 'origami settle': ['fold'], 'origami assign': ['fold'], fold: ['fold'], voxelize: ['obj', 'stl', 'fold'],
  stack: ['fold', 'html', 'stl', '3mf', 'csv'], print: ['pdf', 'svg', 'dxf'], export: ['html', 'png', 'glb', 'urdf', 'xml', 'csv'],
};
const kSuffix: Record<string, string> = {
  check: '-clean', simplify: '-simple', inflate: '-round', shell: '-shells', 'origami settle': '-settled', 'origami assign': '-assigned', fold: '-motion', voxelize: '-squares', stack: '-stack',
};
const kPictures: Record<string, string> = { svg: 'image/svg+xml', png: 'image/png' };

const titleOf = (name: string): string => kTitles[name] ?? name[0]!.toUpperCase() + name.slice(1);
const stem = (file: string): string => file.replace(/\.[^.]*$/, '');
const folderless = (file: string): string => file.slice(file.lastIndexOf('/') + 1);
const sizeOf = (bytes: number): string => (bytes < 1000 ? `${bytes} bytes` : bytes < 1e6 ? `${Math.round(bytes / 1000)} kB` : `${(bytes / 1e6).toFixed(1)} MB`);

function button(text: string, act: () => unknown): HTMLButtonElement {
  const made = document.createElement('button');
  made.type = 'button';
  made.textContent = text;
  made.addEventListener('click', () => void act());
  return made;
}
function paragraph(text: string, className: string): HTMLElement {
  const made = document.createElement('p');
  made.className = className;
  made.textContent = text;
  return made;
}

export class JobsPanel {
  private jobs: JobDescription[] = [];
  private form?: JobForm;
  private readonly files = new Map<string, Uint8Array>(); // opened here, or made by a job
  private readonly lists = new Map<string, { name: string; description: string }[]>();
  private urls: string[] = [];
  private chosen = 0;
  private motion?: MotionView;

  constructor(
    private readonly session: Session, private readonly guarded: Guarded, private readonly progress: (p: Progress) => void,
    private readonly openModel: (name: string, bytes: Uint8Array) => Promise<void>, private readonly makeView: () => MotionView | undefined,
  ) {
    const form = byId<HTMLFormElement>('job-form');
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.run();
    });
    form.addEventListener('input', () => this.showCommand());
    byId('job-kind').addEventListener('change', () => this.showCommand());
    byId('job-run').addEventListener('click', () => form.requestSubmit());
    byId('job-copy').addEventListener('click', () => void navigator.clipboard?.writeText(byId('job-command').textContent ?? ''));
    byId<HTMLInputElement>('job-file').addEventListener('change', (event) => void this.take((event.target as HTMLInputElement).files?.[0]));
  }

  newModel(): void {
    if (this.form) void this.choose(this.form.job.name);
  }
  async shown(): Promise<void> {
    if (this.jobs.length) return;
    this.jobs = await this.session.jobs();
    byId('job-list').replaceChildren(...kGroups.flatMap(([group, names]) => [paragraph(group, 'group'), ...names.map((name) => {
      const choice = button(titleOf(name), () => this.choose(name));
      choice.dataset['job'] = name;
      return choice;
    })]));
    await this.choose(this.session.shape ? 'check' : 'origami make');
  }

  /** A file that another screen made, as the input of a job. */
  async give(name: string, bytes: Uint8Array, job: string): Promise<void> {
    await this.shown();
    this.files.delete(name);
    this.files.set(name, bytes);
    await this.choose(job);
    this.form?.fill(name);
    this.showCommand();
  }

  async choose(name: string): Promise<void> {
    const job = this.jobs.find((one) => one.name === name);
    if (!job) return;
    const ticket = ++this.chosen, names = await this.listOf(job);
    if (ticket !== this.chosen) return; // another was chosen meanwhile
    for (const choice of byId('job-list').querySelectorAll('button')) choice.setAttribute('aria-current', String(choice.dataset['job'] === name));
    byId('job-title').textContent = titleOf(name);
    byId('job-summary').textContent = job.summary;
    this.form = new JobForm(job, byId<HTMLFormElement>('job-form'), () => this.names(), names);
    const kind = byId<HTMLSelectElement>('job-kind'), kinds = kWrites[name] ?? [];
    kind.replaceChildren(...kinds.map((k) => new Option(k || 'nothing', k)));
    byId('job-kind-label').hidden = kinds.length < 2;
    byId('job-result').replaceChildren();
    this.showCommand();
  }

  /** The patterns or shapes that a job knows by name. */
  private async listOf(job: JobDescription): Promise<{ name: string; description: string }[]> {
    if (!job.options.some((option) => option.name === '--list')) return [];
    const known = this.lists.get(job.name);
    if (known) return known;
    const { report } = await this.session.job(job.name, [['list', 'true']], {});
    const list = Object.values(report).find((value) => Array.isArray(value) && value[0]?.name) as { name: string; description: string }[] | undefined;
    this.lists.set(job.name, list ?? []);
    return list ?? [];
  }

  private names(): string[] {
    const model = this.modelName();
    return [...(model ? [`${model}.obj`, `${model}.fold`] : []), ...[...this.files.keys()].reverse()];
  }
  private modelName(): string | undefined {
    return this.session.shape?.model.name.replace(/[^\p{L}\p{N}_.-]+/gu, '-').slice(0, 80) || undefined;
  }
  private bytesOf(file: string): Promise<Uint8Array> | Uint8Array {
    const made = this.files.get(file);
    return made ?? (kindOf(file) === 'obj' ? this.session.mesh() : this.session.net());
  }
  private async take(file: File | undefined): Promise<void> {
    if (!file || !this.form) return;
    this.files.set(file.name, new Uint8Array(await file.arrayBuffer()));
    await this.choose(this.form.job.name);
  }

  private output(form: JobForm): string[] {
    const kind = byId<HTMLSelectElement>('job-kind').value, name = form.job.name;
    if (!kind) return [];
    const base = stem(folderless(form.inputs()[0] ?? form.values().find(([option]) => option === 'name')?.[1] ?? 'model'));
    return [kind === 'a folder' ? base : `${base}${kSuffix[name] ?? ''}.${kind}`];
  }
  private showCommand(): void {
    if (!this.form) return;
    byId('job-command').textContent = [...this.form.command(), ...this.output(this.form).flatMap((file) => ['-o', file])].join(' ');
  }

  private run(): Promise<void> {
    const { form } = this;
    if (!form) return Promise.resolve();
    return this.guarded(async () => {
      byId('job-result').replaceChildren();
      const values: JobValues = [...form.values(), ...this.output(form).map((file): [string, string] => ['output', file])];
      const files: Record<string, Uint8Array> = {};
      for (const file of form.inputs()) files[file] = await this.bytesOf(file);
      const result = await this.session.job(form.job.name, values, files, this.progress);
      for (const [name, bytes] of Object.entries(result.files)) this.files.set(name, bytes);
      await this.tell(result);
    });
  }

  private async tell(result: JobResult): Promise<void> {
    this.urls.forEach((url) => URL.revokeObjectURL(url));
    this.urls = [];
    const place = byId('job-result'), fine = result.exit_code === 0;
    const badge = paragraph(fine ? 'done' : result.exit_code === 1 ? 'the answer is no' : `ended with ${result.exit_code}`, 'badge');
    badge.dataset['status'] = fine ? 'good' : 'bad';
    place.append(badge);
    for (const { tone, text } of result.messages)
      if (text.trim() && tone !== 'detail') place.append(paragraph(text.trimEnd(), `message ${tone}`));
    for (const [name, bytes] of Object.entries(result.files)) place.append(this.row(name, bytes));
    const made = Object.entries(result.files);
    const [sheet] = made.filter(([name]) => kindOf(name) === 'fold');
    if (sheet) await this.offerMotion(place, ...sheet);
    for (const [name, bytes] of made) if (kPictures[kindOf(name)]) place.append(this.picture(name, bytes));
  }

  private row(name: string, bytes: Uint8Array): HTMLElement {
    const row = document.createElement('div');
    row.className = 'row made';
    row.append(paragraph(`${name} · ${sizeOf(bytes.length)}`, 'file'), button('Save', () => download(folderless(name), bytes)));
    if ([...kMesh, 'fold'].includes(kindOf(name))) row.append(button('Open here', () => this.openModel(name, bytes)));
    return row;
  }
  private picture(name: string, bytes: Uint8Array): HTMLImageElement {
    const image = document.createElement('img');
    const url = URL.createObjectURL(new Blob([bytes as Uint8Array<ArrayBuffer>], { type: kPictures[kindOf(name)] }));
    this.urls.push(url);
    image.src = url;
    image.alt = name;
    return image;
  }

  /** What was made as it folds; pictures of it where nothing can be drawn in space. */
  private async offerMotion(place: HTMLElement, name: string, bytes: Uint8Array): Promise<void> {
    const view = (this.motion ??= this.makeView());
    if (!view) return this.offerPictures(place, name, bytes);
    place.append(view.element);
    await view.show({ name, bytes }).catch(() => view.element.remove()); // without panels to draw: what it is was told above
  }
  private async offerPictures(place: HTMLElement, name: string, bytes: Uint8Array): Promise<void> {
    const slider = document.createElement('input');
    Object.assign(slider, { type: 'range', min: '0', max: '1', step: '0.05', value: '0.6' });
    slider.setAttribute('aria-label', 'Folded');
    const image = document.createElement('img');
    image.alt = `${name} as it folds`;
    let asking = false, url = '';
    const draw = async (): Promise<void> => {
      if (asking) return;
      asking = true;
      for (let drawn = ''; drawn !== slider.value; ) {
        drawn = slider.value;
        const { files } = await this.session.job('export', [['file', name], ['output', 'view.png'], ['at', drawn], ['picture-width', '880'], ['picture-height', '560']], { [name]: bytes });
        URL.revokeObjectURL(url);
        url = URL.createObjectURL(new Blob([files['view.png'] as Uint8Array<ArrayBuffer>], { type: 'image/png' }));
        image.src = url;
      }
      asking = false;
    };
    slider.addEventListener('input', () => void this.guarded(draw));
    try {
      await draw();
      place.append(image, slider);
    } catch {
      // A file without panels to draw: what it is was told above.
    }
  }
}
