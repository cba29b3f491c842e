"""Pages without a subcommand of their own: their examples print what they show; all links lead on."""
import re

from support import SOURCE, Page, ProgramTest, main


class Glossary(Page, ProgramTest):
    page_name = "glossary.md"


def pages():
    """Everything that a reader of the project may follow a link from."""
    return [SOURCE / "README.md", SOURCE / "CONTRIBUTING.md", SOURCE / "CHANGELOG.md",
            *sorted((SOURCE / "docs").glob("*.md"))]


def anchors(page):
    """What a link into the page may name: its headings, as GitHub makes anchors of them."""
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
