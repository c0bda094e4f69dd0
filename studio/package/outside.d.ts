// What index.js takes from elsewhere.
declare module '*/plico.mjs' {
  export default function createModule(options: object): Promise<any>;
}
declare module 'node:fs/promises' {
  export function readFile(path: URL): Promise<Uint8Array>;
}
