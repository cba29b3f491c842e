"""Exact Minkowski sums of planar regions, and what follows from them.

Every function takes geometries in many forms, alone or in arrays, and returns a `Geometry` or a
`GeometryArray`. Coordinates are exact: `minksum.from_wkt("POINT (1/3 0.1)")` is one third and one
tenth. `minksum.shapely` has the same functions for Shapely's geometries.
"""

from . import errors
from ._core import (
    CancelToken,
    ConfigurationSpace,
    Geometry,
    GeometryArray,
    NoFitPolygon,
    NoFitTable,
    affine_transform,
    area,
    as_geometry,
    bounds,
    box,
    check_sum,
    closing,
    covers,
    difference,
    dilate,
    disc,
    erode,
    from_geojson,
    from_ragged_array,
    from_wkb,
    from_wkt,
    inner_fit_polygon,
    intersection,
    is_valid,
    locate,
    minkowski_sum,
    no_fit_polygon,
    offset,
    opening,
    penetration_depth,
    reach,
    reflect,
    resolve,
    rounded,
    symmetric_difference,
    time_of_impact,
    to_ragged_array,
    union,
    union_all,
    validate,
)
from ._operators import _add_operators
from ._results import Depth, Reach, Slice
from ._spaces import _add_slices
from ._transforms import rotate, scale, translate
from ._types import GeometryLike, Number
from .errors import BadInputError, CancelledError, Error, InternalError, LimitError

_add_operators()
_add_slices()

__version__ = "0.1.0"
__all__ = [
    "BadInputError",
    "CancelToken",
    "CancelledError",
    "ConfigurationSpace",
    "Depth",
    "Error",
    "Geometry",
    "GeometryArray",
    "GeometryLike",
    "InternalError",
    "LimitError",
    "NoFitPolygon",
    "NoFitTable",
    "Number",
    "Reach",
    "Slice",
    "affine_transform",
    "area",
    "as_geometry",
    "bounds",
    "box",
    "check_sum",
    "closing",
    "covers",
    "difference",
    "dilate",
    "disc",
    "erode",
    "errors",
    "from_geojson",
    "from_ragged_array",
    "from_wkb",
    "from_wkt",
    "inner_fit_polygon",
    "intersection",
    "is_valid",
    "locate",
    "minkowski_sum",
    "no_fit_polygon",
    "offset",
    "opening",
    "penetration_depth",
    "reach",
    "reflect",
    "resolve",
    "rotate",
    "rounded",
    "scale",
    "symmetric_difference",
    "time_of_impact",
    "to_ragged_array",
    "translate",
    "union",
    "union_all",
    "validate",
]
