"""Work on many processes or machines, by Dask.

For a table of few no-fit polygons, the threads of one process are as fast as a cluster. This is
for thousands of parts, or for national data.
"""

from __future__ import annotations

import hashlib
import json
import os
import uuid
from collections.abc import Callable, Iterable
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy
import pyarrow as pa
import pyarrow.parquet as pq

from . import _core
from ._core import Geometry, GeometryArray
from ._spaces import ConfigurationSpace
from ._types import Number
from .errors import BadInputError, Error

_SCHEMA = pa.schema([
    ("fixed", pa.int64()), ("fixed_turn", pa.int8()), ("moving", pa.int64()),
    ("moving_turn", pa.int8()), ("geometry", pa.binary()), ("exact", pa.binary()),
    ("error", pa.string()),
])

# So many entries of a table, or those around one part, are in memory until they are written. An
# entry takes some 0.7 kB, so these take 3 MB. Fewer would make small row groups of Parquet.
_AT_ONCE = 4096
# Columns whose values repeat. Parquet need not look for repetitions in the others.
_KEYS = _SCHEMA.names[:4]

_SLICE_SCHEMA = pa.schema([
    ("asked", pa.string()), ("degrees", pa.float64()), ("off", pa.float64()),
    ("obstacles", pa.binary()), ("free", pa.binary()), ("exact_obstacles", pa.binary()),
    ("exact_free", pa.binary()), ("error", pa.string()),
], metadata={"geo": json.dumps({  # GeoParquet
    "version": "1.1.0", "primary_column": "obstacles",
    "columns": {name: {"encoding": "WKB", "geometry_types": []} for name in ("obstacles", "free")},
})})


def map_geometries(
    frame: Any, operation: str, *operands: Any, column: str = "geometry", **options: Any
) -> Any:
    """Return a Dask data frame whose geometries went through an operation of this package.

    Parameters
    ----------
    frame : dask.dataframe.DataFrame
        Its column holds WKB, best as `pandas.ArrowDtype(pyarrow.binary())`: Dask takes a column
        of Python's bytes for text, unless its setting "dataframe.convert-string" is False. The
        results are WKB of rounded sets, in the same type.
    operation : str
        A name such as "offset" or "minkowski_sum".
    *operands, **options
        What the operation takes after the geometry.
    """
    import minksum

    if operation not in minksum.__all__:
        raise BadInputError(f"there is no operation {operation!r}")
    return frame.map_partitions(
        _map_partition, operation, operands, column, {"threads": 1, **options}, meta=frame._meta
    )


def no_fit_table(
    parts: Iterable[Any],
    *,
    out: str | os.PathLike[str],
    turns: int = 4,
    block: tuple[int, int] = (256, 256),
    client: Any = None,
    retries: int = 3,
) -> list[Path]:
    """Write the no-fit polygons of all pairs of parts into Parquet files, and return their paths.

    A task makes one file, by rename, under a name made of the digest of everything on which it
    depends. Files that are there are not made again: so a run that was killed goes on. A task has
    one thread; without a client all cores share a block.

    Parameters
    ----------
    parts : iterable of GeometryLike
        A part's reference point is its first vertex, as in `NoFitTable`.
    out : path-like
        The folder of the files. Workers on other machines must see it under the same path.
    turns : {1, 2, 4}
        Directions in which parts are laid.
    block : (int, int)
        How many fixed and how many moving parts make one file.
    client : distributed.Client, optional
        Without it, this process makes all files.
    retries : int
        How often a task whose worker died is tried again.

    Returns
    -------
    list of Path
        Files with the columns fixed, fixed_turn, moving, moving_turn, geometry (WKB, rounded),
        exact (for `Geometry.from_bytes`) and error (the message of a pair that failed).
    """
    if turns not in (1, 2, 4) or min(block) < 1:
        raise BadInputError("turns must be 1, 2 or 4, and blocks must have at least one part")
    placed = [_at_origin(part, index) for index, part in enumerate(parts)]
    folder = Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    digest = _digest(placed, f"no-fit table 1, {turns} turns")
    jobs = []
    for i in range(0, len(placed), block[0]):
        for j in range(0, len(placed), block[1]):
            rows = (i, min(i + block[0], len(placed)))
            columns = (j, min(j + block[1], len(placed)))
            name = f"{digest}-{rows[0]}-{rows[1]}-{columns[0]}-{columns[1]}.parquet"
            jobs.append((folder / name, rows, columns, None if client is None else 1))
    return _make_all(_make_block, placed, turns, jobs, client, retries)


def slices(
    space: ConfigurationSpace,
    angles: int | Iterable[Number],
    *,
    out: str | os.PathLike[str],
    free: bool = False,
    tolerance: float = 1e-3,
    block: int = 64,
    client: Any = None,
    retries: int = 3,
) -> list[Path]:
    """Write the slices of a configuration space into Parquet files, and return their paths.

    Files that are there are not made again, as those of `no_fit_table`.

    Parameters
    ----------
    space : ConfigurationSpace
        The robot and its obstacles.
    angles : int or iterable of Number
        The angles in degrees, or the number of equal steps around.
    out : path-like
        The folder of the files.
    free : bool
        Whether the free space is written, too.
    tolerance : float
        How far the rotation of a slice may be from its angle, in degrees.
    block : int
        How many slices make one file.
    client, retries
        As in `no_fit_table`.

    Returns
    -------
    list of Path
        GeoParquet files with the columns asked (the exact angle as a text), degrees and off (of
        the exact rotation that was taken), obstacles and free (WKB, rounded), exact_obstacles and
        exact_free (for `Geometry.from_bytes`), and error (the message of a slice that failed).
    """
    if block < 1:
        raise BadInputError("blocks must have at least one slice")
    asked = [str(angle) for angle in space.turns(angles, tolerance=tolerance)]
    folder = Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    robot, obstacles, settings = space._made_of
    workspace = settings["workspace"]
    reference = settings["reference"] and [str(Fraction(x)) for x in settings["reference"]]
    what = f"slices 1 {reference} {settings['tight']} {settings['fill']} {free} {tolerance!r}"
    digest = _digest([robot, obstacles, *([workspace] if workspace else [])], what)
    jobs = []
    for i in range(0, len(asked), block):
        part = asked[i : i + block]
        name = hashlib.blake2b(" ".join(part).encode(), digest_size=8).hexdigest()
        jobs.append((folder / f"{digest}-{i}-{name}.parquet", part, tolerance))
    return _make_all(_make_slices, space, free, jobs, client, retries)


def _make_all(
    make: Callable[..., str], shared: Any, setting: Any, jobs: list[Any], client: Any, retries: int
) -> list[Path]:
    """Make the files that are not there, in this process or on the workers of a cluster."""
    left = [job for job in jobs if not job[0].exists()]
    if client is None:
        for job in left:
            make(shared, setting, *job)
    elif left:
        sent = client.scatter(shared, broadcast=True, hash=False)
        tasks = [
            client.submit(make, sent, setting, *job, pure=False, retries=retries) for job in left
        ]
        client.gather(tasks)
    return [job[0] for job in jobs]


def _make_slices(
    space: ConfigurationSpace, free: bool, path: Path, asked: list[str], tolerance: float
) -> str:
    if path.exists():
        return str(path)
    unfinished = path.with_name(f".{path.name}.{uuid.uuid4().hex}")
    try:
        with pq.ParquetWriter(unfinished, _SLICE_SCHEMA) as writer:
            for angle in asked:
                record = _slice(space, angle, free, tolerance)
                columns = [pa.array([value], f.type) for value, f in zip(record, _SLICE_SCHEMA)]
                writer.write_batch(pa.record_batch(columns, schema=_SLICE_SCHEMA))
        os.replace(unfinished, path)
    finally:
        unfinished.unlink(missing_ok=True)
    return str(path)


def _slice(space: ConfigurationSpace, angle: str, free: bool, tolerance: float) -> tuple[Any, ...]:
    try:
        made = space.slice(angle, free=free, tolerance=tolerance)
    except Error as error:
        return angle, None, None, None, None, None, None, str(error)
    room = made.free
    return (angle, made.degrees, made.off, made.obstacles.to_wkb(),
            None if room is None else room.to_wkb(), made.obstacles.to_bytes(),
            None if room is None else room.to_bytes(), None)


def _map_partition(
    frame: Any, operation: str, operands: Any, column: str, options: dict[str, Any]
) -> Any:
    import minksum

    if not len(frame):
        return frame
    column_of = frame[column]
    shapes = [None if lost else wkb for wkb, lost in zip(column_of, column_of.isna())]
    results = getattr(minksum, operation)(shapes, *operands, **options)
    wkb = [None if g is None else g.to_wkb() for g in (results[i] for i in range(len(results)))]
    return frame.assign(**{column: type(column_of)(wkb, column_of.index, column_of.dtype)})


def _at_origin(part: Any, index: int) -> Geometry:
    geometry = Geometry(part)
    polygons = geometry.exact_coords()["polygons"]
    if not polygons:
        error = BadInputError(f"part {index} has no area")
        error.operand = index
        raise error
    x, y = polygons[0][0][0]
    return _core.affine_transform(geometry, [1, 0, 0, 1, -x, -y])


def _digest(parts: list[Geometry], what: str) -> str:
    digest = hashlib.blake2b(what.encode(), digest_size=16)
    for part in parts:
        data = part.to_bytes()
        digest.update(len(data).to_bytes(8, "little") + data)
    return digest.hexdigest()


def _turned(part: Geometry, turn: int, turns: int) -> Geometry:
    c, s = [(1, 0), (0, 1), (-1, 0), (0, -1)][turn * 4 // turns]
    return _core.affine_transform(part, [c, -s, s, c, 0, 0])


def _make_block(
    parts: list[Geometry], turns: int, path: Path, rows: tuple[int, int], columns: tuple[int, int],
    threads: int | None,
) -> str:
    if path.exists():
        return str(path)
    moving = [_turned(parts[j], s, turns) for j in range(*columns) for s in range(turns)]
    step = max(1, _AT_ONCE // (turns * len(moving)))
    unfinished = path.with_name(f".{path.name}.{uuid.uuid4().hex}")
    try:
        with pq.ParquetWriter(unfinished, _SCHEMA, use_dictionary=_KEYS) as writer:
            for i in range(rows[0], rows[1], step):
                end = min(i + step, rows[1])
                fixed = [_turned(parts[k], r, turns) for k in range(i, end) for r in range(turns)]
                keys = numpy.indices((end - i, turns, columns[1] - columns[0], turns))
                begin = numpy.array([[i], [0], [columns[0]], [0]])
                made = [pa.array(k, f.type) for k, f in zip(keys.reshape(4, -1) + begin, _SCHEMA)]
                made += _around(fixed, moving, threads)
                writer.write_batch(pa.record_batch(made, schema=_SCHEMA))
        os.replace(unfinished, path)
    finally:
        unfinished.unlink(missing_ok=True)
    return str(path)


def _around(fixed: list[Geometry], moving: list[Geometry], threads: int | None) -> list[pa.Array]:
    """Return columns of WKB, exact bytes and errors. A pair that fails is not a block lost."""
    columns: Any
    try:
        found = _core.no_fit_polygon(GeometryArray(fixed).reshape([len(fixed), 1]),
                                     GeometryArray(moving), reference=(0, 0), threads=threads)
        found = found.reshape([found.size])
        shapes = list(found)
        # All cores make a column of Arrow, and a worker has one.
        wkb = pa.array(found) if threads is None else pa.array([g.to_wkb() for g in shapes])
        columns = wkb.cast(pa.binary()), [g.to_bytes() for g in shapes], [None] * len(shapes)
    except Error:
        columns = zip(*(_pair(a, b) for a in fixed for b in moving))
    return [pa.array(column, field.type) for column, field in zip(columns, list(_SCHEMA)[4:])]


def _pair(fixed: Geometry, moving: Geometry) -> tuple[Any, Any, Any]:
    try:
        shape = _core.no_fit_polygon(fixed, moving, reference=(0, 0), threads=1)
        return shape.to_wkb(), shape.to_bytes(), None
    except Error as error:
        return None, None, str(error)
