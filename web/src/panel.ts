// The controls beside the drawing.
import type { RunAnswer } from "./jobs.js";
import { firstLimits } from "./limits.js";
import { toNumber, vertexCount, type Operation, type State } from "./model.js";
import { fieldsOf, groups, legendOf, texts, valueOf, withValue, type Field } from "./operations.js";
import { fullOf, stageTexts } from "./stages.js";
import type { Store } from "./store.js";

export const byId = <T extends HTMLElement = HTMLElement>(id: string): T => {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found as T;
};
export function element<T extends keyof HTMLElementTagNameMap>(
  tag: T,
  given: Record<string, string> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[T] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(given)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}
const number = (value: number) => value.toLocaleString("en");
export const milliseconds = (value: number) =>
  value < 10
    ? `${value.toFixed(2)} ms`
    : value < 1000
      ? `${value.toFixed(0)} ms`
      : `${(value / 1000).toFixed(2)} s`;

export class Panel {
  private fieldsFor: Operation | undefined;

  constructor(private readonly store: Store) {
    const list = byId("operations");
    for (const [title, names] of groups) {
      const rows = element("div", { class: "list", role: "group", "aria-label": title });
      for (const op of names) {
        const { sign, name } = texts[op];
        const sign_ = element("b", { "aria-hidden": "true" }, sign);
        const button = element(
          "button",
          { type: "button", "data-op": op, "aria-pressed": "false" },
          sign_,
          name,
        );
        button.onclick = () => this.store.change({ op });
        rows.append(button);
      }
      list.append(element("h2", {}, title), rows);
    }
    const names = byId("stage-names");
    for (const { name } of stageTexts) names.append(element("li", {}, name));
    const slider = byId<HTMLInputElement>("stage");
    slider.oninput = () => this.toStage(Number(slider.value));
    byId("step-back").onclick = () => this.toStage(this.store.state.stage - 1);
    byId("step-on").onclick = () => this.toStage(this.store.state.stage + 1);
  }
  private toStage(stage: number): void {
    this.store.change({ stage: Math.min(7, Math.max(0, stage)) });
  }

  /** Shows what belongs to the state alone. */
  update(state: State): void {
    for (const button of document.querySelectorAll<HTMLButtonElement>("[data-op]")) {
      const now = button.dataset["op"] === state.op;
      if (now && button.getAttribute("aria-pressed") !== "true") this.intoSight(button);
      button.setAttribute("aria-pressed", String(now));
    }
    byId("operation-name").textContent = texts[state.op].name;
    byId("operation-text").textContent = texts[state.op].text;
    if (this.fieldsFor !== state.op) {
      this.fieldsFor = state.op;
      byId("fields").replaceChildren(...fieldsOf(state.op).map((field) => this.field(field)));
    }
    for (const input of byId("fields").querySelectorAll<HTMLInputElement>("[data-name]")) {
      if (input.type === "checkbox") continue;
      const value = String(valueOf(state, input.dataset["name"]!));
      if (input.value !== value && document.activeElement !== input) input.value = value;
      const shown = input.parentElement!.querySelector("output");
      if (shown) shown.textContent = value + (input.dataset["unit"] ?? "");
    }
    const limits = document.querySelector<HTMLInputElement>("#fields [data-name=workspace]");
    if (limits) {
      limits.checked = state.workspace !== null;
      byId("limits").hidden = !limits.checked;
    }
    byId("steps").hidden = state.op !== "steps";
    this.legend(state);
  }
  /** Scrolls the list of operations, and nothing else. */
  private intoSight(button: HTMLElement): void {
    const list = byId("operations");
    list.scrollLeft =
      button.offsetLeft - list.offsetLeft - list.clientWidth / 2 + button.clientWidth / 2;
  }
  private limits(label: string): HTMLElement {
    const check = element("input", { type: "checkbox", "data-name": "workspace" });
    check.onchange = () =>
      this.store.change({ workspace: check.checked ? firstLimits(this.store.state) : null });
    const sides = (["left", "bottom", "right", "top"] as const).map((side) =>
      this.field({ kind: "number", name: `workspace.${side}`, label: side, step: 1 }),
    );
    return element(
      "div",
      { class: "limits-field", role: "group", "aria-label": "Limits of the plane" },
      element("label", {}, label, check),
      element("div", { id: "limits", class: "limits-sides" }, ...sides),
    );
  }
  private field(field: Field): HTMLElement {
    if (field.kind === "limits") return this.limits(field.label);
    const change = (value: string | number) =>
      this.store.change(withValue(this.store.state, field.name, value));
    if (field.kind === "choice") {
      const select = element("select", { "data-name": field.name });
      for (const [value, text] of field.options) select.append(element("option", { value }, text));
      select.onchange = () => change(select.value);
      return element("label", {}, field.label, select);
    }
    const input = element("input", {
      type: field.kind,
      "data-name": field.name,
      step: String(field.step),
      ...(field.min === undefined ? {} : { min: String(field.min) }),
      ...(field.max === undefined ? {} : { max: String(field.max) }),
    });
    input.oninput = () => {
      const value = input.valueAsNumber;
      if (Number.isFinite(value) && (field.min === undefined || value >= field.min)) change(value);
    };
    if (field.kind === "number") {
      input.step = "any";
      return element("label", {}, field.label, input);
    }
    // A slide is one step to undo.
    input.onpointerdown = () => this.store.begin();
    input.onchange = () => this.store.finish();
    if (field.unit) input.dataset["unit"] = field.unit;
    return element("label", { class: "wide" }, field.label, element("output"), input);
  }
  private legend(state: State): void {
    const key = JSON.stringify(legendOf(state));
    const legend = byId("legend");
    if (legend.dataset["key"] === key) return;
    legend.dataset["key"] = key;
    legend.replaceChildren(
      ...legendOf(state).map(([cls, text]) => {
        const line = /line|edge|arrow|way|ghost$|dropped|reflex|band|limits/.test(cls);
        const d = cls === "node" ? "M8 6h0" : line ? "M1 7L16 7" : "M2 2H15V11H2Z";
        const sample = element("span");
        sample.innerHTML =
          `<svg viewBox="0 0 17 13" aria-hidden="true"><path class="${cls}" ` + `d="${d}"/></svg>`;
        sample.append(text);
        return sample;
      }),
    );
  }

  /** Shows what was computed. */
  facts(state: State, answer: RunAnswer | null): void {
    const rows: [string, string][] = [
      ["Vertices of A", number(vertexCount(state.a))],
      ...(state.op === "offset"
        ? []
        : [["Vertices of B", number(vertexCount(state.b))] as [string, string]]),
    ];
    if (answer?.op === state.op) rows.push(...resultRows(answer));
    const html = rows.flatMap(([name, value]) => [
      element("dt", {}, name),
      element("dd", {}, value),
    ]);
    byId("facts").replaceChildren(...html);
    this.stage(state, answer);
  }
  private stage(state: State, answer: RunAnswer | null): void {
    if (state.op !== "steps") return;
    const slider = byId<HTMLInputElement>("stage");
    const { name, text, count, time } = stageTexts[state.stage]!;
    slider.value = String(state.stage);
    slider.setAttribute("aria-valuetext", name);
    for (const [i, item] of [...byId("stage-names").children].entries()) {
      item.toggleAttribute("data-now", i === state.stage);
    }
    byId<HTMLButtonElement>("step-back").disabled = state.stage === 0;
    byId<HTMLButtonElement>("step-on").disabled = state.stage === 7;
    const trace = answer?.op === "steps" ? answer.trace : undefined;
    const took = trace ? time(trace) : null;
    const counts = trace
      ? [
          count(trace, state.stage === 1 ? fullOf(trace) : null),
          took === null ? "drawn by the page" : milliseconds(took),
        ]
      : [];
    const key = [state.stage, ...counts].join("|");
    const box = byId("stage-text");
    if (box.dataset["key"] === key) return;
    box.dataset["key"] = key;
    const lines = counts.flatMap((line) => [element("span", {}, line), element("br")]);
    box.replaceChildren(
      element("h2", {}, `${state.stage + 1}. ${name}`),
      element("p", {}, text),
      element("div", { class: "counts" }, ...lines),
    );
  }
}

function resultRows(answer: RunAnswer): [string, string][] {
  const rows: [string, string][] = [];
  const { result, contact, depth, reach, slices } = answer;
  if (contact) rows.push(["Parts are", contact]);
  if (depth !== undefined) {
    if (depth === null) rows.push(["Depth", "a part has no area"]);
    else {
      rows.push([
        "Parts are",
        depth.overlapping ? "overlapping" : depth.distance === 0 ? "touching" : "apart",
      ]);
      rows.push(
        ["Shortest move", `(${depth.exact.join(", ")})`],
        ["Length", String(Number(depth.distance.toPrecision(9)))],
      );
    }
  }
  if (reach) rows.push(["Path", reach.reachable ? `${reach.path.length} places` : "there is none"]);
  if (slices) {
    const all = slices.reduce((sum, slice) => sum + slice.obstacles.coords.length / 2, 0);
    rows.push(["Slices", number(slices.length)], ["Their vertices", number(all)]);
  }
  if (result) {
    const polygons = result.polygons.length - 1;
    rows.push(
      ["Polygons", number(polygons)],
      ["Holes", number(result.rings.length - 1 - polygons)],
    );
    rows.push(["Vertices", number(result.coords.length / 2)]);
    if (result.lines.length > 1) rows.push(["Polylines", number(result.lines.length - 1)]);
    if (result.points.length > 0) rows.push(["Points", number(result.points.length / 2)]);
  }
  rows.push(["Computed in", milliseconds(answer.milliseconds)]);
  return rows;
}
export const toNumbers = (p: [any, any]): [number, number] => [toNumber(p[0]), toNumber(p[1])];
