"""Functions for Shapely's geometries: Shapely in, Shapely out.

Results are rounded to doubles and stay valid. `round` chooses the side: "outside" gives a set that
contains the exact result, and "inside" one that lies within it. A GeoSeries gives a GeoSeries with
the same index and reference system.
"""

from __future__ import annotations

import functools
from typing import Any, Callable

import numpy
import shapely

from . import _core

__all__ = [
    "closing",
    "difference",
    "dilate",
    "erode",
    "from_minksum",
    "inner_fit_polygon",
    "intersection",
    "minkowski_sum",
    "no_fit_polygon",
    "offset",
    "opening",
    "symmetric_difference",
    "to_minksum",
    "union",
]


def to_minksum(geometries: Any, *, z: str = "error") -> Any:
    """Return Shapely geometries as a `Geometry` or a `GeometryArray`, exactly."""
    return _core.as_geometry(geometries, z=z)


def from_minksum(geometries: Any, *, round: str = "nearest") -> Any:
    """Return a `Geometry` or a `GeometryArray` as Shapely geometries, rounded to one side."""
    if geometries is None:
        return None
    return shapely.from_wkb(geometries.to_wkb(round=round, include_srid=True))


def _like(result: Any, operands: tuple[Any, ...]) -> Any:
    for operand in operands:
        if type(operand).__module__.startswith("geopandas") and hasattr(operand, "index"):
            values = numpy.asarray(result, dtype=object)
            if values.shape == (len(operand),):
                return type(operand)(values, index=operand.index, crs=operand.crs)
    return result


def _warn_of_degrees(operands: tuple[Any, ...]) -> None:
    for operand in operands:
        crs = getattr(operand, "crs", None)
        if crs is not None and getattr(crs, "is_geographic", False):
            import warnings

            warnings.warn(
                "Geometry is in a geographic CRS: lengths are degrees. Use 'to_crs()' to "
                "re-project geometries to a projected CRS before.",
                UserWarning,
                stacklevel=4,
            )
            return


def _wrapped(function: Callable[..., Any]) -> Callable[..., Any]:
    @functools.wraps(function)
    def call(*args: Any, round: str = "nearest", **named: Any) -> Any:
        given = (*args, *named.values())
        _warn_of_degrees(given)

        def shown(part: Any) -> Any:
            # Sums come with statistics, too, if they are asked for.
            if not hasattr(part, "to_wkb"):
                return part
            return _like(from_minksum(part, round=round), given)

        result = function(*args, **named)
        return tuple(map(shown, result)) if isinstance(result, tuple) else shown(result)

    call.__doc__ = (
        f"Return what `minksum.{function.__name__}` does, as Shapely geometries that are rounded "
        "to the side `round`."
    )
    return call


minkowski_sum = _wrapped(_core.minkowski_sum)
dilate = _wrapped(_core.dilate)
erode = _wrapped(_core.erode)
opening = _wrapped(_core.opening)
closing = _wrapped(_core.closing)
union = _wrapped(_core.union)
intersection = _wrapped(_core.intersection)
difference = _wrapped(_core.difference)
symmetric_difference = _wrapped(_core.symmetric_difference)
no_fit_polygon = _wrapped(_core.no_fit_polygon)
inner_fit_polygon = _wrapped(_core.inner_fit_polygon)
offset = _wrapped(_core.offset)
