// The library in a worker gives the same, and can be stopped.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { load, MinksumError } from "minksum/worker";
import { box, mk, random, star } from "./support.js";

const worker = await load();
after(() => worker.close());
const next = random(11);
const [a, b] = [star(next, 30), star(next, 20)];
// This takes minutes.
const long = (signal) => worker.minkowskiSum(star(random(1), 20000, 1e9), star(random(2), 20000, 1e9), { signal });

test("operations give the same as without a worker", async () => {
  assert.deepEqual(await worker.minkowskiSum(a, b), mk.minkowskiSum(a, b));
  assert.deepEqual(await worker.offset(a, 2, { as: "flat" }), mk.offset(a, 2, { as: "flat" }));
  assert.equal(await worker.area(a), mk.area(a));
  const [here, there] = [mk.trace(a, b), await worker.trace(a, b)];
  assert.deepEqual(there.loops, here.loops);
  const methods = Object.getOwnPropertyNames(Object.getPrototypeOf(mk));
  const missing = methods.filter((name) => !(name in worker) &&
    !["constructor", "version", "memoryBytes", "prepare", "made", "contactsOf", "take", "binary",
      "hasThinParts", "withResolved", "withNoFit", "withSpace", "writeOptions", "preparedOf", "geometryOf", "pathOf"].includes(name));
  assert.deepEqual(missing, []);
});
test("errors keep their place", async () => {
  await assert.rejects(worker.minkowskiSum(a, "POLYGON ((0 0, 1 x"), (error) =>
    error instanceof MinksumError && error.operand === 1 && error.line === 1);
  await assert.rejects(worker.area(null), TypeError);
});
test("a signal stops a long sum, and what else was asked is done", async () => {
  const table = await worker.noFitTable([box(0, 0, 2, 1), box(0, 0, 1, 1)]);
  const controller = new AbortController();
  const stopped = long(controller.signal);
  const other = worker.minkowskiSum(a, b);
  const entry = table.at(0, 1);
  setTimeout(() => controller.abort(), 200);
  await assert.rejects(stopped, { name: "AbortError" });
  assert.deepEqual(await other, mk.minkowskiSum(a, b));
  const expected = mk.noFitTable([box(0, 0, 2, 1), box(0, 0, 1, 1)]).at(0, 1);
  assert.deepEqual(await entry, expected);
  assert.deepEqual(await table.at(0, 1), expected);
  await table.dispose();
});
test("a signal that was given before stops at once", async () => {
  await assert.rejects(worker.area(a, { signal: AbortSignal.abort() }), { name: "AbortError" });
});
test("what was asked does not change with its operands", async () => {
  const parts = [box(0, 0, 1, 1), box(0, 0, 2, 2)];
  const flat = { coords: new Float64Array([0, 0, 1, 0, 0, 1]), rings: [0, 3], polygons: [0, 1] };
  const expected = mk.minkowskiSum(...parts);
  const entry = mk.noFitTable(parts).at(0, 1);
  const table = await worker.noFitTable(parts);
  const controller = new AbortController();
  const stopped = assert.rejects(worker.disc(5, 1e-9, { signal: controller.signal }), { name: "AbortError" });
  const asked = [worker.minkowskiSum(...parts), table.at(0, 1), worker.area(flat), table.dispose()];
  parts[1].coordinates[0][1][0] = 500;
  parts[0].coordinates[0][1] = () => 1;
  structuredClone(flat.coords.buffer, { transfer: [flat.coords.buffer] });
  controller.abort();
  await stopped;
  assert.deepEqual(await Promise.all(asked), [expected, entry, 0.5, undefined]);
  await assert.rejects(table.at(0, 1), { code: "bad-input", message: "the table was disposed of" });
});
test("arguments that cannot be sent, and signals that are none, are refused", async () => {
  await assert.rejects(worker.area({ ...box(0, 0, 1, 1), f() {} }), { code: "bad-input" });
  await assert.rejects(worker.area(a, { signal: new AbortController() }), { code: "bad-input" });
});
test("a closed worker is cancelled", async () => {
  const other = await load();
  const pending = other.area(a);
  other.close();
  await assert.rejects(pending, { code: "cancelled" });
  await assert.rejects(other.area(a), { code: "cancelled" });
});
