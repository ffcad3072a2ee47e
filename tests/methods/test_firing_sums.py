"""Which orders of gas torque remain: exactly, as a sum of vectors, and as torque is computed."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

import crankstar
from crankstar import spectra
from crankstar.derive.algebra import radicals, typeset
from crankstar.derive.algebra.evaluation import value
from crankstar.derive.firing_sums import factor, gas_orders, places_of
from crankstar.derive.records import DerivationError
from crankstar.derive.twist_sums import twist_orders
from crankstar.engine.engine import Engine
from crankstar.firing.intervals import firing
from crankstar.firing.weighing import WeighingError, sums_of, twist_shape
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import gas_torque

SIZES = {"cylinder.bore": "80 mm", "cylinder.stroke": "80 mm"}
ENGINES = {
    "single": SIZES,
    "i2-360": SIZES,
    "i2-270": SIZES,
    "harley-45": SIZES,
    "ducati-900ss": {},
    "triple-120": SIZES,
    "honda-b18c": {},
    "yamaha-r1-crossplane": {},
    "bmw-m52b28": {},
    "gm-3800": {},
    "bmw-s65": {},
    "ferrari-f136": {},
    "merlin": {},
    "kr250-production": {},
    "man-s90mc-c": {},
}


def loaded(name: str) -> Engine:
    return crankstar.load(name, changes=ENGINES.get(name) or None)


def computed(engine: Engine, off: tuple[int, ...] = ()) -> tuple[dict[float, complex], ...]:
    """Amplitudes by order: of the engine, of a cylinder that fires, of one that does not."""
    found = gas_torque(cycle(engine, imep=9e5, speed=300.0, off=off))
    fires = cycle(engine, imep=9e5, speed=300.0).volumes.fires
    waves = spectra.amplitude(found.torque) * np.exp(1j * np.outer(fires, found.torque.orders))
    whole = spectra.amplitude(found.total)
    silent = [found.numbers.index(number) for number in off]
    firing = next(row for row in range(len(found.numbers)) if row not in silent)
    orders = [float(order) for order in found.total.orders]
    rows = (whole, waves[firing], waves[silent[0]] if silent else waves[firing])
    return tuple(dict(zip(orders, map(complex, row), strict=True)) for row in rows)


@pytest.mark.parametrize("name", ENGINES)
def test_the_exact_factor_is_that_of_the_computed_torque(name: str) -> None:
    engine = loaded(name)
    whole, one, _ = computed(engine)
    places = places_of(engine)
    step = Fraction(1, 2) if engine.cycle == "four-stroke" else Fraction(1)
    for n in range(1, 17):
        exact = factor(places, step * n)
        order = float(step * n)
        if exact.zero:
            assert whole[order] == 0
        else:
            ratio = abs(whole[order]) / abs(one[order])
            assert ratio == pytest.approx(float(value(radicals.length(exact))), rel=1e-9)
            assert ratio == pytest.approx(abs(complex(exact)), rel=1e-9)


@pytest.mark.parametrize("name", ENGINES)
def test_even_firing_leaves_multiples_of_its_frequency_and_nothing_else(name: str) -> None:
    engine = loaded(name)
    places = places_of(engine)
    turns = 2 if engine.cycle == "four-stroke" else 1
    count = len(places)
    steps = sorted((place - places[engine.firing_order[0]]) % turns for place in places.values())
    even = steps == [Fraction(turns * n, count) for n in range(count)]
    assert even is (name not in {"i2-270", "harley-45", "ducati-900ss", "yamaha-r1-crossplane"})
    zeros = [factor(places, Fraction(n, turns)).zero for n in range(1, 4 * count + 1)]
    wanted = [n % count != 0 for n in range(1, 4 * count + 1)]
    assert (zeros == wanted) is even


def test_uneven_engines_have_the_factors_of_textbooks() -> None:
    def lengths(engine: Engine) -> list[str]:
        places = places_of(engine)
        orders = (Fraction(n, 2) for n in range(1, 9))
        return [typeset.text(radicals.length(factor(places, order))) for order in orders]

    quarter = ["√(2 − √2)", "√2", "√(2 + √2)", "0", "√(2 + √2)", "√2", "√(2 − √2)", "2"]
    assert lengths(loaded("ducati-900ss")) == quarter  # 270 and 450 deg
    assert lengths(loaded("i2-270")) == quarter
    crossplane = ["√(4 − 2√2)", "0", "√(4 + 2√2)", "0", "√(4 + 2√2)", "0", "√(4 − 2√2)", "4"]
    assert lengths(loaded("yamaha-r1-crossplane")) == crossplane
    # 315 and 405 deg: 2 cos(k 315/2 deg)
    harley = places_of(loaded("harley-45"))
    for n in range(1, 9):
        wanted = abs(2 * np.cos(n / 2 * np.radians(315) / 2))
        assert abs(complex(factor(harley, Fraction(n, 2)))) == pytest.approx(wanted)


def test_the_uneven_six_has_order_one_and_a_half() -> None:
    # 90 deg V6 on three common pins: 90 and 150 deg in turn
    angles = (0, 90, 240, 330, 480, 570)
    places = {number: Fraction(angle, 360) for number, angle in enumerate(angles)}
    kept = [n for n in range(1, 16) if not factor(places, Fraction(n, 2)).zero]
    assert kept == [3, 6, 9, 15]
    sizes = [abs(complex(factor(places, Fraction(n, 2)))) for n in kept]
    wanted = [6 * abs(np.cos(n / 2 * np.radians(90) / 2)) for n in kept]
    assert sizes == pytest.approx(wanted)


def test_all_cylinders_at_once_have_every_order_of_one() -> None:
    places = {number: Fraction(0) for number in range(1, 5)}
    assert all(complex(factor(places, Fraction(n, 2))) == 4 for n in range(1, 9))


@pytest.mark.parametrize(("name", "off"), [("honda-b18c", (2,)), ("bmw-m52b28", (2, 5))])
def test_cylinders_that_are_off_bring_up_their_own_sum(name: str, off: tuple[int, ...]) -> None:
    engine = loaded(name)
    whole, one, idle = computed(engine, off)
    places = places_of(engine)
    for n in range(1, 13):
        order = Fraction(n, 2)
        lost = abs(complex(factor(places, order, off)))
        if factor(places, order).zero:
            wanted = lost * abs(one[float(order)] - idle[float(order)])
            scale = abs(one[0.5])
            assert abs(whole[float(order)]) == pytest.approx(wanted, rel=1e-9, abs=1e-9 * scale)


def test_two_cylinders_a_turn_apart_that_are_off_bring_up_no_half_order() -> None:
    places = places_of(loaded("bmw-m52b28"))
    zeros = [factor(places, Fraction(n, 2), (2, 5)).zero for n in range(1, 9)]
    assert zeros == [True, False] * 4


def test_chosen_orders_stand_alone() -> None:
    lines = gas_orders(loaded("honda-b18c"), [Fraction(1, 2), Fraction(2)]).steps[2].lines
    assert [typeset.text(line.chain[-1]) for line in lines] == ["0", "4"]
    with pytest.raises(DerivationError):
        gas_orders(loaded("kr250-production"), [Fraction(1, 2)])


@pytest.mark.parametrize("name", [each for each in ENGINES if each != "single"])
def test_the_exact_twist_is_the_sum_of_the_vectors_in_a_straight_shape(name: str) -> None:
    engine = loaded(name)
    if name in ("harley-45", "kr250-production"):
        with pytest.raises(WeighingError, match="one place"):
            twist_orders(engine)
        return
    lines = twist_orders(engine).steps[-1].lines
    orders = [float(Fraction(line.name.below)) for line in lines]  # pyright: ignore
    found = [value(line.chain[-1]) for line in lines]
    wanted = sums_of(firing(engine), twist_shape(engine), orders)
    assert found == pytest.approx(wanted, abs=1e-9)
    zeros = [typeset.text(line.chain[-1]) == "0" for line in lines]
    assert zeros == [each < 1e-9 for each in wanted]


def test_a_row_of_pistons_without_a_pitch_has_no_exact_twist() -> None:
    engine = crankstar.load(
        "i4", changes={"layout.positions": ["0 mm", "90 mm", "180.0333331 mm", "270 mm"]}
    )
    with pytest.raises(DerivationError, match="no fraction of the length"):
        twist_orders(engine)


def test_whole_orders_of_twist_are_sums_and_half_orders_differences() -> None:
    chapter = twist_orders(crankstar.load("bmw-m52b28"))
    lines = {str(line.label): value(line.chain[-1]) for line in chapter.steps[1].lines}
    assert lines["cylinders 1, 6, whole orders"] == 0
    assert lines["cylinders 1, 6, half orders"] == 2
    assert abs(lines["cylinders 5, 2, half orders"]) == pytest.approx(1.2)
