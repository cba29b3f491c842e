// The module in WebAssembly: its functions, its memory, and the structs of the C interface there,
// whose layout wasm/layout.cpp holds.
import { badInput, MinksumError, type ErrorCode } from "./errors.js";
import { progressStages, type Progress } from "./types.js";

type ProgressListener = (progress: Progress) => boolean | void;
/** An address in the module's memory; 0 is none. */
export type Address = number;
type Call = (...args: number[]) => number;
export type Functions = Record<string, Call>;

const kError = 600;
const kOptions = 40;
/** Room for every struct and pointer that a call fills. */
const kResults = 256;
const kNone = 0xffffffff;
const kCodes: ErrorCode[] = ["bad-input", "limit", "cancelled", "internal"];
/** Input up to this size goes into memory that is kept. */
const kKept = 1 << 20;

/** What the module imports: little, as it uses neither files nor the network. */
function imports(
  memory: () => WebAssembly.Memory, tell: (stage: number, done: number, parts: number) => number,
): WebAssembly.Imports {
  const view = () => new DataView(memory().buffer);
  return {
    env: {
      emscripten_notify_memory_growth: () => {},
      __call_sighandler: () => {},
      minksum_progress: tell,
    },
    wasi_snapshot_preview1: {
      clock_time_get: (_clock: number, _precision: bigint, out: Address) => {
        view().setBigUint64(out, BigInt(Math.round(performance.now() * 1e6)), true);
        return 0;
      },
      environ_get: () => 0,
      environ_sizes_get: (count: Address, size: Address) => {
        view().setUint32(count, 0, true);
        view().setUint32(size, 0, true);
        return 0;
      },
      fd_close: () => 8,
      fd_read: () => 8,
      fd_seek: () => 8,
      fd_write: () => 8,
      proc_exit: (code: number) => {
        throw new MinksumError("internal", `the library ended itself with ${code}`);
      },
    },
  };
}

export class Library {
  readonly call: Functions;
  /** where a call leaves its error */
  readonly error: Address;
  /** where a call leaves its results */
  readonly results: Address;
  private readonly options: Address;
  private readonly memory: WebAssembly.Memory;
  private reals: Float64Array;
  private words: Uint32Array;
  private octets: Uint8Array;
  private kept: Address;
  private listener: ProgressListener | undefined;
  /** what a listener has thrown */
  private thrown: { error: unknown } | undefined;
  /** whether a listener runs */
  telling = false;

  private constructor(instance: WebAssembly.Instance) {
    this.memory = instance.exports["memory"] as WebAssembly.Memory;
    this.call = instance.exports as unknown as Functions;
    this.call["_initialize"]?.();
    this.reals = new Float64Array(this.memory.buffer);
    this.words = new Uint32Array(this.memory.buffer);
    this.octets = new Uint8Array(this.memory.buffer);
    this.error = this.allocate(kError + kResults + kOptions);
    this.results = this.error + kError;
    this.options = this.results + kResults;
    this.kept = this.allocate(kKept);
  }
  static async instantiate(module: WebAssembly.Module): Promise<Library> {
    if (!WebAssembly.Module.exports(module).some(({ name }) => name === "minksum_version")) {
      throw badInput("`wasm` is a module in WebAssembly, but not minksum.wasm");
    }
    let instance: WebAssembly.Instance | undefined;
    let library: Library | undefined;
    const given = imports(
      () => instance!.exports["memory"] as WebAssembly.Memory,
      (stage, done, parts) => library!.tell(stage, done, parts),
    );
    instance = await WebAssembly.instantiate(module, given);
    library = new Library(instance);
    return library;
  }
  /** Tells the listener of progress. Returns 0 if the operation shall go on. */
  private tell(stage: number, done: number, parts: number): number {
    const { listener, telling, error: structs } = this;
    const kept = this.u8.slice(structs, structs + kError + kResults + kOptions);
    this.telling = true;
    try {
      return listener?.({ stage: progressStages[stage]!, done, parts }) === false ? 1 : 0;
    } catch (error) {
      // It must not pass through the library, which would not clear up behind itself.
      this.thrown = { error };
      return 1;
    } finally {
      // It may have called the library, and the operation goes on with its own structs.
      this.listener = listener;
      this.telling = telling;
      this.u8.set(kept, structs);
    }
  }

  // -- Memory. Its arrays are new whenever it has grown. ------------------------------------------
  private look(): void {
    if (this.octets.length !== 0) return; // growing takes the old ones their memory
    this.reals = new Float64Array(this.memory.buffer);
    this.words = new Uint32Array(this.memory.buffer);
    this.octets = new Uint8Array(this.memory.buffer);
  }
  get f64(): Float64Array {
    this.look();
    return this.reals;
  }
  get u32(): Uint32Array {
    this.look();
    return this.words;
  }
  get u8(): Uint8Array {
    this.look();
    return this.octets;
  }
  /** Returns a copy of doubles. Exact numbers beyond their range are not among them. */
  doubles(from: Address, count: number, what = "a coordinate"): Float64Array {
    const list = this.f64.slice(from / 8, from / 8 + count);
    for (let i = 0; i < count; ++i) {
      if (!Number.isFinite(list[i])) {
        const message = `${what} is beyond the range of doubles`;
        throw new MinksumError("limit", message, { limit: "doubles" });
      }
    }
    return list;
  }
  get bytes(): number {
    return this.memory.buffer.byteLength;
  }
  allocate(bytes: number): Address {
    const address = bytes < 2 ** 31 ? this.call["malloc"]!(bytes || 1) >>> 0 : 0;
    if (address === 0) throw new MinksumError("limit", "out of memory", { limit: "memory" });
    return address;
  }
  /** Gives `work` room for input that is only read during the call. Calls do not nest. */
  withRoom<T>(bytes: number, work: (address: Address) => T): T {
    if (bytes <= kKept && this.kept !== 0) {
      const address = this.kept;
      this.kept = 0;
      try {
        return work(address);
      } finally {
        this.kept = address;
      }
    }
    const address = this.allocate(bytes);
    try {
      return work(address);
    } finally {
      this.call["free"]!(address);
    }
  }
  text(address: Address, length?: number): string {
    const { u8 } = this;
    const end = length === undefined ? u8.indexOf(0, address) : address + length;
    return new TextDecoder().decode(u8.subarray(address, end));
  }

  // -- Errors ------------------------------------------------------------------------------------
  /** Throws the error of a call unless its status is 0. `operand` names what the call read. */
  check(status: number, operand?: number): void {
    if (status === 0) return;
    const { thrown } = this;
    this.thrown = undefined;
    throw thrown !== undefined ? thrown.error : this.errorAt(this.error, operand);
  }
  errorAt(address: Address, operand?: number): MinksumError {
    const word = (offset: number) => this.u32[(address + offset) >>> 2]!;
    const index = (offset: number) => (word(offset) === kNone ? undefined : word(offset));
    const limit = this.text(address + 28);
    return new MinksumError(kCodes[word(0) - 1] ?? "internal", this.text(address + 88), {
      operand: operand ?? (word(4) === kNone ? undefined : word(4)),
      polygon: index(8),
      ring: index(12),
      vertex: index(16),
      line: word(20) || undefined,
      column: word(24) || undefined,
      limit: limit || undefined,
    });
  }

  // -- Structs ------------------------------------------------------------------------------------
  /** Writes the options that all operations share, and returns where they are. */
  writeOptions(options: {
    fill: number;
    regularize: boolean;
    tight: boolean | undefined;
    maxSegments: number;
    maxCrossings: number;
    progress: ProgressListener | undefined;
  }): Address {
    this.listener = options.progress;
    const at = this.options >>> 2;
    const { u32 } = this;
    const limit = (where: number, value: number) => {
      u32[where] = value >>> 0;
      u32[where + 1] = Math.floor(value / 2 ** 32);
    };
    limit(at, options.maxSegments);
    limit(at + 2, options.maxCrossings);
    u32[at + 4] = options.fill;
    u32[at + 5] = options.regularize ? 1 : 0;
    u32[at + 6] = options.tight === undefined ? kNone : options.tight ? 1 : 0;
    u32[at + 7] = 1;
    u32[at + 8] = options.progress ? this.call["minksum_progress_address"]!() : 0;
    u32[at + 9] = 0;
    return this.options;
  }
}
