"""Laws of every engine: mechanics is linear in masses and has no up, left or first."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import cycle
from math import pi
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from tests.remade import carried, mirrored, opposite, remade, turned_in_space
from tests.strategies import ANGLES, OF_ANY_KIND, OF_LAYOUT, PLACES, SPEEDS, engines, number

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import LAYOUTS
from crankstar.engine.records import Cylinder, Record, Rod, Shaft, Weight
from crankstar.files import engine_of, toml, tree_of
from crankstar.mechanics.balance import (
    Reference,
    Totals,
    balance,
    default_reference,
    grouped,
    of_parts,
    total,
)
from crankstar.spectra import Spectrum

TOLERANCE = 4e-11
"""Of the largest part; a moment counts at least as the largest force at the longest arm.

Rods hardly longer than the crank have 180 orders, forward and backward, of each of which 1e-13 may
be left out as rounding of the series (`motion.NOISE`), and at one angle all may add up.
"""

KNOWN = engines(known=True)
ONE_SHAFT = engines(known=True, max_shafts=1)
REFERENCES = st.builds(Reference, PLACES, PLACES, PLACES)
ORIGIN = Reference(0.0)
FACTORS = number(0.2, 5.0)
THETA = np.random.default_rng(2).uniform(0, 100, 97)


def felt(engine: Engine, reference: Reference = ORIGIN, speed: float = 1.0) -> Totals:
    return total(balance(engine, speed=speed, reference=reference))


class Sizes(NamedTuple):
    """How large force, couple, roll and torque of a single part become at most."""

    force: float
    couple: float
    roll: float
    torque: float

    def multiplied(self, *factors: float) -> Sizes:
        return Sizes(*(size * factor for size, factor in zip(self, factors, strict=True)))


def sizes(engine: Engine, reference: Reference = ORIGIN, speed: float = 1.0) -> Sizes:
    """The sizes of an engine; moments count at least as the largest force at the longest arm."""
    result = balance(engine, speed=speed, reference=reference)

    def most(spectrum: Spectrum) -> float:
        return float((np.abs(spectrum.forward) + np.abs(spectrum.backward)).sum(axis=-1).max())

    bodies = [
        *engine.cylinders,
        *(rotor for shaft in engine.shafts for rotor in (*shaft.throws, *shaft.weights)),
    ]
    along = max(abs(body.z - reference.z) for body in bodies)
    across = max(
        abs(complex(s.up - reference.up, s.right - reference.right)) for s in engine.shafts
    )
    radius = max(throw.radius for shaft in engine.shafts for throw in shaft.throws)
    force = most(result.force)
    couple, roll, torque = (
        max(most(result.couple), force * along),
        most(result.axis_moment),
        most(result.torque),
    )
    return Sizes(force, couple, max(roll, force * (across + radius)), max(torque, force * radius))


def assert_equal(found: np.ndarray, expected: np.ndarray, largest: float) -> None:
    wrong = np.abs(found - expected).max()
    assert wrong <= TOLERANCE * largest, f"{wrong:.3g} wrong, largest part {largest:.3g}"


def assert_alike(found: Totals, expected: Totals, largest: Sizes) -> None:
    """The same vectors and moments at any crank angle."""
    for ours, theirs, size in zip(found, expected, largest, strict=True):
        assert_equal(spectra.value(ours, THETA), spectra.value(theirs, THETA), size)


def of_masses(engine: Engine, share: Callable[[], float]) -> Engine:
    """Each mass multiplied by its own share."""

    def rod(c: Cylinder) -> dict[str, Any]:
        if c.rod is None:
            return {}
        return {
            "rod": c.rod.model_copy(
                update={
                    "mass": c.rod.mass * share(),
                    "inertia": c.rod.turning_inertia(c.rod_length) * share(),
                }
            )
        }

    return remade(
        engine,
        throw=lambda t: {"rotating_mass": t.rotating_mass * share()},
        weight=lambda w: {"unbalance": w.unbalance * share()},
        cylinder=lambda c: {
            "reciprocating_mass": c.reciprocating_mass * share(),
            "big_end_mass": c.big_end_mass * share(),
            **rod(c),
        },
    )


def added(one: Totals, other: Totals) -> Totals:
    """The sum of two totals of the same engine."""

    def both(a: Spectrum, b: Spectrum) -> Spectrum:
        orders = np.union1d(a.orders, b.orders)
        a, b = spectra.selected(a, orders), spectra.selected(b, orders)
        return replace(a, forward=a.forward + b.forward, backward=a.backward + b.backward)

    return Totals(*(both(a, b) for a, b in zip(one, other, strict=True)))


@pytest.mark.release
@given(KNOWN, st.lists(number(0.1, 0.9), min_size=1, max_size=7), REFERENCES)
def test_masses_add(engine: Engine, shares: list[float], reference: Reference) -> None:
    some, rest = cycle(shares), cycle(shares)
    parted = [of_masses(engine, lambda: next(some)), of_masses(engine, lambda: 1 - next(rest))]
    assert_alike(
        added(*(felt(part, reference) for part in parted)),
        felt(engine, reference),
        sizes(engine, reference),
    )


@given(ONE_SHAFT, ANGLES)
def test_turning_all_throws_turns_order_k_by_k_times_the_angle(engine: Engine, phi: float) -> None:
    ahead = remade(
        engine, throw=lambda t: {"angle": t.angle + phi}, weight=lambda w: {"angle": w.angle + phi}
    )
    before, after, largest = felt(engine), felt(ahead), sizes(engine)
    orders = np.intersect1d(before.force.orders, after.force.orders)
    for parts in zip(before[:2], after[:2], largest[:2], strict=True):
        (old, new), size = (spectra.selected(part, orders) for part in parts[:2]), parts[2]
        assert_equal(new.forward, old.forward * np.exp(1j * orders * phi), size)
        assert_equal(new.backward, old.backward * np.exp(-1j * orders * phi), size)
    assert_alike(after, shifted(before, -engine.sense * phi), largest)


def shifted(whole: Totals, theta: float) -> Totals:
    return Totals(*(spectra.shifted(part, theta) for part in whole))


@given(KNOWN, ANGLES, REFERENCES)
def test_shafts_turned_as_their_gears_turn_them_are_at_another_angle(
    engine: Engine, delta: float, reference: Reference
) -> None:
    def later(s: Shaft) -> dict[str, Any]:
        turn = engine.sense * float(s.speed_ratio) * delta
        return {
            "throws": tuple(t.model_copy(update={"angle": t.angle + turn}) for t in s.throws),
            "weights": tuple(w.model_copy(update={"angle": w.angle + turn}) for w in s.weights),
        }

    after = felt(remade(engine, shaft=later), reference)
    assert_alike(after, shifted(felt(engine, reference), -delta), sizes(engine, reference))


@given(KNOWN, ANGLES, REFERENCES)
def test_turning_the_whole_engine_turns_its_vectors_only(
    engine: Engine, bearing: float, reference: Reference
) -> None:
    leaning = turned_in_space(engine, bearing)
    upright = felt(engine, reference)
    expected = upright._replace(
        force=spectra.turned(upright.force, bearing), couple=spectra.turned(upright.couple, bearing)
    )
    found = felt(leaning, reference._replace(**carried(reference.up, reference.right, bearing)))
    assert_alike(found, expected, sizes(engine, reference))


@pytest.mark.release
@given(KNOWN, REFERENCES)
def test_in_the_mirror_vectors_change_sides_and_rolls_their_sign(
    engine: Engine, reference: Reference
) -> None:
    before, largest = felt(engine, reference), sizes(engine, reference)
    after = felt(mirrored(engine), reference._replace(right=-reference.right))
    for old, new, size in (
        (before.force, after.force, largest.force),
        (before.couple, after.couple, largest.couple),
    ):
        assert_equal(spectra.value(new, THETA), np.conj(spectra.value(old, THETA)), size)
        orders = np.intersect1d(old.orders, new.orders)  # forward stays forward
        assert_equal(
            spectra.selected(new, orders).forward,
            np.conj(spectra.selected(old, orders).forward),
            size,
        )
    assert_equal(
        spectra.value(after.axis_moment, THETA),
        -spectra.value(before.axis_moment, THETA),
        largest.roll,
    )
    assert_equal(
        spectra.value(after.torque, THETA), spectra.value(before.torque, THETA), largest.torque
    )


@given(KNOWN, REFERENCES)
def test_an_engine_run_backwards_goes_through_the_same_forces_backwards(
    engine: Engine, reference: Reference
) -> None:
    before, after = (
        felt(engine, reference),
        felt(remade(engine, rotation=opposite(engine)), reference),
    )
    largest = sizes(engine, reference)
    for old, new, size in zip(
        before[:3], after[:3], largest[:3], strict=True
    ):  # what comes from accelerations is even in time
        assert_equal(spectra.value(new, THETA), spectra.value(old, -THETA), size)
    assert_equal(
        spectra.value(after.torque, THETA), -spectra.value(before.torque, -THETA), largest.torque
    )


@given(KNOWN, REFERENCES, REFERENCES)
def test_moments_about_another_point_differ_by_the_arm_times_the_force(
    engine: Engine, here: Reference, there: Reference
) -> None:
    first, second = felt(engine, here), felt(engine, there)
    largest = Sizes(
        *(max(pair) for pair in zip(sizes(engine, here), sizes(engine, there), strict=True))
    )
    force, couple, roll, torque = (spectra.value(part, THETA) for part in first)
    up, right = there.up - here.up, there.right - here.right
    assert_equal(spectra.value(second.force, THETA), force, largest.force)
    assert_equal(
        spectra.value(second.couple, THETA), couple - (there.z - here.z) * force, largest.couple
    )
    assert_equal(
        spectra.value(second.axis_moment, THETA),
        roll - (up * np.imag(force) - right * np.real(force)),
        largest.roll,
    )
    assert_equal(spectra.value(second.torque, THETA), torque, largest.torque)


@given(KNOWN)
def test_the_reference_left_out_is_the_middle_of_the_cylinders(engine: Engine) -> None:
    places = sorted(cylinder.z for cylinder in engine.cylinders)
    middle = Reference((places[0] + places[-1]) / 2, 0.0, 0.0)
    assert default_reference(engine) == middle
    assert balance(engine).reference == middle
    assert_alike(total(balance(engine, speed=1.0)), felt(engine, middle), sizes(engine, middle))


@pytest.mark.release
@given(KNOWN, FACTORS, FACTORS, SPEEDS, REFERENCES)
def test_forces_grow_with_mass_length_and_speed_squared(
    engine: Engine, heavier: float, longer: float, speed: float, reference: Reference
) -> None:
    def larger(c: Cylinder) -> dict[str, Any]:
        rod, link = c.rod, c.articulated
        if rod:
            update = {
                "mass": rod.mass * heavier,
                "centre": rod.centre * longer,
                "inertia": rod.inertia and rod.inertia * heavier * longer**2,
            }
            rod = rod.model_copy(update=update)
        if link:
            link = link.model_copy(update={"radius": link.radius * longer})
        return {
            **{name: getattr(c, name) * longer for name in ("z", "offset", "rod_length")},
            "reciprocating_mass": c.reciprocating_mass * heavier,
            "big_end_mass": c.big_end_mass * heavier,
            "rod": rod,
            "articulated": link,
        }

    large = remade(
        engine,
        shaft=lambda s: {"up": s.up * longer, "right": s.right * longer},
        throw=lambda t: {
            "radius": t.radius * longer,
            "z": t.z * longer,
            "rotating_mass": t.rotating_mass * heavier,
        },
        weight=lambda w: {"unbalance": w.unbalance * heavier * longer, "z": w.z * longer},
        cylinder=larger,
        bore_pitch=engine.pitch * longer,
    )
    small, largest = felt(engine, reference), sizes(engine, reference)
    afar = Reference(*(place * longer for place in reference))
    force = heavier * longer * speed**2
    factors = (force, force * longer, force * longer, force * longer)
    expected = Totals(
        *(spectra.scaled(part, factor) for part, factor in zip(small, factors, strict=True))
    )
    assert_alike(felt(large, afar, speed), expected, largest.multiplied(*factors))
    if (
        engine.first.reciprocating_mass or engine.first.rod
    ):  # counted in m r w^2 the two engines are one
        one, other = (
            total(balance(engine, reference=reference)),
            total(balance(large, reference=afar)),
        )
        assert_alike(other, one, largest.multiplied(*(1 / unit for unit in units_of(engine, 1.0))))


def units_of(engine: Engine, speed: float) -> tuple[float, float, float, float]:
    """m r w^2 and so on, of the first cylinder; of 1 kg where that has no mass."""
    first = min(engine.cylinders, key=lambda cylinder: cylinder.number)
    rod, radius = first.rod, engine.throw(first).radius
    small_end = max(rod.mass * rod.centre / first.rod_length, 0.0) if rod else 0.0
    mass = first.reciprocating_mass + small_end or (rod.mass if rod else 1.0)
    force = mass * radius * speed**2
    return force, force * engine.pitch, force * radius, force * radius


@given(KNOWN, SPEEDS, REFERENCES)
def test_newtons_are_units_of_m_r_w_squared(
    engine: Engine, speed: float, reference: Reference
) -> None:
    relative = engine.model_copy(update={"relative": ("mass", "radius", "pitch")})
    counted, in_newtons = (
        total(balance(relative, speed=speed, reference=reference)),
        felt(engine, reference, speed),
    )
    whole = Totals(
        *(
            spectra.scaled(part, unit)
            for part, unit in zip(counted, units_of(engine, speed), strict=True)
        )
    )
    assert_alike(whole, in_newtons, sizes(engine, reference, speed))


@pytest.mark.many(first=3)
@pytest.mark.parametrize("kind", OF_ANY_KIND)
@settings(max_examples=10)
@given(data=st.data())
def test_the_whole_is_the_sum_of_its_parts_however_they_are_grouped(
    kind: str, data: st.DataObject
) -> None:
    engine = data.draw(OF_ANY_KIND[kind])
    result = balance(engine)
    whole, rows = total(result), len(result.parts)
    assert all(len(getattr(result, name).forward) == rows for name in Totals._fields)
    for by in ("kind", "cylinder", "bank", "shaft"):
        groups = grouped(result, by)
        assert set(groups) == {getattr(part, by) for part in result.parts}
        for name in Totals._fields:
            parts, summed = getattr(result, name), getattr(whole, name)
            largest = rows * (np.abs(parts.forward).max() + np.abs(parts.backward).max())
            for way in ("forward", "backward"):
                each = [getattr(getattr(group, name), way) for group in groups.values()]
                assert_equal(np.sum(each, axis=0), getattr(summed, way), largest)
    for shaft in engine.shafts:
        there = [part.shaft == shaft.name for part in result.parts]
        largest = rows * np.abs(result.force.forward).max(initial=1e-300)
        assert_equal(
            of_parts(result, shaft=shaft.name).force.forward,
            result.force.forward[there].sum(axis=0),
            largest,
        )


@pytest.mark.many(first=3)
@pytest.mark.parametrize("kind", OF_ANY_KIND)
@settings(max_examples=10)
@given(data=st.data())
def test_orders_ascend_from_above_zero_and_fall_off_to_rounding(
    kind: str, data: st.DataObject
) -> None:
    engine = data.draw(OF_ANY_KIND[kind])
    result = balance(engine, reference=Reference(0.0))
    orders = result.force.orders
    assert orders[0] > 0
    assert np.all(np.diff(orders) > 0)
    for name in Totals._fields:
        spectrum = getattr(result, name)
        assert np.all(np.isfinite(spectrum.forward))
        assert np.all(np.isfinite(spectrum.backward))
    size = np.abs(result.force.forward) + np.abs(result.force.backward)
    assert len(orders) == 1 or size[:, -1].max() <= 1e-13 * size.max()


@given(KNOWN, REFERENCES, st.randoms(use_true_random=False))
def test_in_what_order_things_are_listed_does_not_matter(
    engine: Engine, reference: Reference, chance: Any
) -> None:
    def shuffled(things: Sequence[Any]) -> tuple[Any, ...]:
        return tuple(chance.sample(list(things), len(things)))

    first, *others = engine.shafts
    renumbered = {s.name: shuffled(range(len(s.throws))) for s in engine.shafts}
    shafts = [
        s.model_copy(
            update={
                "throws": tuple(s.throws[i] for i in renumbered[s.name]),
                "weights": shuffled(s.weights),
            }
        )
        for s in (first, *shuffled(others))
    ]
    listed = {number: iter(members) for number, members in engine.chambers.items()}
    of = {c.number: number for number, members in engine.chambers.items() for c in members}
    cylinders = [  # of two pistons that face each other the second stays the second
        c.model_copy(update={"throw": renumbered[c.shaft].index(c.throw - 1) + 1})
        for c in (next(listed[of[any_one.number]]) for any_one in shuffled(engine.cylinders))
    ]
    mixed = Engine.model_validate({**dict(engine), "shafts": shafts, "cylinders": cylinders})
    assert_alike(felt(mixed, reference), felt(engine, reference), sizes(engine, reference))


@given(KNOWN, REFERENCES)
def test_a_counterweight_opposite_each_rotating_mass_cancels_it(
    engine: Engine, reference: Reference
) -> None:
    def cured(s: Shaft) -> dict[str, Any]:
        against = [
            Weight(unbalance=t.rotating_mass * t.radius, angle=t.angle + pi, z=t.z)
            for t in s.throws
        ]
        against += [w.model_copy(update={"angle": w.angle - pi}) for w in s.weights]
        return {"weights": (*s.weights, *against)}

    bare = remade(
        remade(engine, shaft=lambda _: {"weights": ()}), throw=lambda _: {"rotating_mass": 0.0}
    )
    assert_alike(
        felt(remade(engine, shaft=cured), reference),
        felt(bare, reference),
        sizes(engine, reference),
    )


@given(KNOWN, st.lists(number(0.05, 0.95), min_size=1, max_size=5), REFERENCES)
def test_a_rod_whose_inertia_is_that_of_two_masses_at_its_ends_is_those_two_masses(
    engine: Engine, shares: list[float], reference: Reference
) -> None:
    first, second = cycle(shares), cycle(shares)

    def rigid(c: Cylinder) -> dict[str, Any]:
        a, mass = next(first) * c.rod_length, 0.5 + c.number
        return {"rod": Rod(mass=mass, centre=a, inertia=mass * a * (c.rod_length - a))}

    def parted(c: Cylinder) -> dict[str, Any]:
        share, mass = next(second), 0.5 + c.number
        ends = {
            "reciprocating_mass": c.reciprocating_mass + mass * share,
            "big_end_mass": c.big_end_mass + mass * (1 - share),
        }
        return {**ends, "rod": None}

    whole, in_two = remade(engine, cylinder=rigid), remade(engine, cylinder=parted)
    assert_alike(felt(in_two, reference), felt(whole, reference), sizes(whole, reference))


@given(ONE_SHAFT, st.sampled_from(["2", "-1", "-3/2", "29/31", "1/2"]).map(Fraction))
def test_a_shaft_geared_at_a_ratio_does_the_same_at_that_ratio_times_the_orders(
    engine: Engine, ratio: Fraction
) -> None:
    (shaft,) = engine.shafts
    crank = Shaft(name="reference")
    geared = engine.model_copy(
        update={"shafts": (crank, shaft.model_copy(update={"speed_ratio": ratio}))}
    )
    own, found, speed = felt(engine), felt(geared), float(ratio)
    assert np.allclose(
        found.force.orders, np.union1d(own.force.orders * abs(speed), [1.0]), atol=1e-12
    )
    factors = (speed**2, speed**2, speed**2, speed**3)
    for slow, fast, factor, size in zip(own, found, factors, sizes(engine), strict=True):
        assert_equal(
            spectra.value(fast, THETA),
            factor * spectra.value(slow, speed * THETA),
            abs(factor) * size,
        )


@pytest.mark.release
@given(engines())
def test_an_engine_written_to_a_file_and_read_again_shakes_as_before(engine: Engine) -> None:
    again = engine_of(tree_of(toml(engine)))
    for name in Engine.model_fields.keys() - {
        "speed",
        "firing_angles",
        "valves",
        "shafts",
        "cylinders",
        "bore_pitch",
        "block",
        "gas",
        "drive",
    }:
        assert getattr(again, name) == getattr(engine, name), name
    for name in ("block", "gas", "drive"):
        written, given = (flat(getattr(one, name)) for one in (again, engine))
        assert written.keys() == given.keys()
        for key, value in given.items():
            close = pytest.approx(value, rel=1e-12) if isinstance(value, float) else value
            assert written[key] == close, (name, key)
    reference = Reference(0.1)
    before, after = (balance(e, speed=100.0, reference=reference) for e in (engine, again))
    assert [part._replace(bank=None) for part in after.parts] == [
        part._replace(bank=None) for part in before.parts
    ]
    for name in Totals._fields:
        old, new = getattr(before, name), getattr(after, name)
        size = (np.abs(old.forward) + np.abs(old.backward)).sum(axis=-1).max()
        wrong = np.abs(spectra.value(new, THETA) - spectra.value(old, THETA)).max()
        assert wrong <= 1e-9 * max(size, 1e-12 * np.abs(before.force.forward).max()), name


def flat(record: Record | None) -> dict[str, object]:
    """The values of a record that are given, by path."""
    out: dict[str, object] = {}
    for name in type(record).model_fields if record is not None else ():
        value = getattr(record, name)
        inner = value if isinstance(value, tuple) else ()
        if inner and isinstance(inner[0], Record):
            for place, each in enumerate(inner):
                out |= {f"{name}[{place}].{key}": own for key, own in flat(each).items()}
        elif value is not None and value != ():
            out[name] = value
    return out


@pytest.mark.release
@pytest.mark.parametrize("rod_ratio", [1.002, 1.02, 1.2, 2.0, 4.0, 50.0])
def test_spectra_converge_for_any_rod(rod_ratio: float) -> None:
    shaft = Shaft.model_validate({"name": "crank", "throw": [{"angle": 0.3, "radius": 1.0}]})
    only = Cylinder(number=1, shaft="crank", throw=1, rod_length=rod_ratio, reciprocating_mass=1.0)
    found = total(
        balance(Engine.model_validate({"name": "one", "shafts": [shaft], "cylinders": [only]}))
    )
    theta = np.linspace(0, 2 * pi, 1000)
    psi, s = theta + 0.3, np.sin(theta + 0.3)
    root = np.sqrt(rod_ratio**2 - s**2)
    expected = np.cos(psi) + np.cos(2 * psi) / root + s**2 * np.cos(psi) ** 2 / root**3
    force = spectra.value(found.force, theta)
    assert np.abs(force - expected).max() <= 1e-10 * np.abs(expected).max()
    assert np.abs(found.force.forward[-1]) <= 1e-13
    assert len(found.force.orders) <= 60 / np.arccosh(rod_ratio) + 10


def test_every_layout_has_a_strategy() -> None:
    assert set(OF_LAYOUT) == set(LAYOUTS)


EXEMPT = {("Engine", "format"): "has one value only"}


@pytest.mark.release
def test_every_option_of_every_record_occurs_in_the_random_engines() -> None:
    seen: list[Record] = []

    @settings(max_examples=200, derandomize=True, database=None, phases=[Phase.generate])
    @given(engines())
    def collected(engine: Engine) -> None:
        seen.extend(all_records(engine))

    collected()
    for kind in {Engine, *(type(record) for record in seen), *Record.__subclasses__()}:
        if kind.__module__ not in (Engine.__module__, Record.__module__) or (
            issubclass(Engine, kind) and kind is not Engine
        ):
            continue  # a record of short files, or what an Engine has from its ancestors
        made = [record for record in seen if type(record) is kind]
        for name, field in kind.model_fields.items():
            values = {repr(getattr(record, name)) for record in made}
            if (kind.__name__, name) not in EXEMPT:
                assert len(values) > 1, f"{kind.__name__}.{name} is never anything but {values}"
                assert field.is_required() or values - {repr(field.default)}


def all_records(record: Record) -> list[Record]:
    found = [record]
    for name in type(record).model_fields:
        value = getattr(record, name)
        items = (
            value
            if isinstance(value, tuple)
            else value.values()
            if isinstance(value, dict)
            else [value]
        )
        found += [
            inner for item in items if isinstance(item, Record) for inner in all_records(item)
        ]
    return found
