"""`crankstar serve`: what is refused before anything is served."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from crankstar.server import running


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["--port", "70000"], "give a whole number from 0 to 65535"),
        (["--port", "http"], '--port: unable to convert "http" into a whole number'),
        (["--port", "0x10"], '--port: unable to convert "0x10" into a whole number'),
        (["--port=-1"], "--port -1: give a whole number from 0 to 65535"),
        (["--host", "no.such.host.invalid"], "is not an address of this machine"),
        (["--host", ""], '--host "" is not an address of this machine'),
        (["--host", "192.0.2.1", "--port", "0"], "cannot be used"),
        (["no-such-engine"], "there is no such engine in the catalog"),
        (["i4", "--set", "cycle=three-stroke"], "cycle is "),
    ],
)
def test_what_cannot_be_served_is_refused_before_it_starts(
    refused: Callable[..., str], monkeypatch: pytest.MonkeyPatch, words: list[str], told: str
) -> None:
    def served(*_: object, **__: object) -> None:
        raise AssertionError("this is served")

    monkeypatch.setattr(running, "serve", served)
    assert told in refused("serve", *words)
