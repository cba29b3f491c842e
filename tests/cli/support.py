"""Shares what tests of the program need: runs within limits, and small shapes."""
import os
import pathlib
import re
import resource
import subprocess
import tempfile
import unittest

PROGRAM = os.environ.get("MINKSUM_PROGRAM", "build/minksum")
MEMORY_MB = int(os.environ.get("MINKSUM_MEMORY_MB", "1024"))  # megabytes of addresses; 0 = no limit
SECONDS = 60  # far beyond any of these runs, so that only a hang reaches it
SOURCE = pathlib.Path(__file__).resolve().parents[2]

SQUARE = "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"
TRIANGLE = "POLYGON ((0 0, 3 0, 0 3, 0 0))"
FRAME = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 6 3, 3 3))"


def limit_memory():
    if MEMORY_MB:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY_MB << 20, MEMORY_MB << 20))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(*arguments, stdin=b"", cwd=None, before=None):
    """Runs the program; a crash shows as a negative return code, a hang as TimeoutExpired.

    `before` is called in the new process, before the program takes its place.
    """
    if isinstance(stdin, str):
        stdin = stdin.encode()

    def prepare():
        limit_memory()
        if before:
            before()

    return subprocess.run([PROGRAM, *map(str, arguments)], input=stdin, capture_output=True,
                          timeout=SECONDS, cwd=cwd, preexec_fn=prepare, check=False)


class ProgramTest(unittest.TestCase):
    """Gives a test a folder of its own and the usual expectations."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="minksum-test-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return path

    def fine(self, *arguments, note="", **options):
        """Runs the program, which must succeed, and returns its output. Standard error must be
        empty, or be one line that holds `note`."""
        result = run(*arguments, **options)
        told = result.stderr.decode(errors="replace")
        self.assertEqual(result.returncode, 0, told)
        self.assertEqual(told.count("\n"), 1 if note else 0, told)
        self.assertIn(note, told)
        return result.stdout.decode()

    def fails(self, code, fragment, *arguments, **options):
        """Runs the program, which must fail with this code and one line that holds `fragment`."""
        result = run(*arguments, **options)
        line = result.stderr.decode(errors="replace")
        self.assertEqual(result.returncode, code, line[:500])
        self.assertTrue(line.startswith("minksum: "), line[:500])
        self.assertEqual(line.count("\n"), 1, line[:500])
        self.assertTrue(line.endswith("\n"), line[-100:])
        self.assertLess(len(line), 2000)
        self.assertIn(fragment, line)
        return result


class Page:
    """Tests that a page of docs/ is right: each block of commands prints the block below it (or
    nothing), and draws its pictures. To be mixed into a ProgramTest."""

    page_name = None
    pictures = 0  # how many there are at least

    def setUp(self):
        super().setUp()
        self.page = (SOURCE / "docs" / self.page_name).read_text()
        build = pathlib.Path(PROGRAM).resolve().parent
        for name, target in (("build", build), ("examples", SOURCE / "examples")):
            (self.folder / name).symlink_to(target)
        (self.folder / "docs" / "img").mkdir(parents=True)

    def test_commands(self):
        blocks = re.findall(r"^```sh\n(.*?)^```$(?:\n\n^```(?:text|json)\n(.*?)^```$)?", self.page,
                            re.M | re.S)
        self.assertEqual(len(blocks), self.page.count("```sh"))
        self.assertGreater(len(blocks), 0)
        for script, expected in blocks:
            done = subprocess.run(["sh", "-eu"], input=script, capture_output=True, text=True,
                                  cwd=self.folder, timeout=SECONDS, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(done.stdout, expected)
        pictures = re.findall(r"\]\((img/[^)]+)\)", self.page)
        self.assertGreaterEqual(len(pictures), self.pictures)
        for picture in pictures:
            made = (self.folder / "docs" / picture).read_text()
            self.assertEqual(made, (SOURCE / "docs" / picture).read_text(), picture)

    def test_links(self):
        for target in re.findall(r"\]\((?!http)([^)#]+)\)", self.page):
            self.assertTrue((SOURCE / "docs" / target).exists(), target)


def main():
    unittest.main(verbosity=1)
