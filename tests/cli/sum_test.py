"""Tests minksum sum: results, formats, statistics, and files that are never lost."""
import json
import os
import re
import shutil
import stat
import struct
import xml.etree.ElementTree

from support import FRAME, SQUARE, TRIANGLE, ProgramTest, main, run

SQUARES = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\n"
EXAMPLES = os.path.join(os.path.dirname(__file__), "..", "..", "examples")


class Results(ProgramTest):
    def setUp(self):
        super().setUp()
        self.square = self.file("square.wkt", SQUARE)
        self.triangle = self.file("triangle.wkt", TRIANGLE)
        self.frame = self.file("frame.wkt", FRAME)

    def test_squares(self):
        self.assertEqual(self.fine("sum", self.square, self.square), SQUARES)

    def test_holes_shrink_and_close(self):
        small = self.file("small.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))")
        self.assertEqual(self.fine("sum", self.frame, small),
                         "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), (4 4, 4 6, 6 6, 6 4, 4 4))\n")
        tight = self.file("tight.wkt", "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))")
        self.assertEqual(self.fine("sum", self.frame, tight),
                         "POLYGON ((0 0, 12 0, 12 12, 0 12, 0 0))\n")

    def test_methods_agree(self):
        for name in ("coral", "star"):
            p = os.path.join(EXAMPLES, f"{name}.wkt")
            q = os.path.join(EXAMPLES, "disc32.wkt" if name == "coral" else "star_turned.wkt")
            reduced = self.fine("sum", p, q, "--coords", "exact")
            self.assertEqual(self.fine("sum", p, q, "--coords", "exact", "--method", "signed"),
                             reduced)
            for extra in (["--no-cover"], ["--grid", "1"], ["--grid", "64"], ["--no-filter"],
                          ["--arithmetic", "medium"], ["--arithmetic", "wide"],
                          ["--arithmetic", "arbitrary"], ["--check"], ["--repeat", "3"]):
                self.assertEqual(self.fine("sum", p, q, "--coords", "exact", *extra), reduced, extra)

    def test_full_method_agrees(self):
        p = os.path.join(EXAMPLES, "star.wkt")
        q = os.path.join(EXAMPLES, "star_turned.wkt")
        self.assertEqual(self.fine("sum", p, q, "--coords", "exact", "--method", "full"),
                         self.fine("sum", p, q, "--coords", "exact"))

    def test_numbers_are_exact(self):
        p = self.file("p.wkt", "POLYGON ((0.1 0, 1 0, 1 1/3, 0.1 0))")
        q = self.file("q.wkt", "POLYGON ((0.2 0, 0.3 0, 0.3 0.1, 0.2 0.1, 0.2 0))")
        exact = self.fine("sum", p, q, "--coords", "exact")
        self.assertIn("(3/10 0, 13/10 0, 13/10 13/30,", exact)
        self.assertIn("0.3 0, 1.3 0,", self.fine("sum", p, q))
        self.assertIn("0.30 0.00, 1.30 0.00, 1.30 0.43,",
                      self.fine("sum", p, q, "--coords", "decimal:2"))

    def test_most_decimals(self):
        third = self.file("third.wkt", "MULTIPOINT (1/3 0, 2/3 1/7)")
        origin = self.file("origin.wkt", "POINT (0 0)")
        for form in ("wkt", "geojson"):
            text = self.fine("sum", third, origin, "--coords", "decimal:4096", "--format", form)
            for digits in ("0." + "3" * 4096, "0." + "6" * 4095 + "7", "0." + "142857" * 682 + "1429"):
                self.assertIn(digits, text)
        for side, last in (("outside", "4"), ("inside", "3")):
            text = self.fine("sum", self.file("p.wkt", "POLYGON ((0 0, 1/3 0, 0 1/3, 0 0))"),
                             origin, "--coords", "decimal:4096", "--round", side)
            self.assertIn("0." + "3" * 4095 + last, text)
        # A number of 4,096 digits in all can be read; one with one more digit cannot.
        out = self.folder / "out.wkt"
        for digits, code in ((4095, 0), (4096, 3)):
            self.fine("sum", third, origin, "--coords", f"decimal:{digits}", "-o", out)
            self.assertEqual(run("info", out).returncode, code)
        for digits in ("4097", "99999"):
            self.fails(1, "decimal:N with N from 0 to 4096", "sum", third, origin, "--coords",
                       f"decimal:{digits}")

    def test_formats(self):
        text = self.fine("sum", self.frame, self.square, "--format", "geojson")
        self.assertEqual(json.loads(text)["type"], "Polygon")
        svg = self.fine("sum", self.frame, self.square, "--format", "svg")
        self.assertTrue(xml.etree.ElementTree.fromstring(svg).tag.endswith("svg"))
        wkt = self.fine("sum", self.frame, self.square)
        for form in ("geojson", "poly", "wkt"):
            copy = self.folder / f"copy.{form}"
            self.fine("sum", self.frame, self.square, "-o", copy)  # the name tells the format
            point = self.file("dot.wkt", "POLYGON ((0 0, 1 0, 0 1, 0 0))")
            self.assertEqual(self.fine("sum", copy, point),
                             self.fine("sum", self.file("copy.txt", wkt), point))

    def test_empty_operand(self):
        empty = self.file("empty.wkt", "POLYGON EMPTY")
        self.assertEqual(self.fine("sum", empty, self.square), "POLYGON EMPTY\n")

    def test_standard_input(self):
        self.assertEqual(self.fine("sum", "-", self.square, stdin=SQUARE), SQUARES)
        self.assertEqual(self.fine("sum", self.square, "-", stdin=SQUARE), SQUARES)


class Geometries(ProgramTest):
    def sum(self, p, q, *extra, **options):
        files = self.file("p.txt", p), self.file("q.txt", q)
        return self.fine("sum", *files, *extra, **options).rstrip("\n")

    def test_thin_operands(self):
        for p, q, expected in (
                ("POINT (1 2)", "POINT (1/2 3)", "POINT (1.5 5)"),
                ("MULTIPOINT (0 0, 1 0)", "MULTIPOINT (0 0, 1 0)",
                 "MULTIPOINT ((0 0), (1 0), (2 0))"),
                ("LINESTRING (0 0, 1 0)", "POINT (5 5)", "LINESTRING (5 5, 6 5)"),
                ("LINESTRING (0 0, 1 0)", "LINESTRING (0 0, 3 0)", "LINESTRING (0 0, 4 0)"),
                ("LINESTRING (0 0, 1 0)", "LINESTRING (0 0, 0 3)",
                 "POLYGON ((0 0, 1 0, 1 3, 0 3, 0 0))"),
                (SQUARE, "POINT (1 1)", "POLYGON ((1 1, 3 1, 3 3, 1 3, 1 1))"),
                (SQUARE, "LINESTRING (0 0, 5 0)", "POLYGON ((0 0, 7 0, 7 2, 0 2, 0 0))"),
                ('{"type":"Point","coordinates":[1,1]}', SQUARE,
                 "POLYGON ((1 1, 3 1, 3 3, 1 3, 1 1))"),
                (SQUARE, "POINT EMPTY", "POLYGON EMPTY"),
                (f"GEOMETRYCOLLECTION ({SQUARE}, POINT (9 9))", "POINT (0 0)",
                 f"GEOMETRYCOLLECTION ({SQUARE}, POINT (9 9))")):
            with self.subTest(f"{p} + {q}"):
                self.assertEqual(self.sum(p, q), expected)
                self.assertEqual(self.sum(q, p), expected)

    def test_operands_that_are_not_valid(self):
        """A hole only takes area away; the program tells of the fault, or refuses."""
        notched = self.file("notched.wkt", "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), "
                                           "(4 2, 9 2, 9 4, 4 4, 4 2))")
        square = self.file("square.wkt", SQUARE)
        area = "POLYGON ((0 0, 6 0, 6 2, 4 2, 4 4, 6 4, 6 6, 0 6, 0 0))\n"
        why = f"{notched}: polygon 1, ring 1, vertex 2: edges cross at (6, "
        rule = "read by --fill automatic: "
        for fragment in (why, rule, "--strict"):
            self.assertEqual(self.fine("sum", notched, self.file("o.wkt", "POINT (0 0)"),
                                       note=fragment), area)
        for command in (["sum", notched, square], ["dilate", notched, square],
                        ["erode", notched, square], ["open", notched, square],
                        ["close", notched, square], ["nfp", notched, square],
                        ["ifp", notched, square], ["depth", notched, square],
                        ["offset", notched, "--distance", "1"], ["draw", notched],
                        ["cspace", notched, square, "--angles", "1"],
                        ["reach", square, notched, "--from", "-9,-9,0", "--to", "20,20,0",
                         "--angles", "4"]):
            with self.subTest(command=command[0]):
                done = run(*command)  # a no-fit polygon tells its reference point as well
                self.assertEqual(done.returncode, 0)
                self.assertIn(why, done.stderr.decode())
                for strict in (["--strict"], ["--fill", "strict"]):
                    self.fails(2, "edges cross at (6, ", *command, *strict)
        self.fails(1, "--strict", "sum", notched, square, "--strict", "--fill", "evenodd")
        # By winding numbers, the part of the hole that is outside is filled.
        self.fine("sum", notched, square, "--fill", "nonzero", note="read by --fill nonzero")
        result = self.file("result.wkt", area)
        self.fine("check", result, notched, self.file("o.wkt", "POINT (0 0)"), note=why)

    def test_fill_rules(self):
        twice = "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0, 0 0, 2 0, 2 2, 0 2, 0 0))"
        full = "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0))"
        ell = "POLYGON ((0 2, 2 2, 2 0, 6 0, 6 6, 0 6, 0 2))"
        for rule, expected in (("automatic", full), ("nonzero", full), ("positive", full),
                               ("evenodd", f"GEOMETRYCOLLECTION ({ell}, LINESTRING (0 2, 0 0, 2 0))"),
                               ("negative", "MULTILINESTRING ((0 2, 0 0, 2 0), "
                                "(0 2, 0 6, 6 6, 6 0, 2 0), (0 2, 2 2, 2 0))")):
            with self.subTest(rule):
                self.assertEqual(self.sum(twice, "POINT (0 0)", "--fill", rule, note="not valid"),
                                 expected)
        self.assertEqual(self.sum(twice, SQUARE, "--fill", "evenodd", "--regularize",
                                  note="not valid"),
                         "POLYGON ((0 2, 2 2, 2 0, 8 0, 8 8, 0 8, 0 2))")
        self.assertEqual(self.sum(SQUARE, "POINT (0 0)", "--regularize"), "POLYGON EMPTY")

    def test_formats_of_thin_results(self):
        lines = "LINESTRING (0 0, 1 0)", "POINT (5 5)"
        self.assertEqual(json.loads(self.sum(*lines, "--format", "geojson")),
                         {"type": "LineString", "coordinates": [[5, 5], [6, 5]]})
        self.assertIn("<path", self.sum(*lines, "--format", "svg"))
        self.fails(2, "no form in .poly", "sum", self.folder / "p.txt", self.folder / "q.txt",
                   "--format", "poly")

    def test_tight_places(self):
        out = self.folder / "sum.wkt"
        tight = self.folder / "tight.geojson"
        p = self.file("p.wkt", FRAME)
        q = self.file("q.wkt", "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))")
        stats = json.loads(self.fine("sum", p, q, "-o", out, "--tight", tight, "--stats", "-"))
        self.assertEqual(json.loads(tight.read_text()), {"type": "Point", "coordinates": [6, 6]})
        self.assertEqual({k: v for k, v in stats["result"].items() if k.startswith("tight")},
                         {"tight_points": 1, "tight_polylines": 0, "tight_length": 0})
        q = self.file("q.wkt", "POLYGON ((0 0, 2 0, 2 3, 0 3, 0 0))")
        self.assertEqual(self.fine("sum", p, q, "-o", out, "--tight", "-"), "LINESTRING (5 6, 6 6)\n")
        q = self.file("q.wkt", SQUARE)
        picture = self.folder / "picture.svg"
        self.assertEqual(self.fine("sum", p, q, "-o", out, "--tight", "-", "--svg", picture),
                         "POLYGON EMPTY\n")
        self.assertIn("tight places: none", picture.read_text())
        stats = json.loads(self.fine("sum", p, q, "-o", out, "--stats", "-"))
        self.assertNotIn("tight_points", stats["result"])

    def test_rounding(self):
        out = self.folder / "sum.wkt"
        p = self.file("p.wkt", "POLYGON ((0 0, 1/3 0, 1/3 1/3, 0 1/3, 0 0))")
        q = self.file("q.wkt", "POINT (0 0)")
        near = "POLYGON ((0.00 0.00, 0.33 0.00, 0.33 0.33, 0.00 0.33, 0.00 0.00))\n"
        stats = json.loads(self.fine("sum", p, q, "-o", out, "--coords", "decimal:2", "--stats",
                                     "-"))
        self.assertEqual(out.read_text(), near)
        self.assertEqual(list(stats["rounding"]),
                         ["side", "exact", "snapped", "topology_kept", "largest_move", "bound"])
        self.assertEqual(stats["rounding"]["side"], "nearest")
        self.assertFalse(stats["rounding"]["exact"])
        self.assertLessEqual(stats["rounding"]["largest_move"], stats["rounding"]["bound"])
        for side, compare in (("outside", self.assertGreaterEqual), ("inside", self.assertLess)):
            text = self.fine("sum", p, q, "--coords", "decimal:2", "--round", side)
            compare(max(float(x) for x in re.findall(r"[-0-9.]+", text)), 1 / 3)
        stats = json.loads(self.fine("sum", q, q, "-o", out, "--stats", "-"))
        self.assertTrue(stats["rounding"]["exact"])
        stats = json.loads(self.fine("sum", p, q, "-o", out, "--stats", "-", "--coords", "exact"))
        self.assertNotIn("rounding", stats)

    def test_rounding_keeps_points_and_polylines_on_their_side(self):
        out = self.folder / "sum.wkt"
        origin = self.file("origin.wkt", "POINT (0 0)")
        cell = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n"
        # Rounding to the nearest would lose the first one, and move the second out of the sum.
        for exact, outside, inside in (
                ("LINESTRING (0 0, 1/3 1/7)", cell, "POINT (0 0)\n"),
                ("POINT (0.4 0.4)", cell, "POLYGON EMPTY\n"),
                ("LINESTRING (0 0, 3 4)", "LINESTRING (0 0, 3 4)\n", "LINESTRING (0 0, 3 4)\n"),
                ("GEOMETRYCOLLECTION (POLYGON ((0 0, 1/3 0, 1/3 1/3, 0 0)), "
                 "LINESTRING (1/3 1/3, 5/7 6/7), POINT (9/7 1/9))",
                 "POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))\n", "POLYGON EMPTY\n")):
            shape = self.file("shape.wkt", exact)
            for side, expected in (("outside", outside), ("inside", inside)):
                stats = json.loads(self.fine("sum", shape, origin, "--round", side, "--coords",
                                             "decimal:0", "-o", out, "--stats", "-",
                                             "-q"))["rounding"]
                self.assertEqual(out.read_text(), expected)
                self.assertEqual(stats["exact"], outside == inside)
                self.assertLessEqual(stats["largest_move"], stats["bound"])

    def test_tight_places_stay(self):
        # They vanished in the area around them.
        slit = "POLYGON ((0 0, 6 0, 6 4, 4 4, 4 1, 2 1, 2 4, 0 4, 0 0))"
        made = self.fine("nfp", slit, SQUARE, note="placements")
        self.assertIn("LINESTRING (2 1, 2 4)", made)
        nfp = self.file("nfp.wkt", made)
        third = ["--coords", "exact", "--scale", "1/3"]
        listed = self.file("nfp.geojson", self.fine("convert", nfp, "--format", "geojson"))
        for file in (nfp, listed):
            for each in ([], ["--each"]):
                wkt = [*each, "--format", "wkt"]
                self.assertEqual(self.fine("convert", file, *wkt), made)
                self.assertIn("LINESTRING (-2 -4, -2 -1)", self.fine("reflect", file, *wkt))
                self.assertIn("LINESTRING (5 1, 5 4)",
                              self.fine("transform", file, "--move", "3,0", *wkt))
                self.assertIn("LINESTRING (2/3 1/3, 2/3 4/3)",
                              self.fine("transform", file, *third, *wkt))
        for side in ("nearest", "outside", "inside"):
            self.assertIn("LINESTRING (0.67 0.33, 0.67 1.33)",
                          self.fine("transform", nfp, "--scale", "1/3", "--coords", "decimal:2",
                                    "--round", side))
            self.assertIn("LINESTRING (0.6666666666666666 0.3333333333333333, ",
                          self.fine("transform", nfp, "--scale", "1/3", "--round", side))
        self.assertNotIn("LINESTRING", self.fine("convert", nfp, "--regularize"))
        self.fails(2, "", "convert", nfp, "-o", self.folder / "nfp.poly")
        # Here one of the lines lies elsewhere. So these are parts of the set.
        self.assertEqual(self.fine("convert", made.replace("LINESTRING (2 1, 2 4)",
                                   "MULTILINESTRING ((2 1, 2 4), (20 0, 20 1))")).count("("), 4)
        bow_tie = "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))"
        both = self.file("both.wkt", f"GEOMETRYCOLLECTION ({bow_tie}, POINT (1 2))")
        self.fails(2, "both.wkt: polygon 1", "convert", both, "--strict")

    def test_parts_that_rounding_loses(self):
        # They vanished in silence.
        grains = ("MULTIPOLYGON (((0 0, 10 0, 10 10, 0 0), (6 2, 6.1 2, 6 2.1, 6 2)), "
                  "((20 20, 20.1 20, 20 20.1, 20 20)), ((30 30, 30.1 30, 30 30.1, 30 30)))")
        origin = "POINT (0 0)"
        told = "minksum: rounding loses 2 of 3 polygons, "
        for command in (["convert", grains], ["sum", grains, origin], ["union", grains, grains]):
            self.assertEqual(self.fine(*command, "--coords", "decimal:0",
                                       note=told + "1 of 1 holes, which vanish or become one"),
                             "POLYGON ((0 0, 10 0, 10 10, 0 0))\n")
            self.fine(*command, "--coords", "decimal:0", "--round", "inside", note=told + "which")
            self.assertIn("0.1", self.fine(*command))
            self.fine(*command, "--coords", "decimal:0", "--round", "outside")
        self.assertEqual(self.fine("convert", "MULTIPOINT (0 0, 0.1 0.1, 5 5)", "--coords",
                                   "decimal:0", note="rounding loses 1 of 3 points,"),
                         "MULTIPOINT ((0 0), (5 5))\n")
        grain = "POLYGON ((0 0, 0.1 0, 0 0.1, 0 0))"
        result = run("nfp", grain, grain, "--coords", "decimal:0")
        self.assertEqual(result.stdout, b"POLYGON EMPTY\n")
        self.assertIn(b"rounding loses 1 of 1 polygons,", result.stderr)

    def test_properties(self):
        geometry = '"geometry":{"type":"Point","coordinates":[1,2]}'
        feature = '{"type":"Feature","id":7,"properties":{"price": 1.50, "name":"\\u00e9"},%s}'
        p = self.file("p.json", feature % geometry)
        both = self.file("both.json", '{"type":"FeatureCollection","features":[%s]}' %
                         (feature % geometry))
        q = self.file("q.wkt", SQUARE)
        expected = ('{"type": "Feature", "properties": {"price": 1.50, "name":"\\u00e9"}, '
                    '"geometry": {"type": "Polygon", "coordinates": '
                    '[[[1,2], [3,2], [3,4], [1,4], [1,2]]]}}\n')
        for first in (p, both):
            self.assertEqual(self.fine("sum", first, q, "--keep-properties", "--format", "geojson"),
                             expected)
        self.assertNotIn("Feature", self.fine("sum", p, q, "--format", "geojson"))
        self.fails(2, "q.wkt: --keep-properties needs a single GeoJSON Feature", "sum", q, p,
                   "--keep-properties", "--format", "geojson")

    def test_picture(self):
        picture = self.folder / "picture.svg"
        self.sum(f"GEOMETRYCOLLECTION ({SQUARE}, LINESTRING (4 4, 8 8), POINT (9 0))",
                 "LINESTRING (0 0, 1 3)", "--svg", picture)
        text = picture.read_text()
        xml.etree.ElementTree.fromstring(text)
        for mark in ('"region first"', '"thin first"', '"dot first"', '"thin second"',
                     '"region sum"', '"thin sum"'):
            self.assertIn(mark, text)


class Statistics(ProgramTest):
    def test_keys(self):
        p, q = self.file("p.wkt", FRAME), self.file("q.wkt", TRIANGLE)
        stats = self.folder / "stats.json"
        self.fine("sum", p, q, "--stats", stats, "--repeat", "3")
        found = json.loads(stats.read_text())
        self.assertEqual([set(o) >= {"vertices", "holes", "parts"} for o in found["operands"]],
                         [True, True])
        self.assertEqual(found["operands"][0]["vertices"], 8)
        self.assertEqual(found["operands"][0]["holes"], 1)
        self.assertEqual(found["operands"][1]["parts"], 1)
        self.assertEqual(set(found["result"]) & {"vertices", "holes", "parts", "area"},
                         {"vertices", "holes", "parts", "area"})
        self.assertEqual(list(found["seconds"]), ["read", "sum", "round", "write", "stages"])
        self.assertEqual(list(found["seconds"]["stages"]),
                         ["operands", "convolution", "cover", "arrangement", "loops", "filters",
                          "output"])
        self.assertGreater(found["seconds"]["sum"], 0)
        self.assertLessEqual({"convolution_segments", "segments_kept", "crossings", "loops",
                              "rejected_by_nesting", "rejected_by_collision"}, set(found["counts"]))
        self.assertLessEqual({"coordinate_bits", "by_filter", "by_fixed_width", "by_arbitrary"},
                             set(found["arithmetic"]))

    def test_area(self):
        p = self.file("p.wkt", SQUARE)
        out = self.folder / "sum.wkt"
        text = self.fine("sum", p, p, "--stats", "-", "-o", out, "--coords", "exact")
        self.assertEqual(json.loads(text)["result"]["area"], 16)
        self.assertEqual(json.loads(text)["result"]["area_exact"], "16")

    def test_verbose_speaks_on_standard_error(self):
        p = self.file("p.wkt", SQUARE)
        result = run("sum", p, p, "--verbose")
        self.assertEqual(result.stdout.decode(), SQUARES)
        self.assertIn("4 vertices", result.stderr.decode())


class Files(ProgramTest):
    def setUp(self):
        super().setUp()
        self.p = self.file("p.wkt", SQUARE)

    def test_output_replaces_the_operand(self):
        self.fine("sum", self.p, self.p, "-o", self.p)
        self.assertEqual(self.p.read_text(), SQUARES)
        self.assertEqual([f.name for f in self.folder.iterdir()], ["p.wkt"])

    def test_failure_keeps_the_old_file(self):
        out = self.file("out.wkt", "precious")
        bad = self.file("bad.wkt", "POLYGON ((0 0")
        self.fails(2, "bad.wkt:1:", "sum", bad, self.p, "-o", out)
        self.assertEqual(out.read_text(), "precious")
        self.assertEqual(len(list(self.folder.iterdir())), 3)

    def test_failure_keeps_all_old_files(self):
        old = {name: self.file(name, "precious") for name in ("a.wkt", "b.wkt", "c.json", "d.svg")}
        full = "/dev/full"
        bracket = os.path.join(EXAMPLES, "bracket.wkt")
        outputs = {"-o": old["a.wkt"], "--tight": old["b.wkt"], "--stats": old["c.json"],
                   "--svg": old["d.svg"]}
        for failing in outputs:
            words = [word for pair in {**outputs, failing: full}.items() for word in pair]
            trace = self.folder / "trace"
            self.fails(2, "No space left", "sum", self.p, self.p, *words, "--trace", trace)
            self.assertEqual({path.read_text() for path in old.values()}, {"precious"})
            self.assertEqual(list(trace.iterdir()), [])
        out = old["a.wkt"]
        for command in (["dilate", self.p, self.p], ["nfp", self.p, self.p],
                        ["ifp", bracket, self.p], ["offset", self.p, "-d1"],
                        ["cspace", self.p, bracket, "--angles", "4"],
                        ["reach", self.p, bracket, "--angles", "4", "--from", "20,20,0", "--to",
                         "21,20,0"]):
            self.fails(2, "No space left", *command, "-o", out, "--svg", full)
            self.assertEqual(out.read_text(), "precious", command)
        self.fails(2, "No space left", "cspace", self.p, bracket, "--angles", "4", "-o", out,
                   "--slices", self.folder / "slices", "--stats", full)
        self.assertEqual(list((self.folder / "slices").iterdir()), [])
        out = old["d.svg"]
        for command in (["depth", self.p, bracket, "--svg", out],
                        ["sum", self.p, self.p, "--svg", out],
                        ["reach", self.p, bracket, "--angles", "4", "--from", "20,20,0", "--to",
                         "21,20,0", "-o", out]):
            self.fails(2, "No space left", *command, before=lambda: os.dup2(
                os.open("/dev/full", os.O_WRONLY), 1))
            self.assertEqual(out.read_text(), "precious", command)
        self.assertEqual([f.name for f in self.folder.iterdir() if f.suffix == ".tmp"], [])

    def test_one_file_for_two_outputs(self):
        """Two outputs to one file are refused before anything is written, by whatever paths."""
        bracket = os.path.join(EXAMPLES, "bracket.wkt")
        (self.folder / "sub").mkdir()
        (self.folder / "here").symlink_to(self.folder)
        there = self.file("there", "precious")
        (self.folder / "link").symlink_to(there)
        (self.folder / "dangling").symlink_to("new")
        os.link(there, self.folder / "hard")
        robot = ["--angles", "4"]
        ends = ["--from", "20,20,0", "--to", "21,20,0"]
        commands = [(["sum", self.p, self.p], ("-o", "--tight", "--stats", "--svg")),
                    (["dilate", self.p, self.p], ("-o", "--svg")),
                    (["nfp", self.p, self.p], ("-o", "--svg")),
                    (["ifp", bracket, self.p], ("-o", "--svg")),
                    (["offset", self.p, "-d1"], ("-o", "--svg")),
                    (["cspace", self.p, bracket, *robot], ("-o", "--svg", "--stats")),
                    (["reach", self.p, bracket, *robot, *ends], ("-o", "--svg"))]
        before = sorted(self.folder.iterdir())
        for command, options in commands:
            for first, second in zip(options, options[1:]):
                for a, b in (("new", "new"), ("there", "there"), ("new", "./new"),
                             ("new", "sub/../new"), ("new", "here/new"), ("new", "dangling"),
                             ("there", "link"), ("there", "hard"), ("here/link", "there"),
                             ("new", self.folder / "new")):
                    self.fails(1, f"{first} and {second} are the same file", *command, first, a,
                               second, b, cwd=self.folder)
        for option, name in (("--trace", "7-result.svg"), ("--trace", "3-cover.svg")):
            self.fails(1, f"--svg and {option} are the same file", "sum", self.p, self.p, option,
                       "sub", "--svg", f"here/sub/{name}", cwd=self.folder)
        self.fails(1, "--svg and --slices are the same file", "cspace", self.p, bracket, *robot,
                   "--slices", "sub", "--svg", "sub/slice-003.svg", cwd=self.folder)
        self.assertEqual(sorted(self.folder.iterdir()), before)
        self.assertEqual(list((self.folder / "sub").iterdir()), [])
        self.assertEqual(there.read_text(), "precious")

    def test_standard_output_is_a_file_too(self):
        shown = self.file("shown", "")
        for command in (["sum", self.p, self.p], ["depth", self.p, self.p]):
            self.fails(1, "--svg is the file that standard output goes to", *command, "--svg", shown,
                       before=lambda: os.dup2(os.open(shown, os.O_WRONLY), 1))
        self.assertEqual(shown.read_text(), "")

    def test_a_file_that_others_write_to_stays(self):
        log = self.file("log", "earlier line\n")
        for stream, options in ((1, ["-o", "/dev/stdout"]), (1, ["-o", log]),
                                (1, ["-o", "x.wkt", "--stats", "/dev/stdout"]),
                                (2, ["--stats", "/dev/stderr"])):
            done = run("sum", self.p, self.p, *options, cwd=self.folder, before=lambda s=stream:
                       os.dup2(os.open(log, os.O_WRONLY | os.O_APPEND), s))
            self.assertEqual(done.returncode, 1, options)
            self.assertTrue(log.read_text().startswith("earlier line\n"), options)
        self.assertFalse((self.folder / "x.wkt").exists())
        self.assertIn("--stats is the file that standard error goes to", log.read_text())

    def test_an_empty_name_is_no_file(self):
        for words in (["-o", ""], ["--stats", ""], ["--svg", ""], ["--trace", ""]):
            self.fails(1, "needs a name, not an empty text", "sum", self.p, self.p, *words)
        self.fails(1, "P: needs a name, not an empty text", "sum", "", self.p)

    def test_devices_may_be_named_twice(self):
        self.fine("sum", self.p, self.p, "-o", "/dev/null", "--svg", "/dev/null", "--stats",
                  "/dev/null")
        text = self.fine("sum", self.p, self.p, "-o", "/dev/stdout", "--tight", "/dev/stdout")
        self.assertEqual(text, SQUARES + "POLYGON EMPTY\n")

    def test_rights_and_links_stay(self):
        out = self.file("out.wkt", "old")
        out.chmod(0o640)
        link = self.folder / "link.wkt"
        link.symlink_to(out)
        self.fine("sum", self.p, self.p, "-o", link)
        self.assertTrue(link.is_symlink())
        self.assertEqual(out.read_text(), SQUARES)
        self.assertEqual(stat.S_IMODE(out.stat().st_mode), 0o640)

    def test_only_rights_to_read_write_and_run_stay(self):
        """A set-user-ID bit was given to the old content."""
        for mode in (0o4755, 0o2775, 0o1777, 0o7644, 0o600, 0o444 | 0o200):
            outputs = {option: self.file(name, "old") for option, name in (
                ("-o", "out.wkt"), ("--svg", "out.svg"), ("--stats", "out.json"),
                ("--tight", "tight.wkt"))}
            for out in outputs.values():
                out.chmod(mode)
            self.fine("sum", self.p, self.p, *[w for pair in outputs.items() for w in pair])
            for out in outputs.values():
                self.assertNotEqual(out.read_text(), "old")
                self.assertEqual(stat.S_IMODE(out.stat().st_mode), mode & 0o777)

    def test_access_list_stays(self):
        """With an access list, the bits of the group are the maximum for all of its entries."""
        name = "system.posix_acl_access"
        out = self.file("out.wkt", "old")
        entries = [(1, 6, -1), (2, 4, 12345), (4, 0, -1), (16, 4, -1), (32, 0, -1)]
        given = struct.pack("<I", 2) + b"".join(struct.pack("<HHi", *entry) for entry in entries)
        try:
            os.setxattr(out, name, given)
        except OSError as error:
            self.skipTest(f"the file system has no access control lists: {error}")
        self.fine("sum", self.p, self.p, "-o", out)
        self.assertEqual(out.read_text(), SQUARES)
        self.assertEqual(os.getxattr(out, name), given)
        self.assertEqual(stat.S_IMODE(out.stat().st_mode), 0o640)

    def test_owner_stays(self):
        out = self.file("out.wkt", "old")
        try:
            os.chown(out, 12345, 23456)
        except PermissionError:
            self.skipTest("only root can give files away")
        self.fine("sum", self.p, self.p, "-o", out)
        self.assertEqual(out.read_text(), SQUARES)
        self.assertEqual((out.stat().st_uid, out.stat().st_gid), (12345, 23456))

    def test_links_and_pipes_in_folders_are_refused(self):
        """The program chose those names, so the user did not ask for what they lead to."""
        bracket = os.path.join(EXAMPLES, "bracket.wkt")
        target = self.file("target", "precious")
        commands = (("7-result.svg", ["sum", self.p, self.p, "--trace"]),
                    ("3-cover.json", ["sum", self.p, self.p, "--trace"]),
                    ("slice-003.svg", ["cspace", self.p, bracket, "--angles", "4", "--slices"]))
        for name, command in commands:
            folder = self.folder / "folder"
            folder.mkdir()
            place = folder / name
            for make in (lambda: place.symlink_to(target), lambda: place.symlink_to("nowhere"),
                         lambda: os.mkfifo(place), place.mkdir):
                make()
                self.fails(2, f"{name}: is not a file, but a file of this name is to be written",
                           *command, folder)
                self.assertEqual(list(folder.iterdir()), [place])
                place.rmdir() if place.is_dir() and not place.is_symlink() else place.unlink()
            self.fine(*command, folder)
            self.fine(*command, folder)  # replaces the files of the first run
            shutil.rmtree(folder)
        self.assertEqual(target.read_text(), "precious")

    def test_no_place_to_write(self):
        self.fails(2, "there is no folder", "sum", self.p, self.p, "-o", self.folder / "no" / "x")
        self.fails(2, "Is a directory", "sum", self.p, self.p, "-o", self.folder)
        self.fails(2, "No space left", "sum", self.p, self.p, "-o", "/dev/full")
        self.fails(2, "there is no folder", "sum", self.p, self.p, "--stats",
                   self.folder / "no" / "x")
        self.fails(2, "", "sum", self.p, self.p, "--trace", self.p)
        with open("/dev/full", "wb") as full:
            import subprocess
            from support import PROGRAM
            done = subprocess.run([PROGRAM, "sum", self.p, self.p], stdout=full,
                                  stderr=subprocess.PIPE, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"No space left", done.stderr)

    def test_picture(self):
        picture = self.folder / "picture.svg"
        self.fine("sum", self.p, self.p, "-o", self.folder / "s.wkt", "--svg", picture)
        root = xml.etree.ElementTree.parse(picture).getroot()
        self.assertTrue(root.tag.endswith("svg"))
        self.assertEqual(len(root.findall("{http://www.w3.org/2000/svg}path")), 3)


class BeyondDoubles(ProgramTest):
    """Coordinates beyond all doubles are an error of outputs with doubles, which is named."""

    def setUp(self):
        super().setUp()
        self.huge = self.file("huge.wkt", "POLYGON ((0 0, 1e400 0, 0 1e400, 0 0))")
        self.square = self.file("square.wkt", SQUARE)
        self.line = self.file("line.wkt", "LINESTRING (0 0, -1e400 3)")
        self.bracket = os.path.join(EXAMPLES, "bracket.wkt")
        self.out = self.file("out", "precious")

    def test_results(self):
        commands = [["sum", self.huge, self.square], ["sum", self.square, self.line],
                    ["dilate", self.huge, self.square], ["erode", self.huge, self.square],
                    ["nfp", self.huge, self.square], ["ifp", self.huge, self.square],
                    ["offset", self.huge, "-d1", "--join", "miter"],
                    ["cspace", self.square, self.huge, "--angles", "4"]]
        hint = "a coordinate is beyond the range of doubles (--coords exact, or decimal:N)"
        for command in commands:
            for side in ("nearest", "outside", "inside"):
                result = self.fails(3, hint, *command, "--round", side, "-o", self.out)
                self.assertTrue(result.stderr.startswith(b"minksum: %b: " % bytes(self.out)))
            self.fails(3, "minksum: standard output: ", *command)
            for coordinates in ("exact", "decimal:2"):
                self.fine(*command, "-q", "--coords", coordinates)
        for form in ("wkt", "geojson", "poly", "svg"):
            self.fails(3, f"{self.out}: ", "sum", self.huge, self.square, "--format", form, "-o",
                       self.out)
        self.assertEqual(self.out.read_text(), "precious")

    def test_pictures(self):
        no_picture = f"{self.out}: no picture: "
        exact = ["--coords", "exact"]
        for command in (["sum", self.huge, self.square, *exact, "--format", "svg", "-o"],
                        ["sum", self.square, self.line, *exact, "--format", "svg", "-o"],
                        ["sum", self.huge, self.square, *exact, "--svg"],
                        ["dilate", self.huge, self.square, *exact, "--svg"],
                        ["nfp", self.huge, self.square, *exact, "--svg"],
                        ["offset", self.huge, "-d1", "--join", "miter", *exact, "--svg"],
                        ["depth", self.huge, self.square, "--svg"],
                        ["cspace", self.square, self.huge, "--angles", "4", *exact, "--svg"],
                        ["draw", self.huge, "-o"], ["draw", self.line, "-o"]):
            self.fails(3, no_picture, *command, self.out)
        self.assertEqual(self.out.read_text(), "precious")
        folder = self.folder / "folder"
        for command in (["sum", self.huge, self.square, *exact, "--trace"],
                        ["cspace", self.square, self.huge, "--angles", "4", *exact, "--slices"]):
            self.fails(3, "no picture: ", *command, folder)
            self.assertIn(f"minksum: {folder}", run(*command, folder).stderr.decode())
            self.assertEqual(list(folder.iterdir()), [])

    def test_answers_are_json(self):
        """Numbers beyond doubles are null there, and exact numbers stand beside them."""
        stats = self.folder / "stats.json"
        self.fine("sum", self.huge, self.square, "--coords", "exact", "--stats", stats)
        result = json.loads(stats.read_text())["result"]
        self.assertIsNone(result["area"])
        self.assertEqual(len(result["area_exact"].partition("/")[0]), 800)
        found = json.loads(self.fine("info", self.huge, "--json"))
        self.assertIsNone(found["area"])
        self.assertEqual(found["box"]["max"], ["1" + "0" * 400] * 2)
        found = json.loads(self.fine("depth", self.huge, self.file(
            "far.wkt", "POLYGON ((3e400 0, 4e400 0, 4e400 1, 3e400 0))"), "--json"))
        self.assertEqual(found["relation"], "apart")
        self.assertIsNone(found["distance"])
        self.assertIsNone(found["vector"][0])

    def test_paths(self):
        robot = ["reach", self.square, self.file("obstacle.wkt", "POINT (0 1)"), "--angles", "1",
                 "--from", "1e400,5,0", "--to", "2e400,5,0"]
        message = ": the path is beyond the range of doubles; --json has exact numbers"
        self.fails(3, "standard output" + message, *robot)
        self.fails(3, f"{self.out}{message}", *robot, "-o", self.out)
        found = json.loads(self.fine(*robot, "--json"))
        self.assertEqual(found["path"][0]["at_exact"], ["1" + "0" * 400, "5"])
        self.assertEqual(found["path"][0]["at"], [None, 5.0])

    def test_jobs(self):
        job = {"operation": "sum", "a": "huge.wkt", "b": "square.wkt"}
        jobs = self.file("jobs.jsonl", json.dumps(job))
        result = json.loads(run("batch", jobs).stdout)
        message = ("polygon 1, ring 1, vertex 2: a coordinate is beyond the range of doubles "
                   "(--coords exact, or decimal:N)")
        self.assertEqual(result["error"], {"code": "limit", "message": message})
        parts = self.folder / "parts"
        parts.mkdir()
        shutil.copy(self.huge, parts)
        result = json.loads(run("batch", "--pairs", parts).stdout)
        self.assertEqual(result["error"]["code"], "limit")


class Usage(ProgramTest):
    def test_wrong_usage(self):
        p = self.file("p.wkt", SQUARE)
        for arguments in ([], ["sum"], ["sum", p], ["sum", p, p, p], ["sum", "-", "-"],
                          ["add", p, p], ["sum", p, p, "--blue"], ["sum", p, p, "-o"],
                          ["sum", p, p, "--format", "dxf"], ["sum", p, p, "--method", "magic"],
                          ["sum", p, p, "--coords", "decimal"], ["sum", p, p, "--coords", "exactly"],
                          ["sum", p, p, "--coords", "decimal:-1"],
                          ["sum", p, p, "--coords", "decimal:99999"],
                          ["sum", p, p, "--repeat", "0"], ["sum", p, p, "--repeat", "x"],
                          ["sum", p, p, "--stats", "-"], ["sum", p, p, "--svg", "-"],
                          ["sum", p, p, "--arithmetic", "float"], ["info"], ["info", "-", "-"],
                          ["sum", p, p, "--grid", "-1"], ["sum", p, p, "--grid", "4097"], ["sum", p, p, "--fill", "odd"],
                          ["sum", p, p, "--round", "up"], ["info", p, "--fill", "odd"],
                          ["sum", p, p, "--coords", "exact", "--round", "outside"],
                          ["sum", p, p, "--keep-properties"],
                          ["sum", p, p, "--keep-properties", "-o", self.folder / "x.wkt"],
                          ["sum", p, p, "--tight", "-"], ["sum", p, p, "--tight", "x.poly"],
                          ["sum", p, p, "--tight", self.folder / "x", "--method", "signed"],
                          ["sum", p, p, "--tight", "-", "--stats", "-", "-o", self.folder / "x"],
                          ["sum", p, p, "--trace", self.folder / "t", "--method", "signed"]):
            with self.subTest(str(arguments)):
                self.fails(1, "", *arguments)

    def test_help_and_version(self):
        self.assertRegex(self.fine("--version"), r"^minksum \d+\.\d+\.\d+\n$")
        for arguments in (["--help"], ["sum", "--help"], ["info", "--help"]):
            text = self.fine(*arguments)
            self.assertRegex(text, re.compile("exit codes: 0 fine, 1 wrong usage", re.I))
        for option in ("--coords", "--method", "--stats", "--svg", "--trace", "--repeat", "--format",
                       "--fill", "--regularize", "--round", "--tight", "--keep-properties",
                       "--max-memory", "--max-segments", "--timeout"):
            self.assertIn(option, self.fine("sum", "--help"))


if __name__ == "__main__":
    main()
