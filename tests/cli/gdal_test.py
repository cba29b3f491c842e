"""Tests files that GDAL opens: what is read equals what GDAL's own program, ogr2ogr, reads.

ogr2ogr writes each file from random features, and then writes what it reads of it as EWKB, which
keeps each double, and as GeoJSON for the properties. Without GDAL the tests of refusals stay.
"""
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import unittest
import zipfile

import support
from support import ProgramTest, run

OGR = shutil.which("ogr2ogr")


def ring(rng, x, y, size):
    """A square whose corners are moved, as doubles with many digits."""
    corners = [(x, y), (x + size, y), (x + size, y + size), (x, y + size)]
    moved = [(a + rng.uniform(0, size / 9), b + rng.uniform(0, size / 9)) for a, b in corners]
    return [*moved, moved[0]]


def features(count, kind="Polygon"):
    rng = random.Random(7)
    for i in range(count):
        x, y = rng.uniform(-100, 60), rng.uniform(-80, 60)
        shapes = {
            "Point": lambda: [x, y],
            "LineString": lambda: [[x, y], [x + 1 / 3, y + rng.random()], [x, y + 2]],
            "Polygon": lambda: [ring(rng, x, y, 9), ring(rng, x + 3, y + 3, 2)[::-1]],
            "MultiPolygon": lambda: [[ring(rng, x, y, 2)], [ring(rng, x + 5, y, 3)]],
        }
        properties = {"name": f"n{i} é \"quoted\"", "count": i * 3, "size": i / 7,
                      "big": 2**40 + i}
        if i % 4 == 3:
            properties["name"] = None
        yield {"type": "Feature", "properties": properties,
               "geometry": {"type": kind, "coordinates": shapes[kind]()}}


def collection(items):
    return json.dumps({"type": "FeatureCollection", "features": list(items)})


# Names of drivers, endings, and options for writing.
FORMATS = [
    ("ESRI Shapefile", ".shp", ["-lco", "ENCODING=UTF-8"]),
    ("GPKG", ".gpkg", []),
    ("FlatGeobuf", ".fgb", []),
    ("FlatGeobuf", ".fgb", ["-lco", "SPATIAL_INDEX=NO"]),
    ("KML", ".kml", []),
    ("GML", ".gml", []),
    ("SQLite", ".sqlite", []),
    ("MapInfo File", ".tab", []),
    ("MapInfo File", ".mif", []),
]


@unittest.skipUnless(OGR, "ogr2ogr is not there: files that GDAL opens are left out")
class Gdal(ProgramTest):
    def setUp(self):
        super().setUp()
        self.source = self.file("source.geojson", collection(features(30)))

    def ogr(self, *arguments):
        return subprocess.run([OGR, *map(str, arguments)], check=True, capture_output=True,
                              cwd=self.folder).stdout.decode()

    def made(self, driver, name, options=(), source=None):
        path = self.folder / name
        self.ogr("-f", driver, path, source or self.source, *options)
        return path

    def as_ogr_reads(self, path, *layer):
        """Returns the hexadecimal EWKB of each feature, and its properties."""
        dump = self.ogr("-f", "PGDump", "/vsistdout/", path, *layer, "-lco", "CREATE_TABLE=OFF",
                        "-lco", "GEOMETRY_NAME=g", "-lco", "FID=f", "-nlt", "GEOMETRY",
                        "--config", "PG_USE_COPY", "NO")
        shapes = re.findall(r"VALUES \('([0-9A-F]+)'", dump)
        made = json.loads(self.ogr("-f", "GeoJSON", "/vsistdout/", path, *layer, "-lco",
                                   "SIGNIFICANT_FIGURES=17"))
        return shapes, [f["properties"] for f in made["features"]]

    def same(self, path, *options, layer=()):
        shapes, properties = self.as_ogr_reads(path, *layer)
        self.assertGreater(len(shapes), 0)
        hexadecimal = self.file("shapes.txt", "\n".join(shapes))
        wanted = run("convert", hexadecimal, "--each", "--format", "wkt", "--coords", "exact", "-q",
                     *options)
        found = run("convert", path, "--each", "--format", "wkt", "--coords", "exact", "-q",
                    *options)
        self.assertEqual((found.returncode, found.stderr), (0, b""))
        self.assertEqual(found.stdout.decode().replace("SRID=4326;", ""),
                         wanted.stdout.decode().replace("SRID=4326;", ""))
        made = json.loads(self.fine("convert", path, "--each", "-q", *options))
        self.assertEqual([f["properties"] for f in made["features"]], properties)
        return made

    def test_formats(self):
        for number, (driver, suffix, options) in enumerate(FORMATS):
            with self.subTest(driver + suffix, options=options):
                folder = self.folder / str(number)
                folder.mkdir()
                path = self.made(driver, f"{number}/made{suffix}", options)
                self.same(path)
                # The content decides, not the name.
                if len(list(folder.iterdir())) == 1:
                    other = path.rename(folder / "other.bin")
                    self.same(other)

    def test_kinds_of_shapes(self):
        for kind in ("Point", "LineString", "MultiPolygon"):
            with self.subTest(kind):
                source = self.file("kind.geojson", collection(features(12, kind)))
                for driver, suffix in (("ESRI Shapefile", ".shp"), ("GPKG", ".gpkg"),
                                       ("FlatGeobuf", ".fgb")):
                    self.same(self.made(driver, kind + suffix, source=source))

    def test_system_and_id(self):
        path = self.made("GPKG", "there.gpkg", ["-a_srs", "EPSG:3857"])
        text = self.fine("convert", path, "--each", "--format", "wkt", "-q")
        self.assertTrue(all(line.startswith("SRID=3857;") for line in text.splitlines()))
        made = json.loads(self.fine("convert", path, "--each"))
        self.assertEqual([f["id"] for f in made["features"]], list(range(1, 31)))
        self.fails(2, "the reference system EPSG:4326 differs from EPSG:3857", "sum", path,
                   "SRID=4326;POINT (0 0)", "-q")

    def test_systems_that_have_no_number(self):
        lost = "the reference system of the operands has no place in this format"
        points = self.file("points.geojson", collection(features(5, "Point")))
        path = self.made("GPKG", "other.gpkg", ["-a_srs", "ESRI:102003"], points)
        made = json.loads(self.fine("convert", path, "--each"))
        self.assertEqual(made["crs"]["properties"], {"name": "urn:ogc:def:crs:ESRI::102003"})
        self.fine("convert", path, "--format", "wkt", note=lost)
        self.fails(2, "the reference system EPSG:4326 differs from ", "sum", path,
                   "SRID=4326;POINT (0 0)", "-q")
        path = self.made("GPKG", "none.gpkg", ["-a_srs", "+proj=lcc +lat_1=49 +lat_2=44"], points)
        note = f"{path}: the reference system has no number, and no result names it"
        self.fine("convert", path, note=note)
        self.assertNotIn("crs", json.loads(self.fine("convert", path, "--each", note=note)))
        job = json.dumps({"operation": "convert", "a": str(path)})
        self.assertIn(note, json.loads(run("batch", "-", stdin=job).stdout)["notes"])

    def test_heights(self):
        high = self.file("high.geojson", collection([
            {"type": "Feature", "properties": {}, "geometry": {
                "type": "LineString", "coordinates": [[0, 0, 7], [1, 2, 7]]}}]))
        path = self.made("GPKG", "high.gpkg", source=high)
        self.fails(2, f"{path}: feature 1: LINESTRING Z has more than two coordinates (--drop-z",
                   "convert", path)
        self.assertEqual(self.fine("convert", path, "--drop-z", "--format", "wkt"),
                         "SRID=4979;LINESTRING (0 0, 1 2)\n")

    def test_curves_are_refused(self):
        advice = " is not supported: flatten it first, as by ogr2ogr -f GeoJSON result.json FILE"
        for curve, kind in (("ELLIPSE 0 0 4 2", "ELLIPSE"), ("  Arc 0 0 4 2\n0 90", "ARC"),
                            ("RoundRect 0 0 4 2 1", "ROUNDRECT"), ("RECT 0 0 4 2", None)):
            path = self.file("some.mif", "Version 300\nColumns 1\n  Arc Char(9)\nData\n"
                             f"POINT 1 2\n{curve}\n")
            self.file("some.mid", '"a"\n"b"\n')
            if kind:
                self.fails(2, f"{path}:6: {kind}{advice}", "convert", path)
            else:
                self.fine("convert", path)
        # ogr2ogr writes no ellipse into a table, so a polygon is renamed.
        path = self.made("MapInfo File", "table.tab")
        for code, kind in ((0x0A, "ARC"), (0x17, "ROUNDRECT"), (0x19, "ELLIPSE")):
            place = int.from_bytes(path.with_suffix(".id").read_bytes()[8:12], "little")
            objects = bytearray(path.with_suffix(".map").read_bytes())
            objects[place] = code
            path.with_suffix(".map").write_bytes(objects)
            self.fails(2, f"{path}: feature 3: {kind}{advice}", "convert", path)
        for number, shape in enumerate(("CIRCULARSTRING (0 0, 1 1, 2 0)",
                                        "CURVEPOLYGON (CIRCULARSTRING (0 0, 4 0, 4 4, 0 4, 0 0))")):
            source = self.file("shape.csv", f'id,WKT\n1,"{shape}"\n')
            path = self.made("GPKG", f"{number}.gpkg", source=source)
            self.fails(2, f"{path}: feature 1: {shape.split()[0]}{advice}", "convert", path)
        # In degrees GDAL flattens an arc that has a centre.
        text = ('<ogr:FeatureCollection xmlns:ogr="http://ogr.maptools.org/" '
                'xmlns:gml="http://www.opengis.net/gml">\n<gml:featureMember><ogr:c><ogr:g>'
                '<gml:Curve srsName="EPSG:4326"><gml:segments><gml:ArcByCenterPoint numArc="1">\n'
                '<gml:pos>1 1</gml:pos><gml:radius uom="m">2</gml:radius>'
                '<gml:startAngle uom="degree">0</gml:startAngle>'
                '<gml:endAngle uom="degree">90</gml:endAngle></gml:ArcByCenterPoint>'
                '</gml:segments></gml:Curve></ogr:g></ogr:c></gml:featureMember>'
                '</ogr:FeatureCollection>')
        for name in ("arc.gml", "arc.bin"):
            path = self.file(name, text)
            self.fails(2, f"{path}:2: ArcByCenterPoint{advice}", "convert", path)

    def test_features_without_a_shape(self):
        some = self.file("some.geojson", collection([
            {"type": "Feature", "properties": {"a": 1}, "geometry": None},
            {"type": "Feature", "properties": {"a": 2},
             "geometry": {"type": "Point", "coordinates": [1, 2]}}]))
        path = self.made("GPKG", "some.gpkg", source=some)
        self.fine("convert", path, note="1 of 2 features skipped: 1 has no geometry")

    def test_layers(self):
        path = self.made("GPKG", "two.gpkg", ["-nln", "first"])
        points = self.file("points.geojson", collection(features(5, "Point")))
        self.ogr("-update", "-f", "GPKG", path, points, "-nln", "second one")
        self.fails(2, "there are 2 layers, and --layer names the one to read: 'first', "
                   "'second one'", "convert", path)
        self.fails(2, "there is no layer 'third' (--layer); there are 'first', 'second one'",
                   "convert", path, "--layer", "third")
        self.same(path, "--layer", "second one", layer=["second one"])

    def test_folders_and_archives(self):
        path = self.made("ESRI Shapefile", "shape.shp", ["-lco", "ENCODING=UTF-8"])
        wanted = self.fine("convert", path, "--each")
        archive, folder = self.folder / "shape.zip", self.folder / "parts"
        folder.mkdir()
        with zipfile.ZipFile(archive, "w") as out:
            for part in self.folder.glob("shape.*"):
                if part.suffix in (".shp", ".shx", ".dbf", ".prj", ".cpg"):
                    out.write(part, part.name)
                    shutil.copy(part, folder)
        self.assertEqual(self.fine("convert", archive, "--each"), wanted)
        self.assertEqual(self.fine("convert", archive.rename(self.folder / "a.bin"), "--each"),
                         wanted)
        self.assertEqual(self.fine("convert", folder, "--each"), wanted)
        for part in list(folder.iterdir()):
            part.rename(folder / part.name.upper())
        self.assertEqual(self.fine("convert", folder, "--each"), wanted)

    def test_archives_of_what_is_read_without_gdal(self):
        point = '{"type": "Point", "coordinates": [0.1, 0.2]}'
        circle = ("0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\n1\n"
                  "0\nENDSEC\n0\nEOF\n")
        for name, text in (("point.geojson", point), ("circle.dxf", circle)):
            archive = self.folder / f"{name}.zip"
            with zipfile.ZipFile(archive, "w") as out:
                out.writestr(name, text)
            self.fails(2, "unpack it, if it holds a folder, or what is read without GDAL",
                       "convert", archive)

    def test_operations_and_batches(self):
        path = self.made("FlatGeobuf", "made.fgb")
        same = self.file("same.txt", "\n".join(self.as_ogr_reads(path)[0]))
        for command in (["sum", "box:1x1"], ["offset", "-d", "0.5", "--tolerance", "0.1"],
                        ["info"], ["transform", "--scale", "2"]):
            with self.subTest(command):
                texts = [run(command[0], file, *command[1:], "-q").stdout.decode()
                         for file in (path, same)]
                self.assertEqual(texts[0].replace("SRID=4326;", "").replace(str(path), ""),
                                 texts[1].replace("SRID=4326;", "").replace(str(same), ""))
        jobs = json.dumps({"operation": "sum", "a": str(path), "b": {"wkt": "POINT (0 0)"}})
        done = run("batch", "-", stdin=jobs)
        self.assertEqual(json.loads(done.stdout).get("error"), None, done.stdout)

    def test_bad_files(self):
        shape = self.made("ESRI Shapefile", "shape.shp").read_bytes()
        lonely = self.file("lonely.shp", shape)
        self.fails(2, f"{lonely}: this looks like a Shapefile, but GDAL cannot open it: ", "info",
                   lonely)
        for name in ("cut.gpkg", "cut.fgb"):
            made = self.made("GPKG" if name.endswith("gpkg") else "FlatGeobuf", name).read_bytes()
            cut = self.file("cut.bin", made[:len(made) // 3])
            self.fails(2, f"{cut}: ", "info", cut)
        cut = self.made("ESRI Shapefile", "cut.shp")
        cut.write_bytes(cut.read_bytes()[:-200])
        self.fails(2, f"{cut}: feature ", "info", cut)
        for end in (-1, -1000):
            cut = self.file("end.fgb", self.made("FlatGeobuf", f"whole{end}.fgb").read_bytes()[:end])
            self.fails(2, f"{cut}: ", "info", cut)
        self.fails(2, "but GDAL cannot open it: ", "info",
                   self.file("no.zip", b"PK\3\4" + bytes(100)))

    def test_text_that_is_not_utf8(self):
        source = self.file("latin.geojson", collection(
            [{"type": "Feature", "properties": {"name": "é"},
              "geometry": {"type": "Point", "coordinates": [1, 2]}}]))
        path = self.made("ESRI Shapefile", "latin.shp", ["-lco", "ENCODING=ISO-8859-1"], source)
        (self.folder / "latin.cpg").unlink()
        self.fails(2, 'feature 1: the field "name" is not UTF-8', "convert", path, "--each", "-q")
        os.environ["SHAPE_ENCODING"] = "ISO-8859-1"
        self.addCleanup(os.environ.pop, "SHAPE_ENCODING")
        made = json.loads(self.fine("convert", path, "--each", "-q"))
        self.assertEqual(made["features"][0]["properties"], {"name": "é"})


class WithoutGdal(ProgramTest):
    def test_what_is_missing_is_said(self):
        os.environ["MINKSUM_GDAL"] = "none"
        self.addCleanup(os.environ.pop, "MINKSUM_GDAL")
        path = self.file("a.shp", b"\0\0\x27\x0a" + bytes(96))
        self.fails(2, "a.shp:1:1: this looks like a Shapefile, which is not read: GDAL opens it, "
                   "but is not installed here (libgdal); or convert it elsewhere: ogr2ogr", "info",
                   path)
        self.fails(2, "standard input:1:1: this looks like a Shapefile, which is not read: give it "
                   "as a file, which GDAL opens if it is installed", "info", "-",
                   stdin=path.read_bytes())
        self.fails(2, "Is a directory", "info", self.folder)

    def test_features_that_are_none(self):
        """A file may begin as the text of GDAL's features, which only the program makes."""
        mark = b"\x8eminksum: features\n"
        lengths = (1).to_bytes(8, "little")
        for tail in (b"", b"\0\0", bytes(4) + b"\1", bytes(4) + lengths * 3 + b"1{",
                     bytes(4) + b"\xff" * 24, bytes(4) + lengths * 3 + b"1{\1"):
            with self.subTest(tail):
                done = run("convert", self.file("odd", mark + tail))
                self.assertEqual(done.returncode, 2, done.stderr)


if __name__ == "__main__":
    support.main()
