// What tests share.
import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import { load } from "minksum";

/** The native program. */
export const program =
  process.env.MINKSUM_PROGRAM ?? fileURLToPath(new URL("../../build/minksum", import.meta.url));
export const run = (args, input) => execFileSync(program, args, { input, encoding: "utf8" });
export const mk = await load();

/** Random numbers from 0 to 1, the same for a seed everywhere. */
export function random(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}
/** Returns a polygon with corners on a small grid, around its middle, and perhaps a hole. */
export function star(next, corners, size = 40) {
  const ring = (radius) => {
    const points = [];
    for (let i = 0; i < corners; ++i) {
      const angle = (2 * Math.PI * i) / corners;
      const r = radius * (0.3 + 0.7 * next());
      points.push([Math.round(size * r * Math.cos(angle)), Math.round(size * r * Math.sin(angle))]);
    }
    return [...points, points[0]];
  };
  const coordinates = [ring(1)];
  if (next() < 0.4) coordinates.push(ring(0.25).reverse());
  return { type: "Polygon", coordinates };
}
export const box = (x0, y0, x1, y1) => ({
  type: "Polygon",
  coordinates: [[[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]],
});
