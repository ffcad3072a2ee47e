"""Sums of vibrations whose phases nobody knows: several engines on one foundation.

Engines that are not coupled run at speeds that differ a little, so that the phases between them
drift through all values. Of one order with the amplitudes a_i the sum R has then

    worst            sum of a_i
    typical          root of the sum of a_i^2, the root of the mean of R^2
    within r         P(R < r) = r integral from 0 to infinity of J_1(r t) product of J_0(a_i t) dt

the share of the time in which it is less than r; for two engines

    P(R < r) = arccos((a^2 + b^2 - r^2)/(2 a b))/pi

and for many alike ones nearly 1 - exp(-r^2/(N a^2)), Rayleigh's law.

Source: J. C. Kluyver, A local probability problem, Proc. KNAW 8 (1906), for the integral; Lord
Rayleigh, Phil. Mag. 10 (1880), for the limit of many.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import acos, pi

import numpy as np
from scipy.integrate import simpson
from scipy.special import j0, j1

from crankstar.mechanics.roots import root
from crankstar.spectra import Real

REACHES = (40.0, 2000.0)
"""How far the integral is taken, least and most, in units of 1 over a great amplitude.

N factors fall below (2/(pi t))^(N/2), so that the rest is below 1e-8, or 1e-6 of three engines.
"""
STEPS = 16
"""Of each of its shortest waves."""
MOST = 64
"""Engines of one foundation, at most."""


def worst_sum(amplitudes: Sequence[float]) -> float:
    """All in phase."""
    return float(sum(amplitudes))


def typical_sum(amplitudes: Sequence[float]) -> float:
    """The root of the mean square of the sum over all phases.

    >>> typical_sum([3.0, 4.0])
    5.0
    """
    return float(np.sqrt(np.square(amplitudes).sum()))


def share_within(amplitudes: Sequence[float], limit: float) -> float:
    """The share of the time in which the sum is less than a limit.

    >>> round(share_within([1.0, 1.0], 2**0.5), 9)  # half of all phases of two
    0.5
    """
    sizes = np.array([each for each in amplitudes if each > 0], float)
    if limit <= 0:
        return 0.0
    if sizes.size == 0 or limit >= sizes.sum():
        return 1.0
    if limit <= 2 * sizes.max() - sizes.sum():  # the others cannot make up for the greatest
        return 0.0
    if sizes.size == 1:
        return 0.0
    if sizes.size == 2:
        one, other = sizes
        return acos((one**2 + other**2 - limit**2) / (2 * one * other)) / pi
    great = sizes[sizes >= sizes.max() / 2]
    end = min(max(2 / pi * 10.0 ** (16 / great.size), REACHES[0]), REACHES[1]) / float(great.min())
    shortest = 2 * pi / (float(sizes.sum()) + limit)
    t = np.linspace(0.0, end, 2 * int(end / shortest * STEPS / 2) + 1)
    product = np.ones_like(t)
    for size in sizes:
        product *= j0(size * t)
    share = limit * float(simpson(j1(limit * t) * product, x=t))
    return min(max(share, 0.0), 1.0)


def exceeded(amplitudes: Sequence[float], share: float) -> float:
    """The sum that is exceeded in this share of the time.

    >>> round(exceeded([1.0, 1.0], 0.5), 6)
    1.414214
    """
    sizes = [each for each in amplitudes if each > 0]
    if len(sizes) < 2:
        return worst_sum(sizes)
    low = max(0.0, 2 * max(sizes) - sum(sizes))
    return root(
        lambda limit: share_within(sizes, limit) - (1 - share), low=low, high=worst_sum(sizes)
    )


def sampled_sums(amplitudes: Sequence[float], *, count: int, seed: int = 1) -> Real:
    """So many sums with phases drawn at random: the same by lot.

    >>> drawn = sampled_sums([1.0, 1.0, 1.0], count=20_000)
    >>> bool(abs((drawn < 2.0).mean() - share_within([1.0, 1.0, 1.0], 2.0)) < 0.02)
    True
    """
    phases = np.random.default_rng(seed).uniform(0, 2 * pi, (count, len(amplitudes)))
    return np.abs(np.exp(1j * phases) @ np.asarray(amplitudes, float))
