"""The fillets of a crank throw as ratios to the diameter of its pin, and where they are known.

With D the diameter of the pin, D_G that of the journal, E the crank radius,

    r = R/D      radius of a fillet              0.03 to 0.13
    s = S/D      S = (D + D_G)/2 - E, by which pin and journal overlap      up to 0.5
    w = W/D      thickness of the web            0.2 to 0.8
    b = B/D      width of the web                1.1 to 2.2
    d = d_bore/D of bored pins and journals      up to 0.8

the ranges are those of the cranks from which the stress concentration factors were drawn
(`dynamics.crank_fillets`). Beyond them the factors themselves have to be given.

Source: Korean Register, Rules for the Classification of Steel Ships, Part 5, Guidance, Annex 5-3,
3 (1); the same in IACS, Unified Requirement M53.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from crankstar.engine.assembly import Assembly
from crankstar.engine.torsion import FACTORS, CrankDimensions, CrankFatigue, Torsion
from crankstar.language.faults import Fault

GREATEST_OVERLAP = 0.5
RANGES = {
    ("fatigue", "pin_fillet"): (0.03, 0.13),
    ("fatigue", "journal_fillet"): (0.03, 0.13),
    ("dimensions", "web_thickness"): (0.2, 0.8),
    ("dimensions", "web_width"): (1.1, 2.2),
    ("dimensions", "pin_bore"): (0.0, 0.8),
    ("dimensions", "journal_bore"): (0.0, 0.8),
}
"""Least and greatest of a length over the diameter of the pin."""
EDGE = 1e-9


class FilletRatios(NamedTuple):
    """Lengths of a crank throw over the diameter of its pin.

    `journal_radius_own` is the fillet of the journal over the diameter of the journal; `overlap` is
    negative where pin and journal do not overlap.
    """

    pin_radius: float
    journal_radius: float
    journal_radius_own: float
    overlap: float
    thickness: float
    width: float
    pin_bore: float
    journal_bore: float
    recess: float


def fillet_ratios(
    dimensions: CrankDimensions, fatigue: CrankFatigue, *, radius: float
) -> FilletRatios:
    """The ratios of a throw with this crank radius, m.

    >>> own = CrankDimensions(
    ...     journal_diameter=0.06, journal_length=0.03, pin_diameter=0.05, pin_length=0.03,
    ...     web_width=0.08, web_thickness=0.02,
    ... )
    >>> steel = CrankFatigue(pin_fillet=0.0025, journal_fillet=0.003, tensile_strength=8e8)
    >>> [round(each, 3) for each in fillet_ratios(own, steel, radius=0.045)]
    [0.05, 0.06, 0.05, 0.2, 0.4, 1.6, 0.0, 0.0, 0.0]
    """
    pin, journal = dimensions.pin_diameter, dimensions.journal_diameter
    return FilletRatios(
        fatigue.pin_fillet / pin,
        fatigue.journal_fillet / pin,
        fatigue.journal_fillet / journal,
        ((pin + journal) / 2 - radius) / pin,
        dimensions.web_thickness / pin,
        dimensions.web_width / pin,
        (dimensions.pin_bore or 0.0) / pin,
        (dimensions.journal_bore or 0.0) / pin,
        ((fatigue.pin_recess or 0.0) + (fatigue.journal_recess or 0.0)) / pin,
    )


def fillet_faults(own: Torsion, engine: Assembly) -> Iterator[Fault]:
    """Fillets without the dimensions of the throw, or beyond where the factors are known."""
    if own.fatigue is None:
        return
    if own.dimensions is None:
        yield Fault(("torsion", "fatigue"), "fatigue.no-dimensions")
        return
    web = own.dimensions.web_thickness
    for name in ("pin_fillet", "journal_fillet", "pin_recess", "journal_recess"):
        length = getattr(own.fatigue, name)
        if length is not None and length >= web:
            values = {"value": length * 1e3, "web": web * 1e3}
            yield Fault(("torsion", "fatigue", name), "fatigue.beyond-web", values)
            return
    if len(own.fatigue.factors) == len(FACTORS):
        return
    pin = own.dimensions.pin_diameter
    for path, (least, greatest) in RANGES.items():
        length = getattr(getattr(own, path[0]), path[1])
        if length is not None and not least - EDGE <= length / pin <= greatest + EDGE:
            values = {"value": length * 1e3, "low": least * pin * 1e3, "high": greatest * pin * 1e3}
            values |= {"least": least, "greatest": greatest}
            yield Fault(("torsion", *path), "fatigue.range", values)
    radii = [throw.radius for shaft in engine.shafts for throw in shaft.throws]
    if radii and "radius" not in engine.relative:
        overlap = fillet_ratios(own.dimensions, own.fatigue, radius=min(radii)).overlap
        if overlap > GREATEST_OVERLAP + EDGE:
            values = {"value": pin * 1e3, "overlap": overlap, "greatest": GREATEST_OVERLAP}
            yield Fault(("torsion", "dimensions", "pin_diameter"), "fatigue.overlap", values)
