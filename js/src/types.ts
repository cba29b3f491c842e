/// <reference lib="esnext.disposable" preserve="true" />
/**
 * A coordinate. A number means exactly its double, so `0.1` is
 * 0.1000000000000000055…; a string is read exactly: `"0.1"` is one tenth and `"1/3"` one third.
 */
export type Coordinate = number | string;
/** x and y. */
export type Position = Coordinate[];

/** What any object of GeoJSON may have besides. */
type Boxed = { bbox?: number[] | undefined };
export type Polygon = Boxed & { type: "Polygon"; coordinates: Position[][] };
export type MultiPolygon = Boxed & { type: "MultiPolygon"; coordinates: Position[][][] };
export type LineString = Boxed & { type: "LineString"; coordinates: Position[] };
export type MultiLineString = Boxed & { type: "MultiLineString"; coordinates: Position[][] };
export type Point = Boxed & { type: "Point"; coordinates: Position };
export type MultiPoint = Boxed & { type: "MultiPoint"; coordinates: Position[] };
export type GeometryCollection = Boxed & { type: "GeometryCollection"; geometries: Geometry[] };
/** A geometry of GeoJSON. */
export type Geometry =
  | Polygon
  | MultiPolygon
  | LineString
  | MultiLineString
  | Point
  | MultiPoint
  | GeometryCollection;
export type Feature = Boxed & {
  type: "Feature";
  geometry: Geometry | null;
  id?: string | number | undefined;
  properties?: unknown;
};
export type FeatureCollection = Boxed & { type: "FeatureCollection"; features: Feature[] };

/**
 * Flat arrays. Ring r has the vertices from `rings[r]` up to, but without, `rings[r + 1]`, and no
 * vertex is repeated at its end. No ring is empty. Polygon p has the rings from `polygons[p]` on,
 * its outer ring first. Both arrays begin with 0. `lines` is to `lineCoords` what `rings` is to
 * `coords`.
 */
export interface Flat {
  /** x and y of each vertex of the rings in turn */
  coords: ArrayLike<Coordinate>;
  rings: ArrayLike<number>;
  polygons: ArrayLike<number>;
  /** x and y of each vertex of the polylines in turn */
  lineCoords?: ArrayLike<Coordinate>;
  lines?: ArrayLike<number>;
  /** x and y of each single point in turn */
  points?: ArrayLike<Coordinate>;
}
/** Flat arrays of a result. */
export interface FlatResult extends Flat {
  coords: Float64Array;
  rings: Uint32Array;
  polygons: Uint32Array;
  lineCoords: Float64Array;
  lines: Uint32Array;
  points: Float64Array;
}
/** Flat arrays of a result with exact coordinates, such as `"1/3"`. */
export interface ExactFlatResult {
  coords: string[];
  rings: Uint32Array;
  polygons: Uint32Array;
  lineCoords: string[];
  lines: Uint32Array;
  points: string[];
}

/** A set of points that stays in the library's memory: see {@link Minksum.prepare}. */
export interface Prepared {
  /** Gives the memory back. Without it, that happens some time after the last use. A listener of
   * progress cannot call it. */
  dispose(): void;
  [Symbol.dispose](): void;
}

/**
 * What operations take: GeoJSON; text (WKT, GeoJSON, SVG, DXF, WKB in hexadecimal digits, `.poly`,
 * `.dat`); WKB as bytes; flat arrays; or something prepared. Its polygons may be of any kind:
 * {@link Options.fill} says which points they enclose.
 */
export type Operand =
  | Geometry
  | Feature
  | FeatureCollection
  | Flat
  | ExactFlatResult
  | string
  | Uint8Array
  | Prepared;

/** Says how text is read. */
export interface ReadOptions {
  /** `"drop"` drops heights and measures, which are errors otherwise */
  z?: "error" | "drop";
  /** how far the polylines of curves in SVG and DXF may be off; without it curves are errors */
  curveTolerance?: number;
  /** to which side of an area its curves may be off */
  curveSide?: Side;
  /** joins ends of outlines in drawings that are at most so far apart */
  joinEnds?: number;
}
/** The names of a sum's stages, in their order. */
export const stages = [
  "operands",
  "convolution",
  "cover",
  "arrangement",
  "loops",
  "filters",
  "output",
] as const;
/** What an operation is doing, besides the stages of a sum. */
export const progressStages = [...stages, "overlay", "rounding", "checking", "search"] as const;
export type ProgressStage = (typeof progressStages)[number];
/** How far an operation is. */
export interface Progress {
  stage: ProgressStage;
  /** how many parts are done: slices, or rows of a table; everything else is one part */
  done: number;
  /** how many parts there are */
  parts: number;
}
/** Says what a result looks like. */
export interface ResultOptions {
  /** GeoJSON (the default), flat arrays, WKT, or the picture as SVG */
  as?: "geojson" | "flat" | "wkt" | "svg";
  /** `"exact"` gives strings such as `"3"` and `"1/3"`; the default is the nearest doubles */
  coords?: "double" | "exact";
}
/** What a caller decides about any operation. */
export interface Options extends ReadOptions, ResultOptions {
  /** which points the rings of operands enclose; `"strict"` refuses polygons that are not valid */
  fill?: "automatic" | "evenodd" | "nonzero" | "positive" | "negative" | "strict";
  /** drops polylines and points of the operands */
  regularize?: boolean;
  /** whether `erode`, `opening`, `closing`, `slices`, and no-fit and inner-fit polygons keep tight
   * places, where something fits without play; by default only the latter two do. `rounded`
   * keeps them unless this is false. Sums never have them: `trace` tells those. */
  tight?: boolean;
  /** segments of a sum above which it is refused, from 1 on */
  maxSegments?: number;
  /** crossings of a sum above which it is refused, from 1 on */
  maxCrossings?: number;
  /** called when a stage begins, and every few milliseconds; `false` stops the operation. It may
   * call the library, but not dispose of anything. */
  progress?: (progress: Progress) => boolean | void;
}
export type Side = "nearest" | "outside" | "inside";
export interface OffsetOptions extends Options {
  join?: "round" | "miter" | "square" | "bevel";
  cap?: "round" | "butt" | "square";
  /** the side of the true offset to which a result with round joins and caps may deviate */
  side?: Side;
  /** the largest miter, in multiples of the distance; 2 by default */
  miterLimit?: number;
  /** how far the result may deviate; a thousandth of the distance by default */
  tolerance?: number;
}
export interface ReferenceOptions extends Options {
  /** the reference point of the moving part; its first vertex by default */
  reference?: [number, number];
}
export interface TableOptions extends Options {
  /** the number of directions in which parts are laid */
  turns?: 1 | 2 | 4;
}
/** Says by how many of a table's turns two parts are turned. */
export interface Turned {
  fixedTurn?: number;
  movingTurn?: number;
}
export interface RoundOptions extends Options {
  side?: Side;
  /** digits after the point, from 0 to 4096; without it, coordinates become doubles */
  decimals?: number;
}
export interface CheckOptions extends Options {
  /** how far the result may deviate in x and in y */
  within?: number;
}
export interface SpaceOptions extends Options {
  /** the point of the robot that says where it is and about which it turns; (0, 0) by default */
  reference?: [number, number];
  /** the area that the robot must not leave */
  workspace?: Operand;
  /** tolerance of turns in degrees; 0.001 by default */
  tolerance?: number;
}
export interface SliceOptions extends SpaceOptions {
  /** whether slices have the free space as well */
  free?: boolean;
}
export interface ReachOptions extends SpaceOptions {
  /** how many turns a full turn has; 72 by default */
  angles?: number;
  /** whether the path shall be free at all angles between, too */
  certain?: boolean;
}
/** A placement of the robot's reference point, and its turn in degrees, counter-clockwise. */
export interface Configuration {
  x: number;
  y: number;
  degrees: number;
}
/** A placement and a turn, exactly. */
export interface ExactConfiguration {
  x: string;
  y: string;
  /** the angle's nearest double */
  degrees: number;
  /** cosine and sine of the angle */
  cos: string;
  sin: string;
}
export interface Reach<At = Configuration> {
  reachable: boolean;
  /** waypoints from start to goal */
  path: At[];
}
/** The type of a path for given options. */
export type ReachOf<O> = Reach<
  CoordsOf<O> extends infer C ? (C extends "exact" ? ExactConfiguration : Configuration) : never
>;
/** The type of a number for given options. */
export type NumberOf<O> =
  CoordsOf<O> extends infer C ? (C extends "exact" ? string : number) : never;
export interface Slice<Result = Geometry> {
  /** the angle that was asked for */
  degrees: number;
  /** where the robot's reference point must not be */
  obstacles: Result;
  /** where it can be, if that was asked for */
  free?: Result;
}
/** How two sets stand to each other. */
export interface Depth {
  /** whether their interiors meet */
  overlapping: boolean;
  /** the shortest move of b after which both only touch */
  vector: [number, number];
  /** the same, exactly */
  exact: [string, string];
  /** the length of the vector */
  distance: number;
}
/** How two placed parts stand to each other. */
export type Contact = "free" | "touching" | "overlapping";
export type Location = "outside" | "boundary" | "inside";
export interface SumCheck {
  /** whether nothing speaks against the result */
  ok: boolean;
  /** number of faults of the result; 0 = it is valid */
  faults: number;
  /** points that were tested */
  points: number;
  /** points that only one of result and sum has */
  disagreements: number;
  /** whether the result is the sum by a second method; `null` = the sum is too large to try */
  proved: boolean | null;
}
/** A fault of an operand: what is wrong, and where. */
export interface Fault {
  message: string;
  polygon: number | undefined;
  ring: number | undefined;
  vertex: number | undefined;
}

export type Stage = (typeof stages)[number];
/** Directed segments: x and y of both ends of each, in turn. Their right side is the outer one. */
export interface Segments {
  xy: Float64Array;
  /** by segment: the operand that has the edge, 0 or 1 */
  edgeOperand: Uint8Array;
  /** by segment: 1 = the arrangement has it */
  kept: Uint8Array;
}
/** An orientable loop, and what became of it. */
export interface Loop {
  /** x and y of each vertex in turn */
  xy: Float64Array;
  counterclockwise: boolean;
  fate: "accepted" | "rejected-by-nesting" | "rejected-by-collision";
}
/** What the stages of a sum made. */
export interface Trace<Result = Geometry> {
  /** both operands as sets: valid polygons, polylines and points */
  operands: [Result, Result];
  /** the segments of the reduced convolution */
  convolution: Segments;
  /** the grid of the cover, or `null` if there is none */
  cover: {
    minX: number;
    minY: number;
    cellWidth: number;
    cellHeight: number;
    columns: number;
    rows: number;
    /** row by row from the lowest: 1 = the cell certainly lies in the sum */
    covered: Uint8Array;
  } | null;
  /** pieces of the segments that the cover leaves, split where they meet */
  arrangement: Segments & {
    /** x and y of each node in turn */
    nodes: Float64Array;
  };
  loops: Loop[];
  /** the sum */
  result: Result;
  /** the tight places: polylines and points in the sum where both sets touch without play */
  tight: Result;
  /** by vertex of the sum's polygons: where the edge came from that begins there; or `null` */
  origins: Origin[] | null;
  counts: {
    convolutionSegments: number;
    segmentsKept: number;
    crossings: number;
    loops: number;
    rejectedByNesting: number;
    rejectedByCollision: number;
    gridCells: number;
    coveredCells: number;
  };
  /** milliseconds of the whole sum */
  milliseconds: number;
  /** milliseconds by stage */
  stageMilliseconds: Record<Stage, number>;
}
/**
 * Where an edge of a sum came from: an edge of one operand, moved by a vertex of the other.
 * Vertices are counted through all rings of an operand.
 */
export interface Origin {
  edgeOperand: 0 | 1;
  edge: number;
  vertex: number;
}

/** What an option may be, with its default. */
type ValueOf<O, Name, Default> = Name extends keyof O
  ? Exclude<O[Name], undefined> | (undefined extends O[Name] ? Default : never)
  : Default;
type CoordsOf<O> = ValueOf<O, "coords", "double">;
type FormOf<As, Coords> = As extends "flat"
  ? Coords extends "exact"
    ? ExactFlatResult
    : FlatResult
  : As extends "wkt" | "svg"
    ? string
    : Geometry;
/** The type of a result for given options: a union unless they are known. */
export type ResultOf<O> = FormOf<ValueOf<O, "as", "geojson">, CoordsOf<O>>;
