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

/** What the library reads as a number. */
const kNumber = /^([-+]?)(?:(\d+)\/(0*[1-9]\d*)|(?=\.?\d)(\d*)\.?(\d*)(?:[eE]([-+]?\d+))?)$/;
/** The largest exponent that it reads. */
const kExponent = 4096;

export function isExact(text: string): boolean {
  const read = kNumber.exec(text);
  return read !== null && Math.abs(Number(read[6] ?? 0)) <= kExponent;
}
function fraction(text: string): [bigint, bigint] {
  const [, sign, numerator, denominator, whole, digits = "", exponent = 0] = kNumber.exec(text)!;
  const shift = Number(exponent) - digits.length;
  const power = 10n ** BigInt(Math.abs(shift));
  const value = BigInt(numerator ?? whole! + digits) * (shift > 0 ? power : 1n);
  return [sign === "-" ? -value : value, BigInt(denominator ?? 1) * (shift < 0 ? power : 1n)];
}
/** Says whether two numbers are the same, such as "0.5" and "1/2". */
export function equal(a: Coordinate, b: Coordinate): boolean {
  if (a === b) return true;
  if (typeof a === "number" && typeof b === "number") return false;
  const [p, q] = fraction(exactText(a));
  const [r, s] = fraction(exactText(b));
  return p * s === r * q;
}
