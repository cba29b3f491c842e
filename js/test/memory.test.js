// Nobody frees anything, and nothing is lost.
import assert from "node:assert/strict";
import { test } from "node:test";
import { box, mk, random, star } from "./support.js";

test("100,000 sums leave memory as large as it was", () => {
  const next = random(5);
  const shapes = Array.from({ length: 20 }, () => star(next, 12));
  const flats = shapes.map((shape) => mk.convert(shape, { as: "flat" }));
  const round = (i) => {
    mk.minkowskiSum(flats[i % 20], flats[(7 * i + 3) % 20], { as: "flat" });
    if (i % 100 === 0) mk.minkowskiSum(shapes[0], "POLYGON ((0 0, 1/3 0, 0 1, 0 0))", { coords: "exact" });
    if (i % 50 === 0) assert.throws(() => mk.minkowskiSum(shapes[0], "POLYGON ((0 0, x"));
    if (i % 50 === 25) assert.throws(() => mk.erode(shapes[0], "POLYGON EMPTY"));
  };
  for (let i = 0; i < 5000; ++i) round(i);
  const before = mk.memoryBytes;
  for (let i = 0; i < 100_000; ++i) round(i);
  assert.equal(mk.memoryBytes, before);
});
test("tables and prepared operands give memory back", () => {
  const part = box(0, 0, 3, 2);
  const round = () => {
    const [table, prepared] = [mk.noFitTable([part, part]), mk.prepare(part)];
    table.at(0, 1);
    mk.trace(part, part);
    table.dispose();
    prepared.dispose();
  };
  for (let i = 0; i < 200; ++i) round();
  const before = mk.memoryBytes;
  for (let i = 0; i < 3000; ++i) round();
  assert.equal(mk.memoryBytes, before);
});
