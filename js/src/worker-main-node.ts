// The script of a thread in Node.js.
import { parentPort } from "node:worker_threads";
import { load } from "./index.js";
import { serve } from "./serve.js";

const answer = serve((wasm) => load(wasm === undefined ? {} : { wasm }), (reply) =>
  parentPort!.postMessage(reply),
);
parentPort!.on("message", answer);
