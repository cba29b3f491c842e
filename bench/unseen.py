"""Writes the section of docs/benchmarks.md on pairs that nobody tuned for."""
from figures import geometric_mean, table

ABOUT = """\
## What holds on pairs that nobody tuned for?

    build/bench/minksum_bench --set mixed --seed 1 --pairs 1000

The set `mixed` has random pairs of all valid shapes of the folder, the second scaled by 10 to the
power of a number between −2 and 2, exactly. The seed makes the pairs the same on any machine. The
set `regret` is a list of pairs of very different kinds and sizes. *Regret* is the processor time of
the automatic settings, divided by the least time of these and of fixed ones: no cover, and grids of
32, 64, … 2,048 cells. Operands are as read, so they are validated in every call.

Calls of less than 50 µs are timed in blocks, CGAL's as minksum's, because the clock itself takes
half a microsecond.
"""
CGAL = """\
CGAL is measured on those of the pairs whose operands are single polygons. Where it was given up,
the ratio is a lower bound. *Prepared* operands are validated once; operands *as read* are validated
in every call. CGAL's operands are never checked.
"""

THREADS = """\
## What do several threads gain?

    build/bench/minksum_bench --set threads

Of the pairs of both sets, those are measured whose sums take 50 ms or more on one thread. *Times*
is the least wall-clock time on one thread, divided by the least on all cores, in turn.
"""


def quantile(values, share):
    return sorted(values)[int(share * (len(values) - 1))]


def regret_row(name, values):
    over = sum(value > 1.5 for value in values)
    return [name, len(values), f"{sum(values) / len(values):.2f}", f"{quantile(values, 0.5):.2f}",
            f"{quantile(values, 0.95):.2f}", f"{max(values):.2f}", over]


def ratio_row(name, values):
    return [name, len(values), f"{geometric_mean(values):.0f}", f"{quantile(values, 0.05):.1f}",
            f"{quantile(values, 0.5):.0f}", f"{min(values):.1f}", f"{max(values):,.0f}"]


def threads_section(records):
    shared = [r for r in records.of("threads") if "seconds" in r]
    if not shared:
        return ""
    rows = [[how, len(shared), f"{geometric_mean([r[key] for r in shared]):.2f}",
             f"{quantile([r[key] for r in shared], 0.05):.2f}",
             f"{quantile([r[key] for r in shared], 0.5):.2f}",
             f"{min(r[key] for r in shared):.2f}"]
            for how, key in (("operands prepared", "times_prepared"),
                             ("operands as read", "times_as_read"))]
    return (THREADS + "\n" + table(["times as fast on all cores", "pairs", "geometric mean", "5 %",
                                    "median", "least"], rows))


def unseen_section(records):
    mixed = [r for r in records.of("mixed") if "regret" in r]
    rows = [regret_row(f"`mixed`, seed {seed}", [r["regret"] for r in mixed if r["seed"] == seed])
            for seed in sorted({r["seed"] for r in mixed})]
    listed = [r["regret"] for r in records.of("regret") if "regret" in r]
    if listed:
        rows.append(regret_row("`regret`", listed))
    if not rows:
        return ""
    text = ABOUT + "\n" + table(["regret", "pairs", "mean", "median", "95 %", "greatest",
                                 "over 1.5"], rows)
    beside = [r for r in mixed if "cgal" in r and r.get("equal_to_cgal") is not False]
    if not beside:
        return text
    different = sum(r.get("equal_to_cgal") is False for r in mixed)
    return (text + "\n\n" + CGAL + "\n"
            + table(["times as fast as CGAL", "pairs", "geometric mean", "5 %", "median", "least",
                     "greatest"],
                    [ratio_row(how, [r["cgal"][key] for r in beside]) for how, key in
                     (("operands prepared", "ratio_prepared"), ("operands as read",
                                                                "ratio_as_read"))])
            + f"\n\nCGAL was given up on {sum('given_up' in r for r in beside)} of these pairs. "
            f"{sum(r.get('equal_to_cgal') is True for r in beside)} results were compared and are "
            f"equal; {different} differ.")
