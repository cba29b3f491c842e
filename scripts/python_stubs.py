#!/usr/bin/env python3
"""Writes the stubs of the extension module, python/minksum/_core.pyi, from the module itself.

usage: python_stubs.py [--check]     run with the Python in which minksum and nanobind are installed.
With --check nothing is written: the exit code is 1 if the file says something else than the module.
"""

import pathlib
import re
import sys
import textwrap

import minksum._core
from nanobind.stubgen import StubGen

PATH = pathlib.Path(__file__).parents[1] / "python" / "minksum" / "_core.pyi"
HEAD = '''\
"""Types of the extension module. scripts/python_stubs.py makes this file."""

import typing
from collections.abc import Callable, Iterable, Sequence
from typing import Any, overload

import numpy
import numpy.typing

from ._results import Exact, Reach, Slice, Trace
from ._types import GeometryLike, Number

# What stands for a single geometry by its type alone.
Single: typing.TypeAlias = "Geometry | str | bytes"
'''
ANY_SHAPE = "-> Geometry | GeometryArray | None"


def overloads(line: str) -> str:
    """Split a function whose result has the shape of its operands by what is known of these."""
    found = re.match(r"( *)def (\w+)\((.*)\) " + re.escape(ANY_SHAPE), line)
    if not found:
        return line
    indent, name, arguments = found.groups()
    single = arguments.replace(": GeometryLike", ": Single")
    if "other:" in arguments:  # only a geometry or an array may stand behind an operator
        single = "self, other: Geometry"
        arguments = "self, other: GeometryArray"
        results = ("Geometry", "GeometryArray")
        if indent and CURRENT[-1] == "GeometryArray":
            return f"{indent}def {name}(self, other: Geometry | GeometryArray) -> GeometryArray: ..."
    else:
        results = ("Geometry", "typing.Any")
    return "\n".join(
        f"{indent}@overload\n{indent}def {name}({a}) -> {r}: ..."
        for a, r in zip((single, arguments), results)
    )


CURRENT: list[str] = [""]


def wrapped(line: str) -> str:
    if len(line) <= 100 or "def " not in line:
        return line
    indent = " " * (len(line) - len(line.lstrip()))
    head, arguments, result = re.match(r"( *def \w+\()(.*)(\) -> .*)", line).groups()
    inner = textwrap.fill(arguments, 100, initial_indent=indent + "    ",
                          subsequent_indent=indent + "    ", break_long_words=False,
                          break_on_hyphens=False)
    return f"{head}\n{inner}\n{indent}{result}"


def stubs() -> str:
    generator = StubGen(module=minksum._core, include_docstrings=False, include_private=True)
    generator.put(minksum._core)
    text = generator.get()
    body = text[re.search(r"^(class|def) ", text, re.M).start():]
    lines = []
    for line in body.rstrip().splitlines():
        if line.startswith("class "):
            CURRENT.append(line[6:].split(":")[0].split("(")[0])
        lines += [wrapped(part) for part in overloads(line).splitlines()]
    return HEAD + "\n" + "\n".join(lines) + "\n"


def main() -> int:
    text = stubs()
    if "--check" in sys.argv[1:]:
        if PATH.read_text() == text:
            return 0
        print(f"{PATH} is not what {sys.argv[0]} makes of the module: run it")
        return 1
    PATH.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
