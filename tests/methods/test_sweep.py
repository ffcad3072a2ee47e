"""Sweeps: many engines as arrays against one at a time; known facts; numbers that cannot vary."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable
from dataclasses import replace
from math import cos, inf, nan, pi, radians, sin, sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.claims import CLAIMS
from tests.strategies import RELEASE, engines

import crankstar
from crankstar import files, spectra
from crankstar.engine.basis import Basis
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import inline
from crankstar.engine.motion import piston_harmonics
from crankstar.engine.records import Weight
from crankstar.files import EngineFileError
from crankstar.mechanics.balance import balance, default_reference, total
from crankstar.mechanics.batches import totals
from crankstar.mechanics.excitation import Reference, Totals, part_spectra
from crankstar.mechanics.excitation import total as summed
from crankstar.mechanics.mechanism import mechanism
from crankstar.remedy import RemedyError
from crankstar.spectra import Spectrum
from crankstar.studies.best_value import Best, best
from crankstar.studies.fields import Varied, source_of, subject
from crankstar.studies.ranges import over_request
from crankstar.studies.sweep import Sweep, swept, watched
from crankstar.studies.variants import FEW, SweepError, variants
from crankstar.tables.machine import csv_text
from crankstar.tables.sweeps import answer, sweep_document

A = np.real(piston_harmonics(crank_radius=1.0, rod_length=4.0))
POINT = Reference(0.03, -0.02, 0.05)
KR250 = CLAIMS["kr250"]


def of(name: str, text: str, **more: Any) -> Sweep:
    over = over_request(text)
    return swept(name, over=over.path, values=over.values, unit=over.unit, **more)


def best_of(
    name: str, text: str, what: str, order: float | None = None, *, greatest: bool = False
) -> Best:
    sweep = of(name, text)
    return best(sweep, watched(sweep, what, order=order), greatest=greatest)


# Peaks of a batch


@given(
    st.integers(0, 10_000),
    st.sampled_from([1, 2, 3]),
    st.sampled_from(["any", "circle", "line", "real"]),
    st.sampled_from([1, -1]),
)
def test_the_peaks_of_a_batch_are_those_of_its_vectors_one_by_one(
    seed: int, teeth: int, kind: str, sense: int
) -> None:
    rng = np.random.default_rng(seed)
    orders = np.sort(rng.choice(np.arange(1, 20), rng.integers(1, 7), replace=False)) / teeth
    shape = (4, orders.size)
    size = np.exp(-orders * rng.uniform(0, 1.5))
    forward, backward = (
        (rng.normal(size=shape) + 1j * rng.normal(size=shape)) * size for _ in range(2)
    )
    backward = {"any": backward, "circle": 0 * backward, "line": forward, "real": np.conj(forward)}[
        kind
    ]
    batch = Spectrum(orders, forward, backward, sense)
    found = spectra.peaks(batch)
    single = np.array([spectra.peak(batch[row]).value for row in range(4)])
    assert np.abs(found / single - 1).max() < 2e-9
    assert np.abs(
        spectra.peaks(
            replace(batch, forward=forward.reshape(2, 2, -1), backward=backward.reshape(2, 2, -1))
        )
    ).shape == (2, 2)
    assert spectra.peaks(batch[2]) == pytest.approx(found[2], rel=1e-14)


def test_peaks_of_a_cosine_with_another_of_twice_its_speed_beside_it_or_square_to_it() -> None:
    """cos theta - b cos 2 theta has its greatest magnitude, 1 + b, at 180 deg.

    With b cos 2 theta at right angles to cos theta the peak is sqrt(1 + b^2).
    """
    second = np.linspace(0.0, 0.6, 1201)
    pair = np.stack([np.full_like(second, 0.5), -second / 2], axis=-1) + 0j
    assert (
        np.abs(spectra.peaks(Spectrum(np.array([1.0, 2.0]), pair, pair)) - (1 + second)).max()
        < 1e-12
    )
    square = pair * [1, 1j]
    assert (
        np.abs(
            spectra.peaks(Spectrum(np.array([1.0, 2.0]), square, square)) - np.hypot(1, second)
        ).max()
        < 1e-12
    )


def test_a_flat_summit_and_the_two_it_parts_into_are_found() -> None:
    """sin theta + b sin 3 theta.

    1 - b at 90 deg up to b = 1/9, then two summits (2/3)(1 + 3 b) s with s^2 = (1 + 3 b)/(12 b).
    """
    third = np.concatenate([np.linspace(0.0, 0.3, 601), 1 / 9 + np.geomspace(1e-9, 1e-2, 200)])
    waves = spectra.real_signal(
        np.array([1.0, 3.0]), np.stack([np.full_like(third, -1j, complex), -1j * third], axis=-1)
    )
    rate = 1 + 3 * third
    with np.errstate(divide="ignore"):
        summits = np.where(third > 1 / 9, 2 / 3 * rate * np.sqrt(rate / (12 * third)), 1 - third)
    assert spectra.peaks(waves) == pytest.approx(summits, rel=1e-12)


@pytest.mark.release
def test_of_two_summits_beside_a_sample_in_the_hollow_between_them_the_higher_one_is_found() -> (
    None
):
    """cos theta + cos 3 theta / 3 raises one of the two and leaves the hollow at 90 deg alone."""
    theta = pi / 2 + np.linspace(-0.1, 0.1, 400_001)
    for lean in (-0.005, 0.005):
        both = np.array([-1j + lean, -0.1112j + lean / 3])
        brute = np.real(np.exp(1j * np.outer(theta, [1, 3])) @ both).max()
        assert spectra.peaks(spectra.real_signal(np.array([1.0, 3.0]), both)) == pytest.approx(
            brute, rel=1e-11
        )


def test_peaks_of_nothing() -> None:
    none = np.zeros((3, 2), complex)
    assert spectra.peaks(Spectrum(np.array([1.0, 2.0]), none, none)).tolist() == [0.0] * 3
    assert spectra.peaks(Spectrum(np.zeros(0), none[:, :0], none[:, :0])).tolist() == [0.0] * 3
    assert spectra.peaks(Spectrum(np.array([1.0, 2.0]), none[:0], none[:0])).shape == (0,)


# Many engines as arrays against one after the other

FIELDS = [
    ("v8-cross-plane", "layout.banks[1].bearing", "deg", 0, 90, True),
    ("v8-cross-plane", "balance_factor", None, 0, 1, True),
    ("v8-cross-plane", "layout.throws[2]", "deg", -720, 720, True),
    ("v8-cross-plane", "layout.pin_split", "deg", -40, 40, True),
    ("v8-cross-plane", "layout.bank_offset", "", -1, 1, True),
    ("v8-cross-plane", "layout.bore_pitch", "mm", 90, 110, True),
    ("v8-cross-plane", "cylinder.rotating_mass", "", 0, 2, True),
    ("v8-cross-plane", "cylinder.rod_ratio", "", 1.5, 6, True),
    ("v8-cross-plane", "cylinder.offset", "", -0.3, 0.3, False),
    ("v8-cross-plane", "shaft[1].throw[2].angle", "deg", 0, 360, True),
    ("v8-cross-plane", "shaft[1].throw[2].radius", "", 0.5, 1.5, True),
    ("v8-cross-plane", "cylinders[3].z", "", -1, 1, True),
    ("v8-cross-plane", "cylinders[3].reciprocating_mass", "", 0.5, 2, True),
    ("bmw-s65", "cylinder.stroke", "mm", 60, 90, True),
    ("bmw-s65", "cylinder.rod_length", "mm", 120, 160, True),
    ("vw-vr6", "cylinder.rod_length", "mm", 160, 180, False),
    ("kr250-racer", "layout.cranks[2].lag", "deg", 0, 720, True),
    ("kr250-racer", "layout.cranks[2].right", "mm", -90, 90, True),
    ("kr250-racer", "balance_factor", "", 0.3, 1.2, True),
    ("kr250-racer", "layout.cranks[1].banks[1].bearing", "deg", -90, 90, True),
    ("napier-deltic", "balance_factor", "", 0, 1.5, True),
    ("napier-deltic", "shaft[2].throw[1].angle", "deg", 0, 360, True),
    ("napier-deltic", "shaft[2].up", None, -2, 2, True),
    ("jumo-205", "layout.lag", "deg", -20, 20, True),
    ("jumo-205", "layout.bearing", "deg", -60, 60, False),
    ("radial-9", "layout.knuckle_radius", "", 0.3, 0.6, False),
    ("radial-9", "balance_factor", "", 0, 1, True),
    ("parallel-twin-180", "layout.throws[2]", "deg", 0, 360, True),
    ("audi-25-tfsi", "shaft[1].throw[2].angle", "deg", 0, 360, True),
    ("audi-25-tfsi", "layout.bearing", "deg", 0, 360, True),
    ("gm-3800", "layout.pin_split", "deg", 0, 60, True),
]


def assert_as_alone(sums: Totals, engine: Engine, point: Reference, row: int) -> None:
    alone = summed(part_spectra(mechanism(engine), reference=point))
    parts = part_spectra(mechanism(engine), reference=point)
    for many, one, pushed in zip(sums, alone, parts, strict=True):
        orders = np.union1d(many.orders, one.orders)
        batch, single = spectra.selected(many[row], orders), spectra.selected(one, orders)
        scale = float(
            (np.abs(pushed.forward) + np.abs(pushed.backward)).sum(axis=-2).max(initial=1e-300)
        )
        assert np.abs(batch.forward - single.forward).max() <= 3e-12 * scale
        assert np.abs(batch.backward - single.backward).max() <= 3e-12 * scale


def assert_one_by_one(
    make: Callable[[float], Engine],
    numbers: np.ndarray,
    *,
    lawful: bool | None,
    point: Reference = POINT,
) -> None:
    calls: list[float] = []

    def counted(number: float) -> Engine:
        calls.append(number)
        return make(number)

    batches = variants(counted, numbers)
    assert sorted(np.concatenate([batch.rows for batch in batches]).tolist()) == list(
        range(numbers.size)
    )
    if lawful is not None:
        assert (len(calls) < numbers.size) == lawful
    for batch in batches:
        orders = part_spectra(batch.machine).force.orders.tolist()
        sums = totals(batch.machine, orders=orders, reference=point, block=7)
        for row, place in enumerate(batch.rows):
            assert_as_alone(sums, make(float(numbers[place])), point, row)


@pytest.mark.release
@pytest.mark.parametrize(("name", "path", "unit", "low", "high", "lawful"), FIELDS, ids=str)
def test_a_sweep_is_as_its_engines_one_by_one(
    name: str, path: str, unit: str | None, low: float, high: float, lawful: bool
) -> None:
    numbers = np.concatenate(
        [
            np.linspace(low, high, 21),
            [low + 0.123 * (high - low)] * 2,
            [low],
            np.linspace(high, low, 5),
        ]
    )
    make = subject(source_of(name), [Varied(path, unit)]).make
    assert_one_by_one(make, numbers, lawful=lawful)


@pytest.mark.release
@given(engines(tight=False), st.integers(0, 10_000), st.floats(0.01, 2.0))
@settings(max_examples=100 if RELEASE else 8, deadline=None)
def test_any_number_of_any_engine_as_one_by_one(engine: Engine, pick: int, span: float) -> None:
    tree = files.explicit(engine.model_copy(update={"firing_order": (), "firing_angles": None}))
    places: list[tuple[str, float]] = []
    for i, shaft in enumerate(engine.shafts, 1):
        places += [
            (f"shaft[{i}].throw[{k}].{key}", getattr(t, key))
            for k, t in enumerate(shaft.throws, 1)
            for key in ("angle", "z")
        ]
        places += [
            (f"shaft[{i}].weight[{k}].angle", weight.angle)
            for k, weight in enumerate(shaft.weights, 1)
        ]
        places += [
            (f"shaft[{i}].weight[{k}].unbalance", weight.unbalance + span)
            for k, weight in enumerate(shaft.weights, 1)
        ]
        places += [(f"shaft[{i}].{key}", getattr(shaft, key)) for key in ("up", "right") if i > 1]
    for k, cylinder in enumerate(engine.cylinders, 1):
        places += [
            (f"cylinders[{k}].z", cylinder.z),
            (f"cylinders[{k}].rod_length", cylinder.rod_length + span),
        ]
        places += [(f"cylinders[{k}].reciprocating_mass", cylinder.reciprocating_mass + span)]
        places += (
            [(f"cylinders[{k}].bearing", cylinder.bearing)]
            if engine.cylinders[k - 1].articulated is None
            else []
        )
    path, value = places[pick % len(places)]
    make = lambda number: files.engine_of(tree, changes={path: number})  # noqa: E731
    try:
        for number in np.linspace(value - span, value + span, 17):
            make(float(number))
    except EngineFileError:
        return
    assert_one_by_one(make, np.linspace(value - span, value + span, 17), lawful=None)


TWIN = inline(Basis(name="twin"), throws=(0.0, pi))


def weighted(unbalance: float, angle: float = 0.0, **shaft: Any) -> Engine:
    own = TWIN.shafts[0].model_copy(
        update={"weights": (Weight(unbalance=unbalance, angle=angle, z=0.2),), **shaft}
    )
    return TWIN.model_copy(update={"shafts": (own,)})


LATE = "a bend after the last probe"
CROOKED: dict[str, Callable[[float], Engine]] = {
    "a bend": lambda x: weighted(max(x, 0.31)),
    "a bend next to the end": lambda x: weighted(max(x, 0.97) if x < 0.999 else x),
    "a step": lambda x: weighted(1.0 if x < 0.7 else 1.1),
    "a parabola": lambda x: weighted(1 + 1e-9 * x**2),
    "an angle that bends": lambda x: weighted(1.0, angle=min(x, 0.5)),
    "a size and an angle": lambda x: weighted(1 + x, angle=x),
    "turns": lambda x: weighted(1.0, angle=(300.0 * x) % (2 * pi)),
    "a weight that changes sides": lambda x: weighted(
        abs(x - 0.4), angle=1.0 if x >= 0.4 else 1.0 - pi
    ),
    "a weight that comes": lambda x: weighted(x) if x > 0.5 else TWIN,
    LATE: lambda x: weighted(max(x, 3 * x - 1.9992)),
    "another last one": lambda x: weighted(x) if x < 1 else TWIN,
    "another nought": lambda x: weighted(1.0 + x) if x else TWIN,
    "nothing": lambda x: weighted(1.0),  # noqa: ARG005
}
LAWFUL = {"turns", "a weight that changes sides", "another last one", "another nought", "nothing"}


@pytest.mark.many(first=6)
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.release] * (name == LATE)) for name in CROOKED]
)
def test_no_law_is_seen_where_there_is_none(name: str) -> None:
    count = 4001 if name == LATE else 41
    assert_one_by_one(
        CROOKED[name],
        np.linspace(-1 if name == "another nought" else 0, 1, count),
        lawful=name in LAWFUL,
    )


def test_an_engine_of_its_own_stands_apart_and_the_others_stay_by_the_law() -> None:
    assert [
        batch.rows.size for batch in variants(CROOKED["another last one"], np.linspace(0, 1, 41))
    ] == [40, 1]
    assert [
        batch.rows.tolist() for batch in variants(CROOKED["another nought"], np.linspace(-1, 1, 41))
    ][1:] == [[20]]
    assert [
        batch.rows.size for batch in variants(CROOKED["a weight that comes"], np.linspace(0, 1, 41))
    ] == [21, 20]


def test_what_stays_the_same_needs_no_axis_so_that_motion_is_worked_out_once() -> None:
    (batch,) = variants(weighted, np.linspace(0.1, 1, 50))
    assert batch.machine.unbalance.shape == (50, 3)
    assert all(
        v.ndim == 1
        for m in (batch.machine, batch.machine.links)
        for k, v in vars(m).items()
        if isinstance(v, np.ndarray) and k != "unbalance"
    )
    (batch,) = variants(CROOKED["nothing"], np.linspace(0, 1, 50))
    assert totals(batch.machine, orders=(1.0,)).force.forward.shape == (50, 1)


def test_progress_is_told_where_engines_are_built_one_by_one() -> None:
    told: list[tuple[int, int]] = []
    variants(
        CROOKED["a parabola"], np.linspace(0, 1, 30), tell=lambda done, of: told.append((done, of))
    )
    assert told == [(k, 30) for k in range(1, 31)]
    told.clear()
    variants(CROOKED["turns"], np.linspace(0, 1, 30), tell=lambda done, of: told.append((done, of)))
    assert told == []
    with pytest.raises(SweepError, match="give fewer values"):
        variants(CROOKED["a parabola"], np.linspace(0, 1, 10_001))


def test_what_is_wrong_at_an_end_or_anywhere_is_said_as_the_engine_says_it() -> None:
    with pytest.raises(
        EngineFileError,
        match=r"v8-cross-plane with cylinder.rod_ratio = 0.5: 1 mistake\n.*greater than 1",
    ):
        of("v8-cross-plane", "cylinder.rod_ratio=4..0.5")
    with pytest.raises(EngineFileError, match="speed_ratio = 0: 1 mistake"):
        of("kr250-racer", "layout.cranks[2].speed_ratio=-1..1/21")
    with pytest.raises(EngineFileError, match="too short"):
        of("radial-9", "layout.knuckle_radius=0.3..3.2/20")


@pytest.mark.release
def test_a_slave_rod_that_cannot_reach_in_the_middle_of_the_range_is_found() -> None:
    """The rod is too short where its knuckle pin, on the master's big end, is far away."""
    tree = files.explicit(crankstar.load("radial-9").model_copy(update={"firing_order": ()}))
    link = crankstar.load("radial-9").cylinders[1].articulated
    assert link is not None

    def make(angle: float) -> Engine:
        return files.engine_of(
            tree,
            changes={
                "cylinders[2].articulated.angle": f"{angle} rad",
                "cylinders[2].rod_length": 1.8,
            },
        )

    around = link.angle + np.arange(28) * (2 * pi / 40)
    for angle in np.delete(around, 11):
        make(float(angle))
    with pytest.raises(EngineFileError, match="too short"):
        variants(make, around)


@pytest.mark.release
def test_gear_ratios_are_swept_in_groups() -> None:
    sweep = swept("kr250-racer", over="layout.cranks[2].speed_ratio", values=[-1, 1, 2, 0.5, 1])
    assert [group.rows.tolist() for group in sweep.groups] == [[0, 1, 4], [2], [3]]
    curve = watched(sweep, "force")
    for row, ratio in enumerate(("-1", "1", "2", "1/2", "1")):
        engine = crankstar.load("kr250-racer", changes={"layout.cranks[2].speed_ratio": ratio})
        alone = total(balance(engine))
        assert curve.values[row] == pytest.approx(spectra.peak(alone.force).value, rel=1e-8)
        joined = spectra.selected(sweep.sums.force[row], alone.force.orders)
        assert np.abs(joined.forward - alone.force.forward).max() < 1e-13
    assert best(sweep, curve).value == 1.0  # found among them, though nothing between them can be


# What sweeps must find


@pytest.mark.release
def test_a_single_is_best_with_half_balance_and_then_it_is_a_pure_backward_circle() -> None:
    found = best_of("single", "balance_factor=0..1", "force", 1)
    assert (found.value, found.result) == (
        pytest.approx(0.5, abs=1e-6),
        pytest.approx(0.5, abs=1e-6),
    )
    assert not found.at_edge
    assert not found.flat
    assert found.also == ()
    sweep = of("single", "balance_factor=0..1/3")
    assert watched(sweep, "force.forward", order=1).values == pytest.approx(
        [0.5, 0, 0.5], abs=1e-12
    )
    assert watched(sweep, "force.backward", order=1).values == pytest.approx([0.5] * 3, abs=1e-12)


@pytest.mark.release
def test_a_45_degree_twin_is_a_pure_backward_circle_of_cos_45_at_a_half() -> None:
    found = best_of("harley-45", "balance_factor=0..1/8", "force", 1)  # 0.5 is not among the eight
    assert (found.value, found.result) == (
        pytest.approx(0.5, abs=1e-6),
        pytest.approx(cos(pi / 4), abs=1e-6),
    )
    assert best_of("harley-45", "balance_factor=0..1/8", "force.forward", 1).value == pytest.approx(
        0.5, abs=1e-6
    )


@pytest.mark.release
def test_a_90_degree_twin_has_no_first_order_at_a_half() -> None:
    found = best_of("v2-90", "balance_factor=0..1/8", "force", 1)
    assert (found.value, found.result) == (pytest.approx(0.5, abs=1e-6), pytest.approx(0, abs=1e-6))


@pytest.mark.release
def test_90_degrees_is_the_bank_angle_at_which_half_balance_leaves_a_twin_no_first_order() -> None:
    sweep = of(
        "v2-90",
        "layout.banks[2].bearing=-45..135/98 deg",
        changes={"balance_factor": 0.5, "layout.banks[1].bearing": "0 deg"},
    )
    found = best(sweep, watched(sweep, "force", order=1))
    assert (found.value, found.result) == (pytest.approx(90, abs=1e-4), pytest.approx(0, abs=1e-6))


@pytest.mark.release
def test_a_parallel_twin_over_its_crank_phase() -> None:
    text = "layout.throws[2]=0..360/100 deg"
    force = of("i2-360", text)
    phase = np.radians(force.values)
    assert watched(force, "force", order=1).values == pytest.approx(
        np.abs(2 * np.cos(phase / 2)), abs=1e-12
    )
    assert watched(force, "force", order=2).values == pytest.approx(
        np.abs(2 * A[2] * np.cos(phase)), abs=1e-12
    )
    assert watched(force, "couple", order=1).values == pytest.approx(
        np.abs(np.sin(phase / 2)), abs=1e-12
    )
    found = best_of("i2-360", text, "force", 1)
    assert (found.value, found.result) == (pytest.approx(180, abs=1e-4), pytest.approx(0, abs=1e-6))
    second = best_of("i2-360", text, "force", 2)
    assert {round(x, 3) for x in (second.value, *second.also)} == {90.0, 270.0}
    none = best_of("i2-360", text, "couple", 1)
    assert (none.value, none.also, none.at_edge) == (0.0, (), False)  # 360 deg is the same
    greatest = best_of("i2-360", text, "couple", 1, greatest=True)
    assert (greatest.value, greatest.result) == (
        pytest.approx(180, abs=1e-3),
        pytest.approx(1.0, abs=1e-9),
    )


def test_a_90_degree_v6_is_left_a_pure_backward_couple_with_30_degree_split_pins() -> None:
    """Split by 30 deg for even firing.

    Counterweights, which take the forward one, leave sqrt(3) sin 15 deg = 0.4483 m r w^2 a.
    """
    sweep = of("gm-3800", "layout.pin_split=0..60/61 deg")
    backward = watched(sweep, "couple.backward", order=1).values
    assert backward[30] == pytest.approx(sqrt(3) * sin(radians(15)), abs=1e-9)
    assert backward == pytest.approx(
        sqrt(3) * np.abs(np.sin(np.radians(sweep.values) / 2)), abs=1e-9
    )


@pytest.mark.many(first=2)
@pytest.mark.parametrize("factor", [0.5, 0.75])
@pytest.mark.parametrize("phase", [0, 180])
def test_the_kr250_over_the_lag_of_its_rear_crank_passes_through_the_rows_of_the_essay(
    phase: int, factor: float
) -> None:
    row = next(
        r
        for r in KR250["rows"]
        if (r["rotation"], r["phase_deg"], r["factor"]) == ("contra", phase, factor)
    )
    sweep = of(
        "kr250-racer",
        "layout.cranks[2].lag=0..360/101 deg",
        changes={"balance_factor": factor},
        orders=[1, 2],
    )
    place = int(np.argmin(np.abs(sweep.values - phase)))
    share = np.array([1.0, KR250["A2"] / A[2]])  # the essay's A2 is 1/4
    force = spectra.scaled(sweep.sums.force[place], share)
    for angle, up in row["up"].items():
        vector = complex(spectra.value(force, radians(float(angle))))
        assert vector.real == pytest.approx(up, abs=1e-9)
        assert abs(vector.imag) == pytest.approx(row["right_magnitude"][angle], abs=1e-9)


def test_the_kr250_at_half_balance_shakes_as_much_in_first_order_at_any_lag() -> None:
    found = best_of("kr250-racer", "layout.cranks[2].lag=0..360 deg", "force", 1)
    assert found.flat
    assert not found.at_edge
    assert found.stretch == (0.0, 360.0)
    assert found.result == pytest.approx(1.0, abs=1e-12)


@pytest.mark.release
def test_explicit_paths_work_on_short_files_and_give_the_same() -> None:
    short = of("v8-cross-plane", "layout.throws[2]=0..360/50 deg")
    explicit = of(
        "v8-cross-plane", "shaft[1].throw[2].angle=45..405/50 deg"
    )  # pin 1 stands at 45 deg
    for what in ("force", "couple", "torque"):
        assert watched(short, what).values == pytest.approx(
            watched(explicit, what).values, abs=1e-11
        )


def test_the_balance_factor_of_an_explicit_engine(tmp_path: Path) -> None:
    path = tmp_path / "twin.toml"
    path.write_text(files.toml(crankstar.load("harley-45")), encoding="utf-8")
    explicit = watched(of(str(path), "balance_factor=0..1/30"), "force")
    assert explicit.values == pytest.approx(
        watched(of("harley-45", "balance_factor=0..1/30"), "force").values, abs=1e-12
    )
    with pytest.raises(RemedyError, match="from -1 to 3"):
        of(str(path), "balance_factor=0..4")


def test_a_firing_order_does_not_stand_in_the_way_and_throws_may_follow_from_it() -> None:
    with pytest.raises(EngineFileError):
        crankstar.load("v8-cross-plane", changes={"layout.throws[2]": "0 deg"})
    assert of("v8-cross-plane", "layout.throws[2]=0..90/3 deg").engine.firing_order == ()
    assert len(of("audi-25-tfsi", "layout.bearing=0..90/3 deg").engine.shafts[0].throws) == 5


@pytest.mark.release
def test_units_and_reference_are_those_of_the_file_for_all_values() -> None:
    mass = {"cylinder.reciprocating_mass": "500 g"}
    base = crankstar.load("bmw-s65", changes=mass)
    sweep = of("bmw-s65", "cylinder.stroke=60..90/31 mm", speed=500.0, changes=mass)
    assert (sweep.units.force, sweep.speed, sweep.unit) == ("N", 500.0, "mm")
    for row in (0, 13, 30):
        engine = crankstar.load(
            "bmw-s65", changes={"cylinder.stroke": f"{sweep.values[row]} mm", **mass}
        )
        alone = total(balance(engine, speed=500.0))
        assert watched(sweep, "force").values[row] == pytest.approx(
            spectra.peak(alone.force).value, rel=1e-8
        )
    plain = of("bmw-s65", "cylinder.stroke=60..90/31 mm", changes=mass)
    unit = base.first.reciprocating_mass * base.throw(base.first).radius
    assert watched(plain, "force").values * unit * 500.0**2 == pytest.approx(
        watched(sweep, "force").values, rel=1e-12
    )
    moved = of("bmw-s65", "shaft[1].throw[1].angle=0..90/20 deg")
    assert moved.reference == default_reference(base)
    pulled = of("v8-cross-plane", "cylinders[3].z=-9..9/20")
    assert pulled.reference == default_reference(crankstar.load("v8-cross-plane"))
    assert (plain.unit, of("single", "balance_factor=0..1").unit) == ("mm", "")
    assert swept("v2-90", over="layout.banks[1].bearing", values=[0, 1]).unit == "rad"


def test_a_number_that_makes_lengths_known_is_counted_in_them() -> None:
    sweep = of("single", "cylinder.stroke=80..90/21 mm")
    assert sweep.engine.relative == ("mass",)
    assert watched(sweep, "force", order=1).values == pytest.approx(sweep.values / 80, rel=1e-12)


# What is watched


@pytest.mark.many(first=1)
@pytest.mark.parametrize(("what", "quantity", "part"), [
    ("force.up", "force", "vertical"), ("force.right", "force", "horizontal"),
    ("couple.up", "couple", "vertical"), ("couple.pitch", "couple", "vertical"),
    ("couple.yaw", "couple", "horizontal"),
])  # fmt: skip
def test_a_component_is_the_amplitude_of_that_component(
    what: str, quantity: str, part: str
) -> None:
    sweep = of("bmw-f800", "balance_factor=0..1/5", reference=Reference(0.1))
    for row in range(5):
        spectrum = getattr(sweep.sums, quantity)[row]
        for order in (1.0, 2.0):
            expected = abs(getattr(spectra, part)(spectra.selected(spectrum, order))[0])
            assert watched(sweep, what, order=order).values[row] == pytest.approx(
                expected, rel=1e-12, abs=1e-15
            )
        theta = np.linspace(0, 2 * pi, 20_001)
        vector = spectra.value(spectrum, theta)
        brute = np.abs(np.real(vector) if part == "vertical" else np.imag(vector)).max()
        assert watched(sweep, what).values[row] == pytest.approx(brute, rel=1e-6, abs=1e-12)


@pytest.mark.release
def test_greatest_of_an_order_and_of_all_orders_are_those_of_the_balance() -> None:
    sweep = of("v4-90", "layout.banks[1].bearing=-60..0/7 deg", reference=Reference(0.4, 0.1, 0.2))
    for row, bearing in enumerate(sweep.values):
        engine = crankstar.load(
            "v4-90", changes={"layout.banks[1].bearing": f"{bearing} deg", "firing_order": []}
        )
        alone = total(balance(engine, reference=Reference(0.4, 0.1, 0.2)))
        for what in Totals._fields:
            own = getattr(alone, what)
            assert watched(sweep, what).values[row] == pytest.approx(
                spectra.peak(own).value, rel=2e-9, abs=1e-12
            )
            second = spectra.selected(own, 2)
            path = spectra.ellipse(complex(second.forward[0]), complex(second.backward[0]))
            assert watched(sweep, what, order=2).values[row] == pytest.approx(
                path.semi_major, rel=1e-11, abs=1e-13
            )
    assert [watched(sweep, what).unit for what in ("force", "couple", "roll", "torque")] == [
        "m*r*w^2",
        "m*r*w^2*a",
        *["m*r^2*w^2"] * 2,
    ]
    assert watched(sweep, "force", order=2).label == "force of order 2"


def test_an_order_that_an_engine_does_not_have_is_nothing() -> None:
    assert (
        watched(of("single", "balance_factor=0..1/5"), "force", order=7.5).values.tolist()
        == [0.0] * 5
    )


# The best value


@pytest.mark.release
def test_the_best_value_at_an_end_of_the_range_is_said_to_be_there() -> None:
    found = best_of("single", "balance_factor=0..0.4/9", "force", 1)
    assert (found.value, found.at_edge) == (0.4, True)
    rods = best_of("i4", "cylinder.rod_ratio=2.5..6/20", "force", 2, greatest=True)
    assert (rods.value, rods.at_edge) == (2.5, True)
    assert rods.result == pytest.approx(
        4 * abs(piston_harmonics(crank_radius=1, rod_length=2.5)[2]), rel=1e-12
    )


@pytest.mark.release
def test_between_two_equal_values_the_tip_is_found() -> None:
    between = swept("single", over="balance_factor", values=[0.0, 0.4, 0.6, 1.0])
    found = best(between, watched(between, "force", order=1))
    assert (found.value, found.stretch) == (pytest.approx(0.5, abs=1e-6), None)


def test_a_tip_beside_a_value_that_is_not_the_least_is_found_as_well() -> None:
    sweep = swept("i2-360", over="layout.throws[2]", values=[0, 160, 360, 535, 720], unit="deg")
    found = best(sweep, watched(sweep, "force", order=1))
    assert [round(value, 3) for value in (found.value, *found.also)] == [180.0, 540.0]


def test_of_values_in_a_row_that_are_equally_good_both_ends_are_told() -> None:
    """A second crank at two, three or four times the speed leaves order 1 to the first."""
    sweep = swept("kr250-racer", over="layout.cranks[2].speed_ratio", values=[-1, 4, 3, 2])
    found = best(sweep, watched(sweep, "force", order=1))
    assert (found.value, found.stretch, found.at_edge, found.flat) == (3.0, (2.0, 4.0), True, False)
    assert found.result == pytest.approx(0.5, abs=1e-12)


@pytest.mark.release
def test_the_best_of_all_orders_lies_beyond_a_half_and_nothing_near_it_is_better() -> None:
    sweep = of("single", "balance_factor=0..1/50")
    found = best(sweep, watched(sweep, "force"))
    near = found.value + np.array([-1e-4, -1e-5, 0, 1e-5, 1e-4])
    around = watched(sweep.again(near), "force").values
    assert 0.55 < found.value < 0.65
    assert around.min() >= found.result - 1e-9
    assert around[2] == pytest.approx(found.result, rel=1e-9)


@pytest.mark.release
def test_more_than_eight_equal_values_are_cut() -> None:
    found = best_of("i2-360", "layout.throws[2]=0..7200/2001 deg", "force", 1)
    assert found.result == pytest.approx(0, abs=1e-6)
    assert len(found.also) <= 8
    assert all(value % 360 == pytest.approx(180, abs=1e-3) for value in (found.value, *found.also))


# Tables


@pytest.mark.release
def test_rows_and_csv_hold_the_values_and_their_units() -> None:
    sweep = of("v2-90", "layout.banks[1].bearing=0..90/91 deg", changes={"balance_factor": 0.5})
    curves = [watched(sweep, "force", order=1), watched(sweep, "roll")]
    bests = [best(sweep, curve) for curve in curves]
    table = next(sweep_document(sweep, curves, bests).tables)
    assert [row[0] for row in table.rows] == [*np.arange(0.0, 91.0, 9.0)]
    assert table.rows[2][1] == curves[0].values[18]
    text = csv_text(next(answer(sweep, curves, bests).tables))
    head, *body = csv.reader(io.StringIO(text))
    assert head == [
        "layout.banks[1].bearing [deg]",
        "force of order 1 [m*r*w^2]",
        "roll [m*r^2*w^2]",
    ]
    assert len(body) == 91
    assert float(body[17][2]) == curves[1].values[17]


# What cannot be asked


def test_what_a_request_may_look_like() -> None:
    assert over_request("balance_factor=0..1/11").values == pytest.approx(np.linspace(0, 1, 11))
    assert len(over_request("balance_factor=0..1").values) == 201
    assert over_request(" layout.banks[1].bearing = 0..90 deg / 3 ") == (
        "layout.banks[1].bearing",
        (0, 45, 90),
        "deg",
    )
    assert (
        over_request("x=0/3..1 deg")
        == over_request("x=0..1/3 deg")
        == over_request("x=0 deg..1 deg/3")
    )
    assert over_request("x=1e-3, -2.5,.5 mm") == ("x", (0.001, -2.5, 0.5), "mm")
    assert over_request("x=-10..-20/2").values == (-10, -20)


@pytest.mark.parametrize(("text", "told"), [
    ("", "give a field"), ("balance_factor", "give a field"), ("=0..1", "give a field"),
    ("x=", "give a field"),
    ("x=a..b", '"a" is not a number'), ("x=nan..1", '"nan" is not a number'), ("x=0..inf", '"inf"'),
    ("x=0..1e999", '"1e999"'),
    ("x=0..", '"" is not a number'), ("x=..1", '"" is not a number'),
    ("x=0..1..2", "is not a number"), ("x=0,5..1", '"0,5"'),
    ("x=1 2, 3", '"1 2"'), ("x=" + "9" * 5000, "is not a number"),
    ("x=1", "is one value"), ("x=1,1", "is one value"), ("x=,", '"" is not a number'),
    ("x=0..0", "the range is empty"), ("x=0..1/1", "1 behind the slash"),
    ("x=0..1/0", "give a whole number from 2 to 20000"),
    ("x=0..1/20001", "from 2 to 20000"), ("x=0..1/" + "9" * 5000, "from 2 to 20000"),
    ("x=0..1/1e9", "1e9 behind the slash is the number of values"),
    ("x=0..1/3/4", "stands once"), ("x=0..1/2.5", "2.5 behind the slash"),
    ("x=0 deg..1 rad", "the units are deg, rad"),
    ("x=0 \x1b[31m..1 \x1b[32m", "the units are ?[31m"),
], ids=lambda text: str(text)[:20])  # fmt: skip
def test_a_request_that_cannot_be_read_is_refused_with_a_sentence(text: str, told: str) -> None:
    with pytest.raises(SweepError, match=re.escape(told)) as error:
        over_request(text)
    assert len(str(error.value)) < 500
    assert "\x1b" not in str(error.value)


@pytest.mark.parametrize(("name", "text", "told"), [
    ("v8-cross-plane", "layout.bank[1].bearing=0..90 deg", "Did you mean layout.banks[1].bearing"),
    ("v8-cross-plane", "layout.banks[9].bearing=0..90 deg", "Did you mean layout.banks["),
    ("v8-cross-plane", "layout.banks[0].bearing=0..90 deg", "is not the path of a single number"),
    ("v8-cross-plane", "layout.banks[1].bearing=0..1",
        "has no unit; write its values with one, as in 90 deg"),
    ("v8-cross-plane", "layout.banks[1].bearing=0..90 kg", "a mass; an angle is needed"),
    ("v8-cross-plane", "layout.throws=0..90 deg", "Did you mean layout.throws["),
    ("sinitsyn-7-first", "layout.throws[2]=0..90 deg", "Did you mean shaft[1].throw[2].angle, "),
    ("v8-cross-plane", "layout=0..90 deg", "is not the path of a single number"),
    ("v8-cross-plane", "name=0..1",
        "The numbers that can be swept are balance_factor, cylinder.bore, "),
    ("v8-cross-plane", "cylinders[3].number=1..4", "is not the path of a single number"),
    ("v8-cross-plane", "firing_order[1]=1..8", "no effect on the inertia forces"),
    ("v8-cross-plane", "valves.lift=1..2 mm", "no effect on the inertia forces"),
    ("v8-cross-plane", "speed=1000..2000 kg", "a mass; a rotational speed is needed"),
    ("v8-cross-plane", "speed=1000..2000",
        "speed has no unit; write its values with one, as in 6000 rpm"),
    ("v8-cross-plane", "speed=-1000..2000 rpm", "it must be greater than 0"),
    ("v8-cross-plane", "balance_factor=0..1 mm", "is a plain number; leave out the unit"),
    ("v8-cross-plane", "balance_factor=0..3", "must be at most 2"),
    ("v8-cross-plane", "layout.bank_offset=0..30 mm", "bore_pitch is missing"),
    ("v8-cross-plane", "a.b[2].c=0..1", "is not a field of the engine"),
    ("v8-cross-plane", "x" * 5000 + "=0..1", "is not a field of the engine"),
    ("v8-cross-plane", "\x1b[31m=0..1", "is not a field of the engine"),
    ("napier-deltic", "layout.banks[1].bearing=0..90 deg", "is not a field of the engine"),
    ("v8-cross-plan", "balance_factor=0..1", "did you mean v8-cross-plane"),
    ("./nowhere.toml", "balance_factor=0..1", "there is no such file"),
], ids=lambda text: str(text)[:30])  # fmt: skip
def test_a_field_that_cannot_be_swept_is_refused_with_a_sentence(
    name: str, text: str, told: str
) -> None:
    with pytest.raises((SweepError, EngineFileError)) as error:
        of(name, text)
    assert told in str(error.value)
    assert len(str(error.value)) < 1500
    assert "\x1b" not in str(error.value)


def test_a_file_with_a_firing_order_that_cannot_be_is_not_swept(tmp_path: Path) -> None:
    file = tmp_path / "six.toml"
    file.write_text('name = "six"\nfiring_order = [0]\n[layout]\ntype = "inline"\n')
    for read in (crankstar.load, lambda name: of(name, "balance_factor=0..1")):
        with pytest.raises(EngineFileError) as error:
            read(str(file))
        assert [fault.path for fault in error.value.faults] == [("firing_order", 0)]


@pytest.mark.release
def test_every_number_that_a_message_names_can_be_swept() -> None:
    for name in ("v8-cross-plane", "kr250-racer", "vw-vr6", "napier-deltic", "radial-9"):
        with pytest.raises(SweepError) as error:
            swept(name, over="nothing", values=[0, 1])
        named = (
            str(error.value)
            .split("can be swept are ")[1]
            .split(" and more")[0]
            .removesuffix(".")
            .split(", ")
        )
        assert len(named) > 5
        for path in named:
            subject(source_of(name), [Varied(path)])


NO_VALUES = [
    [],
    [1.0],
    [1.0, 1.0],
    ["a", "b"],
    [0.0, nan],
    [0.0, inf],
    [[0.0, 1.0]],
    [0.0, 1j],
    [0.0] * 100_001 + [1],
]


@pytest.mark.parametrize("values", NO_VALUES, ids=lambda values: str(values)[:20])
def test_values_that_are_none_are_refused(values: Any) -> None:
    with pytest.raises(SweepError, match="balance_factor: "):
        swept("single", over="balance_factor", values=values)


def test_other_requests_that_cannot_be_met() -> None:
    sweep = of("single", "balance_factor=0..1/5")
    for what in ("", "forc", "force.", "force.middle", "roll.up", "x" * 5000):
        with pytest.raises(SweepError, match="cannot be computed in a sweep"):
            watched(sweep, what)
    for order in (0, -1, nan, inf):
        with pytest.raises(SweepError, match="there is no order"):
            watched(sweep, "force", order=order)
    for orders in ([], [0], [nan], [1, -2], [1e6]):
        with pytest.raises(SweepError, match="the orders are not possible"):
            of("single", "balance_factor=0..1/5", orders=orders)
    with pytest.raises(SweepError, match="too many"):
        of("v8-cross-plane", "cylinder.rod_ratio=1.01..4/20000")


def test_a_file_that_is_mistaken_tells_all_its_mistakes(tmp_path: Path) -> None:
    path = tmp_path / "bad.toml"
    path.write_text(
        'name = "x"\n[cylinder]\nrod_ratio = "a"\n[layout]\ntype = "inline"\nthrows = ["0 kg"]\n',
        encoding="utf-8",
    )
    with pytest.raises(EngineFileError) as error:
        of(str(path), "balance_factor=0..1")
    assert len(error.value.faults) == 2
    path.write_text(
        path.read_text(encoding="utf-8").replace('"a"', "0.5").replace("kg", "deg"),
        encoding="utf-8",
    )
    mended = of(str(path), "cylinder.rod_ratio=2..4/5")  # what is swept may be what is wrong
    assert watched(mended, "force", order=1).values == pytest.approx([1.0] * 5)


def test_fewer_values_than_probes_are_built_one_by_one() -> None:
    assert_one_by_one(
        subject(source_of("v2-90"), [Varied("balance_factor")]).make,
        np.linspace(0, 1, FEW),
        lawful=None,
    )
