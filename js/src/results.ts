// Takes results out of the module's memory.
import type { Address, Library } from "./abi.js";
import type {
  ExactFlatResult, FlatResult, Geometry, LineString, Origin, Point, Polygon, Position, ResultOf,
  ResultOptions,
} from "./types.js";

const kWkt = 0;
const kSvg = 3;

export class Results {
  constructor(private readonly library: Library) {}

  /** Returns what options ask for, and frees the geometry. */
  take<O extends ResultOptions>(geometry: Address, options: O): ResultOf<O> {
    try {
      return this.convert(geometry, options);
    } finally {
      this.library.call["minksum_geometry_free"]!(geometry);
    }
  }
  /** The same, without freeing it. */
  convert<O extends ResultOptions>(geometry: Address, options: O): ResultOf<O> {
    const exact = options.coords === "exact";
    switch (options.as) {
      case "flat":
        return (exact ? this.exactFlat(geometry) : this.flat(geometry)) as ResultOf<O>;
      case "wkt":
        return this.write(geometry, kWkt, exact) as ResultOf<O>;
      case "svg":
        return this.write(geometry, kSvg, false) as ResultOf<O>;
      default:
        return geojson(exact ? this.exactFlat(geometry) : this.flat(geometry)) as ResultOf<O>;
    }
  }

  write(geometry: Address, format: number, exact: boolean): string {
    const { library } = this;
    const { results, error } = library;
    const status = library.call["minksum_write"]!(
      geometry, format, exact ? 1 : 0, 0, results, results + 4, error,
    );
    library.check(status);
    const text = library.u32[results >>> 2]!;
    const written = library.text(text, library.u32[(results >>> 2) + 1]!);
    library.call["minksum_text_free"]!(text);
    return written;
  }

  flat(geometry: Address): FlatResult {
    return this.arrays(geometry, (count, from) => this.library.doubles(from, count));
  }
  private arrays(
    geometry: Address, doubles: (count: number, from: Address) => Float64Array,
  ): FlatResult {
    const { library } = this;
    const { results, error, call } = library;
    call["minksum_geometry_counts"]!(results, geometry);
    const { u32 } = library;
    const at = results >>> 2;
    const polygons = u32[at]!;
    const rings = u32[at + 1]!;
    const vertices = u32[at + 2]!;
    const lines = u32[at + 3]!;
    const lineVertices = u32[at + 4]!;
    const points = u32[at + 5]!;
    const offsets = (count: number, from: Address) => {
      const made = new Uint32Array(count);
      const { u32 } = library;
      for (let i = 0, at = from >>> 2; i < count; ++i, at += 2) made[i] = u32[at]!;
      return made;
    };
    const made: FlatResult = {
      coords: new Float64Array(),
      rings: new Uint32Array(1),
      polygons: new Uint32Array(1),
      lineCoords: new Float64Array(),
      lines: new Uint32Array(1),
      points: new Float64Array(),
    };
    if (vertices + polygons > 0) {
      library.withRoom(8 * (2 * vertices + rings + polygons + 2), (xy) => {
        const ringsAt = xy + 16 * vertices;
        const polygonsAt = ringsAt + 8 * (rings + 1);
        const get = call["minksum_geometry_get_polygons"]!;
        library.check(get(geometry, xy, ringsAt, polygonsAt, error));
        made.coords = doubles(2 * vertices, xy);
        made.rings = offsets(rings + 1, ringsAt);
        made.polygons = offsets(polygons + 1, polygonsAt);
      });
    }
    if (lines > 0) {
      library.withRoom(8 * (2 * lineVertices + lines + 1), (xy) => {
        const linesAt = xy + 16 * lineVertices;
        library.check(call["minksum_geometry_get_polylines"]!(geometry, xy, linesAt, error));
        made.lineCoords = doubles(2 * lineVertices, xy);
        made.lines = offsets(lines + 1, linesAt);
      });
    }
    if (points > 0) {
      library.withRoom(16 * points, (xy) => {
        library.check(call["minksum_geometry_get_points"]!(geometry, xy, error));
        made.points = doubles(2 * points, xy);
      });
    }
    return made;
  }

  /** The numbers stand in the text in the order of the arrays; rings repeat their first vertex. */
  exactFlat(geometry: Address): ExactFlatResult {
    const none = (count: number) => new Float64Array(count);
    const { rings, polygons, lines, points } = this.arrays(geometry, none);
    const numbers = this.write(geometry, kWkt, true).match(/-?\d[\d/]*/g) ?? [];
    let next = 0;
    const take = (count: number, list: string[]) => {
      for (let i = 0; i < count; ++i) list.push(numbers[next++]!);
    };
    const made: ExactFlatResult = { coords: [], rings, polygons, lineCoords: [], lines, points: [] };
    for (let r = 0; r + 1 < rings.length; ++r) {
      take(2 * (rings[r + 1]! - rings[r]!), made.coords);
      next += 2;
    }
    take(2 * lines[lines.length - 1]!, made.lineCoords);
    take(points.length, made.points);
    return made;
  }

  /** Where the edges of a sum came from, or nothing if it does not tell. */
  origins(geometry: Address): Origin[] | null {
    const { library } = this;
    const { results, error, call } = library;
    call["minksum_geometry_counts"]!(results, geometry);
    const vertices = library.u32[(results >>> 2) + 2]!;
    return library.withRoom(12 * vertices, (address) => {
      library.check(call["minksum_geometry_get_origins"]!(geometry, address, results, error));
      if (library.u32[results >>> 2] === 0) return null;
      const words = library.u32.subarray(address >>> 2, (address >>> 2) + 3 * vertices);
      return Array.from({ length: vertices }, (_, v) => ({
        edgeOperand: words[3 * v] as 0 | 1,
        edge: words[3 * v + 1]!,
        vertex: words[3 * v + 2]!,
      }));
    });
  }
}

/** Returns flat arrays as GeoJSON. */
export function geojson(flat: FlatResult | ExactFlatResult): Geometry {
  const { coords, rings, polygons, lineCoords, lines, points } = flat;
  const areas: Position[][][] = [];
  for (let p = 0; p + 1 < polygons.length; ++p) {
    const area: Position[][] = [];
    for (let r = polygons[p]!; r < polygons[p + 1]!; ++r) {
      area.push(positions(coords, rings[r]!, rings[r + 1]!, true));
    }
    areas.push(area);
  }
  const paths: Position[][] = [];
  for (let l = 0; l + 1 < lines.length; ++l) {
    paths.push(positions(lineCoords, lines[l]!, lines[l + 1]!, false));
  }
  const places = positions(points, 0, points.length / 2, false);
  const made: Geometry[] = [];
  if (areas.length === 1) made.push({ type: "Polygon", coordinates: areas[0]! } satisfies Polygon);
  if (areas.length > 1) made.push({ type: "MultiPolygon", coordinates: areas });
  if (paths.length === 1) made.push({ type: "LineString", coordinates: paths[0]! } satisfies LineString);
  if (paths.length > 1) made.push({ type: "MultiLineString", coordinates: paths });
  if (places.length === 1) made.push({ type: "Point", coordinates: places[0]! } satisfies Point);
  if (places.length > 1) made.push({ type: "MultiPoint", coordinates: places });
  if (made.length === 1) return made[0]!;
  return made.length === 0
    ? { type: "Polygon", coordinates: [] }
    : { type: "GeometryCollection", geometries: made };
}
/** Returns points of a list. A ring is closed by a copy of its first point. */
function positions(
  list: ArrayLike<number | string>, from: number, to: number, close: boolean,
): Position[] {
  const made: Position[] = [];
  for (let v = from; v < to; ++v) made.push([list[2 * v]!, list[2 * v + 1]!]);
  if (close && from < to) made.push([list[2 * from]!, list[2 * from + 1]!]);
  return made;
}
