#!/usr/bin/env python3
"""Measures what the Python package promises beside the library itself.

    build/python-environment/bin/python bench/python/promises.py \
        [interrupt] [memory] [threads] [table] [arrow] [stream] [distribution]

It prints a line for each, with the goal where there is one. `table` compiles its counterpart in C++
with the library below `build`, or below MINKSUM_BUILD. `stream` writes a gigabyte into the folder
for temporary files. Run them on a quiet machine.
"""

import os
import pathlib
import resource
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time

import numpy as np

import minksum as mk

CORES = os.cpu_count() or 1


def star(source, corners, at=(0, 0)):
    angles = np.sort(source.uniform(0, 2 * np.pi, corners))
    radii = source.uniform(0.4, 1, corners)
    ring = np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]) + at
    # Multiples of 2^-20, so that coordinates have the lengths of drawings.
    return np.round(ring * 2**20) / 2**20


def best(call, runs=5):
    """Return the shortest wall clock time of a call."""
    times = []
    for _ in range(runs):
        begin = time.perf_counter()
        call()
        times.append(time.perf_counter() - begin)
    return min(times)


def interrupt():
    """How long after Ctrl-C a sum of ten seconds or more ends."""
    source = np.random.default_rng(1)
    angles = np.sort(source.uniform(0, 2 * np.pi, 60000))
    radii = source.uniform(0.01, 1, 60000)
    big = mk.Geometry(np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]))
    signal.signal(signal.SIGINT, signal.default_int_handler)
    waits = []
    for after in np.linspace(0.5, 9.5, 10):
        sent = []

        def send():
            sent.append(time.perf_counter())
            os.kill(os.getpid(), signal.SIGINT)

        timer = threading.Timer(after, send)
        timer.start()
        try:
            mk.minkowski_sum(big, big)
            print("the sum was done before Ctrl-C came")
            timer.cancel()
        except KeyboardInterrupt:
            waits.append(time.perf_counter() - sent[0])
    if waits:
        print(f"interrupt: Ctrl-C ends a sum after {max(waits) * 1e3:.0f} ms at most, "
              f"{statistics.median(waits) * 1e3:.0f} ms mostly, in {len(waits)} trials (goal: 100 ms)")


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def memory():
    """By how much memory grows over 10^5 calls of each kind."""
    triangle = mk.from_wkt("POLYGON ((0 0, 1/3 0, 0 1, 0 0))")
    square, wkb = mk.box(0, 0, 1, 1), mk.box(0, 0, 1, 1).to_wkb()
    ring = [(0, 0), (1, 0), (0, 1)]
    calls = {
        "sums": lambda: mk.minkowski_sum(square, triangle),
        "sums of WKB and lists": lambda: mk.minkowski_sum(wkb, ring),
        "arrays": lambda: mk.minkowski_sum([square, triangle], square, threads=1),
        "exact_coords": lambda: triangle.exact_coords(),
        "coords": lambda: triangle.coords,
        "to_wkb and from_wkb": lambda: mk.from_wkb(triangle.to_wkb()),
        "bad input": lambda: mk.resolve("POLYGON ((0 0", on_error="none"),
    }
    for name, call in calls.items():
        for _ in range(20000):
            call()
        before = resident()
        for _ in range(100000):
            call()
        print(f"memory: 10^5 {name} take {(resident() - before) / 2**10:.0f} KiB more")


def threads():
    """How much faster 8 threads are over the same operands than one."""
    source = np.random.default_rng(1)
    a, b = (mk.Geometry(star(source, 200)) for _ in range(2))

    def work(count):
        for _ in range(count):
            mk.minkowski_sum(a, b, threads=1)

    def all_of(workers):
        running = [threading.Thread(target=work, args=(240 // workers,)) for _ in range(workers)]
        for worker in running:
            worker.start()
        for worker in running:
            worker.join()

    ratio = best(lambda: all_of(1)) / best(lambda: all_of(8))
    print(f"threads: 8 over the same operands are {ratio:.2f} times as fast as one on {CORES} "
          "cores (goal: 1.8 on 2)")


def compiled(folder):
    """Return the path of the counterpart in C++, compiled with the library that was built."""
    root = pathlib.Path(__file__).parents[2]
    build = pathlib.Path(os.environ.get("MINKSUM_BUILD", root / "build"))
    program = pathlib.Path(folder) / "table"
    subprocess.run([os.environ.get("CXX", "c++"), "-std=c++20", "-O3", f"-I{root / 'include'}",
                    root / "bench/python/table.cpp", build / "src/io/libminksum_io.a",
                    build / "src/libminksum.a", "-pthread", "-o", program], check=True)
    return program


def table():
    """A table of no-fit polygons and all its entries beside the same one in C++."""
    source = np.random.default_rng(5)
    parts = mk.GeometryArray([star(source, 12) for _ in range(25)])
    with tempfile.TemporaryDirectory() as folder:
        program = compiled(folder)
        path = pathlib.Path(folder) / "parts.wkt"
        path.write_text("".join(f"{part}\n" for part in parts))
        pairs = []
        for _ in range(5):  # in turn, so that what else runs disturbs both alike
            run = subprocess.run([program, path], capture_output=True, text=True, check=True)
            ours = best(lambda: mk.NoFitTable(parts, threads=1).entries(), runs=3)
            pairs.append((ours, float(run.stdout)))
    ours, theirs = map(min, zip(*pairs))
    print(f"table: {(25 * 4)**2} entries take {ours * 1e3:.1f} ms, {ours / theirs:.3f} times the "
          f"{theirs * 1e3:.1f} ms in C++ (goal: 1.05)")


def arrow():
    """From a column of Arrow to another beside the library's own time."""
    import geopandas
    import minksum.arrow
    import shapely

    source = np.random.default_rng(2)
    count = 100000
    polygons = [star(source, 12, at) for at in source.uniform(0, 1000, (count, 2))]
    shapes = shapely.polygons([shapely.LinearRing(ring) for ring in polygons])
    part = mk.Geometry(star(source, 8))
    array = mk.as_geometry(shapes)
    own = best(lambda: mk.minkowski_sum(array, part, threads=1), runs=3)
    for name in ("geoarrow", "WKB"):
        column = geopandas.GeoSeries(shapes).to_arrow(geometry_encoding=name)
        encoding = "multipolygon" if name == "geoarrow" else "wkb"

        def whole():
            read = minksum.arrow.from_arrow(column)
            minksum.arrow.to_arrow(mk.minkowski_sum(read, part, threads=1), encoding=encoding)

        print(f"arrow: {count} sums of {name} take {best(whole, runs=3):.2f} s from column to "
              f"column, the sums alone {own:.2f} s (goal: 1.1 times)")


def written(folder):
    return sum(path.stat().st_size for path in pathlib.Path(folder).iterdir())


def stream():
    """10^6 no-fit polygons into Parquet files, and the memory that takes."""
    import minksum.dask

    source = np.random.default_rng(4)
    parts = [star(source, 12) for _ in range(250)]
    with tempfile.TemporaryDirectory() as folder:
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        begin = time.perf_counter()
        paths = minksum.dask.no_fit_table(parts, out=folder, turns=4, block=(25, 250))
        spent = time.perf_counter() - begin
        most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        print(f"stream: {(250 * 4)**2} no-fit polygons into {len(paths)} files, "
              f"{written(folder) / 2**20:.0f} MiB, in {spent:.0f} s; memory rose from "
              f"{before / 2**10:.0f} to {most / 2**10:.0f} MiB")


def distribution():
    """From which size on processes of a cluster are faster than one, and than its threads."""
    import distributed
    import minksum.dask

    source = np.random.default_rng(6)
    with distributed.LocalCluster(n_workers=CORES, threads_per_worker=1, host="127.0.0.1",
                                  dashboard_address="127.0.0.1:0") as cluster, \
            distributed.Client(cluster) as client:
        for which in (None, client):  # Every process loads its modules.
            with tempfile.TemporaryDirectory() as folder:
                boxes = [mk.box(0, 0, n, 1) for n in range(1, 9)]
                minksum.dask.no_fit_table(boxes, out=folder, block=(1, 1), client=which)
        for count in (4, 8, 16, 32, 64):
            parts = [star(source, 12) for _ in range(count)]
            block = (max(1, count // 4), max(1, count // 2))
            times = []
            for which in (None, client):
                with tempfile.TemporaryDirectory() as folder:
                    begin = time.perf_counter()
                    minksum.dask.no_fit_table(parts, out=folder, block=block, client=which)
                    times.append(time.perf_counter() - begin)
            print(f"distribution: {count} parts, {(count * 4)**2} entries: {times[0] * 1e3:.0f} ms in "
                  f"one process, {times[1] * 1e3:.0f} ms in {CORES}; the table alone, by threads, "
                  f"{best(lambda: mk.NoFitTable(parts), runs=2) * 1e3:.0f} ms")


if __name__ == "__main__":
    for name in sys.argv[1:] or ["interrupt", "memory", "threads", "table", "arrow", "stream",
                                 "distribution"]:
        globals()[name]()
        sys.stdout.flush()
