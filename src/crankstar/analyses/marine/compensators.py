"""Moment compensators: contra-rotating masses at one end or both that cancel a vertical moment.

Two equal masses that turn against each other at k times the crank speed push up and down with
2 (m r) k^2 w^2 and never sideways. The vertical moment of order k about a point z_n, M + (z_0 -
z_n) F, with F and M the vertical force and moment about z_0, vanishes

    with one compensator at z_1:    F_1 = -M(z_n)/(z_1 - z_n)
    with two, at z_1 and z_2:       F_1 = -F_2 = -M(z_n)/(z_1 - z_2)

One compensator adds a force; with its arm to z_n, a node of the hull's vibration, it cancels the
moment about that node alone. Two add a pure moment, which is the same about every point.

Makers drive them from the crankshaft by chain or gear, at one end or both, or by an electric motor
elsewhere in the ship, which keeps its phase to the crank; a motor that is out of phase by delta
leaves 2 sin(delta/2) of what it should cancel.

Source: WinGD, Marine Installation Manual X62DF-S2.0 (2022), section 6.1.2: compensators at the free
end, the driving end or both, and in the ship; the laws are statics.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from crankstar import spectra
from crankstar.engine.assembly import GREATEST_SHAFTS
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft, Weight
from crankstar.mechanics import remains
from crankstar.mechanics.balance import default_reference
from crankstar.mechanics.excitation import Reference, part_spectra, total
from crankstar.mechanics.mechanism import mechanism
from crankstar.remedy.counterweights import RemedyError

GREATEST_ORDER = 8
MOST_PLACES = 2


@dataclass(frozen=True)
class Compensator:
    """Two contra-rotating masses at z that push up with Re(force exp(i k theta)) at 1 rad/s, N.

    `unbalance` is the mass times radius of each of the two, kg m, or of both in units of m r.

    >>> one = Compensator(order=2, z=4.0, force=1600.0 + 0j)
    >>> one.unbalance  # 2 * 200 * 2^2 = 1600
    200.0
    """

    order: int
    z: float
    force: complex

    @property
    def unbalance(self) -> float:
        """Mass times radius of each of the two masses."""
        return abs(self.force) / (2 * self.order**2)


def compensators(
    engine: Engine,
    *,
    order: int,
    places: Sequence[float],
    node: float | None = None,
    phase_error: float = 0.0,
) -> tuple[Compensator, ...]:
    """The compensators at one or two `places` z that cancel the vertical moment of an order.

    About `node`, else the middle of the cylinders; `phase_error` (rad) is by how much they come
    late. Raises RemedyError where there is nothing to cancel, or a place has no arm.

    >>> from crankstar import load
    >>> [found] = compensators(load("triple-120"), order=2, places=[3.0], node=-5.0)
    >>> round(abs(found.force) * 8.0, 4)  # with the arm of 8 to the node: the moment of the three
    0.44
    """
    if not 1 <= order <= GREATEST_ORDER:
        raise RemedyError(
            "order {order} is not compensated; give one from 1 to {greatest}",
            order=order,
            greatest=GREATEST_ORDER,
        )
    if not 1 <= len(places) <= MOST_PLACES or len(set(places)) < len(places):
        raise RemedyError("compensators stand at one place or at two; give one place or two")
    about = default_reference(engine).z if node is None else node
    moment = _moment(engine, order, about)
    front, rear = places[0], places[1] if len(places) > 1 else about
    if front == rear:
        raise RemedyError(
            "a compensator has no arm to the point about which it works; give it another place, or "
            "the place of the node"
        )
    force = -moment / (front - rear) * np.exp(-1j * phase_error)
    signs = (1.0, -1.0)[: len(places)]
    return tuple(
        Compensator(order, place, complex(sign * force))
        for place, sign in zip(places, signs, strict=True)
    )


def _moment(engine: Engine, order: int, about: float) -> complex:
    """The vertical moment of an order at 1 rad/s. Raises RemedyError where there is none."""
    parts = part_spectra(mechanism(engine), reference=Reference(about), orders=[order])
    moment = complex(spectra.vertical(spectra.selected(total(parts).couple, order))[0])
    size = float((np.abs(parts.couple.forward) + np.abs(parts.couple.backward)).sum())
    if abs(moment) <= remains.NEGLIGIBLE * size or not moment:
        raise RemedyError(
            "{engine} has no vertical moment of order {order}; leave the compensator out",
            engine=engine.name,
            order=order,
        )
    return moment


def with_compensators(engine: Engine, found: Sequence[Compensator], *, up: float = 0.0) -> Engine:
    """The engine with each compensator as two balance shafts at `up`, of speed ratios k and -k.

    Raises RemedyError where the engine would have too many shafts.

    >>> from crankstar import load
    >>> from crankstar.mechanics.external_moments import external_moments
    >>> three = load("triple-120")
    >>> pair = compensators(three, order=2, places=[2.0, -2.0])
    >>> quiet = external_moments(with_compensators(three, pair))
    >>> round(quiet.moment(2), 12), round(quiet.moment(1), 4)
    (0.0, 1.7321)
    """
    if len(engine.shafts) + 2 * len(found) > GREATEST_SHAFTS:
        raise RemedyError(
            "the engine already has {count} shafts; the greatest number is {greatest}",
            count=len(engine.shafts),
            greatest=GREATEST_SHAFTS,
        )
    names = {shaft.name for shaft in engine.shafts}
    shafts: list[Shaft] = []
    for each in found:
        # Re(F exp(i k theta)) upward alone: F/2 turning with theta, its conjugate against it
        for sign in (1, -1):
            vector = each.force / (2 * each.order**2)
            vector = vector if sign * engine.sense > 0 else vector.conjugate()
            name = _name(f"compensator {sign * each.order}", names)
            names.add(name)
            weight = Weight(unbalance=abs(vector), angle=float(np.angle(vector)), z=each.z)
            shafts.append(
                Shaft(name=name, speed_ratio=Fraction(sign * each.order), up=up, weights=(weight,))
            )
    return with_values(engine, shafts=(*engine.shafts, *shafts))


def _name(wanted: str, taken: set[str]) -> str:
    name, count = wanted, 2
    while name in taken:
        name, count = f"{wanted} no. {count}", count + 1
    return name
