"""Arrow, DuckDB, and tables that Dask makes."""

import doctest
import os
import pickle
import signal
import threading
import time

import dask
import dask.dataframe
import distributed
import duckdb
import geopandas
import pandas
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
import shapely

import minksum
import minksum.arrow
import minksum.dask
import minksum.duckdb
from conftest import random_geometry

SHAPES = [
    shapely.box(0, 0, 2, 1),
    shapely.box(0, 0, 9, 9).difference(shapely.box(1, 1, 2, 2)),
    shapely.MultiPolygon([shapely.box(0, 0, 1, 1), shapely.box(3, 3, 4, 4)]),
]


@pytest.mark.parametrize("encoding", ["WKB", "geoarrow"])
@pytest.mark.parametrize("interleaved", [True, False])
def test_columns_of_geopandas(encoding, interleaved):
    for shapes in (SHAPES, SHAPES[:2], [SHAPES[0], None, SHAPES[1]]):
        series = geopandas.GeoSeries(shapes)
        column = series.to_arrow(geometry_encoding=encoding, interleaved=interleaved)
        found = minksum.arrow.from_arrow(column)
        expected = [None if s is None else minksum.Geometry(s) for s in shapes]
        assert len(found) == len(expected)
        for i, geometry in enumerate(expected):
            assert found[i] is None if geometry is None else minksum.resolve(
                found[i]) == minksum.resolve(geometry)


@pytest.mark.parametrize("encoding", ["wkb", "multipolygon"])
def test_columns_for_geopandas(encoding):
    column = minksum.arrow.to_arrow(SHAPES, encoding=encoding)
    series = geopandas.GeoSeries.from_arrow(column)
    assert all(a.equals(b) for a, b in zip(series, SHAPES))
    again = minksum.arrow.from_arrow(column)
    assert all(minksum.resolve(again[i]) == minksum.resolve(s) for i, s in enumerate(SHAPES))


def test_slices_and_chunks_of_columns():
    column = minksum.arrow.to_arrow(SHAPES, encoding="multipolygon").storage
    assert minksum.arrow.from_arrow(column[1:])[0] == minksum.arrow.from_arrow(column)[1]
    chunks = pa.chunked_array([column[:1], column[1:]])
    assert len(minksum.arrow.from_arrow(chunks)) == 3


@pytest.mark.parametrize(("column", "kind"), [
    (pa.array([1, 2]), minksum.BadInputError), ([1, 2], TypeError), (None, TypeError),
    (pa.array([[[[1.0, 2.0, 3.0]]]], pa.list_(pa.list_(pa.list_(pa.float64(), 3)))),
     minksum.BadInputError),
    (pa.array(["POINT (1 1)"]), minksum.BadInputError),
    (pa.array([[[{"x": 1.0, "y": 2.0, "z": 3.0}]]]), minksum.BadInputError),
    (pa.array([[1.0, 2.0]], pa.list_(pa.float64(), 2)), minksum.BadInputError),
])
def test_columns_that_are_refused(column, kind):
    with pytest.raises(kind):
        minksum.arrow.from_arrow(column)


def test_bad_elements_of_columns_are_named():
    good = minksum.box(0, 0, 1, 1).to_wkb()
    with pytest.raises(minksum.BadInputError) as caught:
        minksum.arrow.from_arrow(pa.array([good, None, good[:20]]))
    assert caught.value.index == 2
    with pytest.raises(ValueError, match="encoding"):
        minksum.arrow.to_arrow(SHAPES, encoding="json")


def test_functions_in_duckdb():
    con = duckdb.connect()
    minksum.duckdb.register(con)
    con.register("shapes", pa.table({
        "id": [0, 1, 2, 3],
        "shape": pa.array([*(s.wkb for s in SHAPES), None]),
    }))
    rows = con.execute("SELECT mink_sum(shape, shape), mink_offset(shape, 1), mink_area(shape) "
                       "FROM shapes ORDER BY id").fetchall()
    for shape, (total, grown, area) in zip(SHAPES, rows):
        assert minksum.from_wkb(total) == minksum.rounded(minksum.minkowski_sum(shape, shape))
        assert minksum.from_wkb(grown) == minksum.rounded(minksum.offset(shape, 1))
        assert area == pytest.approx(shape.area)
    assert rows[3] == (None, None, None)
    with pytest.raises(Exception, match="WKB|byte|expected"):
        con.execute("SELECT mink_area('\\x01\\x03'::BLOB)").fetchall()


def read_all(paths):
    return pa.concat_tables(pq.read_table(path) for path in paths)


def test_blocks_are_the_table(rng, tmp_path):
    parts = []
    while len(parts) < 5:
        part = random_geometry(rng)
        if part.area > 0:
            parts.append(part)
    rows = read_all(minksum.dask.no_fit_table(parts, out=tmp_path, block=(2, 3))).to_pylist()
    table = minksum.NoFitTable(parts)
    assert len(rows) == (5 * 4) ** 2
    for row in rows:
        entry = table[(row["fixed"], row["fixed_turn"]), (row["moving"], row["moving_turn"])]
        assert minksum.Geometry.from_bytes(row["exact"]) == entry
        assert row["geometry"] == entry.to_wkb() and row["error"] is None


def test_blocks_that_are_there_are_not_made_again(tmp_path):
    paths = minksum.dask.no_fit_table(SHAPES, out=tmp_path, turns=1, block=(1, 2))
    times = [path.stat().st_mtime_ns for path in paths]
    data = [path.read_bytes() for path in paths]
    paths[1].unlink()
    assert minksum.dask.no_fit_table(SHAPES, out=tmp_path, turns=1, block=(1, 2)) == paths
    assert [path.read_bytes() for path in paths] == data
    again = [path.stat().st_mtime_ns for path in paths]
    assert again[1] != times[1] and again[:1] + again[2:] == times[:1] + times[2:]
    assert not set(paths) & set(minksum.dask.no_fit_table(SHAPES, out=tmp_path, turns=2))
    with pytest.raises(minksum.BadInputError):
        minksum.dask.no_fit_table(["POINT (1 1)"], out=tmp_path)


def test_two_processes_make_equal_bytes(tmp_path):
    far = minksum.box(0, 0, 10**400, 1)  # lies beyond doubles, so its pairs have no WKB
    parts = [*SHAPES, far]
    alone = minksum.dask.no_fit_table(parts, out=tmp_path / "alone", block=(2, 4))
    for row in read_all(alone).to_pylist():
        failed = 3 in (row["fixed"], row["moving"])
        assert [row["geometry"] is None, row["exact"] is None, row["error"] is not None] == (
            [failed] * 3)
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1,
                                  dashboard_address="127.0.0.1:0",
                                  host="127.0.0.1") as cluster:
        with distributed.Client(cluster) as client:
            shared = minksum.dask.no_fit_table(parts, out=tmp_path / "shared", block=(2, 4),
                                               client=client)
            column = pandas.Series([*(s.wkb for s in SHAPES), None],
                                   dtype=pandas.ArrowDtype(pa.binary()))
            frame = dask.dataframe.from_pandas(pandas.DataFrame({"geometry": column}),
                                               npartitions=2)
            grown = minksum.dask.map_geometries(frame, "offset", 1).compute()
            shape = minksum.Geometry(SHAPES[1])
            tokens = {dask.base.tokenize(shape), *client.run(dask.base.tokenize, shape).values()}
    assert [p.read_bytes() for p in shared] == [p.read_bytes() for p in alone]
    for shape, wkb in zip(SHAPES, grown["geometry"]):
        assert bytes(wkb) == minksum.offset(shape, 1).to_wkb()
    assert pandas.isna(grown["geometry"].iloc[3])
    assert len(tokens) == 1


def space_of_slices():
    walls = minksum.union_all([minksum.box(4, -9, 5, -1), minksum.box(4, 1, 5, 9)])
    return minksum.ConfigurationSpace(minksum.box(-1, "-1/3", 1, "1/3"), walls, reference=(0, 0),
                                      workspace=minksum.box(-3, -9, 12, 9))


def test_slices_are_those_of_the_space(tmp_path):
    space = space_of_slices()
    paths = minksum.dask.slices(space, 10, out=tmp_path, block=4, free=True)
    times = [path.stat().st_mtime_ns for path in paths]
    rows = read_all(paths).to_pylist()
    assert len(paths) == 3 and len(rows) == 10
    for row, made in zip(rows, space.slices(10, free=True)):
        assert row["asked"] == str(made.asked) and row["degrees"] == made.degrees
        assert minksum.Geometry.from_bytes(row["exact_obstacles"]) == made.obstacles
        assert minksum.Geometry.from_bytes(row["exact_free"]) == made.free
        assert row["free"] == made.free.to_wkb() and row["error"] is None
    again = pickle.loads(pickle.dumps(space))
    assert minksum.dask.slices(again, 10, out=tmp_path, block=4, free=True) == paths
    assert [path.stat().st_mtime_ns for path in paths] == times
    assert not set(paths) & set(minksum.dask.slices(space, 10, out=tmp_path, block=4))
    assert len(geopandas.read_parquet(paths[0])) == 4


def test_a_worker_is_killed_in_the_middle(rng, tmp_path):
    parts = [minksum.resolve([(0, 0), *((x, rng.randrange(1, 9)) for x in range(30)), (30, 0)])
             for _ in range(10)]
    alone = minksum.dask.no_fit_table(parts, out=tmp_path / "alone", turns=2, block=(1, 2))
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1,
                                  dashboard_address="127.0.0.1:0",
                                  host="127.0.0.1") as cluster:
        with distributed.Client(cluster) as client:
            victim = next(iter(client.run(os.getpid).values()))
            folder = tmp_path / "shared"
            killed = []

            def kill():
                while not any(folder.glob("*.parquet")):
                    time.sleep(0.001)
                os.kill(victim, signal.SIGKILL)
                killed.append(len(list(folder.glob("*.parquet"))))

            killer = threading.Thread(target=kill)
            killer.start()
            shared = minksum.dask.no_fit_table(parts, out=folder, turns=2, block=(1, 2),
                                               client=client)
            killer.join()
    assert 0 < killed[0] < len(alone) == 50
    assert [p.read_bytes() for p in shared] == [p.read_bytes() for p in alone]


@pytest.mark.parametrize("module", [minksum.arrow, minksum.duckdb])
def test_examples(module):
    result = doctest.testmod(module)
    assert result.attempted >= 3 and result.failed == 0
