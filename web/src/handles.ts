// What shows that vertices can be dragged, and what is being drawn.
import type { Editor, Name } from "./editor.js";
import { add, pathOf, toNumber, type State } from "./model.js";
import type { Mark } from "./scene.js";
import { circle, cross, outlineOf } from "./shapes.js";
import type { View } from "./view.js";

/** Above so many vertices handles would lie on each other. */
const kMostHandles = 150;
const colour = (name: Name) => (name === "a" ? "of-first" : "of-second");

export function handleMarks(editor: Editor, state: State, view: View): Mark[] {
  const marks = (["a", "b"] as const)
    .filter((name) => editor.editable(name))
    .flatMap((name) => handlesOf(editor, state, view, name));
  const { selection } = editor;
  if (selection) {
    const p = pathOf(state[selection.name], selection.vertex)?.[selection.vertex.index];
    const [ox, oy] = editor.offset(selection.name);
    if (p) {
      const [x, y] = [toNumber(add(p[0], ox)), toNumber(add(p[1], oy))];
      marks.push({ cls: "selected", d: circle(view, x, y, 9) });
    } else editor.selection = null;
  }
  return editor.tool === "move" ? marks : [...marks, ...drawingMarks(editor, view)];
}
function handlesOf(editor: Editor, state: State, view: View, name: Name): Mark[] {
  // The picture of a stage needs the room.
  if (state.op === "steps" && state.stage > 0) return [];
  const [ox, oy] = editor.offset(name).map(toNumber) as [number, number];
  const outline = outlineOf(state[name]);
  const lists = [...outline.rings, ...outline.lines];
  if (lists.reduce((sum, list) => sum + list.length / 2, 0) > kMostHandles) return [];
  let d = "";
  for (const list of lists) {
    for (let v = 0; v < list.length; v += 2) {
      const [x, y] = view.toScreen(list[v]! + ox, list[v + 1]! + oy);
      d += `M${x.toFixed(1)} ${y.toFixed(1)}h0`;
    }
  }
  return [{ cls: `handles ${colour(name)}`, d }];
}
function drawingMarks({ drawing, cursor, target }: Editor, view: View): Mark[] {
  const vertices = drawing.map((p) => p.map(toNumber) as [number, number]);
  const at = ([x, y]: [number, number]) => view.toScreen(x, y).join(" ");
  const path = cursor ? [...vertices, cursor] : vertices;
  const line = path.map((p, i) => `${i ? "L" : "M"}${at(p)}`).join("");
  const dots = vertices.map((p) => `M${at(p)}h0`).join("");
  return [
    { cls: `drawing ${colour(target)}`, d: line },
    { cls: `handles ${colour(target)}`, d: dots },
    ...(cursor ? [{ cls: "cursor", d: cross(view, ...cursor, 9) }] : []),
  ];
}
