// What people do on the page: draw, drag, drop, share, stop; and what it must not do.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { chooseExample, drop, open, settled, star, start, until as untilOn } from "./browser.mjs";

let browser, page, noted;
before(async () => {
  browser = await start();
  ({ page, noted } = await open(browser.context));
});
after(() => browser.close());

/** Where a place of the drawing is on the screen, as parts of its width and height. */
async function place(x, y) {
  const box = await page.locator("#drawing").boundingBox();
  return [box.x + x * box.width, box.y + y * box.height];
}
const text = (name) => page.inputValue(`#text-${name}`);
const vertices = (wkt) => wkt.split(",").length - 1;
const until = (check, what) => untilOn(page, check, what);

test("shapes are drawn by mouse and by keyboard", async () => {
  await chooseExample(page, "An empty sheet");
  await page.click("[data-tool=polygon]");
  for (const at of [
    [0.4, 0.7],
    [0.8, 0.7],
    [0.8, 0.3],
    [0.4, 0.3],
  ])
    await page.mouse.click(...(await place(...at)));
  await page.mouse.click(...(await place(0.4, 0.7)));
  await until(async () => vertices(await text("a")) === 4, "A has four vertices");
  await page.click("[data-tool=hole]");
  for (const at of [
    [0.5, 0.6],
    [0.7, 0.6],
    [0.6, 0.4],
  ])
    await page.mouse.click(...(await place(...at)));
  await page.keyboard.press("Enter");
  await until(async () => (await text("a")).includes("), ("), "A has a hole");

  await page.click("[data-target=b]");
  await page.focus("#drawing");
  await page.keyboard.press("p");
  for (const keys of [
    ["ArrowLeft", "Space"],
    ["ArrowRight", "ArrowRight", "Space"],
    ["ArrowUp", "ArrowUp", "Space"],
    ["Enter"],
  ]) {
    for (const key of keys) await page.keyboard.press(key);
  }
  await until(async () => vertices(await text("b")) === 3, "B has three vertices");
  await settled(page);
  assert.match(await page.inputValue("#exact"), /^POLYGON/);
  assert.match(await page.textContent("#status"), /Polygon of 3 vertices added to B/);
  await page.keyboard.press("v");
  await page.click("[data-target=a]");
});
test("vertices move by keyboard, are inserted and removed, and all is undone", async () => {
  await chooseExample(page, "Room and robot");
  await page.focus("#drawing");
  const before_ = await text("a");
  await page.keyboard.press("n");
  await page.keyboard.press("ArrowLeft");
  await until(async () => /\(\(4\.5 0,/.test(await text("a")), "the first vertex is at 4.5, 0");
  await page.keyboard.press("Enter");
  await until(
    async () => vertices(await text("a")) === vertices(before_) + 1,
    "a vertex was inserted",
  );
  await page.keyboard.press("Delete");
  await until(async () => vertices(await text("a")) === vertices(before_), "it was removed");
  for (let i = 0; i < 3; ++i) await page.keyboard.press("Control+z");
  await until(async () => (await text("a")) === before_, "all is undone");
  await page.keyboard.press("Control+y");
  await until(async () => /\(\(4\.5 0,/.test(await text("a")), "the move is done again");
});
test("a vertex is dragged by mouse, and an edge gets a vertex by a click", async () => {
  await chooseExample(page, "Room and robot");
  const box = await page.locator(".layer-first path").first().boundingBox();
  const before_ = await text("a");
  await page.mouse.move(box.x + 1, box.y + box.height - 1);
  await page.mouse.down();
  await page.mouse.move(box.x - 40, box.y + box.height + 20, { steps: 5 });
  await page.mouse.up();
  await until(async () => (await text("a")) !== before_, "the vertex has moved");
  assert.equal(vertices(await text("a")), vertices(before_));
  await page.click("#undo");
  await until(async () => (await text("a")) === before_, "one step undoes the drag");
  await page.mouse.click(box.x + box.width / 3, box.y + box.height - 1);
  await until(
    async () => vertices(await text("a")) === vertices(before_) + 1,
    "the edge has a vertex",
  );
});
test("dragging a bird over a bird: frame times (reported)", async () => {
  await chooseExample(page, "Bird and bird");
  const box = await page.locator(".layer-first path").first().boundingBox();
  const [x, y] = [box.x + box.width * 0.6, box.y + box.height * 0.5];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.evaluate(() => {
    window.frames_ = [];
    window.results_ = 0;
    const result = document.querySelector(".layer-result path");
    new MutationObserver(() => ++window.results_).observe(result, {
      attributes: true,
      attributeFilter: ["d"],
    });
    const note = (time) => {
      window.frames_.push(time);
      window.noting_ = requestAnimationFrame(note);
    };
    requestAnimationFrame(note);
  });
  const start_ = performance.now();
  for (let i = 1; i <= 120; ++i) {
    await page.mouse.move(x + 60 * Math.sin(i / 9), y + 40 * Math.sin(i / 7));
    await page.waitForTimeout(4);
  }
  const seconds = (performance.now() - start_) / 1000;
  const { frames_, results_ } = await page.evaluate(() => {
    cancelAnimationFrame(window.noting_);
    return { frames_: window.frames_, results_: window.results_ };
  });
  await page.mouse.up();
  const gaps = frames_
    .slice(1)
    .map((time, i) => time - frames_[i])
    .sort((a, b) => a - b);
  const at = (part) => gaps[Math.floor(part * (gaps.length - 1))].toFixed(1);
  console.log(
    `frames: median ${at(0.5)} ms, 95 of 100 within ${at(0.95)} ms, longest ${at(1)} ms, ` +
      `${(frames_.length / seconds).toFixed(0)} a second; ` +
      `${(results_ / seconds).toFixed(0)} sums drawn a second`,
  );
  assert.ok(frames_.length > 10 && results_ > 0);
});
test("a part snaps to a place without play, and tells how it stands", async () => {
  await chooseExample(page, "Bracket and peg");
  assert.match(await page.textContent("#facts"), /Parts arefree/);
  const box = await page.locator(".layer-second path").first().boundingBox();
  const unit = box.width / 2.05;
  const [x, y] = [box.x + unit, box.y + box.height - unit];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 3, y + 6 * unit + 4, { steps: 12 });
  await page.mouse.up();
  await settled(page);
  assert.match(await page.textContent("#facts"), /Parts aretouching/);
  await page.keyboard.press("ArrowRight");
  await settled(page);
  assert.match(await page.textContent("#facts"), /Parts areoverlapping/);
});
test("the slider goes through all stages, each with words, counts and a time", async () => {
  await chooseExample(page, "A spiral and a gear");
  const names = [
    "Operands",
    "Convolution",
    "Reduced convolution",
    "Cover",
    "Arrangement",
    "Orientable loops",
    "Rejected loops",
    "Result",
  ];
  await page.fill("#stage", "0");
  for (const [i, name] of names.entries()) {
    await until(
      async () => (await page.textContent("#stage-text h2")) === `${i + 1}. ${name}`,
      name,
    );
    const words = await page.textContent("#stage-text p");
    assert.equal(words.match(/[.?](?= |$)/g).length, 3, `three sentences: ${words}`);
    const counts = await page.textContent("#stage-text .counts");
    assert.match(counts, /\d/);
    assert.match(counts, i === 1 ? /drawn by the page/ : /ms/);
    if (i > 0) assert.ok((await page.locator(".layer-result path").count()) > 0);
    await page.focus("#stage");
    await page.keyboard.press("ArrowRight");
  }
});
test("exact coordinates and where an edge came from are told under the pointer", async () => {
  await chooseExample(page, "Room and robot");
  const box = await page.locator(".layer-result path").first().boundingBox();
  await page.mouse.move(box.x + 1.5, box.y + box.height - 1.5);
  await until(async () => await page.locator("#hover").isVisible(), "something is told");
  const told = await page.textContent("#hover");
  assert.match(told, /\(4, -1\)/);
  assert.match(told, /Edge: the edge .* of [AB], moved by the vertex .* of [AB]/);
});
test("a link opens the same, and what is too long for one is saved", async () => {
  await chooseExample(page, "A leaf with a margin");
  await page.fill("#fields input[type=number] >> nth=0", "-0.5");
  await settled(page);
  await page.click("#share");
  await until(
    async () => (await page.evaluate(() => location.hash)).startsWith("#v1."),
    "there is a link",
  );
  const shown = [await text("a"), await text("b"), await page.inputValue("#exact")];
  const other = await open(browser.context, await page.evaluate(() => location.hash));
  const values = await Promise.all(
    ["#text-a", "#text-b", "#exact"].map((id) => other.page.inputValue(id)),
  );
  assert.deepEqual(values, shown);
  assert.deepEqual(other.noted.errors, []);
  await other.page.close();
  const many = Array.from(
    { length: 3000 },
    (_, i) => `${(i * 7919) % 10007} ${(i * i * 31) % 9973}`,
  );
  await page.fill("#text-a", `MULTIPOINT (${many.map((p) => `(${p})`).join(", ")})`);
  await until(
    async () => (await page.textContent("#status")).includes("3000"),
    "the points are read",
  );
  await page.click("#share");
  await until(
    async () => /8 kB.*Save file/.test(await page.textContent("#status")),
    "a file is offered",
  );
});
test("files are dropped: WKT, GeoJSON, SVG, DXF, and what the page has saved", async () => {
  await chooseExample(page, "Room and robot");
  const square = "POLYGON ((5 5, 9 5, 9 8, 5 8, 5 5))";
  const pairs = [
    ["0", "LWPOLYLINE"],
    ["8", "0"],
    ["90", "4"],
    ["70", "1"],
    ...[
      [5, 5],
      [9, 5],
      [9, 8],
      [5, 8],
    ].flatMap(([x, y]) => [
      ["10", x],
      ["20", y],
    ]),
  ];
  const dxf =
    [["0", "SECTION"], ["2", "ENTITIES"], ...pairs, ["0", "ENDSEC"], ["0", "EOF"]]
      .flat()
      .join("\n") + "\n";
  const svg =
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10">' +
    '<path d="M5 5h4v3q-1 1 -2 0l-2 0z"/></svg>';
  const json = JSON.stringify({
    type: "Polygon",
    coordinates: [
      [
        [5, 5],
        [9, 5],
        [9, 8],
        [5, 8],
        [5, 5],
      ],
    ],
  });
  const files = { "a.wkt": square, "a.geojson": json, "a.dxf": dxf, "a.svg": svg };
  for (const [name, content] of Object.entries(files)) {
    await page.fill("#text-a", "POINT (1 1)");
    await until(
      async () => (await page.textContent("#status")).includes("has 1 vertices"),
      "a point",
    );
    await drop(page, name, content);
    await until(
      async () => (await page.textContent("#status")).match(/has ([4-9]|\d\d) vertices/),
      name,
    );
    assert.match(await text("a"), /^POLYGON/, name);
    if (!name.endsWith("svg")) assert.equal(vertices(await text("a")), 4);
  }
  await drop(
    page,
    "minksum.json",
    JSON.stringify({
      version: 1,
      op: "erode",
      a: {
        polygons: [
          [
            [
              [0, 0],
              ["10/3", 0],
              [0, 4],
            ],
          ],
        ],
      },
      b: { points: [[1, 1]] },
    }),
  );
  await until(async () => (await text("a")).includes("10/3"), "the saved state is open");
  await until(
    async () => (await page.getAttribute("[data-op=erode]", "aria-pressed")) === "true",
    "its operation is chosen",
  );
});
test("bad input is refused, with its place marked", async () => {
  await chooseExample(page, "Room and robot");
  await page.click("#text-a");
  await page.fill("#text-a", "POLYGON ((0 0, 4 4, 4 O, 0 4, 0 0))");
  await until(() => page.locator("#problem-a").isVisible(), "a problem is told");
  assert.match(await page.textContent("#problem-a"), /Line 1, column 23: .*'O'/);
  assert.equal(await page.evaluate(() => document.getElementById("text-a").selectionStart), 22);
  await page.fill("#text-a", "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))");
  await until(() => page.locator("#message").isVisible(), "the crossing is told");
  assert.match(await page.textContent("#message"), /A is not a valid polygon: .*\(2, 2\)/);
  assert.ok((await page.locator("path.fault").count()) > 0);
  await page.selectOption("[data-name=fill]", "strict");
  await settled(page);
  await until(
    async () => (await page.textContent("#message")).startsWith("A: "),
    "it is an error now",
  );
  assert.ok((await page.locator("path.fault").count()) > 0);
  await page.selectOption("[data-name=fill]", "automatic");
});
test("a long sum is stopped, and the page goes on", async () => {
  await chooseExample(page, "Room and robot");
  await page.fill("#text-a", star(1500, 0));
  await page.fill("#text-b", star(1499, 0.001));
  await page.locator("#busy").waitFor({ state: "visible" });
  await until(
    async () => / stage [1-7] of 7$/.test(await page.textContent("#doing")),
    "the stage is told",
  );
  const bar = page.getByRole("progressbar", { name: "How much is done" });
  assert.ok(await bar.evaluate(({ value, max }) => value < max && max === 7));
  await page.click("#cancel");
  await until(
    async () => (await page.textContent("#message")).includes("Stopped"),
    "it has stopped",
  );
  await chooseExample(page, "Room and robot");
  assert.match(await page.inputValue("#exact"), /^POLYGON/);
});
test("stacked slices tell how many are done", async () => {
  await chooseExample(page, "Room and robot");
  await page.click("[data-op=slices]");
  await page.fill("#text-a", star(1500, 0));
  await page.fill("#text-b", star(1499, 0.001));
  await until(
    async () => / \d+ of 24 parts done$/.test(await page.textContent("#doing")),
    "the count is told",
  );
  await page.click("#cancel");
  await chooseExample(page, "Room and robot");
});
test("text that was just typed is kept when an answer comes", async () => {
  await chooseExample(page, "Room and robot");
  const [a, b] = ["POLYGON ((0 0, 5 0, 0 5, 0 0))", "POLYGON ((0 0, 1 0, 0 1, 0 0))"];
  await page.evaluate((given) => {
    const area = document.getElementById("text-a");
    area.value = given;
    area.dispatchEvent(new Event("input"));
    document.querySelector("[data-op=erode]").click();
  }, a);
  await page.fill("#text-b", b);
  await settled(page);
  assert.deepEqual([await text("a"), await text("b")], [a, b]);
  assert.equal(await page.inputValue("#exact"), "POLYGON ((0 0, 4 0, 0 4, 0 0))");
});
test("nothing was complained of, and nothing was asked for but the folder's files", () => {
  assert.deepEqual(noted.errors, []);
  assert.deepEqual(
    noted.requests.filter((url) => !/^(file:|blob:|data:)/.test(url)),
    [],
  );
});
