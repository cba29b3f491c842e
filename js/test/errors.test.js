// Bad input is refused with its place, and leaves the library as it was.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load, MinksumError } from "minksum";
import { box, mk } from "./support.js";

const good = box(0, 0, 1, 1);
const ring = (...positions) => ({ type: "Polygon", coordinates: [[[0, 0], [9, 0], [9, 9], [0, 0]], positions] });
const refused = (operand, place, options = {}) => {
  assert.throws(() => mk.minkowskiSum(good, operand, options), (error) => {
    assert.ok(error instanceof MinksumError, String(error));
    assert.equal(error.code, "bad-input");
    for (const [name, value] of Object.entries({ operand: 1, ...place })) {
      assert.equal(error[name], value, `${name}: ${error.message}`);
    }
    return true;
  });
};

test("numbers that are none are refused with operand, polygon, ring and vertex", () => {
  for (const bad of [NaN, Infinity, -Infinity, null, undefined, true, "x", "1/", "0x1", "", "1/0"]) {
    const place = bad === "1/0" ? {} : { polygon: 0, ring: 1, vertex: 2 };
    refused(ring([1, 1], [2, 1], [2, bad], [1, 1]), place);
  }
  refused({ coords: [0, 0, 1, 0, NaN, 1], rings: [0, 3], polygons: [0, 1] }, { polygon: 0, ring: 0, vertex: 2 });
});
test("heights are refused unless they are dropped", () => {
  refused(ring([1, 1], [2, 1, 7], [2, 2]), { polygon: 0, ring: 1, vertex: 1 });
  const dropped = mk.minkowskiSum(good, ring([1, 1], [2, 1, 7], [2, 2]), { z: "drop" });
  assert.deepEqual(dropped, mk.minkowskiSum(good, ring([1, 1], [2, 1], [2, 2])));
  refused("POINT Z (1 2 3)", { line: 1 });
  assert.deepEqual(mk.convert("POINT Z (1 2 3)", { z: "drop" }).coordinates, [1, 2]);
});
test("polygons that are not valid are refused if they must be valid", () => {
  const crossed = { type: "Polygon", coordinates: [[[0, 0], [4, 4], [4, 0], [0, 4], [0, 0]]] };
  refused(crossed, { polygon: 0, ring: 0 }, { fill: "strict" });
  assert.equal(mk.area(crossed), 8);
});
test("text is refused with line and column", () => {
  refused("POLYGON ((0 0, 4 4, 4 O, 0 4, 0 0))", { line: 1, column: 23 });
  refused("POLYGON ((0 0,\n x", { line: 2 });
  refused("", { line: 1 });
  refused("/etc/passwd", { line: 1 });
  refused(new Uint8Array([1, 3, 0, 0, 0, 255, 255, 255, 255]), {});
});
test("what is no operand is refused", () => {
  for (const bad of [{}, { type: "Polygon" }, { type: "Polygon", coordinates: [[]] }, { type: "Circle" },
    { type: "Polygon", coordinates: [[[1]]] }, { type: "FeatureCollection" }]) refused(bad, {});
  for (const bad of [null, undefined, 7, true]) {
    assert.throws(() => mk.minkowskiSum(good, bad), TypeError);
  }
  let deep = good;
  for (let i = 0; i < 40; ++i) deep = { type: "GeometryCollection", geometries: [deep] };
  refused(deep, {});
});
test("offsets that go back or beyond are refused", () => {
  const coords = [0, 0, 1, 0, 0, 1];
  for (const [rings, polygons] of [[[0, 2, 1], [0, 2]], [[0, 4], [0, 1]], [[0, 3], [0, 2]], [[1, 3], [0, 1]],
    [[], []], [[0, NaN], [0, 1]], [[0, 2], [0, 1]], [[0, 1.5, 3], [0, 2]], [[0, 3], undefined]]) {
    refused({ coords, rings, polygons }, {});
  }
  refused({ coords, rings: [0, 3], polygons: [0, 1], lineCoords: [1, 2], lines: [0, 2] }, {});
});
test("options that do not exist are refused", () => {
  assert.throws(() => mk.offset(good, 1, { join: "mitre" }), { code: "bad-input" });
  assert.throws(() => mk.minkowskiSum(good, good, { fill: "odd" }), { code: "bad-input" });
  assert.throws(() => mk.offset(good, NaN), { code: "bad-input" });
  assert.throws(() => mk.erode(good, "POLYGON EMPTY"), { code: "bad-input" });
  assert.throws(() => mk.transform(good, [1, 2]), { code: "bad-input" });
});
test("limits are told", () => {
  assert.throws(() => mk.minkowskiSum(mk.disc(9, 0.001), mk.disc(5, 0.0001), { maxSegments: 5 }), {
    code: "limit", limit: "Limits::max_segments",
  });
  assert.deepEqual(mk.minkowskiSum(good, good).coordinates, [box(0, 0, 2, 2).coordinates[0]]);
});
test("results do not change with later calls", () => {
  const first = mk.minkowskiSum(good, good, { as: "flat" });
  const before = [...first.coords];
  mk.minkowskiSum(mk.disc(9, 0.001), mk.disc(5, 0.0001));
  assert.deepEqual([...first.coords], before);
});
test("what a server sends instead of the module is an error that says what to do", async () => {
  for (const text of ["<!doctype html>", ""]) {
    await assert.rejects(load({ wasm: new Response(text) }), /no module in WebAssembly.*optimizeDeps/);
  }
  await assert.rejects(load({ wasm: new Response("", { status: 404 }) }), /was not loaded: 404/);
});

const square = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))";
const says = (work, words, code = "bad-input") =>
  assert.throws(work, (error) => {
    assert.ok(error instanceof MinksumError, `${error?.stack}`);
    assert.equal(error.code, code, error.message);
    assert.ok(error.message.includes(words), error.message);
    return true;
  });

test("pairs of numbers are two finite numbers", () => {
  for (const bad of [[-1], [], [1, 2, 3], { x: 1, y: 2 }, [1, NaN], ["1", 2], null, "12"]) {
    says(() => mk.timeOfImpact(square, good, bad), "direction");
    says(() => mk.noFitPolygon(square, good, { reference: bad }), "reference");
    says(() => mk.slices(square, good, [0], { reference: bad ?? "none" }), "reference");
  }
  says(() => mk.noFitPolygon(square, good, { reference: new Array(400000).fill(1.5) }), "reference");
  assert.deepEqual(mk.timeOfImpact(square, box(3, 0, 4, 1), [-1, 0]), 2);
});
test("numbers that WebAssembly would change are refused", () => {
  const table = mk.noFitTable([good, good], { turns: 4 });
  for (const part of [2, 2 ** 32, 0.5, -1, "0"]) says(() => table.at(part, 0), "there is no part");
  for (const fixedTurn of [1.9, NaN, 2 ** 32]) says(() => table.at(0, 1, { fixedTurn }), "fixedTurn");
  for (const turns of [4.5, 2 ** 32 + 4, "4"]) says(() => mk.noFitTable([good], { turns }), "turns");
  for (const decimals of [NaN, Infinity, "two", 2.7, 2 ** 32 + 1, -2]) {
    says(() => mk.rounded(good, { decimals }), "decimals");
  }
  for (const most of [-1, NaN, Infinity, 1e7]) says(() => mk.validate(good, { most }), "most");
  for (const maxSegments of [NaN, -1, 0.5, "x"]) {
    says(() => mk.minkowskiSum(good, good, { maxSegments }), "maxSegments");
  }
  for (const distance of [null, [], true, "1", NaN]) says(() => mk.offset(good, distance), "distance");
  for (const list of [[null, null], [[0.5, 0.5]], [0, 0, 5], "00", undefined, { x: 1 }]) {
    says(() => mk.locate(good, list), "points");
    says(() => mk.contact(good, good, list), "points");
  }
  for (const angles of ["45", 5, [null]]) says(() => mk.slices(good, good, angles), "angles");
  says(() => mk.reach(good, good, { x: null, y: 0, degrees: 0 }, { x: 0, y: 0, degrees: 0 }), "`x`");
  says(() => mk.transform(good, ["1", null, [], "0", "1", true]), "map");
  says(() => mk.noFitTable(square), "parts");
});
test("names and values of options that nobody knows are refused", () => {
  for (const [options, words] of [
    [{ fil: "strict" }, "`fil`"], [{ maxsegments: 1 }, "`maxsegments`"], [{ as: "FLAT" }, "`as`"],
    [{ coords: "rational" }, "`coords`"], [{ regularize: "false" }, "`regularize`"], ["wkt", "no object"],
    [null, "no object"], [{ progress: true }, "`progress`"], [{ curveSide: "out" }, "`curveSide`"],
  ]) {
    says(() => mk.minkowskiSum(good, good, options), words);
    says(() => mk.convert(good, options), words);
    says(() => mk.disc(1, 0.1, options), words);
  }
  says(() => mk.slices(good, good, [0], { workspace: "" }), "");
});
test("flat arrays hold numbers or texts, and no ring is empty", () => {
  const flat = (coords, more = {}) => ({ coords, rings: [0, 3], polygons: [0, 1], ...more });
  const exact = (operand) => mk.convert(operand, { as: "wkt", coords: "exact" });
  assert.equal(exact(flat([0, "0.1", 1, 1, 0, 2])), exact(flat(["0", "0.1", "1", "1", "0", "2"])));
  refused(flat([0, null, 1, true, 0, ""]), {});
  refused(flat([0, 0, 1, 0, 0, "0x10"]), {});
  refused(flat([0, 0, 1, 0, 0, 1], { points: [1, 2, 3] }), {});
  refused(flat([0, 0, 1, 0, 0, 1], { points: 7 }), {});
  refused({ coords: [5, 6, 7, 8, 9, 1], rings: [0, 0, 3], polygons: [0, 2] }, {});
  refused({ coords: [5, 6, 7, 8, 9, 1], rings: [0, 3], polygons: [0, 0, 1] }, {});
  refused({ coords: "001001", rings: [0, 3], polygons: [0, 1] }, {});
  refused({ type: "MultiPolygon", coordinates: new Array(3) }, {});
  for (const bad of ["1.5/3", "1e5/3", "1/-3", "1/0"]) {
    refused(ring([1, 1], [2, 1], [2, bad]), { polygon: 0, ring: 1, vertex: 2 });
  }
  const feature = { type: "Feature", geometry: good, properties: {}, coords: "of somebody else" };
  assert.deepEqual(mk.convert(feature), mk.convert(good));
});
test("answers beyond the doubles are errors", () => {
  const far = { type: "Point", coordinates: [1.7e308, 0] };
  says(() => mk.minkowskiSum(far, far), "range of doubles", "limit");
  says(() => mk.area("POLYGON ((0 0, 1e200 0, 1e200 1e200, 0 0))"), "range of doubles", "limit");
  says(() => mk.bounds("POLYGON ((0 0, 1e400 0, 0 1, 0 0))"), "range of doubles", "limit");
  assert.ok(mk.minkowskiSum(far, far, { as: "flat", coords: "exact" }).points[0].length > 300);
});
test("a listener of progress may call the library in each operation", () => {
  const cross = { type: "Polygon", coordinates: [[[0, 0], [4, 4], [4, 0], [0, 4], [0, 0]]] };
  const other = () => mk.minkowskiSum(cross, box(0, 0, 2, 3));
  const ends = [{ x: 0, y: 0, degrees: 0 }, { x: 6, y: 6, degrees: 0 }];
  for (const work of [
    (options) => mk.reach(good, box(3, 3, 4, 4), ...ends, { angles: 8, coords: "exact", ...options }),
    (options) => mk.validate(cross, options),
    (options) => mk.penetrationDepth(good, box(0.5, 0.25, 3, 3), options),
  ]) {
    assert.deepEqual(work({ progress: () => void other() }), work({}));
    assert.deepEqual(work({ progress: () => void mk.area(good, { maxSegments: 100 }) }), work({}));
  }
});
