"""Tests that docs/sql.md is right: blocks of SQL and of commands run in their order, print the text
below them (or nothing), and draw the page's pictures.

If MINKSUM_WRITE_PAGE is set, it prints the page and its pictures as they should be, instead.
"""
import os
import pathlib
import re
import subprocess
import sys

from support import DatabaseTest, main

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "sql.md"
BLOCK = re.compile(r"^```(sql|sh)\n(.*?)^```$\n(?:\n^```text\n(.*?)^```$\n)?", re.M | re.S)
PSQL = ["psql", "-X", "-A", "-t", "-q"]


def run(language, text, database):
    command = [*PSQL, database] if language == "sql" else ["sh", "-eu"]
    done = subprocess.run(command, input=text, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, timeout=120, check=False,
                          env={**os.environ, "PGDATABASE": database}, cwd=ROOT)
    return done.stdout


class PageTest(DatabaseTest):
    extensions = []

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (ROOT / "build").mkdir(exist_ok=True)
        (ROOT / "build" / "minksum").symlink_to(os.environ["MINKSUM_PROGRAM"])

    def test_blocks_and_pictures(self):
        page = PAGE.read_text(encoding="utf-8")
        pictures = {name: (ROOT / "docs" / name).read_text(encoding="utf-8")
                    for name in re.findall(r"\]\((img/[^)]+)\)", page)}
        for name in pictures:
            (ROOT / "docs" / name).unlink()
        blocks = list(BLOCK.finditer(page))
        self.assertEqual(len(blocks), len(re.findall(r"^```(?:sql|sh)$", page, re.M)))
        for block in blocks:
            self.assertEqual(run(block[1], block[2], self.database), block[3] or "", block[2])
        self.assertGreaterEqual(len(pictures), 10)
        for name, expected in pictures.items():
            self.assertEqual((ROOT / "docs" / name).read_text(encoding="utf-8"), expected, name)


def write():
    """Writes the page anew."""
    database = "minksum_page"
    subprocess.run(["createdb", database], check=True)
    (ROOT / "build").mkdir(exist_ok=True)
    (ROOT / "build" / "minksum").symlink_to(os.environ["MINKSUM_PROGRAM"])

    def filled(block):
        printed = run(block[1], block[2], database)
        shown = f"\n```text\n{printed}```\n" if printed else ""
        return f"```{block[1]}\n{block[2]}```\n{shown}"

    print(BLOCK.sub(filled, PAGE.read_text(encoding="utf-8")), end="")
    sys.stdout.flush()
    for name in sorted((ROOT / "docs" / "img").glob("*.svg")):
        print(f"<<<{name.name}", name.read_text(encoding="utf-8"), sep="\n", end="")


if __name__ == "__main__":
    if os.environ.get("MINKSUM_WRITE_PAGE"):
        write()
    else:
        main()
