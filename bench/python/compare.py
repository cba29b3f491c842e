#!/usr/bin/env python3
"""Measures the Python package beside Shapely and pyclipper, in one process.

    build/python-environment/bin/python bench/python/compare.py [budgets] [peers] [buffers]

It prints Markdown. Times are the processor's, the smallest of several runs, so that other work on
the machine disturbs them little; those of threads are the wall clock's. `buffers` reads the outlines
in the folder `gis` of MINKSUM_DATA (../shared/data).
"""

import os
import pathlib
import subprocess
import sys
import threading
import time

import numpy as np
import pyclipper
import shapely
import shapely.affinity

import minksum as mk
import minksum.arrow
import minksum.shapely

SCALE = 2.0**20  # pyclipper has integer coordinates


def seconds(call, least=0.02, runs=7):
    """Return the processor time of one call."""
    count, best = 1, float("inf")
    while True:
        begin = time.process_time()
        for _ in range(count):
            call()
        spent = time.process_time() - begin
        if spent >= least:
            best = min(best, spent / count)
            runs -= 1
            if runs <= 0:
                return best
        else:
            count *= 2


def star(source, corners):
    angles = np.sort(source.uniform(0, 2 * np.pi, corners))
    radii = source.uniform(0.4, 1, corners)
    return np.column_stack([radii * np.cos(angles), radii * np.sin(angles)])


def row(*cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |")


def head(*cells):
    row(*cells)
    print("|" + "---|" * len(cells))


def micro(value):
    return f"{value * 1e6:.2f} µs"


def imports():
    program = ("import numpy, time; a = time.process_time(); import minksum; "
               "print(time.process_time() - a)")
    return min(float(subprocess.run([sys.executable, "-c", program], capture_output=True,
                                    text=True, check=True).stdout) for _ in range(5))


def at_once(threads):
    source = np.random.default_rng(1)
    a, b = (mk.Geometry(star(source, 200)) for _ in range(2))

    def work(count):
        for _ in range(count):
            mk.minkowski_sum(a, b, threads=1)

    best = float("inf")
    for _ in range(5):
        workers = [threading.Thread(target=work, args=(40 // threads,)) for _ in range(threads)]
        begin = time.perf_counter()
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        best = min(best, time.perf_counter() - begin)
    return best


def budgets():
    print("## Cost of a call\n")
    head("call", "minksum", "beside")
    a, b = mk.box(0, 0, 1, 1), mk.box(0, 0, 2, 1)
    s, t = shapely.box(0, 0, 1, 1), shapely.box(0, 0, 2, 1)
    row("`g.is_empty`", micro(seconds(lambda: a.is_empty)),
        f"Shapely {micro(seconds(lambda: s.is_empty))}")
    row("`g.area`", micro(seconds(lambda: a.area)), f"Shapely {micro(seconds(lambda: s.area))}")
    empty = mk.from_wkt("POLYGON EMPTY")
    row("sum with the empty set", micro(seconds(lambda: mk.minkowski_sum(a, empty))), "")
    row("sum of two boxes", micro(seconds(lambda: mk.minkowski_sum(a, b))),
        f"Shapely's `union` {micro(seconds(lambda: shapely.union(s, t)))}")
    row("the same, operands of Shapely", micro(seconds(lambda: mk.minkowski_sum(s, t))),
        f"`to_wkb` of both {micro(2 * seconds(lambda: shapely.to_wkb(s)))}")
    row("the same, result of Shapely", micro(seconds(lambda: minksum.shapely.minkowski_sum(s, t))), "")
    row("`exact_coords()` of thirds, a vertex",
        micro(seconds(mk.scale(a, "1/3", "1/3").exact_coords) / 4), "")
    source = np.random.default_rng(2)
    discs = shapely.buffer(shapely.points(source.uniform(0, 1000, (20000, 2))), 1, quad_segs=3)
    import geopandas

    for name in ("WKB", "geoarrow"):
        column = geopandas.GeoSeries(discs).to_arrow(geometry_encoding=name)
        shapes = minksum.arrow.from_arrow(column)
        read = seconds(lambda: minksum.arrow.from_arrow(column), runs=3) / len(discs)
        row(f"`from_arrow`, {name}, a polygon of 12 vertices", micro(read), "")
    objects = seconds(lambda: mk.as_geometry(discs), runs=3) / len(discs)
    row("an array of Shapely's polygons, each", micro(objects), "")
    for encoding in ("wkb", "multipolygon"):
        write = seconds(lambda: minksum.arrow.to_arrow(shapes, encoding=encoding), runs=3) / len(discs)
        row(f"`to_arrow`, {encoding}, each", micro(write), "")
    parts = [star(source, 12) for _ in range(25)]
    table = seconds(lambda: mk.NoFitTable(parts, threads=1), runs=3)
    entries = 25 * 25 * 16
    row("an entry of `NoFitTable`, 25 parts of 12 vertices", micro(table / entries), "")
    made = mk.NoFitTable(parts, threads=1)
    row("the same as an element of `entries()`", micro(seconds(made.entries, runs=3) / entries), "")
    row("`import minksum` after NumPy", f"{imports() * 1e3:.0f} ms", "")
    alone, eight = at_once(1), at_once(8)
    row("8 threads over the same operands", f"{alone / eight:.2f} times as fast",
        f"{os.cpu_count()} cores")


def area_off(result, truth):
    """Return the area on which two sets differ, relative to the true one."""
    return float(mk.area(mk.symmetric_difference(result, truth)) / mk.area(truth))


def by_pyclipper(a, b):
    ring, pattern = ([(round(x * SCALE), round(y * SCALE)) for x, y in p] for p in (a, b))
    paths = pyclipper.MinkowskiSum(pattern, ring, True)
    clipper = pyclipper.Pyclipper()
    # Its sum is that of the boundaries; a copy of one operand at a vertex of the other fills it.
    x, y = ring[0]
    filled = [*paths, [(x + u, y + v) for u, v in pattern]]
    clipper.AddPaths(filled, pyclipper.PT_SUBJECT, True)
    tree = clipper.Execute(pyclipper.CT_UNION, pyclipper.PFT_NONZERO, pyclipper.PFT_NONZERO)
    return [[(u / SCALE, v / SCALE) for u, v in path] for path in tree]


def by_translates(a, b):
    """The union of b at every vertex of a, swept along no edge: what people write by hand."""
    part = shapely.Polygon(b)
    moved = [shapely.affinity.translate(part, x, y) for x, y in a]
    hulls = [shapely.union(p, q).convex_hull for p, q in zip(moved, moved[1:] + moved[:1])]
    base = shapely.affinity.translate(shapely.Polygon(a), *b[0])
    return shapely.union_all([base, *hulls])


def by_buffer(a, b):
    radius = float(np.sqrt(shapely.Polygon(b).area / np.pi))
    return shapely.buffer(shapely.Polygon(a), radius)


def peers():
    source = np.random.default_rng(3)
    pairs = [(star(source, 30), star(source, 12)) for _ in range(100)]
    truths = [mk.minkowski_sum(a, b) for a, b in pairs]
    print("\n## 100 sums of stars with 30 and 12 corners\n")
    head("by", "time of a sum", "largest error of the area", "mean error")
    ways = [
        ("minksum, exact", lambda a, b: mk.minkowski_sum(a, b, threads=1)),
        ("minksum, Shapely in and out",
         lambda a, b: minksum.shapely.minkowski_sum(shapely.Polygon(a), shapely.Polygon(b), threads=1)),
        ("pyclipper", by_pyclipper),
        ("Shapely: hulls of translates", by_translates),
        ("Shapely: buffer by a disc of equal area", by_buffer),
    ]
    for name, way in ways:
        spent = seconds(lambda: [way(a, b) for a, b in pairs], runs=3) / len(pairs)
        results = [way(a, b) for a, b in pairs]
        if name == "pyclipper":
            results = [pyclipper_set(rings) for rings in results]
        errors = [area_off(mk.as_geometry(r), t) for r, t in zip(results, truths)]
        row(name, micro(spent), f"{max(errors):.1e}", f"{np.mean(errors):.1e}")


def pyclipper_set(rings):
    """Outer rings run counter-clockwise in its results, and holes clockwise."""
    ring_sets = {"type": "Polygon", "coordinates": [r + r[:1] for r in rings if len(r) > 2]}
    return mk.resolve(ring_sets, fill="nonzero")


def deviation(shape, inside, outside):
    """Return how Shapely's buffer lies to the two sides between which the true offset is."""
    ours = mk.as_geometry(shape)
    missed = mk.area(mk.difference(inside, ours))
    beyond = mk.area(mk.difference(ours, outside))
    return missed, beyond


def buffers():
    folder = pathlib.Path(os.environ.get("MINKSUM_DATA", "../shared/data")) / "gis"
    files = sorted(folder.glob("*.wkt"))
    print(f"\n## Offsets of {len(files)} outlines\n")
    print("The distance is a hundredth of the outline's extent, and the tolerance a thousandth of "
          "the distance.\n")
    head("outline", "vertices", "inside within outside", "outside, time", "Shapely, time",
         "area that Shapely misses for certain", "area that it has for certain beyond")
    held = short = 0
    for path in files:
        shape = mk.resolve(path.read_text())
        x0, y0, x1, y1 = mk.bounds(shape)
        distance = max(x1 - x0, y1 - y0) / 100
        begin = time.process_time()
        outside = mk.offset(shape, distance, tolerance=distance / 1000, side="outside", threads=1)
        spent = time.process_time() - begin
        inside = mk.offset(shape, distance, tolerance=distance / 1000, side="inside", threads=1)
        peer = shapely.from_wkb(shape.to_wkb())
        begin = time.process_time()
        buffered = peer.buffer(distance)
        theirs = time.process_time() - begin
        missed, beyond = deviation(buffered, inside, outside)
        good = mk.covers(outside, inside)
        held += good
        short += missed > 0
        total = mk.area(inside)
        row(path.stem, shape.num_vertices, "yes" if good else "no", f"{spent * 1e3:.0f} ms",
            f"{theirs * 1e3:.0f} ms", f"{missed / total:.1e}", f"{beyond / total:.1e}")
        sys.stdout.flush()
    print(f"\n{held} of {len(files)} inner offsets lie within the outer ones. {short} of Shapely's "
          "buffers lack a part of the inner one.")


if __name__ == "__main__":
    for part in sys.argv[1:] or ["budgets", "peers", "buffers"]:
        {"budgets": budgets, "peers": peers, "buffers": buffers}[part]()
