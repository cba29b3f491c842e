"""The goals, each as one line with its figure and whether it holds."""
from figures import (MIB, count_text, dig, exponent, family_rows, geometric_mean, growth,
                     own_seconds, ratio, seconds_text, segments, times_text)


class Claim:
    def __init__(self, number, text, figure, holds):
        """`holds`: True, False, or None where it was not measured."""
        self.number, self.text, self.figure, self.holds = number, text, figure, holds

    @property
    def verdict(self):
        return {True: "holds", False: "falls short", None: "not measured"}[self.holds]


def at_least(number, text, value, goal, suffix=""):
    figure = f"{times_text(value)} times{suffix}" if value else "–"
    return Claim(number, text, figure, value >= goal if value else None)


def paper_pairs(records):
    all_pairs = records.of("paper")
    timed = [r for r in all_pairs if ratio(r)]
    unequal = [r["name"] for r in all_pairs if r.get("equal_to_cgal") is False]
    missing = len(all_pairs) - len(timed)
    suffix = f" ({len(timed)} pairs" + (f"; {missing} not timed" if missing else "") + ")"
    mean = geometric_mean(map(ratio, timed))
    least = min(timed, key=ratio) if timed else None
    yield at_least("1", "paper's models, all pairs: geometric mean at least 100 times as fast as "
                   "CGAL's reduced convolution", mean, 100, suffix)
    yield at_least("1", "… no pair under 30 times", ratio(least) if least else None, 30,
                   f" ({least['name']})" if least else "")
    if unequal:
        yield Claim("1", "… all results equal CGAL's", "differ: " + ", ".join(unequal), False)
    elif timed:
        yield Claim("1", "… results exactly equal to CGAL's", f"{len(timed)} of {len(timed)}", True)


def named_pairs(records):
    for set_name, name, goal in (("paper", "monkey + monkey", 300),
                                 ("named", "neuron + 32-gon", 50),
                                 ("named", "wierd2 + wierd2_n", 600),
                                 ("named", "star5 + star5", 300)):
        text = f"{name.replace('+', '⊕')}: at least {goal} times"
        yield at_least("2", text, ratio(records.get(set_name, name)), goal)


def spiky_stars(records):
    star = records.get("spiky", "spiky 200")
    yield at_least("3", "spiky stars 200 ⊕ 200: at least 1,000 times", ratio(star), 1000)
    large = [r for n in (400, 800, 1600) if own_seconds(r := records.get("spiky", f"spiky {n}"))]
    if not large:
        yield Claim("3", "… 400, 800 and 1,600 finish with less than 2 GiB", "–", None)
        return
    peak = max(r["peak_bytes"] for r in large)
    figure = ", ".join(f"{r['n']}: {seconds_text(own_seconds(r))}" for r in large)
    yield Claim("3", "… 400, 800 and 1,600 finish with less than 2 GiB",
                f"{figure}; at most {peak / MIB:,.0f} MiB", len(large) == 3 and peak < 2048 * MIB)
    sizes = [r for r in records.of("spiky") if own_seconds(r) and r["n"] >= 200]
    slope = exponent([(r["n"], own_seconds(r)) for r in sizes])
    yield Claim("3", "… time grows no faster than n^2",
                f"n^{slope:.2f} from {sizes[0]['n']} to {sizes[-1]['n']}" if slope else "–",
                slope <= 2.0 if slope else None)


def nesting(records):
    timed = [r for r in records.of("nesting") if ratio(r)]
    yield at_least("4", "nesting parts: geometric mean at least 100 times",
                   geometric_mean(map(ratio, timed)), 100, f" ({len(timed)} pairs)")
    rates = records.of("throughput")
    rate = dig(rates[0], "sums_per_second") if rates else None
    how = "prepared operands" if rates and rates[0].get("prepared") else "operands not prepared"
    yield Claim("4", "… at least 30,000 sums a second of pairs of about 30 vertices",
                f"{rate:,.0f} ({how})" if rate else "–", rate >= 30000 if rate else None)


def near_the_limit(records):
    everything = [r for r in records.of("paper", "kin", "named", "spiky", "families")
                  if dig(r, "listing", "median") and own_seconds(r)]

    def worst(least):
        large = [(own_seconds(r) / r["listing"]["median"], r["name"]) for r in everything
                 if segments(r) >= least]
        return max(large, default=None), len(large)
    for least, goal, text in ((10_000, 2, "10,000 segments or more: at most twice as long as "
                               "listing the reduced convolution"),
                              (1_000_000, 1, "a million or more: less than listing it")):
        found, count = worst(least)
        yield Claim("5", text, f"at most {found[0]:.2f} times ({found[1]}; {count} pairs)"
                    if found else "–", found[0] <= goal if found else None)
    large = records.get("named", "heron_original_2 + monkey_original_2")
    seconds = own_seconds(large)
    figure = f"{seconds_text(seconds)} ({count_text(segments(large))} segments)" if seconds else "–"
    yield Claim("5", "heron_original_2 ⊕ monkey_original_2 in at most 40 ms", figure,
                seconds <= 0.04 if seconds else None)


def doubles(records):
    found = [(r["ratio"], r["name"], r["doubles"]["bits"]) for r in records.of("doubles")
             if r.get("ratio")]
    worst = max(found, default=None)
    if not worst:
        yield Claim("6", "random doubles at most 1.5 times as long as decimals", "–", None)
        return
    bits = sorted(f[2] for f in found)
    yield Claim("6", "random doubles at most 1.5 times as long as decimals of six digits",
                f"at most {worst[0]:.2f} times ({worst[1]}), mean "
                f"{geometric_mean(f[0] for f in found):.2f}; {bits[0]} to {bits[-1]} bits",
                worst[0] <= 1.5)


def offset_ratio(record, records):
    """GEOS's time over minksum's, and whether that is a lower bound because GEOS was given up."""
    value = ratio(record, "geos")
    if value:
        return value, False
    if dig(record, "failures", "geos") == "over time" and own_seconds(record):
        return records.run["peer_seconds"] / own_seconds(record), True
    return None, False


def offsets(records):
    for kilometres in (1, 100):
        large = [r for r in records.of("gis") if r["kilometres"] == kilometres and
                 dig(r, "p", "vertices") and r["p"]["vertices"] >= 20000]
        found = [(*offset_ratio(r, records), r["outline"]) for r in large]
        found = [f for f in found if f[0]]
        figure = ", ".join(f"{name} {'over ' if bound else ''}{times_text(value)}"
                           for value, bound, name in found) or "–"
        yield Claim("7", "outline of 20,000 or more vertices ⊕ 32-gon: at least 3 times as fast "
                    f"as GEOS's buffer at {kilometres} km", figure,
                    min(f[0] for f in found) >= 3 if found else None)


def memory(records):
    found = [(r["peak_bytes"], r["name"], r["peak_growth_bytes"]) for r in records.of("paper")
             if "peak_bytes" in r]
    worst = max(found, default=None)
    yield Claim("8", "peak memory of a sum at most 64 MiB for every pair of goal 1",
                f"at most {worst[0] / MIB:.1f} MiB, the whole process ({worst[1]}; the sum alone "
                f"added {worst[2] / MIB:.1f})" if worst else "–",
                worst[0] <= 64 * MIB if worst else None)


def growths(records):
    for name, _, members in family_rows(records):
        time = growth(members, own_seconds)
        output = growth(members, lambda r: dig(r, "result", "vertices"))
        if time is None or output is None:
            continue
        yield Claim("9", f"growth: {name}", f"time n^{time:.2f}, output n^{output:.2f}", True)


def claims(records):
    result = []
    for part in (paper_pairs, named_pairs, spiky_stars, nesting, near_the_limit, doubles, offsets,
                 memory, growths):
        result += part(records)
    return result
