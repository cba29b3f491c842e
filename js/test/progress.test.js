// Progress is told, and a listener can stop an operation.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "minksum/worker";
import { box, mk, random, star } from "./support.js";

const next = random(11);
const [a, b] = [star(next, 300, 1e6), star(next, 300, 1e6)];

test("an operation tells its stages", () => {
  const told = [];
  const sum = mk.minkowskiSum(a, b, { progress: (p) => void told.push(p) });
  assert.deepEqual(sum, mk.minkowskiSum(a, b));
  const names = new Set(told.map((p) => p.stage));
  for (const name of ["operands", "convolution", "arrangement", "loops", "output"]) assert.ok(names.has(name), name);
  assert.ok(told.every(({ done, parts }) => done >= 0 && done <= parts));
});
test("slices and tables tell how many parts are done", () => {
  const counts = (work) => {
    const told = [];
    work({ progress: (p) => void told.push(p) });
    const done = told.map((p) => p.done);
    assert.deepEqual(done, [...done].sort((x, y) => x - y));
    return [told.at(-1).parts, told.at(-1).done];
  };
  assert.deepEqual(counts((options) => mk.slices(a, b, [0, 30, 60], options)), [3, 2]);
  const parts = [a, b, box(0, 0, 1, 1)];
  assert.deepEqual(counts((options) => mk.noFitTable(parts, options).dispose()), [3, 2]);
});
test("false stops an operation, and an error of the listener is thrown", () => {
  assert.throws(() => mk.minkowskiSum(a, b, { progress: () => false }), { code: "cancelled" });
  const own = new Error("mine");
  const fail = () => {
    throw own;
  };
  assert.throws(() => mk.minkowskiSum(a, b, { progress: fail }), (error) => error === own);
  assert.equal(mk.area(mk.minkowskiSum(box(0, 0, 1, 1), box(0, 0, 1, 1))), 4);
});
test("a listener may call the library", () => {
  let calls = 0;
  const progress = () => {
    ++calls;
    assert.equal(mk.area(mk.minkowskiSum(box(0, 0, 1, 1), box(0, 0, 1, 1))), 4);
  };
  assert.deepEqual(mk.minkowskiSum(a, b, { progress }), mk.minkowskiSum(a, b));
  assert.ok(calls > 3);
});
test("what a listener calls does not change what goes on", () => {
  const [robot, wall] = [box(0, 0, 1, 1), box(3, 3, 4, 4)];
  const [from, to] = [{ x: 0, y: 0, degrees: 0 }, { x: 6, y: 6, degrees: 0 }];
  const crossed = "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))";
  const works = [
    (options) => mk.reach(robot, wall, from, to, { angles: 8, coords: "exact", ...options }),
    (options) => mk.validate(crossed, options),
    (options) => mk.penetrationDepth(robot, box(0.5, 0.25, 3, 3), options),
    (options) => mk.checkSum(robot, robot, robot, options),
  ];
  for (const work of works) {
    const inner = () => void mk.area(mk.minkowskiSum(crossed, wall), { fill: "evenodd", maxSegments: 1e6 });
    assert.deepEqual(work({ progress: inner }), work({}));
  }
});
test("a listener cannot dispose of what the operation may use", () => {
  const [first, second] = [mk.prepare(box(0, 0, 1, 1)), mk.prepare(box(0, 0, 2, 2))];
  const progress = () => first.dispose();
  assert.throws(() => mk.minkowskiSum(first, second, { progress }), { code: "bad-input" });
  assert.equal(mk.area(mk.minkowskiSum(first, second)), 9);
  first.dispose();
});
test("a worker tells progress, and can be stopped by it", async () => {
  const worker = await load();
  const told = [];
  const sum = await worker.minkowskiSum(a, b, { progress: (p) => void told.push(p.stage) });
  assert.deepEqual(sum, mk.minkowskiSum(a, b));
  assert.ok(told.includes("arrangement"));
  await assert.rejects(worker.minkowskiSum(a, b, { progress: () => false }), { code: "cancelled" });
  const own = new Error("mine");
  const fail = () => {
    throw own;
  };
  await assert.rejects(worker.minkowskiSum(a, b, { progress: fail }), (error) => error === own);
  assert.equal(await worker.area(box(0, 0, 2, 2)), 4);
  worker.close();
});
