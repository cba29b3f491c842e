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
    refused(ring([1, 1], [2, 1], [2, bad], [1, 1]), { polygon: 0, ring: 1, vertex: 2 });
  }
  for (const bad of ["1e5/3", "1.5/3", "1/-3", "1e5000", 1n, Symbol("x")]) {
    refused({ type: "LineString", coordinates: [[0, 0], [bad, 1]] }, { vertex: 1, line: undefined });
    refused({ type: "MultiPoint", coordinates: [[0, 0], [bad, 1]] }, { vertex: 1, line: undefined });
  }
  refused({ coords: [0, 0, 1, 0, NaN, 1], rings: [0, 3], polygons: [0, 1] }, { polygon: 0, ring: 0, vertex: 2 });
});
test("heights are refused unless they are dropped", () => {
  refused(ring([1, 1], [2, 1, 7], [2, 2], [1, 1]), { polygon: 0, ring: 1, vertex: 1 });
  const dropped = mk.minkowskiSum(good, ring([1, 1], [2, 1, 7], [2, 2], [1, 1]), { z: "drop" });
  assert.deepEqual(dropped, mk.minkowskiSum(good, ring([1, 1], [2, 1], [2, 2], [1, 1])));
  refused("POINT Z (1 2 3)", { line: 1 });
  assert.deepEqual(mk.convert("POINT Z (1 2 3)", { z: "drop" }).coordinates, [1, 2]);
});
test("rings that are not closed are refused, as in text", () => {
  const message = "polygon 1, ring 2 is not closed: its last point must repeat the first";
  for (const last of [[2, 2], ["2", 2], ["1/3", "1/2"]]) {
    const operand = ring([1, 1], [2, 1], last);
    refused(operand, { polygon: 0, ring: 1, message });
    assert.throws(() => mk.area(JSON.stringify(operand)), { code: "bad-input" });
  }
  const closed = (first, last) => ({ type: "Polygon", coordinates: [[[first, 0], [3, 0], [3, 9], [last, "0.0"]]] });
  for (const [first, last] of [["0.5", "1/2"], [0.5, "5e-1"], ["-0", 0], ["3e2", "300"], ["-1/2", -0.5]]) {
    assert.equal(mk.validate(closed(first, last)).length, 0);
  }
  refused(closed("1/3", 1 / 3), { polygon: 0, ring: 0 });
});
test("what is missing in an array is refused", () => {
  const holey = new Array(3);
  holey[0] = good.coordinates;
  for (const text of [0, "0"]) {
    const sparse = [[text, 0], [1, 0], , [0, 1], [text, 0]];
    refused({ type: "Polygon", coordinates: [sparse] }, { polygon: 0, ring: 0, vertex: 2 });
    refused({ type: "LineString", coordinates: sparse }, { vertex: 2 });
  }
  refused({ type: "MultiPolygon", coordinates: holey }, {});
  refused({ type: "GeometryCollection", geometries: [, good] }, {});
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
test("flat arrays have no empty parts", () => {
  const coords = [5, 6, 7, 8, 9, 1];
  refused({ coords, rings: [0, 0, 3], polygons: [0, 2] }, { polygon: 0, ring: 0 });
  refused({ coords: coords.map(String), rings: [0, 3, 3], polygons: [0, 1, 2] }, { polygon: 1, ring: 0 });
  refused({ coords, rings: [0, 3], polygons: [0, 0, 1] }, { polygon: 0 });
  refused({ coords: [], rings: [0], polygons: [0], lineCoords: [], lines: [0, 0] }, {});
});
test("flat arrays have numbers and texts of numbers only", () => {
  const flat = (...coords) => ({ coords, rings: [0, 3], polygons: [0, 1] });
  const exact = { as: "flat", coords: "exact" };
  assert.deepEqual(mk.convert(flat(0, "0.1", 1, 1, 0, 2), exact).coords, ["0", "1/10", "1", "1", "0", "2"]);
  for (const bad of [null, undefined, true, "", [], 1n, "0x1", NaN]) {
    refused(flat(0, 0, 1, bad, 0, 2), { polygon: 0, ring: 0, vertex: 1 });
    refused(flat("0", 0, 1, bad, 0, 2), { polygon: 0, ring: 0, vertex: 1 });
  }
  refused({ ...flat(), coords: BigInt64Array.of(0n, 0n, 1n, 0n, 1n, 1n) }, { polygon: 0, ring: 0, vertex: 0 });
  const triangle = flat(0, 0, 1, 0, 0, 1);
  for (const points of [7, {}, "00", [1], [1, null], null]) refused({ ...triangle, points }, {});
  for (const name of ["coords", "rings", "polygons"]) refused({ ...triangle, [name]: null }, {});
});
test("polylines of one point are refused, and a point's coordinates are an array", () => {
  for (const x of [0, "0"]) refused({ type: "LineString", coordinates: [[x, 0]] }, { line: undefined });
  refused({ type: "Point", coordinates: "" }, {});
  assert.deepEqual(mk.convert({ type: "Point", coordinates: [] }), { type: "Polygon", coordinates: [] });
});
test("objects of GeoJSON may have members that flat arrays have", () => {
  const feature = { type: "Feature", geometry: good, properties: null, coords: "WGS84" };
  assert.equal(mk.area(feature), 1);
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
