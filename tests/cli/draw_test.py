"""Tests minksum draw and its page."""
import os
import re
import shutil
import xml.etree.ElementTree as ElementTree

from support import FRAME, SQUARE, TRIANGLE, Page, ProgramTest, main, run

SVG = "{http://www.w3.org/2000/svg}"
BOWTIE = "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))"


class Draw(ProgramTest):
    def setUp(self):
        super().setUp()
        self.frame = self.file("frame.wkt", FRAME)
        self.square = self.file("square.wkt", SQUARE)

    def picture(self, *arguments, **options):
        """Returns the picture, which must be well-formed and have finite numbers only."""
        text = self.fine("draw", *arguments, **options)
        self.assertNotRegex(text, r"[ \"ML](nan|inf)")
        return ElementTree.fromstring(text)

    def texts(self, picture):
        return [element.text for element in picture.iter(SVG + "text")]

    def styles(self, picture):
        """Returns the classes of areas, starting with the lowest one."""
        return [path.get("class").removeprefix("region ") for path in picture.iter(SVG + "path")
                if path.get("class").startswith("region ")]

    def test_layers_by_position(self):
        files = [self.square] * 6
        for count, expected in ((1, ["first"]), (2, ["first", "second"]),
                                (3, ["first", "second", "sum"]),
                                (6, ["first", "second", "sum", "tight", "outline", "outline"])):
            self.assertEqual(self.styles(self.picture(*files[:count])), expected)

    def test_layers_by_name(self):
        picture = self.picture(self.frame, self.square, "--as", "outline,result")
        self.assertEqual(self.styles(picture), ["outline", "sum"])
        self.assertEqual(self.styles(self.picture("--as", "tight", self.frame)), ["tight"])
        self.fails(1, "one layer for each file, of which there are 2", "draw", self.frame,
                   self.square, "--as", "first")
        self.fails(1, "--as", "draw", self.frame, "--as", "third")

    def test_tight_places_have_one_colour(self):
        fit = self.file("fit.wkt", "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4, 0 0)), "
                                   "LINESTRING (1 1, 3 1), POINT (2 3))")
        def thin(picture):
            classes = [e.get("class").split() for e in picture.iter()
                       if e.tag in (SVG + "path", SVG + "circle")]
            return [c[1] for c in classes if c[0] in ("thin", "dot")]
        picture = self.picture(fit, "--as", "result+tight", "--zoom", 1)
        self.assertEqual((self.styles(picture), thin(picture)), (["sum"], ["tight"] * 3))
        self.assertIn("Tight places", self.texts(picture))
        picture = self.picture(fit, "--as", "result")
        self.assertEqual(thin(picture), ["sum"] * 2)
        self.assertNotIn("Tight places", self.texts(picture))
        self.assertNotIn("Tight places", self.texts(self.picture(self.frame, "--as",
                                                                 "result+tight")))
        svg = self.folder / "erosion.svg"
        room = self.file("room.wkt", "POLYGON ((0 0, 9 0, 9 2, 4 2, 4 4, 0 4, 0 0))")
        for more, style in (([], []), (["--tight"], ["tight"])):
            self.fine("erode", room, self.square, *more, "--svg", svg)
            self.assertEqual(thin(ElementTree.parse(svg)), style)

    def test_one_frame_and_one_scale(self):
        numbers = []
        for path in self.picture(self.frame, self.square).iter(SVG + "path"):
            if path.get("class").startswith("region"):
                values = [float(x) for x in re.findall(r"-?[0-9.]+", path.get("d"))]
                numbers.append((values[0::2], values[1::2]))
        (frame_x, frame_y), (square_x, square_y) = numbers
        scale = (max(frame_x) - min(frame_x)) / 9
        self.assertAlmostEqual(scale, (max(frame_y) - min(frame_y)) / 9, 3)
        for axis in (square_x, square_y):
            self.assertAlmostEqual(max(axis) - min(axis), 2 * scale, 2)
        self.assertAlmostEqual(min(frame_x), min(square_x), 3)  # both from x = 0
        self.assertAlmostEqual(max(frame_y), max(square_y), 3)  # and y = 0, which is lowest

    def test_words(self):
        picture = self.picture(self.frame, self.square, "--caption", "a < b & \"c\"", "--title",
                               "T & Q")
        self.assertIn("a < b & \"c\"", self.texts(picture))
        self.assertIn("square", self.texts(picture))
        self.assertEqual(picture.find(SVG + "title").text, "T & Q")
        texts = self.texts(self.picture(self.frame, "--no-legend", "--no-axes"))
        self.assertEqual(texts, [])
        self.fails(1, "more captions", "draw", self.frame, "--caption", "a", "--caption", "b")

    def test_words_that_xml_cannot_hold(self):
        """Such characters are refused in options, with a message, and replaced in file names."""
        for odd in (b"\x01", b"\n", b"\x7f", b"\xff", b"\xc3", b"\xc2\x9b", b"\xed\xa0\x80",
                    b"\xef\xbf\xbe", b"\xef\xbf\xbf"):
            for option in ("--title", "--caption"):
                self.fails(1, f"{option} takes text in UTF-8 without control characters", "draw",
                           self.frame, option, os.fsdecode(b"x" + odd))
            file = self.file(os.fsdecode(odd + b"\xc3\xa9.wkt"), FRAME)
            self.assertRegex("".join(self.texts(self.picture(file))), "\ufffdé")
            missing = run("draw", self.folder / os.fsdecode(odd + b"\xc3\xa9"))
            text = missing.stderr.decode()
            self.assertIn("/" + "".join(f"\\x{byte:02x}" for byte in odd) + "é: cannot be read", text)
        for fine in ("é", "\u20ac", "\U0001f600", "\ue000", "\ufffd", "a < b"):
            picture = self.picture(self.frame, "--title", fine, "--caption", fine)
            self.assertEqual(picture.find(SVG + "title").text, fine)
            self.assertIn(fine, self.texts(picture))

    def test_themes(self):
        looks = {theme: self.fine("draw", self.frame, "--theme", theme)
                 for theme in ("auto", "light", "dark")}
        self.assertEqual(looks["auto"], self.fine("draw", self.frame))
        for theme, dark, asks in (("auto", True, True), ("light", False, False),
                                  ("dark", True, False)):
            self.assertEqual("#16181c" in looks[theme], dark)
            self.assertEqual("prefers-color-scheme" in looks[theme], asks)
        self.fails(1, "--theme", "draw", self.frame, "--theme", "red")

    def test_width(self):
        self.assertEqual(self.picture(self.frame, "--width", 500).get("width"), "500")
        for width in ("0", "-5", "1e9", "x"):
            self.fails(1, f"--width takes a number from 200 to 10000, not '{width}'", "draw",
                       self.frame, f"--width={width}")

    def test_thin_parts(self):
        lines = self.file("lines.wkt", "GEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0)), "
                                       "LINESTRING (1 1, 2 2), POINT (3 3))")
        picture = self.picture(lines)  # both are there, though they lie within the polygon
        classes = [element.get("class") for element in picture.iter()]
        self.assertIn("thin first", classes)
        self.assertIn("dot first", classes)

    def test_any_extent(self):
        for name, text in (("empty", "POLYGON EMPTY"), ("point", "POINT (3 -4)"),
                           ("far", "POINT (1e300 -1e300)"), ("level", "LINESTRING (0 5, 7 5)"),
                           ("upright", "LINESTRING (5 0, 5 7)"),
                           ("huge", "POLYGON ((-8e307 0, 8e307 0, 0 8e307, -8e307 0))"),
                           ("tiny", "POLYGON ((0 0, 1e-300 0, 0 1e-300, 0 0))"),
                           ("narrow", "POLYGON ((1e20 0, 100000000000000016384 0, 1e20 9, 1e20 0))"
                            ),
                           ("offset", "POLYGON ((1e9 1e9, 1000000001 1e9, 1e9 1000000001, 1e9 1e9))"
                            )):
            with self.subTest(name):
                self.assertLess(len(self.texts(self.picture(self.file(name, text)))), 80)
        for text in ("POINT (1e400 0)", "LINESTRING (0 0, 1e-320 0)",
                     "LINESTRING (-1.7e308 0, 1.7e308 0)"):
            self.fails(3, "no picture", "draw", self.file("beyond.wkt", text))

    def test_numbers_at_axes(self):
        texts = self.texts(self.picture(self.frame, "--no-legend"))
        self.assertEqual(sorted(map(float, texts)), sorted([*range(10), *range(10)]))
        texts = self.texts(self.picture(self.file("a", "LINESTRING (-0.3 0, 0.3 0)")))
        self.assertIn("0.3", texts)
        self.assertIn("\u22120.1", texts)
        self.assertNotIn("-0.1", texts)

    def test_fill_rule(self):
        twice = self.file("twice.wkt", "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), "
                                       "((1 1, 3 1, 3 3, 1 3, 1 1)))")
        one = self.fine("draw", twice, note="not valid")
        hole = self.fine("draw", twice, "--fill", "evenodd", note="not valid")
        self.assertNotEqual(one, hole)
        self.fails(2, f"{twice}: polygon", "draw", self.frame, twice, "--fill", "strict")
        self.fails(1, "cannot be given together with", "draw", twice, "--fill", "evenodd", "--faults")

    def test_faults(self):
        bowtie = self.file("bowtie.wkt", BOWTIE)
        spike = self.file("spike.wkt", "POLYGON ((0 0, 9 0, 9 9, 9 0, 5 -5, 0 0))")
        picture = self.picture(bowtie, spike, "--faults")
        texts = self.texts(picture)
        self.assertIn("bowtie (1 fault)", texts)
        listed = [text for text in texts if "polygon 1, ring 1" in text]
        self.assertEqual([text.split(":")[0] for text in listed], ["1  bowtie", "2  spike"])
        info = run("info", bowtie).stdout.decode()
        self.assertIn(listed[0].split(": ", 1)[1], info)
        marks = [c for c in picture.iter(SVG + "circle") if c.get("class") == "fault"]
        self.assertEqual(len(marks), 2)
        self.assertEqual(self.texts(self.picture(self.frame, "--faults", "--no-axes")), ["frame"])
        many = self.file("many.wkt", "MULTIPOLYGON (" + ", ".join(
            f"(({9 * i} 0, {9 * i + 4} 4, {9 * i + 4} 0, {9 * i} 4, {9 * i} 0))"
            for i in range(30)) + ")")
        self.assertIn("and 10 more", self.texts(self.picture(many, "--faults")))

    def test_words_stay_in_the_picture(self):
        """Words fit by the width of characters in the widest of the usual fonts."""
        words = "a title of many words " * 12
        bowtie = self.file("bowtie.wkt", BOWTIE)
        for width in (200, 400, 960):
            for text in (words.strip(), "oneverylongword" * 20, "ü" * 300):
                picture = self.picture(bowtie, self.frame, "--faults", "--title", text, "--caption",
                                       text, "--caption", "short", "--width", width)
                found = [(e.get("class"), float(e.get("x")), e.text)
                         for e in picture.iter(SVG + "text")]
                for style, x, line in found:
                    size = {"title": 9.4, "caption": 7.4}.get(style, 0)
                    self.assertLessEqual(x + size * len(line or ""), width + 8)
                for wanted in ("title", "caption"):
                    said = "".join(line for style, _, line in found if style == wanted)
                    self.assertIn(text.replace(" ", ""), said.replace(" ", ""))
                # The lines are one below the other.
                places = [float(e.get("y")) for e in picture.iter(SVG + "text")
                          if e.get("class") in ("title", "caption") and e.text != "short"]
                self.assertEqual(len(set(places)), len(places))
                self.assertLess(max(places), float(picture.get("height")))

    def test_numbers_of_faults_at_one_place(self):
        """Numbers are side by side, and not on top of each other."""
        hub = self.file("hub.wkt", "MULTIPOLYGON (" + ", ".join(
            f"(({x} 0, {x + 4} 4, {x + 4} 0, {x} 4, {x} 0))" for x in (0, 0, 0, 50)) + ")")
        picture = self.picture(hub, "--faults")
        numbers = [(e.text, float(e.get("x")), float(e.get("y")))
                   for e in picture.iter(SVG + "text") if "number" in e.get("class").split()]
        marks = [e for e in picture.iter(SVG + "circle") if e.get("class") == "fault"]
        self.assertGreater(len(marks), len(numbers))
        self.assertTrue(any("–" in text or "," in text for text, _, _ in numbers), numbers)
        for i, (_, x, y) in enumerate(numbers):
            for _, u, v in numbers[:i]:
                self.assertTrue(abs(x - u) >= 9 or abs(y - v) >= 9)
        said = []
        for text, _, _ in numbers:
            for run_ in text.split(", "):
                first, _, last = run_.partition("–")
                said += range(int(first), int(last or first) + 1)
        self.assertEqual(sorted(said), list(range(1, len(marks) + 1)))

    def test_labels_are_those_of_messages(self):
        picture = self.picture(self.frame, "--labels", "--no-axes", "--no-legend")
        self.assertEqual(sorted(self.texts(picture)), sorted(["1", "2", "3", "4"] * 2))

    def test_converted_pictures(self):
        for name, begin in (("a.png", b"\x89PNG"), ("a.PDF", b"%PDF")):
            out = self.folder / name
            nothing = {"PATH": str(self.folder)}
            self.assertRegex(self.fails(2, "needs the program rsvg-convert", "draw", "nowhere.wkt",
                                        "-o", out, before=lambda: os.environ.update(nothing)).stderr,
                             b"\\.svg needs nothing")
            if not shutil.which("rsvg-convert"):
                self.skipTest("rsvg-convert is not there")
            for command in (["draw", self.frame, "-o"],
                            ["depth", self.frame, self.square, "--svg"]):
                out.unlink(missing_ok=True)
                run(*command, out)
                self.assertTrue(out.read_bytes().startswith(begin))
        # A converter that fails leaves the old file.
        (self.folder / "rsvg-convert").write_text("#!/bin/sh\nexit 1\n")
        (self.folder / "rsvg-convert").chmod(0o755)
        out.write_text("old")
        self.fails(2, "could not convert the picture", "draw", self.frame, "-o", out,
                   before=lambda: os.environ.update(nothing))
        self.assertEqual(out.read_text(), "old")
        for command in (["draw", "nowhere.wkt", "-o"], ["sum", "nowhere.wkt", "b", "--svg"]):
            self.fails(1, "there are .svg, .png, .pdf", *command, "x.gif")

    def test_views(self):
        """A part of the picture is shown, at the scale that it would have alone."""
        far = self.file("far.wkt", "MULTIPOLYGON (((0 0, 4 0, 0 4, 0 0)), "
                                   "((1e6 1e6, 1000001 1e6, 1e6 1000001, 1e6 1e6)))")
        def ticks(*arguments):
            texts = self.texts(self.picture(far, self.square, "--no-legend", *arguments))
            return sorted({float(text.replace("\u2212", "-")) for text in texts})
        self.assertEqual(ticks()[-1], 1e6)
        self.assertEqual([ticks("--bbox", "0,0,4,4")[i] for i in (0, -1)], [0, 4])
        self.assertLess(ticks("--zoom", 2)[-1], 3)
        labels = self.texts(self.picture(far, "--labels", "--bbox=-1,-1,3,3", "--no-axes",
                                         "--no-legend"))
        self.assertEqual(labels, ["1"])
        for arguments in (["--bbox", "0,0,0,4"], ["--bbox", "0,0,4"], ["--bbox", "4,0,0,4"],
                          ["--zoom", 3], ["--zoom", 0], ["--zoom", 1, "--bbox", "0,0,1,1"]):
            self.fails(1, "", "draw", far, self.square, *arguments)
        beyond = self.file("beyond.wkt", "MULTIPOINT (0 0, 1e308 0)")
        self.fails(3, "no picture", "draw", beyond, "--bbox", "0,0,1e-9,1e-9")

    def test_labels_do_not_overlap(self):
        """All vertices of four squares meet in one point or lie close to it."""
        squares = self.file("squares.wkt", "MULTIPOLYGON (" + ", ".join(
            f"((0 0, {x} 0, {x} {y}, 0 {y}, 0 0))" for x in (-9, 9) for y in (-9, 9)) + ")")
        picture = self.picture(squares, "--labels", "--no-axes", "--no-legend", "--fill", "nonzero",
                               note="not valid")
        places = [(float(e.get("x")), float(e.get("y"))) for e in picture.iter(SVG + "text")]
        self.assertEqual(len(places), 16)
        for i, (x, y) in enumerate(places):
            for u, v in places[:i]:
                self.assertTrue(abs(x - u) >= 9 or abs(y - v) >= 11, (x, y, u, v))

    def test_labels_do_not_lie_on_lines(self):
        line = self.file("line.wkt", "LINESTRING (2 4, 2 1)")
        peg = self.file("peg.wkt", "POLYGON ((0 0, 2 0, 2 2, 1 3, 0 2, 0 0))")
        picture = self.picture(line, peg, "--labels", "--no-axes", "--no-legend", "--width", 480)
        lines = []
        for path in picture.iter(SVG + "path"):
            numbers = [float(n) for n in re.findall(r"-?[0-9.]+", path.get("d"))]
            points = list(zip(numbers[::2], numbers[1::2]))
            if path.get("d").endswith("Z"):
                points.append(points[0])
            lines += zip(points, points[1:])
        self.assertGreater(len(lines), 5)
        for text in picture.iter(SVG + "text"):
            x, y = float(text.get("x")), float(text.get("y")) - 4
            for (x1, y1), (x2, y2) in lines:
                for k in range(101):
                    u, v = x1 + (x2 - x1) * k / 100, y1 + (y2 - y1) * k / 100
                    self.assertTrue(abs(u - x) > 4 or abs(v - y) > 5, (text.text, x, y, u, v))

    def test_files(self):
        out = self.folder / "out.svg"
        self.assertEqual(self.fine("draw", self.frame, "-o", out), "")
        self.assertEqual(out.read_text(), self.fine("draw", self.frame))
        self.assertEqual(self.fine("draw", "-", "--caption", "frame", stdin=FRAME),
                         self.fine("draw", self.frame))
        self.fails(2, "nowhere.wkt", "draw", "nowhere.wkt", "-o", out)
        self.fails(2, "there is no folder", "draw", self.frame, "-o", self.folder / "no" / "x.svg")
        self.fails(1, "standard input", "draw", "-", "-")
        self.fails(1, "FILE", "draw")
        self.fails(3, "--max-vertices", "draw", self.frame, "--max-vertices", 3)
        for name, text in (("t.geojson", '{"type": "Point", "coordinates": [1, 2]}'),
                           ("t.wkt", TRIANGLE)):
            self.picture(self.file(name, text))


class GalleryPage(Page, ProgramTest):
    page_name = "gallery.md"
    pictures = 10


class DrawPage(Page, ProgramTest):
    page_name = "draw.md"
    pictures = 2


if __name__ == "__main__":
    main()
