"""DuckDB: functions of SQL on WKB (BLOB).

>>> import duckdb, minksum.duckdb
>>> con = duckdb.connect()
>>> minksum.duckdb.register(con)
>>> box = minksum.box(0, 0, 1, 1).to_wkb()
>>> result = con.execute("SELECT mink_area(mink_sum($1, $1))", [box]).fetchone()
>>> result
(4.0,)
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pyarrow as pa

from . import _core
from .arrow import from_arrow, to_arrow

_BINARY = {
    "mink_sum": _core.minkowski_sum,
    "mink_erode": _core.erode,
    "mink_open": _core.opening,
    "mink_close": _core.closing,
    "mink_no_fit_polygon": _core.no_fit_polygon,
    "mink_intersection": _core.intersection,
    "mink_difference": _core.difference,
    "mink_union": _core.union,
}


def register(con: Any) -> None:
    """Add the functions to a connection: mink_sum, mink_offset, mink_area and others.

    Results are rounded to the nearest doubles, and stay valid. NULL gives NULL.
    """
    for name, operation in _BINARY.items():
        con.create_function(name, _binary(operation), ["BLOB", "BLOB"], "BLOB", type="arrow",
                            null_handling="special")
    con.create_function("mink_offset", _offset, ["BLOB", "DOUBLE"], "BLOB", type="arrow",
                        null_handling="special")
    con.create_function("mink_area", _area, ["BLOB"], "DOUBLE", type="arrow",
                        null_handling="special")


def _wkb(geometries: Any) -> Any:
    return to_arrow(geometries).storage


def _binary(operation: Any) -> Callable[[Any, Any], Any]:
    def call(a: Any, b: Any) -> Any:
        return _wkb(operation(from_arrow(a), from_arrow(b)))

    return call


def _offset(column: Any, distances: Any) -> Any:
    shapes = from_arrow(column)
    pairs = zip((shapes[i] for i in range(len(shapes))), distances.to_pylist())
    return _wkb([None if g is None or d is None else _core.offset(g, d) for g, d in pairs])


def _area(column: Any) -> Any:
    shapes = from_arrow(column)
    missing = np.array([shapes[i] is None for i in range(len(shapes))], dtype=bool)
    return pa.array(np.asarray(_core.area(shapes), dtype=np.float64), pa.float64(), mask=missing)
