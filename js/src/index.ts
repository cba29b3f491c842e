/**
 * Exact Minkowski sums of planar regions, and what is made of them.
 *
 * @packageDocumentation
 */
import { packagedWasm } from "#wasm";
import { checkNames } from "./arguments.js";
import { make, type WasmSource } from "./load.js";
import type { Minksum } from "./minksum.js";

export { MinksumError, type ErrorCode, type ErrorPlace } from "./errors.js";
export type { WasmSource } from "./load.js";
export { Minksum, NoFitTable } from "./minksum.js";
export * from "./types.js";

/** Says how the library is loaded. */
export interface LoadOptions {
  /** where `minksum.wasm` is; beside this file by default. An address is one that `fetch` loads:
   * in Node.js, read files and give their bytes. */
  wasm?: WasmSource;
}

/** Loads the library. Its functions then need no promises. */
export async function load(options: LoadOptions = {}): Promise<Minksum> {
  checkNames(options, (name) => name === "wasm");
  return make(options.wasm ?? (await packagedWasm()));
}
