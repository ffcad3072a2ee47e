"""A reader of formulas as they are printed: in text, in LaTeX, in MathML.

Independent of the code that prints them. A print is cut into tokens and read by the rules that a
careful reader has: what stands side by side belongs together more tightly than a slash or a dot, a
slash takes the one thing behind it, a function without brackets takes the numbers and letters that
follow it, a minus sign takes the one term behind it. `0.8516…` is any number with these digits.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from flint import acb, arb

GREEK = dict(
    zip(
        "θωλαβφψτδ",
        ["theta", "omega", "lambda", "alpha", "beta", "phi", "psi", "tau", "delta"],
        strict=True,
    )
)
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
LOWERED = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
FUNCTIONS: dict[str, Callable[[acb], acb]] = {"cos": acb.cos, "sin": acb.sin, "atan": acb.atan}


INTEGRAL = r"∫_\w+\^\w+ .*? d\w"
INTEGRAL_PARTS = r"∫_(\w+)\^(\w+) (.*?) d(\w)"


class UnreadableError(ValueError):
    """A print that no reader can read in one way only."""


class Token(NamedTuple):
    """A number, a symbol, a function, an operator, a fraction, a root, or a raised number."""

    kind: str
    value: Any


def from_text(print_: str) -> list[Token]:
    """The tokens of a formula in text."""
    rules = [
        (INTEGRAL, lambda seen: _integral(re.findall(INTEGRAL_PARTS, seen)[0], made=from_text)),
        (r"\d+(?:\.\d+)?…?", _number),
        (r"[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+", lambda seen: Token("raised", int(seen.translate(RAISED)))),
        (r"cos|sin|atan", lambda seen: Token("function", seen)),
        (r"π", lambda _: Token("symbol", "pi")),
        (r"…", lambda _: Token("symbol", "…")),
        (r"[^\W\d_]′*(?:[₀-₉]+|_[\w+−]+(?:, \w+)?)?", lambda seen: Token("symbol", _name(seen))),
        (r"[-+−·/()√∠°]", lambda seen: Token("operator", seen)),
    ]
    return _cut(print_, rules)


def _integral(parts: Sequence[str], *, made: Callable[[str], list[Token]]) -> Token:
    """A definite integral: lower and upper bound, integrand, and the letter it is taken over."""
    lower, upper, inner, letter = map(made, parts)
    return Token("integral", (lower, upper, inner, letter[0].value))


def _name(seen: str) -> str:
    plain = seen.translate(LOWERED)
    letter = re.match(r"[^\W\d_]′*", plain)
    assert letter
    below = plain[letter.end() :].removeprefix("_")
    head = GREEK.get(letter[0], letter[0])
    return f"{head}_{below}" if below else head


def _number(seen: str) -> Token:
    """A number, or all numbers that begin with these digits."""
    digits = seen.removesuffix("…")
    if digits == seen:
        return Token("number", acb(arb(digits)))
    last = arb(10) ** -len(digits.partition(".")[2])
    low = arb(digits)
    # What is cut where rounding hides the last digit may lie a little below.
    return Token("number", acb((low - arb("1e-40")).union(low + last)))


def _cut(print_: str, rules: Sequence[tuple[str, Callable[[str], Token]]]) -> list[Token]:
    out: list[Token] = []
    place = 0
    while place < len(print_):
        if print_[place].isspace():
            place += 1
            continue
        for pattern, made in rules:
            if seen := re.compile(pattern).match(print_, place):
                out.append(made(seen[0]))
                place = seen.end()
                break
        else:
            raise UnreadableError(f"{print_[place:]!r} in {print_!r}")
    return out


def from_latex(print_: str) -> list[Token]:
    """The tokens of a formula in LaTeX."""
    out: list[Token] = []
    rest = print_
    letter = re.compile(
        r"(?P<letter>\\(?:theta|omega|lambda|alpha|beta|phi|psi|tau|delta)(?![a-z])|[A-Za-z])(?P<primes>'*)(?:_\{(?:\\text\{(?P<text>[^{}]*)\}|(?P<below>[^{}]*))\})?"
    )
    while rest:
        if seen := re.match(r"\s+|\\,|\\quad|\\(?:left|right)(?=[()])", rest):
            pass
        elif rest.startswith(r"\frac"):
            above, tail = _group(rest[5:])
            below, rest = _group(tail)
            out.append(Token("fraction", (from_latex(above), from_latex(below))))
            continue
        elif rest.startswith(r"\int"):
            lower, tail = _group(rest[5:])
            upper, tail = _group(tail[1:])
            inner, _, tail = tail.partition("\\,d\\")
            letter_name = re.match("[a-z]+", tail)
            assert letter_name
            parts = (lower, upper, inner, f"\\{letter_name[0]}")
            out.append(_integral(parts, made=from_latex))
            rest = tail[letter_name.end() :]
            continue
        elif rest.startswith(r"\sqrt"):
            inner, rest = _group(rest[5:])
            out.append(Token("root", from_latex(inner)))
            continue
        elif seen := re.match(r"\^\\circ", rest):
            out.append(Token("operator", "°"))
        elif seen := re.match(r"\^\{(-?\d+)\}", rest):
            out.append(Token("raised", int(seen[1])))
        elif seen := re.match(r"\\(cos|sin|arctan)(?![a-z])", rest):
            out.append(Token("function", seen[1].replace("arctan", "atan")))
        elif seen := re.match(r"(\d+(?:\.\d+)?)(\\ldots)?", rest):
            out.append(_number(seen[1] + ("…" if seen[2] else "")))
        elif seen := re.match(r"\\pi(?![a-z])", rest):
            out.append(Token("symbol", "pi"))
        elif seen := re.match(r"\\ldots", rest):
            out.append(Token("symbol", "…"))
        elif seen := re.match(r"\\cdot|\\angle", rest):
            out.append(Token("operator", {r"\cdot": "·", r"\angle": "∠"}[seen[0]]))
        elif seen := re.match(r"[-+()]", rest):
            out.append(Token("operator", seen[0]))
        elif seen := letter.match(rest):
            below = (seen["text"] or seen["below"] or "").replace("$-$", "−").replace("-", "−")
            name = seen["letter"].removeprefix("\\") + "′" * len(seen["primes"])
            out.append(Token("symbol", f"{name}_{below}" if below else name))
        else:
            raise UnreadableError(f"{rest!r} in {print_!r}")
        rest = rest[seen.end() :]
    return out


def _group(rest: str) -> tuple[str, str]:
    """What stands in the braces at the beginning, and what follows them."""
    depth = 0
    for place, char in enumerate(rest):
        depth += (char == "{") - (char == "}")
        if depth == 0:
            return rest[1:place], rest[place + 1 :]
    raise UnreadableError(rest)


def from_mathml(element: ET.Element) -> list[Token]:
    """The tokens of a formula in MathML: rows have no brackets but those that are seen."""
    tag, said = element.tag, (element.text or "").strip()
    children = list(element)
    if tag == "mspace":
        return []
    if tag == "mfrac":
        above, below = children
        return [Token("fraction", (from_mathml(above), from_mathml(below)))]
    if tag == "msqrt":
        return [Token("root", _row(children))]
    if tag == "msup":
        base, above = children
        return [*from_mathml(base), Token("raised", int((above.text or "").replace("−", "-")))]
    if tag == "msub":
        head, below = children
        name = GREEK.get(head.text or "", head.text or "")
        return [Token("symbol", f"{name}_{(below.text or '').strip()}")]
    if tag == "mn":
        return from_text(said)
    if tag == "mi":
        if said in FUNCTIONS:
            return [Token("function", said)]
        return [Token("symbol", {"π": "pi"}.get(said, GREEK.get(said, said)))]
    if tag == "mo":
        return [] if said == "\u2061" else [Token("operator", said)]
    return _row(children)


def _row(children: Sequence[ET.Element]) -> list[Token]:
    out: list[Token] = []
    for place, child in enumerate(children):
        if child.tag == "msubsup":
            end = next(n for n, c in enumerate(children) if n > place and c.text == "d")
            _sign, lower, upper = child
            bounds = (from_mathml(lower), from_mathml(upper))
            letter = from_mathml(children[end + 1])[0].value
            whole = Token("integral", (*bounds, _row(children[place + 1 : end]), letter))
            return [*out, whole, *_row(children[end + 2 :])]
        dots = child.tag == "mo" and child.text == "…"
        if dots and place and children[place - 1].tag == "mn":
            out[-1] = _number((children[place - 1].text or "") + "…")
        else:
            out += [Token("symbol", "…")] if dots else from_mathml(child)
    return out


class _Reader:
    """Tokens read from left to right, evaluated as they are read."""

    def __init__(self, tokens: Sequence[Token], values: Mapping[str, acb | arb]) -> None:
        self.tokens, self.place, self.values = tokens, 0, values

    @property
    def next(self) -> Token:
        return self.tokens[self.place] if self.place < len(self.tokens) else Token("end", "")

    def taken(self, *operators: str) -> str:
        if self.next.kind == "operator" and self.next.value in operators:
            self.place += 1
            return self.tokens[self.place - 1].value
        return ""

    def sum(self) -> acb:
        out = self.signed()
        while sign := self.taken("+", "−", "-"):
            out = out + self.vector() if sign == "+" else out - self.vector()
        return out

    def signed(self) -> acb:
        return -self.vector() if self.taken("−", "-") else self.vector()

    def vector(self) -> acb:
        length = self.quotient()
        if not self.taken("∠"):
            return length
        minus = self.taken("−", "-")
        angle = self.quotient()
        return length * (acb(0, 1) * (-angle if minus else angle)).exp()

    def quotient(self) -> acb:
        out = self.side_by_side()
        while operator := self.taken("·", "/"):
            out = out * self.side_by_side() if operator == "·" else out / self.side_by_side()
        return out

    def side_by_side(self) -> acb:
        out = self.factor()
        while self.next.kind not in ("end", "operator") or self.next.value in ("(", "√"):
            out *= self.factor()
        return out

    def factor(self) -> acb:
        if self.next.kind == "function":
            return self.function()
        out = self.atom()
        if self.next.kind == "raised":
            out = out ** self.raised()
        if self.taken("°"):
            out = out * arb.pi() / 180
        return out

    def raised(self) -> int:
        self.place += 1
        return self.tokens[self.place - 1].value

    def function(self) -> acb:
        function = FUNCTIONS[self.next.value]
        self.place += 1
        exponent = self.raised() if self.next.kind == "raised" else 1
        if exponent < 1:
            raise UnreadableError("an inverse function, or a reciprocal?")
        if self.taken("("):
            argument = self.closed()
        else:
            argument = self.factor_without_brackets()
            while self.next.kind in ("number", "symbol", "fraction", "root"):
                argument *= self.factor_without_brackets()
        return function(argument) ** exponent

    def factor_without_brackets(self) -> acb:
        if self.next.kind not in ("number", "symbol", "fraction", "root"):
            raise UnreadableError(f"the argument of a function begins with {self.next.value!r}")
        return self.factor()

    def closed(self) -> acb:
        out = self.sum()
        if not self.taken(")"):
            raise UnreadableError("a bracket is not closed")
        return out

    def atom(self) -> acb:
        token = self.next
        self.place += 1
        if token.kind == "number":
            if self.next.kind == "number":
                raise UnreadableError("two numbers side by side")
            return token.value
        if token.kind == "symbol":
            return acb(arb.pi()) if token.value == "pi" else acb(self.values[token.value])
        if token.kind == "fraction":
            above, below = token.value
            return value(above, self.values) / value(below, self.values)
        if token.kind == "integral":
            lower, upper, inner, letter = token.value
            return acb.integral(
                lambda point, _: value(inner, {**self.values, letter: point}),
                value(lower, self.values),
                value(upper, self.values),
            )
        if token.kind == "root":
            return value(token.value, self.values).sqrt()
        if token == ("operator", "("):
            return self.closed()
        if token == ("operator", "√"):
            return self.atom().sqrt()
        raise UnreadableError(
            f"{token.value!r} at {self.place} of {[t.value for t in self.tokens]}"
        )


def value(tokens: Sequence[Token], values: Mapping[str, acb | arb]) -> acb:
    """What tokens come to, in a ball that holds every number they may stand for."""
    reader = _Reader(tokens, values)
    out = reader.sum()
    if reader.next.kind != "end":
        raise UnreadableError(f"{reader.next.value!r} is left over")
    return out
