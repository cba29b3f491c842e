// Arguments and options are refused by name unless they are what they must be.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load, MinksumError } from "minksum";
import { load as inline } from "minksum/inline";
import { load as inWorker } from "minksum/worker";
import { box, mk } from "./support.js";

const a = box(0, 0, 1, 1);
const b = box(10, 0, 11, 1);
const huge = { type: "Point", coordinates: [1.7e308, 0] };
const refused = (work, words, code = "bad-input") =>
  assert.throws(work, (error) => {
    assert.ok(error instanceof MinksumError, String(error));
    assert.equal(error.code, code, error.message);
    assert.match(error.message, words);
    return true;
  }, `${work}`);

test("a direction and a reference point are two numbers", () => {
  const long = new Float64Array(400_000).fill(1);
  for (const bad of [[], [-1], [-1, 0, 7], {}, { x: -1, y: 0 }, "11", ["-1", 0], [null, 0], [NaN, 0], [1n, 0n], 3, null, long]) {
    refused(() => mk.timeOfImpact(a, b, bad), /`direction/);
    refused(() => mk.noFitPolygon(a, b, { reference: bad }), /`reference/);
    refused(() => mk.contact(a, b, [0, 0], { reference: bad }), /`reference/);
    refused(() => mk.slices(a, b, [0], { reference: bad }), /`reference/);
  }
  refused(() => mk.timeOfImpact(a, b), /`direction`/);
  assert.equal(mk.timeOfImpact(a, b, Float32Array.of(-1, 0)), 9);
});
test("points and other lists are numbers", () => {
  for (const bad of [undefined, "00", 5, [0], [0, 0, 5], [null, null], ["0", "0"], [[0, 0]], [[0], [0]], [1n, 2n], [, 0], [0, Infinity]]) {
    refused(() => mk.contact(a, b, bad), /`points/);
    refused(() => mk.locate(a, bad), /`points/);
  }
  for (const bad of ["45", 5, [null], undefined, ["45"]]) refused(() => mk.slices(a, b, bad), /`angles/);
  for (const bad of [["1", 0, 0, 0, 1, 0], [1, null, 0, 0, 1, 0], [1], undefined]) refused(() => mk.transform(a, bad), /`m/);
});
test("numbers are neither made from other things nor cut", () => {
  for (const bad of [null, undefined, [], true, "1", 1n, NaN, Infinity, {}]) {
    refused(() => mk.offset(a, bad), /`distance`/);
    refused(() => mk.disc(bad, 1), /`radius`/);
    refused(() => mk.disc(1, bad), /`tolerance`/);
    refused(() => mk.reach(a, b, { x: bad, y: 0, degrees: 0 }, { x: 1, y: 1, degrees: 0 }), /`from.x`/);
    refused(() => mk.reach(a, b, { x: 1, y: 0, degrees: 0 }, { x: 1, y: 1, degrees: bad }), /`to.degrees`/);
  }
  refused(() => mk.reach(a, b), /`from.x`/);
  const integers = {
    most: [-1, 1.5, NaN, Infinity, "2", 2 ** 32, null], decimals: [-1, -2, 2.7, NaN, Infinity, "two", 2 ** 32 + 1],
    maxSegments: [0, -1, 0.5, NaN, "x", 1n, 2 ** 64], maxCrossings: [0, -1, NaN], angles: [0, 4.5, 2 ** 32 + 4, "4"],
    turns: [0, 4.5, "4", 2 ** 32 + 4], fixedTurn: [-1, 1.9, NaN, 4, 2 ** 32], movingTurn: ["1"],
  };
  for (const [name, values] of Object.entries(integers)) {
    for (const bad of values) refused(() => mk.validate(a, { [name]: bad }), new RegExp(`\`${name}\` is .* no integer from`));
  }
  const table = mk.noFitTable([a, b], { turns: 2 });
  for (const bad of [2, -1, 2 ** 32, 0.5, "0", null]) {
    refused(() => table.at(bad, 0), /`fixed`/);
    refused(() => table.contact(0, bad, [0, 0]), /`moving`/);
  }
  refused(() => table.at(0, 1, { fixedTurn: 3 }), /turn/);
  for (const bad of [undefined, "POINT (1 2)", a]) refused(() => mk.noFitTable(bad), /`parts`/);
});
test("options have names and values that exist", () => {
  for (const bad of [null, "wkt", 7, true, []]) {
    for (const work of [(o) => mk.area(a, o), (o) => mk.toSvg(a, o), (o) => mk.disc(5, 1, o), (o) => mk.validate(a, o),
      (o) => mk.noFitTable([a], o), (o) => mk.prepare(a, o), (o) => mk.slices(a, b, [0], o)]) refused(() => work(bad), /`options`/);
  }
  refused(() => mk.minkowskiSum(a, b, { fil: "strict" }), /no option `fil`/);
  refused(() => mk.minkowskiSum(a, b, { signal: AbortSignal.abort() }), /no option `signal`/);
  const values = {
    as: ["FLAT", null], coords: ["rational"], curveSide: ["out", "constructor"], z: ["Drop"], fill: [1n, Symbol("x"), null],
    regularize: ["false", 1], tight: ["no"], free: [1], certain: ["true"], progress: [true, "x"], join: ["mitre"],
    curveTolerance: ["1", NaN], joinEnds: [NaN], miterLimit: [NaN], tolerance: [NaN, null], within: [NaN, "1"],
  };
  for (const [name, list] of Object.entries(values)) {
    for (const bad of list) refused(() => mk.minkowskiSum(a, b, { [name]: bad }), new RegExp(`\`${name}\``));
  }
  refused(() => mk.slices(a, b, [0], { workspace: "" }), /empty/);
  assert.equal(mk.area(a, { fill: undefined, as: undefined }), 1);
});
test("options of loading have names that exist", async () => {
  for (const start of [load, inline, inWorker]) {
    await assert.rejects(start({ wasm_: "x" }), { code: "bad-input", message: "there is no option `wasm_`" });
    await assert.rejects(start(null), { code: "bad-input" });
  }
  await assert.rejects(load({ worker: () => undefined }), /no option `worker`/);
  assert.equal((await load({ wasm: undefined, other: undefined })).version, mk.version);
});
test("flat arrays have names that exist", () => {
  const flat = { coords: [0, 0, 4, 0, 0, 4], rings: [0, 3], polygons: [0, 1] };
  for (const name of ["lineCords", "hasOwnProperty", "point"]) {
    refused(() => mk.area({ ...flat, [name]: [1, 1] }), new RegExp(`no flat array \`${name}\``));
  }
  assert.throws(() => mk.minkowskiSum(a, { ...flat, lineCords: [] }), { operand: 1 });
  assert.equal(mk.area({ ...flat, lineCords: undefined }), 8);
  assert.equal(mk.area(mk.resolve(flat, { as: "flat" })), 8);
});
test("numbers beyond the doubles are refused, and exact ones are not", () => {
  const words = /beyond the range of doubles/;
  const tall = "POLYGON ((0 0, 1e400 0, 0 1, 0 0))";
  for (const as of ["geojson", "flat", "wkt"]) refused(() => mk.minkowskiSum(huge, huge, { as }), words, "limit");
  refused(() => mk.area("POLYGON ((0 0, 1e200 0, 1e200 1e200, 0 0))"), words, "limit");
  refused(() => mk.bounds(tall), words, "limit");
  refused(() => mk.penetrationDepth("POINT (-1e400 0)", tall), words, "limit");
  refused(() => mk.trace(tall, tall), words, "limit");
  const { points } = mk.minkowskiSum(huge, huge, { as: "flat", coords: "exact" });
  assert.equal(BigInt(points[0]), 2n * BigInt(1.7e308));
});
test("another module in WebAssembly is refused", async () => {
  const other = new WebAssembly.Module(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0));
  await assert.rejects(load({ wasm: other }), { code: "bad-input" });
});
test("what is refused leaves no memory behind", () => {
  const disc = mk.disc(5, 0.001);
  const round = () => refused(() => mk.contact(disc, a), /points/);
  for (let i = 0; i < 100; ++i) round();
  const before = mk.memoryBytes;
  for (let i = 0; i < 2000; ++i) round();
  assert.equal(mk.memoryBytes, before);
});
