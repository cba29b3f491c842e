"""Tests operands that are typed: geometries as WKT, and shapes by name."""
import json
import math

from support import SQUARE, ProgramTest, main, run

POINT = "POINT (0 0)"


class TypedOperands(ProgramTest):
    def corners(self, *arguments, **options):
        """Returns the corners of the only ring of a result."""
        text = self.fine(*arguments, "--format", "geojson", "--coords", "decimal:12", **options)
        rings = json.loads(text)["coordinates"]
        self.assertEqual(len(rings), 1)
        return rings[0][:-1]

    def test_wkt(self):
        file = self.file("square.wkt", SQUARE)
        expected = self.fine("sum", file, file)
        for typed in (SQUARE, SQUARE.lower(), "  " + SQUARE, "SRID=0;" + SQUARE,
                      SQUARE.replace("N (", "N\n(")):
            self.assertEqual(self.fine("sum", typed, file), expected)
            self.assertEqual(self.fine("sum", file, typed), expected)
        self.assertEqual(self.fine("sum", "POLYGON EMPTY", file), "POLYGON EMPTY\n")
        self.fails(2, "minksum: 'POLYGON ((0 0, 1 1)':1:10: polygon 1, ring 1", "sum",
                   "POLYGON ((0 0, 1 1)", file)
        self.fails(2, "'MULTIPOINT (0 0, 1 1, 2 2, 3 3, 4 4, 5 5...':1:", "sum",
                   "MULTIPOINT (0 0, 1 1, 2 2, 3 3, 4 4, 5 5, 6 6", file)
        self.fails(2, "No such file", "sum", "polygon.wkt", file)

    def test_wkt_is_typed_for_every_command(self):
        self.assertIn("area      4", self.fine("info", SQUARE))
        self.assertIn("no error found", self.fine("check", SQUARE, SQUARE, POINT))
        self.assertEqual(self.fine("erode", SQUARE, SQUARE, "--tight"), "POINT (0 0)\n")
        self.assertIn("overlapping", self.fine("depth", SQUARE, SQUARE))
        self.assertIn("<svg", self.fine("draw", SQUARE))
        self.assertEqual(self.fine("offset", SQUARE, "-d1", "--join=miter"),
                         "POLYGON ((-1 -1, 3 -1, 3 3, -1 3, -1 -1))\n")
        self.assertEqual(
            self.fine("reach", SQUARE, "POLYGON ((9 9, 10 9, 9 10, 9 9))", "--from=0,0,0",
                      "--to=1,1,0", "--angles=1", "--workspace=box:99x99").split()[0], "yes")

    def test_box(self):
        self.assertEqual(self.fine("sum", "box:3x1/2", POINT, "--coords", "exact"),
                         "POLYGON ((-3/2 -1/4, 3/2 -1/4, 3/2 1/4, -3/2 1/4, -3/2 -1/4))\n")
        self.assertEqual(self.fine("sum", "BOX:.5X1e1", POINT),
                         "POLYGON ((-0.25 -5, 0.25 -5, 0.25 5, -0.25 5, -0.25 -5))\n")
        for bad in ("box:", "box:3", "box:3x", "box:x3", "box:0x1", "box:1x-1", "box:axb"):
            self.fails(1, "takes", "sum", bad, POINT)

    def test_disc(self):
        for side, least, most in (("nearest", 2.9, 3.1), ("outside", 3, 3.1), ("inside", 2.9, 3)):
            corners = self.corners("sum", "disc:3", POINT, "--tolerance", ".1", "--side", side,
                                   note="disc:3: a polygon of")
            for (x, y), (u, v) in zip(corners, corners[1:] + corners[:1]):
                # An inner and an outer bound of the edge's distance from the centre.
                self.assertLessEqual(math.hypot(x, y), most + 1e-9)
                self.assertGreaterEqual(abs(x * v - y * u) / math.hypot(u - x, v - y),
                                        least - 1e-9)
        default = self.fine("sum", "disc:3", POINT, note="within 0.003 of the disc")
        self.assertEqual(
            self.fine("sum", "disk:3", POINT, "--tolerance", ".003", note="disk:3:"), default)
        self.assertEqual(self.fine("sum", "disc:3", POINT, "-q"), default)
        for bad in ("disc:", "disc:0", "disc:-1", "disc:one", "disc:1x1"):
            self.fails(1, "disc:R takes", "sum", bad, POINT)

    def test_ngon(self):
        self.assertEqual(self.fine("sum", "ngon:4:2", POINT, "--side", "outside"),
                         "POLYGON ((-2 0, 0 -2, 2 0, 0 2, -2 0))\n")
        for count in (3, 5, 6, 17, 400):
            corners = self.corners("sum", f"ngon:{count}:2", POINT, "--tolerance", "1/1000",
                                   note="corners on the circle")
            self.assertEqual(len(corners), count)
            angles = sorted(math.atan2(y, x) % (2 * math.pi) for x, y in corners)
            for x, y in corners:
                self.assertAlmostEqual(math.hypot(x, y), 2, places=10)
            for k, angle in enumerate(angles):
                self.assertLess(abs(angle - 2 * math.pi * k / count) * 2, 1.1e-3)
        for bad in ("ngon:", "ngon:2:1", "ngon:5", "ngon:5:", "ngon:5.5:1", "ngon:100001:1",
                    "ngon:5:0"):
            self.fails(1, "ngon:N:R takes", "sum", bad, POINT)
        self.fails(1, "--side is for discs and drawings", "sum", "ngon:5:1", POINT,
                   "--side", "inside")
        self.fails(1, "takes a --tolerance from 2e-12 on", "sum", "ngon:5:1", POINT,
                   "--tolerance", "1e-12")

    def test_options_that_nothing_takes(self):
        # They were ignored in silence.
        square = self.file("square.wkt", SQUARE)
        table = self.file("table.csv", "id,geom\n1,POINT (0 0)\n")
        drawing = self.file("drawing.svg", '<svg xmlns="http://www.w3.org/2000/svg">'
                                           '<rect width="1" height="1"/></svg>')
        pin = self.file("pin.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nA\n10\n0\n20\n0\n11\n1\n"
                                   "21\n1\n0\nENDSEC\n0\nEOF\n")
        takes = {"--tolerance 0.1": (drawing, pin), "--side outside": (drawing, pin),
                 "--layer A": (pin,), "--join-ends 1": (pin,), "--column geom": (table,)}
        for option, files in takes.items():
            note = option.split()[0] + " has no effect: nothing that was read is "
            for file in (square, table, drawing, pin, "box:1x1", SQUARE):
                for command in (["convert", file], ["convert", file, "--each"],
                                ["sum", "box:1x1", file], ["info", file]):
                    result = run(*command, *option.split())
                    told = result.stderr.decode()
                    self.assertEqual(result.returncode, 0, told)
                    self.assertEqual(told.count(note), file not in files, (command, told))
            self.assertEqual(run("convert", square, *option.split(), "-q").stderr, b"")
        self.fine("offset", square, "-d1", "--join=miter", "--tolerance", "0.1")
        self.fine("sum", "disc:1", POINT, "--tolerance", "0.1", note="disc:1: a polygon of")

    def test_a_file_of_such_a_name(self):
        self.file("box:1x1", SQUARE)
        shape = "POLYGON ((-0.5 -0.5, 0.5 -0.5, 0.5 0.5, -0.5 0.5, -0.5 -0.5))\n"
        self.assertEqual(self.fine("sum", "box:1x1", POINT, cwd=self.folder,
                                   note="is taken as a shape; the file of that name is ./box:1x1"),
                         shape)
        self.assertEqual(self.fine("sum", "./box:1x1", POINT, cwd=self.folder), SQUARE + "\n")

    def test_a_file_whose_name_begins_as_wkt_does(self):
        (self.folder / "Polygons (old)").mkdir()
        names = ("polygon (1).wkt", "points (copy).geojson", "Polygons (old)/a.wkt",
                 "point empty.txt", "Polygon (2)", "srid=4326 (final).wkt")
        for name in names:
            self.file(name, SQUARE)
            self.assertEqual(self.fine("sum", name, POINT, cwd=self.folder), SQUARE + "\n")
        self.assertEqual(self.fine("convert", names[0], "--each", cwd=self.folder), SQUARE + "\n")
        self.fails(2, "minksum: polygon (9).wkt: cannot be read: No such file", "info",
                   "polygon (9).wkt", cwd=self.folder)


if __name__ == "__main__":
    main()
