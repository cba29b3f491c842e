// Puts operands into the module's memory.
import type { Address, Library } from "./abi.js";
import { checkNames, checkOptions, isList, kSides, oneOf, shown } from "./arguments.js";
import { Doubles, type FlatDoubles } from "./doubles.js";
import { badInput } from "./errors.js";
import { equal, exactText, isExact } from "./exact.js";
import type { Flat, Operand, Position, ReadOptions } from "./types.js";

const encoder = new TextEncoder();
const kLists = ["coords", "rings", "polygons", "lineCoords", "lines", "points"] as const;

/** What GeoJSON holds, with numbers of any kind. It tells what is wrong, and where. Rings do not
 * repeat their first position. */
class Parts {
  readonly polygons: Position[][][] = [];
  readonly lines: Position[][] = [];
  readonly points: Position[] = [];

  constructor(
    private readonly operand: number,
    private readonly dropZ: boolean,
  ) {}

  add(value: any, depth = 0): void {
    if (depth > 32) throw this.bad("collections are nested more than 32 deep");
    switch (value?.type) {
      case "Feature":
        if (value.geometry !== null) this.add(value.geometry, depth + 1);
        return;
      case "FeatureCollection":
        for (const feature of this.list(value.features, "features")) this.add(feature, depth + 1);
        return;
      case "GeometryCollection":
        for (const part of this.list(value.geometries, "geometries")) this.add(part, depth + 1);
        return;
      case "Polygon":
        return this.addPolygon(value.coordinates);
      case "MultiPolygon":
        for (const rings of this.list(value.coordinates, "coordinates")) this.addPolygon(rings);
        return;
      case "LineString":
        return this.addLine(value.coordinates);
      case "MultiLineString":
        for (const line of this.list(value.coordinates, "coordinates")) this.addLine(line);
        return;
      case "Point":
        if (this.list(value.coordinates, "coordinates").length > 0) {
          this.points.push(this.position(value.coordinates, {}));
        }
        return;
      case "MultiPoint":
        for (const point of this.positions(value.coordinates)) this.points.push(point);
        return;
    }
    throw this.bad(`an operand of the type ${shown(value?.type)} is not known`);
  }
  private bad(message: string, place = {}) {
    return badInput(message, { operand: this.operand, ...place });
  }
  private list(value: any, name: string): any[] {
    if (!Array.isArray(value)) throw this.bad(`\`${name}\` is not an array`);
    return Array.from(value); // what is missing becomes undefined
  }
  private positions(value: any, place = {}): Position[] {
    const positions = this.list(value, "coordinates");
    return positions.map((position, vertex) => this.position(position, { ...place, vertex }));
  }
  private addPolygon(rings: any): void {
    const polygon = this.polygons.length;
    const read = this.list(rings, "coordinates").map((ring, r) => {
      const place = { polygon, ring: r };
      const positions = this.positions(ring, place);
      const [first, last] = [positions[0], positions[positions.length - 1]];
      if (positions.length === 0) throw this.bad("a ring is empty", place);
      if (!equal(first![0]!, last![0]!) || !equal(first![1]!, last![1]!)) {
        const name = `polygon ${polygon + 1}, ring ${r + 1}`;
        throw this.bad(`${name} is not closed: its last point must repeat the first`, place);
      }
      if (positions.length > 1) positions.pop();
      return positions;
    });
    if (read.length > 0) this.polygons.push(read);
  }
  private addLine(line: any): void {
    const positions = this.positions(line);
    if (positions.length === 1) throw this.bad("a polyline has two points or more");
    if (positions.length > 0) this.lines.push(positions);
  }
  private position(value: any, place: object): Position {
    if (!Array.isArray(value) || value.length < 2) throw this.bad("a position has no x and y", place);
    if (value.length > 2 && !this.dropZ) {
      throw this.bad('a position has more than x and y; {z: "drop"} drops the rest', place);
    }
    for (const coordinate of [value[0], value[1]]) {
      if (typeof coordinate === "string") {
        if (!isExact(coordinate)) throw this.bad(`${shown(coordinate)} is not a number`, place);
      } else if (typeof coordinate !== "number" || !Number.isFinite(coordinate)) {
        throw this.bad(`a coordinate is not a finite number: ${shown(coordinate)}`, place);
      }
    }
    return value;
  }

  /** WKT in which every number stands exactly. */
  wkt(): string {
    const path = (positions: Position[], close: boolean) =>
      "(" +
      (close ? [...positions, positions[0]!] : positions)
        .map(([x, y]) => `${exactText(x!)} ${exactText(y!)}`)
        .join(", ") +
      ")";
    const texts = [];
    const rings = (polygon: Position[][]) => `(${polygon.map((r) => path(r, true)).join(", ")})`;
    const points = this.points.map((point) => path([point], false));
    if (this.polygons.length > 0) texts.push(`MULTIPOLYGON (${this.polygons.map(rings).join(", ")})`);
    for (const line of this.lines) texts.push(`LINESTRING ${path(line, false)}`);
    if (points.length > 0) texts.push(`MULTIPOINT (${points.join(", ")})`);
    if (texts.length === 1) return texts[0]!;
    return texts.length === 0
      ? "GEOMETRYCOLLECTION EMPTY"
      : `GEOMETRYCOLLECTION (${texts.join(", ")})`;
  }
}

export class Operands {
  private readonly doubles = new Doubles();

  constructor(
    private readonly library: Library,
    /** returns the address of something prepared, or nothing if `value` is something else */
    private readonly prepared: (value: unknown) => Address | undefined,
  ) {}

  /** Calls `work` with the addresses of all operands, and frees them. */
  with<T>(operands: unknown[], options: ReadOptions, work: (addresses: Address[]) => T): T {
    checkOptions(options);
    const made: Address[] = [];
    try {
      const addresses = operands.map((operand, index) => {
        const known = this.prepared(operand);
        if (known !== undefined) return known;
        const address = this.make(operand as Operand, index, options);
        made.push(address);
        return address;
      });
      return work(addresses);
    } finally {
      for (const address of made) this.library.call["minksum_geometry_free"]!(address);
    }
  }

  /** Makes a geometry, which the caller frees. */
  make(operand: Operand, index: number, options: ReadOptions): Address {
    if (operand === null || operand === undefined) {
      throw new TypeError(`operand ${index} is ${operand}`);
    }
    if (typeof operand === "string") return this.read(encoder.encode(operand), index, options);
    if (operand instanceof Uint8Array) return this.read(operand, index, options);
    if (typeof operand !== "object") throw new TypeError(`operand ${index} is a ${typeof operand}`);
    if (!("type" in operand)) {
      if ("coords" in operand) return this.makeFlat(operand as Flat, index, options);
      throw badInput("an operand has neither `type` nor `coords`", { operand: index });
    }
    const flat = this.doubles.read(operand, options.z === "drop");
    if (flat !== undefined) return this.putFlat(flat, index);
    const parts = new Parts(index, options.z === "drop");
    parts.add(operand);
    return this.read(encoder.encode(parts.wkt()), index, options);
  }

  /** Flat arrays with other things than numbers go the way of text, which tells where those are. */
  private text(flat: Required<Flat>, index: number): string {
    const parts = new Parts(index, false);
    const at = (list: ArrayLike<any>, i: number) => [list[2 * i], list[2 * i + 1]];
    const range = (list: ArrayLike<any>, from: number, to: number) =>
      Array.from({ length: to - from }, (_, i) => at(list, from + i));
    const { coords, rings, polygons, lineCoords, lines, points } = flat;
    for (let p = 0; p + 1 < polygons.length; ++p) {
      const list = [];
      for (let r = polygons[p]!; r < polygons[p + 1]!; ++r) {
        list.push([...range(coords, rings[r]!, rings[r + 1]!), at(coords, rings[r]!)]);
      }
      parts.add({ type: "Polygon", coordinates: list });
    }
    for (let l = 0; l + 1 < lines.length; ++l) {
      const coordinates = range(lineCoords, lines[l]!, lines[l + 1]!);
      parts.add({ type: "LineString", coordinates });
    }
    parts.add({ type: "MultiPoint", coordinates: range(points, 0, points.length / 2) });
    return parts.wkt();
  }

  private read(text: Uint8Array, index: number, options: ReadOptions): Address {
    const { library } = this;
    return library.withRoom(text.length + 32, (address) => {
      const how = address / 8;
      library.f64[how] = options.curveTolerance ?? 0;
      library.f64[how + 1] = options.joinEnds ?? 0;
      library.u32[2 * how + 4] = oneOf(kSides, options.curveSide ?? "nearest", "curveSide");
      library.u32[2 * how + 5] = options.z === "drop" ? 1 : 0;
      library.u32.fill(0, 2 * how + 6, 2 * how + 8);  // no column, no layer
      library.u8.set(text, address + 32);
      const { results, error } = library;
      const status = library.call["minksum_read_as"]!(address + 32, text.length, address, results, error);
      library.check(status, index);
      return library.u32[results >>> 2]!;
    });
  }

  private makeFlat(flat: Flat, index: number, options: ReadOptions): Address {
    const isKnown = (name: string) => (kLists as readonly string[]).includes(name);
    checkNames(flat, isKnown, "flat array", { operand: index });
    const { coords, rings, polygons, lineCoords = [], lines = [0], points = [] } = flat;
    const lists = { coords, rings, polygons, lineCoords, lines, points };
    for (const name of kLists) {
      if (!isList(lists[name])) throw badInput(`\`${name}\` is no array`, { operand: index });
    }
    this.checkOffsets(rings.length - 1, polygons, "polygons", "polygon", index);
    this.checkOffsets(coords.length / 2, rings, "rings", "ring", index, polygons);
    this.checkOffsets(lineCoords.length / 2, lines, "lines", "polyline", index);
    if (points.length % 2 !== 0) throw badInput("`points` has an odd length", { operand: index });
    return isDoubles(coords) && isDoubles(lineCoords) && isDoubles(points)
      ? this.putFlat(lists as FlatDoubles, index)
      : this.read(encoder.encode(this.text(lists, index)), index, options);
  }
  /** Makes a geometry of flat arrays whose offsets are known to be good. */
  private putFlat(flat: FlatDoubles, index: number): Address {
    const { library } = this;
    const { coords, rings, polygons } = flat;
    const bytes = 8 * (coords.length + rings.length + polygons.length);
    const geometry = library.withRoom(bytes, (address) => {
      const xy = address / 8;
      library.f64.set(coords, xy);
      const ringsAt = this.putOffsets(rings, address + 8 * coords.length);
      const polygonsAt = this.putOffsets(polygons, ringsAt + 8 * rings.length);
      const status = library.call["minksum_geometry_polygons"]!(
        address, ringsAt, Math.max(rings.length - 1, 0), polygonsAt,
        Math.max(polygons.length - 1, 0), library.results, library.error,
      );
      library.check(status, index);
      return library.u32[library.results >>> 2]!;
    });
    try {
      this.addThin(geometry, flat, index);
    } catch (error) {
      library.call["minksum_geometry_free"]!(geometry);
      throw error;
    }
    return geometry;
  }
  private addThin(geometry: Address, flat: FlatDoubles, index: number): void {
    const { library } = this;
    const add = (name: string, list: ArrayLike<number>, from: number, to: number) =>
      library.withRoom(16 * (to - from), (address) => {
        const { f64 } = library;
        for (let i = 2 * from; i < 2 * to; ++i) f64[address / 8 + i - 2 * from] = list[i]!;
        library.check(library.call[name]!(geometry, address, to - from, library.error), index);
      });
    const { lineCoords, lines, points } = flat;
    for (let l = 0; l + 1 < lines.length; ++l) {
      add("minksum_geometry_add_polyline", lineCoords, lines[l]!, lines[l + 1]!);
    }
    if (points.length > 0) add("minksum_geometry_add_points", points, 0, points.length / 2);
  }
  /** The library reads the arrays up to the last offset, so that must lie within them. */
  private checkOffsets(
    last: number, offsets: ArrayLike<number>, name: string, part: string, operand: number,
    polygons?: ArrayLike<number>,
  ): void {
    let before = 0;
    for (let i = 0; i < offsets.length; ++i) {
      const offset = offsets[i]!;
      if (!(offset >= before && (i > 0 || offset === 0) && Number.isInteger(offset))) {
        throw badInput(`\`${name}\` goes back or does not begin with 0 at index ${i}`, { operand });
      }
      if (i > 0 && offset === before) throw empty(i - 1, part, operand, polygons);
      before = offset;
    }
    if (offsets.length === 0 || before !== last) {
      throw badInput(`\`${name}\` ends with ${before}, but there are ${last}`, { operand });
    }
  }
  private putOffsets(offsets: ArrayLike<number>, address: Address): Address {
    const { u32 } = this.library;
    for (let i = 0, at = address >>> 2; i < offsets.length; ++i) {
      u32[at++] = offsets[i]!;
      u32[at++] = 0;
    }
    return address;
  }
}

function isDoubles(list: ArrayLike<unknown>): boolean {
  if (ArrayBuffer.isView(list)) return list.length === 0 || typeof list[0] === "number";
  for (let i = 0; i < list.length; ++i) if (typeof list[i] !== "number") return false;
  return true;
}
/** The error of a part that has nothing. Rings are counted in their polygon. */
function empty(index: number, part: string, operand: number, polygons?: ArrayLike<number>) {
  if (polygons === undefined) {
    const place = part === "polygon" ? { operand, polygon: index } : { operand };
    return badInput(`${part} ${index + 1} is empty`, place);
  }
  let polygon = 0;
  while (polygons[polygon + 1]! <= index) ++polygon;
  const ring = index - polygons[polygon]!;
  return badInput(`polygon ${polygon + 1}, ring ${ring + 1} is empty`, { operand, polygon, ring });
}
