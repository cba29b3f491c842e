// Measures the package beside the native program, clipper2-wasm and jsts, and prints tables:
// node bench/bench.mjs [FOLDER WITH MODELS]     (MINKSUM_PROGRAM is the native program)
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import GeoJSONReader from "jsts/org/locationtech/jts/io/GeoJSONReader.js";
import GeoJSONWriter from "jsts/org/locationtech/jts/io/GeoJSONWriter.js";
import BufferOp from "jsts/org/locationtech/jts/operation/buffer/BufferOp.js";
import { load } from "minksum";
import { minkowskiSum as clipperSum } from "./clipper.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const program = process.env.MINKSUM_PROGRAM ?? here("../../build/minksum");
const folder = process.argv[2] ?? here("../../../shared/data/paper");
const mk = await load();

/** Returns milliseconds of processor time, which other programs do not lengthen. */
const clock = () => {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
};
/** Returns the median time of a call in milliseconds. */
function time(call) {
  const once = (count) => {
    const begin = clock();
    for (let i = 0; i < count; ++i) call();
    return (clock() - begin) / count;
  };
  // The engine compiles what is called often.
  let last = once(1);
  for (const begin = clock(); clock() - begin < 500; ) last = once(1);
  if (last > 500) return last;
  const count = Math.max(1, Math.round(20 / last));
  return Array.from({ length: 9 }, () => once(count)).sort((a, b) => a - b)[4];
}
const table = (title, heads, rows) => {
  console.log(`\n${title}\n`);
  console.log(`| ${heads.join(" | ")} |\n|${heads.map((_, i) => (i === 0 ? "---|" : "---:|")).join("")}`);
  for (const row of rows) console.log(`| ${row.join(" | ")} |`);
};
const ms = (value) => (value < 10 ? value.toPrecision(2) : value.toFixed(0));

// -- Beside the native program --------------------------------------------------------------------
const pairs = [
  ["bird", "bird"], ["bird", "mammoth"], ["nazca_monkey", "nazca_monkey"], ["star5", "star5"],
  ["wierd2", "wierd2_n"], ["neuron_original", "neuron_original"], ["texas", "taiwan"],
  ["hole1", "hole2"], ["simple1", "simple2"], ["lookalike_g1", "lookalike_g1"],
];
const file = (name) => `${folder}/${name}.wkt`;
const read = (name) => mk.convert(readFileSync(file(name), "utf8"), { coords: "exact" });
const native = (a, b) => {
  const args = ["sum", file(a), file(b), "--stats", "-", "--repeat", "15", "--threads", "1", "-o", "/dev/null"];
  return 1000 * JSON.parse(execFileSync(program, args, { encoding: "utf8" })).seconds.sum;
};
const rows = pairs.map(([a, b]) => {
  const [p, q] = [mk.prepare(read(a)), mk.prepare(read(b))];
  const ours = time(() => mk.minkowskiSum(p, q, { as: "flat" }));
  const theirs = native(a, b);
  return [`${a} ⊕ ${b}`, ms(theirs), ms(ours), (ours / theirs).toFixed(1)];
});
table("Milliseconds of a sum", ["sum", "native", "WebAssembly", "ratio"], rows);

// -- Calls ----------------------------------------------------------------------------------------
const circle = (n) =>
  Array.from({ length: n }, (_, i) => [1000 * Math.cos((2 * Math.PI * i) / n), 1000 * Math.sin((2 * Math.PI * i) / n)]);
const forms = {
  "flat arrays": (ring) => [{ coords: Float64Array.from(ring.flat()), rings: [0, ring.length], polygons: [0, 1] }, { as: "flat" }],
  GeoJSON: (ring) => [{ type: "Polygon", coordinates: [[...ring, ring[0]]] }, {}],
};
const many = 10_000;
const calls = Object.entries(forms).map(([name, form]) => {
  const both = [3, many].map((n) => {
    const [operand, options] = form(circle(n));
    return time(() => mk.convert(operand, options));
  });
  return [name, (1000 * both[0]).toFixed(1), ((1e6 * (both[1] - both[0])) / many).toFixed(0)];
});
table("A call that takes a polygon in and gives it back", ["form", "µs a call", "ns a vertex, in and out"], calls);

// -- Beside other packages ------------------------------------------------------------------------
/** Returns how much of the exact area an answer has too much or lacks, as a part of it. */
function error(answer, exact) {
  const off = mk.symmetricDifference(answer, exact, { coords: "exact", fill: "nonzero" });
  return (mk.area(off) / mk.area(exact)).toExponential(0);
}
const sums = [];
for (const [a, b] of pairs.filter(([a]) => !a.startsWith("hole"))) {
  const operands = [read(a), read(b)].map((shape) => mk.convert(shape));
  if (operands.some((shape) => shape.type !== "Polygon" || shape.coordinates.length > 1)) continue;
  // Clipper2 makes a quadrangle for each pair of edges, and joining more of them takes minutes.
  const edges = operands.map((shape) => shape.coordinates[0].length - 1);
  if (edges[0] * edges[1] > 5_000) continue;
  const exact = mk.minkowskiSum(...operands, { coords: "exact" });
  sums.push([
    `${a} ⊕ ${b}`, ms(time(() => mk.minkowskiSum(...operands))), error(mk.minkowskiSum(...operands), exact),
    ms(time(() => clipperSum(...operands))), error(clipperSum(...operands), exact),
  ]);
}
table("Sums of GeoJSON, in doubles", ["sum", "minksum, ms", "error", "clipper2-wasm, ms", "error"], sums);

const [reader, writer] = [new GeoJSONReader(), new GeoJSONWriter()];
const offsets = [];
for (const name of ["bird", "nazca_monkey", "texas", "hole1"]) {
  const shape = mk.convert(read(name));
  const [minX, minY, maxX, maxY] = mk.bounds(shape);
  const distance = Math.max(maxX - minX, maxY - minY) / 50;
  // Eight segments of a quarter circle, as in JTS, are off by this part of the distance.
  const tolerance = distance * (1 - Math.cos(Math.PI / 32));
  const exact = mk.offset(shape, distance, { tolerance: distance * 1e-6, coords: "exact" });
  const geometry = reader.read(shape);
  const buffer = () => writer.write(BufferOp.bufferOp(geometry, distance, 8));
  const ours = () => mk.offset(shape, distance, { tolerance });
  offsets.push([name, ms(time(ours)), error(ours(), exact), ms(time(buffer)), error(buffer(), exact)]);
}
table(
  "Offsets by a fiftieth of the size, with eight segments a quarter circle",
  ["shape", "minksum, ms", "error", "jsts, ms", "error"],
  offsets,
);
