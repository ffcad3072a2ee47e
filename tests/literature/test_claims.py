"""The founding documents: their true statements and their errors (claims.json, with locators)."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import permutations
from math import atan, hypot, pi, radians, sqrt
from typing import Any

import numpy as np
import pytest
from tests.claims import CLAIMS

import crankstar
from crankstar import spectra
from crankstar.engine import motion
from crankstar.engine.dead_centres import dead_centres
from crankstar.engine.engine import Engine
from crankstar.firing.intervals import firing
from crankstar.firing.strokes import disturbances, exhaust_groups, working_cycle
from crankstar.firing.strokes import exhaust_intervals as strokes_intervals
from crankstar.mechanics.balance import Reference, balance, grouped, mechanism, part_spectra, total
from crankstar.spectra import Spectrum

EXACT = 1e-12
ANGLES = np.radians(np.arange(0, 360, 5))
V8S = {"v8-flat-plane": CLAIMS["v8_flat_plane"], "v8-cross-plane": CLAIMS["v8_cross_plane"]}


def number(claim: float | str) -> float:
    """A claim such as 0, 0.8516, "4*sqrt(2)", "-sqrt(10)"."""
    if not isinstance(claim, str):
        return float(claim)
    sign, text = (-1, claim[1:]) if claim.startswith("-") else (1, claim)
    factor, _, root = text.rpartition("sqrt(")
    return sign * float(factor.rstrip("*") or 1) * sqrt(float(root.rstrip(")")))


def harmonic(engine: Engine, order: int) -> float:
    """A_k of the engine's first cylinder."""
    first = engine.first
    harmonics = motion.piston_harmonics(
        crank_radius=engine.throw(first).radius, rod_length=first.rod_length, offset=first.offset
    )
    return float(harmonics[order].real)


def sums(engine: Engine, order: int) -> tuple[Spectrum, Spectrum]:
    """Force and couple of one order in units of m r w^2 A_k and m r w^2 A_k a."""
    whole = total(balance(engine))
    factor = 1 / harmonic(engine, order)
    return (
        spectra.scaled(spectra.selected(whole.force, order), factor),
        spectra.scaled(spectra.selected(whole.couple, order), factor),
    )


def upright(spectrum: Spectrum) -> complex:
    """The amplitude of the order's upward component; in line, the sum over the crank star."""
    return complex(spectra.vertical(spectrum)[0])


# The series of the piston's acceleration


@pytest.mark.parametrize("order", [1, 2, 4, 6, 8])
def test_exact_harmonics_are_those_of_the_claims(order: int) -> None:
    found = motion.piston_harmonics(crank_radius=1, rod_length=1 / CLAIMS["series"]["lambda"])[
        order
    ].real
    assert found == pytest.approx(CLAIMS["series"]["A"][str(order)], abs=1e-14)


def in_rods_over_stroke(order: int, power: int) -> Fraction:
    """Our coefficient of 1/L^power, L = rod length over stroke as in the pages: R/l is 1/(2 L)."""
    return motion.series_coefficient(order, power) / 2**power


@pytest.mark.parametrize("order", [2, 4, 6])
def test_the_true_series_in_rod_length_over_stroke(order: int) -> None:
    true = {
        int(power): Fraction(text)
        for power, text in CLAIMS["series"]["true_in_powers_of_1_over_L"][str(order)].items()
    }
    assert {
        power: value for power in range(6) if (value := in_rods_over_stroke(order, power))
    } == true


@pytest.mark.parametrize("page", CLAIMS["series"]["printed_in_powers_of_1_over_L"])
def test_printed_series_coefficients_are_wrong_where_marked_and_right_elsewhere(page: str) -> None:
    printed = CLAIMS["series"]["printed_in_powers_of_1_over_L"][page]
    order, coefficients = printed["order"], printed["coefficients"]
    wrong = [
        power
        for power, text in coefficients.items()
        if Fraction(text) != in_rods_over_stroke(order, int(power))
    ]
    assert wrong == printed["wrong"]


@pytest.mark.parametrize(
    ("page", "off_by"),
    [
        ("2, both pages", 1.9e-3),
        ("4, flat-plane page", 3.7e-3),
        ("4, cross-plane page", 9e-5),
        ("6, flat-plane page", 3.4e-5),
    ],
)
def test_printed_series_miss_the_exact_harmonic_and_the_true_ones_do_not(
    page: str, off_by: float
) -> None:
    printed = CLAIMS["series"]["printed_in_powers_of_1_over_L"][page]
    order, length = printed["order"], 2.0  # rod over stroke 2 is r/l = 1/4
    exact = CLAIMS["series"]["A"][str(order)]
    value = sum(
        float(Fraction(text)) / length ** int(power)
        for power, text in printed["coefficients"].items()
    )
    assert abs(value - exact) > off_by
    assert motion.series(order, ratio=0.25, highest_power=5) == pytest.approx(exact, abs=2e-5)


# The two V8 pages


@pytest.mark.parametrize("name", V8S)
def test_v8_dead_centres_and_banks_are_those_of_the_claims(name: str) -> None:
    engine, claim = crankstar.load(name), V8S[name]
    assert list(engine.firing_order) == claim["firing_order"]
    found = {number: round(centre.angle_deg, 6) for number, centre in dead_centres(engine).items()}
    assert found == {int(number): angle for number, angle in claim["tdc_deg"].items()}
    for cylinder in engine.cylinders:
        side = claim["bearing_deg"]["odd" if cylinder.number % 2 else "even"]
        assert np.degrees(cylinder.bearing) == pytest.approx(side, abs=EXACT)


@pytest.mark.parametrize("name", V8S)
def test_v8_order_is_refused_with_the_banks_on_the_other_sides(name: str) -> None:
    claim = V8S[name]
    banks = [
        {"bearing": f"{-claim['bearing_deg'][side]} deg", "cylinders": numbers}
        for side, numbers in (("odd", [1, 3, 5, 7]), ("even", [2, 4, 6, 8]))
    ]
    with pytest.raises(crankstar.EngineFileError, match="banks on the other sides"):
        crankstar.load(name, changes={"layout.banks": banks})


@pytest.mark.parametrize(
    ("name", "order"), [(name, order) for name, claim in V8S.items() for order in claim["force"]]
)
def test_v8_force_is_the_closed_form_of_the_claims_with_its_sign(name: str, order: str) -> None:
    force, _ = sums(crankstar.load(name), int(order))
    claim = V8S[name]["force"][order]
    up, right = complex(spectra.vertical(force)[0]), complex(spectra.horizontal(force)[0])
    assert up == pytest.approx(number(claim["vertical"]), abs=1e-9)
    assert abs(right) == pytest.approx(number(claim["horizontal"]), abs=1e-9)
    if abs(right) > 1e-9:  # at theta = 0 away from the odd bank, which stands on the left
        assert right.real < 0
        assert right.imag == pytest.approx(0, abs=1e-9)


def test_flat_plane_second_order_points_to_the_odd_bank_when_cylinder_1_is_at_top_dead_centre() -> (
    None
):
    engine = crankstar.load("v8-flat-plane")
    force, _ = sums(engine, 2)
    vector = complex(spectra.value(force, 0.0))
    odd = np.exp(1j * engine.first.bearing)
    assert (vector * np.conj(odd)).real > 0
    assert vector == pytest.approx(-4j * sqrt(2), abs=1e-9)


def printed_vector(formula: dict[str, list], order: int) -> np.ndarray:
    """A printed pair of formulas, vertical and horizontal, over a turn."""
    wave = {"cos": np.cos, "sin": np.sin}
    up, right = (
        amplitude * wave[function](order * ANGLES + phase * pi)
        for amplitude, function, phase in (formula["vertical"], formula["horizontal"])
    )
    return up + 1j * right


PRINTED = [(name, key) for name, claim in V8S.items() for key in claim["printed_formulas"]["force"]]


@pytest.mark.parametrize(("name", "key"), PRINTED)
def test_v8_printed_rotating_forces_are_wrong_in_every_frame(name: str, key: str) -> None:
    formula = V8S[name]["printed_formulas"]["force"][key]
    order = int(key.split(",")[0])
    printed = printed_vector(formula, order)
    force, _ = sums(crankstar.load(name), order)
    true = spectra.value(force, ANGLES)
    assert np.ptp(np.abs(printed)) < 1e-9  # a circle of radius 4 is printed
    assert np.abs(printed).max() == pytest.approx(4)
    for turned in np.exp(
        1j * np.radians(np.arange(0, 360, 15))
    ):  # no frame and no sign saves it: a circle is no line
        assert np.abs(printed - turned * true).max() > 1.5
        assert np.abs(printed.conj() - turned * true).max() > 1.5


def test_flat_plane_couple_of_the_bank_offset_is_vertical_and_does_not_rotate() -> None:
    engine, claim = crankstar.load("v8-flat-plane"), CLAIMS["v8_flat_plane"]
    odd, even = (next(c.z for c in engine.cylinders if c.number == number) for number in (1, 2))
    offset = (odd - even) / engine.pitch
    assert offset > 0
    for order in ("1", "2"):
        _, couple = sums(engine, int(order))
        for part, component in ((spectra.vertical, "vertical"), (spectra.horizontal, "horizontal")):
            assert complex(part(couple)[0]) == pytest.approx(
                number(claim["couple_per_b"][order][component]) * offset, abs=1e-9
            )
    _, couple = sums(engine, 2)
    printed = printed_vector(claim["printed_formulas"]["couple_per_b"]["2"], 2)
    assert np.abs(printed - spectra.value(couple, ANGLES) / offset).max() > 2


def test_flat_plane_couple_changes_sign_when_the_other_bank_leads() -> None:
    couples = [
        sums(crankstar.load("v8-flat-plane", changes={"layout.bank_offset": offset}), 2)[1]
        for offset in (0.3, -0.3)
    ]
    assert upright(couples[0]) == pytest.approx(0.3 * 2 * sqrt(2), abs=1e-9)
    assert upright(couples[1]) == pytest.approx(-0.3 * 2 * sqrt(2), abs=1e-9)


@pytest.mark.parametrize("bank", ["odd", "even"])
def test_flat_plane_second_order_couple_of_each_bank_vanishes_about_its_own_middle(
    bank: str,
) -> None:
    engine = crankstar.load("v8-flat-plane")
    places = [c.z for c in engine.cylinders if c.bank == bank]
    middle = Reference((min(places) + max(places)) / 2)
    couple = grouped(balance(engine, reference=middle), "bank")[bank].couple
    assert np.abs(spectra.value(spectra.selected(couple, [1, 2]), ANGLES)).max() < 1e-9


@pytest.mark.parametrize("offset", [0.0, 0.2, -0.35])
def test_cross_plane_couple_is_the_printed_circle_whatever_the_bank_offset(offset: float) -> None:
    claim = CLAIMS["v8_cross_plane"]["couple_per_a"]
    engine = crankstar.load("v8-cross-plane", changes={"layout.bank_offset": offset})
    _, couple = sums(engine, 1)
    vector = number(claim["1"]["forward"]) * np.exp(1j * radians(claim["1"]["forward_phase_deg"]))
    assert complex(couple.forward[0]) == pytest.approx(complex(vector), abs=1e-9)
    assert abs(couple.backward[0]) < 1e-9
    printed = -sqrt(10) * np.exp(1j * (ANGLES - pi / 4 - atan(3)))  # vertical cos, horizontal sin
    assert np.allclose(spectra.value(couple, ANGLES), printed, rtol=0, atol=1e-9)
    _, second = sums(engine, 2)
    assert np.abs(spectra.value(second, ANGLES)).max() < 1e-9


def exhaust_intervals(engine: Engine, bank: str) -> list[float]:
    fired = firing(engine)
    own = {c.number for c in engine.cylinders if c.bank == bank}
    angles = [
        angle for number, angle in zip(fired.order, fired.angles_deg, strict=True) if number in own
    ]
    return [
        round(later - sooner, 6)
        for sooner, later in zip(angles, [*angles[1:], angles[0] + fired.cycle_deg], strict=True)
    ]


def test_exhaust_intervals_of_the_banks() -> None:
    flat, cross = crankstar.load("v8-flat-plane"), crankstar.load("v8-cross-plane")
    assert exhaust_intervals(flat, "odd") == exhaust_intervals(flat, "even") == [180] * 4
    assert (
        exhaust_intervals(cross, "odd")
        == CLAIMS["v8_cross_plane"]["bank_exhaust_intervals_deg"]["odd"]
    )


def test_the_exhausts_of_the_banks_are_those_of_the_two_v8_pages() -> None:
    """Source: the two V8 pages: with a flat plane each bank exhausts every 180 deg.

    With a cross plane cylinders 5 and 7 exhaust only 90 deg apart.
    """
    flat, cross = (crankstar.load(name) for name in ("v8-flat-plane", "v8-cross-plane"))
    for group in exhaust_groups(flat):
        assert [
            step.interval_deg for step in strokes_intervals(working_cycle(flat), group.chambers)
        ] == [180] * 4
    steps = strokes_intervals(working_cycle(cross), cross.banks["odd"])
    assert [step.first for step in steps] == [1, 3, 5, 7]
    assert [step.interval_deg for step in steps] == CLAIMS["v8_cross_plane"][
        "bank_exhaust_intervals_deg"
    ]["odd"]
    assert [step for step in steps if step.interval_deg == 90] == [(5, 7, 90)]
    found = {
        (one.blowing, one.disturbed): one
        for one in disturbances(working_cycle(cross), cross.banks["odd"])
    }
    assert (
        found[7, 5].both_open_deg == 0
    )  # into the open exhaust of 5, long before its intake opens
    assert found[7, 5].exhaust_open_deg == pytest.approx(50)


# The KR250 essay: orders 1 and 2, A2 = 1/4

KR250 = {
    ("contra", 180): "kr250-racer",
    ("contra", 0): "kr250-racer-simultaneous",
    ("same", 180): "kr250-production",
}


def as_the_essay(force: Spectrum, exact: float) -> Spectrum:
    """Orders 1 and 2 only, the second with A2 = 1/4 instead of the exact one."""
    both = spectra.selected(force, [1, 2])
    share = np.array([1.0, CLAIMS["kr250"]["A2"] / exact])
    return spectra.scaled(both, share)


def row_of(row: dict[str, Any]) -> Engine:
    return crankstar.load(
        KR250[row["rotation"], row["phase_deg"]], changes={"balance_factor": row["factor"]}
    )


def row_name(row: dict[str, Any]) -> str:
    return f"{row['rotation']}-{row['phase_deg']}-{row['factor']}"


KR_ROWS: list[dict[str, Any]] = CLAIMS["kr250"]["rows"]
WITH_COUPLE = [row for row in KR_ROWS if "couple_about_middle_PL" in row]


@pytest.mark.parametrize("row", KR_ROWS, ids=row_name)
def test_kr250_forces_as_the_essay_counts_them(row: dict[str, Any]) -> None:
    engine = row_of(row)
    force = as_the_essay(total(balance(engine)).force, harmonic(engine, 2))
    for angle, up in row["up"].items():
        vector = complex(spectra.value(force, radians(float(angle))))
        assert vector.real == pytest.approx(up, abs=1e-9)
        assert abs(vector.imag) == pytest.approx(row["right_magnitude"][angle], abs=1e-9)


@pytest.mark.parametrize("row", KR_ROWS, ids=row_name)
def test_kr250_forces_at_the_dead_centres_hold_exactly_too(row: dict[str, Any]) -> None:
    force = total(balance(row_of(row))).force  # all orders together are 1 + r/l at top dead centre
    for angle in ("0", "180"):
        assert complex(spectra.value(force, radians(float(angle)))).real == pytest.approx(
            row["up"][angle], abs=1e-9
        )


@pytest.mark.parametrize("row", WITH_COUPLE, ids=row_name)
def test_kr250_couple_is_a_roll_about_the_middle_of_the_cylinders(row: dict[str, Any]) -> None:
    engine, claim = row_of(row), row["couple_about_middle_PL"]["0"]
    pitch = engine.shafts[1].right
    by_shaft = grouped(balance(engine), "shaft")
    ups = [
        complex(
            spectra.value(as_the_essay(by_shaft[shaft.name].force, harmonic(engine, 2)), 0.0)
        ).real
        for shaft in engine.shafts
    ]
    assert (ups[0] - ups[1]) / 2 == pytest.approx(
        claim, abs=1e-9
    )  # clockwise: the left one pushes up
    radius = engine.throw(engine.first).radius
    middle = balance(engine, reference=Reference(0.0, 0.0, pitch / 2))
    roll = complex(spectra.value(total(middle).axis_moment, 0.0)).real * radius / pitch
    assert roll == pytest.approx(claim, abs=1e-9)
    if (
        row["factor"] == 0.5
    ):  # the printed 0.25 P L holds about the first crankshaft, where it leaves 0.5 P on its line
        first = (
            complex(spectra.value(total(balance(engine)).axis_moment, 0.0)).real * radius / pitch
        )
        assert first == pytest.approx(CLAIMS["kr250"]["printed_couple_PL"], abs=1e-9)
        assert abs(CLAIMS["kr250"]["printed_couple_PL"] - claim) > 0.2


@pytest.mark.parametrize(("factor", "length"), CLAIMS["kr250"]["sideways_and_down"].items())
def test_kr250_at_90_degrees_sideways_and_down_together(factor: str, length: float) -> None:
    row = next(
        r
        for r in CLAIMS["kr250"]["rows"]
        if (r["rotation"], r["phase_deg"], r["factor"]) == ("contra", 180, float(factor))
    )
    assert hypot(row["right_magnitude"]["90"], row["up"]["90"]) == pytest.approx(length, abs=0.005)


def test_one_cylinder_of_the_essay() -> None:
    engine = crankstar.load("single")
    force = as_the_essay(total(balance(engine)).force, harmonic(engine, 2))
    for angle, up in CLAIMS["kr250"]["single"].items():
        assert complex(spectra.value(force, radians(float(angle)))) == pytest.approx(up, abs=1e-9)


def test_parallel_twin_of_the_essay_has_a_turning_primary_couple_of_half_p_a() -> None:
    engine = crankstar.load("parallel-twin-180")
    force, couple = sums(engine, 1)
    assert np.abs(spectra.value(force, ANGLES)).max() < 1e-12
    assert np.allclose(np.abs(spectra.value(couple, ANGLES)), 0.5, rtol=0, atol=1e-12)


def test_the_note_of_the_parallel_twin_names_the_way_in_which_its_couple_turns() -> None:
    """Its pins are counterweighted by half: of each piston's P cos the half that turns back stays.

    At top dead centre of the front cylinder, a quarter turn later and so on: the front piston has
    P cos(theta) up, the weight half of it opposite the pin, up + i right; the arms are +-1/2.
    """
    engine = crankstar.load("parallel-twin-180")
    theta = ANGLES
    force = np.cos(theta) - 0.5 * np.exp(1j * theta)
    own = 0.5 * force - (-0.5) * force  # the other pin is opposite, and so is its arm
    assert np.allclose(own, 0.5 * np.exp(-1j * theta), rtol=0, atol=1e-12)
    _, couple = sums(engine, 1)
    assert np.allclose(spectra.value(couple, theta), own, rtol=0, atol=1e-12)
    assert "0.5 P a that turns against the crankshaft" in engine.notes


# Sinitsyn's in-line engines

SINITSYN = {
    "sinitsyn-6-valve": (0, "order", 1),
    "sinitsyn-6-valve-mirror": (0, "mirror", -1),
    "sinitsyn-6-loop": (1, "order", 1),
    "sinitsyn-6-loop-mirror": (1, "mirror", -1),
    "sinitsyn-7-first": (2, "order", 1),
    "sinitsyn-7-first-mirror": (2, "mirror", -1),
    "sinitsyn-7-first-four-stroke": (2, "four_stroke", 1),
    "sinitsyn-7-first-four-stroke-mirror": (2, "four_stroke_mirror", -1),
    "sinitsyn-7-second": (3, "order", 1),
    "sinitsyn-7-second-four-stroke": (3, "four_stroke", 1),
}
SCHEMES: list[dict[str, Any]] = CLAIMS["sinitsyn"]


@pytest.mark.parametrize("name", SINITSYN)
def test_sinitsyn_moments_and_their_planes(name: str) -> None:
    place, key, mirrored = SINITSYN[name]
    claim, engine = SCHEMES[place], crankstar.load(name)
    assert list(engine.firing_order) == claim[key]
    for order, moment in ((1, "M_I"), (2, "M_II")):
        force, couple = sums(engine, order)
        assert np.abs(spectra.value(force, ANGLES)).max() < 1e-9
        vector, size = upright(couple), number(claim[moment])
        assert abs(vector) == pytest.approx(
            size, abs=1e-9 if isinstance(claim[moment], str) else 5e-5
        )
        if f"{moment}_deg" in claim:
            assert np.degrees(np.angle(vector)) == pytest.approx(
                mirrored * claim[f"{moment}_deg"], abs=5e-3
            )
        if "printed" in claim:  # rounded to hundredths, the angles cut to whole degrees
            assert size == pytest.approx(claim["printed"][moment], abs=0.006)
            assert abs(claim[f"{moment}_deg"] - claim["printed"][f"{moment}_deg"]) < 1


@pytest.mark.many(first=8)
@pytest.mark.parametrize("name", SINITSYN)
def test_sinitsyn_rotating_parts_have_the_moment_of_the_first_order(name: str) -> None:
    engine = crankstar.load(name, changes={"cylinder.rotating_mass": 1})
    turning = grouped(balance(engine), "kind")["throw"]
    reciprocating = grouped(balance(engine), "kind")["piston"]
    assert np.abs(turning.force.forward).max() < 1e-9
    rotating_moment = complex(spectra.selected(turning.couple, 1).forward[0])
    assert rotating_moment == pytest.approx(
        upright(spectra.selected(reciprocating.couple, 1)), abs=1e-9
    )


def test_valve_scavenged_six_has_the_components_5_3_1_of_its_opposite_cranks() -> None:
    engine = crankstar.load("sinitsyn-6-valve")
    force = grouped(balance(engine), "cylinder")
    places = {c.number: c.z for c in engine.cylinders}
    for (front, rear), arm in zip(((1, 6), (2, 5), (3, 4)), SCHEMES[0]["components"], strict=True):
        vectors = [upright(spectra.selected(force[number].force, 1)) for number in (front, rear)]
        assert vectors[0] == pytest.approx(-vectors[1], abs=1e-12)
        assert abs(vectors[0]) * (places[front] - places[rear]) == pytest.approx(arm, abs=1e-12)


def test_second_scheme_of_seven_is_better_by_the_factors_claimed() -> None:
    schemes = [crankstar.load(name) for name in ("sinitsyn-7-first", "sinitsyn-7-second")]
    gains = [
        abs(upright(sums(schemes[0], k)[1])) / abs(upright(sums(schemes[1], k)[1])) for k in (1, 2)
    ]
    claimed = SCHEMES[3]["smaller_than_first_scheme"]
    assert gains == pytest.approx([claimed["M_I"], claimed["M_II"]], abs=0.005)


@pytest.mark.parametrize("place", [1, 2, 3, 4])
def test_four_stroke_eight_is_balanced_in_all_six_respects(place: int) -> None:
    engine = crankstar.load(
        f"sinitsyn-8-four-stroke-{place}", changes={"cylinder.rotating_mass": 1}
    )
    assert list(engine.firing_order) == SCHEMES[4]["orders"][place - 1]
    whole = total(balance(engine))
    for spectrum in (whole.force, whole.couple):
        assert np.abs(spectra.value(spectra.selected(spectrum, [1, 2]), ANGLES)).max() < 1e-9
    assert firing(engine).even


# All two-stroke stars of six and eight, the package's batch beside the bare sum


def stars(count: int) -> tuple[list[tuple[int, ...]], np.ndarray]:
    """Every firing order from cylinder 1 on, and the bearings of its pins [star, cylinder]."""
    orders = [(1, *rest) for rest in permutations(range(2, count + 1))]
    bearings = np.zeros((len(orders), count))
    rows = np.arange(len(orders))[:, None]
    bearings[rows, np.array(orders) - 1] = -2 * pi * np.arange(count) / count
    return orders, bearings


def moments(engine: Engine, bearings: np.ndarray) -> list[np.ndarray]:
    """M_I and M_II of every star, by the package."""
    machine = replace(mechanism(engine), throw_angle=bearings, unbalance_angle=bearings)
    whole = part_spectra(machine, orders=(1, 2))
    couple = np.abs(spectra.vertical(spectra.total(whole.couple)))
    return [couple[:, order - 1] / harmonic(engine, order) for order in (1, 2)]


def bare_moments(bearings: np.ndarray) -> list[np.ndarray]:
    """The same from the star alone: the sum of z exp(i k bearing)."""
    count = bearings.shape[1]
    arms = (count - 1) / 2 - np.arange(count)
    return [np.abs(np.exp(1j * order * bearings) @ arms) for order in (1, 2)]


@pytest.mark.parametrize(("count", "name"), [(6, "sinitsyn-6-loop"), (8, "sinitsyn-8-two-stroke")])
def test_all_stars_by_the_package_and_by_the_bare_sum(count: int, name: str) -> None:
    _, bearings = stars(count)
    for packaged, bare in zip(
        moments(crankstar.load(name), bearings), bare_moments(bearings), strict=True
    ):
        assert np.allclose(packaged, bare, rtol=0, atol=1e-9)


def test_loop_scavenged_six_has_the_least_second_moment_without_a_first_one() -> None:
    orders, bearings = stars(6)
    first, second = bare_moments(bearings)
    free = np.nonzero(first < 1e-9)[0]
    least = second[free].min()
    best = {orders[index] for index in free if second[index] < least + 1e-9}
    assert least == pytest.approx(number(SCHEMES[1]["M_II"]), abs=1e-9)
    assert best == {tuple(SCHEMES[1]["order"]), tuple(SCHEMES[1]["mirror"])}
    assert second[free].max() > least + 0.1  # there are others


def test_two_stroke_eight_of_the_inverse_problem() -> None:
    claim = SCHEMES[5]
    orders, bearings = stars(8)
    first, second = bare_moments(bearings)
    free = np.nonzero(second < 1e-9)[0]
    assert (len(orders), len(free)) == (claim["stars"], claim["with_M_II_zero"])
    least = first[free].min()
    assert least == pytest.approx(claim["least_M_I"], abs=5e-5)
    assert {orders[index] for index in free if first[index] < least + 1e-9} == {
        tuple(order) for order in claim["orders"]
    }


@pytest.mark.parametrize(
    ("name", "place"), [("sinitsyn-8-two-stroke", 0), ("sinitsyn-8-two-stroke-mirror", 1)]
)
def test_two_stroke_eight_of_the_catalog_solves_the_inverse_problem(name: str, place: int) -> None:
    engine = crankstar.load(name)
    assert list(engine.firing_order) == SCHEMES[5]["orders"][place]
    assert abs(upright(sums(engine, 2)[1])) < 1e-9
    assert abs(upright(sums(engine, 1)[1])) == pytest.approx(SCHEMES[5]["least_M_I"], abs=5e-5)
