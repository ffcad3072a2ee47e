"""Free fonts for letters that the fonts of a machine may lack, from packages that carry them.

`pip install "crankstar[fonts]"` brings Noto Sans JP and Noto Sans, under the SIL Open Font License.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Sequence
from functools import lru_cache
from importlib.resources import files
from pathlib import Path
from shutil import which
from subprocess import run
from typing import NamedTuple
from unicodedata import east_asian_width


class Script(NamedTuple):
    """Letters that need a font: their language, a package and its file with them."""

    language: str
    family: str
    package: str
    place: tuple[str, ...]


JAPANESE = Script("ja", "Noto Sans JP", "pylopdf_fonts_jp", ("NotoSansJP-Regular.otf",))
CYRILLIC = Script("ru", "Noto Sans", "fontpkg_noto_sans", ("files", "NotoSans[wdth,wght].ttf"))
SCRIPTS = (CYRILLIC, JAPANESE)


def letters_of(script: Script, text: Iterable[str]) -> str:
    """The letters of a text that are of a script, each once.

    >>> letters_of(JAPANESE, "慣性 a 力"), letters_of(CYRILLIC, "сила F")
    ('力性慣', 'аилс')
    """
    return "".join(sorted(letter for letter in set(text) if _is_of(script, letter)))


def _is_of(script: Script, letter: str) -> bool:
    if script is CYRILLIC:
        return "\u0400" <= letter <= "\u04ff"
    return letter >= "\u2e80" and east_asian_width(letter) in "WF"


def font_file(script: Script) -> Path | None:
    """The file of a font with the letters of a script, None where its package is not installed."""
    try:
        place = files(script.package)
    except ModuleNotFoundError:
        return None
    found = Path(str(place)).joinpath(*script.place)
    return found if found.is_file() else None


@lru_cache
def lacks(language: str) -> bool:
    """Whether no font here has the letters of a language, as far as that can be known."""
    lister = which("fc-list")
    if sys.platform in ("win32", "darwin") or lister is None:
        return False
    listed = run(  # noqa: S603 - found on the path
        [lister, f":lang={language}", "family"], capture_output=True, check=False
    )
    return listed.returncode == 0 and not listed.stdout.strip()


def missing_letters(text: str) -> Sequence[str]:
    """The letters of a text, one item a script, for which there is no font here at all."""
    return [
        letters
        for script in SCRIPTS
        if (letters := letters_of(script, text))
        and font_file(script) is None
        and lacks(script.language)
    ]


@lru_cache
def registered() -> None:
    """Have vl-convert draw with the installed fonts."""
    import vl_convert

    for script in SCRIPTS:
        place = font_file(script)
        if place is not None:
            vl_convert.register_font_directory(str(place.parent))
