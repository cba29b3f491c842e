// Exact numbers as text.
import type { Coordinate } from "./types.js";

/** Returns a number in digits that mean exactly its double. Strings stay as they are. */
export function exactText(value: Coordinate): string {
  if (typeof value === "string") return value;
  if (Number.isInteger(value)) return BigInt(value).toString();
  let denominator = 1n;
  while (!Number.isInteger(value)) {
    value *= 2;
    denominator *= 2n;
  }
  return `${BigInt(value)}/${denominator}`;
}
