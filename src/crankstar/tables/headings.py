"""The lines under an engine's name: cycle, cylinders, rotation, firing order, valve timing."""

from __future__ import annotations

from math import degrees

from crankstar.analysis.document import Remarks
from crankstar.engine.engine import Engine
from crankstar.engine.valves import EVENTS, Timing, timing
from crankstar.firing.intervals import firing
from crankstar.firing.strokes import without_common_cycle
from crankstar.language.faults import listed
from crankstar.language.messages import N_, _, _n
from crankstar.language.numbers import number

ROTATIONS = {
    (False, True): N_("clockwise seen from the front"),
    (False, False): N_("counter-clockwise seen from the front"),
    (True, True): N_("counter-rotating crankshafts, the first clockwise seen from the front"),
    (True, False): N_(
        "counter-rotating crankshafts, the first counter-clockwise seen from the front"
    ),
}
"""By whether crankshafts turn both ways, and the first clockwise."""
TIMINGS = {
    "two-stroke": (
        N_(
            "Intake opens {intake_opens} before and closes {intake_closes} after bottom "
            "dead centre."
        ),
        N_(
            "Exhaust opens {exhaust_opens} before and closes {exhaust_closes} after bottom dead "
            "centre."
        ),
    ),
    "four-stroke": (
        N_(
            "Intake opens {intake_opens} before top and closes {intake_closes} after bottom dead "
            "centre."
        ),
        N_(
            "Exhaust opens {exhaust_opens} before bottom and closes {exhaust_closes} "
            "after top dead "
            "centre."
        ),
    ),
}


def heading(engine: Engine) -> Remarks:
    """Cycle, cylinders, rotation; firing order with its intervals."""
    return Remarks(tuple(heading_lines(engine)))


def heading_lines(engine: Engine) -> list[str]:
    """The same as lines.

    >>> from crankstar.files.catalog import load
    >>> heading_lines(load("i4"))
    ['Four-stroke, 4 cylinders, clockwise seen from the front.', 'Fires 1-3-4-2 every 180 deg.']
    """
    count = len(engine.chambers)
    lines = [
        _(
            "{cycle}, {cylinders}, {rotation}.",
            cycle=cycle_text(engine),
            cylinders=cylinders_text(engine, count),
            rotation=rotation_text(engine),
        )
    ]
    if engine.firing_order:
        lines.append(_("Fires {firing}.", firing=firing_text(engine)))
    return lines


def cycle_text(engine: Engine) -> str:
    """Four-stroke or two-stroke, as a sentence begins."""
    return _("Two-stroke") if engine.cycle == "two-stroke" else _("Four-stroke")


def cylinders_text(engine: Engine, count: int) -> str:
    """How many cylinders, and pistons where each cylinder has two."""
    pistons = len(engine.cylinders)
    cylinders = _n("{count} cylinder", "{count} cylinders", count, count=count)
    if pistons == count:
        return cylinders
    return _("{cylinders}, {pistons} pistons", cylinders=cylinders, pistons=pistons)


def rotation_text(engine: Engine) -> str:
    """The sense of rotation; of geared shafts that turn both ways, of the first.

    >>> from crankstar.files.catalog import load
    >>> rotation_text(load("v8-cross-plane"))
    'clockwise seen from the front'
    """
    return _(
        ROTATIONS[
            any(shaft.throws and shaft.speed_ratio < 0 for shaft in engine.shafts), engine.sense > 0
        ]
    )


def firing_text(engine: Engine) -> str:
    """The firing order and its intervals: `1-3-4-2 every 180 deg`; why, if it has no cycle."""
    if astray := without_common_cycle(engine):
        values = astray.values
        return _n(
            "in no common cycle, as cylinder {numbers} is at top dead centre every {period} deg, "
            "not every {turn} deg",
            "in no common cycle, as cylinders {numbers} are at top dead centre every {period} deg, "
            "not every {turn} deg",
            values["count"],
            numbers=listed(values["numbers"]),
            period=number(values["period"]),
            turn=number(values["turn"]),
        )
    fired = firing(engine)
    order = "-".join(map(str, fired.order))
    if fired.even:
        every = number(fired.intervals_deg[0])
        return _("{order} every {interval} deg", order=order, interval=every)
    intervals = "-".join(number(x, digits=4) for x in fired.intervals_deg)
    return _("{order} at intervals of {intervals} deg", order=order, intervals=intervals)


def timing_lines(engine: Engine) -> list[str]:
    """When valves or ports open and close, and which exhausts the engine file joins.

    >>> from crankstar.files.catalog import load
    >>> timing_lines(load("kr250-racer"))[1]
    'Exhaust opens 85 deg (assumed) before and closes 85 deg (assumed) after bottom dead centre.'
    """
    own = timing(engine.valves, cycle=engine.cycle)
    angles = {name: _angle(own, name) for name in EVENTS}
    lines = [_(sentence, **angles) for sentence in TIMINGS[engine.cycle]]
    if engine.valves is not None and engine.valves.manifolds:
        groups = "; ".join(", ".join(map(str, group)) for group in engine.valves.manifolds)
        lines.append(_("Exhaust manifolds join cylinders {groups}.", groups=groups))
    return lines


def _angle(own: Timing, name: str) -> str:
    angle = number(round(degrees(getattr(own, name)), 9))
    if name in own.assumed:
        return _("{angle} deg (assumed)", angle=angle)
    return _("{angle} deg", angle=angle)
