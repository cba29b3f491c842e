"""Tests cspace and reach: arguments, results, failures, and their page."""
import json
import xml.etree.ElementTree
from fractions import Fraction

from support import FRAME, SQUARE, Page, ProgramTest, main, run

ROD = "POLYGON ((-5 -1/2, 5 -1/2, 5 1/2, -5 1/2, -5 -1/2))"
WALLS = "MULTIPOLYGON (((19 0, 21 0, 21 7, 19 7, 19 0)), ((19 13, 21 13, 21 20, 19 20, 19 13)))"
HALL = "POLYGON ((0 0, 40 0, 40 20, 0 20, 0 0))"


def turn_of(properties):
    """Returns the exact point of the unit circle that the properties of a slice give."""
    t = Fraction(properties["tan_half"])
    x, y = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    for _ in range(properties["quarter_turns"]):
        x, y = -y, x
    return x, y


class Robots(ProgramTest):
    def setUp(self):
        super().setUp()
        self.rod = self.file("rod.wkt", ROD)
        self.walls = self.file("walls.wkt", WALLS)
        self.hall = self.file("hall.wkt", HALL)
        self.square = self.file("square.wkt", SQUARE)


class ConfigurationSpace(Robots):
    def slices(self, *options, note=""):
        return json.loads(self.fine("cspace", *options, note=note))["features"]

    def test_angles(self):
        found = self.slices(self.square, self.walls, "--angles", 8)
        self.assertEqual([f["properties"]["theta"] for f in found], [45 * i for i in range(8)])
        for feature in found:
            properties = feature["properties"]
            x, y = turn_of(properties)
            self.assertEqual(x * x + y * y, 1)
            self.assertLessEqual(properties["off"], 0.001)
            self.assertLessEqual(abs(properties["turned"] - properties["theta"]),
                                 properties["off"])
            self.assertEqual(properties["part"], "obstacles")
            if properties["theta"] % 90 == 0:
                self.assertEqual((properties["off"], properties["tan_half"]), (0, "0"))
        ranged = self.slices(self.square, self.walls, "--theta", "-45:1e2:145/3")
        self.assertEqual([f["properties"]["theta"] for f in ranged],
                         [-45, 10 / 3, 155 / 3, 100])
        self.assertEqual(self.slices(self.square, self.walls, "--theta", "5:5:9")[0], self.slices(
            self.square, self.walls, "--theta", "5:13:9")[0])

    def test_parts_that_rounding_loses(self):
        grain = self.file("grain.wkt", "POLYGON ((0 0, 0.1 0, 0 0.1, 0 0))")
        told = "minksum: slice 1: rounding loses 1 of 1 polygons, "
        self.slices(grain, grain, "--angles", 1, "--coords", "decimal:0", note=told)
        found = run("cspace", grain, grain, "--angles", 3, "--coords", "decimal:0").stderr.decode()
        self.assertTrue(found.startswith(told) and
                        found.endswith("; it loses parts of 2 more slices\n"), found)
        self.slices(grain, grain, "--angles", 3)

    # Each slice is the sum with the robot turned as the slice's properties say.
    def test_slices_are_sums(self):
        found = self.slices(self.square, self.walls, "--angles", 7, "--coords", "exact",
                            "--reference", "1/2,-3")
        for feature in found:
            cos, sin = turn_of(feature["properties"])
            ring = [(Fraction(x) - Fraction(1, 2), Fraction(y) + 3)
                    for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
            turned = [(sin * y - cos * x, -sin * x - cos * y) for x, y in ring]
            mirrored = self.file("mirrored.wkt", "POLYGON ((" + ", ".join(
                f"{x} {y}" for x, y in [*turned, turned[0]]) + "))")
            expected = self.fine("sum", self.walls, mirrored, "--coords", "exact", "--format",
                                 "geojson")
            self.assertEqual(feature["geometry"], json.loads(expected))

    def test_free_space(self):
        room = self.file("room.wkt", "POLYGON ((0 0, 9 0, 9 2, 0 2, 0 0))")
        options = (self.square, self.file("none.wkt", "POLYGON EMPTY"), "--workspace", room,
                   "--angles", 4, "--free")
        for feature in self.slices(*options):
            self.assertEqual(feature["geometry"]["coordinates"], [])
            self.assertEqual(feature["properties"]["part"], "free")
        self.assertEqual([f["geometry"] for f in self.slices(*options, "--tight")], [
            {"type": "LineString", "coordinates": ends} for ends in
            ([[0, 0], [7, 0]], [[2, 0], [9, 0]], [[2, 2], [9, 2]], [[0, 2], [7, 2]])])
        # Nothing is in the way, so the free space is a whole box around the origin.
        empty = self.slices(self.square, self.folder / "none.wkt", "--angles", 1, "--free")
        self.assertEqual(len(empty[0]["geometry"]["coordinates"]), 1)
        self.assertEqual(self.slices(self.square, self.folder / "none.wkt", "--angles", 1)[0][
            "geometry"]["coordinates"], [])

    def test_threads_and_files(self):
        out, stats, picture = (self.folder / name for name in ("out.json", "stats.json", "a.svg"))
        expected = self.fine("cspace", self.rod, self.walls, "--angles", 30, "--threads", 1)
        for threads in (2, 9):
            self.fine("cspace", self.rod, self.walls, "--angles", 30, "--threads", threads, "-o",
                      out, "--svg", picture, "--slices", self.folder / "each", "--stats", stats)
            self.assertEqual(out.read_text(), expected)
        each = sorted((self.folder / "each").iterdir())
        self.assertEqual([file.name for file in each],
                         [f"slice-{i:03}.svg" for i in range(30)])
        for file in [picture, *each[:3]]:
            xml.etree.ElementTree.parse(file)
        numbers = json.loads(stats.read_text())
        self.assertEqual(numbers["slices"], 30)
        self.assertGreater(numbers["vertices"], 30 * 8)
        self.assertLessEqual(numbers["seconds_per_slice"], numbers["slowest_slice"])

    def test_fill_rule_and_formats(self):
        twice = self.file("twice.wkt", "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), "
                                       "((0 0, 4 0, 4 4, 0 4, 0 0)))")
        holes = [len(self.slices(self.square, twice, "--angles", 1, *options, note="not valid")[0]["geometry"][
            "coordinates"]) - 1 for options in ((), ("--fill", "evenodd"))]
        self.assertEqual(holes, [0, 1])  # the second ring is a thin wall all around
        line = self.file("line.wkt", "LINESTRING (0 0, 10 0)")
        self.assertEqual(self.slices(self.square, line, "--angles", 1)[0]["geometry"][
            "coordinates"], [[[-2, -2], [10, -2], [10, 0], [-2, 0], [-2, -2]]])
        piped = self.fine("cspace", "-", self.walls, "--angles", 2, stdin=SQUARE)
        self.assertEqual(piped, self.fine("cspace", self.square, self.walls, "--angles", 2))

    def pair_of_places(self):
        return "reach", self.square, self.walls, "--from", "0,0,0", "--to", "0,0,90"

    def test_wrong_usage(self):
        both = ("cspace", self.square, self.walls)
        self.fails(1, "needs --angles or --theta", *both)
        self.fails(1, "cannot be given together with", *both, "--angles", 3, "--theta", "0:1:1")
        for number in ("0", "-1", "x", "1.5", "1000001"):
            self.fails(1, "--angles takes a number", *both, f"--angles={number}")
        for theta, why in (("0:90:0", "step above 0"), ("0:90:-1", "step above 0"),
                           ("90:0:1", "smaller to the larger"), ("0:90", "3 numbers"),
                           ("0:90:1:2", "3 numbers"), ("a:b:c", "3 numbers"),
                           ("0:90:1e-9", "up to 1000000 angles")):
            self.fails(1, why, *both, f"--theta={theta}")
        self.fails(2, "million degrees", *both, "--theta", "1e9:1e9:1")
        self.fails(1, "--format", *both, "--angles", 1, "--format", "wkt")
        self.fails(1, "--threads", *both, "--angles", 1, "--threads", 0)
        for tolerance in ("0", "1e-11", "1.5", "x"):
            for command in (both, self.pair_of_places()):
                self.fails(1, "--angle-tolerance takes a number from 1e-10 to 1, not "
                           f"'{tolerance}'", *command, "--angles", 1, "--angle-tolerance",
                           tolerance)
        self.fails(1, "needs --free", *both, "--angles", 1, "--tight")
        self.fails(1, "--svg", *both, "--angles", 1, "--svg", "-")
        self.fails(1, "both go to standard output", *both, "--angles", 1, "--stats", "-")
        self.fails(1, "only one file", "cspace", "-", "-", "--angles", 1)
        self.fails(1, "only one file", "cspace", "-", self.walls, "--workspace", "-", "--angles",
                   1)
        self.fails(1, "--reference takes two numbers", *both, "--angles", 1, "--reference", "1")

    def test_reference_systems(self):
        note = "the reference system of the operands is not named in the result"
        ends = ["--from", "-9,-9,0", "--to", "-8,-9,0"]
        for command in (["cspace"], ["reach", *ends]):
            self.fine(*command, "SRID=4326;" + SQUARE, self.walls, "--angles", 2, note=note)
            self.fails(2, "the reference system EPSG:3857 differs from EPSG:4326", *command,
                       "SRID=4326;" + SQUARE, "SRID=3857;" + WALLS, "--angles", 2)

    def test_bad_input(self):
        line = self.file("line.wkt", "LINESTRING (0 0, 10 0)")
        bow = self.file("bow.wkt", "POLYGON ((0 0, 4 4, 4 0, 0 3, 0 0))")
        self.fails(2, "line.wkt: a robot needs an area", "cspace", line, self.walls, "--angles", 1)
        self.fails(2, "line.wkt: a workspace needs an area", "cspace", self.square, self.walls,
                   "--workspace", line, "--angles", 1)
        for arguments in ((bow, self.walls), (self.square, bow),
                          (self.square, self.walls, "--workspace", bow)):
            self.fails(2, "bow.wkt: polygon 1", "cspace", *arguments, "--angles", 1, "--fill",
                       "strict")
        self.fails(2, "nowhere.wkt", "cspace", self.square, "nowhere.wkt", "--angles", 1)
        self.fails(2, "nowhere.wkt", "cspace", self.square, self.walls, "--workspace",
                   "nowhere.wkt", "--angles", 1)
        for option in ("-o", "--svg", "--stats"):
            self.fails(2, "there is no folder", "cspace", self.square, self.walls, "--angles", 1,
                       option, self.folder / "no" / "x")
        self.fails(2, "cannot make this folder", "cspace", self.square, self.walls, "--angles", 1,
                   "--slices", self.square)
        self.fails(3, "--max-segments", "cspace", self.square, self.walls, "--angles", 9,
                   "--max-segments", 3)
        self.assertFalse(list(self.folder.glob("*.tmp")))


class Reach(Robots):
    def options(self, *more, start="6,10,90", goal="34,10,270", angles=24):
        return ("reach", self.rod, self.walls, "--workspace", self.hall, "--from", start, "--to",
                goal, "--angles", angles, *more)

    def test_answers(self):
        lines = self.fine(*self.options()).splitlines()
        self.assertEqual((lines[0], lines[1], lines[-1]), ("yes", "6 10 90", "34 10 270"))
        for a, b in zip(lines[1:], lines[2:]):  # each line is a move, or a turn by a step
            x, y, theta = (float(word) for word in a.split())
            u, v, turned = (float(word) for word in b.split())
            if theta == turned:
                self.assertNotEqual((x, y), (u, v))
            else:
                self.assertEqual((x, y), (u, v))
                self.assertIn((turned - theta) % 360, (15, 345))
        narrow = WALLS.replace("7", "9.6").replace("13", "10.4")
        self.walls.write_text(narrow)
        self.assertEqual(self.fine(*self.options(), note="--angles 48"), "no\n")
        self.assertEqual(self.fine(*self.options(angles=1, goal="6,11,90")).splitlines()[0], "yes")

    def test_json(self):
        found = json.loads(self.fine(*self.options("--json", "--certain", angles=120)))
        self.assertTrue(found["reachable"])
        self.assertEqual(found["slices"], 120)
        self.assertGreater(found["parts"], 120)
        self.assertEqual(float(Fraction(found["margin_exact"])), found["margin"])
        self.assertAlmostEqual(found["margin"], 0.1316, places=3)
        self.assertEqual(found["path"][0]["at_exact"], ["6", "10"])
        for waypoint in found["path"]:
            self.assertEqual([float(Fraction(x)) for x in waypoint["at_exact"]], waypoint["at"])
            x, y = turn_of(waypoint)
            self.assertEqual(x * x + y * y, 1)
        none = json.loads(self.fine(*self.options("--json", "--certain", angles=6),
                                    note="; --angles 12 looks twice as closely, in about "))
        self.assertEqual((none["reachable"], none["path"]), (False, []))

    def test_files(self):
        path, picture = self.folder / "path.geojson", self.folder / "path.svg"
        self.fine(*self.options("-o", path, "--svg", picture))
        xml.etree.ElementTree.parse(picture)
        feature = json.loads(path.read_text())
        self.assertEqual(feature["geometry"]["coordinates"][0], [6, 10])
        self.assertEqual(len(feature["geometry"]["coordinates"]),
                         len(feature["properties"]["theta"]))
        # The first path does not move, and then there is no path.
        self.fine(*self.options("-o", path, "--svg", picture, angles=1, start="6,10,0",
                                goal="6,10,0"))
        self.assertEqual(json.loads(path.read_text())["geometry"]["coordinates"],
                         [[6, 10], [6, 10]])
        xml.etree.ElementTree.parse(picture)
        self.walls.write_text(WALLS.replace("7", "9.6").replace("13", "10.4"))
        self.assertEqual(self.fine(*self.options("-o", path, "--svg", picture, angles=1,
                                                 start="6,10,0", goal="34,10,0"),
                                   note='"no" means: not with these 1 slices'), "no\n")
        self.assertIsNone(json.loads(path.read_text())["geometry"])
        xml.etree.ElementTree.parse(picture)

    def test_ends_that_are_not_free(self):
        for start, why in (("20,6,0", "--from: the robot overlaps an obstacle at the start"),
                           ("1,10,0", "--from: the robot leaves the workspace at the start")):
            self.fails(2, why, *self.options(start=start))
        self.fails(2, "--to: the robot overlaps an obstacle at the goal",
                   *self.options(goal="20,6,0"))
        self.fails(2, "grown by the margin", *self.options("--certain", start="5,10,0"))

    def test_wrong_usage(self):
        for option in ("--from", "--to", "--angles"):
            arguments = list(self.options())
            place = arguments.index(option)
            self.fails(1, option, *arguments[:place], *arguments[place + 2:])
        for text in ("1,2", "1,2,3,4", "x,y,z", "1,2,"):
            self.fails(1, "--from takes 3 numbers", *self.options(start=text))
        self.fails(1, "--angles takes a number", *self.options(angles=0))
        self.fails(2, "more angles are needed", *self.options("--certain", angles=2,
                                                              goal="34,10,0", start="6,10,0"))
        for option in ("-o", "--svg"):
            self.fails(1, "needs a file", *self.options(option, "-"))
            self.fails(2, "there is no folder", *self.options(option, self.folder / "no" / "x"))

    def test_time_limit(self):
        many = run(*self.options("--timeout", "0.05", angles=100000))
        self.assertEqual(many.returncode, 3)
        self.assertIn(b"--timeout", many.stderr)

    def test_frame(self):
        frame = self.file("frame.wkt", FRAME)
        inside = ("reach", self.square, frame, "--angles", 4, "--from", "4,4,0", "--to")
        self.assertTrue(self.fine(*inside, "4,3.5,0").startswith("yes\n"))
        self.assertEqual(self.fine(*inside, "20,0,0", note="--angles 8"), "no\n")


class ConfigurationSpacePage(Page, ProgramTest):
    page_name = "configuration-space.md"
    pictures = 2


if __name__ == "__main__":
    main()
