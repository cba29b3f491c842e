"""Tests that files as other programs write them are read as Shapely reads them.

The table has a row for each file. Its expected geometry is Shapely's reading of the same bytes, or
of GDAL's reading (`ogr2ogr`), or, for drawings, the shape that was drawn. Without Shapely all of
this is left out, and without `ogr2ogr` the rows that it writes or reads.
"""
import binascii
import json
import math
import os
import shutil
import subprocess
import sys
import unittest

try:
    import shapely.geometry
    import shapely.ops
    import shapely.wkb
    import shapely.wkt
except ImportError:
    SYSTEM = "/usr/bin/python3"  # the interpreter that Debian's python3-shapely is for
    if sys.executable != SYSTEM and os.path.exists(SYSTEM) and not os.environ.get("MINKSUM_TRIED"):
        os.environ["MINKSUM_TRIED"] = "1"
        os.execv(SYSTEM, [SYSTEM, "-B", *sys.argv])
    shapely = None
import support
from support import ProgramTest, run

OGR = shutil.which("ogr2ogr")

ROOM = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 6 3, 3 3))"
TENTHS = "POLYGON ((0.1 0.2, 7.3 0.2, 7.3 5.7, 0.1 5.7, 0.1 0.2))"
PARTS = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)), ((5 5, 8 5, 8 8, 5 5), (7 6, 7.5 6, 7.5 6.5, 7 6)))"
PATH = "LINESTRING (0 0, 1.5 2.25, 4 2)"
PATHS = "MULTILINESTRING ((0 0, 1 1), (5 5, 6 5, 6 6))"
SPOT = "POINT (3.25 -7.5)"
SPOTS = "MULTIPOINT ((0 0), (4 1), (2 9))"
ALL = f"GEOMETRYCOLLECTION ({TENTHS}, LINESTRING (20 20, 21 25), POINT (-5 -5))"
SHAPES = [ROOM, TENTHS, PARTS, PATH, PATHS, SPOT, SPOTS, ALL]
HIGH = "POLYGON Z ((0 0 1, 4 0 2, 4 4 3, 0 4 4, 0 0 1))"


def mapping(text):
    return json.dumps(shapely.geometry.mapping(shapely.wkt.loads(text)))


def features(texts, more=""):
    rows = ['{"type": "Feature", "properties": {"n": %d}, "geometry": %s}' % (i, mapping(text))
            for i, text in enumerate(texts)]
    return '{"type": "FeatureCollection", %s"features": [%s]}' % (more, ",\n".join(rows))


def union(texts):
    return shapely.ops.unary_union([shapely.wkt.loads(text) for text in texts])


def ogr(content, name, *options, suffix, cwd):
    """Returns what ogr2ogr writes of a file."""
    source = cwd / name
    source.write_bytes(content.encode() if isinstance(content, str) else content)
    target = cwd / ("made" + suffix)
    if target.exists():
        target.unlink()
    subprocess.run([OGR, str(target), str(source), *options], check=True, capture_output=True)
    return target.read_bytes()


def text_rows():
    """Rows of WKT and its relatives: name, content, options, expected."""
    for text in SHAPES:
        kind = text.split(" ")[0]
        shape = shapely.wkt.loads(text)
        yield f"WKT of Shapely: {kind} {len(text)}", shape.wkt, [], shape
        yield f"WKT in small letters: {kind} {len(text)}", text.lower(), [], shape
        for order in (True, False):
            data = shapely.wkb.dumps(shape, big_endian=order)
            yield f"WKB, big {order}: {kind} {len(text)}", data, [], shape
            yield (f"hexadecimal EWKB, big {order}: {kind} {len(text)}",
                   shapely.wkb.dumps(shape, hex=True, srid=3857, big_endian=order), [], shape)
        yield f"GeoJSON of Shapely: {kind} {len(text)}", mapping(text), [], shape
    room = shapely.wkt.loads(ROOM)
    yield "PostGIS: ST_AsEWKT", "SRID=4326;" + ROOM, [], room
    yield "PostGIS: bytea of psql", "\\x" + binascii.hexlify(room.wkb).decode() + "\n", [], room
    yield "PostGIS: bytea in capitals", "0x" + binascii.hexlify(room.wkb).decode().upper(), [], room
    high = shapely.wkt.loads(HIGH)
    flat = shapely.ops.transform(lambda x, y, z=None: (x, y), high)
    yield "WKT Z", HIGH, ["--drop-z"], flat
    yield "WKT of QGIS: PolygonZ", HIGH.replace("POLYGON Z", "PolygonZ"), ["--drop-z"], flat
    yield "WKB Z", shapely.wkb.dumps(high), ["--drop-z"], flat
    yield "hexadecimal EWKB Z", shapely.wkb.dumps(high, hex=True, srid=5), ["--drop-z"], flat
    yield "GeoJSON Z", json.dumps(shapely.geometry.mapping(high)), ["--drop-z"], flat
    yield "WKT M", "POINT M (1 2 9)", ["--drop-z"], shapely.geometry.Point(1, 2)
    yield "WKT ZM", "LINESTRING ZM (1 2 3 4, 5 6 7 8)", ["--drop-z"], \
        shapely.geometry.LineString([(1, 2), (5, 6)])
    yield "lines of WKT", "\n".join(SHAPES[:3]), [], union(SHAPES[:3])
    yield "WKT with semicolons and comments", f"# from a log\n{PATH};\n{SPOT}; # end\n", [], \
        union([PATH, SPOT])
    yield "WKT in quotes", f'"{ROOM}"\n"{PARTS}"\n', [], union([ROOM, PARTS])
    yield "WKT with a byte order mark and CRLF", b"\xef\xbb\xbf" + ROOM.encode() + b"\r\n", [], room
    yield "nested collections", f"GEOMETRYCOLLECTION (GEOMETRYCOLLECTION ({PATH}), {SPOT})", [], \
        union([PATH, SPOT])


def json_rows():
    both = union([ROOM, PARTS])
    crs = '"crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}}, '
    yield "FeatureCollection", features([ROOM, PARTS]), [], both
    yield "FeatureCollection of QGIS", features([ROOM, PARTS], '"name": "parts", ' + crs), [], both
    yield "a null geometry", features([ROOM]).replace(
        '"features": [', '"features": [{"type": "Feature", "properties": {}, "geometry": null}, '), \
        [], shapely.wkt.loads(ROOM)
    lines = "\n".join('{"type": "Feature", "properties": {}, "geometry": %s}' % mapping(text)
                      for text in (ROOM, PARTS))
    yield "newline-delimited GeoJSON", lines + "\n", [], both
    yield "GeoJSON text sequence", "".join("\x1e" + line + "\n" for line in lines.split("\n")), [], \
        both
    yield "an indented GeoJSON", json.dumps(json.loads(features([ROOM, PARTS])), indent=4), [], both
    yield "type at the end", '{"coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]], ' \
        '"type": "Polygon"}', [], shapely.wkt.loads("POLYGON ((0 0, 1 0, 0 1, 0 0))")


def table_rows():
    both = union([ROOM, PARTS])
    hexes = [shapely.wkb.dumps(shapely.wkt.loads(text), hex=True, srid=25832)
             for text in (ROOM, PARTS)]
    yield "CSV of QGIS", f'WKT,name\n"{ROOM}","a, b"\n"{PARTS}",c\n', [], both
    yield "clipboard of QGIS", f"wkt_geom\tid\n{ROOM.replace('POLYGON', 'Polygon')}\t1\n" \
        f"{PARTS.replace('MULTIPOLYGON', 'MultiPolygon')}\t2\n", [], both
    yield "CSV of psql", f"id,geom\n1,{hexes[0]}\n2,{hexes[1]}\n", [], both
    yield "CSV with semicolons", f"id;geom\n1;{ROOM}\n2;{PARTS}\n", [], both
    yield "CSV of one column", f'geometry\n"{ROOM}"\n', [], shapely.wkt.loads(ROOM)
    yield "CSV of two geometries", f'a,b\n"{ROOM}","{PARTS}"\n', ["--column", "b"], \
        shapely.wkt.loads(PARTS)
    yield "CSV with CRLF, quotes and line ends in cells", \
        f'note,geom\r\n"he said ""no""\r\n","{ROOM}"\r\n"",\r\n', [], shapely.wkt.loads(ROOM)


def written_by_gdal(cwd):
    """Rows of files that ogr2ogr writes."""
    room, both = shapely.wkt.loads(ROOM), union([ROOM, PARTS])
    source = features([ROOM, PARTS])
    high = '{"type": "Feature", "properties": {}, "geometry": %s}' % json.dumps(
        shapely.geometry.mapping(shapely.wkt.loads(HIGH)))
    plans = [
        ("CSV, WKT", source, ".csv", ["-f", "CSV", "-lco", "GEOMETRY=AS_WKT"], [], both),
        ("TSV, WKT", source, ".csv", ["-f", "CSV", "-lco", "GEOMETRY=AS_WKT", "-lco",
                                      "SEPARATOR=TAB"], [], both),
        ("CSV, semicolons", source, ".csv", ["-f", "CSV", "-lco", "GEOMETRY=AS_WKT", "-lco",
                                             "SEPARATOR=SEMICOLON"], [], both),
        ("GeoJSON", source, ".geojson", ["-f", "GeoJSON"], [], both),
        ("GeoJSON, RFC 7946", features([ROOM]), ".geojson",
         ["-f", "GeoJSON", "-lco", "RFC7946=YES"], [], room),
        ("GeoJSON with boxes", source, ".geojson",
         ["-f", "GeoJSON", "-lco", "WRITE_BBOX=YES"], [], both),
        ("GeoJSON in another system", features([SPOT]), ".geojson",
         ["-f", "GeoJSON", "-a_srs", "EPSG:3857"], [], shapely.wkt.loads(SPOT)),
        ("GeoJSONSeq", source, ".geojsonl", ["-f", "GeoJSONSeq"], [], both),
        ("GeoJSONSeq with marks", source, ".geojsons", ["-f", "GeoJSONSeq", "-lco", "RS=YES"], [],
         both),
        ("CSV with heights", high, ".csv", ["-f", "CSV", "-lco", "GEOMETRY=AS_WKT"], ["--drop-z"],
         shapely.geometry.box(0, 0, 4, 4)),
        ("DXF of lines", features([PATH]), ".dxf", ["-f", "DXF"], [], shapely.wkt.loads(PATH)),
    ]
    for name, content, suffix, options, ours, expected in plans:
        made = ogr(content, "source.geojson", *options, suffix=suffix, cwd=cwd)
        yield f"ogr2ogr: {name}", made, ours, expected


def dxf(*entities, unit=None):
    header = f"0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n{unit}\n0\nENDSEC\n" if unit else ""
    return header + "0\nSECTION\n2\nENTITIES\n" + "".join(entities) + "0\nENDSEC\n0\nEOF\n"


def entity(kind, *tags):
    return f"0\n{kind}\n8\n0\n" + "".join(f"{code}\n{value}\n" for code, value in tags)


def ring_of(points, *more):
    tags = [(90, len(points)), (70, 1)]
    for x, y in points:
        tags += [(10, x), (20, y)]
    return entity("LWPOLYLINE", *tags, *more)


def line(a, b):
    return entity("LINE", (10, a[0]), (20, a[1]), (11, b[0]), (21, b[1]))


def svg(body, attributes=""):
    return f'<svg xmlns="http://www.w3.org/2000/svg" {attributes}>{body}</svg>'


def drawing_rows():
    """Drawings of straight lines, whose shapes are exact; y points down in SVG."""
    box, polygon = shapely.geometry.box, shapely.geometry.Polygon
    corners = [(0, 0), (4.1, 0), (4.1, 3.3), (0, 3.3)]
    yield "LibreCAD: LWPOLYLINE", dxf(ring_of(corners)), [], polygon(corners)
    yield "LibreCAD: LINE, in any order and direction", dxf(
        line(corners[0], corners[1]), line(corners[3], corners[2]), line(corners[3], corners[0]),
        line(corners[2], corners[1])), [], polygon(corners)
    yield "DXF: hole by containment, in mm", dxf(ring_of(corners), ring_of(
        [(1, 1), (2, 1), (2, 2), (1, 2)]), unit=4), [], polygon(corners, [[(1, 1), (2, 1), (2, 2),
                                                                           (1, 2)]])
    yield "DXF: POLYLINE", dxf(entity("POLYLINE", (66, 1), (70, 1)), *(
        entity("VERTEX", (10, x), (20, y)) for x, y in corners), entity("SEQEND")), [], \
        polygon(corners)
    yield "Inkscape: rect", svg('<rect x="1.1" y="2.2" width="3" height="4.5"/>'), [], \
        box(1.1, -6.7, 4.1, -2.2)
    yield "Inkscape: relative path", svg('<path d="m 1,1 h 3 v 2 h -3 z m 5,0 1,0 0,1 z"/>'), [], \
        union(["POLYGON ((1 -1, 4 -1, 4 -3, 1 -3, 1 -1))", "POLYGON ((6 -1, 7 -1, 7 -2, 6 -1))"])
    yield "Inkscape: even-odd hole", svg(
        '<path style="fill:#000;fill-rule:evenodd" d="M0 0H9V9H0ZM3 3H6V6H3Z"/>'), [], \
        polygon([(0, 0), (9, 0), (9, -9), (0, -9)], [[(3, -3), (6, -3), (6, -6), (3, -6)]])
    yield "Inkscape: group moved and scaled", svg(
        '<g transform="translate(10,20) scale(2)"><polygon points="0,0 3,0 0,3"/></g>'), [], \
        polygon([(10, -20), (16, -20), (10, -26)])
    yield "Inkscape: polyline without fill", svg(
        '<polyline fill="none" stroke="#000" points="0,0 1,1 2,0"/>'), [], \
        shapely.geometry.LineString([(0, 0), (1, -1), (2, 0)])
    yield "Inkscape: viewBox in mm", svg('<rect width="10" height="10"/>',
                                         'width="40mm" height="20mm" viewBox="0 0 20 10"'), [], \
        box(0, -20, 20, 0)


def parts_equal(found, expected):
    """Compares as sets: areas, lines and points by themselves, as lines within areas vanish."""
    def of(shape, dimension):
        parts = getattr(shape, "geoms", [shape])
        flat = [inner for part in parts for inner in getattr(part, "geoms", [part])]
        kinds = [("Point",), ("LineString", "LinearRing"), ("Polygon",)][dimension]
        return shapely.ops.unary_union([part for part in flat if part.geom_type in kinds])
    def equal(a, b):
        return (a.is_empty and b.is_empty) or a.equals(b)
    return all(equal(of(found, dimension), of(expected, dimension)) for dimension in range(3))


@unittest.skipUnless(shapely, "Shapely is not there: comparisons with it are left out")
class RealInputs(ProgramTest):
    def read(self, name, content, options):
        """Returns what the program reads, all as one set."""
        path = self.file("input", content)
        done = run("convert", path, "--format", "wkbhex", "-q", *options)
        self.assertEqual((done.returncode, done.stderr), (0, b""), name)
        return shapely.wkb.loads(done.stdout.decode().strip(), hex=True)

    def same(self, rows):
        count = 0
        for name, content, options, expected in rows:
            with self.subTest(name):
                count += 1
                found = self.read(name, content, options)
                self.assertTrue(parts_equal(found, expected), f"{name}: {found.wkt[:300]}")
        return count

    def test_texts(self):
        self.assertGreaterEqual(self.same(text_rows()), 60)

    def test_json(self):
        self.same(json_rows())

    def test_tables(self):
        self.same(table_rows())

    def test_drawings(self):
        self.same(drawing_rows())

    @unittest.skipUnless(OGR, "ogr2ogr is not there: files that it writes are left out")
    def test_files_of_gdal(self):
        self.assertGreaterEqual(self.same(written_by_gdal(self.folder)), 10)

    @unittest.skipUnless(OGR, "ogr2ogr is not there: its reading is left out")
    def test_drawings_as_gdal_reads_them(self):
        """GDAL flattens arcs by itself, so areas agree within the tolerance of both."""
        bulge = math.tan(math.radians(90) / 4)
        drawings = {
            "slot": entity("LWPOLYLINE", (90, 4), (70, 1), (10, 0), (20, 0), (10, 10), (20, 0),
                           (42, 1), (10, 10), (20, 4), (10, 0), (20, 4), (42, 1)),
            "corner": entity("LWPOLYLINE", (90, 3), (70, 1), (10, 0), (20, 0), (10, 5), (20, 0),
                             (42, bulge), (10, 0), (20, 5)),
            "circle": entity("CIRCLE", (10, 3), (20, -2), (40, 7)),
            "ellipse": entity("ELLIPSE", (10, 0), (20, 0), (11, 8), (21, 0), (40, 0.5), (41, 0),
                              (42, 2 * math.pi)),
        }
        for name, text in drawings.items():
            with self.subTest(name):
                path = self.file(name + ".dxf", dxf(text))
                theirs = subprocess.run(
                    [OGR, "-f", "GeoJSON", "/vsistdout/", str(path), "--config",
                     "OGR_ARC_STEPSIZE", "0.1"], check=True, capture_output=True).stdout
                shape = shapely.geometry.shape(json.loads(theirs)["features"][0]["geometry"])
                theirs = shapely.geometry.Polygon(shape.coords)
                ours = self.read(name, dxf(text), ["--tolerance", "1e-5"])
                apart = ours.symmetric_difference(theirs).area
                self.assertLess(apart, 1e-4 * theirs.length, name)


if __name__ == "__main__":
    support.main()
