"""Any engine, good or spoilt, and any question of the API: answers or sentences only."""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import pytest
import schemathesis
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from schemathesis.checks import CHECKS
from tests.holding import PATIENCE
from tests.spoilt import TREES, mutated
from tests.strategies import OF_ANY_KIND, RELEASE
from tests.web.serving import Server

from crankstar import files
from crankstar.engine.engine import Engine
from crankstar.files import EngineFileError
from crankstar.files.box import spread
from crankstar.files.source import tree_of_keys
from crankstar.page.records import Exhibit
from crankstar.server import tasks
from crankstar.server.application import application
from crankstar.server.refusal import Refused
from crankstar.server.routes import bounded
from crankstar.server.workers import Workers

API = schemathesis.openapi.from_dict(application(workers=Workers(1, seconds=1.0)).description())
PATIENT = [HealthCheck.too_slow, HealthCheck.data_too_large, HealthCheck.filter_too_much]
ANY_ENGINE = st.one_of(*OF_ANY_KIND.values())
MANY = range(15, 3000, 199)
"""Where rows of seeds begin, each short enough for a machine that is busy."""


def answer(task: Callable[..., bytes], *asked: Any) -> Any:
    """The answer of a task as strict JSON; None where it refuses in sentences."""

    def refuse(name: str) -> Any:
        raise AssertionError(f"{name} is no JSON")

    try:
        return json.loads(task(*asked), parse_constant=refuse)
    except Refused as caught:
        refusal = caught
    assert refusal.status == 422
    assert json.loads(refusal.body)["problems"]
    return None


def check(engine: str | dict[str, Any], chance: random.Random) -> bool:
    """Asks everything of an engine that is not too much; whether it was one."""
    shown = answer(tasks.exhibit, engine)
    text = answer(tasks.toml, engine)
    if shown is None:
        if text is not None:  # ranges of estimated values at whose ends there is no engine
            with pytest.raises(EngineFileError, match=r"provenance"):
                spread(
                    tree_of_keys(engine)[1] if isinstance(engine, dict) else files.tree_of(engine)
                )
        return False
    assert text is not None
    exhibit = Exhibit.model_validate_json(json.dumps(shown))
    answer(tasks.fitted, engine, {})
    answer(tasks.chart, engine, chance.choice(exhibit.charts).key)
    answer(tasks.derivation, engine, chance.choice(exhibit.derivations).key)
    assert files.engine_of(files.tree_of(text["toml"])).name == exhibit.name
    return True


@pytest.mark.release
@given(engine=ANY_ENGINE, seed=st.integers(0, 1000))
@settings(max_examples=200 if RELEASE else 2, suppress_health_check=PATIENT)
def test_all_that_is_asked_of_any_engine_is_answered(engine: Engine, seed: int) -> None:
    assert check(json.loads(json.dumps(files.explicit(engine))), random.Random(seed))  # noqa: S311


@pytest.mark.parametrize(
    "seeds",
    [
        range(15),
        *(pytest.param(range(at, at + MANY.step), marks=pytest.mark.release) for at in MANY),
    ],
    ids=lambda seeds: f"from {seeds[0]}",
)
def test_a_spoilt_engine_is_answered_or_refused_in_sentences(seeds: range, seed: int) -> None:
    good = 0
    for number in seeds:
        chance = random.Random(seed + number)  # noqa: S311
        tree = mutated(chance.choice(TREES), chance)
        try:
            tree = json.loads(json.dumps(tree))
        except (TypeError, ValueError):
            continue  # it cannot come over the wire
        with suppress(Refused):  # it is too large
            good += check(bounded(tree), chance)
    assert 0 < good < len(seeds)


@pytest.mark.many(first=2)
@API.parametrize()
@settings(max_examples=100 if RELEASE else 8, suppress_health_check=PATIENT, deadline=None)
def test_whatever_the_description_allows_is_answered_as_it_says(case: Any, server: Server) -> None:
    """Schemathesis: no server failure; status, kind, headers and shape are as described."""
    if case.operation.path == "/api/search" and case.method == "POST":
        case.body = (
            {"cylinders": 1} if isinstance(case.body, dict) else case.body
        )  # searches would take all the processors
    found = case.call(base_url=server.address.rstrip("/"), timeout=PATIENCE)
    case.validate_response(found, excluded_checks=REFUSED_IN_WORDS)


REFUSED_IN_WORDS = [
    check
    for check in CHECKS.get_all()
    if check.__name__ in ("positive_data_acceptance", "unsupported_method")
]
"""Beyond the schema: engines refused with 422, unknown methods with 400 or 405."""
