// The page: it holds the parts together, and draws once a frame at most.
import { Editor, type Name, type Tool } from "./editor.js";
import { listenToDrops } from "./drops.js";
import { Engine } from "./engine.js";
import { examples, stateOf } from "./examples.js";
import { faultMarks, gridMarks } from "./ground.js";
import { CodeBox, copy, drawingAsSvg, flatToWkt, save, showProblem } from "./files.js";
import { showBusy } from "./busy.js";
import { handleMarks } from "./handles.js";
import { hoverAt, tightPlace } from "./hover.js";
import type { Failure, RunAnswer, RunJob } from "./jobs.js";
import { listenToKeys } from "./keys.js";
import { limitMarks, limitsWkt } from "./limits.js";
import { emptyShape, moved, toWkt, vertexCount, type State } from "./model.js";
import { byId, element, Panel } from "./panel.js";
import { isInside, operandMarks, places, resultMarks, worldBox } from "./picture.js";
import { kMostInSvg, Scene } from "./scene.js";
import { fromFragment, fromJson, kLargestLink, toFragment, toJson } from "./share.js";
import { listenToTheme } from "./theme.js";
import { Store } from "./store.js";
import { View } from "./view.js";

const tools: [Tool, string, string][] = [
  ["move", "Move", "Move vertices and parts, click an edge for a vertex (V)"],
  ["polygon", "Polygon", "Draw a polygon (P)"],
  ["hole", "Hole", "Draw a hole (H)"],
  ["line", "Polyline", "Draw a polyline; a single vertex is a point (L)"],
];
const svg = document.getElementById("drawing") as unknown as SVGSVGElement;
const store = new Store(stateOf(examples[0]!));
const view = new View();
const scene = new Scene(svg, byId("canvas").querySelector("canvas")!, [
  "grid",
  "result",
  "first",
  "second",
  "inner",
  "marks",
  "hover",
]);
const panel = new Panel(store);
const code = new CodeBox(say);
const editor = new Editor(svg, store, view, {
  changed: draw,
  say,
  tightPlace: (x, y, within) => tightPlace(answer, x, y, within),
});
let answer: RunAnswer | null = null;
let failure: Failure | null = null;
let detailsTimer: ReturnType<typeof setTimeout> | undefined;
/** whether the next answer decides what is shown */
let fitNext = true;
let frame = 0;
/** the number of the job that was sent last */
let lastJob = 0;
const engine = new Engine(answered);

function say(text: string): void {
  byId("status").textContent = text;
}

// -- Computing -------------------------------------------------------------------------------
function placedWkt(state: State): string {
  return toWkt(places(state) ? moved(state.b, state.place) : state.b);
}
function compute(details: boolean): void {
  settle(false);
  const { state } = store;
  const { a, b, workspace: _, ...rest } = state;
  const job: RunJob = {
    kind: "run",
    id: ++lastJob,
    ...rest,
    a: toWkt(a),
    b: toWkt(b),
    placed: placedWkt(state),
    limits: limitsWkt(state),
    details,
  };
  engine.run(job);
  clearTimeout(detailsTimer);
  // Exact numbers come when nothing moves.
  if (!details) detailsTimer = setTimeout(() => compute(true), 140);
}
function answered(given: RunAnswer | Failure): void {
  if (given.kind === "failure") {
    failure = given;
    clearTimeout(detailsTimer);
  } else {
    failure = null;
    const before = answer;
    answer = given;
    if (given.op === "nofit" && !given.details && before?.op === "nofit" && onlyPlaceChanged)
      given.details = before.details;
    if (fitNext && given.op === store.state.op) {
      fitNext = false;
      fit();
    }
  }
  showTexts();
  draw();
  const isLast = given.kind === "failure" || (given.faults !== undefined && given.id === lastJob);
  complete = isLast && unread.size === 0;
}
let onlyPlaceChanged = false;
/** whether no further answer is awaited */
let complete = false;
/** Says for tests and other scripts whether all is shown that will be. */
function settle(done: boolean): void {
  complete &&= done;
  document.documentElement.dataset["settled"] = done ? "yes" : "no";
}

store.listen((state, before) => {
  // Choosing a stage of a sum computes nothing.
  const noted = (Object.keys(state) as (keyof State)[]).filter(
    (name) => name !== "stage" && state[name] !== before[name],
  );
  onlyPlaceChanged = noted.every((name) => name === "place");
  if (noted.includes("op")) {
    fitNext = true;
    editor.selection = null;
  }
  if (noted.length > 0) compute(false);
  draw();
});

// -- Drawing ---------------------------------------------------------------------------------
function draw(): void {
  frame ||= requestAnimationFrame(render);
}
function render(): void {
  frame = 0;
  const { state } = store;
  const shown = failure && failure.code !== "cancelled" ? null : answer;
  scene.show("grid", gridMarks(view));
  const marks = resultMarks(view, state, shown);
  const total = shown?.op === state.op && shown.result ? shown.result.coords.length / 2 : 0;
  const large = total > kMostInSvg;
  const above = isInside(state);
  scene.paint(large ? marks : []);
  scene.show("result", large || above ? [] : marks);
  scene.show("inner", above && !large ? marks : []);
  const { a, b } = operandMarks(view, state, shown);
  scene.show("first", a);
  scene.show("second", b);
  scene.show("marks", [
    ...limitMarks(view, state),
    ...handleMarks(editor, state, view),
    ...faultMarks(editor, view, state, answer, failure),
  ]);
  const hover =
    editor.dragging || editor.tool !== "move"
      ? { lines: [], marks: [] }
      : hoverAt(view, state, shown, editor.cursor);
  scene.show("hover", hover.marks);
  const box = byId("hover");
  box.hidden = hover.lines.length === 0;
  if (!box.hidden) {
    box.replaceChildren(
      element("b", {}, hover.lines[0]!),
      ...hover.lines.slice(1).flatMap((line) => [element("br"), line]),
    );
  }
  svg.classList.toggle("draws", editor.tool !== "move");
  panel.update(state);
  panel.facts(state, shown);
  buttons();
  messages(state);
  if (complete) settle(true);
}
function messages(state: State): void {
  const box = byId("message");
  const faults =
    answer?.faults?.flatMap((list, i) => list.map((f) => ({ ...f, name: "AB"[i]! }))) ?? [];
  let text = "";
  if (failure) {
    const which = ["A: ", "B: ", "Limits: "][failure.operand ?? -1] ?? "";
    text = which + failure.message;
  } else if (faults[0] && state.op !== "slices") {
    const { name, message, ring, vertex } = faults[0];
    const more = faults.length > 1 ? ` There are ${faults.length - 1} more faults.` : "";
    text =
      `${name} is not a valid polygon: ${message} (ring ${ring}, vertex ${vertex}). It is ` +
      `read by the fill rule.${more}`;
  } else if (vertexCount(state.a) === 0) {
    text = "A is empty. Choose Polygon and click on the drawing, or paste a text.";
  }
  box.hidden = text === "";
  if (box.textContent !== text) box.textContent = text;
}
function buttons(): void {
  byId<HTMLButtonElement>("undo").disabled = !store.canUndo;
  byId<HTMLButtonElement>("redo").disabled = !store.canRedo;
  byId("snap").setAttribute("aria-pressed", String(editor.snap));
  for (const button of document.querySelectorAll<HTMLElement>("[data-tool]")) {
    button.setAttribute("aria-pressed", String(button.dataset["tool"] === editor.tool));
  }
  for (const button of document.querySelectorAll<HTMLElement>("[data-target]")) {
    button.setAttribute("aria-pressed", String(button.dataset["target"] === editor.target));
  }
}
setInterval(() => showBusy(engine), 100);

// -- Texts -----------------------------------------------------------------------------------
/** operands whose text was typed and is not read yet */
const unread = new Set<Name>();
function showTexts(): void {
  const { state } = store;
  if (editor.dragging) return;
  for (const name of ["a", "b"] as const) {
    const area = byId<HTMLTextAreaElement>(`text-${name}`);
    if (document.activeElement !== area && !unread.has(name))
      area.value = vertexCount(state[name]) ? toWkt(state[name]) : "";
  }
  byId<HTMLTextAreaElement>("exact").value =
    answer?.details && answer.id === lastJob ? answer.details.wkt : "";
  byId("exact-box").hidden = ![
    "sum",
    "erode",
    "open",
    "close",
    "offset",
    "nofit",
    "robot",
    "steps",
  ].includes(state.op);
  code.update(state, placedWkt(state));
}
async function readText(name: Name, text: string): Promise<void> {
  if (text.trim() === "") {
    showProblem(name, null);
    store.change({ [name]: emptyShape() });
    return;
  }
  const read = await engine.read(text, store.state.tolerance);
  showProblem(name, read.kind === "failure" ? read : null);
  if (read.kind === "failure") return compute(false);
  fitNext = true;
  store.change({ [name]: read.shape });
  showTexts();
  say(`${name.toUpperCase()} has ${vertexCount(read.shape)} vertices now.`);
}
async function readFile(file: File): Promise<void> {
  if (file.size > 20_000_000) {
    say(
      `${file.name} has ${Math.round(file.size / 1e6)} MB. This page reads files of up to 20 ` +
        `MB; the program reads larger ones.`,
    );
    return;
  }
  const text = await file.text();
  if (/^\s*\{\s*"version"\s*:/.test(text)) {
    try {
      fitNext = true;
      store.change(fromJson(text));
    } catch (problem) {
      say((problem as Error).message);
    }
    return;
  }
  const name = editor.target;
  const area = byId<HTMLTextAreaElement>(`text-${name}`);
  area.value = text;
  area.blur();
  await readText(name, text);
}

// -- Controls --------------------------------------------------------------------------------
function fit(): void {
  view.fit(worldBox(store.state, answer, view));
  draw();
}
function setTool(tool: Tool): void {
  editor.tool = tool;
  editor.stopDrawing();
  editor.selection = null;
  draw();
}
async function share(): Promise<void> {
  const fragment = await toFragment(store.state);
  if (fragment.length > kLargestLink) {
    say(
      `A link would have ${Math.round(fragment.length / 1024)} kB, and more than 8 kB is cut ` +
        `off in many places. Use “Save file” instead, and drop the file on the page to open it.`,
    );
    byId("save-json").classList.add("strong");
    return;
  }
  history.replaceState(null, "", `#${fragment}`);
  await copy(location.href, "The link", say);
}
async function openLink(): Promise<boolean> {
  try {
    const state = await fromFragment(location.hash);
    if (state === null) return false;
    fitNext = true;
    store.change(state);
    return true;
  } catch (problem) {
    say((problem as Error).message);
    return false;
  }
}
function listen(): void {
  for (const [tool, name, title] of tools) {
    const button = element("button", { type: "button", "data-tool": tool, title }, name);
    button.onclick = () => setTool(tool);
    byId("tools").append(button);
  }
  for (const button of document.querySelectorAll<HTMLElement>("[data-target]")) {
    button.onclick = () => {
      editor.target = button.dataset["target"] as Name;
      draw();
    };
  }
  const select = byId<HTMLSelectElement>("example");
  for (const [i, { name }] of examples.entries())
    select.append(element("option", { value: String(i) }, name));
  select.onchange = () => {
    fitNext = true;
    store.change(stateOf(examples[Number(select.value)]!));
  };
  const click = (id: string, does: () => void) => (byId(id).onclick = does);
  click("snap", () => {
    editor.snap = !editor.snap;
    draw();
  });
  click("undo", () => store.undo());
  click("redo", () => store.redo());
  const middle = () => [view.width / 2, view.height / 2] as const;
  click("closer", () => (view.zoom(1.25, ...middle()), draw()));
  click("farther", () => (view.zoom(0.8, ...middle()), draw()));
  click("fit", fit);
  click("cancel", () => engine.cancel());
  click("share", () => void share());
  listenToTheme(draw);
  click("swap", () => store.change({ a: store.state.b, b: store.state.a }));
  click("save-svg", () => save("minksum.svg", "image/svg+xml", drawingAsSvg(svg)));
  click("save-json", () => save("minksum.json", "application/json", toJson(store.state)));
  click("save-wkt", () => {
    const text =
      answer?.details?.wkt ?? answer?.slices?.map((s) => flatToWkt(s.obstacles)).join("\n");
    if (text) save("minksum.wkt", "text/plain", text + "\n");
    else say("This operation has no shape as its result.");
  });
  for (const name of ["a", "b"] as const) {
    const area = byId<HTMLTextAreaElement>(`text-${name}`);
    let timer: ReturnType<typeof setTimeout>;
    area.oninput = () => {
      settle(false);
      unread.add(name);
      clearTimeout(timer);
      timer = setTimeout(() => {
        unread.delete(name);
        void readText(name, area.value);
      }, 250);
    };
  }
  const file = byId<HTMLInputElement>("file");
  click("open", () => file.click());
  file.onchange = () => {
    if (file.files?.[0]) void readFile(file.files[0]);
    file.value = "";
  };
  const take = (text: string) => void readText(editor.target, text);
  listenToDrops(
    () => editor.target.toUpperCase(),
    (given) => void readFile(given),
    take,
  );
}
function resize(): void {
  const { width, height } = byId("canvas").getBoundingClientRect();
  if (width === view.width && height === view.height) return;
  view.x += (width - view.width) / 2;
  view.y += (height - view.height) / 2;
  view.width = width;
  view.height = height;
  scene.resize(width, height);
  if (store.state === first) fit();
  draw();
}
const first = store.state;
listen();
listenToKeys(svg, editor, store, view, { setTool, fit, changed: draw, say });
new ResizeObserver(resize).observe(byId("canvas"));
resize();
addEventListener("hashchange", () => void openLink());
void openLink().then((opened) => {
  if (!opened) compute(false);
});
