"""Engines whose moving parts were weighed or measured, each with the page that says so.

Masses in kg, lengths in m. A mass that a page leaves out is None. `piston_group` is piston, pin,
rings and locks; where a page gives the bare piston only, that is `piston`. `rod` is a whole rod
without bearing shells, `small_end` its weight at the piston pin with the big end held level.
`reciprocating` is given where a page has no parts, only what reciprocates. The reference of each
engine is an entry of docs/reference/references.bib.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

EngineType = Literal["petrol", "diesel-car", "diesel", "motorcycle", "aero", "crosshead"]
"""petrol: car; diesel: truck, rail, medium speed; crosshead: large two-stroke."""
OUNCE = 0.028349523125
POUND = 16 * OUNCE


class Weighed(NamedTuple):
    """An engine with published masses of its moving parts."""

    name: str
    kind: EngineType
    reference: str
    locator: str
    bore: float | None = None
    stroke: float | None = None
    rod_length: float | None = None
    piston: float | None = None
    piston_group: float | None = None
    rod: float | None = None
    small_end: float | None = None
    reciprocating: float | None = None
    crank_pin: tuple[float, float] | None = None
    """Diameter and length of the crank pin of one rod."""
    bore_pitch: float | None = None


ENGINES = (
    Weighed(
        "Audi 2.5 TFSI",
        "petrol",
        "audi2009",
        "engine data: pistons with rings and pin",
        bore=0.0825,
        stroke=0.0928,
        piston_group=0.492,
        bore_pitch=0.088,
    ),
    Weighed(
        "Chrysler 2.4 (2006)",
        "petrol",
        "chrysler2006",
        "System Specifications: pistons, connecting rod, crankshaft",
        bore=0.0875,
        piston=0.350,
        rod=0.5658,
    ),
    Weighed(
        "Chrysler 3.5 (2004)",
        "petrol",
        "chrysler2004",
        "System Specifications: connecting rods, piston weight (mean of A and B)",
        bore=0.096,
        piston=0.438,
        rod=0.647,
    ),
    Weighed(
        "Chrysler 3.5 (1997)",
        "petrol",
        "plymouth1997",
        "Piston weight (mean of A and B)",
        bore=0.096,
        piston=0.515,
    ),
    Weighed(
        "Dodge 5.9 V8",
        "petrol",
        "dodge2002",
        "page 1510, piston measurement chart: total finished weight",
        bore=0.1016,
        piston=0.4708,
    ),
    Weighed(
        "Chevrolet V8, rebuilt",
        "petrol",
        "chevyhiperformance2009",
        "table of parts: piston; piston with wrist pin, rings and locks",
        piston=0.5839,
        piston_group=0.8318,
    ),
    Weighed(
        "Jeep 4.0",
        "petrol",
        "jeep2002",
        "page 9-16, pistons (less pin); rod: Jeep Engines, page 148; pin: page 42 (2.5)",
        bore=0.09855,
        stroke=0.08661,
        rod_length=0.15557,
        piston=0.423,
        rod=0.661,
        crank_pin=(0.0532, 0.02725),
    ),
    Weighed(
        "Lancia Fulvia 1.6 HF",
        "petrol",
        "fulvia2008",
        "first post, means of four cylinders",
        bore=0.082,
        stroke=0.075,
        piston=0.3836,
        piston_group=0.5306,
        rod=0.6993,
        small_end=0.2068,
    ),
    Weighed(
        "Subaru EJ25",
        "petrol",
        "enginesim",
        "assets/engines, Subaru EJ25: piston, pin, rod",
        bore=0.0995,
        stroke=0.079,
        rod_length=0.1306,
        piston=0.414,
        rod=0.535,
    ),
    Weighed(
        "Chevrolet HFV6 3.2",
        "petrol",
        "chevrolet-hfv6",
        "table, crankshaft: diameter and width of the rod journal",
        bore=0.089,
        stroke=0.0856,
        crank_pin=(0.056, 0.022),
    ),
    Weighed(
        "BMW M52B28",
        "petrol",
        "enginesim",
        "assets/engines, BMW M52B28",
        bore=0.084,
        stroke=0.084,
        rod_length=0.135,
    ),
    Weighed(
        "Ford 4.6 V8",
        "petrol",
        "fordmodular",
        "section 4.6 L: bore, stroke, rod length",
        bore=0.0902,
        stroke=0.090,
        rod_length=0.1507,
    ),
    Weighed(
        "Ford Coyote 5.0",
        "petrol",
        "fordmodular",
        "bore and stroke; bore pitch: catalog, ford-coyote",
        bore=0.0922,
        stroke=0.0927,
        bore_pitch=0.100,
    ),
    Weighed(
        "GM L76 6.0",
        "petrol",
        "pontiac2008",
        "bore and stroke; bore pitch: catalog, gm-l76",
        bore=0.101627,
        stroke=0.092,
        bore_pitch=0.11176,
    ),
    Weighed(
        "Honda B18C",
        "petrol",
        "enginesim",
        "assets/engines, Honda B18C",
        bore=0.081,
        stroke=0.0872,
        rod_length=0.1379,
    ),
    Weighed(
        "Toyota 2JZ",
        "petrol",
        "enginesim",
        "assets/engines, Toyota 2JZ",
        bore=0.086,
        stroke=0.086,
        rod_length=0.142,
    ),
    Weighed(
        "Suzuki Hayabusa 1300",
        "motorcycle",
        "enginesim",
        "assets/engines, Suzuki Hayabusa",
        bore=0.081,
        stroke=0.065,
        rod_length=0.1195,
    ),
    Weighed(
        "Formula One V8 (2006)",
        "motorcycle",
        "f1rules2006",
        "articles on bore and cylinder spacing",
        bore=0.098,
        bore_pitch=0.1065,
    ),
    Weighed("MAN B&W S50MC-C", "crosshead", "manbw-s50mcc", "fig. 1.02", bore=0.5, stroke=2.0),
    Weighed(
        "Harley-Davidson WL 750, front",
        "motorcycle",
        "headturners",
        "front rod: whole, small end",
        bore=0.06985,
        rod=0.4808,
        small_end=0.194,
    ),
    Weighed(
        "Harley-Davidson WL 750, rear",
        "motorcycle",
        "headturners",
        "rear rod: whole, small end",
        bore=0.06985,
        rod=0.6238,
        small_end=0.194,
    ),
    Weighed(
        "car examined by Rolls-Royce, 1929",
        "petrol",
        "rr1929",
        "connecting rod: small end 0.719 lb of 2.656 lb",
        rod=2.656 * POUND,
        small_end=0.719 * POUND,
    ),
    Weighed(
        "rod of a classic four-cylinder",
        "petrol",
        "hinosamurai",
        "connecting rod: small end 98.6 g of 382.7 g",
        rod=0.3827,
        small_end=0.0986,
    ),
    Weighed(
        "Junkers Jumo 211",
        "aero",
        "rr1940",
        "items 9a and 9b; bore, stroke: National Air and Space Museum A19710914000",
        bore=0.150,
        stroke=0.165,
        piston=67.25 * OUNCE,
        piston_group=97.25 * OUNCE,
        rod=(2046 / 12 - 97.25) * OUNCE,
    ),
    Weighed(
        "MWM six-cylinder diesel",
        "diesel",
        "mendes2008",
        "as in openTorsion, ICE example: l_rod, d_piston, r, m_a",
        bore=0.105,
        stroke=0.137,
        rod_length=0.207,
        reciprocating=2.521,
    ),
)
"""Every engine of which a page with such numbers was found; `proportions` uses them all."""
