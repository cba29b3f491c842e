// Makes a library from the module in WebAssembly.
import { Library } from "./abi.js";
import { Minksum } from "./minksum.js";

/** Where the module in WebAssembly is: its address, its bytes, the answer to a request, or itself. */
export type WasmSource =
  | string
  | URL
  | ArrayBuffer
  | Uint8Array
  | Response
  | WebAssembly.Module
  | Promise<Response>;

async function compile(source: WasmSource): Promise<WebAssembly.Module> {
  const given = await source;
  if (given instanceof WebAssembly.Module) return given;
  if (typeof given === "string" || given instanceof URL) return compile(fetch(given));
  if (typeof Response !== "undefined" && given instanceof Response) {
    if (!given.ok) throw new Error(`${given.url} was not loaded: ${given.status}`);
    return WebAssembly.compile(await given.arrayBuffer());
  }
  return WebAssembly.compile(given as BufferSource);
}

export async function make(source: WasmSource): Promise<Minksum> {
  return new Minksum(await Library.instantiate(await compile(source)));
}
