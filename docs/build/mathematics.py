"""Formulas of the documents, set when the pages are built: LaTeX in, MathML out.

`$...$` in a line and a fence of kind `math` are what code hosts set too, so the Markdown is read
there as it is. MathML needs neither script nor network nor font. What the converter does not know
stops the build.
"""

from __future__ import annotations

import re
from typing import Any
from xml.etree import ElementTree

from latex2mathml.converter import convert
from markdown import Markdown
from markdown.extensions import Extension
from markdown.inlinepatterns import InlineProcessor

INLINE = r"(?<![\\$\w])\$(?![\s$])((?:[^$\\]|\\.)+?)(?<!\s)\$(?![\w$])"
"""As code hosts read it: no space inside the dollars, no word right outside."""
SPACE = "http://www.w3.org/1998/Math/MathML"
THIN = "0.167em"
MINUS, LONG_BAR, PRIMES = "\N{MINUS SIGN}", "\N{HORIZONTAL BAR}", ("\N{PRIME}", "\N{DOUBLE PRIME}")
ROWS = ("math", "mrow", "msqrt", "mstyle", "mtd")
"""Elements in which any number of things stand side by side."""


class MathematicsError(ValueError):
    """A formula that cannot be set."""


def mathml(latex: str, *, display: bool = False) -> str:
    """A formula as a `math` element, its LaTeX as the text for those who cannot see it.

    Raises MathematicsError for a command that the converter does not know.
    """
    typed = re.sub(r"(\\(?:begin|end)\{)aligned\}", r"\1align*}", latex.strip())
    if typed.count("{") != typed.count("}"):
        raise MathematicsError(f"{latex.strip()}: a brace is not closed")
    try:
        root = ElementTree.fromstring(convert(typed, display="block" if display else "inline"))  # noqa: S314 - our own documents
    except Exception as error:
        raise MathematicsError(f"{latex.strip()}: {error}") from error
    unknown = [node.text for node in root.iter() if "\\" in (node.text or "")]
    if unknown:
        raise MathematicsError(f"{latex.strip()}: unknown {unknown}")
    root.set("display", "block" if display else "inline")
    root.set("alttext", " ".join(latex.split()))
    for node in list(root.iter()):
        _spaced(node)
        _close(node)
        _primed(node)
        _sided(node)
    ElementTree.register_namespace("", SPACE)
    return ElementTree.tostring(root, encoding="unicode")


def _spaced(row: ElementTree.Element) -> None:
    """Put the thin space of printed mathematics around the names of functions, as in 2 cos kψ."""
    if _tag(row) not in ROWS:
        return
    children = list(row)
    shift = 0
    for place, node in enumerate(children):
        if not _named_function(node):
            continue
        before = children[place - 1] if place else None
        after = children[place + 1] if place + 1 < len(children) else None
        _upright(node)
        if before is not None and _tag(before) not in ("mo", "mspace"):
            row.insert(place + shift, _space())
            shift += 1
        if after is not None and not _opening(after):
            row.insert(place + shift + 1, _space())
            shift += 1


def _named_function(node: ElementTree.Element) -> bool:
    head = node if _tag(node) in ("mi", "mo") else next(iter(node), None)
    scripts = ("mi", "mo", "msub", "msup", "msubsup")
    return (
        _tag(node) in scripts
        and head is not None
        and bool(re.fullmatch(r"[a-zA-Z]{2,}", head.text or ""))
    )


def _upright(node: ElementTree.Element) -> None:
    """A name of a function is an identifier, not an operator with wide spaces."""
    for part in (node, *node):
        if _tag(part) == "mo" and (part.text or "").isalpha() and len(part.text or "") > 1:
            part.tag = f"{{{SPACE}}}mi"


def _sided(row: ElementTree.Element) -> None:
    """Columns of aligned equations; style sheets know classes, browsers no longer attributes."""
    if _tag(row) == "mtd" and (side := row.attrib.pop("columnalign", "")):
        row.set("class", {"right": "lhs", "left": "rhs"}.get(side, ""))
        content = list(row)
        for node in content:
            row.remove(node)
        ElementTree.SubElement(row, f"{{{SPACE}}}mrow").extend(content)


def _close(row: ElementTree.Element) -> None:
    """Bars and slashes stand close; a minus sign after another operator is a sign."""
    before = "("
    for node in row if _tag(row) in ROWS else ():
        said = (node.text or "") if _tag(node) == "mo" else "x"
        if said in ("|", "/"):
            node.attrib |= {"lspace": "0", "rspace": "0"}
        if said == MINUS and before in ("(", "=", ","):
            node.set("form", "prefix")
        if not (_tag(node) == "mi" and not node.text):  # the empty cell before an equals sign
            before = said


def _primed(node: ElementTree.Element) -> None:
    """A prime is raised already: beside its letter, not above it."""
    if _tag(node) == "msup" and (node[1].text or "") in PRIMES:
        node.tag = f"{{{SPACE}}}mrow"
        node[1].tag = f"{{{SPACE}}}mo"
        node[1].attrib = {"lspace": "0", "rspace": "0"}
    if _tag(node) == "mover" and node[1].text == LONG_BAR:
        node[1].text = "\u00af"
        node[1].attrib = {"stretchy": "true"}


def _opening(node: ElementTree.Element) -> bool:
    head = node
    while len(head) and _tag(head) in ("mrow", "msup", "msub"):
        head = head[0]
    return head.text == "(" and _tag(head) == "mo"


def _space() -> ElementTree.Element:
    return ElementTree.Element(f"{{{SPACE}}}mspace", {"width": THIN})


def _tag(node: ElementTree.Element) -> str:
    return node.tag.rpartition("}")[2]


class _Inline(InlineProcessor):
    """Formulas in a line of text."""

    def handleMatch(self, m: re.Match[str], data: str) -> Any:  # noqa: ARG002, N802 - of the library
        """The formula, kept from further processing."""
        return self.md.htmlStash.store(mathml(m.group(1))), m.start(0), m.end(0)


class Mathematics(Extension):
    """Formulas between dollars."""

    def extendMarkdown(self, md: Markdown) -> None:  # noqa: N802 - of the library
        """Register the pattern; backslashes in a formula are its own."""
        md.inlinePatterns.register(_Inline(INLINE, md), "mathematics", 185)


def fence(source: str, *_: Any, **__: Any) -> str:
    """A fence of kind `math` as a formula on a line of its own."""
    return f'<div class="formula">{mathml(source, display=True)}</div>'


def formulas(page: str) -> list[str]:
    """All formulas of a page, those on lines of their own first."""
    fences = re.findall(r"^ *```math\n(.*?)^ *```$", page, re.MULTILINE | re.DOTALL)
    prose = re.sub(r"^( *)(`{3,}).*?^\1\2$", "", page, flags=re.MULTILINE | re.DOTALL)
    prose = re.sub(r"`[^`]+`", "", prose)
    return [*fences, *re.findall(INLINE, prose)]
