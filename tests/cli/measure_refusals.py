"""Prints what refusing large files takes: python3 tests/cli/measure_refusals.py (not a test).

Each row of the table of bad_input_test.py is made 10 MB long in two ways: with a good beginning, so
that the fault comes last, and with filling behind the fault. Seconds are those of the clock, and
those of the processor, which do not count what else the machine does.
"""
import os
import pathlib
import subprocess
import tempfile
import time

from bad_input_test import TABLE
from support import PROGRAM, SQUARE

SIZE = 10_000_000
BEGINNINGS = {
    "WKT": (SQUARE + "\n").encode(),
    "GeoJSON": b'{"type": "Point", "coordinates": [1, 2]}\n',
    "CSV": b"wkt,n\nPOINT (1 2),3\n",
}


def filled(name, content):
    """Gives the files that are made of a row."""
    content = content() if callable(content) else content
    content = content.encode() if isinstance(content, str) else content
    if len(content) > 1_000_000:
        yield "as it is", content
        return
    yield "filling behind", content + b"\n" + content * (SIZE // max(len(content), 1))
    for kind, good in BEGINNINGS.items():
        if name.startswith(kind) and kind != "CSV":
            yield "fault last", good * (SIZE // len(good)) + content
    if name.startswith("CSV"):
        head, _, tail = content.partition(b"\n")
        row = b"POINT (1 2)" + b",3" * head.count(b",") + b"\n"
        yield "fault last", head + b"\n" + row * (SIZE // len(row)) + tail


def main():
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "bad"
        for name, content, _, _ in TABLE:
            for how, data in filled(name, content):
                path.write_bytes(data)
                start = time.monotonic()
                process = subprocess.Popen([PROGRAM, "info", path], stdout=subprocess.DEVNULL,
                                           stderr=subprocess.DEVNULL)
                _, status, usage = os.wait4(process.pid, 0)
                rows.append((time.monotonic() - start, usage.ru_utime + usage.ru_stime,
                             usage.ru_maxrss // 1024,
                             os.waitstatus_to_exitcode(status), name, how))
    rows.sort(reverse=True)
    refused = [row for row in rows if row[3] != 0]
    print(f"{len(rows)} files, {len(refused)} refused. Most of a refusal: "
          f"{max(row[0] for row in refused):.2f} s, {max(row[1] for row in refused):.2f} s of the "
          f"processor, {max(row[2] for row in refused)} MB. The slowest files:")
    for seconds, work, memory, code, name, how in rows[:12]:
        told = f"exit {code}" if code else "read  "  # a file that is longer can be right
        print(f"{seconds:5.2f} s {work:5.2f} s {memory:4d} MB  {told}  {name} ({how})")


if __name__ == "__main__":
    main()
