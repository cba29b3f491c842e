// What the page asks its worker, and what the worker answers.
import type {
  Contact,
  Depth,
  ExactFlatResult,
  Fault,
  FlatResult,
  Progress,
  Reach,
  Trace,
} from "minksum";
import type { Operation, Shape, State } from "./model.js";

export interface RunJob extends Omit<State, "a" | "b" | "op" | "workspace"> {
  kind: "run";
  id: number;
  op: Operation;
  /** operands as WKT */
  a: string;
  b: string;
  /** B where it was dragged to */
  placed: string;
  /** the limits of the plane as WKT */
  limits?: string | undefined;
  /** whether exact coordinates and origins are asked for, and the faults of both operands */
  details: boolean;
}
/** Reads a text of any format. */
export interface ReadJob {
  kind: "read";
  text: string;
  tolerance: number;
}
/** What the worker is given first. */
export interface StartJob {
  kind: "start";
  wasm: WebAssembly.Module;
}
export type Job = RunJob | ReadJob | StartJob;

/** Exact coordinates of a result, and where its edges came from. */
export interface Details {
  wkt: string;
  exact: ExactFlatResult;
  /** by vertex: the edge of an operand and the vertex of the other, in words */
  origins: string[] | null;
}
export interface RunAnswer {
  kind: "run";
  /** the job that is answered */
  id: number;
  op: Operation;
  milliseconds: number;
  result: FlatResult | null;
  /** the band in which the true offset's boundary lies */
  band?: { inner: FlatResult; outer: FlatResult };
  contact?: Contact;
  depth?: Depth | null;
  slices?: { degrees: number; obstacles: FlatResult }[];
  reach?: Reach;
  trace?: Trace<FlatResult>;
  details?: Details;
  faults?: [Fault[], Fault[]];
}
export interface ReadAnswer {
  kind: "read";
  shape: Shape;
  faults: Fault[];
}
export interface Failure {
  kind: "failure";
  message: string;
  code?: string;
  operand?: number;
  polygon?: number;
  ring?: number;
  vertex?: number;
  line?: number;
  column?: number;
}
export type Answer = RunAnswer | ReadAnswer | Failure | { kind: "started"; version: string };
/** Told while a job goes on. */
export type Told = { kind: "progress" } & Progress;
