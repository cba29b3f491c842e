"""Tests that malformed and unsupported input ends with its exit code and a line that says where.

support.run checks for crashes, hangs and memory beyond the limit.
"""
import json
import os

from support import SQUARE, ProgramTest, main, run

# GDAL would open files of some formats; gdal_test.py has its refusals.
os.environ["MINKSUM_GDAL"] = "none"


def geojson(kind, coordinates):
    return json.dumps({"type": kind, "coordinates": coordinates})


RING = [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]
LONG = "1" * 10_000

# Rows have a name, the content, the exit code and a fragment of the message. Lines, columns,
# polygons, rings and vertices count from 1.
TABLE = [
    # -- no text at all ---------------------------------------------------------------------
    ("empty file", "", 2, "empty"),
    ("blanks only", " \n\t\n", 2, "empty"),
    ("a byte order mark only", b"\xef\xbb\xbf", 2, "empty"),
    ("zero bytes", b"\0" * 100, 2, ":1:1:"),
    ("binary rubbish", bytes(range(128, 256)) * 10, 2, ":1:1:"),
    ("an ELF header", b"\x7fELF\x02\x01\x01\0\0\0", 2, ":1:1:"),
    ("UTF-16", SQUARE.encode("utf-16"), 2, "UTF-16"),
    ("words", "this is no region\n", 2, ":1:1:"),
    # -- WKT ----------------------------------------------------------------------------------
    ("WKT cut in the keyword", "POLYG", 2, ":1:1:"),
    ("WKT without coordinates", "POLYGON", 2, ":1:8:"),
    ("WKT cut in a ring", "POLYGON ((0 0, 1 0,", 2, ":1:"),
    ("WKT cut after a ring", "POLYGON ((0 0, 1 0, 1 1, 0 0)", 2, ":1:30:"),
    ("WKT cut in a number", "POLYGON ((0 0, 1 0, 1 1, 0 0.", 2, ":1:"),
    ("WKT with text after it", SQUARE + " and more", 2, ":1:"),
    ("WKT with NaN", "POLYGON ((0 0, nan 0, 1 1, 0 0))", 2, ":1:16:"),
    ("WKT with an infinity", "POLYGON ((0 0, 1 0, 1 inf, 0 0))", 2, ":1:"),
    ("WKT with a lone coordinate", "POLYGON ((0 0, 1, 1 1, 0 0))", 2, ":1:"),
    ("WKT with three coordinates", "POLYGON ((0 0 0, 1 0 0, 1 1 0, 0 0 0))", 2, ":1:"),
    ("WKT Z", "POLYGON Z ((0 0 0, 1 0 0, 1 1 0, 0 0 0))", 2, "POLYGON Z"),
    ("WKT denominator zero", "POLYGON ((0 0, 1/0 0, 1 1, 0 0))", 2, ":1:16:"),
    ("WKT hexadecimal", "POLYGON ((0 0, 0x10 0, 1 1, 0 0))", 2, ":1:"),
    ("WKT comma for a point", "POLYGON ((0 0, 1,5 0, 1 1, 0 0))", 2, ":1:"),
    ("WKT open ring", "POLYGON ((0 0, 1 0, 1 1, 0 1))", 2, "polygon 1, ring 1"),
    ("WKT open hole", "POLYGON ((0 0, 9 0, 9 9, 0 0), (4 1, 5 1, 5 2))", 2, "polygon 1, ring 2"),
    ("WKT line of one point", "LINESTRING (0 0)", 2, ":1:12: a line has 1 point"),
    ("WKT empty ring", "POLYGON (())", 2, ":1:11:"),
    ("WKT point of two points", "POINT (1 2, 3 4)", 2, ":1:11:"),
    ("WKT point Z", "POINT Z (1 2 3)", 2, "POINT Z"),
    ("WKT curve", "CURVEPOLYGON ((0 0, 1 0, 1 1, 0 0))", 2, "CURVEPOLYGON"),
    ("WKT collection with a curve", f"GEOMETRYCOLLECTION ({SQUARE}, CIRCULARSTRING (0 0, 1 1, "
     "2 0))", 2, ":1:58: CIRCULARSTRING is not supported"),
    ("10 MB of opening parentheses", lambda: b"(" * 10_000_000, 3, "32"),
    ("10 MB of nested WKT", lambda: b"POLYGON " + b"(" * 10_000_000, 3, "32"),
    ("deep collections", lambda: b"GEOMETRYCOLLECTION (" * 100_000, 3, "32"),
    ("a number of 10,000 digits", f"POLYGON ((0 0, {LONG} 0, 1 1, 0 0))", 3, "4096"),
    ("10,000 digits after the point", f"POLYGON ((0 0, 1.{LONG} 0, 1 1, 0 0))", 3, "4096"),
    ("exponent 1e9", "POLYGON ((0 0, 1e1000000000 0, 1 1, 0 0))", 3, "4096"),
    ("exponent -1e9", "POLYGON ((0 0, 1e-1000000000 0, 1 1, 0 0))", 3, "4096"),
    ("exponent beyond 64 bits", "POLYGON ((0 0, 1e99999999999999999999 0, 1 1, 0 0))", 3, "4096"),
    # -- GeoJSON ------------------------------------------------------------------------------
    ("JSON cut", '{"type": "Polygon", "coordinates": [[[0, 0], [1, 0]', 2, ":1:"),
    ("JSON of no type", '{"coordinates": []}', 2, "type"),
    ("JSON array", "[[0, 0], [1, 0], [1, 1]]", 2, "type"),
    ("JSON of an unknown type", geojson("Blob", []), 2, "Blob"),
    ("JSON with a trailing comma", '{"type": "Polygon", "coordinates": [],}', 2, ":1:"),
    ("JSON with text after it", geojson("Polygon", [RING]) + "}", 2, ":1:"),
    ("GeoJSON nested too little", geojson("Polygon", RING), 2, ":1:"),
    ("GeoJSON nested too much", geojson("Polygon", [[RING]]), 2, ":1:"),
    ("GeoJSON multipolygon as polygon", geojson("MultiPolygon", [RING]), 2, ":1:"),
    ("GeoJSON position of one number", geojson("Polygon", [[[0], [1, 0], [1, 1], [0]]]), 2, ":1:"),
    ("GeoJSON with heights", geojson("Polygon", [[p + [7] for p in RING]]), 2, "coordinates"),
    ("GeoJSON string for a number", geojson("Polygon", [[["a", 0], [1, 0], [1, 1], ["a", 0]]]), 2,
     ":1:"),
    ("GeoJSON null for a number", geojson("Polygon", [[[None, 0], [1, 0], [1, 1], [0, 0]]]), 2,
     ":1:"),
    ("GeoJSON NaN", '{"type":"Polygon","coordinates":[[[NaN,0],[1,0],[1,1],[NaN,0]]]}', 2, ":1:"),
    ("GeoJSON open ring", geojson("Polygon", [RING[:-1]]), 2, "polygon 1, ring 1"),
    ("GeoJSON line of one point", geojson("LineString", [[0, 0]]), 2, "a line has 1 point"),
    ("GeoJSON point with a height", geojson("Point", [0, 0, 1]), 2, "coordinates"),
    ("GeoJSON number 1e400000", '{"type":"Polygon","coordinates":[[[1e400000,0],[1,0],[1,1],[0,0]]]}',
     3, "4096"),
    ("JSON string not in UTF-8", b'{"type": "Point", "coordinates": [1, 2],\n "n": "a\xe9b"}', 2,
     ":2:9: a string must be in UTF-8, found byte 0xe9; convert it first, as by iconv -f latin1"),
    ("JSON name of half a surrogate in UTF-8", b'{"type": "Point", "n\xed\xa0\x80": 0}', 2, "UTF-8"),
    ("JSON string in overlong UTF-8", b'{"type": "Point", "n": "\xc0\xaf"}', 2, "UTF-8"),
    ("JSON string beyond Unicode", b'{"type": "Point", "n": "\xf4\x90\x80\x80"}', 2, "UTF-8"),
    ("JSON string with a cut character", b'{"type": "Point", "n": "\xe2\x82"}', 2, "UTF-8"),
    ("JSON string with half a surrogate", '{"type": "Point", "n": "\\ud800"}', 2, "surrogate"),
    ("JSON string with a control character", '{"type": "Point",\n"n": "a\x01"}', 2,
     ":2:8: a control character in a string must be escaped, found byte 0x01"),
    ("10 MB of brackets", lambda: b'{"type":"Polygon","coordinates":' + b"[" * 10_000_000, 2,
     "too deep"),
    ("deep objects", lambda: b'{"a":' * 1_000_000, 3, "32"),
    # -- .poly and .dat -------------------------------------------------------------------------
    (".poly cut", "1\n4 out\n0 0\n1 0\n", 2, ":"),
    (".poly of an unknown kind", "1\n3 about\n0 0\n1 0\n0 1\n1 2 3\n", 2, ":2:"),
    (".poly with a wrong order", "1\n3 out\n0 0\n1 0\n0 1\n1 1 3\n", 2, ":6:"),
    (".poly hole without outer", "1\n3 in\n0 0\n1 0\n0 1\n1 2 3\n", 2, ":2:"),
    (".poly with a negative count", "1\n-3 out\n0 0\n1 0\n0 1\n1 2 3\n", 2, ":"),
    (".poly with a huge count", "1\n999999999999 out\n0 0\n", 2, ":"),
    (".dat cut", "4 0 0 1 0 1 1", 2, ":"),
    (".dat with a word", "3 0 0 1 zero 1 1", 2, ":1:"),
    (".dat with a huge count", "99999999999999999999 0 0", 3, "digits"),
    # -- tables -------------------------------------------------------------------------------
    ("CSV without geometries", "a,b\n1,2\n", 2, "no column of this table holds WKT"),
    ("CSV with its first line alone", "a,name\n", 2, "there are 'a', 'name'"),
    ("CSV of two geometries", 'a,b\nPOINT (1 2),POINT (3 4)\n', 2,
     "several columns hold geometries: 'a' and 'b'; --column names the one to read"),
    ("CSV with too many cells", 'wkt,n\nPOINT (1 2),3\nPOINT (1 2),3,4\n', 2,
     ":3:1: row 2: there are 3 cells, where the table has 2 columns"),
    ("CSV with too few cells", 'wkt,n\nPOINT (1 2)\n', 2, "row 1: there are 1 cells"),
    ("CSV with an open quote", 'wkt,n\n"POINT (1 2),3\n', 2, ":2:1: row 1: a quote is not closed"),
    ("CSV with text behind a quote", 'wkt,n\n"POINT (1 2)"x,3\n', 2, "closing quote, found 'x'"),
    ("CSV with a bad geometry", 'wkt,n\nPOINT (1 2),3\n"POINT (1 x)",4\n', 2,
     ":3:11: row 2: expected"),
    ("CSV with a word for a geometry", "wkt,n\nPOINT (1 2),3\nnowhere,4\n", 2, ":3:1: row 2: "),
    ("CSV in Latin-1", b"wkt,n\nPOINT (1 2),caf\xe9\n", 2,
     "a cell is not UTF-8; convert it first, as by iconv -f latin1 -t utf-8"),
    ("CSV with a name in Latin-1", b"\xe9tage,geom\n1,POINT (1 2)\n", 2, "iconv -f latin1"),
    ("CSV with a cut WKB", "wkb,n\n0101000000000000000000F03F0000,1\n", 2, "row 1: byte 14"),
    # -- drawings -----------------------------------------------------------------------------
    ("SVG cut", '<svg xmlns="http://www.w3.org/2000/svg"><rect width="1" hei', 2, ":1:"),
    ("SVG with a curve", '<svg xmlns="http://www.w3.org/2000/svg"><circle r="1"/></svg>', 2,
     "--tolerance"),
    ("SVG with a bad path", '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 L1 x"/></svg>', 2,
     ":1:"),
    ("DXF cut", "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n0\n", 2, ":"),
    ("DXF with a circle", "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n10\n0\n20\n0\n40\n1\n0\n"
     "ENDSEC\n0\nEOF\n", 2, "--tolerance"),
    # -- other formats, by their first bytes --------------------------------------------------
    ("Shapefile", b"\0\0\x27\x0a" + bytes(96), 2, "a Shapefile"),
    ("GeoPackage", b"SQLite format 3\0" + bytes(84), 2, "an SQLite database, such as GeoPackage"),
    ("FlatGeobuf", b"fgb\x03fgb\0" + bytes(20), 2, "FlatGeobuf"),
    ("KML", '<?xml version="1.0"?><kml xmlns="http://www.opengis.net/kml/2.2"/>', 2, "KML"),
    ("GML", '<gml:FeatureCollection xmlns:gml="http://www.opengis.net/gml"/>', 2, "GML"),
    ("GPX", "<gpx/>", 2, "GPX"),
    ("HTML", "<!DOCTYPE html><html></html>", 2, "a page in HTML"),
    ("gzip", b"\x1f\x8b\x08\0\0", 2, "a gzip archive, which is not read: unpack it first"),
    ("zip", b"PK\3\4\x14\0", 2, "a zip archive"),
    ("PNG", b"\x89PNG\r\n\x1a\n", 2, "a PNG picture"),
    ("PDF", "%PDF-1.7\n", 2, "PDF"),
    ("binary DXF", b"AutoCAD Binary DXF\r\n\x1a\0", 2, "a binary DXF drawing"),
    ("DWG", b"AC1032\0\0", 2, "a DWG drawing"),
    # -- WKB ----------------------------------------------------------------------------------
    ("WKB cut", b"\x01\x03\0\0\0\x01\0\0\0\x04\0\0\0" + bytes(20), 2,
     "byte 10: 4 points do not fit into the 20 bytes that are left"),
    ("WKB with a huge count", b"\x01\x03\0\0\0\xff\xff\xff\xff", 2, "byte"),
    ("WKB with NaN", b"\x01\x02\0\0\0\x01\0\0\0" + b"\0\0\0\0\0\0\xf8\x7f" * 2, 2, "byte"),
    ("WKB with heights", b"\x01\xe9\x03\0\0" + bytes(24), 2, "--drop-z"),
    ("hexadecimal WKB, odd", "01010000000000000000000000000000000000000", 2, "hexadecimal digit"),
    ("two systems", "SRID=4326;POINT (1 2)\nSRID=3857;POINT (3 4)\n", 2,
     "differs from that of earlier geometries"),
]

# Polygons that are not valid, which only `--fill strict` refuses: name, content, fragment.
INVALID = [
    ("ring of one point", "POLYGON ((0 0))", "polygon 1, ring 1"),
    ("ring of two points", "POLYGON ((0 0, 1 1, 0 0))", "polygon 1, ring 1"),
    ("bow-tie", "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))", "polygon 1, ring 1, vertex"),
    ("ring without area", "POLYGON ((0 0, 1 1, 2 2, 0 0))", "polygon 1, ring 1"),
    ("one point four times", "POLYGON ((1 1, 1 1, 1 1, 1 1))", "polygon 1, ring 1"),
    ("spike", "POLYGON ((0 0, 4 0, 4 4, 4 9, 4 4, 0 4, 0 0))", "polygon 1, ring 1, vertex"),
    ("figure of eight that touches itself", "POLYGON ((0 0, 2 2, 4 0, 4 4, 2 2, 0 4, 0 0))",
     "polygon 1, ring 1, vertex"),
    ("hole outside", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (6 6, 7 6, 7 7, 6 6))",
     "polygon 1, ring 2"),
    ("hole across the rim", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (2 2, 6 2, 6 3, 2 2))",
     "polygon 1, ring"),
    ("hole that is the polygon", "POLYGON ((0 0, 4 0, 4 4, 0 0), (0 0, 4 0, 4 4, 0 0))",
     "polygon 1, ring"),
    ("hole in a hole", "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1), "
     "(2 2, 3 2, 3 3, 2 2))", "polygon 1, ring"),
    ("crossing holes", "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 5 1, 5 5, 1 5, 1 1), "
     "(4 4, 8 4, 8 8, 4 8, 4 4))", "polygon 1, ring"),
    ("overlapping parts", "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), ((2 2, 6 2, 6 6, 2 6, 2 2)))",
     "polygon"),
    ("equal parts", "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 0)), ((0 0, 4 0, 4 4, 0 0)))", "polygon"),
    ("a part within a part", "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0)), ((2 2, 3 2, 3 3, 2 2)))",
     "polygon"),
    ("parts that share an edge", "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), "
     "((4 1, 8 1, 8 3, 4 3, 4 1)))", "polygon"),
]


class BadInput(ProgramTest):
    def content(self, content):
        content = content() if callable(content) else content
        return content.encode() if isinstance(content, str) else content

    def test_first_operand(self):
        square = self.file("square.wkt", SQUARE)
        for name, content, code, fragment in TABLE:
            with self.subTest(name):
                bad = self.file("bad.txt", self.content(content))
                out = self.folder / "out.wkt"
                result = self.fails(code, fragment, "sum", bad, square, "-o", out)
                self.assertIn(str(bad), result.stderr.decode())
                self.assertEqual(result.stdout, b"")
                self.assertFalse(out.exists())

    def test_second_operand_from_standard_input(self):
        square = self.file("square.wkt", SQUARE)
        for name, content, code, fragment in TABLE:
            with self.subTest(name):
                result = self.fails(code, fragment, "sum", square, "-",
                                    stdin=self.content(content))
                self.assertIn(b"standard input", result.stderr)
                self.assertNotIn(b"square.wkt", result.stderr)

    def test_info_finds_the_same(self):
        for name, content, code, fragment in TABLE:
            with self.subTest(name):
                result = run("info", self.file("bad.txt", self.content(content)))
                self.assertEqual(result.returncode, code)
                self.assertIn(fragment, result.stderr.decode(errors="replace"))

    def test_invalid_polygons(self):
        square = self.file("square.wkt", SQUARE)
        for name, content, fragment in INVALID:
            with self.subTest(name):
                bad = self.file("bad.wkt", content)
                for p, q in ((bad, square), (square, bad)):
                    result = self.fails(2, fragment, "sum", p, q, "--fill", "strict")
                    self.assertIn(b"bad.wkt", result.stderr)
                result = run("info", bad, "--strict")
                self.assertEqual(result.returncode, 2)
                self.assertIn(fragment, result.stderr.decode())
                for rule in ("automatic", "evenodd", "nonzero", "positive", "negative"):
                    self.fine("sum", bad, square, "--fill", rule, note=f"--fill {rule}: ")

    def test_what_is_no_file(self):
        square = self.file("square.wkt", SQUARE)
        self.fails(2, "Is a directory", "sum", self.folder, square)
        self.fails(2, "No such file", "sum", square, self.folder / "none.wkt")
        self.fails(1, "Q: needs a name, not an empty text", "sum", square, "")
        self.fails(2, "empty", "sum", square, "/dev/null")

    def test_the_table_is_long_enough(self):
        self.assertGreaterEqual(len(TABLE), 80)
        names = [name for name, *_ in TABLE + INVALID]
        self.assertEqual(len(set(names)), len(names))


if __name__ == "__main__":
    main()
