// What lies under the pointer, with exact coordinates and where it came from.
import type { FlatResult } from "minksum";
import { nearestOnSegment, polygonAt } from "./hit.js";
import type { RunAnswer } from "./jobs.js";
import { fromExact, type Position, type State } from "./model.js";
import { circle, outlineOf, outlinePaths, posed } from "./shapes.js";
import type { Mark } from "./scene.js";
import type { View } from "./view.js";

interface Near {
  distance: number;
  vertex?: number;
  /** the first vertex of an edge, and the second one */
  edge?: [number, number];
  /** a polyline's or a point's place */
  at?: [number, number];
}

/** Looks for the nearest vertex, and for the nearest edge if no vertex is near. */
function nearest(result: FlatResult, x: number, y: number, reach: number): Near | null {
  let vertex: Near | null = null;
  let edge: Near | null = null;
  const { coords, rings } = result;
  for (let r = 0; r + 1 < rings.length; ++r) {
    const [from, to] = [rings[r]!, rings[r + 1]!];
    for (let v = from; v < to; ++v) {
      const next = v + 1 === to ? from : v + 1;
      const [ax, ay, bx, by] = [
        coords[2 * v]!,
        coords[2 * v + 1]!,
        coords[2 * next]!,
        coords[2 * next + 1]!,
      ];
      const distance = Math.hypot(ax - x, ay - y);
      if (distance <= reach && (!vertex || distance < vertex.distance))
        vertex = { distance, vertex: v };
      const [px, py] = nearestOnSegment(x, y, ax, ay, bx, by);
      const off = Math.hypot(px - x, py - y);
      if (off <= reach && (!edge || off < edge.distance)) edge = { distance: off, edge: [v, next] };
    }
  }
  return vertex ?? edge;
}

export interface Hover {
  /** lines of text: what is there, and where it came from */
  lines: string[];
  marks: Mark[];
}
export function hoverAt(
  view: View,
  state: State,
  answer: RunAnswer | null,
  cursor: [number, number] | null,
): Hover {
  const nothing: Hover = { lines: [], marks: [] };
  if (!cursor || state.op === "slices") return nothing;
  const [x, y] = cursor;
  const result = answer?.op === state.op ? answer.result : null;
  const isResultShown = state.op !== "steps" || state.stage === 7;
  const near = result && isResultShown ? nearest(result, x, y, 9 / view.scale) : null;
  if (result && near) return onResult(view, result, near, answer!);
  if (
    (state.op === "sum" || (state.op === "steps" && state.stage === 0)) &&
    polygonAt(state.a, x, y)
  ) {
    const { area, lines } = outlinePaths(view, posed(outlineOf(state.b), x, y));
    return {
      lines: [],
      marks: [
        { cls: "sweep", d: area },
        { cls: "sweep", d: lines },
      ],
    };
  }
  if (state.op === "robot") {
    const robot = outlinePaths(view, posed(outlineOf(state.b), x, y, state.degrees));
    return {
      lines: [],
      marks: [
        { cls: "sweep", d: robot.area },
        { cls: "sweep", d: robot.lines },
      ],
    };
  }
  return nothing;
}

function onResult(view: View, result: FlatResult, near: Near, answer: RunAnswer): Hover {
  const { coords } = result;
  const exact = answer.details?.exact.coords;
  const text = (v: number) => {
    const [px, py] = exact
      ? [exact[2 * v]!, exact[2 * v + 1]!]
      : [coords[2 * v]!, coords[2 * v + 1]!];
    return `(${px}, ${py})`;
  };
  const rounded = (v: number) => `≈ (${coords[2 * v]}, ${coords[2 * v + 1]})`;
  const origin = (v: number) => {
    const from = answer.details?.origins?.[v];
    return from ? [`Edge: ${from}`] : [];
  };
  if (near.vertex !== undefined) {
    const v = near.vertex;
    const isFraction =
      exact && [exact[2 * v], exact[2 * v + 1]].some((c) => String(c).includes("/"));
    return {
      lines: [text(v), ...(isFraction ? [rounded(v)] : []), ...origin(v)],
      marks: [{ cls: "near", d: circle(view, coords[2 * v]!, coords[2 * v + 1]!, 7) }],
    };
  }
  const [v, next] = near.edge!;
  const ends = [v, next].map((end) =>
    view.toScreen(coords[2 * end]!, coords[2 * end + 1]!).join(" "),
  );
  return {
    lines: [`${text(v)} to ${text(next)}`, ...origin(v)],
    marks: [{ cls: "near-edge", d: `M${ends[0]}L${ends[1]}` }],
  };
}

/** Returns a place of the no-fit polygon without play, or a vertex of it, that is near. */
export function tightPlace(
  answer: RunAnswer | null,
  x: number,
  y: number,
  within: number,
): Position | null {
  const { result, details } = answer ?? {};
  if (!result || !details) return null;
  let best: { distance: number; place: Position } | null = null;
  const offer = (numbers: ArrayLike<number>, exact: string[], weight: number) => {
    for (let i = 0; i + 1 < numbers.length; i += 2) {
      const distance = Math.hypot(numbers[i]! - x, numbers[i + 1]! - y) * weight;
      if (distance > within || (best && best.distance <= distance)) continue;
      best = { distance, place: [fromExact(exact[i]!), fromExact(exact[i + 1]!)] };
    }
  };
  offer(result.points, details.exact.points, 0.5);
  offer(result.lineCoords, details.exact.lineCoords, 0.7);
  offer(result.coords, details.exact.coords, 1);
  return best
    ? (best as { place: Position }).place
    : onTightLine(result, details.exact.lineCoords, x, y, within);
}
/** Level and upright tight polylines keep one exact coordinate all along. */
function onTightLine(
  result: FlatResult,
  exact: string[],
  x: number,
  y: number,
  within: number,
): Position | null {
  const { lineCoords: xy, lines } = result;
  for (let l = 0; l + 1 < lines.length; ++l) {
    for (let v = lines[l]!; v + 1 < lines[l + 1]!; ++v) {
      const [ax, ay, bx, by] = [xy[2 * v]!, xy[2 * v + 1]!, xy[2 * v + 2]!, xy[2 * v + 3]!];
      const [px, py] = nearestOnSegment(x, y, ax, ay, bx, by);
      if (Math.hypot(px - x, py - y) > within) continue;
      const rounded = (value: number) => Number(value.toPrecision(6));
      if (exact[2 * v] === exact[2 * v + 2]) return [fromExact(exact[2 * v]!), rounded(py)];
      if (exact[2 * v + 1] === exact[2 * v + 3]) return [rounded(px), fromExact(exact[2 * v + 1]!)];
    }
  }
  return null;
}
