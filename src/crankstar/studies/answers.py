"""The figures of each analysis, and what they rest on: the record that every command prints.

An `Answer` names an analysis by what it says first: amplitudes by order, peak loads, natural
frequencies. `rests_on` varies what the file lacks and says which figure of them moves how much.

>>> from crankstar.files.catalog import load
>>> engine = load("audi-25-tfsi")
>>> first = rests_on(engine, amplitudes(engine))[1]
>>> first.path, first.status, first.moved.quantity, first.moved.order
('cylinder.rotating_mass', 'missing', 'couple', 1.0)
>>> [round(each) for each in (first.moved.now, first.moved.low, first.moved.high)]
[418, 747, 1259]
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace

from crankstar.analysis.assumptions import Answer, Assumption, Uses, moved
from crankstar.analysis.changed_values import with_drive_inertia
from crankstar.analysis.registry import added, analyses
from crankstar.analysis.tried_values import Figure, Figures
from crankstar.engine.basis import BALANCE_FACTOR
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, MessageError, _
from crankstar.language.numbers import number, rpm_of
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.gas import Cycle, cycle, cycle_or_reason
from crankstar.mechanics.gas_torque import brake_torque, gas_torque
from crankstar.mechanics.lacking import lacking_keys
from crankstar.mechanics.operating_points import operating_state
from crankstar.mechanics.remains import USUAL_ORDERS
from crankstar.studies.answer_parts import (
    TURNING,
    gas_of,
    in_own_unit,
    in_whose_unit,
    joined,
    usual_gas,
    without_speed,
)
from crankstar.studies.assumed_doubts import doubted_weight
from crankstar.studies.assumed_loads import of_load
from crankstar.studies.assumed_values import assumed_values
from crankstar.studies.figures_by_order import (
    by_order,
    components,
    inertia_sizes,
    inertia_unit,
    least_pushed,
    rolls_of,
)
from crankstar.studies.gas_alone import gas_alone, lacking_gas, usual_speeds, with_speed

MakeCycle = Callable[[Engine], Cycle | None]
ONE_SPEED = N_("no speed in one of the files; the ratio of inertia forces is that of any speed")
IN_ROLL = N_("Not in the rolling moment: {paths}.")


def rests_on(engine: Engine, answer: Answer) -> tuple[Assumption, ...]:
    """All that an answer rests on, what moves it most first."""
    engine = answer.engine or engine
    found = [each for each in assumed_values(engine, answer) if each.path not in answer.given]
    return moved(engine, found, answer)


def amplitudes(
    engine: Engine,
    *,
    point: str = "",
    speed: float | None = None,
    gas: bool = False,
    both: bool = False,
    reference: Reference | None = None,
    highest: float = USUAL_ORDERS,
) -> Answer:
    """Force, couple and rolling moment of inertia by order, at `speed` (rad/s) or the engine's.

    With `gas` the rolling moment is not said to leave it out; with `both` that with gas stands
    beside it. `point` is the operating point. Orders up to the `highest`. Raises GasError for a
    point that the engine has not.
    """
    without, why = (None, "") if gas else gas_of(engine, point=point, speed=speed)
    usual, short = (None, "") if gas else usual_gas(engine, speed=speed)
    if point and speed is None:
        speed = operating_state(engine, point=point).speed

    def figures(each: Engine) -> Figures:
        inertia = inertia_sizes(each, speed, reference, highest)
        if without is None or not both:
            return inertia
        return inertia | rolls_of("roll with gas", each, cycle(each, point=point, speed=speed))

    def unit(quantity: str, each: Engine) -> str:
        return "N*m" if quantity == "roll with gas" else inertia_unit(speed, quantity, each)

    lacking = [] if gas or without is not None else _lacking_roll(engine, point, speed)
    choices = [*lacking, *of_load(engine, without if both else None)]
    if both and without is not None and not {"mass", "radius"} & {*engine.relative}:
        choices += gas_alone(engine, without, figures, ["roll with gas"])
    choices += doubted_weight(engine, speed) if both else []
    return Answer(
        figures=figures,
        unit=unit,
        uses=("inertia", "gas") if both else ("inertia",),
        gas=without if both else None,
        least=lambda each: least_pushed(each, speed, reference),
        without_gas=usual if both else without or usual,
        gasless="" if gas or lacking or (both and without is not None) else IN_ROLL,
        why_gasless=why or short,
        choices=choices,
    )


def _lacking_roll(engine: Engine, point: str, speed: float | None) -> list[Assumption]:
    """The gas that a rolling moment leaves out for want of a bore or a speed, and what it changes.

    In N m, whatever the unit of the inertia is.
    """

    def rolls(each: Engine) -> Figures:
        return rolls_of("roll", each, cycle(each, point=point, speed=speed))

    def inertia(each: Engine) -> Figures:
        if speed is None and each.speed is None:
            return {}
        sizes = inertia_sizes(each, speed)
        return {key: size for key, size in sizes.items() if key[0] == "roll"}

    lacking = lacking_gas(engine, rolls, IN_ROLL, speed=speed, point=point)
    if lacking is None:
        return []
    in_roll = Answer(figures=inertia, unit=lambda _quantity, _engine: "N*m")
    found = moved(engine, [lacking], in_roll) or [lacking]
    return [replace(each, vary=None, figures=None) for each in found]


def compared(
    engine: Engine,
    *,
    speed: float | None = None,
    own_unit: bool = False,
    gas: bool = True,
    speed_assumed: bool = False,
) -> Answer:
    """What engines are compared by: inertia by order, the torque with gas, torsion, mounts.

    In m r omega^2 with `own_unit`, as where an engine beside it has no masses; without the torque
    unless `gas`, as where one beside it has none. `speed_assumed` where `speed` is not that of the
    file, nor asked for, but one for all.
    """
    torque = _of_torque(engine, speed) if gas else []
    of_file = bool(torque) and bool({"mass", "radius"} & {*engine.relative})  # gas in another unit
    if own_unit:
        inertia = in_own_unit(amplitudes(without_speed(engine), gas=of_file))
        if not of_file and gas_of(engine, speed=speed)[0] is not None:
            inertia = replace(inertia, why_gasless=in_whose_unit(engine, speed))
    else:
        inertia = amplitudes(engine, speed=speed, gas=of_file)
    answer = joined([inertia, *torque, *_driven(engine, speed)])

    def at_its_own(each: Engine) -> Figures:
        return compared(each, speed=each.speed or speed, gas=gas).figures(each)

    if not speed_assumed or speed is None or speed == engine.speed:
        return answer
    rpm, of_file = (rpm_of(each) for each in (speed, engine.speed or 0.0))
    chosen = Assumption("assumed", "speed", ONE_SPEED, rpm, "rpm")
    usual = usual_speeds(engine)
    if engine.speed is not None:
        reason = _(
            "{own} rpm in the file, all are at {rpm} rpm", own=number(of_file), rpm=number(rpm)
        )
        chosen = replace(chosen, status="left out", reason=reason)
        usual = of_file, of_file
    if usual is not None and not own_unit:
        low, high = usual
        chosen = replace(chosen, low=low, high=high, vary=with_speed, figures=at_its_own)
    return replace(answer, choices=[*answer.choices, chosen])


def summary(engine: Engine, *, speed: float | None = None) -> Answer:
    """What the verdict is about: inertia and gas, torsion, mounts, as far as the file has them.

    Without a speed it prints no newtons, and a rolling moment without gas: so are its figures.
    """
    known = speed is not None or engine.speed is not None
    own = outlook(engine, speed=speed) if known else amplitudes(engine)
    return joined([own, *_driven(engine, speed)])


def _of_torque(engine: Engine, speed: float | None) -> list[Answer]:
    """The torque of gas and inertia by order, where there is a cycle."""
    found = cycle_or_reason(engine, speed=speed)[0]
    if found is None:
        return []

    def figures(each: Engine) -> Figures:
        from crankstar.studies.gas_results import torque_of

        return by_order("torque", torque_of(each, cycle(each, speed=speed)))

    made = Answer(
        figures=figures,
        unit=lambda _quantity, _engine: "N*m",
        uses=("inertia", "gas"),
        gas=found,
        given=TURNING,
        choices=[*gas_alone(engine, found, figures), *of_load(engine, found)],
    )
    return [made]


def _driven(engine: Engine, speed: float | None) -> list[Answer]:
    """The analyses of which a verdict tells, where the file has what they are of."""
    out: list[Answer] = []
    for record in analyses():
        if record.facts is None:
            continue
        with added().among_others(record.name), suppress(MessageError):
            if record.tells(engine, speed):
                out.append(record.answering(engine, record.question.value(speed=speed)))
    return out


def outlook(
    engine: Engine,
    *,
    speed: float | None = None,
    point: str = "",
    reference: Reference | None = None,
    highest: float = USUAL_ORDERS,
) -> Answer:
    """Force and couple of inertia, and the rolling moment with gas where a cycle is known."""
    found = cycle_or_reason(engine, point=point, speed=speed)[0]
    if found is None:
        return amplitudes(engine, point=point, speed=speed, reference=reference, highest=highest)

    def figures(each: Engine) -> Figures:
        again = cycle(each, point=point, speed=speed)
        inertia = inertia_sizes(each, speed, reference, highest)
        plain = {key: size for key, size in inertia.items() if key[0] != "roll"}
        return plain | rolls_of("roll", each, again)

    def unit(quantity: str, each: Engine) -> str:
        return "N*m" if quantity == "roll" else inertia_unit(speed, quantity, each)

    return Answer(
        figures=figures,
        unit=unit,
        uses=("inertia", "gas"),
        gas=found,
        least=lambda each: least_pushed(each, speed, reference),
        choices=[*gas_alone(engine, found, figures), *of_load(engine, found)],
    )


def torques(
    engine: Engine,
    make: Callable[[Engine], Cycle],
    *,
    running: bool = True,
    flywheel: float | None = None,
    irregularity: float | None = None,
    sums: bool = False,
) -> Answer:
    """The rolling moment of gas and inertia by order, mean and brake torque, the peak pressure.

    With `running` the degree of irregularity where the `flywheel` (kg m^2) is known, and the one
    for a degree of `irregularity`. With `sums` force, couple and roll besides, as generating sets
    have them on their frame, not the torques. Raises GasError.
    """
    if flywheel is not None:
        engine = with_drive_inertia(engine, flywheel)
    found = make(engine)

    def figures(each: Engine) -> Figures:
        again = make(each)
        rolls = rolls_of("roll", each, again, one_frame=sums)
        if running:
            rolls |= _evenness(each, again, irregularity)
        if sums:
            return components(each, again.speed) | rolls
        mean = float(gas_torque(again).mean.sum())
        plain = {("mean torque", None): mean, ("peak pressure", None): again.peak / 1e5}
        brake = brake_torque(again)
        if brake is not None:
            plain["brake torque", None] = brake
        return {**rolls, **plain}

    told = running and not lacking_keys(engine, found.speed, flywheel=irregularity is None)
    load = of_load(engine, found, on_frame=sums, running=told)
    units = {"peak pressure": "bar", "irregularity": "", "flywheel": "kg*m^2"}
    turning: Uses = "running" if irregularity is None else "sized"
    uneven: tuple[Uses, ...] = (turning, "set") if sums else (turning,)
    return Answer(
        figures=figures,
        unit=lambda quantity, each: (
            inertia_unit(found.speed, quantity, each)
            if quantity.endswith(("force", "couple"))
            else units.get(quantity, "N*m")
        ),
        uses=("inertia", "gas", *(uneven if running else ())),
        gas=found,
        choices=[*gas_alone(engine, found, figures), *load],
        engine=engine,
    )


def _evenness(engine: Engine, found: Cycle, irregularity: float | None) -> dict[Figure, float]:
    """The degree of irregularity, and the flywheel for one that was asked for."""
    from crankstar.dynamics.uneven import driven, flywheel_for

    out: dict[Figure, float] = {}
    running = driven(engine, found)
    if running is not None:
        out["irregularity", None] = running.irregularity
    if irregularity is not None and found.speed is not None:
        out["flywheel", None] = flywheel_for(engine, found, irregularity=irregularity)
    return out


def bobweights(engine: Engine, *, factor: float, assumed: bool = False) -> Answer:
    """The heaviest bobweight of the crank pins, at a balance factor, which may be `assumed`."""
    from crankstar.remedy.loads import bobweight, loads

    unit = "m" if "mass" in engine.relative else "kg"
    reason = N_("half of what reciprocates, neither in the file nor given with --factor")
    half = Assumption("assumed", BALANCE_FACTOR, reason, factor, explained=True)
    return Answer(
        figures=lambda each: {
            ("heaviest bobweight", None): max(bobweight(pin, factor) for pin in loads(each))
        },
        unit=lambda _quantity, _engine: unit,
        given=("cylinder.throw_mass",),
        choices=[half] if assumed else [],
    )
