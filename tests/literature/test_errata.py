"""The errata: the printed is wrong by momentum, ours right; data, claims, command, page agree."""

from __future__ import annotations

import re
import tomllib
from dataclasses import replace
from fractions import Fraction
from math import cos, degrees, pi, radians
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from tests import newton
from tests.claims import CLAIMS
from tests.scripts import script

import crankstar
from crankstar import charts, cli, spectra
from crankstar.analyses.errata.document import errata_document
from crankstar.analysis.document import Table
from crankstar.derive import derivation
from crankstar.derive.algebra import evaluation, typeset
from crankstar.derive.errata import (
    ErrataError,
    Erratum,
    confirmed,
    curves,
    errata,
    momentum,
    series_errors,
    sources,
)
from crankstar.engine import motion
from crankstar.language.messages import spoken
from crankstar.mechanics.balance import balance, total

ROOT = Path(__file__).parents[2]
ALL = {one.id: one for one in errata()}
JUDGED = [one for one in ALL.values() if one.kind in ("result", "step")]
SERIES = [one for one in ALL.values() if one.kind == "series"]
LINES = [one for one in ALL.values() if one.kind == "line"]
ANGLES = [one for one in ALL.values() if one.kind == "angle"]
FINE = 1e-12
RESOLVED = 1e-15
"""Of m r w^2: what rounding leaves of the judge, which starts from places in double precision."""


def each(found: list[Erratum]) -> Any:
    return pytest.mark.parametrize("one", found, ids=lambda one: one.id)


def engine_of(one: Erratum) -> crankstar.Engine:
    return crankstar.load(one.engine, changes=dict(one.changes))


# Results and steps, judged by momentum


@pytest.mark.many(first=2)
@each(JUDGED)
def test_what_is_printed_is_not_what_momentum_says(one: Erratum) -> None:
    found = curves(one)
    off = np.nanmax(np.abs(found.printed - found.momentum))
    assert off >= 0.25 - FINE  # the smallest of all: 0.25 P L of the essay for 0.5 P L
    if one.printed is not None:
        assert off > 0.7 * np.nanmax(np.abs(found.printed))


@pytest.mark.many(first=1)
@each(JUDGED)
def test_what_we_derive_is_what_momentum_says(one: Erratum) -> None:
    found = curves(one)
    scale = max(1.0, np.abs(found.ours).max())
    unit = momentum.harmonic(engine_of(one), one.order)
    off = np.abs(found.ours - found.momentum).max()
    assert off * abs(unit) <= RESOLVED * scale
    if one.order <= 4:
        assert off <= FINE * scale


@pytest.mark.parametrize(
    ("name", "off"),
    [
        ("flat-force-2-up", 4.0),
        ("flat-force-2-right", 4.0),
        ("cross-force-4-even-along", 4 * 2**0.5),
        ("kr250-couple", 0.25),
    ],
)
def test_by_how_much_a_printed_formula_is_off(name: str, off: float) -> None:
    found = curves(ALL[name], 721)
    assert np.nanmax(np.abs(found.printed - found.momentum)) == pytest.approx(off, rel=1e-3)


ROD = {"cylinder.rod": {"mass": 0.5, "centre": 1.2, "inertia": 0.1}, "cylinder.rotating_mass": 0.7}


@pytest.mark.many(first=5)
@pytest.mark.parametrize(
    ("engine", "order", "quantity", "changes"),
    [
        ("v8-flat-plane", 2, "force", {}),
        ("v8-flat-plane", 2, "couple", {}),
        ("kr250-racer", 1, "force", {}),
        ("vw-vr6", 2, "couple", {}),
        ("radial-9", 2, "force", {}),
        ("sinitsyn-7-first", 1, "couple", ROD),
        ("i4", 2, "force", ROD),
    ],
)
def test_the_judge_agrees_with_the_spectra_of_the_package(
    engine: str, order: int, quantity: str, changes: dict[str, Any]
) -> None:
    """Two roads: places differentiated here, laws of force summed there."""
    loaded = crankstar.load(engine, changes=changes)
    whole = spectra.selected(getattr(total(balance(loaded)), quantity), order)
    unit = momentum.harmonic(loaded, order)
    for bearing, part in ((0.0, spectra.vertical), (pi / 2, spectra.horizontal)):
        judged = momentum.component(loaded, order, quantity, bearing) * unit
        assert judged == pytest.approx(complex(part(whole)[0]), abs=1e-11)


def test_the_judge_agrees_with_momentum_in_long_doubles() -> None:
    engine = engine_of(ALL["flat-couple-2-up"])
    reference = crankstar.Reference(*([sum(c.z for c in engine.cylinders) / 8]))
    road = newton.road(engine, reference=reference, speed=1.0)
    moments = np.sum([push.moment for push in road.pushes], axis=0)
    turning = np.exp(-2j * np.asarray(road.theta, float))
    # the couple as a vector of the forces times their arms: up is minus the moment about right
    up = 2 * np.mean(-np.asarray(moments[:, 0], float) * turning)
    first = engine.first
    unit = (
        first.reciprocating_mass
        * engine.throw(first).radius
        * momentum.harmonic(engine, 2)
        * engine.pitch
    )
    assert up / unit == pytest.approx(momentum.component(engine, 2, "couple", 0.0), abs=1e-11)


def test_moment_about_the_middle_of_two_shafts_is_the_roll_of_the_balance() -> None:
    engine = crankstar.load("kr250-racer")
    pitch, radius = engine.shafts[1].right, engine.throw(engine.first).radius
    middle = total(balance(engine, reference=crankstar.Reference(0.0, 0.0, pitch / 2))).axis_moment
    assert momentum.roll(engine, 1) == pytest.approx(
        complex(spectra.amplitude(spectra.selected(middle, 1))[0]) * radius / pitch, abs=FINE
    )


@pytest.mark.many(first=3)
@each([*JUDGED, *SERIES])
def test_the_step_that_slips_is_a_step_of_our_derivation(one: Erratum) -> None:
    if one.kind == "series":
        steps = derivation(crankstar.load("single"), one.order).steps
    else:
        steps = derivation(
            engine_of(one), one.order, "couple" if one.quantity == "couple" else "force"
        ).steps
    assert one.step in [step.title for step in steps]
    assert one.slip


@pytest.mark.many(first=2)
@each([one for one in ALL.values() if one.printed is not None and one.kind in ("result", "step")])
def test_the_printed_text_is_the_printed_formula(one: Erratum) -> None:
    assert one.printed is not None
    assert typeset.text(one.printed) == one.text


# Series


@pytest.mark.release
@each(SERIES)
def test_a_printed_series_misses_the_exact_harmonic_and_the_true_one_misses_it_less(
    one: Erratum,
) -> None:
    found = series_errors(one)
    at_four = int(np.argmin(np.abs(found.ratio - 2)))  # l/r = 4
    assert abs(found.ours[at_four]) < 0.25 * abs(found.printed[at_four])
    assert abs(found.ours[-1]) < 0.1 * abs(found.printed[-1])
    assert np.all(np.diff(np.abs(found.ours)) < 0)  # the longer the rod, the better


@pytest.mark.many(first=2)
@each(SERIES)
def test_the_true_series_is_that_of_motion(one: Erratum) -> None:
    power = {2: 5, 4: 5, 6: 5}[one.order]
    for length in (1.0, 2.0):
        expected = motion.series(one.order, ratio=1 / (2 * length), highest_power=power)
        assert evaluation.value(one.ours, {"L": length}) == pytest.approx(float(expected), rel=FINE)


def test_three_coefficients_are_printed_at_half_their_size() -> None:
    halved = {"series-2": 3, "series-4-cross": 5, "series-6": 5}
    printed = {entry["id"]: dict(entry["terms"]) for entry in data()["series"]}
    assert {name for name in printed if "half its size" in ALL[name].slip} == set(halved)
    for name, power in halved.items():
        true = motion.series_coefficient(ALL[name].order, power) / 2**power
        assert true == 2 * Fraction(printed[name][power])
    assert abs(Fraction(printed["series-4-flat"][5])) == Fraction(printed["series-6"][5])


def test_exact_harmonics_from_places_are_those_of_the_claims() -> None:
    for order in (2, 4, 6):
        assert momentum.harmonics(np.array([2.0]), order)[0] == pytest.approx(
            CLAIMS["series"]["A"][str(order)], abs=1e-14
        )


SERIES_OF = {
    "series-2": "2, both pages",
    "series-4-flat": "4, flat-plane page",
    "series-4-cross": "4, cross-plane page",
    "series-6": "6, flat-plane page",
}


def test_series_are_those_of_the_claims() -> None:
    printed = {entry["id"]: entry["terms"] for entry in data()["series"]}
    assert set(printed) == set(SERIES_OF)
    for name, page in SERIES_OF.items():
        claim = CLAIMS["series"]["printed_in_powers_of_1_over_L"][page]
        assert {str(power): Fraction(value) for power, value in printed[name]} == {
            power: Fraction(value) for power, value in claim["coefficients"].items()
        }
        assert ALL[name].order == claim["order"]
        text = typeset.text(ALL[name].printed)  # pyright: ignore[reportArgumentType]
        plain = ALL[name].text
        assert text in (
            plain,
            "−" + plain.removeprefix("−(").removesuffix(")").replace(" + ", " − "),
        )


# The claims


def data() -> dict[str, Any]:
    return tomllib.loads(
        (ROOT / "src/crankstar/derive/errata/printed.toml").read_text(encoding="utf-8")
    )


PRINTED_OF = [
    (f"{prefix}-{kind}-{order}{suffix}", CLAIMS[page]["printed_formulas"][table][key], int(order))
    for prefix, kind, page, table, key, order, suffix in [
        ("flat", "force", "v8_flat_plane", "force", "2", "2", ""),
        ("flat", "force", "v8_flat_plane", "force", "4", "4", ""),
        ("flat", "force", "v8_flat_plane", "force", "6", "6", ""),
        ("flat", "couple", "v8_flat_plane", "couple_per_b", "2", "2", ""),
        ("cross", "force", "v8_cross_plane", "force", "4", "4", ""),
        ("cross", "force", "v8_cross_plane", "force", "4, second way", "4", "-again"),
    ]
]


@pytest.mark.release
@pytest.mark.parametrize(("name", "claim", "order"), PRINTED_OF, ids=[row[0] for row in PRINTED_OF])
def test_printed_formulas_are_those_of_the_claims(
    name: str, claim: dict[str, list], order: int
) -> None:
    for side, component in (("vertical", "up"), ("horizontal", "right")):
        amplitude, function, phase = claim[side]
        found = curves(ALL[f"{name}-{component}"], 25)
        wave = {"cos": np.cos, "sin": np.sin}[function]
        assert found.printed == pytest.approx(
            amplitude * wave(order * found.theta + phase * pi), abs=FINE
        )


def claimed(text: float | str) -> float:
    return float(evaluation.value(crankstar.derive.errata.reading.size(str(text))))


@pytest.mark.release
@pytest.mark.parametrize(("name", "page"), [("flat", "v8_flat_plane"), ("cross", "v8_cross_plane")])
def test_true_formulas_have_the_sizes_of_the_claims(name: str, page: str) -> None:
    for order, claim in CLAIMS[page]["force"].items():
        for side, component in (("vertical", "up"), ("horizontal", "right")):
            one = ALL.get(f"{name}-force-{order}-{component}")
            if one is not None:
                assert np.abs(curves(one).ours).max() == pytest.approx(
                    claimed(claim[side]), abs=FINE
                )


def test_true_couple_of_the_bank_offset_is_that_of_the_claims_with_the_even_bank_in_front() -> None:
    up, right = (curves(ALL[f"flat-couple-2-{side}"]).ours for side in ("up", "right"))
    claim = CLAIMS["v8_flat_plane"]["couple_per_b"]["2"]  # for the odd bank in front
    assert up[0] == pytest.approx(-claimed(claim["vertical"]), abs=FINE)
    assert np.abs(right).max() == pytest.approx(claimed(claim["horizontal"]), abs=FINE)
    engine = engine_of(ALL["flat-couple-2-up"])
    odd, even = (next(c.z for c in engine.cylinders if c.number == number) for number in (1, 2))
    assert even > odd  # the page's arms are b/2 + 1.5 a and -b/2 + 1.5 a


def test_the_two_ways_of_the_cross_plane_page_print_one_value() -> None:
    for side in ("up", "right"):
        first, again = (curves(ALL[f"cross-force-4{way}-{side}"]).printed for way in ("", "-again"))
        assert first == pytest.approx(again, abs=FINE)


def test_couple_of_the_essay_is_that_of_the_claims() -> None:
    one = ALL["kr250-couple"]
    found = curves(one)
    row = next(
        row
        for row in CLAIMS["kr250"]["rows"]
        if (row["rotation"], row["phase_deg"], row["factor"]) == ("contra", 180, 0.5)
    )
    assert found.printed[0] == CLAIMS["kr250"]["printed_couple_PL"]
    assert found.ours[0] == pytest.approx(row["couple_about_middle_PL"]["0"])
    assert np.count_nonzero(~np.isnan(found.printed)) == len(one.points) == 2


@pytest.mark.many(first=12)
@pytest.mark.parametrize("one", confirmed(), ids=lambda one: f"{one.source}: {one.words}")
def test_what_is_called_true_is_true(one: Any) -> None:
    found = derivation(crankstar.load(one.engine), one.order, one.quantity)
    expected = evaluation.value(one.size)
    assert found.zero == (expected == 0)
    whole = spectra.selected(
        getattr(total(balance(crankstar.load(one.engine))), one.quantity), one.order
    )
    pitch = 1.0
    assert spectra.peak(whole).value / abs(found.scale) * pitch == pytest.approx(expected, abs=1e-9)


# Lines that do not follow, and angles


@pytest.mark.many(first=2)
@each(LINES)
def test_a_line_differs_from_the_one_it_should_equal(one: Erratum) -> None:
    assert one.printed is not None
    points = [{"theta": t, "alpha": t, "a": 1.0, "b": 0.37, "L": 1.0} for t in (0.1, 0.7, 1.3, 2.9)]
    off = [abs(evaluation.value(one.printed, at) - evaluation.value(one.ours, at)) for at in points]
    assert max(off) > 0.4


@pytest.mark.release
@pytest.mark.parametrize("share", ["flat-share", "cross-share"])
def test_shares_of_a_push_are_exchanged_unless_the_bank_angle_is_90_degrees(share: str) -> None:
    half = radians(22.5)
    first = crankstar.load("harley-45").first
    assert abs(first.bearing) == pytest.approx(half)
    at = {"alpha": half, "L": 1.0}
    assert evaluation.value(ALL[f"{share}-up"].ours, at) == pytest.approx(cos(first.bearing))
    printed = ALL[f"{share}-up"].printed
    assert printed is not None
    assert evaluation.value(printed, at) != pytest.approx(cos(first.bearing), abs=0.1)
    same = {"alpha": pi / 4, "L": 1.0}
    assert evaluation.value(printed, same) == pytest.approx(cos(pi / 4))


@pytest.mark.parametrize(
    ("name", "scheme", "key"),
    [("sinitsyn-7-first-angle", 2, "M_I_deg"), ("sinitsyn-7-second-angle", 3, "M_II_deg")],
)
def test_angles_of_the_chapter_are_cut(name: str, scheme: int, key: str) -> None:
    one, claim = ALL[name], CLAIMS["sinitsyn"][scheme]
    true, printed = (degrees(evaluation.value(f)) for f in (one.ours, one.printed))  # pyright: ignore[reportArgumentType]
    assert true == pytest.approx(claim[key], abs=0.005)
    assert printed == pytest.approx(claim["printed"][key])
    assert 0.5 < abs(true - printed) < 1
    assert int(true) == round(printed)
    assert f"{round(true)}°".replace("-", "−") in one.slip


# What shows them


def run(capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, str, str]:
    with pytest.raises(SystemExit) as left:
        cli.main(["errata", *words])
    shown = capsys.readouterr()
    return int(left.value.code or 0), shown.out, shown.err


def test_the_command_prints_every_erratum_with_the_true_formula(
    capsys: pytest.CaptureFixture[str],
) -> None:
    code, out, _ = run(capsys)
    assert code == 0
    rows = [re.split(r"\s{2,}", line.strip()) for line in out.splitlines()]
    for one in ALL.values():
        assert any(row[-2:] == [one.text, typeset.text(one.ours)] for row in rows), one.id


def test_the_command_fits_80_columns(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("crankstar.cli.output.terminal_width", lambda: 80)
    _, out, _ = run(capsys)
    assert max(map(len, out.splitlines())) <= 80
    assert "…" not in out.replace("… ", "").replace("…°", "")


def test_the_command_shows_one_source(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    place = tmp_path / "errata.txt"
    code, out, _ = run(capsys, "--source", "kr250", "-o", str(place))
    assert (code, out) == (0, "")
    written = place.read_text(encoding="utf-8")
    assert "0.5 cos θ" in written
    assert "yamamoto2012" not in written


def test_a_source_without_errata_is_refused_with_those_there_are(
    capsys: pytest.CaptureFixture[str],
) -> None:
    code, out, err = run(capsys, "--source", "taylor1985")
    assert (code, out) == (2, "")
    assert err.count("\n") == 1
    assert "taylor1985" in err
    assert all(source in err for source in sources())


def test_questions_without_an_answer_are_refused() -> None:
    with pytest.raises(ErrataError, match="no curves over a turn"):
        curves(SERIES[0])
    with pytest.raises(ErrataError, match="not a series"):
        series_errors(JUDGED[0])


@pytest.fixture(scope="module")
def page() -> str:
    return script("hooks").filled(
        (ROOT / "docs" / "explanation" / "errata.md").read_text(encoding="utf-8")
    )


@pytest.mark.release
def test_every_source_is_on_the_page_and_in_the_references(page: str) -> None:
    assert set(
        re.findall(
            r"^<!-- errata: (\w+) -->$",
            (ROOT / "docs/explanation/errata.md").read_text(encoding="utf-8"),
            re.MULTILINE,
        )
    ) == set(sources())
    known = script("hooks").entries(
        (ROOT / "docs" / "reference" / "references.bib").read_text(encoding="utf-8")
    )
    assert set(sources()) <= set(known)
    assert all(f"references.md#{source}" in page for source in sources())


@pytest.mark.release
@each(list(ALL.values()))
def test_the_page_has_each_erratum_with_both_formulas_and_the_slip(page: str, one: Erratum) -> None:
    assert one.slip in page
    rows = [row for row in page.splitlines() if f'<a id="{one.id}"></a>' in row]
    assert len(rows) == 1
    assert f'<math alttext="{typeset.text(one.ours)}">' in rows[0]
    assert one.text in rows[0] or (
        one.printed is not None and f'<math alttext="{typeset.text(one.printed)}">' in rows[0]
    )


@pytest.mark.release
def test_every_result_has_a_drawing_with_a_title_and_nothing_from_elsewhere(page: str) -> None:
    drawings = re.findall(r"<svg.*?</svg>", page)
    assert len(drawings) == len([one for one in ALL.values() if one.drawn])
    for drawing in drawings:
        root = ElementTree.fromstring(drawing)  # noqa: S314 - our own
        assert root.find("{http://www.w3.org/2000/svg}title") is not None
        assert not re.search(r"(?:href|src)=|url\(", drawing)
        assert charts.GREY not in drawing


def test_a_drawing_shows_printed_true_and_momentum_where_they_are() -> None:
    one = ALL["flat-force-2-right"]
    found = curves(one)
    chart = charts.judged(
        theta=found.theta,
        printed=found.printed,
        ours=found.ours,
        momentum=found.momentum,
        axis="force (N)",
    )
    layers = chart.to_dict()["layer"]
    by_name = {layer["data"]["values"][0]["what"]: layer for layer in layers}
    assert set(by_name) == {"printed", "correct formula", "momentum"}
    assert by_name["correct formula"]["data"]["values"][0] == {
        "x": 0.0,
        "y": pytest.approx(-4 * 2**0.5),
        "what": "correct formula",
    }
    assert by_name["printed"]["data"]["values"][0]["y"] == pytest.approx(-4 * 2**-0.5)
    assert by_name["momentum"]["mark"]["type"] == "point"
    assert all(layer["encoding"]["y"]["title"] == "force (N)" for layer in layers)
    drawn = charts.svg(chart, "a < b")
    assert "<title>a &lt; b</title>" in drawn
    assert "crank angle θ (degrees)" in drawn


def test_a_change_of_the_engine_changes_what_is_true() -> None:
    """No truth is stored: the same question about another crank has another answer."""
    one = ALL["flat-couple-2-up"]
    assert curves(one, 9).momentum[0] == pytest.approx(-(8**0.5), abs=FINE)
    turned = replace(one, changes={"layout.bank_offset": 0.2})
    assert curves(turned, 9).momentum[0] == pytest.approx(8**0.5, abs=FINE)


@pytest.mark.parametrize(("language", "head"), [("ja", "正しい式"), ("ru", "верная формула")])
def test_the_right_formula_is_headed_as_a_formula_not_as_an_answer(
    language: str, head: str
) -> None:
    with spoken(language):
        tables = [part for part in errata_document(errata()).parts if isinstance(part, Table)]
        assert {table.columns[-1].heading for table in tables} == {head}
