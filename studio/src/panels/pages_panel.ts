// Pages to print, as the print job lays them out, and everything that can be taken away as a file.
import type { JobValues } from '../core/protocol';
import { byId, download } from '../page';
import type { Session } from '../session';

type Guarded = (work: () => Promise<void>) => Promise<void>;

const kTabSides = ['auto', 'alternate', 'left', 'right', 'both', 'none'];
const kExports = [['html', 'folding page'], ['glb', 'animation (glTF)'], ['urdf', 'robot (URDF)'], ['xml', 'robot (MuJoCo)'], ['csv', 'angles (CSV)']] as const;
const kStyles = ['paper', 'origami', 'laser', 'bw'];

export class PagesPanel {
  private fresh = false; // the pages shown are of the net as it is
  private urls: string[] = [];

  constructor(private readonly session: Session, private readonly guarded: Guarded) {
    const form = byId<HTMLFormElement>('page-form');
    for (const [name, choices] of [['tabs', kTabSides], ['style', kStyles]] as const)
      for (const choice of choices) (form.elements.namedItem(name) as HTMLSelectElement).append(new Option(choice, choice));
    form.addEventListener('submit', (e) => {
      e.preventDefault();
      void this.layOut();
    });
    form.addEventListener('change', () => void this.layOut());
    this.offer('PDF', () => this.pages('pdf'));
    this.offer('SVG', () => this.pages('svg'));
    this.offer('DXF', () => this.pages('dxf'));
    this.offer('FOLD', async () => ({ [`${this.name()}.fold`]: await this.session.net() }));
    this.offer('project', async () => ({ [`${this.name()}.plico`]: await this.session.project() }));
    for (const [kind, label] of kExports) this.offer(label, () => this.exported(kind));
  }

  newModel(): void {
    this.fresh = false;
  }
  edited(): void {
    this.fresh = false;
  }
  shown(): Promise<void> {
    return this.fresh ? Promise.resolve() : this.layOut();
  }

  private name(): string {
    return this.session.shape!.model.name.replace(/[^\p{L}\p{N}_.-]+/gu, '-').slice(0, 80) || 'model';
  }

  private async pages(kind: 'pdf' | 'svg' | 'dxf'): Promise<Record<string, Uint8Array>> {
    const form = new FormData(byId<HTMLFormElement>('page-form'));
    const net = `${this.name()}.fold`;
    const values: JobValues = [['net', net], ['output', `${this.name()}.${kind}`], ['title', this.session.shape!.model.name]];
    for (const name of ['page', 'tabs', 'style']) values.push([name, String(form.get(name))]);
    if (form.get('longest')) values.push(['longest', `${String(form.get('longest'))}mm`]);
    if (form.get('split')) values.push(['split', 'true']);
    const result = await this.session.job('print', values, { [net]: await this.session.net() });
    byId('page-report').textContent = result.messages.filter((m) => m.tone !== 'detail').map((m) => m.text.trim()).join('\n');
    return result.files;
  }
  private async exported(kind: string): Promise<Record<string, Uint8Array>> {
    const net = `${this.name()}.fold`;
    const result = await this.session.job('export', [['file', net], ['output', `${this.name()}.${kind}`]], { [net]: await this.session.net() });
    return result.files;
  }

  private layOut(): Promise<void> {
    return this.guarded(async () => {
      const files = await this.pages('svg');
      this.urls.forEach((url) => URL.revokeObjectURL(url));
      this.urls = Object.values(files).map((svg) => URL.createObjectURL(new Blob([svg as Uint8Array<ArrayBuffer>], { type: 'image/svg+xml' })));
      byId('pages').replaceChildren(...this.urls.map((url, i) => {
        const image = document.createElement('img');
        image.src = url;
        image.alt = `Page ${i + 1} of ${this.urls.length}`;
        return image;
      }));
      this.fresh = true;
    });
  }

  private offer(label: string, make: () => Promise<Record<string, Uint8Array>>): void {
    const button = document.createElement('button');
    button.textContent = `Save ${label}`;
    button.addEventListener('click', () => void this.guarded(async () => {
      for (const [name, bytes] of Object.entries(await make())) download(name, bytes);
    }));
    byId('downloads').append(button);
  }
}
