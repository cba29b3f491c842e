"""Tests the subcommands for uses of sums, and the commands of their page."""
import json
import random
import xml.etree.ElementTree
from fractions import Fraction

from support import FRAME, SQUARE, TRIANGLE, Page, ProgramTest, main, run

MORPHOLOGY = ("dilate", "erode", "open", "close")
EMPTY = "POLYGON EMPTY"
# This shape has a slit from the top that is as wide as SQUARE.
SLIT = "POLYGON ((0 0, 6 0, 6 4, 4 4, 4 1, 2 1, 2 4, 0 4, 0 0))"


def polygon(ring):
    return f"POLYGON (({', '.join(f'{x} {y}' for x, y in [*ring, ring[0]])}))"


class Morphology(ProgramTest):
    def setUp(self):
        super().setUp()
        self.frame = self.file("frame.wkt", FRAME)
        self.square = self.file("square.wkt", SQUARE)

    def test_dilation_is_the_sum(self):
        for style in ("exact", "double", "decimal:2"):
            self.assertEqual(self.fine("dilate", self.frame, self.square, "--coords", style),
                             self.fine("sum", self.frame, self.square, "--coords", style))

    def test_results(self):
        small = self.file("small.wkt", "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))")
        self.assertEqual(self.fine("erode", self.frame, self.square),
                         "POLYGON ((0 0, 7 0, 7 7, 0 7, 0 0), (1 1, 1 6, 6 6, 6 1, 1 1))\n")
        self.assertEqual(self.fine("open", self.frame, self.square), self.fine("dilate", self.frame,
                         self.file("origin.wkt", "POINT (0 0)")))
        self.assertEqual(self.fine("close", self.frame, small),
                         "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))\n")

    def test_tight_is_part_of_the_result(self):
        room = self.file("room.wkt", "POLYGON ((0 0, 5 0, 5 2, 0 2, 0 0))")
        self.assertEqual(self.fine("erode", room, self.square), EMPTY + "\n")
        self.assertEqual(self.fine("erode", room, self.square, "--tight"),
                         "LINESTRING (0 0, 3 0)\n")
        self.assertEqual(self.fine("open", room, self.square), EMPTY + "\n")
        self.assertEqual(self.fine("open", room, self.square, "--tight"),
                         "POLYGON ((0 0, 5 0, 5 2, 0 2, 0 0))\n")
        point = self.file("point.wkt", "POINT (7 8)")
        self.assertEqual(self.fine("close", point, self.square, "--tight"), "POINT (7 8)\n")
        self.assertEqual(self.fine("dilate", point, point, "--tight"), "POINT (14 16)\n")

    def test_fill_rule(self):
        twice = self.file("twice.wkt", "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), "
                                       "((0 0, 4 0, 4 4, 0 4, 0 0)))")
        self.assertEqual(self.fine("erode", twice, self.square, note="not valid"),
                         "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\n")
        self.assertEqual(self.fine("erode", twice, self.square, "--fill", "evenodd",
                                   note="not valid"), EMPTY + "\n")
        result = self.fails(2, "polygon", "erode", self.square, twice, "--fill", "strict")
        self.assertIn(str(twice), result.stderr.decode())

    def test_files(self):
        out, picture = self.folder / "out.geojson", self.folder / "out.svg"
        for command in MORPHOLOGY:
            self.assertEqual(self.fine(command, self.frame, self.square, "-o", out, "--svg",
                                       picture), "")
            self.assertIn("coordinates", json.loads(out.read_text()))
            xml.etree.ElementTree.parse(picture)

    def test_bad_input(self):
        empty = self.file("empty.wkt", EMPTY)
        point = self.file("point.wkt", "POINT (0 0)")
        for command in MORPHOLOGY[1:]:
            result = self.fails(2, "empty set", command, self.square, empty)
            self.assertIn(str(empty), result.stderr.decode())
            self.assertEqual(self.fine(command, empty, self.square), EMPTY + "\n")
        self.fails(2, "thin parts", "erode", self.square, point, "--tight")
        for command in MORPHOLOGY:
            self.fails(2, "nowhere.wkt", command, self.square, "nowhere.wkt")
            self.fails(2, "there is no folder", command, self.square, self.square, "-o",
                       self.folder / "no" / "out.wkt")
            self.fails(1, "both be standard input", command, "-", "-")
            self.fails(1, "--coords", command, self.square, self.square, "--coords", "three")
            self.fails(1, "--round", command, self.square, self.square, "--coords", "exact",
                       "--round", "inside")
            self.fails(3, "--max-segments", command, self.frame, self.square, "--max-segments", 2)


class Nesting(ProgramTest):
    def setUp(self):
        super().setUp()
        self.square = self.file("square.wkt", SQUARE)
        self.slit = self.file("slit.wkt", SLIT)

    def test_reference_point(self):
        turned = self.file("turned.wkt", "POLYGON ((2 2, 0 2, 0 0, 2 0, 2 2))")
        self.assertEqual(self.fine("nfp", "-q", self.square, self.square),
                         "POLYGON ((-2 -2, 2 -2, 2 2, -2 2, -2 -2))\n")
        moved = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\n"
        self.assertEqual(self.fine("nfp", "-q", self.square, turned), moved)
        self.assertEqual(self.fine("nfp", "-q", self.square, self.square, "--reference", "2,2"), moved)
        self.assertEqual(self.fine("ifp", "-q", self.square, turned), "POINT (2 2)\n")
        self.assertEqual(
            self.fine("ifp", "-q", self.square, self.square, "--reference", "-1/3,1e1", "--coords",
                      "exact"), "POINT (-1/3 10)\n")
        # The part has no play. With a side, the result is a superset or subset of that point.
        for side, rounded in (("nearest", "POINT (0 10)"), ("outside", "LINESTRING (-1 10, 0 10)"),
                              ("inside", "POLYGON EMPTY")):
            self.assertEqual(
                self.fine("ifp", "-q", self.square, self.square, "--reference", "-1/3,1e1", "--coords",
                          "decimal:0", "--round", side), rounded + "\n")

    def test_reference_points_by_name(self):
        part = self.file("part.wkt", "POLYGON ((4 1, 5 3, 1 3, 2 1, 4 1))")
        for typed, told in (([], "moving part's first vertex, (4, 1)"),
                            (["--reference", "first"], "moving part's first vertex, (4, 1)"),
                            (["--reference", "Lower-Left"], "lower left corner, (1, 1)"),
                            (["--reference", "centroid"], "centroid, (3, about 2.1111111"),
                            (["--reference", "1/2,7"], "moving part's point, (0.5, 7)")):
            self.fine("nfp", self.square, part, *typed, note=told)
        self.assertEqual(
            self.fine("ifp", "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))", part, "--reference", "centroid",
                      "--coords", "exact", note="the part's centroid, (3, about 2.11"),
            "POLYGON ((2 10/9, 7 10/9, 7 73/9, 2 73/9, 2 10/9))\n")
        # A hole takes away from the area; the fill rule says what that is.
        frame = self.file("frame.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (2 1, 3 1, 3 3, 2 3, "
                                       "2 1))")
        self.fine("nfp", self.square, frame, "--reference", "centroid",
                  note="centroid, (about 1.928571428571428")
        for part_without_area in ("POINT (1 1)", "LINESTRING (0 0, 1 1)"):
            self.fails(2, "a part without area has no lower left corner and no centroid", "nfp",
                       self.square, part_without_area, "--reference", "centroid")
        self.fails(1, "(did you mean 'centroid'?)", "nfp", self.square, part, "--reference",
                   "centriod")

    def test_parts_without_area(self):
        # Their no-fit polygons were empty, and all placements free.
        flat = "POLYGON ((0 0, 4 0, 4 0, 0 0))"
        for thin in ("LINESTRING (0 0, 4 0)", "POINT (1 1)", flat):
            for pair in ((self.square, thin), (thin, self.square), (thin, thin)):
                for asked in ([], ["--at", "1,1"]):
                    result = run("nfp", *pair, "--reference", "0,0", "-q", *asked)
                    self.assertEqual((result.returncode, result.stdout), (2, b""))
                    self.assertIn(b"a part without area has no no-fit polygon; give its lines and "
                                  b"points a width first (minksum offset)", result.stderr)
        self.assertEqual(self.fine("nfp", EMPTY, self.square, "-q"), EMPTY + "\n")
        self.assertEqual(self.fine("nfp", self.square, EMPTY, "-q", "--reference", "0,0"),
                         EMPTY + "\n")
        tail = f"GEOMETRYCOLLECTION ({SQUARE}, LINESTRING (2 1, 9 1))"
        for command in ("nfp", "ifp"):
            for pair in ((self.square, tail), (tail, self.square)):
                told = run(command, *pair).stderr.decode()
                self.assertEqual(told.count("polylines and points are left out"), 1, told)
            self.assertEqual(self.fine(command, self.square, tail, "-q"),
                             self.fine(command, self.square, self.square, "-q"))

    def test_tight_places(self):
        nfp = self.fine("nfp", "-q", self.slit, self.square)
        self.assertIn("LINESTRING (2 1, 2 4)", nfp)
        # Rounding moves the area to its side, and tight places to the nearest points.
        third = self.file("third.wkt", "POLYGON ((0 0, 1/3 0, 1/3 1/3, 0 1/3, 0 0))")
        hole = self.file("hole.wkt", "POLYGON ((-9 -9, 9 -9, 9 9, -9 9, -9 -9), "
                                     "(1/3 1/3, 2/3 1/3, 2/3 2/3, 1/3 2/3, 1/3 1/3))")
        for side in ("nearest", "outside", "inside"):
            self.assertIn("POINT (0.33 0.33)", self.fine("nfp", "-q", hole, third, "--coords",
                                                         "decimal:2", "--round", side))

    def test_placements(self):
        self.assertEqual(self.fine("nfp", "-q", "--at", "2,5/2", "--at", "-3,0", "--at", "-2,-2", "--at",
                                   "1.5,2", self.slit, self.square),
                         "touching\nfree\ntouching\noverlapping\n")
        self.assertEqual(self.fine("nfp", "-q", "--at", ".5,2.", self.slit, self.square), "overlapping\n")
        self.fails(1, "--at takes exponents up to ±4096, not '1e-5000'", "nfp", "--at", "0,1e-5000",
                   self.slit, self.square)
        for option in (["-o", "x"], ["--format", "svg"], ["--svg", "x"], ["--coords", "exact"],
                       ["--round", "inside"]):
            self.fails(1, "cannot be given together with", "nfp", self.slit, self.square, "--at", "0,0", *option)
        self.fails(1, "--at", "ifp", self.slit, self.square, "--at", "0,0")

    def test_part_that_does_not_fit(self):
        triangle = self.file("triangle.wkt", TRIANGLE)
        empty = self.file("empty.wkt", EMPTY)
        out = self.folder / "out.wkt"
        for bin_file, part in ((self.square, triangle), (empty, self.square)):
            result = run("ifp", bin_file, part, "-o", out)
            self.assertEqual(result.returncode, 0)
            self.assertTrue(result.stderr.decode().endswith(
                f"(--reference)\nminksum: the part ({part}) does not fit into the bin "
                f"({bin_file})\n"))
            self.assertEqual(out.read_text(), EMPTY + "\n")

    def test_pictures(self):
        picture = self.folder / "picture.svg"
        for command in ("nfp", "ifp"):
            for part in (self.square, self.slit):  # one of the bins is too small
                run(command, self.square, part, "-o", self.folder / "x", "--svg", picture)
                xml.etree.ElementTree.parse(picture)

    def test_bad_input(self):
        empty = self.file("empty.wkt", EMPTY)
        line = self.file("line.wkt", "LINESTRING (0 0, 1 0)")
        for command in ("nfp", "ifp"):
            for part in (empty, line):
                self.fails(2, f"{part}: a part without area", command, self.square, part)
            for point in ("", "1", "1,", ",1", "1,2,3", "1/0,1", "nan,0", "0x1,0", "1;2"):
                self.fails(1, "--reference takes " if point else "--reference", command,
                           self.square, self.square, f"--reference={point}")
            self.fails(1, "both be standard input", command, "-", "-")
            self.fails(2, "there is no folder", command, self.square, self.square, "-o",
                       self.folder / "no" / "out.wkt")
        self.fails(2, "empty.wkt: erosion by an empty set", "ifp", self.square, empty,
                   "--reference", "0,0")
        self.fails(1, "--at takes two numbers", "nfp", self.square, self.square, "--at", "1,x")


class OperationStatistics(ProgramTest):
    def test_sizes_and_times(self):
        frame, square = self.file("frame.wkt", FRAME), self.file("square.wkt", SQUARE)
        stats, out = self.folder / "stats.json", self.folder / "out.wkt"
        for command in (["erode", frame, square], ["nfp", frame, square], ["ifp", frame, square],
                        ["offset", frame, "-d1"], ["depth", frame, square]):
            self.fine(*command, "-q", "--stats", stats,
                      *([] if command[0] == "depth" else ["-o", out]))
            found = json.loads(stats.read_text())
            self.assertEqual([o["vertices"] for o in found["operands"]],
                             [8, 4] if command[-1] == square else [8])
            self.assertEqual(found["operands"][0]["file"], str(frame))
            self.assertGreater(found["seconds"]["work"], 0)
            self.fails(1, "--stats", *command, "--stats", "-")
            stats.unlink()
        both = self.fine("erode", frame, square, "--stats", "-", "-o", out)
        self.assertEqual(json.loads(both)["fill"], "automatic")
        self.fails(1, "the same file", "erode", frame, square, "--stats", out, "-o", out)


class DepthOfTwo(ProgramTest):
    def depth(self, a, b, *options):
        return json.loads(self.fine("depth", self.file("a.wkt", a), self.file("b.wkt", b), "--json",
                                    *options))

    def test_relations(self):
        for dx, relation, vector in ((1, "overlapping", [1, 0]), (2, "touching", [0, 0]),
                                     (5, "apart", [-3, 0])):
            b = polygon([(x + dx, y) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))])
            found = self.depth(SQUARE, b)
            self.assertEqual((found["relation"], found["vector"]), (relation, vector))
            self.assertEqual(found["vector_exact"], [str(x) for x in vector])
            self.assertNotIn("impact", found)

    def test_fractions(self):
        found = self.depth(polygon([(0, 0), (3, 0), (0, 3)]),
                           polygon([(3, 3), (4, 3), (3, "10/3")]))
        self.assertEqual(found["vector_exact"], ["-3/2", "-3/2"])
        self.assertEqual((found["squared_exact"], found["distance"]), ("9/2", 4.5 ** 0.5))
        text = self.fine("depth", self.folder / "a.wkt", self.folder / "b.wkt", "--along", "-1,-3")
        self.assertIn("x         -1.5\ny         -1.5\nsquared   4.5\ndistance  2.12", text)
        self.assertIn("impact    0.75\n", text)

    def test_impact(self):
        far = "POLYGON ((6 1, 8 1, 8 3, 6 1))"
        for along, exact, near in (("-1,0", "4", 4), ("-3,0", "4/3", 4 / 3), ("1,0", None, None),
                                   ("-8/3,0", "3/2", 1.5)):
            found = self.depth(SQUARE, far, "--along", along)
            self.assertEqual((found["impact_exact"], found["impact"]), (exact, near))
        self.assertEqual(self.depth(SQUARE, SQUARE, "--along", "1,0")["impact"], 0)
        self.assertIn("impact    never\n", self.fine("depth", self.folder / "a.wkt",
                                                     self.file("far.wkt", far), "--along", "0,1"))

    # In contact, the named vertex lies on the named edge, whatever the orientation of rings.
    def test_contact(self):
        rng = random.Random(1)
        named = 0
        for _ in range(60):
            rings = []
            for _ in range(2):
                x, y = rng.randint(-6, 6), rng.randint(-6, 6)
                # No two edges lie in one line, because the first would be named for all of them.
                ring = [(x, y), (x + rng.randint(4, 9), y - 1), (x + 3, y + rng.randint(4, 9)),
                        (x + 1, y + 1)]
                rings.append(ring if rng.random() < 0.5 else ring[::-1])
            far = [(x + 99, y) for x, y in rings[0]]  # some vertices are then in the second polygon
            a = f"MULTIPOLYGON ({polygon(far)[8:]}, {polygon(rings[0])[8:]})"
            found = self.depth(a, polygon(rings[1]))
            if found["contact"] is None:
                continue
            named += 1
            move = [Fraction(text) for text in found["vector_exact"]]
            moved = [(x + move[0], y + move[1]) for x, y in rings[1]]
            shapes = {"A": [far, rings[0]], "B": [moved]}
            edge, vertex = found["contact"]["edge"], found["contact"]["vertex"]
            self.assertEqual({edge["of"], vertex["of"]}, {"A", "B"})
            ring = shapes[edge["of"]][edge["polygon"] - 1]
            p, q = ring[edge["vertex"] - 1], ring[edge["vertex"] % len(ring)]
            v = shapes[vertex["of"]][vertex["polygon"] - 1][vertex["vertex"] - 1]
            self.assertEqual((edge["ring"], vertex["ring"]), (1, 1))
            self.assertEqual((q[0] - p[0]) * (v[1] - p[1]), (q[1] - p[1]) * (v[0] - p[0]))
            for i in (0, 1):
                self.assertTrue(min(p[i], q[i]) <= v[i] <= max(p[i], q[i]))
        self.assertGreater(named, 30)

    def test_holes_count(self):
        inside = polygon([(4, 4), (5, 4), (4, 5)])
        found = self.depth(FRAME, inside)
        self.assertEqual((found["relation"], found["distance"]), ("apart", 1))
        self.assertEqual({found["contact"][k]["of"]: found["contact"][k]["ring"]
                          for k in ("edge", "vertex")}, {"A": 2, "B": 1})

    def test_picture(self):
        picture = self.folder / "picture.svg"
        self.depth(FRAME, SQUARE, "--svg", picture)
        xml.etree.ElementTree.parse(picture)

    def test_polylines_and_points(self):
        picture = self.folder / "picture.svg"
        for thin, relation, distance in (("POINT (1 0.5)", "overlapping", 0.5),
                                         ("POINT (2 1)", "touching", 0),
                                         ("LINESTRING (5 0, 5 9)", "apart", 3)):
            for pair in ((SQUARE, thin), (thin, SQUARE)):
                found = self.depth(*pair, "--svg", picture)
                self.assertEqual((found["relation"], found["distance"], found["contact"]),
                                 (relation, distance, None))
                xml.etree.ElementTree.parse(picture)

    def test_bad_input(self):
        square = self.file("square.wkt", SQUARE)
        bad = self.file("bad.wkt", EMPTY)
        for pair in ((bad, square), (square, bad)):
            self.fails(2, f"{bad}: there is no distance", "depth", *pair)
        for along, why in (("0,0", "direction"), ("1", "two numbers"), ("1,,2", "two numbers")):
            self.fails(1, why, "depth", square, square, "--along", along)
        self.fails(1, "both be standard input", "depth", "-", "-")
        self.fails(1, "--svg", "depth", square, square, "--svg", "-")
        self.fails(2, "there is no folder", "depth", square, square, "--svg",
                   self.folder / "no" / "x.svg")


class Options(ProgramTest):
    def test_options_without_effect(self):
        box = "box:1x1"
        for words, other in (
                (["batch", "jobs", "--operation", "sum"], "--pairs"),
                (["convert", box, "--restart"], "--each"),
                (["transform", box, "--move", "1,1", "--about", "1,1"], "--scale or --turn"),
                (["transform", box, "--scale", "2", "--angle-tolerance", "0.1"], "--turn"),
                (["offset", box, "-d", "1", "--miter-limit", "3"], "--join miter")):
            self.fails(1, f" has no meaning without {other} (minksum", *words)
        self.fails(1, "cannot be given together with", "convert", box, "-q", "-v")
        self.fine("offset", box, "-d", "1", "--join", "miter", "--miter-limit", "3")

    def test_missing_names(self):
        for option, following in (("--svg", "-q"), ("-o", "-v"), ("--stats", "--svg")):
            self.fails(1, f"needs a name; write './{following}' if '{following}' is one", "sum",
                       "box:1x1", "box:1x1", option, following)
        self.assertEqual(list(self.folder.glob("-*")), [])

    def test_counts(self):
        box = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"
        for option in ("--samples", "--edges", "--seed", "--proof-segments"):
            for text in ("-1", "", "0x10", "1.5", "18446744073709551616"):
                self.fails(1, f"{option} takes a count as 500000, 500K or 2M, not '{text}'", "check",
                           box, box, "POINT (0 0)", option, text)

    def test_reference_systems_without_a_number(self):
        point = self.file("a.json", '{"type": "Point", "coordinates": [1, 2], "crs": {"type": "name",'
                                    ' "properties": {"name": "mine"}}}')
        lost = "the reference system of the operands has no place in this format"
        self.fine("convert", point, note=lost)
        self.fine("convert", point, "--each", "--format", "wkt", note=lost)
        self.fine("convert", point, "--format", "geojson")


class UsesPage(Page, ProgramTest):
    page_name = "operations.md"
    pictures = 4


if __name__ == "__main__":
    main()
