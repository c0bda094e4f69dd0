// The project kept in the browser (IndexedDB), so that a killed tab loses nothing: a project as it once was, and the
// edits since, which are small and written after each. Without storage it is a page without memory; the caller is told
// by `false` or `undefined`.
import type { Edit } from './core/protocol';

const kName = 'plico-studio', kStore = 'projects', kProject = 'current', kEdits = 'edits', kPattern = 'pattern', kPlaces = 'places', kForm = 'page form';

export interface Kept {
  name: string;
  project: Uint8Array;
  id: number; // edits and places belong to the project of the same
}

/** One panel of a part on a page: its first corner in millimetres from the lower left, its first side's direction in degrees. */
export interface Place {
  panel: number;
  page: number; // from 1
  x: number;
  y: number;
  angle_deg: number;
}
/** Where parts lie, by their panels; a place is kept for a part of the same panels, whatever else becomes of the net. */
export type Places = ReadonlyMap<string, Place & { byHand: boolean }>;

let opened: Promise<IDBDatabase> | undefined;
function database(): Promise<IDBDatabase> {
  return (opened ??= new Promise((resolve, reject) => {
    const opening = indexedDB.open(kName, 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore(kStore);
    opening.onsuccess = () => resolve(opening.result);
    opening.onerror = () => reject(opening.error);
  }));
}

async function write(values: Record<string, unknown>): Promise<boolean> {
  try {
    const writing = (await database()).transaction(kStore, 'readwrite', { durability: 'relaxed' });
    for (const [key, value] of Object.entries(values)) writing.objectStore(kStore).put(value, key);
    writing.commit();
    return await new Promise((resolve) => {
      writing.oncomplete = () => resolve(true);
      writing.onabort = writing.onerror = () => resolve(false);
    });
  } catch {
    return false;
  }
}

async function read<T>(key: string): Promise<T | undefined> {
  const asked = (await database()).transaction(kStore).objectStore(kStore).get(key);
  return new Promise((resolve, reject) => {
    asked.onsuccess = () => resolve(asked.result as T | undefined);
    asked.onerror = () => reject(asked.error);
  });
}

export const keepProject = (kept: Kept, places: Places): Promise<boolean> =>
  write({ [kProject]: kept, [kEdits]: { id: kept.id, edits: [] }, [kPlaces]: { id: kept.id, places } });
export const keepEdits = (id: number, edits: Edit[]): Promise<boolean> => write({ [kEdits]: { id, edits } });

export const keepPlaces = (id: number, places: Places): Promise<boolean> => write({ [kPlaces]: { id, places } });

/** Paper, size and whatever else was filled in, by the names of the fields; it is there for the next project too. */
export type Filled = Record<string, string | boolean>;
export const keepForm = (form: Filled): Promise<boolean> => write({ [kForm]: form });

export const keepPattern = (text: string): Promise<boolean> => write({ [kPattern]: text });
export const keptPattern = (): Promise<string | undefined> => read<string>(kPattern).catch(() => undefined);

export async function kept(): Promise<(Kept & { edits: Edit[]; places: Places; form: Filled }) | undefined> {
  try {
    const [project, since, where, form] = await Promise.all([
      read<Kept>(kProject), read<{ id: number; edits: Edit[] }>(kEdits), read<{ id: number; places: Places }>(kPlaces),
      read<Filled>(kForm),
    ]);
    return project && {
      ...project, edits: since?.id === project.id ? since.edits : [], places: where?.id === project.id ? where.places : new Map(),
      form: form ?? {},
    };
  } catch {
    return undefined;
  }
}
