"""The verb torque: gas torque with inertia torque, by order, and how evenly the engine runs."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated

from crankstar.cli.options import (
    Csv,
    EngineName,
    Estimating,
    Json,
    Output,
    Settings,
    Speed,
    loaded_values,
    option,
    together,
)
from crankstar.cli.output import working
from crankstar.cli.tabulating import give, resting_on, words_for
from crankstar.engine.quantities import INERTIA, PRESSURE, Quantity
from crankstar.files import units
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.forms import TABLES, form_of
from crankstar.options.gas import (
    degree_of_irregularity,
    gas_orders,
    mean_pressures,
    refuse_weak_beside_off,
    weaker_cylinders,
)
from crankstar.options.values import RequestError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crankstar.analysis.document import Document
    from crankstar.dynamics.uneven import Running
    from crankstar.engine.engine import Engine
    from crankstar.mechanics.gas import Cycle
    from crankstar.mechanics.gas_loads import LoadedTorques
    from crankstar.tables.torque import Wheel


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
    weaker: Annotated[list[str] | None, option("--weaker")] = None,
    flywheel: Annotated[str | None, option("--flywheel")] = None,
    irregularity: Annotated[str | None, option("--irregularity")] = None,
    tangential: Annotated[str | None, option("--tangential")] = None,
    orders: Annotated[str | None, option("--orders", "Default: those of note.")] = None,
    settings: Settings = None,
    estimate: Estimating = False,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """Compute gas and inertia torque, half orders included, and how evenly the engine runs."""
    from crankstar.mechanics.gas import cycle
    from crankstar.mechanics.occurring_orders import check_orders
    from crankstar.studies.answers import torques
    from crankstar.tables.ranges import ranged
    from crankstar.tables.torque import torque_document

    form = form_of(output, TABLES, json=json, csv=csv)
    loads = {"--imep": imep, "--bmep": bmep, "--peak-pressure": peak_pressure}
    given = [name for name, text in loads.items() if text is not None]
    if motored:
        request.refuse_unused({**loads, "--weaker": weaker}, beside="--motored")
    if len(given) > 1:
        raise RequestError(
            "{one} and {other} both say how much a cycle does; give one",
            one=given[0],
            other=given[1],
        )
    (loaded, spread), turning, pressures, silent, weak, inertia, even, levels = together(
        partial(loaded_values, engine, settings, estimate=estimate),
        partial(request.speed, speed),
        lambda: {name: _positive(name, loads[name] or "", PRESSURE) for name in given},
        partial(request.cylinders_off, off),
        partial(weaker_cylinders, weaker),
        lambda: None if flywheel is None else _positive("--flywheel", flywheel, INERTIA),
        partial(degree_of_irregularity, irregularity),
        partial(mean_pressures, tangential),
    )
    refuse_weak_beside_off(weak, silent)
    names = {"--imep": "imep", "--bmep": "bmep", "--peak-pressure": "peak_pressure"}
    wanted = gas_orders(orders)
    if wanted and (orders or "").strip() != "all":
        check_orders(loaded, wanted, gas=True)

    def burnt(each: Engine) -> Cycle:
        return cycle(
            each,
            point=point or "",
            speed=turning,
            motored=motored,
            off=silent,
            weaker=dict(weak),
            **{names[name]: value for name, value in pressures.items()},
        )

    def sheet(each: Engine) -> Document:
        found = burnt(each)
        return torque_document(
            each,
            found,
            running=_running(each, found, inertia),
            orders=wanted,
            wheel=_wheel(each, found, even),
            loads=_loads(each, found, levels),
        )

    with working(_("Computing the cycle ...")), words_for(form):
        rests = resting_on(
            form, loaded, partial(torques, loaded, burnt, flywheel=inertia, irregularity=even)
        )
        document = ranged(sheet, spread, loaded, rests=rests)
    give(document, output, form=form)


def _positive(name: str, text: str, quantity: Quantity) -> float:
    """A value above nought. Raises RequestError."""
    with request.reading(name):
        value = units.si(text, quantity)
    if value <= 0:
        raise request.not_positive(name, text, quantity)
    return value


def _needing(option: str, engine: Engine, cycle: Cycle) -> None:
    """Refuse what needs speed and masses where they are not known. Raises RequestError."""
    missing = ["speed"] if cycle.speed is None else []
    if not {"mass", "radius"}.isdisjoint(engine.relative):
        missing.append("cylinder.reciprocating_mass")
    if missing:
        raise RequestError(
            "{option} needs {keys}: give it in the engine file or with --set",
            option=option,
            keys=", ".join(missing),
        )


def _wheel(engine: Engine, cycle: Cycle, irregularity: float | None) -> Wheel | None:
    """The flywheel for a degree of irregularity. Raises RequestError."""
    from crankstar.dynamics.uneven import flywheel_for
    from crankstar.mechanics.kinetic import mean_inertia, throw_inertia
    from crankstar.mechanics.mechanism import mechanism
    from crankstar.tables.torque import Wheel

    if irregularity is None:
        return None
    _needing("--irregularity", engine, cycle)
    wheel = flywheel_for(engine, cycle, irregularity=irregularity)
    return Wheel(irregularity, wheel, mean_inertia(mechanism(engine)) + throw_inertia(engine))


def _loads(engine: Engine, cycle: Cycle, levels: Sequence[float]) -> LoadedTorques | None:
    """The torque at the loads of --tangential."""
    from crankstar.mechanics.gas_loads import torques_at_loads

    if not levels:
        return None
    return torques_at_loads(engine, imep=levels, point=cycle.name, speed=cycle.speed)


def _running(engine: Engine, cycle: Cycle, flywheel: float | None) -> Running | None:
    """How evenly the engine runs, where its flywheel and its masses are known."""
    from crankstar.dynamics.uneven import driven

    found = driven(engine, cycle, flywheel=flywheel)
    if found is None and flywheel is not None:
        _needing("--flywheel", engine, cycle)
    return found
