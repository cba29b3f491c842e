// Accessibility, requests and sizes.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { basename, join } from "node:path";
import { after, before, test } from "node:test";
import { gzipSync } from "node:zlib";
import { folder, open, settled, star, start } from "./browser.mjs";

let browser, page;
before(async () => {
  browser = await start();
  ({ page } = await open(browser.context));
});
after(() => browser.close());

test("axe finds no fault: light and dark, wide and narrow, in every operation", async () => {
  const axe = join(new URL(".", import.meta.url).pathname, "../node_modules/axe-core/axe.min.js");
  await page.addScriptTag({ path: axe });
  const all = await page.evaluate(() => {
    for (const box of document.querySelectorAll("details")) box.open = true;
    return [...document.querySelectorAll("[data-op]")].map((button) => button.dataset.op);
  });
  assert.equal(all.length, 11);
  await page.emulateMedia({ reducedMotion: "reduce" }); // colours must not be between two others
  for (const [width, scheme] of [
    [1440, "light"],
    [1440, "dark"],
    [390, "light"],
    [390, "dark"],
  ]) {
    await page.setViewportSize({ width, height: 900 });
    if ((await page.getAttribute("html", "data-theme")) !== scheme) await page.click("#theme");
    await page.fill("#text-a", star(1500, 0));
    await page.fill("#text-b", star(1499, 0.001));
    await page.locator("#busy").waitFor({ state: "visible" });
    const { violations: busy } = await page.evaluate(() => window.axe.run("#busy", { preload: false }));
    assert.deepEqual(busy.map((v) => [width, scheme, v.id, v.nodes.map((n) => n.html)]), []);
    await page.click("#cancel");
    await page.selectOption("#example", { label: "Room and robot" });
    const shown = width === 1440 ? all : ["sum", "offset", "nofit", "path", "steps"];
    for (const op of shown) {
      await page.evaluate((name) => document.querySelector(`[data-op=${name}]`).click(), op);
      await page.evaluate(() => document.querySelector("[data-name=workspace]:not(:checked)")?.click());
      await settled(page);
      const { violations } = await page.evaluate(() => window.axe.run({ preload: false }));
      assert.deepEqual(
        violations.map((v) => [op, width, scheme, v.id, v.nodes.map((n) => n.html)]),
        [],
      );
    }
  }
});
test("served, the page asks for the files of its folder alone", async () => {
  const server = createServer(async (request, response) => {
    const name = basename(new URL(request.url, "http://page").pathname) || "index.html";
    const types = { html: "text/html", css: "text/css", js: "text/javascript" };
    response.setHeader("Content-Type", types[name.split(".").pop()] ?? "text/plain");
    response.end(await readFile(join(folder, name)).catch(() => ""));
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const origin = `http://127.0.0.1:${server.address().port}/`;
  const served = await browser.context.newPage();
  const asked = [];
  served.on("request", (request) => asked.push(request.url()));
  await served.goto(origin);
  await settled(served);
  assert.match(await served.inputValue("#exact"), /^POLYGON/);
  const own = ["", "style.css", "minksum.js", "worker.js", "page.js"].map((name) => origin + name);
  assert.deepEqual(asked.filter((url) => !/^(blob|data):/.test(url)).sort(), own.sort());
  await served.close();
  server.close();
});
test("the page's own script is small", async () => {
  const bytes = gzipSync(await readFile(join(folder, "page.js")), { level: 9 }).length;
  console.log(`page.js: ${bytes} bytes compressed`);
  assert.ok(bytes <= 60_000);
});
