"""Shares what tests of the extensions need: a database of their own, and queries by psql."""
import os
import pathlib
import subprocess
import unittest

PROGRAM = os.environ["MINKSUM_PROGRAM"]
SECONDS = 600  # far beyond any query, so that only a hang reaches it
EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / "examples"
OPTIONS = ["-X", "-A", "-t", "-q", "-v", "ON_ERROR_STOP=1", "-v", "VERBOSITY=verbose"]


def psql(database, text):
    """Runs SQL and returns what psql says, with an exit code."""
    return subprocess.run(["psql", *OPTIONS, database], input=text, capture_output=True, text=True,
                          timeout=SECONDS, check=False)


def program(*arguments):
    """Returns what the program prints."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                          timeout=SECONDS, check=True)
    return done.stdout.strip()


class DatabaseTest(unittest.TestCase):
    """Gives a class of tests a database with the extensions."""

    extensions = ["postgis", "minksum", "minksum_postgis"]

    @classmethod
    def setUpClass(cls):
        cls.database = "minksum_" + cls.__name__.lower()
        subprocess.run(["createdb", cls.database], check=True)
        for name in cls.extensions:
            done = psql(cls.database, f"CREATE EXTENSION {name}")
            if done.returncode:
                raise AssertionError(done.stderr)

    def ask(self, text):
        """Returns the rows that SQL prints, as one text."""
        done = psql(self.database, text)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.rstrip("\n")

    def refused(self, text, code, *fragments):
        """Runs SQL, which must fail with this SQLSTATE and say all fragments."""
        done = psql(self.database, text)
        self.assertNotEqual(done.returncode, 0, done.stdout)
        self.assertIn(f"ERROR:  {code}: ", done.stderr)
        for fragment in fragments:
            self.assertIn(fragment, done.stderr)
        return done.stderr


def main():
    unittest.main(verbosity=1)
