// Reads GeoJSON whose coordinates are doubles, which nearly all are.
import type { Flat } from "./types.js";

/** Flat arrays that have no strings. */
export type FlatDoubles = Record<keyof Flat, ArrayLike<number>>;

/** The doubles of GeoJSON in flat arrays. Their memory is kept from one operand to the next. */
export class Doubles {
  private xy = new Float64Array(256);
  private used = 0;
  private rings: number[] = [];
  private polygons: number[] = [];
  private lineCoords: number[] = [];
  private lines: number[] = [];
  private points: number[] = [];

  /** Returns flat arrays, which are valid until the next call. Returns nothing for what has other
   * numbers, or is not what it must be. */
  read(value: unknown, dropZ: boolean): FlatDoubles | undefined {
    this.used = 0;
    this.rings = [0];
    this.polygons = [0];
    this.lineCoords = [];
    this.lines = [0];
    this.points = [];
    if (!this.add(value, dropZ, 0)) return undefined;
    const { rings, polygons, lineCoords, lines, points } = this;
    return { coords: this.xy.subarray(0, this.used), rings, polygons, lineCoords, lines, points };
  }

  private add(value: any, dropZ: boolean, depth: number): boolean {
    if (depth > 32) return false;
    switch (value?.type) {
      case "Polygon":
        return this.addPolygon(value.coordinates, dropZ);
      case "MultiPolygon":
        return every(value.coordinates, (rings) => this.addPolygon(rings, dropZ));
      case "Feature":
        return value.geometry === null || this.add(value.geometry, dropZ, depth + 1);
      case "FeatureCollection":
        return every(value.features, (feature) => this.add(feature, dropZ, depth + 1));
      case "GeometryCollection":
        return every(value.geometries, (part) => this.add(part, dropZ, depth + 1));
      case "LineString":
        return this.addLine(value.coordinates, dropZ);
      case "MultiLineString":
        return every(value.coordinates, (line) => this.addLine(line, dropZ));
      case "Point":
        if (Array.isArray(value.coordinates) && value.coordinates.length === 0) return true;
        return this.addPoints([value.coordinates], dropZ);
      case "MultiPoint":
        return this.addPoints(value.coordinates, dropZ);
    }
    return false;
  }
  private addPolygon(rings: any, dropZ: boolean): boolean {
    if (!Array.isArray(rings)) return false;
    for (const ring of rings) {
      const first = this.used;
      const { xy } = this.roomFor(ring?.length);
      const end = write(ring, dropZ, xy, first);
      if (end <= first) return false;
      if (xy[first] !== xy[end - 2] || xy[first + 1] !== xy[end - 1]) return false;
      this.used = end > first + 2 ? end - 2 : end;
      this.rings.push(this.used / 2);
    }
    if (rings.length > 0) this.polygons.push(this.rings.length - 1);
    return true;
  }
  private addLine(line: any, dropZ: boolean): boolean {
    const before = this.lineCoords.length;
    const end = write(line, dropZ, this.lineCoords, before);
    if (end > before) this.lines.push(end / 2);
    return end >= before;
  }
  private addPoints(points: any, dropZ: boolean): boolean {
    const before = this.points.length;
    return write(points, dropZ, this.points, before) >= before;
  }
  private roomFor(positions: unknown): this {
    const needed = this.used + 2 * (typeof positions === "number" ? positions : 0);
    if (needed > this.xy.length) {
      const larger = new Float64Array(Math.max(needed, 2 * this.xy.length));
      larger.set(this.xy.subarray(0, this.used));
      this.xy = larger;
    }
    return this;
  }
}

function every(list: any, take: (value: any) => boolean): boolean {
  if (!Array.isArray(list)) return false;
  for (const value of list) if (!take(value)) return false; // `every` would skip what is missing
  return true;
}

/** Writes positions to `xy` from index `at` on. Returns the index behind the last; -1 if a position
 * is not two doubles. */
function write(positions: any, dropZ: boolean, xy: Float64Array | number[], at: number): number {
  if (!Array.isArray(positions)) return -1;
  for (let i = 0; i < positions.length; ++i) {
    const position = positions[i];
    if (!Array.isArray(position)) return -1;
    if (position.length !== 2 && !(dropZ && position.length > 2)) return -1;
    const x = position[0];
    const y = position[1];
    if (typeof x !== "number" || typeof y !== "number") return -1;
    if (!Number.isFinite(x) || !Number.isFinite(y)) return -1;
    xy[at++] = x;
    xy[at++] = y;
  }
  return at;
}
