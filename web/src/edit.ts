// Changes of shapes. Each returns a new shape.
import { pathOf, type Position, type Shape, type Vertex } from "./model.js";

/** Returns a copy in which the path of a vertex was replaced. */
function withPath(shape: Shape, v: Vertex, path: Position[]): Shape {
  const { polygons, lines } = shape;
  if (v.kind === "points") return { ...shape, points: path };
  if (v.kind === "lines") {
    return {
      ...shape,
      lines: path.length < 2 ? lines.filter((_, i) => i !== v.part) : lines.with(v.part, path),
    };
  }
  const rings = polygons[v.part]!;
  // Without its outer ring a polygon is gone, and so are its holes.
  if (path.length < 3 && v.ring === 0)
    return { ...shape, polygons: polygons.filter((_, i) => i !== v.part) };
  const left = path.length < 3 ? rings.filter((_, i) => i !== v.ring) : rings.with(v.ring, path);
  return { ...shape, polygons: polygons.with(v.part, left) };
}
export const moveVertex = (shape: Shape, v: Vertex, to: Position): Shape =>
  withPath(shape, v, pathOf(shape, v).with(v.index, to));
/** Inserts a vertex behind another. */
export const insertVertex = (shape: Shape, v: Vertex, at: Position): Shape =>
  withPath(shape, v, pathOf(shape, v).toSpliced(v.index + 1, 0, at));
/** Removes a vertex; and with it what has too few vertices then. */
export const removeVertex = (shape: Shape, v: Vertex): Shape =>
  withPath(shape, v, pathOf(shape, v).toSpliced(v.index, 1));

/** Moves the part that holds a vertex: a polygon with its holes, a polyline, or a point. */
export function movePart(shape: Shape, v: Vertex, change: (p: Position) => Position): Shape {
  if (v.kind === "points")
    return { ...shape, points: shape.points.with(v.index, change(shape.points[v.index]!)) };
  if (v.kind === "lines")
    return { ...shape, lines: shape.lines.with(v.part, shape.lines[v.part]!.map(change)) };
  const rings = shape.polygons[v.part]!.map((ring) => ring.map(change));
  return { ...shape, polygons: shape.polygons.with(v.part, rings) };
}
export const addPolygon = (shape: Shape, ring: Position[]): Shape => ({
  ...shape,
  polygons: [...shape.polygons, [ring]],
});
export const addLine = (shape: Shape, line: Position[]): Shape =>
  line.length === 1
    ? { ...shape, points: [...shape.points, line[0]!] }
    : { ...shape, lines: [...shape.lines, line] };
export const addHole = (shape: Shape, polygon: number, ring: Position[]): Shape => ({
  ...shape,
  polygons: shape.polygons.with(polygon, [...shape.polygons[polygon]!, ring]),
});
