// The packed package is installed into an empty folder and used there: by Node.js, by a bundler, by
// the checkers of packages. No registry is asked.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const js = fileURLToPath(new URL("..", import.meta.url));
const folder = mkdtempSync(join(tmpdir(), "minksum-"));
const run = (command, args, cwd = folder) => execFileSync(command, args, { cwd, encoding: "utf8", stdio: "pipe" });
const bin = (name) => join(js, "node_modules", ".bin", name);

const [packed] = JSON.parse(run("npm", ["pack", "--json", "--pack-destination", folder], js));
const tarball = join(folder, packed.filename);
writeFileSync(join(folder, "package.json"), '{"type":"module"}');
run("npm", ["install", "--offline", "--no-audit", "--no-fund", tarball]);

test("the package holds what it should, and nothing else", () => {
  const names = packed.files.map(({ path }) => path);
  for (const name of ["LICENSE", "README.md", "package.json", "dist/minksum.wasm"]) assert.ok(names.includes(name), name);
  const others = names.filter((name) => !/^(dist\/[\w-]+\.(js|d\.ts|wasm)|LICENSE|README\.md|package\.json)$/.test(name));
  assert.deepEqual(others, []);
});
const runPrograms = (file) => {
  const page = readFileSync(join(js, file), "utf8");
  return [...page.matchAll(/```js\n([^]*?)```/g)].map(([, program], i) => {
    writeFileSync(join(folder, `program${i}.mjs`), program);
    return run("node", [`program${i}.mjs`]);
  });
};
test("the programs of javascript.md run as they stand", () => {
  const outputs = runPrograms("../docs/javascript.md");
  const [, shown] = /```text\n([^]*?)```/.exec(readFileSync(join(js, "../docs/javascript.md"), "utf8"));
  assert.equal(outputs.length, 2);
  assert.equal(outputs[0], shown);
  assert.match(outputs[1], /^\d+ \d+ \d+\n(accepted|rejected)/);
});
test("the programs of its page run as they stand", () => {
  const outputs = runPrograms("README.md");
  assert.equal(outputs[0].split("\n")[1],
    "POLYGON ((0 0, 91/10 0, 28/3 1, 28/3 10, 1/3 10, 0 9, 0 0), (10/3 4, 10/3 6, 6 6, 6 4, 10/3 4))");
  assert.equal(outputs[1], "Polygon true\n");
  assert.equal(outputs[2], "true\n");
});
test("TypeScript knows the types of results", () => {
  writeFileSync(join(folder, "types.ts"), `
    import { load, type ExactFlatResult, type Geometry, type FlatResult, MinksumError, type Options } from "minksum";
    import { load as start } from "minksum/worker";
    const mk = await load();
    const sum: Geometry = mk.minkowskiSum("POINT (0 0)", { type: "Point", coordinates: [1, "1/3"] });
    const flat: FlatResult = mk.offset(sum, 1, { as: "flat", join: "miter" });
    const text: string = mk.convert(flat, { as: "wkt" });
    // @ts-expect-error: there is no such join
    mk.offset(text, 1, { join: "mitre" });
    const factor: string | null = mk.timeOfImpact(text, text, [1, 0], { coords: "exact", progress: () => false });
    const later: FlatResult = await (await start()).minkowskiSum(text, text, { as: "flat" });
    // What @types/geojson has, and flat arrays with texts.
    type Box = [number, number, number, number];
    interface Area { type: "Polygon"; coordinates: number[][][]; bbox?: Box | undefined }
    interface Feature { type: "Feature"; geometry: Area; properties: { [name: string]: any } | null; id?: string | number | undefined }
    declare const features: Feature[];
    mk.area({ type: "FeatureCollection", features, bbox: [0, 0, 1, 1] });
    mk.area(features[0]!) + mk.area({ coords: [0, "1/3", 1, 1, 0, 2], rings: [0, 3], polygons: [0, 1] });
    declare const any: Options;
    const form: string | Geometry | FlatResult | ExactFlatResult = mk.convert(text, any);
    const impact: string | number | null = mk.timeOfImpact(text, text, [1, 0], any);
    // @ts-expect-error: it may be text
    const geometry: Geometry = mk.convert(text, any);
    export default [later, factor, MinksumError, form, impact, geometry];
  `);
  run(bin("tsc"), ["--noEmit", "--strict", "--target", "es2022", "--module", "nodenext", "--lib", "es2022,dom", "types.ts"]);
});
test("Vite bundles it, the module in WebAssembly and the worker", () => {
  writeFileSync(join(folder, "index.html"), '<script type="module" src="/main.js"></script>');
  writeFileSync(join(folder, "main.js"), `
    import { load } from "minksum";
    import { load as start } from "minksum/worker";
    document.title = (await load()).version + (await (await start()).area("POINT (0 0)"));
  `);
  writeFileSync(join(folder, "vite.config.js"), 'export default { build: { target: "es2022" }, worker: { format: "es" } };');
  run(bin("vite"), ["build"]);
  const assets = readdirSync(join(folder, "dist", "assets"));
  assert.ok(assets.some((name) => /^minksum-.*\.wasm$/.test(name)), String(assets));
  assert.ok(assets.some((name) => /^worker-main-.*\.js$/.test(name)), String(assets));
});
test("publint and attw find no fault", () => {
  assert.match(run(bin("publint"), ["--strict", tarball], js), /All good/);
  run(bin("attw"), [tarball, "--profile", "esm-only", "--exclude-entrypoints", "minksum.wasm"], js);
});
