// Minkowski sums by clipper2-wasm, which computes with integers.
import { createRequire } from "node:module";

const clipper = await createRequire(import.meta.url)("clipper2-wasm")();
const kScale = 2 ** 20;
const big = (value) => BigInt(Math.round(value * kScale));

function pathOf(ring) {
  const path = new clipper.Path64();
  for (const [x, y] of ring.slice(0, -1)) {
    const point = new clipper.Point64(big(x), big(y), 0n);
    path.push_back(point);
    point.delete();
  }
  return path;
}
function geojson(paths) {
  const polygons = [];
  for (let i = 0; i < paths.size(); ++i) {
    const path = paths.get(i);
    const ring = [];
    for (let k = 0; k < path.size(); ++k) {
      const point = path.get(k);
      ring.push([Number(point.x) / kScale, Number(point.y) / kScale]);
      point.delete();
    }
    ring.push([...ring[0]]);
    polygons.push([ring]);
    path.delete();
  }
  return { type: "MultiPolygon", coordinates: polygons };
}

/** Returns the sum of two polygons without holes, from GeoJSON to GeoJSON. The rings of its holes
 * run clockwise: read them by "nonzero". */
export function minkowskiSum(a, b) {
  const [first, second] = [a, b].map((shape) => pathOf(shape.coordinates[0]));
  // Clipper2 sweeps b along the outline of a. The inside of a is added, moved to a point of b.
  const swept = clipper.MinkowskiSum64(second, first, true);
  const [x, y] = b.coordinates[0][0];
  const moved = clipper.TranslatePath64(first, big(x), big(y));
  const inside = new clipper.Paths64();
  inside.push_back(moved);
  const sum = clipper.Union64(swept, inside, clipper.FillRule.NonZero);
  const answer = geojson(sum);
  for (const made of [first, second, swept, moved, inside, sum]) made.delete();
  return answer;
}
