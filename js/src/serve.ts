// What runs in a worker: it does what it is asked, one after the other.
import { badInput, MinksumError } from "./errors.js";
import type { WasmSource } from "./load.js";
import type { Minksum, NoFitTable } from "./minksum.js";
import type { Options, Progress } from "./types.js";
import type { Answer, Question } from "./worker.js";

/** Returns a function that answers questions by `reply`. */
export function serve(
  loadLibrary: (wasm: WasmSource | undefined) => Promise<Minksum>,
  reply: (answer: Answer) => void,
): (question: Question) => void {
  let library: Promise<Minksum> | undefined;
  const tables = new Map<number, NoFitTable>();
  const answer = async (question: Question): Promise<unknown> => {
    if (question.method === "load") {
      library = loadLibrary(question.args[0] as WasmSource | undefined);
      return (await library).version;
    }
    const mk = (await library) as any;
    if (question.method === "version?") return mk.version;
    const { id, method, args, table } = question;
    if (question.progress) {
      const options = args.pop() as Options;
      args.push({ ...options, progress: (progress: Progress) => reply({ id, progress }) });
    }
    if (method === "noFitTable") {
      const made = mk.noFitTable(...args) as NoFitTable;
      tables.set(table!, made);
      return { size: made.size, turns: made.turns };
    }
    if (method === "dispose") {
      tables.get(table!)?.dispose();
      tables.delete(table!);
      return undefined;
    }
    const object = table === undefined ? mk : tables.get(table);
    if (object === undefined) throw badInput("the table was disposed of");
    return object[method](...args);
  };
  return (question) => {
    answer(question).then(
      (value) => reply({ id: question.id, value }),
      (error: unknown) => reply({ id: question.id, error: describe(error) }),
    );
  };
}

function describe(error: unknown): NonNullable<Answer["error"]> {
  if (error instanceof MinksumError) {
    const { code, message, operand, polygon, ring, vertex, line, column, limit } = error;
    return { code, message, place: { operand, polygon, ring, vertex, line, column, limit } };
  }
  const name = error instanceof TypeError ? "TypeError" : "Error";
  return { name, message: error instanceof Error ? error.message : String(error) };
}
