"""The README's examples work as they stand: its blocks are cut out and run."""
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
        # As if the commands were typed in a clone after `make build`.
        build = pathlib.Path(PROGRAM).resolve().parent
        for name, target in (("build", build), ("include", SOURCE / "include"),
                             ("examples", SOURCE / "examples")):
            (self.folder / name).symlink_to(target)

    def block(self, language, index=0):
        return [text for kind, text in self.blocks if kind == language][index]

    def shell(self, script):
        done = subprocess.run(["sh", "-eu"], input=script, capture_output=True, text=True,
                              cwd=self.folder, timeout=240, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_shell(self):
        output = self.shell(self.block("sh"))
        self.assertEqual(output.splitlines()[0] + "\n", self.block("text"))
        for made in ("grown.geojson", "grown.svg", "grown-stats.json", "stages/7-result.svg"):
            self.assertTrue((self.folder / made).exists(), made)

    def test_cpp(self):
        (self.folder / "room.cpp").write_text(self.block("cpp"))
        compiler = os.environ.get("MINKSUM_CXX", "c++") + " " + os.environ.get("MINKSUM_CXXFLAGS", "")
        script = self.block("sh", 1)
        self.assertTrue(script.startswith("c++ "))
        output = self.shell(compiler + script.removeprefix("c++"))
        self.assertIn("19/2 10 known\n", output)
        self.assertEqual(len(output.splitlines()), 10)

    def test_links(self):
        text = (SOURCE / "README.md").read_text()
        for target in re.findall(r"\]\((?!http)([^)#]+)\)", text):
            self.assertTrue((SOURCE / target).exists(), target)


if __name__ == "__main__":
    main()
