// Every operation gives what the program gives, exactly.
import assert from "node:assert/strict";
import { test } from "node:test";
import { box, mk, random, run, star } from "./support.js";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const folder = mkdtempSync(join(tmpdir(), "minksum-"));
const exact = { as: "wkt", coords: "exact" };
const wkt = (operand) => mk.convert(operand, exact);
let files = 0;
const file = (operand) => {
  const path = join(folder, `${++files}.wkt`);
  writeFileSync(path, wkt(operand));
  return path;
};
const a = { type: "Polygon", coordinates: [...box(0, 0, 9, 9).coordinates, ...box(3, 3, 6, 6).coordinates] };
const b = "POLYGON ((0 0, 0.1 0, 1/3 1, 0 0))";
const byProgram = (command, ...args) => run([command, ...args, "--coords", "exact"]).trim();

test("sums and morphology are those of the program", () => {
  const [pa, pb] = [file(a), file(b)];
  assert.equal(mk.minkowskiSum(a, b, exact), byProgram("sum", pa, pb));
  assert.equal(mk.dilate(a, b, exact), byProgram("dilate", pa, pb));
  assert.equal(mk.erode(a, b, exact), byProgram("erode", pa, pb));
  assert.equal(mk.opening(a, b, exact), byProgram("open", pa, pb));
  assert.equal(mk.closing(a, b, exact), byProgram("close", pa, pb));
  assert.equal(mk.noFitPolygon(a, b, exact), byProgram("nfp", pa, pb));
  assert.equal(mk.innerFitPolygon(a, b, exact), byProgram("ifp", pa, pb));
  assert.equal(mk.offset(a, 1.5, exact), byProgram("offset", pa, "-d", "1.5"));
  const shape = { join: "miter", cap: "butt", miterLimit: 3, tolerance: 0.25 };
  const words = ["--join", "miter", "--cap", "butt", "--miter-limit", "3", "--tolerance", "0.25"];
  assert.equal(mk.offset(a, -0.5, { ...exact, ...shape }), byProgram("offset", pa, "-d", "-0.5", ...words));
});

test("results have the asked form, and are operands again", () => {
  const sum = mk.minkowskiSum(a, b);
  assert.equal(sum.type, "Polygon");
  assert.deepEqual(sum.coordinates[0][2], [28 / 3, 1]);
  const strings = mk.minkowskiSum(a, b, { coords: "exact" });
  assert.deepEqual(strings.coordinates[0][2], ["28/3", "1"]);
  const flat = mk.minkowskiSum(a, b, { as: "flat" });
  assert.ok(flat.coords instanceof Float64Array);
  assert.deepEqual([...flat.rings], [0, 6, 10]);
  assert.deepEqual([...flat.polygons], [0, 2]);
  const exactFlat = mk.minkowskiSum(a, b, { as: "flat", coords: "exact" });
  assert.deepEqual(exactFlat.coords.slice(4, 6), ["28/3", "1"]);
  const text = mk.minkowskiSum(a, b, exact);
  for (const operand of [strings, exactFlat, text]) assert.equal(mk.resolve(operand, exact), text);
  for (const operand of [sum, flat]) assert.deepEqual(mk.convert(operand), sum);
  assert.match(mk.toSvg(a), /^<svg/);
});

test("thin parts come and go in every form", () => {
  const thin = "GEOMETRYCOLLECTION (POLYGON ((0 0, 1/3 0, 0 1, 0 0)), LINESTRING (5 5, 6 6, 7 5), LINESTRING (8 8, 9 9), POINT (20 1/7))";
  for (const options of [{ coords: "exact" }, { as: "flat", coords: "exact" }]) {
    assert.equal(wkt(mk.convert(thin, options)), wkt(thin));
  }
  const doubles = mk.convert(thin, { as: "flat" });
  assert.deepEqual(mk.convert(doubles), mk.convert(thin));
  assert.deepEqual(mk.convert("POLYGON EMPTY"), { type: "Polygon", coordinates: [] });
});

test("a number means its double, and a string what it says", () => {
  const point = (x) => wkt({ type: "Point", coordinates: [x, 0] });
  assert.equal(point(0.1), "POINT (3602879701896397/36028797018963968 0)");
  assert.equal(point("0.1"), "POINT (1/10 0)");
  assert.equal(wkt({ type: "MultiPoint", coordinates: [[0.1, 0], ["1/3", 0]] }),
    "MULTIPOINT ((3602879701896397/36028797018963968 0), (1/3 0))");
});

test("SVG, DXF, WKB and GeoJSON are read", () => {
  const svg = '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H4V4H0Z"/></svg>';
  assert.equal(mk.area(svg), 16);
  const round = '<svg xmlns="http://www.w3.org/2000/svg"><circle r="1"/></svg>';
  assert.throws(() => mk.area(round), { code: "bad-input", operand: 0 });
  const area = mk.area(round, { curveTolerance: 0.001, curveSide: "outside" });
  assert.ok(area > Math.PI && area < Math.PI * 1.003);
  const pairs = [0, "SECTION", 2, "ENTITIES", 0, "LWPOLYLINE", 8, "0", 90, 3, 70, 1, 10, 0, 20, 0, 10, 4,
    20, 0, 10, 0, 20, 4, 0, "ENDSEC", 0, "EOF"];
  assert.equal(mk.area(pairs.join("\n") + "\n"), 8);
  assert.equal(mk.area(JSON.stringify(a)), 72);
  assert.equal(mk.area({ type: "Feature", geometry: a, properties: null }), 72);
  const wkb = Buffer.from("01030000000100000004000000" + "0000000000000000".repeat(2) +
    "000000000000f03f0000000000000000" + "0000000000000000000000000000f03f" + "0000000000000000".repeat(2), "hex");
  assert.equal(mk.area(new Uint8Array(wkb)), 0.5);
});

test("parts are placed", () => {
  const part = box(0, 0, 2, 2);
  const contacts = mk.contact(part, part, [5, 5, 2, 1, 1, 1]);
  assert.deepEqual(contacts, ["free", "touching", "overlapping"]);
  const hole = { type: "Polygon", coordinates: [...box(0, 0, 9, 9).coordinates, ...box(3, 3, 5, 5).coordinates] };
  assert.deepEqual(mk.contact(hole, part, [3, 3, 3.5, 3]), ["touching", "overlapping"]);
  const table = mk.noFitTable([hole, part], { turns: 2 });
  assert.deepEqual([table.size, table.turns], [2, 2]);
  assert.equal(table.at(0, 1, exact), mk.noFitPolygon(hole, part, exact));
  assert.deepEqual(table.contact(0, 1, [3, 3, 20, 20]), ["touching", "free"]);
  assert.throws(() => table.at(2, 0), { code: "bad-input" });
  table.dispose();
  assert.throws(() => table.at(0, 0), { code: "bad-input" });
});

test("sets stand to each other", () => {
  const other = box(1, 1, 4, 2);
  assert.deepEqual(mk.penetrationDepth(box(0, 0, 9, 9), other), {
    overlapping: true, vector: [0, -2], exact: ["0", "-2"], distance: 2,
  });
  assert.deepEqual(mk.penetrationDepth("POINT (0 0)", other), {
    overlapping: false, vector: [-1, -1], exact: ["-1", "-1"], distance: Math.SQRT2,
  });
  assert.equal(mk.penetrationDepth("POINT EMPTY", other), null);
  assert.equal(mk.timeOfImpact(box(0, 0, 1, 1), box(5, 0, 6, 1), [-2, 0]), 2);
  assert.equal(mk.timeOfImpact(box(0, 0, 1, 1), box(5, 0, 6, 1), [2, 0]), null);
  const exactly = (direction) =>
    mk.timeOfImpact(box(0, 0, 1, 1), box(5, 0, 6, 1), direction, { coords: "exact" });
  assert.equal(exactly([-3, 0]), "4/3");
  assert.equal(exactly([3, 0]), null);
});

test("robots go where they can", () => {
  const walls = { type: "MultiPolygon", coordinates: [box(0, 3, 4, 4).coordinates, box(5, 3, 9, 4).coordinates] };
  const robot = box(-0.4, -1, 0.4, 1);
  const workspace = box(0, 0, 9, 9);
  const slices = mk.slices(robot, walls, [0, 90], { workspace, free: true, ...exact });
  assert.equal(slices.length, 2);
  assert.match(slices[0].free, /POLYGON/);
  const from = { x: 4.5, y: 1.5, degrees: 0 };
  const through = mk.reach(robot, walls, from, { x: 4.5, y: 6, degrees: 0 }, { workspace, angles: 4 });
  assert.equal(through.reachable, true);
  assert.deepEqual(through.path[0], from);
  const exactly = mk.reach(robot, walls, from, { x: 4.5, y: 6, degrees: 30 }, { workspace, angles: 12, coords: "exact" });
  assert.deepEqual(exactly.path[0], { ...from, x: "9/2", y: "3/2", cos: "1", sin: "0" });
  for (const { cos, sin } of exactly.path) {
    const [[p, q = 1n], [r, s = 1n]] = [cos, sin].map((text) => text.split("/").map(BigInt));
    assert.equal((p * s) ** 2n + (r * q) ** 2n, (q * s) ** 2n, "a point of the unit circle");
  }
  assert.ok(Math.abs(exactly.path.at(-1).degrees - 30) < 0.01);
  const wide = mk.reach(box(-1, -1, 1, 1), walls, from, { x: 4.5, y: 6, degrees: 0 }, { workspace, angles: 4 });
  assert.deepEqual(wide, { reachable: false, path: [] });
});

test("tight places are rounded and moved with their no-fit polygon", () => {
  const slot = "POLYGON ((0 0, 6 0, 6 4, 4 4, 4 4/3, 2 4/3, 2 4, 0 4, 0 0))";
  const peg = box(0, 0, 2, 3);
  const polygon = mk.noFitPolygon(slot, peg, exact);
  for (const side of ["nearest", "outside", "inside"]) {
    const byProgram = run(["nfp", file(slot), file(peg), "--round", side, "--coords", "decimal:0"]);
    assert.equal(mk.rounded(polygon, { decimals: 0, side, ...exact }), wkt(byProgram));
    assert.match(byProgram, /LINESTRING/);
  }
  assert.doesNotMatch(mk.rounded(polygon, { tight: false, ...exact }), /LINESTRING/);
  assert.match(mk.transform(polygon, [1, 0, 1, 0, 1, 0], exact), /LINESTRING \(3 4\/3, 3 4\)/);
});

test("sets are combined, rounded, moved and asked", () => {
  const [p, q] = [box(0, 0, 2, 2), box(1, 1, 3, 3)];
  assert.equal(mk.area(mk.union(p, q)), 7);
  assert.equal(mk.area(mk.intersection(p, q)), 1);
  assert.equal(mk.area(mk.difference(p, q)), 3);
  assert.equal(mk.area(mk.symmetricDifference(p, q)), 6);
  assert.deepEqual(mk.bounds(mk.transform(p, [0, -1, 5, 1, 0, 0])), [3, 0, 5, 2]);
  assert.deepEqual(mk.locate(p, [1, 1, 2, 1, 3, 1]), ["inside", "boundary", "outside"]);
  const thirds = "POLYGON ((0 0, 1/3 0, 0 2/3, 0 0))";
  const byProgramRounded = ["sum", file(thirds), file("POINT (0 0)"), "--round", "outside", "--coords", "decimal:2"];
  assert.equal(mk.rounded(thirds, { decimals: 2, side: "outside", ...exact }), wkt(run(byProgramRounded)));
  assert.equal(mk.bounds("POINT (1 1)"), null);
  assert.deepEqual(mk.validate(p), []);
  const bowTie = "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))";
  assert.match(mk.validate(bowTie)[0].message, /cross/);
  const sum = mk.minkowskiSum(p, q);
  assert.equal(mk.checkSum(sum, p, q).proved, true);
  assert.equal(mk.checkSum(p, p, q).ok, false);
  assert.match(mk.version, /^\d+\.\d+\.\d+$/);
});

test("a trace has every stage", () => {
  const next = random(7);
  const [p, q] = [star(next, 60), star(next, 40)];
  const trace = mk.trace(p, q, exact);
  assert.equal(trace.result, mk.minkowskiSum(p, q, exact));
  assert.equal(trace.operands[0], mk.resolve(p, exact));
  assert.equal(trace.convolution.xy.length, 4 * trace.convolution.kept.length);
  assert.equal(trace.convolution.kept.length, trace.counts.convolutionSegments);
  assert.equal(trace.arrangement.xy.length, 4 * trace.arrangement.edgeOperand.length);
  assert.ok(trace.arrangement.nodes.length > 0);
  assert.equal(trace.loops.length, trace.counts.loops);
  const fate = (name) => trace.loops.filter((loop) => loop.fate === name).length;
  assert.equal(fate("rejected-by-nesting"), trace.counts.rejectedByNesting);
  assert.equal(fate("rejected-by-collision"), trace.counts.rejectedByCollision);
  assert.equal(trace.cover.covered.length, trace.cover.columns * trace.cover.rows);
  assert.ok(trace.cover.cellWidth > 0 && trace.cover.cellHeight > 0);
  assert.equal(trace.cover.covered.reduce((n, cell) => n + cell, 0), trace.counts.coveredCells);
  const { length } = mk.convert(trace.result, { as: "flat" }).coords;
  assert.equal(trace.origins.length, length / 2);
  assert.ok(trace.milliseconds > 0);
  assert.deepEqual(Object.keys(trace.stageMilliseconds).length, 7);
});

test("prepared operands give the same sums", () => {
  const next = random(3);
  const [p, q] = [star(next, 30), star(next, 20)];
  const [first, second] = [mk.prepare(p), mk.prepare(q)];
  assert.equal(mk.minkowskiSum(first, second, exact), mk.minkowskiSum(p, q, exact));
  assert.equal(mk.minkowskiSum(first, q, exact), mk.minkowskiSum(p, q, exact));
  first.dispose();
  first.dispose();
  second[Symbol.dispose]?.();
  assert.throws(() => mk.minkowskiSum(first, q), { code: "bad-input" });
  assert.throws(() => mk.prepare("POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))"), { code: "bad-input" });
});
