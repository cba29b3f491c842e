import type { Channel } from "./worker.js";

/** Starts a worker. */
export function spawn(): Channel {
  const worker = new Worker(new URL("./worker-main.js", import.meta.url), { type: "module" });
  return fromWorker(worker);
}
/** Speaks with a worker of the browser. */
export function fromWorker(worker: Worker): Channel {
  return {
    send: (message) => worker.postMessage(message),
    listen: (hear, fail) => {
      worker.onmessage = (event) => hear(event.data);
      worker.onerror = (event) => fail(new Error(event.message || "the worker did not start"));
    },
    end: () => worker.terminate(),
  };
}
