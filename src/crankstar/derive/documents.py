"""Derivations as documents: for the terminal, as LaTeX, Markdown with LaTeX, HTML with MathML.

MathML needs neither script nor network, and every browser of today sets it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from html import escape
from pathlib import Path
from typing import Any, NamedTuple

from crankstar.derive.algebra import typeset
from crankstar.derive.algebra.formula import Formula, Sum
from crankstar.derive.algebra.styles import latex_text
from crankstar.derive.notations import CRANKSTAR, Meaning, Notation, legend, notated
from crankstar.derive.records import Line, Readable, Step
from crankstar.language.messages import _

LINE = 84
"""Greatest length of a line of a sum in LaTeX and Markdown, in characters."""

SHORT = 48
"""Characters of a chain of equations that stays in one line in the terminal."""


def _template(name: str) -> str:
    """A file that stands beside this module."""
    return Path(__file__).with_name(name).read_text(encoding="utf-8")


_LATEX_HEAD = _template("document.tex")
ALIGNED = "math .lhs { text-align: right; } math .rhs { text-align: left; }"
"""Style that sets the equals signs of a chain below each other.

Attributes would break a strict Content-Security-Policy.
"""

_STYLE = _template("document.css")


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
                out.append(Padding(Text(f"{meanings}."), (0, 0, 0, 3)))
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


def plain(chapters: Sequence[Readable], notation: Notation = CRANKSTAR, *, width: int = 120) -> str:
    """Chapters as plain text."""
    from io import StringIO

    from rich.console import Console

    console = Console(
        file=StringIO(), width=width, force_terminal=False, highlight=False, markup=False
    )
    with console.capture() as captured:
        console.print(rendered(chapters, notation))
    return "\n".join(line.rstrip() for line in captured.get().splitlines())


class _Part(NamedTuple):
    """A chapter of a document, with the letters that are new in it."""

    engine: str
    title: str
    steps: tuple[Step, ...]
    letters: list[Meaning]


def _introduced(chapters: Sequence[Readable], notation: Notation) -> list[_Part]:
    """The chapters in a notation; what their first steps repeat is left out."""
    out: list[_Part] = []
    known: set[str] = set()
    read: set[object] = set()
    for chapter in chapters:
        shown = notated(chapter, notation)
        first, *others = shown.steps
        words = tuple(sentence for sentence in first.words if sentence not in read)
        lines = tuple(line for line in first.lines if line not in read)
        read |= {*first.words, *first.lines}
        letters = [
            meaning
            for meaning in legend(shown, notation)
            if typeset.text(meaning.letter) not in known
        ]
        known |= {typeset.text(meaning.letter) for meaning in letters}
        steps = (replace(first, words=words, lines=lines), *others)
        out.append(_Part(chapter.engine, chapter.title, steps, letters))
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


def latex(chapters: Sequence[Readable], notation: Notation = CRANKSTAR) -> str:
    """A complete LaTeX document; needs amsmath and Latin Modern only."""
    body = [_LATEX_HEAD]
    title = chapters[0].engine
    body.append(
        f"% {title.encode('ascii', 'replace').decode()}\n\\section*{{{latex_text(title)}}}\n"
    )
    for shown in _introduced(chapters, notation):
        body.append(f"\\subsection*{{{latex_text(shown.title)}}}\n")
        for count, step in enumerate(shown.steps, 1):
            body.append(f"\\paragraph{{{count}. {latex_text(step.title)}.}}\n")
            body.append("\n\n".join(latex_text(words) for words in step.words) + "\n")
            if count == 1 and shown.letters:
                meanings = (
                    f"${typeset.latex(one.letter)}$: {latex_text(one.words)}"
                    for one in shown.letters
                )
                body.append(f"\n{'; '.join(meanings)}.\n")
            for line in step.lines:
                if line.label:
                    body.append(f"\n{_label(line, latex_text(line.label), _inline)}:\n")
                body.append(f"\\[\n{aligned(line)}\n\\]\n")
                if line.note:
                    body.append(f"{latex_text(line.note)}\n")
    body.append("\\end{document}\n")
    return "".join(body)


def _inline(formula: Formula) -> str:
    """A formula in a line of LaTeX or Markdown."""
    return f"${typeset.latex(formula)}$"


def aligned(line: Line) -> str:
    """A chain of equations in LaTeX, long sums broken."""
    name = "" if line.name is None else typeset.latex(line.name)
    rows: list[str] = []
    for place, formula in enumerate(line.chain):
        first, *others = _pieces(formula)
        rows.append(f"{name if place == 0 else ''} &= {typeset.latex(first)}")
        for piece in others:
            plus = "" if typeset.negative(piece) else "+ "
            rows.append(f"&\\quad {plus}{typeset.latex(piece)}")
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


def markdown(chapters: Sequence[Readable], notation: Notation = CRANKSTAR) -> str:
    """Markdown with LaTeX formulas between double dollars, as GitHub.

    Jupyter and most wikis set them.
    """
    body = [f"# {markdown_words(chapters[0].engine)}\n"]
    for shown in _introduced(chapters, notation):
        body.append(f"## {markdown_words(shown.title)}\n")
        for count, step in enumerate(shown.steps, 1):
            body.append(f"### {count}. {markdown_words(step.title)}\n")
            body += [f"{markdown_words(words)}\n" for words in step.words]
            if count == 1 and shown.letters:
                body += [
                    f"* ${typeset.latex(meaning.letter)}$: {meaning.words}"
                    for meaning in shown.letters
                ] + [""]
            for line in step.lines:
                if line.label:
                    body.append(f"{_label(line, markdown_words(line.label), _inline)}:\n")
                body.append(f"$$\n{aligned(line)}\n$$\n")
                if line.note:
                    body.append(f"{markdown_words(line.note)}\n")
    return "\n".join(body)


def markdown_words(words: str) -> str:
    """Words with everything escaped that means something in Markdown or HTML."""
    return "".join(
        f"\\{char}" if char in "\\`*_{}[]#|$~!" else char for char in escape(words, quote=False)
    )


def html(chapters: Sequence[Readable], notation: Notation = CRANKSTAR) -> str:
    """A page that stands alone: no script, nothing from elsewhere, light and dark, printable."""
    parts = "\n".join(_section(shown) for shown in _introduced(chapters, notation))
    values = {"name": escape(chapters[0].engine), "style": ALIGNED + _STYLE, "parts": parts}
    return re.sub(r"\{(name|style|parts)\}", lambda key: values[key[1]], _template("document.html"))


def html_part(chapter: Readable, notation: Notation = CRANKSTAR) -> str:
    """One chapter as a part of a page whose style has `ALIGNED`."""
    return html_parts([chapter], notation)[0]


def html_parts(chapters: Sequence[Readable], notation: Notation = CRANKSTAR) -> list[str]:
    """Chapters as parts of one page, each letter explained where it comes first.

    The page's style has `ALIGNED`.
    """
    return [_section(shown) for shown in _introduced(chapters, notation)]


def _section(shown: _Part) -> str:
    out = [f'<section class="derivation">\n<h2>{escape(shown.title)}</h2>']
    for count, step in enumerate(shown.steps, 1):
        out.append(f"<h3>{count}. {escape(step.title)}</h3>")
        out += [f"<p>{escape(words)}</p>" for words in step.words]
        if count == 1 and shown.letters:
            terms = (
                f"<dt>{math(meaning.letter)}</dt><dd>{escape(meaning.words)}</dd>"
                for meaning in shown.letters
            )
            out.append(f"<dl>{''.join(terms)}</dl>")
        for line in step.lines:
            shown_label = _label(line, escape(line.label), math)
            label = f'<div class="label">{shown_label}</div>' if line.label else ""
            note = f'<div class="note">{escape(line.note)}</div>' if line.note else ""
            out.append(f'<div class="line">{label}{chain(line)}{note}</div>')
    out.append("</section>")
    return "\n".join(out)


def math(formula: Formula) -> str:
    """A formula as a MathML element, its plain text for screen readers."""
    plain_text, typed = escape(typeset.text(formula)), typeset.mathml(formula)
    return f'<math alttext="{plain_text}"><mrow>{typed}</mrow></math>'


def chain(line: Line) -> str:
    """A chain of equations as one MathML table, aligned at the equals signs, long sums broken."""
    name = "" if line.name is None else typeset.mathml(line.name)
    rows = ""
    for place, formula in enumerate(line.chain):
        for row, piece in enumerate(_pieces(formula)):
            left = name if place == row == 0 else ""
            shown = typeset.mathml(piece)
            plus = "" if row == 0 or typeset.negative(piece) else "<mo form='infix'>+</mo>"
            equals = "<mo>=</mo>" if row == 0 else ""
            rows += (
                f'<mtr><mtd class="lhs"><mrow>{left}</mrow></mtd><mtd>{equals}</mtd>'
                f'<mtd class="rhs"><mrow>{plus}{shown}</mrow></mtd></mtr>'
            )
    plain_text = escape(equations(line).replace("\n", " "))
    return f'<math alttext="{plain_text}"><mtable displaystyle="true">{rows}</mtable></math>'


FORMATS: dict[str, Callable[..., str]] = {"latex": latex, "markdown": markdown, "html": html}
"""The formats that are files; `text` is for the terminal."""
