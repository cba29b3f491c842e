"""Errors, and how calls are stopped."""

import gc
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy as np
import pytest
import shapely

import minksum as mk

SQUARE = mk.box(0, 0, 1, 1)


class Raises:
    @property
    def __geo_interface__(self):
        raise RuntimeError("no shape today")


@pytest.mark.parametrize(
    "operand, kind, words",
    [
        (3, TypeError, "not int"),
        (object(), TypeError, "not object"),
        (np.zeros((3, 3)), TypeError, r"\(n, 2\)"),
        (np.array([[0, 0], [np.nan, 0], [1, 1]]), mk.BadInputError, "vertex 1"),
        ([(0, 0), (float("inf"), 0), (1, 1)], mk.BadInputError, "vertex 1"),
        ([(0, 0, 5), (1, 0, 5), (1, 1, 5)], mk.BadInputError, "drop"),
        ("POLYGON ((0 0, 1 0, 1 O, 0 0))", mk.BadInputError, "1:23"),
        ("no geometry", mk.BadInputError, "1:1"),
        ("/etc/passwd", mk.BadInputError, "1:1"),
        ("POLYGON Z ((0 0 1, 1 0 1, 1 1 1, 0 0 1))", mk.BadInputError, ""),
        (b"", mk.BadInputError, "byte 1"),
        (b"\x07abc", mk.BadInputError, "byte 1"),
        ({"type": "Curve", "coordinates": []}, mk.BadInputError, "'Curve'"),
        ({"coordinates": []}, mk.BadInputError, "type"),
        (Raises(), RuntimeError, "no shape today"),
        ([[("a", 0), (1, 0), (1, 1)]], (mk.BadInputError, TypeError), ""),
        (shapely.from_wkt("POLYGON Z ((0 0 1, 1 0 1, 1 1 1, 0 0 1))"), mk.BadInputError, ""),
    ],
)
def test_what_is_refused(operand, kind, words):
    for call in (lambda: mk.minkowski_sum(operand, SQUARE), lambda: mk.offset(operand, 1),
                 lambda: mk.Geometry(operand)):
        with pytest.raises(kind, match=words or None):
            call()


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: mk.offset(SQUARE, 1, side="left"), '"outside"'),
        (lambda: mk.offset(SQUARE, 1, join="sharp"), '"bevel"'),
        (lambda: mk.minkowski_sum(SQUARE, SQUARE, fill="odd"), '"evenodd"'),
        (lambda: mk.minkowski_sum(SQUARE, SQUARE, timeout=0), "timeout"),
        (lambda: mk.minkowski_sum(SQUARE, SQUARE, threads=-1), "threads"),
        (lambda: mk.from_wkt("POINT (0 0)", z="keep"), '"drop"'),
        (lambda: mk.box(0, 0, 0, 1), "xmin < xmax"),
        (lambda: mk.box(0, 0, "one", 1), "'one'"),
        (lambda: mk.erode(SQUARE, "POLYGON EMPTY"), ""),
        (lambda: mk.disc(-1), "radius"),
    ],
)
def test_arguments_that_are_refused(call, words):
    with pytest.raises(ValueError, match=words or None):
        call()


def test_heights_are_dropped_on_request():
    assert mk.from_wkt("POINT Z (1 2 3)", z="drop") == mk.from_wkt("POINT (1 2)")
    assert mk.as_geometry([(0, 0, 5), (1, 0, 5), (1, 1, 5)], z="drop").num_vertices == 3


def test_errors_of_arrays_name_the_element():
    bow_tie = [(0, 0), (4, 4), (4, 0), (0, 4)]
    array = [SQUARE] * 50 + [mk.Geometry(bow_tie)] + [SQUARE] * 50
    with pytest.raises(mk.BadInputError, match="element 50: edges cross") as caught:
        mk.minkowski_sum(array, SQUARE, fill="strict")
    assert caught.value.index == 50 and caught.value.operand == 0


def long_operand():
    """A star whose sum with another one takes many seconds by any method."""
    rng = np.random.default_rng(1)
    angles = np.sort(rng.uniform(0, 2 * np.pi, 60000))
    radii = rng.uniform(0.01, 1, 60000)
    return mk.Geometry(np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]))


def test_limits_tokens_progress_and_time():
    big = long_operand()
    with pytest.raises(mk.LimitError) as caught:
        mk.minkowski_sum(big, big, max_segments=1000)
    assert caught.value.limit == "Limits::max_segments"
    with pytest.raises(mk.LimitError) as caught:
        mk.minkowski_sum(big, big, timeout=0.2)
    assert caught.value.limit == "timeout"
    token = mk.CancelToken()
    threading.Timer(0.2, token.cancel).start()
    with pytest.raises(mk.CancelledError):
        mk.minkowski_sum(big, big, cancel=token)
    stages = []
    with pytest.raises(mk.CancelledError):
        mk.minkowski_sum(big, big, progress=lambda stage: stages.append(stage) or len(stages) < 3)
    assert stages[0] == "operands"
    with pytest.raises(ZeroDivisionError):
        mk.minkowski_sum(big, big, progress=lambda stage: 1 // 0)


def test_ctrl_c_ends_a_call_and_loses_nothing():
    program = textwrap.dedent("""
        import signal, sys
        sys.path.insert(0, %r)
        # A shell's background jobs ignore Ctrl-C, and what they start inherits that.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        import minksum as mk
        from test_calls import long_operand
        big = long_operand()
        print("ready", flush=True)
        try:
            mk.minkowski_sum(big, big)
        except KeyboardInterrupt:
            square = mk.box(0, 0, 1, 1)
            print("interrupted", mk.minkowski_sum(square, square), flush=True)
    """) % os.path.dirname(__file__)
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "ready\n"
    time.sleep(0.5)
    child.send_signal(signal.SIGINT)
    out, _ = child.communicate(timeout=60)
    assert out == "interrupted POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\n"


def test_threads_share_operands():
    a = mk.offset(shapely.Point(0, 0).buffer(5, quad_segs=100), 1)
    expected = mk.minkowski_sum(a, a, threads=1)
    results = []
    threads = [threading.Thread(target=lambda: results.append(mk.minkowski_sum(a, a, threads=1)))
               for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert results == [expected] * 8
    many = mk.GeometryArray([a] * 40)
    assert mk.minkowski_sum(many, a, threads=4) == mk.GeometryArray([expected] * 40)


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="needs Linux's /proc")
def run_alone(program, before=""):
    """Runs a program in a process of its own, in which nothing has been called yet."""
    done = subprocess.run(["sh", "-c", before + 'exec "$0" -c "$1"', sys.executable,
                           textwrap.dedent(program)],
                          capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_first_calls_of_many_threads():
    run_alone("""
        import threading
        import minksum as mk, shapely
        box, start = shapely.box(0, 0, 1, 1), threading.Barrier(8)
        def use():
            start.wait()
            mk.from_wkt("POINT (1/3 1/7)").exact_coords()
            mk.as_geometry(box)
            mk.depth(box, box)
        threads = [threading.Thread(target=use) for _ in range(8)]
        for thread in threads: thread.start()
        for thread in threads: thread.join()
    """)


def test_nobody_waits_for_a_geometry_that_is_prepared():
    run_alone("""
        import math, threading
        import minksum as mk
        n = 60000
        ring = [(math.cos(i * math.tau / n) * (3 + i % 2), math.sin(i * math.tau / n) * (3 + i % 2))
                for i in range(n)]
        x, y = mk.as_geometry(ring), mk.box(0, 0, 1, 1)
        mk.minkowski_sum(x, y)
        helper = threading.Thread(target=lambda: mk.prepare(x))
        seen = set()
        def again(stage):  # once for each stage: a sum takes long
            if stage not in seen:
                seen.add(stage)
                mk.minkowski_sum(x, y, threads=1)
        helper.start()
        mk.minkowski_sum(x, y, progress=again, threads=1)
        helper.join()
    """)


@pytest.mark.skipif(sys.platform != "linux", reason="limits of processes differ")
def test_fewer_threads_than_asked_for():
    run_alone("""
        import resource
        import numpy as np
        import minksum as mk
        boxes = np.array([mk.box(0, 0, i + 1, 1) for i in range(500)], dtype=object)
        resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))  # each thread takes 1 GiB of it
        assert len(mk.minkowski_sum(boxes, mk.box(0, 0, 1, 1), threads=64)) == 500
    """, before="ulimit -s 1048576; export OPENBLAS_NUM_THREADS=1; ")


@pytest.mark.parametrize("progress", ["None", "lambda stage: None"])
def test_a_process_ends_while_its_threads_compute(progress):
    run_alone(f"""
        import threading, time
        import minksum as mk
        p, q = mk.disc(5, "1e-6"), mk.disc(3, "1e-6")
        def work():
            while True:
                mk.minkowski_sum(p, q, progress={progress})
        for i in range(3):
            threading.Thread(target=work, daemon=True).start()
        time.sleep(0.5)
    """)


def test_progress_may_answer_with_any_truth():
    p, q = mk.disc(5, "1e-3"), mk.disc(3, "1e-3")
    assert mk.minkowski_sum(p, q, progress=lambda stage: np.True_).area > 0
    with pytest.raises(mk.CancelledError):
        mk.minkowski_sum(p, q, progress=lambda stage: np.False_)


def test_elements_one_after_another():
    array = mk.as_geometry([SQUARE, None, mk.box(0, 0, 2, 1)])
    assert list(array) == [array[0], None, array[-1]] and array[np.int64(2)] == array[2]
    for index in (3, -4):
        with pytest.raises(IndexError):
            array[index]


def test_a_geometry_that_is_not_made():
    with pytest.raises(TypeError, match="not made"):
        mk.offset(mk.Geometry.__new__(mk.Geometry), 1)


def test_masked_arrays_are_refused():
    points = np.ma.masked_array([[0, 0], [4, 0], [4, 4], [9, 9]], mask=[[0, 0]] * 3 + [[1, 1]])
    for dtype in (float, int, np.float32, object):
        with pytest.raises(TypeError, match="masked arrays"):
            mk.as_geometry(points.astype(dtype))


def test_reference_systems_have_to_be_one():
    a, b = (mk.as_geometry(f"SRID={srid};POLYGON ((0 0, 1 0, 0 1, 0 0))") for srid in (1, 2))
    with pytest.raises(mk.BadInputError, match="two reference systems"):
        mk.NoFitPolygon(a, b)
    with pytest.raises(mk.BadInputError, match="two reference systems"):
        mk.check_sum(mk.minkowski_sum(a, a), a, b)


def test_equal_arrays_have_equal_hashes():
    def make():
        return mk.as_geometry([SQUARE, None, mk.box(0, 0, "1/3", 1)])

    assert make() == make()
    assert hash(make()) == hash(make())


def test_areas_of_numbers_that_are_no_doubles():
    assert mk.area(mk.box(10**16, 10**16, 10**16 + 3, 10**16 + 2)) == 6
    assert mk.area(mk.box(1, 1, "1.0000000000000003", "1.0000000000000003")) == 9e-32


def test_memory_does_not_grow():
    triangle = mk.from_wkt("POLYGON ((0 0, 1/3 0, 0 1, 0 0))")

    def calls(count):
        for _ in range(count):
            mk.minkowski_sum(SQUARE, triangle).exact_coords()
            try:
                mk.from_wkt("POLYGON ((0 0")
            except mk.BadInputError:
                pass

    calls(20000)
    gc.collect()
    before = resident()
    calls(100000)
    gc.collect()
    assert resident() - before < 4 << 20
