/** The module in WebAssembly; scripts/pack.mjs writes it. */
export declare const wasmBase64: string;
