// What is on the canvas for each operation.
import type { FlatResult } from "minksum";
import type { RunAnswer } from "./jobs.js";
import { hasLimits, limitsOf } from "./limits.js";
import { toNumber, type State } from "./model.js";
import type { Mark } from "./scene.js";
import {
  arrow,
  circle,
  cross,
  flatPaths,
  listsOf,
  outlineOf,
  outlinePaths,
  posed,
  type Outline,
} from "./shapes.js";
import { stageMarks } from "./stages.js";
import { boxOf, type Box, type View } from "./view.js";

/** Operations in which B, the part or the robot, is dragged as a whole. */
export const places = (state: State) => state.op === "nofit" || state.op === "depth";
export const hasPoses = (state: State) => state.op === "path";

function areaMarks(view: View, outline: Outline, name: string): Mark[] {
  const { area, lines, dots } = outlinePaths(view, outline);
  return [
    { cls: name, d: area },
    { cls: `${name} path`, d: lines },
    { cls: `${name} dots`, d: dots },
  ];
}
function flatMarks(view: View, flat: FlatResult, name: string, thin: string): Mark[] {
  const { area, lines, dots } = flatPaths(view, flat);
  return [
    { cls: name, d: area },
    { cls: `${thin}-line`, d: lines },
    { cls: `${thin}-dot`, d: dots },
  ];
}

/** Slices lie above each other, each turned a little more. */
export function slicePoint(
  view: View,
  x: number,
  y: number,
  level: number,
  height: number,
): [number, number] {
  const [px, py] = view.toScreen(x, y * 0.45);
  return [px, py - level * height];
}
function sliceMarks(view: View, state: State, answer: RunAnswer): Mark[] {
  const slices = answer.slices ?? [];
  const height = (view.height * 0.4) / Math.max(1, slices.length);
  const path = (list: ArrayLike<number>, from: number, to: number, level: number) => {
    let text = "";
    for (let v = from; v < to; ++v) {
      const [x, y] = slicePoint(view, list[2 * v]!, list[2 * v + 1]!, level, height);
      text += `${text ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`;
    }
    return text + "Z";
  };
  const marks: Mark[] = outlineOf(state.a).rings.length
    ? [
        {
          cls: "first",
          d: outlineOf(state.a)
            .rings.map((r) => path(r, 0, r.length / 2, 0))
            .join(""),
        },
      ]
    : [];
  if (hasLimits(state)) marks.push({ cls: "limits", d: path(limitsOf(state.workspace), 0, 4, 0) });
  // The stack is cut at the angle: what lies above would hide the slice there.
  const shown =
    state.degrees <= 0
      ? slices.length
      : Math.max(1, Math.round((state.degrees / 360) * slices.length));
  for (const [i, { obstacles }] of slices.slice(0, shown).entries()) {
    let d = "";
    for (let r = 0; r + 1 < obstacles.rings.length; ++r) {
      d += path(obstacles.coords, obstacles.rings[r]!, obstacles.rings[r + 1]!, i);
    }
    marks.push({ cls: i + 1 === shown ? "slice chosen" : "slice", d });
  }
  return marks;
}

function depthMarks(view: View, state: State, answer: RunAnswer): Mark[] {
  const { depth } = answer;
  if (!depth) return [];
  const [x, y] = [toNumber(state.place[0]), toNumber(state.place[1])];
  const b = outlineOf(state.b);
  const box = boxOf(listsOf(b));
  if (!box) return [];
  const middle: [number, number] = [x + (box.minX + box.maxX) / 2, y + (box.minY + box.maxY) / 2];
  const [vx, vy] = depth.vector;
  return [
    ...areaMarks(view, posed(b, x + vx, y + vy), "ghost"),
    { cls: "arrow", d: arrow(view, middle, [middle[0] + vx, middle[1] + vy]) },
  ];
}

function pathMarks(view: View, state: State, answer: RunAnswer | null): Mark[] {
  const b = outlineOf(state.b);
  const marks: Mark[] = [];
  const path = answer?.reach?.path ?? [];
  // The robot is shown on its way, so that one sees it turn.
  for (const [i, pose] of path.entries()) {
    const before = path[i - 1];
    const steps = before
      ? Math.min(
          12,
          Math.ceil((Math.hypot(pose.x - before.x, pose.y - before.y) * view.scale) / 26),
        )
      : 0;
    for (let s = 1; s < steps; ++s) {
      const t = s / steps;
      const turn = ((pose.degrees - before!.degrees + 540) % 360) - 180;
      marks.push(
        ...areaMarks(
          view,
          posed(
            b,
            before!.x + t * (pose.x - before!.x),
            before!.y + t * (pose.y - before!.y),
            before!.degrees + t * turn,
          ),
          "ghost",
        ),
      );
    }
  }
  if (path.length) {
    const d = path.map((p, i) => `${i ? "L" : "M"}${view.toScreen(p.x, p.y).join(" ")}`).join("");
    marks.push({ cls: "way", d });
  }
  for (const [name, pose] of [
    ["start", state.from],
    ["goal", state.to],
  ] as const) {
    marks.push(...areaMarks(view, posed(b, pose.x, pose.y, pose.degrees), `second ${name}`));
    marks.push({ cls: "origin", d: cross(view, pose.x, pose.y) });
    const [x, y] = view.toScreen(pose.x, pose.y);
    marks.push({ cls: "label", text: name, x: x + 10, y: y - 10 });
  }
  return marks;
}

/** What lies below the operands: the result. */
export function resultMarks(view: View, state: State, answer: RunAnswer | null): Mark[] {
  if (!answer || answer.op !== state.op) return [];
  const { result } = answer;
  switch (state.op) {
    case "steps":
      return answer.trace ? stageMarks(view, answer.trace, state.stage) : [];
    case "slices":
      return sliceMarks(view, state, answer);
    case "depth":
      return depthMarks(view, state, answer);
    case "path":
      return [];
    case "nofit":
      return result ? flatMarks(view, result, "blocked", "tight") : [];
    case "robot":
      return result ? flatMarks(view, result, "blocked", "blocked") : [];
    default: {
      if (!result) return [];
      const marks = flatMarks(view, result, "sum", "sum");
      if (answer.band) {
        const { outer, inner } = answer.band;
        marks.push({ cls: "band", d: flatPaths(view, outer).area + flatPaths(view, inner).area });
      }
      return marks;
    }
  }
}
/** Operations whose result would hide under A, and lies above it. */
export const isInside = (state: State) =>
  ["erode", "open"].includes(state.op) || (state.op === "offset" && state.distance < 0);

/** The operands, and what moves with them. */
export function operandMarks(
  view: View,
  state: State,
  answer: RunAnswer | null,
): { a: Mark[]; b: Mark[] } {
  if (state.op === "slices") return { a: [], b: [] };
  const faint = state.op === "steps" && state.stage > 0 ? " faint" : "";
  const a = areaMarks(view, outlineOf(state.a), `first${faint}`);
  if (state.op === "offset") return { a, b: [] };
  if (state.op === "path") return { a, b: pathMarks(view, state, answer) };
  const at: [number, number] = places(state)
    ? [toNumber(state.place[0]), toNumber(state.place[1])]
    : [0, 0];
  const degrees = state.op === "robot" ? state.degrees : 0;
  const contact = state.op === "nofit" && answer?.contact ? ` ${answer.contact}` : "";
  const b = areaMarks(view, posed(outlineOf(state.b), ...at, degrees), `second${faint}${contact}`);
  b.push({ cls: "origin", d: cross(view, ...at) + circle(view, ...at, 3) });
  return { a, b };
}

/** The box of all that an operation shows. */
export function worldBox(state: State, answer: RunAnswer | null, view: View): Box | null {
  const lists: ArrayLike<number>[] = listsOf(outlineOf(state.a));
  const b = outlineOf(state.b);
  if (state.op === "path") {
    for (const pose of [state.from, state.to])
      lists.push(...listsOf(posed(b, pose.x, pose.y, pose.degrees)));
  } else if (state.op !== "offset" && state.op !== "slices") {
    const at: [number, number] = places(state)
      ? [toNumber(state.place[0]), toNumber(state.place[1])]
      : [0, 0];
    lists.push(...listsOf(posed(b, ...at)), [0, 0]);
  }
  if (hasLimits(state)) lists.push(limitsOf(state.workspace));
  if (answer?.op === state.op) {
    for (const flat of [answer.result, ...(answer.slices ?? []).map((slice) => slice.obstacles)]) {
      if (flat) lists.push(flat.coords, flat.lineCoords, flat.points);
    }
  }
  const box = boxOf(lists);
  if (box && state.op === "slices") {
    box.minY *= 0.45;
    box.maxY = box.maxY * 0.45 + ((box.maxX - box.minX) * 0.42 * view.height) / view.width;
  }
  return box;
}
