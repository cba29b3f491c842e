// Other ways in and out: paste, save, zoom, fingers.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { chooseExample, open, settled, start, until } from "./browser.mjs";

let browser, page, noted;
before(async () => {
  browser = await start({ hasTouch: true });
  ({ page, noted } = await open(browser.context));
});
after(() => browser.close());

const text = (name) => page.inputValue(`#text-${name}`);
const status = () => page.textContent("#status");
const boxOf = (layer) => page.locator(`.layer-${layer} path`).first().boundingBox();
async function paste(content) {
  await page.evaluate((given) => {
    const data = new DataTransfer();
    data.setData("text/plain", given);
    document.body.dispatchEvent(
      new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }),
    );
  }, content);
}
async function saved(button) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(button)]);
  return [download.suggestedFilename(), await readFile(await download.path(), "utf8")];
}

test("WKT, GeoJSON, SVG and DXF are pasted, and one step undoes each", async () => {
  await chooseExample(page, "Room and robot");
  await page.focus("#drawing");
  const dxf = [0, "SECTION", 2, "ENTITIES", 0, "LWPOLYLINE", 8, "0", 90, 3, 70, 1, 10, 1, 20, 1, 10, 5]
    .concat([20, 1, 10, 1, 20, 7, 0, "ENDSEC", 0, "EOF"])
    .join("\n");
  const triangle = "POLYGON ((1 1, 5 1, 1 7, 1 1))";
  const coordinates = [[[1, 1], [5, 1], [1, 7], [1, 1]]];
  // y runs down in an SVG, and up here.
  const svg = '<svg xmlns="http://www.w3.org/2000/svg"><path d="M1 -1H5L1 -7Z"/></svg>';
  const whole = await text("a");
  for (const content of [triangle, JSON.stringify({ type: "Polygon", coordinates }), svg, dxf + "\n"]) {
    await paste(content);
    await until(page, async () => (await text("a")) === triangle, content);
    await page.click("#undo");
    await until(page, async () => (await text("a")) === whole, "it is undone");
  }
  await paste("POLYGON ((1 1, 5 x");
  await until(page, () => page.locator("#problem-a").isVisible(), "what is wrong is told");
  await chooseExample(page, "Bird and bird");
});
test("the result is saved as WKT, and the drawing as SVG", async () => {
  await chooseExample(page, "Room and robot");
  const [wktName, wkt] = await saved("#save-wkt");
  assert.equal(wktName, "minksum.wkt");
  assert.equal(wkt, `${await page.inputValue("#exact")}\n`);
  const [svgName, svg] = await saved("#save-svg");
  assert.equal(svgName, "minksum.svg");
  const drawn = await page.evaluate((given) => {
    const read = new DOMParser().parseFromString(given, "image/svg+xml");
    const sum = document.querySelector(".layer-result path").getAttribute("d");
    const paths = [...read.querySelectorAll("path")];
    return {
      failed: read.querySelector("parsererror") !== null,
      sum: paths.some((path) => path.getAttribute("d") === sum && path.getAttribute("fill") !== "none"),
    };
  }, svg);
  assert.deepEqual(drawn, { failed: false, sum: true });
});
test("wheel, buttons and keys zoom, and Fit shows all", async () => {
  await chooseExample(page, "Room and robot");
  await page.click("#fit");
  const width = async () => (await boxOf("first")).width;
  const fitted = await width();
  const drawing = await page.locator("#drawing").boundingBox();
  const grows = async (act, what) => {
    const was = await width();
    await act();
    await until(page, async () => (await width()) > was * 1.05, what);
  };
  const shrinks = async (act, what) => {
    const was = await width();
    await act();
    await until(page, async () => (await width()) < was * 0.95, what);
  };
  await grows(() => page.click("#closer"), "closer");
  await shrinks(() => page.click("#farther"), "farther");
  await page.mouse.move(drawing.x + drawing.width / 2, drawing.y + drawing.height / 2);
  await grows(() => page.mouse.wheel(0, -300), "the wheel brings closer");
  await shrinks(() => page.mouse.wheel(0, 600), "and farther");
  await page.focus("#drawing");
  await grows(() => page.keyboard.press("+"), "the key +");
  await shrinks(() => page.keyboard.press("-"), "the key -");
  await page.keyboard.press("f");
  await until(page, async () => Math.abs((await width()) - fitted) < 1, "all is shown again");
});
test("a finger drags a vertex, and two fingers zoom", async () => {
  await chooseExample(page, "Room and robot");
  const session = await browser.context.newCDPSession(page);
  const touch = (type, ...points) =>
    session.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
  const box = await boxOf("first");
  const whole = await text("a");
  const corner = [box.x + 2, box.y + box.height - 2];
  await touch("touchStart", corner);
  for (let i = 1; i <= 5; ++i) await touch("touchMove", [corner[0] - 8 * i, corner[1] + 4 * i]);
  await touch("touchEnd");
  await until(page, async () => (await text("a")) !== whole, "the vertex has moved");
  await page.click("#undo");
  await until(page, async () => (await text("a")) === whole, "it is undone");
  await settled(page);
  const before = (await boxOf("first")).width;
  const middle = [box.x + box.width / 2, box.y + box.height / 2];
  const fingers = (d) => [[middle[0] - d, middle[1]], [middle[0] + d, middle[1]]];
  await touch("touchStart", fingers(40)[0]);
  await touch("touchStart", ...fingers(40));
  for (const d of [50, 60, 70, 80]) await touch("touchMove", ...fingers(d));
  await touch("touchEnd");
  await until(page, async () => (await boxOf("first")).width > 1.5 * before, "it is closer");
  assert.equal(await text("a"), whole, "nothing was moved");
});
test("nothing was complained of, and nothing was asked for", () => {
  assert.deepEqual(noted.errors, []);
  assert.deepEqual(noted.requests.filter((url) => !/^(file:|blob:|data:)/.test(url)), []);
});
