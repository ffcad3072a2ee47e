"""Weights at the two ends of a crankshaft that share the first-order moment between its planes.

In the middle of an engine in line the reciprocating masses leave a first-order moment that swings
up and down: two vectors of equal length, one with the crank, f, and one against it, b. What turns
with the crank, pins and webs without counterweights, adds to f. Two equal and opposite weights at
the ends change f alone; makers choose them so that of the moment D = 2 |b| that the pistons make a
share s acts in the horizontal plane:

    f = (1 - 2 s) conj(b),    M_1V = (1 - s) D,    M_1H = s D

s = 0: all of it vertical; s = 1/2: M_1V = M_1H, which a project guide calls the standard; s = 1:
none of it vertical.
"""

from __future__ import annotations

from crankstar import spectra
from crankstar.engine.copies import with_weights
from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import end_webs
from crankstar.mechanics import remains
from crankstar.mechanics.balance import default_reference
from crankstar.mechanics.excitation import part_spectra, total
from crankstar.mechanics.mechanism import mechanism
from crankstar.remedy.counterweights import RemedyError, turned_weights
from crankstar.remedy.kept import least_weights


class NothingToShareError(RemedyError):
    """An engine has no first-order moment that weights at the ends could share."""


def with_end_weights(engine: Engine, *, share: float) -> Engine:
    """The engine with opposite weights on the end webs of its crankshaft, beside those it has.

    `share` of the first-order moment of the pistons is then horizontal, the rest vertical. Raises
    RemedyError where there are several crankshafts or cylinders that do not stand up, and where a
    share is not from 0 to 1; NothingToShareError where there is no first-order moment.

    >>> from crankstar import load
    >>> from crankstar.mechanics.external_moments import external_moments
    >>> found = external_moments(with_end_weights(load("triple-120"), share=0.5))
    >>> [round(found.moment(1, side), 4) for side in "VH"]  # half of sqrt(3) each
    [0.866, 0.866]
    """
    shafts = [shaft for shaft in engine.shafts if shaft.throws]
    if not 0 <= share <= 1:
        raise RemedyError(
            "a share of {share} cannot be horizontal; give a number from 0 to 1", share=f"{share:g}"
        )
    if len(shafts) > 1 or any(abs(cylinder.bearing) > 1e-9 for cylinder in engine.cylinders):
        raise RemedyError(
            "weights at the ends share the moment of upright cylinders on one crankshaft; balance "
            "{engine} with `crankstar balance`",
            engine=engine.name,
        )
    couple = spectra.selected(
        total(
            part_spectra(mechanism(engine), reference=default_reference(engine), orders=[1])
        ).couple,
        1,
    )
    ahead, against = complex(couple.forward[0]), complex(couple.backward[0])
    if abs(against) <= remains.NEGLIGIBLE * abs(ahead) or not against:
        raise NothingToShareError(
            "{engine} has no first-order moment that weights at the ends could share",
            engine=engine.name,
        )
    wanted = (1 - 2 * share) * against.conjugate() - ahead
    planes = end_webs(engine, shafts[0])
    middle = default_reference(engine).z
    vectors = least_weights(force=0, moment=wanted, planes=[plane - middle for plane in planes])
    throws = [1, len(shafts[0].throws)]
    added = turned_weights(vectors, planes, throws=throws, beside=abs(wanted) / _reach(planes))
    return with_weights(engine, {shafts[0].name: [*shafts[0].weights, *added]})


def _reach(planes: tuple[float, ...]) -> float:
    return abs(planes[0] - planes[-1]) or 1.0
