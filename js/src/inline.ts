/**
 * The same as `minksum`, with the module in WebAssembly inside of the script: for pages that cannot
 * load a second file.
 *
 * @packageDocumentation
 */
import { checkNames } from "./arguments.js";
import { make } from "./load.js";
import type { Minksum } from "./minksum.js";
import { wasmBase64 } from "./wasm-base64.js";

export { MinksumError, type ErrorCode, type ErrorPlace } from "./errors.js";
export { Minksum, NoFitTable } from "./minksum.js";
export * from "./types.js";

/** Returns the bytes of the module in WebAssembly, for `load` in a worker. */
export function wasmBytes(): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(wasmBase64), (c) => c.charCodeAt(0));
}
/** Loads the library. Its functions then need no promises. There are no options. */
export async function load(options: { [name: string]: never } = {}): Promise<Minksum> {
  checkNames(options, () => false);
  return make(wasmBytes());
}
