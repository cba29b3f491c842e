"""A Sphinx extension: public headers become pages, from the XML that Doxygen makes of them.

Each header is a source of the site, so links to it in pages lead to its page. Names stand in the
header's order. Every public name must have documentation: its lack is a warning, which `make docs`
makes an error. Code in prose that is a public name becomes a link.
"""
import pathlib
import re
import xml.etree.ElementTree as ElementTree

from docutils import nodes
from sphinx import addnodes
from sphinx.util import logging

log = logging.getLogger(__name__)
INCLUDE = pathlib.Path(__file__).resolve().parent.parent / "include"
# What names a type or a member without being marked as code.
NAME = re.compile(r"Error\((k\w+)\)|\b[A-Z][a-z]+(?:[A-Z][a-z]+)+(?:::\w+)*|\b[A-Z]\w+::\w+"
                  r"|(?<=see )[A-Z]\w+|\b(?:minksum|MINKSUM)_\w+\b(?!\.h)"
                  r"|\bk[A-Z][a-z]\w+|\b(?:\w+/)*\w+\.(?:hpp|md)\b")
# Between words and markup that touch; what stands for it in reStructuredText depends on both.
GAP = "\0"
SCOPES = ["minksum", "minksum::io", "minksum::adaptors"]
# Made from nothing, copied, moved, destroyed, deleted: the declaration of such a member says all.
SPECIAL = r"~.*|{0}\(\).*|(operator=|{0})\((const )?{0} ?&&?\).*|.*= ?delete"


class Reference:
    """What Doxygen found: a compound for each class and each header, by its id."""

    def __init__(self, folder):
        self.compounds = {}
        self.names = {}  # qualified names, and their domains
        self.enumerators = {}  # what only one enumeration has, and nothing for others
        for path in pathlib.Path(folder).glob("*.xml"):
            for compound in ElementTree.parse(path).getroot().iter("compounddef"):
                self.compounds[compound.get("id")] = compound
        self.namespaces = [compound for compound in self.compounds.values()
                           if compound.get("kind") == "namespace"]
        self.headers = {compound.find("location").get("file"): compound
                        for compound in self.compounds.values() if compound.get("kind") == "file"}
        for name, header in self.headers.items():
            domain = "c" if name.endswith(".h") else "cpp"
            for _, node in self.members(header):
                self.add_names(node, domain)

    def members(self, compound):
        """What a header or a class declares for users, with its line; sorted by that."""
        file = compound.find("location").get("file")
        of_header = compound.get("kind") == "file"
        # Doxygen lists a part of a header's names with the header, and all with their namespaces.
        lists = [compound, *(self.namespaces if of_header else [])]
        found = {node.get("id"): node for each in lists for node in each.iter("memberdef")}
        for each in lists:
            for inner in each.findall("innerclass"):
                node = self.compounds[inner.get("refid")]
                outer = node.findtext("compoundname").rpartition("::")[0]
                if inner.get("prot") == "public" and outer == each.findtext("compoundname") or (
                        of_header and not outer):
                    found[node.get("id")] = node
        return sorted(((int(node.find("location").get("line")), node) for node in found.values()
                       if node.find("location").get("file") == file and is_public(node)),
                      key=lambda entry: (entry[0], entry[1].get("kind") == "typedef"))

    def add_names(self, node, domain):
        name = qualified(node)
        self.names.setdefault(name, domain)
        for value in node.findall("enumvalue"):
            inner = value.findtext("name")
            full = inner if domain == "c" else f"{name}::{inner}"
            self.names[full] = domain
            self.enumerators[inner] = full if self.enumerators.get(inner, full) == full else ""
        if node.tag == "compounddef":
            for _, member in self.members(node):
                self.add_names(member, domain)

    def find(self, text, scope, location):
        """The role and the qualified name of what code in prose names, seen from a scope."""
        name = re.fullmatch(r"([A-Za-z_]\w*(?:::~?\w+)*)(\(\))?", text)
        if not name:
            return None
        name = name.group(1)
        parts = scope.split("::") if scope else []
        for outer in ["::".join(parts[:i]) for i in range(len(parts), 0, -1)] + SCOPES + [""]:
            full = f"{outer}::{name}" if outer else name
            if full in self.names:
                if self.names[full] == "c":
                    return ("c", "type"), full.replace("::", ".")
                return ("cpp", "any"), full
        if self.enumerators.get(name):
            return ("cpp", "any"), self.enumerators[name]
        first = name.removeprefix("minksum::").partition("::")[0]
        if "::" in name and any(f"{outer}::{first}" in self.names for outer in SCOPES):
            log.warning("there is no %s", name, location=location)
        return None


def is_public(node):
    """Whether users may use it. A State is the library's own, and so is what gives it."""
    kind_of = flat(node.find("type"))
    return (node.get("prot", "public") == "public" and not kind_of.endswith("State &")
            and not (node.get("kind") == "friend" and "class" in kind_of.split()))


def qualified(node):
    return (node.findtext("qualifiedname") or node.findtext("compoundname")
            or node.findtext("name"))


class Prose:
    """A text of a comment, as reStructuredText."""

    def __init__(self, reference, scope, location):
        self.reference = reference
        self.scope = scope
        self.location = location

    def words(self, text):
        """Plain words, with links where they are names."""
        parts, end = [], 0
        for found in NAME.finditer(text or ""):
            name = f"ErrorCode::{found.group(1)}" if found.group(1) else found.group()
            parts += [escape(text[end:found.start()]), self.link(found.group(), name)
                      or escape(found.group())]
            end = found.end()
        return "".join(parts) + escape((text or "")[end:])

    def link(self, text, name):
        if name.endswith((".hpp", ".md")):
            return self.page(text)
        target = self.reference.find(name, self.scope, self.location)
        return target and f"{GAP}:{':'.join(target[0])}:`{escape(text)} <{target[1]}>`{GAP}"

    def page(self, path):
        """A link to the page of a header, or to another page."""
        if path.endswith(".md"):
            return f"{GAP}:doc:`{escape(path)} </{path.removesuffix('.md')}>`{GAP}"
        found = [name for name in self.reference.headers if f"/{name}".endswith(f"/{path}")]
        return found and (f"{GAP}:doc:`{escape(path)} </include/{found[0].removesuffix('.hpp')}>`"
                          f"{GAP}")

    def inline(self, node):
        return self.words(node.text) + "".join(self.element(child) + self.words(child.tail)
                                               for child in node)

    def element(self, node):
        text = "".join(node.itertext())
        if node.tag == "computeroutput":
            return self.link(text, text) or f"{GAP}``{text}``{GAP}"
        if node.tag in ("emphasis", "bold"):
            mark = "*" if node.tag == "emphasis" else "**"
            return f"{GAP}{mark}{escape(text)}{mark}{GAP}"
        if node.tag in ("ref", "ulink"):
            return self.inline(node)
        log.warning("docs/reference.py does not know <%s> of a comment", node.tag,
                    location=self.location)
        return escape(text)

    def blocks(self, node):
        """Paragraphs, lists and code in a description or an item of a list, as lists of lines."""
        for para in node.findall("para"):
            line = self.words(para.text)
            for child in para:
                if child.tag in ("itemizedlist", "orderedlist", "preformatted", "verbatim",
                                 "programlisting"):
                    yield from paragraph(line)
                    line = self.words(child.tail)
                    yield from self.block(child)
                else:
                    line += self.element(child) + self.words(child.tail)
            yield from paragraph(line)

    def block(self, node):
        if node.tag in ("itemizedlist", "orderedlist"):
            mark = "- " if node.tag == "itemizedlist" else "#. "
            for item in node.findall("listitem"):
                lines = [line for block in self.blocks(item) for line in [*block, ""]]
                yield [(mark if i == 0 else " " * len(mark)) + line if line else ""
                       for i, line in enumerate(lines[:-1])]
        else:
            for space in node.iter("sp"):  # Doxygen's word for a blank in code
                space.text = " "
            lines = "".join(node.itertext()).strip("\n").split("\n")
            yield [".. code-block:: text", "", *("   " + line for line in lines)]

    def of(self, node):
        """All that is said about a name."""
        lines = []
        for part in ("briefdescription", "detaileddescription"):
            description = node.find(part)
            if description is not None:
                lines += [line for block in self.blocks(description) for line in [*block, ""]]
        return lines


def escape(text):
    return re.sub(r"([\\*`|_<>])", r"\\\1", text)


def paragraph(line):
    """A block of one line; none if nothing is said."""
    line = " ".join(line.split())
    line = re.sub(rf"(?<![^ ]){GAP}|{GAP}(?![^ ])", "", line).replace(GAP, r"\ ")
    # What would begin a list is a word here, and two colons are two colons.
    line = re.sub(r"^([-+]|\(?\w+[.)]) ", r"\\ \g<0>", re.sub("::$", r":\:", line))
    return [[line]] if line else []


class Page:
    """The page of a header, as reStructuredText."""

    def __init__(self, reference, name, docname, text):
        self.reference = reference
        self.docname = docname
        self.domain = "c" if name.endswith(".h") else "cpp"
        self.lines = []
        header = reference.headers[name]
        title = name.rpartition("/")[2]
        lead = " ".join(re.match(r"(// .*\n)*", text).group().replace("// ", "").split("\n"))
        self.add(0, [title, "=" * len(title), "", f"``#include <{name}>``", "",
                     *sum(paragraph(Prose(reference, "", (docname, 1)).words(lead)), []), "",
                     *self.text(header, "")])
        # Comments that divide a header divide its page.
        self.dividers = [(number, found.group(1)) for number, line in
                         enumerate(text.split("\n"), 1)
                         if (found := re.match(r"\s*/[/*] -- (.*?)\.? -{3,}", line))]
        self.write(0, reference.members(header), "")

    def add(self, depth, lines):
        self.lines += ["   " * depth + line if line else "" for line in lines]

    def write(self, depth, members, scope):
        namespace, done = "", set()
        for line, node in members:
            while self.dividers and self.dividers[0][0] < line:
                title = escape(self.dividers.pop(0)[1])
                self.add(depth, [f".. rubric:: {title}", ""] if depth else
                         [title, "-" * len(title), ""])
            name = qualified(node)
            outer = name.rpartition("::")[0]
            if depth == 0 and self.domain == "cpp" and outer != namespace:
                namespace = outer
                self.add(0, [f".. cpp:namespace:: {namespace}", ""])
            # In C a type may have a name twice: struct name, and name.
            if self.domain == "c" and name in done:
                continue
            done.add(name)
            if not self.is_special(node, scope):
                self.describe(depth, node, scope)

    def is_special(self, node, scope):
        """Whether it is left out, as nothing is said about it and nothing need be."""
        declaration = (node.findtext("name") or "") + (node.findtext("argsstring") or "")
        return (node.get("kind") == "function" and not self.text(node, "")
                and re.fullmatch(SPECIAL.format(scope.rpartition("::")[2]), declaration))

    def text(self, node, scope, of=None):
        line = int((of or node).find("location").get("line", 1))
        return Prose(self.reference, scope, (self.docname, line)).of(node)

    def describe(self, depth, node, scope):
        kind, declaration = declare(node, self.domain)
        name = qualified(node)
        text = self.text(node, name if node.tag == "compounddef" else scope)
        self.require(node, name, text)
        domain = "c" if kind == "macro" else self.domain
        self.add(depth, [f".. {domain}:{kind}:: {declaration}", ""])
        self.add(depth + 1, text)
        for value in node.findall("enumvalue"):
            said = self.text(value, name, node)
            self.require(node, f"{name}::{value.findtext('name')}", said)
            self.add(depth + 1, [f".. {self.domain}:enumerator:: {value.findtext('name')}"
                                 + with_space(value.findtext("initializer")), ""])
            self.add(depth + 2, said)
        if node.tag == "compounddef":
            self.write(depth + 1, self.reference.members(node), name)

    def require(self, node, name, text):
        if not text:
            line = node.find("location").get("line")
            log.warning("%s has no documentation", name, type="reference", subtype="undocumented",
                        location=(self.docname, int(line)))


def with_space(text):
    return f" {text}" if text else ""


def flat(node):
    return " ".join("".join(node.itertext()).split()) if node is not None else ""


def template(node):
    parameters = node.find("templateparamlist")
    if parameters is None:
        return ""
    return "template<" + ", ".join(
        (flat(p.find("type")) + with_space(p.findtext("declname"))).strip()
        for p in parameters.findall("param")) + "> "


def declare(node, domain):
    """The directive of a name, and its declaration."""
    kind = node.get("kind")
    name = node.findtext("name") or node.findtext("compoundname").rpartition("::")[2]
    kind_of = flat(node.find("type"))
    arguments = node.findtext("argsstring") or ""
    initializer = flat(node.find("initializer"))
    if kind in ("class", "struct"):
        bases = ", ".join(f"{base.get('prot')} {flat(base)}"
                          for base in node.findall("basecompoundref"))
        return kind, template(node) + name + (f" : {bases}" if bases else "")
    if kind == "enum":
        strong = "enum-class" if node.get("strong") == "yes" else "enum"
        return strong, name
    if kind == "define":
        parameters = ", ".join(p.findtext("defname") for p in node.findall("param"))
        return "macro", name + (f"({parameters})" if parameters else "")
    if kind == "typedef" and domain == "c":
        return "type", f"{kind_of} {name}{arguments}" if not kind_of.startswith("struct") else name
    if kind == "typedef":
        return "type", f"{template(node)}{name} = {kind_of}"
    static = "static " if node.get("static") == "yes" else ""
    if kind == "variable":
        if initializer and not initializer.startswith("="):
            initializer = f"= {initializer}"
        function = "(" in kind_of and arguments.startswith(")")
        declarator = f"{kind_of}{name}" if function else f"{kind_of} {name}"
        static = "" if "static" in kind_of.split() else static
        return ("member" if domain == "c" else "var",
                f"{static}{declarator}{arguments}{with_space(initializer)}")
    friend = "friend " if kind == "friend" else ""
    explicit = "explicit " if node.get("explicit") == "yes" else ""
    kind_of = kind_of.removeprefix("friend ").replace("static ", "")
    arguments = re.sub(r"\s*=\s*(default|delete)$", r" = \1", arguments)
    return "function", (f"{template(node)}{friend}{static}{explicit}{kind_of} "
                        f"{name}{arguments}").replace("  ", " ")


def read_header(app, docname, source):
    """A header's text becomes its page."""
    path = pathlib.Path(app.env.doc2path(docname))
    if path.is_relative_to(INCLUDE):
        page = Page(app.reference, path.relative_to(INCLUDE).as_posix(), docname, source[0])
        source[0] = "\n".join(page.lines)


def link_names(app, doctree):
    """In pages, code that can only be a name of the library becomes a link."""
    docname = app.env.docname
    if docname.startswith("include/"):
        return
    for literal in list(doctree.findall(nodes.literal)):
        text = literal.astext()
        plain = re.fullmatch(r"[a-z]+(\(\))?", text)
        target = None if plain or docname == "CHANGELOG" else app.reference.find(text, "", literal)
        if target and not isinstance(literal.parent, (nodes.reference, addnodes.pending_xref)):
            (domain, kind), name = target
            link = addnodes.pending_xref("", refdomain=domain, reftype=kind, reftarget=name,
                                         refdoc=docname, refexplicit=True, refwarn=True)
            literal.replace_self(link)
            link += literal


def setup(app):
    app.add_config_value("reference_xml", "", "env")
    app.connect("builder-inited", lambda app: setattr(app, "reference",
                                                      Reference(app.config.reference_xml)))
    app.connect("source-read", read_header)
    app.connect("doctree-read", link_names)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
