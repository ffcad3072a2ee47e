"""Random possible engines: every layout, and any shafts, throws, weights and cylinders.

Strategies for hypothesis.

They are possible by construction: a rod is as long as its crank radius, its offset and the knuckle
pins under it could ever need, or some slave rods as they do need. Numbers are rounded to a
millionth, so that none is absurdly small.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise
from math import ceil, cos, pi, radians, sin
from typing import Any, NamedTuple

import numpy as np
from hypothesis import reject
from hypothesis import strategies as st
from tests.newton import placed

from crankstar.engine.banks import Bank, Crank
from crankstar.engine.basis import ASSUMED_ROD_RATIO, Basis, Override, Sizes
from crankstar.engine.copies import with_values
from crankstar.engine.dead_centres import dead_centres
from crankstar.engine.drive import Drive
from crankstar.engine.engine import Engine
from crankstar.engine.gas import Gas, OperatingPoint
from crankstar.engine.layouts import LAYOUTS, Row
from crankstar.engine.main_bearings import main_bearings, webs
from crankstar.engine.mounts import Foundation, Mount
from crankstar.engine.oil import Oil, PlainBearing
from crankstar.engine.records import (
    Articulation,
    Block,
    Cylinder,
    Parts,
    Provenance,
    Rod,
    Shaft,
    Throw,
    Valves,
    Weight,
)
from crankstar.engine.torsion import Coupling, Disc, Torsion
from crankstar.language.faults import EngineError

RELEASE = os.environ.get("HYPOTHESIS_PROFILE") == "release"
"""Whether all is run, which can afford many examples of what takes a second each."""

Draw = Callable[[st.SearchStrategy[Any]], Any]

LEAST_CLEARANCE = 1.02


def number(low: float, high: float) -> st.SearchStrategy[float]:
    """Numbers to six decimals: nothing far smaller than anything an engine has."""
    return st.floats(low, high).map(lambda value: round(value, 6))


def maybe(strategy: st.SearchStrategy[Any], otherwise: Any = None) -> st.SearchStrategy[Any]:
    return st.just(otherwise) | strategy


ANGLES = st.sampled_from([0.0, pi / 2, pi, -pi / 2, pi / 4, 2 * pi / 3, -pi / 3]) | number(-pi, pi)
RADII = number(0.01, 0.2)
PLACES = number(-1.0, 1.0)
MASSES = number(0.05, 20.0)
RATIOS = [
    Fraction(r) for r in ("1", "-1", "2", "-2", "1/2", "-1/2", "3/2", "-2/3", "4/3", "3", "-1/3")
]
SPEEDS = number(1.0, 1500.0)
ROTATIONS = st.sampled_from(["clockwise", "counter-clockwise"])
CYCLES = st.sampled_from(["two-stroke", "four-stroke"])
CLEARANCES = st.sampled_from([LEAST_CLEARANCE, 1.05, 2.5, 4.0, 50.0]) | number(LEAST_CLEARANCE, 6.0)
"""Rod length over the longest that it could have to span."""
GASES = st.sampled_from(
    [
        Gas(imep=9e5),
        Gas(process="otto", compression_ratio=8.0, bmep=6e5, friction="none"),
        Gas(compression_ratio=10.5, points=(OperatingPoint(name="idle", imep=2e5, speed=80.0),)),
    ]
)
DRIVES = st.builds(
    Drive, inertia=number(0.001, 50.0), load_exponent=st.sampled_from([-1.0, 0.0, 2.0])
)
OILS = st.sampled_from(
    [Oil(viscosity=0.008), Oil(main=PlainBearing(diameter=0.06, length=0.02, clearance=25e-6))]
)
TEXTS = st.sampled_from(["a book", "工場の図面", 'two\nlines, "quoted" \\ and a tab\there'])


@st.composite
def rigid_rods(draw: Draw, length: float) -> Rod:
    mass = draw(number(0.05, 5.0))
    return Rod(
        mass=mass,
        centre=draw(number(-0.3, 1.3)) * length,
        inertia=mass * length**2 * draw(maybe(number(0.01, 0.5), 0.0)),
    )


@st.composite
def shafts(draw: Draw, name: str, ratio: Fraction, *, least_throws: int) -> Shaft:
    first = name == "shaft 0"
    throw = st.builds(Throw, angle=ANGLES, radius=RADII, z=PLACES, rotating_mass=maybe(MASSES, 0.0))
    throws = draw(st.lists(throw, min_size=least_throws, max_size=4))
    own = maybe(st.integers(1, len(throws))) if throws else st.none()
    weight = st.builds(Weight, unbalance=number(0.0, 0.5), angle=ANGLES, z=PLACES, throw=own)
    weights = draw(st.lists(weight, max_size=3))
    up, right = (0.0 if first else draw(PLACES) for _ in range(2))
    return Shaft.model_validate(
        {
            "name": name,
            "speed_ratio": ratio,
            "up": up,
            "right": right,
            "throws": throws,
            "weights": weights,
        }
    )


@st.composite
def speed_ratios(draw: Draw) -> list[Fraction]:
    """One to four shafts; the common period stays within 31 turns."""
    teeth = draw(st.sampled_from([1, 1, 2, 3, 5, 31]))
    others = st.sampled_from([r for r in RATIOS if teeth % r.denominator == 0])
    odd = st.builds(
        Fraction,
        st.integers(1, 2 * teeth).flatmap(lambda n: st.sampled_from([n, -n])),
        st.just(teeth),
    )
    return [Fraction(1), *draw(st.lists(others | odd, max_size=3))]


class _Pin(NamedTuple):
    """A crank pin, or a knuckle pin of a master rod, with its greatest distance from the shaft."""

    shaft: str
    throw: int
    radius: float


@st.composite
def _cylinders(draw: Draw, engine_shafts: Sequence[Shaft], *, tight: bool) -> list[Cylinder]:
    pins = [
        _Pin(s.name, slot, t.radius) for s in engine_shafts for slot, t in enumerate(s.throws, 1)
    ]
    numbers = draw(st.permutations(range(1, draw(st.integers(1, 6)) + 1)))
    made: list[Cylinder] = []
    reach: dict[int, float] = {}
    for index, own in enumerate(numbers):
        master = draw(maybe(st.sampled_from(made))) if made else None
        link = None
        if master is None:
            pin = draw(st.sampled_from(pins))
            reach[own] = pin.radius
        else:
            pin = next(
                pin for pin in pins if (pin.shaft, pin.throw) == (master.shaft, master.throw)
            )
            link = Articulation(
                master=master.number, radius=draw(number(0.1, 0.8)) * pin.radius, angle=draw(ANGLES)
            )
            reach[own] = reach[master.number] + link.radius
        offset = draw(maybe(number(-0.9, 0.9), 0.0)) * pin.radius
        length = (reach[own] + abs(offset)) * draw(CLEARANCES)
        cylinder = Cylinder(
            number=own,
            shaft=pin.shaft,
            throw=pin.throw,
            bearing=draw(ANGLES),
            z=draw(PLACES),
            offset=offset,
            bore=draw(maybe(number(0.02, 0.5))),
            rod_length=length,
            reciprocating_mass=draw(MASSES if index == 0 else maybe(MASSES, 0.0)),
            big_end_mass=draw(maybe(MASSES, 0.0)),
            rod=draw(maybe(rigid_rods(length))),
            articulated=link,
            bank=draw(maybe(st.sampled_from(["left", "right"]))),
        )
        if tight and link and draw(st.booleans()):
            needed = max(_across([*made, cylinder], engine_shafts), pin.radius / 10)
            cylinder = cylinder.model_copy(
                update={"rod_length": needed * draw(st.sampled_from([LEAST_CLEARANCE, 1.2, 2.5]))}
            )
        made.append(cylinder)
    return made


def _across(cylinders: Sequence[Cylinder], engine_shafts: Sequence[Shaft]) -> float:
    """How far the big end of the last cylinder comes from its axis."""
    last = cylinders[-1]
    engine = Engine.model_validate(
        {"name": "draft", "shafts": engine_shafts, "cylinders": cylinders}
    )
    pin, _, _ = placed(
        engine, last, np.linspace(0, 2 * pi, 720) / abs(float(engine.shaft(last.shaft).speed_ratio))
    )
    return float(
        np.abs(pin @ np.array([cos(last.bearing), -sin(last.bearing)]) - last.offset).max()
    )


def _shared(
    draw: Draw, cylinders: list[Cylinder], engine_shafts: Sequence[Shaft]
) -> list[Cylinder]:
    """Perhaps one pair of pistons with a combustion chamber in common."""
    speed = {s.name: abs(s.speed_ratio) for s in engine_shafts}
    pairs = [
        (a, b)
        for a in cylinders
        for b in cylinders
        if a.number < b.number and speed[a.shaft] == speed[b.shaft]
    ]
    pair = draw(maybe(st.sampled_from(pairs))) if pairs else None
    if pair is None:
        return cylinders
    chamber = draw(st.sampled_from([pair[0].number, 1000]))
    return [c.model_copy(update={"chamber": chamber}) if c in pair else c for c in cylinders]


def fired(engine: Engine, *, with_angles: bool) -> Engine:
    """The engine firing in the order of its dead centres; unchanged if that exceeds a cycle."""
    centres = {chamber: centre.angle_deg for chamber, centre in dead_centres(engine).items()}
    order = tuple(sorted(centres, key=centres.__getitem__))
    angles = [centres[chamber] for chamber in order]
    if (
        any(b - a < 1e-3 for a, b in pairwise(angles))
        or angles[-1] - angles[0] > engine.cycle_angle - 1e-3
    ):
        return engine
    update: dict[str, Any] = {"firing_order": order}
    if with_angles:
        update["firing_angles"] = tuple(map(radians, angles))
    return engine.model_copy(update=update)


def _weighed(cylinders: Sequence[Cylinder], engine_shafts: Sequence[Shaft]) -> list[Cylinder]:
    """The cylinders with parts that come to their masses and to those of their throws.

    The ends of a rod with a mass of its own are in none of them.
    """
    on_throw = Counter((own.shaft, own.throw) for own in cylinders if own.articulated is None)
    throw = {
        (shaft.name, slot): each
        for shaft in engine_shafts
        for slot, each in enumerate(shaft.throws, 1)
    }

    def parts(own: Cylinder) -> Parts | None:
        place = (own.shaft, own.throw)
        turning = own.big_end_mass
        if own.articulated is None:
            turning = throw[place].rotating_mass / on_throw[place]
        up, ends = own.reciprocating_mass, 0.0 if own.rod else 0.25
        if not (up or turning):
            return None
        return Parts(
            piston=up * 0.5,
            pin=up * (0.375 - ends),
            rings=up * 0.09375,
            locks=up * 0.03125,
            small_end=up * ends,
            big_end=turning * ends,
            bearing_shells=turning * (0.875 - ends),
            oil=turning * 0.125,
        )

    return [own.model_copy(update={"parts": parts(own)}) for own in cylinders]


@st.composite
def engines(draw: Draw, *, known: bool = False, max_shafts: int = 4, tight: bool = True) -> Engine:
    """Any engine at all, written shaft by shaft and cylinder by cylinder.

    `known` leaves nothing relative; unless `tight`, slave rods are long enough for any other angle
    of their knuckle pins.
    """
    ratios = draw(speed_ratios())[:max_shafts]
    bearer = draw(st.integers(0, len(ratios) - 1))
    turning = [
        draw(shafts(f"shaft {i}", ratio, least_throws=int(i == bearer)))
        for i, ratio in enumerate(ratios)
    ]
    cylinders = _shared(draw, draw(_cylinders(turning, tight=tight)), turning)
    cylinders = _weighed(cylinders, turning) if draw(st.booleans()) else cylinders
    status = st.sampled_from(["published", "computed", "unverified", "placeholder"])
    wide = st.tuples(st.sampled_from([0.5, 0.81]), st.sampled_from([1.0, 1.25]))
    shorter = st.tuples(st.sampled_from([0.5, 0.81]), st.just(1.0))  # a longer throw may not turn
    sources = {
        path: st.builds(Provenance, status=status, source=maybe(TEXTS, ""))
        | st.builds(Provenance, status=st.just("estimated"), range=ends)
        for path, ends in (("speed", maybe(wide, None)), ("shaft[1].throw[1].radius", shorter))
    }
    bound = st.builds(
        lambda ends: {
            "speed": Provenance(status="estimated", range=ends),
            "shaft[1].throw[1].radius": Provenance(
                status="estimated", range=ends, moves_with="speed"
            ),
        },
        shorter,
    )
    engine = Engine.model_validate(
        {
            "name": draw(st.sampled_from(["engine", "двигатель [1]"])),
            "cycle": draw(CYCLES),
            "rotation": draw(ROTATIONS),
            "speed": draw(maybe(SPEEDS)),
            "source": draw(maybe(TEXTS, "")),
            "notes": draw(maybe(TEXTS, "")),
            "left_out": draw(maybe(st.sampled_from([("balance rod",), ("a, b", "c")]), ())),
            "provenance": draw(bound | st.fixed_dictionaries({}, optional=sources)),
            "relative": ()
            if known
            else draw(
                st.lists(st.sampled_from(["mass", "radius", "pitch"]), unique=True, max_size=3)
            ),
            "bore_pitch": draw(maybe(number(0.02, 0.5))),
            "block": draw(maybe(blocks(cylinders))),
            "shafts": turning,
            "cylinders": draw(st.permutations(cylinders)),
        }
    )
    engine = draw(_supported(engine))
    engine = fired(engine, with_angles=draw(st.booleans())) if draw(st.booleans()) else engine
    valves = draw(maybe(timed_valves(engine)))
    more = {"gas": draw(maybe(GASES)), "drive": draw(maybe(DRIVES)), "oil": draw(maybe(OILS))}
    made = engine.model_copy(update={"valves": None if valves == Valves() else valves, **more})
    return draw(twisting(draw(mounted(made)))) if draw(st.integers(0, 3)) == 0 else made


@st.composite
def mounted(draw: Draw, engine: Engine) -> Engine:
    """The same on four mounts, on a raft or on the ground, where masses and lengths are known."""
    if engine.relative or engine.block is None:
        return engine
    stiffness = (draw(number(1e4, 1e7)), draw(number(1e4, 1e7)), draw(number(1e4, 1e7)))
    corners = [(-0.3, -0.4), (-0.3, 0.4), (0.3, -0.4), (0.3, 0.4)]
    stood = [
        Mount(name=f"{n}", right=x, z=z, stiffness=stiffness) for n, (x, z) in enumerate(corners)
    ]
    below = tuple(with_values(each, name=f"below {each.name}") for each in stood)
    raft = Foundation(mass=500, inertia_up=80, inertia_right=70, inertia_z=60, mounts=below)
    return with_values(engine, mounts=tuple(stood), foundation=draw(maybe(st.just(raft))))


@st.composite
def twisting(draw: Draw, engine: Engine) -> Engine:
    """The same with an elastic crankshaft, further ones coupled to it."""
    cranks = [shaft for shaft in engine.shafts if shaft.throws]
    if not cranks or cranks[0] is not engine.shafts[0]:
        return engine
    several = sum(len(shaft.throws) for shaft in cranks) > len(cranks)
    torsion = Torsion(
        inertia=(draw(number(0.001, 5.0)),),
        stiffness=(draw(number(1e4, 1e7)),) if several else (),
        couplings=tuple(Coupling(crankshaft=shaft.name, stiffness=1e6) for shaft in cranks[1:]),
        discs=(Disc(name="flywheel", inertia=1.0, to="rear", stiffness=1e6),),
    )
    return with_values(engine, torsion=torsion)


@st.composite
def _supported(draw: Draw, engine: Engine) -> Engine:
    """The same with some main bearings, webs and stiffnesses given, where they have room."""
    shaft = next(shaft for shaft in engine.shafts if shaft.throws)
    given = draw(
        st.sampled_from(
            [
                {},
                {"bearing_count": 2},
                {"bearings": main_bearings(engine, shaft), "webs": webs(engine, shaft)},
            ]
        )
    )
    near, far = (2.0, 5.0) if engine.relative else (2e5, 4e8)
    stiff = draw(maybe(st.just({"bending_stiffness": near, "bearing_stiffness": far}), {}))
    try:
        changed = with_values(shaft, **given, **stiff)
        shafts = [changed if each is shaft else each for each in engine.shafts]
        return with_values(engine, shafts=tuple(shafts))
    except EngineError:  # pins too near to each other for a bearing between
        return engine


@st.composite
def blocks(draw: Draw, cylinders: Sequence[Cylinder]) -> Block:
    """Whole engines as rigid bodies, partly left to be estimated; inertia from spread masses.

    They are heavier than the moving parts of their cylinders.
    """
    moving = sum(
        each.reciprocating_mass + each.big_end_mass + (each.rod.mass if each.rod else 0.0)
        for each in cylinders
    )
    high, broad, long = (draw(number(0.1, 50.0)) for _ in range(3))
    inertia = {"inertia_up": broad + long, "inertia_right": high + long, "inertia_z": high + broad}
    place = {
        "up": draw(maybe(PLACES, 0.0)),
        "right": draw(maybe(PLACES, 0.0)),
        "z": draw(maybe(PLACES)),
    }
    return Block(
        mass=round(moving + draw(number(1.0, 5000.0)), 3),
        **place,
        **(inertia if draw(st.booleans()) else {}),
    )


@st.composite
def timed_valves(draw: Draw, engine: Engine) -> Valves:
    """Valves or ports that can run, some angles left out, with or without manifolds."""
    four = {
        "intake_opens": (-20, 60),
        "intake_closes": (-40, 90),
        "exhaust_opens": (20, 90),
        "exhaust_closes": (-20, 60),
    }
    two = {
        "intake_opens": (40, 75),
        "intake_closes": (40, 75),
        "exhaust_opens": (60, 105),
        "exhaust_closes": (40, 105),
    }
    ranges = four if engine.cycle == "four-stroke" else two
    angles = {
        name: draw(maybe(number(radians(low), radians(high))))
        for name, (low, high) in ranges.items()
    }
    order = tuple(draw(st.permutations(sorted(engine.chambers))))
    at = draw(st.integers(0, len(order) - 1))
    manifolds = (order[:at], order[at:]) if at else (order,)
    return Valves(**angles, manifolds=draw(st.sampled_from([(), manifolds])))


class _Size(NamedTuple):
    """Crank radius, greatest offset and knuckle radius for the cylinders of a layout."""

    radius: float
    offset: float
    knuckle: float = 0.0
    known: bool = True

    @property
    def reach(self) -> float:
        return LEAST_CLEARANCE * (self.radius + self.offset + self.knuckle)


@st.composite
def _size(draw: Draw, *, knuckle: float = 0.0) -> _Size:
    """`knuckle` in crank radii. Without a known stroke the crank radius is 1."""
    known = draw(st.sampled_from([True, True, False]))
    radius = draw(RADII) if known else 1.0
    return _Size(radius, draw(maybe(st.just(0.4), 0.0)) * radius, knuckle * radius, known)


def _offsets(size: _Size) -> st.SearchStrategy[float]:
    return number(-1.0, 1.0).map(lambda share: share * size.offset)


@st.composite
def _bases(
    draw: Draw,
    numbers: Sequence[int],
    size: _Size,
    *,
    order: Sequence[int] = (),
    own_stroke: bool = False,
    moved: bool = True,
    further: Sequence[Override] = (),
) -> Basis:
    length = (size.reach + size.knuckle) * draw(CLEARANCES)
    ratio = (size.reach + size.knuckle) / size.radius * draw(CLEARANCES)
    rod = draw(st.sampled_from([{"rod_length": length}, {"rod_ratio": ratio}, {}]))
    whole = rod.get("rod_length", rod.get("rod_ratio", ASSUMED_ROD_RATIO) * size.radius)
    cylinder = Sizes(
        bore=draw(maybe(number(0.02, 0.5))),
        stroke=2 * size.radius if size.known else None,
        offset=draw(_offsets(size)),
        reciprocating_mass=draw(maybe(MASSES)),
        rotating_mass=draw(maybe(MASSES, 0.0)),
        rod=draw(maybe(rigid_rods(whole))),
        **rod,
    )
    different = draw(st.lists(st.sampled_from(numbers), unique=True, max_size=2))
    return Basis(
        name="engine",
        cycle=draw(CYCLES),
        rotation=draw(ROTATIONS),
        firing_order=tuple(order),
        speed=draw(maybe(SPEEDS)),
        cylinder=cylinder,
        cylinders=(
            *(
                draw(_overrides(n, size, whole, own_stroke=own_stroke, moved=moved))
                for n in different
            ),
            *further,
        ),
        relative=draw(
            maybe(
                st.lists(st.sampled_from(["mass", "radius", "pitch"]), unique=True, max_size=2), ()
            )
        ),
        balance_factor=draw(maybe(number(0.0, 2.0))),
    )


@st.composite
def _overrides(
    draw: Draw, own: int, size: _Size, whole: float, *, own_stroke: bool, moved: bool
) -> Override:
    longer = {"rod_length": whole * draw(number(1.0, 1.5))}
    shorter_stroke = {"stroke": 2 * size.radius * draw(number(0.5, 1.0)), "rod_length": whole}
    return Override(
        number=own,
        offset=draw(maybe(_offsets(size))),
        reciprocating_mass=draw(maybe(MASSES)),
        rotating_mass=draw(maybe(MASSES)),
        rod=draw(maybe(rigid_rods(whole))),
        bearing=draw(maybe(ANGLES)) if moved else None,
        z=draw(maybe(PLACES)) if moved else None,
        bank=draw(maybe(st.just("other"))),
        **draw(
            st.sampled_from([{}, longer, *([shorter_stroke] if own_stroke and size.known else [])])
        ),
    )


@st.composite
def _pitches(draw: Draw, count: int) -> dict[str, Any]:
    """A bore pitch, none, or uneven positions."""
    gaps = draw(st.lists(number(0.05, 0.5), min_size=count, max_size=count))
    positions = tuple(sum(gaps[:place]) for place in range(count))
    return draw(st.sampled_from([{"bore_pitch": 0.11}, {}, {"positions": positions}]))


@st.composite
def inline_engines(draw: Draw, *, moved: bool = True) -> Engine:
    count = draw(st.integers(1, 6))
    numbers = tuple(range(1, count + 1))
    throws = draw(maybe(st.tuples(*[ANGLES] * count)))
    order = draw(st.permutations(numbers)) if throws is None else ()
    basis = draw(_bases(numbers, draw(_size()), order=order, own_stroke=True, moved=moved))
    places = {"bearing": draw(ANGLES), **draw(_pitches(count))}
    try:
        return LAYOUTS["inline"](basis, throws=throws, **places)
    except EngineError as error:
        if any(not fault.code.startswith("firing_order.unfit") for fault in error.faults):
            raise
        reject()  # a cylinder that was moved cannot fire in its turn


@st.composite
def _banks(
    draw: Draw,
    bearings: Sequence[float],
    size: _Size,
    *,
    of: int,
    first: int = 1,
    own_pins: bool = False,
) -> tuple[Bank, ...]:
    count = len(bearings)
    numbers = draw(st.permutations(range(first, first + of * count)))
    return tuple(
        Bank(
            bearing=bearing,
            cylinders=tuple(sorted(numbers[index * of : (index + 1) * of])),
            name=draw(maybe(st.just(f"bank of {index}"))),
            offset=draw(maybe(_offsets(size))),
            set_back=draw(maybe(number(-0.1, 0.1))),
            pin_angle=draw(maybe(ANGLES)) if own_pins else None,
        )
        for index, bearing in enumerate(bearings)
    )


@st.composite
def vee_engines(draw: Draw, *, moved: bool = True) -> Engine:
    """V, VR, W: shared or split pins, a throw per cylinder, or articulated rods on shared pins."""
    per_bank = draw(st.integers(1, 4))
    size = draw(_size(knuckle=0.3))
    bearings = draw(st.lists(ANGLES, min_size=2, max_size=4 if per_bank < 3 else 2))
    style = draw(st.sampled_from(["shared", "split", "single", "articulated"]))
    banks = draw(_banks(bearings, size, of=per_bank, own_pins=style == "split"))
    numbers = [n for bank in banks for n in bank.cylinders]
    throws = draw(st.tuples(*[ANGLES] * (len(numbers) if style == "single" else per_bank)))
    slaves: list[Override] = []
    if style == "articulated":
        angle = draw(ANGLES)
        for master, slave in zip(banks[0].cylinders, banks[1].cylinders, strict=True):
            link = Articulation(master=master, radius=size.knuckle, angle=angle)
            slaves.append(Override(number=slave, articulated=link))
    others = [n for n in numbers if n not in {slave.number for slave in slaves}]
    return LAYOUTS["vee"](
        draw(_bases(others, size, moved=moved, further=slaves)),
        banks=banks,
        throws=throws,
        bank_offset=draw(maybe(number(-0.1, 0.1), 0.0)),
        pin_split=draw(ANGLES) if style == "split" else 0.0,
        **draw(_pitches(per_bank)),
    )


@st.composite
def boxer_engines(draw: Draw, *, moved: bool = True) -> Engine:
    per_bank, bearing, size = draw(st.integers(1, 3)), draw(ANGLES), draw(_size())
    return LAYOUTS["boxer"](
        draw(_bases(range(1, 2 * per_bank + 1), size, moved=moved)),
        banks=draw(_banks([bearing, bearing + pi], size, of=per_bank)),
        throws=draw(st.tuples(*[ANGLES] * per_bank)),
        bank_offset=draw(maybe(number(-0.1, 0.1), 0.0)),
        **draw(_pitches(per_bank)),
    )


@st.composite
def tandem_engines(draw: Draw, *, moved: bool = True) -> Engine:
    size, per_bank = draw(_size()), draw(st.integers(1, 2))
    cranks: list[Crank] = []
    for index in range(draw(st.integers(2, 3))):
        bearings = draw(st.lists(ANGLES, min_size=1, max_size=2))
        first = 1 + sum(len(bank.cylinders) for crank in cranks for bank in crank.banks)
        banks = draw(_banks(bearings, size, of=per_bank, first=first, own_pins=True))
        place = (
            {}
            if index == 0
            else {
                "up": draw(PLACES),
                "right": draw(PLACES),
                "speed_ratio": draw(st.sampled_from(RATIOS)),
            }
        )
        throws = draw(
            st.tuples(*[ANGLES] * draw(st.sampled_from([per_bank, per_bank * len(bearings)])))
        )
        cranks.append(
            Crank(
                banks=banks,
                throws=throws,
                lag=draw(maybe(ANGLES, 0.0)) if index or moved else 0.0,
                **place,
            )
        )
    count = sum(len(bank.cylinders) for crank in cranks for bank in crank.banks)
    return LAYOUTS["tandem"](
        draw(_bases(range(1, count + 1), size, moved=moved)),
        cranks=tuple(cranks),
        bank_offset=draw(maybe(number(-0.1, 0.1), 0.0)),
        **draw(_pitches(per_bank)),
    )


@st.composite
def opposed_engines(draw: Draw, *, moved: bool = True) -> Engine:
    count = draw(st.integers(1, 3))
    return LAYOUTS["opposed"](
        draw(_bases(range(1, 2 * count + 1), draw(_size()), moved=moved)),
        throws=draw(st.tuples(*[ANGLES] * count)),
        crank_distance=draw(number(0.3, 3.0)),
        lag=draw(maybe(ANGLES, 0.0)),
        speed_ratio=draw(st.sampled_from([Fraction(1), Fraction(-1)])),
        bearing=draw(ANGLES),
        **draw(_pitches(count)),
    )


@st.composite
def radial_engines(draw: Draw, *, moved: bool = True) -> Engine:
    """Stars of one or more rows, all rods on the crank pin or slave rods on a master."""
    articulated = draw(st.booleans())
    size = draw(_size(knuckle=0.5 if articulated else 0.0))
    rows: list[Row] = []
    for _ in range(draw(st.integers(1, 3))):
        first = 1 + sum(len(row.cylinders) for row in rows)
        numbers = draw(st.permutations(range(first, first + draw(st.integers(1, 5)))))
        rows.append(
            Row(
                cylinders=tuple(numbers),
                bearing=draw(ANGLES),
                throw=draw(ANGLES),
                master=draw(maybe(st.sampled_from(numbers))),
            )
        )
    count = sum(len(row.cylinders) for row in rows)
    return LAYOUTS["radial"](
        draw(_bases(range(1, count + 1), size, moved=moved)),
        rows=tuple(rows),
        row_pitch=draw(maybe(number(0.05, 0.5))),
        knuckle_radius=size.knuckle if articulated else None,
        slave_rod_length=draw(maybe(st.just(ceil(size.reach * 1e4) / 1e4)))
        if articulated
        else None,
    )


_WRITTEN_BY: dict[str, Callable[..., st.SearchStrategy[Engine]]] = {
    "inline": inline_engines,
    "vee": vee_engines,
    "boxer": boxer_engines,
    "tandem": tandem_engines,
    "opposed": opposed_engines,
    "radial": radial_engines,
}


def of_layout(name: str, *, moved: bool = True) -> st.SearchStrategy[Engine]:
    """Engines of a layout function; unless `moved`, each cylinder stays where it puts it."""
    return _WRITTEN_BY[name](moved=moved)


OF_LAYOUT = {name: of_layout(name) for name in _WRITTEN_BY}
OF_ANY_KIND: dict[str, st.SearchStrategy[Engine]] = {"explicit": engines(), **OF_LAYOUT}
"""The engines of every layout, and explicit ones."""
