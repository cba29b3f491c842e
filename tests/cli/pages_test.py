"""Tests that examples of pages without a subcommand print what they show, and that links work."""
import os
import pathlib
import re
import subprocess

from support import PROGRAM, SOURCE, Page, ProgramTest, main


def compiler():
    """Returns the compiler of the tree, with its flags."""
    return [*os.environ.get("MINKSUM_CXX", "c++").split(),
            *os.environ.get("MINKSUM_CXXFLAGS", "").split()]


def built(*names):
    """Returns libraries of the tree that was built."""
    return [pathlib.Path(PROGRAM).resolve().parent / name for name in names]


class Adaptors(ProgramTest):
    """Each program of adaptors.md prints the block below it, if its library is available."""

    CLIPPER2 = """\
        #include <cstdint>
        #include <vector>
        namespace Clipper2Lib {
        struct Point64 { std::int64_t x, y; };
        using Paths64 = std::vector<std::vector<Point64>>;
        }"""

    def run_example(self, header, *options):
        page = (SOURCE / "docs" / "adaptors.md").read_text()
        examples = dict(re.findall(r"^```cpp\n(.*?)^```$\n\n^```text\n(.*?)^```$", page,
                                   re.M | re.S))
        self.assertEqual(len(examples), page.count("```cpp"))
        code, expected = next(pair for pair in examples.items()
                              if pair[0].startswith(f"#include <{header}>"))
        program = self.folder / "app.cpp"
        program.write_text(code)
        there = subprocess.run([*compiler(), "-std=c++20", "-E", "-x", "c++", "-"],
                               input=f"#include <{header}>\n", capture_output=True, text=True,
                               check=False)
        if there.returncode and header != "clipper2/clipper.h":
            self.skipTest(f"{header} is not there")
        subprocess.run([*compiler(), "-std=c++20", f"-I{SOURCE / 'include'}",
                        f"-I{self.folder}", program, *built("src/libminksum.a"), *options,
                        "-o", self.folder / "app"], check=True)
        done = subprocess.run([self.folder / "app"], capture_output=True, text=True, timeout=60,
                              check=True)
        self.assertEqual(done.stdout, expected)

    def test_boost_geometry(self):
        self.run_example("boost/geometry.hpp", "-DBOOST_ALLOW_DEPRECATED_HEADERS")

    def test_geos(self):
        self.run_example("geos_c.h", "-lgeos_c")

    def test_clipper2(self):
        """Types of the same shape replace Clipper2's."""
        (self.folder / "clipper2").mkdir()
        (self.folder / "clipper2" / "clipper.h").write_text(self.CLIPPER2)
        self.run_example("clipper2/clipper.h")

    def test_cgal(self):
        self.run_example("CGAL/Exact_predicates_exact_constructions_kernel.h", "-frounding-math",
                         "-lmpfr", "-lgmp")


class CommandLine(Page, ProgramTest):
    page_name = "cli.md"


class Concepts(Page, ProgramTest):
    page_name = "concepts.md"


class Formats(Page, ProgramTest):
    page_name = "formats.md"


class Glossary(Page, ProgramTest):
    page_name = "glossary.md"


class Guarantees(Page, ProgramTest):
    page_name = "guarantees.md"


class Install(Page, ProgramTest):
    page_name = "install.md"

    def test_c(self):
        """A compiler for C compiles the example in C, and it is linked as the page says."""
        code, expected = re.search(r"^```c\n(.*?)^```$\n\n^```text\n(.*?)^```$", self.page,
                                   re.M | re.S).groups()
        (self.folder / "app.c").write_text(code)
        subprocess.run(["cc", "-std=c11", "-Wall", "-Wextra", "-Werror", f"-I{SOURCE / 'include'}",
                        "-c", "app.c"], check=True, cwd=self.folder)
        subprocess.run([*compiler(), "app.o", *built("c/libminksum_c.a", "src/io/libminksum_io.a",
                                                     "src/libminksum.a"), "-o", "app"],
                       check=True, cwd=self.folder)
        done = subprocess.run([self.folder / "app"], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, expected)


class Performance(Page, ProgramTest):
    page_name = "performance.md"


class Pipeline(Page, ProgramTest):
    page_name = "pipeline.md"


class Reference(ProgramTest):
    def test_cpp(self):
        """The program prints the block below it; each public header is in a table."""
        page = (SOURCE / "docs" / "reference.md").read_text()
        code, expected = re.search(r"^```cpp\n(.*?)^```$\n\n^```text\n(.*?)^```$", page,
                                   re.M | re.S).groups()
        (self.folder / "app.cpp").write_text(code)
        subprocess.run([*compiler(), "-std=c++20", f"-I{SOURCE / 'include'}", "app.cpp",
                        *built("src/libminksum.a"), "-o", "app"], check=True, cwd=self.folder)
        done = subprocess.run([self.folder / "app"], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, expected)

    def test_headers(self):
        page = (SOURCE / "docs" / "reference.md").read_text()
        headers = {path.relative_to(SOURCE).as_posix()
                   for path in (SOURCE / "include").rglob("*.h*")}
        listed = re.findall(r"^\| \[.*?\]\(\.\./(.*?)\)", page, re.M)
        inner = {name for name in headers if "/detail/" in name or name.endswith("/export.h")}
        self.assertEqual(sorted(listed), sorted(headers - inner))


class Tutorial(Page, ProgramTest):
    page_name = "tutorial.md"

    def test_cpp(self):
        """Each block of C++ prints the block below it. All are compiled at once, as functions; the
        first block is the frame in which a reader puts each of them."""
        frame, *examples = re.findall(r"^```cpp\n(.*?)^```$(?:\n\n^```text\n(.*?)^```$)?",
                                      self.page, re.M | re.S)
        self.assertEqual(len(examples), 10)
        head, rest = frame[0].split("int main() {\n")
        self.assertEqual(rest, "  // The example comes here.\n}\n")
        functions = "".join(f"void example_{i}() {{\n{code}}}\n"
                            for i, (code, _) in enumerate(examples))
        calls = "".join(f'example_{i}();\nstd::cout << "--\\n";\n' for i in range(len(examples)))
        program = self.folder / "app.cpp"
        program.write_text(f"{head}{functions}int main() {{\n{calls}}}\n")
        subprocess.run([*compiler(), "-std=c++20", f"-I{SOURCE / 'include'}", program,
                        *built("src/io/libminksum_io.a", "src/libminksum.a"),
                        "-o", self.folder / "app"], check=True)
        done = subprocess.run([self.folder / "app"], capture_output=True, text=True,
                              cwd=self.folder, timeout=60, check=True)
        self.assertEqual(done.stdout.split("--\n")[:-1], [expected for _, expected in examples])


def pages():
    """Returns all pages from which a reader of the project may follow a link."""
    return [SOURCE / "README.md", SOURCE / "CONTRIBUTING.md", SOURCE / "CHANGELOG.md",
            *sorted((SOURCE / "docs").glob("*.md"))]


def anchors(page):
    """Returns what a link into the page may name: the anchors that GitHub makes of its headings."""
    text = re.sub(r"^```.*?^```$", "", page.read_text(), flags=re.M | re.S)
    found = set()
    for heading in re.findall(r"^#+ (.*)$", text, re.M):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        found.add(re.sub(r"[^\w\- ]", "", words).replace(" ", "-"))
    return found


class Links(ProgramTest):
    def test_files_and_anchors(self):
        for page in pages():
            text = re.sub(r"^```.*?^```$", "", page.read_text(), flags=re.M | re.S)
            for path, anchor in re.findall(r"\]\((?!https?:)([^)#\s]*)#?([^)\s]*)\)", text):
                target = page.parent / path if path else page
                self.assertTrue(target.exists(), f"{page.name}: {path}")
                if anchor:
                    self.assertIn(anchor, anchors(target), f"{page.name}: {path}#{anchor}")


if __name__ == "__main__":
    main()
