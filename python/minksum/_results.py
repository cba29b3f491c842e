"""What functions return besides geometries."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Optional, Union

if TYPE_CHECKING:
    from ._core import Geometry

Exact = Union[int, Fraction]


@dataclass(frozen=True)
class Depth:
    """How two sets stand to each other.

    Attributes
    ----------
    overlapping : bool
        Whether their interiors meet.
    vector : tuple
        The shortest move of the second set after which both touch, exactly.
    squared : int or Fraction
        The square of its length.
    distance : float
        Its length.
    contact : tuple or None
        What touches after the move: the operand with the edge (0 or 1), the index of the edge's
        first vertex, and the index of the other operand's vertex.
    """

    overlapping: bool
    vector: tuple[Exact, Exact]
    squared: Exact
    distance: float
    contact: Optional[tuple[int, int, int]]


@dataclass(frozen=True)
class Slice:
    """The configurations of a robot that is turned by one angle.

    Attributes
    ----------
    asked : int or Fraction
        The angle that was asked for, in degrees.
    degrees : float
        The angle of the exact rotation that was taken.
    off : float
        A bound on the difference of both.
    direction : tuple
        The cosine and the sine of the rotation, exactly.
    obstacles : Geometry
        Where the robot meets an obstacle or leaves the workspace.
    free : Geometry or None
        Where the robot is free, if that was asked for.
    """

    asked: Exact
    degrees: float
    off: float
    direction: tuple[Exact, Exact]
    obstacles: Geometry
    free: Optional[Geometry]


@dataclass(frozen=True)
class Reach:
    """Whether there is a path, and which one.

    Attributes
    ----------
    reachable : bool
        Whether there is a path in the slices that were made. False does not mean that there is
        none between these slices.
    path : list
        Pairs of an exact point and an angle in degrees.
    slices, parts : int
        How many slices and free parts there were.
    margin : int or Fraction
        By how much the robot was grown, if the path must hold at all angles.
    """

    reachable: bool
    path: list[tuple[tuple[Exact, Exact], float]]
    slices: int
    parts: int
    margin: Exact
