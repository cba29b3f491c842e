#!/usr/bin/env python3
"""Turns the JSON of minksum_bench into docs/benchmarks.md and its pictures.

usage: report.py BENCH.json... DOCS_FOLDER     writes DOCS_FOLDER/benchmarks.md and img/bench-*.svg
       report.py --summary BENCH.json...       prints the goals and whether they hold, no more

Several files may hold different sets. If two files have the same pair, the later one counts.
"""
import json
import pathlib
import statistics
import sys
import textwrap

import plots
from claims import claims, table_ratio
from figures import (MIB, MODELS, STAGES, Records, bound_text, count_text, dig, family_rows,
                     geometric_mean, growth, matrix, own_seconds, peer_cell, ratio, ratio_or_bound,
                     seconds_text, segments, table, times_text)
from unseen import threads_section, unseen_section

INTRODUCTION = """\
# How fast is it beside its peers?

    make bench      # measures everything anew and writes this page and its pictures

Do not edit this page: `bench/report.py` makes it from `build/bench.json`.

{machine}

## What does each figure contain?

- **minksum**: the processor time of the whole call, from parsed operands in memory to the exact,
  canonical region in memory. The checks of the operands are included; reading and writing are not.
  One thread computes, and memory is reused from call to call. The figure is the median of many
  runs.
- **CGAL**: `Minkowski_sum_by_reduced_convolution_2` (the *reduced convolution*), the fastest exact
  peer, and `minkowski_sum_by_full_convolution_2`. The kernel has exact constructions, and CGAL's
  own checks are switched off. Operands are converted beforehand, from doubles, which is CGAL's fast
  case. The figure is the call alone: operands are not checked, the result stays lazy, and its
  destruction is not counted. Holes that cannot matter are left out beforehand, untimed.
- **Comparison**: before a pair is timed, minksum's result is compared with CGAL's for the same
  decimals, exactly, vertex by vertex. Where they differ, or where CGAL did not end, the table says
  so and CGAL is not timed.
- **Turns**: both run in one process on the same operands, a block of runs of the one, then a block
  of the other. Blocks are equally long where runs are short. *Times* is the median of the peer's
  runs, divided by the median of minksum's runs between them.
- **Clipper** 6 (`MinkowskiSum`) sums the *boundaries* only, on rounded integers. That is less than
  the region's sum. It is tried where the operands have at most 100,000 pairs of edges.
- **GEOS** (`GEOSBuffer`, 8 segments a quarter) rounds corners with arcs that begin at each edge's
  own normal, in doubles. Its result is near to the sum with a 32-gon, not equal to it.
- **Listing** writes down the reduced convolution with plain code (`bench/list_convolution.cpp`).
  The code sorts edges by direction (radix sort, ties exactly), merges both orders and writes each
  segment: two points of 32-bit integers, 16 bytes. Its operands are integers without straight
  vertices, oriented, and with the holes that matter; all of that is untimed. It keeps no origins.
  So listing is a lower limit for every method that looks at each segment.
- **Listing by the library** is the time of the library's stages *operands* and *convolution*, from
  the same operands as a sum, checks included.
- **Memory** is `ru_maxrss` of a process that reads two files and sums them once.
- **Given up**: a peer is given up where one sum takes more than {peer_seconds:.0f} s or 8 GiB. For
  full convolutions the limit is {full_seconds:.0f} s. For star5 it is 180 s and for spiky stars of
  200 it is 240 s, both with 16 GiB. *Over* before a figure means that the peer was given up, so the
  figure is a lower bound.
"""

FIG5 = """\
The paper's Fig. 5 has eleven models of 24 to 1,204 vertices. **Eight of them were not to be had**:
four grates, the airplane, the dog and two hands. Stand-ins with the same numbers of vertices take
their places, so single figures of those pairs are not the paper's. Three of the authors' files are
used as published: bird (275 vertices), mammoth (403) and monkey (1,204).

Neuron (1,815 vertices, 18 holes) is the model of the paper's Fig. 1. All pairs of the twelve make
78. Three further models of the same authors (heron, taiwan, texas) are measured beside them and
stay out of the mean.
"""


def run_text(run):
    quick = " A *quick* run: few pairs, few repeats." if run.get("quick") else ""
    return (f"{run['date']}, load when it began {run['load_at_start']:.1f}, "
            f"{run['seconds'] / 60:.0f} minutes.{quick}")


def machine_text(runs):
    run = runs[0]
    peers = ", ".join(p for p in run["peers"].values() if p) or "no peers"
    return (f"{run['processor']}, {run['processors']} processors, "
            f"{run['memory_bytes'] / 2**30:.0f} GiB; {run['system']}; {run['compiler']}, "
            f"{run['build_type']} (`{run['flags']}`); minksum {run['minksum']}, {peers}. Measured: "
            + " ".join(map(run_text, runs)))


def claims_table(records):
    return table(["goal", "", "figure", ""],
                 [[c.number, c.text, c.figure, f"**{c.verdict}**" if c.holds is False
                   else c.verdict] for c in claims(records)])


def shortfalls(records):
    """Returns for each missed goal what decided it, and where its time goes."""
    rows = []
    for claim in claims(records):
        for r in claim.records if claim.holds is False else []:
            stages = dig(r, "minksum_alone", "stages")
            if stages:
                total = sum(stages[s] for s in STAGES) or 1
                rows.append([claim.number, r["name"], seconds_text(own_seconds(r)),
                             dig(r, "bits")] + [f"{100 * stages[s] / total:.0f} %" for s in STAGES])
    unique = [row for i, row in enumerate(rows) if row not in rows[:i]]
    if not unique:
        return ""
    return ("### Where does the time go where a goal is missed?\n\nThe table has the pairs that "
            "are furthest from each goal. Small operands skip the stages; their shares are "
            "those that the stages would have.\n\n"
            + table(["goal", "pair", "time", "bits"] + STAGES, unique))


def failure_text(record):
    if record.get("equal_to_cgal") is False:
        return "differs from CGAL's: not timed"
    return "; ".join(f"{k}: {v}" for k, v in record.get("failures", {}).items()) or "–"


def pair_table(records, *sets):
    rows = []
    for r in records.of(*sets):
        if own_seconds(r) is None:
            rows.append([r["name"]] + [failure_text(r)] + [""] * 8)
            continue
        rows.append([r["name"], f"{count_text(r['p']['vertices'])}, "
                     f"{count_text(r['q']['vertices'])}", count_text(segments(r)),
                     count_text(dig(r, "counts", "crossings")),
                     count_text(r["result"]["vertices"]), seconds_text(own_seconds(r)),
                     seconds_text(dig(r, "cgal", "median")), peer_cell(r, "cgal"),
                     peer_cell(r, "clipper"), f"{r['peak_bytes'] / MIB:.1f}"])
    return table(["pair", "vertices", "segments", "crossings found", "vertices of the sum",
                  "minksum", "CGAL reduced", "times", "Clipper: times", "MiB"], rows)


def figure6(records):
    full = [ratio(r, "cgal_full") for r in records.of("figures") if ratio(r, "cgal_full")]
    span = (f"Here the factor is {times_text(min(full))} to {times_text(max(full))}, with a "
            f"geometric mean of {times_text(geometric_mean(full))} over {len(full)} pairs "
            "that CGAL finished."
            if full else "")

    def cell(set_name, peer):
        def text(p, q):
            return peer_cell(records.get(set_name, f"{p} + {q}"), peer)
        return text
    return "\n\n".join([
        "## Fig. 6: how much faster than CGAL is each pair?",
        "The paper's program is 1.01 (grate3 ⊕ monkey) to 30.8 times (bird ⊕ hand1) as fast as "
        f"CGAL's full convolution. CGAL did not end on monkey ⊕ monkey. {span} Those three pairs "
        f"have these factors here: {cell('figures', 'cgal_full')('g3', 'monkey')}, "
        f"{cell('figures', 'cgal_full')('hand1', 'bird')} and "
        f"{cell('figures', 'cgal_full')('monkey', 'monkey')}.",
        "This table has the factors against CGAL's **full** convolution:",
        matrix(MODELS[:-1], cell("figures", "cgal_full")),
        "This table has the factors against CGAL's **reduced** convolution:",
        matrix(MODELS, cell("paper", "cgal")),
        "![Speed-up of every pair](img/bench-pairs.svg)"])


def figure7a_rows(records):
    rows = []
    for r in records.of("paper"):
        stages = dig(r, "minksum_alone", "stages")
        if stages and r["p_name"] == r["q_name"]:
            total = sum(stages[s] for s in STAGES) or 1
            rows.append((r["name"], [stages[s] / total for s in STAGES]))
    return rows


def figure7a(records):
    rows = [[name] + [f"{100 * share:.0f} %" for share in shares]
            for name, shares in figure7a_rows(records)]
    return "\n\n".join([
        "## Fig. 7a: which share does each stage take?",
        "In the paper the intersection of segments dominates, and the collision test takes less "
        "than 40 %. The cover finds what is certainly inside, and the arrangement finds the "
        "crossings outside it:",
        table(["pair"] + STAGES, rows), "![Share of each stage](img/bench-stages.svg)"])


def crossing_counts(record):
    return (dig(record, "counts", "crossings"), dig(record, "counts_no_cover", "crossings"),
            dig(record, "counts_full", "crossings"))


def figure7b(records):
    rows, fewer = [], []
    for r in records.of("figures"):
        if own_seconds(r) is None:
            continue
        cover, reduced, full = crossing_counts(r)
        part = full / reduced if full and reduced else None
        if part:
            fewer.append(part)
        rows.append([r["name"], count_text(segments(r)),
                     count_text(dig(r, "counts_full", "convolution_segments")),
                     count_text(cover), count_text(reduced),
                     count_text(full) if full else dig(r, "failures", "counts_full") or "–",
                     times_text(part)])
    span = (f"Here it has {times_text(min(fewer))} to {times_text(max(fewer))} times fewer."
            if fewer else "")
    return "\n\n".join([
        "## Fig. 7b: how many crossings has each convolution?",
        "In the paper the reduced convolution has 1.4 times (774 and 1,087) to 314.7 times (29,411 "
        f"and 9,255,477) fewer crossings than the full one. {span} minksum finds only the "
        "crossings outside its cover.",
        table(["pair", "segments, reduced", "segments, full", "crossings outside the cover",
               "crossings, reduced", "crossings, full", "full / reduced"], rows),
        "![Crossings](img/bench-crossings.svg)"])


def figure1(records):
    r = records.get("named", "neuron + 32-gon")
    if own_seconds(r) is None:
        return ""
    return ("## Fig. 1: how long does the paper's large model take?\n\nThe model has 1,815 "
            "vertices and 18 holes, and is added to a circle of 32 corners. The paper takes 0.3 s "
            f"(2.13 GHz, 2011). minksum takes {seconds_text(own_seconds(r))}, and CGAL's "
            f"reduced convolution {seconds_text(dig(r, 'cgal', 'median'))}.")


def family_section(records):
    summary, parts = [], []
    for name, note, members in family_rows(records):
        exponents = [growth(members, own_seconds),
                     growth(members, lambda r: dig(r, "result", "vertices")),
                     growth(members, segments)]
        summary.append([name, note, f"{members[0]['n']:,} to {members[-1]['n']:,}"] +
                       ["–" if e is None else f"{e:.2f}" for e in exponents])
        rows = [[count_text(r["n"]), count_text(r["q"]["vertices"]), count_text(segments(r)),
                 count_text(r["result"]["vertices"]), seconds_text(own_seconds(r)),
                 seconds_text(dig(r, "listing", "median")),
                 seconds_text(dig(r, "cgal", "median")), peer_cell(r, "cgal"),
                 f"{r['peak_bytes'] / MIB:.0f}"] for r in members]
        parts.append(f"<details><summary>{name}</summary>\n\n" + table(
            ["n", "vertices of Q", "segments", "vertices of the sum", "minksum", "listing",
             "CGAL reduced", "times", "MiB"], rows) + "\n\n</details>")
    return "\n\n".join([
        "## How does the time grow with size?",
        "n is about the number of vertices of P. Each n is twice the one before it. Exponents are "
        "slopes of the best lines through the logarithms, over the larger half of the sizes (four "
        "at least). A family ends where a sum takes a second.",
        "![Families](img/bench-families.svg)",
        table(["family", "P ⊕ Q", "n", "time: exponent", "output: exponent",
               "segments: exponent"], summary)] + parts)


def tables_section(records):
    rows = []
    for r in records.of("tables"):
        one, both = (dig(r, "table", kind, "median") for kind in ("one_thread", "all_threads"))
        rows.append([r["name"], r["parts"], count_text(r["sums"]), seconds_text(one),
                     seconds_text(both), f"{r['sums'] / one:,.0f}" if one else "–",
                     seconds_text(dig(r, "cgal", "mean")),
                     f"{dig(r, 'cgal', 'equal')} of {dig(r, 'cgal', 'sums')}",
                     times_text(table_ratio(r, "one_thread")),
                     times_text(table_ratio(r, "all_threads"))])
    return "\n\n".join([
        "## How long do tables of no-fit polygons take?",
        "A table has all ordered pairs of an instance's parts, the second one turned by 0, 90, 180 "
        "and 270 degrees. A `NoFitTable` of the parts as read computes only about half of these "
        "sums, and turns them for the other entries. The figure is the wall clock for the table "
        "and for all entries taken from it.",
        "CGAL takes a sample of the table's sums, each compared exactly first, in turn with the "
        "table. *Times* is CGAL's mean times the number of sums, divided by the table's time. The "
        "table runs on one thread and on all processors, and CGAL's sums run on one.",
        table(["instance", "parts", "sums", "one thread", "all processors", "sums a second",
               "CGAL: mean of one sum", "equal", "times, one thread", "times, all"], rows)])


def gis_section(records):
    rows = []
    for r in records.of("gis"):
        if own_seconds(r) is None:
            rows.append([r["name"], "", failure_text(r), "", "", "", ""])
            continue
        value, bound = ratio_or_bound(r, "geos")
        area, other = r.get("result_area"), dig(r, "geos", "result_area")
        rows.append([r["name"], count_text(r["p"]["vertices"]), seconds_text(own_seconds(r)),
                     seconds_text(dig(r, "geos", "median")) if not bound else "given up",
                     bound_text(value, bound), peer_cell(r, "cgal"),
                     f"{100 * (other / area - 1):+.2f} %" if area and other else "–"])
    return "\n\n".join([
        "## How fast are offsets of outlines, beside GEOS?",
        "Coordinates are in degrees, and a degree is taken as 111.32 km. The last column tells by "
        "how much GEOS's area differs, because its arcs have corners elsewhere.",
        table(["outline", "vertices", "minksum", "GEOS", "times", "CGAL: times",
               "GEOS's area"], rows)])


def outlines_section(records):
    rows, summary = [], []
    measured = [r for r in records.of("outlines") if dig(r, "geos", "ratio")]
    for r in measured:
        rows.append([r["name"], count_text(r["vertices"]), count_text(r["result_vertices"]),
                     count_text(r["decisions"]), seconds_text(own_seconds(r)),
                     seconds_text(dig(r, "geos", "median")), times_text(dig(r, "geos", "ratio")),
                     times_text(dig(r, "geos", "ratio_reusing"))])
    for distance in sorted({r["distance"] for r in measured}):
        for kind, name in (("ratio", "as called"), ("ratio_reusing", "memory reused")):
            found = sorted(r["geos"][kind] for r in measured if r["distance"] == distance)
            summary.append([f"{distance:g}", name, len(found),
                            f"{statistics.geometric_mean(found):.2f}",
                            f"{found[len(found) // 20]:.2f}", f"{found[0]:.2f}"])
    if not rows:
        return ""
    return "\n\n".join([
        "## How fast is `offset`, beside GEOS?",
        "`offset` makes round joins of its default tolerance. GEOS's buffer has as many segments "
        "a quarter as that disc. Both read operands in memory; ours is exact, validates them, and "
        "takes decimals. Calls alternate. *Memory reused* means calls with one `Workspace` "
        "(`Options::memory`). Distances are in degrees.",
        table(["distance", "calls", "outlines", "times: geometric mean", "5 %", "least"],
              summary),
        "<details><summary>Each outline</summary>",
        table(["outline, distance", "vertices", "vertices of the result", "decisions", "minksum",
               "GEOS", "times", "times, memory reused"], rows),
        "</details>"])


def doubles_section(records):
    rows = [[r["name"], r["decimals"]["bits"], r["doubles"]["bits"],
             seconds_text(r["decimals"]["median"]), seconds_text(r["doubles"]["median"]),
             f"{r['ratio']:.2f}"] for r in records.of("doubles") if "ratio" in r]
    return "\n\n".join([
        "## What do doubles cost, beside decimals?",
        "Models are turned by one radian. Each pair is summed twice: in the doubles that come out, "
        "and in the decimals of six digits nearest to these.",
        table(["pair", "bits, decimals", "bits, doubles", "decimals", "doubles",
               "doubles / decimals"], rows)])


def write_pictures(records, folder):
    folder.mkdir(parents=True, exist_ok=True)
    series = []
    for name, _, members in family_rows(records):
        lines = {"minksum": [(r["n"], own_seconds(r)) for r in members],
                 "CGAL": [(r["n"], r["cgal"]["median"]) for r in members if ratio(r)]}
        slope = growth(members, own_seconds)
        series.append((name, f"time ~ n^{slope:.2f}" if slope else "", lines))
    figures = [(segments(r), *crossing_counts(r)) for r in records.of("figures") if own_seconds(r)]
    pictures = {
        "families": plots.families(series),
        "pairs": plots.pairs([(segments(r), ratio(r)) for r in records.of("paper") if ratio(r)],
                             100, 30),
        "crossings": plots.crossings(figures),
        "stages": plots.stages(figure7a_rows(records), STAGES)}
    for name, text in pictures.items():
        if text:
            (folder / f"bench-{name}.svg").write_text(text)


def wrapped(text):
    """Wraps paragraphs at 100 columns; headings, tables, lists and HTML stay as they are."""
    return "\n\n".join(
        part if part.startswith(("#", "|", "<", "!", "-", " "))
        else textwrap.fill(part, 100, break_on_hyphens=False, break_long_words=False)
        for part in text.split("\n\n"))


def page(records):
    run = records.runs[0]
    parts = [INTRODUCTION.format(machine=machine_text(records.runs),
                                 peer_seconds=run["peer_seconds"],
                                 full_seconds=run["full_seconds"]),
             unseen_section(records), threads_section(records),
             "## Which goals hold?", claims_table(records), shortfalls(records),
             "## Which models are measured?", FIG5, figure1(records),
             figure6(records), figure7a(records), figure7b(records), family_section(records),
             tables_section(records), gis_section(records), outlines_section(records),
             doubles_section(records),
             "## What does each pair take?", "This table has the named pairs and the spiky stars:",
             pair_table(records, "named", "spiky"),
             "<details><summary>The paper's models</summary>\n",
             pair_table(records, "paper"), "</details>\n",
             "<details><summary>Their kin</summary>\n", pair_table(records, "kin"), "</details>\n",
             "<details><summary>Nesting parts, P ⊕ −Q</summary>\n",
             pair_table(records, "nesting"), "</details>"]
    return wrapped("\n\n".join(p.rstrip("\n") for p in parts if p)) + "\n"


def main(words):
    summary = words[:1] == ["--summary"]
    files, docs = (words[1:], None) if summary else (words[:-1], pathlib.Path((words or [""])[-1]))
    if not files:
        sys.exit(__doc__)
    records = Records([json.loads(pathlib.Path(file).read_text()) for file in files])
    for claim in claims(records):
        print(f"{claim.number}  {claim.verdict:<12}  {claim.text}: {claim.figure}")
    if not summary:
        write_pictures(records, docs / "img")
        (docs / "benchmarks.md").write_text(page(records))
        print(f"written: {docs / 'benchmarks.md'}")


if __name__ == "__main__":
    main(sys.argv[1:])
