"""Roll minimised and limited by weights: against the finished engine, and against a scan."""

from __future__ import annotations

import numpy as np
import pytest
from tests.commands import Run
from tests.files.conftest import refused, run

import crankstar
from crankstar import spectra
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import balance, scales, total
from crankstar.mechanics.excitation import rolling_moment
from crankstar.remedy import (
    Aim,
    Limit,
    Plane,
    balance_shafts,
    best_weights,
    clashes,
    with_balance_shaft,
    with_counterweights,
)
from crankstar.remedy.aims import measured, setting
from crankstar.stars.engine_stars import stars_of, with_star

__all__ = ["refused", "run"]

AIMS = (Aim("roll"), Aim("roll", rms=True), Aim("roll", order=1.0), Aim("roll", order=2.0))


def rolled(engine: Engine, aim: Aim) -> float:
    """The aim of a finished engine from its rolling moment over the turn, m r^2 w^2."""
    moment = rolling_moment(total(balance(engine)))
    turns = spectra.period(moment)
    theta = np.linspace(0, 2 * np.pi * turns, 20_000 * turns, endpoint=False)
    values = np.real(spectra.value(moment, theta))
    if aim.order is not None:
        return float(2 * abs(np.mean(values * np.exp(-1j * aim.order * theta))))
    return float(np.sqrt(np.mean(values**2)) if aim.rms else np.abs(values).max())


def two_cranks() -> tuple[Engine, list[Plane]]:
    """A tandem twin, whose crankshafts stand on both sides of the reference axis, bare."""
    engine = crankstar.load("kr250-racer")
    bare = with_values(
        engine, shafts=tuple(with_values(shaft, weights=()) for shaft in engine.shafts)
    )
    return bare, [Plane(s.name, s.throws[0].z) for s in bare.shafts if s.throws]


@pytest.mark.many(first=2)
@pytest.mark.parametrize("aim", AIMS, ids=str)
def test_an_aim_of_roll_is_that_of_the_engine_with_the_weights(aim: Aim) -> None:
    engine, planes = two_cranks()
    assert measured(setting(engine, []), aim, np.zeros(0)) == pytest.approx(
        rolled(engine, aim), rel=1e-6, abs=1e-9
    )
    if aim.order == 2.0:
        return
    best = best_weights(engine, planes=planes, aim=aim)
    assert best.value == pytest.approx(rolled(best.engine, aim), rel=1e-6, abs=1e-7)
    assert best.bound <= best.value * (1 + 1e-6) + 1e-9
    assert best.value < 0.9 * best.before


@pytest.mark.release
def test_no_weights_of_a_scan_roll_less_than_the_best() -> None:
    engine, planes = two_cranks()
    aim = Aim("roll")
    best = best_weights(engine, planes=planes, aim=aim)
    case = setting(engine, planes)
    generator = np.random.default_rng(5)
    x = np.array([part for u in best.unbalance for part in (u.real, u.imag)])
    tried = [measured(case, aim, x + generator.normal(0, 0.2, x.size)) for _ in range(300)]
    assert min(tried) >= best.bound - 1e-9


@pytest.mark.release
def test_a_limit_of_roll_is_kept_by_the_engine_that_is_written() -> None:
    engine, planes = two_cranks()
    aim, free = Aim("roll", order=1.0), best_weights(engine, planes=planes, aim=Aim("force"))
    least = best_weights(engine, planes=planes, aim=aim).value
    most = (least + rolled(free.engine, aim)) / 2
    best = best_weights(engine, planes=planes, aim=Aim("force"), limits=[Limit(aim, most)])
    assert rolled(best.engine, aim) <= most * (1 + 1e-6) + 1e-9
    assert best.value >= free.value - 1e-7


@pytest.mark.parametrize("model", ["determinate", "continuous"])
def test_the_aim_of_bearings_is_by_the_model_that_is_named(model: str, run: Run) -> None:
    done = run("balance", "i4", "--minimise", "bearing", "--model", model)
    words = "one beam on its main bearings" if model == "continuous" else "hinged at its main"
    assert done.code == 0
    assert words in " ".join(done.out.split())


def test_roll_on_the_command_line(run: Run) -> None:
    done = run("balance", "kr250-racer", "--bare", "--minimise", "roll 1")
    assert done.code == 0
    assert "Roll of order 1" in done.out


@pytest.mark.many(first=6)
@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("i4", "--minimise", "roll"), "does not depend on the weights of these crankshafts"),
        (("i4", "--minimise", "roll 0"), "give an order above 0"),
        (("i4", "--minimise", "rolls"), "choose from"),
        (("i4", "--model", "stiff"), "choose from determinate, continuous"),
        (("i4", "--box", "-2..-1, 0"), "no balance shafts to place"),
        (("i4", "--recommended", "--box", "-2..-1, 0"), "--recommended places its shafts itself"),
        (("square-four", "--minimise", "force", "--limit", "roll=50%"), "cannot be met"),
    ],
)
def test_bad_wishes_for_roll_are_refused_in_a_sentence(
    arguments: tuple[str, ...], words: str, run: Run
) -> None:
    done = run("balance", *arguments)
    assert done.code == 2
    assert words in " ".join(done.err.split())


def test_shafts_of_the_file_are_placed_and_nothing_else_is_changed(run: Run) -> None:
    assert run("balance", "i4", "--factor", "0", "--shafts", "2, -2", "-o", "two.toml").code == 0
    done = run(
        "balance", "two.toml", "--box", "-3.2..-2.6, 1..1.5", "--box", "-2.8..-2.5, -1.5..-1",
        "-o", "placed.toml",
    )  # fmt: skip
    assert done.code == 0
    assert "`crankstar plot FILE balance-shafts`" in " ".join(done.out.split())
    before, after = (crankstar.load(name) for name in ("two.toml", "placed.toml"))
    assert [s.weights for s in before.shafts] == [s.weights for s in after.shafts]
    places = [(round(s.up, 6), round(s.right, 6)) for s in balance_shafts(after)]
    assert all(-3.2 <= up <= -2.5 and 1 <= abs(right) <= 1.5 for up, right in places)
    moments = [rolled(engine, Aim("roll", order=2.0)) for engine in (before, after)]
    assert moments[1] < moments[0] or places


def test_a_shaft_in_the_sweep_of_the_crank_or_in_another_is_told(run: Run) -> None:
    engine = with_counterweights(crankstar.load("i2-360"), factor=0.5)
    near = with_balance_shaft(engine, ratio=-1, planes=[0], up=-1.5)
    assert [(clash.second, clash.crank) for clash in clashes(near)] == [("crank", True)]
    assert clashes(with_balance_shaft(engine, ratio=-1, planes=[0], up=-2.6)) == ()
    done = run("balance", "i4", "--shafts", "2, -2", "--box", "-3..-2.9, 0..0.1")
    assert done.code == 0
    assert "would be inside it" in " ".join(done.out.split())


@pytest.mark.many(first=2)
@pytest.mark.parametrize("name", ["i6", "sinitsyn-7-first", "sinitsyn-8-two-stroke"])
def test_every_star_of_an_engine_has_the_same_roll(name: str) -> None:
    engine = crankstar.load(name)
    stars = stars_of(engine)
    order = [d for d in range(stars.directions) for _ in range(stars.sharing)]
    generator = np.random.default_rng(3)
    peaks = [rolled(with_star(engine, stars, tuple(map(int, generator.permutation(order)))),
                    Aim("roll")) for _ in range(3)]  # fmt: skip
    assert np.ptp(peaks) < 1e-6 * max(peaks) + 1e-9


def test_scale_of_the_roll_is_that_of_the_tables() -> None:
    engine = crankstar.load("audi-25-tfsi")
    unit = scales(engine, None)[1].moment
    assert unit == "m*r^2*w^2"
    value = measured(setting(engine, []), Aim("roll", order=2.0), np.zeros(0))
    assert value == pytest.approx(rolled(engine, Aim("roll", order=2.0)), abs=1e-9)
