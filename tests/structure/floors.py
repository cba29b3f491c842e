#!/usr/bin/env python3
"""Checks and draws the floors of the house, which say what each part of the code may include.

    floors.py check ROOT    print every include that breaks a rule; exit with 1 if there is one
    floors.py draw ROOT     write docs/architecture.md and docs/img/architecture.svg anew
    floors.py count ROOT    print the lines of each room

A room is a folder. A file belongs to the room that its path names, and may include its own room and
the rooms on lower floors. Includes are followed to their end: what a header includes counts for
every file that includes that header.
"""
import collections
import pathlib
import re
import sys
import textwrap

# Each entry has a room, its floor, and what it holds. Rooms on one floor do not include each other.
ROOMS = [
    ("src/machine", 0, "Vector instructions, threads, memory that grows in pieces, the count of "
                       "work that looks at cancel tokens."),
    ("src/exact", 1, "Exact numbers: integers of fixed and of any width, fractions, signs, every "
                     "formula of a predicate, and the ladder of number types that decides it."),
    ("src/region", 2, "The public values and what needs nothing else: rationals, regions, "
                      "transformation, measures, locating points."),
    ("src/spatial", 2, "Grids of cells, pairs of overlapping boxes, division at medians, a sweep "
                       "over segments."),
    ("src/validation", 3, "Reads an operand into exact coordinates and finds every fault, with its "
                          "place."),
    ("src/overlay", 4, "Fill rules, boolean operations and complements."),
    ("src/sum", 4, "The sum by the reduced convolution: a folder for each stage, `pipeline.cpp` "
                   "that runs them, and `small/`, a shorter way for small operands."),
    ("src/rounding", 5, "Rounding to a grid, so that the result stays valid and on the side that "
                        "is asked for."),
    ("src/second", 5, "The second opinion: the sum by the signed convolution, and the check of "
                      "results. It includes nothing of `src/sum`."),
    ("src/operations", 6, "A folder for each group of public operations: sum, morphology, offset, "
                          "no-fit polygons, penetration depth, configuration space."),
    ("src/io", 7, "Readers and writers of files, mostly one for each format. Few include more "
                  "than public headers."),
    ("c", 8, "The C interface. Includes only public headers."),
    ("cli", 8, "The program. Includes only public headers."),
    ("sql", 8, "The extensions of PostgreSQL. Includes only public headers."),
    ("python", 8, "The Python package. Includes only public headers."),
]
FLOOR = {room: floor for room, floor, _ in ROOMS}

# The stages in the order of the pipeline. Each may include the boundary header of those before it.
STAGES = ["operands", "convolution", "cover", "arrangement", "loops", "filters", "output", "tight",
          "trace"]
# Rules beyond the floors: a room or folder, what it may not reach, the folders of it that it may
# reach nevertheless, and why.
APART = [
    ("src/second", "src/sum", [], "a second opinion shares nothing with the first"),
    ("src/sum/small", "src/sum", STAGES[:3],
     "the way of small operands stands beside the stages, but has the same cover"),
]
# Exceptions: a file or a room, what it includes against the rules, and why.
EXCEPTIONS = {
    ("src/io", "src/machine/cancellation.hpp"):
        "readers and writers count their work as the library does, by this header",
    ("src/io", "src/machine/bad_input.hpp"):
        "options of reading and writing are checked as those of operations are",
    ("src/io/writer.cpp", "src/exact/shortest_double.hpp"):
        "not every standard library can write doubles",
    ("src/io/gdal/gdal_features.cpp", "src/exact/shortest_double.hpp"):
        "not every standard library can write doubles",
    ("src/operations/configuration_space/slices.cpp", "src/operations/sum/fixed_sum.hpp"):
        "slices share one raster of the obstacles, which has no public form",
    ("src/operations/no_fit/no_fit_table.cpp", "src/operations/sum/fixed_sum.hpp"):
        "the parts of a table are validated once, which has no public form",
}
# Adaptors are public headers that may include the library that they adapt, because only a user who
# has that library includes them. Some of these libraries are GPL or LGPL, so no program and no
# library that is built here may reach an adaptor.
ADAPTORS = "include/minksum/adaptors/"
ADAPTED = {"boost_geometry.hpp": "boost/", "cgal.hpp": "CGAL/", "geos.hpp": "geos_c.h"}
SHARED = ADAPTORS + "shared.hpp"  # all adaptors share it; it includes no other library
# Code outside of src that includes only public headers, so that it shares no mistake with src.
OUTSIDE = ["c", "cli", "python", "sql", "bench", "examples", "tests/adaptors", "tests/reference",
           "tests/support", "tests/property", "tests/real", "tests/oracle"]

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*["<]([^">]+)[">]', re.M)


class House:
    """Knows every file and what it includes."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.faults = []
        self.used = set()  # exceptions that were needed
        self.includes = {}
        for folder in ["include", "src", *OUTSIDE]:
            for path in sorted((self.root / folder).rglob("*.?pp")):
                name = path.relative_to(self.root).as_posix()
                found = INCLUDE.findall(path.read_text(encoding="utf-8"))
                self.includes[name] = [self.resolve(name, text) for text in found]

    def resolve(self, name, text):
        """Returns the file that an include names, or the text itself if the file is not ours."""
        own = name.rsplit("/", 1)[0]
        for folder in [own, name.split("/")[0], "src", "include", "tests"]:
            if (self.root / folder / text).is_file():
                return f"{folder}/{text}"
        return text

    def reached(self, name):
        """Returns each file that `name` includes in the end, with the include that leads to it."""
        first = {direct: direct for direct in self.includes.get(name, [])}
        for direct in list(first):
            stack = list(self.includes.get(direct, []))
            while stack:
                file = stack.pop()
                if file not in first:
                    first[file] = direct
                    stack.extend(self.includes.get(file, []))
        return first

    def fault(self, name, target, why):
        self.faults.append(f"{name}: {target}: {why}")

    # -- The rules ---------------------------------------------------------------------------------
    def check(self):
        for name in self.includes:
            if name.startswith("src/"):
                self.check_source(name)
            elif name.startswith("include/"):
                self.check_public(name)
            else:
                self.check_outside(name)
        for pair in sorted(set(EXCEPTIONS) - self.used):
            if (self.root / pair[0]).exists():
                self.fault(*pair, "an exception that nobody needs")
        return self.faults

    def check_source(self, name):
        own = room_of(name)
        if own is None:
            return self.fault(name, "", "no room has this path")
        self.check_without_adaptors(name)
        for target, entry in self.reached(name).items():
            shown = target if entry == target else f"{target} (by {entry})"
            other = room_of(target)
            if self.excepted(name, target):
                continue
            if other is None:
                if target.startswith("src/"):
                    self.fault(name, shown, "no room has this path")
            elif own == "src/io" and other != own:
                self.fault(name, shown, "only the public headers are for this room")
            elif other != own and FLOOR[other] >= FLOOR[own]:
                self.fault(name, shown, f"{other} is not on a floor below {own}")
            else:
                self.check_apart(name, target, shown)
                if entry == target:
                    self.check_folders(name, target)

    def excepted(self, name, target):
        for pair in [(name, target), (room_of(name), target)]:
            if pair in EXCEPTIONS:
                self.used.add(pair)
                return True
        return False

    def check_apart(self, name, target, shown):
        for folder, other, but, why in APART:
            inside = name.startswith(folder + "/") and target.startswith(other + "/")
            allowed = tuple(f"{other}/{part}/" for part in but)
            if inside and not target.startswith((folder + "/", *allowed)):
                self.fault(name, shown, why)

    def check_folders(self, name, target):
        """Checks two files in one room: stages must be in order, and operations apart."""
        own, other = folder_of(name), folder_of(target)
        if own == other:
            return
        if name.startswith("src/sum/") and target.startswith("src/sum/"):
            if other not in STAGES:
                if own in STAGES:
                    self.fault(name, target, "a stage knows nothing of what runs it")
            elif own in STAGES and STAGES.index(other) > STAGES.index(own):
                self.fault(name, target, f"{other} comes after {own}")
            elif own in STAGES and target != f"src/sum/{other}/{other}.hpp":
                self.fault(name, target, "only the boundary header of a stage is for others")
        if name.startswith("src/operations/") and target.startswith("src/operations/"):
            self.fault(name, target, "operations use each other through the public headers")

    def check_public(self, name):
        adaptor = name.startswith(ADAPTORS)
        adapted = ADAPTED.get(name.removeprefix(ADAPTORS)) if adaptor else None
        for target in self.includes[name]:
            if target.startswith(ADAPTORS):
                if not adaptor:
                    self.fault(name, target, "adaptors are for users who have the other library")
                elif target != SHARED:
                    self.fault(name, target, "an adaptor includes no other adaptor")
            elif target.startswith("include/minksum/"):
                continue
            elif adapted and target.startswith(adapted):
                continue
            elif "/" in target or target.endswith(".h"):  # the standard library has neither
                also = f", this one {adapted} as well" if adapted else ""
                self.fault(name, target,
                           f"public headers include the standard library and each other{also}")

    def check_outside(self, name):
        reached = self.reached(name).items()
        for entry in sorted({entry for target, entry in reached if target.startswith("src/")}):
            self.fault(name, entry, "only the public headers are for this folder")
        if name.split("/")[0] in FLOOR:
            self.check_without_adaptors(name)

    def check_without_adaptors(self, name):
        for target in self.includes[name]:
            if target.startswith(ADAPTORS):
                self.fault(name, target, "adaptors are for users who have the other library")

    # -- The picture -------------------------------------------------------------------------------
    def arrows(self):
        """Returns pairs of rooms of which the first includes the second."""
        pairs = set()
        for name, targets in self.includes.items():
            own = room_of(name)
            pairs.update((own, room_of(target)) for target in targets)
        return sorted((a, b) for a, b in pairs if a and b and a != b)


def room_of(path):
    parts = path.split("/")
    if parts[0] in FLOOR:
        return parts[0]
    room = "/".join(parts[:2])
    return room if len(parts) > 2 and room in FLOOR else None


def folder_of(path):
    """Returns the folder inside the room, or the empty string."""
    parts = path.split("/")
    return parts[2] if len(parts) > 3 else ""


# -- Drawing
# -----------------------------------------------------------------------------------------
WIDTH, LANE, BOX, HEIGHT = 760, 74, 150, 34


def places():
    """Returns the middle of each room's box."""
    floors = collections.defaultdict(list)
    for room, floor, _ in ROOMS:
        floors[floor].append(room)
    top = max(floors)
    where = {}
    for floor, rooms in floors.items():
        for i, room in enumerate(rooms):
            # Rooms that are alone on their floor stand left and right in turn, so that arrows
            # over several floors pass beside them.
            x = WIDTH * (i + 1) / (len(rooms) + 1) if len(rooms) > 1 else WIDTH * (
                0.62 if floor % 2 else 0.42)
            where[room] = (round(x), (top - floor) * LANE + 40)
    return where


def picture(house):
    where = places()
    height = max(y for _, y in where.values()) + 40
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" role="img" '
        'aria-label="The rooms of the code by floors; arrows point to what a room includes">',
        "<style>",
        "text{font:14px system-ui,sans-serif;fill:#1f2933;text-anchor:middle}",
        "text.floor{font-size:12px;text-anchor:start;fill:#6b7785}",
        "rect{fill:#f3f6f9;stroke:#5b7083}.lane{stroke:#c8d1da;stroke-dasharray:2 4}",
        ".arrow{fill:none;stroke:#3b6ea5;stroke-opacity:.55}.head{fill:#3b6ea5}",
        "@media (prefers-color-scheme:dark){text{fill:#e3e8ed}text.floor{fill:#93a1af}",
        "rect{fill:#1d2731;stroke:#8aa0b4}.lane{stroke:#3a4856}",
        ".arrow{stroke:#7fb0e0}.head{fill:#7fb0e0}}",
        "</style>",
        '<defs><marker id="head" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" '
        'markerHeight="7" orient="auto"><path class="head" d="M0 1L8 4L0 7z"/></marker></defs>',
    ]
    for floor in sorted({FLOOR[room] for room in where}):
        y = next(y for room, (_, y) in where.items() if FLOOR[room] == floor)
        lines.append(f'<path class="lane" d="M0 {y + LANE // 2}H{WIDTH}"/>'
                     f'<text class="floor" x="4" y="{y + 5}">floor {floor}</text>')
    for a, b in house.arrows():
        (x0, y0), (x1, y1) = where[a], where[b]
        # An arrow enters and leaves a box towards its other end, so that few arrows coincide.
        shift = max(-55, min(55, (x1 - x0) // 4))
        start, end = x0 + shift, x1 - shift
        bend = min(60, (y1 - y0) // 2)
        lines.append(f'<path class="arrow" marker-end="url(#head)" d="M{start} {y0 + HEIGHT // 2}'
                     f'C{start} {y0 + HEIGHT // 2 + bend} {end} {y1 - HEIGHT // 2 - bend} '
                     f'{end} {y1 - HEIGHT // 2}"/>')
    for room, (x, y) in where.items():
        lines.append(f'<rect x="{x - BOX // 2}" y="{y - HEIGHT // 2}" width="{BOX}" '
                     f'height="{HEIGHT}" rx="5"/><text x="{x}" y="{y + 5}">{room}</text>')
    return "\n".join(lines) + "\n</svg>\n"


PAGE = """\
# Where is what in the code?

The code is a house with floors. A room is a folder. A file may include files of its own room and of
rooms on lower floors, and nothing else. The test `structure_floors` holds this; it follows includes
to their end. This page and its picture are written by that test's script:

    python3 tests/structure/floors.py draw .

![The rooms by floors](img/architecture.svg)

| floor | room | what it holds | what it includes |
|---|---|---|---|
{table}

Beside the house lie `include/minksum`, the public headers, which every room may include;
`include/minksum_c.h`, the C interface, which room `c` implements; `tests`, whose `unit` folder has
the same rooms; `bench`; `examples`; `js`, the package for JavaScript, which calls the C interface
as WebAssembly; and `web`, a page that uses it.

## Rules beside the floors

{rules}

How a sum passes through `src/sum` is in [pipeline.md](pipeline.md).
[CONTRIBUTING.md](../CONTRIBUTING.md) tells how to add a format, a subcommand or an operation, and
which places depend on the machine.
[install.md](install.md#how-do-i-use-it-from-c-or-from-another-language) tells how another language
calls the library.
"""


def page(house):
    includes = collections.defaultdict(list)
    for a, b in house.arrows():
        includes[a].append(b.removeprefix("src/"))
    table = "\n".join(
        f"| {floor} | `{room}` | {text} | {', '.join(includes[room]) or '-'} |"
        for room, floor, text in reversed(ROOMS))
    rules = [f"`{folder}` includes nothing of `{other}`"
             + (f" but {', '.join(but)}" if but else "") + f": {why}."
             for folder, other, but, why in APART]
    rules.append("Inside `src/sum` a stage includes only boundary headers, and only of earlier "
                 "stages. The order is " + ", ".join(STAGES) + ".")
    rules.append("The folders of `src/operations` use each other through the public headers.")
    rules.append("Public headers include the standard library and each other. An adaptor may include "
                 "the library that it adapts as well: "
                 + ", ".join(f"`{name}` includes `{what}`" for name, what in ADAPTED.items())
                 + ". Only a user who has that library includes an adaptor: no room does, nor does "
                 "another public header.")
    rules.append("Exceptions:")
    text = "\n".join(wrapped("- ", rule) for rule in rules)
    for (name, target), why in EXCEPTIONS.items():
        text += "\n" + wrapped("  - ", f"`{name}` includes `{target}`: {why}.")
    return PAGE.format(table=table, rules=text)


def wrapped(bullet, text):
    return textwrap.fill(text, 100, initial_indent=bullet, subsequent_indent=" " * len(bullet),
                         break_long_words=False, break_on_hyphens=False)


def drawn(house):
    """Returns the texts of the files that are drawn, by their paths."""
    return {"docs/architecture.md": page(house), "docs/img/architecture.svg": picture(house)}


def count(house):
    lines = collections.Counter()
    for name in house.includes:
        key = room_of(name) or name.split("/")[0]
        lines[key] += len((house.root / name).read_text(encoding="utf-8").splitlines())
    for key, number in sorted(lines.items()):
        print(f"{number:7} {key}")


def main(what, root):
    house = House(root)
    if what == "count":
        return count(house)
    if what == "draw":
        for name, text in drawn(house).items():
            (house.root / name).write_text(text, encoding="utf-8")
        return 0
    faults = house.check()
    for name, text in drawn(house).items():
        path = house.root / name
        if path.exists() and path.read_text(encoding="utf-8") != text:
            faults.append(f"{name}: is out of date: python3 tests/structure/floors.py draw .")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] not in ("check", "draw", "count"):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
