"""Star and firing sequence together: proved fronts against every order, engines, judgements."""

from __future__ import annotations

import dataclasses
import json
import signal
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

import numpy as np
import pytest
from tests.search import plain_orders as plain

from crankstar import cli, load, spectra
from crankstar.firing import weighing
from crankstar.firing.intervals import firing
from crankstar.firing.vees import stars as stars_of_vees
from crankstar.language.search_faults import SENTENCES
from crankstar.mechanics.balance import balance, total
from crankstar.options.sequences import sequences_of
from crankstar.options.words import SearchWords, SequenceWords
from crankstar.stars import executors, sequence_fronts, sequence_work
from crankstar.stars.faults import SearchError, said
from crankstar.stars.progress import Progress
from crankstar.stars.sequence_engines import engine_of, fired_of_engine, shaft_of_engine, with_fired
from crankstar.stars.sequence_fronts import beaten, sequence_front, ways
from crankstar.stars.shafts import Fired, Shaft, followed, shaft_of
from crankstar.stars.uneven_sequences import uneven_sequences
from crankstar.stars.vector_sums import (
    NEIGHBOURS,
    Cap,
    Goal,
    SequenceQuestion,
    couple,
    force,
    shares,
    straight,
    torsion,
)

SHAFTS = [
    (4, 0),
    (5, 0),
    (6, 0),
    (7, 0),
    (8, 0),
    (4, 180),
    (6, 120),
    (8, 90),
    (8, 180),
    (10, 72),
    (10, 144),
]
"""Cylinders and bank angle; every firing order of these can be tried."""
GOALS = [
    "M1,M2,twist",
    "M1,T0.5,T1.5",
    "T0.5,T1.5,T2.5",
    "M1,M2",
    "M2,M3,T2",
    "twist,neighbours",
    "M1,neighbours",
    "M1,twist,neighbours",
    "F2,M1,T0.5",
]


def asked(about: Any, minimise: str, **more: Any) -> SequenceQuestion:
    """The question of some words; goals that no star changes are left out."""
    names = {name: more.pop(name, None) for name in ("bank", "crank_orders", "why")}
    words = SearchWords(minimise=minimise, **more)
    return sequences_of(about, words, SequenceWords(**names)).question


def question(cylinders: int, bank: float, minimise: str, **more: Any) -> SequenceQuestion | None:
    try:
        return asked(cylinders, minimise, bank=str(bank) if bank else None, **more)
    except SearchError as raised:
        codes = {each.code for each in raised.faults}
        assert codes <= {"alike-throws", "alike-order", "goal-balanced", "two-stroke-torsion"}
        return None


def plain_values(about: SequenceQuestion) -> tuple[np.ndarray, np.ndarray]:
    """The values of all goals for all orders by the plain road, and which keep the limits."""
    shaft = about.shaft
    bank = float(shaft.bank_angle_deg)
    orders, fires = plain.angles(shaft.cylinders, shaft.cycle_deg, bank)
    places = np.repeat(np.array(shaft.places, float), shaft.rods)

    def of(one: Any) -> np.ndarray:
        if one.kind == "T":
            return plain.torsion(float(one.order), fires, np.array(one.weights, float))
        return plain.shaking(one.kind, int(one.order), fires, places, bank)

    near = plain.neighbours(orders, vee=shaft.rods == 2)
    columns = [
        near if goal.neighbours else np.max([of(one) for one in goal.sums], axis=0)
        for goal in about.goals
    ]
    kept = np.ones(len(orders), bool)
    for cap in about.caps:
        kept &= of(cap.sum) <= cap.greatest + 1e-9
    if about.neighbours_at_most is not None:
        kept &= near <= about.neighbours_at_most
    return np.column_stack(columns), kept


def agrees(about: SequenceQuestion) -> None:
    """The front is that of all orders one by one, with as many orders at each point."""
    values, kept = plain_values(about)
    wanted = plain.front(values[kept])
    found = sequence_front(about)
    assert found.complete
    assert found.stars == about.shaft.count
    assert [point.orders for point in found.points] == [count for _, count in wanted]
    ours = np.array([point.values for point in found.points]).reshape(-1, len(about.goals))
    theirs = np.array([point for point, _ in wanted]).reshape(-1, len(about.goals))
    assert np.allclose(ours, theirs, rtol=0, atol=1e-8)


@pytest.mark.parametrize(
    ("name", "goals"),
    [("i2-360", ["twist"]), ("i4", ["M1", "twist"]), ("i6", ["M1", "M2", "twist"])],
)
def test_without_goals_couples_that_are_alike_are_none(name: str, goals: list[str]) -> None:
    asked = sequences_of(load(name), SearchWords(), SequenceWords(crank_orders="0.5"))
    assert [goal.name for goal in asked.question.goals] == goals


@pytest.mark.many(first=7)
@pytest.mark.parametrize(("cylinders", "bank"), SHAFTS)
def test_stars_times_sequences_are_all_orders_that_fit(cylinders: int, bank: float) -> None:
    shaft = shaft_of(cylinders, bank_angle_deg=bank or None)
    orders, _ = plain.angles(cylinders, 720, bank)
    assert len(orders) == shaft.count * shaft.sequences
    for order in orders[:: len(orders) // 50 + 1].tolist():
        assert shaft.firing_order(shaft.fired_in(order)) == tuple(order)


@pytest.mark.many(first=5)
@pytest.mark.parametrize(
    ("cylinders", "bank"), [(6, 120), (8, 90), (8, 180), (10, 72), (12, 60), (12, 120), (16, 45)]
)
def test_stars_of_a_v_are_as_many_as_those_that_vees_lists(cylinders: int, bank: float) -> None:
    shaft = shaft_of(cylinders, bank_angle_deg=bank)
    listed = stars_of_vees(pins=shaft.throws, classes=shaft.classes, shift=shaft.shift)
    assert shaft.count == len(listed)
    assert all(shaft.fires(star) for star in listed.tolist())


def test_twenty_cylinders_have_all_stars_of_ten_throws() -> None:
    """9! with each throw in its own direction, half of it up to mirror images, and 22,680 more."""
    shaft = shaft_of(20, bank_angle_deg=108)
    assert (shaft.count - 22_680, shaft.sequences) == (2 * 181_440, 512)


@pytest.mark.many(first=22)
@pytest.mark.parametrize("minimise", GOALS)
@pytest.mark.parametrize(("cylinders", "bank"), SHAFTS)
def test_a_front_is_that_of_every_order_one_by_one(
    cylinders: int, bank: float, minimise: str
) -> None:
    about = question(cylinders, bank, minimise)
    if about is not None:
        agrees(about)


@pytest.mark.parametrize(("cylinders", "bank"), [(6, 0), (5, 0), (6, 60), (8, 45)])
def test_two_stroke_fronts_are_those_of_every_order(cylinders: int, bank: float) -> None:
    about = question(cylinders, bank, "M1,M2,twist", cycle="two-stroke", crank_orders="1,2")
    assert about is not None
    agrees(about)


def random_question(seed: int) -> SequenceQuestion | None:
    """A shaft with random gaps, shapes, goals and limits."""
    random = Random(seed)  # noqa: S311  # it is no secret
    cylinders, bank = random.choice([each for each in SHAFTS if each != (8, 0)])
    throws = cylinders // (2 if bank else 1)
    shape = random.choice([None, throws, cylinders])
    amplitudes = [str(random.randint(-5, 5)) for _ in range(shape or 0)]
    names = ["M1", "M2", "M3", "F2", "T0.5", "T1", "T1.5", "T3.5", "twist", "neighbours"]
    orders = random.sample(["0.5", "1", "1.5", "2.5", "4.5"], random.randint(1, 3))
    goals = random.sample(names, random.randint(1, 3))
    words: dict[str, Any] = {}
    if random.random() < 0.5:
        words["gaps"] = ",".join(str(random.randint(1, 3)) for _ in range(throws - 1))
    if shape and any(name[0] in "Tt" for name in goals) and len(set(amplitudes)) > 1:
        words["mode_shape"] = ",".join(amplitudes)
    if "twist" in goals:
        words["crank_orders"] = ",".join(orders)
    limits = [f"M{random.randint(1, 2)}={random.choice([1.5, 3, 6])}"] * (random.random() < 0.3)
    limits += [f"neighbours={random.randint(0, 3)}"] * (random.random() < 0.3)
    return question(cylinders, bank, ",".join(goals), limit=limits, **words)


@pytest.mark.release
@pytest.mark.parametrize("block", range(100))
def test_random_questions_are_answered_as_by_every_order(block: int, seed: int) -> None:
    """Thirty questions in each block."""
    for number in range(30 * block, 30 * block + 30):
        about = random_question(seed + number)
        if about is not None:
            agrees(about)


@pytest.mark.release
@pytest.mark.parametrize(("cylinders", "bank"), [(5, 0), (6, 0), (7, 0), (8, 90), (10, 72)])
def test_the_engine_of_a_row_is_what_the_row_promises(cylinders: int, bank: float) -> None:
    """Firing, gas sums, forces and couples of the Engine, by the rooms that know no search."""
    about = question(cylinders, bank, "M1,M2,twist")
    assert about is not None
    shaft = about.shaft
    for point in sequence_front(about).points[:6]:
        engine = engine_of(shaft, point.fired)
        fired = firing(engine)
        assert fired.order == shaft.firing_order(point.fired)
        assert fired.even
        assert shaft_of_engine(engine) == shaft
        assert fired_of_engine(engine, shaft) == point.fired
        orders = [float(one.order) for one in about.goals[2].sums]
        sums = weighing.sums_of(fired, weighing.twist_shape(engine), orders)
        ours = [one.length(shaft, point.fired) for one in about.goals[2].sums]
        assert np.allclose(sums, ours, atol=1e-9)
        whole = total(balance(engine, orders=(1, 2)))
        for kind, spectrum in ((force, whole.force), (couple, whole.couple)):
            greatest = np.abs(spectrum.forward) + np.abs(spectrum.backward)
            second = motion_harmonic(engine)
            ours = [
                kind(shaft, order).length(shaft, point.fired) * size
                for order, size in ((1, 1), (2, second))
            ]
            assert np.allclose(greatest.ravel(), ours, atol=1e-9)
        along, against = shares(shaft, 1)
        left = couple(shaft, 1).length(shaft, point.fired) * against / (along + against)
        assert np.abs(whole.couple.backward).ravel()[0] == pytest.approx(left, abs=1e-9)


def motion_harmonic(engine: Any) -> float:
    """A_2 of the assumed rod ratio, from the piston's acceleration."""
    from crankstar.engine import motion

    harmonics = motion.piston_harmonics(crank_radius=1.0, rod_length=engine.cylinders[0].rod_length)
    return abs(float(harmonics[2].real))


@pytest.mark.parametrize(
    "name", ["v8-cross-plane", "v8-flat-plane", "merlin", "v12-60", "i6", "bmw-s65", "ford-coyote"]
)
def test_an_engine_keeps_its_star_and_order_through_its_shaft(name: str) -> None:
    engine = load(name)
    shaft = shaft_of_engine(engine)
    fired = fired_of_engine(engine, shaft)
    assert fired is not None
    start = engine.firing_order.index(min(engine.firing_order))
    turned = (*engine.firing_order[start:], *engine.firing_order[:start])
    assert shaft.firing_order(fired) == turned
    again = with_fired(engine, shaft, fired)
    assert np.allclose(firing(again).intervals_deg, 720 / len(engine.chambers))
    other = Fired(
        fired.star, tuple(not each if at else each for at, each in enumerate(fired.first))
    )
    turned_engine = with_fired(engine, shaft, other)
    assert fired_of_engine(turned_engine, shaft) == other


@pytest.mark.many(first=1)
@pytest.mark.parametrize("name", ["ferrari-f136", "bmw-s65", "porsche-cayenne-48"])
def test_how_an_engine_is_numbered_does_not_change_its_front(name: str) -> None:
    """Bank after bank, or from side to side; and its own sums are those of its gas torque."""
    engine = load(name)
    ours = sequence_front(asked(engine, "M1,M2,twist")).points
    plainly = sequence_front(asked(8, "M1,M2,twist", bank="90")).points
    assert [point.orders for point in ours] == [point.orders for point in plainly]
    assert np.allclose([p.values for p in ours], [p.values for p in plainly], atol=1e-9)
    about = asked(engine, "T0.5,T1.5,T2.5")
    fired = fired_of_engine(engine, about.shaft)
    assert fired is not None
    sums = weighing.sums_of(firing(engine), weighing.twist_shape(engine), (0.5, 1.5, 2.5))
    assert about.values(fired) == pytest.approx(sums)


@pytest.mark.release
def test_threads_and_a_narrow_buffer_change_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    about = asked(8, "M1,M2,twist")
    plainly = sequence_front(about)
    monkeypatch.setattr(sequence_work, "BUFFER", 0)
    monkeypatch.setattr(sequence_work, "OF_A_PART", 1)
    with executors.threads(3) as workers:
        assert sequence_front(about, workers=workers).points == plainly.points


@pytest.mark.many(first=5)
@pytest.mark.parametrize("minimise", ["M1,M2,twist", "M1,twist,neighbours", "M2,T1.5"])
@pytest.mark.parametrize(("cylinders", "bank"), [(5, 0), (6, 0), (7, 0), (8, 90), (10, 72)])
def test_ways_are_all_orders_of_a_point(cylinders: int, bank: float, minimise: str) -> None:
    """As many as the point counts, each once, all with its values."""
    about = question(cylinders, bank, minimise)
    assert about is not None
    about = dataclasses.replace(about, size=1000)
    front = sequence_front(about)
    for point in front.points:
        every = ways(front, point)
        assert len(every) == len(set(every)) == point.orders
        assert every[0] == point.fired
        for fired in every:
            assert about.values(fired) == pytest.approx(point.values, abs=1e-8)
            back = about.shaft.mirrored(about.shaft.mirrored(fired))
            assert about.shaft.firing_order(back) == about.shaft.firing_order(fired)


def test_the_mirror_image_in_line_fires_backwards() -> None:
    for order in [(1, 2, 4, 5, 3), (1, 5, 3, 6, 2, 4), (1, 3, 2, 7, 5, 6, 4)]:
        shaft = shaft_of(len(order))
        other = shaft.firing_order(shaft.mirrored(shaft.fired_in(order)))
        assert other == (1, *reversed(order[1:]))


def test_a_typed_order_is_told_which_limits_it_breaks(capsys: pytest.CaptureFixture[str]) -> None:
    line = "search 8 --bank 90 --minimise twist --limit neighbours=0 --limit M1=3 --why"
    with pytest.raises(SystemExit):
        cli.main([*line.split(), "1-8-4-3-6-5-7-2"])
    told = " ".join(capsys.readouterr().out.split())
    assert "1-8-4-3-6-5-7-2 breaks a limit: M1 3.1623 > 3, neighbours 1 > 0." in told


def test_an_engine_that_fires_unevenly_is_told_to_be_no_star(
    capsys: pytest.CaptureFixture[str],
) -> None:
    with pytest.raises(SystemExit):
        cli.main(["search", "yamaha-r1-crossplane", "--minimise", "M1,twist"])
    assert "as it is does not fire evenly" in " ".join(capsys.readouterr().out.split())


def test_a_typed_order_is_told_what_beats_it() -> None:
    """Among sixes free of couples 1-5-3-6-2-4 has the fewest neighbours and the greatest twist."""
    six = shaft_of(6)
    sums = tuple(torsion(six, Fraction(k, 2), straight(six)) for k in (1, 3, 5))
    goals = (Goal("M1", (couple(six, 1),)), Goal("twist", sums))
    usual = six.fired_in((1, 5, 3, 6, 2, 4))
    front = sequence_front(SequenceQuestion(six, goals))
    values, better = beaten(front, usual)
    assert values == (0.0, pytest.approx(3.6))
    assert better == [(0, (1,))]
    beside = sequence_front(SequenceQuestion(six, (*goals, NEIGHBOURS)))
    own, rows = beaten(beside, usual)
    assert own[2] == 0
    assert [which for _, which in rows] == [()]


@pytest.mark.release
def test_what_beats_an_order_is_what_plain_comparison_says() -> None:
    about = asked(7, "M1,M2,twist")
    front, random = sequence_front(about), Random(3)  # noqa: S311
    for _ in range(200):
        order = [1, *random.sample(range(2, 8), 6)]
        values, better = beaten(front, about.shaft.fired_in(order))
        wanted = [
            (place, tuple(q for q in range(3) if point.values[q] < values[q] - 1e-8))
            for place, point in enumerate(front.points)
            if all(own <= other + 1e-8 for own, other in zip(point.values, values, strict=True))
        ]
        assert better == wanted
        assert better


def test_counterweights_can_take_all_of_the_first_couple_at_ninety_degrees() -> None:
    assert shares(shaft_of(8, bank_angle_deg=90), 1) == (1.0, 0.0)
    assert shares(shaft_of(12, bank_angle_deg=60), 1) == pytest.approx((1.0, 0.5))
    assert shares(shaft_of(6), 1) == (0.5, 0.5)


def test_neighbours_are_those_of_the_same_bank() -> None:
    vee = shaft_of(8, bank_angle_deg=90)
    steps = followed(vee, (1, 8, 4, 3, 6, 5, 7, 2))
    assert steps.neighbours == ((5, 7),)
    assert steps.partners == ((4, 3), (6, 5), (2, 1))


@pytest.mark.parametrize(
    ("about", "words", "more", "path", "code"),
    [
        (8, {}, {"bank": "60"}, "bank", "bank-uneven"),
        (7, {}, {"bank": "60"}, "bank", "bank-odd"),
        (8, {}, {"bank": "200"}, "bank", "bank-angle"),
        (8, {}, {"bank": "90,180"}, "bank", "sequence-bank"),
        (26, {}, {"bank": "27.6923076923"}, "", "sequence-cylinders"),
        (15, {"minimise": "twist"}, {}, "", "sequence-cylinders"),
        (8, {"gaps": "1,1"}, {"bank": "90"}, "gaps", "throw-gap-count"),
        (6, {"minimise": "M1,twist"}, {"crank_orders": "0.3"}, "orders", "torsion-order"),
        (6, {"minimise": "M1,twist"}, {"crank_orders": "x"}, "orders", "sequence-orders"),
        (6, {"minimise": "M1"}, {"crank_orders": "0.5"}, "orders", "orders-unused"),
        (6, {"minimise": "twist,roll"}, {}, "minimise", "no-goal"),
        (6, {"minimise": "twist,M1V"}, {}, "minimise", "no-goal"),
        (6, {"minimise": "twist,M3"}, {}, "minimise", "alike-order"),
        (6, {"minimise": "twist,F1"}, {}, "minimise", "alike-throws"),
        (8, {"minimise": "M3,M4"}, {"bank": "90"}, "minimise", "alike-order"),
        (8, {"minimise": "twist,twist"}, {}, "minimise", "named-twice"),
        (8, {"minimise": "M1,M2,M3,T1,twist"}, {}, "minimise", "too-many-objectives"),
        (8, {"minimise": "twist", "mode_shape": "1,2"}, {}, "mode_shape", "shape-throws"),
        (8, {"minimise": "twist", "mode_shape": "1,x"}, {}, "mode_shape", "shape-form"),
        (4, {"minimise": "twist", "mode_shape": "1,1,1,1"}, {}, "mode_shape", "shape-uniform"),
        (6, {"minimise": "M1", "mode_shape": "straight"}, {"why": "1-2-3-4-5-6"},
         "mode_shape", "shape-unused"),
        (6, {"minimise": "twist", "limit": ["T0.5=1"]}, {}, "limit", "cap-sequence"),
        (6, {"minimise": "twist", "limit": ["M1=3 N*m"]}, {}, "limit", "unit-needs-engine"),
        (6, {"minimise": "twist"}, {"why": "1-2-3-4-5-5"}, "why", "order-numbers"),
        (8, {}, {"bank": "90", "why": "1-2-3-4-5-6-7-8"}, "why", "pin-apart"),
        ("i6", {"minimise": "twist", "gaps": "1"}, {}, "gaps", "engine-gaps"),
        ("i6", {"minimise": "twist"}, {"bank": "60"}, "bank", "engine-bank"),
        ("i6", {"minimise": "twist", "cycle": "two-stroke"}, {}, "cycle", "engine-cycle"),
        ("boxer-6", {"minimise": "twist"}, {}, "", "not-shared"),
        ("kr250-racer", {"minimise": "twist"}, {}, "", "several-shafts"),
    ],
)  # fmt: skip
def test_a_mistake_is_said_in_a_sentence(
    about: Any, words: dict[str, Any], more: dict[str, Any], path: str, code: str
) -> None:
    engine = load(about) if isinstance(about, str) else about
    with pytest.raises(SearchError) as raised:
        sequences_of(engine, SearchWords(**words), SequenceWords(**more))
    found = [(".".join(map(str, each.path)), each.code) for each in raised.value.faults]
    assert (path, code) in found
    assert code in SENTENCES
    assert all("{" not in said(each, lambda name: f"--{name}") for each in raised.value.faults)


@pytest.mark.release
def test_the_command_gives_the_front_as_json(capsys: pytest.CaptureFixture[str]) -> None:
    line = "search 8 --bank 90 --minimise M1,M2,twist --orders 0.5,1.5 --json --why"
    with pytest.raises(SystemExit) as ended:
        cli.main([*line.split(), "1-8-4-3-6-5-7-2"])
    tree = json.loads(capsys.readouterr().out)
    assert ended.value.code == 0
    assert (tree["format"], tree["certificate"]["complete"], len(tree["rows"])) == (1, True, 4)
    (judged,) = tree["judged"]
    assert (judged["row"], judged["dominated_by"]) == (3, [])
    assert tree["rows"][2]["M1"] == pytest.approx(10**0.5)
    assert tree["rows"][2]["M1_after_counterweights"] == 0


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    "option", ["--best 3", "--uneven 1", "--speed 3000", "--row 1 --uneven 200"]
)
def test_options_of_other_searches_are_refused(
    option: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        cli.main(["search", "6", "--minimise", "twist", *option.split()])
    assert ended.value.code == 2
    assert option.split()[-2 if "--row" in option else 0] in capsys.readouterr().err


def test_a_row_is_written_as_an_engine_that_is_on_the_front(
    tmp_path: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    place = tmp_path / "better.toml"
    words = ["--minimise", "M1,M2,twist"]
    with pytest.raises(SystemExit):
        cli.main(["search", "v8-cross-plane", *words, "--row", "4", "-o", str(place)])
    with pytest.raises(SystemExit):
        cli.main(["search", str(place), *words])
    assert "is on the front, row 4" in " ".join(capsys.readouterr().out.split())


def test_a_sum_is_zero_only_where_it_is_exactly() -> None:
    shaft: Shaft = shaft_of(8, bank_angle_deg=90)
    about = SequenceQuestion(
        shaft, (Goal("M1", (couple(shaft, 1),)),), (Cap(couple(shaft, 2)), Cap(force(shaft, 2)))
    )
    values, kept = plain_values(about)
    assert [point.values for point in sequence_front(about).points] == [(pytest.approx(10**0.5),)]
    assert values[kept].min() == pytest.approx(10**0.5)


def test_an_interrupt_ends_the_search_with_the_best_so_far(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Nothing is proved then, and the command says so."""
    about = asked(8, "M1,M2,twist")
    monkeypatch.setattr(sequence_work, "OF_A_PART", 1)
    told: list[int] = []

    def watch(now: Progress) -> None:
        told.append(now.done)
        if len(told) == 20:
            signal.raise_signal(signal.SIGINT)

    front = sequence_front(about, watch=watch)
    assert not front.complete
    assert 0 < front.stars < about.shaft.count
    monkeypatch.setattr(sequence_fronts, "sequence_front", lambda *_, **__: front)
    with pytest.raises(SystemExit) as ended:
        cli.main(["search", "8", "--minimise", "M1,M2,twist"])
    assert ended.value.code == 130
    assert "INCOMPLETE" in capsys.readouterr().out


def test_a_bound_that_is_too_tight_would_be_found_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """The front of all orders differs as soon as a point is missing."""
    about = asked(6, "M1,M2,twist")
    whole = sequence_front(about)
    cut = dataclasses.replace(whole, points=whole.points[1:])
    monkeypatch.setattr(f"{__name__}.sequence_front", lambda _: cut)
    with pytest.raises(AssertionError):
        agrees(about)


UNEVEN = [
    (6, 0.0, (1, 5, 3, 6, 2, 4)),
    (8, 90.0, (1, 8, 4, 3, 6, 5, 7, 2)),
    (5, 0.0, (1, 2, 4, 5, 3)),
]


@pytest.mark.many(first=1)
@pytest.mark.parametrize(("cylinders", "bank", "order"), UNEVEN)
def test_uneven_angles_do_what_is_said_in_the_engine_that_is_written(
    cylinders: int, bank: float, order: tuple[int, ...]
) -> None:
    """Forces and couples by mechanics, torsion by the firing angles of that engine."""
    shaft = shaft_of(cylinders, bank_angle_deg=bank or None)
    fired = shaft.fired_in(order)
    sums = [couple(shaft, 1), force(shaft, 1)]
    sums += [torsion(shaft, Fraction(n, 2), straight(shaft)) for n in (1, 3)]
    question = SequenceQuestion(shaft, tuple(Goal(one.name, (one,)) for one in sums))
    curve = uneven_sequences(question, fired, deviations_deg=[4, 12], starts=6)
    assert [each.deviation_deg for each in curve] == [0, 4, 12]
    assert curve[0].later_deg == (0.0,) * cylinders
    assert curve[2].value <= curve[1].value <= curve[0].value
    found = curve[2]
    assert found.greatest_deviation_deg <= 12 + 1e-6
    engine = engine_of(shaft, fired, found.later_deg)
    own = firing(engine)
    assert own.order == found.firing_order
    assert own.intervals_deg == pytest.approx(found.intervals_deg, abs=1e-6)
    after = {term.sum.name: length for term, length in zip(found.terms, found.after, strict=True)}
    result = total(balance(engine))
    for name, spectrum in (("F1", result.force), ("M1", result.couple)):
        one = spectra.selected(spectrum, [1.0])
        both_ways = float((abs(one.forward) + abs(one.backward))[0])
        assert both_ways == pytest.approx(after[name], abs=1e-6)
    numbers = [number for pin in shaft.numbers for number in pin]
    shape = dict(zip(numbers, map(float, straight(shaft)), strict=True))
    at = dict(zip(own.order, np.radians(own.angles_deg), strict=True))
    for half in (0.5, 1.5):
        length = abs(sum(a * np.exp(1j * half * at[n]) for n, a in shape.items()))
        assert length == pytest.approx(after[f"T{half:g}"], abs=1e-6)


@pytest.mark.release
def test_no_drawn_angles_are_better_than_the_uneven_ones_that_were_found() -> None:
    shaft = shaft_of(6)
    fired = shaft.fired_in((1, 5, 3, 6, 2, 4))
    sums = [couple(shaft, 1), *(torsion(shaft, Fraction(n, 2), straight(shaft)) for n in (3, 5))]
    question = SequenceQuestion(shaft, tuple(Goal(one.name, (one,)) for one in sums))
    found = uneven_sequences(question, fired, deviations_deg=[8])[-1]
    random = np.random.default_rng(3)
    order = shaft.firing_order(fired)
    for _ in range(20_000):
        gaps = 120 + random.uniform(-8, 8, 5)
        if abs(600 - gaps.sum()) > 8:
            continue
        places = np.cumsum([0.0, *gaps])
        later = dict(zip(order, places, strict=True))
        value = sum(
            abs(
                sum(
                    float(weight) * np.exp(1j * float(one.order) * np.radians(later[n]))
                    for n, weight in enumerate(one.weights, 1)
                )
                * one.scale
            )
            ** 2
            for one in sums
        )
        assert value**0.5 > found.value - 1e-3


def test_the_command_writes_an_engine_with_uneven_angles(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    place = tmp_path / "uneven.toml"
    line = "search 6 --minimise M1,twist,neighbours --row 3 --uneven 5 -o"
    with pytest.raises(SystemExit) as ended:
        cli.main([*line.split(), str(place)])
    assert ended.value.code == 0
    assert "local optimum" in " ".join(capsys.readouterr().out.split())
    intervals = firing(load(str(place))).intervals_deg
    assert sorted(intervals) == pytest.approx([115, 115, 120, 120, 125, 125], abs=0.1)
