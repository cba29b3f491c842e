// Speaks with the worker. Of the sums that are asked for while it computes only the last is done.
import type { Answer, Failure, Job, ReadAnswer, RunAnswer, RunJob, Told } from "./jobs.js";

/** Both are made by the scripts beside this one: the worker's code, and the library. */
declare const minksumWorker: () => void;
declare const minksumWasm: string;

interface Task {
  job: Job;
  resolve(answer: Answer): void;
}

export class Engine {
  private worker!: Worker;
  private running: Task | undefined;
  private readonly waiting: Task[] = [];
  private next: RunJob | undefined;
  private module: Promise<WebAssembly.Module>;
  /** when the running job was sent */
  private since = 0;
  /** how far the running job is, as far as it has told */
  progress: Told | undefined;

  constructor(private readonly answered: (answer: RunAnswer | Failure, roundTrip: number) => void) {
    this.module = this.compile();
    this.start();
  }
  /** whether something is being computed, and for how many milliseconds */
  get busyFor(): number {
    return this.running ? performance.now() - this.since : 0;
  }
  private async compile(): Promise<WebAssembly.Module> {
    return WebAssembly.compile(Uint8Array.from(atob(minksumWasm), (c) => c.charCodeAt(0)));
  }
  private start(): void {
    // A worker of a text can be started from a folder as well as from a server.
    const code = new Blob([`(${minksumWorker})()`], { type: "text/javascript" });
    const address = URL.createObjectURL(code);
    const worker = new Worker(address);
    URL.revokeObjectURL(address);
    this.worker = worker;
    worker.onmessage = ({ data }: MessageEvent<Answer | Told>) => {
      if (data.kind === "progress") this.progress = data;
      else this.finish(data);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      this.restart(event.message || "The worker ended. There may be too little memory.");
    };
    const job = this.module.then((wasm): Job => ({ kind: "start", wasm }));
    this.since = performance.now();
    this.running = {
      job: { kind: "read", text: "", tolerance: 0 },
      resolve: (answer) => {
        if (answer.kind === "failure") this.answered(answer, 0);
      },
    };
    job.then((message) => worker === this.worker && worker.postMessage(message));
  }

  /** Asks for an operation. Its answer goes to `answered`, unless another is asked for before. */
  run(job: RunJob): void {
    this.next = job;
    this.go();
  }
  /** Reads a text. */
  read(text: string, tolerance: number): Promise<ReadAnswer | Failure> {
    return new Promise((resolve) => {
      const job: Job = { kind: "read", text, tolerance };
      this.waiting.push({ job, resolve: (answer) => resolve(answer as ReadAnswer | Failure) });
      this.go();
    });
  }
  /** Ends what is being computed. */
  cancel(): void {
    if (this.running) this.restart("Stopped. Change something, or compute again.", "cancelled");
  }
  private restart(message: string, code = "internal"): void {
    const ended = this.running;
    this.worker.terminate();
    this.next = undefined;
    this.progress = undefined;
    this.start();
    ended?.resolve({ kind: "failure", message, code });
    this.answered({ kind: "failure", message, code }, 0);
  }
  private go(): void {
    if (this.running) return;
    let task = this.waiting.shift();
    if (task === undefined && this.next !== undefined) {
      const job = this.next;
      this.next = undefined;
      const resolve = (answer: Answer) => {
        if (answer.kind === "run" || (answer.kind === "failure" && answer.code !== "cancelled")) {
          this.answered(answer, performance.now() - this.since);
        }
      };
      task = { job, resolve };
    }
    if (task === undefined) return;
    this.running = task;
    this.since = performance.now();
    this.worker.postMessage(task.job);
  }
  private finish(answer: Answer): void {
    const { running } = this;
    this.running = undefined;
    this.progress = undefined;
    running?.resolve(answer);
    this.go();
  }
}
