// Reads what the stages of a sum made.
import type { Address, Library } from "./abi.js";
import type { Results } from "./results.js";
import { stages, type Loop, type Options, type ResultOf, type Segments, type Stage, type Trace } from "./types.js";

const kFates: Loop["fate"][] = ["accepted", "rejected-by-nesting", "rejected-by-collision"];
const kStatisticsAt = 64;

export function readTrace<O extends Options>(
  library: Library, results: Results, both: [Address, Address], how: Address,
  operands: [ResultOf<O>, ResultOf<O>], options: O,
): Trace<ResultOf<O>> {
  const { call, error } = library;
  const at = library.results;
  const status = call["minksum_detailed_sum"]!(
    both[0], both[1], how, at, at + 4, at + kStatisticsAt, at + 8, error,
  );
  library.check(status);
  const [sum, tight, trace] = library.u32.slice(at >>> 2, (at >>> 2) + 3);
  const did = library.f64.slice((at + kStatisticsAt) / 8, (at + kStatisticsAt) / 8 + 16);
  try {
    const origins = results.origins(sum!);
    const stageMilliseconds = Object.fromEntries(
      stages.map((stage, i) => [stage, 1000 * did[9 + i]!]),
    ) as Record<Stage, number>;
    return {
      operands,
      ...readStages(library, trace!),
      result: results.convert(sum!, options),
      tight: results.convert(tight!, options),
      origins,
      counts: {
        convolutionSegments: did[0]!,
        segmentsKept: did[1]!,
        crossings: did[2]!,
        loops: did[3]!,
        rejectedByNesting: did[4]!,
        rejectedByCollision: did[5]!,
        gridCells: did[6]!,
        coveredCells: did[7]!,
      },
      milliseconds: 1000 * did[8]!,
      stageMilliseconds,
    };
  } finally {
    call["minksum_geometry_free"]!(sum!);
    call["minksum_geometry_free"]!(tight!);
    call["minksum_trace_free"]!(trace!);
  }
}

type Stages = Pick<Trace<never>, "convolution" | "cover" | "arrangement" | "loops">;

function readStages(library: Library, trace: Address): Stages {
  const { call, results, error } = library;
  call["minksum_trace_get_counts"]!(results, trace);
  const at = results >>> 2;
  const [segments, nodes, pieces, loops, loopVertices, columns, rows] = library.u32.slice(at, at + 7);
  const [minX, minY, cellWidth, cellHeight] = library.f64.slice(results / 8 + 4, results / 8 + 8);
  const doubles = (count: number, from: Address) => library.doubles(from, count);
  const bytes = (count: number, from: Address) => library.u8.slice(from, from + count);
  const readSegments = (name: string, count: number): Segments =>
    library.withRoom(33 * count, (xy) => {
      const flags = xy + 32 * count;
      library.check(call[name]!(trace, xy, flags, error));
      const said = bytes(count, flags);
      return {
        xy: doubles(4 * count, xy),
        edgeOperand: said.map((flag) => 1 - (flag & 1)),
        kept: said.map((flag) => flag >> 1),
      };
    });
  const nodesXy = library.withRoom(16 * nodes!, (xy) => {
    library.check(call["minksum_trace_get_nodes"]!(trace, xy, error));
    return doubles(2 * nodes!, xy);
  });
  const cells = columns! * rows!;
  const covered = library.withRoom(cells, (flags) => {
    library.check(call["minksum_trace_get_cover"]!(trace, flags, error));
    return bytes(cells, flags);
  });
  const readLoops = library.withRoom(16 * loopVertices! + 9 * loops! + 8, (xy): Loop[] => {
    const offsetsAt = xy + 16 * loopVertices!;
    const statesAt = offsetsAt + 8 * (loops! + 1);
    library.check(call["minksum_trace_get_loops"]!(trace, xy, offsetsAt, statesAt, error));
    const offset = (i: number) => library.u32[(offsetsAt >>> 2) + 2 * i]!;
    return Array.from({ length: loops! }, (_, i) => {
      const state = library.u8[statesAt + i]!;
      return {
        xy: doubles(2 * (offset(i + 1) - offset(i)), xy + 16 * offset(i)),
        counterclockwise: (state & 4) !== 0,
        fate: kFates[state & 3]!,
      };
    });
  });
  return {
    convolution: readSegments("minksum_trace_get_convolution", segments!),
    cover:
      columns === 0
        ? null
        : {
            minX: minX!,
            minY: minY!,
            cellWidth: cellWidth!,
            cellHeight: cellHeight!,
            columns: columns!,
            rows: rows!,
            covered,
          },
    arrangement: { ...readSegments("minksum_trace_get_pieces", pieces!), nodes: nodesXy },
    loops: readLoops,
  };
}
