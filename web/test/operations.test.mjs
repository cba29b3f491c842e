// Every operation gives what the program gives, and the programs that the page shows do as well.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { after, before, test } from "node:test";
import { promisify } from "node:util";
import { chooseExample, open, settled, start } from "./browser.mjs";

const run = promisify(execFile);
const root = resolve(new URL(".", import.meta.url).pathname, "../..");
const program = resolve(process.env.MINKSUM_PROGRAM ?? join(root, "build/minksum"));
const packaged = resolve(process.env.MINKSUM_PACKAGE ?? join(root, "js/dist"));
let browser, page, noted, folder;

before(async () => {
  browser = await start();
  ({ page, noted } = await open(browser.context));
  folder = await mkdtemp(join(tmpdir(), "minksum-snippets-"));
});
after(async () => {
  await browser.close();
  await rm(folder, { recursive: true, force: true });
});

/** The program that the page shows, in a language. */
async function snippet(language) {
  await page.evaluate(() => (document.getElementById("code-box").open = true));
  await page.click(`#languages button:text-is("${language}")`);
  return page.textContent("#code");
}
async function shell(text) {
  const env = { ...process.env, PATH: `${dirname(program)}:${process.env.PATH}` };
  return (await run("bash", ["-euc", text], { cwd: folder, env, maxBuffer: 1 << 28 })).stdout;
}
async function javascript(text) {
  const file = join(folder, "snippet.mjs");
  await writeFile(
    file,
    text.replace('from "minksum"', `from ${JSON.stringify(join(packaged, "index.js"))}`),
  );
  return (await run("node", [file], { maxBuffer: 1 << 28 })).stdout;
}
const fact = (name) =>
  page.evaluate(
    (wanted) =>
      [...document.querySelectorAll("#facts dt")].find((dt) => dt.textContent === wanted)
        ?.nextElementSibling.textContent,
    name,
  );
async function choose(example, op) {
  await chooseExample(page, example);
  await page.click(`[data-op=${op}]`);
  await settled(page);
}

const named = ["sum", "erode", "open", "close", "nofit", "offset"];
for (const example of ["Room and robot", "A plate with a slit", "Bracket and peg"]) {
  for (const op of named) {
    test(`${op} of “${example}” equals the program's exact text`, async () => {
      await choose(example, op);
      const shown = await page.inputValue("#exact");
      assert.match(shown, /^(POLYGON|MULTI|GEOMETRY|LINE|POINT)/);
      assert.equal(shown, (await shell(await snippet("Shell"))).trim());
      assert.equal(shown, (await javascript(await snippet("JavaScript"))).trim());
    });
  }
}
test("the sum of two birds, and of polylines, equals the program's", async () => {
  for (const example of ["Bird and bird", "A polyline and a brush"]) {
    await choose(example, "sum");
    const shown = await page.inputValue("#exact");
    assert.ok(shown.length > 200);
    assert.equal(shown, (await shell(await snippet("Shell"))).trim());
  }
});
test("each fill rule gives what the program gives", async () => {
  await choose("Room and robot", "sum");
  await page.fill("#text-a", "POLYGON ((0 0, 6 0, 6 6, 2 6, 2 2, 8 2, 8 8, 0 8, 0 0))");
  await settled(page);
  for (const rule of ["automatic", "evenodd", "nonzero", "positive", "negative"]) {
    await page.selectOption("[data-name=fill]", rule);
    await settled(page);
    const shown = await page.inputValue("#exact");
    assert.equal(shown, (await shell(`${await snippet("Shell")}`)).trim(), rule);
  }
});
test("a robot at an angle is in the program's slice", async () => {
  await choose("A sofa in a hall", "robot");
  await page.locator("#fields input[type=range]").first().fill("30");
  await settled(page);
  const shown = await page.inputValue("#exact");
  const { features } = JSON.parse(await shell(await snippet("Shell")));
  const { load } = await import(join(packaged, "index.js"));
  const mk = await load();
  assert.equal(shown, mk.convert(features[0].geometry, { as: "wkt", coords: "exact" }));
});
test("stacked slices are as many as the program's, with as many vertices", async () => {
  await choose("A sofa in a hall", "slices");
  const { features } = JSON.parse(await shell(await snippet("Shell")));
  const rings = ({ type, coordinates }) => (type === "Polygon" ? coordinates : coordinates.flat());
  const vertices = features
    .flatMap((f) => rings(f.geometry))
    .reduce((sum, ring) => sum + ring.length - 1, 0);
  assert.equal(await fact("Slices"), String(features.length));
  assert.equal(await fact("Their vertices"), vertices.toLocaleString("en"));
});
test("a path is found where the program finds one", async () => {
  await choose("A sofa in a hall", "path");
  const [verdict, ...places] = (await shell(await snippet("Shell"))).trim().split("\n");
  assert.equal(verdict, "yes");
  assert.equal(await fact("Path"), `${places.length} places`);
});
test("a robot stays between limits as it does in the program", async () => {
  const limits = async (values) => {
    for (const [side, value] of Object.entries(values)) {
      await page.fill(`[data-name="workspace.${side}"]`, String(value));
    }
    await settled(page);
  };
  await choose("A sofa in a hall", "robot");
  const free = await page.inputValue("#exact");
  await page.check("[data-name=workspace]");
  await limits({ left: 0, bottom: 0, right: 20.5, top: 12 });
  const shown = await page.inputValue("#exact");
  assert.notEqual(shown, free);
  const { load } = await import(join(packaged, "index.js"));
  const mk = await load();
  for (const fill of ["automatic", "nonzero", "negative"]) {
    await page.selectOption("[data-name=fill]", fill);
    await settled(page);
    if ((await page.inputValue("#exact")) === "") continue; // the robot has no area by this rule
    // As text, because a corner of the frame has more digits than a number of JavaScript.
    const told = mk.convert(await shell(await snippet("Shell")), { as: "wkt", coords: "exact" });
    assert.equal(await page.inputValue("#exact"), told, fill);
    assert.equal((await javascript(await snippet("JavaScript"))).trim(), told, fill);
  }
  await page.selectOption("[data-name=fill]", "automatic");
  await page.click("[data-op=slices]");
  await settled(page);
  const { features } = JSON.parse(await shell(await snippet("Shell")));
  const rings = ({ type, coordinates }) => (type === "Polygon" ? coordinates : coordinates.flat());
  const count = features.flatMap((f) => rings(f.geometry)).reduce((n, r) => n + r.length - 1, 0);
  assert.equal(await fact("Their vertices"), count.toLocaleString("en"));
  await page.click("[data-op=path]");
  await settled(page);
  assert.match(await fact("Path"), /places$/);
  await limits({ right: 9 });
  assert.match(await page.textContent("#message"), /the robot leaves the workspace at the goal/);
  await limits({ right: 0 });
  assert.match(await page.textContent("#message"), /^Limits: /);
  await page.uncheck("[data-name=workspace]");
  await settled(page);
  assert.match(await fact("Path"), /places$/);
});
test("the depth vector is the program's", async () => {
  await choose("Two parts that overlap", "depth");
  const told = await shell(
    (await snippet("Shell")).replace("minksum depth", "minksum depth --json"),
  );
  const shown = (await fact("Shortest move")).match(/-?[\d/]+/g);
  for (const number of shown) assert.ok(told.includes(number), `${number} in ${told}`);
  const printed = await javascript(await snippet("JavaScript"));
  for (const number of shown) assert.ok(printed.includes(number));
});
/** Runs a program in Python, or says why it is only read. */
const python = resolve(process.env.MINKSUM_PYTHON ?? "/usr/bin/python3");
const hasPackage = await run(python, ["-c", "import minksum"]).then(
  () => true,
  () => console.log(`${python} has no minksum: programs in Python are read, not run`),
);
test("the programs in Python give what the page shows, or can be read", async () => {
  for (const op of ["sum", "erode", "open", "close", "offset", "nofit", "depth", "robot", "path"]) {
    await choose(op === "path" ? "A sofa in a hall" : "Room and robot", op);
    if (["robot", "path"].includes(op)) {
      await page.check("[data-name=workspace]");
      await settled(page);
    }
    const file = join(folder, "snippet.py");
    await writeFile(file, await snippet("Python"));
    if (!hasPackage) {
      await run(python, ["-c", "import ast, sys; ast.parse(open(sys.argv[1]).read())", file]);
      continue;
    }
    const { stdout } = await run(python, [file]);
    const shown = await page.inputValue("#exact");
    if (["depth", "path"].includes(op)) assert.notEqual(stdout, "");
    else assert.equal(stdout.trim(), shown, op);
  }
});
test("the programs in C++ compile", async () => {
  const robots = ["robot", "slices", "path"];
  const limited = robots.map((op) => [op, true]);
  for (const [op, limits] of ["sum", "offset", "nofit", "depth", ...robots].map((o) => [o]).concat(limited)) {
    await choose("Room and robot", op);
    if (limits) await page.check("[data-name=workspace]");
    const cpp = join(folder, "snippet.cpp");
    await writeFile(cpp, await snippet("C++"));
    await run("c++", ["-std=c++20", "-fsyntax-only", `-I${join(root, "include")}`, cpp]);
  }
});
test("nothing was complained of, and nothing was asked for but the folder's files", () => {
  assert.deepEqual(noted.errors, []);
  assert.deepEqual(
    noted.requests.filter((url) => !/^(file:|blob:|data:)/.test(url)),
    [],
  );
});
