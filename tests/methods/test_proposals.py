"""What the verdict proposes betters the engine as it is."""

from __future__ import annotations

from fractions import Fraction

import pytest

from crankstar import load
from crankstar.analyses.verdict.facts import verdict
from crankstar.engine.engine import Engine
from crankstar.files import catalog, engine_of, toml, tree_of
from crankstar.mechanics.balance import balance
from crankstar.mechanics.bounds import size
from crankstar.mechanics.remains import summed
from crankstar.remedy import RemedyError, fitting, needs
from crankstar.tables.cures import cure_lines, proposal

QUICK = ("i4", "gm-3800", "single", "kr250-racer", "v8-cross-plane", "harley-45")
EVERY = [
    name if name in QUICK else pytest.param(name, marks=pytest.mark.release)
    for name in catalog.names()
]


def first_order(engine: Engine) -> tuple[float, float]:
    sums = summed(balance(engine))
    return size(sums.force, 1.0), size(sums.couple, 1.0)


def balanced(engine: Engine) -> list[Engine]:
    """The engine as `balance -o` writes it: by a factor, and with the shafts it then needs."""
    out = [fitting.by_factor(engine, factor=factor, weights="webs") for factor in (0.5, 0.3)]
    for one in out[:1]:
        try:
            shafts = fitting.with_shafts(one, ratios="all", places=fitting.ShaftPlaces())
        except RemedyError:
            continue
        out.append(shafts)
    return [engine_of(tree_of(toml(one))) for one in out]


@pytest.mark.parametrize("name", EVERY)
def test_counterweights_are_proposed_only_where_they_better_the_engine(name: str) -> None:
    engine = load(name)
    for one in (engine, *balanced(engine)):
        cranks = {shaft.speed_ratio for shaft in one.shafts if shaft.throws}
        turning = any(need.ratio in cranks for need in needs(one, highest=1))
        sentence = proposal(one)
        if sentence:
            assert turning
            before, after = first_order(one), first_order(fitting.quiet_cranks(one)[0])
            assert all(
                new <= old * (1 + 1e-6) + 1e-9 for old, new in zip(before, after, strict=True)
            )
            assert any(new < old for old, new in zip(before, after, strict=True))


def test_an_engine_without_a_first_order_gets_no_counterweights() -> None:
    """The engine of the issue: by a factor of a half with a shaft at minus crank speed."""
    weighted = fitting.by_factor(load("harley-45"), factor=0.5, weights="webs")
    quiet = fitting.with_shafts(weighted, ratios=[Fraction(-1)], places=fitting.ShaftPlaces())
    assert max(first_order(quiet)) < 1e-9
    assert proposal(quiet) == ""
    about = [fact.about for fact in verdict(quiet, relatives=False)]
    assert about.count("cure") == len(cure_lines(quiet, needs(quiet)))
