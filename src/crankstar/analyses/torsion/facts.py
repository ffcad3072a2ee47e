"""What a verdict and a comparison say of torsion: the first frequencies and the critical speeds."""

from __future__ import annotations

from collections.abc import Sequence

from crankstar.analyses.torsion.fatigue_tables import fatigue_sentence
from crankstar.analysis.document import Column, Table, Value
from crankstar.dynamics.torsion_analysis import TorsionAnalysis, torsion
from crankstar.dynamics.torsion_criticals import Critical
from crankstar.engine.engine import Engine
from crankstar.language.alike import as_given
from crankstar.language.messages import _
from crankstar.language.numbers import RPM, number, order_text

MODES = 3


def sentences(engine: Engine, *, speed: float | None = None) -> list[str]:
    """The first torsional mode, the critical speed that counts for most, fatigue; or nothing.

    >>> from crankstar.files.catalog import load
    >>> disc = {"name": "flywheel", "inertia": "1 kg*m^2", "to": "rear", "stiffness": "1 MN*m/rad"}
    >>> own = {"inertia": "0.02 kg*m^2", "stiffness": "0.6 MN*m/rad", "disc": [disc]}
    >>> sentences(load("audi-25-tfsi", changes={"torsion": own}))[0]
    'First torsional mode: 278.1 Hz.'
    """
    if engine.torsion is None:
        return []
    found = torsion(engine, speed=speed)
    if not found.modes:
        return [_("Nothing of the crankshaft twists: all masses are rigidly coupled.")]
    lines = [_("First torsional mode: {frequency} Hz.", frequency=_hertz(found, 0))]
    if not found.speeds.size:
        return lines
    low, high = (number(round(float(found.speeds[place]) * RPM)) for place in (0, -1))
    fatigue = fatigue_sentence(engine, found)
    last = [fatigue] if fatigue else []
    if not found.criticals:
        none = _("No critical speed between {low} and {high} rpm.", low=low, high=high)
        return [*lines, none, *last]
    top = _strongest(found)
    if top is None:
        reason = found.without_gas.rstrip(".")
        why = _(
            "Which critical speed is the strongest depends on the gas: {reason}.", reason=reason
        )
        return [*lines, why, *last]
    sentence = _(
        "Between {low} and {high} rpm the strongest critical speed is that of order {order} with "
        "mode {mode}, at {rpm} rpm.",
        low=low,
        high=high,
        order=order_text(top.order),
        mode=top.mode,
        rpm=number(round(top.speed * RPM)),
    )
    return [*lines, sentence, *last]


def _hertz(found: TorsionAnalysis, index: int) -> str:
    return number(float(f"{found.modes[index].frequency:.4g}"))


def _strongest(found: TorsionAnalysis) -> Critical | None:
    """The critical speed of the order and mode that the engine as given decides."""
    top = found.strongest
    if top is None:
        return None
    place = as_given("strongest critical speed", (top.mode, top.order))
    return next((each for each in found.criticals if each[:2] == place), top)


def compared(
    engines: Sequence[Engine], names: Sequence[str], speeds: Sequence[float | None]
) -> tuple[Table, ...]:
    """The first frequencies and the strongest critical speed of engines with a table [torsion]."""
    found = [
        (name, torsion(engine, speed=speed))
        for engine, name, speed in zip(engines, names, speeds, strict=True)
        if engine.torsion is not None
    ]
    if not found:
        return ()
    columns = (
        Column(_("engine"), kind="text", label=True, wraps=True),
        *(
            Column(_("mode {number}", number=index + 1), "Hz", fixed=True, digits=4)
            for index in range(MODES)
        ),
        Column(_("strongest order")),
        Column(_("its mode")),
        Column(_("critical speed"), "rpm"),
    )
    rows: list[tuple[Value, ...]] = []
    for name, own in found:
        frequencies = [mode.frequency for mode in own.modes[:MODES]]
        top = own.strongest
        last = (None, None, None) if top is None else (top.order, top.mode, top.speed * RPM)
        rows.append((name, *frequencies, *[None] * (MODES - len(frequencies)), *last))
    return (Table(_("Torsion"), columns, tuple(rows)),)


def sizes(
    engines: Sequence[Engine], speeds: Sequence[float | None]
) -> list[tuple[str, float | None, list[float | None], str]]:
    """The same for machines: quantity, order, the value of each engine, unit.

    None for an engine without a table [torsion].
    """
    if all(engine.torsion is None for engine in engines):
        return []
    found = [
        None if each.torsion is None else torsion(each, speed=speed)
        for each, speed in zip(engines, speeds, strict=True)
    ]
    rows: list[tuple[str, float | None, list[float | None], str]] = []
    for index in range(MODES):
        name = "torsion_frequency" if not index else f"torsion_frequency_{index + 1}"
        modes = [() if own is None else own.modes for own in found]
        own = [each[index].frequency if index < len(each) else None for each in modes]
        rows += [(name, None, own, "Hz")] if any(own) else []
    tops = [own and own.strongest for own in found]
    return [
        *rows,
        ("torsion_order", None, [top and top.order for top in tops], ""),
        ("torsion_mode", None, [top and float(top.mode) for top in tops], ""),
        ("torsion_critical", None, [top and top.speed * RPM for top in tops], "rpm"),
    ]
