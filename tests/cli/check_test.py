"""Tests that minksum check accepts right sums, and finds and locates errors."""
import json

from support import FRAME, SQUARE, TRIANGLE, ProgramTest, main, run


class Check(ProgramTest):
    def setUp(self):
        super().setUp()
        self.p = self.file("p.wkt", FRAME)
        self.q = self.file("q.wkt", "POLYGON ((0 0, 2 0, 1/3 2, 0 0))")
        self.sum = self.folder / "sum.wkt"
        self.fine("sum", self.p, self.q, "--coords", "exact", "-o", self.sum)

    def verdict(self, result, *extra):
        """Returns the exit code and the report."""
        run_ = run("check", result, self.p, self.q, "--json", *extra)
        return run_.returncode, json.loads(run_.stdout)

    def test_right(self):
        code, report = self.verdict(self.sum)
        self.assertEqual((code, report["ok"], report["proof"]), (0, True, "holds"))
        self.assertEqual(report["result_area"], report["sum_area"])
        text = self.fine("check", self.sum, self.p, self.q)
        self.assertEqual(text.splitlines()[-1], "verdict   no error found")

    def test_operands_that_do_not_fit(self):
        for words in (("-", "-", self.q), ("-", self.p, "-"), (self.p, "-", "-")):
            self.fails(1, "only one file can be standard input", "check", *words)
        here, there = "SRID=4326;POINT (0 0)", "SRID=3857;POINT (0 0)"
        for words in ((here, there, self.q), (here, self.p, there), (self.p, here, there)):
            self.fails(2, "the reference system EPSG:3857 differs from EPSG:4326", "check", *words)

    def test_a_lost_hole(self):
        text = self.sum.read_text()
        filled = self.file("filled.wkt", text[:text.index("), (")] + "))")
        code, report = self.verdict(filled)
        self.assertEqual((code, report["ok"], report["proof"]), (5, False, "refuted"))
        self.assertGreater(report["surplus"]["area"], 0)
        self.assertIsNone(report["missing"].get("near"))
        x, y = report["surplus"]["near"]
        self.assertTrue(3 < x < 6 and 3 < y < 6)
        self.assertTrue(report["examples"][0]["in_result"])
        # Points alone find the error as well.
        code, report = self.verdict(filled, "--proof-segments", "1")
        self.assertEqual((code, report["proof"]), (5, "not tried"))
        self.assertGreater(report["disagreements"], 0)

    def test_rounded(self):
        rounded = self.folder / "rounded.wkt"
        self.fine("sum", self.p, self.q, "--coords", "decimal:2", "-o", rounded)
        self.assertEqual(self.verdict(rounded)[0], 5)
        self.assertEqual(self.verdict(rounded, "--within", "0.005")[0], 0)
        self.assertEqual(self.verdict(rounded, "--within", ".005")[0], 0)
        self.assertEqual(self.verdict(rounded, "--within", "1/1000000")[0], 5)

    def test_numbers_are_short(self):
        tenth = self.file("tenth.wkt", "POLYGON ((0 0, 0.1 0, 0.1 0.7, 0 0.7, 0 0))")
        origin = self.file("origin.wkt", "POINT (0 0)")
        wrong = self.file("wrong.wkt", "POLYGON ((0.1 0, 0.2 0, 0.2 0.7, 0.1 0.7, 0.1 0))")
        text = run("check", wrong, tenth, origin).stdout.decode()
        self.assertIn(" (near 0.05 0.35)\n", text)
        self.assertIn(" (near 0.15 0.35)\n", text)
        self.assertIn("wrong     0.2 0.7 is in the result", text)

    def test_invalid_result(self):
        bow_tie = self.file("bow_tie.wkt", "POLYGON ((0 0, 9 9, 9 0, 0 9, 0 0))")
        code, report = self.verdict(bow_tie)
        self.assertEqual((code, report["valid"]), (5, False))
        self.assertTrue(report["faults"])

    def test_thin_parts(self):
        line = self.file("line.wkt", "LINESTRING (0 0, 5 1)")
        point = self.file("point.wkt", "POINT (1 2)")
        self.fine("check", self.file("moved.wkt", "LINESTRING (1 2, 6 3)"), line, point)
        self.assertEqual(
            run("check", self.file("less.wkt", "LINESTRING (1 2, 5 2.8)"), line, point).returncode, 5)

    def test_wrong_usage_and_input(self):
        self.fails(1, "--within", "check", self.sum, self.p, self.q, "--within", "-1")
        self.fails(1, "--within", "check", self.sum, self.p, self.q, "--within", "near")
        self.fails(1, "±4096", "check", self.sum, self.p, self.q, "--within", "1e-5000")
        self.fails(1, "Q is missing", "check", self.sum, self.p)
        self.fails(2, "nothing.wkt", "check", self.folder / "nothing.wkt", self.p, self.q)
        bow_tie = self.file("bow_tie.wkt", "POLYGON ((0 0, 9 9, 9 0, 0 9, 0 0))")
        self.fails(2, "bow_tie.wkt", "check", self.sum, bow_tie, self.q, "--fill", "strict")
        self.assertEqual(run("check", self.file("s.wkt", SQUARE), self.file("t.wkt", TRIANGLE),
                             self.file("e.wkt", "POLYGON EMPTY")).returncode, 5)


if __name__ == "__main__":
    main()
