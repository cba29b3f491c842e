// Checks what callers give, which WebAssembly would change without a word.
import { badInput, MinksumError } from "./errors.js";

/** The options of all operations. */
const kOptions = new Set([
  "angles", "as", "cap", "certain", "coords", "curveSide", "curveTolerance", "decimals", "fill",
  "fixedTurn", "free", "join", "joinEnds", "maxCrossings", "maxSegments", "miterLimit", "most",
  "movingTurn", "progress", "reference", "regularize", "side", "signal", "tight", "tolerance",
  "turns", "within", "workspace", "z",
]);
/** The values of those that are not checked where they are used. */
const kFlag = [true, false];
const kValues: Record<string, readonly unknown[]> = {
  as: ["geojson", "flat", "wkt", "svg"],
  coords: ["double", "exact"],
  curveSide: ["nearest", "outside", "inside"],
  z: ["error", "drop"],
  certain: kFlag,
  free: kFlag,
  regularize: kFlag,
  tight: kFlag,
};

function shown(value: unknown): string {
  return typeof value === "number" || typeof value === "string" ? `${value}` : typeof value;
}

/** Refuses names and values that no operation knows. */
export function checkOptions(options: unknown): void {
  if (typeof options !== "object" || options === null) {
    throw badInput("options are no object");
  }
  for (const [name, value] of Object.entries(options)) {
    if (!kOptions.has(name)) throw badInput(`there is no option \`${name}\``);
    if (value === undefined) continue;
    const known = kValues[name];
    if (known?.includes(value) === false) {
      throw badInput(`\`${name}\` is ${shown(value)}, and none of ${known.join(", ")}`);
    }
    if (name === "progress" && typeof value !== "function") {
      throw badInput("`progress` is no function");
    }
  }
}

/** Returns a finite number. */
export function finite(value: unknown, name: string): number {
  if (typeof value === "number" && Number.isFinite(value)) return value;
  throw badInput(`\`${name}\` is no finite number, but ${shown(value)}`);
}

/** Returns an integer from 0 to `most`. */
export function count(value: unknown, name: string, most = 2 ** 31 - 1): number {
  if (Number.isInteger(value) && (value as number) >= 0 && (value as number) <= most) {
    return value as number;
  }
  throw badInput(`\`${name}\` is no integer from 0 to ${most}, but ${shown(value)}`);
}

/** Returns a list of finite numbers. */
export function numbers(list: unknown, name: string, length?: number): ArrayLike<number> {
  if (!Array.isArray(list) && !(ArrayBuffer.isView(list) && "length" in list)) {
    throw badInput(`\`${name}\` is no array of numbers`);
  }
  const given = list as ArrayLike<number>;
  if (length !== undefined && given.length !== length) {
    throw badInput(`\`${name}\` has ${given.length} numbers, and not ${length}`);
  }
  for (let i = 0; i < given.length; ++i) finite(given[i], `${name}[${i}]`);
  return given;
}

/** Returns a list of x and y. */
export function points(list: unknown): ArrayLike<number> {
  const given = numbers(list, "points");
  if (given.length % 2 !== 0) throw badInput("`points` ends with an x that has no y");
  return given;
}

/** Returns numbers of an answer, which doubles must be able to hold. */
export function inRange<T extends ArrayLike<number>>(answer: T): T {
  for (let i = 0; i < answer.length; ++i) {
    if (!Number.isFinite(answer[i])) {
      throw new MinksumError("limit", "a coordinate is beyond the range of doubles");
    }
  }
  return answer;
}
