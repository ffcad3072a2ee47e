"""One quantity by every method: closed forms, series, quadrature, sampling, single engines."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from pydantic import ValidationError
from tests.newton import PI, Rate, placed
from tests.strategies import ANGLES, CYCLES, ROTATIONS, engines, number, of_layout

from crankstar import spectra
from crankstar.engine import motion
from crankstar.engine.basis import Basis
from crankstar.engine.checks import MINIMUM_CLEARANCE
from crankstar.engine.dead_centres import pistons
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import LAYOUTS
from crankstar.engine.records import Articulation, Cylinder, Rod, Shaft, Weight
from crankstar.files import EngineFileError, engine_of, tree_of
from crankstar.files.catalog import load
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.batches import totals
from crankstar.mechanics.excitation import Reference, Totals, part_spectra
from crankstar.mechanics.mechanism import Mechanism, mechanism
from crankstar.spectra import Spectrum, greatest

AROUND = np.arange(1 << 14, dtype=np.longdouble) * (2 * PI / (1 << 14))


def harmonics_by_quadrature(rod_ratio: float, offset: float) -> np.ndarray:
    """A_k as k^2 times the Fourier coefficient of the travel x(psi), by the trapezoidal rule."""
    across = np.sin(AROUND) - np.longdouble(offset)
    travel = np.cos(AROUND) + np.sqrt(np.longdouble(rod_ratio) ** 2 - across**2)
    coefficients = 2 * np.fft.rfft(travel) / travel.size
    return (np.arange(coefficients.size) ** 2 * coefficients)[: coefficients.size - 1].astype(
        complex
    )


def series_by_expansion(order: int, highest_power: int) -> list[Fraction]:
    """A_order by powers of lambda.

    Expands cos(psi) + sqrt(1/lambda^2 - sin(psi)^2) in polynomials of exp(i psi).
    """
    found = [Fraction(0)] * (highest_power + 1)
    if order == 1:
        found[0] = Fraction(1)
        return found
    sine_squared = {-2: Fraction(-1, 4), 0: Fraction(1, 2), 2: Fraction(-1, 4)}
    power = {0: Fraction(1)}  # sin(psi)^(2 j)
    factor = Fraction(1)  # of (-x)^j in sqrt(1 - x)
    for j in range(highest_power // 2 + 2):
        if 0 <= 2 * j - 1 <= highest_power:
            found[2 * j - 1] += 2 * order**2 * factor * power.get(order, 0)
        product: dict[int, Fraction] = {}
        for (a, x), (b, y) in (
            (one, other) for one in power.items() for other in sine_squared.items()
        ):
            product[a + b] = product.get(a + b, Fraction(0)) + x * y
        power, factor = product, factor * Fraction(2 * j - 1, 2 * j + 2)
    return found


@pytest.mark.release
@given(number(1.002, 50.0), st.just(0.0) | number(-0.9, 0.9))
def test_the_harmonics_of_a_piston_are_those_of_its_travel(clearance: float, offset: float) -> None:
    rod_ratio = clearance * (1 + abs(offset))
    exact = motion.piston_harmonics(crank_radius=1, rod_length=rod_ratio, offset=offset)
    expected = harmonics_by_quadrature(rod_ratio, offset)
    count = min(len(exact), len(expected))
    assert np.abs(exact - expected[:count])[1:].max() <= 1e-12 * np.abs(expected).max()
    # nothing was left out but what the quadrature rounds, which k^2 magnifies
    rounding = float(np.finfo(np.longdouble).eps) * np.arange(len(expected)) ** 2
    beyond = (np.abs(expected) - rounding)[count : 2 * count]
    assert beyond.max() <= 1e-12 * np.abs(expected).max()
    assert exact[0] == 0


@given(number(1.002, 20.0), number(-0.9, 0.9), number(0.01, 10.0))
def test_harmonics_know_no_unit_of_length_and_an_offset_to_the_other_side_conjugates_them(
    clearance: float, offset: float, unit: float
) -> None:
    rod_length = clearance * (1 + abs(offset))
    one, large, mirrored = (
        motion.piston_harmonics(crank_radius=u, rod_length=rod_length * u, offset=e * u)
        for u, e in ((1, offset), (unit, offset), (1, -offset))
    )
    count = min(map(len, (one, large, mirrored)))
    assert np.abs(one[:count] - large[:count]).max() <= 1e-11 * np.abs(one).max()
    assert np.abs(np.conj(one[:count]) - mirrored[:count]).max() <= 1e-12 * np.abs(one).max()


@pytest.mark.parametrize("order", range(1, 13))
def test_the_series_in_lambda_is_the_expansion_of_the_square_root(order: int) -> None:
    expected = series_by_expansion(order, 15)
    assert [motion.series_coefficient(order, power) for power in range(16)] == expected


@pytest.mark.parametrize("ratio", [0.02, 0.1, 0.25, 1 / 3, 0.5])
def test_the_series_carried_far_is_exact(ratio: float) -> None:
    exact = motion.piston_harmonics(crank_radius=ratio, rod_length=1)
    for order in range(1, 10):
        assert float(motion.series(order, ratio=ratio, highest_power=91)) == pytest.approx(
            exact[order].real, rel=1e-12, abs=1e-14
        )
        assert abs(exact[order].imag) <= 1e-14
    # The usual series ends at lambda^7: what it leaves out of A_2 is of the order of lambda^9.
    assert (
        0
        <= exact[2].real - float(motion.series(2, ratio=ratio))
        <= 0.4 * ratio**9 / (1 - ratio**2) + 1e-14
    )


@pytest.mark.release
@given(engines())
def test_each_cylinder_may_have_angles_of_its_own(engine: Engine) -> None:
    theta = np.linspace(0, 2 * np.pi, 7)
    links, _place, lag, ratio, *_ = pistons(engine)
    together = motion.rods(links, ratio[:, None] * theta + lag[:, None])
    for index in range(len(engine.cylinders)):
        own = motion.parted(links, motion.chain(links.master, index))
        alone = motion.rods(own, ratio[index] * theta + lag[index])
        for ours, theirs in zip(together, alone, strict=True):
            assert all(np.allclose(a[index], b[-1]) for a, b in zip(ours, theirs, strict=True))


@pytest.mark.release
@given(engines())
def test_rods_are_where_circles_cut_axes_and_move_as_they_stand(engine: Engine) -> None:
    """Places by the package and by plane geometry; its derivatives against spectral ones."""
    links = motion.linkage(engine)
    psi = np.arange(2048) * (2 * np.pi / 2048)
    moved = motion.rods(links, psi)
    root = motion.roots(links.master)
    for index, cylinder in enumerate(engine.cylinders):
        first = engine.cylinders[root[index]]
        turn = np.exp(1j * first.bearing)
        # The crank angle at which the throw stands psi clockwise of its root's cylinder, whatever
        # gear it has.
        own = engine.model_copy(
            update={
                "rotation": "clockwise",
                "shafts": tuple(
                    s.model_copy(update={"speed_ratio": Fraction(1)}) for s in engine.shafts
                ),
            }
        )
        theta = psi - engine.throw(cylinder).angle + first.bearing
        pin, piston, leaning = placed(own, cylinder, theta.astype(np.longdouble))
        size = np.abs(piston).max()
        for ours, theirs in ((moved.big_end, pin), (moved.piston, piston)):
            assert (
                np.abs(ours.place[index] * turn - (theirs[:, 1] + 1j * theirs[:, 0])).max()
                <= 1e-12 * size
            )
        assert np.abs(moved.direction.place[index] * turn - np.exp(1j * leaning)).max() <= 1e-11
        rate = Rate(1, psi.size)
        for path in (moved.big_end, moved.piston, moved.direction):
            for below, above in (
                (path.place[index], path.first[index]),
                (path.first[index], path.second[index]),
            ):
                spectral = (
                    rate(below.real.astype(np.longdouble))
                    + 1j * rate(below.imag.astype(np.longdouble))
                ).astype(complex)
                assert np.abs(spectral - above).max() <= 1e-8 * max(
                    np.abs(above).max(), np.abs(below).max()
                )


@given(
    st.sampled_from([0.9, 0.999, 1.0005, 1.0015, 1.1]),
    number(0.05, 0.9),
    ANGLES,
    ANGLES,
    number(-0.5, 0.5),
)
def test_a_slave_rod_is_refused_just_when_its_circle_hardly_meets_its_axis(
    clearance: float, knuckle: float, angle: float, bearing: float, offset: float
) -> None:
    theta = np.arange(7200) * (2 * np.pi / 7200)
    lean = -np.arcsin(np.sin(theta) / 4)
    pin = np.exp(1j * theta) + knuckle * np.exp(1j * (lean + angle))
    needed = np.abs((pin * np.exp(-1j * bearing)).imag - offset).max()
    shaft = Shaft.model_validate({"name": "crank", "throw": [{"angle": 0.0, "radius": 1.0}]})
    master = Cylinder(number=1, shaft="crank", throw=1, rod_length=4.0, reciprocating_mass=1.0)
    link = Articulation(master=1, radius=knuckle, angle=angle)
    update = {
        "number": 2,
        "bearing": bearing,
        "offset": offset,
        "rod_length": clearance * needed,
        "articulated": link,
    }
    slave = master.model_copy(update=update)
    tree = {"name": "pair", "shafts": [shaft], "cylinders": [master, slave]}
    if clearance >= MINIMUM_CLEARANCE:
        assert Engine.model_validate(tree).cylinders[1] == slave
        return
    with pytest.raises(ValidationError) as refused:
        Engine.model_validate(tree)
    (cause,) = [mistake.get("ctx", {})["error"] for mistake in refused.value.errors()]
    (fault,) = cause.faults
    assert fault.path == ("cylinders", 1, "rod_length")


UNFIT = """
format = 1
name = "a radial engine with an order that does not fit"
cycle = "two-stroke"
firing_order = [1, 3, 5, 2, 4]
cylinder = { stroke = "80 mm", rod_length = "105 mm", reciprocating_mass = "1 kg" }
layout = { type = "radial", rows = [{ cylinders = [1, 2, 3, 4, 5] }], knuckle_radius = "40 mm" }
"""


def test_an_order_that_does_not_fit_slave_rods_is_refused_with_a_sentence() -> None:
    with pytest.raises(EngineFileError, match="firing_order"):
        engine_of(tree_of(UNFIT))


def vectors(size: int) -> st.SearchStrategy[np.ndarray]:
    part = number(-1.0, 1.0)
    return st.lists(st.builds(complex, part, part), min_size=size, max_size=size).map(np.array)


ORDERS = [
    np.array(orders)
    for orders in ([1.0], [2.0, 4.0], [0.5, 1.0, 1.5], [1.0, 29 / 31], [1.0, 4 / 3, 2.0, 7.0])
]
SPECTRA = st.sampled_from([np.sort(orders) for orders in ORDERS]).flatmap(
    lambda orders: st.builds(
        Spectrum,
        st.just(orders),
        vectors(orders.size),
        vectors(orders.size),
        st.sampled_from([1, -1]),
    )
)
THETA = np.linspace(-7, 11, 301)


@given(SPECTRA)
def test_a_spectrum_is_a_sum_of_turning_vectors_whose_parts_are_real_signals(
    spectrum: Spectrum,
) -> None:
    turning = spectrum.sense * spectrum.orders[:, None] * THETA
    expected = spectrum.forward @ np.exp(1j * turning) + spectrum.backward @ np.exp(-1j * turning)
    assert np.abs(spectra.value(spectrum, THETA) - expected).max() < 1e-13
    ahead = np.exp(1j * spectrum.orders[:, None] * THETA)
    assert np.abs(np.real(spectra.vertical(spectrum) @ ahead) - np.real(expected)).max() < 1e-13
    assert np.abs(np.real(spectra.horizontal(spectrum) @ ahead) - np.imag(expected)).max() < 1e-13
    real = spectra.real_signal(spectrum.orders, spectrum.forward)
    assert np.abs(spectra.value(real, THETA) - np.real(spectrum.forward @ ahead)).max() < 1e-13
    assert np.allclose(spectra.amplitude(real), spectrum.forward, atol=1e-15)


@given(SPECTRA, ANGLES)
def test_turned_shifted_and_selected_spectra_are_the_turned_delayed_and_filtered_signal(
    spectrum: Spectrum, angle: float
) -> None:
    before = spectra.value(spectrum, THETA)
    assert (
        np.abs(
            spectra.value(spectra.turned(spectrum, angle), THETA) - before * np.exp(1j * angle)
        ).max()
        < 1e-13
    )
    assert (
        np.abs(spectra.value(spectra.shifted(spectrum, angle), THETA + angle) - before).max()
        < 1e-12
    )
    one_by_one = sum(
        spectra.value(spectra.selected(spectrum, order), THETA)
        for order in (*spectrum.orders, 99.0)
    )
    assert np.abs(one_by_one - before).max() < 1e-13


@pytest.mark.release
@given(SPECTRA)
def test_a_signal_sampled_over_its_period_has_the_spectrum_it_was_made_of(
    spectrum: Spectrum,
) -> None:
    turns = spectra.period(spectrum)
    around = np.arange(1024) * (2 * np.pi * turns / 1024)
    assert (
        np.abs(
            spectra.value(spectrum, around + 2 * np.pi * turns) - spectra.value(spectrum, around)
        ).max()
        < 1e-11
    )
    coefficients = np.fft.fft(spectra.value(spectrum, around)) / around.size
    places = spectrum.sense * np.round(spectrum.orders * turns).astype(int)
    assert np.abs(coefficients[places] - spectrum.forward).max() < 1e-12
    assert np.abs(coefficients[-places] - spectrum.backward).max() < 1e-12


@given(
    number(-1.0, 1.0),
    number(-1.0, 1.0),
    number(-1.0, 1.0),
    number(-1.0, 1.0),
    st.sampled_from([1, -1]),
)
def test_the_ellipse_is_the_one_that_sampling_draws(
    a: float, b: float, c: float, d: float, sense: int
) -> None:
    forward, backward = complex(a, b), complex(c, d)
    found = spectra.ellipse(forward, backward)
    around = np.linspace(0, 2 * np.pi, 20_001)
    path = spectra.value(
        Spectrum(np.array([1.0]), np.array([forward]), np.array([backward]), sense), around
    )
    scale = max(abs(forward), abs(backward), 1e-300)
    assert found.semi_major == pytest.approx(np.abs(path).max(), abs=1e-6 * scale)
    assert found.semi_minor == pytest.approx(np.abs(path).min(), abs=1e-3 * scale)
    assert -np.pi / 2 < found.bearing <= np.pi / 2
    on_long_axis = np.abs((path * np.exp(-1j * found.bearing)).real).max()
    assert on_long_axis == pytest.approx(found.semi_major, abs=1e-6 * scale)
    swept = np.imag(np.conj(path[:-1]) * path[1:]).sum() / 2  # twice the area, clockwise
    assert swept * sense == pytest.approx(
        np.pi * found.semi_major * found.semi_minor * found.sense, abs=1e-6 * scale**2
    )


def assert_peak(spectrum: Spectrum) -> None:
    found, turns = spectra.peak(spectrum), spectra.period(spectrum)
    dense = np.arange(4000 * turns) * (2 * np.pi / 4000)
    lengths = np.abs(spectra.value(spectrum, dense))
    assert found.value >= lengths.max() * (1 - 1e-12)
    steepest = (spectrum.orders * (np.abs(spectrum.forward) + np.abs(spectrum.backward))).sum()
    assert found.value <= lengths.max() + steepest * (2 * np.pi / 4000)
    assert 0 <= found.theta < 2 * np.pi * turns
    assert abs(spectra.value(spectrum, found.theta) - found.vector) <= 1e-9 * found.value
    assert abs(found.vector) == pytest.approx(found.value)


@pytest.mark.release
@settings(max_examples=10)
@given(engines())
def test_no_sample_is_longer_than_the_peak(engine: Engine) -> None:
    whole = total(balance(engine))
    for spectrum in whole:
        assert_peak(spectra.selected(spectrum, spectrum.orders[:40]))


@pytest.mark.release
@given(SPECTRA)
def test_no_sample_of_any_spectrum_is_longer_than_its_peak(spectrum: Spectrum) -> None:
    assert_peak(spectrum)


@example([1.3352056514018935], 1)  # next to a sample that is as long but for 4e-10
@given(st.lists(st.floats(0.001, 1.56), min_size=1, max_size=5), st.sampled_from([1, 2, 3, 5]))
def test_of_equal_peaks_in_a_batch_each_vector_has_its_first(
    delays: list[float], order: int
) -> None:
    """cos n(theta - d) has its greatest length n times in half a turn; nothing has none."""
    late = np.array(delays)[:, None] / order
    wave = np.append(np.exp(-1j * order * late), [[0.0]], axis=0)
    batch = spectra.real_signal(np.array([float(order)]), wave)
    *found, nothing = spectra.tops(batch)
    first = np.array(delays) / order % (np.pi / order)
    half = np.pi / order  # a crest at the end of it is the first one or the next
    off = (np.array([top.theta for top in found]) - first + half / 2) % half - half / 2
    assert off == pytest.approx(0.0, abs=1e-7)
    assert all(-1e-7 <= top.theta <= half + 1e-7 for top in found)
    assert [top.value for top in found] == pytest.approx([1.0] * len(delays), rel=1e-12)
    assert nothing == spectra.Peak(0.0, 0.0, 0j)


def test_of_two_peaks_beside_one_sample_the_first_is_told() -> None:
    """cos x - b cos 3x has a minimum at 0 between two maxima, sin^2 x = (9 b - 1)/12 b."""
    late, b = 2 * np.pi * 10 / (16 * (3 + 4)), 1 / 9 + 1e-4  # between samples 9 and 11
    orders = np.array([1.0, 3.0])
    wave = np.array([1.0, -b]) * np.exp(-1j * orders * late)
    (top,) = spectra.tops(spectra.real_signal(orders, wave[None]))
    aside = np.arcsin(np.sqrt((9 * b - 1) / (12 * b)))
    assert top.theta == pytest.approx(late - aside, abs=1e-6)
    assert top.value == pytest.approx(np.cos(aside) - b * np.cos(3 * aside), rel=1e-12)


def test_the_higher_of_two_nearly_equal_peaks_is_found() -> None:
    forward, backward = np.array([0.5 + 0.2j, -1.5 + 0.5j]), np.array([-1.6 + 0.9j, 0.6 - 1.2j])
    assert_peak(Spectrum(np.array([1.0, 2.0]), forward, backward))  # 4.618653, not 4.614653


@pytest.mark.parametrize("share", [1e-11, 1e-10])
def test_a_sum_that_is_small_but_no_rounding_error_stays(share: float) -> None:
    """Two parts of opposite sign whose masses differ by that share leave it."""
    parts = np.array([[1.0 + 0j], [share - 1.0]])
    left = spectra.total(Spectrum(np.array([1.0]), parts, 1j * parts))
    assert left.forward[0] == pytest.approx(share, rel=1e-3)
    assert left.backward[0] == pytest.approx(1j * share, rel=1e-3)


def test_angles_that_are_nearly_equal_steps_are_taken_as_they_are() -> None:
    angles = np.arange(16) * (2 * np.pi / 16)
    moved = angles + np.where(np.arange(16) == 5, 1e-10, 0.0)
    wave = spectra.real_signal(np.array([7.0]), np.array([1.0 + 0j]))
    change = (spectra.value(wave, moved) - spectra.value(wave, angles)).real
    expected = np.where(np.arange(16) == 5, -7e-10 * np.sin(7 * angles), 0.0)
    assert change == pytest.approx(expected, abs=1e-14)


@pytest.mark.parametrize("at_most", [greatest.POINTS_AT_MOST, 1])
def test_the_peak_may_lie_halfway_between_two_samples(
    at_most: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """cos n(x - d), halfway, is sampled at cos(pi n/samples) of its peak; a low wave is on one."""
    monkeypatch.setattr(greatest, "POINTS_AT_MOST", at_most)
    order, scale = 60, 0.9999
    samples = greatest._steps(order)
    late, least = np.pi / samples, np.cos(np.pi * order / samples)
    low = (1 - least) / 2  # a crest on a sample far away stands above the samples about the peak
    orders = np.array([1.0, order - 1.0, order])
    wave = np.array([-low * 0.5, low * 0.25, scale]) * np.exp(-1j * orders * late)
    batch = spectra.real_signal(orders, np.stack([wave, wave[::-1]]))
    dense = np.linspace(0, 2 * np.pi, 400_001)
    highest = np.abs(spectra.value(batch, dense)).max(axis=-1)
    assert spectra.peaks(batch) == pytest.approx(highest, rel=1e-6)
    assert (spectra.peaks(batch) >= highest * (1 - 1e-12)).all()
    assert [top.value for top in spectra.tops(batch)] == pytest.approx(spectra.peaks(batch))


def test_the_peak_does_not_hang_on_how_the_orders_are_listed() -> None:
    orders, amplitude = np.array([1.0, 60.0]), np.array([1.0, 0.7j])
    ascending, descending = (
        Spectrum(orders[way], amplitude[way], 0.3 * amplitude[way]) for way in ([0, 1], [1, 0])
    )
    assert spectra.peak(descending).value == pytest.approx(spectra.peak(ascending).value, rel=1e-9)


@pytest.mark.release
def test_the_peak_of_shafts_of_29_and_31_teeth_is_found_in_the_turn_where_they_meet() -> None:
    weight = Weight(unbalance=1.0, angle=0.0)
    shafts = [
        Shaft.model_validate(
            {"name": "crank", "throw": [{"angle": 0.0, "radius": 1.0}], "weight": [weight]}
        ),
        Shaft.model_validate(
            {
                "name": "other",
                "speed_ratio": "-29/31",
                "weight": [weight.model_copy(update={"angle": 2.0, "unbalance": 31**2 / 29**2})],
            }
        ),
    ]
    only = Cylinder(number=1, shaft="crank", throw=1, rod_length=4.0, reciprocating_mass=1e-12)
    force = total(
        balance(
            Engine.model_validate(
                {"name": "gears", "relative": ["mass"], "shafts": shafts, "cylinders": [only]}
            )
        )
    ).force
    assert spectra.period(force) == 31
    # theta and 2 - 29/31 theta meet where 60/31 theta = 2 + 2 pi n.
    meeting = [(2 + 2 * np.pi * n) * 31 / 60 for n in range(60)]
    strong = spectra.selected(force, [29 / 31, 1.0])
    found = spectra.peak(
        replace(
            strong,
            forward=np.round(strong.forward * 1e-12, 9),
            backward=np.round(strong.backward * 1e-12, 9),
        )
    )
    assert found.value == pytest.approx(2.0, abs=1e-9)
    assert min(abs(found.theta - angle) for angle in meeting) < 1e-4
    assert_peak(spectra.scaled(force, 1e-12))


def varied(machine: Mechanism, shape: tuple[int, ...], seed: int) -> Mechanism:
    """A batch: angles and masses vary freely, rods grow, cranks, knuckles and offsets shrink."""
    rng = np.random.default_rng(seed)

    def times(values: np.ndarray, low: float, high: float) -> np.ndarray:
        return values * rng.uniform(low, high, (*shape, values.size))

    def plus(values: np.ndarray, most: float) -> np.ndarray:
        return values + rng.uniform(-most, most, (*shape, values.size))

    links = machine.links
    return replace(
        machine,
        links=replace(
            links,
            crank_radius=times(links.crank_radius, 0.8, 1.0),
            rod_length=times(links.rod_length, 1.0, 1.3),
            offset=times(links.offset, -1.0, 1.0),
            knuckle_radius=times(links.knuckle_radius, 0.5, 1.0),
            knuckle_angle=plus(links.knuckle_angle, 3.0),
        ),
        throw_angle=plus(machine.throw_angle, 3.0),
        bearing=plus(machine.bearing, 3.0),
        z=plus(machine.z, 0.3),
        **{name: times(getattr(machine, name), 0.0, 2.0) for name in BODIES},
        unbalance=times(machine.unbalance, 0.0, 2.0),
        unbalance_angle=plus(machine.unbalance_angle, 3.0),
        unbalance_z=plus(machine.unbalance_z, 0.3),
        place=plus(machine.place, 0.3),
    )


BODIES = ("reciprocating_mass", "big_end_mass", "rod_mass", "rod_centre", "rod_inertia")


def picked(machine: Mechanism, at: tuple[int, ...]) -> Mechanism:
    """One engine of a batch."""

    def own(record: Any) -> dict[str, Any]:
        return {
            name: np.array(values[at])
            for name, values in vars(record).items()
            if isinstance(values, np.ndarray) and values.ndim > 1
        }

    return replace(machine, links=replace(machine.links, **own(machine.links)), **own(machine))


def assert_rows_alike(batch: Totals, single: Totals, at: tuple[int, ...]) -> None:
    for many, one in zip(batch, single, strict=True):
        scale = max(np.abs(one.forward).max(), np.abs(one.backward).max(), 1e-300)
        orders = np.union1d(many.orders, one.orders)
        of_batch, alone = spectra.selected(many[at], orders), spectra.selected(one, orders)
        assert np.abs(of_batch.forward - alone.forward).max() <= 1e-11 * scale
        assert np.abs(of_batch.backward - alone.backward).max() <= 1e-11 * scale


@pytest.mark.release
@given(engines(tight=False), st.sampled_from([(3,), (2, 2), (1,)]), st.integers(0, 1000))
def test_a_batch_of_engines_is_a_loop_over_them(
    engine: Engine, shape: tuple[int, ...], seed: int
) -> None:
    batch = varied(mechanism(engine), shape, seed)
    reference = Reference(0.1, -0.2, 0.3)
    found = part_spectra(batch, reference=reference)
    for at in np.ndindex(shape):
        assert_rows_alike(found, part_spectra(picked(batch, at), reference=reference), at)


ALONE = [
    "throw_angle",
    "unbalance_angle",
    "unbalance",
    "place",
    "z",
    "reciprocating_mass",
    "big_end_mass",
]


@pytest.mark.release
@given(engines(), st.sampled_from(ALONE))
def test_one_array_with_a_leading_axis_is_enough_for_a_batch(engine: Engine, name: str) -> None:
    machine = mechanism(engine)
    values = getattr(machine, name)
    found = part_spectra(
        replace(machine, **{name: np.stack([values, values * 0.5, values * 0.25])})
    )
    for index, factor in enumerate((1, 0.5, 0.25)):
        single = part_spectra(replace(machine, **{name: values * factor}))
        same = Totals(*(part[index] if part.forward.ndim == 3 else part for part in found))
        assert_rows_alike(same, single, ())


def with_a_rod() -> Mechanism:
    shaft = Shaft.model_validate(
        {"name": "crank", "throw": [{"angle": 0.3, "radius": 1.0, "rotating_mass": 1.0}]}
    )
    rod = Rod(mass=1.0, centre=1.0, inertia=1.0)
    only = Cylinder(
        number=1, shaft="crank", throw=1, rod_length=4.0, reciprocating_mass=1.0, rod=rod
    )
    return mechanism(Engine.model_validate({"name": "one", "shafts": [shaft], "cylinders": [only]}))


@pytest.mark.parametrize("name", ["rod_mass", "rod_centre", "rod_inertia"])
def test_a_batch_may_vary_the_rods_alone(name: str) -> None:
    machine = with_a_rod()
    found = part_spectra(replace(machine, **{name: np.array([[1.0], [2.0], [3.0]])}))
    for index in range(3):
        assert_rows_alike(
            found, part_spectra(replace(machine, **{name: np.array([index + 1.0])})), (index,)
        )


@pytest.mark.parametrize("name", ["unbalance", "unbalance_angle", "z", "place"])
def test_every_result_of_a_batch_has_its_leading_axis(name: str) -> None:
    machine = with_a_rod()
    values = getattr(machine, name)
    batch = replace(machine, **{name: np.stack([values, values + 1, values + 2])})
    assert [part.forward.shape for part in totals(batch, orders=[1, 2], block=2)] == 4 * [(3, 2)]


@pytest.mark.release
@given(engines(tight=False), st.integers(0, 1000), st.integers(1, 6))
def test_sums_over_a_long_batch_are_the_same_block_by_block(
    engine: Engine, seed: int, block: int
) -> None:
    batch, orders, reference = (
        varied(mechanism(engine), (5,), seed),
        [1, 2, 2.5, 4],
        Reference(0.1, -0.2, 0.3),
    )
    found = totals(batch, orders=orders, reference=reference, block=block)
    for index in range(5):
        single = part_spectra(picked(batch, (index,)), reference=reference)
        for many, one in zip(found, single, strict=True):
            wanted, whole = (
                spectra.selected(one, orders),
                spectra.selected(spectra.total(one), orders),
            )
            scale = max(
                (np.abs(wanted.forward) + np.abs(wanted.backward)).max(),
                np.abs(one.forward).max(),
                1e-300,
            )
            assert np.array_equal(many.orders, orders)
            assert np.abs(many.forward[index] - whole.forward).max() <= 1e-11 * scale
            assert np.abs(many.backward[index] - whole.backward).max() <= 1e-11 * scale


@pytest.mark.release
@given(
    engines(),
    st.lists(
        st.sampled_from([0.5, 1.0, 1.5, 2.0, 4 / 3, 29 / 31, 4.0, 40.0]), min_size=1, unique=True
    ),
)
def test_the_orders_asked_for_are_those_of_the_whole_spectrum(
    engine: Engine, orders: list[float]
) -> None:
    machine = mechanism(engine)
    for few, all_of_them in zip(
        part_spectra(machine, orders=orders), part_spectra(machine), strict=True
    ):
        expected = spectra.selected(all_of_them, sorted(orders))
        assert np.allclose(few.orders, expected.orders, atol=1e-6)
        scale = max(np.abs(all_of_them.forward).max(), 1e-300)
        assert np.abs(few.forward - expected.forward).max() <= 1e-13 * scale
        assert np.abs(few.backward - expected.backward).max() <= 1e-13 * scale


@pytest.mark.release
@pytest.mark.parametrize("layout", LAYOUTS)
@settings(max_examples=10)
@given(data=st.data())
def test_every_layout_stands_with_cylinder_1_at_top_dead_centre(
    layout: str, data: st.DataObject
) -> None:
    engine = data.draw(of_layout(layout, moved=False))
    first = min(engine.cylinders, key=lambda cylinder: cylinder.number)
    _, piston, _ = placed(engine, first, np.append(0, AROUND))
    travel = piston @ np.array([np.sin(first.bearing), np.cos(first.bearing)])
    assert travel[0] >= travel.max() - 1e-12 * np.abs(travel).max()


@given(st.integers(1, 9).flatmap(lambda n: st.permutations(range(1, n + 1))), ROTATIONS, CYCLES)
def test_throws_left_out_bring_the_cylinders_to_dead_centre_in_their_order(
    order: list[int], rotation: str, cycle: str
) -> None:
    basis = Basis.model_validate(
        {"name": "in line", "rotation": rotation, "cycle": cycle, "firing_order": order}
    )
    engine = LAYOUTS["inline"](basis)
    sense, turns = (1 if rotation == "clockwise" else -1), (1 if cycle == "two-stroke" else 2)
    for cylinder in engine.cylinders:
        theta = 2 * np.pi * turns * (order.index(cylinder.number) - order.index(1)) / len(order)
        pin = engine.shafts[0].throws[cylinder.throw - 1].angle + sense * theta
        assert np.exp(1j * pin) == pytest.approx(1, abs=1e-12)


@pytest.mark.parametrize("third", [0.1105, 0.1111, 0.1112, 0.1113, 0.112, 0.118])
def test_a_summit_that_has_just_parted_in_two_is_climbed(third: float) -> None:
    """sin x + c sin 3x has a flat top at c = 1/9, beyond it two summits about a hollow sample."""
    signal = spectra.real_signal(np.array([1.0, 3.0]), np.array([-1j, -1j * third]))
    angles = np.linspace(0, np.pi, 400_001)
    highest = np.abs(np.sin(angles) + third * np.sin(3 * angles)).max()
    assert spectra.peak(signal).value == pytest.approx(highest, rel=2e-9)
    assert spectra.peaks(signal) == pytest.approx(highest, rel=2e-9)


@pytest.mark.parametrize(("length", "offset"), [(0.9, 0.0), (1.2, 0.3), (1.2, -0.3)])
def test_a_rod_that_does_not_reach_has_no_motion(length: float, offset: float) -> None:
    """Neither by harmonics nor angle by angle."""
    with pytest.raises(ValueError, match="too short to reach"):
        motion.piston_harmonics(crank_radius=1.0, rod_length=length, offset=offset)
    four = load("i4")
    radius = four.shafts[0].throws[0].radius
    sizes = {"rod_length": length * radius, "offset": offset * radius}
    short = four.model_copy(
        update={"cylinders": tuple(each.model_copy(update=sizes) for each in four.cylinders)}
    )
    with pytest.raises(ValueError, match="too short to reach"):
        motion.rods(motion.linkage(short), np.linspace(0.0, 6.3, 90))
