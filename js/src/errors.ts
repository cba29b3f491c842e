/** Says which kind of failure an error reports. */
export type ErrorCode = "bad-input" | "limit" | "cancelled" | "internal";

/** The error that every operation throws. Indices count from 0, lines and columns from 1. */
export class MinksumError extends Error {
  override readonly name = "MinksumError";
  readonly code: ErrorCode;
  /** the operand to blame: 0 = the first; in a list its index; `undefined` = none */
  readonly operand: number | undefined;
  readonly polygon: number | undefined;
  /** the ring in its polygon: 0 = outer, 1… = holes */
  readonly ring: number | undefined;
  /** the vertex in its ring, its polyline, or its list of points */
  readonly vertex: number | undefined;
  /** the line of a text */
  readonly line: number | undefined;
  readonly column: number | undefined;
  /** the exceeded limit, such as "Limits::max_segments" or "memory" */
  readonly limit: string | undefined;

  constructor(code: ErrorCode, message: string, place: ErrorPlace = {}) {
    super(message);
    this.code = code;
    this.operand = place.operand;
    this.polygon = place.polygon;
    this.ring = place.ring;
    this.vertex = place.vertex;
    this.line = place.line;
    this.column = place.column;
    this.limit = place.limit;
  }
}
/** What an error tells besides its code and its message. */
export interface ErrorPlace {
  operand?: number | undefined;
  polygon?: number | undefined;
  ring?: number | undefined;
  vertex?: number | undefined;
  line?: number | undefined;
  column?: number | undefined;
  limit?: string | undefined;
}

/** The error of an argument that is not what it must be. */
export function badInput(message: string, place: ErrorPlace = {}): MinksumError {
  return new MinksumError("bad-input", message, place);
}
