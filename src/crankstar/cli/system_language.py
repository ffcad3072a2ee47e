"""The language of the system, as POSIX names it."""

from __future__ import annotations

from collections.abc import Mapping

from crankstar.language.messages import LANGUAGES


def of_system(environment: Mapping[str, str]) -> str:
    """The language of the messages of a system, one of LANGUAGES; English where it is no other.

    The first of LC_ALL, LC_MESSAGES and LANG that is not empty decides.

    >>> of_system({"LANG": "ja_JP.UTF-8"}), of_system({"LC_ALL": "C", "LANG": "ja_JP.UTF-8"})
    ('ja', 'en')
    """
    names = (environment.get(name) for name in ("LC_ALL", "LC_MESSAGES", "LANG"))
    name = next(filter(None, names), "").lower()
    spoken = name.replace(".", "_").replace("@", "_").partition("_")[0]
    return spoken if spoken in LANGUAGES else LANGUAGES[0]
