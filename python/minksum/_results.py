"""What functions return besides geometries."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy
from numpy.typing import NDArray

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


@dataclass(frozen=True)
class Segments:
    """Directed segments of a trace. Points outside of the sum can lie only on their right.

    Attributes
    ----------
    ends : array of shape (n, 4)
        x and y of the start, and x and y of the end.
    edge_of_first : array of bool
        Whether the first operand has the edge.
    kept : array of bool
        Whether the segment is in the arrangement.
    """

    ends: NDArray[numpy.float64]
    edge_of_first: NDArray[numpy.bool_]
    kept: NDArray[numpy.bool_]


@dataclass(frozen=True)
class Cover:
    """Cells that certainly lie in the sum.

    Attributes
    ----------
    origin : (float, float)
        The lower left corner of the grid.
    cell : (float, float)
        The width and the height of a cell.
    covered : array of bool of shape (rows, columns)
        Whether a cell certainly lies in the sum.
    """

    origin: tuple[float, float]
    cell: tuple[float, float]
    covered: NDArray[numpy.bool_]


@dataclass(frozen=True)
class Loop:
    """An orientable loop of the arrangement.

    Attributes
    ----------
    vertices : array of shape (n, 2)
        The vertices, in order.
    positive : bool
        Whether it runs counter-clockwise.
    state : {'accepted', 'rejected by nesting', 'rejected by collision'}
        What became of it.
    """

    vertices: NDArray[numpy.float64]
    positive: bool
    state: str


@dataclass(frozen=True)
class Trace:
    """What the stages of a sum made. Coordinates are those of the sum, as doubles.

    Attributes
    ----------
    sum : Geometry
        The sum itself.
    convolution : Segments
        The segments of the reduced convolution.
    cover : Cover or None
        The grid, if there was one.
    nodes : array of shape (n, 2)
        Nodes of the arrangement outside of the cover.
    pieces : Segments
        The segments, split at the nodes.
    loops : list of Loop
        Orientable loops, and what became of them.
    """

    sum: Geometry
    convolution: Segments
    cover: Optional[Cover]
    nodes: NDArray[numpy.float64]
    pieces: Segments
    loops: list[Loop]


def _segments(parts: tuple[Any, Any]) -> Segments:
    ends, flags = parts
    return Segments(ends, flags[:, 0].astype(bool), flags[:, 1].astype(bool))


def _trace(total: Any, convolution: Any, grid: Any, nodes: Any, pieces: Any, loops: Any) -> Trace:
    cover = None if grid is None else Cover(grid[:2], grid[2:4], grid[4].astype(bool))
    return Trace(total, _segments(convolution), cover, nodes, _segments(pieces),
                 [Loop(*loop) for loop in loops])
