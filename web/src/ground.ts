// The grid below everything, and the marks at faults above everything.
import type { Editor } from "./editor.js";
import type { Failure, RunAnswer } from "./jobs.js";
import { toNumber, type State } from "./model.js";
import type { Mark } from "./scene.js";
import { circle } from "./shapes.js";
import type { View } from "./view.js";

export function gridMarks(view: View): Mark[] {
  const { step, width, height, scale } = view;
  let d = "";
  for (let i = Math.ceil(-view.x / scale / step); i * step * scale + view.x < width; ++i) {
    d += `M${(view.x + i * step * scale).toFixed(1)} 0V${height}`;
  }
  for (let i = Math.ceil((view.y - height) / scale / step); view.y - i * step * scale > 0; ++i) {
    d += `M0 ${(view.y - i * step * scale).toFixed(1)}H${width}`;
  }
  const axes = `M${view.x.toFixed(1)} 0V${height}M0 ${view.y.toFixed(1)}H${width}`;
  return [
    { cls: "grid", d },
    { cls: "grid-strong", d: axes },
  ];
}

/** Circles where an operand is not valid, or where an operation refused it. */
export function faultMarks(
  editor: Editor,
  view: View,
  state: State,
  answer: RunAnswer | null,
  failure: Failure | null,
): Mark[] {
  const found: Pick<Failure, "operand" | "polygon" | "ring" | "vertex">[] = [];
  for (const [operand, faults] of (answer?.faults ?? []).entries()) {
    for (const { polygon, ring, vertex } of faults) found.push({ operand, polygon, ring, vertex });
  }
  if (failure) found.push(failure);
  return found.flatMap(({ operand, polygon = 0, ring = 0, vertex }) => {
    const name = operand === undefined ? undefined : (["a", "b"] as const)[operand];
    if (vertex === undefined || !name || !editor.editable(name)) return [];
    const p = state[name].polygons[polygon]?.[ring]?.[vertex];
    if (!p) return [];
    const [ox, oy] = editor.offset(name).map(toNumber) as [number, number];
    return [{ cls: "fault", d: circle(view, toNumber(p[0]) + ox, toNumber(p[1]) + oy, 11) }];
  });
}
