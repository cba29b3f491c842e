// Draws marks: as SVG, and on a canvas what has too many vertices for that.
import type { View } from "./view.js";

export interface Mark {
  /** classes of the style sheet */
  cls: string;
  /** a path in pixels, or nothing for text */
  d?: string;
  text?: string;
  x?: number;
  y?: number;
}
/** Above so many vertices a path goes to the canvas. */
export const kMostInSvg = 20_000;

const kSvg = "http://www.w3.org/2000/svg";
const round = (value: number) => Math.round(value * 10) / 10;

/** Paths as text of SVG. */
export class PathText {
  private readonly texts: string[] = [];
  vertices = 0;
  constructor(private readonly view: View) {}
  /** Adds x and y in turn, from one vertex to another. */
  add(xy: ArrayLike<number>, from = 0, to = xy.length / 2, close = true): this {
    const { x, y, scale } = this.view;
    let text = "";
    for (let v = from; v < to; ++v) {
      const px = round(x + xy[2 * v]! * scale);
      const py = round(y - xy[2 * v + 1]! * scale);
      text += `${v === from ? "M" : "L"}${px} ${py}`;
    }
    this.vertices += to - from;
    this.texts.push(close ? text + "Z" : text);
    return this;
  }
  /** Adds dots: with round ends of lines they are discs as wide as the stroke. */
  dots(xy: ArrayLike<number>): this {
    const { x, y, scale } = this.view;
    for (let v = 0; 2 * v + 1 < xy.length; ++v) {
      this.texts.push(`M${round(x + xy[2 * v]! * scale)} ${round(y - xy[2 * v + 1]! * scale)}h0`);
    }
    this.vertices += xy.length / 2;
    return this;
  }
  toString(): string {
    return this.texts.join("");
  }
}

export class Scene {
  private readonly groups = new Map<string, { group: SVGGElement; made: SVGElement[] }>();

  constructor(
    private readonly svg: SVGSVGElement,
    private readonly canvas: HTMLCanvasElement,
    layers: string[],
  ) {
    for (const name of layers) {
      const group = document.createElementNS(kSvg, "g");
      group.setAttribute("class", `layer-${name}`);
      svg.append(group);
      this.groups.set(name, { group, made: [] });
    }
  }
  resize(width: number, height: number): void {
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const ratio = devicePixelRatio;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
  }
  /** Shows these marks in a layer, with as few changes of elements as possible. */
  show(layer: string, marks: Mark[]): void {
    const { group, made } = this.groups.get(layer)!;
    for (const [i, mark] of marks.entries()) {
      const tag = mark.text === undefined ? "path" : "text";
      let element = made[i];
      if (element?.tagName !== tag) {
        const fresh = document.createElementNS(kSvg, tag);
        if (element) element.replaceWith(fresh);
        else group.append(fresh);
        made[i] = element = fresh;
      }
      set(element, "class", mark.cls);
      if (mark.text === undefined) {
        set(element, "d", mark.d!);
      } else {
        if (element.textContent !== mark.text) element.textContent = mark.text;
        set(element, "x", String(round(mark.x!)));
        set(element, "y", String(round(mark.y!)));
      }
    }
    for (const extra of made.splice(marks.length)) extra.remove();
  }
  /** Draws marks with many vertices. */
  paint(marks: Mark[]): void {
    const context = this.canvas.getContext("2d")!;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.scale(devicePixelRatio, devicePixelRatio);
    for (const mark of marks) {
      const probe = document.createElementNS(kSvg, "path");
      probe.setAttribute("class", mark.cls);
      this.svg.append(probe);
      const { fill, fillOpacity, stroke, strokeWidth } = getComputedStyle(probe);
      const path = new Path2D(mark.d!);
      context.globalAlpha = Number(fillOpacity);
      context.fillStyle = fill;
      if (fill !== "none") context.fill(path, "evenodd");
      context.globalAlpha = 1;
      context.strokeStyle = stroke;
      context.lineWidth = Math.min(1, parseFloat(strokeWidth));
      if (stroke !== "none") context.stroke(path);
      probe.remove();
    }
  }
}
function set(element: Element, name: string, value: string): void {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}
