// Limits of the plane, between which a robot has to stay.
import { decimal, type Limits, type State } from "./model.js";
import { outlineOf, listsOf } from "./shapes.js";
import type { Mark } from "./scene.js";
import { PathText } from "./scene.js";
import { boxOf, type View } from "./view.js";

type Limited = State & { workspace: Limits };
/** Whether an operation is done between limits. */
export const hasLimits = (state: State): state is Limited =>
  state.workspace !== null && ["robot", "slices", "path"].includes(state.op);

/** The corners of the limits, x and y in turn. */
export function limitsOf({ left, bottom, right, top }: Limits): number[] {
  const [x, y] = [Math.min(left, right), Math.min(bottom, top)];
  const [x2, y2] = [Math.max(left, right), Math.max(bottom, top)];
  return [x, y, x2, y, x2, y2, x, y2];
}
/** What the limits are at first: the box of the obstacles. */
export function firstLimits(state: State): Limits {
  const box = boxOf(listsOf(outlineOf(state.a)));
  if (!box) return { left: -10, bottom: -10, right: 10, top: 10 };
  return { left: box.minX, bottom: box.minY, right: box.maxX, top: box.maxY };
}

/** Returns the limits as a polygon; nothing if there are none. */
export function limitsWkt(state: State): string | undefined {
  if (!hasLimits(state)) return undefined;
  const xy = limitsOf(state.workspace);
  const corners = [0, 1, 2, 3].map((i) => `${decimal(xy[2 * i]!)} ${decimal(xy[2 * i + 1]!)}`);
  // This fill rule takes only what a clockwise ring encloses.
  if (state.fill === "negative") corners.reverse();
  return `POLYGON ((${[...corners, corners[0]].join(", ")}))`;
}

export function limitMarks(view: View, state: State): Mark[] {
  if (!hasLimits(state) || state.op === "slices") return [];
  return [{ cls: "limits", d: String(new PathText(view).add(limitsOf(state.workspace))) }];
}
