// usage: node scripts/build.mjs MINKSUM.WASM
// Compiles the package into dist/, with the module in WebAssembly beside the scripts.
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";

const [wasm] = process.argv.slice(2);
process.chdir(new URL("..", import.meta.url).pathname);
rmSync("dist", { recursive: true, force: true });
const tsc = (...flags) =>
  execFileSync(process.execPath, ["node_modules/typescript/bin/tsc", "-p", ".", ...flags], { stdio: "inherit" });
// Editors show the comments of declarations. Nobody reads those of scripts, which pages load.
tsc("--emitDeclarationOnly");
tsc("--declaration", "false", "--removeComments");
mkdirSync("dist", { recursive: true });
copyFileSync(wasm, "dist/minksum.wasm");
const base64 = readFileSync(wasm).toString("base64");
writeFileSync("dist/wasm-base64.js", `export const wasmBase64 = "${base64}";\n`);
copyFileSync("src/wasm-base64.d.ts", "dist/wasm-base64.d.ts");
copyFileSync("../LICENSE", "LICENSE");
