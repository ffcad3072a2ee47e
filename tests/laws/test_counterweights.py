"""Counterweights: what they take away, whatever the engine, and what no counterweight can touch."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from crankstar import load, spectra, total
from crankstar.engine.engine import Engine
from crankstar.engine.records import Rod
from crankstar.files import catalog, engine_of
from crankstar.mechanics.balance import balance
from crankstar.remedy import RemedyError, bobweight, loads, with_counterweights
from crankstar.spectra import Spectrum

pytestmark = pytest.mark.quick

SINGLE_SHAFT = [name for name in catalog.names() if len(load(name).shafts) == 1]
PLAIN = [
    name
    for name in SINGLE_SHAFT
    if not any(c.articulated or c.offset for c in load(name).cylinders)
]


def first(engine: Engine, quantity: str) -> tuple[complex, complex]:
    """The first-order vectors with the crank and against it."""
    one: Spectrum = spectra.selected(getattr(total(balance(engine)), quantity), [1.0])
    return complex(one.forward[0]), complex(one.backward[0])


@pytest.mark.many(first=33)
@pytest.mark.parametrize("name", SINGLE_SHAFT)
def test_weights_in_planes_do_what_weights_at_the_throws_do(name: str) -> None:
    engine = load(name)
    places = [throw.z for throw in engine.shafts[0].throws]
    reach = engine.pitch / 2
    planes = [
        max(places) + reach,
        min(places) - reach / 3,
        (max(places) + min(places)) / 2,
    ]  # not about the middle
    for factor in (0.0, 0.5, 1.0):
        at_throws = with_counterweights(engine, factor=factor)
        in_planes = with_counterweights(engine, factor=factor, planes=planes)
        for quantity in ("force", "couple"):
            wanted, found = first(at_throws, quantity), first(in_planes, quantity)
            assert np.allclose(found, wanted, rtol=0, atol=1e-12 * len(engine.cylinders))


@pytest.mark.many(first=32)
@pytest.mark.parametrize("name", SINGLE_SHAFT)
def test_no_counterweight_touches_what_turns_against_the_crank(name: str) -> None:
    engine = load(name)
    for quantity in ("force", "couple"):
        before, after = (
            first(engine, quantity),
            first(with_counterweights(engine, factor=0.7), quantity),
        )
        assert after[1] == pytest.approx(before[1], abs=1e-12 * len(engine.cylinders))


@pytest.mark.many(first=63)
@pytest.mark.parametrize(
    "name",
    [
        name
        for name in SINGLE_SHAFT
        if not any(c.articulated or c.offset for c in load(name).cylinders)
    ],
)
def test_half_of_the_reciprocating_mass_takes_away_all_that_turns_with_the_crank(name: str) -> None:
    balanced = with_counterweights(load(name), factor=0.5)
    for quantity in ("force", "couple"):
        assert abs(first(balanced, quantity)[0]) < 1e-12 * len(balanced.cylinders)


def test_half_leaves_a_circle_of_a_single_and_nothing_of_a_right_angled_twin() -> None:
    left = {
        name: first(with_counterweights(load(name), factor=0.5), "force")
        for name in ("single", "harley-45", "v2-90")
    }
    assert left["single"] == (pytest.approx(0, abs=1e-15), pytest.approx(0.5))
    assert abs(left["harley-45"][1]) == pytest.approx(np.sqrt(0.5))  # cos 45 deg
    assert abs(left["harley-45"][0]) < 1e-15
    assert np.abs(left["v2-90"]) == pytest.approx([0, 0], abs=1e-15)


def test_two_end_weights_take_away_the_couple_of_the_cross_plane_eight() -> None:
    balanced = with_counterweights(load("v8-cross-plane"), factor=0.5, planes=[2.0, -2.0])
    weights = balanced.shafts[0].weights
    assert np.abs(first(balanced, "couple")) == pytest.approx([0, 0], abs=1e-14)
    assert [weight.unbalance for weight in weights] == pytest.approx(
        [np.sqrt(10) / 4] * 2
    )  # sqrt(10) a over a span of 4 a
    assert abs(weights[0].angle - weights[1].angle) == pytest.approx(np.pi)


def test_a_rigid_rod_is_shared_between_its_ends() -> None:
    engine = load("audi-25-tfsi")
    rod = Rod(mass=0.6, centre=engine.first.rod_length / 3)
    cylinders = tuple(c.model_copy(update={"rod": rod}) for c in engine.cylinders)
    pin, plain = loads(engine.model_copy(update={"cylinders": cylinders}))[0], loads(engine)[0]
    assert pin.reciprocating - plain.reciprocating == pytest.approx(0.2)
    assert pin.rotating - plain.rotating == pytest.approx(0.4)
    assert bobweight(pin, 0.5) == pytest.approx(bobweight(plain, 0.5) + 0.5)


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ({"factor": -1.1}, "from -1 to 3"),
        ({"factor": 3.1}, "from -1 to 3"),
        ({"factor": float("nan")}, "from -1 to 3"),
        ({"factor": 0.5, "planes": [0.0]}, "two planes or more"),
        ({"factor": 0.5, "planes": [1.0, 1.0]}, "all different"),
        ({"factor": 0.5, "planes": [0.0, 9.0]}, "beyond the crankshaft"),
        ({"factor": 0.5, "planes": [0.0, float("nan")]}, "no position"),
        ({"factor": 0.5, "planes": [0.0, 1e-15]}, "closer than"),
    ],
)
def test_what_cannot_be_done_is_told(arguments: dict[str, object], told: str) -> None:
    with pytest.raises(RemedyError, match=told):
        with_counterweights(load("v8-cross-plane"), **arguments)  # pyright: ignore[reportArgumentType]


def test_other_shafts_keep_their_weights() -> None:
    tree = {
        "format": 1,
        "name": "one over a balance shaft",
        "shaft": [
            {"name": "crank", "throw": [{"angle": "0 deg", "radius": "40 mm"}]},
            {
                "name": "balancer",
                "speed_ratio": -1,
                "weight": [{"unbalance": "0.01 kg*m", "angle": "180 deg"}],
            },
        ],
        "cylinders": [
            {
                "number": 1,
                "shaft": "crank",
                "throw": 1,
                "rod_length": "160 mm",
                "reciprocating_mass": "0.5 kg",
            }
        ],
    }
    engine = engine_of(tree)
    balanced = with_counterweights(engine, factor=0.5)
    assert balanced.shafts[1] == engine.shafts[1]
    assert np.abs(first(balanced, "force")) == pytest.approx([0, 0], abs=1e-15)


Run = Callable[..., object]


def test_the_balanced_engine_is_a_file_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from crankstar import cli

    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as left:
        cli.main(["balance", "harley-45", "--factor", "0.5", "-o", "new.toml"])
    assert left.value.code == 0
    out = capsys.readouterr().out
    assert "The file gives no rotating mass" in out
    assert "the balance factor is 1." in out
    again = load(str(tmp_path / "new.toml"))
    assert first(again, "force") == pytest.approx(
        first(with_counterweights(load("harley-45"), factor=0.5), "force"), abs=1e-12
    )
