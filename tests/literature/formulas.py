"""Formulas of the documents, evaluated as they stand: a small reader of the LaTeX they use.

A formula is read into a value by recursive descent. Names are letters with their subscripts and
primes, as they are written (`P''`, `F_p`, `\\beta''`); what stands side by side is multiplied.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

DOCS = Path(__file__).parents[2] / "docs"
TOKEN = re.compile(
    r"\\operatorname\{(\w+)\}|\\([A-Za-z]+)|(\d+(?:\.\d+)?)|([A-Za-z])|('+)|([-+=(){}\[\]^_/,|&])"
)
SPACES = re.compile(r"\\[,;! ]|\\q?quad|\\left|\\right|\\text\{[^}]*\}|~")
FUNCTIONS: dict[str, Callable[[Any], Any]] = {
    "cos": np.cos,
    "sin": np.sin,
    "tan": np.tan,
    "exp": np.exp,
    "Re": np.real,
    "Im": np.imag,
    "conj": np.conj,
    "arcosh": np.arccosh,
}
PRODUCTS = ("cdot", "times")
CLOSING = {"(": ")", "[": "]", "|": "|"}
ENDS = ("", "+", "-", "=", ")", "]", "}", ",")


class FormulaError(ValueError):
    """A formula, or a name in one, that cannot be read."""


def formulas(page: str) -> list[str]:
    """The displayed formulas of a page, each row of an aligned one by itself."""
    text = (DOCS / page).read_text(encoding="utf-8")
    out: list[str] = []
    for fence in re.findall(r"^```math\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        body = re.sub(r"\\(begin|end)\{\w+\*?\}", "", fence)
        out += [" ".join(row.split()) for row in body.split(r"\\") if row.strip()]
    return out


class Reader:
    """One formula with the values of its names."""

    def __init__(self, latex: str, names: Mapping[str, Any]) -> None:
        self.latex, self.names = latex, names
        bare = re.sub(r"_\\text\{(\w+)\}", r"_{\1}", latex).replace(r",\text{up}", ",up")
        bare = re.sub(r"\\bar\{(\w)\}_(\w)", r"\\bar{\1_\2}", bare)
        bare = SPACES.sub(" ", bare.replace(r",\text{right}", ",right")).replace("&", " ")
        self.tokens = [match.group(0) for match in TOKEN.finditer(bare)]
        left = TOKEN.sub("", bare).strip()
        if left:
            raise FormulaError(f"{latex}: {left}")
        self.at, self.bars = 0, 0

    @property
    def next(self) -> str:
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self, wanted: str = "") -> str:
        token = self.next
        if not token or (wanted and token != wanted):
            raise FormulaError(
                f"{self.latex}: {wanted or 'more'} is wanted at {token or 'the end'}"
            )
        self.at += 1
        return token

    def whole(self) -> Any:
        value = self.sum()
        if self.next:
            raise FormulaError(f"{self.latex}: {self.next} is left")
        return value

    def sum(self) -> Any:
        sign = -1 if self.next == "-" else 1
        if self.next in ("+", "-"):
            self.take()
        value = sign * self.product()
        while self.next in ("+", "-"):
            sign = 1 if self.take() == "+" else -1
            value = value + sign * self.product()
        return value

    def product(self) -> Any:
        value = self.power()
        while not self.ends:
            if self.next.removeprefix("\\") in PRODUCTS:
                self.take()
                continue
            if self.next == "/":
                self.take()
                value = value / self.power()
            else:
                value = value * self.power()
        return value

    def power(self) -> Any:
        value = self.atom()
        if self.next == "^":
            self.take()
            value = value ** self.group()
        return value

    def group(self) -> Any:
        """What is in braces, or one letter or digit."""
        if self.next != "{":
            token = self.take()
            if token.isdigit() and len(token) > 1:  # \tfrac12
                self.at -= 1
                self.tokens[self.at : self.at + 1] = [*token]
                token = self.take()
            return float(token) if token.isdigit() else self.named(token)
        self.take("{")
        value = self.sum()
        self.take("}")
        return value

    def atom(self) -> Any:
        sign = self.take()
        word = sign.removeprefix("\\").removeprefix("operatorname{").removesuffix("}")
        if sign in CLOSING:
            self.bars += sign == "|"
            value = self.sum()
            self.take(CLOSING[sign])
            self.bars -= sign == "|"
            return np.abs(value) if sign == "|" else value
        if re.fullmatch(r"[\d.]+", sign):
            return float(sign)
        if word in ("frac", "tfrac"):
            above = self.group()
            return above / self.group()
        if word == "sqrt":
            return np.sqrt(self.group())
        if word in ("overline", "bar"):
            return np.conj(self.group())
        if word in FUNCTIONS:
            return self.applied(FUNCTIONS[word])
        return self.named(sign)

    def applied(self, function: Callable[[Any], Any]) -> Any:
        r"""A function of what is in brackets, or of the product behind it: \cos k\psi."""
        raised: Any = 1
        if self.next == "^":
            self.take()
            raised = self.group()
        if self.next == "(":
            return function(self.power()) ** raised
        value = self.power()
        while not (self.ends or self.next in (*CLOSING, "/") or self.is_function):
            value = value * self.power()
        return function(value) ** raised

    @property
    def ends(self) -> bool:
        """Whether a product ends here; a bar opens one where none is open."""
        return self.next in ENDS or (self.next == "|" and self.bars > 0)

    @property
    def is_function(self) -> bool:
        return re.sub(r"\\operatorname\{|[\\}]", "", self.next) in FUNCTIONS

    def named(self, token: str) -> Any:
        name = token.removeprefix("\\")
        if self.next == "_":
            self.take()
            sub = self.take()
            if sub == "{":
                inner: list[str] = []
                while self.next != "}":
                    inner.append(self.take().removeprefix("\\"))
                self.take("}")
                sub = "".join(inner)
            name += "_" + sub.removeprefix("\\")
        if self.next.startswith("'"):
            name += self.take()
        if name not in self.names:
            raise FormulaError(f"{self.latex}: {name} has no value")
        return self.names[name]


def value(latex: str, names: Mapping[str, Any]) -> Any:
    r"""A formula as a value.

    >>> round(float(value(r"\frac{1}{2} r \cos 2\psi", {"r": 3.0, "psi": 0.0})), 9)
    1.5
    """
    return Reader(latex, {"pi": np.pi, "i": 1j, "e": np.e, **names}).whole()
