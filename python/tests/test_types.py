"""Types: the stubs are those of the module, and mypy accepts a file that uses every name."""

import pathlib
import re
import subprocess
import sys

import matplotlib
import minksum
import typed_use

ROOT = pathlib.Path(__file__).parents[2]
USE = ROOT / "python/tests/typed_use.py"


def run(*command):
    done = subprocess.run([sys.executable, *map(str, command)], cwd=ROOT, capture_output=True,
                          text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_stubs_are_those_of_the_module():
    run("scripts/python_stubs.py", "--check")


def test_mypy_accepts_every_function():
    run("-m", "mypy", "--strict", USE)
    run("-m", "mypy", "--strict", "-p", "minksum")


def test_every_name_is_used():
    used = set(re.findall(r"\bmk\.(\w+)", USE.read_text()))
    assert used >= set(minksum.__all__), set(minksum.__all__) - used


def test_what_is_typed_runs(tmp_path):
    matplotlib.use("Agg")
    typed_use.one_geometry()
    typed_use.arrays()
    typed_use.parts_and_robots()
    typed_use.stopped_and_refused()
    typed_use.other_packages(tmp_path)
