"""Columns of Arrow by the C data interface, without pyarrow, and operands that are kept."""

import subprocess
import sys
import textwrap

import geopandas
import numpy as np
import pyarrow as pa
import pytest
import shapely

import minksum as mk
import minksum.arrow
from conftest import random_geometry, random_ring

SHAPES = [shapely.box(0, 0, 2, 1), None,
          shapely.box(0, 0, 9, 9).difference(shapely.box(1, 1, 2, 2))]


def equal(found, shapes):
    return len(found) == len(shapes) and all(
        found[i] is None if s is None else mk.resolve(found[i]) == mk.resolve(s)
        for i, s in enumerate(shapes))


class Array:
    def __init__(self, column):
        self.column = column

    def __arrow_c_array__(self, requested_schema=None):
        return self.column.__arrow_c_array__(requested_schema)


class Stream:
    def __init__(self, column):
        self.column = column

    def __arrow_c_stream__(self, requested_schema=None):
        return self.column.__arrow_c_stream__(requested_schema)


def test_nanoarrow():
    nanoarrow = pytest.importorskip("nanoarrow", reason="nanoarrow is not installed")
    column = nanoarrow.Array(mk.GeometryArray(SHAPES))
    assert equal(minksum.arrow.from_arrow(column), SHAPES)
    assert equal(minksum.arrow.from_arrow(Stream(column)), SHAPES)
    shapes = [SHAPES[0], SHAPES[2]]
    flat = nanoarrow.Array(minksum.arrow.Column(mk.GeometryArray(shapes), "multipolygon"))
    assert equal(minksum.arrow.from_arrow(flat), shapes)
    assert equal(mk.minkowski_sum(column, "POINT (0 0)"), SHAPES)


def test_polars():
    polars = pytest.importorskip("polars", reason="polars is not installed")
    series = polars.Series([s and s.wkb for s in SHAPES] * 5, dtype=polars.Binary)
    assert equal(minksum.arrow.from_arrow(series), SHAPES * 5)
    # Short ones lie in the views themselves.
    with pytest.raises(mk.BadInputError, match="element 1: byte"):
        minksum.arrow.from_arrow(polars.Series([SHAPES[0].wkb, b"\1\1\0\0\0"]))
    assert len(polars.DataFrame({"shape": [1, 2, 3]}).with_columns(
        polars.Series("shape", mk.GeometryArray(SHAPES).to_wkb().tolist()))) == 3


@pytest.mark.parametrize("kind", [pa.binary(), pa.large_binary(), pa.binary_view()])
def test_layouts_of_wkb(kind):
    column = pa.array([None, *(s and s.wkb for s in SHAPES)], kind)
    assert equal(minksum.arrow.from_arrow(column[1:]), SHAPES)
    for form in (Array(column), Stream(pa.chunked_array([column[:2], column[2:]]))):
        assert equal(minksum.arrow.from_arrow(form), [None, *SHAPES])


@pytest.mark.parametrize("interleaved", [True, False])
@pytest.mark.parametrize("wkt", [
    "POINT (1 2)", "POINT EMPTY", "LINESTRING (0 0, 1 2, 3 3)", "MULTIPOINT ((0 0), (1 2))",
    "MULTILINESTRING ((0 0, 1 2), (5 5, 6 7, 8 8))", "POLYGON ((0 0, 4 0, 0 4, 0 0))",
    "MULTIPOLYGON (((0 0, 4 0, 0 4, 0 0)), ((9 9, 10 9, 9 10, 9 9)))"])
def test_types_of_geoarrow(wkt, interleaved):
    shapes = [shapely.from_wkt(wkt), shapely.from_wkt(wkt)]
    column = geopandas.GeoSeries(shapes).to_arrow(geometry_encoding="geoarrow",
                                                  interleaved=interleaved)
    assert equal(minksum.arrow.from_arrow(column), shapes)


def lists(*offsets, vertices=4):
    coords = pa.FixedSizeListArray.from_arrays(pa.array(np.zeros(2 * vertices)), 2)
    numbers = np.zeros(len(offsets), np.int32)
    rings = pa.Array.from_buffers(pa.list_(coords.type), len(offsets) - 1,
                                  [None, pa.py_buffer(numbers)], children=[coords])
    column = pa.ListArray.from_arrays(pa.array([0, len(offsets) - 1], pa.int32()), rings)
    numbers[:] = offsets  # pyarrow would refuse them above
    return column


@pytest.mark.parametrize("offsets", [(0, 3, 2, 4), (0, 5), (-1, 4), (0, 4, -3), (2, 1)])
def test_offsets_that_run_back_or_beyond(offsets):
    with pytest.raises(mk.BadInputError, match="element 0: offset .* must not decrease or pass"):
        minksum.arrow.from_arrow(lists(*offsets))


def test_columns_name_what_is_wrong():
    good = SHAPES[0].wkb
    column = pa.chunked_array([pa.array([good, good]), pa.array([good, None, good[:30]])])
    with pytest.raises(mk.BadInputError, match="element 4: byte") as caught:
        minksum.arrow.from_arrow(column)
    assert caught.value.index == 4
    assert equal(minksum.arrow.from_arrow(column, on_error="none"),
                 [SHAPES[0]] * 3 + [None, None])
    broken = pa.FixedSizeListArray.from_arrays(pa.array([0, 0, 1, None, 1, 1.0]), 2)
    rings = pa.ListArray.from_arrays(pa.array([0, 3], pa.int32()), broken)
    with pytest.raises(mk.BadInputError, match="element 0: vertex 1 .* is missing"):
        minksum.arrow.from_arrow(pa.ListArray.from_arrays(pa.array([0, 1], pa.int32()), rings))
    with pytest.raises(ValueError, match="one dimension"):
        minksum.arrow.to_arrow(mk.GeometryArray(SHAPES[:1]).reshape([1, 1]))


def test_pyarrow_is_not_needed():
    program = textwrap.dedent("""
        import sys
        sys.modules["pyarrow"] = None
        import minksum.arrow
        shapes = minksum.GeometryArray([minksum.box(0, 0, 1, 1), None])
        for encoding, array in [("wkb", shapes), ("multipolygon", shapes[:1])]:
            column = minksum.arrow.to_arrow(array, encoding=encoding)
            assert minksum.arrow.from_arrow(column) == array
        print("read")
    """)
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert run.stdout == "read\n"


def test_elements_that_fail_are_left_out():
    square = mk.box(0, 0, 1, 1)
    texts = [square.to_wkb(), b"\1\3", str(square), "POLYGON ((0 0", None]
    for found in (mk.minkowski_sum(texts, square, on_error="none"),
                  mk.offset(texts, 1, on_error="none"), mk.as_geometry(texts, on_error="none"),
                  mk.covers(square, texts, on_error="none")):
        assert [g is None for g in found] == [False, True, False, True, True]
    assert mk.erode(square, "POLYGON EMPTY", on_error="none") is None
    assert mk.resolve("POLYGON ((0 0", on_error="none") is None
    found = mk.erode([square] * 3, [square, mk.from_wkt("POLYGON EMPTY"), square], on_error="none")
    assert [g is None for g in found] == [False, True, False]
    # What is about the call and not about an element ends it.
    with pytest.raises(ValueError, match='"none"'):
        mk.resolve(square, on_error="ignore")
    with pytest.raises(TypeError):
        mk.resolve([square, 3], on_error="none")
    token = mk.CancelToken()
    token.cancel()
    with pytest.raises(mk.CancelledError):
        mk.resolve([square] * 9, on_error="none", cancel=token)


def test_statistics():
    square = mk.box(0, 0, 1, 1)
    total, counts = mk.minkowski_sum(square, square, return_stats=True)
    assert total == square + square and counts["convolution_segments"] == 8
    totals, tight, each = mk.minkowski_sum([square, None], square, tight=True, return_stats=True)
    assert totals[0] == total and tight[0].is_empty and totals[1] is each[1] is None
    assert each.shape == (2,) and each[0]["seconds"] > 0


def test_operands_that_are_kept(rng):
    for _ in range(100):
        shapes = [mk.resolve([random_ring(rng, 40)])[0], random_geometry(rng, 40),
                  mk.Geometry(random_ring(rng, 40))]  # the last one is not valid as it is
        expected = {}
        for again in range(3):
            for i, a in enumerate(shapes):
                for j, b in enumerate(shapes):
                    found = mk.minkowski_sum(a, b)
                    first = expected.setdefault((i, j), found)
                    assert found == first and found.origins == first.origins
                    assert str(found) == str(first)
        anew = [mk.prepare(mk.Geometry.from_bytes(s.to_bytes())) for s in shapes]
        for (i, j), total in expected.items():
            assert mk.minkowski_sum(anew[i], anew[j]) == total
    assert mk.prepare([shapes[0], None])[1] is None
