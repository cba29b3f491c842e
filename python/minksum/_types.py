"""Names of what functions take."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Any, Union

Number = Union[int, float, Fraction, Decimal, str]
"""A number that is taken exactly: a float is itself, and a text may be "0.1" or "1/3"."""

GeometryLike = Any
"""A geometry in any of the forms that docs/python.md lists, an array of them, or None."""
