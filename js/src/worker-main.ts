// The script of a worker in a browser.
import { load } from "./index.js";
import { serve } from "./serve.js";
import type { Question } from "./worker.js";

const answer = serve((wasm) => load(wasm === undefined ? {} : { wasm }), (reply) => postMessage(reply));
onmessage = (event: MessageEvent<Question>) => answer(event.data);
