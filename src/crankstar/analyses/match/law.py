"""The unbalance of an engine as a linear law of the masses of its cylinders.

With r_c what goes up and down in cylinder c and q_c what turns at its big end, the force and the
couple of every order are sums over the cylinders, F = F_0 + sum (a_c r_c + b_c q_c). What is
minimised is one number of all chosen orders, an unbalance in kg m that a speed does not change:

    U^2 = mean over a turn of sum (|F_k|^2 + |C_k|^2 / h^2) / w^2

h is half the distance between the outermost cylinders, at which two forces would make the couple;
where all stand in one place, the crank radius. U w^2 is the rms of that force in N.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from crankstar import spectra
from crankstar.analyses.match.question import Minimised
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import default_reference
from crankstar.mechanics.excitation import Totals, part_spectra
from crankstar.mechanics.mechanism import mechanism
from crankstar.spectra import Real, Spectrum

ORDERS = (1.0, 2.0)
"""The orders that are minimised where none are chosen."""


@dataclass(frozen=True)
class LinearUnbalance:
    """Rows of force and couple over h [row], kg m, and what 1 kg adds to them [row, cylinder].

    `fixed` is that of the engine as it is. The sum of the squares of the rows is U^2.
    """

    orders: tuple[float, ...]
    arm: float
    fixed: Real
    reciprocating: Real
    rotating: Real

    def rows(self, up: Real, around: Real) -> Real:
        """The rows [..., row] with so much more going up and down, and turning [..., cylinder]."""
        return self.fixed + up @ self.reciprocating.T + around @ self.rotating.T

    def unbalance(self, up: Real, around: Real) -> Real:
        """U with so much more in each cylinder, kg m [...]."""
        return np.sqrt((self.rows(up, around) ** 2).sum(axis=-1))


def linear_unbalance(
    engine: Engine,
    *,
    orders: Sequence[float] = ORDERS,
    quantities: Sequence[Minimised] = ("force", "couple"),
) -> LinearUnbalance:
    """The law of an engine, for these orders of force, of couple, or of both.

    A single cylinder with 1 g more in its piston has sqrt(1/2) of g times its crank radius more:

    >>> from crankstar.files.catalog import load
    >>> law = linear_unbalance(load("subaru-ej25"), orders=(1.0,), quantities=("force",))
    >>> one = np.array([0.001, 0, 0, 0])
    >>> radius = load("subaru-ej25").shafts[0].throws[0].radius
    >>> round(float(law.unbalance(one, 0 * one) / (0.001 * radius * 0.5**0.5)), 6)
    1.0
    """
    reference = default_reference(engine)
    machine = mechanism(engine)
    wanted = tuple(sorted({*map(float, orders)}))
    whole = part_spectra(machine, reference=reference, orders=wanted)
    ones = np.ones(len(engine.cylinders))
    unit = replace(
        machine, reciprocating_mass=ones, big_end_mass=ones, rod_mass=0 * ones, rod_inertia=0 * ones
    )
    single = part_spectra(unit, reference=reference, orders=wanted)
    places = [cylinder.z for cylinder in engine.cylinders]
    arm = (max(places) - min(places)) / 2 or engine.throw(engine.first).radius
    count = ones.size
    each = _rows(single, wanted, arm, quantities)
    return LinearUnbalance(
        wanted,
        arm,
        _rows(whole, wanted, arm, quantities).sum(axis=0),
        each[:count].T,
        each[count : 2 * count].T,
    )


def _rows(sums: Totals, orders: Sequence[float], arm: float, of: Sequence[Minimised]) -> Real:
    """The rows of every part [part, row] at 1 rad/s; orders that do not occur are zero."""
    out: list[Real] = []
    for name, size in (("force", 1.0), ("couple", 1 / arm)):
        if name not in of:
            continue
        spectrum: Spectrum = spectra.selected(getattr(sums, name), orders)
        for values in (spectrum.forward, spectrum.backward):
            out += [size * np.real(values), size * np.imag(values)]
    return np.concatenate(out, axis=-1)
