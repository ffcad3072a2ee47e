"""How fillets of a crank throw concentrate stress, and what stress its steel bears for ever.

The stress concentration factor of a fillet is the greatest equivalent stress there over a nominal
one: of bending, the moment in the middle of the web over its section modulus B W^2/6; of
compression, the radial force over the area B W; of torsion, the torque over the modulus of pin or
journal. Regressions of the ratios of `engine.fillets`, drawn from strain gauges on steel cranks
(Forschungsvereinigung Verbrennungskraftmaschinen); a throw without overlap counts as one whose pin
and journal are half a pin diameter apart at most.

The fatigue strength of the equivalent alternating stress, in N/mm^2 and mm,

    sigma_W = K (0.42 sigma_B + 39.3) (0.264 + 1.073 D^-0.2 + (785 - sigma_B)/4900
                                       + 196/(sigma_B sqrt(R)))

falls with the diameter D and with the fillet radius R (not less than 2 mm), and grows with the
tensile strength sigma_B.

Two coefficients of this text have fewer digits than their neighbours, 0.85 of b^3 in alpha_T and
1.527 of w^2 in beta_B, and are unverified: readers of other texts remember 0.857 and 1.5276. Both
make the factors smaller; the greater ones are taken.

Source: Korean Register, Rules for the Classification of Steel Ships (2025), Part 5, Guidance,
Annex 5-3, 3 and 6, by which the coefficients are typed; it has the text of IACS, Unified
Requirement M53. The formula of the fatigue strength stands in the same words in Indian Register of
Shipping, Classification Notes: Calculation of Crankshafts, section 6.
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from crankstar.engine.fillets import FilletRatios

DEEPEST = -0.5
"""The overlap below which a throw without overlap is taken to be no different."""
LEAST_RADIUS = 2.0
"""mm: of a fillet, in the formula of the fatigue strength."""


def _polynomial(x: float, *coefficients: float) -> float:
    """Of coefficients with the constant first."""
    return float(np.polynomial.polynomial.polyval(x, coefficients))


def _recess(own: FilletRatios) -> float:
    """What fillets cut into the web add; a cut that would help a throw without overlap does not."""
    return max(1.0, 1 + own.recess * (1.8 + 3.2 * own.overlap))


def pin_bending(own: FilletRatios) -> float:
    """Stress concentration by bending in the fillet of the pin, over B W^2/6.

    >>> throw = FilletRatios(0.05, 0.05, 0.05, 0.2, 0.4, 1.5, 0.0, 0.0, 0.0)
    >>> round(pin_bending(throw), 3), round(pin_bending(throw._replace(pin_radius=0.1)), 3)
    (2.532, 1.762)
    """
    w, gap = own.thickness, 1 - max(own.overlap, DEEPEST)
    overlap = (
        _polynomial(w, -4.1883, 29.2004, -77.5925, 91.9454, -40.0416)
        + gap * _polynomial(w, 9.5440, -58.3480, 159.3415, -192.5846, 85.2916)
        + gap**2 * _polynomial(w, -3.8399, 25.0444, -70.5571, 87.0328, -39.1832)
    )
    return (
        2.6914
        * overlap
        * (2.1790 * w**0.7171)
        * _polynomial(own.width, 0.6840, -0.0077, 0.1473)
        * (0.2081 * own.pin_radius**-0.5231)
        * _polynomial(own.journal_bore, 0.9993, 0.27, -1.0211, 0.5306)
        * _polynomial(own.pin_bore, 0.9978, 0.3145, -1.5241, 2.4147)
        * _recess(own)
    )


OF_WIDTH = (7.8955, -10.654, 5.3482)
"""f(b) of alpha_T and beta_T but for b^3."""
PRINTED, REMEMBERED = -0.85, -0.857
"""The coefficient of b^3, as the source has it and as readers remember it; unverified."""


def torsion_margin(own: FilletRatios) -> float:
    """The share by which the factors of torsion are lower with the remembered coefficient.

    >>> throw = FilletRatios(0.05, 0.05, 0.05, 0.2, 0.4, 1.5, 0.0, 0.0, 0.0)
    >>> round(torsion_margin(throw), 4)
    0.0219
    """
    printed, remembered = (
        _polynomial(own.width, *OF_WIDTH, cubic) for cubic in (PRINTED, REMEMBERED)
    )
    return 1 - remembered / printed


def _torsion(own: FilletRatios, radius: float) -> float:
    gap = 1 - max(own.overlap, DEEPEST)
    return (
        0.8
        * radius ** (-0.322 + 0.1015 * gap)
        * _polynomial(own.width, *OF_WIDTH, PRINTED)
        * own.thickness**-0.145
    )


def pin_torsion(own: FilletRatios) -> float:
    """Stress concentration by torsion in the fillet of the pin, over the modulus of the pin.

    >>> throw = FilletRatios(0.05, 0.05, 0.05, 0.2, 0.4, 1.5, 0.0, 0.0, 0.0)
    >>> round(pin_torsion(throw), 3)
    2.029
    """
    return _torsion(own, own.pin_radius)


def journal_torsion(own: FilletRatios) -> float:
    """Stress concentration by torsion in the fillet of the journal, over its modulus.

    Where pin and journal are alike it is that of the pin.

    >>> throw = FilletRatios(0.05, 0.05, 0.05, 0.2, 0.4, 1.5, 0.0, 0.0, 0.0)
    >>> journal_torsion(throw) == pin_torsion(throw)
    True
    """
    return _torsion(own, own.journal_radius_own)


def journal_bending(own: FilletRatios) -> float:
    """Stress concentration by bending in the fillet of the journal, over B W^2/6.

    >>> throw = FilletRatios(0.05, 0.05, 0.05, 0.2, 0.4, 1.5, 0.0, 0.0, 0.0)
    >>> round(journal_bending(throw), 3)
    2.819
    """
    w, gap = own.thickness, 1 - max(own.overlap, DEEPEST)
    overlap = (
        _polynomial(w, -1.7625, 2.9821, -1.527)
        + gap * _polynomial(w, 5.1169, -5.8089, 3.1391)
        + gap**2 * _polynomial(w, -2.1567, 2.3297, -1.2952)
    )
    return (
        2.7146
        * overlap
        * (2.2422 * w**0.7548)
        * _polynomial(own.width, 0.5616, 0.1197, 0.1176)
        * (0.1908 * own.journal_radius**-0.5568)
        * _polynomial(own.journal_bore, 1.0012, -0.6441, 1.2265)
        * _polynomial(own.pin_bore, 1.0022, -0.1903, 0.0073)
        * _recess(own)
    )


def journal_compression(own: FilletRatios) -> float:
    """Stress concentration by the radial force in the fillet of the journal, over B W.

    >>> throw = FilletRatios(0.05, 0.05, 0.05, 0.2, 0.4, 1.5, 0.0, 0.0, 0.0)
    >>> round(journal_compression(throw), 3)
    3.2
    """
    gap = 1 - max(own.overlap, DEEPEST)
    return (
        3.0128
        * _polynomial(gap, 0.4368, 2.1630, -1.5212)
        * (own.thickness / (0.0637 + 0.9369 * own.thickness))
        * (own.width - 0.5)
        * (0.5331 * own.journal_radius**-0.2038)
        * _polynomial(own.pin_bore, 0.9937, -1.1949, 1.7373)
        * _recess(own)
    )


def fatigue_strength(
    *, tensile_strength: float, diameter: float, fillet: float, factor: float = 1.0
) -> float:
    """The equivalent alternating stress that a fillet bears for ever, Pa.

    `tensile_strength` in Pa, `diameter` of pin or journal and radius of the `fillet` in m; `factor`
    is K, of how the crankshaft is made.

    >>> [
    ...     round(fatigue_strength(tensile_strength=t, diameter=0.06, fillet=0.003) / 1e6, 1)
    ...     for t in (6e8, 8e8, 10e8)
    ... ]
    [280.7, 328.6, 370.4]
    """
    strength, size = tensile_strength / 1e6, diameter * 1e3
    radius = max(fillet * 1e3, LEAST_RADIUS)
    shape = 0.264 + 1.073 * size**-0.2 + (785 - strength) / 4900 + 196 / strength / sqrt(radius)
    return factor * (0.42 * strength + 39.3) * shape * 1e6


def equivalent_stress(*, bending: float, torsion: float, additional: float = 0.0) -> float:
    """The equivalent alternating stress of bending and torsion at one place (von Mises), Pa.

    >>> equivalent_stress(bending=80e6, torsion=0.0, additional=10e6)
    90000000.0
    """
    return sqrt((abs(bending) + additional) ** 2 + 3 * torsion**2)
