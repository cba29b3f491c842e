"""Tests ends at any moment and lack of memory, disk or time: no torn file, the right exit code."""
import math
import os
import random
import resource
import signal
import subprocess
import time
import unittest

from support import MEMORY_MB, PROGRAM, SQUARE, ProgramTest, limit_memory, main, run

OLD = "precious\n"


def ragged(vertices, radius):
    """Returns a star-shaped polygon whose sum with itself takes much work."""
    ring = [f"{int(radius * (1 + i * 7919 % 97 / 100) * math.cos(2 * math.pi * i / vertices))} "
            f"{int(radius * (1 + i * 7919 % 97 / 100) * math.sin(2 * math.pi * i / vertices))}"
            for i in range(vertices)]
    return f"POLYGON (({', '.join(ring + ring[:1])}))"


def squares(count):
    """Returns many distant squares, whose sum takes little time and much space."""
    return "MULTIPOLYGON (" + ", ".join(
        f"(({x} 0, {x + 1} 0, {x + 1} 1, {x} 1, {x} 0))" for x in range(0, 100 * count, 100)) + ")"


class Interrupted(ProgramTest):
    def setUp(self):
        super().setUp()
        self.square = self.file("square.wkt", SQUARE)
        self.out = self.file("out.wkt", OLD)

    def temporary_files(self):
        return [f for f in self.folder.iterdir() if f.suffix == ".tmp"]

    def start(self, *arguments):
        def prepare():
            limit_memory()
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                signal.signal(number, signal.SIG_DFL)  # whoever runs the tests may ignore them

        return subprocess.Popen([PROGRAM, *map(str, arguments)], stdin=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                preexec_fn=prepare)

    def expect_old_or(self, new):
        self.assertIn(self.out.read_text(), (OLD, new))

    def test_at_random_moments(self):
        choice = random.Random(2011)
        arguments = ("sum", self.file("p.wkt", ragged(300, 10_000)), self.file("q.wkt", squares(9)),
                     "--coords", "decimal:100", "-o", self.out)
        began = time.monotonic()
        self.fine(*arguments)
        whole = time.monotonic() - began
        new = self.out.read_text()
        for count in range(60):
            self.out.write_text(OLD)
            number = choice.choice([signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL])
            with self.subTest(f"{count}: {number.name}"):
                process = self.start(*arguments)
                time.sleep(choice.uniform(0, 1.2 * whole))
                process.send_signal(number)
                process.stderr.read()
                process.stderr.close()
                self.assertIn(process.wait(), (0, -number))
                self.expect_old_or(new)
                if number == signal.SIGKILL:
                    for file in self.temporary_files():
                        self.assertTrue(file.name.startswith("minksum-"))
                        file.unlink()
                self.assertEqual(self.temporary_files(), [])

    def while_writing(self, *extra):
        """Returns a process that has begun to write much; the caller must end it."""
        p = self.file("p.wkt", squares(1000))
        for _ in range(20):
            process = self.start("sum", p, self.square, "--coords", "decimal:1000", "-o", self.out,
                                 *extra)
            while process.poll() is None:
                if self.temporary_files():
                    return process
            process.stderr.close()
            self.out.write_text(OLD)
        return self.fail("no moment of writing was met")

    def test_while_writing(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL):
            with self.subTest(number.name):
                process = self.while_writing()
                process.send_signal(number)
                told = process.stderr.read()
                self.assertEqual(told, b"" if number == signal.SIGKILL else
                                 b"minksum: interrupted: no output was changed\n")
                process.stderr.close()
                self.assertEqual(process.wait(), -number)
                self.assertEqual(self.out.read_text(), OLD)
                left = self.temporary_files()
                self.assertEqual(len(left), 1 if number == signal.SIGKILL else 0)
                for file in left:
                    file.unlink()

    def test_line_says_what_was_written(self):
        """Standard output may be torn, and a batch keeps what is done."""
        p = self.file("p.wkt", ragged(1000, 100_000))
        slow = '{"operation": "sum", "a": "p.wkt", "b": "p.wkt", "options": {"method": "full"}}\n'
        jobs = self.file("jobs.jsonl", slow)
        partial = self.folder / "results.jsonl.partial"
        for arguments, words in (
                (["batch", jobs, "-o", partial.with_suffix("")],
                 b"interrupted: FILE.partial keeps the jobs that are done"),
                (["batch", jobs], b"interrupted: what was printed is incomplete"),
                (["sum", p, p, "--repeat", 100_000], b"interrupted: no output was changed")):
            process = self.start(*arguments)
            time.sleep(1)  # a batch begins its output at once, and all sums take far longer
            process.send_signal(signal.SIGINT)
            self.assertIn(words, process.stderr.read())
            process.stderr.close()
            self.assertEqual(process.wait(), -signal.SIGINT)
        self.assertTrue(partial.exists())

    def test_what_is_ignored_stays_ignored(self):
        new = self.folder / "new.wkt"
        self.fine("sum", self.square, self.square, "-o", new)
        process = subprocess.Popen(
            [PROGRAM, "sum", "-", self.square, "-o", self.out], stdin=subprocess.PIPE,
            preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        time.sleep(0.05)
        process.send_signal(signal.SIGHUP)
        process.communicate(SQUARE.encode(), timeout=60)
        self.assertEqual(process.returncode, 0)
        self.assertEqual(self.out.read_text(), new.read_text())

    def test_file_too_large(self):
        for size in (0, 10, 100_000):
            with self.subTest(size):
                p = self.file("p.wkt", squares(1000))
                self.fails(2, "out.wkt: cannot be written: File too large", "sum", p, self.square,
                           "--coords", "decimal:100", "-o", self.out,
                           before=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
                self.assertEqual(self.out.read_text(), OLD)
                self.assertEqual(self.temporary_files(), [])

    def test_reader_goes_away(self):
        p = self.file("p.wkt", squares(1000))
        for ignored in (False, True):
            reading, writing = os.pipe()
            os.close(reading)
            action = signal.SIG_IGN if ignored else signal.SIG_DFL
            result = subprocess.run([PROGRAM, "sum", p, self.square], stdout=writing,
                                    stderr=subprocess.PIPE, check=False,
                                    preexec_fn=lambda: signal.signal(signal.SIGPIPE, action))
            os.close(writing)
            if ignored:
                self.assertEqual(result.returncode, 2)
                self.assertEqual(result.stderr,
                                 b"minksum: standard output: cannot be written: Broken pipe\n")
            else:
                self.assertEqual(result.returncode, -signal.SIGPIPE)

    def test_closed_streams(self):
        self.fails(2, "standard output: cannot be written: Bad file descriptor", "sum", self.square,
                   self.square, before=lambda: os.close(1))
        self.fails(2, "standard input: cannot be read: Bad file descriptor", "sum", "-",
                   self.square, before=lambda: os.close(0))
        new = self.fine("sum", self.square, self.square)
        result = run("sum", self.square, self.square, "-o", self.out, "-v",
                     before=lambda: os.close(2))
        self.assertEqual((result.returncode, self.out.read_text()), (0, new))
        self.fails(2, "No space left", "--help", before=lambda: os.dup2(
            os.open("/dev/full", os.O_WRONLY), 1))


class Limits(ProgramTest):
    def setUp(self):
        super().setUp()
        self.square = self.file("square.wkt", SQUARE)
        self.out = self.file("out.wkt", OLD)

    @unittest.skipIf(MEMORY_MB == 0, "a sanitizer needs more addresses than any limit allows")
    def test_any_memory(self):
        """The limit starts at what the program needs to start, and grows until it is enough."""
        p = self.file("p.wkt", ragged(400, 10_000))
        codes = []
        for kilobytes in [0, 1, *range(6_000, 60_000, 600)]:
            with self.subTest(kilobytes):
                self.out.write_text(OLD)
                result = run("sum", p, p, "-o", self.out, "--svg", self.folder / "out.svg",
                             "--max-memory", f"{kilobytes}K")
                codes.append(result.returncode)
                if result.returncode == 0:
                    self.assertNotEqual(self.out.read_text(), OLD)
                    break
                self.assertEqual(result.returncode, 3, result.stderr)
                self.assertRegex(result.stderr.decode(),
                                 r"^minksum: out of memory: the limit is \d+[KM]? bytes "
                                 r"\(--max-memory\)\n$")
                self.assertFalse([f for f in self.folder.iterdir() if f.suffix == ".tmp"])
        self.assertEqual(codes[-1], 0)
        self.assertGreater(codes.count(3), 10)

    @unittest.skipIf(MEMORY_MB == 0, "a sanitizer needs more addresses than any limit allows")
    def test_any_memory_of_many_threads(self):
        """Any request of any thread may fail without a crash."""
        self.file("square.wkt", SQUARE)
        jobs = self.file("jobs.jsonl", 100 * (
            '{"operation": "sum", "a": "square.wkt", "b": "square.wkt"}\n'))
        for kilobytes in (*range(18_500, 40_000, 1500), *range(40_000, 400_000, 20_000)):
            with self.subTest(kilobytes):
                result = run("batch", jobs, "--threads", 20, "--max-memory", f"{kilobytes}K")
                self.assertIn(result.returncode, (0, 2, 3), result.stderr)

    @unittest.skipIf(MEMORY_MB == 0, "a sanitizer needs more addresses than any limit allows")
    def test_memory_while_reading_and_from_outside(self):
        big = self.file("big.wkt", squares(20_000))
        for command in (["sum", big, self.square], ["info", big]):
            self.fails(3, "out of memory: the limit is 20M bytes (--max-memory)", *command,
                       "--max-memory", "20M")
        self.fails(3, "minksum: out of memory\n", "info", big, before=lambda: resource.setrlimit(
            resource.RLIMIT_AS, (20 << 20, 20 << 20)))

    def test_time(self):
        p = self.file("p.wkt", ragged(3000, 100_000))
        self.fails(3, "the time limit of 0.3 seconds is exceeded (--timeout)", "sum", p, p,
                   "--timeout", "0.3", "--no-cover", "--arithmetic", "arbitrary", "-o", self.out)
        self.assertEqual(self.out.read_text(), OLD)
        self.fine("sum", self.square, self.square, "--timeout", "50", "-o", self.out)

    def test_time_while_reading(self):
        reading, writing = os.pipe()
        result = subprocess.run([PROGRAM, "info", "-", "--timeout", "0.1"], stdin=reading,
                                capture_output=True, timeout=60, check=False)
        os.close(reading)
        os.close(writing)
        self.assertEqual(result.returncode, 3)
        self.assertIn(b"the time limit of 0.1 seconds is exceeded (--timeout)", result.stderr)

    def test_time_while_writing(self):
        p = self.file("p.wkt", squares(200))
        process = subprocess.Popen([PROGRAM, "sum", p, self.square, "--timeout", "2", "--coords",
                                    "decimal:100"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        # Nobody reads, so the pipe is full long before the whole sum is written.
        self.assertIn(b"(--timeout)", process.stderr.read())
        self.assertEqual(process.wait(60), 3)
        self.assertTrue(process.stdout.read().startswith(b"MULTIPOLYGON"))
        process.stdout.close()
        process.stderr.close()

    def test_counts(self):
        p = self.file("p.wkt", ragged(100, 10_000))
        for fragment, *limit in (
                ("more vertices than the limit of 99 (--max-vertices)", "--max-vertices", "99"),
                ("more than 2 segments (--max-segments)", "--max-segments", "2"),
                ("more than 1000 segments (--max-segments)", "--max-segments", "1K"),
                ("more than 3 crossings (--max-crossings)", "--max-crossings", "3", "--no-cover"),
                ("limit of 1024 bytes (--max-bytes)", "--max-bytes", "1K"),
                ("more than 2 segments (--max-segments)", "--max-segments", "2", "--method",
                 "signed"),
                ("more than 2 crossings (--max-crossings)", "--max-crossings", "2",
                 "--method", "signed")):
            self.fails(3, fragment, "sum", p, p, *limit)
        # The message is about vertices, but names the option that limits segments.
        many = self.file("many.wkt", "MULTIPOINT (0 0, 9 9, 20 20)")
        self.fails(3, "vertices (--max-segments)\n", "sum", p, many, "--max-segments", "250")
        self.fine("sum", p, p, "--max-vertices", "1K", "--max-segments", "1G", "--max-crossings",
                  "2M", "--max-bytes", "1T")
        self.fails(3, "(--max-vertices)", "info", p, "--max-vertices", "99")

    def test_fixed_limits_have_no_option(self):
        for arguments in (["offset", self.square, "-d1", "--tolerance", "1e-13"],
                          ["offset", self.square, "-d1", "--tolerance", "1e-13", "--join", "miter"],
                          ["info", self.file("deep.wkt", "GEOMETRYCOLLECTION (" * 99)],
                          ["info", self.file("long.wkt", f"POINT (0 {'1' * 5000})")]):
            result = self.fails(3, "", *arguments)
            self.assertNotIn(b"--", result.stderr)

    def test_what_is_no_limit(self):
        for option in ("--max-vertices", "--max-segments", "--max-crossings"):
            for text in ("-1", "x", "1.5K", "1T", "1KK", "99999999999999999999", "20000000000G"):
                self.fails(1, f"{option} takes a count", "sum", self.square, self.square,
                           f"{option}={text}")
        for option in ("--max-bytes", "--max-memory"):
            for text in ("-1", "G", "1.5G", "1B", "1 G", "99999999999T"):
                self.fails(1, f"{option} takes a size", "info", self.square, f"{option}={text}")
        for text in ("0", "-1", "1s", "nan", "inf", "1e9"):
            self.fails(1, "--timeout takes seconds", "info", self.square, f"--timeout={text}")
        self.fine("info", self.square, "--max-memory", "none", "--timeout", "1e2")


if __name__ == "__main__":
    main()
