"""Operators of geometries and arrays: a + b is the Minkowski sum, and -a the point mirror."""

from __future__ import annotations

from typing import Any, Callable

from . import _core


def _binary(function: Callable[[Any, Any], Any]) -> Callable[[Any, Any], Any]:
    def operator(a: Any, b: Any) -> Any:
        if not isinstance(b, (_core.Geometry, _core.GeometryArray)):
            return NotImplemented
        return function(a, b)

    return operator


def _add_operators() -> None:
    for cls in (_core.Geometry, _core.GeometryArray):
        setattr(cls, "__add__", _binary(_core.minkowski_sum))
        setattr(cls, "__or__", _binary(_core.union))
        setattr(cls, "__and__", _binary(_core.intersection))
        setattr(cls, "__sub__", _binary(_core.difference))
        setattr(cls, "__xor__", _binary(_core.symmetric_difference))
        setattr(cls, "__neg__", lambda a: _core.reflect(a))
