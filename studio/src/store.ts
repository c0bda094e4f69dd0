// The project kept in the browser (IndexedDB), so that a closed tab loses nothing. Without storage it is silently a
// page without memory; the caller is told by `false` or `undefined`.
const kName = 'plico-studio', kStore = 'projects', kKey = 'current';

export interface Kept {
  name: string;
  project: Uint8Array;
}

function database(): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const opening = indexedDB.open(kName, 1);
    opening.onupgradeneeded = () => opening.result.createObjectStore(kStore);
    opening.onsuccess = () => resolve(opening.result);
    opening.onerror = () => reject(opening.error);
  });
}

async function request<T>(mode: IDBTransactionMode, ask: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  const open = await database();
  return new Promise((resolve, reject) => {
    const asked = ask(open.transaction(kStore, mode).objectStore(kStore));
    asked.onsuccess = () => resolve(asked.result);
    asked.onerror = () => reject(asked.error);
  }).finally(() => open.close()) as Promise<T>;
}

export async function keep(kept: Kept): Promise<boolean> {
  try {
    await request('readwrite', (store) => store.put(kept, kKey));
    return true;
  } catch {
    return false;
  }
}

export async function kept(): Promise<Kept | undefined> {
  try {
    return (await request('readonly', (store) => store.get(kKey))) as Kept | undefined;
  } catch {
    return undefined;
  }
}
