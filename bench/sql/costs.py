#!/usr/bin/env python3
"""Measures what a call of each function costs, in calls of int4's operator +.

    tests/sql/run.sh BUILD build/minksum ../../bench/sql/costs.py

PostgreSQL's COST 1 stands for an operator as cheap as this one. Operands are stars of 5, 20 and 80
corners, each in a row of a table, and a second one that stays the same. It prints Markdown.
"""
import math
import random
import subprocess

DATABASE = "minksum_costs"
PSQL = ["psql", "-X", "-A", "-t", "-q", "-v", "ON_ERROR_STOP=1", DATABASE]
SIZES = (5, 20, 80)
CALLS = {
    "sum": "mink_sum(g, {q})", "erode": "mink_erode(g, {q})", "open": "mink_open(g, {q})",
    "close": "mink_close(g, {q})", "union": "mink_union(g, {q})",
    "intersection": "mink_intersection(g, {q})", "difference": "mink_difference(g, {q})",
    "sym_difference": "mink_sym_difference(g, {q})", "resolve": "mink_resolve(g)",
    "offset": "mink_offset(g, 1, tolerance => 0.01)", "disc": "mink_disc(1 + id, 0.01 * (1 + id))",
    "no_fit_polygon": "mink_no_fit_polygon(g, {q})",
    "inner_fit_polygon": "mink_inner_fit_polygon(g, {q})", "depth": "mink_depth(g, {q})",
    "impact": "mink_impact(g, {q}, -30, 0)", "is_sum": "mink_is_sum(s, g, {q})",
    "slices": "(SELECT count(*) FROM mink_slices({q}, g, 4))",
    "no_fit_table": "(SELECT count(*) FROM mink_no_fit_table(ARRAY[g, {q}], 4))",
}


def ask(text):
    return subprocess.run(PSQL, input=text, capture_output=True, text=True,
                          check=True).stdout.strip()


def seconds(expression, table, rows):
    """Returns the least time of three scans of some rows, without that of empty ones."""
    def scan(what):
        plan = ask(f"EXPLAIN (ANALYZE, TIMING OFF) SELECT count({what}) "
                   f"FROM (SELECT * FROM {table} LIMIT {rows}) AS t")
        return float(plan.rsplit("Execution Time: ", 1)[1].split()[0]) / 1000
    return max(min(scan(expression) for _ in range(3)) - min(scan("id") for _ in range(3)), 0)


def star(source, corners):
    ring = []
    for i in range(corners):
        reach = 10 * source.uniform(0.4, 1)
        ring.append((round(reach * math.cos(2 * math.pi * i / corners), 3),
                     round(reach * math.sin(2 * math.pi * i / corners), 3)))
    return "POLYGON ((" + ", ".join(f"{x} {y}" for x, y in [*ring, ring[0]]) + "))"


def main():
    subprocess.run(["createdb", DATABASE], check=True)
    ask("CREATE EXTENSION postgis; CREATE EXTENSION minksum; CREATE EXTENSION minksum_postgis; "
        "CREATE TABLE numbers AS SELECT id FROM generate_series(1, 3000000) AS id; "
        "VACUUM ANALYZE numbers")
    source = random.Random(3)
    octagon = ("'POLYGON ((1.5 0, 1.06 1.06, 0 1.5, -1.06 1.06, -1.5 0, -1.06 -1.06, 0 -1.5, "
               "1.06 -1.06, 1.5 0))'::geometry")
    for size in SIZES:
        rows = ", ".join(f"({i}, '{star(source, size)}'::geometry)" for i in range(2000))
        ask(f"CREATE TABLE stars{size} (id int, g geometry, s geometry); "
            f"INSERT INTO stars{size} (id, g) VALUES {rows}; "
            f"UPDATE stars{size} SET s = mink_sum(g, {octagon}); VACUUM FULL ANALYZE stars{size}")
    # Ten additions, so that reading rows counts less.
    one = seconds(" + ".join(["id"] + ["1"] * 10), "numbers", 3000000) / 3e7
    print(f"The operator takes {one * 1e9:.1f} ns.\n")
    print("| function | " + " | ".join(f"{size} corners" for size in SIZES) + " |\n"
          + "|---" * (1 + len(SIZES)) + "|")
    for name, call in CALLS.items():
        costs = []
        for size in SIZES:
            rows = 100 if name in ("is_sum", "slices", "no_fit_table") else 500
            taken = seconds(call.format(q=octagon), f"stars{size}", rows)
            costs.append(f"{taken / rows / one:.0f}")
        print(f"| `{name}` | " + " | ".join(costs) + " |", flush=True)


if __name__ == "__main__":
    main()
