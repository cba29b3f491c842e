"""Tests --each: an operation on each feature equals the operation on that feature alone."""
import json
import os
import pathlib
import signal
import subprocess
import time
import unittest

import support
from support import MEMORY_MB, PROGRAM, ProgramTest, run

DATA = os.environ.get("MINKSUM_DATA")
SQUARE = "[[[0,0],[4,0],[4,4],[0,4],[0,0]]]"
SQUARE_WKT = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"
BOW_TIE = "[[[0,0],[4,4],[4,0],[0,4],[0,0]]]"
CRS = '{"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::3857"}}'


def polygon(coordinates):
    return '{"type": "Polygon", "coordinates": %s}' % coordinates


def feature(geometry, properties="null", more=""):
    return ('{"type": "Feature", %s"properties": %s, "geometry": %s}'
            % (more, properties, geometry))


def collection(features, more=""):
    return '{"type": "FeatureCollection", %s"features": [%s]}' % (more, ",\n".join(features))


def parts_of_the_collection():
    """Returns each polygon of the folder gis as a feature."""
    parts = []
    for path in sorted((pathlib.Path(DATA) / "gis").glob("*.wkt")):
        done = run("convert", path, "--format", "geojson", "-q")
        done.check_returncode()
        made = json.loads(done.stdout)
        polygons = made["coordinates"] if made["type"] == "MultiPolygon" else [made["coordinates"]]
        parts += [feature(polygon(json.dumps(p)), '{"file": "%s"}' % path.name)
                  for p in polygons]
    return parts


class Losses(ProgramTest):
    def test_parts_that_rounding_loses(self):
        # They vanished in silence.
        grain = "POLYGON ((0 0, 0.1 0, 0 0.1, 0 0))"
        grains = self.file("grains.wkt", f"{SQUARE_WKT}\n{grain}\n{grain}\n{grain}\n")
        told = ("grains.wkt: feature 2: rounding loses 1 of 1 polygons, which vanish or become one "
                "with others (--coords exact keeps all); it loses parts of 2 more features\n")
        out = self.folder / "out.wkt"
        for command in (["sum", grains, "POINT (0 0)"], ["convert", grains]):
            for more in ([], ["-o", out]):
                self.fine(*command, "--each", "--coords", "decimal:0", *more, note=told)
            self.fine(*command, "--each")
            self.fine(*command, "--each", "--coords", "decimal:0", "-q")
        self.fine("convert", self.file("one.wkt", f"{SQUARE_WKT}\n{grain}\n"), "--each", "--coords",
                  "decimal:0", note="(--coords exact keeps all)\n")
        told = run("nfp", grains, grain, "--each", "--coords", "decimal:0").stderr.decode()
        self.assertIn("feature 2: rounding loses", told)


class Each(ProgramTest):
    def setUp(self):
        super().setUp()
        self.mixed = self.file("mixed.geojson", collection([
            feature(polygon(SQUARE), '{"name": "a", "big": 1e999}', '"id": "first", '),
            feature("null", '{"name": "nothing"}'),
            feature('{"type": "LineString", "coordinates": [[0, 0], [1, 0.1]]}',
                    '{"name": [\n1]}', '"id": 7, '),
            feature(polygon(BOW_TIE)),
        ], '"crs": %s, ' % CRS))

    def one_by_one(self, *command):
        """Returns the results of the features of self.mixed, each from a file of its own."""
        texts = ["POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))", "LINESTRING (0 0, 1 0.1)",
                 "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))"]
        results = []
        for text in texts:
            alone = self.file("alone.wkt", text)
            done = run(command[0], alone, *command[1:], "-q")
            self.assertEqual(done.returncode, 0, done.stderr)
            results.append(done.stdout.decode().strip())
        return results

    def test_each_feature_by_itself(self):
        for command in (["sum", "box:1x2"], ["dilate", "ngon:4:1"], ["erode", "box:1x1"],
                        ["open", "box:1x1"], ["close", "box:1x1"], ["offset", "-d", "0.5"],
                        ["ifp", "box:1x1"], ["union", "box:1x1"],
                        ["intersection", "box:1x1", "--regularize"],
                        ["difference", "box:1x1", "--regularize"],
                        ["symdiff", "box:1x1", "--regularize"], ["reflect"], ["convert"],
                        ["transform", "--scale", "2", "--turn", "90", "--move", "1/3,0"]):
            with self.subTest(command=command):
                done = run(command[0], self.mixed, *command[1:], "--each", "--format", "wkt", "-q")
                self.assertEqual(done.returncode, 0, done.stderr)
                lines = done.stdout.decode().splitlines()
                self.assertEqual([line.replace("SRID=3857;", "") for line in lines],
                                 self.one_by_one(*command))
                self.assertTrue(all(line.startswith("SRID=3857;") for line in lines))

    def test_properties_ids_and_system_stay(self):
        text = self.fine("sum", self.mixed, "box:1x1", "--each", "--fill", "evenodd", "-q")
        self.assertIn('"big": 1e999', text)
        made = json.loads(text.replace("1e999", "0"))
        self.assertEqual([f.get("id") for f in made["features"]], ["first", 7, None])
        self.assertEqual([f["properties"] for f in made["features"]],
                         [{"name": "a", "big": 0}, {"name": [1]}, None])
        self.assertEqual(made["crs"], json.loads(CRS))

    def test_lists_of_all_formats(self):
        wanted = run("convert", self.mixed, "--each", "--format", "wkt", "-q").stdout
        for name in ("out.geojson", "out.geojsonl", "out.ndjson", "out.wkt", "out.wkbhex"):
            out = self.folder / name
            self.assertEqual(run("convert", self.mixed, "--each", "-o", out, "-q").returncode, 0)
            again = run("convert", out, "--each", "--format", "wkt", "-q")
            self.assertEqual((again.stdout, again.stderr), (wanted, b""), name)
        for name in ("out.wkb", "out.svg", "out.poly"):
            self.fails(1, "--each writes lists", "convert", self.mixed, "--each", "-o",
                       self.folder / name)

    def test_notes(self):
        done = run("convert", self.mixed, "--each", "--format", "wkt")
        told = done.stderr.decode()
        self.assertIn("1 of 4 features skipped: 1 has no geometry", told)
        self.assertIn("properties have no place in this format", told)
        self.assertIn("feature 4: polygon 1, ring 1, vertex 1: edges cross at (2, 2)", told)

    def test_a_feature_that_fails_stops_no_other(self):
        for more in ([], ["-o", self.folder / "out.wkt"]):
            done = run("sum", self.mixed, "box:1x1", "--each", "--strict", "--format", "wkt", *more)
            told = done.stderr.decode()
            self.assertEqual(done.returncode, 2)
            self.assertIn("mixed.geojson: feature 4: polygon 1, ring 1, vertex 1: edges cross at "
                          "(2, 2)\n", told)
            self.assertIn("1 of 3 features failed", told)
            text = (self.folder / "out.wkt").read_text() if more else done.stdout.decode()
            self.assertEqual(text.count("\n"), 2)

    def test_a_feature_without_area_has_no_no_fit_polygon(self):
        done = run("nfp", self.mixed, "box:1x1", "--each", "--format", "wkt", "-q")
        self.assertEqual(done.returncode, 2)
        self.assertIn("mixed.geojson: feature 3: a part without area", done.stderr.decode())
        self.assertEqual(done.stdout.count(b"\n"), 2)

    def test_features_before_a_malformed_one_have_results(self):
        texts = [f"POINT ({i} 1)\n" for i in range(40)] + ["POINT (1 x)\n", "POINT (1 1)\n"]
        points = self.file("points.wkt", "".join(texts))
        for threads in (1, 2, 2, 8):
            done = run("sum", points, "box:1x1", "--each", "--threads", threads)
            self.assertEqual((done.returncode, done.stdout.count(b"\n")), (2, 40))
            self.assertIn(b"points.wkt:41:10: geometry 41: expected a number", done.stderr)
        run("sum", points, "box:1x1", "--each", "-o", self.folder / "out.wkt")
        self.assertEqual((self.folder / "out.wkt.partial").read_text().count("\n"), 40)

    def test_answers_that_are_no_geometries(self):
        boxes = self.file("boxes.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n"
                                       "POLYGON ((3 0, 4 0, 4 1, 3 1, 3 0))\n")
        lines = self.fine("depth", boxes, "box:1x1", "--each").splitlines()
        self.assertEqual([json.loads(line)["result"]["relation"] for line in lines],
                         ["overlapping", "apart"])
        lines = self.fine("nfp", boxes, "box:1x1", "--each", "--at", "0,0", "-q").splitlines()
        self.assertEqual([json.loads(line)["feature"] for line in lines], [1, 2])

    def test_reference_systems(self):
        here = "SRID=4326;POLYGON ((0 0, 1 0, 0 1, 0 0))"
        self.assertTrue(self.fine("sum", here, "box:1x1").startswith("SRID=4326;POLYGON"))
        self.assertTrue(self.fine("sum", "box:1x1", here).startswith("SRID=4326;POLYGON"))
        self.fails(2, "the reference system EPSG:4326 differs from EPSG:3857", "sum", self.mixed,
                   here, "-q")
        self.fails(2, "the reference system EPSG:4326 differs from EPSG:3857", "sum", self.mixed,
                   here, "--each", "-q")
        self.fine("sum", here, "box:1x1", "--format", "poly", note="no place in this format")
        lon_lat = self.file("crs84.geojson", collection(
            [feature(polygon(SQUARE))], '"crs": %s, ' % CRS.replace("EPSG::3857", "OGC:1.3:CRS84")))
        self.assertTrue(self.fine("sum", lon_lat, here, "--format", "wkt").startswith("SRID=4326;"))
        made = json.loads(self.fine("sum", here, "box:1x1", "--format", "geojson"))
        self.assertEqual(made["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::4326")
        digits = self.fine("sum", here, "box:1x1", "--format", "wkbhex")
        self.assertTrue(digits.startswith("0103000020E6100000"), digits)
        self.assertTrue(self.fine("convert", self.file("hex.txt", digits)).startswith("SRID=4326;"))

    def test_wkb_is_written(self):
        out = self.folder / "square.wkb"
        self.fine("convert", "POLYGON ((0 0, 0.1 0, 0 1, 0 0))", "-o", out)
        self.assertEqual(self.fine("convert", out), "POLYGON ((0 0, 0.1 0, 0 1, 0 0))\n")
        self.fails(1, "WKB holds doubles", "convert", "POINT (0 0)", "-o", out, "--coords", "exact")

    def rings(self, count):
        return self.file("many%d.geojson" % count, collection([
            feature(polygon("[[[%d,0],[%d,0],[%d,%d],[%d,0]]]" % (i, i + 2, i + 1, i % 9 + 1, i)),
                    '{"number": %d}' % i) for i in range(count)]))

    def killed_and_resumed(self, many, count, *command):
        whole = self.folder / "whole.geojson"
        self.fine(command[0], many, *command[1:], "--each", "-o", whole, "-q")
        self.assertEqual(len(json.loads(whole.read_text())["features"]), count)
        out = self.folder / "killed.geojson"
        partial = pathlib.Path(str(out) + ".partial")
        process = subprocess.Popen([PROGRAM, command[0], many, *command[1:], "--each", "-q",
                                    "--threads", "1", "-o", out])
        while process.poll() is None and not (partial.exists() and partial.stat().st_size > 5000):
            time.sleep(0.001)
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.assertFalse(out.exists())
        done = partial.read_bytes().count(b"\n")
        self.assertGreater(done, 0)
        self.assertLess(done, count)
        self.fails(2, "not the result of this job with these settings", command[0], many,
                   *command[1:], "--each", "-q", "--coords", "decimal:1", "-o", out)
        stats = self.folder / "stats.json"
        self.fine(command[0], many, *command[1:], "--each", "-q", "-o", out, "--stats", stats)
        self.assertEqual(out.read_bytes(), whole.read_bytes())
        self.assertFalse(partial.exists())
        self.assertGreaterEqual(json.loads(stats.read_text())["earlier"], done - 1)

    def test_killed_and_resumed(self):
        self.killed_and_resumed(self.rings(4000), 4000, "offset", "-d", "0.1")

    def peak(self, many):
        """Returns the bytes that --each takes at most."""
        process = subprocess.Popen([PROGRAM, "sum", many, "ngon:12:1", "--each", "-q", "-o",
                                    self.folder / "out.geojson"])
        _, process.returncode, usage = os.wait4(process.pid, 0)
        self.assertEqual(process.returncode, 0)
        return usage.ru_maxrss * 1024

    @unittest.skipIf(MEMORY_MB == 0, "a sanitizer keeps memory that was freed")
    def test_memory_does_not_grow_with_the_number_of_features(self):
        few, many = self.rings(2000), self.rings(20000)
        growth = self.peak(many) - self.peak(few)
        # The text of the file is held, and what is read and not yet written is bounded.
        self.assertLess(growth, many.stat().st_size - few.stat().st_size + (4 << 20))

    @unittest.skipIf(MEMORY_MB == 0, "a sanitizer keeps memory that was freed")
    def test_the_text_is_held_once(self):
        short = self.file("short.geojson", feature(polygon(SQUARE)))
        long = self.file("long.geojson", feature(polygon(SQUARE)) + 40_000_001 * " ")
        self.assertLess(self.peak(long) - self.peak(short), 44_000_000)

    def test_all_of_the_collection(self):
        if not DATA:
            self.skipTest("MINKSUM_DATA is not set")
        parts = parts_of_the_collection()
        many = self.file("all.geojson", collection(parts))
        self.assertGreater(len(parts), 1800)
        self.killed_and_resumed(many, len(parts), "sum", "ngon:5:0.01")
        # Each feature by itself: jobs, as a process for each would take too long for a test.
        b = json.dumps({"wkt": self.fine("convert", "ngon:5:0.01", "--coords", "exact", "-q")})
        jobs = self.file("jobs.jsonl", "".join(
            '{"operation": "sum", "a": %s, "b": %s}\n' % (part, b) for part in parts))
        lines = self.fine("batch", jobs, "--format", "geojson").splitlines()
        made = json.loads((self.folder / "whole.geojson").read_text())["features"]
        self.assertEqual(len(lines), len(made))
        for line, result in zip(lines, made):
            self.assertEqual(json.loads(line)["result"], result["geometry"])


if __name__ == "__main__":
    support.main()
