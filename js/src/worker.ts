/**
 * The same operations as `minksum`, in a worker: each returns a promise, and an `AbortSignal` stops
 * it.
 *
 * @packageDocumentation
 */
import { fromWorker, spawn } from "#spawn";
import { checkNames } from "./arguments.js";
import { badInput, MinksumError, type ErrorCode, type ErrorPlace } from "./errors.js";
import type {
  CheckOptions, Configuration, Contact, Depth, Fault, Location, NumberOf, OffsetOptions, Operand,
  Options, Progress, ReachOf, ReachOptions, ReferenceOptions, ResultOf, RoundOptions, Side, Slice,
  SliceOptions, SumCheck, TableOptions, Trace, Turned,
} from "./types.js";

export { MinksumError, type ErrorCode, type ErrorPlace } from "./errors.js";
export type { WasmSource } from "./load.js";
export * from "./types.js";

/** Asks a worker. */
export interface Question {
  id: number;
  method: string;
  args: unknown[];
  table?: number | undefined;
  /** whether progress shall be told */
  progress?: boolean | undefined;
}
/** What a worker answers. */
export interface Answer {
  id: number;
  value?: unknown;
  /** told while the operation goes on */
  progress?: Progress;
  error?: { code?: ErrorCode; name?: string; message: string; place?: ErrorPlace };
}
/** A worker with which one can speak. */
export interface Channel {
  send(message: Question): void;
  listen(hear: (answer: Answer) => void, fail: (error: Error) => void): void;
  end(): void;
  /** says whether something is asked */
  hold?(busy: boolean): void;
}

/** Stops an operation. The worker ends, and another one takes its place. */
export interface Abortable {
  signal?: AbortSignal;
}
/** Says how the worker is started. */
export interface WorkerOptions {
  /** where `minksum.wasm` is; beside the package's files by default. It must be what a worker can
   * be sent: an address that `fetch` loads, bytes, or a compiled module. */
  wasm?: string | URL | ArrayBuffer | Uint8Array | WebAssembly.Module;
  /** starts a worker that runs the script `minksum/worker`'s way; only in browsers */
  worker?: () => Worker;
}

interface Pending extends Question {
  heard: Options["progress"];
  resolve(value: any): void;
  reject(error: unknown): void;
}

/** A table of no-fit polygons in a worker. */
export class NoFitTableInWorker {
  /** @internal */
  constructor(
    private readonly ask: (method: string, args: unknown[]) => Promise<any>,
    readonly size: number,
    readonly turns: number,
  ) {}
  /** Returns the no-fit polygon of two parts, each turned by so many of the table's turns. */
  at<O extends Options & Turned & Abortable = {}>(
    fixed: number, moving: number, options: O = {} as O,
  ): Promise<ResultOf<O>> {
    return this.ask("at", [fixed, moving, options]);
  }
  /** Tells how two parts stand to each other when `moving` is placed at each of the points. */
  contact(
    fixed: number, moving: number, points: ArrayLike<number>, options: Turned & Abortable = {},
  ): Promise<Contact[]> {
    return this.ask("contact", [fixed, moving, points, options]);
  }
  /** Gives the worker's memory back. */
  async dispose(): Promise<void> {
    await this.ask("dispose", []);
  }
}

/** Options that can have a signal. */
export type Plain<O> = O & Abortable;
/** What an operation promises. */
export type Made<O> = Promise<ResultOf<O>>;

/** The library in a worker. Each method does what that of `Minksum` does, with copies of its
 * arguments. */
export class MinksumWorker {
  private channel: Channel;
  private readonly pending = new Map<number, Pending>();
  private readonly tables = new Map<number, Question>();
  private next = 1;
  private started = false;
  private closed = false;

  private constructor(
    private readonly start: () => Channel,
    private readonly wasm: WorkerOptions["wasm"],
  ) {
    this.channel = this.open();
  }
  /** @internal */
  static async create(start: () => Channel, wasm: WorkerOptions["wasm"]): Promise<MinksumWorker> {
    const made = new MinksumWorker(start, wasm);
    await made.ask("version?", []);
    return made;
  }

  minkowskiSum<O extends Plain<Options> = {}>(a: Operand, b: Operand, options?: O): Made<O> {
    return this.ask("minkowskiSum", [a, b, options]);
  }
  dilate<O extends Plain<Options> = {}>(a: Operand, b: Operand, options?: O): Made<O> {
    return this.ask("dilate", [a, b, options]);
  }
  erode<O extends Plain<Options> = {}>(a: Operand, b: Operand, options?: O): Made<O> {
    return this.ask("erode", [a, b, options]);
  }
  opening<O extends Plain<Options> = {}>(a: Operand, b: Operand, options?: O): Made<O> {
    return this.ask("opening", [a, b, options]);
  }
  closing<O extends Plain<Options> = {}>(a: Operand, b: Operand, options?: O): Made<O> {
    return this.ask("closing", [a, b, options]);
  }
  offset<O extends Plain<OffsetOptions> = {}>(a: Operand, distance: number, options?: O): Made<O> {
    return this.ask("offset", [a, distance, options]);
  }
  disc<O extends Plain<Options & { side?: Side }> = {}>(
    radius: number, tolerance: number, options?: O,
  ): Made<O> {
    return this.ask("disc", [radius, tolerance, options]);
  }
  noFitPolygon<O extends Plain<ReferenceOptions> = {}>(
    fixed: Operand, moving: Operand, options?: O,
  ): Made<O> {
    return this.ask("noFitPolygon", [fixed, moving, options]);
  }
  innerFitPolygon<O extends Plain<ReferenceOptions> = {}>(
    bin: Operand, part: Operand, options?: O,
  ): Made<O> {
    return this.ask("innerFitPolygon", [bin, part, options]);
  }
  contact(
    fixed: Operand, moving: Operand, points: ArrayLike<number>, options?: Plain<ReferenceOptions>,
  ): Promise<Contact[]> {
    return this.ask("contact", [fixed, moving, points, options]);
  }
  penetrationDepth(a: Operand, b: Operand, options?: Plain<Options>): Promise<Depth | null> {
    return this.ask("penetrationDepth", [a, b, options]);
  }
  timeOfImpact<O extends Plain<Options> = {}>(
    a: Operand, b: Operand, direction: [number, number], options?: O,
  ): Promise<NumberOf<O> | null> {
    return this.ask("timeOfImpact", [a, b, direction, options]);
  }
  slices<O extends Plain<SliceOptions> = {}>(
    robot: Operand, obstacles: Operand, angles: ArrayLike<number>, options?: O,
  ): Promise<Slice<ResultOf<O>>[]> {
    return this.ask("slices", [robot, obstacles, angles, options]);
  }
  reach<O extends Plain<ReachOptions> = {}>(
    robot: Operand, obstacles: Operand, from: Configuration, to: Configuration, options?: O,
  ): Promise<ReachOf<O>> {
    return this.ask("reach", [robot, obstacles, from, to, options]);
  }
  union<O extends Plain<Options> = {}>(a: Operand, b: Operand, options?: O): Made<O> {
    return this.ask("union", [a, b, options]);
  }
  intersection<O extends Plain<Options> = {}>(a: Operand, b: Operand, options?: O): Made<O> {
    return this.ask("intersection", [a, b, options]);
  }
  difference<O extends Plain<Options> = {}>(a: Operand, b: Operand, options?: O): Made<O> {
    return this.ask("difference", [a, b, options]);
  }
  symmetricDifference<O extends Plain<Options> = {}>(a: Operand, b: Operand, options?: O): Made<O> {
    return this.ask("symmetricDifference", [a, b, options]);
  }
  resolve<O extends Plain<Options> = {}>(a: Operand, options?: O): Made<O> {
    return this.ask("resolve", [a, options]);
  }
  rounded<O extends Plain<RoundOptions> = {}>(a: Operand, options?: O): Made<O> {
    return this.ask("rounded", [a, options]);
  }
  transform<O extends Plain<Options> = {}>(a: Operand, m: ArrayLike<number>, options?: O): Made<O> {
    return this.ask("transform", [a, m, options]);
  }
  convert<O extends Plain<Options> = {}>(a: Operand, options?: O): Made<O> {
    return this.ask("convert", [a, options]);
  }
  toSvg(a: Operand, options?: Plain<Options>): Promise<string> {
    return this.ask("toSvg", [a, options]);
  }
  area(a: Operand, options?: Plain<Options>): Promise<number> {
    return this.ask("area", [a, options]);
  }
  bounds(a: Operand, options?: Plain<Options>): Promise<[number, number, number, number] | null> {
    return this.ask("bounds", [a, options]);
  }
  locate(a: Operand, points: ArrayLike<number>, options?: Plain<Options>): Promise<Location[]> {
    return this.ask("locate", [a, points, options]);
  }
  validate(a: Operand, options?: Plain<Options & { most?: number }>): Promise<Fault[]> {
    return this.ask("validate", [a, options]);
  }
  checkSum(
    result: Operand, a: Operand, b: Operand, options?: Plain<CheckOptions>,
  ): Promise<SumCheck> {
    return this.ask("checkSum", [result, a, b, options]);
  }
  trace<O extends Plain<Options> = {}>(
    a: Operand, b: Operand, options?: O,
  ): Promise<Trace<ResultOf<O>>> {
    return this.ask("trace", [a, b, options]);
  }
  async noFitTable(parts: Operand[], options?: Plain<TableOptions>): Promise<NoFitTableInWorker> {
    const table = this.next;
    const asked = this.ask("noFitTable", [parts, options], table);
    const args = this.pending.get(table)?.args ?? [];
    const { size, turns } = await asked;
    this.tables.set(table, { id: 0, method: "noFitTable", args, table });
    const ask = async (method: string, args: unknown[]) => {
      const answer = await this.ask(method, args, table);
      if (method === "dispose") this.tables.delete(table);
      return answer;
    };
    return new NoFitTableInWorker(ask, size, turns);
  }
  /** Ends the worker. What is not done yet is cancelled. */
  close(): void {
    this.closed = true;
    this.channel.end();
    this.fail(new MinksumError("cancelled", "the worker was closed"));
  }

  // -- The worker ----------------------------------------------------------------------------------
  private ask(method: string, args: unknown[], table?: number): Promise<any> {
    if (this.closed) return Promise.reject(new MinksumError("cancelled", "the worker was closed"));
    const last = args[args.length - 1] as Plain<Options> | undefined;
    const signal = last?.signal;
    if (signal !== undefined && !(signal instanceof AbortSignal)) {
      return Promise.reject(badInput("`signal` is no AbortSignal: give controller.signal"));
    }
    if (signal?.aborted) return Promise.reject(signal.reason);
    const heard = typeof last?.progress === "function" ? last.progress : undefined;
    const strip = signal !== undefined || heard !== undefined;
    const rest = strip ? { ...last, signal: undefined, progress: undefined } : last;
    // Another worker may have to do it, and what the caller owns may have changed by then.
    let kept: unknown[];
    try {
      kept = structuredClone([...args.slice(0, -1), rest]);
    } catch (error) {
      return Promise.reject(badInput(`an argument cannot be sent to a worker: ${String(error)}`));
    }
    const id = this.next++;
    const question: Question = { id, method, args: kept, table, progress: !!heard };
    return new Promise((resolve, reject) => {
      const abort = () => this.abort(id, signal!.reason);
      signal?.addEventListener("abort", abort, { once: true });
      const done = () => signal?.removeEventListener("abort", abort);
      this.pending.set(id, {
        ...question, heard,
        resolve: (value) => (done(), resolve(value)),
        reject: (error) => (done(), reject(error)),
      });
      this.send(question);
    });
  }
  private send({ id, method, args, table, progress }: Question): void {
    this.channel.hold?.(true);
    try {
      this.channel.send({ id, method, args, table, progress });
    } catch (error) {
      this.settle(id)?.reject(error);
    }
  }
  private open(): Channel {
    const channel = this.start();
    channel.listen(
      (answer) => this.hear(answer),
      (error) => {
        if (channel === this.channel) this.restart(error);
      },
    );
    channel.send({ id: 0, method: "load", args: [this.wasm] });
    return channel;
  }
  private settle(id: number): Pending | undefined {
    const asked = this.pending.get(id);
    this.pending.delete(id);
    if (this.pending.size === 0) this.channel.hold?.(false);
    return asked;
  }
  private hear({ id, value, error, progress }: Answer): void {
    if (id === 0) {
      this.started ||= error === undefined;
      if (error !== undefined) this.fail(toError(error));
      return;
    }
    if (progress !== undefined) {
      this.tell(id, progress);
      return;
    }
    const asked = this.settle(id);
    if (error === undefined) asked?.resolve(value);
    else asked?.reject(toError(error));
  }
  private tell(id: number, progress: Progress): void {
    try {
      const goOn = this.pending.get(id)?.heard?.(progress);
      if (goOn === false) this.abort(id, new MinksumError("cancelled", "`progress` asked to stop"));
    } catch (error) {
      this.abort(id, error);
    }
  }
  /** The worker cannot be stopped but by its end. Another one does what else was asked. */
  private abort(id: number, reason: unknown): void {
    const asked = this.settle(id);
    if (asked === undefined) return;
    asked.reject(reason);
    this.replace();
  }
  /** The worker died: what it was asked fails, and another one takes its place. */
  private restart(error: Error): void {
    this.closed ||= !this.started; // another one would not start either
    this.fail(error);
    if (this.closed) this.channel.end();
    else this.replace();
  }
  private replace(): void {
    this.channel.end();
    try {
      this.channel = this.open();
      for (const table of this.tables.values()) this.channel.send(table);
    } catch (error) {
      this.closed = true;
      this.fail(error as Error);
    }
    for (const asked of [...this.pending.values()]) this.send(asked);
  }
  private fail(error: Error): void {
    for (const asked of [...this.pending.values()]) this.settle(asked.id)?.reject(error);
  }
}

function toError(told: NonNullable<Answer["error"]>): Error {
  if (told.code !== undefined) return new MinksumError(told.code, told.message, told.place);
  return told.name === "TypeError" ? new TypeError(told.message) : new Error(told.message);
}

/** Starts a worker and loads the library there. */
export async function load(options: WorkerOptions = {}): Promise<MinksumWorker> {
  checkNames(options, (name) => name === "worker" || name === "wasm");
  const { worker, wasm } = options;
  const given = wasm instanceof URL ? wasm.href : wasm;
  return MinksumWorker.create(worker ? () => fromWorker(worker()) : spawn, given);
}
