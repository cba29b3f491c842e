// The script of a worker in a browser.
import { make } from "./load.js";
import { serve } from "./serve.js";
// Not "#wasm": a page without a bundler names that in an import map, which its workers do not see.
import { packagedWasm } from "./wasm-web.js";
import type { Question } from "./worker.js";

const answer = serve(async (wasm) => make(wasm ?? packagedWasm()), (reply) => postMessage(reply));
onmessage = (event: MessageEvent<Question>) => answer(event.data);
