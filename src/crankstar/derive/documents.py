"""Derivations as documents: for the terminal, as LaTeX, as Markdown with LaTeX formulas, as HTML with MathML.

MathML needs neither script nor network, and every browser of today sets it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from html import escape
from typing import Any

from crankstar.derive import typeset
from crankstar.derive.formula import Formula, Sum
from crankstar.derive.notations import CRANKSTAR, Meaning, Notation, legend, notated
from crankstar.derive.records import Chapter, Line

LINE = 84
"""Characters of a formula after which a long sum goes on in a new line, in LaTeX and in Markdown."""

SHORT = 48
"""Characters of a chain of equations that stays in one line in the terminal."""

_LATEX_HEAD = r"""\documentclass[a4paper,11pt]{article}
\usepackage[T1]{fontenc}
\usepackage{lmodern}
\usepackage{textcomp}
\usepackage{amsmath}
\usepackage[margin=22mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
\allowdisplaybreaks
\begin{document}
"""
ALIGNED = "math .lhs { text-align: right; } math .rhs { text-align: left; }"
"""Style that sets the equals signs of a chain below each other; attributes would break a strict Content-Security-Policy."""

_STYLE = """
:root { color-scheme: light dark; --ink: #1c2733; --soft: #5b6b7b; --rule: #d5dce3; --ground: #fdfdfc; --band: #f2f5f7; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e3e8ee; --soft: #9fb0c0; --rule: #36424e; --ground: #14191f; --band: #1b222a; }
}
body { margin: 0; background: var(--ground); color: var(--ink); font: 16px/1.55 system-ui, sans-serif; }
main { max-width: 60rem; margin: 0 auto; padding: 1.2rem 1.2rem 4rem; }
h1 { font-size: 1.5rem; line-height: 1.25; }
h2 { font-size: 1.25rem; margin-top: 2.4rem; border-top: 2px solid var(--rule); padding-top: 1rem; }
h3 { font-size: 1.02rem; margin: 1.6rem 0 .3rem; }
.derivation p { margin: .4rem 0; }
.derivation .line { margin: .35rem 0; padding: .3rem .7rem; background: var(--band); border-radius: .4rem; overflow-x: auto; }
.derivation .label { color: var(--soft); font-size: .88rem; }
.derivation .note { color: var(--soft); font-size: .88rem; }
.derivation math { font-size: 1.08rem; }
.derivation dl { display: grid; grid-template-columns: max-content 1fr; gap: .1rem .9rem; margin: .5rem 0; }
.derivation dd { margin: 0; }
@media print { .derivation .line { break-inside: avoid; background: none; } }
"""


def rendered(chapters: Sequence[Chapter], notation: Notation = CRANKSTAR) -> Any:
    """Chapters for the terminal, in its width."""
    from rich.console import Group
    from rich.padding import Padding
    from rich.table import Table
    from rich.text import Text

    out: list[Any] = []
    for shown, letters in _told_once(chapters, notation):
        out += [Text(f"{shown.engine}: {shown.title}", style="bold"), Text()]
        for count, step in enumerate(shown.steps, 1):
            out.append(Text(f"{count}  {step.title}", style="bold"))
            out += [Padding(Text(words), (0, 0, 0, 3)) for words in step.words]
            if count == 1 and letters:
                told = "; ".join(f"{typeset.text(meaning.letter)}: {meaning.words}" for meaning in letters)
                out.append(Padding(Text(f"{told}."), (0, 0, 0, 3)))
            table = Table.grid(padding=(0, 3, 0, 0))
            table.add_column(ratio=2, style="dim", overflow="fold")
            table.add_column(ratio=5, overflow="fold")
            for line in step.lines:
                arm = f", arm {typeset.text(line.arm)}" if line.arm is not None else ""
                table.add_row(Text(line.label + arm), Text(_equations(line)))
                if line.note:
                    table.add_row("", Text(line.note, style="italic"))
            if step.lines:
                out.append(Padding(table, (0, 0, 0, 3)))
            out.append(Text())
    return Group(*out[:-1])


def plain(chapters: Sequence[Chapter], notation: Notation = CRANKSTAR, *, width: int = 120) -> str:
    """Chapters as plain text."""
    from io import StringIO

    from rich.console import Console

    console = Console(file=StringIO(), width=width, force_terminal=False, highlight=False, markup=False)
    with console.capture() as captured:
        console.print(rendered(chapters, notation))
    return "\n".join(line.rstrip() for line in captured.get().splitlines())


def _told_once(chapters: Sequence[Chapter], notation: Notation) -> list[tuple[Chapter, list[Meaning]]]:
    """The chapters in a notation, each with the letters that are new in it; what the first step says again is left out."""
    out: list[tuple[Chapter, list[Meaning]]] = []
    known: set[str] = set()
    said: set[object] = set()
    for chapter in chapters:
        shown = notated(chapter, notation)
        first, *others = shown.steps
        words = tuple(one for one in first.words if one not in said)
        lines = tuple(one for one in first.lines if one not in said)
        said |= {*first.words, *first.lines}
        letters = [meaning for meaning in legend(chapter, notation) if typeset.text(meaning.letter) not in known]
        known |= {typeset.text(meaning.letter) for meaning in letters}
        out.append((replace(shown, steps=(replace(first, words=words, lines=lines), *others)), letters))
    return out


def _equations(line: Line) -> str:
    """A chain of equations, one below the other from the equals sign on."""
    name = "" if line.name is None else typeset.text(line.name)
    lead = f"{name} = " if name else ""
    short = lead + " = ".join(map(typeset.text, line.chain))
    if len(short) <= SHORT:
        return short
    return f"\n{' ' * max(len(lead) - 2, 0)}= ".join([lead + typeset.text(line.chain[0]), *map(typeset.text, line.chain[1:])])


def latex(chapters: Sequence[Chapter], notation: Notation = CRANKSTAR) -> str:
    """A complete LaTeX document; needs amsmath and Latin Modern only."""
    body = [_LATEX_HEAD]
    title = chapters[0].engine
    body.append(f"% {title.encode('ascii', 'replace').decode()}\n\\section*{{{typeset.latex_text(title)}}}\n")
    for shown, letters in _told_once(chapters, notation):
        body.append(f"\\subsection*{{{typeset.latex_text(shown.title)}}}\n")
        for count, step in enumerate(shown.steps, 1):
            body.append(f"\\paragraph{{{count}. {typeset.latex_text(step.title)}.}}\n")
            body.append("\n\n".join(typeset.latex_text(words) for words in step.words) + "\n")
            if count == 1 and letters:
                told = (f"${typeset.latex(one.letter)}$: {typeset.latex_text(one.words)}" for one in letters)
                body.append(f"\n{'; '.join(told)}.\n")
            for line in step.lines:
                arm = f", arm ${typeset.latex(line.arm)}$" if line.arm is not None else ""
                if line.label:
                    body.append(f"\n{typeset.latex_text(line.label)}{arm}:\n")
                body.append(f"\\[\n{aligned(line)}\n\\]\n")
                if line.note:
                    body.append(f"{typeset.latex_text(line.note)}\n")
    body.append("\\end{document}\n")
    return "".join(body)


def aligned(line: Line) -> str:
    """A chain of equations in LaTeX, long sums broken."""
    name = "" if line.name is None else typeset.latex(line.name)
    rows: list[str] = []
    for place, formula in enumerate(line.chain):
        first, *others = map(typeset.latex, _pieces(formula))
        rows.append(f"{name if place == 0 else ''} &= {first}")
        rows += [f"&\\quad {other if other.startswith('-') else f'+ {other}'}" for other in others]
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


def markdown(chapters: Sequence[Chapter], notation: Notation = CRANKSTAR) -> str:
    """Markdown with LaTeX formulas between double dollars, as GitHub, Jupyter and most wikis set them."""
    body = [f"# {markdown_words(chapters[0].engine)}\n"]
    for shown, letters in _told_once(chapters, notation):
        body.append(f"## {markdown_words(shown.title)}\n")
        for count, step in enumerate(shown.steps, 1):
            body.append(f"### {count}. {markdown_words(step.title)}\n")
            body += [f"{markdown_words(words)}\n" for words in step.words]
            if count == 1 and letters:
                body += [f"* ${typeset.latex(meaning.letter)}$: {meaning.words}" for meaning in letters] + [""]
            for line in step.lines:
                arm = f", arm ${typeset.latex(line.arm)}$" if line.arm is not None else ""
                if line.label:
                    body.append(f"{markdown_words(line.label)}{arm}:\n")
                body.append(f"$$\n{aligned(line)}\n$$\n")
                if line.note:
                    body.append(f"{markdown_words(line.note)}\n")
    return "\n".join(body)


def markdown_words(words: str) -> str:
    """Words with everything escaped that means something in Markdown or HTML."""
    return "".join(f"\\{char}" if char in "\\`*_{}[]#|$~!" else char for char in escape(words, quote=False))


def html(chapters: Sequence[Chapter], notation: Notation = CRANKSTAR) -> str:
    """A page that stands alone: no script, nothing from elsewhere, light and dark, printable."""
    name = escape(chapters[0].engine)
    parts = "\n".join(_section(shown, letters) for shown, letters in _told_once(chapters, notation))
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>{name}</title>\n'
        f'<meta name="viewport" content="width=device-width, initial-scale=1">\n<style>{ALIGNED}{_STYLE}</style>\n</head>\n'
        f"<body>\n<main>\n<h1>{name}</h1>\n{parts}\n</main>\n</body>\n</html>\n"
    )


def html_part(chapter: Chapter, notation: Notation = CRANKSTAR) -> str:
    """One chapter as a part of a page whose style has `ALIGNED`."""
    return html_parts([chapter], notation)[0]


def html_parts(chapters: Sequence[Chapter], notation: Notation = CRANKSTAR) -> list[str]:
    """Chapters as parts of one page, each letter explained where it comes first; the page's style has `ALIGNED`."""
    return [_section(shown, letters) for shown, letters in _told_once(chapters, notation)]


def _section(shown: Chapter, letters: Sequence[Meaning]) -> str:
    out = [f'<section class="derivation">\n<h2>{escape(shown.title)}</h2>']
    for count, step in enumerate(shown.steps, 1):
        out.append(f"<h3>{count}. {escape(step.title)}</h3>")
        out += [f"<p>{escape(words)}</p>" for words in step.words]
        if count == 1 and letters:
            terms = (f"<dt>{math(meaning.letter)}</dt><dd>{escape(meaning.words)}</dd>" for meaning in letters)
            out.append(f"<dl>{''.join(terms)}</dl>")
        for line in step.lines:
            arm = f", arm {math(line.arm)}" if line.arm is not None else ""
            label = f'<div class="label">{escape(line.label)}{arm}</div>' if line.label else ""
            note = f'<div class="note">{escape(line.note)}</div>' if line.note else ""
            out.append(f'<div class="line">{label}{_chain(line)}{note}</div>')
    out.append("</section>")
    return "\n".join(out)


def math(formula: Formula) -> str:
    """A formula as a MathML element, its plain text for those who hear it."""
    return f'<math alttext="{escape(typeset.text(formula))}"><mrow>{typeset.mathml(formula)}</mrow></math>'


def _chain(line: Line) -> str:
    """A chain of equations as one MathML table, aligned at the equals signs, long sums broken."""
    name = "" if line.name is None else typeset.mathml(line.name)
    rows = ""
    for place, formula in enumerate(line.chain):
        for row, piece in enumerate(_pieces(formula)):
            left = name if place == row == 0 else ""
            shown = typeset.mathml(piece)
            plus = "" if row == 0 or typeset.text(piece).startswith("−") else "<mo form='infix'>+</mo>"
            rows += (
                f'<mtr><mtd class="lhs"><mrow>{left}</mrow></mtd><mtd>{"<mo>=</mo>" if row == 0 else ""}</mtd>'
                f'<mtd class="rhs"><mrow>{plus}{shown}</mrow></mtd></mtr>'
            )
    told = escape(_equations(line).replace("\n", " "))
    return f'<math alttext="{told}"><mtable displaystyle="true">{rows}</mtable></math>'


FORMATS: dict[str, Callable[..., str]] = {"latex": latex, "markdown": markdown, "html": html}
"""The formats that are files; `text` is for the terminal."""
