// Sums of many pairs have the same bytes as those of the native program.
import assert from "node:assert/strict";
import { test } from "node:test";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { mk, random, run, star } from "./support.js";

const pairs = 2000;
const exact = { as: "wkt", coords: "exact" };

test(`${pairs} sums have the bytes that the program writes`, () => {
  const next = random(2026);
  const operands = () => {
    const corners = 3 + Math.floor(next() ** 3 * 120);
    const shape = star(next, corners, next() < 0.5 ? 40 : 10000);
    if (next() < 0.5) return mk.convert(shape, exact);
    // Thirds, so that vertices are no doubles, and several parts.
    return mk.union(
      mk.transform(shape, [0.1, 0, 3, 0, 0.7, 0]),
      mk.convert("POLYGON ((100 100, 301/3 100, 100 302/3, 100 100))", { coords: "exact" }),
      exact,
    );
  };
  const list = Array.from({ length: pairs }, () => [operands(), operands()]);
  const folder = mkdtempSync(join(tmpdir(), "minksum-"));
  const jobs = join(folder, "jobs.jsonl");
  const lines = list.map(([a, b]) => JSON.stringify({ operation: "sum", a: { wkt: a }, b: { wkt: b } }));
  writeFileSync(jobs, lines.join("\n") + "\n");
  const byProgram = (coords) => {
    const out = join(folder, coords);
    run(["batch", jobs, "--coords", coords, "-o", out]);
    const written = readFileSync(out, "utf8").trim().split("\n");
    assert.equal(written.length, pairs);
    return written.map((line) => JSON.parse(line).result.wkt);
  };
  const [exactly, doubles] = [byProgram("exact"), byProgram("double")];
  let vertices = 0;
  list.forEach(([a, b], i) => {
    const sum = mk.minkowskiSum(a, b, exact);
    vertices += sum.split(",").length;
    assert.equal(sum, exactly[i], `pair ${i}`);
    // The program rounds so that results stay valid.
    assert.equal(mk.rounded(sum, { as: "wkt" }), doubles[i], `pair ${i}`);
  });
  assert.ok(vertices > 50 * pairs, `${vertices} vertices`);
});
