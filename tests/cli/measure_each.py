"""Compares --each with the features one by one, and prints what it takes (not a test):

    MINKSUM_DATA=FOLDER MINKSUM_PROGRAM=build/minksum python3 tests/cli/measure_each.py

All polygons of the folder gis become the features of one file. Their results are compared with those
of a process for each feature alone. Then the run is killed again and again until it is done, and the
features are taken ten times over, to see what that does to the memory.
"""
import json
import os
import pathlib
import re
import subprocess
import tempfile
import time

from each_test import collection, parts_of_the_collection
from support import PROGRAM

OPERATION = ("sum", "ngon:5:0.01")


def start(operand, *more):
    return subprocess.Popen([PROGRAM, OPERATION[0], operand, *OPERATION[1:], "-q", *more])


def measured(operand, *more):
    """Returns seconds and the peak memory in megabytes, which is read while the program runs: what
    the system counts for a child includes this script."""
    begin = time.monotonic()
    process = start(operand, *more)
    peak = 0
    while process.poll() is None:
        status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
        peak = max([peak, *(int(kilobytes) for kilobytes in re.findall(r"VmHWM:\s*(\d+)", status))])
        time.sleep(0.01)
    assert process.returncode == 0, process.returncode
    return time.monotonic() - begin, peak / 1024


def alone(folder, part):
    """Returns the result of one feature as a process of its own computes it."""
    path = folder / "alone.geojson"
    path.write_text(part)
    done = subprocess.run([PROGRAM, OPERATION[0], path, *OPERATION[1:], "--format", "geojson", "-q"],
                          check=True, capture_output=True)
    return json.loads(done.stdout)


def kill_and_resume(many, out):
    """Kills the run by SIGKILL, each time after it has written more. Returns how often."""
    partial = pathlib.Path(str(out) + ".partial")
    kills = 0
    while True:
        before = partial.stat().st_size if partial.exists() else 0
        process = start(many, "--each", "--threads", "1", "-o", out)
        while process.poll() is None:
            if partial.exists() and partial.stat().st_size > before + 200_000:
                process.kill()
                kills += 1
                break
            time.sleep(0.002)
        if process.wait() == 0:
            return kills


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        parts = parts_of_the_collection()
        many = folder / "all.geojson"
        many.write_text(collection(parts))
        whole = folder / "whole.geojson"
        seconds, memory = measured(many, "--each", "-o", whole)
        print(f"{len(parts)} features, {many.stat().st_size / 1e6:.1f} MB: {seconds:.1f} s, "
              f"{memory:.0f} MB")
        made = json.loads(whole.read_text())["features"]
        begin = time.monotonic()
        equal = sum(alone(folder, part) == result["geometry"] for part, result in zip(parts, made))
        print(f"equal to a process of its own: {equal} of {len(parts)} "
              f"({time.monotonic() - begin:.1f} s)")
        killed = folder / "killed.geojson"
        kills = kill_and_resume(many, killed)
        same = "the same bytes" if killed.read_bytes() == whole.read_bytes() else "OTHER BYTES"
        print(f"killed {kills} times and resumed: {same}")
        many.write_text(collection(parts * 10))
        seconds, more = measured(many, "--each", "-o", whole)
        print(f"ten times the features, {many.stat().st_size / 1e6:.1f} MB: {seconds:.1f} s, "
              f"{more:.0f} MB")


if __name__ == "__main__":
    main()
