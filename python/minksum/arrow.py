"""Arrow: geometries from and to columns of WKB and GeoArrow, by the C data interface.

An object with `__arrow_c_array__` or `__arrow_c_stream__` is taken, so a column of GeoPandas,
DuckDB or Polars needs no object of Python for each geometry. pyarrow need not be installed.
"""

from __future__ import annotations

from typing import Any

from . import _core
from ._core import GeometryArray


def from_arrow(column: Any, *, z: str = "error", on_error: str = "raise") -> GeometryArray:
    """Return the geometries of a column: WKB, or a type of GeoArrow.

    Parameters
    ----------
    column : object with `__arrow_c_array__` or `__arrow_c_stream__`
        Coordinates are doubles, separated (struct) or interleaved (fixed-size list). Lists without
        the name of a type are polygons or multipolygons, as their depth tells.
    z : {'error', 'drop'}
        What becomes of heights in WKB.
    on_error : {'raise', 'none'}
        What becomes of an element that is bad input: an error, or a missing geometry.

    Examples
    --------
    >>> import minksum, minksum.arrow
    >>> shapes = minksum.GeometryArray([minksum.box(0, 0, 2, 1), None])
    >>> minksum.arrow.from_arrow(minksum.arrow.to_arrow(shapes))[0] == shapes[0]
    True
    """
    return _core._from_arrow(column, z, on_error)


class Column:
    """A column that pyarrow, nanoarrow, Polars and others take by `__arrow_c_array__`."""

    def __init__(self, geometries: GeometryArray, encoding: str) -> None:
        self._made_of = (geometries, encoding, "nearest")

    def __arrow_c_array__(self, requested_schema: Any = None) -> tuple[Any, Any]:
        return _core._to_arrow(*self._made_of)


def to_arrow(geometries: Any, *, encoding: str = "wkb") -> Any:
    """Return a column of the type `geoarrow.wkb` or `geoarrow.multipolygon`.

    Parameters
    ----------
    geometries : GeometryLike
        An array in one dimension.
    encoding : {'wkb', 'multipolygon'}
        'multipolygon' has interleaved doubles, each of which is the nearest one. It holds areas
        alone, and no missing geometries. 'wkb' holds rounded sets, which stay valid.

    Returns
    -------
    pyarrow.Array, or Column if pyarrow is not installed
    """
    shapes = geometries if isinstance(geometries, GeometryArray) else GeometryArray(geometries)
    column = Column(shapes, encoding)
    try:
        import pyarrow
    except ImportError:
        return column
    storage = pyarrow.array(column)
    return pyarrow.ExtensionArray.from_storage(_type(storage.type, encoding), storage)


def _type(storage: Any, encoding: str) -> Any:
    """Return a type of GeoArrow, which need not be registered with pyarrow."""
    import pyarrow

    class Type(pyarrow.ExtensionType):  # type: ignore[misc]
        def __arrow_ext_serialize__(self) -> bytes:
            return b"{}"

        @classmethod
        def __arrow_ext_deserialize__(cls, storage: Any, serialized: bytes) -> Any:
            raise NotImplementedError("these types are only written")

    return Type(storage, f"geoarrow.{encoding}")
