"""The tables of the gears between the crankshafts of the KR250, and of its torque at low speed."""

from __future__ import annotations

from functools import cache
from math import pi
from typing import NamedTuple

import numpy as np

from crankstar import charts, load, spectra, total
from crankstar.charts.crank_angle import across
from crankstar.charts.drawing import BLUE, VERMILION, styled
from crankstar.charts.grammar import field, of_rows
from crankstar.dynamics.meshes import Mesh, meshes
from crankstar.dynamics.uneven import SAMPLES, running
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.files.catalog import tree_of
from crankstar.files.estimate import estimated
from crankstar.mechanics.balance import balance
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import over_cycle
from crankstar.mechanics.kinetic import samples_over

APART, TOGETHER, PRODUCTION = "kr250-racer", "kr250-racer-simultaneous", "kr250-production"
ENGINES = {
    APART: "racer, 180°",
    TOGETHER: "racer, simultaneous",
    PRODUCTION: "production, same sense, 180°",
}
SHARES = {0.5: "½ on each crankshaft", 0.25: "¼ on each, ½ with the load", 0.0: "all with the load"}
"""How much of the inertia turns on each crankshaft."""
LOAD = 9e5
"""Indicated mean effective pressure, Pa: what the program assumes where a file gives none."""
FAST = 12_000
SPEEDS = (1500, 3000, 6000, 9000, FAST)
LOADS = (3e5, LOAD)
GREAT = 1000.0
"""kg m^2: so much flywheel that the energy of its speed does not depend on it."""


class Fluctuation(NamedTuple):
    """The fluctuation of energy over a turn (J), and the greatest torque (N m) at a speed."""

    energy: float
    torque: float


def page(part: str) -> str:
    """A part of the page: the gears, or the torque at each speed."""
    return {"kr250": gears, "low speed": low_speed}[part]()


def burning(engine: Engine) -> Engine:
    """The engine with the cycle of the production engine, so that the arrangements are compared."""
    return with_values(engine, gas=load(PRODUCTION).gas)


@cache
def complete(name: str) -> Engine:
    """An engine with masses estimated from its bore."""
    shown, tree = tree_of(name)
    return burning(engine_of(estimated(tree, name=shown).tree))


@cache
def mesh(name: str, share: float, *, rpm: int | None = None) -> Mesh:
    """The gears at full load: gas alone, or at a speed with estimated masses."""
    engine = burning(load(name)) if rpm is None else complete(name)
    found = cycle(engine, imep=LOAD, speed=None if rpm is None else rpm * pi / 30)
    (only,) = meshes(engine, found, inertia_shares=(share, share))
    return only


@cache
def fluctuation(name: str, imep: float, rpm: int) -> Fluctuation:
    """How uneven the whole torque is at a speed, with estimated masses."""
    engine = complete(name)
    found = cycle(engine, imep=imep, speed=rpm * pi / 30)
    run = running(engine, found, flywheel=GREAT)
    return Fluctuation(run.fluctuation, float(whole_torque(engine, imep, rpm).max()))


def whole_torque(engine: Engine, imep: float, rpm: int) -> np.ndarray:
    """Gas and inertia torque of the engine over a turn, N m."""
    found = cycle(engine, imep=imep, speed=rpm * pi / 30)
    gas = over_cycle(found, SAMPLES).sum(axis=0)
    moving = total(balance(engine, speed=rpm * pi / 30)).torque
    return gas + np.real(spectra.value(moving, samples_over(engine, SAMPLES)))


def gears() -> str:
    """What the gears pass on, at low speed and at high speed, and where the flywheel is."""
    heads = "| inertia | engine | torque, gas alone | reversals | work |"
    rows = [f"{heads} torque at {FAST} rpm | reversals | work |", "|---" * 8 + "|"]
    for share, where in SHARES.items():
        for name, words in ENGINES.items():
            cells = [cell for rpm in (None, FAST) for cell in _cells(mesh(name, share, rpm=rpm))]
            rows.append(f"| {where} | {words} | {' | '.join(cells)} |")
    table = '<div class="numbers" markdown="1">\n\n' + "\n".join(rows) + "\n\n</div>\n\n"
    return table + figure() + "\n\n" + verdict()


def figure() -> str:
    """The torque in the gears of the racer over a turn, gas alone."""
    curves = {
        f"{ENGINES[APART]}, ½ on each": (mesh(APART, 0.5), VERMILION),
        f"{ENGINES[TOGETHER]}, ½ on each": (mesh(TOGETHER, 0.5), BLUE),
        f"{ENGINES[APART]}, all with the load": (mesh(APART, 0.0), charts.GREY),
    }
    rows = [
        {"x": x, "y": y, "what": name}
        for name, (one, _) in curves.items()
        for x, y in zip(np.degrees(one.theta[::4]).tolist(), one.torque[::4].tolist(), strict=True)
    ]
    legend = {"orient": "top", "title": None, "columns": 1, "labelLimit": 0}
    colour = field(
        "what:N",
        legend=legend,
        scale={"domain": [*curves], "range": [shade for _, shade in curves.values()]},
    )
    line = of_rows(rows).mark("line", strokeWidth=1.6)
    chart = styled(
        line.encode(
            x=across(1, ticks=45, foot=True),
            y=field("y:Q", title="torque in the gears (N m)"),
            color=colour,
        )
    )
    title = "Torque in the gears of the racer over a turn, gas alone"
    drawing = charts.svg(chart, title).replace(charts.GREY, "currentColor")
    return f'<figure class="chart" markdown="0">{drawing}<figcaption>{title}</figcaption></figure>'


def _cells(found: Mesh) -> list[str]:
    low, high = found.least[0], found.greatest[0]
    steady = high - low < 1e-6 * found.scale
    digits = 1 if high < 100 else 0
    span = _number(high) if steady else f"{_fixed(low, digits)} to {_fixed(high, digits)}"
    return [f"{span} N m", str(len(found.reversals)), f"{_number(found.work)} J"]


def verdict() -> str:
    """The numbers of the essay's statement on the gears, in sentences."""
    apart, together = (mesh(name, 0.5) for name in (APART, TOGETHER))
    force = [one.force or 0.0 for one in (apart, together)]
    fast = [mesh(name, 0.5, rpm=FAST) for name in (APART, TOGETHER)]
    ratio = (fast[0].force or 0.0) / (fast[1].force or 1.0)
    return (
        "With the inertia on the crankshafts, and gas alone, the teeth of the racer (pitch radius "
        f"45 mm) carry up to {_number(force[0])} N where it fires every 180°, and "
        f"{len(apart.reversals)} times a turn contact goes to their other flanks; where it fires "
        f"together they carry {_number(force[1])} N, steadily, on the same flanks. That is "
        f"{force[0] / force[1]:.1f} times the force and {apart.work / together.work:.1f} times the "
        f"work through the teeth; at {FAST} rpm {ratio:.1f} and "
        f"{fast[0].work / fast[1].work:.1f} times."
    )


def low_speed() -> str:
    """The fluctuation of energy of both ways of firing over the speed."""
    heads = "| mean effective pressure | speed | fluctuation of energy, 180° | simultaneous |"
    rows = [f"{heads} ratio | greatest torque, 180° | simultaneous |", "|---" * 7 + "|"]
    for imep in LOADS:
        for rpm in SPEEDS:
            apart, together = (fluctuation(name, imep, rpm) for name in (APART, TOGETHER))
            rows.append(
                f"| {imep / 1e5:g} bar | {rpm} rpm | {_number(apart.energy)} J "
                f"| {_number(together.energy)} J | {together.energy / apart.energy:.1f} "
                f"| {_number(apart.torque)} N m | {_number(together.torque)} N m |"
            )
    return '<div class="numbers" markdown="1">\n\n' + "\n".join(rows) + "\n\n</div>"


def _number(value: float) -> str:
    """Three significant figures."""
    shown = f"{value:.3g}"
    return f"{float(shown):.0f}" if "e" in shown else shown


def _fixed(value: float, digits: int) -> str:
    """So many decimals, a minus of its own length."""
    shown = f"{value:.{digits}f}"
    return "−" + shown[1:] if shown.startswith("-") else shown
