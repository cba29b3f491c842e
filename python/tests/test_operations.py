"""Operations: laws through the whole stack, and equality with the program."""

import json
import random
import subprocess
from fractions import Fraction

import pytest
import shapely
from conftest import random_geometry, random_ring
from hypothesis import given, settings
from hypothesis import strategies as st

import minksum as mk


@st.composite
def geometries(draw):
    seed = draw(st.integers(0, 2**32))
    return random_geometry(random.Random(seed))


@given(geometries(), geometries(), geometries())
@settings(max_examples=150, deadline=None)
def test_laws(a, b, c):
    assert a + b == b + a
    assert (a + b) + c == a + (b + c)
    assert -(a + b) == (-a) + (-b)
    point = mk.from_wkt("POINT (1/3 -2)")
    assert a + point == mk.translate(a, "1/3", -2)
    assert mk.union(a, b) + c == mk.union(a + c, b + c)
    if not a.has_thin_parts and not b.is_empty and b.num_polygons:
        opened = mk.opening(a, b)
        assert mk.covers(a, opened) and mk.opening(opened, b) == opened
        assert mk.covers(mk.closing(a, b), a)
    assert mk.area(mk.scale(a, 3, 3), exact=True) == 9 * mk.area(a, exact=True)
    assert mk.rotate(mk.rotate(a, 90), 270) == a


def test_equal_to_the_program_byte_for_byte(program, tmp_path):
    rng = random.Random(7)
    firsts, seconds = [], []
    for _ in range(2000):
        firsts.append(mk.resolve([random_ring(rng, rng.randrange(3, 12))])[0])
        seconds.append(mk.resolve([random_ring(rng, rng.randrange(3, 12))])[0])
    jobs = tmp_path / "jobs.jsonl"
    with open(jobs, "w") as out:
        for i, (p, q) in enumerate(zip(firsts, seconds)):
            job = {"id": i, "operation": "sum", "a": {"wkt": str(p)}, "b": {"wkt": str(q)}}
            out.write(json.dumps(job) + "\n")
    run = subprocess.run([program, "batch", str(jobs), "--coords", "exact"],
                         capture_output=True, text=True, check=True)
    lines = [json.loads(line) for line in run.stdout.splitlines()]
    sums = mk.minkowski_sum(firsts, seconds)
    assert len(lines) == 2000
    for line in lines:
        assert line["result"]["wkt"] == str(sums[line["id"]])


def test_tight_places():
    fixed = mk.from_wkt("POLYGON ((0 0, 6 0, 6 5, 4 5, 4 2, 2 2, 2 5, 0 5, 0 0))")
    key = mk.box(0, 0, 2, 3)
    nfp = mk.no_fit_polygon(fixed, key, reference=(0, 0))
    assert nfp.has_thin_parts
    _, tight = mk.minkowski_sum(fixed, mk.reflect(key), tight=True)
    assert not tight.is_empty
    polygon = mk.NoFitPolygon(fixed, key, reference=(0, 0))
    assert polygon.contact([(2, 2), (2, 1), (20, 20)]) == ["touching", "overlapping", "free"]
    bin_ = mk.box(0, 0, 2, 9)
    assert mk.inner_fit_polygon(bin_, key, reference=(0, 0)).geom_type == "LineString"


def test_written_no_fit_polygons_keep_their_tight_places():
    slot = mk.from_wkt("POLYGON ((0 0, 6 0, 6 4, 4 4, 4 1, 2 1, 2 4, 0 4, 0 0))")
    nfp = mk.no_fit_polygon(slot, mk.box(0, 0, 2, 3))
    text = "GEOMETRYCOLLECTION (POLYGON ((-2 -3, 6 -3, 6 4, -2 4, -2 -3)), LINESTRING (2 1, 2 4))"
    assert str(nfp) == text
    for side in ("nearest", "outside", "inside"):
        assert nfp.to_wkt(round=side) == text
        assert mk.from_wkb(nfp.to_wkb(round=side)) == nfp
    assert mk.from_geojson(nfp.to_geojson()) == nfp


def test_rounded_no_fit_polygons_keep_their_tight_places(program, tmp_path):
    slot = "POLYGON ((0 0, 6 0, 6 4, 4 4, 4 4/3, 2 4/3, 2 4, 0 4, 0 0))"
    peg = "POLYGON ((0 0, 2 0, 2 3, 0 3, 0 0))"
    nfp = mk.no_fit_polygon(slot, peg)
    files = [tmp_path / "slot.wkt", tmp_path / "peg.wkt"]
    for file, text in zip(files, (slot, peg)):
        file.write_text(text)
    for side in ("nearest", "outside", "inside"):
        run = subprocess.run([program, "nfp", *map(str, files), "--round", side, "--coords",
                              "decimal:0"], capture_output=True, text=True, check=True)
        expected = mk.from_wkt(run.stdout.strip())
        assert expected.geom_type == "GeometryCollection"
        assert mk.rounded(nfp, decimals=0, side=side) == expected
        assert mk.from_wkt(nfp.to_wkt(decimals=0, round=side)) == expected


def test_no_fit_polygons_that_were_read_keep_their_tight_places():
    fixed = "POLYGON ((0 0, 6 0, 6 4, 4 4, 4 4/3, 2 4/3, 2 4, 0 4, 0 0))"
    polygon = mk.NoFitPolygon(fixed, mk.box(0, 0, 2, 3)).geometry
    for read in (mk.from_wkt(str(polygon)), mk.Geometry.from_bytes(polygon.to_bytes())):
        assert mk.rounded(read) == mk.rounded(polygon) != mk.rounded(mk.resolve(polygon))
        assert read.to_wkt() == polygon.to_wkt()
        assert "LINESTRING" in read.to_wkt()


def test_moved_no_fit_polygons_keep_their_tight_places():
    fixed = "POLYGON ((0 0, 6 0, 6 4, 4 4, 4 1, 2 1, 2 4, 0 4, 0 0))"
    nfp = mk.no_fit_polygon(fixed, mk.box(0, 0, 2, 3))
    text = "GEOMETRYCOLLECTION (POLYGON ((0 -2, 8 -2, 8 5, 0 5, 0 -2)), LINESTRING (4 2, 4 5))"
    assert str(mk.translate(nfp, 2, 1)) == text
    assert mk.translate(mk.translate(nfp, "1/3", 5), "-1/3", -5) == nfp
    assert mk.rotate(mk.rotate(nfp, 90), 270) == nfp == -(-nfp)
    assert str(mk.reflect(nfp)).endswith("LINESTRING (-2 -4, -2 -1))")
    assert str(mk.scale(nfp, 2, 2)).endswith("LINESTRING (4 2, 4 8))")


def test_comparison_with_none():
    square = mk.box(0, 0, 1, 1)
    assert square != None  # noqa: E711
    assert None not in [square]
    assert mk.GeometryArray([square]) != None  # noqa: E711


def test_tables_are_their_entries():
    parts = [mk.box(0, 0, 2, 1), mk.from_wkt("POLYGON ((0 0, 3 0, 0 1/3, 0 0))")]
    table = mk.NoFitTable(parts)
    assert len(table) == 2 and table.turns == 4
    entries = table.entries()
    assert entries.shape == (2, 4, 2, 4)
    for i in range(2):
        for j in range(2):
            assert table[i, j] == mk.no_fit_polygon(parts[i], parts[j], reference=(0, 0))
            assert entries[i, 1, j, 3] == table[(i, 1), (j, 3)]
    assert table.entries(1, 2)[0, 0, 0, 0] == table[1, 0]
    with pytest.raises(mk.BadInputError):
        table[0, 2]


def test_depth_and_impact():
    a, b = mk.box(0, 0, 4, 4), mk.box(3, 1, 5, 3)
    depth = mk.penetration_depth(a, b)
    assert depth.overlapping and depth.vector == (1, 0) and depth.squared == 1
    assert mk.penetration_depth(a, "POINT (3 2)").vector == (1, 0)
    assert mk.penetration_depth(a, "POINT EMPTY") is None
    assert mk.time_of_impact(a, mk.box(5, 0, 6, 1), ("-1/3", 0)) == 3
    assert mk.time_of_impact(a, mk.box(5, 0, 6, 1), (1, 0)) is None
    assert mk.locate(a, [(0, 0), (1, 1), (Fraction(9, 2), 0)]).tolist() == [0, 1, -1]


def test_configuration_space_and_path():
    robot = mk.from_wkt("POLYGON ((-1 -1/2, 1 -1/2, 1 1/2, -1 1/2, -1 -1/2))")
    walls = [mk.box(4, -9, 5, -1), mk.box(4, 1, 5, 9)]
    walls = mk.union_all(walls)
    space = mk.ConfigurationSpace(robot, walls)
    found = list(space.slices([0, 45, 90], free=True))
    assert [s.asked for s in found] == [0, 45, 90]
    assert found[0].obstacles == mk.minkowski_sum(walls, mk.reflect(robot))
    assert found[2].direction == (0, 1) and found[1].off < 1e-3
    path = mk.reach(robot, walls, (0, 0, 90), (9, 0, 90), workspace=mk.box(-3, -9, 12, 9))
    assert path.reachable and path.path[0][0] == (0, 0) and path.path[-1][0] == (9, 0)


def test_offsets_hold_their_side():
    shape = shapely.Point(0, 0).buffer(3).difference(shapely.box(-1, -1, 1, 5))
    for distance in (1, -0.25):
        inside, near, outside = (
            mk.offset(shape, distance, tolerance="1/100", side=s)
            for s in ("inside", "nearest", "outside"))
        assert mk.covers(outside, inside)
        reference = shape.buffer(distance, quad_segs=400)
        assert inside.area < reference.area < outside.area
        assert abs(near.area - reference.area) < 0.01 * reference.length * 2


def test_trace_of_a_sum():
    # Crossings of axis-parallel edges are integers, so doubles can be compared.
    frame = mk.from_wkt("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (2 2, 2 7, 7 7, 7 2, 2 2))")
    hook = mk.from_wkt("POLYGON ((0 0, 3 0, 3 1, 1 1, 1 3, 0 3, 0 0))")
    trace = mk.trace_sum(frame, hook)
    assert trace.sum == frame + hook
    kept = [loop for loop in trace.loops if loop.state == "accepted"]
    assert len(kept) == trace.sum.num_polygons + trace.sum.num_holes == 2
    assert {tuple(p) for p in trace.sum.coords} <= {tuple(p) for l in kept for p in l.vertices}
    assert trace.convolution.ends.shape == (len(trace.convolution.kept), 4)
    assert set(trace.convolution.edge_of_first.tolist()) == {True, False}


def test_check_of_a_sum():
    a, b = mk.box(0, 0, 3, 3), mk.from_wkt("POLYGON ((0 0, 1 0, 0 1, 0 0))")
    assert mk.check_sum(a + b, a, b)["proof"] == "holds"
    wrong = mk.check_sum(a, a, b)
    assert not wrong["ok"] and wrong["proof"] == "refuted"


def test_validity():
    bow_tie = mk.Geometry([(0, 0), (4, 4), (4, 0), (0, 4)])
    assert not mk.is_valid(bow_tie)
    (fault,) = mk.validate(bow_tie)
    assert fault["at"] == (2, 2) and "edges cross" in fault["message"]
    assert mk.is_valid(mk.resolve(bow_tie))
    with pytest.raises(mk.BadInputError) as caught:
        mk.minkowski_sum(bow_tie, bow_tie, fill="strict")
    assert (caught.value.operand, caught.value.polygon, caught.value.ring) == (0, 0, 0)


def test_beside_pyclipper():
    import pyclipper

    rng = random.Random(3)
    for _ in range(50):
        ring = [(rng.randrange(100), rng.randrange(100)) for _ in range(6)]
        pattern = [(0, 0), (7, 0), (0, 9)]
        swept = pyclipper.MinkowskiSum(pattern, ring, True)
        clipper = pyclipper.Pyclipper()
        clipper.AddPaths([p for p in swept if len(p) > 2], pyclipper.PT_SUBJECT, True)
        paths = clipper.Execute(pyclipper.CT_UNION, pyclipper.PFT_NONZERO, pyclipper.PFT_NONZERO)
        ours = mk.minkowski_sum({"type": "LineString", "coordinates": ring + ring[:1]}, pattern)
        area = sum(pyclipper.Area(p) for p in paths)
        # Its vertices are rounded to integers: each edge moves by less than one unit.
        length = shapely.from_wkb(ours.to_wkb()).length
        assert abs(area - ours.area) <= length
