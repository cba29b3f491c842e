"""Exact moves, scalings and turns."""

from __future__ import annotations

from typing import Any

from . import _core
from ._types import GeometryLike, Number


def translate(a: GeometryLike, xoff: Number = 0, yoff: Number = 0) -> Any:
    """Return the set moved by (xoff, yoff), exactly.

    Examples
    --------
    >>> import minksum
    >>> print(minksum.translate(minksum.box(0, 0, 1, 1), "1/3", 2))
    POLYGON ((1/3 2, 4/3 2, 4/3 3, 1/3 3, 1/3 2))
    """
    return _core.affine_transform(a, [1, 0, 0, 1, xoff, yoff])


def scale(
    a: GeometryLike,
    xfact: Number = 1,
    yfact: Number = 1,
    *,
    origin: tuple[Number, Number] = (0, 0),
) -> Any:
    """Return the set scaled about a point, exactly."""
    x, y = map(_core._exact, origin)
    fx, fy = map(_core._exact, (xfact, yfact))
    return _core.affine_transform(a, [fx, 0, 0, fy, x - fx * x, y - fy * y])


def rotate(
    a: GeometryLike,
    degrees: Number,
    *,
    tolerance: float = 1e-3,
    origin: tuple[Number, Number] = (0, 0),
) -> Any:
    """Return the set turned counter-clockwise about a point.

    The rotation is exact: a rational point of the unit circle within `tolerance` degrees of the
    angle. Multiples of 90 degrees are taken as they are.
    """
    cos, sin = _core._direction(degrees, tolerance)
    x, y = map(_core._exact, origin)
    return _core.affine_transform(
        a, [cos, -sin, sin, cos, x - cos * x + sin * y, y - sin * x - cos * y]
    )
