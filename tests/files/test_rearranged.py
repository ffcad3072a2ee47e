"""Engines with another number of cylinders: always an engine, firing evenly where a crank can."""

from __future__ import annotations

import pytest
from tests.catalog import EVERY_ENGINE, EVERY_NAME

from crankstar.engine.engine import Engine
from crankstar.files import catalog, engine_of
from crankstar.files.forms import is_explicit
from crankstar.files.rearranged import Rearranged, rearranged
from crankstar.firing.intervals import firing
from crankstar.firing.rows import row_cranks
from crankstar.language.faults import EngineError

UNEVEN = {
    "brough-golden-dream": "two crankshafts that reach their dead centres together",
    "ducati-90": "pins would be split by 90 deg",
    "ducati-900ss": "pins would be split by 90 deg",
    "kr250-production": "cylinders of both crankshafts fire together",
    "kr250-racer": "cylinders of both crankshafts fire together",
    "kr250-racer-simultaneous": "cylinders of both crankshafts fire together",
    "napier-lion": "three banks 60 deg apart on five pins",
    "square-four": "three pins on each of two crankshafts geared at 180 deg",
    "v2-90": "pins would be split by 90 deg",
    "vw-vr6": "axes that miss the crankshaft shift the dead centres",
}
"""Engines that do not fire evenly with one row more on, and why."""


def tree_of(name: str) -> dict:
    return catalog.tree_of(name)[1]


def evenness(engine: Engine) -> float:
    """The greatest deviation of a firing interval from the mean, over the mean."""
    fired = firing(engine)
    mean = fired.cycle_deg / len(fired.order)
    return max(abs(interval - mean) for interval in fired.intervals_deg) / mean


@pytest.mark.many(first=3)
@pytest.mark.parametrize(
    "name", [each for each in EVERY_NAME if not is_explicit(tree_of(str(each.values[0])))]
)
def test_an_engine_with_more_cylinders_is_one_and_fires_evenly_if_it_can(name: str) -> None:
    before = rearranged(tree_of(name))
    assert before.more is not None
    made = rearranged(tree_of(name), cylinders=before.more)
    engine = engine_of(made.tree)
    assert len(engine.chambers) == made.cylinders == before.more
    assert engine.cycle == engine_of(tree_of(name)).cycle
    if name == "napier-lion":
        assert not made.orders
        return
    assert sorted(engine.firing_order) == sorted(engine.chambers)
    articulated = any(cylinder.articulated for cylinder in engine.cylinders)
    if name not in UNEVEN:
        assert evenness(engine) < (0.12 if articulated else 1e-6)
    assert [offer.tree for offer in made.orders if offer.chosen] == [made.tree]


@pytest.mark.many(first=2)
@EVERY_ENGINE
def test_there_and_back_again_there_are_as_many_cylinders(name: str) -> None:
    tree = tree_of(name)
    here = rearranged(tree)
    for count in (here.fewer, here.more):
        if count is not None:
            other = rearranged(tree, cylinders=count)
            assert here.cylinders in (other.fewer, other.more)
            again = rearranged(other.tree, cylinders=here.cylinders)
            assert len(engine_of(again.tree).chambers) == here.cylinders


@pytest.mark.many(first=1)
@pytest.mark.parametrize("name", ["i4", "i5", "v8-cross-plane", "v6-60-six-throws", "harley-45"])
def test_every_offer_is_an_engine_of_as_many_cylinders(name: str) -> None:
    made = rearranged(tree_of("i4"), cylinders=5) if name == "i5" else rearranged(tree_of(name))
    assert len(made.cranks) > (1 if name != "harley-45" else 0)
    for offer in (*made.cranks, *made.orders):
        assert len(engine_of(offer.tree).chambers) == made.cylinders, offer.label
    assert sum(offer.chosen for offer in made.cranks) == 1


@pytest.mark.release
def test_customary_orders_come_first() -> None:
    orders = {5: [1, 2, 4, 5, 3], 6: [1, 5, 3, 6, 2, 4], 8: [1, 6, 2, 5, 8, 3, 7, 4]}
    made: Rearranged = rearranged(tree_of("i4"))
    while made.more and made.cylinders < max(orders):
        made = rearranged(made.tree, cylinders=made.more)
        if made.cylinders in orders:
            assert made.tree["firing_order"] == orders[made.cylinders]


def test_sizes_stay_and_what_belongs_to_the_old_crank_goes() -> None:
    tree = tree_of("subaru-ej25") | {
        "crankshaft": [{"bearing_count": 3}],
        "block": {"mass": "90 kg"},
    }
    made = rearranged(tree, cylinders=6)
    assert made.tree["cylinder"] == tree["cylinder"]
    assert made.tree["layout"]["bore_pitch"] == tree["layout"]["bore_pitch"]
    assert made.tree["name"] == "Boxer 6"
    assert not {"crankshaft", "block", "notes"} & made.tree.keys()
    assert "crankshaft, block" in made.sentences[1]
    assert not [path for path in made.tree["provenance"] if path.startswith("layout")]


def test_a_sentence_says_what_was_decided() -> None:
    made = rearranged(tree_of("i4"), cylinders=6)
    assert made.sentences == (
        (
            "6 cylinders, throws at 0°, -120°, 120°, 120°, -120°, 0°, firing order 1-5-3-6-2-4, "
            "evenly every 120°."
        ),
    )


@pytest.mark.parametrize(
    ("name", "count"), [("v8-cross-plane", 9), ("i4", 99), ("napier-deltic", 9)]
)
def test_a_number_that_the_layout_cannot_have_is_refused(name: str, count: int) -> None:
    with pytest.raises(EngineError):
        rearranged(tree_of(name), cylinders=count)


def test_rows_of_four_stroke_engines_of_an_even_number_have_no_couples() -> None:
    for count in range(2, 15, 2):
        first = row_cranks(cylinders=count, cycle="four-stroke")[0]
        assert first.couples == (0.0, 0.0)


def test_the_seven_of_marine_diesels_is_the_best_of_its_kind() -> None:
    """The crank of 1-7-2-5-4-3-6: couples 0.267 and 1.006."""
    first = row_cranks(cylinders=7, cycle="two-stroke")[0]
    assert [round(couple, 3) for couple in first.couples] == [0.267, 1.006]


def test_a_harley_is_not_said_to_fire_nearly_evenly_but_a_radial_is() -> None:
    assert "unevenly at 315-405°" in rearranged(tree_of("harley-45")).sentences[0]
    assert "nearly evenly every 80°" in rearranged(tree_of("radial-9")).sentences[0]


def test_the_explicit_form_says_why_its_cylinders_stay() -> None:
    made = rearranged(tree_of("napier-deltic"))
    assert (made.fewer, made.more) == (None, None)
    assert "layout is needed" in made.sentences[0]


@pytest.mark.release
def test_a_row_longer_than_any_built_has_no_other_cranks() -> None:
    plain = {k: v for k, v in tree_of("i6").items() if k in ("format", "name", "cylinder")}
    throws = [f"{720 * pin / 128 % 360:.9g} deg" for pin in range(128)]
    made = rearranged({**plain, "layout": {"type": "inline", "throws": throws}})
    assert (made.fewer, made.more, len(made.cranks)) == (16, None, 1)
    assert rearranged(made.tree, cylinders=16).cylinders == 16
