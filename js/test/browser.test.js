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
import { mk } from "./support.js";

const browser = process.env.MINKSUM_CHROMIUM ?? "/usr/bin/chromium";
const js = fileURLToPath(new URL("..", import.meta.url));
const types = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm" };

test("a bundled page computes, in the page and in a worker", { skip: !existsSync(browser) && "Chromium is not there" }, async () => {
  const folder = mkdtempSync(join(tmpdir(), "minksum-"));
  const tarball = execFileSync("npm", ["pack", "--pack-destination", folder], { cwd: js, encoding: "utf8" }).trim();
  writeFileSync(join(folder, "package.json"), '{"type":"module"}');
  execFileSync("npm", ["install", "--offline", "--no-audit", "--no-fund", join(folder, tarball)], { cwd: folder });
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
  const server = createServer((request, response) => {
    const path = join(folder, "dist", request.url === "/" ? "index.html" : request.url);
    if (!existsSync(path)) return response.writeHead(404).end();
    response.writeHead(200, { "content-type": types[extname(path)] ?? "text/plain" }).end(readFileSync(path));
  }).listen(0, "127.0.0.1");
  const chrome = await chromium.launch({ executablePath: browser, args: ["--no-sandbox"] });
  try {
    const page = await chrome.newPage();
    const troubles = [];
    page.on("pageerror", (error) => troubles.push(String(error)));
    page.on("console", (message) => message.type() === "error" && troubles.push(message.text()));
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    await page.waitForFunction("window.answer", undefined, { timeout: 60_000 });
    const { sums, stopped } = await page.evaluate("window.answer");
    const expected = mk.offset("POINT (1 2)", 3, { as: "wkt", coords: "exact" });
    assert.deepEqual(sums, [expected, expected, expected]);
    assert.equal(stopped, "AbortError");
    assert.deepEqual(troubles, []);
  } finally {
    await chrome.close();
    server.close();
  }
});
