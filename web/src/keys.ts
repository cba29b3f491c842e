// The keyboard on the canvas: everything that a pointer can do.
import type { Editor, Name, Selection, Tool } from "./editor.js";
import { moveVertex } from "./edit.js";
import { add, pathOf, toNumber, verticesOf, type Position } from "./model.js";
import { hasPoses, places } from "./picture.js";
import type { Store } from "./store.js";
import type { View } from "./view.js";

export interface KeyHooks {
  setTool(tool: Tool): void;
  fit(): void;
  changed(): void;
  say(text: string): void;
}
const kArrows: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
const kTools: Record<string, Tool> = { v: "move", p: "polygon", h: "hole", l: "line" };

export function listenToKeys(
  element: SVGSVGElement,
  editor: Editor,
  store: Store,
  view: View,
  hooks: KeyHooks,
): void {
  element.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (handle(event, editor, store, view, hooks)) event.preventDefault();
  });
  document.addEventListener("keydown", (event) => {
    const typing = (event.target as Element).matches?.("input, textarea, select");
    if (typing || !(event.ctrlKey || event.metaKey)) return;
    const key = event.key.toLowerCase();
    if (key === "z" && !event.shiftKey) store.undo();
    else if (key === "y" || key === "z") store.redo();
    else return;
    event.preventDefault();
  });
}

function handle(
  event: KeyboardEvent,
  editor: Editor,
  store: Store,
  view: View,
  hooks: KeyHooks,
): boolean {
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const arrow = kArrows[key];
  if (arrow) return go(arrow, event.shiftKey, editor, store, view, hooks);
  const tool = kTools[key];
  if (tool) {
    hooks.setTool(tool);
    return true;
  }
  const { selection } = editor;
  switch (key) {
    case "n":
    case "b":
      return select(editor, store, key === "n" ? 1 : -1, hooks);
    case "Enter":
    case " ":
      if (editor.tool !== "move") {
        if (key === "Enter") editor.finishDrawing();
        else drawHere(editor, view);
        return true;
      }
      return selection ? insertHere(editor, store, selection) : false;
    case "Delete":
    case "Backspace":
      if (selection) editor.remove(selection);
      return selection !== null;
    case "Escape":
      if (editor.drawing.length > 0) editor.stopDrawing();
      else hooks.setTool("move");
      editor.selection = null;
      hooks.changed();
      return true;
    case "+":
    case "=":
    case "-":
      view.zoom(key === "-" ? 0.8 : 1.25, view.width / 2, view.height / 2);
      hooks.changed();
      return true;
    case "f":
    case "0":
      hooks.fit();
      return true;
  }
  return false;
}
function drawHere(editor: Editor, view: View): void {
  const [x, y] = editor.cursor ?? view.toWorld(view.width / 2, view.height / 2);
  editor.draw(x, y, false, false);
}
/** Goes to the next vertex, or to the one before: all those of A, and then those of B. */
function select(editor: Editor, store: Store, by: number, hooks: KeyHooks): boolean {
  const all: Selection[] = (["a", "b"] as Name[])
    .filter((name) => editor.editable(name))
    .flatMap((name) => Array.from(verticesOf(store.state[name]), ([vertex]) => ({ name, vertex })));
  if (all.length === 0) return false;
  const now = editor.selection && JSON.stringify(editor.selection);
  const found = all.findIndex((one) => JSON.stringify(one) === now);
  const next = found < 0 ? (by > 0 ? 0 : all.length - 1) : (found + by + all.length) % all.length;
  editor.selection = all[next]!;
  editor.sayVertex();
  hooks.changed();
  return true;
}
function insertHere(editor: Editor, store: Store, { name, vertex }: Selection): boolean {
  if (vertex.kind === "points") return false;
  const path = pathOf(store.state[name], vertex);
  const p = path[vertex.index]!;
  const q = path[(vertex.index + 1) % path.length]!;
  const half = (a: Position[0], b: Position[0]) =>
    Number(((toNumber(a) + toNumber(b)) / 2).toPrecision(12));
  editor.insert(name, vertex, [half(p[0], q[0]), half(p[1], q[1])]);
  return true;
}
/** Moves the vertex that is selected, the cursor, the part, or the view. */
function go(
  [dx, dy]: [number, number],
  far: boolean,
  editor: Editor,
  store: Store,
  view: View,
  hooks: KeyHooks,
): boolean {
  const step = (far ? 5 : 0.5) * view.step;
  const [x, y] = [dx * step, dy * step];
  const shift = (p: Position): Position => [add(p[0], x), add(p[1], y)];
  const { state } = store;
  if (editor.tool !== "move") {
    const at =
      editor.cursor ??
      editor.snapped(...view.toWorld(view.width / 2, view.height / 2)).map(toNumber);
    editor.cursor = [at[0]! + x, at[1]! + y];
    hooks.say(`${editor.snapped(...editor.cursor).join(", ")}`);
  } else if (editor.selection) {
    const { name, vertex } = editor.selection;
    const p = pathOf(state[name], vertex)[vertex.index]!;
    store.change({ [name]: moveVertex(state[name], vertex, shift(p)) });
    editor.sayVertex();
  } else if (places(state)) {
    store.change({ place: shift(state.place) });
    hooks.say(`B at ${store.state.place.join(", ")}`);
  } else if (hasPoses(state)) {
    store.change({ to: { ...state.to, x: state.to.x + x, y: state.to.y + y } });
    hooks.say(`Goal at ${store.state.to.x}, ${store.state.to.y}`);
  } else {
    view.x -= dx * 40;
    view.y += dy * 40;
  }
  hooks.changed();
  return true;
}
