// The package runs in a browser, bundled by Vite, and its worker can be stopped there.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { createServer as vite } from "vite";
import { mk } from "./support.js";

const browser = process.env.MINKSUM_CHROMIUM ?? "/usr/bin/chromium";
const js = fileURLToPath(new URL("..", import.meta.url));
const types = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm" };

/** Returns a new folder in which the packed package is installed. */
function installed() {
  const folder = mkdtempSync(join(tmpdir(), "minksum-"));
  const tarball = execFileSync("npm", ["pack", "--pack-destination", folder], { cwd: js, encoding: "utf8" }).trim();
  writeFileSync(join(folder, "package.json"), '{"type":"module"}');
  execFileSync("npm", ["install", "--offline", "--no-audit", "--no-fund", join(folder, tarball)], { cwd: folder });
  return folder;
}
/** Serves a folder, and returns its address. */
async function serve(folder, t) {
  const server = createServer((request, response) => {
    const path = join(folder, request.url === "/" ? "index.html" : request.url);
    if (!existsSync(path)) return response.writeHead(404).end();
    response.writeHead(200, { "content-type": types[extname(path)] ?? "text/plain" }).end(readFileSync(path));
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  t.after(() => server.close());
  return `http://127.0.0.1:${server.address().port}/`;
}
/** Opens a page until `done` holds there, and returns what that is. */
async function open(address, done) {
  const chrome = await chromium.launch({ executablePath: browser, args: ["--no-sandbox"] });
  try {
    const page = await chrome.newPage();
    const troubles = [];
    page.on("pageerror", (error) => troubles.push(String(error)));
    page.on("console", (message) => message.type() === "error" && troubles.push(message.text()));
    await page.goto(address);
    await page.waitForFunction(done, undefined, { timeout: 60_000 }).catch((error) => troubles.push(error.message));
    assert.deepEqual(troubles, []);
    return await page.evaluate(done);
  } finally {
    await chrome.close();
  }
}
const whole = { skip: !existsSync(browser) && "Chromium is not there" };
const guide = readFileSync(join(js, "../docs/javascript.md"), "utf8");

test("a bundled page computes, in the page and in a worker", whole, async (t) => {
  const folder = installed();
  writeFileSync(join(folder, "index.html"), '<link rel="icon" href="data:,"><script type="module" src="/main.js"></script>');
  writeFileSync(join(folder, "main.js"), `
    import { load } from "minksum";
    import { load as inline } from "minksum/inline";
    import { load as start } from "minksum/worker";
    const [mk, other, worker] = await Promise.all([load(), inline(), start()]);
    const exact = { as: "wkt", coords: "exact" };
    const stop = new AbortController();
    const long = worker.trace(mk.disc(1e9, 1e-2, exact), "MULTIPOINT (0 0, 1 1, 7 3)", { signal: stop.signal });
    stop.abort();
    const stopped = await long.then(() => "done", (error) => error.name);
    const sums = [mk.offset("POINT (1 2)", 3, exact), other.offset("POINT (1 2)", 3, exact), await worker.offset("POINT (1 2)", 3, exact)];
    window.answer = { sums, stopped };
  `);
  writeFileSync(join(folder, "vite.config.js"), 'export default { build: { target: "es2022" }, worker: { format: "es" } };');
  execFileSync(join(js, "node_modules/.bin/vite"), ["build"], { cwd: folder });
  const { sums, stopped } = await open(await serve(join(folder, "dist"), t), "window.answer");
  const expected = mk.offset("POINT (1 2)", 3, { as: "wkt", coords: "exact" });
  assert.deepEqual(sums, [expected, expected, expected]);
  assert.equal(stopped, "AbortError");
});
const out = "document.querySelector('#out').textContent";
const [, page] = /```html\n([^]*?)```/.exec(guide);
test("the page of javascript.md computes without a bundler", whole, async (t) => {
  const folder = installed();
  writeFileSync(join(folder, "index.html"), page);
  assert.equal(await open(await serve(folder, t), out), "2.5");
});
test("and so it does by Vite's server for development", whole, async (t) => {
  const folder = installed();
  writeFileSync(join(folder, "index.html"), page.replace(/<script type="importmap">[^]*?<\/script>/, ""));
  writeFileSync(join(folder, "vite.config.js"), /export default .*optimizeDeps.*/.exec(guide)[0]);
  const server = await vite({ root: folder, logLevel: "error" });
  t.after(() => server.close());
  await server.listen(0);
  assert.equal(await open(server.resolvedUrls.local[0], out), "2.5");
});
