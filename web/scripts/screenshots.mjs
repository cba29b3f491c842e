// Makes pictures of the page to be looked at: node scripts/screenshots.mjs FOLDER
import { mkdir } from "node:fs/promises";
import { join } from "node:path";
import { open, settled, start } from "../test/browser.mjs";

const out = process.argv[2] ?? "screenshots";
await mkdir(out, { recursive: true });
const only = process.argv[3];
const looks = {
  "light-wide": { colorScheme: "light", viewport: { width: 1440, height: 900 } },
  "dark-wide": { colorScheme: "dark", viewport: { width: 1440, height: 900 } },
  "light-narrow": {
    colorScheme: "light",
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
  },
  "dark-narrow": {
    colorScheme: "dark",
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
  },
};
// Each operation on an example that suits it, and the stages of a sum.
const operations = {
  sum: 1, erode: 0, open: 0, close: 5, offset: 6, nofit: 3, depth: 7, robot: 8, slices: 8, path: 8,
};
const pictures = [
  ...Object.entries(operations).map(([op, example]) => ({ name: op, example, op })),
  ...[1, 3, 5, 7].map((stage) => ({ name: `stage-${stage}`, example: 2, op: "steps", stage })),
];
for (const [look, options] of Object.entries(looks)) {
  if (only && !look.startsWith(only)) continue;
  const { context, close } = await start(options);
  const { page } = await open(context);
  for (const { name, example, op, stage } of pictures) {
    await page.selectOption("#example", String(example));
    await settled(page);
    await page.evaluate((wanted) => document.querySelector(`[data-op=${wanted}]`).click(), op);
    if (stage !== undefined) await page.fill("#stage", String(stage));
    await settled(page);
    await page.screenshot({
      path: join(out, `${look}-${name}.png`),
      fullPage: look.endsWith("narrow"),
    });
  }
  await close();
}
