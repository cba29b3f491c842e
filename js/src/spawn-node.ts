import { Worker } from "node:worker_threads";
import type { Channel } from "./worker.js";

/** Starts a thread. It does not keep the program running once nothing is asked. */
export function spawn(): Channel {
  const worker = new Worker(new URL("./worker-main-node.js", import.meta.url));
  worker.unref();
  return {
    send: (message) => worker.postMessage(message),
    listen: (hear, fail) => {
      worker.on("message", hear);
      worker.on("error", fail);
    },
    end: () => void worker.terminate(),
    hold: (busy) => (busy ? worker.ref() : worker.unref()),
  };
}
export function fromWorker(_worker: unknown): Channel {
  throw new TypeError("Node.js starts its own threads: leave `worker` out");
}
