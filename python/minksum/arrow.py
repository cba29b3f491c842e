"""Arrow: geometries from and to GeoArrow arrays, by pyarrow.

An object with `__arrow_c_array__` or `__arrow_c_stream__` is taken, so a column of GeoPandas,
DuckDB or Polars needs no object of Python for each geometry.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from . import _core
from ._core import GeometryArray
from .errors import BadInputError


class _Type(pa.ExtensionType):  # type: ignore[misc]
    """A type of GeoArrow, which need not be registered with pyarrow."""

    def __arrow_ext_serialize__(self) -> bytes:
        return b"{}"

    @classmethod
    def __arrow_ext_deserialize__(cls, storage: Any, serialized: bytes) -> _Type:
        raise NotImplementedError("these types are only written")


def from_arrow(column: Any, *, z: str = "error") -> GeometryArray:
    """Return the geometries of an Arrow array: WKB, polygons or multipolygons of GeoArrow.

    Parameters
    ----------
    column : object with `__arrow_c_array__` or `__arrow_c_stream__`
        Coordinates may be separated (struct) or interleaved (fixed-size list).
    z : {'error', 'drop'}
        What becomes of heights in WKB.

    Examples
    --------
    >>> import minksum, minksum.arrow
    >>> shapes = minksum.GeometryArray([minksum.box(0, 0, 2, 1), None])
    >>> minksum.arrow.from_arrow(minksum.arrow.to_arrow(shapes))[0] == shapes[0]
    True
    """
    array = _imported(column)
    kind = array.type
    if pa.types.is_binary(kind) or pa.types.is_large_binary(kind):
        return _of_wkb(array, z)
    valid = array.is_valid().to_numpy(zero_copy_only=False)
    levels = []
    values = array
    while pa.types.is_list(values.type) or pa.types.is_large_list(values.type):
        lengths = pc.fill_null(pc.list_value_length(values), 0).to_numpy()
        levels.append(np.concatenate([[0], np.cumsum(lengths, dtype=np.int64)]))
        values = values.flatten()
    if len(levels) not in (2, 3):
        raise BadInputError(f"an Arrow column of type {kind} holds no polygons and no WKB")
    shapes = _core.from_ragged_array(_coordinates(values, kind), *reversed(levels))
    if valid.all():
        return shapes
    return GeometryArray([shapes[i] if valid[i] else None for i in range(len(valid))])


def to_arrow(geometries: Any, *, encoding: str = "wkb") -> pa.Array:
    """Return an Arrow array of type `geoarrow.wkb` or `geoarrow.multipolygon`.

    Parameters
    ----------
    geometries : GeometryLike
        An array in one dimension.
    encoding : {'wkb', 'multipolygon'}
        'multipolygon' has interleaved doubles, each of which is the nearest one. It holds areas
        alone, and no missing geometries. 'wkb' holds rounded sets, which stay valid.
    """
    shapes = geometries if isinstance(geometries, GeometryArray) else GeometryArray(geometries)
    if encoding == "wkb":
        storage = _wkb_storage(shapes)
    elif encoding == "multipolygon":
        coordinates, levels = _core.to_ragged_array(shapes)
        storage = pa.FixedSizeListArray.from_arrays(pa.array(coordinates.ravel()), 2)
        for offsets in levels:
            storage = _lists(offsets, storage)
    else:
        raise ValueError(f"encoding must be 'wkb' or 'multipolygon', not {encoding!r}")
    return pa.ExtensionArray.from_storage(_Type(storage.type, f"geoarrow.{encoding}"), storage)


def _lists(offsets: Any, values: Any) -> Any:
    if offsets[-1] <= np.iinfo(np.int32).max:
        return pa.ListArray.from_arrays(pa.array(offsets.astype(np.int32)), values)
    return pa.LargeListArray.from_arrays(pa.array(offsets.astype(np.int64)), values)


def _imported(column: Any) -> Any:
    if hasattr(column, "__arrow_c_stream__"):
        column = pa.chunked_array(column)
    elif not isinstance(column, pa.Array) and hasattr(column, "__arrow_c_array__"):
        column = pa.array(column)
    if isinstance(column, pa.ChunkedArray):
        column = column.combine_chunks()
    if not isinstance(column, pa.Array):
        raise TypeError(f"expected an Arrow array, found {type(column).__name__}")
    return column.storage if isinstance(column, pa.ExtensionArray) else column


def _of_wkb(array: Any, z: str) -> GeometryArray:
    valid = array.is_valid().to_numpy(zero_copy_only=False)
    _, offsets, data = array.buffers()
    kind = np.int64 if pa.types.is_large_binary(array.type) else np.int32
    ends = slice(array.offset, array.offset + len(array) + 1)
    # An array without elements may have no offsets.
    starts = np.frombuffer(offsets, kind)[ends] if len(array) else np.zeros(1, kind)
    content = np.frombuffer(data or b"", np.uint8)
    return _core._from_wkb_column(content, starts.astype(np.int64), valid.astype(np.bool_), z)


def _wkb_storage(shapes: GeometryArray) -> Any:
    data, offsets = _core._to_wkb_column(shapes, "nearest")
    # WKB is never empty, so what has no bytes is missing.
    valid = np.diff(offsets) > 0
    large = offsets[-1] > np.iinfo(np.int32).max
    kind, number = (pa.large_binary(), np.int64) if large else (pa.binary(), np.int32)
    bits = None if valid.all() else pa.py_buffer(np.packbits(valid, bitorder="little"))
    buffers = [bits, pa.py_buffer(offsets.astype(number)), pa.py_buffer(data)]
    return pa.Array.from_buffers(kind, len(shapes), buffers)


def _coordinates(values: Any, kind: Any) -> Any:
    if pa.types.is_fixed_size_list(values.type) and values.type.list_size == 2:
        points = values.flatten().to_numpy(zero_copy_only=False).reshape(-1, 2)
    elif pa.types.is_struct(values.type) and [f.name for f in values.type] == ["x", "y"]:
        points = np.column_stack([v.to_numpy(zero_copy_only=False) for v in values.flatten()])
    else:
        raise BadInputError(f"an Arrow column of type {kind} has no coordinates x and y alone")
    return np.ascontiguousarray(points, dtype=np.float64)
