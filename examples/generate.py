#!/usr/bin/env python3
"""Makes the shapes of this folder: the same ones every time, from a fixed seed.

    examples/generate.py FOLDER

coral.wkt    an organic region with 18 holes and about 1,800 vertices: limbs around the edges of a
             random planar net, with free ends
disc32.wkt   a regular 32-gon (corners rounded to the grid of the decimals)
star.wkt     a star with nine thin arms
star_turned.wkt  the same, turned by a few degrees
"""
import math
import pathlib
import random
import sys

DECIMALS = 2


def net(rng, loops):
    """A planar net with `loops` bounded faces: points, and edges as pairs of indices."""
    points = []
    while len(points) < 44:
        p = (rng.uniform(-100, 100), rng.uniform(-70, 70))
        if (p[0] / 100) ** 2 + (p[1] / 70) ** 2 > 1:
            continue
        if all(math.dist(p, other) > 17 for other in points):
            points.append(p)

    # The Gabriel graph is planar and connected, and its edges look natural.
    def gabriel(i, j):
        centre = [(a + b) / 2 for a, b in zip(points[i], points[j])]
        radius = math.dist(points[i], points[j]) / 2
        return all(math.dist(centre, p) >= radius for k, p in enumerate(points) if k not in (i, j))

    n = len(points)
    edges = [(i, j) for i in range(n) for j in range(i) if gabriel(i, j)]
    # A spanning tree of the shortest edges stays; others go until the wanted loops are left.
    edges.sort(key=lambda e: math.dist(points[e[0]], points[e[1]]))
    root = list(range(n))

    def find(i):
        while root[i] != i:
            i = root[i]
        return i

    tree, rest = [], []
    for i, j in edges:
        if find(i) != find(j):
            root[find(i)] = find(j)
            tree.append((i, j))
        else:
            rest.append((i, j))
    rng.shuffle(rest)
    assert len(rest) >= loops, (len(rest), loops)
    return points, tree + rest[:loops]


def limbs(rng, points, edges):
    """Capsules (a, b, radius at a, radius at b), with bends, and free ends pointing outwards."""
    thickness = [rng.uniform(1.7, 3.2) for _ in points]
    capsules = []

    def bent(a, b, ra, rb, bend):
        middle = ((a[0] + b[0]) / 2 - (b[1] - a[1]) * bend, (a[1] + b[1]) / 2 + (b[0] - a[0]) * bend)
        thin = 0.5 * min(ra, rb) + 0.25
        capsules.append((a, middle, ra, thin))
        capsules.append((middle, b, thin, rb))

    for i, j in edges:
        bent(points[i], points[j], thickness[i], thickness[j], rng.uniform(-0.1, 0.1))
    for p, radius in zip(points, thickness):
        away = math.hypot(p[0] / 100, p[1] / 70)
        if away < 0.72:
            continue
        for _ in range(rng.choice((1, 1, 2))):
            angle = math.atan2(p[1], p[0]) + rng.uniform(-0.7, 0.7)
            length = rng.uniform(10, 26)
            tip = (p[0] + length * math.cos(angle), p[1] + length * math.sin(angle))
            bent(p, tip, radius, 0.9, rng.uniform(-0.25, 0.25))
    return capsules


def distance(capsules, x, y):
    best = 1e9
    for (ax, ay), (bx, by), ra, rb in capsules:
        dx, dy = bx - ax, by - ay
        t = max(0.0, min(1.0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)))
        best = min(best, math.hypot(x - ax - t * dx, y - ay - t * dy) - ra - t * (rb - ra))
    return best


def contours(capsules, step):
    """Marching squares around distance < 0: closed rings, interior on the left."""
    x0, y0, nx, ny = -140.0, -110.0, int(280 / step), int(220 / step)
    value = [[distance(capsules, x0 + i * step, y0 + j * step) or 1e-9 for j in range(ny + 1)]
             for i in range(nx + 1)]
    after = {}

    def cut(a, b):
        """The crossing on the grid edge from a (inside) to b (outside), named by that edge."""
        t = value[a[0]][a[1]] / (value[a[0]][a[1]] - value[b[0]][b[1]])
        return (a, b), (x0 + step * (a[0] + t * (b[0] - a[0])), y0 + step * (a[1] + t * (b[1] - a[1])))

    for i in range(nx):
        for j in range(ny):
            corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            inside = [value[a][b] < 0 for a, b in corners]
            leaving = [k for k in range(4) if inside[k] and not inside[(k + 1) % 4]]
            for k in leaving:  # the inside ends at one edge of the cell and begins at another
                m = k
                while inside[m % 4] or not inside[(m + 1) % 4]:
                    m += 1
                end, end_point = cut(corners[k], corners[(k + 1) % 4])
                start, start_point = cut(corners[(m + 1) % 4], corners[m % 4])
                after[end] = (end_point, start)
    rings = []
    while after:
        name = next(iter(after))
        ring = []
        while name in after:
            point, name = after.pop(name)
            ring.append(point)
        rings.append(ring)
    return rings


def area(ring):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1])) / 2


def resample(ring, spacing):
    """About equal steps along the ring, rounded to the grid of the decimals."""
    lengths = [math.dist(a, b) for a, b in zip(ring, ring[1:] + ring[:1])]
    count = max(8, round(sum(lengths) / spacing))
    stride = sum(lengths) / count
    result, walked, due = [], 0.0, 0.0
    for a, b, length in zip(ring, ring[1:] + ring[:1], lengths):
        while due < walked + length and len(result) < count:
            t = (due - walked) / length
            point = tuple(round(p + t * (q - p), DECIMALS) for p, q in zip(a, b))
            if not result or point != result[-1]:
                result.append(point)
            due += stride
        walked += length
    return result


def simple(rings):
    """Whether no two edges meet but where they follow each other. Exact: integers throughout."""
    scale = 10 ** DECIMALS
    edges = []
    for ring in rings:
        points = [(round(x * scale), round(y * scale)) for x, y in ring]
        edges += [(a, b) for a, b in zip(points, points[1:] + points[:1])]
    side = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    edges.sort(key=lambda e: min(e[0][0], e[1][0]))
    for i, (a, b) in enumerate(edges):
        for c, d in edges[i + 1:]:
            if min(c[0], d[0]) > max(a[0], b[0]):
                break
            if a in (c, d) or b in (c, d):
                continue
            if side(a, b, c) * side(a, b, d) <= 0 and side(c, d, a) * side(c, d, b) <= 0:
                return False
    return True


def coral():
    rng = random.Random(18)
    points, edges = net(rng, 18)
    rings = contours(limbs(rng, points, edges), 0.8)
    rings = sorted(rings, key=area)[:18] + [max(rings, key=area)]  # tiny gaps between limbs go
    total = sum(math.dist(a, b) for r in rings for a, b in zip(r, r[1:] + r[:1]))
    rings = [resample(r, total / 1800) for r in rings]
    rings.sort(key=area, reverse=True)
    assert simple(rings)
    return rings


def star(arms, outer, inner, turn):
    ring = []
    for k in range(2 * arms):
        angle, radius = turn + math.pi * k / arms, inner if k % 2 else outer
        ring.append((round(radius * math.cos(angle), 3), round(radius * math.sin(angle), 3)))
    return [ring]


def disc(corners, radius):
    return [[(round(radius * math.cos(2 * math.pi * k / corners), 4),
              round(radius * math.sin(2 * math.pi * k / corners), 4)) for k in range(corners)]]


def wkt(rings):
    def text(ring):
        return "(" + ", ".join(f"{x:g} {y:g}" for x, y in ring + ring[:1]) + ")"
    return "POLYGON (" + ",\n".join(text(r) for r in rings) + ")\n"


def main():
    folder = pathlib.Path(sys.argv[1])
    shapes = {"coral": coral(), "disc32": disc(32, 3), "star": star(9, 10, 2.5, 0.1),
              "star_turned": star(9, 10, 2.5, 0.17)}
    for name, rings in shapes.items():
        (folder / f"{name}.wkt").write_text(wkt(rings))
        print(f"{name}.wkt: {sum(map(len, rings))} vertices, {len(rings) - 1} holes")


main()
