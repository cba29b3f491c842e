"""Tests minksum offset: options, files, messages, exit codes, and the commands of its page."""
import json
import math
import xml.etree.ElementTree

from support import FRAME, SQUARE, Page, ProgramTest, main

LINE = "LINESTRING (0 0, 10 0, 10 10)"
JOINS = ("round", "miter", "square", "bevel")
CAPS = ("round", "butt", "square")


class Offset(ProgramTest):
    def setUp(self):
        super().setUp()
        self.square = self.file("square.wkt", SQUARE)
        self.frame = self.file("frame.wkt", FRAME)
        self.line = self.file("line.wkt", LINE)

    def offset(self, file, distance, *options, note=""):
        return self.fine("offset", file, f"--distance={distance}", *options, note=note)

    def test_results(self):
        self.assertEqual(self.offset(self.square, 1, "--join", "miter"),
                         "POLYGON ((-1 -1, 3 -1, 3 3, -1 3, -1 -1))\n")
        self.assertEqual(self.offset(self.square, "1/2", "--join", "bevel"),
                         "POLYGON ((-0.5 0, 0 -0.5, 2 -0.5, 2.5 0, 2.5 2, 2 2.5, 0 2.5, -0.5 2, "
                         "-0.5 0))\n")
        self.assertEqual(self.offset(self.frame, -1, "--join", "miter"),
                         "POLYGON ((1 1, 8 1, 8 8, 1 8, 1 1), (2 2, 2 7, 7 7, 7 2, 2 2))\n")
        self.assertEqual(self.offset(self.line, 1, "--join", "miter", "--cap", "square"),
                         "POLYGON ((-1 -1, 11 -1, 11 11, 9 11, 9 1, -1 1, -1 -1))\n")
        self.assertEqual(self.offset(self.line, 1, "--join=miter", "--cap=butt"),
                         "POLYGON ((0 -1, 11 -1, 11 10, 9 10, 9 1, 0 1, 0 -1))\n")
        for distance in (-1, "-1e9", -3):
            self.assertEqual(self.offset(self.square, distance), "POLYGON EMPTY\n")
        self.assertEqual(self.offset(self.line, -1), "POLYGON EMPTY\n")
        self.assertEqual(self.offset(self.line, 0), LINE + "\n")
        self.assertEqual(self.fine("offset", "-", "-d", "0", stdin=SQUARE), SQUARE + "\n")

    def test_numbers_as_files_have_them(self):
        for typed, number in ((".5", "0.5"), ("5.", "5"), ("-.5", "-1/2"), ("+.5", "1/2"),
                              ("5.e-1", "0.5"), (".05E1", "0.5"), ("1e4096", None)):
            given = self.offset(self.square, typed, "--join", "miter", "--coords", "exact")
            if number:
                self.assertEqual(given, self.offset(self.square, number, "--join", "miter",
                                                    "--coords", "exact"))
        for typed in (".", "-.", ".e1", "1./2", "1/.5", "1.5.5", "1e", "e5", "1e.5", "1e5000.5"):
            self.fails(1, "takes a number", "offset", self.square, f"--distance={typed}")
        for option in ("--distance", "--tolerance", "--miter-limit"):
            for typed in ("1e5000", "-.5e-4097", "1e99999999999999999999"):
                self.fails(1, f"{option} takes exponents up to ±4096, not '{typed}'", "offset",
                           self.square, *(() if option == "--distance" else ("-d1",)),
                           f"{option}={typed}")
        self.fails(1, "1111...", "offset", self.square, "-d", "1" * 10_000)

    def test_round_joins_keep_their_side(self):
        # The squared distances are those of the farthest point of a disc, and of the nearest
        # edge's middle.
        point = self.file("point.wkt", "POINT (0 0)")
        for side, low, high in (("outside", 1, 1.01), ("inside", 0.99, 1), ("nearest", .99, 1.01)):
            text = self.offset(point, 1, "--side", side, "--tolerance", "0.01", "--format",
                               "geojson")
            ring = json.loads(text)["coordinates"][0]
            self.assertLessEqual(len(ring), 32)
            for (x, y), (u, v) in zip(ring, ring[1:]):
                self.assertLessEqual(x * x + y * y, high * high)
                self.assertGreaterEqual(((x + u) ** 2 + (y + v) ** 2) / 4, low * low)

    def test_rounding_keeps_the_side_too(self):
        point = self.file("point.wkt", "POINT (0 0)")
        for side, sign in (("outside", 1), ("inside", -1)):
            text = self.offset(point, 1, "--side", side, "--coords", "decimal:1", "--format",
                               "geojson")
            ring = json.loads(text)["coordinates"][0]
            for (x, y), (u, v) in zip(ring, ring[1:]):
                squared = (x - u) ** 2 + (y - v) ** 2
                foot = min(1, max(0, (x * (x - u) + y * (y - v)) / squared)) if sign > 0 else 0
                distance = math.hypot(x + foot * (u - x), y + foot * (v - y))
                self.assertGreaterEqual(sign * distance, sign - 1e-12)
            other = self.offset(point, 1, "--side", side, "--coords", "decimal:1", "--round",
                                "nearest", "--format", "geojson")
            self.assertNotEqual(other, text)

    def test_files(self):
        out, picture = self.folder / "out.geojson", self.folder / "out.svg"
        for join in JOINS:
            for cap in CAPS:
                self.assertEqual(self.offset(self.line, 1, "--join", join, "--cap", cap, "-o", out,
                                             "--svg", picture), "")
                self.assertEqual(json.loads(out.read_text())["type"], "Polygon")
                text = picture.read_text()
                self.assertNotIn(">Q<", text)
                xml.etree.ElementTree.fromstring(text)
        self.offset(self.square, -5, "--svg", picture)
        xml.etree.ElementTree.parse(picture)

    def test_fill_rule_and_rounding(self):
        twice = self.file("twice.wkt", "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), "
                                       "((0 0, 2 0, 2 2, 0 2, 0 0)))")
        for join in JOINS:
            self.assertEqual(self.offset(twice, 1, "--join", join, note="not valid"),
                             self.offset(self.square, 1, "--join", join))
            # The overlap is a hole, so only the rings are left, as a closed polyline.
            hollow = self.offset(twice, "1/2", "--join", join, "--fill", "evenodd",
                                 note="not valid")
            self.assertEqual(hollow.count("("), 3)
            result = self.fails(2, "polygon", "offset", twice, "-d1", "--join", join, "--fill",
                                "strict")
            self.assertIn(str(twice), result.stderr.decode())
        self.assertIn("/3 ", self.offset(self.square, "1/3", "--coords", "exact"))
        self.assertIn("2.34", self.offset(self.square, "1/3", "--coords", "decimal:2", "--round",
                                          "outside"))

    def test_bad_input(self):
        square = self.square
        self.fails(1, "--distance is missing", "offset", square)
        for option, values, why in (
                ("--distance", ("one", "nan", "1/0", "0x1", "1,5"), "takes a number"),
                ("--tolerance", ("0", "-1", "-1e-9"), "must be positive"),
                ("--tolerance", ("x", "inf"), "takes a number"),
                ("--miter-limit", ("0", "0.99", "-3"), "at least 1"),
                ("--miter-limit", ("x",), "takes a number"),
                ("--join", ("mitred", "rounded", "1"), "--join"),
                ("--cap", ("flat", "bevel"), "--cap"),
                ("--side", ("left",), "--side"),
                ("--coords", ("three",), "--coords")):
            for value in values:
                line = self.fails(1, why, "offset", square, *(() if option == "--distance" else ("--distance=1",)),
                                  f"{option}={value}")
                self.assertIn(option, line.stderr.decode())
        for options in (("--join", "miter"), ("--cap", "butt")):
            self.fails(1, "round joins and caps only", "offset", square, "-d1", "--side", "inside",
                       *options)
        self.fails(1, "--svg", "offset", square, "-d1", "--svg", "-")
        self.fails(2, "nowhere.wkt", "offset", "nowhere.wkt", "-d1")
        bad = self.file("bad.wkt", "POLYGON ((0 0, 1 0")
        self.fails(2, f"{bad}:1:", "offset", bad, "-d1")
        for option in ("-o", "--svg"):
            self.fails(2, "there is no folder", "offset", square, "-d1", option,
                       self.folder / "no" / "out.svg")
        self.fails(3, "2^20 vertices", "offset", square, "-d1", "--tolerance", "1e-13")
        self.fails(3, "tolerance", "offset", square, "-d1", "--tolerance", "1e-13", "--join", "miter")
        self.fails(3, "--max-segments", "offset", square, "-d1", "--join", "bevel",
                   "--max-segments", 3)
        self.fails(3, "--max-segments", "offset", square, "-d1", "--max-segments", 3)


class OffsetPage(Page, ProgramTest):
    page_name = "offset.md"
    pictures = 3


if __name__ == "__main__":
    main()
