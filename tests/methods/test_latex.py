"""LaTeX takes what is right and says what is wrong, so that a test may ask it about a formula."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.latex import compiled

pytestmark = pytest.mark.release

PREAMBLE = r"""\documentclass{article}
\usepackage[T1]{fontenc}
\usepackage{lmodern}
\usepackage{amsmath}
"""
GREEK = r"\DeclareUnicodeCharacter{03C9}{\ensuremath{\omega}}"


def document(body: str, *, preamble: str = PREAMBLE) -> str:
    return f"{preamble}\\begin{{document}}\n{body}\n\\end{{document}}\n"


def test_aligned_equations_with_umlauts_and_greek_letters_are_typeset(tmp_path: Path) -> None:
    body = r"""Hübe und Größen bei der Drehzahl ω:
\begin{align*}
    x &= r \cos\varphi + l \sqrt{1 - \lambda^2 \sin^2\varphi} \\
    F &= -m\,r\,\omega^2 \sum_{k} A_k \cos k\varphi
\end{align*}"""
    result = compiled(document(body, preamble=PREAMBLE + GREEK), tmp_path)
    assert result.ok, str(result)
    assert (result.pages, result.errors) == (1, ())
    assert (tmp_path / "document.pdf").read_bytes().startswith(b"%PDF")


def test_pages_are_counted(tmp_path: Path) -> None:
    assert compiled(document(r"one \newpage two \newpage three"), tmp_path).pages == 3


@pytest.mark.parametrize(
    ("body", "error"),
    [
        (r"\[ x = \nonsense y \]", r"line 6: Undefined control sequence. At: \[ x = \nonsense"),
        (r"\[ x = y } \]", r"line 6: Extra }, or forgotten $. At: \[ x = y }"),
        (r"\[ \frac{1}{2 \]", r"File ended while scanning use of \frac"),
        (
            r"\begin{align*} x &= 1 \end{align}",
            r"line 6: LaTeX Error: \begin{align*} on input line 6 ended by \end{align}.",
        ),
        ("the speed ω", "line 6: LaTeX Error: Unicode character ω (U+03C9)"),
    ],
)
def test_what_is_broken_is_reported_with_its_line(body: str, error: str, tmp_path: Path) -> None:
    result = compiled(document(body), tmp_path)
    assert not result.ok
    assert any(said.startswith(error) for said in result.errors), str(result)
