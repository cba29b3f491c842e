"""Every public function and class, used as mypy --strict accepts it. test_types.py runs both."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import shapely

import minksum as mk
import minksum.arrow
import minksum.duckdb
import minksum.io
import minksum.plotting
import minksum.shapely


def one_geometry() -> None:
    a: mk.Geometry = mk.box(0, 0, Fraction(1, 3), "0.5")
    b: mk.Geometry = mk.disc(Decimal("0.5"), side="outside")
    sums: list[mk.Geometry] = [
        mk.minkowski_sum(a, "POLYGON ((0 0, 1 0, 0 1, 0 0))"), mk.dilate(a, b), mk.erode(a, b),
        mk.opening(a, b, tight=True), mk.closing(a, b), mk.offset(a, 1, join="miter"),
        mk.union(a, b), mk.intersection(a, b), mk.difference(a, b),
        mk.symmetric_difference(a, b, threads=1), mk.no_fit_polygon(a, b, reference=(0, "1/3")),
        mk.inner_fit_polygon(b, a), mk.resolve(a), mk.reflect(a), mk.rounded(a, decimals=3),
        mk.affine_transform(a, [1, 0, 0, 1, "1/3", 0]), mk.translate(a, 1), mk.scale(a, 2, 2),
        mk.rotate(a, 90, origin=(1, 1)), a + b, a | b, a & b, a - b, a ^ b, -a,
    ]
    total: mk.Geometry = mk.union_all(sums)
    points: npt.NDArray[np.float64] = total.coords
    text: str = total.to_wkt(decimals=2) + total.to_geojson() + total.geom_type
    wkb: bytes = total.to_wkb(round="outside") + total.to_bytes()
    count: int = total.num_vertices + total.srid + len(points) + len(text) + len(wkb)
    assert count > 0 and mk.area(a, exact=True) == Fraction(1, 6) and mk.bounds(a)
    assert mk.covers(total, a) and mk.is_valid(total) and not mk.validate(total)
    where: npt.NDArray[np.int8] = mk.locate(a, [(0, 0)])
    checked: dict[str, Any] = mk.check_sum(a + b, a, b)
    depth: mk.Depth = mk.penetration_depth(a, b)
    assert where[0] == 0 and checked["ok"] and depth.squared > 0
    assert mk.time_of_impact(a, mk.translate(a, 5), (-1, 0)) == Fraction(14, 3)


def arrays() -> None:
    shapes = mk.GeometryArray([mk.box(0, 0, 1, 1), mk.from_wkt("POLYGON ((0 0, 1 0, 0 1, 0 0))")])
    sums: mk.GeometryArray = mk.minkowski_sum(shapes.reshape([2, 1]), shapes)
    assert sums.shape == (2, 2) and (shapes + shapes).size == 2 and (-shapes).ndim == 1
    flat: npt.NDArray[np.float64]
    flat, (rings, polygons, geometries) = mk.to_ragged_array(shapes)
    assert mk.from_ragged_array(flat, rings, polygons, geometries) == shapes
    assert mk.from_wkb(shapes.to_wkb())[0] == shapes[0] == mk.as_geometry(shapes[0])
    assert mk.from_geojson(shapes[0].to_geojson()) == mk.Geometry([(0, 0), (1, 0), (1, 1), (0, 1)])
    assert minksum.arrow.from_arrow(minksum.arrow.to_arrow(shapes)) == shapes
    assert mk.prepare(shapes) == shapes


def parts_and_robots() -> None:
    a = mk.box(0, 0, 2, 1)
    table: mk.NoFitTable = mk.NoFitTable([a, a], turns=2)
    entry: mk.Geometry = table[(0, 0), (1, 1)]
    row: mk.GeometryArray = table.entries(0, 1)
    assert entry == row[0, 0, 1, 1] and table.turns == 2
    polygon: mk.NoFitPolygon = mk.NoFitPolygon(a, a)
    contacts: list[str] = polygon.contact([(9, 9)])
    assert contacts == ["free"]
    trace: mk.Trace = mk.trace_sum(a, a)
    segments: mk.Segments = trace.convolution
    cover: mk.Cover | None = trace.cover
    loops: list[mk.Loop] = trace.loops
    assert len(segments.ends) >= 4 and len(loops) >= 1 and (cover is None or min(cover.cell) > 0)
    space: mk.ConfigurationSpace = mk.ConfigurationSpace(a, mk.box(5, 5, 6, 6))
    slices: list[mk.Slice] = list(space.slices([0, 90], free=False))
    found: mk.Reach = mk.reach(a, mk.box(5, 5, 6, 6), (0, 0, 0), (1, 1, 0), angles=4)
    assert slices[1].direction == (0, 1) and found.reachable


def stopped_and_refused() -> None:
    token: mk.CancelToken = mk.CancelToken()
    token.cancel()
    for kind in (mk.BadInputError, mk.LimitError, mk.CancelledError, mk.InternalError):
        assert issubclass(kind, mk.Error) and issubclass(kind, mk.errors.Error)
    try:
        mk.minkowski_sum(mk.disc(1), mk.disc(1), cancel=token, progress=lambda stage: None)
    except mk.CancelledError as error:
        place: int | None = error.operand
        assert place is None


def other_packages(folder: Path) -> None:
    shape: Any = minksum.shapely.offset(shapely.box(0, 0, 1, 1), 1, round="outside")
    assert minksum.shapely.to_minksum(shape).area > 4
    svg = folder / "a.svg"
    svg.write_text('<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H2V2Z"/></svg>')
    drawn: mk.Geometry = minksum.io.read_svg(svg)
    minksum.plotting.plot_geometry(drawn, alpha=0.5)
    numbers: list[mk.Number] = [1, 1.5, Fraction(1, 3), Decimal("0.1"), "1/3"]
    operands: list[mk.GeometryLike] = [drawn, str(drawn), drawn.to_wkb(), None]
    assert len(numbers) > len(operands)
    assert callable(minksum.duckdb.register)
