"""What the tests of the program share: running it within limits, and small shapes."""
import os
import pathlib
import resource
import subprocess
import tempfile
import unittest

PROGRAM = os.environ.get("MINKSUM_PROGRAM", "build/minksum")
MEMORY_MB = int(os.environ.get("MINKSUM_MEMORY_MB", "1024"))  # of addresses; 0 = no limit
SECONDS = 60  # far beyond what any of these runs needs, so that only a hang reaches it
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
    """A test with a folder of its own and the usual expectations."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="minksum-test-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return path

    def fine(self, *arguments, **options):
        """Runs the program, which must succeed in silence on standard error; its output."""
        result = run(*arguments, **options)
        self.assertEqual(result.returncode, 0, result.stderr.decode(errors="replace"))
        self.assertEqual(result.stderr, b"")
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


def main():
    unittest.main(verbosity=1)
