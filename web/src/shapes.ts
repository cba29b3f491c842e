// Shapes and results as paths on the screen.
import type { FlatResult } from "minksum";
import { toNumber, type Position, type Shape } from "./model.js";
import { PathText } from "./scene.js";
import type { View } from "./view.js";

/** A shape in doubles, for drawing: one list of x and y in turn for each path. */
export interface Outline {
  rings: number[][];
  lines: number[][];
  points: number[];
}
const cache = new WeakMap<Shape, Outline>();

export function outlineOf(shape: Shape): Outline {
  let made = cache.get(shape);
  if (made === undefined) {
    const xy = (path: Position[]) => path.flatMap((p) => [toNumber(p[0]), toNumber(p[1])]);
    made = {
      rings: shape.polygons.flat().map(xy),
      lines: shape.lines.map(xy),
      points: xy(shape.points),
    };
    cache.set(shape, made);
  }
  return made;
}
export const listsOf = (outline: Outline): number[][] => [
  ...outline.rings,
  ...outline.lines,
  outline.points,
];

/** Turns an outline about (0, 0) and moves it. */
export function posed(outline: Outline, x: number, y: number, degrees = 0): Outline {
  const angle = (degrees * Math.PI) / 180;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const map = (xy: number[]) =>
    xy.map((value, i) =>
      i % 2 === 0 ? x + c * value - s * xy[i + 1]! : y + s * xy[i - 1]! + c * value,
    );
  return {
    rings: outline.rings.map(map),
    lines: outline.lines.map(map),
    points: map(outline.points),
  };
}

/** The areas of an outline; then its polylines; then its points as dots. */
export function outlinePaths(
  view: View,
  outline: Outline,
): { area: string; lines: string; dots: string } {
  const area = new PathText(view);
  for (const ring of outline.rings) area.add(ring);
  const lines = new PathText(view);
  for (const line of outline.lines) lines.add(line, 0, line.length / 2, false);
  return {
    area: area.toString(),
    lines: lines.toString(),
    dots: new PathText(view).dots(outline.points).toString(),
  };
}
export function flatPaths(view: View, flat: FlatResult) {
  const area = new PathText(view);
  for (let r = 0; r + 1 < flat.rings.length; ++r)
    area.add(flat.coords, flat.rings[r]!, flat.rings[r + 1]!);
  const lines = new PathText(view);
  for (let l = 0; l + 1 < flat.lines.length; ++l) {
    lines.add(flat.lineCoords, flat.lines[l]!, flat.lines[l + 1]!, false);
  }
  const dots = new PathText(view).dots(flat.points);
  return {
    area: area.toString(),
    lines: lines.toString(),
    dots: dots.toString(),
    vertices: area.vertices,
  };
}
/** A cross at a place, in pixels. */
export function cross(view: View, x: number, y: number, size = 7): string {
  const [px, py] = view.toScreen(x, y);
  return `M${px - size} ${py}h${2 * size}M${px} ${py - size}v${2 * size}`;
}
export function circle(view: View, x: number, y: number, radius: number): string {
  const [px, py] = view.toScreen(x, y);
  return (
    `M${px - radius} ${py}a${radius} ${radius} 0 1 0 ${2 * radius} 0a${radius} ${radius} 0 ` +
    `1 0 ${-2 * radius} 0Z`
  );
}
/** An arrow from one place to another, in pixels. */
export function arrow(view: View, from: [number, number], to: [number, number]): string {
  const [ax, ay] = view.toScreen(...from);
  const [bx, by] = view.toScreen(...to);
  const length = Math.hypot(bx - ax, by - ay);
  if (length < 0.5) return "";
  const [ux, uy] = [(bx - ax) / length, (by - ay) / length];
  const head = Math.min(12, length);
  const wing = (side: number) =>
    `${bx - head * ux + side * 0.5 * head * uy} ${by - head * uy - side * 0.5 * head * ux}`;
  return `M${ax} ${ay}L${bx} ${by}M${wing(1)}L${bx} ${by}L${wing(-1)}`;
}
