"""Two numbers varied at once: arrays against engines one by one, closed ranges, best pairs."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from math import cos, pi, radians
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray
from tests.files.test_balance_asked import TWIN as TWIN_FILE
from tests.methods.test_sweep import POINT, assert_as_alone

import crankstar
from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.files import EngineFileError
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.batches import totals
from crankstar.mechanics.excitation import part_spectra
from crankstar.studies import variants as variants_module
from crankstar.studies.best_pair import best_pair, front
from crankstar.studies.best_value import best
from crankstar.studies.fields import Varied, source_of, subject
from crankstar.studies.grids import grid_variants
from crankstar.studies.ranges import over_request, speeds_request
from crankstar.studies.sweep import sweep, swept, watched
from crankstar.studies.variants import SweepError

Request = tuple[str, str | None, float, float]
PAIRS: list[tuple[str, Request, Request, bool]] = [
    ("v8-cross-plane", ("balance_factor", None, 0, 1), ("layout.throws[2]", "deg", 0, 720), True),
    ("v8-cross-plane", ("layout.throws[2]", "deg", 0, 720), ("balance_factor", None, 0, 1), True),
    (
        "v8-cross-plane",
        ("layout.banks[1].bearing", "deg", 0, 400),
        ("layout.pin_split", "deg", -40, 40),
        True,
    ),
    ("v8-cross-plane", ("cylinder.rotating_mass", "", 0, 2), ("balance_factor", None, 0, 1), True),
    ("v8-cross-plane", ("cylinder.rod_ratio", "", 2, 5), ("balance_factor", None, 0, 1), True),
    ("v8-cross-plane", ("balance_factor", None, 0, 1), ("cylinder.rod_ratio", "", 2, 5), True),
    ("bmw-s65", ("cylinder.rod_length", "mm", 120, 160), ("cylinder.stroke", "mm", 60, 90), True),
    (
        "kr250-racer",
        ("layout.cranks[2].lag", "deg", 0, 720),
        ("layout.cranks[2].right", "mm", -90, 90),
        True,
    ),
    ("jumo-205", ("layout.lag", "deg", -20, 20), ("balance_factor", None, 0, 1), True),
    ("radial-9", ("layout.knuckle_radius", "", 0.3, 0.6), ("balance_factor", None, 0, 1), False),
    (
        "napier-deltic",
        ("shaft[2].throw[1].angle", "deg", 0, 360),
        ("balance_factor", None, 0, 1.5),
        True,
    ),
    ("harley-45", ("balance_factor", None, 0, 1), ("shaft[1].throw[1].angle", "deg", 0, 90), True),
]


def numbers(request: Request, count: int) -> np.ndarray:
    return np.linspace(request[2], request[3], count)


@pytest.mark.release
@pytest.mark.parametrize(("name", "first", "second", "lawful"), PAIRS, ids=str)
def test_engines_over_two_numbers_are_those_built_one_by_one(
    name: str, first: Request, second: Request, lawful: bool
) -> None:
    make = subject(source_of(name), [Varied(*first[:2]), Varied(*second[:2])]).make
    calls: list[tuple[float, float]] = []

    def counted(a: float, b: float) -> Engine:
        calls.append((a, b))
        return make(a, b)

    a, b = numbers(first, 21), numbers(second, 23)
    batches = grid_variants(counted, a, b)
    rows = np.concatenate([batch.rows for batch in batches])
    assert sorted(rows.tolist()) == [*range(a.size * b.size)]
    assert (len(calls) < a.size * b.size / 2) == lawful
    random = np.random.default_rng(4)
    for batch in batches:
        orders = part_spectra(batch.machine).force.orders.tolist()
        sums = totals(batch.machine, orders=orders, reference=POINT)
        for row in random.choice(batch.rows.size, min(batch.rows.size, 4), replace=False):
            place = divmod(int(batch.rows[row]), b.size)
            assert_as_alone(sums, make(float(a[place[0]]), float(b[place[1]])), POINT, int(row))


@pytest.mark.release
def test_values_of_two_numbers_may_be_in_any_order_and_come_twice() -> None:
    names = [Varied("balance_factor"), Varied("layout.throws[2]", "deg")]
    make = subject(source_of("v8-cross-plane"), names).make
    a = np.concatenate([np.linspace(1, 0, 18), [0.3, 0.3]])
    b = np.concatenate([np.linspace(90, 0, 17), np.linspace(5, 80, 9)])
    batches = grid_variants(make, a, b)
    assert sum(batch.rows.size for batch in batches) == a.size * b.size
    for batch in batches:
        sums = totals(batch.machine, orders=[1.0, 4.0], reference=POINT)
        for row in range(0, batch.rows.size, 37):
            place = divmod(int(batch.rows[row]), b.size)
            engine = make(float(a[place[0]]), float(b[place[1]]))
            alone = total(balance(engine, reference=POINT)).force
            scale = 1 / balance_unit(engine)
            one = spectra.selected(alone, [1.0, 4.0])
            assert sums.force.forward[row] * scale == pytest.approx(one.forward, abs=1e-11)


def balance_unit(engine: Engine) -> float:
    from crankstar.mechanics.balance import unit_unbalance

    return unit_unbalance(engine)


TWIN = {"cylinder.stroke": "60 mm"}
TWIN |= {"cylinder.reciprocating_mass": "320 g", "layout.bore_pitch": "90 mm"}


@pytest.mark.release
def test_the_cells_of_a_sweep_are_single_analyses() -> None:
    made = sweep(
        "i2-270",
        ["speed=1000..9000 rpm by 2000", "layout.throws[2]=0..300 deg by 60"],
        changes=TWIN,
    )
    assert made.shape == (5, 6)
    assert made.units.force == "N"
    force, roll = watched(made, "force"), watched(made, "roll", order=2)
    middle = crankstar.balance(crankstar.load("i2-270", changes=TWIN)).reference
    for (i, rpm), (j, angle) in product(*(enumerate(axis.values) for axis in made.axes)):
        changes = {**TWIN, "layout.throws[2]": f"{angle} deg", "firing_order": []}
        engine = crankstar.load("i2-270", changes=changes)
        alone = balance(engine, speed=rpm * pi / 30, reference=middle)
        sums = total(alone)
        assert force.values[i, j] == pytest.approx(spectra.peak(sums.force).value, rel=1e-8)
        own = crankstar.of_parts(alone)
        cell = spectra.selected(made.sums.couple[i, j], [1.0, 2.0])
        single = spectra.selected(own.couple, [1.0, 2.0])
        assert cell.forward == pytest.approx(single.forward, rel=1e-9, abs=1e-9)
    turned = sweep(
        "i2-270",
        ["layout.throws[2]=0..300 deg by 60", "speed=1000..9000 rpm by 2000"],
        changes=TWIN,
    )
    across = watched(turned, "roll", order=2).values.T
    assert across == pytest.approx(roll.values, rel=1e-12)


def test_an_engine_without_masses_is_counted_at_the_highest_speed() -> None:
    made = sweep("v8-cross-plane", "speed=1000, 2000, 4000 rpm")
    assert tuple(made.units) == ("m*r*w_0^2", "m*r*w_0^2*a", "m*r^2*w_0^2")
    assert made.speed is None
    assert made.highest_speed == pytest.approx(4000 * pi / 30)
    whole = spectra.peak(total(balance(crankstar.load("v8-cross-plane"))).couple).value
    assert watched(made, "couple").values == pytest.approx(whole * np.array([1, 4, 16]) / 16)


# Closed ranges


@pytest.mark.parametrize(
    ("name", "text", "closed"),
    [
        ("i2-360", "layout.throws[2]=0..360/100 deg", True),
        ("i2-360", "layout.throws[2]=360..0/100 deg", True),
        ("i2-360", "layout.throws[2]=-180..540 deg/50", True),
        ("v2-90", "layout.banks[1].bearing=-90..270 deg by 10", True),
        ("kr250-racer", "layout.cranks[2].lag=0..360 deg", True),
        ("i2-360", "layout.throws[2]=0..359 deg", False),
        ("i2-360", "layout.throws[2]=0, 360 deg", False),
        ("i2-360", "balance_factor=0..1", False),
        ("v8-cross-plane", "layout.pin_split=-180..180 deg/30", True),
    ],
)
def test_a_range_that_ends_where_it_began_is_closed(name: str, text: str, closed: bool) -> None:
    made = sweep(name, text)
    assert made.axes[0].closed == closed
    for what in ("force", "couple", "roll"):
        values = watched(made, what).values
        assert (values[0] == values[-1]) or not closed
    if closed:
        first, last = (made.sums.couple[place] for place in (0, -1))
        assert np.array_equal(first.forward, last.forward)


@pytest.mark.release
def test_the_best_of_a_closed_range_lies_across_its_ends_and_comes_once() -> None:
    made = sweep("i2-360", "layout.throws[2]=7..367 deg by 12")
    least = best(made, watched(made, "couple", order=1))
    assert (least.value % 360, least.at_edge, least.also) == (pytest.approx(0, abs=1e-4), False, ())
    assert 7 <= least.value <= 367
    second = best(made, watched(made, "force", order=2), greatest=True)
    assert {round(value) % 360 for value in (second.value, *second.also)} == {0, 180}


@pytest.mark.release
def test_both_axes_of_a_pair_may_be_closed() -> None:
    over = ["shaft[1].throw[2].angle=0..360 deg/19", "shaft[1].throw[3].angle=-90..270 deg/25"]
    made = sweep("triple-120", over)
    assert [axis.closed for axis in made.axes] == [True, True]
    values = watched(made, "force", order=1).values
    assert np.array_equal(values[0], values[-1])
    assert np.array_equal(values[:, 0], values[:, -1])
    a, b = (np.radians(axis.values) for axis in made.axes)
    star = np.abs(1 + np.exp(1j * a)[:, None] + np.exp(1j * b)[None, :])
    assert values == pytest.approx(star, abs=1e-12)
    found = best_pair(made, watched(made, "force", order=1))
    assert sorted(round(v % 360, 1) for v in found.values) == [120.0, 240.0]
    assert (found.result, found.at_edge) == (pytest.approx(0, abs=1e-9), (False, False))
    assert found.also == 1  # the mirror image


# The best pair and the front


@pytest.mark.release
def test_the_best_pair_of_a_twin_is_half_balance_at_a_right_angle() -> None:
    changes = {"layout.banks[1].bearing": "0 deg"}
    over = ["balance_factor=0..1/12", "layout.banks[2].bearing=40..130 deg/14"]
    made = sweep("v2-90", over, changes=changes)
    found = best_pair(made, watched(made, "force", order=1))
    assert found.values == (pytest.approx(0.5, abs=1e-4), pytest.approx(90, abs=0.01))
    assert found.result < 1e-4
    none = best_pair(made, watched(made, "force", order=7.5))
    assert none.flat


@pytest.mark.release
def test_a_best_pair_at_an_end_says_of_which_range() -> None:
    made = sweep("single", ["balance_factor=0..0.4/9", "cylinder.rod_ratio=2.5..6/9"])
    found = best_pair(made, watched(made, "force"))
    assert (found.values[0], found.at_edge[0]) == (0.4, True)


@pytest.mark.release
def test_no_pair_beats_one_of_the_front_and_every_other_is_beaten() -> None:
    over = ["balance_factor=0..1/15", "layout.throws[2]=0..360 deg/25"]
    made = sweep("i2-360", over)
    curves = [watched(made, "force"), watched(made, "couple")]
    for greatest in (False, True):
        pairs = front(made, curves[0], curves[1], greatest=greatest)
        sign = -1 if greatest else 1
        x, y = (sign * curve.values[:, :-1].ravel() for curve in curves)
        least = 1e-8 * np.abs(x).max(), 1e-8 * np.abs(y).max()
        for pair in pairs:
            a, b = (sign * result for result in pair.results)
            beaten = (x <= a - least[0]) & (y <= b + least[1])
            beaten |= (x <= a + least[0]) & (y <= b - least[1])
            assert not np.any(beaten)
        results = np.array([[sign * result for result in pair.results] for pair in pairs])
        for a, b in zip(x, y, strict=True):
            assert np.any((results[:, 0] <= a + least[0]) & (results[:, 1] <= b + least[1]))
        assert len(pairs) > 3


# Records


def test_a_sweep_of_two_as_data_set_has_dimensions_named_by_the_paths(tmp_path: Path) -> None:
    over = ["balance_factor=0..1/3", "layout.banks[1].bearing=0..90 deg/4"]
    made = crankstar.sweep("v2-90", over)
    data = made.to_xarray()
    assert data.force_forward.dims == ("balance_factor", "layout.banks[1].bearing", "order")
    assert data["layout.banks[1].bearing"].attrs["units"] == "deg"
    made.to_xarray(split=True).to_netcdf(tmp_path / "two.nc", engine="scipy")
    with xarray.open_dataset(tmp_path / "two.nc", engine="scipy") as read:
        both = read.force_vertical.sel(component="real") + 1j * read.force_vertical.sel(
            component="imag"
        )
        assert np.array_equal(both.values, data.force_vertical.values)
    frame = made.to_frame()
    rows = frame.query("quantity == 'force' and direction == 'vertical' and order == 1")
    table = rows.pivot_table(
        index="balance_factor", columns="layout.banks[1].bearing [deg]", values="amplitude"
    )
    assert table.to_numpy() == pytest.approx(abs(data.force_vertical.sel(order=1)).values)


def test_the_public_function_takes_names_and_paths_with_keys_of_the_file(tmp_path: Path) -> None:
    file = tmp_path / "twin.toml"
    file.write_text('name = "x"\n[layout]\ntype = "inline"\nthrows = ["0 deg", "90 deg"]\n')
    either: list[Any] = [file, str(file)]
    point: Any = "0.5"
    first = np.zeros(3)
    for given in either:
        made = crankstar.sweep(given, "layout.throws[2]=0..180 deg/3", reference=point)
        assert made.reference.z == 0.5
        first = watched(made, "force", order=1).values
        assert first == pytest.approx([2, 2 * cos(radians(45)), 0], abs=1e-12)
    own = crankstar.sweep(crankstar.load(str(file)), "shaft[1].throw[2].angle=0..180 deg/3")
    assert watched(own, "force", order=1).values == pytest.approx(first, abs=1e-12)


def test_paths_of_both_forms_can_be_varied_together() -> None:
    over = ["cylinder.rod_ratio=3..5/3", "shaft[1].throw[2].radius=0.8..1.2/5"]
    made = sweep("i2-270", over)
    for i, ratio in enumerate(made.axes[0].values):
        alone = swept(
            "i2-270",
            over="shaft[1].throw[2].radius",
            values=made.axes[1].values,
            changes={"cylinder.rod_ratio": float(ratio)},
            reference=made.reference,
        )
        own = watched(made, "force", order=2).values[i]
        assert own == pytest.approx(watched(alone, "force", order=2).values, rel=1e-9)


# What cannot be asked


@pytest.mark.parametrize(
    ("over", "told"),
    [
        (["balance_factor=0..1"] * 2, "balance_factor is varied twice"),
        (["layout.throws[2]=0..9 deg", "layout.throws[ 2 ]=0..9 deg"], "is not a"),
        (["balance_factor=0..1"] * 3, "3 values are to be varied; one or two"),
        ([], "0 values are to be varied"),
        (["balance_factor=0..1", "layout.bor=0..1 mm"], "is not a field of the engine"),
        (["balance_factor=0..1", "layout.throws[2]=0..9 kg"], "a mass; an angle is needed"),
        (["balance_factor=0..1 mm", "layout.throws[2]=0..9 deg"], "is a plain number"),
        (["balance_factor=0..1", "layout.throws[2]=0..9"], "has no unit"),
        (["balance_factor=0..1/1000", "layout.throws[2]=0..9 deg/1000"], "are 1000000 engines"),
        (["speed=1000..2000 rpm", "speed=1..2 Hz"], "speed is varied twice"),
        (["balance_factor=0..1 by 0"], "steps of 0 never lead from 0 to 1; write by 0.1"),
        (["balance_factor=0..1 by -0.1"], "steps of -0.1 never lead from 0 to 1; write by 0.1"),
        (["balance_factor=1..0 by 0.1"], "steps of 0.1 never lead from 1 to 0; write by -0.1"),
        (["balance_factor=0..1 by 2"], "the step 2 is longer than the range"),
        (["balance_factor=0..1 by 1e-9"], "make 1e+09 values; at most 20000"),
        (["balance_factor=0..1e300 by 1e-300"], "values; at most 20000"),
        (["balance_factor=0..1/5 by 0.1"], "either the number of values"),
        (["balance_factor=0..1 by"], "is not a number"),
        (["balance_factor=0..1 by x"], '"x" is not a number'),
        (["layout.throws[2]=0..9 deg by 1 rad"], "the units are deg, rad"),
        (["balance_factor=1..1 by 0.1"], "the range is empty"),
        (["balance_factor=0..1/-5"], "-5 behind the slash is the number of values"),
        (["balance_factor=0,,1"], '"" is not a number'),
        (["balance_factor=,"], '"" is not a number'),
        (["speed=1..1e300 rpm"], "the speed is 1e+300 rpm, too large for an engine"),
    ],
    ids=lambda value: str(value)[:50],
)
def test_what_cannot_be_varied_is_refused_with_a_sentence(over: Sequence[str], told: str) -> None:
    with pytest.raises((SweepError, EngineFileError)) as error:
        sweep("i2-360", over)
    assert told in str(error.value)
    assert len(str(error.value)) < 1500


def test_an_ellipsis_is_a_range_and_a_last_comma_is_nothing() -> None:
    assert over_request("balance_factor=0…1/3") == over_request("balance_factor=0..1/3")
    assert over_request("balance_factor=0, 1,").values == (0.0, 1.0)


def test_a_speed_that_is_given_and_varied_is_refused() -> None:
    with pytest.raises(SweepError, match="given and varied"):
        sweep("i2-360", "speed=1000..2000 rpm", speed=100.0)


@pytest.mark.release
def test_so_many_engines_one_by_one_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(variants_module, "GREATEST_BUILT", 200)
    over = ["layout.knuckle_radius=0.3..0.6/20", "balance_factor=0..1/20"]
    with pytest.raises(SweepError, match="give fewer values"):
        sweep("radial-9", over)


def test_steps_end_at_the_end_of_the_range_or_before_it() -> None:
    def values(text: str) -> Any:
        return sweep("i2-360", text).values.tolist()

    assert values("balance_factor=0..1 by 0.25") == [0, 0.25, 0.5, 0.75, 1]
    assert values("balance_factor=0..1 by 0.3") == [0, 0.3, 0.6, 0.9]
    assert values("balance_factor=0.1..0.7 by 0.1") == [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]
    assert values("speed=600..6000 rpm by 1800") == [600, 2400, 4200, 6000]
    assert values("layout.throws[2]=90..0 deg by -30 deg") == [90, 60, 30, 0]


@pytest.mark.release
@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    "over",
    [
        ["balance_factor=0..1", "layout.throws[2]=0..360 deg"],
        ["balance_factor=0..1/5", "layout.throws[2]=180..360 deg by 45"],
        ["layout.throws[2]=180..360 deg/7", "balance_factor=0..1/4"],
    ],
    ids=str,
)
def test_the_best_pair_of_few_values_is_that_of_many(over: list[str], tmp_path: Path) -> None:
    """The force of a twin is least in a narrow bend at the end of one range."""
    file = tmp_path / "twin.toml"
    text = TWIN_FILE.replace('"0 deg", "0 deg"', '"0 deg", "270 deg"')
    file.write_text(text, encoding="utf-8")
    made = sweep(str(file), over)
    found = best_pair(made, watched(made, "force"))
    many = sweep(str(file), ["balance_factor=0..1/21", "layout.throws[2]=180..200 deg/101"])
    assert found.result <= float(watched(many, "force").values.min())
    which = 0 if over[0].startswith("balance") else 1
    assert found.values[which] == 1
    assert found.at_edge[which]
    assert not found.at_edge[1 - which]


def test_an_order_that_was_not_asked_for_is_refused_and_not_nought() -> None:
    made = sweep("i2-270", "layout.throws[2]=0..360 deg/5", orders=[1])
    assert watched(made, "couple", order=1).values.max() > 0
    with pytest.raises(SweepError, match="no order 2; its orders are 1"):
        watched(made, "couple", order=2)


@pytest.mark.parametrize("text", ["600...6000 rpm", "0...1", "0....5 by .1", "0…..1"])
def test_three_full_stops_are_read_in_no_way(text: str) -> None:
    """They were read as two before a decimal: 600 to 0.6 rpm."""
    for read in (speeds_request, lambda range_: over_request(f"balance_factor={range_}")):
        with pytest.raises(SweepError, match="three full stops or more"):
            read(text)


@pytest.mark.parametrize("text", ["-1e308..1e308", "0..1e308 by 1e307", "0, 1e301"])
def test_numbers_beyond_any_engine_are_refused_without_a_warning(text: str) -> None:
    with pytest.raises(SweepError, match="is too large"):
        over_request(f"balance_factor={text}")


@pytest.mark.parametrize(
    "path",
    ["cylinder.rod_length=120..180 mm/4", "layout.bore_pitch=1..2/3", "layout.bank_angle=0..1/3"],
)
def test_a_key_of_the_short_file_needs_the_file(path: str) -> None:
    with pytest.raises(SweepError) as refused:
        crankstar.sweep(crankstar.load("i4"), path)
    said = str(refused.value)
    assert "an Engine does not know its file. Give the name or the path of the file" in said
    assert "Did you mean" not in said
