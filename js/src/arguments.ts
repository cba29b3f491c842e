// Arguments of operations: each is what it must be, or is refused by its name. WebAssembly would
// take almost anything for a number.
import { badInput } from "./errors.js";
import type { Configuration } from "./types.js";

export const kFills = [
  "automatic", "evenodd", "nonzero", "positive", "negative", "strict",
] as const;
export const kSides = ["nearest", "outside", "inside"] as const;
export const kJoins = ["round", "miter", "square", "bevel"] as const;
export const kCaps = ["round", "butt", "square"] as const;

type Check = (value: unknown, name: string) => unknown;

/** Returns what an error says about a value. */
export function shown(value: unknown): string {
  if (typeof value === "string") return JSON.stringify(value);
  if (typeof value === "bigint") return `${value}n`;
  if (typeof value === "function") return "a function";
  if (typeof value !== "object" || value === null) return String(value);
  return Array.isArray(value) ? "an array" : "an object";
}
function refuse(value: unknown, name: string, wanted: string): never {
  throw badInput(`\`${name}\` is ${shown(value)}, and ${wanted}`);
}
/** Returns the index of a name. */
export function oneOf(names: readonly string[], value: unknown, name: string): number {
  const index = names.indexOf(value as string);
  return index < 0 ? refuse(value, name, `none of ${names.join(", ")}`) : index;
}
export function finite(value: unknown, name: string): number {
  return Number.isFinite(value) ? (value as number) : refuse(value, name, "no finite number");
}
export function integer(value: unknown, name: string, from: number, to: number): number {
  const good = Number.isInteger(value) && (value as number) >= from && (value as number) <= to;
  return good ? (value as number) : refuse(value, name, `no integer from ${from} to ${to}`);
}
/** Says whether something is an array, or like one. Text is not. */
export function isList(list: unknown): list is ArrayLike<unknown> {
  if (typeof list !== "object" || list === null) return false;
  const { length } = list as ArrayLike<unknown>;
  return Number.isSafeInteger(length) && length >= 0;
}
/** Returns a list of finite numbers: so many, if that is given. */
export function numbers(list: unknown, name: string, count?: number): ArrayLike<number> {
  if (!isList(list)) return refuse(list, name, "no list of numbers");
  if (count !== undefined && list.length !== count) {
    throw badInput(`\`${name}\` has the length ${list.length}, and must have ${count} numbers`);
  }
  for (let i = 0; i < list.length; ++i) {
    if (!Number.isFinite(list[i])) finite(list[i], `${name}[${i}]`);
  }
  return list as ArrayLike<number>;
}
/** Returns a list in which x and y of points follow each other. */
export function pointList(list: unknown, name: string): ArrayLike<number> {
  const xy = numbers(list, name);
  if (xy.length % 2 !== 0) throw badInput(`\`${name}\` has an odd length: an x has no y`);
  return xy;
}
/** Returns x, y and degrees. */
export function configuration(value: Configuration, name: string): number[] {
  return (["x", "y", "degrees"] as const).map((part) => finite(value?.[part], `${name}.${part}`));
}

const choice = (...names: readonly string[]): Check => (value, name) => oneOf(names, value, name);
const range = (from: number, to: number): Check => (value, name) => integer(value, name, from, to);
const pair: Check = (value, name) => numbers(value, name, 2);
const flag: Check = (value, name) =>
  typeof value === "boolean" || refuse(value, name, "neither true nor false");
const listener: Check = (value, name) =>
  typeof value === "function" || refuse(value, name, "no function");
const limit = range(1, Number.MAX_SAFE_INTEGER);

const kOptions = new Map<string, Check>(Object.entries({
  z: choice("error", "drop"),
  curveTolerance: finite,
  curveSide: choice(...kSides),
  joinEnds: finite,
  as: choice("geojson", "flat", "wkt", "svg"),
  coords: choice("double", "exact"),
  fill: choice(...kFills),
  regularize: flag,
  tight: flag,
  maxSegments: limit,
  maxCrossings: limit,
  progress: listener,
  join: choice(...kJoins),
  cap: choice(...kCaps),
  side: choice(...kSides),
  miterLimit: finite,
  tolerance: finite,
  reference: pair,
  turns: range(1, 4),
  fixedTurn: range(0, 3),
  movingTurn: range(0, 3),
  decimals: range(0, 4096), // as kMaxDecimals in minksum/round.hpp
  within: finite,
  workspace: () => true, // an operand, which is checked as such
  free: flag,
  angles: range(1, 2 ** 31 - 1),
  certain: flag,
  most: range(0, 1e6), // each takes 600 bytes of the module's memory, which ends at 4 GB
}));

/** Refuses members of an object that have none of the names. */
export function checkNames(
  given: unknown, has: (name: string) => boolean, kind = "option", place = {},
): void {
  if (typeof given !== "object" || given === null || Array.isArray(given)) {
    refuse(given, "options", "no object");
  }
  for (const name in given) {
    if (!has(name) && (given as Record<string, unknown>)[name] !== undefined) {
      throw badInput(`there is no ${kind} \`${name}\``, place);
    }
  }
}
/** Refuses options that are none. An operation may get options that only others use. */
export function checkOptions(options: unknown): void {
  checkNames(options, (name) => kOptions.has(name));
  for (const name in options as object) {
    const value = (options as Record<string, unknown>)[name];
    if (value !== undefined) kOptions.get(name)!(value, name);
  }
}
