"""What goes in and comes out: numbers, texts, arrays, other packages, pickles."""

import pickle
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import shapely
from conftest import random_geometry

import minksum as mk

TRIANGLE = "POLYGON ((0 0, 1/3 0, 0 1, 0 0))"


def test_numbers_are_exact():
    assert mk.box(0, 0, 0.1, 1) != mk.box(0, 0, "0.1", 1)
    assert mk.box(0, 0, Decimal("0.1"), 1) == mk.box(0, 0, "1/10", 1)
    assert mk.area(mk.box(0, 0, Fraction(1, 3), 2), exact=True) == Fraction(2, 3)
    huge = 10**60 + 1
    assert mk.bounds(mk.box(-huge, 0, huge, Fraction(1, huge)), exact=True) == (
        -huge, 0, huge, Fraction(1, huge))
    assert mk.area(mk.box(np.int64(0), np.float64(0), np.float32(0.5), 2), exact=True) == 1
    assert type(mk.area(mk.box(0, 0, 2, 2), exact=True)) is int
    assert mk.box(-1, 0, Fraction(1, 3), 2).bounds == (-1.0, 0.0, 1 / 3, 2.0)
    assert mk.from_wkt("GEOMETRYCOLLECTION (POINT (5 1/2), LINESTRING (1 7, 2 3))").bounds == (
        1.0, 0.5, 5.0, 7.0)
    assert mk.from_wkt("POLYGON EMPTY").bounds is None


def test_every_form_of_an_operand():
    square = mk.box(0, 0, 2, 2)
    points = [(0, 0), (2, 0), (2, 2), (0, 2)]
    forms = [
        "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))",
        points,
        points + points[:1],
        np.array(points, dtype=float),
        np.array(points, dtype=np.int64),
        np.array(points, dtype=np.int32),
        [[Fraction(x), Fraction(y)] for x, y in points],
        shapely.box(0, 0, 2, 2),
        shapely.to_wkb(shapely.box(0, 0, 2, 2)),
        shapely.to_wkb(shapely.box(0, 0, 2, 2), hex=True),
        {"type": "Polygon", "coordinates": [points + points[:1]]},
        {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [points + points[:1]]}},
        '{"type": "Polygon", "coordinates": [[[0,0],[2,0],[2,2],[0,2],[0,0]]]}',
        square,
    ]
    for form in forms:
        assert mk.resolve(form) == square, form
    assert mk.resolve([forms[0], forms[7], None]) == mk.GeometryArray([square, square, None])


def test_missing_geometries_stay_missing():
    assert mk.minkowski_sum(None, "POINT (1 1)") is None
    result = mk.minkowski_sum([TRIANGLE, None], "POINT (1 1)")
    assert result[1] is None and result[0] is not None
    assert mk.area([None, mk.box(0, 0, 1, 1)]).tolist() == [None, 1.0]


def test_broadcasting():
    a = mk.GeometryArray([mk.box(0, 0, i + 1, 1) for i in range(3)]).reshape([3, 1])
    b = mk.GeometryArray([mk.box(0, 0, 1, j + 1) for j in range(4)])
    table = mk.minkowski_sum(a, b)
    assert table.shape == (3, 4)
    assert table[2, 3] == mk.box(0, 0, 4, 5)
    assert table[:, 1].shape == (3,)
    assert len(table[1:]) == 2
    assert np.asarray(table).shape == (3, 4)
    with pytest.raises(ValueError, match="3 and 2 elements"):
        mk.minkowski_sum(a[:, 0], b[:2])
    assert mk.minkowski_sum([], mk.box(0, 0, 1, 1)).shape == (0,)


def test_pickles_and_bytes(rng):
    for _ in range(200):
        g = mk.minkowski_sum(random_geometry(rng), random_geometry(rng))
        copy = pickle.loads(pickle.dumps(g))
        assert copy == g and hash(copy) == hash(g) and copy.to_bytes() == g.to_bytes()
    collection = mk.from_wkt(
        "GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 0 1, 0 0)), LINESTRING (5 5, 6 1/7), POINT (9 9))")
    assert mk.Geometry.from_bytes(collection.to_bytes()) == collection
    array = mk.GeometryArray([collection, None]).reshape([2, 1])
    assert pickle.loads(pickle.dumps(array)) == array
    assert mk.Geometry.from_bytes(collection.with_srid(4326).to_bytes()).srid == 4326


def test_bytes_that_were_changed_are_refused():
    whole = mk.from_wkt("MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((5 5, 7 5, 5 7, 5 5)))").to_bytes()
    for n in range(len(whole)):
        with pytest.raises(mk.BadInputError, match=r"byte \d+: "):
            mk.Geometry.from_bytes(whole[:n])
    with pytest.raises(mk.BadInputError, match="left behind"):
        mk.Geometry.from_bytes(whole + b"\0")


def test_ragged_arrays():
    shapes = [shapely.box(0, 0, 1, 1),
              shapely.MultiPolygon([shapely.box(0, 0, 9, 9, ccw=True) - shapely.box(2, 2, 3, 3),
                                    shapely.box(20, 20, 21, 21)])]
    array = mk.as_geometry(shapes)
    coords, (rings, polygons, geometries) = mk.to_ragged_array(mk.resolve(array))
    back = shapely.from_ragged_array(
        shapely.GeometryType.MULTIPOLYGON, coords, (rings, polygons, geometries))
    assert all(shapely.equals(a, b) for a, b in zip(shapes, back))
    again = mk.from_ragged_array(coords, rings, polygons, geometries)
    assert mk.resolve(again) == mk.resolve(array)
    for bad in ([0, 5, 4, len(coords)], [1, 5, len(coords)], [0, len(coords) + 1], []):
        with pytest.raises(mk.BadInputError, match="ring_offsets"):
            mk.from_ragged_array(coords, np.array(bad, dtype=np.int64), polygons, geometries)


def test_shapely_in_and_out():
    import geopandas

    from minksum import shapely as ms

    a = shapely.Point(0, 0).buffer(1)
    assert ms.minkowski_sum(a, shapely.box(0, 0, 1, 1)).is_valid
    series = geopandas.GeoSeries([shapely.box(0, 0, 1, 1), None, a], index=[7, 8, 9], crs=25832)
    grown = ms.offset(series, 1, side="outside", round="outside")
    assert list(grown.index) == [7, 8, 9] and grown.crs == series.crs
    assert grown[8] is None and grown[9].contains(a.buffer(0.99))
    with pytest.warns(UserWarning, match="geographic"):
        ms.offset(series.set_crs(4326, allow_override=True), 1)
    inside = ms.offset(a, 0.5, side="inside", round="inside")
    outside = ms.offset(a, 0.5, side="outside", round="outside")
    exact = mk.offset(a, 0.5, side="inside")
    assert mk.covers(exact, inside) and mk.covers(outside, exact)


def test_reference_systems():
    a = shapely.set_srid(shapely.box(0, 0, 1, 1), 3857)
    assert mk.minkowski_sum(a, mk.box(0, 0, 1, 1)).srid == 3857
    assert shapely.get_srid(shapely.from_wkb(mk.resolve(a).to_wkb(include_srid=True))) == 3857
    with pytest.raises(mk.BadInputError, match="3857 and 4326"):
        mk.minkowski_sum(a, shapely.set_srid(shapely.box(0, 0, 1, 1), 4326))


    import geopandas

    columns = [geopandas.GeoSeries([shapely.box(0, 0, 1, 1)], crs=crs) for crs in (25832, 3857)]
    with pytest.raises(mk.BadInputError, match="25832 and 3857"):
        mk.minkowski_sum(*columns)


def test_shapely_with_details_and_names():
    import geopandas

    from minksum import shapely as ms

    series = geopandas.GeoSeries([shapely.box(0, 0, 3, 1)], index=[5], crs=25832)
    part = shapely.box(0, 0, 1, 1)
    total, places, counts = ms.minkowski_sum(b=part, a=series, tight=True, return_stats=True)
    assert total.crs == places.crs == series.crs and list(total.index) == [5]
    assert total[5].equals(shapely.box(0, 0, 4, 2)) and counts[0]["small"] in (True, False)
    total, counts = ms.minkowski_sum(part, part, return_stats=True)
    assert total.equals(shapely.box(0, 0, 2, 2)) and "loops" in counts


def test_numbers_of_numpy():
    assert mk.scale(mk.box(0, 0, 1, 1), np.int64(2), np.float32(0.5)) == mk.box(0, 0, 2, "1/2")
    assert mk.scale(mk.box(0, 0, 1, 1), 3, 3, origin=np.array([1, 1])) == mk.box(-2, -2, 1, 1)
    assert mk.rotate(mk.box(0, 0, 1, 1), np.int32(90), origin=np.array([0.5, 0.5])) == mk.resolve(mk.box(0, 0, 1, 1))


def test_arrays_of_exact_pairs():
    pairs = [(Fraction(1, 3), 0), (1, 0), (0, "1/7")]
    ring = mk.as_geometry(pairs)
    assert mk.as_geometry(np.array(pairs, dtype=object)) == ring
    assert list(mk.as_geometry(np.array([pairs, pairs], dtype=object))) == [ring, ring]


def test_areas_count_each_point_once():
    for wkt, area in (("POLYGON ((0 0, 2 0, 0 2, 2 2, 0 0))", 2),
                      ("MULTIPOLYGON (((0 0, 2 0, 2 2, 0 0)), ((0 0, 2 0, 2 2, 0 0)))", 2)):
        assert mk.from_wkt(wkt).area == mk.area(wkt) == mk.area(wkt, exact=True) == area


def test_drawings_in_other_encodings(tmp_path):
    svg = tmp_path / "a.svg"
    head = '<?xml version="1.0" encoding="ISO-8859-1"?><svg xmlns="http://www.w3.org/2000/svg">'
    svg.write_bytes((head + '<g id="\u00df"><path d="M0 0H2V2Z"/></g></svg>').encode("latin-1"))
    assert mk.io.read_svg(svg).area == 2


def test_how_a_geometry_is_shown():
    triangle = mk.from_wkt(TRIANGLE)
    assert str(triangle) == TRIANGLE
    assert repr(triangle) == "<minksum.Geometry POLYGON, 1 part, 3 vertices>"
    assert triangle.to_wkt(decimals=2, round="outside") != triangle.to_wkt(decimals=2)
    assert triangle._repr_svg_().startswith("<svg")
    assert triangle.__geo_interface__["type"] == "Polygon"
    assert triangle.exact_coords()["polygons"] == [[[(0, 0), (Fraction(1, 3), 0), (0, 1)]]]
    assert '"1/3"' in triangle.to_geojson(exact=True)
    assert shapely.geometry.shape(triangle).is_valid
    assert triangle.coords.shape == (3, 2)


def test_operators_are_those_of_sets():
    a, b = mk.box(0, 0, 2, 2), mk.box(1, 1, 3, 3)
    assert a + b == mk.minkowski_sum(a, b)
    assert -a == mk.box(-2, -2, 0, 0)
    assert (a | b) == mk.union(a, b) == mk.union_all([a, b])
    assert (a & b) == mk.box(1, 1, 2, 2)
    assert (a ^ b) == (a | b) - (a & b)
    with pytest.raises(TypeError):
        a + 1


def test_plotting():
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    from minksum.plotting import plot_geometry

    ax = plot_geometry("GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 0 4, 0 0), (1 1, 2 1, 1 2, 1 1)), "
                       "LINESTRING (5 5, 6 6), POINT (7 7))", pyplot.figure().gca())
    assert len(ax.patches) == 1 and len(ax.lines) == 2
    hole_like_its_outline = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 6 3, 6 6, 3 6, 3 3))"
    path = plot_geometry(hole_like_its_outline, pyplot.figure().gca()).patches[0].get_path()
    # matplotlib fills by winding numbers, so the hole must run the other way.
    assert path.vertices[5:].tolist() == [[3, 3], [3, 6], [6, 6], [6, 3], [3, 3]]


def test_drawings_and_instances(tmp_path):
    from minksum import io

    svg = tmp_path / "a.svg"
    svg.write_text('<svg xmlns="http://www.w3.org/2000/svg"><circle cx="0" cy="0" r="10"/></svg>')
    with pytest.raises(mk.BadInputError, match=r"a\.svg: .*tolerance"):
        io.read_svg(svg)
    inside, outside = (io.read_svg(svg, tolerance="0.1", side=s) for s in ("inside", "outside"))
    assert mk.covers(outside, inside) and 310 < inside.area < 315 < outside.area
    instance = tmp_path / "i.json"
    instance.write_text(
        '{"items": [{"demand": 2, "shape": {"type": "simple_polygon", "data": [[0,0],[1,0],[0,1],'
        '[0,0]]}}], "bins": [{"shape": {"type": "rectangle", "data": {"width": 5, "height": 3}}}]}')
    read = io.read_jagua(instance)
    assert read["items"][0]["demand"] == 2 and read["items"][0]["geometry"].area == 0.5
    assert read["bins"][0]["geometry"] == mk.box(0, 0, 5, 3)
    for text, fault in [
        ("{", "i.json: Expecting"),
        ("[]", "i.json: not an object"),
        ('{"items": 5}', "i.json: items must be a list"),
        ('{"items": [{}]}', "i.json: item 0 has no shape"),
        ('{"bins": [{"shape": {"type": "rectangle", "data": {"width": 5}}}]}', "bin 0 .* 'height'"),
    ]:
        instance.write_text(text)
        with pytest.raises(mk.BadInputError, match=fault):
            io.read_jagua(instance)
    drawing = tmp_path / "b.dxf"
    drawing.write_text("0\nSECTION\n2\nENTITIES\n0\nLINE\n10\nx\n0\nENDSEC\n0\nEOF\n")
    with pytest.raises(mk.BadInputError, match=r"b\.dxf: ") as caught:
        io.read_dxf(drawing)
    assert caught.value.line == 8
