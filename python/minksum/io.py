"""Files: drawings (SVG, DXF), and the JSON of nesting programs."""

from __future__ import annotations

import json
from os import PathLike
from typing import Any, Callable, Union

from . import _core
from ._core import Geometry
from ._types import Number
from .errors import BadInputError, Error

Path = Union[str, "PathLike[str]"]


def _bytes(path: Path) -> bytes:
    with open(path, "rb") as file:
        return file.read()


def _drawing(path: Path, read: Callable[[bytes], Geometry]) -> Geometry:
    try:
        return read(_bytes(path))
    except Error as error:
        error.args = (f"{path}: {error}",)
        raise


def read_svg(path: Path, *, tolerance: Number | None = None, side: str = "nearest") -> Geometry:
    """Return the shapes of an SVG file.

    Parameters
    ----------
    path : path-like
        The file.
    tolerance : Number, optional
        How far the polyline of a curve may be off. A file with curves needs it.
    side : {'nearest', 'outside', 'inside'}
        'outside' contains the drawn areas, and 'inside' lies within them.
    """
    return _drawing(path, lambda text: _core._read_svg(text, tolerance, side))


def read_dxf(
    path: Path,
    *,
    tolerance: Number | None = None,
    side: str = "nearest",
    layer: str = "",
    join_ends: Number = 0,
) -> Geometry:
    """Return the shapes of a DXF file, of all layers that are shown or of one.

    Ends of outlines are joined if they are at most `join_ends` apart. The other parameters are
    those of `read_svg`.
    """
    return _drawing(path, lambda text: _core._read_dxf(text, tolerance, side, layer, join_ends))


def _ring(points: Any, what: str) -> list[tuple[Any, Any]]:
    try:
        return [(x, y) for x, y in points]
    except (TypeError, ValueError):
        raise BadInputError(f"{what} must be a list of [x, y]") from None


def _shape(shape: Any, what: str) -> Geometry:
    kind, data = shape.get("type"), shape.get("data")
    if kind == "rectangle":
        x, y = data.get("x_min", 0), data.get("y_min", 0)
        return _core.box(x, y, x + data["width"], y + data["height"])
    if kind == "simple_polygon":
        outer, inner = data, []
    elif kind == "polygon":
        outer, inner = data["outer"], data.get("inner", [])
    else:
        raise BadInputError(f"{what} has a shape of type {kind!r}, which is not read")
    rings = [_ring(ring, what) for ring in [outer, *inner]]
    mapping = {"type": "Polygon", "coordinates": [ring + ring[:1] for ring in rings]}
    return _core.from_geojson(mapping)  # type: ignore[no-any-return]


def read_jagua(path: Path) -> dict[str, list[dict[str, Any]]]:
    """Return the items and bins of an instance of jagua-rs or sparrow.

    Each is a dict with its `geometry` and whatever else the file says of it, such as `demand` and
    `allowed_orientations`. Coordinates are the doubles of the file, exactly.
    """
    try:
        document = json.loads(_bytes(path))
    except ValueError as error:
        raise BadInputError(f"{path}: {error}") from None
    if not isinstance(document, dict):
        raise BadInputError(f"{path}: not an object with items")
    parts: dict[str, list[dict[str, Any]]] = {"items": [], "bins": []}
    for group in ("items", "bins"):
        entries = document.get(group, [])
        if not isinstance(entries, list):
            raise BadInputError(f"{path}: {group} must be a list")
        for i, entry in enumerate(entries):
            what = f"{path}: {group[:-1]} {i}"
            if not isinstance(entry, dict) or "shape" not in entry:
                raise BadInputError(f"{what} has no shape")
            known = {name: value for name, value in entry.items() if name != "shape"}
            try:
                geometry = _shape(entry["shape"], what)
            except (AttributeError, KeyError, TypeError) as error:
                raise BadInputError(f"{what} has a shape that cannot be read: {error}") from None
            parts[group].append({**known, "geometry": geometry})
    return parts
