"""Derivations as documents: for the terminal, as LaTeX, Markdown with LaTeX, HTML with MathML.

MathML needs neither script nor network, and every browser of today sets it.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from html import escape
from pathlib import Path
from typing import Any, NamedTuple

from crankstar.derive.algebra import typeset
from crankstar.derive.algebra.formula import Formula, Sum
from crankstar.derive.algebra.styles import latex_text
from crankstar.derive.notations import CRANKSTAR, Meaning, Notation, legend, notated
from crankstar.derive.records import Line, Readable, Step
from crankstar.language.messages import _, language

LINE = 84
"""Greatest length of a line of a sum in LaTeX and Markdown, in characters."""

SHORT = 48
"""Characters of a chain of equations that stays in one line in the terminal."""


def _template(name: str) -> str:
    """A file that stands beside this module."""
    return Path(__file__).with_name(name).read_text(encoding="utf-8")


ALIGNED = "math .lhs { text-align: right; } math .rhs { text-align: left; }"
"""Style that sets the equals signs of a chain below each other.

Attributes would break a strict Content-Security-Policy.
"""

PLUS = "<mo form='infix'>+</mo>"
MATH_FONT = Path(__file__).parents[1] / "bundle" / "math.woff2"
FONTS = '"crankstar math", "STIX Two Math", "Latin Modern Math", "Cambria Math", math'


def math_style() -> str:
    """The style of formulas, with the font for mathematics that a built package has with it.

    A Content-Security-Policy has to allow `font-src data:`.
    """
    own = ""
    if MATH_FONT.is_file():
        data = b64encode(MATH_FONT.read_bytes()).decode()
        address = f'url("data:font/woff2;base64,{data}") format("woff2")'
        own = f'@font-face {{ font-family: "crankstar math"; src: {address}; }}\n'
    return f"{own}math {{ font-family: {FONTS}; }}\n{ALIGNED}"


def rendered(chapters: Sequence[Readable], notation: Notation = CRANKSTAR) -> Any:
    """Chapters for the terminal, in its width."""
    from rich.console import Group
    from rich.padding import Padding
    from rich.table import Table
    from rich.text import Text

    out: list[Any] = []
    for shown in _introduced(chapters, notation):
        out += [Text(f"{shown.engine}: {shown.title}", style="bold"), Text()]
        for count, step in enumerate(shown.steps, 1):
            out.append(Text(f"{count}  {step.title}", style="bold"))
            out += [Padding(Text(words), (0, 0, 0, 3)) for words in step.words]
            if count == 1 and shown.letters:
                meanings = "; ".join(
                    f"{typeset.text(meaning.letter)}: {meaning.words}" for meaning in shown.letters
                )
                out.append(Padding(Text(_("{text}.", text=meanings)), (0, 0, 0, 3)))
            table = Table.grid(padding=(0, 3, 0, 0))
            table.add_column(ratio=2, style="dim", overflow="fold")
            table.add_column(ratio=5, overflow="fold")
            for line in step.lines:
                table.add_row(Text(_label(line, line.label, typeset.text)), Text(equations(line)))
                if line.note:
                    table.add_row("", Text(line.note, style="italic"))
            if step.lines:
                out.append(Padding(table, (0, 0, 0, 3)))
            out.append(Text())
    return Group(*out[:-1])


def plain(chapters: Sequence[Readable]) -> str:
    """Chapters as plain text."""
    from io import StringIO

    from rich.console import Console

    printed = StringIO()
    Console(file=printed, width=120, highlight=False, markup=False).print(rendered(chapters))
    return "\n".join(line.rstrip() for line in printed.getvalue().splitlines())


class _Part(NamedTuple):
    """A chapter of a document, with the letters that are new in it."""

    engine: str
    title: str
    steps: tuple[Step, ...]
    letters: list[Meaning]


def _introduced(chapters: Sequence[Readable], notation: Notation) -> list[_Part]:
    """The chapters in a notation; what their first steps repeat is left out.

    A chapter of one step, which is its result, stays whole.
    """
    out: list[_Part] = []
    known: set[str] = set()
    read: set[object] = set()
    for chapter in chapters:
        shown = notated(chapter, notation)
        first, *others = shown.steps
        if others:
            words = tuple(sentence for sentence in first.words if sentence not in read)
            lines = tuple(line for line in first.lines if line not in read)
            read |= {*first.words, *first.lines}
            first = replace(first, words=words, lines=lines)
        letters = [
            meaning
            for meaning in legend(shown, notation)
            if typeset.text(meaning.letter) not in known
        ]
        known |= {typeset.text(meaning.letter) for meaning in letters}
        out.append(_Part(chapter.engine, chapter.title, (first, *others), letters))
    return out


def _label(line: Line, label: str, written: Callable[[Formula], str]) -> str:
    """The label of a line in a kind of print, with its arm where it has one."""
    return (
        label if line.arm is None else _("{label}, arm {arm}", label=label, arm=written(line.arm))
    )


def equations(line: Line) -> str:
    """A chain of equations, one below the other from the equals sign on."""
    name = "" if line.name is None else typeset.text(line.name)
    lead = f"{name} = " if name else ""
    short = lead + " = ".join(map(typeset.text, line.chain))
    if len(short) <= SHORT:
        return short
    return f"\n{' ' * max(len(lead) - 2, 0)}= ".join(
        [lead + typeset.text(line.chain[0]), *map(typeset.text, line.chain[1:])]
    )


class _Markup(NamedTuple):
    """How one kind of file writes the parts of a chapter, as templates.

    `words` and `letters` are what stands before, between and after several of them.
    """

    escaped: Callable[[str], str]
    inline: Callable[[Formula], str]
    chain: Callable[[Line], str]
    title: str
    step: str
    words: tuple[str, str, str]
    letters: tuple[str, str, str]
    letter: str
    label: str
    equations: str
    note: str
    line: str = "{}"


def _written(shown: _Part, markup: _Markup) -> str:
    """A chapter in a kind of file."""
    escaped = markup.escaped
    out = [markup.title.format(escaped(shown.title))]
    for count, step in enumerate(shown.steps, 1):
        out.append(markup.step.format(count, escaped(step.title)))
        out.append(_joined(markup.words, [escaped(words) for words in step.words]))
        if count == 1:
            letters = [
                markup.letter.format(markup.inline(meaning.letter), escaped(meaning.words))
                for meaning in shown.letters
            ]
            out.append(_joined(markup.letters, letters))
        for line in step.lines:
            label = _label(line, escaped(line.label), markup.inline)
            written = markup.label.format(label) if label else ""
            written += markup.equations.format(markup.chain(line))
            written += markup.note.format(escaped(line.note)) if line.note else ""
            out.append(markup.line.format(written))
    return "".join(out)


def _joined(marks: tuple[str, str, str], parts: list[str]) -> str:
    before, between, after = marks
    return before + between.join(parts) + after if parts else ""


def _inline(formula: Formula) -> str:
    """A formula in a line of LaTeX or Markdown."""
    return f"${typeset.latex(formula)}$"


def _rows(line: Line) -> Iterator[tuple[bool, bool, bool, Formula]]:
    """The rows of a chain of equations, long sums broken.

    Whether the row has the name on its left, an equals sign, a plus sign, and its formula.
    """
    for index, formula in enumerate(line.chain):
        for row, piece in enumerate(_pieces(formula)):
            yield index == row == 0, row == 0, row > 0 and not typeset.negative(piece), piece


def aligned(line: Line) -> str:
    """A chain of equations in LaTeX, long sums broken."""
    name = "" if line.name is None else typeset.latex(line.name)
    rows = [
        (f"{name if first else ''} &= " if equals else "&\\quad ")
        + ("+ " if plus else "")
        + typeset.latex(piece)
        for first, equals, plus, piece in _rows(line)
    ]
    return "\\begin{aligned}\n" + " \\\\\n".join(rows) + "\n\\end{aligned}"


def _pieces(formula: Formula) -> list[Formula]:
    """A sum in pieces that fit a line."""
    if not isinstance(formula, Sum) or len(typeset.text(formula)) <= LINE:
        return [formula]
    pieces: list[tuple[Formula, ...]] = [()]
    for term in formula.terms:
        if pieces[-1] and len(typeset.text(Sum((*pieces[-1], term)))) > LINE:
            pieces.append(())
        pieces[-1] = (*pieces[-1], term)
    return [Sum(piece) for piece in pieces]


def markdown_words(words: str) -> str:
    """Words with everything escaped that means something in Markdown or HTML."""
    return re.sub(r"([\\`*_{}\[\]#|$~!])", r"\\\1", escape(words, quote=False))


def math(formula: Formula) -> str:
    """A formula as a MathML element, its plain text for screen readers."""
    plain_text, typed = escape(typeset.text(formula)), typeset.mathml(formula)
    return f'<math alttext="{plain_text}"><mrow>{typed}</mrow></math>'


def chain(line: Line) -> str:
    """A chain of equations as one MathML table, aligned at the equals signs, long sums broken."""
    name = "" if line.name is None else typeset.mathml(line.name)
    rows = "".join(
        f'<mtr><mtd class="lhs"><mrow>{name if first else ""}</mrow></mtd>'
        f"<mtd>{'<mo>=</mo>' if equals else ''}</mtd>"
        f'<mtd class="rhs"><mrow>{PLUS if plus else ""}{typeset.mathml(piece)}</mrow></mtd></mtr>'
        for first, equals, plus, piece in _rows(line)
    )
    plain_text = escape(equations(line).replace("\n", " "))
    return f'<math alttext="{plain_text}"><mtable displaystyle="true">{rows}</mtable></math>'


_LATEX = _Markup(
    escaped=latex_text,
    inline=_inline,
    chain=aligned,
    title="\\subsection*{{{}}}\n",
    step="\\paragraph{{{}. {}.}}\n",
    words=("", "\n\n", "\n"),
    letters=("\n", "; ", ".\n"),
    letter="{}: {}",
    label="\n{}:\n",
    equations="\\[\n{}\n\\]\n",
    note="{}\n",
)
_MARKDOWN = _Markup(
    escaped=markdown_words,
    inline=_inline,
    chain=aligned,
    title="## {}\n\n",
    step="### {}. {}\n\n",
    words=("", "\n\n", "\n\n"),
    letters=("* ", "\n* ", "\n\n"),
    letter="{}: {}",
    label="{}:\n\n",
    equations="$$\n{}\n$$\n\n",
    note="{}\n\n",
)
_HTML = _Markup(
    escaped=escape,
    inline=math,
    chain=chain,
    title="<h2>{}</h2>\n",
    step="<h3>{}. {}</h3>\n",
    words=("<p>", "</p>\n<p>", "</p>\n"),
    letters=("<dl>", "", "</dl>\n"),
    letter="<dt>{}</dt><dd>{}</dd>",
    label='<div class="label">{}</div>',
    equations="{}",
    note='<div class="note">{}</div>',
    line='<div class="line">{}</div>\n',
)


def latex(chapters: Sequence[Readable], notation: Notation = CRANKSTAR) -> str:
    """A complete LaTeX document; needs amsmath and Latin Modern only."""
    title = chapters[0].engine
    head = f"% {title.encode('ascii', 'replace').decode()}\n\\section*{{{latex_text(title)}}}\n"
    parts = [_written(shown, _LATEX) for shown in _introduced(chapters, notation)]
    return "".join([_template("document.tex"), head, *parts, "\\end{document}\n"])


def markdown(chapters: Sequence[Readable], notation: Notation = CRANKSTAR) -> str:
    """Markdown with LaTeX formulas between double dollars, as GitHub.

    Jupyter and most wikis set them.
    """
    parts = [_written(shown, _MARKDOWN) for shown in _introduced(chapters, notation)]
    return "".join([f"# {markdown_words(chapters[0].engine)}\n\n", *parts]).rstrip("\n") + "\n"


def html(chapters: Sequence[Readable], notation: Notation = CRANKSTAR) -> str:
    """A page that stands alone: no script, nothing from elsewhere, light and dark, printable."""
    return _template("document.html").format(
        language=language(),
        name=escape(chapters[0].engine),
        style=math_style() + _template("document.css"),
        parts="\n".join(html_parts(chapters, notation)),
    )


def html_parts(chapters: Sequence[Readable], notation: Notation = CRANKSTAR) -> list[str]:
    """Chapters as parts of one page that has `math_style`.

    Each letter is explained where it comes first.
    """
    return [
        f'<section class="derivation">\n{_written(shown, _HTML)}</section>'
        for shown in _introduced(chapters, notation)
    ]


FORMATS: dict[str, Callable[..., str]] = {"latex": latex, "markdown": markdown, "html": html}
"""The formats that are files; `text` is for the terminal."""
