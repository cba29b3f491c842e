"""Tests what minksum info says about a region."""
import json
import math
import random
import sys
from fractions import Fraction

from support import FRAME, SQUARE, ProgramTest, main, run


class Info(ProgramTest):
    def meaning(self, content, *extra):
        text = run("info", self.file("shape.txt", content), *extra).stdout.decode()
        return text.splitlines()[-1].split(None, 1)[1]

    def test_text(self):
        text = self.fine("info", self.file("frame.wkt", FRAME))
        rows = dict(line.split(None, 1) for line in text.splitlines())
        self.assertEqual(rows["parts"], "1")
        self.assertEqual(rows["holes"], "1")
        self.assertEqual(rows["vertices"], "8")
        self.assertEqual(rows["x"], "from 0 to 9")
        self.assertEqual(rows["area"], "72")
        self.assertEqual(rows["bits"], "4")
        self.assertEqual(rows["valid"], "yes")

    def test_exact_numbers(self):
        text = self.fine("info", self.file("p.wkt", "POLYGON ((0 0, 0.1 0, 0.1 1/3, 0 0))"))
        self.assertIn("x         from 0 to 0.1\n", text)
        self.assertIn("y         from 0 to about 0.33333333333333", text)
        self.assertIn("area      about 0.016666666666666", text)
        text = self.fine("info", self.folder / "p.wkt", "--exact")
        self.assertIn("y         from 0 to 1/3 (about 0.33333333333333", text)
        self.assertIn("area      1/60 (about ", text)

    def test_several_files(self):
        frame, square = self.file("frame.wkt", FRAME), self.file("square.wkt", SQUARE)
        text = self.fine("info", frame, square)
        self.assertEqual([line.split()[1] for line in text.splitlines() if line[:4] == "file"],
                         [str(frame), str(square)])
        self.assertEqual(text.count("valid     yes\n"), 2)
        reports = json.loads(self.fine("info", frame, square, "--json"))
        self.assertEqual([(r["file"], r["area"]) for r in reports],
                         [(str(frame), 72), (str(square), 4)])
        self.fails(1, "several files cannot all be standard input", "info", "-", "-")
        self.fails(2, "nowhere.wkt: cannot be read", "info", frame, self.folder / "nowhere.wkt")

    def test_only_strict_makes_faults_an_error(self):
        bow = self.file("bow.wkt", "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))")
        self.assertIn("valid     no\n", self.fine("info", bow))
        self.assertIn("valid     no\n", self.fine("info", bow, "--fill", "evenodd"))
        self.fails(2, "bow.wkt: not valid: polygon 1, ring 1, vertex 1: edges cross at (1, 1)",
                   "info", self.file("square.wkt", SQUARE), bow, "--strict")

    def test_long_numbers(self):
        """They are exact and in lowest terms in JSON, and approximate for people."""
        rng = random.Random(4)
        ring = []
        for x, y in [(i, i * i) for i in range(-10, 11)]:
            below = [rng.randrange(10**3998, 10**3999) | 1 for _ in "xy"]
            ring.append(tuple(Fraction(c * q + 1, q) for c, q in zip((x, y), below)))
        file = self.file("long.wkt", "POLYGON ((" + ", ".join(
            f"{x.numerator}/{x.denominator} {y.numerator}/{y.denominator}"
            for x, y in ring + ring[:1]) + "))")
        text = self.fine("info", file)
        self.assertLess(max(map(len, text.splitlines())), 200)
        self.assertRegex(text, r"x         from about -(9|10)[.\d]* \(\d+ bits; exactly with --json\)")
        self.assertIn("valid     yes", text)
        found = json.loads(self.fine("info", file, "--json"))
        # This is twice the area of vertices on a parabola, in one common denominator.
        common = math.prod(x.denominator * y.denominator for x, y in ring)
        crosses = [(a[0] * b[1], b[0] * a[1]) for a, b in zip(ring, ring[1:] + ring[:1])]
        doubled = sum(common // p.denominator * p.numerator -
                      common // q.denominator * q.numerator for p, q in crosses)
        sys.set_int_max_str_digits(0)
        above, below = map(int, found["area_exact"].split("/"))
        self.assertEqual(above * 2 * common, doubled * below)
        self.assertEqual(math.gcd(above, below), 1)
        self.assertEqual(found["meaning"]["area_exact"], found["area_exact"])
        wide = max(y for _, y in ring) - min(y for _, y in ring)
        grid = math.lcm(*(c.denominator for point in ring for c in point))
        self.assertEqual(found["coordinate_bits"], int(wide * grid).bit_length())

    def test_numbers_about(self):
        for typed, shown in (("1e400", "1e+400"), ("-25e4000", "-2.5e+4001"), ("3e-4000", "3e-4000"),
                             ("1e-320", "1e-320"), ("123456789e300", "1.23456789e+308"),
                             ("9" * 300, "1e+300"), ("1/" + "3" * 300, "3e-300")):
            text = self.fine("info", self.file("p.wkt", f"POINT ({typed} 0)"))
            self.assertIn(f"x         from about {shown} (", text)
        for typed in ("1e200", "-1e-200", "9" * 200):
            text = self.fine("info", self.file("p.wkt", f"POINT ({typed} 0)"), "--exact")
            self.assertNotIn("about", text.split("\n")[5].partition(" (about")[0])

    def test_json(self):
        found = json.loads(self.fine("info", "--json", self.file("frame.wkt", FRAME)))
        self.assertEqual((found["parts"], found["holes"], found["vertices"]), (1, 1, 8))
        self.assertEqual(found["box"], {"min": ["0", "0"], "max": ["9", "9"]})
        self.assertEqual((found["area"], found["area_exact"]), (72, "72"))
        self.assertIs(found["valid"], True)
        self.assertEqual(found["faults"], [])

    def test_every_fault_has_a_place(self):
        bad = self.file("bad.wkt", "MULTIPOLYGON (((0 0, 2 2, 2 0, 0 2, 0 0)), "
                                   "((10 0, 12 2, 12 0, 10 2, 10 0)))")
        result = run("info", "--json", "--strict", bad)
        self.assertEqual(result.returncode, 2)
        self.assertIn(b"not valid", result.stderr)
        found = json.loads(result.stdout)
        self.assertIs(found["valid"], False)
        self.assertEqual({fault["polygon"] for fault in found["faults"]}, {1, 2})
        for fault in found["faults"]:
            self.assertEqual(fault["ring"], 1)
            self.assertIn(fault["near"][1], (0, 1, 2))
        text = run("info", bad).stdout.decode()
        self.assertIn("valid     no\n", text)
        self.assertIn("fault     polygon 2, ring 1", text)

    def test_places_of_faults_are_short(self):
        text = run("info", self.file("bow.wkt", "POLYGON ((0.1 0.7, 0.3 0.9, 0.3 0.7, 0.1 0.9, 0.1 0.7))"),
                   "--strict")
        self.assertIn(b"edges cross at (0.2, 0.8)\n", text.stdout)
        self.assertIn(b"edges cross at (0.2, 0.8)\n", text.stderr)

    def test_each_crossing_is_a_fault_with_its_place(self):
        zigzag = self.file("zigzag.wkt", "POLYGON ((0 0, 12 0, 12 5, 9 -2, 7 2, 5 -2, 3 2, 0 5, 0 0))")
        result = run("info", "--json", zigzag)
        self.assertEqual(result.returncode, 0)
        faults = json.loads(result.stdout)["faults"]
        self.assertEqual(sorted(fault["at"] for fault in faults),
                         [["4", "0"], ["6", "0"], ["69/7", "0"], ["8", "0"]])
        for fault in faults:
            self.assertIn(1, (fault["vertex"], fault["meets"]["vertex"]))
            self.assertEqual(fault["near"][1], 0)

    def test_a_place_beyond_the_doubles(self):
        huge = self.file("huge.wkt", "POLYGON ((0 0, 1e400 1e400, 1e400 0, 0 1e400, 0 0))")
        fault = json.loads(run("info", "--json", huge).stdout)["faults"][0]
        self.assertEqual(fault["at"][0], "5" + 399 * "0")
        self.assertEqual(fault["near"], [None, None])

    def test_what_it_means(self):
        self.assertEqual(self.meaning(FRAME),
                         "8 vertices, 1 hole; area 72 (fill rule automatic)")
        spike = "POLYGON ((0 0, 2 0, 2 2, 5 5, 2 2, 0 2, 0 0))"
        self.assertEqual(self.meaning(spike),
                         "4 vertices, 1 polyline; area 4 (fill rule automatic)")
        self.assertEqual(self.meaning(spike, "--regularize"),
                         "4 vertices; area 4 (fill rule automatic)")
        self.assertEqual(self.meaning(spike, "--fill", "strict"), "none (fill rule strict)")
        self.assertEqual(self.meaning("MULTIPOINT (1 1, 2 2, 1 1)", "--fill", "evenodd"),
                         "2 points; area 0 (fill rule evenodd)")
        self.assertEqual(self.meaning("POLYGON EMPTY"), "empty; area 0 (fill rule automatic)")

    def test_a_meaning_with_too_many_crossings_is_not_computed(self):
        bow_ties = "MULTIPOLYGON (((0 0, 2 2, 2 0, 0 2, 0 0)), ((4 0, 6 2, 6 0, 4 2, 4 0)))"
        computed = "12 vertices, 4 parts; area 4 (fill rule automatic)"
        self.assertEqual(self.meaning(bow_ties, "--max-crossings", "4"), computed)
        nested = "POLYGON ((0 0, 9 9, 9 0, 0 9, 0 0), (0 2, 9 2, 9 3, 0 4, 0 2))"
        for rule in "automatic", "evenodd":
            self.assertEqual(
                self.meaning(nested, "--max-crossings", "2", "--fill", rule),
                f"not computed: more than 2 crossings (--max-crossings) (fill rule {rule})")
        result = run("info", "--json", "--max-crossings", "2", "--fill", "evenodd",
                     self.file("nested.wkt", nested))
        self.assertEqual(result.returncode, 0)
        found = json.loads(result.stdout)
        self.assertEqual((found["meaning"], found["crosses_more_than"]), (None, 2))

    def test_thin_geometries(self):
        text = self.fine("info", "-", stdin="GEOMETRYCOLLECTION (LINESTRING (0 0, 3 1/2), "
                                            "POINT (-1 7))")
        rows = dict(line.split(None, 1) for line in text.splitlines())
        self.assertEqual((rows["parts"], rows["polylines"], rows["points"]), ("0", "1", "1"))
        self.assertEqual((rows["x"], rows["y"]), ("from -1 to 3", "from 0 to 7"))
        self.assertEqual((rows["area"], rows["valid"]), ("0", "yes"))
        found = json.loads(self.fine("info", "--json", "-", stdin="LINESTRING (0 0, 4 0, 2 0)"))
        self.assertEqual((found["polylines"], found["points"], found["fill"]), (1, 0, "automatic"))
        self.assertEqual(found["meaning"], {"parts": 0, "holes": 0, "vertices": 0, "polylines": 1,
                                            "points": 0, "area": 0, "area_exact": "0"})
        result = run("info", "--json", "--fill", "strict", "-", stdin="POLYGON ((1 1))")
        self.assertIsNone(json.loads(result.stdout)["meaning"])

    def test_empty_region_and_standard_input(self):
        text = self.fine("info", "-", stdin="POLYGON EMPTY")
        self.assertIn("parts     0\n", text)
        self.assertIn("box       none", text)
        self.assertIn("vertices  4\n", self.fine("info", "-", stdin=SQUARE))


if __name__ == "__main__":
    main()
