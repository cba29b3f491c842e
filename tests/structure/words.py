"""Prints each identifier and heading that goes against docs/glossary.md.

    words.py ROOT    exits with 1 if there is one
"""
import pathlib
import re
import sys

# Words that mean something else or say nothing, each with what to say instead.
WORDS = {
    r"\w*[Ii]llegal\w*": "invalid",
    r"\w*(?:Legal|(?<![a-zA-Z])legal)\w*": "valid",
    r"settle\w*|\w*Settle\w*": "what is decided or converted",
    r"\w*Shell\w*": "outer ring",
    r"Typed[A-Z]\w*": "...Text: options as text",
    r"Places?|Placement|PlaceOnLine|RingPlace": "what place it is: ExactLocation, PlacedOperand, ...",
    r"Given|GivenOperand": "CallerOperand",
    r"Nesting(Options|Arguments)|make_nesting|nesting_": "NoFit...: nesting is a filter",
    r"CoverLeaf": "QuadtreeLeaf",
}
COMMENT = re.compile(r"//.*|\"(?:[^\"\\\n]|\\.)*\"")
HEADING = re.compile(r"^#+ .*", re.M)


def texts(root):
    """Yields (place, text) of each heading and line of code, without comments and literals."""
    for folder in ["src", "include", "cli", "c", "tests"]:
        for path in sorted((root / folder).rglob("*.?pp")):
            for i, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                yield f"{path.relative_to(root)}:{i}", COMMENT.sub("", line)
    for path in [*sorted((root / "docs").glob("*.md")), *sorted(root.glob("*.md"))]:
        if path.name == "glossary.md":
            continue
        for heading in HEADING.findall(path.read_text(encoding="utf-8")):
            yield str(path.relative_to(root)), heading


def main(root):
    found = 0
    for place, text in texts(pathlib.Path(root)):
        for word, instead in WORDS.items():
            for match in re.finditer(rf"(?<!\w)(?:{word})(?!\w)", text):
                print(f"{place}: {match.group(0)}: say {instead}")
                found += 1
    return 1 if found else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
