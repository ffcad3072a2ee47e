"""Signs that an encoding lacks, spelt with letters it has: `m r ω²` becomes `m r w^2`."""

from __future__ import annotations

import codecs
import re
import unicodedata

_SPELT = {
    "ω": "w",
    "°": " deg",
    "∠": "@",
    "λ": "lambda",
    "√": "sqrt ",
    "≤": "<=",
    "≥": ">=",
    "−": "-",
    "–": "-",
    "─": "-",
    "…": "...",
    "·": "*",
    "′": "'",
}
_RAISED = re.compile("[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+")


def spelt(text: str) -> str:
    """A text in ASCII.

    Indices follow `_`, powers `^`; Greek letters have their names, what has no spelling is `?`.

    >>> spelt("m r ω² A₂, 2 ∠ −45°, 3 cos(kθ)"), spelt("長")
    ('m r w^2 A_2, 2 @ -45 deg, 3 cos(ktheta)', '?')
    """
    text = _RAISED.sub(lambda power: "^" + unicodedata.normalize("NFKC", power.group()), text)
    return "".join(sign if sign.isascii() else _spelling(sign) for sign in text)


def _spelling(sign: str) -> str:
    if sign in _SPELT:
        return _SPELT[sign]
    if unicodedata.decomposition(sign).startswith("<sub>"):
        return "_" + unicodedata.normalize("NFKC", sign)
    name = unicodedata.name(sign, "")
    if name.startswith("GREEK SMALL LETTER "):
        return name.removeprefix("GREEK SMALL LETTER ").lower()
    plain = unicodedata.normalize("NFKD", sign).encode("ascii", "ignore").decode()
    return plain or ("#" if "BLOCK" in name else "?")


def _encoded(error: UnicodeError) -> tuple[str, int]:
    """The spelling of what an encoding lacks, as a handler of codec errors."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return spelt(error.object[error.start : error.end]), error.end


def register() -> str:
    """The name under which codecs know this spelling, for `errors=`."""
    codecs.register_error("crankstar.spelt", _encoded)
    return "crankstar.spelt"
