#!/usr/bin/env python3
"""Measures how late a query ends after statement_timeout, for each function.

    tests/sql/run.sh BUILD build/minksum ../../bench/sql/interrupts.py

Each query would take far longer than any of the timeouts, which fall into its different phases. It
prints Markdown: the latest end after its timeout by the clock, and of how many queries.
"""
import os
import subprocess
import time

DATABASE = "minksum_interrupts"
PSQL = ["psql", "-X", "-A", "-t", "-q", "-v", "VERBOSITY=verbose", DATABASE]
# Thousands of discs that overlap, and some of them as one resolved set.
TABLES = """
CREATE EXTENSION postgis; CREATE EXTENSION minksum; CREATE EXTENSION minksum_postgis;
CREATE TABLE many AS SELECT ST_Collect(ST_Buffer(ST_MakePoint(x * 1.7, (x * x) % 97), 0.9, 20)) AS g
  FROM generate_series(1, 4000) AS x;
ALTER TABLE many ADD t text; UPDATE many SET t = ST_AsText(g);
CREATE TABLE parts AS SELECT array_agg(ST_Buffer(ST_MakePoint(x, x * x), 9, 2500)) AS list
  FROM generate_series(1, 30) AS x;
"""
BINARY = ["sum", "erode", "open", "close", "union", "intersection", "difference", "sym_difference",
          "no_fit_polygon", "inner_fit_polygon"]


def queries():
    for name in BINARY:
        other = "ST_Buffer('POINT (0 0)'::geometry, 0.4, 3000)" if name in (
            "erode", "open", "close", "inner_fit_polygon") else "g"
        yield name, f"SELECT length(mink_{name}(g, {other})::bytea) FROM many, generate_series(1, 99)"
    yield "resolve", "SELECT length(mink_resolve(g)::bytea) FROM many, generate_series(1, 99)"
    yield "offset", "SELECT length(mink_offset(g, -1e-3, tolerance => 1e-9)::bytea) FROM many"
    yield "disc", "SELECT length(mink_disc(r, 1e-9)) FROM generate_series(1, 99) AS r"
    yield "depth", "SELECT mink_depth(g, g) FROM many"
    yield "impact", "SELECT mink_impact(g, ST_Translate(g, 9999, 0), -1, 0) FROM many"
    yield "is_sum", "SELECT mink_is_sum(g, g, g) FROM many"
    yield "slices", "SELECT count(*) FROM many, mink_slices(g, g, 100, true)"
    yield "no_fit_table", "SELECT count(*) FROM parts, mink_no_fit_table(list, 4)"
    yield "sum_text", "SELECT length(mink_sum_text(t, t)) FROM many"
    yield "union_agg", ("SELECT length(mink_union_agg(ST_Translate(g, x, x))::bytea) "
                        "FROM many, generate_series(1, 99) AS x")
    yield "sum_agg", ("SELECT length(mink_sum_agg(ST_Buffer(ST_MakePoint(x, x * x), 9, 500))::bytea)"
                      " FROM generate_series(1, 100000) AS x")
    yield "sum_agg of many", "SELECT length(mink_sum_agg(g)::bytea) FROM many, generate_series(1, 9)"


def overshoot(query, timeout):
    """Returns by how many milliseconds a query is late. None: it ended before."""
    text = (f"\\timing on\nSET statement_timeout = {timeout};\n{query};\n")
    done = subprocess.run(PSQL, input=text, capture_output=True, text=True, check=False)
    if "57014" not in done.stderr:
        return None
    last = done.stdout.strip().split("\n")[-1]
    return float(last.split()[1]) - timeout


def main():
    subprocess.run(["createdb", DATABASE], check=True)
    subprocess.run(PSQL, input=TABLES, text=True, check=True, stdout=subprocess.DEVNULL)
    timeouts = [int(t) for t in os.environ.get("MINKSUM_TIMEOUTS", "70 150 310 620 1250").split()]
    print("| function | latest end, ms after the timeout | timeouts |\n|---|---|---|")
    begin = time.monotonic()
    for name, query in queries():
        late = [overshoot(query, timeout) for timeout in timeouts]
        met = [value for value in late if value is not None]
        print(f"| `{name}` | {max(met, default=0):.0f} | {len(met)} |", flush=True)
    print(f"\n{time.monotonic() - begin:.0f} s in all.")


if __name__ == "__main__":
    main()
