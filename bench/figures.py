"""Makes the parts of docs/benchmarks.md: numbers out of the records, and Markdown tables."""
import math

MODELS = ["g1", "g2", "g3", "g4", "airplane", "dog", "hand1", "hand2", "bird", "mammoth", "monkey",
          "neuron"]
STAGES = ["operands", "convolution", "cover", "arrangement", "loops", "filters", "output"]
MIB = 1 << 20


class Records:
    """The records of minksum_bench: of one run, or of several that measured a part each."""

    def __init__(self, benches):
        self.runs = [bench["run"] for bench in benches]
        self.by_key = {(r["set"], r["name"]): r for bench in benches for r in bench["records"]}
        self.all = list(self.by_key.values())

    def of(self, *sets):
        return [r for r in self.all if r["set"] in sets]

    def get(self, set_name, name):
        return self.by_key.get((set_name, name))


def dig(record, *path):
    """Returns record[a][b]..., or None where a key is missing."""
    for key in path:
        if record is None or key not in record:
            return None
        record = record[key]
    return record


def own_seconds(record):
    return dig(record, "minksum_alone", "median")


def ratio(record, peer="cgal"):
    return dig(record, peer, "ratio")


def ratio_or_bound(record, peer="cgal"):
    """Returns how many times as fast as a peer minksum is, and whether that is a lower bound. It is
    one if the peer was given up after so many seconds."""
    value = ratio(record, peer)
    if value:
        return value, False
    seconds = dig(record, "given_up", peer)
    if seconds and own_seconds(record):
        return seconds / own_seconds(record), True
    return None, False


def geometric_mean(values):
    values = list(values)
    return math.exp(sum(map(math.log, values)) / len(values)) if values else None


def exponent(points):
    """Returns the slope of the best line through the logarithms of both, by least squares."""
    points = [(math.log(x), math.log(y)) for x, y in points if x > 0 and y > 0]
    if len(points) < 2:
        return None
    mean_x = sum(p[0] for p in points) / len(points)
    mean_y = sum(p[1] for p in points) / len(points)
    spread = sum((p[0] - mean_x) ** 2 for p in points)
    return sum((x - mean_x) * (y - mean_y) for x, y in points) / spread if spread else None


def seconds_text(seconds):
    if seconds is None:
        return "–"
    if seconds < 1e-3:
        return f"{seconds * 1e6:.0f} µs"
    if seconds < 1:
        return f"{seconds * 1e3:.3g} ms"
    return f"{seconds:.3g} s"


def times_text(value):
    if value is None:
        return "–"
    return f"{value:,.0f}" if value >= 100 else f"{value:.3g}"


def count_text(value):
    return "–" if value is None else f"{value:,}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows])


def matrix(names, cell):
    """Returns a triangular table of pairs, where cell(p, q) is a text."""
    rows = []
    for i, p in enumerate(names):
        rows.append([f"**{p}**"] + ["" if j < i else cell(p, q) for j, q in enumerate(names)])
    return table(["⊕"] + names, rows)


def segments(record):
    """Returns the segments of the whole reduced convolution; minksum may have listed fewer."""
    return dig(record, "counts_no_cover", "convolution_segments") or dig(
        record, "listing", "segments") or dig(record, "counts", "convolution_segments")


def family_rows(records):
    """Returns for each family its name, its description, and its members in order of size."""
    found = {}
    for r in records.of("families"):
        if own_seconds(r):
            found.setdefault(r["family"], []).append(r)
    return [(name, members[0]["description"], sorted(members, key=lambda r: r["n"]))
            for name, members in found.items()]


def upper_half(members):
    """Returns the larger half of the sizes, at least four, because growth shows at large n."""
    return members[min(len(members) // 2, max(len(members) - 4, 0)):]


def growth(members, value):
    return exponent([(r["p"]["vertices"], value(r) or 0) for r in upper_half(members)])


def bound_text(value, is_bound):
    return ("over " if is_bound else "") + times_text(value)


def peer_cell(record, peer):
    """Returns how many times as fast as a peer minksum is, or why that is not known."""
    value, is_bound = ratio_or_bound(record, peer)
    if value:
        return bound_text(value, is_bound)
    if record is not None and record.get("equal_to_cgal") is False:
        return "differs"
    if peer in ("cgal", "cgal_full") and dig(record, "failures", "comparison"):
        return "not compared: " + record["failures"]["comparison"]
    return dig(record, "failures", peer) or "–"
