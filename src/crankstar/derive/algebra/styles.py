"""How formulas are written in each kind of print: plain text, LaTeX, MathML.

A style is a set of templates for a fraction, a root, a power and so on; `typeset` says what goes
where.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from html import escape

GREEK = {
    "theta": "θ", "omega": "ω", "lambda": "λ", "alpha": "α", "beta": "β", "phi": "φ", "psi": "ψ",
    "tau": "τ", "delta": "δ", "pi": "π",
    "Lambda": "Λ", "Sigma": "Σ",
}  # fmt: skip
NOT_IN_T1 = "ĦħĸĿŀŉŦŧſ"
FIRST_UNKNOWN = 0x180
"""The first character that LaTeX's T1 fonts do not have, but for those below."""
_RAISED, _LOWERED = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "₀₁₂₃₄₅₆₇₈₉"
_LATEX_GREEK = {char: rf"\{name}" for name, char in GREEK.items()}
_LATEX_KNOWN = {
    **{char: f"${name}$" for char, name in _LATEX_GREEK.items()},
    **{char: f"$^{index}$" for index, char in enumerate(_RAISED[:10])},
    **{char: f"$_{index}$" for index, char in enumerate(_LOWERED)},
    "φ": r"$\varphi$", "−": "$-$", "…": r"\ldots{}", "√": r"$\surd$", "∠": r"$\angle$", "′": "'",
    "≤": r"$\le$", "≥": r"$\ge$",
}  # fmt: skip
_LATEX_SPECIAL = {char: f"\\{char}" for char in "{}$&#_%"} | {
    "\\": r"\textbackslash{}", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}",
    "<": r"\textless{}", ">": r"\textgreater{}",
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Style:
    """How one kind of print writes things: templates for what is text already.

    `stacked`: a fraction has its numerator above its denominator, so that it needs no brackets.
    `simple` is a function whose argument has no brackets, `single` the root of one number or
    letter, empty where it is written as any other. `raised` turns the figures of an exponent into
    those that are printed.
    """

    symbol: Callable[[str, str], str]
    ratio: str
    root: str
    power: str
    bracket: str
    function: str
    degrees: str
    polar: str
    integral: str
    plus: str
    minus: str
    sign: str
    space: str
    dot: str
    dots: str
    simple: str = "{} {}"
    single: str = ""
    name: str = "{}"
    figures: str = "{}"
    stacked: bool = True
    raised: Mapping[int, int] = field(default_factory=dict)


def _text_symbol(letter: str, below: str) -> str:
    if below.isdigit():
        return GREEK.get(letter, letter) + "".join(_LOWERED[int(figure)] for figure in below)
    return GREEK.get(letter, letter) + (f"_{below}" if below else "")


def _latex_symbol(letter: str, below: str) -> str:
    plain = letter.rstrip("′")
    if plain in GREEK or plain == "…":
        name = r"\ldots" if plain == "…" else f"\\{plain}"
    else:
        upright = (_LATEX_GREEK.get(char) or rf"\mathrm{{{latex_text(char)}}}" for char in plain)
        name = plain if len(plain) == 1 else "".join(upright)
    name += "'" * (len(letter) - len(plain))
    if not below:
        return name
    short = below.isdigit() or below in "+−" or re.fullmatch("[A-Za-z]", below)
    shown = below.replace("−", "-") if short else f"\\text{{{latex_text(below)}}}"
    return f"{name}_{{{shown}}}"


def _mathml_symbol(letter: str, below: str) -> str:
    shown = escape(GREEK.get(letter, letter))
    name = f"<mi>{shown}</mi>"
    if not below:
        return name
    tag = "mn" if below.isdigit() else "mi" if len(below) == 1 else "mtext"
    return f"<msub>{name}<{tag}>{escape(below)}</{tag}></msub>"


def latex_text(text: str) -> str:
    """Text with everything escaped that means something in LaTeX.

    What its plain form cannot set is a question mark.
    """
    plain = "".join(_LATEX_SPECIAL.get(char, char) for char in text)
    return "".join(
        char if ord(char) < FIRST_UNKNOWN and char not in NOT_IN_T1 else _LATEX_KNOWN.get(char, "?")
        for char in plain
    )


TEXT = Style(
    symbol=_text_symbol,
    ratio="{}/{}",
    root="√({})",
    single="√{}",
    power="{}{}",
    bracket="({})",
    function="{}({})",
    degrees="{}°",
    polar="{} ∠ {}",
    integral="∫_{}^{} {} d{}",
    plus=" + ",
    minus=" − ",
    sign="−",
    space=" ",
    dot=" · ",
    dots="…",
    stacked=False,
    raised=str.maketrans("0123456789-", _RAISED),
)
LATEX = Style(
    symbol=_latex_symbol,
    ratio=r"\frac{{{}}}{{{}}}",
    root=r"\sqrt{{{}}}",
    power="{}^{{{}}}",
    bracket=r"\left({}\right)",
    function=r"{}\left({}\right)",
    degrees=r"{}^\circ",
    polar=r"{}\,\angle\,{}",
    integral=r"\int_{{{}}}^{{{}}} {}\,d{}",
    plus=" + ",
    minus=" - ",
    sign="-",
    space=r"\,",
    dot=r" \cdot ",
    dots=r"\ldots",
    name=r"\{}",
)
MATHML = Style(
    symbol=_mathml_symbol,
    ratio="<mfrac><mrow>{}</mrow><mrow>{}</mrow></mfrac>",
    root="<msqrt>{}</msqrt>",
    power="<msup><mrow>{}</mrow><mn>{}</mn></msup>",
    bracket="<mrow><mo>(</mo>{}<mo>)</mo></mrow>",
    function="{}<mo>&#x2061;</mo><mrow><mo>(</mo>{}<mo>)</mo></mrow>",
    simple="{}<mspace width='0.17em'></mspace>{}",
    degrees="{}<mo>°</mo>",
    polar="{}<mspace width='0.3em'></mspace><mo>∠</mo>{}",
    integral="<msubsup><mo>∫</mo><mrow>{}</mrow><mrow>{}</mrow></msubsup>{}"
    "<mspace width='0.17em'></mspace><mi>d</mi>{}",
    plus="<mo>+</mo>",
    minus="<mo>−</mo>",
    sign="<mo form='prefix'>−</mo>",
    space="<mspace width='0.17em'></mspace>",
    dot="<mo>·</mo>",
    dots="<mo>…</mo>",
    name="<mi>{}</mi>",
    figures="<mn>{}</mn>",
)
