"""The verdict: its sentences say what the Balance says, for every engine of the catalog."""

from __future__ import annotations

import re
from fractions import Fraction

import numpy as np
import pytest

from crankstar import balance, catalog, load, phasor, total
from crankstar.arrangement import Basis
from crankstar.layouts import Bank, Crank, tandem
from crankstar.remedy import main_bearings, needs
from crankstar.verdict import likeness, verdict

BEARINGS = {
    "i4": 5,
    "i6": 7,
    "triple-120": 4,
    "v8-cross-plane": 5,
    "gm-3800": 4,
    "v6-60-six-throws": 4,
    "subaru-ej25": 5,
    "boxer-6": 7,
}
"""Main bearings of the real engines of these layouts."""


@pytest.mark.parametrize("name", catalog.names())
def test_free_and_remaining_orders_are_those_of_the_balance(name: str) -> None:
    engine = load(name)
    facts = verdict(engine, neighbours=False)
    sums = total(balance(engine))
    for quantity in ("force", "couple"):
        (sentence,) = [fact.sentence for fact in facts if fact.about == quantity]
        spectrum = getattr(sums, quantity)
        told = {
            float(order): float(size) for order, size in re.findall(r"order (\d+(?:\.\d+)?)(?: remains)?: ([\d.e-]+\d)", sentence)
        }
        for order, size in told.items():
            one = phasor.selected(spectrum, [order])
            assert abs(complex(one.forward[0])) + abs(complex(one.backward[0])) == pytest.approx(size, rel=1e-4)
        free = re.match(rf"No {quantity} of order ([\d., and]+);", sentence)
        none = [float(order) for order in re.findall(r"\d+(?:\.\d+)?", free.group(1))] if free else []
        if sentence.startswith(f"No {quantity} of any order"):
            none = [1.0, 2.0, 4.0, 6.0]
        for order in none:
            one = phasor.selected(spectrum, [order])
            assert abs(complex(one.forward[0])) + abs(complex(one.backward[0])) < 1e-8 * len(engine.cylinders)


@pytest.mark.parametrize("name", BEARINGS)
def test_main_bearings_are_counted_as_engines_have_them(name: str) -> None:
    engine = load(name)
    assert len(main_bearings(engine, engine.shafts[0])) == BEARINGS[name]
    assert f"{BEARINGS[name]} main bearings" in verdict(engine, neighbours=False)[0].sentence


@pytest.mark.parametrize("name", ["i4", "gm-3800", "radial-9", "napier-deltic", "kr250-racer", "single"])
def test_every_need_has_its_cure(name: str) -> None:
    engine = load(name)
    cures = " ".join(fact.sentence for fact in verdict(engine, neighbours=False) if fact.about == "cure")
    for need in needs(engine):
        assert f"Order {abs(need.ratio)}, " in cures
        crank = next((shaft for shaft in engine.shafts if shaft.throws and shaft.speed_ratio == need.ratio), None)
        if crank is None:
            assert re.search(rf"(speed ratio|and) {need.ratio}\b|ratios {abs(need.ratio)} and -{abs(need.ratio)}", cures)


def test_half_the_mass_leaves_what_the_sentence_says() -> None:
    told = {
        "harley-45": "a force of 0.70711 m r ω², turning against the crank",
        "gm-3800": "a couple of 0.44829 m r ω² a, turning against the crank",
        "v2-90": "leave nothing of the first order",
    }
    for name, words in told.items():
        assert any(words in fact.sentence for fact in verdict(load(name), neighbours=False))


@pytest.mark.parametrize("pitch", ["20 mm", "110 mm"])
def test_couples_of_neighbours_are_compared_in_one_length(pitch: str) -> None:
    """Of two cylinders on one pin any bore pitch can be given: what the couple is counted in must not tell engines apart."""
    sizes = {"cylinder.stroke": "69 mm", "cylinder.reciprocating_mass": "560 g", "layout.bore_pitch": pitch}
    same = load("ducati-90", changes={**sizes, "layout.bank_offset": "24 mm", "name": "mine"})
    told = [fact.sentence for fact in verdict(same) if fact.about == "neighbours"]
    assert "ducati-90" in told[0]
    assert told[0].startswith("Its pistons alone")


def test_neighbours_are_of_the_same_kind_and_nearest_first() -> None:
    sentences = [fact.sentence for fact in verdict(load("v8-cross-plane")) if fact.about == "neighbours"]
    assert "bmw-s65" in sentences[0]
    assert "shake like" in sentences[0]
    assert any("v8-flat-plane it has 3.162" in sentence for sentence in sentences)
    own = likeness(load("v8-cross-plane"))
    for sentence in sentences[1:]:
        name = re.search(r"beside ([\w-]+)", sentence).group(1)  # pyright: ignore[reportOptionalMemberAccess]
        assert load(name).cycle == "four-stroke"
        assert len(load(name).chambers) == 8
        assert np.abs(np.subtract(own, likeness(load(name)))).max() > 0.01


def test_an_engine_alone_in_the_catalog_says_so() -> None:
    assert verdict(load("napier-deltic"))[-1].sentence == "The catalog has no other two-stroke engine with 18 cylinders."


BURBLE = (
    "Cylinders 5 and 7 of bank odd exhaust 90 deg apart (270-180-90-180), and 8 and 4 of bank even exhaust 90 deg "
    "apart (90-180-270-180): uneven bank pulses, the burble of a cross-plane V8."
)


def told(name: str) -> list[str]:
    return [fact.sentence for fact in verdict(load(name), neighbours=False) if fact.about == "firing"]


@pytest.mark.parametrize(
    ("name", "sentences"),
    [
        ("v8-cross-plane", [BURBLE, "Neighbours 5-7 fire one after the other; so do partners on a pin 4-3, 6-5, 2-1."]),
        ("i4", ["Neighbours 3-4, 2-1 fire one after the other."]),
        ("i6", ["No neighbours fire one after the other."]),
        ("merlin", ["Each bank exhausts evenly, every 120 deg.", "No neighbours or partners on a pin fire one after the other."]),
        ("radial-9", []),
        ("triple-120", []),
        ("napier-lion", []),
    ],
)
def test_the_verdict_on_exhaust_pulses_and_on_who_fires_after_whom(name: str, sentences: list[str]) -> None:
    assert told(name) == sentences


@pytest.mark.parametrize("name", catalog.names())
def test_only_cross_plane_eights_burble_and_the_verdict_on_firing_is_short(name: str) -> None:
    sentences = told(name)
    eights = {"v8-cross-plane", "bmw-s65", "ford-coyote", "ford-46-sohc", "gm-l76", "porsche-cayenne-48", "toyota-1uz-fe"}
    assert any("burble" in sentence for sentence in sentences) == (name in eights)
    assert len(sentences) <= 2
    assert all(len(sentence) < 240 for sentence in sentences)


def test_manifolds_that_join_the_right_cylinders_end_the_burble() -> None:
    joined = load("v8-cross-plane", changes={"valves.manifolds": [[1, 4, 6, 7], [8, 3, 5, 2]]})
    sentences = [fact.sentence for fact in verdict(joined, neighbours=False) if fact.about == "firing"]
    assert sentences[0] == "Each manifold exhausts evenly, every 180 deg."


def test_crankshafts_of_different_speed_have_no_verdict_on_their_strokes() -> None:
    first, second = (Bank(cylinders=own) for own in ((1, 2), (3, 4)))
    slow = Crank(banks=(second,), throws=(0.0, 1.0), right=3.0, speed_ratio=Fraction(1, 2), lag=0.5)
    cranks = (Crank(banks=(first,), throws=(0.0, 1.0)), slow)
    engine = tandem(Basis(name="x", firing_order=(1, 3, 2, 4)), cranks=cranks)
    assert [fact.about for fact in verdict(engine, neighbours=False)][:2] == ["layout", "force"]
