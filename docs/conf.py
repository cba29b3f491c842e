"""The site: pages, and the reference of the public headers. `make docs` calls it."""
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
OUT = pathlib.Path(os.environ["MINKSUM_DOCS"])
sys.path.insert(0, str(ROOT / "docs"))

project = "minksum"
version = release = re.search(r'MINKSUM_VERSION "(.*)"',
                              (ROOT / "include/minksum/version.hpp").read_text()).group(1)
copyright = ""
root_doc = "README"
extensions = ["myst_parser", "reference"]  # reference.py beside this file
include_patterns = ["*.md", "docs/*.md", "js/README.md", "include/**/*.hpp", "include/*.h"]
exclude_patterns = ["include/minksum/detail", "build*"]
source_suffix = {".md": "markdown", ".hpp": "restructuredtext", ".h": "restructuredtext"}
reference_xml = str(OUT / "xml")

myst_heading_anchors = 6
nitpick_ignore_regex = [("c:identifier", r"u?int(32|64)_t|size_t"),
                        ("cpp:identifier", r"GEOS\w+|(minksum::)?detail.*|minksum")]

smartquotes = False  # "1/3" in prose is what a program prints
html_theme = "furo"
html_static_path = ["site.css"]
html_css_files = ["site.css"]
pygments_dark_style = "github-dark"
html_title = f"minksum {release}"
html_show_sourcelink = html_show_copyright = html_copy_source = False
toc_object_entries_show_parents = "hide"
maximum_signature_line_length = 80


def add_contents(app, docname, source):
    """The pages that a table of a page lists in its first column are below it in the menu."""
    if docname not in (root_doc, "docs/reference"):
        return
    below = re.findall(r"^\| \[[^]]*\]\(([^)#]+)\.\w+\)", source[0], re.M)
    if docname == root_doc:
        below += ["js/README", "CHANGELOG"]
    source[0] += "\n".join(["", "```{toctree}", ":hidden:", "", *below, "```", ""])


def add_index(app, exception):
    """Who opens the folder is led to the first page."""
    (pathlib.Path(app.outdir) / "index.html").write_text(
        f'<!doctype html><meta http-equiv="refresh" content="0; url={root_doc}.html">\n'
        f'<a href="{root_doc}.html">minksum</a>\n')


def setup(app):
    app.connect("source-read", add_contents)
    app.connect("build-finished", add_index)
