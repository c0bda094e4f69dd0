// plico.mjs of the wasm build; the worker is the only one to know it.
declare module 'plico-module' {
  export default function createPlico(options?: { wasmBinary?: ArrayBuffer; locateFile?: (path: string) => string }): Promise<any>;
}
