"""The definition of an engine's forces in sixty digits (mpmath).

A road to the exact derivations that shares nothing with them.

Numbers are taken for what is written: angles for parts of a turn, lengths and masses for their
decimals.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import pi
from typing import Any, NamedTuple

from hypothesis import strategies as st
from mpmath.ctx_mp import MPContext

from crankstar.derive.algebra import formula
from crankstar.engine.engine import Engine
from crankstar.engine.records import Articulation, Cylinder, Rod, Shaft, Throw, Weight
from crankstar.mechanics.excitation import Reference

MP = MPContext()
MP.dps = 60
SAMPLES = 160
"""Of a turn: with rods twice as long as they must be what they fold is far below sixty digits."""
NOTHING, SOMETHING = MP.mpf(10) ** -50, MP.mpf(10) ** -40

Draw = Callable[[st.SearchStrategy[Any]], Any]


def written(value: float) -> Fraction:
    """A double as the decimal that was written."""
    return Fraction(f"{value:.13g}")


def unit_mass(first: Cylinder) -> Fraction:
    """What goes up and down in the first cylinder; 1 kg where that is nothing."""
    rod, mass = first.rod, written(first.reciprocating_mass)
    if rod is None:
        return mass or Fraction(1)
    small_end = written(rod.mass) * written(rod.centre) / written(first.rod_length)
    return mass + max(small_end, Fraction(0)) or written(rod.mass)


def part(radians: float) -> Fraction:
    """An angle as the part of a turn that was meant."""
    found = Fraction(radians / (2 * pi)).limit_denominator(36_000)
    if abs(float(found) - radians / (2 * pi)) > 2e-13:
        raise ValueError(f"{radians} is no part of a turn")
    return found


def mp(value: Fraction | int) -> Any:
    """A fraction in sixty digits."""
    value = Fraction(value)
    return MP.mpf(value.numerator) / value.denominator


def unit(turn: Fraction) -> Any:
    """exp(2 pi i turn) in sixty digits."""
    return MP.expjpi(mp(2 * (turn % 1)))


def angle(radians: float) -> Any:
    """An angle in sixty digits."""
    return 2 * MP.pi * mp(part(radians))


def is_nothing(number: Any) -> bool:
    """Whether a sum is zero; there must be a gap between what is and what is not."""
    size = abs(number)
    assert size < NOTHING or size > SOMETHING, f"{size} is neither zero nor far from it"
    return bool(size < NOTHING)


@lru_cache(maxsize=512)
def piston_harmonic(rod_ratio: Fraction, order: int, offset: Fraction = Fraction(0)) -> Any:
    """A_k of a plain rod: k^2 times the Fourier coefficient of the travel.

    The travel is cos psi + sqrt(L^2 - (sin psi - e)^2).
    """
    whole = MP.mpf(0)
    for place in range(SAMPLES):
        turn = unit(Fraction(place, SAMPLES))
        travel = turn.real + MP.sqrt(mp(rod_ratio) ** 2 - (turn.imag - mp(offset)) ** 2)
        whole += travel * MP.conj(unit(Fraction(order * place, SAMPLES)))
    return whole * 2 / SAMPLES * order**2


class Amplitudes(NamedTuple):
    """Up and right of a signal `Re(z exp(i k theta))`, in m r w^2 (couples in m r w^2 a)."""

    up: Any
    right: Any


def arm(engine: Engine, z: float, reference: Reference | None) -> Any:
    """How far in front of the reference plane something stands, in bore pitches."""
    places = [written(c.z) for c in engine.cylinders]
    plane = (min(places) + max(places)) / 2 if reference is None else written(reference.z)
    return mp((written(z) - plane) / written(engine.pitch))


def defined(
    engine: Engine, order: Fraction, quantity: str, reference: Reference | None = None
) -> Amplitudes:
    """One order of an engine with plain rods and centred cranks: the sum over its parts."""
    up, right = MP.mpc(0), MP.mpc(0)
    first = engine.first
    base = mp(unit_mass(first) * written(engine.throw(first).radius))

    def place(z: float) -> Any:
        return arm(engine, z, reference) if quantity == "couple" else 1

    def turning(shaft: Shaft, unbalance: Fraction, at: float, z: float) -> None:
        nonlocal up, right
        if abs(shaft.speed_ratio) == order:
            sign = engine.sense * (1 if shaft.speed_ratio > 0 else -1)
            push = unit(sign * part(at)) * mp(unbalance * shaft.speed_ratio**2) / base * place(z)
            up, right = up + push, right - 1j * sign * push

    for c in engine.cylinders:
        throw, shaft = engine.throw(c), engine.shaft(c.shaft)
        radius, length, mass = (
            written(throw.radius),
            written(c.rod_length),
            written(c.reciprocating_mass),
        )
        on_pin = written(c.big_end_mass)
        if c.rod:
            share = written(c.rod.centre) / length
            mass, on_pin = (
                mass + written(c.rod.mass) * share,
                on_pin + written(c.rod.mass) * (1 - share),
            )
        turning(shaft, on_pin * radius, throw.angle, c.z)
        j = order / abs(shaft.speed_ratio)
        if j.denominator == 1 and (j == 1 or j % 2 == 0):
            sign = engine.sense * (1 if shaft.speed_ratio > 0 else -1)
            size = piston_harmonic(length / radius, int(j)) if j > 1 else 1
            lag = unit(sign * j * (part(throw.angle) - part(c.bearing)))
            push = mp(mass * radius * shaft.speed_ratio**2) / base * size * lag * place(c.z)
            beta = angle(c.bearing)
            up, right = up + push * MP.cos(beta), right + push * MP.sin(beta)
    for shaft in engine.shafts:
        for t in shaft.throws:
            turning(shaft, written(t.rotating_mass) * written(t.radius), t.angle, t.z)
        for w in shaft.weights:
            turning(shaft, written(w.unbalance), w.angle, w.z)
    return Amplitudes(up, right)


@dataclass(frozen=True)
class Moved:
    """`up + i right` mass moment of one cylinder's parts at equal steps of its own shaft."""

    cylinder: Cylinder
    moment: list[Any]


def moved(engine: Engine) -> list[Moved]:
    """Every cylinder followed through a turn of its shaft by plane geometry, whatever its rods."""
    by_number = {c.number: c for c in engine.cylinders}

    def joints(c: Cylinder, step: int) -> tuple[Any, Any]:
        """Big end and piston pin."""
        shaft, throw = engine.shaft(c.shaft), engine.throw(c)
        sign = engine.sense * (1 if shaft.speed_ratio > 0 else -1)
        if c.articulated is None:
            pin = mp(written(throw.radius)) * unit(
                part(throw.angle) + Fraction(sign * step, SAMPLES)
            )
        else:
            below, piston = joints(by_number[c.articulated.master], step)
            master = by_number[c.articulated.master]
            towards = (piston - below) / mp(written(master.rod_length))
            pin = below + mp(written(c.articulated.radius)) * towards * unit(
                part(c.articulated.angle)
            )
        axis = unit(part(c.bearing))
        seen = pin / axis
        across = seen.imag - mp(written(c.offset))
        height = MP.sqrt(mp(written(c.rod_length)) ** 2 - across**2)
        return pin, axis * (seen.real + height + 1j * mp(written(c.offset)))

    def moment(c: Cylinder, step: int) -> Any:
        pin, piston = joints(c, step)
        whole = mp(written(c.reciprocating_mass)) * piston + mp(written(c.big_end_mass)) * pin
        if c.rod:
            share = mp(written(c.rod.centre) / written(c.rod_length))
            whole += mp(written(c.rod.mass)) * (pin + share * (piston - pin))
        return whole

    return [Moved(c, [moment(c, step) for step in range(SAMPLES)]) for c in engine.cylinders]


def followed(
    engine: Engine,
    paths: Sequence[Moved],
    order: Fraction,
    quantity: str,
    reference: Reference | None = None,
) -> Amplitudes:
    """One order of an engine whose cylinders were followed; throws and weights as in `defined`."""
    still = engine.model_copy(
        update={
            "cylinders": tuple(
                c.model_copy(update={"reciprocating_mass": 0.0, "big_end_mass": 0.0, "rod": None})
                for c in engine.cylinders
            )
        }
    )
    first = engine.first
    mass = unit_mass(first)
    up, right = defined(still, order, quantity, reference)
    up, right = up / mp(mass), right / mp(mass)  # without a mass it was counted in 1 kg
    for path in paths:
        j = order / abs(engine.shaft(path.cylinder.shaft).speed_ratio)
        if j.denominator != 1:
            continue
        turns = [MP.conj(unit(Fraction(int(j) * step, SAMPLES))) for step in range(SAMPLES)]
        factor = mp(order**2) * 2 / SAMPLES / mp(mass * written(engine.throw(first).radius))
        factor *= arm(engine, path.cylinder.z, reference) if quantity == "couple" else 1
        up += factor * sum(
            value.real * turn for value, turn in zip(path.moment, turns, strict=True)
        )
        right += factor * sum(
            value.imag * turn for value, turn in zip(path.moment, turns, strict=True)
        )
    return Amplitudes(up, right)


def vectors(found: Amplitudes, sense: int) -> tuple[Any, Any]:
    """Forward and backward: `up + i right = f exp(i s k theta) + b exp(-i s k theta)`."""
    with_theta = (found.up + 1j * found.right) / 2
    against = (MP.conj(found.up) + 1j * MP.conj(found.right)) / 2
    return (with_theta, against) if sense > 0 else (against, with_theta)


def from_ball(ball: Any) -> Any:
    """The middle of a real ball."""
    mantissa, exponent = ball.mid().man_exp()
    return MP.ldexp(MP.mpf(int(mantissa)), int(exponent))


def evaluated(tree: formula.Formula, symbols: Mapping[str, Any] | None = None) -> Any:
    """What a formula comes to in sixty digits: an evaluator of its own."""
    names = symbols or {}

    def of(one: Any) -> Any:
        match one:
            case formula.Rational():
                return mp(one.value)
            case formula.Decimal():
                return from_ball(one.ball)
            case formula.Symbol():
                return names[one.name]
            case formula.Pi():
                return MP.pi
            case formula.Root():
                return MP.sqrt(of(one.radicand))
            case formula.Power():
                return of(one.base) ** one.exponent
            case formula.Sum():
                return sum((of(term) for term in one.terms), MP.mpf(0))
            case formula.Product():
                return MP.fprod(of(factor) for factor in one.factors)
            case formula.Ratio():
                return of(one.above) / of(one.below)
            case formula.Degrees():
                return of(one.value) * MP.pi / 180
            case formula.Applied():
                return {"cos": MP.cos, "sin": MP.sin, "atan": MP.atan}[one.function](
                    of(one.argument)
                )
            case formula.Polar():
                return of(one.length) * MP.expj(of(one.angle))
        raise TypeError(f"no formula: {one!r}")

    return of(tree)


# -- engines whose numbers are short
# -----------------------------------------------------------------------------------

MASSES = st.sampled_from([Fraction(n, 20) for n in (10, 13, 15, 20, 26)])
RADII = st.sampled_from([Fraction(n, 1000) for n in (40, 45, 50)])
SHORT_RATIOS = st.sampled_from(
    [Fraction(2), Fraction(5, 2), Fraction(3), Fraction(7, 2), Fraction(4)]
)
SPEEDS = st.sampled_from(
    [Fraction(r) for r in ("1", "-1", "2", "-2", "1/2", "-1/2", "3/2", "-2/3")]
)


def parts_of_a_turn(*denominators: int) -> st.SearchStrategy[Fraction]:
    """Parts of a turn with one of these denominators."""
    return st.sampled_from(denominators).flatmap(
        lambda n: st.integers(-n, n).map(lambda above: Fraction(above, n))
    )


def radians_of(turn: Fraction) -> float:
    """A part of a turn in radians."""
    return float(turn) * 2 * pi


@st.composite
def short_engines(draw: Draw, *, plain: bool = True) -> Engine:
    """Engines of short decimals and parts of a turn; unless `plain`, offsets and slave rods."""
    few = draw(st.sampled_from([(4, 8), (12,), (10,), (14,), (24, 16), (360,), (4, 14), (7, 9)]))
    angles = parts_of_a_turn(*few).map(radians_of)
    places = st.integers(-20, 20).map(lambda n: n / 20)
    rotating = st.sampled_from([0.0, 0.0, 0.8])
    shafts: list[Shaft] = []
    for index in range(draw(st.integers(1, 3))):
        throws = [
            Throw(
                angle=draw(angles),
                radius=float(draw(RADII)),
                z=draw(places),
                rotating_mass=draw(rotating),
            )
            for _ in range(draw(st.integers(1, 3)))
        ]
        weight = st.builds(Weight, unbalance=st.sampled_from([0.01, 0.02]), angle=angles, z=places)
        ratio = draw(SPEEDS) if index else Fraction(1)
        weights = draw(st.lists(weight, max_size=2))
        shafts.append(
            Shaft(
                name=f"shaft {index}",
                speed_ratio=ratio,
                throws=tuple(throws),
                weights=tuple(weights),
            )
        )
    cylinders: list[Cylinder] = []
    same = draw(st.booleans())
    common = (draw(MASSES), draw(SHORT_RATIOS))
    for number in range(1, draw(st.integers(1, 6)) + 1):
        mass, ratio = common if same else (draw(MASSES), draw(SHORT_RATIOS))
        masters = [c for c in cylinders if c.articulated is None]
        link = None
        if not plain and masters and draw(st.booleans()):
            master = draw(st.sampled_from(masters))
            shaft, throw = next(s for s in shafts if s.name == master.shaft), master.throw
            link = Articulation(
                master=master.number,
                radius=float(shaft.throws[throw - 1].radius) / 4,
                angle=draw(angles),
            )
        else:
            shaft = draw(st.sampled_from(shafts))
            throw = draw(st.integers(1, len(shaft.throws)))
        radius = written(shaft.throws[throw - 1].radius)
        length = float(ratio * radius * (1 if plain else 2))
        offset = 0.0 if plain else draw(st.sampled_from([0.0, 0.01, -0.02]))
        rod = (
            Rod(mass=0.4, centre=length / 4, inertia=0.001)
            if draw(st.sampled_from([False, False, True]))
            else None
        )
        cylinders.append(
            Cylinder(
                number=number,
                shaft=shaft.name,
                throw=throw,
                bearing=draw(angles),
                z=draw(places),
                offset=offset,
                rod_length=length,
                reciprocating_mass=float(mass),
                big_end_mass=draw(st.sampled_from([0.0, 0.0, 0.3])),
                rod=rod,
                articulated=link,
            )
        )
    return Engine(
        name="short",
        rotation=draw(st.sampled_from(["clockwise", "counter-clockwise"])),
        bore_pitch=draw(st.sampled_from([0.1, None, 0.25])),
        shafts=tuple(shafts),
        cylinders=tuple(cylinders),
    )


def orders_of(engine: Engine) -> st.SearchStrategy[Fraction]:
    """Orders in which something of the engine pushes, up to 24."""
    speeds = [abs(s.speed_ratio) for s in engine.shafts]
    found = sorted(
        {
            j * speed
            for speed in speeds
            for j in (1, 1, 2, 3, 4, 6)
            if j * speed <= 24 and j * speed.denominator <= 1000
        }
    )
    return st.sampled_from(found or [Fraction(1)])


def snapped(engine: Engine, part: int) -> Engine:
    """The engine with all angles at parts of a turn, plain rods and centred cranks: exact."""

    def near(radians: float) -> float:
        return round(radians / (2 * pi) * part) / part * 2 * pi

    shafts = tuple(
        s.model_copy(
            update={
                "throws": tuple(t.model_copy(update={"angle": near(t.angle)}) for t in s.throws),
                "weights": tuple(w.model_copy(update={"angle": near(w.angle)}) for w in s.weights),
            }
        )
        for s in engine.shafts
    )
    cylinders = []
    for c in engine.cylinders:
        radius = engine.throw(c).radius
        update = {
            "bearing": near(c.bearing),
            "offset": 0.0,
            "articulated": None,
            "rod_length": max(c.rod_length, 1.05 * radius),
        }
        cylinders.append(c.model_copy(update=update))
    return Engine.model_validate(
        {
            **dict(engine),
            "shafts": shafts,
            "cylinders": cylinders,
            "firing_order": (),
            "firing_angles": None,
        }
    )
