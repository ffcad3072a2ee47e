"""Random chains that twist: trees of discs with gears, rings, damping and pendulums."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import strategies as st
from tests.strategies import Draw, number

from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_excitation import Excitation
from crankstar.dynamics.torsion_system import TorsionChain
from crankstar.engine.torsion import Chain, Disc, Pendulum

RATIOS = st.sampled_from(["1", "1", "1", "-1", "2", "-5/2", "3/7"])
INERTIAS = number(0.01, 20.0)
STIFFNESSES = number(1e3, 1e7)


def row(
    inertias: Any, stiffnesses: Any, *, name: str = "row", loss_factor: float = 0.0
) -> TorsionChain:
    """An unbranched chain of these inertias and the stiffnesses between them."""
    discs = [Disc(name="0", inertia=inertias[0])]
    for place, (inertia, stiffness) in enumerate(zip(inertias[1:], stiffnesses, strict=True), 1):
        discs.append(Disc(name=f"{place}", inertia=inertia, to=f"{place - 1}", stiffness=stiffness))
    return torsion_chain(Chain(name=name, discs=tuple(discs), loss_factor=loss_factor))


@st.composite
def chains(
    draw: Draw, *, branched: bool = True, rings: bool = True, damped: bool = True, most: int = 7
) -> Chain:
    """A tree of discs, or a row of them."""
    count = draw(st.integers(2, most))
    discs = [Disc(name="0", inertia=draw(INERTIAS))]
    stiff = 0
    for place in range(1, count):
        kinds = ["shaft", "shaft", "rigid", *(["ring"] if rings and branched else [])]
        kind = draw(st.sampled_from(kinds)) if place > 1 else "shaft"
        stiff += kind == "shaft"
        on = draw(st.integers(0, place - 1)) if branched else place - 1
        fluid = draw(number(0.1, 500.0)) if damped or kind == "ring" else 0.0
        if kind == "rigid":
            fluid = 0.0
        discs.append(
            Disc.model_validate(
                {
                    "name": f"{place}",
                    "inertia": draw(INERTIAS),
                    "to": f"{on}",
                    "stiffness": draw(STIFFNESSES) if kind == "shaft" else None,
                    "damping": fluid,
                    "loss_factor": draw(number(0.0, 0.3)) if damped and kind == "shaft" else None,
                    "speed_ratio": draw(RATIOS),
                    "absolute_damping": draw(number(0.0, 50.0)) if damped else 0.0,
                }
            )
        )
    loss = 0.05 if damped else 0.0
    return Chain(name="tree", discs=tuple(discs), loss_factor=loss)


@st.composite
def pendulums(draw: Draw, names: tuple[str, ...]) -> Pendulum:
    """A pendulum absorber on one of these discs."""
    return Pendulum(
        on=draw(st.sampled_from(names)),
        mass=draw(number(0.1, 3.0)),
        radius=draw(number(0.05, 0.3)),
        length=draw(number(0.005, 0.1)),
        count=draw(st.integers(1, 4)),
    )


def pushes(chain: TorsionChain, seed: int, orders: Any = (0.5, 1.0, 1.5, 3.0)) -> Excitation:
    """Random torques on every mass, some of them growing with the speed."""
    random = np.random.default_rng(seed)
    shape = (2, len(chain.names), len(orders))
    gas, moving = random.normal(size=shape) + 1j * random.normal(size=shape)
    return Excitation(np.asarray(orders, float), 100 * gas, 1e-3 * moving)
