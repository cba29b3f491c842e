#!/usr/bin/env python3
"""Turns the JSON of minksum_bench into docs/benchmarks.md and its pictures.

usage: report.py BENCH.json DOCS_FOLDER     writes DOCS_FOLDER/benchmarks.md and img/bench-*.svg
       report.py --summary BENCH.json       prints the goals and whether they hold, no more
"""
import json
import pathlib
import sys

import plots
from claims import claims, offset_ratio
from figures import (MIB, MODELS, STAGES, Records, count_text, dig, family_rows, geometric_mean,
                     growth, matrix, own_seconds, ratio, seconds_text, segments, table, times_text)

INTRODUCTION = """\
# Benchmarks

Made by `make bench` (`bench/`), which writes `build/bench.json` and from it this page and its pictures. Do not edit.

{machine}

What each figure contains:

- **minksum**: `Statistics.seconds`, the whole call: from parsed operands in memory to the exact, canonical region in memory, checks of
  the operands included; one thread, memory reused from call to call. Median of many runs.
- **CGAL**: `Minkowski_sum_by_reduced_convolution_2` (the *reduced convolution*: the fastest exact peer) and `minkowski_sum_by_full_convolution_2`, kernel
  with exact constructions, its own checks switched off, operands made from doubles (its fast case), converted beforehand; the call and its
  result's destruction. Holes that cannot matter are left out beforehand, untimed.
- Both run *in turn in one process*, on the same operands; before that, minksum's result and CGAL's for the same numbers are compared
  *exactly*. Where they differ nothing is timed, and the table says so. *Times* is the median of CGAL's runs by the median of minksum's.
- **Clipper** 6 (`MinkowskiSum`) sums the *boundaries* only, on rounded integers: less than the region's sum. Tried where the operands have
  at most 100,000 pairs of edges.
- **GEOS** (`GEOSBuffer`, 8 segments a quarter) rounds corners with arcs that begin at each edge's own normal, in doubles: near to the sum with a 32-gon, not equal to it.
- **Listing** the reduced convolution: plain code that sorts edges by direction and writes down each segment (16 bytes) in the fastest
  arithmetic, sorting included: what a method must pay that looks at every segment.
- Memory: `ru_maxrss` of a process that reads two files and sums them once.
- A peer is given up where one sum takes more than {peer_seconds:.0f} s or 8 GiB (spiky stars of 200: 240 s, 16 GiB).
"""

FIG5 = """\
The paper's Fig. 5 has eleven models of 24 to 1,204 vertices. Three of the authors' files are used as published (bird 275, mammoth 403, monkey
1,204 vertices); for the other eight (four grates, airplane, dog, two hands) the files were not to be had, and stand-ins with the same numbers of vertices take their places, so
single figures of those pairs are not the paper's. Neuron (1,815 vertices, 18 holes) is the model of the paper's Fig. 1. All pairs of the twelve make 78. Three further models of the same authors (heron, taiwan, texas) are measured
beside them and stay out of the mean.
"""


def machine_text(run):
    peers = ", ".join(p for p in run["peers"].values() if p) or "no peers"
    quick = " A *quick* run: few pairs, few repeats." if run.get("quick") else ""
    return (f"{run['date']}; {run['processor']}, {run['processors']} processors, "
            f"{run['memory_bytes'] / 2**30:.0f} GiB; {run['system']}; {run['compiler']}, "
            f"{run['build_type']} (`{run['flags']}`); minksum {run['minksum']}, {peers}. "
            f"Load when it began: {run['load_at_start']:.1f}; it took "
            f"{run['seconds'] / 60:.0f} minutes.{quick}")


def claims_table(records):
    return table(["goal", "", "figure", ""],
                 [[c.number, c.text, c.figure, f"**{c.verdict}**" if c.holds is False
                   else c.verdict] for c in claims(records)])


def peer_cell(record, peer):
    value = ratio(record, peer)
    if value:
        return times_text(value)
    if record is not None and record.get("equal_to_cgal") is False and peer == "cgal":
        return "differs"
    return dig(record, "failures", peer) or "–"


def pair_table(records, *sets):
    rows = []
    for r in records.of(*sets):
        if own_seconds(r) is None:
            rows.append([r["name"]] + [dig(r, "failures", "minksum") or "–"] + [""] * 8)
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
        "The paper: 1.01 to 30.8 times as fast as CGAL's full convolution; monkey ⊕ monkey did "
        f"not end. {span}",
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
        f"The paper: 1.4 to 314.7 times fewer in the reduced one. {span} Of these minksum finds "
        "only those outside its cover.",
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


def gis_section(records):
    rows = []
    for r in records.of("gis"):
        if own_seconds(r) is None:
            rows.append([r["name"], "", dig(r, "failures", "minksum") or "–", "", "", "", ""])
            continue
        value, bound = offset_ratio(r, records)
        area, other = r.get("result_area"), dig(r, "geos", "result_area")
        rows.append([r["name"], count_text(r["p"]["vertices"]), seconds_text(own_seconds(r)),
                     seconds_text(dig(r, "geos", "median")) if not bound else "given up",
                     ("over " if bound else "") + times_text(value), peer_cell(r, "cgal"),
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
    parts = [INTRODUCTION.format(machine=machine_text(records.run),
                                 peer_seconds=records.run["peer_seconds"]),
             "## Goals", claims_table(records), "## The models", FIG5, figure1(records),
             figure6(records), figure7a(records), figure7b(records), family_section(records),
             gis_section(records), doubles_section(records), "## Pairs",
             "Named pairs and spiky stars:", pair_table(records, "named", "spiky"),
             "<details><summary>The paper's models</summary>\n",
             pair_table(records, "paper"), "</details>\n",
             "<details><summary>Their kin</summary>\n", pair_table(records, "kin"), "</details>\n",
             "<details><summary>Nesting parts, P ⊕ −Q</summary>\n",
             pair_table(records, "nesting"), "</details>"]
    return "\n\n".join(p.rstrip("\n") for p in parts if p) + "\n"


def main(words):
    summary = words[:1] == ["--summary"]
    if len(words) != 2:
        sys.exit(__doc__)
    records = Records(json.loads(pathlib.Path(words[1 if summary else 0]).read_text()))
    for claim in claims(records):
        print(f"{claim.number}  {claim.verdict:<12}  {claim.text}: {claim.figure}")
    if not summary:
        docs = pathlib.Path(words[1])
        write_pictures(records, docs / "img")
        (docs / "benchmarks.md").write_text(page(records))
        print(f"written: {docs / 'benchmarks.md'}")


if __name__ == "__main__":
    main(sys.argv[1:])
