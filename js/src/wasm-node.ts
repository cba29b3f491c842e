import { readFile } from "node:fs/promises";
import type { WasmSource } from "./load.js";

/** Returns the module that lies beside this file. */
export async function packagedWasm(): Promise<WasmSource> {
  return readFile(new URL("./minksum.wasm", import.meta.url));
}
