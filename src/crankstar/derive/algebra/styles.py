"""How formulas are written in each kind of print: plain text, LaTeX, MathML.

A style is a set of ways to write a fraction, a root, a power and so on; `typeset` says what goes
where.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from html import escape

GREEK = {
    "theta": "θ", "omega": "ω", "lambda": "λ", "alpha": "α", "beta": "β", "phi": "φ", "psi": "ψ",
    "tau": "τ", "delta": "δ",
    "Lambda": "Λ", "Sigma": "Σ",
}  # fmt: skip
NOT_IN_T1 = "ĦħĸĿŀŉŦŧſ"
FIRST_UNKNOWN = 0x180
"""The first character that LaTeX's T1 fonts do not have, but for those below."""
_LATEX_KNOWN = {
    "θ": r"$\theta$", "ψ": r"$\psi$", "ω": r"$\omega$", "λ": r"$\lambda$", "β": r"$\beta$",
    "α": r"$\alpha$", "φ": r"$\varphi$",
    "π": r"$\pi$", "−": "$-$", "…": r"\ldots{}", "√": r"$\surd$", "∠": r"$\angle$", "′": "'",
    "≤": r"$\le$", "≥": r"$\ge$",
    "⁴": "$^4$", "⁵": "$^5$", "⁶": "$^6$", "⁷": "$^7$", "⁸": "$^8$", "₀": "$_0$", "₁": "$_1$",
    "₂": "$_2$",
    "₄": "$_4$", "₆": "$_6$",
}  # fmt: skip
_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
_LOWERED = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_LATEX_SPECIAL = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "#": r"\#",
    "_": r"\_", "%": r"\%",
    "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", "<": r"\textless{}",
    ">": r"\textgreater{}",
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Style:
    """How one kind of print writes things; everything is text already."""

    symbol: Callable[[str, str], str]
    pi: str
    ratio: Callable[[str, str], str]
    root: Callable[[str, bool], str]
    power: Callable[[str, int], str]
    bracket: Callable[[str], str]
    name: Callable[[str], str]
    function: Callable[[str, str, bool], str]
    degrees: Callable[[str], str]
    polar: Callable[[str, str], str]
    figures: Callable[[str], str]
    plus: str
    minus: str
    sign: str
    space: str
    dot: str
    dots: str
    stacked: bool
    """Whether a fraction has its numerator above its denominator, so that it needs no brackets."""


def _text_symbol(letter: str, below: str) -> str:
    if below.isdigit():
        return GREEK.get(letter, letter) + below.translate(_LOWERED)
    return GREEK.get(letter, letter) + (f"_{below}" if below else "")


def _latex_symbol(letter: str, below: str) -> str:
    plain = letter.rstrip("′")
    name = (
        f"\\{plain}"
        if plain in GREEK
        else r"\ldots"
        if plain == "…"
        else plain
        if len(plain) == 1
        else f"\\mathrm{{{latex_text(plain)}}}"
    )
    name += "'" * (len(letter) - len(plain))
    if not below:
        return name
    short = (
        below.isdigit()
        or below in "+−"
        or (len(below) == 1 and below.isascii() and below.isalpha())
    )
    return (
        f"{name}_{{{below.replace('−', '-')}}}"
        if short
        else f"{name}_{{\\text{{{latex_text(below)}}}}}"
    )


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
    pi="π",
    ratio=lambda above, below: f"{above}/{below}",
    root=lambda inner, single: f"√{inner}" if single else f"√({inner})",
    power=lambda base, exponent: base + str(exponent).translate(_RAISED),
    bracket=lambda inner: f"({inner})",
    name=lambda name: name,
    function=lambda name, inner, simple: f"{name} {inner}" if simple else f"{name}({inner})",
    degrees=lambda inner: f"{inner}°",
    polar=lambda length, angle: f"{length} ∠ {angle}",
    figures=lambda text: text,
    plus=" + ",
    minus=" − ",
    sign="−",
    space=" ",
    dot=" · ",
    dots="…",
    stacked=False,
)
_LATEX_FUNCTIONS = {"cos": r"\cos", "sin": r"\sin", "atan": r"\arctan"}
LATEX = Style(
    symbol=_latex_symbol,
    pi=r"\pi",
    ratio=lambda above, below: f"\\frac{{{above}}}{{{below}}}",
    root=lambda inner, _: f"\\sqrt{{{inner}}}",
    power=lambda base, exponent: f"{base}^{{{exponent}}}",
    bracket=lambda inner: f"\\left({inner}\\right)",
    name=lambda name: _LATEX_FUNCTIONS[name],
    function=lambda name, inner, simple: (
        f"{name} {inner}" if simple else f"{name}\\left({inner}\\right)"
    ),
    degrees=lambda inner: f"{inner}^\\circ",
    polar=lambda length, angle: f"{length}\\,\\angle\\,{angle}",
    figures=lambda text: text,
    plus=" + ",
    minus=" - ",
    sign="-",
    space=r"\,",
    dot=r" \cdot ",
    dots=r"\ldots",
    stacked=True,
)
MATHML = Style(
    symbol=_mathml_symbol,
    pi="<mi>π</mi>",
    ratio=lambda above, below: f"<mfrac><mrow>{above}</mrow><mrow>{below}</mrow></mfrac>",
    root=lambda inner, _: f"<msqrt>{inner}</msqrt>",
    power=lambda base, exponent: f"<msup><mrow>{base}</mrow><mn>{exponent}</mn></msup>",
    bracket=lambda inner: f"<mrow><mo>(</mo>{inner}<mo>)</mo></mrow>",
    name=lambda name: f"<mi>{name}</mi>",
    function=lambda name, inner, simple: (
        f"{name}<mspace width='0.17em'></mspace>{inner}"
        if simple
        else f"{name}<mo>&#x2061;</mo><mrow><mo>(</mo>{inner}<mo>)</mo></mrow>"
    ),
    degrees=lambda inner: f"{inner}<mo>°</mo>",
    polar=lambda length, angle: f"{length}<mspace width='0.3em'></mspace><mo>∠</mo>{angle}",
    figures=lambda text: f"<mn>{text}</mn>",
    plus="<mo>+</mo>",
    minus="<mo>−</mo>",
    sign="<mo form='prefix'>−</mo>",
    space="<mspace width='0.17em'></mspace>",
    dot="<mo>·</mo>",
    dots="<mo>…</mo>",
    stacked=True,
)
