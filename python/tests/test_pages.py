"""Docstrings and the page's examples are run."""

import doctest
import pathlib

import pytest

import minksum
from minksum import _core

# Names of types, which have no docstring of their own at run time.
ALIASES = ("GeometryLike", "Number")
ROOT = pathlib.Path(__file__).parents[2]


def test_docstrings():
    count = 0
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
    items = [getattr(minksum, name) for name in minksum.__all__]
    for item in [*items, minksum.ConfigurationSpace.slices]:
        doc = item.__doc__
        if not doc or ">>>" not in doc:
            continue
        test = doctest.DocTestParser().get_doctest(doc, {}, item.__name__, None, 0)
        runner.run(test)
        count += len(test.examples)
    assert count >= 10 and runner.failures == 0


def test_everything_has_a_docstring():
    for module in (minksum, _core):
        for name in getattr(module, "__all__", dir(module)):
            item = getattr(module, name)
            if callable(item) and not name.startswith("_") and name not in ALIASES:
                assert item.__doc__, name


@pytest.mark.parametrize("name, least", [("docs/python.md", 20), ("README.md", 4)])
def test_pages(name, least):
    page = (ROOT / name).read_text()
    blocks = [block.split("```")[0] for block in page.split("```python\n")[1:]]
    example = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, name, None, 0)
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    runner.run(example)
    assert runner.failures == 0 and len(example.examples) >= least
