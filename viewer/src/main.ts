// The page: reads its data, joins the views, listens to the keyboard.
import { Model, type PageData } from './model';
import { NetView } from './net';
import { Player } from './player';
import { Scene, type Look } from './scene';
import { rgbOf, type Rgb } from './raster';
import { badge, panelDetails, percent, plainName, rows } from './words';

declare global {
  interface Window {
    plico: { positions: () => number[][]; time: () => number; setTime: (time: number) => void; selected: () => number };
  }
}

const byId = <T extends Element>(id: string): T => document.getElementById(id) as unknown as T;
const data = JSON.parse(byId<HTMLScriptElement>('plico-data').textContent!) as PageData;
const model = new Model(data);

const kLinksInRow = 5;

function look(): Look {
  const style = getComputedStyle(document.documentElement);
  const rgb = (name: string): Rgb => rgbOf(style.getPropertyValue(name).trim());
  return {
    front: rgb('--front'), back: rgb('--back'), ink: rgb('--line'), accent: rgb('--accent'), alarm: rgb('--alarm'),
    mountain: rgb('--mountain'), valley: rgb('--valley'), flat: rgb('--flat'),
  };
}

const slider = byId<HTMLInputElement>('time');
const playButton = byId<HTMLButtonElement>('play');
const speed = byId<HTMLSelectElement>('speed');
const details = byId<HTMLElement>('details');
const panelInput = byId<HTMLInputElement>('panel');
const help = byId<HTMLDialogElement>('help');
const singleKeys = byId<HTMLInputElement>('single-keys');

const scene = new Scene(model, byId('space'), byId('shadow'), look(), hover, select);
const net = new NetView(model, byId('net'), hover, select);
const player = new Player(show);

function hover(panel: number): void {
  if (scene.hovered === panel) return;
  scene.hovered = panel;
  scene.redraw();
  mark();
}
function select(panel: number): void {
  scene.selected = panel === scene.selected ? -1 : panel;
  panelInput.value = scene.selected >= 0 ? String(scene.selected) : '';
  scene.redraw();
  mark();
}
function mark(): void {
  const colliding = model.colliding(player.time);
  net.mark(scene.hovered, scene.selected, colliding);
  const panel = scene.hovered >= 0 ? scene.hovered : scene.selected;
  const summary = `${data.panels.length} panels, ${data.hinges.length} folds. Point at a panel, or drag to turn.`;
  details.textContent = panel >= 0 ? panelDetails(model, panel, player.time) : summary;
  const alarm = byId<HTMLElement>('alarm');
  const list = [...colliding].sort((a, b) => a - b);
  alarm.hidden = list.length === 0;
  alarm.textContent = list.length ? `Panels in collision: ${list.slice(0, 12).join(', ')}${list.length > 12 ? ' …' : ''}` : '';
}

function show(): void {
  slider.value = String(player.time);
  slider.style.setProperty('--folded', `${100 * player.time}%`);
  slider.setAttribute('aria-valuetext', `${percent(player.time)} folded`);
  byId('now').textContent = percent(player.time);
  playButton.setAttribute('aria-label', player.playing ? 'Pause' : 'Play');
  playButton.dataset['playing'] = String(player.playing);
  speed.value = String(player.speed);
  scene.setTime(player.time);
  mark();
}

function fillHeader(): void {
  document.title = `${data.title} · Plico`;
  byId('title').textContent = data.title;
  const { mark: sign, text, title } = badge(data);
  const element = byId<HTMLElement>('badge');
  element.dataset['status'] = data.proof.status;
  element.title = title;
  element.querySelector('b')!.textContent = sign;
  element.querySelector('span')!.textContent = text;
  fillLinks();
}

// Files of which there is one of a kind fit in the header's row; pages, of which there may be dozens, are folded away.
function fillLinks(): void {
  const kind = (href: string): string => href.slice(href.lastIndexOf('.') + 1);
  const count = new Map<string, number>();
  for (const { href } of data.links) count.set(kind(href), (count.get(kind(href)) ?? 0) + 1);
  const shown = data.links.filter(({ href }) => count.get(kind(href)) === 1).slice(0, kLinksInRow);
  const rest = data.links.filter((link) => !shown.includes(link));
  const more = byId<HTMLDetailsElement>('more');
  for (const link of shown) more.before(anchor(link));
  more.hidden = rest.length === 0;
  more.querySelector('summary')!.textContent = `${rest.length} ${shown.length ? 'more ' : ''}${rest.length === 1 ? 'file' : 'files'}`;
  more.querySelector('div')!.append(...rest.map(anchor));
}
function anchor({ label, href }: PageData['links'][number]): HTMLAnchorElement {
  const link = document.createElement('a');
  link.textContent = label;
  link.title = label;
  link.href = href;
  return link;
}

function fillPictures(): void {
  const part = byId<HTMLElement>('pictures');
  part.hidden = data.pictures.length === 0;
  for (const { caption, png } of data.pictures) {
    const figure = part.appendChild(document.createElement('figure'));
    const image = figure.appendChild(document.createElement('img'));
    image.src = `data:image/png;base64,${png}`;
    image.alt = caption;
    figure.appendChild(document.createElement('figcaption')).textContent = caption;
  }
}

function fillReport(): void {
  const table = byId<HTMLTableElement>('report');
  for (const [name, value] of rows(data.report ?? {})) {
    const row = table.insertRow();
    const head = row.appendChild(document.createElement('th'));
    head.scope = 'row';
    head.textContent = plainName(name);
    row.insertCell().textContent = value;
  }
  byId<HTMLElement>('report-part').hidden = table.rows.length === 0;
}

const actions: Record<string, () => void> = {
  ' ': () => player.toggle(),
  ArrowRight: () => player.step(0.01),
  ArrowLeft: () => player.step(-0.01),
  ArrowUp: () => player.step(0.1),
  ArrowDown: () => player.step(-0.1),
  PageUp: () => player.step(0.1),
  PageDown: () => player.step(-0.1),
  Home: () => player.step(-1),
  End: () => player.step(1),
};
const singleKeyActions: Record<string, () => void> = {
  '.': () => player.step(0.01),
  ',': () => player.step(-0.01),
  '[': () => player.faster(0.5),
  ']': () => player.faster(2),
  a: () => scene.turn(-0.15, 0),
  d: () => scene.turn(0.15, 0),
  w: () => scene.turn(0, 0.12),
  s: () => scene.turn(0, -0.12),
  '+': () => scene.zoom(1.2),
  '-': () => scene.zoom(1 / 1.2),
  r: () => scene.home(),
  l: toggleLines,
  '?': () => help.showModal(),
};

function toggleLines(): void {
  scene.showLines = !scene.showLines;
  byId('lines').setAttribute('aria-pressed', String(scene.showLines));
  scene.redraw();
}

function onKey(event: KeyboardEvent): void {
  if (event.ctrlKey || event.metaKey || event.altKey || help.open) return;
  const target = event.target as HTMLElement;
  const writing = target === panelInput || target === speed;
  if (writing || (event.key === ' ' && target.closest('button, a, summary'))) return;
  const action = actions[event.key] ?? (singleKeys.checked ? singleKeyActions[event.key] : undefined);
  if (!action) return;
  event.preventDefault();
  action();
}

function listen(): void {
  slider.addEventListener('input', () => {
    player.playing = false;
    player.set(Number(slider.value));
  });
  playButton.addEventListener('click', () => player.toggle());
  speed.addEventListener('change', () => {
    player.speed = Number(speed.value);
    show();
  });
  panelInput.max = String(data.panels.length - 1);
  panelInput.addEventListener('change', () => {
    const panel = panelInput.value === '' ? -1 : Math.min(data.panels.length - 1, Math.max(0, Math.floor(Number(panelInput.value))));
    scene.selected = -1;
    select(panel);
  });
  const press = (id: string, action: () => void): void => byId(id).addEventListener('click', action);
  press('turn-left', () => scene.turn(-0.3, 0));
  press('turn-right', () => scene.turn(0.3, 0));
  press('nearer', () => scene.zoom(1.25));
  press('farther', () => scene.zoom(0.8));
  press('home', () => scene.home());
  press('lines', toggleLines);
  press('help-open', () => help.showModal());
  document.addEventListener('keydown', onKey);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => scene.setLook(look()));
}

fillHeader();
fillReport();
fillPictures();
listen();
player.set(data.start);
window.plico = {
  positions: () => model.positions(player.time),
  time: () => player.time,
  setTime: (time) => player.set(time),
  selected: () => scene.selected,
};
document.documentElement.dataset['ready'] = 'true';
