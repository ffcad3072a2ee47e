"""Several crankshafts that twist together: by hand as discs, by energy, by the sum of torques."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from crankstar import load, spectra, total
from crankstar.dynamics.torsion_analysis import torsion
from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_excitation import excitation
from crankstar.dynamics.torsion_modes import torsion_modes
from crankstar.dynamics.torsion_response import response
from crankstar.dynamics.torsion_variable import inertia_waves
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain, Disc
from crankstar.files.read import engine_of
from crankstar.mechanics.balance import balance
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import gas_torque
from crankstar.mechanics.kinetic import carried_inertias, inertias, throw_inertia
from crankstar.page.torsion import torsion_shown


def geared(name: str, *couplings: dict[str, Any], **own: Any) -> Engine:
    """An engine of the catalog with several crankshafts and a table [torsion]."""
    table = {"inertia": "0.05 kg*m^2", "coupling": list(couplings), **own}
    return load(name, changes={"torsion": table})


def deltic() -> Engine:
    """Its three crankshafts: one, an idler of half its speed behind it, and the others."""
    idler = {"name": "idler", "inertia": "0.4 kg*m^2", "to": "rear", "stiffness": "3 MN*m/rad"}
    return geared(
        "napier-deltic",
        {"crankshaft": "top right", "at": "front", "to": "idler", "stiffness": "4 MN*m/rad"},
        {"crankshaft": "bottom", "at": "throw 2", "to": "throw 3 of top right"},
        stiffness="2 MN*m/rad",
        disc=[{**idler, "speed_ratio": "-1/2"}],
    )


def by_hand() -> Chain:
    """The same as a drive line of discs, each on the one before it."""

    def crank(name: str, first: int, way: range, to: str, **own: Any) -> list[Disc]:
        out = [Disc(name=f"{name}{first}", inertia=0.05, to=to, **own)]
        at = {first: out[0].name}
        for place in way:
            on = at[min(at, key=lambda one: abs(one - place))]
            out.append(Disc(name=f"{name}{place}", inertia=0.05, to=on, stiffness=2e6))
            at[place] = out[-1].name
        return out

    first = [Disc(name="a1", inertia=0.05)]
    first += [Disc(name=f"a{n}", inertia=0.05, to=f"a{n - 1}", stiffness=2e6) for n in range(2, 7)]
    idler = Disc(name="idler", inertia=0.4, to="a6", stiffness=3e6, speed_ratio="-1/2")  # pyright: ignore[reportArgumentType]
    second = crank("b", 1, range(2, 7), "idler", stiffness=4e6, speed_ratio="-2")
    third = crank("c", 2, range(3, 7), "b3", speed_ratio="-1")
    third += [Disc(name="c1", inertia=0.05, to="c2", stiffness=2e6)]
    return Chain(name="by hand", discs=(*first, idler, *second, *third), loss_factor=0.02)


def test_three_crankshafts_are_the_chain_of_their_discs() -> None:
    one, other = (torsion_modes(torsion_chain(each)) for each in (deltic(), by_hand()))
    assert [mode.speed for mode in one] == pytest.approx([mode.speed for mode in other], rel=1e-9)
    assert len(one) == 17  # 19 masses, two of them rigid with others, and the turn of the whole


def pair(ratio: str, **changes: Any) -> Engine:
    """Two crankshafts side by side, the second at a speed ratio, of known masses."""

    def shaft(name: str, speed_ratio: str, right: str) -> dict[str, Any]:
        throw = {"angle": "0 deg", "radius": "27 mm", "rotating_mass": "0.2 kg"}
        return {"name": name, "speed_ratio": speed_ratio, "right": right, "throw": [throw]}

    def cylinder(number: int, name: str) -> dict[str, Any]:
        sizes = {"bore": "54 mm", "rod_length": "110 mm", "reciprocating_mass": "0.4 kg"}
        return {"number": number, "shaft": name, "throw": 1, **sizes}

    return engine_of(
        {
            "format": 1,
            "name": "pair",
            "cycle": "two-stroke",
            "speed": "9000 rpm",
            "shaft": [shaft("one", "1", "0 mm"), shaft("other", ratio, "200 mm")],
            "cylinders": [cylinder(1, "one"), cylinder(2, "other")],
            "torsion": {
                "bare_inertia": "0.002 kg*m^2",
                "coupling": [{"crankshaft": "other", "stiffness": "20 kN*m/rad"}],
                "loss_factor": 0.05,
            },
            **changes,
        }
    )


RATIOS = ["1", "-1", "2", "-3/2"]


@pytest.mark.parametrize("ratio", RATIOS)
def test_their_inertia_torques_turn_the_whole_as_those_of_the_engine(ratio: str) -> None:
    engine = pair(ratio)
    chain = torsion_chain(engine)
    push = excitation(chain, engine, None, orders=np.arange(1, 48) / 2)
    assert push.inertia is not None
    whole = spectra.selected(total(balance(engine, speed=1.0)).torque, push.orders)
    turning = chain.transform.sum(axis=1) @ push.inertia
    assert turning == pytest.approx(spectra.amplitude(whole), abs=1e-12)


@pytest.mark.many(first=3)
@pytest.mark.parametrize("ratio", RATIOS)
def test_their_inertias_add_up_to_that_of_the_engine(ratio: str) -> None:
    engine = pair(ratio)
    chain = torsion_chain(engine)
    squared = np.array([float(shaft.speed_ratio) ** 2 for shaft in engine.shafts])
    theta = np.linspace(0, 4 * np.pi, 4001)[:-1]
    mean = inertias(engine, theta).mean(axis=1)  # by shaft, at the speed of the first
    assert squared * carried_inertias(engine) == pytest.approx(mean, rel=1e-6)
    assert throw_inertia(engine) < mean.sum()
    assert chain.inertias()[0] == pytest.approx(mean + 0.002 * squared, rel=1e-6)


@pytest.mark.parametrize("ratio", RATIOS)
def test_each_changes_its_inertia_as_its_pistons_go(ratio: str) -> None:
    engine = pair(ratio)
    chain = torsion_chain(engine)
    push = excitation(chain, engine, None, orders=np.arange(1, 48) / 2)
    theta = np.linspace(0, 6, 9)
    waves = inertia_waves(chain, push)
    change = np.real(np.exp(1j * np.outer(theta, push.orders)) @ waves.T).T
    wanted = inertias(engine, theta)
    found = change - change[:, :1]
    assert found == pytest.approx(wanted - wanted[:, :1], abs=1e-9)


def test_gas_torques_on_two_crankshafts_turn_the_whole_as_that_of_the_engine() -> None:
    for name in ("jumo-205", "kr250-racer"):
        engine = geared(
            name,
            {"crankshaft": load(name).shafts[1].name, "stiffness": "1 MN*m/rad"},
            **({"stiffness": "2 MN*m/rad"} if name == "jumo-205" else {}),
        )
        chain = torsion_chain(engine)
        found = cycle(engine, imep=9e5)
        push = excitation(chain, engine, found)
        whole = spectra.total(spectra.selected(gas_torque(found).torque, push.orders))
        size = np.abs(push.gas).max()
        turning = chain.transform.sum(axis=1) @ push.gas
        assert turning == pytest.approx(spectra.amplitude(whole), abs=1e-9 * size)


@pytest.mark.parametrize("ratio", ["-1", "2"])
def test_the_response_solves_the_equations_of_two_shafts(ratio: str) -> None:
    """The coupling twists by what the second turns less what the first makes it turn."""
    engine = pair(ratio)
    chain = torsion_chain(engine)
    push = excitation(chain, engine, None)
    found = response(chain, push, speeds=np.array([700.0]))
    by = abs(float(engine.shafts[1].speed_ratio))
    stiffness = 20e3 * (1 + 0.05j)
    for column, order in enumerate(found.orders):
        w = 700.0 * order
        one, other = (float(each) for each in chain.inertia)
        matrix = np.array(
            [
                [stiffness * by**2 - w**2 * one, -stiffness * by],
                [-stiffness * by, stiffness - w**2 * other],
            ]
        )
        torque = found.driving[0, column]
        turns = found.turns[0, column]
        assert matrix @ turns == pytest.approx(torque, abs=1e-9 * np.abs(found.driving).max())


def test_a_mode_of_the_deltic_is_driven_by_all_three_crankshafts() -> None:
    engine = deltic()
    found = torsion(engine, speed=150.0)
    assert found.at is not None
    assert len(found.chain.throws) == 18
    assert len({found.chain.cylinders[n] for n in range(len(engine.cylinders))}) == 18
    shape = found.modes[0].shape
    first = found.criticals[0]
    assert first.vector_sum is not None
    assert first.vector_sum > 0
    assert np.isfinite(shape).all()


def test_the_page_has_their_numbers_and_shows_no_crank_that_twists() -> None:
    shown = torsion_shown(deltic())
    assert shown is not None
    assert (shown.throws, shown.pieces) == ((), ())
    assert [len(mode.shape) for mode in shown.modes[:2]] == [19, 19]
