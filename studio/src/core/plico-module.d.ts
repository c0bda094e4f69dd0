// plico.mjs of the wasm build; the worker is the only one to know it.
declare module 'plico-module' {
  export default function createPlico(options?: { instantiateWasm?: (imports: WebAssembly.Imports, receive: (instance: WebAssembly.Instance) => void) => object; locateFile?: (path: string) => string }): Promise<any>;
}
