"""The slices of configuration spaces, one after another: a method of `ConfigurationSpace`."""

from __future__ import annotations

from typing import Iterator, Sequence, Union

from ._core import ConfigurationSpace
from ._results import Slice
from ._types import Number


def _slices(
    space: ConfigurationSpace,
    angles: Union[int, Sequence[Number]],
    *,
    free: bool = False,
    tolerance: float = 1e-3,
) -> Iterator[Slice]:
    """Give the slices, one for each angle, in order.

    Parameters
    ----------
    angles : int or sequence of Number
        The angles in degrees, or the number of equal steps around.
    free : bool
        Whether slices have the free space, too.
    tolerance : float
        How far the rotation of a slice may be from its angle, in degrees.

    Examples
    --------
    >>> import minksum
    >>> space = minksum.ConfigurationSpace(minksum.box(0, 0, 2, 1), minksum.box(5, 5, 6, 6))
    >>> [int(minksum.area(s.obstacles)) for s in space.slices(4)]
    [6, 6, 6, 6]
    """
    for angle in space.turns(angles, tolerance=tolerance):
        yield space.slice(angle, free=free, tolerance=tolerance)


def _add_slices() -> None:
    setattr(ConfigurationSpace, "slices", _slices)
