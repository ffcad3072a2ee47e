"""The verdict: its sentences say what the Balance says, for every engine of the catalog."""

from __future__ import annotations

import re
from fractions import Fraction

import numpy as np
import pytest
from tests.catalog import EVERY_ENGINE

from crankstar import load, spectra, total
from crankstar.analyses.verdict.facts import verdict
from crankstar.analyses.verdict.relatives import piston_balance
from crankstar.engine.banks import Bank, Crank
from crankstar.engine.basis import Basis
from crankstar.engine.copies import with_values
from crankstar.engine.layouts import tandem
from crankstar.engine.records import Rod
from crankstar.language.numbers import number
from crankstar.mechanics.balance import balance, scales
from crankstar.remedy import main_bearings, needs

pytestmark = pytest.mark.quick

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


@EVERY_ENGINE
def test_free_and_remaining_orders_are_those_of_the_balance(name: str) -> None:
    engine = load(name)
    facts = verdict(engine, relatives=False)
    sums = total(balance(engine, speed=engine.speed))
    for quantity in ("force", "couple"):
        (sentence,) = [fact.sentence for fact in facts if fact.about == quantity]
        spectrum = getattr(sums, quantity)
        scale, _units = scales(engine, engine.speed)
        unit = getattr(scale, quantity) / getattr(scales(engine, None)[0], quantity)
        words = {"Primary": "1", "Secondary": "2"}
        named = re.findall(
            rf"(Primary|Secondary) {quantity}: ([\d.e-]*\d)|[Oo]rder (\d+(?:\.\d+)?): ([\d.e-]*\d)",
            sentence,
        )
        told = {
            float(words.get(word) or order): float(size or other)
            for word, size, order, other in named
        }
        for order, size in told.items():
            one = spectra.selected(spectrum, [order])
            assert abs(complex(one.forward[0])) + abs(complex(one.backward[0])) == pytest.approx(
                size, rel=1e-4
            )
        none = [float(place) for place in (1, 2) if float(place) not in told]
        if sentence.startswith(f"No {quantity} of any order"):
            none = [1.0, 2.0, 4.0, 6.0]
        for order in none:
            one = spectra.selected(spectrum, [order])
            size = abs(complex(one.forward[0])) + abs(complex(one.backward[0]))
            assert size < 1e-8 * len(engine.cylinders) * unit


@pytest.mark.parametrize("name", BEARINGS)
def test_main_bearings_are_counted_as_engines_have_them(name: str) -> None:
    engine = load(name)
    assert len(main_bearings(engine, engine.shafts[0])) == BEARINGS[name]
    assert f"{BEARINGS[name]} main bearings" in verdict(engine, relatives=False)[0].sentence


@pytest.mark.parametrize(
    "name", ["i4", "gm-3800", "radial-9", "napier-deltic", "kr250-racer", "single"]
)
def test_every_need_has_its_cure(name: str) -> None:
    engine = load(name)
    cures = " ".join(
        fact.sentence for fact in verdict(engine, relatives=False) if fact.about == "cure"
    )
    for need in needs(engine):
        names = {1: "Primary", 2: "Secondary"}
        assert names.get(int(abs(need.ratio)), f"order {abs(need.ratio)}") in cures
        crank = next(
            (shaft for shaft in engine.shafts if shaft.throws and shaft.speed_ratio == need.ratio),
            None,
        )
        if crank is None:
            assert re.search(
                (
                    rf"(shaft at|and) {need.ratio} times|at {abs(need.ratio)} and "
                    rf"-{abs(need.ratio)} times"
                ),
                cures,
            )


def test_half_the_mass_leaves_what_the_sentence_says() -> None:
    told = {
        "harley-45": "a primary force of 0.70711 m r ω², rotating against the crankshaft",
        "gm-3800": "a primary couple of 0.44829 m r ω² a, rotating against the crankshaft",
        "v2-90": "leave no primary force or couple",
    }
    for name, words in told.items():
        assert any(words in fact.sentence for fact in verdict(load(name), relatives=False))


@pytest.mark.parametrize("pitch", ["20 mm", "110 mm"])
def test_couples_of_neighbours_are_compared_in_one_length(pitch: str) -> None:
    """Two cylinders on one pin have any bore pitch, so it must not tell engines apart."""
    sizes = {
        "cylinder.stroke": "69 mm",
        "cylinder.reciprocating_mass": "560 g",
        "layout.bore_pitch": pitch,
    }
    same = load("ducati-90", changes={**sizes, "layout.bank_offset": "24 mm", "name": "mine"})
    told = [fact.sentence for fact in verdict(same) if fact.about == "relatives"]
    assert "ducati-90" in told[0]
    assert told[0].startswith("Same balance")


def test_neighbours_are_of_the_same_kind_and_nearest_first() -> None:
    sentences = [
        fact.sentence for fact in verdict(load("v8-cross-plane")) if fact.about == "relatives"
    ]
    assert "bmw-s65" in sentences[0]
    assert sentences[0].startswith("Same balance")
    assert any(re.search(r"v8-flat-plane.* primary couple 3\.162", text) for text in sentences)
    own = piston_balance(load("v8-cross-plane"))
    for sentence in sentences[1:]:
        name = re.search(r"with ([\w-]+)", sentence).group(1)  # pyright: ignore[reportOptionalMemberAccess]
        assert load(name).cycle == "four-stroke"
        assert len(load(name).chambers) == 8
        assert np.abs(np.subtract(own, piston_balance(load(name)))).max() > 0.01


def test_rods_as_bodies_do_not_change_the_balance_of_the_pistons() -> None:
    twin = load("i2-270")
    length = twin.cylinders[0].rod_length
    body = Rod(mass=1.0, centre=0.3 * length, inertia=2.0)  # 0.3 of it goes up and down
    cylinders = tuple(
        with_values(cylinder, reciprocating_mass=0.7, rod=body) for cylinder in twin.cylinders
    )
    made = with_values(twin, name="with rods", cylinders=cylinders)
    assert piston_balance(made) == pytest.approx(piston_balance(twin), abs=1e-9)
    assert any("i2-270" in fact.sentence for fact in verdict(made) if "Same" in fact.sentence)


def test_an_engine_alone_in_the_catalog_says_so() -> None:
    assert (
        verdict(load("napier-deltic"))[-1].sentence
        == "The catalog has no other two-stroke engine with 18 cylinders."
    )


BURBLE = (
    "Uneven exhaust pulses, the burble of a cross-plane V8: bank odd, cylinders 5 and 7, "
    "90 deg apart "
    "(270-180-90-180); bank even, cylinders 8 and 4, 90 deg apart (90-180-270-180). "
    "Exhaust of each bank: orders 0.5, 1.5, 2.5, 3.5 beside 4."
)


def told(name: str) -> list[str]:
    return [
        fact.sentence for fact in verdict(load(name), relatives=False) if fact.about == "firing"
    ]


@pytest.mark.parametrize(
    ("name", "sentences"),
    [
        (
            "v8-cross-plane",
            [BURBLE, "Neighbours 5-7 and partners on a pin 4-3, 6-5, 2-1 fire in succession."],
        ),
        ("i4", ["Neighbours 3-4, 2-1 fire in succession."]),
        ("i6", ["No neighbours fire in succession."]),
        (
            "merlin",
            [
                "Each bank exhausts evenly, every 120 deg.",
                "No neighbours or partners on a pin fire in succession.",
            ],
        ),
        ("radial-9", []),
        ("triple-120", []),
        ("napier-lion", []),
    ],
)
def test_the_verdict_on_exhaust_pulses_and_on_who_fires_after_whom(
    name: str, sentences: list[str]
) -> None:
    assert told(name) == sentences


@EVERY_ENGINE
def test_only_cross_plane_eights_burble_and_the_verdict_on_firing_is_short(name: str) -> None:
    sentences = told(name)
    eights = {
        "v8-cross-plane",
        "bmw-s65",
        "ford-coyote",
        "ford-46-sohc",
        "gm-l76",
        "porsche-cayenne-48",
        "toyota-1uz-fe",
        "cadillac-ld8",
        "rover-v8-39",
    }
    assert any("burble" in sentence for sentence in sentences) == (name in eights)
    assert len(sentences) <= 2
    assert all(len(sentence) < 240 for sentence in sentences)


def test_manifolds_that_join_the_right_cylinders_end_the_burble() -> None:
    joined = load("v8-cross-plane", changes={"valves.manifolds": [[1, 4, 6, 7], [8, 3, 5, 2]]})
    sentences = [
        fact.sentence for fact in verdict(joined, relatives=False) if fact.about == "firing"
    ]
    assert sentences[0] == "Each manifold exhausts evenly, every 180 deg."


def test_crankshafts_of_different_speed_have_no_verdict_on_their_strokes() -> None:
    first, second = (Bank(cylinders=own) for own in ((1, 2), (3, 4)))
    slow = Crank(banks=(second,), throws=(0.0, 1.0), right=3.0, speed_ratio=Fraction(1, 2), lag=0.5)
    cranks = (Crank(banks=(first,), throws=(0.0, 1.0)), slow)
    engine = tandem(Basis(name="x", firing_order=(1, 3, 2, 4)), cranks=cranks)
    assert [fact.about for fact in verdict(engine, relatives=False)][:3] == [
        "layout",
        "units",
        "force",
    ]


def test_the_verdict_is_in_newtons_at_the_speed_of_the_file_or_the_one_asked_for() -> None:
    engine = load("subaru-ej25")
    assert engine.speed is not None
    own = {fact.about: fact.sentence for fact in verdict(engine, relatives=False)}
    assert own["units"] == f"Forces and moments at {number(engine.speed * 30 / np.pi)} rpm."
    for share in (1.0, 0.5):
        speed = share * engine.speed
        sums = total(balance(engine, speed=speed))
        couple = spectra.selected(sums.couple, [2.0])
        size = float((np.abs(couple.forward) + np.abs(couple.backward))[0])
        given = None if share == 1 else speed
        facts = verdict(engine, speed=given, relatives=False)
        (sentence,) = [fact.sentence for fact in facts if fact.about == "couple"]
        assert f"Secondary couple: {number(size)} N m, horizontal." in sentence


def test_a_cure_that_is_to_take_weights_off_names_no_balance_factor() -> None:
    cures = [fact.sentence for fact in verdict(load("kr250-racer"), relatives=False)]
    assert "Without its counterweights the engine has no primary force or couple." in cures
    assert not any("balance factor" in sentence for sentence in cures)
