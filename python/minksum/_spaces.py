"""Configuration spaces: the slices one after another, and pickles."""

from __future__ import annotations

from typing import Any, Iterable, Iterator, Optional, Union

from . import _core
from ._results import Slice
from ._types import GeometryLike, Number


class ConfigurationSpace(_core.ConfigurationSpace):
    """The configurations of a robot among obstacles, one slice for each angle.

    Parameters
    ----------
    robot, obstacles : GeometryLike
        What moves and turns, and what stands still.
    reference : (Number, Number), optional
        The robot's point that says where it is, and about which it turns; the origin without it.
    workspace : GeometryLike, optional
        What the robot must not leave.
    tight : bool
        Whether slices keep places without play.
    fill : str
        How rings are read.

    Examples
    --------
    >>> import minksum
    >>> space = minksum.ConfigurationSpace(minksum.box(0, 0, 2, 1), minksum.box(5, 5, 6, 6))
    >>> print(space.slice(90).obstacles)
    POLYGON ((5 3, 7 3, 7 6, 5 6, 5 3))
    """

    def __init__(
        self,
        robot: GeometryLike,
        obstacles: GeometryLike,
        *,
        reference: Optional[tuple[Number, Number]] = None,
        workspace: GeometryLike = None,
        tight: bool = False,
        fill: str = "automatic",
    ) -> None:
        # What a pickle holds: the operands as they are now, not what they are made of.
        robot, obstacles, workspace = map(_core.as_geometry, (robot, obstacles, workspace))
        settings = {"reference": reference, "workspace": workspace, "tight": tight, "fill": fill}
        super().__init__(robot, obstacles, **settings)
        self._made_of = (robot, obstacles, settings)

    def __reduce__(self) -> tuple[Any, ...]:
        return _made, self._made_of

    def slices(
        self,
        angles: Union[int, Iterable[Number]],
        *,
        free: bool = False,
        tolerance: float = 1e-3,
    ) -> Iterator[Slice]:
        """Give the slices, one for each angle, in order.

        Parameters
        ----------
        angles : int or iterable of Number
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
        for angle in self.turns(angles, tolerance=tolerance):
            yield self.slice(angle, free=free, tolerance=tolerance)


def _made(robot: Any, obstacles: Any, settings: dict[str, Any]) -> ConfigurationSpace:
    return ConfigurationSpace(robot, obstacles, **settings)
