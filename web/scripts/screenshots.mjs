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
const all = [0, 1, 2, 3, 4, 5, 6, 7, 8].map((example) => ({ name: `example-${example}`, example }));
const more = [
  { name: "slices", example: 8, op: "slices" },
  { name: "robot", example: 8, op: "robot" },
  ...[0, 1, 3, 4, 5, 6, 7].map((stage) => ({ name: `stage-${stage}`, example: 2, stage })),
];
for (const [look, options] of Object.entries(looks)) {
  if (only && !look.startsWith(only)) continue;
  const { context, close } = await start(options);
  const { page } = await open(context);
  for (const { name, example, op, stage } of look === "light-wide"
    ? [...all, ...more]
    : [...all.slice(0, 4), ...more.slice(0, 1)]) {
    await page.selectOption("#example", String(example));
    await settled(page);
    if (op) await page.click(`[data-op=${op}]`);
    if (stage !== undefined) await page.fill("#stage", String(stage));
    await page.waitForTimeout(500);
    await settled(page);
    await page.screenshot({
      path: join(out, `${look}-${name}.png`),
      fullPage: look.endsWith("narrow"),
    });
  }
  await close();
}
