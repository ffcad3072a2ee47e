"""The verb torque: gas torque with inertia torque, by order, and how evenly the engine runs."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated

from crankstar.cli.options import (
    Csv,
    EngineName,
    Json,
    Output,
    Settings,
    Speed,
    loaded_engine,
    option,
    together,
)
from crankstar.cli.output import working
from crankstar.cli.tabulating import give, words_for
from crankstar.engine.quantities import INERTIA, PRESSURE, Quantity
from crankstar.files import units
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.forms import TABLES, form_of
from crankstar.options.refusals import refusal
from crankstar.options.values import RequestError

if TYPE_CHECKING:
    from crankstar.dynamics.uneven import Running
    from crankstar.engine.engine import Engine
    from crankstar.mechanics.gas import Cycle


def torque(
    engine: EngineName,
    /,
    *,
    speed: Speed = None,
    point: Annotated[str | None, option("--point")] = None,
    imep: Annotated[str | None, option("--imep")] = None,
    bmep: Annotated[str | None, option("--bmep")] = None,
    peak_pressure: Annotated[str | None, option("--peak-pressure")] = None,
    motored: Annotated[bool, option("--motored")] = False,
    off: Annotated[str | None, option("--off")] = None,
    flywheel: Annotated[str | None, option("--flywheel")] = None,
    orders: Annotated[str | None, option("--orders", "Default: those of note.")] = None,
    settings: Settings = None,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """Compute gas and inertia torque, half orders included, and how evenly the engine runs."""
    from crankstar.mechanics.gas import cycle
    from crankstar.tables.torque import torque_document

    form = form_of(output, TABLES, json=json, csv=csv)
    loads = {"--imep": imep, "--bmep": bmep, "--peak-pressure": peak_pressure}
    given = [name for name, text in loads.items() if text is not None]
    if len(given) > 1:
        raise RequestError(
            "{one} and {other} both say how much a cycle does; give one",
            one=given[0],
            other=given[1],
        )
    loaded, turning, pressures, silent, inertia = together(
        partial(loaded_engine, engine, settings),
        partial(request.speed, speed),
        lambda: {name: _positive(name, loads[name] or "", PRESSURE) for name in given},
        partial(request.cylinders_off, off),
        lambda: None if flywheel is None else _positive("--flywheel", flywheel, INERTIA),
    )
    names = {"--imep": "imep", "--bmep": "bmep", "--peak-pressure": "peak_pressure"}
    with working(_("Computing the cycle ...")), words_for(form):
        found = cycle(
            loaded,
            point=point or "",
            speed=turning,
            motored=motored,
            off=silent,
            **{names[name]: value for name, value in pressures.items()},
        )
        document = torque_document(
            loaded,
            found,
            running=_running(loaded, found, inertia),
            orders=_orders(orders),
            machine=form not in ("txt", "xlsx"),
        )
    give(document, output, form=form)


def _positive(name: str, text: str, quantity: Quantity) -> float:
    """A value above nought. Raises RequestError."""
    with request.reading(name):
        value = units.si(text, quantity)
    if value <= 0:
        raise request.not_positive(name, text, quantity)
    return value


def _orders(text: str | None) -> list[float] | None:
    """The orders of --orders, those of note without. Raises RequestError."""
    from crankstar.mechanics.gas_torque import HIGHEST

    wanted = request.orders(text, [n / 2 for n in range(1, int(2 * HIGHEST) + 1)])
    if wanted and max(wanted) > HIGHEST:
        raise refusal("--orders", text or "", "give orders up to {highest}", highest=f"{HIGHEST:g}")
    return wanted


def _running(engine: Engine, cycle: Cycle, flywheel: float | None) -> Running | None:
    """How evenly the engine runs, where its flywheel and its masses are known."""
    from crankstar.dynamics.uneven import driven

    found = driven(engine, cycle, flywheel=flywheel)
    if found is None and flywheel is not None:
        raise RequestError(
            "--flywheel needs the speed and the masses: give speed and cylinder.reciprocating_mass"
        )
    return found
