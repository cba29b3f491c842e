// The state as text in the fragment of the address: "#v1." and base64url of deflated JSON.
import {
  defaults,
  emptyShape,
  fills,
  joins,
  operations,
  sides,
  type Limits,
  type Position,
  type Shape,
  type State,
} from "./model.js";

const kPrefix = "v1.";
/** What fits into an address that mail programs and chats keep whole. */
export const kLargestLink = 8192;

/** Returns the JSON of what differs from the defaults. */
export function toJson(state: State): string {
  const kept = Object.entries(state).filter(
    ([name, value]) => JSON.stringify(value) !== JSON.stringify((defaults as any)[name]),
  );
  return JSON.stringify({ version: 1, ...Object.fromEntries(kept) });
}

const choice = <T extends string>(given: unknown, names: readonly T[], name: string): T => {
  if (names.includes(given as T)) return given as T;
  throw new Error(
    `The link names ${JSON.stringify(given)} as \`${name}\`, which this page does not know.`,
  );
};
const finite = (given: unknown, name: string): number => {
  if (typeof given === "number" && Number.isFinite(given)) return given;
  throw new Error(`The link has no number for \`${name}\`.`);
};
const isPosition = (p: any) =>
  Array.isArray(p) &&
  p.length === 2 &&
  p.every((c) =>
    typeof c === "number" ? Number.isFinite(c) : /^-?\d+(\/[1-9]\d*)?$/.test(String(c)),
  );
function place(given: any): Position {
  if (isPosition(given)) return given;
  throw new Error("The link has no position for `place`.");
}
function shape(given: any, name: string): Shape {
  const made = { ...emptyShape(), ...given };
  const paths = [...made.polygons.flat(), ...made.lines, made.points];
  if (!paths.every((path: any) => Array.isArray(path) && path.every(isPosition))) {
    throw new Error(`The link has a position of ${name} that is not two numbers.`);
  }
  return { polygons: made.polygons, lines: made.lines, points: made.points };
}

/** Reads what `toJson` wrote. Throws an error that says what is wrong. */
export function fromJson(text: string): State {
  const given = JSON.parse(text);
  if (given?.version !== 1) throw new Error("This was made by another version of the page.");
  const all = { ...defaults, ...given };
  const pose = (p: any, name: string) => ({
    x: finite(p?.x, `${name}.x`),
    y: finite(p?.y, `${name}.y`),
    degrees: finite(p?.degrees, `${name}.degrees`),
  });
  const limit = (name: keyof Limits) => finite(all.workspace[name], `workspace.${name}`);
  const limits = () => ({
    left: limit("left"),
    bottom: limit("bottom"),
    right: limit("right"),
    top: limit("top"),
  });
  return {
    a: shape(given.a, "A"),
    b: shape(given.b, "B"),
    op: choice(all.op, operations, "op"),
    fill: choice(all.fill, fills, "fill"),
    join: choice(all.join, joins, "join"),
    side: choice(all.side, sides, "side"),
    distance: finite(all.distance, "distance"),
    tolerance: finite(all.tolerance, "tolerance"),
    place: place(all.place),
    degrees: finite(all.degrees, "degrees"),
    slices: Math.min(360, Math.max(1, Math.round(finite(all.slices, "slices")))),
    from: pose(all.from, "from"),
    to: pose(all.to, "to"),
    workspace: all.workspace === null ? null : limits(),
    stage: Math.min(7, Math.max(0, Math.round(finite(all.stage, "stage")))),
  };
}

async function through(
  bytes: Uint8Array,
  by: { readable: ReadableStream; writable: WritableStream },
) {
  const stream = new Blob([bytes as BlobPart]).stream().pipeThrough(by as ReadableWritablePair);
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
/** Returns the fragment of the address that shows this state. */
export async function toFragment(state: State): Promise<string> {
  const packed = await through(
    new TextEncoder().encode(toJson(state)),
    new CompressionStream("deflate-raw"),
  );
  const text = Array.from(packed, (byte) => String.fromCharCode(byte)).join("");
  return kPrefix + btoa(text).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}
/** Returns the state of a fragment; `null` if it has none. */
export async function fromFragment(fragment: string): Promise<State | null> {
  const text = fragment.replace(/^#/, "");
  if (text === "") return null;
  if (!text.startsWith(kPrefix))
    throw new Error("The address ends with a link that this page does not know.");
  try {
    const coded = text.slice(kPrefix.length).replaceAll("-", "+").replaceAll("_", "/");
    const packed = Uint8Array.from(atob(coded), (c) => c.charCodeAt(0));
    const json = await through(packed, new DecompressionStream("deflate-raw"));
    return fromJson(new TextDecoder().decode(json));
  } catch (problem) {
    if (problem instanceof Error && problem.message.startsWith("Th")) throw problem;
    throw new Error("The link in the address is damaged: a part of it may be missing.");
  }
}
