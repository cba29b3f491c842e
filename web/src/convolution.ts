// The full convolution, for a picture: the library computes the reduced one alone.
import type { FlatResult } from "minksum";

export interface FullConvolution {
  /** both ends of each segment, x and y in turn */
  convex: number[];
  /** the segments of reflex vertices, which the reduced convolution leaves out */
  reflex: number[];
}
/** Above so many pairs of an edge and a vertex no picture is made. */
const kMostPairs = 2_000_000;

interface Corner {
  x: number;
  y: number;
  /** the edge that arrives, and the one that leaves */
  inX: number;
  inY: number;
  outX: number;
  outY: number;
}
function cornersOf(flat: FlatResult): Corner[] {
  const { coords, rings } = flat;
  const corners: Corner[] = [];
  for (let r = 0; r + 1 < rings.length; ++r) {
    const [from, to] = [rings[r]!, rings[r + 1]!];
    for (let v = from; v < to; ++v) {
      const before = v === from ? to - 1 : v - 1;
      const after = v + 1 === to ? from : v + 1;
      const [x, y] = [coords[2 * v]!, coords[2 * v + 1]!];
      corners.push({
        x,
        y,
        inX: x - coords[2 * before]!,
        inY: y - coords[2 * before + 1]!,
        outX: coords[2 * after]! - x,
        outY: coords[2 * after + 1]! - y,
      });
    }
  }
  return corners;
}
const turn = (ax: number, ay: number, bx: number, by: number) => ax * by - ay * bx;

/** Pairs every edge with the vertices of the other operand whose turn passes its direction. */
export function fullConvolution(a: FlatResult, b: FlatResult): FullConvolution | null {
  const both = [cornersOf(a), cornersOf(b)];
  if (both[0]!.length * both[1]!.length > kMostPairs) return null;
  const made: FullConvolution = { convex: [], reflex: [] };
  for (const [moving, other] of [
    [both[0]!, both[1]!],
    [both[1]!, both[0]!],
  ] as const) {
    for (const v of other) {
      const reflex = turn(v.inX, v.inY, v.outX, v.outY) < 0;
      for (const e of moving) {
        const fromIn = turn(v.inX, v.inY, e.outX, e.outY);
        const toOut = turn(e.outX, e.outY, v.outX, v.outY);
        if (reflex ? !(fromIn <= 0 && toOut <= 0) : !(fromIn >= 0 && toOut >= 0)) continue;
        const list = reflex ? made.reflex : made.convex;
        list.push(v.x + e.x, v.y + e.y, v.x + e.x + e.outX, v.y + e.y + e.outY);
      }
    }
  }
  return made;
}
