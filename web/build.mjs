// Makes the page: one folder that any server serves, and that a browser opens without one.
import { build } from "esbuild";
import { copyFile, mkdir, readFile, rm, writeFile } from "node:fs/promises";
import { join } from "node:path";

const here = new URL(".", import.meta.url).pathname;
const out = process.argv[2] ?? join(here, "dist");
const minksum = process.argv[3] ?? join(here, "../js/dist");

const bundle = async (entry, options = {}) => {
  const { outputFiles } = await build({
    entryPoints: [join(here, "src", entry)],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: "es2022",
    legalComments: "none",
    ...options,
  });
  return outputFiles[0].text;
};

await rm(out, { recursive: true, force: true });
await mkdir(out, { recursive: true });
const page = await bundle("main.ts");
// The page hands this function's text to its worker, and never calls it.
const nowhere = {
  name: "nowhere",
  setup: (b) => b.onResolve({ filter: /^#wasm$/ }, () => ({ path: join(here, "src/no-file.ts") })),
};
const worker = await bundle("worker.ts", {
  alias: { minksum: join(minksum, "index.js") },
  plugins: [nowhere],
});
const wasm = await readFile(join(minksum, "minksum.wasm"));
await writeFile(join(out, "page.js"), page);
await writeFile(join(out, "worker.js"), `var minksumWorker = function () {\n${worker}};\n`);
await writeFile(join(out, "minksum.js"), `var minksumWasm = "${wasm.toString("base64")}";\n`);
for (const name of ["index.html", "style.css"]) await copyFile(join(here, name), join(out, name));
