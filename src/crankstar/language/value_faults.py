"""What can be wrong with a value and its unit: a sentence for each code."""

from __future__ import annotations

from crankstar.language.messages import N_, Plural

DIMENSIONS = {
    "angle": N_("an angle"),
    "length": N_("a length"),
    "length along the crankshaft": N_("a length"),
    "mass": N_("a mass"),
    "moment of inertia": N_("a moment of inertia"),
    "unbalance": N_("an unbalance"),
    "rotational speed": N_("a rotational speed"),
    "force": N_("a force"),
    "couple": N_("a couple"),
    "stiffness": N_("a stiffness"),
    "bending stiffness": N_("a bending stiffness"),
    "torsional stiffness": N_("a torsional stiffness"),
    "torsional damping": N_("a torsional damping"),
    "damping": N_("a damping"),
    "receptance": N_("a receptance"),
    "elastic modulus": N_("an elastic modulus"),
    "viscosity": N_("a viscosity"),
    "power": N_("a power"),
    "pressure": N_("a pressure"),
    "temperature": N_("a temperature"),
    "area": N_("an area"),
    "volume": N_("a volume"),
    "time": N_("a time"),
    "speed along a line": N_("a speed along a line"),
    "acceleration": N_("an acceleration"),
    "density": N_("a density"),
    "mass per length": N_("a mass per length"),
    "other": N_("another kind of quantity"),
}
"""The quantities that a unit can be of."""

SENTENCES: dict[str, str | Plural] = {
    "unit.needed": N_("{where} is {value}; {dimension} is needed, such as {example}"),
    "unit.not-finite": N_(
        "{where} is {value}, which is not finite; {dimension} is needed, such as {example}"
    ),
    "unit.missing": N_(
        "{where} is {value}, a number without a unit; {dimension} is needed, such as {example}"
    ),
    "unit.bare-beside-unit": N_(
        "{where} is {value} without a unit, and {key} has one; give {like}, or {absolute}"
    ),
    "unit.bare-beside-one": N_(
        "{where} is {value} without a unit, and {key} has one; give {reading}"
    ),
    "unit.bare-beside-pitch": N_(
        "{where} is {value} without a unit, and {key} has one; give {relative} where it counts "
        "bore pitches, or {absolute}"
    ),
    "unit.bare-beside-radius": N_(
        "{where} is {value} without a unit, and {key} has one; give {relative} where it counts "
        "crank radii, or {absolute}"
    ),
    "unit.bare-beside-mass": N_(
        "{where} is {value} without a unit, and {key} has one; give {relative} where it counts in "
        "that mass, or {absolute}"
    ),
    "unit.bare-per-mass": N_(
        "{where} is {value} without a unit, {key} has one, and the file gives no reciprocating "
        "mass: give {relative} where it counts crank radii, or {absolute}, over that mass; or give "
        "cylinder.reciprocating_mass"
    ),
    "unit.bare-per-radius": N_(
        "{where} is {value} without a unit, {key} has one, and the file gives no stroke: give "
        "{relative} where it counts in that mass, or {absolute}, at the crank radius; or give "
        "cylinder.stroke"
    ),
    "unit.implausible": N_(
        "{where} is {number} {unit}; the largest plausible value is {greatest} {unit}. "
        "Did you mean "
        "{number} {meant}?"
    ),
    "unit.too-large": N_(
        "{where} is {value}, too large for an engine; {dimension} is needed, such as {example}"
    ),
    "unit.too-small": N_(
        "{where} is {value}, too small for an engine; {dimension} is needed, such as {example}"
    ),
    "unit.not-a-number": N_(
        "{where} is {value}, not a number with a unit; {dimension} is needed, such as {example}"
    ),
    "unit.range": N_("{where} is {value}, a range; one value is needed, such as {example}"),
    "unit.decimal-comma": N_(
        "{where} is {value}; write numbers with a decimal point and no other commas, as "
        "in {example}"
    ),
    "unit.unknown": N_(
        "{where} is {value}, whose unit {unit} is not known; {dimension} is needed, such as "
        "{example}"
    ),
    "unit.gauge": N_(
        "{where} is {value}, a gauge pressure; give the absolute one: add the pressure of the "
        "surroundings, 1.013 bar at sea level, and write {unit}"
    ),
    "unit.misspelt": N_(
        "{where} is {value}, whose unit {unit} is not known (did you mean {meant}?); "
        "{dimension} is "
        "needed, such as {example}"
    ),
    "unit.other-dimension": N_(
        "{where} is {value}, {measured}; {dimension} is needed, such as {example}"
    ),
    "unit.radius-missing": N_(
        '{where} is {value}, a mass; add the radius at which it is, as in "38 g at 100 mm"'
    ),
    "unit.bare-out-of-range": N_(
        "{where} is {value}, too large or too small; give a bare number near 1"
    ),
    "unit.unknown-radius": N_(
        "{where} is {value}, but the file gives no stroke, so such lengths are in crank radii; "
        "give a bare number, or the stroke"
    ),
    "unit.unknown-pitch": N_(
        "{where} is {value}, but the file gives no bore pitch, so lengths along the crankshaft are "
        "in bore pitches; give a bare number, or the bore pitch"
    ),
    "unit.unknown-mass": N_(
        "{where} is {value}, but the file gives no reciprocating mass, so masses are in units of "
        "it; give a bare number, or the reciprocating mass"
    ),
    "unit.several-radius": N_(
        "the file gives no cylinder.stroke, but values across the crankshaft have units: {paths}; "
        "give the stroke, or bare numbers in crank radii"
    ),
    "unit.several-pitch": N_(
        "the file gives no layout.bore_pitch, but values along the crankshaft have units: "
        "{paths}; give the bore pitch, or bare numbers in bore pitches"
    ),
    "unit.several-mass": N_(
        "the file gives no cylinder.reciprocating_mass, but masses have units: {paths}; give the "
        "reciprocating mass, or bare numbers in units of it"
    ),
    "unit.relative-radius": N_(
        "{where} is {value}, but such lengths are in crank radii; give a bare number, or take "
        "radius out of relative"
    ),
    "unit.relative-pitch": N_(
        "{where} is {value}, but lengths along the crankshaft are in bore pitches; give a bare "
        "number, or take pitch out of relative"
    ),
    "unit.relative-mass": N_(
        "{where} is {value}, but masses are in units of the reciprocating mass; give a "
        "bare number, "
        "or take mass out of relative"
    ),
}
