// Runs in the worker: does one job after the other.
import {
  load,
  MinksumError,
  type Fault,
  type FlatResult,
  type Minksum,
  type Origin,
  type Progress,
  type Trace,
} from "minksum";
import type {
  Answer,
  Details,
  Failure,
  Job,
  ReadAnswer,
  RunAnswer,
  RunJob,
  Told,
} from "./jobs.js";
import { fromExact, type Position, type Shape } from "./model.js";

let library: Minksum;
const flat = { as: "flat" } as const;
const exactFlat = { as: "flat", coords: "exact" } as const;
const exactWkt = { as: "wkt", coords: "exact" } as const;

/** Tells the page how far a job is, ten times a second. */
let told = 0;
function progress(now: Progress): void {
  if (performance.now() - told < 100) return;
  told = performance.now();
  const message: Told = { kind: "progress", ...now };
  postMessage(message);
}

/** How a job's operation is called, with results of any form. */
function call(mk: Minksum, job: RunJob, form: object): any {
  const { a, b, fill } = job;
  const how = { fill, progress, ...form };
  switch (job.op) {
    case "erode":
      return mk.erode(a, b, how);
    case "open":
      return mk.opening(a, b, how);
    case "close":
      return mk.closing(a, b, how);
    case "offset": {
      const { tolerance, join, side } = job;
      return mk.offset(a, job.distance, { ...how, tolerance, join, side });
    }
    case "nofit":
      return mk.noFitPolygon(a, b, { ...how, reference: [0, 0] });
    case "robot":
      return mk.slices(b, a, [job.degrees], within(job, how))[0]!.obstacles;
    default:
      return mk.minkowskiSum(a, b, how);
  }
}

/** Adds the limits of the plane to options, if there are some. */
const within = <T extends object>(job: RunJob, options: T) =>
  job.limits === undefined ? options : { ...options, workspace: job.limits };

/** The no-fit polygon of the last job: dragging the part does not change it. */
let lastNoFit: { key: string; made: FlatResult; milliseconds: number } | undefined;
function noFit(mk: Minksum, job: RunJob): { made: FlatResult; milliseconds: number } {
  const key = [job.fill, job.a, job.b].join("\n");
  if (lastNoFit?.key !== key) {
    const start = performance.now();
    const made = call(mk, job, flat);
    lastNoFit = { key, made, milliseconds: performance.now() - start };
  }
  return lastNoFit;
}

function run(mk: Minksum, job: RunJob): RunAnswer {
  const answer: RunAnswer = { kind: "run", id: job.id, op: job.op, milliseconds: 0, result: null };
  const { a, b, fill } = job;
  const how = { fill, progress };
  const start = performance.now();
  told = start;
  switch (job.op) {
    case "depth":
      answer.depth = mk.penetrationDepth(a, job.placed, how);
      break;
    case "slices": {
      const angles = Array.from({ length: job.slices }, (_, i) => (360 * i) / job.slices);
      answer.slices = mk.slices(b, a, angles, within(job, { ...how, ...flat }));
      break;
    }
    case "path":
      answer.reach = mk.reach(b, a, job.from, job.to, within(job, { ...how, angles: job.slices }));
      break;
    case "steps":
      answer.trace = mk.trace(a, b, { ...how, ...flat });
      answer.result = answer.trace.result;
      break;
    case "nofit":
      answer.result = noFit(mk, job).made;
      break;
    default:
      answer.result = call(mk, job, flat);
  }
  answer.milliseconds = performance.now() - start;
  if (job.op === "nofit") answer.milliseconds = noFit(mk, job).milliseconds;
  if (job.op === "offset") answer.band = band(mk, job);
  if (job.op === "nofit")
    [answer.contact] = mk.contact(a, job.placed, [0, 0], { fill, reference: [0, 0] });
  if (job.details) {
    answer.faults = [mk.validate(a, { most: 20 }), mk.validate(b, { most: 20 })];
    if (answer.result) answer.details = details(mk, job, answer, answer.faults);
  }
  return answer;
}

/** Between these two lies the boundary of the true offset; only round joins have a band. */
function band(mk: Minksum, job: RunJob): RunAnswer["band"] {
  const { a, distance, tolerance, join, fill } = job;
  const one = (side: "inside" | "outside") =>
    mk.offset(a, distance, { fill, tolerance, join, side, progress, ...flat });
  return join === "round" ? { inner: one("inside"), outer: one("outside") } : undefined;
}

function details(mk: Minksum, job: RunJob, answer: RunAnswer, faults: [Fault[], Fault[]]): Details {
  const tellsOrigins = job.op === "sum" || job.op === "steps";
  const trace = tellsOrigins
    ? (answer.trace ?? mk.trace(job.a, job.b, { fill: job.fill, progress, ...flat }))
    : null;
  // Origins count the vertices of an operand as it was given, unless it had to be resolved.
  const operands = [job.a, job.b].map((given, i) =>
    faults[i]!.length === 0 ? mk.convert(given, flat) : trace?.operands[i],
  );
  return {
    wkt: call(mk, job, exactWkt),
    exact: call(mk, job, exactFlat),
    origins: trace && describeOrigins(trace, operands as FlatResult[]),
  };
}

/** Says in words where each edge came from. */
function describeOrigins(trace: Trace<FlatResult>, operands: FlatResult[]): string[] | null {
  if (trace.origins === null) return null;
  const places = operands.map(({ coords, rings }) => {
    const at = (v: number) => `(${short(coords[2 * v]!)}, ${short(coords[2 * v + 1]!)})`;
    const next = (v: number) => {
      const ring = rings.findIndex((start) => start > v);
      return v + 1 === rings[ring] ? rings[ring - 1]! : v + 1;
    };
    return { vertex: at, edge: (v: number) => `${at(v)} to ${at(next(v))}` };
  });
  return trace.origins.map(({ edgeOperand, edge, vertex }: Origin) => {
    const other = 1 - edgeOperand;
    const name = "AB"[edgeOperand];
    return (
      `the edge ${places[edgeOperand]!.edge(edge)} of ${name}, moved by the vertex ` +
      `${places[other]!.vertex(vertex)} of ${"AB"[other]}`
    );
  });
}
const short = (value: number) => String(Number(value.toPrecision(6)));

function read(mk: Minksum, text: string, curveTolerance: number): ReadAnswer {
  const operand = mk.convert(text, { ...exactFlat, curveTolerance });
  const { coords, rings, polygons, lineCoords, lines, points } = operand;
  const positions = (list: string[], from: number, to: number) => {
    const made: Position[] = [];
    for (let v = from; v < to; ++v)
      made.push([fromExact(list[2 * v]!), fromExact(list[2 * v + 1]!)]);
    return made;
  };
  const shape: Shape = { polygons: [], lines: [], points: positions(points, 0, points.length / 2) };
  for (let p = 0; p + 1 < polygons.length; ++p) {
    const part: Position[][] = [];
    for (let r = polygons[p]!; r < polygons[p + 1]!; ++r)
      part.push(positions(coords, rings[r]!, rings[r + 1]!));
    shape.polygons.push(part);
  }
  for (let l = 0; l + 1 < lines.length; ++l)
    shape.lines.push(positions(lineCoords, lines[l]!, lines[l + 1]!));
  return { kind: "read", shape, faults: mk.validate(text, { curveTolerance, most: 20 }) };
}

function failure(problem: unknown, job: Job): Failure {
  if (!(problem instanceof MinksumError)) {
    return {
      kind: "failure",
      message: problem instanceof Error ? problem.message : String(problem),
    };
  }
  const { message, code, operand, polygon, ring, vertex, line, column } = problem;
  // The robot B is the first operand of its operations, and the obstacles A are the second.
  const isRobot = job.kind === "run" && ["robot", "slices", "path"].includes(job.op);
  const which = isRobot && operand !== undefined && operand < 2 ? 1 - operand : operand;
  return { kind: "failure", message, code, operand: which, polygon, ring, vertex, line, column };
}

onmessage = async ({ data: job }: MessageEvent<Job>) => {
  let answer: Answer;
  try {
    if (job.kind === "start") {
      library = await load({ wasm: job.wasm });
      // A first sum takes longer, because its code is compiled then.
      library.trace(
        "POLYGON ((0 0, 4 0, 1 1, 0 4, 0 0))",
        "POLYGON ((0 0, 3 1, 1 1, 1 3, 0 0))",
        flat,
      );
      answer = { kind: "started", version: library.version };
    } else {
      answer = job.kind === "read" ? read(library, job.text, job.tolerance) : run(library, job);
    }
  } catch (problem) {
    answer = failure(problem, job);
  }
  postMessage(answer);
};
