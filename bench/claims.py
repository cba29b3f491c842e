"""Tests the goals, and gives each as one line with its figure and whether it holds."""
from figures import (MIB, bound_text, count_text, dig, exponent, family_rows, geometric_mean,
                     growth, own_seconds, ratio, ratio_or_bound, seconds_text, segments, times_text)


class Claim:
    def __init__(self, number, text, figure, holds, records=(), verdict=None):
        """`holds` is True, False, or None where it was not measured. `records` decided it."""
        self.number, self.text, self.figure, self.holds = number, text, figure, holds
        self.records = [r for r in records if r]
        self.verdict = verdict or {True: "holds", False: "falls short", None: "not measured"}[holds]


def at_least(number, text, value, goal, suffix="", records=(), is_bound=False):
    """A bound that is lower than the goal says nothing."""
    figure = f"{bound_text(value, is_bound)} times{suffix}" if value else "–"
    holds = None if not value or (is_bound and value < goal) else value >= goal
    return Claim(number, text, figure, holds, records)


def counted(timed, everything):
    missing = len(everything) - len(timed)
    return f" ({len(timed)} pairs" + (f"; {missing} not timed)" if missing else ")")


def paper_pairs(records):
    all_pairs = records.of("paper")
    timed = sorted((r for r in all_pairs if ratio(r)), key=ratio)
    compared = [r for r in all_pairs if "equal_to_cgal" in r]
    unequal = [r["name"] for r in compared if not r["equal_to_cgal"]]
    yield at_least("1", "paper's models, all pairs: geometric mean at least 100 times as fast as "
                   "CGAL's reduced convolution", geometric_mean(map(ratio, timed)), 100,
                   counted(timed, all_pairs), timed[:3])
    yield at_least("1", "… no pair under 30 times", ratio(timed[0]) if timed else None, 30,
                   f" ({timed[0]['name']}); {sum(ratio(r) >= 30 for r in timed)} of {len(timed)} "
                   "pairs reach it" if timed else "", timed[:3])
    figure = f"{len(compared) - len(unequal)} of {len(all_pairs)}" if compared else "–"
    yield Claim("1", "… results exactly equal to CGAL's", figure + (
        "; they differ: " + ", ".join(unequal) if unequal else ""),
        len(compared) == len(all_pairs) and not unequal if compared else None)


def named_pairs(records):
    for set_name, name, goal in (("paper", "monkey + monkey", 300),
                                 ("named", "neuron + 32-gon", 50),
                                 ("named", "wierd2 + wierd2_n", 600),
                                 ("named", "star5 + star5", 300)):
        record = records.get(set_name, name)
        value, is_bound = ratio_or_bound(record)
        yield at_least("2", f"{name.replace('+', '⊕')}: at least {goal} times", value, goal, "",
                       [record], is_bound)


def spiky_stars(records):
    star = records.get("spiky", "spiky 200")
    value, is_bound = ratio_or_bound(star)
    yield at_least("3", "spiky stars 200 ⊕ 200: at least 1,000 times", value, 1000, "", [star],
                   is_bound)
    large = [r for n in (400, 800, 1600) if own_seconds(r := records.get("spiky", f"spiky {n}"))]
    text = "… 400, 800 and 1,600 finish with less than 2 GiB"
    if not large:
        yield Claim("3", text, "–", None)
        return
    peak = max(r["peak_bytes"] for r in large)
    figure = ", ".join(f"{r['n']}: {seconds_text(own_seconds(r))}" for r in large)
    yield Claim("3", text, f"{figure}; at most {peak / MIB:,.0f} MiB",
                len(large) == 3 and peak < 2048 * MIB, large)
    sizes = [r for r in records.of("spiky") if own_seconds(r) and r["n"] >= 200]
    slope = exponent([(r["n"], own_seconds(r)) for r in sizes])
    yield Claim("3", "… time grows no faster than n^2",
                f"n^{slope:.2f} from {sizes[0]['n']} to {sizes[-1]['n']}" if slope else "–",
                slope <= 2.0 if slope else None, sizes)


def nesting(records):
    timed = sorted((r for r in records.of("nesting") if ratio(r)), key=ratio)
    yield at_least("4", "nesting parts: geometric mean at least 100 times",
                   geometric_mean(map(ratio, timed)), 100, counted(timed, records.of("nesting")),
                   timed[:3])
    rates = records.of("throughput")
    rate, other = (dig(rates[0] if rates else None, "sums_per_second" + end)
                   for end in ("", "_unprepared"))
    yield Claim("4", "… at least 30,000 sums a second of pairs of about 30 vertices, operands "
                "prepared", f"{rate:,.0f} (not prepared: {other:,.0f})" if rate else "–",
                rate >= 30000 if rate else None)


def table_ratio(record, threads):
    """Returns how many times as long CGAL would take for the table, by its sample."""
    mean, seconds = dig(record, "cgal", "mean"), dig(record, "table", threads, "median")
    return mean * record["sums"] / seconds if mean and seconds else None


def nesting_tables(records):
    everything = records.of("tables")
    for threads, text in (("one_thread", "one thread"), ("all_threads", "all processors")):
        found = sorted((table_ratio(r, threads), r["name"]) for r in everything
                       if table_ratio(r, threads))
        figure = "–"
        if found:
            good = sum(f[0] >= 100 for f in found)
            figure = (f"{good} of {len(found)} instances; geometric mean "
                      f"{times_text(geometric_mean(f[0] for f in found))}, at least "
                      f"{times_text(found[0][0])} times ({found[0][1]})")
        yield Claim("10", "tables of no-fit polygons of nesting instances, 4 rotations, at least "
                    f"100 times as fast as CGAL, {text}", figure,
                    found[0][0] >= 100 if found else None)


def near_the_limit(records):
    everything = [r for r in records.of("paper", "kin", "named", "spiky", "nesting", "gis",
                                        "families") if dig(r, "listing", "median") and
                  own_seconds(r)]
    for least, goal, text in ((10_000, 2, "10,000 segments or more: at most twice as long as "),
                              (1_000_000, 1, "a million or more: less than ")):
        for key, what in (("median", "listing the reduced convolution"),
                          ("by_library", "the library takes to list it, from the same operands")):
            found = sorted(((own_seconds(r) / r["listing"][key], r["name"], r) for r in everything
                            if segments(r) >= least), key=lambda f: -f[0])
            good = sum(f[0] <= goal for f in found)
            yield Claim("5", text + what, f"{good} of {len(found)} pairs; mean "
                        f"{times_text(geometric_mean(f[0] for f in found))}, at most "
                        f"{times_text(found[0][0])} times ({found[0][1]})" if found else "–",
                        good == len(found) if found else None, [f[2] for f in found[:3]])
    large = records.get("named", "heron_original_2 + monkey_original_2")
    seconds = own_seconds(large)
    figure = f"{seconds_text(seconds)} ({count_text(segments(large))} segments)" if seconds else "–"
    yield Claim("5", "heron_original_2 ⊕ monkey_original_2 in at most 40 ms", figure,
                seconds <= 0.04 if seconds else None, [large])


def doubles(records):
    found = sorted(((r["ratio"], r["name"], r["doubles"]["bits"]) for r in records.of("doubles")
                    if r.get("ratio")), reverse=True)
    text = "random doubles at most 1.5 times as long as decimals of six digits"
    if not found:
        yield Claim("6", text, "–", None)
        return
    bits = sorted(f[2] for f in found)
    yield Claim("6", text, f"at most {found[0][0]:.2f} times ({found[0][1]}), mean "
                f"{geometric_mean(f[0] for f in found):.2f}, {len(found)} pairs; {bits[0]} to "
                f"{bits[-1]} bits", found[0][0] <= 1.5)


def offsets(records):
    for kilometres in (1, 100):
        large = [r for r in records.of("gis") if r.get("kilometres") == kilometres and
                 dig(r, "p", "vertices") and r["p"]["vertices"] >= 20000]
        found = [(*ratio_or_bound(r, "geos"), r["outline"], r) for r in large]
        found = [f for f in found if f[0]]
        figure = ", ".join(f"{name} {bound_text(value, is_bound)}"
                           for value, is_bound, name, _ in found) or "–"
        yield Claim("7", "outline of 20,000 or more vertices ⊕ 32-gon: at least 3 times as fast "
                    f"as GEOS's buffer at {kilometres} km", figure,
                    min(f[0] for f in found) >= 3 if found else None, [f[3] for f in found])


def memory(records):
    found = sorted(((r["peak_bytes"], r["name"], r["peak_growth_bytes"])
                    for r in records.of("paper") if "peak_bytes" in r), reverse=True)
    figure = "–"
    if found:
        peak, name, grown = found[0]
        figure = (f"at most {peak / MIB:.1f} MiB, the whole process ({name}; the sum alone added "
                  f"{grown / MIB:.1f}), {len(found)} pairs")
    yield Claim("8", "peak memory of a sum at most 64 MiB for every pair of goal 1", figure,
                found[0][0] <= 64 * MIB if found else None)


def growths(records):
    for name, _, members in family_rows(records):
        time = growth(members, own_seconds)
        output = growth(members, lambda r: dig(r, "result", "vertices"))
        if time is not None and output is not None:
            yield Claim("9", f"growth: {name}", f"time n^{time:.2f}, output n^{output:.2f}", True,
                        verdict="shown")


def claims(records):
    result = []
    for part in (paper_pairs, named_pairs, spiky_stars, nesting, near_the_limit, doubles, offsets,
                 memory, growths, nesting_tables):
        result += part(records)
    return result
