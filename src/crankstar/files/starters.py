"""Commented engine files to begin with, one for each layout: what `crankstar new` writes."""

from __future__ import annotations

_HEAD = """\
# An engine file of crankstar. Check it with:   crankstar check FILE
# See what it does with:                        crankstar analyze FILE
# A value is text with a unit ("82.5 mm", "3.25 in", "650 g", "90 deg", "6000 rpm") or a bare
# number in SI units. Angles are bearings: 0 is up, clockwise seen from the front of the engine.
# Leave out what you do not know: without masses or sizes the results are in units of m r w^2.
format = 1
name = "{name}"
cycle = "{cycle}"            # or "{other}"
rotation = "clockwise"            # of the crankshaft, seen from the front; or "counter-clockwise"
firing_order = {order}
speed = "{speed}"                # the speed at which to quote forces
# a counterweight on each throw, for its rotating mass and this share of its reciprocating mass:
# balance_factor = 0.5
# {valves}; what is left out is assumed (crankstar strokes):
# valves.intake_opens = "{io}"
# valves.intake_closes = "{ic}"
# valves.exhaust_opens = "{eo}"
# valves.exhaust_closes = "{ec}"
source = ""                       # where the numbers come from

[cylinder]                        # all cylinders alike
bore = "{bore}"
stroke = "{stroke}"
rod_length = "{rod}"              # between centres; or rod_ratio = 3.5 (over the crank radius)
reciprocating_mass = "{mass}"     # goes up and down: piston, pin, locks, rings, rod's small end
rotating_mass = "{rotating}"      # hangs on the crank pin: rod's big end, bearing shells, oil
# throw_mass = "200 g"            # the bare throw's own unbalance: crank pin, webs; in no bobweight
# the parts as weighed, instead of reciprocating_mass and rotating_mass (crankstar bobweight):
# parts.piston = "400 g"          # and pin, locks, rings, small_end: these go up and down
# parts.big_end = "500 g"         # and bearing_shells, oil: these turn with the crank pin
# offset = "0 mm"                 # the cylinder axis passes this far clockwise of the crankshaft's
# rod = {{ mass = "0.6 kg", centre = "40 mm", inertia = "0.002 kg*m^2" }}   # instead of shares
"""

_TAIL = """
# [[crankshaft]]                  # the first one's bearings, webs and weights; assumed if left out
# bearing_count = 2               # number of main bearings; or their places, from front to rear:
# bearings = ["100 mm", "-100 mm"]            # 0 is the middle of the cylinders, + the front
# weight = [{ throw = 1, unbalance = "20 g*m" }]                     # opposite pin 1

# [[balance_shaft]]
# speed_ratio = -1                # turns per turn of the crankshaft; or teeth, "29/31"
# right = "100 mm"                # seen from the front; up = "..." for height
# weight = [{ angle = "180 deg", unbalance = "10 g*m", z = "0 mm" }]   # bearing at theta = 0

# [[cylinders]]                   # what is different about one of them
# number = 1
# reciprocating_mass = "655 g"

# [provenance]                    # published, computed, unverified (from memory) or placeholder
# "cylinder.bore" = { status = "published", source = "workshop manual, page 12" }
"""

_FOUR = {
    "cycle": "four-stroke",
    "other": "two-stroke",
    "bore": "87.5 mm",
    "stroke": "82.5 mm",
    "rod": "146 mm",
}
_FOUR.update({"valves": "valves, before and after their dead centres"})
_FOUR.update({"io": "15 deg", "ic": "50 deg", "eo": "50 deg", "ec": "15 deg"})
_FOUR.update({"mass": "650 g", "rotating": "700 g", "speed": "6000 rpm"})
_TWO = {
    "cycle": "two-stroke",
    "other": "four-stroke",
    "bore": "54 mm",
    "stroke": "54.4 mm",
    "rod": "110 mm",
}
_TWO.update({"valves": "ports, before and after bottom dead centre"})
_TWO.update({"io": "60 deg", "ic": "60 deg", "eo": "85 deg", "ec": "85 deg"})
_TWO.update({"mass": "280 g", "rotating": "300 g", "speed": "10000 rpm"})
_STAR = {
    **_FOUR,
    "bore": "146 mm",
    "stroke": "160 mm",
    "rod": "310 mm",
    "mass": "3.2 kg",
    "rotating": "2.5 kg",
    "speed": "2200 rpm",
}
_HEAVY = {
    **_TWO,
    "bore": "105 mm",
    "stroke": "160 mm",
    "rod": "270 mm",
    "mass": "3 kg",
    "rotating": "3 kg",
    "speed": "2200 rpm",
}

_BODIES: dict[str, tuple[dict[str, str], str]] = {
    "inline": (
        {**_FOUR, "name": "my in-line four", "order": "[1, 3, 4, 2]"},
        """
[layout]
type = "inline"
# from pin 1, clockwise; left out: evenly spaced, as the firing order needs
throws = ["0 deg", "180 deg", "180 deg", "0 deg"]
bore_pitch = "91 mm"              # or positions = ["0 mm", "91 mm", ...] behind cylinder 1
# bearing = "0 deg"               # a slanted engine
""",
    ),
    "vee": (
        {**_FOUR, "name": "my V8", "order": "[1, 8, 4, 3, 6, 5, 7, 2]"},
        """
[layout]
type = "vee"
banks = [                         # a W has three or four; cylinders from front to rear
  { bearing = "45 deg", cylinders = [1, 3, 5, 7] },
  { bearing = "-45 deg", cylinders = [2, 4, 6, 8] },
]
# one for each pin, or one for each cylinder; from pin 1, clockwise
throws = ["0 deg", "90 deg", "-90 deg", "180 deg"]
bore_pitch = "105.5 mm"
bank_offset = "21 mm"             # the first bank in front of the second; 0: fork-and-blade rods
# pin_split = "30 deg"            # split pins: the second bank's are turned clockwise by this
""",
    ),
    "boxer": (
        {**_FOUR, "name": "my boxer four", "order": "[1, 3, 2, 4]"},
        """
[layout]
type = "boxer"                    # pairs on pins 180 deg apart; a 180 deg V is a vee
banks = [
  { bearing = "90 deg", cylinders = [1, 3] },
  { bearing = "-90 deg", cylinders = [2, 4] },
]
throws = ["0 deg", "180 deg"]     # the pins of the first bank, from pin 1, clockwise
bore_pitch = "113 mm"
bank_offset = "46 mm"             # how far the first bank stands in front of the second
""",
    ),
    "tandem": (
        {**_TWO, "name": "my tandem twin", "order": "[1, 2]"},
        """
[layout]
type = "tandem"                   # several crankshafts geared together: tandem, U, square four, H
[[layout.cranks]]
name = "front"
banks = [{ bearing = "0 deg", cylinders = [1] }]
throws = ["0 deg"]                # from this crankshaft's own pin 1, clockwise
[[layout.cranks]]
name = "rear"
right = "90 mm"                   # of the first, seen from the front; up = "..." for height
speed_ratio = -1                  # turns per turn of the first, negative the other way; or "29/31"
lag = "180 deg"                   # its first cylinder reaches top dead centre this much later
banks = [{ bearing = "0 deg", cylinders = [2] }]
throws = ["0 deg"]
""",
    ),
    "opposed": (
        {**_HEAVY, "name": "my opposed-piston three", "order": "[1, 3, 2]"},
        """
[layout]
type = "opposed"                  # two pistons in each cylinder; cylinder k has pistons k and n + k
throws = ["0 deg", "120 deg", "240 deg"]   # of the first crankshaft, from pin 1, clockwise
crank_distance = "860 mm"
lag = "11 deg"                    # the second crankshaft follows by this
speed_ratio = 1                   # -1: it turns the other way
bore_pitch = "150 mm"
""",
    ),
    "radial": (
        {**_STAR, "name": "my radial nine", "order": "[1, 3, 5, 7, 9, 2, 4, 6, 8]"},
        """
[layout]
type = "radial"
knuckle_radius = "60 mm"          # of slave rods; left out: all rods on the crank pin
# slave_rod_length = "240 mm"     # the master's rod_length less the knuckle radius if left out
rows = [{ cylinders = [1, 2, 3, 4, 5, 6, 7, 8, 9], bearing = "0 deg", throw = "0 deg", master = 1 }]
# row_pitch = "150 mm"            # for more than one row
""",
    ),
}

_EXPLICIT = """\
# An engine file of crankstar in the explicit form: every shaft, throw, weight and cylinder. Any
# other file can be printed in it with:   crankstar show FILE --explicit
# Angles are bearings at theta = 0: 0 is up, clockwise seen from the front. z is positive to the
# front.
format = 1
name = "my in-line three with a balance shaft"
cycle = "four-stroke"
firing_order = [1, 2, 3]
speed = "6000 rpm"
bore_pitch = "91 mm"              # the length a in which normalised couples are counted

[[shaft]]                         # the first one is the reference crankshaft
name = "crank"
throw = [
  { angle = "0 deg", radius = "41.25 mm", z = "91 mm", rotating_mass = "0.7 kg" },
  { angle = "120 deg", radius = "41.25 mm", z = "0 mm", rotating_mass = "0.7 kg" },
  { angle = "-120 deg", radius = "41.25 mm", z = "-91 mm", rotating_mass = "0.7 kg" },
]
# rotating_mass hangs on the pin, as its bobweight does; throw_mass = "200 g" is the throw's own
weight = [                        # counterweights: unbalance is mass times radius
  { angle = "180 deg", unbalance = "0.04228 kg*m", z = "91 mm" },
  { angle = "-60 deg", unbalance = "0.04228 kg*m", z = "0 mm" },
  { angle = "60 deg", unbalance = "0.04228 kg*m", z = "-91 mm" },
]
# bearings = ["136 mm", "45 mm", "-45 mm", "-136 mm"]   # main bearings; or bearing_count = 4
# webs = ["114 mm", "68 mm", "23 mm", "-23 mm", "-68 mm", "-114 mm"]

[[shaft]]
name = "balance shaft"
speed_ratio = -1                  # turns per turn of the crankshaft; or teeth, "29/31"
right = "100 mm"                  # seen from the front; up = "..." for height
weight = [
  { angle = "150 deg", unbalance = "0.01161 kg*m", z = "91 mm" },
  { angle = "-30 deg", unbalance = "0.01161 kg*m", z = "-91 mm" },
]

[[cylinders]]
number = 1
shaft = "crank"
throw = 1                         # counted from 1
bearing = "0 deg"
z = "91 mm"
bore = "87.5 mm"
rod_length = "146 mm"
reciprocating_mass = "650 g"

[[cylinders]]
number = 2
shaft = "crank"
throw = 2
z = "0 mm"
bore = "87.5 mm"
rod_length = "146 mm"
reciprocating_mass = "650 g"

[[cylinders]]
number = 3
shaft = "crank"
throw = 3
z = "-91 mm"
bore = "87.5 mm"
rod_length = "146 mm"
reciprocating_mass = "650 g"      # or parts.piston, pin, locks, rings, small_end as weighed
# offset = "0 mm"                 # the cylinder axis passes this far clockwise of the shaft's
# the rod as a rigid body; on a knuckle pin of another rod:
# rod = { mass = "0.6 kg", centre = "40 mm", inertia = "0.002 kg*m^2" }
# articulated = { master = 1, radius = "50 mm", angle = "40 deg" }
"""

STARTERS: dict[str, str] = {
    **{kind: _HEAD.format(**values) + body + _TAIL for kind, (values, body) in _BODIES.items()},
    "explicit": _EXPLICIT,
}
"""By layout: the text of a commented engine file that is a real engine as it stands."""
