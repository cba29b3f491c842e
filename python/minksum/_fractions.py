"""Makes fractions of numbers that are known to be in lowest terms, without another gcd."""

from fractions import Fraction
from typing import Callable

coprime: Callable[[int, int], Fraction]

if hasattr(Fraction, "_from_coprime_ints"):  # Python 3.12 and later

    coprime = Fraction._from_coprime_ints

else:

    def coprime(numerator: int, denominator: int) -> Fraction:
        return Fraction(numerator, denominator, _normalize=False)  # type: ignore[call-arg]
