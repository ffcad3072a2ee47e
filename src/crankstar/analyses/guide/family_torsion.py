"""The torsion of a family of engines: the chain of one with as many throws as another has.

The throws of the engine are alike, and so are the shafts between them: another member has more of
them or fewer. What hangs on the front end hangs there on each member, and so on the rear end. A
chain whose throws differ, or with something on a throw between the ends, has no members but those
with its own number of throws.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_excitation import firing_phases
from crankstar.dynamics.torsion_modes import torsion_modes
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Torsion
from crankstar.engine.torsion_places import REAR, home
from crankstar.firing.weighing import vector_sums
from crankstar.language.messages import _
from crankstar.language.quoting import seen
from crankstar.spectra import Real

LISTS = ("inertia", "bare_inertia", "stiffness", "damping")
"""Values of each throw, or of each gap between two."""


class Twist(NamedTuple):
    """How the cylinders join in an order of torsion.

    `size` is its vector sum, None where no order is asked for; `frequency` (Hz) that of mode 1,
    whose shape counts, None where a straight one does.
    """

    size: float | None
    frequency: float | None


def with_throws(engine: Engine, count: int) -> Torsion | None:
    """The table [torsion] of a member with so many throws; None where `not_grown` has a reason.

    Fillets are left out: they tell of stress alone.

    >>> from crankstar.files.catalog import load
    >>> disc = {"name": "rotor", "inertia": "1 kg*m^2", "to": "throw 5", "stiffness": "1 MN*m/rad"}
    >>> own = {"inertia": "0.02 kg*m^2", "stiffness": "0.6 MN*m/rad", "disc": [disc]}
    >>> grown = with_throws(load("audi-25-tfsi", changes={"torsion": own}), 7)
    >>> grown.inertia, grown.discs[0].to
    ((0.02,), 'rear')
    """
    own = engine.torsion
    if own is None or not_grown(engine, count):
        return None
    plain = {"fatigue": None, "dimensions": None if own.stiffness else own.dimensions}
    if count == _throws(engine):
        return with_values(own, **plain)
    return with_values(
        own,
        **plain,
        **{name: getattr(own, name)[:1] for name in LISTS},
        discs=tuple(with_values(each, to=_end(engine, own, each.to)) for each in own.discs),
        pendulums=tuple(with_values(each, on=_end(engine, own, each.on)) for each in own.pendulums),
    )


def not_grown(engine: Engine, count: int) -> str:
    """Why there is no table [torsion] of a member with so many throws; empty where there is."""
    own = engine.torsion
    if own is None:
        return _("the engine file has no table [torsion]")
    if own.couplings:
        return _("the chain has several crankshafts")
    if count == _throws(engine):
        return ""
    if any(len(set(getattr(own, name))) > 1 for name in LISTS):
        own_count = _throws(engine)
        return _(
            "the throws differ, so that the chain fits {count} cylinders alone", count=own_count
        )
    inner = [each.name for each in own.discs if _end(engine, own, each.to) is None]
    if inner:
        return _("{name} hangs on a throw between the ends", name=seen(inner[0]))
    if any(_end(engine, own, each.on) is None for each in own.pendulums):
        return _("a pendulum hangs on a throw between the ends")
    return ""


def _throws(engine: Engine) -> int:
    """How many throws the crankshaft has."""
    return len(engine.shaft(engine.first.shaft).throws)


def _end(engine: Engine, own: Torsion, text: str | None) -> str | None:
    """A place as that of any member: an end or a disc; None for a throw between the ends."""
    count, names = _throws(engine), tuple(each.name for each in own.discs)
    found = home(text or "", cranks=[(engine.first.shaft, count)], names=names)
    if found is None or found.throw in (None, 0):
        return text
    return REAR if found.throw == count - 1 else None


def twist(engine: Engine, order: float | None) -> Twist:
    """How the cylinders of a member join in an order, by mode 1 of its chain if it has one.

    Its shape is 1 at the first mass; a straight one 1 at the end cylinders, and -1.
    """
    frequency, shape = None, _straight(engine)
    if engine.torsion is not None:
        chain = torsion_chain(engine)
        first, *_more = torsion_modes(chain, order=order or 0.0)
        frequency, shape = first.frequency, chain.at_cylinders(first.shape)
    phases = firing_phases(engine)
    if order is None or phases is None:
        return Twist(None, frequency)
    return Twist(float(vector_sums(shape, phases, [order])[0]), frequency)


def _straight(engine: Engine) -> Real:
    """Amplitudes that go evenly with the place, 1 and -1 at the end cylinders."""
    places = np.array([cylinder.z for cylinder in engine.cylinders])
    arms = places - (places.max() + places.min()) / 2
    return arms / np.abs(arms).max()
