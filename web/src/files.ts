// What comes in from files, and what goes out.
import type { FlatResult } from "minksum";
import type { Failure } from "./jobs.js";
import type { State } from "./model.js";
import { languages, snippet, type Language } from "./snippets.js";
import { byId, element } from "./panel.js";

export function save(name: string, type: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = element("a", { href: address, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}

/** The drawing as a file: all that is on the screen, with the colours of the page. */
export function drawingAsSvg(svg: SVGSVGElement): string {
  const copy = svg.cloneNode(true) as SVGSVGElement;
  const properties = [
    "fill",
    "fill-opacity",
    "fill-rule",
    "stroke",
    "stroke-width",
    "stroke-dasharray",
    "stroke-opacity",
    "stroke-linejoin",
    "stroke-linecap",
    "opacity",
    "font-size",
    "font-weight",
  ];
  const [from, to] = [svg.querySelectorAll("path, text"), copy.querySelectorAll("path, text")];
  for (const [i, original] of [...from].entries()) {
    const style = getComputedStyle(original);
    for (const name of properties) to[i]!.setAttribute(name, style.getPropertyValue(name));
    to[i]!.removeAttribute("class");
  }
  for (const layer of copy.querySelectorAll(".layer-marks, .layer-hover")) layer.remove();
  for (const name of ["id", "tabindex", "role", "class", "aria-describedby"])
    copy.removeAttribute(name);
  const { width, height } = svg.viewBox.baseVal;
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", String(width));
  copy.setAttribute("height", String(height));
  const ground = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  for (const [name, value] of [
    ["width", "100%"],
    ["height", "100%"],
    ["fill", getComputedStyle(svg.parentElement!).backgroundColor],
  ]) {
    ground.setAttribute(name!, value!);
  }
  copy.prepend(ground);
  return new XMLSerializer().serializeToString(copy);
}

/** A result in doubles, for paths and slices, which have no exact text of their own. */
export function flatToWkt({ coords, rings, polygons }: FlatResult): string {
  const ring = (r: number) => {
    const list: string[] = [];
    for (let v = rings[r]!; v < rings[r + 1]!; ++v)
      list.push(`${coords[2 * v]} ${coords[2 * v + 1]}`);
    return `(${[...list, list[0]].join(", ")})`;
  };
  const parts: string[] = [];
  for (let p = 0; p + 1 < polygons.length; ++p) {
    const own = Array.from({ length: polygons[p + 1]! - polygons[p]! }, (_, i) =>
      ring(polygons[p]! + i),
    );
    parts.push(`(${own.join(", ")})`);
  }
  return parts.length ? `MULTIPOLYGON (${parts.join(", ")})` : "POLYGON EMPTY";
}

export class CodeBox {
  private language: Language = "Shell";
  private state: State | undefined;
  private placed = "";

  constructor(say: (text: string) => void) {
    for (const language of languages) {
      const button = element(
        "button",
        { type: "button", "aria-pressed": String(language === this.language) },
        language,
      );
      button.onclick = () => {
        this.language = language;
        for (const other of byId("languages").children)
          other.setAttribute("aria-pressed", String(other === button));
        this.show();
      };
      byId("languages").append(button);
    }
    byId("code-box").addEventListener("toggle", () => this.show());
    byId("copy-code").onclick = () => void copy(byId("code").textContent!, "The program", say);
  }
  update(state: State, placed: string): void {
    this.state = state;
    this.placed = placed;
    this.show();
  }
  private show(): void {
    if (!this.state || !byId<HTMLDetailsElement>("code-box").open) return;
    byId("code").textContent = snippet(this.language, this.state, this.placed);
  }
}

/** Copies a text; where that is not allowed, shows it to be copied by hand. */
export async function copy(text: string, what: string, say: (text: string) => void): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    say(`${what} is in the clipboard.`);
  } catch {
    say(`${what} could not be put into the clipboard. Copy it from the address line or by hand.`);
  }
}

/** Marks in a text where it is wrong, and says what is. */
export function showProblem(name: "a" | "b", problem: Failure | null): void {
  const area = byId<HTMLTextAreaElement>(`text-${name}`);
  const box = byId(`problem-${name}`);
  area.toggleAttribute("aria-invalid", false);
  box.hidden = problem === null;
  if (problem === null) return;
  area.setAttribute("aria-invalid", "true");
  area.setAttribute("aria-describedby", box.id);
  const { message, line, column, ring, vertex } = problem;
  const place = line
    ? `Line ${line}, column ${column}: `
    : vertex !== undefined
      ? `Ring ${ring}, vertex ${vertex}: `
      : "";
  box.textContent = place + message;
  if (!line) return;
  const lines = area.value.split("\n");
  const start =
    lines.slice(0, line - 1).reduce((sum, text) => sum + text.length + 1, 0) + (column ?? 1) - 1;
  if (document.activeElement === area || document.activeElement === document.body) {
    area.focus();
    area.setSelectionRange(start, Math.min(start + 1, area.value.length));
  }
}
