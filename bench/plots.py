"""Draws plots as hand-written SVG: log-log curves and dots, for light and dark pages. Colours are
from Okabe and Ito, for colour-blind people, and each series has its own marker."""
import math
import re

STYLE = """text{font:12px system-ui,"Segoe UI","DejaVu Sans",Helvetica,Arial,sans-serif;fill:#333}
.t{font-weight:600;font-size:13px}.s{fill:#666;font-size:11px}
.g{stroke:#ddd;stroke-width:1}.a{stroke:#888;stroke-width:1;fill:none}
.l{fill:none;stroke-width:1.8;stroke-linejoin:round}
.bg{fill:#fff}
@media(prefers-color-scheme:dark){text{fill:#ddd}.s{fill:#aaa}.g{stroke:#3a3a3a}.a{stroke:#888}
.bg{fill:#161616}}
"""
COLOURS = {"minksum": "#0072b2", "CGAL": "#d55e00", "output": "#009e73", "segments": "#cc79a7",
           "GEOS": "#e69f00", "grey": "#888888"}


def escape(text):
    return str(text).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def raised(text):
    """Returns the escaped text, in which what follows a ^ is an exponent."""
    return re.sub(r"\^([\d.]+)", r'<tspan dy="-4" font-size="9">\1</tspan>', escape(text))


def number(value):
    return f"{value:.1f}".rstrip("0").rstrip(".")


def decades(low, high):
    """Returns the exponents of the whole powers of ten around the values."""
    return math.floor(math.log10(low)), math.ceil(math.log10(high))


def power_label(exponent):
    names = {-6: "1 µs", -5: "10 µs", -4: "100 µs", -3: "1 ms", -2: "10 ms", -1: "100 ms",
             0: "1 s", 1: "10 s", 2: "100 s", 3: "1000 s"}
    return names.get(exponent, f"10^{exponent}")


def count_label(exponent):
    return {0: "1", 1: "10", 2: "100", 3: "1,000"}.get(exponent, f"10^{exponent}")


def marker(kind, x, y, colour):
    x, y = number(x), number(y)
    if kind == "square":
        return (f'<rect x="{number(float(x) - 3)}" y="{number(float(y) - 3)}" width="6" height="6" '
                f'fill="{colour}"/>')
    if kind == "cross":
        return (f'<path d="M{x} {y}m-3.2-3.2l6.4 6.4m0-6.4l-6.4 6.4" stroke="{colour}" '
                f'stroke-width="1.8"/>')
    return f'<circle cx="{x}" cy="{y}" r="3.2" fill="{colour}"/>'


class Panel:
    """One pair of logarithmic axes at a place of the picture."""

    def __init__(self, left, top, width, height, x_range, y_range, title, note=""):
        self.left, self.top, self.width, self.height = left, top, width, height
        self.x0, self.x1 = x_range
        self.y0, self.y1 = y_range
        self.parts = [f'<text class="t" x="{left}" y="{top - 22}">{escape(title)}</text>']
        if note:
            self.parts.append(f'<text class="s" x="{left}" y="{top - 6}">{raised(note)}</text>')

    def x(self, value):
        return self.left + self.width * (math.log10(value) - self.x0) / (self.x1 - self.x0)

    def y(self, value):
        part = (math.log10(value) - self.y0) / (self.y1 - self.y0)
        return self.top + self.height * (1 - part)

    def axes(self, y_label, y_title, x_title, x_label=count_label):
        for e in range(math.ceil(self.x0), math.floor(self.x1) + 1):
            x = number(self.x(10.0 ** e))
            self.parts.append(f'<path class="g" d="M{x} {self.top}V{self.top + self.height}"/>')
            self.parts.append(f'<text class="s" x="{x}" y="{self.top + self.height + 14}" '
                              f'text-anchor="middle">{raised(x_label(e))}</text>')
        for e in range(self.y0, self.y1 + 1):
            y = number(self.y(10.0 ** e))
            self.parts.append(f'<path class="g" d="M{self.left} {y}H{self.left + self.width}"/>')
            self.parts.append(f'<text class="s" x="{self.left - 5}" y="{number(float(y) + 4)}" '
                              f'text-anchor="end">{raised(y_label(e))}</text>')
        self.parts.append(f'<path class="a" d="M{self.left} {self.top}v{self.height}'
                          f'h{self.width}"/>')
        self.parts.append(f'<text class="s" x="{self.left + self.width}" '
                          f'y="{self.top + self.height + 27}" text-anchor="end">{x_title}</text>')
        middle = self.top + self.height // 2
        self.parts.append(f'<text class="s" transform="translate({self.left - 50},{middle})'
                          f'rotate(-90)" text-anchor="middle">{y_title}</text>')

    def series(self, points, colour, kind="circle", line=True, dash=""):
        points = [(self.x(x), self.y(y)) for x, y in points if x > 0 and y > 0]
        if line and len(points) > 1:
            path = "L".join(f"{number(x)} {number(y)}" for x, y in points)
            dashed = f' stroke-dasharray="{dash}"' if dash else ""
            self.parts.append(f'<path class="l" d="M{path}" stroke="{colour}"{dashed}/>')
        self.parts += [marker(kind, x, y, colour) for x, y in points]


def legend(entries, left, top):
    parts = []
    for label, colour, kind in entries:
        parts.append(marker(kind, left, top - 4, colour))
        parts.append(f'<text x="{left + 9}" y="{top}">{escape(label)}</text>')
        left += 9 + 7.2 * len(label) + 24
    return parts


def picture(width, height, title, parts):
    body = "\n".join(parts)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
            f'width="{width}" height="{height}" role="img">\n<title>{escape(title)}</title>\n'
            f'<style>{STYLE}</style>\n<rect class="bg" width="{width}" height="{height}"/>\n'
            f'{body}\n</svg>\n')


def families(series):
    """Draws time against n, one panel a family. `series` has name, note, {who: [(n, s)]}."""
    columns, width, height = 3, 210, 150
    rows = (len(series) + columns - 1) // columns
    everything = [p for _, _, lines in series for points in lines.values() for p in points]
    if not everything:
        return None
    x_range = (math.log10(min(p[0] for p in everything)) - 0.05,
               math.log10(max(p[0] for p in everything)) + 0.05)
    y_range = decades(min(p[1] for p in everything), max(p[1] for p in everything))
    parts = legend([("minksum", COLOURS["minksum"], "circle"),
                    ("CGAL, reduced convolution", COLOURS["CGAL"], "square")], 70, 24)
    for i, (name, note, lines) in enumerate(series):
        panel = Panel(70 + (i % columns) * (width + 80), 80 + (i // columns) * (height + 75),
                      width, height, x_range, y_range, name, note)
        panel.axes(power_label, "time", "vertices of P")
        panel.series(lines.get("CGAL", []), COLOURS["CGAL"], "square")
        panel.series(lines.get("minksum", []), COLOURS["minksum"])
        parts += panel.parts
    return picture(columns * (width + 80) + 20, 60 + rows * (height + 75),
                   "Time against vertices of P, family by family", parts)


def pairs(points, goal_mean, goal_least):
    """Draws the speed-up of every pair against the segments of its reduced convolution."""
    if not points:
        return None
    x_range = decades(min(p[0] for p in points), max(p[0] for p in points))
    low, high = decades(min(p[1] for p in points), max(p[1] for p in points))
    panel = Panel(70, 60, 640, 300, x_range, (min(low, 0), max(high, 3)),
                  "Times as fast as CGAL's reduced convolution",
                  "each dot a pair of models")
    panel.axes(count_label, "times as fast", "segments of the reduced convolution")
    for goal, text in ((goal_mean, "goal: mean"), (goal_least, "goal: least")):
        y = number(panel.y(goal))
        panel.parts.append(f'<path d="M70 {y}h640" stroke="{COLOURS["grey"]}" '
                           f'stroke-dasharray="5 4"/><text class="s" x="706" '
                           f'y="{number(float(y) - 4)}" text-anchor="end">{text}</text>')
    panel.series(points, COLOURS["minksum"], line=False)
    return picture(740, 400, "Speed-up over CGAL's reduced convolution", panel.parts)


def crossings(rows):
    """Draws crossings against segments. `rows`: segments, cover, reduced, full or None."""
    if not rows:
        return None
    values = [v for r in rows for v in r[1:] if v]
    x_range = decades(min(r[0] for r in rows), max(r[0] for r in rows))
    panel = Panel(70, 80, 640, 300, x_range, decades(max(1, min(values)), max(values)),
                  "Crossings to be found",
                  "each mark a pair of models")
    panel.axes(count_label, "crossings", "segments of the reduced convolution")
    kinds = (("full convolution", "GEOS", "square", 3), ("reduced convolution", "CGAL", "cross", 2),
             ("outside the cover: what minksum finds", "minksum", "circle", 1))
    for _, colour, kind, column in kinds:
        points = [(r[0], r[column]) for r in rows if r[column]]
        panel.series(points, COLOURS[colour], kind, line=False)
    parts = legend([(name, COLOURS[c], kind) for name, c, kind, _ in kinds], 70, 24)
    return picture(740, 420, "Crossings: full, reduced, outside the cover", parts + panel.parts)


STAGE_COLOURS = ["#0072b2", "#56b4e9", "#009e73", "#f0e442", "#e69f00", "#d55e00", "#cc79a7"]


def stages(rows, names):
    """Draws bars of shares. `rows`: label, [share of each stage]."""
    if not rows:
        return None
    parts, left, width = [], 190, 520
    x = left
    for name, colour in zip(names, STAGE_COLOURS):
        parts.append(f'<rect x="{x}" y="12" width="10" height="10" fill="{colour}"/>'
                     f'<text class="s" x="{x + 13}" y="21">{name}</text>')
        x += 22 + 6.2 * len(name)
    for i, (label, shares) in enumerate(rows):
        y, x = 36 + 20 * i, float(left)
        parts.append(f'<text x="{left - 8}" y="{y + 12}" text-anchor="end">{escape(label)}</text>')
        for share, colour in zip(shares, STAGE_COLOURS):
            parts.append(f'<rect x="{number(x)}" y="{y}" width="{number(share * width)}" '
                         f'height="15" fill="{colour}"/>')
            x += share * width
    return picture(740, 46 + 20 * len(rows), "Share of each stage", parts)
