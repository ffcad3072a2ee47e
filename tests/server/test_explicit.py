"""The explicit form by the API."""

from __future__ import annotations

from typing import Any

from tests.web.serving import Server


def printed(exhibit: dict[str, Any]) -> list[tuple[str, ...]]:
    """The table of orders as it is read: to five digits."""
    return [tuple(row[key] for key in ("label", "quantity", "up", "right", "path", "greatest")) for row in exhibit["table"]]


def test_the_explicit_form_of_an_engine_is_the_same_engine(server: Server) -> None:
    for name in ("v8-cross-plane", "kr250-racer", "radial-9"):
        tree = server.ask("api/explicit", {"engine": name}).json["tree"]
        assert "layout" not in tree
        one, other = (server.ask("api/exhibit", {"engine": engine}).json for engine in (name, tree))
        assert printed(one) == printed(other)
        assert one["strokes"] == other["strokes"]


def test_what_is_no_engine_has_no_explicit_form(server: Server) -> None:
    answer = server.ask("api/explicit", {"engine": {"name": "x", "layout": {"type": "vee"}}})
    assert answer.status == 422
    assert {problem["path"] for problem in answer.json["problems"]} == {"layout.banks", "layout.throws"}
