"""Parts matched to cylinders: the law, the search and its proof, against trying everything."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations, permutations, product

import numpy as np
import pytest
from tests.files.test_parts import tree

from crankstar import spectra
from crankstar.analyses.match.assignments import Kind, _exchanged, _halved, _listed, least
from crankstar.analyses.match.batch import Batch, MatchingError, batch_of, paired
from crankstar.analyses.match.law import linear_unbalance
from crankstar.analyses.match.matching import left_by, matched
from crankstar.analyses.match.sets import divided, divided_rods, runs
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.files.catalog import load
from crankstar.files.lists import list_of
from crankstar.mechanics.balance import balance, total
from crankstar.spectra import Real
from crankstar.studies.part_weights import WEIGHED, with_own_big_ends, with_parts

TRIPLE = """
name = "triple"
speed = "3000 rpm"
[cylinder]
stroke = "80 mm"
rod_length = "140 mm"
reciprocating_mass = "600 g"
rotating_mass = "500 g"
[layout]
type = "inline"
throws = ["0 deg", "120 deg", "240 deg"]
bore_pitch = "90 mm"
"""


def triple() -> Engine:
    """Three cylinders in line."""
    from crankstar.files import tree_of

    return engine_of(tree_of(TRIPLE))


def batch(count: int, seed: int = 1, kinds: tuple[str, ...] = WEIGHED) -> Batch:
    """Parts with scatter; their sizes are those of a car engine."""
    chance = np.random.default_rng(seed)
    usual = {"piston": 0.41, "pin": 0.1, "small_end": 0.15, "big_end": 0.4}
    return Batch(
        tuple(map(str, range(1, count + 1))),
        {name: usual[name] + 0.001 * chance.normal(size=count) for name in kinds},
    )


def left(engine: Engine, arm: float) -> float:
    """U by the sums of the engine itself: rms of force and of couple over the arm."""
    sums = total(balance(engine, speed=1.0))
    squares = 0.0
    for spectrum, size in ((sums.force, 1.0), (sums.couple, 1 / arm)):
        some = spectra.selected(spectrum, [1.0, 2.0])
        squares += size**2 * float((np.abs(some.forward) ** 2 + np.abs(some.backward) ** 2).sum())
    return squares**0.5


@pytest.mark.parametrize("name", ["subaru-ej25", "radial-9", "napier-deltic", "v8-cross-plane"])
def test_the_law_is_what_the_engine_with_other_parts_does(name: str) -> None:
    engine = load(name)
    law = linear_unbalance(engine)
    chance = np.random.default_rng(3)
    count = len(engine.cylinders)
    more = {part: chance.uniform(0, 1e-3, count) for part in WEIGHED}
    up = more["piston"] + more["pin"] + more["small_end"]
    whole = linear_unbalance(with_parts(engine, more)).fixed
    assert law.rows(up, more["big_end"]) == pytest.approx(whole, abs=1e-9 * abs(whole).max())
    if not engine.relative:
        assert left(with_parts(engine, more), law.arm) == pytest.approx(
            float(law.unbalance(up, more["big_end"])), rel=1e-9
        )


@pytest.mark.parametrize("name", ["bmw-s65", "radial-9", "audi-25-tfsi"])
def test_equal_big_ends_come_to_the_same_in_their_places_as_on_their_throws(name: str) -> None:
    engine = load(name)
    before, after = (total(balance(each)) for each in (engine, with_own_big_ends(engine)))
    for sums in ("force", "couple", "torque"):
        own = getattr(before, sums)
        other = spectra.selected(getattr(after, sums), own.orders)
        size = max(float(np.abs(own.forward).max(initial=0)), 1e-12)
        assert np.abs(other.forward - own.forward).max(initial=0) <= 1e-12 * size
        assert np.abs(other.backward - own.backward).max(initial=0) <= 1e-12 * size


def test_the_law_holds_for_rods_as_rigid_bodies() -> None:
    engine = load("audi-25-tfsi", changes={"cylinder.rod": {"mass": "600 g", "centre": "45 mm"}})
    law = linear_unbalance(engine)
    more = {
        "small_end": np.array([1, 0, 2, 0, 3]) / 1e3,
        "big_end": np.array([0, 3, 1, 0, 0]) / 1e3,
    }
    assert left(with_parts(engine, more), law.arm) == pytest.approx(
        float(law.unbalance(more["small_end"], more["big_end"])), rel=1e-9
    )


@pytest.mark.parametrize("whole", [True, False])
def test_a_match_is_the_best_of_all_engines_that_can_be_built(whole: bool) -> None:
    engine, parts = triple(), batch(3)
    found = matched(engine, parts, whole=whole)
    pins, sums = paired(parts)
    means = {name: float(own.mean()) for name, own in parts.masses.items()}
    tried: list[float] = []
    for pistons, rods in product(permutations(range(3)), repeat=2):
        items = {
            "piston": parts.masses["piston"][[*pistons]],
            "pin": parts.masses["pin"][[pins[item] for item in pistons]],
            "small_end": parts.masses["small_end"][[*rods]],
            "big_end": parts.masses["big_end"][[*rods]],
        }
        more = {name: own - means[name] for name, own in items.items()}
        if not whole:
            law = linear_unbalance(engine)
            up = more["piston"] + more["pin"] + more["small_end"]
            tried.append(float(np.linalg.norm(law.rows(up, more["big_end"]) - law.fixed)))
        else:
            tried.append(left(with_parts(engine, more), found.law.arm))
    assert found.proved
    assert found.unbalance == pytest.approx(min(tried), rel=1e-6)
    assert found.by_chance == pytest.approx(float(np.sqrt(np.mean(np.square(tried)))), rel=1e-6)
    assert left(found.engine, found.law.arm) == pytest.approx(found.whole_unbalance, rel=1e-6)
    assert sums[0] == pytest.approx(parts.masses["piston"][0] + parts.masses["pin"][pins[0]])


def test_the_masses_of_the_matched_engine_are_those_of_its_parts() -> None:
    engine, parts = engine_of(tree()), batch(8)
    found = matched(engine, parts, watch=lambda _done, _of: False)
    for place, cylinder in zip(found.places, found.engine.cylinders, strict=True):
        assert cylinder.parts is not None
        own = {"piston": place.piston or 0, "pin": place.pin or 0, "small_end": place.rod or 0}
        for name, item in own.items():
            assert getattr(cylinder.parts, name) == pytest.approx(parts.masses[name][item])
        assert cylinder.reciprocating_mass == pytest.approx(cylinder.parts.reciprocating)
        assert cylinder.big_end_mass == pytest.approx(cylinder.parts.rotating)
    assert {throw.rotating_mass for throw in found.engine.shafts[0].throws} == {0}
    assert not found.proved  # it was interrupted
    assert found.unbalance < found.as_listed


@pytest.mark.parametrize("rows", [1, 2, 5])
@pytest.mark.parametrize("items", [3, 4, 5])
def test_the_least_of_two_kinds_is_that_of_all_pairs(items: int, rows: int) -> None:
    chance = np.random.default_rng(10 * items + rows)
    fixed = chance.normal(size=rows)
    kinds = [Kind(chance.normal(size=(items, 3, rows))) for _ in range(2)]
    brute = min(
        float(
            np.linalg.norm(
                fixed
                + sum(
                    kind.vectors[own[place], place]
                    for kind, own in zip(kinds, pair, strict=True)
                    for place in range(3)
                )
            )
        )
        for pair in product(permutations(range(items), 3), repeat=2)
    )
    found = least(fixed, kinds)
    assert found.proved
    assert found.length == pytest.approx(brute, rel=1e-9)


def test_like_places_are_filled_in_one_order_only() -> None:
    alike = np.ones((5, 4, 1)) * np.array([1.0, 1.0, 1.0, -1.0])[None, :, None]
    kind = Kind(alike * np.arange(1.0, 6.0)[:, None, None])
    assert len(_listed(kind)) == 5 * 4 * 3 * 2 // 6
    brute = min(abs(a + b + c - d) for a, b, c, d in permutations(range(1, 6), 4))
    assert least(np.zeros(1), [kind]).length == brute


def test_halves_and_exchanges_come_to_the_same_as_the_list() -> None:
    chance = np.random.default_rng(4)
    kind = Kind(chance.normal(size=(7, 7, 3)))
    fixed = chance.normal(size=3)
    told = lambda _done, _of: True  # noqa: E731
    listed = least(fixed, [kind])
    split, exchanged = _halved(fixed, kind, told), _exchanged(fixed, [kind], told)
    assert split.length == pytest.approx(listed.length, rel=1e-9)
    assert (split.proved, exchanged.proved) == (True, False)
    assert exchanged.length >= listed.length * (1 - 1e-9)
    whole = fixed + sum(kind.vectors[item, at] for at, item in enumerate(split.items[0]))
    assert float(np.linalg.norm(whole)) == pytest.approx(split.length)


@pytest.mark.release
def test_twelve_pistons_are_matched_with_proof() -> None:
    """Checked by exchanges: no exchange of two pistons makes it better."""
    chance = np.random.default_rng(6)
    masses, arms = chance.normal(size=12), chance.normal(size=(12, 2))
    kind = Kind(masses[:, None, None] * arms[None])
    found = least(np.zeros(2), [kind])
    own = [masses[item] for item in found.items[0]]
    for a, b in combinations(range(12), 2):
        other = own.copy()
        other[a], other[b] = other[b], other[a]
        assert np.linalg.norm(np.array(other) @ arms) >= found.length - 1e-12
    assert found.proved


def test_heavy_pins_with_light_pistons_scatter_least_of_all_pairings() -> None:
    parts = batch(5, seed=9)
    _pins, sums = paired(parts)
    pistons, pins = parts.masses["piston"], parts.masses["pin"]
    every = [pistons + pins[[*order]] for order in permutations(range(5))]
    assert np.ptp(sums) == pytest.approx(min(float(np.ptp(each)) for each in every))
    assert sums.std() == pytest.approx(min(float(each.std()) for each in every))


def test_classes_leave_what_random_parts_of_a_class_leave() -> None:
    engine, parts = triple(), batch(3)
    found = matched(engine, parts, classes=[0.004])
    law, chance = found.law, np.random.default_rng(8)
    around = 0.002 * chance.uniform(-1, 1, (40_000, 3))
    up = 0.002 * chance.uniform(-1, 1, (40_000, 3, 3)).sum(axis=1)
    sizes = np.linalg.norm(law.rows(up, around) - law.fixed, axis=1)
    assert found.classes[0].rms == pytest.approx(float(np.sqrt((sizes**2).mean())), rel=0.01)
    assert float(sizes.max()) < found.classes[0].most


def every_division(items: int, size: int) -> list[tuple[tuple[int, ...], ...]]:
    """All ways to take two sets out of some items."""
    sets = list(combinations(range(items), size))
    return [(a, b) for a in sets for b in sets if not set(a) & set(b)]


def test_sets_have_the_least_spread_of_all_divisions() -> None:
    chance = np.random.default_rng(5)
    for _ in range(5):
        masses, ends = chance.normal(size=7), chance.normal(size=(7, 2))
        ways = every_division(7, 3)
        brute = min(sum(float(np.ptp(masses[[*some]])) for some in way) for way in ways)
        assert runs(masses, sets=2, size=3).spread == pytest.approx(brute)
        both = min(sum(float(np.ptp(ends[[*s]], axis=0).sum()) for s in way) for way in ways)
        found = divided_rods(ends, sets=2, size=3)
        assert (found.spread, found.proved) == (pytest.approx(both), True)


def test_every_engine_of_a_batch_is_matched_with_parts_of_its_own() -> None:
    engine, parts = triple(), batch(7)
    found = divided(engine, parts, engines=2)
    for kind in ("piston", "pin", "rod"):
        used = [getattr(place, kind) for each in found.engines for place in each.places]
        assert len(set(used)) == 6
    pins, _sums = paired(parts)
    for each in found.engines:
        assert each.proved
        assert all(place.pin == pins[place.piston or 0] for place in each.places)
        assert left(each.engine, each.law.arm) == pytest.approx(each.whole_unbalance)


def test_too_few_parts_and_engines_without_masses_are_refused() -> None:
    with pytest.raises(MatchingError, match="2 of each part and the engine 3 cylinders"):
        matched(triple(), batch(2))
    with pytest.raises(MatchingError, match="gives no masses"):
        matched(load("i4"), batch(4))
    with pytest.raises(MatchingError, match="2 engines with 3 cylinders need 6"):
        divided(triple(), batch(5), engines=2)


def test_a_list_may_have_semicolons_decimal_commas_and_units_in_cells() -> None:
    text = "# weights\nnr;Piston;Pin [g]\n\nA;0,412 kg;99,5\nB;411 g;98\n"
    found = batch_of(list_of(text, name="w.csv"))
    masses: dict[str, Real] = dict(found.masses)
    assert found.labels == ("A", "B")
    assert masses["piston"] == pytest.approx([0.412, 0.411])
    assert masses["pin"] == pytest.approx([0.0995, 0.098])


TWIN = TRIPLE.replace('["0 deg", "120 deg", "240 deg"]', '["0 deg", "0 deg"]')
FIVE = np.array([500.0, 500.1, 502.0, 504.2, 506.5]) / 1000


def twin() -> Engine:
    """Two cylinders in line that go up and down together."""
    from crankstar.files import tree_of

    return engine_of(tree_of(TWIN))


def counted_from_the_fitted(engine: Engine, masses: Real, chosen: tuple[int, ...]) -> float:
    """U of pistons by the engine itself: with them, less with their own mean in its place."""
    law = linear_unbalance(engine)
    own = masses[[*chosen]]
    built = with_parts(engine, {"piston": own - own.mean()})
    return float(np.linalg.norm(linear_unbalance(built).fixed - law.fixed))


@pytest.mark.many(first=1)
@pytest.mark.parametrize("make", [twin, triple])
def test_of_too_many_pistons_those_are_fitted_that_leave_least(make: Callable[[], Engine]) -> None:
    """The mean counts of those that are fitted: pistons left over are in no engine."""
    engine = make()
    count = len(engine.cylinders)
    ways = list(permutations(range(5), count))
    tried = [counted_from_the_fitted(engine, FIVE, way) for way in ways]
    found = matched(engine, Batch(tuple("abcde"), {"piston": FIVE}))
    chosen = tuple(place.piston or 0 for place in found.places)
    assert found.proved
    assert found.left_over == 5 - count
    assert found.unbalance == pytest.approx(min(tried), rel=1e-6)
    assert counted_from_the_fitted(engine, FIVE, chosen) == pytest.approx(min(tried), rel=1e-6)
    assert found.by_chance == pytest.approx(float(np.sqrt(np.mean(np.square(tried)))), rel=1e-6)
    assert found.as_listed == pytest.approx(
        counted_from_the_fitted(engine, FIVE, tuple(range(count))), rel=1e-6
    )
    assert found.fixed == 0


def test_a_twin_of_a_batch_is_the_same_alone_and_as_the_first_of_several() -> None:
    parts = Batch(tuple("abcde"), {"piston": FIVE})
    alone = matched(twin(), parts)
    (one,) = divided(twin(), parts, engines=1).engines
    assert {place.piston for place in alone.places} == {0, 1}
    assert {place.piston for place in one.places} == {0, 1}
    assert one.unbalance == pytest.approx(alone.unbalance, rel=1e-9)
    assert one.whole_unbalance == pytest.approx(alone.whole_unbalance, rel=1e-9)
    assert one.engine.cylinders[0].reciprocating_mass == pytest.approx(
        alone.engine.cylinders[0].reciprocating_mass, abs=2e-4
    )


@pytest.mark.release
@pytest.mark.parametrize("whole", [True, False])
def test_of_too_many_of_every_part_the_best_are_fitted(whole: bool) -> None:
    engine, parts = triple(), batch(4)
    law, (pins, _sums) = linear_unbalance(engine), paired(parts)
    tried: list[float] = []
    for pistons, rods in product(permutations(range(4), 3), repeat=2):
        chosen = {
            "piston": [*pistons],
            "pin": [pins[item] for item in pistons],
            "small_end": [*rods],
            "big_end": [*rods],
        }
        more = {}
        for name, items in chosen.items():
            own = parts.masses[name]
            more[name] = own[items] - (own if whole else own[items]).mean()
        rows = linear_unbalance(with_parts(engine, more)).fixed - (0 if whole else law.fixed)
        tried.append(float(np.linalg.norm(rows)))
    found = matched(engine, parts, whole=whole)
    assert found.proved
    assert found.unbalance == pytest.approx(min(tried), rel=1e-6)
    assert found.by_chance == pytest.approx(float(np.sqrt(np.mean(np.square(tried)))), rel=1e-6)
    assert left(found.engine, found.law.arm) == pytest.approx(found.whole_unbalance, rel=1e-6)


def test_of_more_parts_than_can_be_tried_nothing_is_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    parts = Batch(tuple("abcde"), {"piston": FIVE})
    listed = matched(triple(), parts)
    monkeypatch.setattr("crankstar.analyses.match.assignments.MOST", 10)
    exchanged = matched(triple(), parts)
    assert (listed.proved, exchanged.proved) == (True, False)
    assert exchanged.unbalance == pytest.approx(listed.unbalance, rel=1e-6)


@pytest.mark.many(first=3)
@pytest.mark.parametrize("whole", [True, False])
@pytest.mark.parametrize("ends", [("big_end",), ("small_end", "big_end")])
def test_each_of_several_engines_has_the_least_that_was_asked_for(
    ends: tuple[str, ...], whole: bool
) -> None:
    """By trying every assignment of its set on the engine itself, about what is asked for."""
    engine, parts = triple(), batch(6, seed=4, kinds=("piston", *ends))
    law = linear_unbalance(engine)
    for found in divided(engine, parts, engines=2, whole=whole).engines:
        pistons = [place.piston or 0 for place in found.places]
        rods = [place.rod or 0 for place in found.places]
        mean = {
            name: own[pistons if name == "piston" else rods].mean()
            for name, own in parts.masses.items()
        }
        tried: list[float] = []
        for first, second in product(permutations(pistons), permutations(rods)):
            fitted = {
                name: own[[*(first if name == "piston" else second)]] - mean[name]
                for name, own in parts.masses.items()
            }
            rows = linear_unbalance(with_parts(engine, fitted)).fixed
            tried.append(float(np.linalg.norm(rows - (0 if whole else law.fixed))))
        assert (found.whole, found.proved) == (whole, True)
        assert found.unbalance == pytest.approx(min(tried), rel=1e-6)


@pytest.mark.parametrize("whole", [True, False])
def test_one_engine_of_a_batch_has_one_answer(whole: bool) -> None:
    parts = batch(6, seed=4, kinds=("piston", "pin", "big_end"))
    alone = matched(triple(), parts, whole=whole)
    (one,) = divided(triple(), parts, engines=1, whole=whole).engines
    assert (one.places, one.unbalance, one.whole) == (alone.places, alone.unbalance, whole)
    assert one.classes == alone.classes


@pytest.mark.parametrize("whole", [False, True])
def test_what_is_left_in_the_cylinders_is_the_same_by_the_law(*, whole: bool) -> None:
    """Of the assignment that was found; of the whole engine also by its own sums."""
    engine, parts = triple(), batch(3)
    found = matched(engine, parts, whole=whole)
    asked = {"orders": (1.0, 2.0), "quantities": found.quantities, "whole": whole}
    again = left_by(engine, parts, found.places, **asked)
    assert again == pytest.approx(found.unbalance, rel=1e-9)
    if whole:
        assert again == pytest.approx(left(found.engine, found.law.arm), rel=1e-9)
