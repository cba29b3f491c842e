"""Bad inputs, one by one: each has its error, which says where the fault is."""

import itertools
import math
import re
import struct
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import shapely

import minksum as mk

SQUARE = mk.box(0, 0, 1, 1)
TABLE = mk.NoFitTable([SQUARE])
SPACE = mk.ConfigurationSpace(SQUARE, SQUARE)
NAN, INF = math.nan, math.inf
TEXT = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 1 1))"


class Shaped:
    """Has `__geo_interface__`, which may raise."""

    def __init__(self, what):
        self.what = what

    @property
    def __geo_interface__(self):
        if isinstance(self.what, Exception):
            raise self.what
        return self.what


class Number:
    """Looks like a number, and raises when it is asked."""

    def __index__(self):
        raise OSError("no number today")


class Quotient:
    def __init__(self, numerator, denominator):
        self.numerator, self.denominator = numerator, denominator


class Sequence(list):
    def __getitem__(self, index):
        raise OSError("no elements today")


def geo(type, coordinates):
    return {"type": type, "coordinates": coordinates}


def around(vertex):
    """Rings, with a vertex at index 2."""
    return [[(0, 0), (4, 0), vertex, (0, 4)]]


def operands():
    """Objects that no function takes as an operand: name, object, error, words, place."""
    bad, kind = mk.BadInputError, TypeError
    yield "int", 3, kind, "not int", {}
    yield "object", object(), kind, "not object", {}
    yield "set", {1, 2}, kind, "not set", {}
    yield "generator", (i for i in []), kind, "not generator", {}
    yield "bytearray", bytearray(b"abc"), kind, "not bytearray", {}
    yield "class", Shaped, kind, "", {}
    # Shapes of arrays.
    for shape in [(), (1,), (4,), (3, 0), (3, 1), (3, 3), (2, 3, 3), (1, 2, 3, 2)]:
        for type in ("f8", "i8", "f4", "u2"):
            yield f"{type} {shape}", np.ones(shape, type), kind, re.escape(str(shape)), {}
    for type in ("c16", "M8[s]", "m8[s]"):
        yield type, np.zeros((3, 2), type), kind, "element 0", {}
    yield "objects", np.array([[0, 0], [1, {}]], object), kind, "number|vertex 1", {}
    itself = np.empty((), object)
    itself[()] = itself
    yield "array in itself", itself, kind, "not an array", {}
    loop = []
    loop.append(loop)
    yield "list in itself", loop, kind, "element 0: .*not an array", {}
    deep = SQUARE
    for _ in range(100000):
        deep = [deep]
    yield "deep list", deep, kind, "element 0: .*not an array", {}
    yield "lists of lists", [[SQUARE], [SQUARE, SQUARE]], kind, "element 0: ", {}
    # Numbers that are not finite, in each way in which numbers come.
    for number in (NAN, INF, -INF, Decimal("NaN"), Decimal("-Infinity"), np.float32("nan")):
        for vertex in [(number, 1), (1, number)]:
            place = {"polygon": 0, "ring": 0, "vertex": 2}
            name = f"{number!r} {vertex.index(number) if number == number else vertex!r}"
            yield f"ring {name}", around(vertex)[0], bad, "finite number", place
            yield f"Polygon {name}", geo("Polygon", around(vertex)), bad, "finite", place
            yield (f"hole {name}", geo("Polygon", around((4, 4)) + around(vertex)), bad, "finite",
                   {**place, "ring": 1})
            yield (f"second {name}", geo("MultiPolygon", [around((4, 4)), around(vertex)]), bad,
                   "finite", {**place, "polygon": 1})
            yield (f"line {name}", geo("LineString", around(vertex)[0]), bad,
                   "polyline 0: .*finite", {"vertex": 2})
            yield (f"lines {name}", geo("MultiLineString", around((4, 4)) + around(vertex)), bad,
                   "polyline 1: .*finite", {"vertex": 2})
            yield f"Point {name}", geo("Point", vertex), bad, "point 0: .*finite", {}
            yield f"points {name}", geo("MultiPoint", around(vertex)[0]), bad, "point 2: ", {}
    for at, type in itertools.product(range(3), ("f8", "f4", "f2")):
        ring = np.ones((3, 2), type)
        ring[at, at % 2] = NAN
        yield f"{type} NaN at {at}", ring, bad, "", {"polygon": 0, "ring": 0, "vertex": at}
    for at in range(5):
        many = [SQUARE, SQUARE.to_wkb(), str(SQUARE), [(0, 0), (1, 0), (1, 1)], SQUARE]
        yield f"element {at}", many[:at] + [around((NAN, 1))[0]] + many[at + 1:], bad, \
            f"element {at}: ", {"index": at, "vertex": 2}
        yield f"text {at}", many[:at] + ["POLYGON ((0 0, 1"] + many[at + 1:], bad, \
            f"element {at}: 1:17: ", {"index": at, "line": 1, "column": 17}
        yield f"int {at}", many[:at] + [5] + many[at + 1:], kind, f"element {at}: .*not int", {}
    table = np.array([[SQUARE.to_wkb()] * 3] * 2, object)
    table[1, 2] = SQUARE.to_wkb()[:-1]
    yield "element (1, 2)", table, bad, "element 1, 2: byte", {"index": (1, 2)}
    shapes = [shapely.box(0, 0, 1, 1), None, shapely.Point(1, 2, 3)]
    yield "Shapely with Z", shapes[2], bad, 'Z has more than two .*z="drop"', {}
    yield "array of Shapely", np.array(shapes, object), bad, "element 2: ", {"index": 2}
    yield "Shapely with NaN", shapely.LineString([(0, 0), (NAN, 1)]), bad, "byte 26", {}
    # Vertices and numbers of wrong kinds.
    for vertex, words in [((1,), "pair"), ((), "pair"), (7, "pair"), (None, "pair"), ("ab", "pair"),
                          ((None, 1), "x must be a number"), ((1, []), "y must be a number"),
                          ((1j, 0), "x must be"), ((Quotient(1.5, 2), 0), "integers"),
                          ((Quotient(1, -2), 0), "positive")]:
        where = r"polygon 0, ring 0, vertex 2\)"
        yield f"vertex {vertex!r}", around(vertex)[0], kind, f"{words}.*{where}", {}
        yield f"line of {vertex!r}", geo("LineString", around(vertex)[0]), kind, \
            f"polyline 0: .*{words}.*vertex 2", {}
    place = {"polygon": 0, "ring": 0, "vertex": 2}
    for vertex, words in [(("one", 1), "'one' is not a number"), (("1/0", 1), "x: "),
                          ((1, ""), "y: "), ((Quotient(1, 0), 1), "denominator 0")]:
        yield f"number {vertex!r}", around(vertex)[0], bad, words, place
    yield "height", around((1, 1, 5))[0], bad, 'two coordinates: z="drop"', place
    yield "number that raises", around((Number(), 1))[0], OSError, "no number today", {}
    yield "list that raises", Sequence([(0, 0), (1, 0)]), OSError, "no elements today", {}
    yield "surrogate", "\ud800", UnicodeEncodeError, "position 0", {}
    # Mappings, and objects that have or raise one.
    for what in (None, 3, "abc", b"abc", [1], (1, 2)):
        yield f"interface {what!r}", Shaped(what), kind, "must be a mapping", {}
    for error in (OSError("gone"), ValueError("gone"), KeyError("gone"), RuntimeError("gone"),
                  MemoryError("gone"), ZeroDivisionError("gone")):
        yield f"interface {error!r}", Shaped(error), type_of(error), "gone", {}
    yield "no attribute", Shaped(AttributeError("gone")), kind, "not Shaped", {}
    yield "empty mapping", {}, bad, '"type"', {}
    for name in (None, 3, b"Polygon", ["Polygon"]):
        yield f"type {name!r}", geo(name, []), bad, '"type"', {}
    for name in ("", "polygon", "Curve", "Polygon Z", "CircularString", "TIN"):
        yield f"type {name!r}", geo(name, []), bad, f"'{name}'", {}
    for name in ("Point", "MultiPoint", "LineString", "MultiLineString", "Polygon", "MultiPolygon"):
        yield f"{name} alone", {"type": name}, bad, 'no member "coordinates"', {}
        for what in (None, 3, "abc", {1: 2}.keys()):
            yield f"{name} of {what!r}", geo(name, what), kind, "must be a sequence", {}
        yield f"{name} of None", geo(name, [None]), kind, "", {}
    for name, member in [("Feature", "geometry"), ("FeatureCollection", "features"),
                         ("GeometryCollection", "geometries")]:
        yield f"{name} alone", {"type": name}, bad, f'no member "{member}"', {}
    for what in (None, 3, "abc"):
        yield f"collection of {what!r}", {"type": "GeometryCollection", "geometries": what}, \
            kind, "geometries must be a sequence", {}
        if what is not None:
            yield f"feature of {what!r}", {"type": "Feature", "geometry": what}, kind, "mapping", {}
    nested = {"type": "GeometryCollection", "geometries": []}
    nested["geometries"].append(nested)
    yield "collection in itself", nested, mk.LimitError, "limit of 32", {}
    # Texts and bytes.
    for text, at in [("", "1:1"), (" \n", "1:1"), ("/etc/passwd", "1:1"), ("POINT Z (1 2 3)", "1:1"),
                     ("POINT M (1 2 3)", "1:1"), ("POINT (1 2 3)", "1:"), ("POINT (nan 0)", "1:8"),
                     ("POINT (1/0 0)", "1:8"), ("POINT (inf 0)", "1:8"), ("POINT\0(1 1)", "1:6"),
                     ("POLYGON ((0 0, 1 0))", "1:10"), ("POLYGON ((0 0, 1 O, 0 0))", "1:18"),
                     ("CURVEPOLYGON ((0 0, 1 1))", "1:1"), ("TIN (((0 0, 1 1, 1 0)))", "1:1"),
                     ("CIRCULARSTRING (0 0, 1 1)", "1:1"), ("POINT (1 1) x", "1:13"),
                     ("POINT (1 1)\nPOINT (1 x)", "2:"), ('{"type": "Point"}', "1:"),
                     ('{"type": "Curve", "coordinates": []}', "1:"), ("[1, 2", "1:"),
                     ('{"type": "Point", "coordinates": ["a", 1]}', "1:"), ("{}", "1:")]:
        line, column = at.split(":")
        place = {"line": int(line), **({"column": int(column)} if column else {})}
        yield f"text {text!r}", text, bad, re.escape(at), place
    yield "hexadecimal digits", "0102", bad, "not WKT, WKB or GeoJSON", {}
    for first in (2, 7, 48, 80, 123, 255):
        yield f"bytes of {first}", bytes([first, 1, 0, 0, 0]), bad, "byte 1: ", {}
    for code in (0, 8, 11, 15, 99, 1001, 2003, 3006, 0x80000001, 0x40000003):
        wkb = struct.pack("<BI", 1, code) + bytes(16)
        yield f"WKB {code:#x}", wkb, bad, "byte 2: ", {}
    for type in (2, 4, 5, 6, 7):
        for count in (1, 2**31, 2**32 - 1):
            yield f"{count} in WKB {type}", struct.pack("<BII", 1, type, count), bad, "byte 6", {}


def type_of(error):
    return type(error)


def cut():
    """Texts and bytes that end too early, at every place."""
    shapes = [shapely.box(0, 0, 1, 1), shapely.box(0, 0, 9, 9) - shapely.box(2, 2, 3, 3),
              shapely.MultiPoint([(0, 0), (1, 1)]),
              shapely.GeometryCollection([shapely.box(0, 0, 1, 1),
                                          shapely.LineString([(0, 0), (1, 1)])])]
    for s, shape in enumerate(shapes):
        for order in (0, 1):
            wkb = shapely.to_wkb(shape, byte_order=order)
            for n in range(len(wkb)):
                yield f"WKB {s} {order} cut at {n}", mk.from_wkb, wkb[:n], r"byte (\d+): ", n
    wkb = shapely.to_wkb(shapely.set_srid(shapes[0], 3857), include_srid=True)
    for n in range(len(wkb)):
        yield f"EWKB cut at {n}", mk.from_wkb, wkb[:n], r"byte (\d+): ", n
    state = mk.from_wkt("GEOMETRYCOLLECTION (POLYGON ((0 0, 1/3 0, 0 1e30, 0 0)), POINT (7 8), "
                        "LINESTRING (1 1, 2 2))").to_bytes()
    for n in range(len(state)):
        yield f"state cut at {n}", mk.Geometry.from_bytes, state[:n], r"byte (\d+): ", n
    for n in range(len(TEXT)):
        yield f"WKT cut at {n}", mk.from_wkt, TEXT[:n], r"1:(\d+): ", n


def offsets():
    """Ragged arrays: coordinates, offsets, the array at fault, and the place in it."""
    def numbers(*values):
        return np.array(values, np.int64)

    coords = np.zeros((8, 2))
    rings, polygons, shapes = numbers(0, 4, 8), numbers(0, 1, 2), numbers(0, 1, 2)
    good = {"ring_offsets": rings, "polygon_offsets": polygons, "geometry_offsets": shapes}
    for name, offsets in good.items():
        last = int(offsets[-1])
        for wrong, at in [(numbers(), 0), (numbers(1, last), 0), (numbers(-1, last), 0),
                          (numbers(0, 2, 1, last), 2), (numbers(0, last, 0), 2),
                          (numbers(0, -1, last), 1), (numbers(0, last + 1), 1),
                          (numbers(0, last - 1), 1), (numbers(0), 0), (numbers(0, 2**62), 1),
                          (numbers(0, -(2**63), last), 1), (numbers(0, 1, last, 2**63 - 1), 3)]:
            yield coords, {**good, name: wrong}, mk.BadInputError, rf"{name}\[{at}\]"
        for wrong in (None, "abc", offsets.astype(float), offsets.reshape(1, 3), 7, [0.5, 1]):
            if name != "geometry_offsets" or wrong is not None:
                yield coords, {**good, name: wrong}, TypeError, f"{name} must be"
    for wrong in (None, "abc", np.zeros((8, 3)), np.zeros(16), np.zeros((8, 2), complex), 5,
                  np.zeros((4, 2, 2))):
        yield wrong, good, TypeError, "coords must be"
    yield np.full((8, 2), 2**53 + 1), good, mk.BadInputError, "coords has integers"
    for at in range(8):
        wrong = coords.copy()
        wrong[at] = NAN if at % 2 else INF
        yield wrong, good, mk.BadInputError, rf"element {at // 4}: .*vertex {at % 4}\)"


def arguments():
    """Calls with arguments that are refused: name, call, error, words."""
    bad, value, kind = mk.BadInputError, ValueError, TypeError
    for name, call in {
        "distance": lambda x: mk.offset(SQUARE, x),
        "tolerance": lambda x: mk.offset(SQUARE, 1, tolerance=x),
        "miter_limit": lambda x: mk.offset(SQUARE, 1, miter_limit=x),
        "reference": lambda x: mk.no_fit_polygon(SQUARE, SQUARE, reference=(x, 0)),
        "direction": lambda x: mk.time_of_impact(SQUARE, SQUARE, (0, x)),
        "a point": lambda x: mk.locate(SQUARE, [(0, 0), (x, 0)]),
        "matrix": lambda x: mk.affine_transform(SQUARE, [1, 0, 0, 1, x, 0]),
        "degrees": lambda x: mk.rotate(SQUARE, x),
        "radius": lambda x: mk.disc(x),
        "xmin": lambda x: mk.box(x, 0, 1, 1),
        "ymax": lambda x: mk.box(0, 0, 1, x),
        "within": lambda x: mk.check_sum(SQUARE, SQUARE, SQUARE, within=x),
        "each of the angles": lambda x: list(SPACE.slices([x])),
        "start": lambda x: mk.reach(SQUARE, SQUARE, (x, 0, 0), (1, 1, 1)),
        "goal": lambda x: mk.reach(SQUARE, SQUARE, (1, 1, 1), (0, 0, x)),
    }.items():
        for number, words in [(NAN, "not nan"), (INF, "not inf"), (Decimal("NaN"), "not NaN"),
                              ("one", "'one' is not"), ("1/0", "1/0")]:
            yield f"{name} {number!r}", lambda c=call, x=number: c(x), bad, f"{name}: .*{words}"
        for thing in ([], {}, object(), 1j):
            yield f"{name} {thing!r}", lambda c=call, x=thing: c(x), kind, f"{name} must be"
    yield "second point", lambda: mk.locate(SQUARE, [(0, 0), 5]), kind, "element 1: a point must be"
    yield "contact", lambda: mk.NoFitPolygon(SQUARE, SQUARE).contact([(0, 0, 0)]), kind, "element 0"
    for key in (-1, 1, "a", (0, 1, 2), (0,), (0, 4), (0, -1), (1, 0), 2**70, 0.5, None):
        yield f"key {key!r}", lambda k=key: TABLE[0, k], bad, "there is no"
    for key in (0, "ab", (0, 0, 0)):
        yield f"keys {key!r}", lambda k=key: TABLE[k], kind, "indexed by"
    for word in ("", "left", "Outside", "x" * 1000):
        for call in (lambda w: mk.offset(SQUARE, 1, side=w), lambda w: SQUARE.to_wkb(round=w),
                     lambda w: mk.rounded(SQUARE, side=w), lambda w: SQUARE.to_wkt(round=w),
                     lambda w: mk.disc(1, side=w)):
            yield f"side {word[:9]!r}", lambda c=call, w=word: c(w), value, '"outside"'
        yield f"fill {word[:9]!r}", lambda w=word: mk.resolve(SQUARE, fill=w), value, '"evenodd"'
        yield f"join {word[:9]!r}", lambda w=word: mk.offset(SQUARE, 1, join=w), value, '"bevel"'
        yield f"cap {word[:9]!r}", lambda w=word: mk.offset(SQUARE, 1, cap=w), value, '"butt"'
        yield f"z {word[:9]!r}", lambda w=word: mk.as_geometry(TEXT, z=w), value, '"drop"'
    for digits in (-1, 4097, 10**6):
        yield f"{digits} digits", lambda d=digits: mk.rounded(SQUARE, decimals=d), bad, "0 to 4096"
    for seconds in (0, -1, NAN, -INF):
        yield f"timeout {seconds}", lambda s=seconds: mk.resolve(SQUARE, timeout=s), value, "timeout"
    for name in ("threads", "max_segments", "timeout", "cancel", "fill", "regularize"):
        yield f"{name} of a wrong type", lambda n=name: mk.resolve(SQUARE, **{n: []}), kind, name
    yield "negative threads", lambda: mk.resolve(SQUARE, threads=-1), value, "threads"
    yield "no callable", lambda: mk.resolve(SQUARE, progress=3), kind, "callable"
    yield "unknown name", lambda: mk.resolve(SQUARE, colour=3), kind, "colour|incompatible"
    for count in (3, 4):
        yield f"2 with {count}", lambda c=count: mk.minkowski_sum([SQUARE] * 2, [SQUARE] * c), \
            value, f"2 and {count} elements"
    empty = "POLYGON EMPTY"
    yield "erosion by nothing", lambda: mk.erode(SQUARE, empty), bad, "operand 1"
    yield "in an array", lambda: mk.erode(SQUARE, [SQUARE, empty]), bad, "element 1: .*operand 1"
    yield "no part", lambda: mk.no_fit_polygon(SQUARE, empty), bad, "operand 1"
    yield "points as parts", lambda: mk.NoFitTable([SQUARE, "POINT (0 0)"]), bad, "operand 1"
    yield "missing part", lambda: mk.NoFitTable([SQUARE, None]), kind, "None"
    for turns in (0, 3, 5, -1):
        yield f"{turns} turns", lambda t=turns: mk.NoFitTable([SQUARE], turns=t), bad, "1, 2 or 4"
    for count in (0, -1, -(10**30)):
        yield f"{count} angles", lambda c=count: list(SPACE.slices(c)), value, "angle|turn|direction"
    for tolerance in (0, -1, NAN, 2):
        yield f"turn by {tolerance}", lambda t=tolerance: mk.rotate(SQUARE, 1, tolerance=t), bad, \
            "tolerance"
    yield "no direction", lambda: mk.time_of_impact(SQUARE, SQUARE, (0, 0)), bad, r"\(0, 0\)"
    yield "flat box", lambda: mk.box(0, 0, 0, 1), bad, "xmin < xmax"
    yield "box turned round", lambda: mk.box(0, 1, 1, 0), bad, "ymin < ymax"
    yield "fine disc", lambda: mk.disc(1, Fraction(1, 10**40)), mk.LimitError, "vertices"
    yield "matrix of five", lambda: mk.affine_transform(SQUARE, [1] * 5), value, "six numbers"
    yield "missing in flat arrays", lambda: mk.to_ragged_array(mk.GeometryArray([SQUARE, None])), \
        value, "element 1 is missing"
    yield "points in flat arrays", lambda: mk.to_ragged_array(mk.GeometryArray(["POINT (0 0)"])), \
        value, "element 0 has"
    yield "left over", lambda: mk.Geometry.from_bytes(SQUARE.to_bytes() + b"x"), bad, "byte 31"
    yield "another shape", lambda: mk.GeometryArray([SQUARE]).reshape([2]), value, "another size"
    yield "no such element", lambda: mk.GeometryArray([SQUARE])[1], IndexError, "1"
    yield "WKB for WKT", lambda: mk.from_wkt(SQUARE.to_wkb()), bad, "another format"
    yield "WKT for WKB", lambda: mk.from_wkb(TEXT), bad, "another format"
    yield "two systems", lambda: mk.union(SQUARE.with_srid(1), SQUARE.with_srid(2)), bad, "1 and 2"


@pytest.mark.parametrize("case", list(operands()), ids=lambda case: case[0])
def test_operands(case):
    _, operand, kind, words, place = case
    for call, number in [(lambda: mk.minkowski_sum(operand, SQUARE), 0),
                         (lambda: mk.minkowski_sum(SQUARE, operand), 1),
                         (lambda: mk.resolve(operand), None)]:
        with pytest.raises(kind, match=words or None) as caught:
            call()
        if isinstance(caught.value, mk.Error):
            found = {name: getattr(caught.value, name) for name in place}
            assert found == place and caught.value.operand == number
        elif "geometry" in str(caught.value) and number is not None:
            assert f"operand {number}" in str(caught.value)


def test_input_that_is_cut():
    count = 0
    for name, read, data, words, n in cut():
        with pytest.raises(mk.BadInputError) as caught:
            read(data)
        place = re.search(words, str(caught.value))
        # The reader names where it stands, which is no place behind the end.
        assert place and 1 <= int(place[1]) <= n + 1, (name, str(caught.value))
        count += 1
    assert count > 1000


@pytest.mark.parametrize("case", list(offsets()))
def test_ragged_arrays(case):
    coords, offsets, kind, words = case
    with pytest.raises(kind, match=words):
        mk.from_ragged_array(coords, **offsets)


@pytest.mark.parametrize("case", list(arguments()), ids=lambda case: case[0])
def test_arguments(case):
    _, call, kind, words = case
    with pytest.raises(kind, match=words):
        call()


def test_there_are_many():
    assert sum(1 for _ in itertools.chain(operands(), offsets(), arguments())) >= 500
