// Laws of sums hold for any operands.
import assert from "node:assert/strict";
import { test } from "node:test";
import fc from "fast-check";
import { mk } from "./support.js";

const exact = { as: "wkt", coords: "exact" };
const coordinate = fc.oneof(
  fc.integer({ min: -20, max: 20 }),
  // Sums of the tiniest doubles have a thousand bits: fewer of them are added below.
  fc.double({ min: -100, max: 100, noNaN: true }).map((x) => (Math.abs(x) < 2 ** -99 ? 0 : x)),
  fc.tuple(fc.integer({ min: -99, max: 99 }), fc.integer({ min: 1, max: 9 })).map(([p, q]) => `${p}/${q}`),
);
const position = fc.tuple(coordinate, coordinate);
// Rings may cross themselves and have any number of corners.
const polygon = fc
  .array(position, { minLength: 1, maxLength: 9 })
  .map((ring) => ({ type: "Polygon", coordinates: [[...ring, ring[0]]] }));
const line = fc
  .array(position, { minLength: 2, maxLength: 5 })
  .map((coordinates) => ({ type: "LineString", coordinates }));
const point = position.map((coordinates) => ({ type: "Point", coordinates }));
const operand = fc.oneof({ weight: 4, arbitrary: polygon }, line, point);
const runs = { numRuns: 200, seed: 2026 };

test("a sum does not depend on the order", () => {
  fc.assert(fc.property(operand, operand, (a, b) => {
    assert.equal(mk.minkowskiSum(a, b, exact), mk.minkowskiSum(b, a, exact));
  }), runs);
});
test("nor does one of the largest and the tiniest doubles", () => {
  const double = fc.double({ noNaN: true, noDefaultInfinity: true });
  const triangle = fc
    .array(fc.tuple(double, double), { minLength: 3, maxLength: 3 })
    .map((ring) => ({ type: "Polygon", coordinates: [[...ring, ring[0]]] }));
  fc.assert(fc.property(triangle, triangle, (a, b) => {
    assert.equal(mk.minkowskiSum(a, b, exact), mk.minkowskiSum(b, a, exact));
  }), { ...runs, numRuns: 50 });
});
test("a sum does not depend on parentheses", () => {
  fc.assert(fc.property(polygon, polygon, polygon, (a, b, c) => {
    const [ab, bc] = [mk.minkowskiSum(a, b, exact), mk.minkowskiSum(b, c, exact)];
    assert.equal(mk.minkowskiSum(ab, c, exact), mk.minkowskiSum(a, bc, exact));
  }), { ...runs, numRuns: 100 });
});
test("a point moves a set", () => {
  fc.assert(fc.property(operand, fc.integer({ min: -9, max: 9 }), fc.integer({ min: -9, max: 9 }), (a, x, y) => {
    const moved = mk.transform(mk.resolve(a, { coords: "exact" }), [1, 0, x, 0, 1, y], { coords: "exact" });
    const sum = mk.minkowskiSum(a, { type: "Point", coordinates: [x, y] }, exact);
    assert.equal(sum, mk.resolve(moved, exact));
  }), runs);
});
test("opening lies in the set, and the set in closing", () => {
  const tool = { type: "Polygon", coordinates: [[[0, 0], [1, 0], [0, 1], [0, 0]]] };
  fc.assert(fc.property(polygon, (a) => {
    const outside = (small, large) => mk.area(mk.difference(small, large, { coords: "exact" }));
    assert.equal(outside(mk.opening(a, tool, { coords: "exact" }), a), 0);
    assert.equal(outside(a, mk.closing(a, tool, { coords: "exact" })), 0);
  }), runs);
});
test("exact results are read again as they were", () => {
  fc.assert(fc.property(operand, operand, (a, b) => {
    const text = mk.minkowskiSum(a, b, exact);
    for (const options of [{ coords: "exact" }, { as: "flat", coords: "exact" }]) {
      assert.equal(mk.convert(mk.minkowskiSum(a, b, options), exact), text);
    }
  }), runs);
});
test("the second method proves sums", () => {
  fc.assert(fc.property(polygon, polygon, (a, b) => {
    const { ok, proved } = mk.checkSum(mk.minkowskiSum(a, b, exact), a, b);
    assert.deepEqual([ok, proved], [true, true]);
  }), { ...runs, numRuns: 50 });
});
