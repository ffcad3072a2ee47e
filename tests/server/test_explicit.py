"""The explicit form by the API."""

from __future__ import annotations

import tomllib
from typing import Any

import pytest
from tests.web.serving import Server

from crankstar.files import catalog


def printed(exhibit: dict[str, Any]) -> list[tuple[str, ...]]:
    """The table of orders as it is read: to five digits."""
    return [
        tuple(row[key] for key in ("label", "quantity", "up", "right", "path", "greatest"))
        for row in exhibit["table"]
    ]


@pytest.mark.release
def test_the_explicit_form_of_an_engine_is_the_same_engine(server: Server) -> None:
    for name in ("v8-cross-plane", "kr250-racer", "radial-9"):
        tree = server.ask("api/explicit", {"engine": name}).json["tree"]
        assert "layout" not in tree
        one, other = (server.ask("api/exhibit", {"engine": engine}).json for engine in (name, tree))
        assert printed(one) == printed(other)
        assert one["strokes"] == other["strokes"]


@pytest.mark.release
@pytest.mark.parametrize("more", [{}, {"factor": 0.5, "weights": "webs", "shafts": "needed"}])
def test_a_fitted_engine_keeps_the_sources_of_its_file(
    server: Server, more: dict[str, Any]
) -> None:
    short = catalog.tree_of("audi-25-tfsi")[1]
    tree = server.ask("api/fitted", {"engine": short, **more}).json["exhibit"]["file"]
    assert tree["provenance"] == short["provenance"]
    saved = tomllib.loads(server.ask("api/toml", {"engine": tree}).json["toml"])
    assert saved["provenance"] == short["provenance"]


def test_no_source_stays_of_a_key_that_is_gone(server: Server) -> None:
    short = catalog.tree_of("audi-25-tfsi")[1]
    sources = short["provenance"] | {
        "cycle": {"status": "published", "source": "a default that is not written"}
    }
    assert {"layout.bore_pitch", "cylinder.stroke", "firing_order", "speed"} <= set(sources)
    answer = server.ask("api/explicit", {"engine": short | {"provenance": sources}}).json
    tree = answer["tree"]
    kept = {"firing_order", "speed", "cycle", *(key for key in sources if key.startswith("gas."))}
    assert set(tree["provenance"]) == kept
    saved = tomllib.loads(server.ask("api/toml", {"engine": tree}).json["toml"])
    assert set(saved["provenance"]) == kept


def test_sources_of_the_explicit_form_stay_with_its_parts(server: Server) -> None:
    tree = server.ask("api/explicit", {"engine": "i4"}).json["tree"]
    told = {"status": "computed", "source": "here"}
    kept = [
        "shaft[1].throw[2].angle",
        "cylinders[4].z",
        "shaft[1].speed_ratio",
        "shaft",
        "shaft.throw.radius",
        "cylinders.z",
    ]
    gone = [
        "shaft[1].throw[9].angle",
        "shaft[2].name",
        "cylinder.bore",
        "shaft.weight.angle",
        "shaft[0]",
        "layout",
    ]
    tree["provenance"] = dict.fromkeys([*kept, *gone], told)
    again = server.ask("api/explicit", {"engine": tree}).json["tree"]
    assert set(again["provenance"]) == set(kept)


def test_what_is_no_engine_has_no_explicit_form(server: Server) -> None:
    answer = server.ask("api/explicit", {"engine": {"name": "x", "layout": {"type": "vee"}}})
    assert answer.status == 422
    assert {problem["path"] for problem in answer.json["problems"]} == {
        "layout.banks",
        "layout.throws",
    }
