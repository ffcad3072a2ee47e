"""Ideal cycles of a chamber: Otto, Diesel and limited pressure, as pressure over the crank angle.

Compression from the greatest volume V_1 to the least V_2 = V_1/r and expansion back are isentropic,
p V^gamma constant. At top dead centre heat Q comes in, first at constant volume up to the limit of
pressure p_3, what is left at constant pressure up to the volume V_4:

    p_2 = p_1 r^gamma
    p_3 = min(p_2 + (gamma - 1) Q_v / V_2, limit)      Q_v = V_2 (p_3 - p_2)/(gamma - 1)
    V_4 = V_2 + (gamma - 1)/gamma (Q - Q_v)/p_3
    p_5 = p_3 (V_4/V_1)^gamma                          at the end of expansion

Without a limit this is the Otto cycle, with the limit p_2 the Diesel cycle. A four-stroke chamber
is emptied at the exhaust pressure p_e and filled at p_1, a two-stroke one changes its gas at
bottom dead centre. The work of a cycle over the swept volume V_d = V_1 - V_2 is

    imep V_d = Q - V_1 (p_5 - p_1)/(gamma - 1) + (p_1 - p_e) V_d (four-stroke alone)

Source: any textbook of thermodynamics; J. B. Heywood, Internal Combustion Engine Fundamentals,
chapter 5 (ideal models of engine cycles).
"""

from __future__ import annotations

from math import inf
from typing import NamedTuple

import numpy as np

from crankstar.spectra import Real


class Ideal(NamedTuple):
    """An ideal cycle: pressures in Pa, the ratio of specific heats, where the pressure is held.

    `limit` is inf for the Otto cycle and the pressure of compression for the Diesel cycle.
    """

    compression_ratio: float
    gamma: float
    intake: float
    exhaust: float
    limit: float = inf


class Corners(NamedTuple):
    """The corners of an ideal cycle in units of its swept volume: pressures (Pa) and V_4/V_d."""

    compressed: float
    peak: float
    cut_off: float
    end: float


def compressed(cycle: Ideal) -> float:
    """The pressure at the end of compression, Pa: p_1 r^gamma.

    >>> round(compressed(Ideal(8.0, 1.4, 1.0e5, 1.0e5)) / 1e5, 3)
    18.379
    """
    return cycle.intake * cycle.compression_ratio**cycle.gamma


def corners(cycle: Ideal, heat: float) -> Corners:
    """The corners with a heat per swept volume (Pa = J/m^3) from nought up."""
    ratio, gamma = cycle.compression_ratio, cycle.gamma
    least, greatest = 1 / (ratio - 1), ratio / (ratio - 1)
    start = compressed(cycle)
    limit = max(cycle.limit, start)
    peak = min(start + (gamma - 1) * heat / least, limit)
    at_volume = least * (peak - start) / (gamma - 1)
    cut_off = least + (gamma - 1) / gamma * max(heat - at_volume, 0.0) / peak
    return Corners(start, peak, cut_off, peak * (cut_off / greatest) ** gamma)


def mean_pressure(cycle: Ideal, heat: float, *, four_stroke: bool) -> float:
    """The indicated mean effective pressure, Pa, with a heat per swept volume (Pa).

    An Otto cycle of r = 8, gamma = 1.4 turns 1 - 8^-0.4 of its heat into work:

    >>> round(mean_pressure(Ideal(8.0, 1.4, 1e5, 1e5), 2.0e6, four_stroke=True) / 2.0e6, 6)
    0.564725
    """
    ratio, gamma = cycle.compression_ratio, cycle.gamma
    end = corners(cycle, heat).end
    lost = ratio / (ratio - 1) * (end - cycle.intake) / (gamma - 1)
    pumping = cycle.intake - cycle.exhaust if four_stroke else 0.0
    return heat - lost + pumping


def greatest_heat(cycle: Ideal) -> float:
    """The heat per swept volume (Pa) at which constant pressure lasts to bottom dead centre."""
    if cycle.limit == inf:
        return inf
    ratio, gamma = cycle.compression_ratio, cycle.gamma
    limit = max(cycle.limit, compressed(cycle))
    at_volume = (limit - compressed(cycle)) / (ratio - 1) / (gamma - 1)
    return at_volume + gamma / (gamma - 1) * limit


def pressure(cycle: Ideal, heat: float, above: Real, *, bottom: int, four_stroke: bool) -> Real:
    """The pressure, Pa [sample], at equal steps of a cycle from the dead centre of firing.

    `above` is the volume above the least in units of the swept volume [sample], `heat` per swept
    volume (Pa); `bottom` is the last sample of the power stroke.
    """
    ratio, gamma = cycle.compression_ratio, cycle.gamma
    volume = above + 1 / (ratio - 1)
    found = corners(cycle, heat)
    turn = above.size // 2 if four_stroke else above.size
    out = np.empty_like(volume)
    power = slice(0, bottom + 1)
    out[power] = found.peak * np.minimum(found.cut_off / volume[power], 1.0) ** gamma
    compression = slice(above.size - turn + bottom + 1, above.size)
    out[compression] = cycle.intake * (ratio / (ratio - 1) / volume[compression]) ** gamma
    if four_stroke:
        out[bottom + 1 : turn] = cycle.exhaust
        out[turn : turn + bottom + 1] = cycle.intake
    return out
