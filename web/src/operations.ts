// What each operation is called, says and lets one choose.
import { hasLimits } from "./limits.js";
import type { Operation, State } from "./model.js";

export interface OperationText {
  sign: string;
  name: string;
  text: string;
}
export const groups: [string, Operation[]][] = [
  ["Grow and shrink", ["sum", "erode", "open", "close", "offset"]],
  ["Place a part", ["nofit", "depth"]],
  ["Move a robot", ["robot", "slices", "path"]],
  ["How it works", ["steps"]],
];
export const texts: Record<Operation, OperationText> = {
  sum: {
    sign: "⊕",
    name: "Sum",
    text:
      "A ⊕ B is the area that B sweeps when its origin visits every point of A. Move the " +
      "pointer over A to see one copy of B.",
  },
  erode: {
    sign: "⊖",
    name: "Erosion",
    text: "A ⊖ B holds the places at which all of B lies inside A.",
  },
  open: {
    sign: "∘",
    name: "Opening",
    text: "A ∘ B is the part of A that B can reach without leaving A.",
  },
  close: {
    sign: "•",
    name: "Closing",
    text: "A • B is A together with the gaps that are too narrow for B.",
  },
  offset: {
    sign: "↔",
    name: "Offset",
    text:
      "A, grown by a distance, or shrunk if it is negative. The true curve runs inside of " +
      "the coloured band.",
  },
  nofit: {
    sign: "⊓",
    name: "No-fit polygon",
    text:
      "Drag B. Its origin is inside the polygon if the parts overlap, and on its boundary " +
      "if they touch. B snaps to places where it fits without play.",
  },
  depth: {
    sign: "→",
    name: "Depth vector",
    text: "The shortest move of B after which both parts only touch. Drag B.",
  },
  robot: {
    sign: "∠",
    name: "Robot at an angle",
    text:
      "A is the obstacle, B the robot. Where its origin is in the coloured area, the robot " +
      "collides. Move the pointer to see it.",
  },
  slices: {
    sign: "≡",
    name: "Slices, stacked",
    text:
      "The same for many angles, one above the other. Together they are the obstacles of a " +
      "robot that moves and turns.",
  },
  path: {
    sign: "⇝",
    name: "Path",
    text: "A way for the robot B from start to goal that collides with nothing. Drag both ends.",
  },
  steps: {
    sign: "§",
    name: "Step by step",
    text:
      "How the sum is computed: the stages of the method of Behar and Lien (2011), with the " +
      "numbers of this very sum.",
  },
};

export type Field =
  | { kind: "number"; name: string; label: string; min?: number; max?: number; step: number }
  | {
      kind: "range";
      name: string;
      label: string;
      min: number;
      max: number;
      step: number;
      unit?: string;
    }
  | {
      kind: "choice";
      name: string;
      label: string;
      options: readonly (readonly [string, string])[];
    }
  | { kind: "limits"; label: string };

const fill: Field = {
  kind: "choice",
  name: "fill",
  label: "Rings are read by",
  options: [
    ["automatic", "outer, holes"],
    ["evenodd", "even-odd"],
    ["nonzero", "non-zero"],
    ["positive", "positive"],
    ["negative", "negative"],
    ["strict", "strict rules"],
  ],
};
const angle: Field = {
  kind: "range",
  name: "degrees",
  label: "Angle",
  min: 0,
  max: 360,
  step: 1,
  unit: "°",
};
const slices: Field = { kind: "range", name: "slices", label: "Slices", min: 4, max: 120, step: 1 };

const limits: Field = { kind: "limits", label: "Robot stays between limits" };

export function fieldsOf(op: Operation): Field[] {
  switch (op) {
    case "offset":
      return [
        { kind: "range", name: "distance", label: "Distance", min: -4, max: 4, step: 0.0625 },
        { kind: "number", name: "distance", label: "exactly", step: 0.0625 },
        {
          kind: "number",
          name: "tolerance",
          label: "Tolerance",
          min: 0.0009765625,
          step: 0.015625,
        },
        {
          kind: "choice",
          name: "join",
          label: "Corners",
          options: [
            ["round", "round"],
            ["miter", "mitred"],
            ["square", "square"],
            ["bevel", "bevelled"],
          ],
        },
        {
          kind: "choice",
          name: "side",
          label: "Side of the error",
          options: [
            ["nearest", "nearest"],
            ["outside", "outside"],
            ["inside", "inside"],
          ],
        },
        fill,
      ];
    case "robot":
      return [angle, limits, fill];
    case "slices":
      return [slices, { ...angle, label: "Stack up to the angle" }, limits, fill];
    case "path":
      return [
        {
          kind: "range",
          name: "from.degrees",
          label: "Angle at start",
          min: -180,
          max: 180,
          step: 5,
          unit: "°",
        },
        {
          kind: "range",
          name: "to.degrees",
          label: "Angle at goal",
          min: -180,
          max: 180,
          step: 5,
          unit: "°",
        },
        { ...slices, label: "Angles of a full turn" },
        limits,
        fill,
      ];
    default:
      return [fill];
  }
}
export function valueOf(state: State, name: string): string | number {
  const [first, second] = name.split(".");
  const value = (state as any)[first!];
  return second ? (value?.[second] ?? "") : value;
}
export function withValue(state: State, name: string, value: string | number): Partial<State> {
  const [first, second] = name.split(".");
  return { [first!]: second ? { ...(state as any)[first!], [second]: value } : value };
}

/** What the colours mean. */
export function legendOf(state: State): [string, string][] {
  const limits: [string, string][] = hasLimits(state) ? [["limits", "limits"]] : [];
  const both: [string, string][] = [
    ["first", "A"],
    ["second", "B, with its origin"],
  ];
  switch (state.op) {
    case "offset":
      return [
        ["first", "A"],
        ["sum", "offset"],
        ...(state.join === "round" ? [["band", "error band"] as [string, string]] : []),
      ];
    case "nofit":
      return [...both, ["blocked", "no-fit polygon"], ["tight-line", "fits without play"]];
    case "depth":
      return [...both, ["arrow", "shortest move"], ["ghost", "B after it"]];
    case "robot":
      return [
        ["first", "obstacles A"],
        ["second", "robot B"],
        ["blocked", "here it collides"],
        ...limits,
      ];
    case "slices":
      return [
        ["first", "obstacles A"],
        ["slice", "slices, from 0° up"],
        ["slice chosen", "the highest one"],
        ...limits,
      ];
    case "path":
      return [
        ["first", "obstacles A"],
        ["second", "start"],
        ["second goal", "goal"],
        ["way", "way of the origin"],
        ...limits,
      ];
    case "steps":
      return stageLegend(state.stage, both);
    default: {
      const name = { sum: "A ⊕ B", erode: "A ⊖ B", open: "A ∘ B", close: "A • B" }[state.op];
      return [...both, ["sum", name]];
    }
  }
}
function stageLegend(stage: number, both: [string, string][]): [string, string][] {
  const edges: [string, string][] = [
    ["edge-first", "edges of A"],
    ["edge-second", "edges of B"],
  ];
  switch (stage) {
    case 0:
      return both;
    case 1:
      return [...edges, ["reflex", "at reflex vertices"]];
    case 2:
      return [...edges, ["dropped", "left out"]];
    case 3:
      return [...edges, ["covered", "covered cells"], ["dropped", "segments in them"]];
    case 4:
      return [...edges, ["node", "nodes"]];
    case 5:
      return [
        ["loop-outer", "outer loops"],
        ["loop-hole", "loops of holes"],
      ];
    case 6:
      return [
        ["accepted", "accepted"],
        ["nesting", "rejected by nesting"],
        ["collision", "rejected by collision"],
      ];
    default:
      return [...both, ["sum", "A ⊕ B"]];
  }
}
