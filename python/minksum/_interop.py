"""How a single geometry of Shapely is written quickly."""

from __future__ import annotations

from typing import Any

import numpy as np


def writer() -> tuple[Any, ...]:
    """Return a function that writes EWKB, and its arguments behind the geometry.

    `shapely.to_wkb` makes its arguments ready in each call, which takes longer than to write a
    small geometry. So the function behind it is called, if it does the same.
    """
    import shapely

    try:
        from shapely import lib

        found = (lib.to_wkb, np.bool_(False), np.intc(4), np.intc(1), np.bool_(True), np.intc(1))
        place = shapely.set_srid(shapely.Point(1, 2, 3), 4)
        if found[0](place, *found[1:]) == shapely.to_wkb(place, include_srid=True):
            return found
    except Exception:  # another version of Shapely
        pass
    return (lambda geometry: shapely.to_wkb(geometry, include_srid=True),)
