// Small things of the page itself.
import type { SheetColors } from './views/sheet_view';
import type { SpaceColors } from './views/space_view';

export const byId = <T extends HTMLElement = HTMLElement>(id: string): T => document.getElementById(id) as T;

export const bytesOf = (text: string): Uint8Array<ArrayBuffer> => Uint8Array.from(text, (c) => c.charCodeAt(0));

const named = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
const rgb = (name: string): number[] => [1, 3, 5].map((i) => parseInt(named(name).slice(i, i + 2), 16) / 255);

/** Read anew each time: they follow the light and dark scheme. */
export const colors = {
  sheet: (): SheetColors => ({
    ink: named('line'), fold: named('fold'), alarm: named('alarm'), accent: named('accent'), lock: named('lock'),
    tints: [0, 1, 2, 3, 4].map((i) => named(`tint${i}`)),
  }),
  space: (): SpaceColors => ({
    front: rgb('front'), back: rgb('back'), ink: rgb('line'), alarm: rgb('alarm'), accent: rgb('accent'), fold: rgb('fold'),
  }),
};

export function download(name: string, bytes: Uint8Array): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([bytes as Uint8Array<ArrayBuffer>]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
