// The paper, step by step: what each stage of a sum makes, in words and as a picture.
import type { FlatResult, Segments, Trace } from "minksum";
import { fullConvolution, type FullConvolution } from "./convolution.js";
import { PathText, type Mark } from "./scene.js";
import { flatPaths } from "./shapes.js";
import type { View } from "./view.js";

type SumTrace = Trace<FlatResult>;

export interface StageText {
  name: string;
  /** three sentences */
  text: string;
  count(trace: SumTrace, full: FullConvolution | null): string;
  /** milliseconds, if the library does this stage */
  time(trace: SumTrace): number | null;
}
const number = (value: number) => value.toLocaleString("en");
const plural = (value: number, one: string, many = one + "s") =>
  `${number(value)} ${value === 1 ? one : many}`;
const vertices = (flat: FlatResult) => flat.coords.length / 2;

export const stageTexts: StageText[] = [
  {
    name: "Operands",
    text:
      "Both shapes are put on one grid of integers, so that no later decision is rounded. Outer " +
      "rings run counter-clockwise and holes clockwise, so the inside is always on the left. The " +
      "edges of each shape are sorted by their directions.",
    count: (t) =>
      `${plural(vertices(t.operands[0]), "vertex", "vertices")} of A, ` +
      `${number(vertices(t.operands[1]))} of B`,
    time: (t) => t.stageMilliseconds.operands,
  },
  {
    name: "Convolution",
    text:
      "Walk along A, and at each vertex turn from one edge to the next. Every edge of B whose " +
      "direction lies within that turn is moved to the vertex; then A and B change places. The " +
      "boundary of the sum consists of parts of these segments.",
    count: (_t, full) =>
      full
        ? plural((full.convex.length + full.reflex.length) / 4, "segment")
        : "too many segments to draw",
    time: () => null,
  },
  {
    name: "Reduced convolution",
    text:
      "At a reflex vertex the shape bends inwards, so the segments there lie inside the sum. The " +
      "paper leaves them out, and the boundary of the sum is still complete. The dashed " +
      "segments are " +
      "those that are left out.",
    count: (t) => `${plural(t.counts.convolutionSegments, "segment")} kept`,
    time: (t) => t.stageMilliseconds.convolution,
  },
  {
    name: "Cover",
    text:
      "A coarse grid finds cells that certainly lie inside the sum. Segments in such cells " +
      "cannot " +
      "be part of the boundary, so nobody has to intersect them. This step is not in the paper: " +
      "it is " +
      "where most of the speed comes from.",
    count: (t) =>
      t.cover
        ? `${number(t.counts.coveredCells)} of ${plural(t.counts.gridCells, "cell")} covered, ` +
          `${plural(t.counts.segmentsKept, "segment")} remain`
        : "no cover: these shapes are too small for one to pay",
    time: (t) => t.stageMilliseconds.cover,
  },
  {
    name: "Arrangement",
    text:
      "The segments that remain are split where they meet. Each crossing is an exact fraction, " +
      "never a rounded number. The pieces between crossings form a graph, whose nodes are the " +
      "dots.",
    count: (t) =>
      `${plural(t.counts.crossings, "crossing")}, ` + plural(t.arrangement.kept.length, "piece"),
    time: (t) => t.stageMilliseconds.arrangement,
  },
  {
    name: "Orientable loops",
    text:
      "From each piece, the walk goes on with the piece that turns most to the outside. Walks " +
      "that " +
      "come back to their start make loops, with all segments in one sense. Every ring of the " +
      "sum's " +
      "boundary is such a loop, but not every loop is such a ring.",
    count: (t) => plural(t.loops.length, "loop"),
    time: (t) => t.stageMilliseconds.loops,
  },
  {
    name: "Rejected loops",
    text:
      "A hole that does not lie within an outer loop is rejected by nesting. For each other " +
      "hole, " +
      "B is placed so that its origin is a point of the hole, and mirrored. If it collides with " +
      "A " +
      "there, then the point belongs to the sum, and the hole is false.",
    count: (t) =>
      `${number(t.counts.rejectedByNesting)} rejected by nesting, ` +
      `${number(t.counts.rejectedByCollision)} by collision`,
    time: (t) => t.stageMilliseconds.filters,
  },
  {
    name: "Result",
    text:
      "The loops that remain are the boundary of the sum. Outer rings and their holes become " +
      "polygons in a fixed order, so equal sums have equal text. Every coordinate is still " +
      "exact, and " +
      "every edge knows which edge and which vertex made it.",
    count: (t) =>
      `${plural(t.result.polygons.length - 1, "polygon")}, ` +
      `${plural(t.result.rings.length - t.result.polygons.length, "hole")}, ` +
      plural(vertices(t.result), "vertex", "vertices"),
    time: (t) => t.stageMilliseconds.output,
  },
];

let last: { trace: SumTrace; full: FullConvolution | null } | undefined;
export function fullOf(trace: SumTrace): FullConvolution | null {
  if (last?.trace !== trace) last = { trace, full: fullConvolution(...trace.operands) };
  return last.full;
}

/** The segments for which `choose` says yes, as paths by operand. */
function segments(view: View, list: Segments, choose: (i: number) => boolean): [string, string] {
  const paths = [new PathText(view), new PathText(view)];
  for (let i = 0; i < list.kept.length; ++i) {
    if (choose(i)) paths[list.edgeOperand[i]!]!.add(list.xy, 2 * i, 2 * i + 2, false);
  }
  return [paths[0]!.toString(), paths[1]!.toString()];
}
function pairs(view: View, xy: number[]): string {
  const path = new PathText(view);
  for (let v = 0; 2 * v < xy.length; v += 2) path.add(xy, v, v + 2, false);
  return path.toString();
}
const byOperand = ([first, second]: [string, string]): Mark[] => [
  { cls: "edge-first", d: first },
  { cls: "edge-second", d: second },
];

function coverMarks(view: View, trace: SumTrace): Mark[] {
  const { cover } = trace;
  if (!cover) return [];
  const covered = new PathText(view);
  const grid = new PathText(view);
  const { minX, minY, cellWidth, cellHeight, columns, rows } = cover;
  const x = (column: number) => minX + column * cellWidth;
  const y = (row: number) => minY + row * cellHeight;
  for (let row = 0; row < rows; ++row) {
    for (let column = 0; column < columns; ++column) {
      if (cover.covered[row * columns + column] !== 1) continue;
      let end = column;
      while (end + 1 < columns && cover.covered[row * columns + end + 1] === 1) ++end;
      const [left, right, bottom, top] = [x(column), x(end + 1), y(row), y(row + 1)];
      covered.add([left, bottom, right, bottom, right, top, left, top]);
      column = end;
    }
  }
  for (let i = 0; i <= columns; ++i) grid.add([x(i), minY, x(i), y(rows)], 0, 2, false);
  for (let i = 0; i <= rows; ++i) grid.add([minX, y(i), x(columns), y(i)], 0, 2, false);
  return [
    { cls: "covered", d: covered.toString() },
    { cls: "cells", d: grid.toString() },
  ];
}

function loopMarks(view: View, trace: SumTrace, rejected: boolean): Mark[] {
  const paths: Record<string, PathText> = {};
  for (const loop of trace.loops) {
    const cls = !rejected
      ? loop.counterclockwise
        ? "loop-outer"
        : "loop-hole"
      : loop.fate === "accepted"
        ? "accepted"
        : loop.fate === "rejected-by-nesting"
          ? "nesting"
          : "collision";
    (paths[cls] ??= new PathText(view)).add(loop.xy);
  }
  return Object.entries(paths).map(([cls, path]) => ({ cls, d: path.toString() }));
}

/** The picture of a stage. */
export function stageMarks(view: View, trace: SumTrace, stage: number): Mark[] {
  const { convolution, arrangement } = trace;
  const sum = (cls: string): Mark => ({ cls, d: flatPaths(view, trace.result).area });
  switch (stage) {
    case 0:
      return [];
    case 1:
    case 2: {
      const full = fullOf(trace);
      const dropped: Mark[] = full
        ? [{ cls: stage === 1 ? "reflex" : "dropped", d: pairs(view, full.reflex) }]
        : [];
      return [sum("ghost-sum"), ...dropped, ...byOperand(segments(view, convolution, () => true))];
    }
    case 3:
      return [
        ...coverMarks(view, trace),
        {
          cls: "dropped",
          d: segments(view, convolution, (i) => convolution.kept[i] === 0).join(""),
        },
        ...byOperand(segments(view, convolution, (i) => convolution.kept[i] !== 0)),
      ];
    case 4:
      return [
        sum("ghost-sum"),
        ...byOperand(segments(view, arrangement, () => true)),
        { cls: "node", d: new PathText(view).dots(arrangement.nodes).toString() },
      ];
    case 5:
      return loopMarks(view, trace, false);
    case 6:
      return [sum("ghost-sum"), ...loopMarks(view, trace, true)];
    default: {
      const { area, lines, dots } = flatPaths(view, trace.result);
      return [
        { cls: "sum", d: area },
        { cls: "sum-line", d: lines },
        { cls: "sum-dot", d: dots },
      ];
    }
  }
}
