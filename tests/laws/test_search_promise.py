"""What a search promises of an engine is what `analyze` finds in the file that it writes."""

from __future__ import annotations

from fractions import Fraction
from math import pi
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.search.asked import seven
from tests.strategies import ANGLES, CYCLES, MASSES, ROTATIONS, Draw, maybe, number, rigid_rods

from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder, Shaft, Throw, Weight
from crankstar.files import engine_of, toml, tree_of
from crankstar.mechanics.balance import balance
from crankstar.spectra import selected
from crankstar.stars.answer import answer_to
from crankstar.stars.engine_stars import couple_of, force_of, star_of, stars_of, with_star
from crankstar.stars.options import Measure, SearchOptions, search_for
from crankstar.stars.question import All, Question
from crankstar.stars.sums import of
from crankstar.tables import balance_orders, machine
from crankstar.tables.search_stars import as_it_is, search_stars
from crankstar.tables.uneven_angles import curve_of, uneven_angles

ORDERS = (1, 2, 3, 4)


@st.composite
def lines(draw: Draw) -> Engine:
    """In-line engines; throws, rods, pistons and weights all alike, or each as it likes."""
    count = draw(st.integers(2, 5))
    places = [0.0]
    for _ in range(count - 1):
        places.append(round(places[-1] - draw(number(0.05, 0.5)), 6))
    alike = draw(st.booleans())
    parts = [_parts(draw) for _ in range(1 if alike else count)] * (count if alike else 1)
    star = draw(st.booleans())
    angles = [2 * pi * j / count if star else draw(ANGLES) for j in range(count)]
    bearing = draw(ANGLES)
    throws = [
        Throw(angle=angle, z=z, **own["throw"])
        for angle, z, own in zip(angles, places, parts, strict=True)
    ]
    weights = [
        Weight(
            angle=angles[j] + own["lag"],
            z=places[j] + own["ahead"],
            throw=j + 1,
            unbalance=own["unbalance"],
        )
        for j, own in enumerate(parts)
    ]
    shafts = [Shaft(name="crank", throws=tuple(throws), weights=tuple(weights))]
    if draw(st.booleans()):
        ratio = draw(st.sampled_from([Fraction(-1), Fraction(2), Fraction(-2)]))
        weight = Weight(
            angle=draw(ANGLES), z=draw(number(-0.5, 0.5)), unbalance=draw(number(0, 0.3))
        )
        shafts.append(Shaft(name="balancer", speed_ratio=ratio, up=-0.1, weights=(weight,)))
    cylinders = [
        Cylinder(
            number=j + 1,
            shaft="crank",
            throw=j + 1,
            bearing=bearing,
            z=places[j],
            **own["cylinder"],
        )
        for j, own in enumerate(parts)
    ]
    return Engine(
        name="a line",
        cycle=draw(CYCLES),
        rotation=draw(ROTATIONS),
        speed=draw(maybe(number(10.0, 600.0))),
        shafts=tuple(shafts),
        cylinders=tuple(cylinders),
    )


def _parts(draw: Draw) -> dict[str, Any]:
    radius = draw(number(0.03, 0.1))
    length = radius * draw(number(2.5, 6.0))
    return {
        "throw": {"radius": radius, "rotating_mass": draw(maybe(MASSES, 0.0))},
        "lag": draw(ANGLES),
        "ahead": draw(maybe(number(-0.02, 0.02), 0.0)),
        "unbalance": draw(maybe(number(0.0, 0.5), 0.0)),
        "cylinder": {
            "rod_length": length,
            "offset": draw(maybe(number(-0.5, 0.5), 0.0)) * radius,
            "reciprocating_mass": draw(MASSES),
            "big_end_mass": draw(maybe(MASSES, 0.0)),
            "rod": draw(maybe(rigid_rods(length))),
        },
    }


def written(engine: Engine) -> Engine:
    """The engine in the file that is written of it."""
    return engine_of(tree_of(toml(engine)))


def analyzed(engine: Engine, orders: tuple[int, ...] = ORDERS) -> dict[str, float]:
    """The greatest values that `analyze --json` has of an engine: F1, M1, F2, ..."""
    result = balance(engine, speed=engine.speed)
    answer = machine.tree(balance_orders.answer(engine, result, orders=orders))
    return {
        f"{letter}{order:g}": row[quantity]["greatest"]
        for order, row in zip(orders, answer["orders"], strict=True)
        for letter, quantity in (("F", "force"), ("M", "couple"))
    }


def reach(engine: Engine) -> dict[str, float]:
    """The most that F and M could be at any star: 1e-9 of that is nothing."""
    result = balance(engine, speed=engine.speed)
    return {
        letter: float(np.abs([spectrum.forward, spectrum.backward]).sum(axis=(0, 1)).max())
        for letter, spectrum in (("F", result.force), ("M", result.couple))
    }


def question_of(engine: Engine) -> Question:
    stars = stars_of(engine)
    sums = [
        make(engine, stars, k, speed=engine.speed) for k in ORDERS for make in (force_of, couple_of)
    ]
    objectives = tuple(of(vector) for vector in sums if vector.scale)
    return Question(stars, objectives, ask=All())


@settings(max_examples=40)
@given(engine=lines(), data=st.data())
def test_every_number_of_a_row_is_what_analyze_finds(engine: Engine, data: st.DataObject) -> None:
    question = question_of(engine)
    answer = answer_to(question)
    rows = machine.tree(search_stars(answer, engine=engine, limit=None))["rows"]
    place = data.draw(st.integers(0, len(rows) - 1))
    better = written(with_star(engine, question.stars, answer.rows[place].star))
    expected, most = analyzed(better), reach(better)
    for vector in question.sums:
        assert rows[place][vector.short] == pytest.approx(
            expected[vector.short], rel=1e-9, abs=1e-9 * most[vector.short[0]]
        )


@given(engine=lines(), data=st.data())
def test_a_sum_of_the_pistons_is_named_so_and_is_that(engine: Engine, data: st.DataObject) -> None:
    question = question_of(engine)
    answer = answer_to(question)
    row = answer.rows[data.draw(st.integers(0, len(answer.rows) - 1))]
    result = balance(with_star(engine, question.stars, row.star), speed=engine.speed)
    moving = [part.cylinder is not None for part in result.parts]
    most = reach(engine)
    for vector, value in zip(question.sums, row.values, strict=True):
        letter, _pistons, rest = vector.name.partition(" (pistons)")
        if letter != vector.name and not rest:
            spectrum = result.force if letter[0] == "F" else result.couple
            against = selected(spectrum[moving], float(vector.order)).backward.sum()
            assert value == pytest.approx(2 * abs(against), rel=1e-9, abs=1e-9 * most[letter[0]])


@given(engine=lines())
def test_equal_throws_are_searched_with_all_their_parts(engine: Engine) -> None:
    (crank, *_others) = engine.shafts
    first = engine.first
    own = crank.throws[0]
    alike = [
        with_values(throw, rotating_mass=own.rotating_mass, radius=own.radius)
        for throw in crank.throws
    ]
    weights = [
        with_values(
            crank.weights[0],
            angle=crank.weights[0].angle + throw.angle - own.angle,
            z=crank.weights[0].z + throw.z - own.z,
            throw=j,
        )
        for j, throw in enumerate(crank.throws, 1)
    ]
    cylinders = [
        with_values(first, number=each.number, throw=each.throw, z=each.z)
        for each in engine.cylinders
    ]
    shaft = with_values(crank, throws=tuple(alike), weights=tuple(weights))
    even = with_values(engine, shafts=(shaft,), cylinders=tuple(cylinders))
    forces = [sum_ for sum_ in question_of(even).sums if sum_.short[0] == "F"]
    assert forces
    assert not any(vector.parts for vector in forces)


@given(engine=lines())
def test_the_engine_as_it_is_has_the_numbers_of_its_file(engine: Engine) -> None:
    question = question_of(engine)
    if star_of(engine, question.stars) is None:
        turned = with_star(engine, question.stars, next(iter(answer_to(question).rows)).star)
        engine, question = turned, question_of(turned)
    star = star_of(engine, question.stars)
    assert star is not None
    expected, most = analyzed(written(engine)), reach(engine)
    for vector in question.sums:
        assert vector.of_engine(star) == pytest.approx(
            expected[vector.short], rel=1e-9, abs=1e-9 * most[vector.short[0]]
        )
    assert as_it_is(answer_to(question), engine)


def test_uneven_angles_are_those_of_the_file_that_is_written() -> None:
    engine = seven(0.5)
    (crank,) = engine.shafts
    heavy = (with_values(crank.throws[0], rotating_mass=900.0), *crank.throws[1:])
    engine = with_values(engine, shafts=(with_values(crank, throws=heavy),))
    measures = ((1.0, Measure("M", Fraction(1))), (1.0, Measure("M", Fraction(2))))
    search = search_for(engine, SearchOptions(minimise=measures), speed=engine.speed)
    star = answer_to(search.question).rows[0].star
    curve = curve_of(search.question, star, deviations_deg=[2.0], engine=engine, speed=engine.speed)
    last = machine.tree(uneven_angles(curve))["angles"][-1]
    better = written(with_star(engine, search.question.stars, star, later_deg=curve[-1].later_deg))
    expected, most = analyzed(better, (1, 2)), reach(better)
    for name in ("M1", "M2", "F1", "F2"):
        assert last[name] == pytest.approx(expected[name], rel=1e-9, abs=1e-9 * most[name[0]])


@pytest.mark.many(first=1)
@pytest.mark.parametrize("factor", [0.0, 0.5, 1.0])
def test_each_row_of_a_counterweighted_seven_is_kept_by_its_file(factor: float) -> None:
    engine = seven(factor)
    search = search_for(engine, SearchOptions(), speed=engine.speed)
    rows = answer_to(search.question).rows
    for row in rows:
        expected = analyzed(written(with_star(engine, search.question.stars, row.star)))
        assert row.values == pytest.approx((expected["M1"], expected["M2"]), rel=1e-9)
    if factor == 0.5:
        assert rows[2].values[0] == pytest.approx(914004, abs=1)
