// The package stays small, whole, and of one version.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { load } from "minksum/inline";
import { mk } from "./support.js";

const file = (name) => readFileSync(new URL(`../${name}`, import.meta.url));

test("the module takes at most 1.5 MB, and 500 kB compressed", () => {
  const wasm = file("dist/minksum.wasm");
  const compressed = gzipSync(wasm, { level: 9 }).length;
  console.log(`minksum.wasm: ${wasm.length} bytes, ${compressed} compressed`);
  assert.ok(wasm.length <= 1_500_000, `${wasm.length}`);
  assert.ok(compressed <= 500_000, `${compressed}`);
});
test("the scripts take at most 25 kB compressed", () => {
  const scripts = readdirSync(new URL("../dist", import.meta.url)).filter((name) => name.endsWith(".js") && !name.includes("base64"));
  const total = scripts.reduce((sum, name) => sum + gzipSync(file(`dist/${name}`)).length, 0);
  console.log(`scripts: ${total} bytes compressed`);
  assert.ok(total <= 25_000, `${total}`);
});
test("package and library have one version, and there is no dependency", () => {
  const { version, dependencies } = JSON.parse(file("package.json"));
  assert.equal(mk.version, version);
  assert.equal(dependencies, undefined);
});
test("the inline form is the same library", async () => {
  const other = await load();
  assert.deepEqual(other.offset("POINT (1 2)", 3), mk.offset("POINT (1 2)", 3));
});
