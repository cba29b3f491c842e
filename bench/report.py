#!/usr/bin/env python3
"""Turns the JSON of minksum_bench into docs/benchmarks.md and its pictures.

usage: report.py BENCH.json... DOCS_FOLDER     writes DOCS_FOLDER/benchmarks.md and img/bench-*.svg
       report.py --summary BENCH.json...       prints the goals and whether they hold, no more

Of several files each may hold other sets; where two have the same pair the later one counts.
"""
import json
import pathlib
import sys

import plots
from claims import claims, table_ratio
from figures import (MIB, MODELS, STAGES, Records, bound_text, count_text, dig, family_rows,
                     geometric_mean, growth, matrix, own_seconds, peer_cell, ratio, ratio_or_bound,
                     seconds_text, segments, table, times_text)

INTRODUCTION = """\
# Benchmarks

Made by `make bench` (`bench/`), which writes `build/bench.json` and from it this page and its pictures. Do not edit.

{machine}

What each figure contains:

- **minksum**: the wall clock of the whole call: from parsed operands in memory to the exact, canonical region in memory, checks of
  the operands included; one thread, memory reused from call to call. Median of many runs. No reading, no writing.
- **CGAL**: `Minkowski_sum_by_reduced_convolution_2` (the *reduced convolution*: the fastest exact peer) and `minkowski_sum_by_full_convolution_2`, kernel
  with exact constructions, its own checks switched off, operands made from doubles (its fast case), converted beforehand; the call
  alone. Its operands are not checked, its result stays lazy, and the destruction of that is not counted. Holes that cannot matter are left out beforehand, untimed.
- **Compared first**: before a pair is timed, minksum's result is compared with CGAL's for the same decimals, exactly, vertex by vertex. Where they differ or
  CGAL did not end, the table says so, and CGAL is not timed.
- **In turn**: both run in one process on the same operands, a block of runs of the one, then a block of the other, equally long where
  runs are short. *Times* is the median of the peer's runs by the median of minksum's between them.
- **Clipper** 6 (`MinkowskiSum`) sums the *boundaries* only, on rounded integers: less than the region's sum. Tried where the operands have
  at most 100,000 pairs of edges.
- **GEOS** (`GEOSBuffer`, 8 segments a quarter) rounds corners with arcs that begin at each edge's own normal, in doubles: near to the sum with a 32-gon, not equal to it.
- **Listing** the reduced convolution: plain code (`bench/list_convolution.cpp`) that sorts edges by direction (radix sort, ties
  exactly), merges both orders and writes down each segment: two points of 32-bit integers, 16 bytes. Operands are given to it as integers without straight
  vertices, oriented, and with the holes that matter, all of that untimed. It keeps no origins. So it is a limit below what any
  method pays that looks at every segment. Beside it stands what *the library* itself takes to list them all: its stages operands
  and convolution, from the same operands as a sum, checks included.
- Memory: `ru_maxrss` of a process that reads two files and sums them once.
- A peer is given up where one sum takes more than {peer_seconds:.0f} s ({full_seconds:.0f} s for full convolutions; 180 s for star5, 240 s for
  spiky stars of 200) or 8 GiB (16 GiB for those). *Over* before a figure means: given up, so it is a lower bound.
"""

FIG5 = """\
The paper's Fig. 5 has eleven models of 24 to 1,204 vertices. Three of the authors' files are used as published (bird 275, mammoth 403, monkey
1,204 vertices); for the other eight (four grates, airplane, dog, two hands) the files were not to be had, and stand-ins with the same numbers of vertices take their places, so
single figures of those pairs are not the paper's. Neuron (1,815 vertices, 18 holes) is the model of the paper's Fig. 1. All pairs of the twelve make 78. Three further models of the same authors (heron, taiwan, texas) are measured
beside them and stay out of the mean.
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
    """For each goal that is missed: what decided it, and where its time goes."""
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
    return ("### Where the time goes in what falls short\n\nFor each goal the pairs that are "
            "furthest from it. Small operands take none of the stages: for them, these are the "
            "shares if they did.\n\n"
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
    span = (f"Here: {times_text(min(full))} to {times_text(max(full))} times, geometric mean "
            f"{times_text(geometric_mean(full))}, over {len(full)} pairs that CGAL finished."
            if full else "")

    def cell(set_name, peer):
        def text(p, q):
            return peer_cell(records.get(set_name, f"{p} + {q}"), peer)
        return text
    return "\n\n".join([
        "## Fig. 6: speed-up over CGAL, pair by pair",
        "The paper: 1.01 (grate3 ⊕ monkey) to 30.8 times (bird ⊕ hand1) as fast as CGAL's full "
        f"convolution; CGAL did not end on monkey ⊕ monkey. {span} Those pairs here: "
        f"{cell('figures', 'cgal_full')('g3', 'monkey')}, "
        f"{cell('figures', 'cgal_full')('hand1', 'bird')} and "
        f"{cell('figures', 'cgal_full')('monkey', 'monkey')}.",
        "minksum against CGAL's **full** convolution, times as fast:",
        matrix(MODELS[:-1], cell("figures", "cgal_full")),
        "minksum against CGAL's **reduced** convolution, times as fast:",
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
        "## Fig. 7a: share of each stage",
        "The paper: the intersection of segments dominates, the collision test takes less than "
        "40 %. Here (cover: what is certainly inside; arrangement: crossings outside it):",
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
    span = (f"Here: {times_text(min(fewer))} to {times_text(max(fewer))} times fewer."
            if fewer else "")
    return "\n\n".join([
        "## Fig. 7b: crossings in the reduced and in the full convolution",
        "The paper: 1.4 (774 and 1,087) to 314.7 times (29,411 and 9,255,477) fewer in the reduced "
        f"one. {span} Of these minksum finds only those outside its cover.",
        table(["pair", "segments, reduced", "segments, full", "crossings outside the cover",
               "crossings, reduced", "crossings, full", "full / reduced"], rows),
        "![Crossings](img/bench-crossings.svg)"])


def figure1(records):
    r = records.get("named", "neuron + 32-gon")
    if own_seconds(r) is None:
        return ""
    return ("## Fig. 1\n\nA model of 1,815 vertices and 18 holes ⊕ a circle of 32 corners. The "
            f"paper: 0.3 s (2.13 GHz, 2011). Here: {seconds_text(own_seconds(r))}; CGAL's reduced "
            f"convolution: {seconds_text(dig(r, 'cgal', 'median'))}.")


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
        "## Families of doubling size",
        "n: vertices of P, about. Exponents: slopes of the best lines through the logarithms, over "
        "the larger half of the sizes (four at least). A family ends where a sum takes a second.",
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
        "## Tables of no-fit polygons",
        "All ordered pairs of an instance's parts, the second one turned by 0, 90, 180 and 270 "
        "degrees: a `NoFitTable` of the parts as read, which makes every second sum and turns it for "
        "the other, and all entries taken from it; wall clock. CGAL takes a sample of the table's "
        "sums, each compared exactly first, in turn with the table; *times*: its mean times the "
        "number of sums, by the table's time on one thread, and on all processors (CGAL's sums on "
        "one).",
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
        "## Offsets of outlines, against GEOS",
        "Coordinates in degrees, a degree taken as 111.32 km. The last column: by how much GEOS's "
        "area differs (its arcs have corners elsewhere).",
        table(["outline", "vertices", "minksum", "GEOS", "times", "CGAL: times",
               "GEOS's area"], rows)])


def doubles_section(records):
    rows = [[r["name"], r["decimals"]["bits"], r["doubles"]["bits"],
             seconds_text(r["decimals"]["median"]), seconds_text(r["doubles"]["median"]),
             f"{r['ratio']:.2f}"] for r in records.of("doubles") if "ratio" in r]
    return "\n\n".join([
        "## Doubles against decimals",
        "Models turned by one radian: as the doubles that come out, and rounded to six digits.",
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


def page(records):
    run = records.runs[0]
    parts = [INTRODUCTION.format(machine=machine_text(records.runs),
                                 peer_seconds=run["peer_seconds"],
                                 full_seconds=run["full_seconds"]),
             "## Goals", claims_table(records), shortfalls(records), "## The models", FIG5, figure1(records),
             figure6(records), figure7a(records), figure7b(records), family_section(records),
             tables_section(records), gis_section(records), doubles_section(records), "## Pairs",
             "Named pairs and spiky stars:", pair_table(records, "named", "spiky"),
             "<details><summary>The paper's models</summary>\n",
             pair_table(records, "paper"), "</details>\n",
             "<details><summary>Their kin</summary>\n", pair_table(records, "kin"), "</details>\n",
             "<details><summary>Nesting parts, P ⊕ −Q</summary>\n",
             pair_table(records, "nesting"), "</details>"]
    return "\n\n".join(p.rstrip("\n") for p in parts if p) + "\n"


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
