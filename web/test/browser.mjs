// Starts Debian's Chromium with a folder for its user that is new and goes away.
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

export const folder =
  process.env.MINKSUM_PAGE ?? join(new URL(".", import.meta.url).pathname, "../dist");
export const address = pathToFileURL(join(folder, "index.html")).href;

export async function start(options = {}) {
  const user = await mkdtemp(join(tmpdir(), "minksum-page-"));
  const context = await chromium.launchPersistentContext(user, {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    args: [
      "--no-sandbox",
      "--disable-gpu",
      "--disable-quic",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
    ],
    viewport: { width: 1440, height: 900 },
    colorScheme: "light",
    ...options,
  });
  const close = async () => {
    await context.close();
    await rm(user, { recursive: true, force: true, maxRetries: 5 });
  };
  return { context, close };
}

/** Opens the page, and notes what it asks for and complains of. */
export async function open(context, fragment = "") {
  const page = await context.newPage();
  const noted = { errors: [], requests: [] };
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) noted.errors.push(message.text());
  });
  page.on("pageerror", (error) => noted.errors.push(error.message));
  page.on("request", (request) => noted.requests.push(request.url()));
  await page.goto(address + fragment);
  await settled(page);
  return { page, noted };
}
/** Waits until exact numbers are there, or what an operation without them has. */
export async function settled(page) {
  await page.waitForFunction(() => document.documentElement.dataset.settled === "yes", null, {
    timeout: 60_000,
  });
}
/** A star of so many rays as WKT. The sum of two with many rays takes seconds. */
export function star(rays, turn) {
  const ring = Array.from({ length: 2 * rays }, (_, i) => {
    const angle = turn + (Math.PI * i) / rays;
    const radius = i % 2 ? 10 : 1000;
    return `${(radius * Math.cos(angle)).toFixed(3)} ${(radius * Math.sin(angle)).toFixed(3)}`;
  });
  return `POLYGON ((${[...ring, ring[0]].join(", ")}))`;
}
/** Waits until `check` holds. */
export async function until(page, check, what) {
  for (let i = 0; i < 400; ++i) {
    if (await check()) return;
    await page.waitForTimeout(25);
  }
  throw new Error(`never: ${what}`);
}
export async function chooseExample(page, name) {
  await page.selectOption("#example", { label: name });
  await settled(page);
}
/** Lets a file fall on the page. */
export async function drop(page, name, text) {
  await page.evaluate(
    ([fileName, content]) => {
      const data = new DataTransfer();
      data.items.add(new File([content], fileName));
      document.dispatchEvent(
        new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }),
      );
    },
    [name, text],
  );
}
