// The state of the page, and the shapes in it. Everything that can be shared is here.

/** A number means its shortest decimal, as in a file: 0.1 is one tenth. Others are text: "1/3". */
export type Coordinate = number | string;
export type Position = [Coordinate, Coordinate];
export type Kind = "polygons" | "lines" | "points";
/** Polygons with holes, polylines and points. No ring repeats its first position. */
export interface Shape {
  polygons: Position[][][];
  lines: Position[][];
  points: Position[];
}

export const operations = [
  "sum",
  "erode",
  "open",
  "close",
  "offset",
  "nofit",
  "depth",
  "robot",
  "slices",
  "path",
  "steps",
] as const;
export type Operation = (typeof operations)[number];
export const fills = ["automatic", "evenodd", "nonzero", "positive", "negative", "strict"] as const;
export const joins = ["round", "miter", "square", "bevel"] as const;
export const sides = ["nearest", "outside", "inside"] as const;

/** Where the moving part or the robot is, and how it is turned. */
export interface Pose {
  x: number;
  y: number;
  degrees: number;
}
/** Limits of the plane, between which a robot has to stay. */
export interface Limits {
  left: number;
  bottom: number;
  right: number;
  top: number;
}
export interface State {
  a: Shape;
  b: Shape;
  op: Operation;
  fill: (typeof fills)[number];
  distance: number;
  tolerance: number;
  join: (typeof joins)[number];
  side: (typeof sides)[number];
  /** where the part is that is dragged */
  place: Position;
  degrees: number;
  slices: number;
  from: Pose;
  to: Pose;
  workspace: Limits | null;
  stage: number;
}

export const emptyShape = (): Shape => ({ polygons: [], lines: [], points: [] });
export const defaults: Omit<State, "a" | "b"> = {
  op: "sum",
  fill: "automatic",
  distance: 1,
  tolerance: 0.05,
  join: "round",
  side: "nearest",
  place: [0, 0],
  degrees: 0,
  slices: 24,
  from: { x: 0, y: 0, degrees: 0 },
  to: { x: 10, y: 0, degrees: 0 },
  workspace: null,
  stage: 0,
};

/** The double next to a coordinate: for drawing. */
export function toNumber(coordinate: Coordinate): number {
  if (typeof coordinate === "number") return coordinate;
  const [numerator, denominator] = coordinate.split("/");
  return denominator === undefined ? Number(numerator) : divide(numerator!, denominator);
}
function divide(numerator: string, denominator: string): number {
  const quotient = Number(numerator) / Number(denominator);
  if (Number.isFinite(quotient)) return quotient;
  // Both may have more digits than a double's exponent allows.
  const cut = Math.max(0, Math.min(numerator.length, denominator.length) - 40);
  return (
    Number(numerator.slice(0, numerator.length - cut)) /
    Number(denominator.slice(0, denominator.length - cut))
  );
}

/** The same number as a double if its shortest decimal means exactly that; else the text. */
export function fromExact(text: string): Coordinate {
  const double = toNumber(text);
  const [numerator, denominator] = fraction(decimal(double));
  const [given, below = "1"] = text.split("/");
  return numerator * BigInt(below) === BigInt(given!) * denominator ? double : text;
}
function fraction(text: string): [bigint, bigint] {
  const [digits, after = ""] = text.split(".");
  return [BigInt(digits! + after), 10n ** BigInt(after.length)];
}

/** The shortest decimal of a double, without an exponent. */
export function decimal(value: number): string {
  const text = String(value);
  const found = /^(-?)(\d)(?:\.(\d+))?e([-+]\d+)$/.exec(text);
  if (!found) return text;
  const [, sign, first, rest = "", power] = found;
  const exponent = Number(power);
  if (exponent < 0) return `${sign}0.${"0".repeat(-exponent - 1)}${first}${rest}`;
  return `${sign}${first}${rest}${"0".repeat(exponent - rest.length)}`;
}
const written = (c: Coordinate) => (typeof c === "number" ? decimal(c) : c);
export const position = (p: Position) => `${written(p[0])} ${written(p[1])}`;

/** Returns a shape as WKT, in which every number stands exactly. */
export function toWkt(shape: Shape): string {
  const path = (ring: Position[]) => `(${ring.map(position).join(", ")})`;
  const rings = (polygon: Position[][]) =>
    `(${polygon.map((ring) => path([...ring, ring[0]!])).join(", ")})`;
  const texts: string[] = [];
  const { polygons, lines, points } = shape;
  if (polygons.length === 1) texts.push(`POLYGON ${rings(polygons[0]!)}`);
  if (polygons.length > 1) texts.push(`MULTIPOLYGON (${polygons.map(rings).join(", ")})`);
  for (const line of lines) texts.push(`LINESTRING ${path(line)}`);
  if (points.length === 1) texts.push(`POINT (${position(points[0]!)})`);
  if (points.length > 1)
    texts.push(`MULTIPOINT (${points.map((p) => `(${position(p)})`).join(", ")})`);
  if (texts.length === 0) return "POLYGON EMPTY";
  return texts.length === 1 ? texts[0]! : `GEOMETRYCOLLECTION (${texts.join(", ")})`;
}

/** A vertex of a shape: which path it is in, and where there. */
export interface Vertex {
  kind: Kind;
  /** the polygon, polyline or point */
  part: number;
  /** the ring of a polygon */
  ring: number;
  index: number;
}
/** Returns the path that holds a vertex. */
export function pathOf(shape: Shape, v: Vertex): Position[] {
  if (v.kind === "polygons") return shape.polygons[v.part]![v.ring]!;
  return v.kind === "lines" ? shape.lines[v.part]! : shape.points;
}
export function* verticesOf(shape: Shape): Generator<[Vertex, Position]> {
  for (const [part, rings] of shape.polygons.entries()) {
    for (const [ring, path] of rings.entries()) {
      for (const [index, p] of path.entries()) yield [{ kind: "polygons", part, ring, index }, p];
    }
  }
  for (const [part, path] of shape.lines.entries()) {
    for (const [index, p] of path.entries()) yield [{ kind: "lines", part, ring: 0, index }, p];
  }
  for (const [index, p] of shape.points.entries())
    yield [{ kind: "points", part: index, ring: 0, index }, p];
}
export function vertexCount(shape: Shape): number {
  const paths = [...shape.polygons.flat(), ...shape.lines];
  return paths.reduce((sum, path) => sum + path.length, shape.points.length);
}

/** Returns a shape in which every path was changed by `change`. */
export function mapShape(shape: Shape, change: (p: Position) => Position): Shape {
  return {
    polygons: shape.polygons.map((rings) => rings.map((ring) => ring.map(change))),
    lines: shape.lines.map((line) => line.map(change)),
    points: shape.points.map(change),
  };
}
/** Adds coordinates exactly. */
export function add(a: Coordinate, b: Coordinate): Coordinate {
  if (b === 0) return a;
  if (typeof a === "number" && typeof b === "number") {
    const sum = addDecimals(a, b);
    if (sum !== undefined) return sum;
  }
  const [n, d] = ratio(a);
  const [m, e] = ratio(b);
  return fromExact(reduced(n * e + m * d, d * e));
}
/**
 * The same for short decimals, fast. Decimals of up to 15 digits that are read as one double are
 * equal, so a whole number of up to 15 digits that divides back to a double is what that means.
 */
function addDecimals(a: number, b: number): number | undefined {
  for (let unit = 1; unit <= 1e6; unit *= 10) {
    const [x, y] = [Math.round(a * unit), Math.round(b * unit)];
    if (Math.abs(x) + Math.abs(y) >= 1e15) return undefined;
    if (x / unit === a && y / unit === b) return (x + y) / unit;
  }
  return undefined;
}
export const negated = (c: Coordinate): Coordinate =>
  typeof c === "number" ? 0 - c : c.startsWith("-") ? c.slice(1) : `-${c}`;
function ratio(c: Coordinate): [bigint, bigint] {
  if (typeof c === "number") return fraction(decimal(c));
  const [n, d = "1"] = c.split("/");
  return [BigInt(n!), BigInt(d)];
}
function reduced(n: bigint, d: bigint): string {
  let [a, b] = [n < 0n ? -n : n, d];
  while (b !== 0n) [a, b] = [b, a % b];
  return d === a ? `${n / a}` : `${n / a}/${d / a}`;
}
/** Moves a shape exactly. */
export const moved = (shape: Shape, by: Position): Shape =>
  mapShape(shape, (p) => [add(p[0], by[0]), add(p[1], by[1])]);

/** Rounds to a multiple of a step that is a power of ten, or five or two times one. */
export function snapTo(value: number, step: number): number {
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return Number((Math.round(value / step) * step).toFixed(Math.min(digits, 15))) + 0;
}
