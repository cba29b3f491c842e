// What lies under the pointer. Only doubles: nothing here is part of a result.
import { toNumber, verticesOf, type Position, type Shape, type Vertex } from "./model.js";

export interface VertexHit {
  vertex: Vertex;
  distance: number;
}
export interface EdgeHit extends VertexHit {
  /** the nearest place on the edge behind the vertex */
  at: [number, number];
}

/** Returns the vertex that is nearest to a place. */
export function nearestVertex(shape: Shape, x: number, y: number): VertexHit | null {
  let best: VertexHit | null = null;
  for (const [vertex, p] of verticesOf(shape)) {
    const distance = Math.hypot(toNumber(p[0]) - x, toNumber(p[1]) - y);
    if (!best || distance < best.distance) best = { vertex, distance };
  }
  return best;
}

/** Returns the nearest place of the segment from a to b. */
export function nearestOnSegment(
  x: number,
  y: number,
  ax: number,
  ay: number,
  bx: number,
  by: number,
): [number, number] {
  const [dx, dy] = [bx - ax, by - ay];
  const length = dx * dx + dy * dy;
  const t = length === 0 ? 0 : Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / length));
  return [ax + t * dx, ay + t * dy];
}

/** Returns the edge that is nearest to a place, by the vertex at which it begins. */
export function nearestEdge(shape: Shape, x: number, y: number): EdgeHit | null {
  let best: EdgeHit | null = null;
  const look = (path: Position[], closed: boolean, vertex: (index: number) => Vertex) => {
    for (let i = 0; i + (closed ? 0 : 1) < path.length; ++i) {
      const [a, b] = [path[i]!, path[(i + 1) % path.length]!];
      const at = nearestOnSegment(
        x,
        y,
        toNumber(a[0]),
        toNumber(a[1]),
        toNumber(b[0]),
        toNumber(b[1]),
      );
      const distance = Math.hypot(at[0] - x, at[1] - y);
      if (!best || distance < best.distance) best = { vertex: vertex(i), distance, at };
    }
  };
  for (const [part, rings] of shape.polygons.entries()) {
    for (const [ring, path] of rings.entries()) {
      look(path, true, (index) => ({ kind: "polygons", part, ring, index }));
    }
  }
  for (const [part, path] of shape.lines.entries()) {
    look(path, false, (index) => ({ kind: "lines", part, ring: 0, index }));
  }
  return best;
}

function crossings(path: Position[], x: number, y: number): number {
  let count = 0;
  for (let i = 0; i < path.length; ++i) {
    const [ax, ay] = path[i]!.map(toNumber) as [number, number];
    const [bx, by] = path[(i + 1) % path.length]!.map(toNumber) as [number, number];
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) ++count;
  }
  return count;
}
/** Returns the polygon that holds a place, by the first vertex of its outer ring. */
export function polygonAt(shape: Shape, x: number, y: number): Vertex | null {
  for (let part = shape.polygons.length - 1; part >= 0; --part) {
    const inside =
      shape.polygons[part]!.reduce((sum, ring) => sum + crossings(ring, x, y), 0) % 2 === 1;
    if (inside) return { kind: "polygons", part, ring: 0, index: 0 };
  }
  return null;
}

/** Returns x and y in turn as positions. */
export function pairs(xy: number[]): Position[] {
  const made: Position[] = [];
  for (let v = 0; v < xy.length; v += 2) made.push([xy[v]!, xy[v + 1]!]);
  return made;
}
export const same = (a: Vertex, b: Vertex) =>
  a.kind === b.kind && a.part === b.part && a.ring === b.ring && a.index === b.index;
