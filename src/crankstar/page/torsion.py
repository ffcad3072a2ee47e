"""The twist of the crankshaft, as the page has it: modes, critical speeds, forced vibration.

Nothing of torsion is loaded for an engine without the table [torsion].
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import RPM, number, unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.gas import cycle
from crankstar.page.keys import chart_key
from crankstar.page.printed import printed
from crankstar.page.records import ChartKey
from crankstar.page.torque import cycles, sentence_of, wave_of
from crankstar.page.torsion_records import (
    CriticalShown,
    ModeShown,
    Piece,
    Torsion,
    TorsionNumbers,
    Vibration,
)
from crankstar.page.unit_records import Table, Unit
from crankstar.tables.gas_words import points_text

if TYPE_CHECKING:
    from crankstar.analysis.document import Document
    from crankstar.analysis.document import Table as Values
    from crankstar.dynamics.torsion_analysis import TorsionAnalysis
    from crankstar.dynamics.torsion_criticals import Critical
    from crankstar.dynamics.torsion_response import Response
    from crankstar.dynamics.torsion_system import TorsionChain
    from crankstar.mechanics.gas import Cycle

MOST_POINTS, MOST_CRITICAL = 6, 4
"""Operating points and critical speeds whose vibration is sent."""
MOST_STARS, STARRED = 6, 3
"""Stars of a mode, and modes that have some."""
FIGURES = {
    "torsion-modes": (N_("Mode shapes of torsion"), (None,)),
    "campbell": (N_("Campbell diagram of torsion"), (None,)),
    "torsion-response": (N_("Torsional vibration over the speed"), ("amplitude", "stress")),
}
"""The figures beside the stars of modes, with their quantities."""


class _Driven(NamedTuple):
    """The vibration at a speed with the gas of a cycle, which is critical for a mode and order."""

    cycle: Cycle | None
    critical: Critical | None
    response: Response


class _Twist(NamedTuple):
    """All that is known of the twist of an engine."""

    found: TorsionAnalysis
    driven: tuple[_Driven, ...]
    pieces: tuple[int | None, ...]


@lru_cache(maxsize=16)
def _twist(engine: Engine) -> _Twist | None:
    """The twist of an engine, None without the table [torsion]."""
    if engine.torsion is None:
        return None
    from crankstar.dynamics.torsion_analysis import torsion  # with scipy, for these engines alone

    found = torsion(engine)
    pieces = () if _several(engine) else tuple(_pieces(found.chain))
    return _Twist(found, tuple(_vibrations(engine, found)), pieces)


def _several(engine: Engine) -> bool:
    """Whether it has several crankshafts, which are not seen to twist."""
    return sum(bool(shaft.throws) for shaft in engine.shafts) > 1


def torsion_needs(engine: Engine) -> str:
    """What the torsion of an engine needs, as a sentence; empty where it can be computed.

    >>> from crankstar.files.catalog import load
    >>> torsion_needs(load("v8-flat-plane"))[-44:]
    'give the table [torsion] in the engine file.'
    """
    if engine.torsion is not None:
        return ""
    from crankstar.dynamics.torsion_chain import torsion_chain
    from crankstar.dynamics.torsion_system import TorsionError

    try:
        torsion_chain(engine)
    except TorsionError as error:
        return sentence_of(error)
    return ""


def torsion_shown(engine: Engine) -> Torsion | None:
    """The modes of an engine, its critical speeds and vibrations; None without [torsion].

    >>> from crankstar.files.catalog import load
    >>> disc = {"name": "flywheel", "inertia": "1 kg*m^2", "to": "rear", "stiffness": "1 MN*m/rad"}
    >>> own = {"inertia": "0.02 kg*m^2", "stiffness": "0.6 MN*m/rad", "disc": [disc]}
    >>> twist = torsion_shown(load("audi-25-tfsi", changes={"torsion": own}))
    >>> twist.masses[-1], len(twist.throws), [each and each.name for each in twist.pieces][:2]
    ('flywheel', 5, [None, 'throw 1 - throw 2'])
    """
    known = _twist(engine)
    if known is None:
        return None
    from crankstar.dynamics.torsion_criticals import strength
    from crankstar.mechanics.kinetic import throws_from_front

    found, driven, pieces = known
    chain = found.chain
    stiff = [0.0 if place is None else chain.sections[place].stiffness for place in pieces]
    drawn = () if _several(engine) else tuple(n - 1 for n in throws_from_front(engine.shafts[0]))
    return Torsion(
        masses=chain.names,
        throws=drawn,
        masses_of_throws=chain.throws[: len(drawn)],
        pieces=tuple(_piece(chain, place) for place in pieces),
        estimated=bool(chain.estimated),
        modes=tuple(
            ModeShown(
                number=mode.number,
                frequency_hz=mode.frequency,
                shape=tuple(mode.shape.tolist()),
                torque=tuple(
                    0.0 if place is None else own * float(mode.twist[place])
                    for place, own in zip(pieces, stiff, strict=True)
                ),
            )
            for mode in found.modes
        ),
        criticals=tuple(
            CriticalShown(
                mode=each.mode,
                order=each.order,
                speed_rpm=each.speed * RPM,
                strength=strength(each),
            )
            for each in found.criticals
        ),
        orders=tuple(driven[0].response.orders.tolist()) if driven else (),
        vibrations=tuple(_vibration(chain, pieces, each) for each in driven),
    )


def _piece(chain: TorsionChain, place: int | None) -> Piece | None:
    if place is None:
        return None
    return Piece(name=chain.section_name(place), modulus=chain.sections[place].modulus)


def _vibration(chain: TorsionChain, pieces: tuple[int | None, ...], driven: _Driven) -> Vibration:
    gas, critical, at = driven
    return Vibration(
        point="" if gas is None or gas.shares == (("", 1.0),) else points_text(gas.shares),
        gas=gas is not None,
        speed_rpm=float(at.speeds[0]) * RPM,
        critical=None if critical is None else (critical.mode, critical.order),
        turns=tuple(wave_of(at.turns[0, :, mass]) for mass in chain.throws if pieces),
        torque=tuple(() if each is None else wave_of(at.torque[0, :, each]) for each in pieces),
        peak=tuple(0.0 if each is None else float(at.peak[0, each]) for each in pieces),
    )


def _vibrations(engine: Engine, found: TorsionAnalysis) -> Iterator[_Driven]:
    """At the speeds of operating points, else of the file, then at the strongest critical ones."""
    if found.response is None:
        return
    from crankstar.dynamics.torsion_excitation import excitation
    from crankstar.dynamics.torsion_response import response

    def driven(gas: Cycle | None, critical: Critical | None, speed: float) -> _Driven:
        push = excitation(found.chain, engine, gas)
        return _Driven(gas, critical, response(found.chain, push, speeds=np.array([speed])))

    points = [] if found.cycle is None else [each.burning for each in cycles(engine)]
    at_speeds = [(gas, gas.speed) for gas in points[:MOST_POINTS] if gas.speed is not None]
    for gas, speed in at_speeds or [(found.cycle, engine.speed)]:
        if speed is not None:
            yield driven(gas, None, speed)
    for critical in found.noted[:MOST_CRITICAL]:
        gas = found.cycle
        if gas is not None:
            gas = cycle(engine, speed=critical.speed)
        yield driven(gas, critical, critical.speed)


def _pieces(chain: TorsionChain) -> Iterator[int | None]:
    """The sections ahead of the first throw, between the throws and behind the last.

    At an end that which hangs on the throw itself: on a disc that is rigid with it, the shaft that
    is drawn has the torque of both. A fluid is no shaft.
    """
    throws = chain.throws
    stiff = [(n, each) for n, each in enumerate(chain.sections) if each.stiffness]

    def at_end(mass: int, *, ahead: bool) -> int | None:
        own = [n for n, each in stiff if each.before == mass and each.after not in throws]
        side = [n for n in own if (chain.sections[n].after < throws[0]) == ahead]
        return side[0] if len(side) == 1 and not _rigid(chain, mass, ahead=ahead) else None

    yield at_end(throws[0], ahead=True)
    for front, rear in pairwise(throws):
        yield next(n for n, each in stiff if {each.before, each.after} == {front, rear})
    yield at_end(throws[-1], ahead=False)


def _rigid(chain: TorsionChain, mass: int, *, ahead: bool) -> bool:
    """Whether a disc is rigid with the throw of that mass, at that end."""
    others = [n for n, own in enumerate(chain.freedom) if own == chain.freedom[mass] and n != mass]
    return any((other < chain.throws[0]) == ahead for other in others)


def torsion_numbers(engine: Engine) -> TorsionNumbers | None:
    """Its numbers as the command prints them, in the units of the context."""
    known = _twist(engine)
    if known is None:
        return None
    from crankstar.analyses.torsion.document import document as torsion_document
    from crankstar.analyses.torsion.question import Question

    found, driven, _places = known
    plain = torsion_document(engine, found, Question())
    every = (each for each in plain.for_machines.tables if each.key == "criticals")
    still = replace(found, response=None, criticals=())
    at_speeds = [
        torsion_document(engine, replace(still, at=each.response), Question()) for each in driven
    ]
    torques = [float(each.response.peak.max(initial=0.0)) for each in driven]
    torque, stress = (
        shown("N*m", max(torques, default=1.0) or 1.0),
        shown("MPa", 1.0, prefixed=False),
    )
    notes, doubts = (
        tuple(line for part in plain.sentences if part.kind in kinds for line in part.lines)
        for kinds in (("note",), ("doubt", "assumed"))
    )
    return TorsionNumbers(
        stress_unit=Unit(label=unit_text(stress.unit), factor=1e-6 * stress.factor),
        torque_unit=Unit(label=unit_text(torque.unit), factor=torque.factor),
        frequencies=_first(_tables(plain, "modes")),
        criticals=_first(printed(replace(each, notes=()) for each in _of(plain, "criticals"))),
        every_critical=_first(printed(replace(each, audience="all") for each in every)),
        chain=_tables(plain, "masses", "sections", "shapes"),
        over_speeds=_tables(plain, "greatest", "barred"),
        vibrations=tuple(_tables(each, "sections_at_speed", "orders") for each in at_speeds),
        notes=notes,
        doubts=doubts,
    )


def _of(document: Document, *keys: str) -> Iterator[Values]:
    """The tables of a document with these keys."""
    return (table for table in document.for_readers.tables if table.key in keys)


def _tables(document: Document, *keys: str) -> tuple[Table, ...]:
    return printed(_of(document, *keys))


def _first(tables: tuple[Table, ...]) -> Table:
    return tables[0] if tables else Table(title="", heads=(), rows=())


def torsion_charts(engine: Engine) -> Iterator[ChartKey]:
    """The figures of torsion that an engine has."""
    known = _twist(engine)
    if known is None or not known.found.modes:
        return
    for figure, (label, quantities) in FIGURES.items():
        for quantity in quantities:
            if figure == "torsion-modes" or known.found.speeds.size:
                yield ChartKey(
                    key=chart_key(figure, quantity=quantity),
                    figure=figure,
                    label=_(label),
                    quantity=quantity,
                )
    if engine.firing_order or len(engine.chambers) == 1:
        yield from _stars(known.found)


def _stars(found: TorsionAnalysis) -> Iterator[ChartKey]:
    """A star for each mode and order that meet and count, else one of each mode."""
    from crankstar.dynamics.torsion_criticals import of_note

    for mode in found.modes[:STARRED]:
        quantity = f"mode-{mode.number}"
        met = of_note([each for each in found.criticals if each.mode == mode.number])
        for order in sorted(each.order for each in met[:MOST_STARS]) or [None]:
            words = {"mode": mode.number, "order": order and number(order)}
            yield ChartKey(
                key=chart_key("torsion-star", orders=order, quantity=quantity),
                figure="torsion-star",
                label=_("Vectors of the cylinders, mode {mode}, order {order}", **words)
                if order
                else _("Vectors of the cylinders, mode {mode}", mode=mode.number),
                quantity=quantity,
                order=order,
            )
