"""Exports that other packages add, by entry points of the group `crankstar.exports`.

An entry point names a function (engine) -> str or bytes, the content of the file; its name is that
of `crankstar export --to`.
"""

from __future__ import annotations

from collections.abc import Callable
from inspect import signature

from crankstar.engine.engine import Engine
from crankstar.engine.packages import Added, PackageError, Words, told_of
from crankstar.language.messages import N_, MessageError, _
from crankstar.language.quoting import given

PROGRAMS = ("exudyn", "opentorsion", "ross")
"""The programs for which this package writes an engine itself."""


def _checked(found: object, words: Words) -> Callable[[Engine], bytes]:
    """An export of another package, which gives the content of a file. Raises MessageError."""
    needed = MessageError(
        _("an export is a function (engine) of an Engine that gives text or bytes")
    )
    if not callable(found):
        raise needed
    try:
        signature(found).bind(None)
    except TypeError:
        raise needed from None

    def content(engine: Engine) -> bytes:
        try:
            made = found(engine)
            if isinstance(made, str):
                return made.encode()
        except MessageError:
            raise
        except Exception as error:
            raise PackageError(
                "package {package}: its export {name} ends with an error ({why})",
                **{**words, "why": told_of(error)},
            ) from error
        if isinstance(made, bytes):
            return made
        raise PackageError(
            "package {package}: its export {name} gives {made}, where an export gives text or "
            "bytes",
            **{**words, "made": given(made)},
        )

    return content


ADDED: Added[Callable[[Engine], bytes]] = Added(
    "crankstar.exports", N_("export"), PROGRAMS, _checked
)
"""The exports of other packages."""
