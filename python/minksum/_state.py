"""Makes objects of what pickles hold."""

from __future__ import annotations

from typing import Optional, Sequence

from ._core import Geometry, GeometryArray


def geometry(data: bytes) -> Geometry:
    return Geometry.from_bytes(data)


def array(items: Sequence[Optional[Geometry]], shape: Sequence[int]) -> GeometryArray:
    return GeometryArray._make(items, shape)
