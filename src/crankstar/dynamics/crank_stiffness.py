"""The torsional stiffness between two crank throws, estimated from their dimensions.

Each formula gives an equivalent length: that of a plain shaft of the polar moment
I = pi (D^4 - d^4)/32 that would twist as much as one throw does, half of a journal on either side
of two webs and a pin. With L_j, D_j length and diameter of a journal, L_p, D_p those of the pin,
r the crank radius, w the width of a web (across) and t its thickness (along), the stiffness is

    k = G / (sum of length / I over journal, pin and webs)             N m/rad

The formulas are empirical, of crankshafts of solid webs without much overlap of pin and journal;
they differ by a fifth, and a short stroke with overlap is stiffer than all of them say. A measured
stiffness, or one by finite elements, is better: what is estimated here is marked.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import pi

from crankstar.engine.torsion import STEEL, CrankDimensions, Formula

YOUNG = 2.6
"""Young's modulus over the shear modulus, 2 (1 + 0.3)."""


def polar(diameter: float, bore: float | None) -> float:
    """The polar second moment of area of a round shaft, m^4.

    >>> round(polar(0.1, 0.08) / polar(0.1, None), 4)
    0.5904
    """
    return pi / 32 * (diameter**4 - (bore or 0.0) ** 4)


def ker_wilson(own: CrankDimensions, radius: float) -> float:
    """Sum of length over polar moment, 1/m^3.

    Journal and pin count 0.4 of their diameter more than their length; the webs bend over what
    journal and pin leave of the crank radius: (r - 0.2 (D_j + D_p)) / (t w^3), in units of pi/32.

    Source: W. Ker Wilson, Practical Solution of Torsional Vibration Problems, volume 1.
    """
    journal, pin = own.journal_diameter, own.pin_diameter
    arm = max(radius - 0.2 * (journal + pin), 0.0)
    return (
        (own.journal_length + 0.4 * journal) / polar(journal, own.journal_bore)
        + (own.pin_length + 0.4 * pin) / polar(pin, own.pin_bore)
        + 32 / pi * arm / (own.web_thickness * own.web_width**3)
    )


def carter(own: CrankDimensions, radius: float) -> float:
    """Sum of length over polar moment, 1/m^3.

    The journal counts 0.8 of a web's thickness more, the pin three quarters of its length, the
    webs 1.5 r / (t w^3), in units of pi/32. For flexible webs and stiff pins and journals.

    Source: B. C. Carter, An empirical formula for crankshaft stiffness in torsion, Engineering
    (1928).
    """
    return (
        (own.journal_length + 0.8 * own.web_thickness)
        / polar(own.journal_diameter, own.journal_bore)
        + 0.75 * own.pin_length / polar(own.pin_diameter, own.pin_bore)
        + 32 / pi * 1.5 * radius / (own.web_thickness * own.web_width**3)
    )


def timoshenko(own: CrankDimensions, radius: float) -> float:
    """Sum of length over polar moment, 1/m^3.

    Journal and pin count 0.9 of a web's thickness more than their length, and each web bends in
    its plane as a beam of the crank radius, 2 r/B with B = E t w^3/12. For journals that are free
    in their bearings; held ones are stiffer.

    Source: S. P. Timoshenko, Vibration Problems in Engineering, torsional vibration of crankshafts.
    """
    web = own.web_thickness
    return (
        (own.journal_length + 0.9 * web) / polar(own.journal_diameter, own.journal_bore)
        + (own.pin_length + 0.9 * web) / polar(own.pin_diameter, own.pin_bore)
        + 2 * radius * 12 / (YOUNG * web * own.web_width**3)
    )


FORMULAS: Mapping[Formula, Callable[[CrankDimensions, float], float]] = {
    "ker-wilson": ker_wilson,
    "carter": carter,
    "timoshenko": timoshenko,
}
NAMES: Mapping[Formula, str] = {
    "ker-wilson": "Ker Wilson",
    "carter": "Carter",
    "timoshenko": "Timoshenko",
}


def throw_stiffness(own: CrankDimensions, *, radius: float) -> float:
    """The stiffness between the middles of two pins, N m/rad; `radius` that of the crank, m.

    A car engine's crankshaft has some hundred kN m/rad, and the formulas agree to a fifth or so:

    >>> from crankstar.engine.copies import with_values
    >>> crank = CrankDimensions(
    ...     journal_diameter=0.06, journal_length=0.028, pin_diameter=0.048, pin_length=0.026,
    ...     web_width=0.08, web_thickness=0.018,
    ... )
    >>> each = [with_values(crank, formula=name) for name in FORMULAS]
    >>> [round(throw_stiffness(own, radius=0.045) / 1e3) for own in each]
    [521, 550, 498]
    """
    modulus = STEEL if own.shear_modulus is None else own.shear_modulus
    return modulus / FORMULAS[own.formula](own, radius)
