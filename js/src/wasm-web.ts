import type { WasmSource } from "./load.js";

/** Returns the module that lies beside this file. */
export function packagedWasm(): WasmSource {
  return new URL("./minksum.wasm", import.meta.url);
}
