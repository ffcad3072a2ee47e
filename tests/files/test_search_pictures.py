"""Pictures of `crankstar search`: their numbers in the units chosen, their letters and size."""

from __future__ import annotations

import csv
import io
import json
import re
from collections import defaultdict
from math import pi
from pathlib import Path

import pytest
from tests.commands import Run

from crankstar import charts
from crankstar.charts.drawing import BLUE, ORANGE
from crankstar.options.sequences import sequences_of
from crankstar.options.words import SearchWords, SequenceWords
from crankstar.stars.sequence_fronts import sequence_front

MARINE = """
format = 1
name = "Marine seven"
cycle = "two-stroke"
speed = "76 rpm"
firing_order = [1, 7, 2, 5, 4, 3, 6]
source = "made up"
[cylinder]
bore = "900 mm"
stroke = "3188 mm"
rod_length = "3270 mm"
reciprocating_mass = "14 t"
rotating_mass = "9 t"
[layout]
type = "inline"
bore_pitch = "1602 mm"
"""
TEXT = re.compile(r'<text[^>]*translate\(([-\d.]+),([-\d.]+)\)[^>]*fill="(#\w+)"[^>]*>([^<]*)<')
SIDES = re.compile(r'<svg[^>]* width="([\d.]+)mm" height="([\d.]+)mm"')
GROUND = {"light": "#ffffff", "print": "#ffffff", "dark": "#14171a"}


@pytest.fixture
def marine(tmp_path: Path) -> str:
    place = tmp_path / "marine.toml"
    place.write_text(MARINE, encoding="utf-8")
    return str(place)


def drawn(run: Run, marine: str, *options: str) -> str:
    place = Path(marine).with_name("picture.svg")
    ran = run("search", marine, "--minimise", "M1,M2", "--front", *options, "-o", str(place))
    assert ran.code == 0, ran.err
    return place.read_text("utf-8")


def rows_of(picture: str) -> dict[str, list[float]]:
    """The values beside each firing order of the key, as they are printed."""
    lines: dict[float, list[tuple[float, str]]] = defaultdict(list)
    for x, y, _colour, text in TEXT.findall(picture):
        lines[float(y)].append((float(x), text))
    out = {}
    for line in lines.values():
        words = [text for _x, text in sorted(line)]
        order = next((word for word in words if re.fullmatch(r"\d(-\d){6}", word)), None)
        if order is not None:
            out[order] = [float(word) for word in words[words.index(order) + 1 :]]
    return out


@pytest.mark.release
@pytest.mark.parametrize(
    ("units", "name", "size"),
    [("MN m", "MN m", 1e6), ("us", "lbf ft", 4.4482216152605 * 0.3048), ("si", "MN m", 1e6)],
)
def test_a_front_is_drawn_in_the_units_of_its_table(
    run: Run, marine: str, units: str, name: str, size: float
) -> None:
    told = run("--units", "N m", "search", marine, "--minimise", "M1,M2", "--front", "--csv").out
    table = list(csv.DictReader(io.StringIO(told)))
    picture = drawn(run, marine, "--chart", "front", "--units", units)
    key = rows_of(picture)
    assert len(key) == len(table) > 2
    for row in table:
        one, two, _neighbours = key[row["firing_order"]]
        for shown, column in ((one, "M1"), (two, "M2")):
            assert shown == pytest.approx(float(row[f"{column} [N*m]"]) / size, rel=5e-4)
    whole = (
        23_000 * 1.594 * (76 * pi / 30) ** 2 * 1.602
    )  # of all mass on a throw, an arm of a pitch
    assert key["1-7-2-5-4-3-6"][0] * size == pytest.approx(0.26725 * whole, rel=1e-3)
    assert f">M1 ({name})<" in picture
    assert f">M2 ({name})<" in picture
    stars = drawn(run, marine, "--chart", "stars", "--units", units)
    best = re.findall(r">M1 ([\d.e+]+), M2 ([\d.e+]+)<", stars)
    assert [float(one) for one, _two in best] == [values[0] for values in key.values()][: len(best)]
    assert best


def luminance(colour: str) -> float:
    """Relative luminance by WCAG 2."""
    parts = [int(colour[place : place + 2], 16) / 255 for place in (1, 3, 5)]
    linear = [
        part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts
    ]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


@pytest.mark.release
@pytest.mark.parametrize("theme", GROUND)
@pytest.mark.parametrize("chart", ["front", "stars"])
def test_its_letters_can_be_read_on_paper(run: Run, marine: str, chart: str, theme: str) -> None:
    picture = drawn(run, marine, "--chart", chart, "--theme", theme)
    ground = luminance(GROUND[theme])
    letters = {colour for *_place, colour, text in TEXT.findall(picture) if text.strip()}
    assert letters
    for colour in letters:
        dim, bright = sorted((luminance(colour), ground))
        assert (bright + 0.05) / (dim + 0.05) >= 4.5, colour


@pytest.mark.release
def test_it_has_the_size_asked_for(run: Run, marine: str) -> None:
    picture = drawn(run, marine, "--chart", "front", "--width", "150 mm")
    sides = SIDES.search(picture)
    assert sides is not None
    assert float(sides[1]) == pytest.approx(150, abs=0.2)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--theme", "sepia", "-o", "x.svg"), "light, dark, print"),
        (("--width", "20 mm", "-o", "x.svg"), "does not fit"),
        (("--width", "20 kg", "-o", "x.svg"), "--width"),
        (("--theme", "dark"), "a table"),
        (("--row", "1", "--dpi", "200", "-o", "x.toml"), "an engine"),
        (("--dpi", "200", "-o", "x.svg"), ".svg"),
    ],
)
def test_what_cannot_be_drawn_is_refused_in_a_sentence(
    run: Run, marine: str, options: tuple[str, ...], words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = Path(marine).parent
    monkeypatch.chdir(folder)
    ran = run("search", marine, *options)
    assert (ran.code, ran.out) == (2, "")
    assert words in ran.err
    assert [place.name for place in folder.iterdir()] == ["marine.toml"]


SEQUENCES = ("search", "v8-cross-plane", "--minimise", "M1,twist,neighbours", "--orders", "0.5,1.5")


def test_the_front_over_firing_orders_has_the_numbers_of_its_table(
    run: Run, tmp_path: Path
) -> None:
    place = tmp_path / "front.svg"
    assert run(*SEQUENCES, "-o", str(place)).code == 0
    told = json.loads(run(*SEQUENCES, "--json").out)["rows"]
    texts = [text for _x, _y, _colour, text in TEXT.findall(place.read_text("utf-8"))]
    for row in told:
        at = texts.index("-".join(map(str, row["firing_order"])))
        near = texts[max(0, at - 2) :]
        assert f"{row['M1']:.4g}" in near
        assert f"{row['twist']:.4g}" in near


@pytest.mark.release
def test_stars_of_torsion_are_drawn_beside_the_crank_of_each_row(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "stars.svg"
    assert run(*SEQUENCES, "--chart", "stars", "-o", str(place)).code == 0
    told = json.loads(run(*SEQUENCES, "--json").out)["rows"][:3]
    whole = re.sub("<[^>]*>", " ", place.read_text("utf-8"))
    for number, row in enumerate(told, 1):
        assert f"{number}:  {'-'.join(map(str, row['firing_order']))}" in whole
        for order in ("0.5", "1.5"):
            assert f"order {order}: sum {row[f'T{order}']:.3g}" in whole


def test_the_drawn_vectors_add_up_to_the_drawn_sum() -> None:
    """Of the arrows in each star the heavy one is the sum of the others, from tail to head."""
    asked = sequences_of(6, SearchWords(minimise="M1,twist"), SequenceWords(crank_orders="1.5"))
    front = sequence_front(asked.question)
    figure = charts.sequence_stars(front, count=2).to_dict()
    for place, panel in enumerate(figure["vconcat"][:2]):
        arrows = panel["hconcat"][1]["layer"][1]["data"]["values"]
        heads: dict[str, complex] = defaultdict(complex)
        for row in arrows:
            heads[row["colour"]] += complex(row["endUp"], row["endRight"])
        assert abs(heads[ORANGE] - heads[BLUE]) < 1e-6
        assert abs(heads[ORANGE]) == pytest.approx(front.points[place].values[1], rel=1e-9)


@pytest.mark.parametrize(
    ("more", "words"),
    [
        (("--chart", "stars", "--json"), "--json"),
        (("--judge", "stress", "--chart", "front"), "--judge"),
        (("--chart", "front", "--row", "1"), "--chart"),
        (("--dpi", "200"), "--dpi"),
    ],
)
def test_pictures_of_firing_orders_refuse_what_they_do_not_use(
    more: tuple[str, ...], words: str, run: Run, tmp_path: Path
) -> None:
    ran = run(*SEQUENCES, *more, "-o", str(tmp_path / "x.svg"))
    assert ran.code == 2
    assert words in ran.err
    assert not (tmp_path / "x.svg").exists()
