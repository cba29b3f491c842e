"""Makes fractions of numbers that are known to be in lowest terms, without another gcd."""

from fractions import Fraction
from typing import Any

# Python 3.12 and later have a function for this, and earlier ones an argument.
_of_coprime: Any = getattr(Fraction, "_from_coprime_ints", None)
_fraction: Any = Fraction


def _unnormalized(numerator: int, denominator: int) -> Any:
    return _fraction(numerator, denominator, _normalize=False)


coprime = _of_coprime or _unnormalized
