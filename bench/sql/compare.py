#!/usr/bin/env python3
"""Compares the extensions with SFCGAL's ST_MinkowskiSum and with ST_Buffer, in one server.

    tests/sql/run.sh BUILD build/minksum ../../bench/sql/compare.py

MINKSUM_DATA names a folder with collections, of which `gis` is used. MINKSUM_PARTS chooses from
`sums openings buffers`; buffers of large files by ST_Buffer take many minutes. Times are those of queries, and
only ratios of one run mean something. It prints Markdown.
"""
import math
import os
import pathlib
import random
import statistics
import subprocess
import time

PSQL = ["psql", "-X", "-A", "-t", "-q", "-v", "ON_ERROR_STOP=1", "minksum_bench"]
PARALLEL = ("SET parallel_setup_cost = 0; SET parallel_tuple_cost = 0; "
            "SET min_parallel_table_scan_size = 0; SET max_parallel_workers_per_gather = {}; ")


def ask(text):
    return subprocess.run(PSQL, input=text, capture_output=True, text=True,
                          check=True).stdout.strip()


def seconds(text, runs=3):
    """Returns the median time of a query as the server sees it."""
    times = []
    for _ in range(runs):
        begin = time.monotonic()
        ask(text)
        times.append(time.monotonic() - begin)
    return statistics.median(times)


def star(source, corners, radius, cx=0.0, low=0.4):
    """Returns a ring around (cx, 0), whose corners have random distances."""
    ring = []
    for i in range(corners):
        angle = 2 * math.pi * i / corners
        reach = radius * source.uniform(low, 1)
        ring.append((round(cx + reach * math.cos(angle), 3), round(reach * math.sin(angle), 3)))
    return ring


def wkt(rings):
    return "POLYGON (" + ", ".join(
        "(" + ", ".join(f"{x} {y}" for x, y in [*ring, ring[0]]) + ")" for ring in rings) + ")"


def shape(source, radius, holes):
    # With 8 corners of at least 0.75, edges stay farther away than 0.6, which no hole reaches.
    rings = [star(source, source.randint(8, 30), radius, low=0.75 if holes else 0.4)]
    for i in range(holes):
        centre = 0 if holes == 1 else (0.8 * i - 0.4) * radius
        rings.append(star(source, source.randint(4, 8), radius * (0.5 if holes == 1 else 0.2),
                          centre))
    return wkt(rings)


def make_pairs(count):
    """Makes pairs of four kinds: no holes, two in the first, one in the second, and both.

    Every other second operand is so large that the first one fits into its hole.
    """
    source = random.Random(1)
    rows = []
    for i in range(count):
        large = i // 4 % 2 == 1
        first = shape(source, 2 if large else 10, 2 if i % 4 & 1 else 0)
        second = shape(source, 12 if large else 1, 1 if i % 4 & 2 else 0)
        # SFCGAL refuses holes that go the same way round as their outer ring.
        a, b = (f"ST_ForcePolygonCCW('{text}'::geometry)" for text in (first, second))
        rows.append(f"({i}, {a}, {b})")
    ask("CREATE TABLE pairs (id int, a geometry, b geometry); INSERT INTO pairs VALUES "
        + ", ".join(rows))


def compare_sums():
    make_pairs(1000)
    ask("""CREATE FUNCTION peer(a geometry, b geometry) RETURNS geometry LANGUAGE plpgsql AS $$
        BEGIN RETURN ST_Force2D(ST_MinkowskiSum(a, b)); EXCEPTION WHEN OTHERS THEN RETURN NULL;
        END $$;
        CREATE TABLE sums AS SELECT id, a, b, mink_sum(a, b) AS ours, peer(a, b) AS peers
        FROM pairs;
        CREATE TABLE differences AS SELECT id, a, b, ours, peers, extra, missing FROM sums,
          LATERAL (SELECT ST_Difference(ST_MakeValid(peers), ours) AS extra,
                          ST_Difference(ours, ST_MakeValid(peers)) AS missing) AS d
          WHERE ST_Area(extra) > 1e-6 OR ST_Area(missing) > 1e-6;""")
    ours = seconds("SELECT count(mink_sum(a, b)) FROM pairs")
    peers = seconds("SELECT count(peer(a, b)) FROM pairs", 1)
    # Coordinates of both results are rounded in different ways, so nearly all differ by slivers.
    print("## Sums beside SFCGAL\n\n| holes in | pairs | differ by an area above 1e-6 | "
          "SFCGAL wrong | minksum wrong | SFCGAL failed |\n|---|---|---|---|---|---|")
    # A point x is in the sum if and only if a meets x - b, which GEOS decides.
    print(ask("""
        WITH witness AS (SELECT id, a, b, ours, peers, ST_PointOnSurface(
            CASE WHEN ST_Area(extra) > ST_Area(missing) THEN extra ELSE missing END) AS x
          FROM differences),
        judged AS (SELECT id, ST_Intersects(ours, x) AS in_ours,
            ST_Intersects(ST_MakeValid(peers), x) AS in_peers,
            ST_Intersects(a, ST_Translate(ST_Scale(b, -1, -1), ST_X(x), ST_Y(x))) AS truly
          FROM witness)
        SELECT '| ' || (ARRAY['neither', 'the first', 'the second', 'both'])[s.id % 4 + 1] || ' | '
          || count(*) || ' | ' || count(j.id) || ' | '
          || count(*) FILTER (WHERE in_peers <> truly) || ' | '
          || count(*) FILTER (WHERE in_ours <> truly) || ' | '
          || count(*) FILTER (WHERE peers IS NULL) || ' |'
        FROM sums AS s LEFT JOIN judged AS j USING (id) GROUP BY s.id % 4 ORDER BY s.id % 4"""))
    print(f"\nSFCGAL takes {peers / ours:.0f} times as long ({peers:.2f} s, {ours:.2f} s).\n")


def compare_buffers():
    folder = pathlib.Path(os.environ.get("MINKSUM_DATA", "")) / "gis"
    files = sorted(folder.glob("*.wkt")) if os.environ.get("MINKSUM_DATA") else []
    ask("CREATE TABLE shapes (name text, g geometry)")
    for file in files:
        ask(f"INSERT INTO shapes VALUES ('{file.stem}', $${file.read_text()}$$::geometry)")
    print(f"## Buffers of {len(files)} files\n\n| distance / width | minksum s | ST_Buffer s | "
          "minksum, error at most | ST_Buffer, farthest from that | ST_Buffer invalid |\n"
          "|---|---|---|---|---|---|")
    # ST_Buffer has 8 segments a quarter, whose middles are this part of the distance too near.
    slack = 1 - math.cos(math.pi / 32)
    for part in (0.0001, 0.001, 0.01):
        size = f"((ST_XMax(g) - ST_XMin(g)) * {part})"
        ours = f"mink_offset(g, {size}, tolerance => {size} * {slack})"
        peers = f"ST_Buffer(g, {size})"
        ours_s = seconds(f"SELECT sum(ST_NPoints({ours})) FROM shapes", 1)
        peers_s = seconds(f"SELECT sum(ST_NPoints({peers})) FROM shapes", 1)
        # A corner of the one that is in a hole of the other shows in the share of areas.
        rest = ask(f"""SELECT max(ST_Area(ST_SymDifference(p, o)) / ST_Perimeter(o) / d),
              count(*) FILTER (WHERE NOT ST_IsValid(p)) FROM (SELECT {peers} AS p, {ours} AS o,
              {size} AS d FROM shapes) AS s""").split("|")
        print(f"| {part} | {ours_s:.2f} | {peers_s:.2f} | {slack:.4f} of the distance | "
              f"{float(rest[0] or 0):.4f} of the distance, on average | {rest[1]} |", flush=True)
    print()


def compare_openings(count=100_000):
    source = random.Random(2)
    rows = "\n".join(f"{i}\t{wkt([star(source, source.randint(6, 20), 10)])}" for i in range(count))
    subprocess.run([*PSQL, "-c", "CREATE TABLE land (id int, g geometry)", "-c",
                    "COPY land FROM STDIN"], input=rows, text=True, check=True)
    ask("ALTER TABLE land SET (parallel_workers = 2); ANALYZE land")
    octagon = wkt([[(round(1.5 * math.cos(math.pi * k / 4), 6),
                     round(1.5 * math.sin(math.pi * k / 4), 6)) for k in range(8)]])
    print("## Openings of 100,000 polygons by an octagon\n\n| | processes | rows a second |\n"
          "|---|---|---|")
    queries = [("mink_open(g, octagon)", f"mink_open(g, '{octagon}'::geometry)"),
               ("ST_Buffer(ST_Buffer(g, -1.5, 2), 1.5, 2)",
                "ST_Buffer(ST_Buffer(g, -1.5, 2), 1.5, 2)")]
    for name, call in queries:
        for workers in (0, 2):
            taken = seconds(PARALLEL.format(workers) + f"SELECT sum(ST_NPoints({call})) FROM land",
                            1)
            print(f"| `{name}` | {workers + 1} | {count / taken:.0f} |", flush=True)


def main():
    subprocess.run(["createdb", "minksum_bench"], check=True)
    ask("CREATE EXTENSION postgis; CREATE EXTENSION postgis_sfcgal; CREATE EXTENSION minksum; "
        "CREATE EXTENSION minksum_postgis")
    parts = {"sums": compare_sums, "openings": compare_openings, "buffers": compare_buffers}
    for name in os.environ.get("MINKSUM_PARTS", " ".join(parts)).split():
        parts[name]()


if __name__ == "__main__":
    main()
