"""Formulas in print: plain text for a terminal, LaTeX, and MathML for a browser.

The three say the same thing; a printer is a set of ways to write a fraction, a root, a power, and so on, and one set of
rules says what goes where.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from html import escape
from math import floor, log10

from flint import arb, fmpq

from crankstar.derive.formula import (
    LONG,
    UNIT,
    Applied,
    Decimal,
    Degrees,
    Formula,
    Pi,
    Polar,
    Power,
    Product,
    Ratio,
    Rational,
    Root,
    Sum,
    Symbol,
    coefficient,
    letters_of,
    product,
)

GREEK = {
    "theta": "θ", "omega": "ω", "lambda": "λ", "alpha": "α", "beta": "β", "phi": "φ", "psi": "ψ", "tau": "τ", "delta": "δ",
    "Lambda": "Λ", "Sigma": "Σ",
}  # fmt: skip
GREATEST_PLACES = 30
"""Places behind the point at most, however small a decimal is."""
TINY = 1e-6
"""Decimals below this are written with a power of ten."""
NOT_IN_T1 = "ĦħĸĿŀŉŦŧſ"
FIRST_UNKNOWN = 0x180
"""The first character that LaTeX's T1 fonts do not have, but for those below."""
_LATEX_KNOWN = {
    "θ": r"$\theta$", "ψ": r"$\psi$", "ω": r"$\omega$", "λ": r"$\lambda$", "β": r"$\beta$", "α": r"$\alpha$", "φ": r"$\varphi$",
    "π": r"$\pi$", "−": "$-$", "…": r"\ldots{}", "√": r"$\surd$", "∠": r"$\angle$", "′": "'", "≤": r"$\le$", "≥": r"$\ge$",
    "⁴": "$^4$", "⁵": "$^5$", "⁶": "$^6$", "⁷": "$^7$", "⁸": "$^8$", "₀": "$_0$", "₁": "$_1$", "₂": "$_2$",
    "₄": "$_4$", "₆": "$_6$",
}  # fmt: skip
_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
_LOWERED = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_LATEX_SPECIAL = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "#": r"\#", "_": r"\_", "%": r"\%",
    "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", "<": r"\textless{}", ">": r"\textgreater{}",
}  # fmt: skip


@dataclass(frozen=True)
class _Style:
    """How one kind of print writes things; all take and give text."""

    symbol: Callable[[str, str], str]
    pi: str
    ratio: Callable[[str, str], str]
    root: Callable[[str], str]
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
    row: Callable[[str], str]
    decimals: bool


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
    short = below.isdigit() or below in "+−" or (len(below) == 1 and below.isascii() and below.isalpha())
    return f"{name}_{{{below.replace('−', '-')}}}" if short else f"{name}_{{\\text{{{latex_text(below)}}}}}"


def _mathml_symbol(letter: str, below: str) -> str:
    shown = escape(GREEK.get(letter, letter))
    name = f"<mi>{shown}</mi>"
    if not below:
        return name
    tag = "mn" if below.isdigit() else "mi" if len(below) == 1 else "mtext"
    return f"<msub>{name}<{tag}>{escape(below)}</{tag}></msub>"


def latex_text(text: str) -> str:
    """Text with everything escaped that means something in LaTeX; what its plain form cannot set is a question mark."""
    plain = "".join(_LATEX_SPECIAL.get(char, char) for char in text)
    return "".join(char if ord(char) < FIRST_UNKNOWN and char not in NOT_IN_T1 else _LATEX_KNOWN.get(char, "?") for char in plain)


_TEXT = _Style(
    symbol=_text_symbol,
    pi="π",
    ratio=lambda above, below: f"{above}/{below}",
    root=lambda inner: f"√{inner}" if inner.isalnum() else f"√({inner})",
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
    row=lambda inner: inner,
    decimals=True,
)
_LATEX_FUNCTIONS = {"cos": r"\cos", "sin": r"\sin", "atan": r"\arctan"}
_LATEX = _Style(
    symbol=_latex_symbol,
    pi=r"\pi",
    ratio=lambda above, below: f"\\frac{{{above}}}{{{below}}}",
    root=lambda inner: f"\\sqrt{{{inner}}}",
    power=lambda base, exponent: f"{base}^{{{exponent}}}",
    bracket=lambda inner: f"\\left({inner}\\right)",
    name=lambda name: _LATEX_FUNCTIONS[name],
    function=lambda name, inner, simple: f"{name} {inner}" if simple else f"{name}\\left({inner}\\right)",
    degrees=lambda inner: f"{inner}^\\circ",
    polar=lambda length, angle: f"{length}\\,\\angle\\,{angle}",
    figures=lambda text: text,
    plus=" + ",
    minus=" - ",
    sign="-",
    space=r"\,",
    dot=r" \cdot ",
    dots=r"\ldots",
    row=lambda inner: inner,
    decimals=False,
)
_MATHML = _Style(
    symbol=_mathml_symbol,
    pi="<mi>π</mi>",
    ratio=lambda above, below: f"<mfrac><mrow>{above}</mrow><mrow>{below}</mrow></mfrac>",
    root=lambda inner: f"<msqrt>{inner}</msqrt>",
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
    row=lambda inner: f"<mrow>{inner}</mrow>",
    decimals=False,
)


def text(formula: Formula) -> str:
    """A formula in one line of text.

    >>> text(product(Fraction(3, 2), Symbol("a"), Root(Rational(Fraction(2)))))
    '(3√2/2) a'
    """
    return _printed(formula, _TEXT)


def latex(formula: Formula) -> str:
    """A formula in LaTeX, for use between dollar signs."""
    return _printed(formula, _LATEX)


def mathml(formula: Formula) -> str:
    """A formula as presentation MathML, without the enclosing `math` element."""
    return _printed(formula, _MATHML)


def figures(decimal: Decimal) -> str:
    """The digits of a decimal that are certain, at most as many as it asks for: `-0.8516` is cut, not rounded.

    An enclosure of zero that is not zero is written as 0.
    """
    ball = decimal.ball
    if ball.contains(0):
        return "0"
    most = max(0, min(decimal.digits - 1 - floor(log10(float(abs(ball).mid()))), GREATEST_PLACES))
    for places in range(most, -1, -1):
        scaled = abs(ball) * 10**places
        # Cut; or rounded where it is so near to a round number that a cut is undecided.
        for start in (scaled, scaled + arb(0.5)):
            low, high = start.lower().floor(), start.upper().floor()
            if low == high:
                digits = str(low.unique_fmpz()).rjust(places + 1, "0")
                shown = digits if places == 0 else f"{digits[:-places]}.{digits[-places:]}"
                return shown if ball > 0 else f"-{shown}"
    return str(ball)


def _printed(formula: Formula, style: _Style) -> str:
    writer = _WRITERS[type(formula)]
    return writer(formula, style)


def _rational(formula: Rational, style: _Style) -> str:
    size = abs(formula.value)
    shown = _plain(size, style)
    return f"{style.sign}{shown}" if formula.value < 0 else shown


def _plain(size: Fraction, style: _Style) -> str:
    """A positive rational number: whole, as a fraction, or as a decimal where the fraction is long."""
    if size.denominator == 1:
        return style.figures(str(size.numerator))
    if size.denominator > LONG:
        return _decimal(Decimal(arb(fmpq(size.numerator, size.denominator))), style)
    return style.ratio(style.figures(str(size.numerator)), style.figures(str(size.denominator)))


def _decimal(formula: Decimal, style: _Style) -> str:
    ball = formula.ball
    if not ball.contains(0) and abs(ball) < TINY:
        power = floor(log10(float(abs(ball).mid())))
        mantissa = _decimal(Decimal(ball * arb(10) ** -power, formula.digits), style)
        return mantissa + style.dot + style.power(style.figures("10"), power)
    shown = figures(formula)
    sign = style.sign if shown.startswith("-") else ""
    return sign + style.figures(shown.removeprefix("-")) + (style.dots if shown != "0" else "")


def _degrees(value: Rational | Decimal, style: _Style) -> str:
    """Degrees as a decimal, cut where it has no end."""
    if isinstance(value, Decimal) or value.value.denominator == 1:
        return _printed(value, style)
    if 10**6 % value.value.denominator:
        return _decimal(Decimal(arb(fmpq(value.value.numerator, value.value.denominator))), style)
    shown = f"{abs(float(value.value)):.10g}"
    return (style.sign if value.value < 0 else "") + style.figures(shown)


def _sum(formula: Sum, style: _Style) -> str:
    out = ""
    for place, term in enumerate(formula.terms):
        rational, _ = coefficient(term)
        down = rational < 0 or (isinstance(term, Decimal) and term.ball < 0) or (isinstance(term, Degrees) and _below(term))
        shown = _printed(_opposite(term) if down else term, style)
        out += (style.sign if down else "") + shown if place == 0 else (style.minus if down else style.plus) + shown
    return out


def _below(term: Degrees) -> bool:
    inner = term.value
    return inner.value < 0 if isinstance(inner, Rational) else bool(inner.ball < 0)


def _opposite(term: Formula) -> Formula:
    if isinstance(term, Decimal):
        return Decimal(-term.ball, term.digits)
    if isinstance(term, Degrees):
        inner = term.value
        return Degrees(Rational(-inner.value) if isinstance(inner, Rational) else Decimal(-inner.ball, inner.digits))
    return product(-1, term)


def _product(formula: Product, style: _Style) -> str:
    """Numbers, then letters: 4√2 a cos 2θ, 0.5 · 0.8516… a."""
    size, _ = coefficient(formula)
    factors = [factor for factor in formula.factors if not isinstance(factor, Rational)]
    simple = [factor for factor in factors if isinstance(factor, (Root, Pi))]
    longer = [factor for factor in factors if isinstance(factor, (Decimal, Ratio)) and not letters_of(factor)]
    letters = [factor for factor in factors if factor not in simple and factor not in longer]
    sign, size = (style.sign, -size) if size < 0 else ("", size)
    front = _front(size, simple, style, alone=not letters and not longer)
    numbers = style.dot.join([*([front] if front else []), *(_grouped(factor, style) for factor in longer)])
    rest = style.space.join(_grouped(factor, style) for factor in letters)
    close = not longer and bool(letters) and _close(front, letters[0], style)
    return sign + numbers + (style.space if numbers and rest and not close else "") + rest


def _close(front: str, letter: Formula, style: _Style) -> bool:
    """Whether a number stands right before a letter, as in 2θ."""
    plain = letter.base if isinstance(letter, Power) else letter
    return (front.isdigit() and isinstance(plain, Symbol)) or (style is _MATHML and front.startswith("<mn>"))


def _front(size: Fraction, constants: Sequence[Formula], style: _Style, *, alone: bool) -> str:
    """The numbers in front of a product: 4√2, 3√2/2, 3π/4, 1.5."""
    shown = "".join(_printed(factor, style) for factor in constants)
    if not constants:
        if size == 1:
            return ""
        if size.denominator == 1 or not style.decimals:
            return _plain(size, style)
        short = size.denominator in (2, 4, 5, 8, 10, 20)
        return f"{float(size):.15g}" if short else _plain(size, style) if size.denominator > LONG else f"({_plain(size, style)})"
    above = shown if size.numerator == 1 else style.figures(str(size.numerator)) + shown
    if size.denominator == 1:
        return above
    out = style.ratio(above, style.figures(str(size.denominator)))
    return out if alone or style is not _TEXT else f"({out})"


def _grouped(formula: Formula, style: _Style) -> str:
    """A factor of a product: a sum in brackets; in text also a fraction with letters."""
    shown = _printed(formula, style)
    loose = style is _TEXT and isinstance(formula, Ratio) and letters_of(formula)
    return style.bracket(shown) if isinstance(formula, Sum) or loose else shown


def _power(formula: Power, style: _Style) -> str:
    """A power; of a cosine with the exponent at its name, cos² α."""
    if isinstance(formula.base, Applied):
        return _applied(formula.base, style, exponent=formula.exponent)
    base = _printed(formula.base, style)
    return style.power(base if isinstance(formula.base, Symbol) else style.bracket(base), formula.exponent)


def _ratio(formula: Ratio, style: _Style) -> str:
    above, below = _printed(formula.above, style), _printed(formula.below, style)
    if style is not _TEXT:
        return style.ratio(above, below)
    above = f"({above})" if not isinstance(formula.above, Root) and (" " in above or "/" in above) else above
    return style.ratio(above, f"({below})" if isinstance(formula.below, (Product, Sum, Ratio)) else below)


def _applied(formula: Applied, style: _Style, exponent: int = 1) -> str:
    argument = formula.argument
    _, inner = coefficient(argument)
    simple = (isinstance(inner, Symbol) and formula.function != "atan") or (
        isinstance(argument, Rational) and argument.value.denominator == 1 and argument.value > 0
    )
    name = style.name(formula.function)
    return style.function(name if exponent == 1 else style.power(name, exponent), _printed(argument, style), simple)


def _polar(formula: Polar, style: _Style) -> str:
    return style.polar(_grouped(formula.length, style), _grouped(formula.angle, style))


_WRITERS: dict[type, Callable[..., str]] = {
    Rational: _rational,
    Decimal: _decimal,
    Symbol: lambda formula, style: style.symbol(formula.letter, formula.below),
    Pi: lambda _, style: style.pi,
    Root: lambda formula, style: style.root(_printed(formula.radicand, style)),
    Power: _power,
    Sum: _sum,
    Product: _product,
    Ratio: _ratio,
    Degrees: lambda formula, style: style.degrees(_degrees(formula.value, style)),
    Applied: _applied,
    Polar: _polar,
}

__all__ = ["GREEK", "UNIT", "figures", "latex", "latex_text", "mathml", "text"]
