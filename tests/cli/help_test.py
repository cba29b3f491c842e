"""Tests help, man pages, completions, and what the program says beside results."""
import os
import pty
import re
import shutil
import signal
import subprocess
import time

from support import FRAME, PROGRAM, SQUARE, ProgramTest, main, run

BOWTIE = "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))"


def options_in(text):
    """Returns the options that a help text lists, with all their names."""
    rows = re.findall(r"^  (-[^ ].*)$", text, re.M)
    return [re.findall(r"(?:^|, )(-[-\w]+)", row.split("  ")[0]) for row in rows]


class Help(ProgramTest):
    def commands(self):
        listed = self.fine("--help").split("\nCommands:\n")[1].split("\n\n")[0]
        return re.findall(r"^  (\w+) ", listed, re.M)

    def test_help_of_commands(self):
        self.assertEqual(self.fine("help"), self.fine("--help"))
        self.assertIn("sum", self.commands())
        for command in self.commands():
            text = self.fine("help", command)
            self.assertEqual(text, self.fine(command, "--help"))
            self.assertIn(f"Usage: minksum {command} [OPTIONS]", text)
            self.assertIn("Exit codes: 0 fine", text)
            for line in text.splitlines():
                self.assertLessEqual(len(line), 80, line)
        self.assertEqual(self.fine("help", "SUM"), self.fine("help", "sum"))

    def test_shared_options(self):
        """Each subcommand but help has these; those that compute sums have the others, too."""
        for command in self.commands():
            names = {name for row in options_in(self.fine("help", command)) for name in row}
            if command == "help":
                continue
            self.assertLessEqual({"-h", "--help", "-v", "--verbose", "-q", "--quiet", "--progress",
                                  "--timeout", "--max-memory", "--max-bytes", "--max-vertices"},
                                 names, command)
            if "--max-segments" in names:
                self.assertIn("--threads", names, command)

    def test_man_pages_and_completions_agree_with_help(self):
        self.fine("help", "--install", self.folder / "share")
        share = self.folder / "share"
        bash = (share / "bash-completion/completions/minksum").read_text()
        zsh = (share / "zsh/site-functions/_minksum").read_text()
        fish = (share / "fish/vendor_completions.d/minksum.fish").read_text()
        for name, text in (("bash", bash), ("zsh", zsh), ("fish", fish)):
            self.assertEqual(text, self.fine("help", "--completion", name))
        pages = {page.name for page in (share / "man/man1").iterdir()}
        self.assertEqual(pages, {"minksum.1"} | {f"minksum-{c}.1" for c in self.commands()})
        main_page = (share / "man/man1/minksum.1").read_text()
        for command in self.commands():
            self.assertIn(f"\\fB{command}\\fR", main_page)
            page = (share / f"man/man1/minksum-{command}.1").read_text()
            self.assertEqual(page, self.fine("help", command, "--man"))
            of_bash = bash.split(f"\n_minksum_{command}() {{")[1].split("\n}\n")[0]
            of_zsh = zsh.split(f"\n  {command}) options=(")[1].split("\n  ) ;;\n")[0]
            of_fish = [line for line in fish.splitlines()
                       if f"'__fish_seen_subcommand_from {command}'" in line]
            rows = options_in(self.fine("help", command))
            self.assertGreater(len(rows), 3)
            self.assertEqual(len(rows), len([line for line in of_fish if " -d " in line]))
            self.assertEqual(len(rows), len(re.findall(r"^\.TP\n\\fB\\-", page, re.M)))
            for row in rows:
                escaped = [name.replace("-", "\\-") for name in row]
                self.assertIn(", ".join(f"\\fB{name}\\fR" for name in escaped), page)
                for name in row:
                    self.assertRegex(of_bash, rf"['| ]{name}['| )]")
                    self.assertRegex(of_zsh, rf"[)*]{name}[=+\[]")
                    short = f" -l {name[2:]} " if name.startswith("--") else f" -s {name[1:]} "
                    self.assertTrue(any(short in line + " " for line in of_fish), name)

    def test_man_pages_render(self):
        tools = [tool for tool in ("mandoc", "groff") if shutil.which(tool)]
        if not tools:
            self.skipTest("neither mandoc nor groff is there")
        self.fine("help", "--install", self.folder)
        for page in sorted((self.folder / "man/man1").iterdir()):
            if "mandoc" in tools:
                done = subprocess.run(["mandoc", "-Tlint", "-Wwarning", page], text=True,
                                      capture_output=True, check=False)
                # The pages have no date, so that the same program always makes the same pages.
                faults = [line for line in done.stdout.splitlines() if "missing date" not in line]
                self.assertEqual(faults, [])
            if "groff" in tools:
                done = subprocess.run(["groff", "-ww", "-z", "-K", "utf8", "-man", "-Tutf8", page],
                                      text=True, capture_output=True, check=False)
                missing_macros = "an.tmac" in done.stderr
                self.assertTrue(done.stderr == "" or missing_macros, done.stderr)

    def complete(self, *words):
        """Returns what bash offers for the last word."""
        script = self.folder / "minksum.bash"
        script.write_text(self.fine("help", "--completion", "bash"))
        quoted = " ".join(f"'{word}'" for word in words)
        done = subprocess.run(
            ["bash", "-euc", f"source {script}; COMP_WORDS=({quoted}); "
             f"COMP_CWORD={len(words) - 1}; _minksum; printf '%s\\n' \"${{COMPREPLY[@]}}\""],
            capture_output=True, text=True, check=False, cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return sorted(done.stdout.split())

    def test_bash_completion(self):
        if not shutil.which("bash"):
            self.skipTest("bash is not there")
        (self.folder / "shapes").mkdir()
        self.file("shape.wkt", SQUARE)
        self.assertEqual(self.complete("minksum", "off"), ["offset"])
        self.assertEqual(sorted(self.commands()), self.complete("minksum", ""))
        self.assertEqual(self.complete("minksum", "sum", "--form"), ["--format"])
        for words in (("--format", "w"), ("--format", "=", "w"), ("--format", "=")):
            self.assertIn("wkt", self.complete("minksum", "sum", *words))
        self.assertEqual(self.complete("minksum", "sum", "sha"), ["shape.wkt", "shapes"])
        self.assertEqual(self.complete("minksum", "sum", "--trace", "sha"), ["shapes"])
        self.assertEqual(self.complete("minksum", "help", "of"), ["offset"])

    def test_zsh_completion(self):
        if not shutil.which("zsh"):
            self.skipTest("zsh is not there")
        self.fine("help", "--install", self.folder)
        done = subprocess.run(
            ["zsh", "-fc", f"fpath=({self.folder}/zsh/site-functions $fpath); "
             "autoload -U compinit && compinit -D -u && print $_comps[minksum] && "
             f"source {self.folder}/zsh/site-functions/_minksum && print $+functions[_minksum]"],
            capture_output=True, text=True, check=False)
        self.assertEqual((done.stdout, done.stderr), ("_minksum\n1\n", ""))

    def test_fish_completion(self):
        if not shutil.which("fish"):
            self.skipTest("fish is not there")
        self.fine("help", "--install", self.folder)
        script = self.folder / "fish/vendor_completions.d/minksum.fish"
        for line, expected in (("minksum off", "offset"), ("minksum sum --form", "--format"),
                               ("minksum sum --format wkt", "wkt"), ("minksum help of", "offset")):
            done = subprocess.run(["fish", "-c", f"source {script}; complete -C '{line}'"],
                                  capture_output=True, text=True, check=False,
                                  env={**os.environ, "HOME": str(self.folder)})
            self.assertEqual(done.stdout.split()[0], expected, done.stderr)


class Words(ProgramTest):
    def setUp(self):
        super().setUp()
        self.square = self.file("square.wkt", SQUARE)

    def test_suggestions(self):
        p = self.square
        for words, *arguments in (
                ("there is no command 'summ' (did you mean 'sum'?) (minksum --help)", "summ", p, p),
                ("(did you mean 'offset'?)", "ofset", p),
                ("(did you mean 'info'?)", "help", "inof"),
                ("no option '--tmeout' (did you mean '--timeout'?) (minksum sum --help)", "sum",
                 "--tmeout", "3", p, p),
                ("(did you mean '--timeout'?)", "sum", p, "--time=3", p),
                ("(did you mean '--timeout'?)", "sum", p, "-timeout", "3", p),
                ("(did you mean '--distance'?)", "offset", p, "--distnace", "1"),
                ("(did you mean '--version'?)", "--vesrion"),
                ("(did you mean 'evenodd'?)", "sum", p, p, "--fill", "even-odd"),
                ("(did you mean 'round'?)", "offset", p, "-d", "1", "--join", "rounded")):
            self.fails(1, words, *arguments)
        for arguments in (["zzz"], ["sum", p, p, "--zzzzzz"], ["sum", p, p, "--fill", "zzz"]):
            self.assertNotIn(b"did you mean", self.fails(1, "", *arguments).stderr)

    def test_usage_points_to_help(self):
        p = self.square
        for arguments in ([p], [p, p, p], [p, p, "--threads", "0"], [p, p, "--timeout"], ["-", "-"],
                          [p, p, "--stats", "-"], [p, p, "-o", self.folder / "a.shp"],
                          [p, p, "-o", p, "--svg", p], [p, p, "-=3"], [p, p, "--"] + [p]):
            result = self.fails(1, "", "sum", *arguments)
            self.assertTrue(result.stderr.endswith(b" (minksum sum --help)\n"), result.stderr)
        for arguments in ([], ["--blue"], ["-"], ["--"]):
            result = self.fails(1, "", *arguments)
            self.assertTrue(result.stderr.endswith(b" (minksum --help)\n"), result.stderr)

    def test_any_case_and_both_spellings(self):
        p = self.square
        expected = self.fine("offset", p, "-d", 1, "--join", "miter", "--miter-limit", 1.2,
                             "--coords", "decimal:3", "--format", "geojson")
        self.assertEqual(expected, self.fine("offset", p, "-d", 1, "--join", "Mitre",
                                             "--mitre-limit", 1.2, "--coords", "DECIMAL:3",
                                             "--format", "GeoJSON"))
        self.assertEqual(self.fine("sum", p, p), self.fine("sum", p, p, "--regularise", "--fill",
                                                           "EvenOdd", "--method", "Signed"))
        self.fine("sum", p, p, "-o", self.folder / "SUM.GeoJSON")
        self.assertIn("coordinates", (self.folder / "SUM.GeoJSON").read_text())

    def test_unknown_endings(self):
        """They are refused before any work: the operand is not even read."""
        for name in ("x.shp", "x.png", "x.txt", "x.wkt.gz"):
            for option in ("-o", "--tight"):
                self.fails(1, "there are .geojsons, .json, .ndjson, .geojson, ", "sum", "nowhere.wkt",
                           self.square, option, self.folder / name)
            self.assertFalse((self.folder / name).exists())
            self.fine("sum", self.square, self.square, "--format", "wkt", "-o", self.folder / name)
        for name in ("plain", "/dev/null"):
            self.fine("sum", self.square, self.square, "-o", self.folder / name)


class Telling(ProgramTest):
    def setUp(self):
        super().setUp()
        self.bowtie = self.file("bowtie.wkt", BOWTIE)
        self.frame = self.file("frame.wkt", FRAME)

    def test_quiet(self):
        self.fine("sum", self.bowtie, self.frame, note="edges cross")
        self.fine("sum", self.bowtie, self.frame, "-q")
        self.fails(2, "nowhere", "sum", self.bowtie, "nowhere", "--quiet")

    def test_verbose(self):
        for command in (["erode", self.frame, self.frame], ["info", self.frame],
                        ["draw", self.frame], ["check", self.frame, self.frame, self.frame]):
            told = run(*command, "-v").stderr.decode()
            self.assertIn("frame.wkt: 8 vertices, 1 hole\n", told)
            self.assertRegex(told, r"of processor time, \d+ MB of memory\n")

    def on_terminal(self, *arguments, until=None):
        """Returns what a terminal gets from standard error, or what comes until these bytes."""
        ours, theirs = pty.openpty()
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.DEVNULL,
                                   stderr=theirs)
        os.close(theirs)
        told = b""
        while True:
            try:
                part = os.read(ours, 4096)
            except OSError:  # Linux says so when the other end is closed
                break
            told += part
            if not part or (until and until in told):
                break
        os.close(ours)
        if until:
            process.kill()
        self.assertEqual(process.wait(), -signal.SIGKILL if until else 0)
        return told

    def test_progress(self):
        told = self.on_terminal("sum", self.frame, self.frame, "--progress")
        self.assertRegex(told, rb"^\r0 s  [a-z]+\x1b\[K")
        self.assertTrue(told.endswith(b"\r\x1b[K"))  # nothing of it stays
        self.assertEqual(self.on_terminal("sum", self.frame, self.frame, "--progress", "-q"), b"")

    def test_progress_of_long_runs(self):
        long = ["cspace", self.frame, self.frame, "--angles", 500_000, "-o", "/dev/null"]
        begin = time.monotonic()
        told = self.on_terminal(*long, until=b" of 500000  ")
        self.assertGreaterEqual(time.monotonic() - begin, 1)
        self.assertRegex(told, rb"\r\[#* *\] \d+ %  [1-9]\d* s  \d+ of 500000  ")
        # Whoever is not at a terminal sees nothing.
        process = subprocess.Popen([PROGRAM, *map(str, long)], stderr=subprocess.PIPE)
        time.sleep(1.5)
        process.terminate()
        self.assertEqual(process.stderr.read(), b"minksum: interrupted: no output was changed\n")
        process.stderr.close()
        self.assertEqual(process.wait(), -signal.SIGTERM)


if __name__ == "__main__":
    main()
