"""The errors of the library. All of them are derived from `Error`."""

from __future__ import annotations

from typing import Optional

__all__ = ["Error", "BadInputError", "LimitError", "CancelledError", "InternalError"]


class Error(Exception):
    """An operation failed.

    Attributes
    ----------
    operand, polygon, ring, vertex : int or None
        The place in an operand that the error is about, counted from 0. Ring 0 of a polygon is its
        outer ring. Operand 0 is the first. None means that the place is not known.
    line, column : int or None
        The place in a text that could not be read, counted from 1.
    index : int, tuple of int or None
        The element of an array call that failed.
    limit : str or None
        The name of the limit that was passed.
    """

    operand: Optional[int] = None
    polygon: Optional[int] = None
    ring: Optional[int] = None
    vertex: Optional[int] = None
    line: Optional[int] = None
    column: Optional[int] = None
    index: Optional[int | tuple[int, ...]] = None
    limit: Optional[str] = None


class BadInputError(Error, ValueError):
    """An operand or an argument is not what the operation takes."""


class LimitError(Error):
    """A limit would be passed: segments, crossings, time, or the range of doubles."""


class CancelledError(Error):
    """A cancel token or the progress callback asked to stop."""


class InternalError(Error):
    """An invariant of the library broke. Please report it with the operands."""
