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

/** The first four bytes of every module. */
const kWasm = 0x0061736d;

async function compile(source: WasmSource): Promise<WebAssembly.Module> {
  const given = await source;
  if (given instanceof WebAssembly.Module) return given;
  if (typeof given === "string" || given instanceof URL) return compile(fetch(given));
  if (typeof Response !== "undefined" && given instanceof Response) {
    if (!given.ok) throw new Error(`${given.url} was not loaded: ${given.status}`);
    const bytes = await given.arrayBuffer();
    // A server may answer with a page of its own, as that of Vite does.
    if (bytes.byteLength < 4 || new DataView(bytes).getUint32(0) !== kWasm) {
      throw new Error(
        `${given.url} is no module in WebAssembly. If Vite serves this page, its configuration ` +
          `needs optimizeDeps: { exclude: ["minksum"] }`,
      );
    }
    return WebAssembly.compile(bytes);
  }
  return WebAssembly.compile(given as BufferSource);
}

export async function make(source: WasmSource): Promise<Minksum> {
  return new Minksum(await Library.instantiate(await compile(source)));
}
