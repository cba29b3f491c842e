/// <reference lib="esnext.disposable" preserve="true" />
// All operations: each puts its operands into memory, calls the library, and takes the result out.
import type { Address, Library } from "./abi.js";
import {
  checkOptions, configuration, finite, integer, kCaps, kFills, kJoins, kSides, numbers, oneOf,
  pointList,
} from "./arguments.js";
import { badInput, type MinksumError } from "./errors.js";
import { Operands } from "./operands.js";
import { Results } from "./results.js";
import { readTrace } from "./trace.js";
import type {
  CheckOptions, Configuration, Contact, Depth, ExactConfiguration, Fault, Location, NumberOf,
  OffsetOptions, Operand, Options, Prepared, ReachOf, ReachOptions, ReferenceOptions, ResultOf,
  RoundOptions, Side, Slice, SliceOptions, SpaceOptions, SumCheck, TableOptions, Trace, Turned,
} from "./types.js";

const kContacts: Contact[] = ["free", "touching", "overlapping"];
const kLocations: Location[] = ["outside", "boundary", "inside"];

/** Frees what nobody disposed of. */
const collector = new FinalizationRegistry<() => void>((free) => free());

/** Something in the module's memory. */
class Handle implements Prepared {
  private readonly state: { free: (() => void) | undefined };
  constructor(
    private readonly library: Library,
    free: () => void,
  ) {
    const state: { free: (() => void) | undefined } = { free };
    this.state = state;
    collector.register(this, () => state.free?.(), this);
  }
  get disposed(): boolean {
    return this.state.free === undefined;
  }
  dispose(): void {
    const { free } = this.state;
    if (free !== undefined && this.library.telling) {
      throw badInput("`progress` cannot dispose of anything: the operation may use it");
    }
    this.state.free = undefined;
    collector.unregister(this);
    free?.();
  }
  [Symbol.dispose](): void {
    this.dispose();
  }
}
class PreparedOperand extends Handle {
  constructor(
    readonly owner: Minksum,
    readonly geometry: Address,
    readonly prepared: Address,
    free: () => void,
  ) {
    super(owner.library, free);
  }
}

/** The no-fit polygons of all pairs of parts, which are laid in one, two or four directions. */
export class NoFitTable extends Handle {
  /** @internal */
  constructor(
    private readonly mk: Minksum,
    private readonly table: Address,
    /** the number of parts */
    readonly size: number,
    /** the number of directions */
    readonly turns: number,
    free: () => void,
  ) {
    super(mk.library, free);
  }
  /** Returns the no-fit polygon of two parts, each turned by so many of the table's turns. */
  at<O extends Options = {}>(
    fixed: number, moving: number, options: O & Turned = {} as O,
  ): ResultOf<O> {
    return this.mk.results.take(this.entry(fixed, moving, options), options);
  }
  /** Tells how two parts stand to each other when `moving` is placed at each of the points. */
  contact(
    fixed: number, moving: number, points: ArrayLike<number>,
    options: Turned = {},
  ): Contact[] {
    const xy = pointList(points, "points");
    return this.mk.contactsOf(this.entry(fixed, moving, options), xy);
  }
  private entry(
    fixed: number, moving: number, options: Turned,
  ): Address {
    if (this.disposed) throw badInput("the table was disposed of");
    checkOptions(options);
    const { results, error } = this.mk.library;
    const part = (value: unknown, name: string) => integer(value, name, 0, this.size - 1);
    return this.mk.made("minksum_no_fit_table_at", [
      this.table, part(fixed, "fixed"), options.fixedTurn ?? 0,
      part(moving, "moving"), options.movingTurn ?? 0, results, error,
    ]);
  }
}

/** The library. {@link load} makes one, with a memory of its own. */
export class Minksum {
  /** @internal */
  readonly results: Results;
  private readonly operands: Operands;

  /** @internal */
  constructor(/** @internal */ readonly library: Library) {
    this.results = new Results(library);
    this.operands = new Operands(library, (value) => this.geometryOf(value));
  }
  /** The version of the library. */
  get version(): string {
    return this.library.text(this.library.call["minksum_version"]!());
  }
  /** Bytes of the module's memory. It grows where an operation needs more, and never shrinks. */
  get memoryBytes(): number {
    return this.library.bytes;
  }

  // -- Sums and morphology -------------------------------------------------------------------------
  /** Returns a ⊕ b = { p + q | p ∈ a, q ∈ b }. */
  minkowskiSum<O extends Options = {}>(a: Operand, b: Operand, options: O = {} as O): ResultOf<O> {
    if (a instanceof PreparedOperand && b instanceof PreparedOperand) {
      const both = [this.preparedOf(a), this.preparedOf(b)];
      return this.take("minksum_sum_prepared", both, options);
    }
    return this.binary("minksum_sum", a, b, options);
  }
  /** Returns a ⊕ b, by another name. */
  dilate<O extends Options = {}>(a: Operand, b: Operand, options: O = {} as O): ResultOf<O> {
    return this.binary("minksum_dilate", a, b, options);
  }
  /** Returns a ⊖ b: the placements at which b lies in a. */
  erode<O extends Options = {}>(a: Operand, b: Operand, options: O = {} as O): ResultOf<O> {
    return this.binary("minksum_erode", a, b, options);
  }
  /** Returns (a ⊖ b) ⊕ b: the part of a that b can reach inside a. */
  opening<O extends Options = {}>(a: Operand, b: Operand, options: O = {} as O): ResultOf<O> {
    return this.binary("minksum_open", a, b, options);
  }
  /** Returns (a ⊕ b) ⊖ b: a with what b cannot reach from outside. */
  closing<O extends Options = {}>(a: Operand, b: Operand, options: O = {} as O): ResultOf<O> {
    return this.binary("minksum_close", a, b, options);
  }
  /** Returns a grown by a distance, or shrunk if that is negative. */
  offset<O extends OffsetOptions = {}>(a: Operand, distance: number, options: O = {} as O): ResultOf<O> {
    return this.operands.with([a], options, ([address]) =>
      this.library.withRoom(32, (shape) => {
        const { library } = this;
        const at = shape >>> 2;
        library.u32[at] = oneOf(kJoins, options.join ?? "round", "join");
        library.u32[at + 1] = oneOf(kCaps, options.cap ?? "round", "cap");
        library.u32[at + 2] = oneOf(kSides, options.side ?? "nearest", "side");
        library.f64[shape / 8 + 2] = options.miterLimit ?? 2;
        library.f64[shape / 8 + 3] = options.tolerance ?? 0;
        return this.take("minksum_offset", [address!, finite(distance, "distance"), shape], options);
      }),
    );
  }
  /** Returns a convex polygon that stands for the disc of this radius around (0, 0). */
  disc<O extends Options = {}>(
    radius: number, tolerance: number, options: O & { side?: Side } = {} as O,
  ): ResultOf<O> {
    checkOptions(options);
    const { results, error } = this.library;
    const made = this.made("minksum_disc", [
      finite(radius, "radius"), finite(tolerance, "tolerance"),
      oneOf(kSides, options.side ?? "nearest", "side"), results, error,
    ]);
    return this.results.take(made, options);
  }

  // -- Placing parts -------------------------------------------------------------------------------
  /** Returns the placements of the moving part's reference point at which both touch or overlap. */
  noFitPolygon<O extends ReferenceOptions = {}>(
    fixed: Operand, moving: Operand, options: O = {} as O,
  ): ResultOf<O> {
    return this.withNoFit("minksum_no_fit_polygon", fixed, moving, options, (geometry) =>
      this.results.take(geometry, options),
    );
  }
  /** Returns the placements of the part's reference point at which it lies in the bin. */
  innerFitPolygon<O extends ReferenceOptions = {}>(
    bin: Operand, part: Operand, options: O = {} as O,
  ): ResultOf<O> {
    return this.withNoFit("minksum_inner_fit_polygon", bin, part, options, (geometry) =>
      this.results.take(geometry, options),
    );
  }
  /** Tells how two parts stand to each other when `moving` is placed at each of the points, whose
   * x and y follow each other. */
  contact(
    fixed: Operand, moving: Operand, points: ArrayLike<number>, options: ReferenceOptions = {},
  ): Contact[] {
    const xy = pointList(points, "points");
    return this.withNoFit("minksum_no_fit_polygon", fixed, moving, options, (geometry) =>
      this.contactsOf(geometry, xy),
    );
  }
  /** Makes a table of the no-fit polygons of all pairs of parts. */
  noFitTable(parts: Operand[], options: TableOptions = {}): NoFitTable {
    const { library } = this;
    const { call, results, error } = library;
    if (!Array.isArray(parts)) throw badInput("`parts` is no array of operands");
    return this.operands.with([...parts], options, (addresses) => {
      const turns = options.turns ?? 4;
      const table = library.withRoom(4 * addresses.length, (list) => {
        library.u32.set(addresses, list >>> 2);
        const how = this.writeOptions(options);
        return this.made("minksum_no_fit_table_new", [list, parts.length, turns, how, results, error]);
      });
      const free = () => void call["minksum_no_fit_table_free"]!(table);
      return new NoFitTable(this, table, parts.length, turns, free);
    });
  }

  // -- How two sets stand to each other ------------------------------------------------------------
  /** Tells how deep two sets overlap, or how far they are apart; `null` if one is empty. */
  penetrationDepth(a: Operand, b: Operand, options: Options = {}): Depth | null {
    const { library } = this;
    return this.operands.with([a, b], options, ([first, second]) => {
      const how = this.writeOptions(options);
      const { results, error, call } = library;
      library.check(call["minksum_penetration_depth"]!(first!, second!, how, results, error));
      if (library.u32[results >>> 2] === 0) return null;
      const overlapping = library.u32[(results >>> 2) + 1] === 1;
      const [x, y, distance] = library.doubles(results + 8, 3, "a depth");
      const point = this.made("minksum_depth_vector", [first!, second!, how, results, error]);
      const { points } = this.results.take(point, { as: "flat", coords: "exact" });
      const exact: [string, string] = [points[0]!, points[1]!];
      return { overlapping, vector: [x!, y!], exact, distance: distance! };
    });
  }
  /** Returns the smallest t ≥ 0 for which b, moved by t · direction, touches or overlaps a. */
  timeOfImpact<O extends Options = {}>(
    a: Operand, b: Operand, direction: [number, number], options: O = {} as O,
  ): NumberOf<O> | null {
    const { library } = this;
    return this.operands.with([a, b], options, ([first, second]) =>
      library.withRoom(16, (where) => {
        library.f64.set(numbers(direction, "direction", 2), where / 8);
        const { results, error } = library;
        const how = this.writeOptions(options);
        const made = this.made("minksum_impact_factor", [first!, second!, where, how, results, error]);
        const { points } =
          options.coords === "exact"
            ? this.results.take(made, { as: "flat", coords: "exact" })
            : this.results.take(made, { as: "flat" });
        return (points[0] ?? null) as NumberOf<O> | null;
      }),
    );
  }

  // -- Robots --------------------------------------------------------------------------------------
  /** Returns where a robot must not be among obstacles, for each of the angles in degrees. */
  slices<O extends SliceOptions = {}>(
    robot: Operand, obstacles: Operand, angles: ArrayLike<number>, options: O = {} as O,
  ): Slice<ResultOf<O>>[] {
    numbers(angles, "angles");
    const { library } = this;
    const { call, results, error } = library;
    return this.withSpace(robot, obstacles, options, (first, second, space) => {
      const { progress } = options;
      let done = 0;
      const told: Options = progress
        ? { ...options, progress: (now) => progress({ ...now, done, parts: angles.length }) }
        : options;
      const how = this.writeOptions(told);
      const made = this.made("minksum_space_new", [first, second, space, how, results, error]);
      try {
        return Array.from(angles, (degrees) => {
          const status = call["minksum_space_slice"]!(
            made, degrees, results, options.free ? results + 4 : 0, error,
          );
          library.check(status);
          const [taken, free] = library.u32.slice(results >>> 2, (results >>> 2) + 2);
          const slice: Slice<ResultOf<O>> = { degrees, obstacles: this.results.take(taken!, options) };
          if (options.free) slice.free = this.results.take(free!, options);
          ++done;
          return slice;
        });
      } finally {
        call["minksum_space_free"]!(made);
      }
    });
  }
  /** Tells whether a robot gets from one configuration to another, and how. */
  reach<O extends ReachOptions = {}>(
    robot: Operand, obstacles: Operand, from: Configuration, to: Configuration,
    options: O = {} as O,
  ): ReachOf<O> {
    const { library } = this;
    const { call, results, error } = library;
    return this.withSpace(robot, obstacles, options, (first, second, space) =>
      library.withRoom(48, (ends) => {
        library.f64.set([...configuration(from, "from"), ...configuration(to, "to")], ends / 8);
        const status = call["minksum_find_path"]!(
          first, second, ends, ends + 24, options.angles ?? 72, options.certain ? 1 : 0, space,
          this.writeOptions(options), results, error,
        );
        library.check(status);
        const answer = library.u32.slice(results >>> 2, (results >>> 2) + 4);
        try {
          return { reachable: answer[0] === 1, path: this.pathOf(answer, options) } as ReachOf<O>;
        } finally {
          library.u32.set(answer, results >>> 2);
          call["minksum_reach_free"]!(results);
        }
      }),
    );
  }

  private pathOf(answer: Uint32Array, options: ReachOptions): (Configuration | ExactConfiguration)[] {
    const [, count, path, exact] = answer;
    const waypoints = Array.from({ length: count! }, (_, i) => {
      const [x, y, degrees] = this.library.doubles(path! + 24 * i, 3);
      return { x: x!, y: y!, degrees: degrees! };
    });
    if (options.coords !== "exact" || count === 0) return waypoints;
    const { points } = this.results.convert(exact!, { as: "flat", coords: "exact" });
    return waypoints.map(({ degrees }, i) => {
      const [x, y, cos, sin] = points.slice(4 * i, 4 * i + 4);
      return { x: x!, y: y!, degrees, cos: cos!, sin: sin! };
    });
  }

  // -- Sets ----------------------------------------------------------------------------------------
  /** Returns the union of two sets, with polylines and points. */
  union<O extends Options = {}>(a: Operand, b: Operand, options: O = {} as O): ResultOf<O> {
    return this.binary("minksum_unite", a, b, options);
  }
  /** Returns the area that both have. Polylines and points of the operands are dropped. */
  intersection<O extends Options = {}>(a: Operand, b: Operand, options: O = {} as O): ResultOf<O> {
    return this.binary("minksum_intersect", a, b, options);
  }
  /** Returns the area of a without that of b. Polylines and points of the operands are dropped. */
  difference<O extends Options = {}>(a: Operand, b: Operand, options: O = {} as O): ResultOf<O> {
    return this.binary("minksum_subtract", a, b, options);
  }
  /** Returns the area that exactly one of both has. Polylines and points of the operands are
   * dropped. */
  symmetricDifference<O extends Options = {}>(
    a: Operand, b: Operand, options: O = {} as O,
  ): ResultOf<O> {
    return this.binary("minksum_symmetric_difference", a, b, options);
  }
  /** Returns the set of points that an operand means, with valid polygons. */
  resolve<O extends Options = {}>(a: Operand, options: O = {} as O): ResultOf<O> {
    return this.operands.with([a], options, (both) => this.take("minksum_resolve", both, options));
  }
  /** Returns a rounded to doubles or decimals, so that it stays valid. An operand that no operation
   * made is resolved first. Polylines and points that all lie within the area, as the tight places
   * of a no-fit polygon do, are rounded by themselves, to the nearest whatever the side. */
  rounded<O extends RoundOptions = {}>(a: Operand, options: O = {} as O): ResultOf<O> {
    return this.withResolved(a, options, (resolved, given) => {
      const side = oneOf(kSides, options.side ?? "nearest", "side");
      // Resolved as parts of one set, tight places vanish in the area.
      const address = this.hasThinParts(given) ? given : resolved;
      return this.take("minksum_round", [address, side, options.decimals ?? -1], options);
    });
  }
  /** Returns the image by the map (x, y) ↦ (m₀ x + m₁ y + m₂, m₃ x + m₄ y + m₅). */
  transform<O extends Options = {}>(a: Operand, m: ArrayLike<number>, options: O = {} as O): ResultOf<O> {
    const six = numbers(m, "m", 6);
    return this.operands.with([a], options, ([address]) =>
      this.library.withRoom(48, (map) => {
        this.library.f64.set(six, map / 8);
        return this.take("minksum_transform", [address!, map], options);
      }),
    );
  }
  /** Returns an operand as it is, in another form. */
  convert<O extends Options = {}>(a: Operand, options: O = {} as O): ResultOf<O> {
    return this.operands.with([a], options, ([address]) => this.results.convert(address!, options));
  }
  /** Returns a picture of an operand. */
  toSvg(a: Operand, options: Options = {}): string {
    checkOptions(options);
    return this.convert(a, { ...options, as: "svg" });
  }

  // -- Questions -----------------------------------------------------------------------------------
  /** Returns the area of a. */
  area(a: Operand, options: Options = {}): number {
    const { library } = this;
    const { results, error, call } = library;
    return this.withResolved(a, options, (address) => {
      library.check(call["minksum_area"]!(address, results, error));
      return library.doubles(results, 1, "an area")[0]!;
    });
  }
  /** Returns the bounding box of a's polygons: min x, min y, max x, max y; `null` without any. */
  bounds(a: Operand, options: Options = {}): [number, number, number, number] | null {
    const { library } = this;
    const { results, error, call } = library;
    return this.operands.with([a], options, ([address]) => {
      library.check(call["minksum_bounding_box"]!(address!, results, results + 32, error));
      if (library.u32[(results >>> 2) + 8] === 0) return null;
      return [...library.doubles(results, 4)] as [number, number, number, number];
    });
  }
  /** Tells where points lie, whose x and y follow each other. */
  locate(a: Operand, points: ArrayLike<number>, options: Options = {}): Location[] {
    const xy = pointList(points, "points");
    const { library } = this;
    const { results, error, call } = library;
    return this.withResolved(a, options, (address) => {
      const how = this.writeOptions(options);
      const locator = this.made("minksum_locator_new", [address, how, results, error]);
      try {
        return Array.from({ length: xy.length / 2 }, (_, i) => {
          const [x, y] = [xy[2 * i]!, xy[2 * i + 1]!];
          library.check(call["minksum_locate"]!(locator, x, y, results, error));
          return kLocations[library.u32[results >>> 2]!]!;
        });
      } finally {
        call["minksum_locator_free"]!(locator);
      }
    });
  }
  /** Returns the faults of a's polygons, at most `most`, which is 100 by default and a million
   * at most; none if they are valid. */
  validate(a: Operand, options: Options & { most?: number } = {}): Fault[] {
    const { library } = this;
    const { results, error, call } = library;
    return this.operands.with([a], options, ([address]) => {
      const most = options.most ?? 100;
      return library.withRoom(600 * most, (faults) => {
        const how = this.writeOptions(options);
        library.check(call["minksum_validate"]!(address!, how, faults, most, results, error));
        return Array.from({ length: library.u32[results >>> 2]! }, (_, i) => {
          const { message, polygon, ring, vertex }: MinksumError = library.errorAt(faults + 600 * i);
          return { message, polygon, ring, vertex };
        });
      });
    });
  }
  /** Checks by independent methods whether `result`, of any program, is a ⊕ b. */
  checkSum(result: Operand, a: Operand, b: Operand, options: CheckOptions = {}): SumCheck {
    const { library } = this;
    const { results, error, call } = library;
    return this.operands.with([result, a, b], options, ([sum, first, second]) => {
      const how = this.writeOptions(options);
      const within = options.within ?? 0;
      library.check(call["minksum_check_sum"]!(sum!, first!, second!, within, how, results, error));
      const word = (i: number) => library.u32[(results >>> 2) + i]!;
      const long = (i: number) => word(i) + 2 ** 32 * word(i + 1);
      const proved = word(6) | 0;
      return {
        ok: word(0) === 1,
        faults: word(1),
        points: long(2),
        disagreements: long(4),
        proved: proved < 0 ? null : proved === 1,
      };
    });
  }
  /** Returns a ⊕ b, and what each stage of its computation made. */
  trace<O extends Options = {}>(a: Operand, b: Operand, options: O = {} as O): Trace<ResultOf<O>> {
    return this.operands.with([a, b], options, ([first, second]) => {
      const { library, results } = this;
      const operand = (index: 0 | 1) => {
        const how = this.writeOptions(options);
        const address = [first!, second!][index]!;
        const given = [address, how, library.results, library.error];
        return results.take(this.made("minksum_resolve", given, index), options);
      };
      const operands: [ResultOf<O>, ResultOf<O>] = [operand(0), operand(1)];
      return readTrace(library, results, [first!, second!], this.writeOptions(options), operands, options);
    });
  }

  // -- Operands that are used often ----------------------------------------------------------------
  /** Keeps an operand in the library's memory. Sums of two prepared operands take the least time.
   * Its polygons must be valid, and it has no polylines and points. */
  prepare(a: Operand, options: Options = {}): Prepared {
    const { library } = this;
    const { call, results, error } = library;
    checkOptions(options);
    const geometry = this.operands.make(a, 0, options);
    try {
      const how = this.writeOptions(options);
      const prepared = this.made("minksum_prepare", [geometry, how, results, error], 0);
      return new PreparedOperand(this, geometry, prepared, () => {
        call["minksum_prepared_free"]!(prepared);
        call["minksum_geometry_free"]!(geometry);
      });
    } catch (problem) {
      call["minksum_geometry_free"]!(geometry);
      throw problem;
    }
  }
  private preparedOf(operand: PreparedOperand): Address {
    if (operand.disposed) throw badInput("an operand was disposed of");
    if (operand.owner !== this) throw badInput("an operand was prepared by another library");
    return operand.prepared;
  }
  private geometryOf(value: unknown): Address | undefined {
    if (!(value instanceof PreparedOperand)) return undefined;
    this.preparedOf(value);
    return value.geometry;
  }

  // -- Calls ---------------------------------------------------------------------------------------
  /** Calls a function that makes something, and returns where that is. @internal */
  made(name: string, given: number[], operand?: number): Address {
    const { library } = this;
    library.check(library.call[name]!(...given), operand);
    return library.u32[library.results >>> 2]!;
  }
  /** @internal */
  contactsOf(noFit: Address, xys: ArrayLike<number>): Contact[] {
    const { library } = this;
    const { call, error } = library;
    const count = xys.length / 2;
    try {
      return library.withRoom(20 * count, (xy) => {
        library.f64.set(xys, xy / 8);
        const contacts = xy + 16 * count;
        library.check(call["minksum_contacts"]!(noFit, xy, count, contacts, 0, error));
        return Array.from(library.u32.subarray(contacts >>> 2, (contacts >>> 2) + count), (c) => kContacts[c]!);
      });
    } finally {
      call["minksum_geometry_free"]!(noFit);
    }
  }
  private take<O extends Options>(name: string, given: number[], options: O): ResultOf<O> {
    const { results, error } = this.library;
    const how = this.writeOptions(options);
    return this.results.take(this.made(name, [...given, how, results, error]), options);
  }
  private binary<O extends Options>(name: string, a: Operand, b: Operand, options: O): ResultOf<O> {
    return this.operands.with([a, b], options, (both) => this.take(name, both, options));
  }
  private hasThinParts(geometry: Address): boolean {
    const { call, results } = this.library;
    call["minksum_geometry_counts"]!(results, geometry);
    const { u32 } = this.library;
    return u32[(results >>> 2) + 3]! + u32[(results >>> 2) + 5]! > 0;
  }
  private withResolved<T>(
    a: Operand, options: Options, work: (resolved: Address, given: Address) => T,
  ): T {
    const { call, results, error } = this.library;
    return this.operands.with([a], options, ([address]) => {
      const how = this.writeOptions(options);
      const resolved = this.made("minksum_resolve", [address!, how, results, error], 0);
      try {
        return work(resolved, address!);
      } finally {
        call["minksum_geometry_free"]!(resolved);
      }
    });
  }
  private withNoFit<T>(
    name: string, a: Operand, b: Operand, options: ReferenceOptions, work: (made: Address) => T,
  ): T {
    const { library } = this;
    const { results, error } = library;
    const made = this.operands.with([a, b], options, ([first, second]) =>
      library.withRoom(16, (where) => {
        if (options.reference) library.f64.set(options.reference, where / 8);
        const how = this.writeOptions(options);
        return this.made(name, [first!, second!, options.reference ? where : 0, how, results, error]);
      }),
    );
    return work(made);
  }
  private withSpace<T>(
    robot: Operand, obstacles: Operand, options: SpaceOptions,
    work: (robot: Address, obstacles: Address, space: Address) => T,
  ): T {
    const { library } = this;
    checkOptions(options);
    const { workspace: area } = options;
    const list = [robot, obstacles, ...(area === undefined ? [] : [area])];
    return this.operands.with(list, options, ([first, second, workspace]) =>
      library.withRoom(32, (space) => {
        library.f64.set(options.reference ?? [0, 0], space / 8);
        library.u32[(space >>> 2) + 4] = workspace ?? 0;
        library.f64[space / 8 + 3] = options.tolerance ?? 1e-3;
        return work(first!, second!, space);
      }),
    );
  }
  private writeOptions(options: Options): Address {
    return this.library.writeOptions({
      fill: oneOf(kFills, options.fill ?? "automatic", "fill"),
      regularize: options.regularize ?? false,
      tight: options.tight,
      maxSegments: options.maxSegments ?? 0,
      maxCrossings: options.maxCrossings ?? 0,
      progress: options.progress,
    });
  }
}
