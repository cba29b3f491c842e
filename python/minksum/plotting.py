"""Pictures by matplotlib, in the colours of the program's pictures."""

from __future__ import annotations

from typing import Any, Optional

import numpy

from ._core import Geometry, resolve

# The first colours of `minksum draw`, which people with any kind of colour vision can tell apart.
COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")


def _path(geometry: Geometry) -> Any:
    from matplotlib.path import Path

    vertices: list[tuple[float, float]] = []
    codes: list[Any] = []
    for rings in geometry.exact_coords()["polygons"]:
        for ring in rings:
            points = [(float(x), float(y)) for x, y in ring]
            vertices += [*points, points[0]]
            codes += [Path.MOVETO] + [Path.LINETO] * (len(points) - 1) + [Path.CLOSEPOLY]
    return Path(numpy.array(vertices).reshape(-1, 2), codes)


def plot_geometry(
    geometry: Any,
    ax: Optional[Any] = None,
    *,
    facecolor: Optional[str] = None,
    edgecolor: Optional[str] = None,
    linewidth: float = 1.0,
    alpha: float = 0.35,
    color: str = COLORS[0],
    **settings: Any,
) -> Any:
    """Draw areas, polylines and points into `ax`, and return `ax`.

    Parameters
    ----------
    geometry : GeometryLike
        What is drawn.
    ax : matplotlib.axes.Axes, optional
        Where it is drawn; the current axes without it.
    facecolor, edgecolor, color : str, optional
        Colours of areas and of lines. `color` is that of both.
    linewidth, alpha : float
        The width of lines, and how opaque areas are.
    **settings
        Whatever matplotlib's PathPatch takes.
    """
    from matplotlib import pyplot
    from matplotlib.colors import to_rgba
    from matplotlib.patches import PathPatch

    ax = pyplot.gca() if ax is None else ax
    # Holes of a resolved set run clockwise, as matplotlib wants it.
    shape: Any = resolve(geometry)
    if shape is None:
        return ax
    fill = to_rgba(facecolor or color, alpha)
    line = edgecolor or color
    parts = shape.exact_coords()
    if parts["polygons"]:
        ax.add_patch(
            PathPatch(
                _path(shape), facecolor=fill, edgecolor=line, linewidth=linewidth, **settings
            )
        )
    for polyline in parts["polylines"]:
        xs, ys = zip(*((float(x), float(y)) for x, y in polyline))
        ax.plot(xs, ys, color=line, linewidth=linewidth)
    if parts["points"]:
        xs, ys = zip(*((float(x), float(y)) for x, y in parts["points"]))
        ax.plot(xs, ys, "o", color=line, markersize=3 * linewidth)
    ax.set_aspect("equal")
    ax.autoscale_view()
    return ax
