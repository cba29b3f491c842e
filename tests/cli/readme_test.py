"""Tests that the README's examples work as they stand: cuts out its blocks and runs them."""
import os
import pathlib
import re
import subprocess

from support import PROGRAM, SOURCE, ProgramTest, main


class Readme(ProgramTest):
    def setUp(self):
        super().setUp()
        text = (SOURCE / "README.md").read_text()
        self.blocks = re.findall(r"^```(\w+)\n(.*?)^```$", text, re.M | re.S)
        # The commands must work as if they were typed in a clone after `make build`.
        build = pathlib.Path(PROGRAM).resolve().parent
        for name, target in (("build", build), ("include", SOURCE / "include"),
                             ("examples", SOURCE / "examples")):
            (self.folder / name).symlink_to(target)

    def test_blocks(self):
        """Each block of commands prints the block of text that comes after it."""
        # The last two are for Python; the tests of its package run the second.
        self.assertEqual([kind for kind, _ in self.blocks],
                         ["sh", "text", "cpp", "sh", "text", "console", "python"])
        texts = [text for _, text in self.blocks]
        compiler = os.environ.get("MINKSUM_CXX", "c++") + " " + os.environ.get("MINKSUM_CXXFLAGS", "")
        self.assertTrue(texts[3].startswith("c++ "))
        (self.folder / "room.cpp").write_text(texts[2])
        for script, expected in ((texts[0], texts[1]),
                                 (compiler + texts[3].removeprefix("c++"), texts[4])):
            done = subprocess.run(["sh", "-eu"], input=script, capture_output=True, text=True,
                                  cwd=self.folder, timeout=240, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(done.stdout, expected)
        self.assertTrue((self.folder / "grown.svg").exists())

    def test_commands_of_make(self):
        makefile = (SOURCE / "Makefile").read_text()
        for target in re.findall(r"\bmake ([a-z-]+)", (SOURCE / "README.md").read_text()):
            self.assertRegex(makefile, rf"(?m)^{target}:")


if __name__ == "__main__":
    main()
