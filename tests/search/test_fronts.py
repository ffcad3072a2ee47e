"""Figures of a search: the numbers of the answer, visible zeros, labels apart."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from itertools import combinations, pairwise
from typing import Any

import numpy as np
import pytest
from tests import exhaustive
from tests.methods.test_charts import BLUE, arrows, close, drawn, kind
from tests.methods.test_charts_pictures import sound, words_of

from crankstar import charts
from crankstar.charts.drawing import GREY
from crankstar.charts.front_axes import Axis
from crankstar.charts.letters import SMALL, text_width
from crankstar.charts.search_values import order_lines
from crankstar.language.numbers import number
from crankstar.stars.answer import Answer, AnswerRow, answer_to
from crankstar.stars.engines import firing_order
from crankstar.stars.question import All, FunctionObjective, Question
from crankstar.stars.star import Stars
from crankstar.stars.sums import Limit, Objective, couple, neighbours, of


def space(cylinders: int, cycle: Any = "two-stroke") -> Stars:
    return Stars(cylinders, cycle, exhaustive.halves(cylinders))


def couples(stars: Stars, orders: tuple[int, ...]) -> tuple[Objective, ...]:
    return tuple(of(couple(stars, order)) for order in orders)


@cache
def found(name: str) -> Answer:
    if name == "every seven":
        return answer_to(Question(space(7), couples(space(7), (1, 2)), ask=All()))
    if name == "seven, three couples":
        return answer_to(Question(space(7), couples(space(7), (1, 2, 3))))
    stars = space(int(name[0]), "four-stroke" if name.endswith("four-stroke") else "two-stroke")
    beside = (neighbours(),) if name.endswith("neighbours") else ()
    return answer_to(Question(stars, (*couples(stars, (1, 2)), *beside)))


EVERY = pytest.mark.parametrize(
    "name", ["6", "7", "8", "7 with neighbours", "8 with neighbours", "5 four-stroke"]
)


def layers(chart: Any) -> tuple[dict[str, list[Any]], Any]:
    """The rows of the front's panel by what they are, and its key."""
    front, key = drawn(chart)
    rows = {"points": [], "steps": [], "texts": [], "leaders": [], "others": []}
    for layer, found_rows in front:
        mark = kind(layer)
        pale = mark == "point" and layer["mark"].get("color") == GREY
        name = (
            "others"
            if pale
            else {"point": "points", "line": "steps", "text": "texts", "rule": "leaders"}[mark]
        )
        rows[name] = found_rows
    return rows, key


@pytest.mark.many(first=8)
@EVERY
@pytest.mark.parametrize("logarithmic", [False, True, None])
def test_points_stand_at_the_values_of_the_findings_and_zeros_apart(
    name: str, logarithmic: bool | None
) -> None:
    answer = found(name)
    chart = charts.pareto_front(answer, logarithmic=logarithmic)
    points = layers(chart)[0]["points"]
    assert [(row.value0, row.value1) for row in points] == [row.values[:2] for row in answer.rows]
    assert [row.row for row in points] == list(range(1, len(answer.rows) + 1))
    assert [row.order for row in points] == [
        "-".join(map(str, firing_order(answer.question.stars, row.star))) for row in answer.rows
    ]
    for place, side in enumerate("xy"):
        least = min(row.values[place] for row in answer.rows if row.values[place])
        for point, row in zip(points, answer.rows, strict=True):
            value = row.values[place]
            assert point[side] == value or (
                logarithmic and value == 0 and 0 < point[side] < 0.8 * least
            )
    sound(charts.saved(chart, "svg", title=name))


@pytest.mark.release
def test_zero_has_its_own_number_on_a_logarithmic_axis() -> None:
    for logarithmic in (False, True):
        picture = charts.saved(
            charts.pareto_front(found("6"), logarithmic=logarithmic), "svg", title="six"
        )
        axes = re.findall(r">(0(?:\.0)?)<", picture.decode())
        assert len(axes) >= 4  # on either axis, and each zero of the key
    spec = charts.pareto_front(found("6"), logarithmic=True).to_dict()
    x = spec["vconcat"][0]["layer"][-1]["encoding"]["x"]
    zero, *ticks = x["axis"]["values"]
    assert x["scale"]["type"] == "log"
    assert x["scale"]["domain"][0] < zero < 0.8 * min(ticks)
    assert "? '0' :" in x["axis"]["labelExpr"]


@pytest.mark.parametrize(
    ("axis", "values"),
    [
        (Axis(0.0, 8.0, 330.0), (0.0, 0.1, 3.0, 8.0)),
        (Axis(1e-3, 20.0, 250.0, powers=True, zero=2e-3), (1e-2, 1.0, 20.0)),
    ],
)
def test_places_on_an_axis_are_those_of_their_values(axis: Axis, values: tuple[float, ...]) -> None:
    assert [axis.value(axis.place(value)) for value in values] == pytest.approx(values)
    assert axis.place(axis.low if axis.powers else 0.0) == pytest.approx(0, abs=1e-9)
    assert axis.place(axis.high) == pytest.approx(axis.length)
    assert 0 <= axis.place(0.0) < axis.place(values[1])


def test_axes_become_logarithmic_where_values_span_powers_of_ten_but_counts_stay() -> None:
    def kinds(chart: Any) -> list[Any]:
        encoding = chart.to_dict()["vconcat"][0]["layer"][-1]["encoding"]
        return [encoding[side]["scale"].get("type") for side in "xy"]

    assert kinds(charts.pareto_front(found("7"))) == ["log", "log"]
    assert kinds(charts.pareto_front(found("6"))) == [None, None]
    assert kinds(charts.pareto_front(found("7"), logarithmic=False)) == [None, None]
    stars = space(7)
    counted = answer_to(Question(stars, (of(couple(stars, 1)), neighbours())))
    assert kinds(charts.pareto_front(counted, logarithmic=True)) == ["log", None]


@pytest.mark.parametrize("name", ["6", "7", "8", "5 four-stroke"])
def test_the_line_goes_through_what_nothing_betters_and_all_stars_are_beyond_it(name: str) -> None:
    answer = found(name)
    rows, _ = layers(charts.pareto_front(answer, logarithmic=False))
    corners = [(step.x, step.y) for step in sorted(rows["steps"], key=lambda step: step["at"])]
    assert all(
        a[0] <= b[0] and a[1] >= b[1] and (a[0] == b[0] or a[1] == b[1])
        for a, b in pairwise(corners)
    )
    values = [row.values[:2] for row in answer.rows]
    best = [
        one
        for one in values
        if not any(o != one and o[0] <= one[0] and o[1] <= one[1] for o in values)
    ]
    assert set(best) <= set(corners)
    for one, two in values:
        beyond = [corner for corner in corners[:-1] if corner[0] <= one]
        assert beyond
        assert min(corner[1] for corner in beyond) <= two


@pytest.mark.many(first=2)
@pytest.mark.parametrize("name", ["7 with neighbours", "8 with neighbours", "seven, three couples"])
def test_a_third_objective_leaves_no_line_that_would_make_good_points_look_bettered(
    name: str,
) -> None:
    rows, _ = layers(charts.pareto_front(found(name)))
    assert not rows["steps"]
    assert len(rows["points"]) == len(found(name).rows)


def test_other_stars_are_drawn_pale_where_they_do_not_cover_each_other() -> None:
    every = found("every seven")
    chart = charts.pareto_front(found("7"), others=every)
    others = {(row.x, row.y) for row in layers(chart)[0]["others"]}
    assert others <= {row.values for row in every.rows}
    assert 150 < len(others) <= 192
    sound(charts.saved(chart, "svg", title="seven"))


@EVERY
def test_the_key_has_firing_orders_values_and_neighbours_of_every_row(name: str) -> None:
    answer = found(name)
    _, key = layers(charts.pareto_front(answer))
    lines: dict[float, list[tuple[float, str]]] = {}
    for _, rows in key:
        for row in rows:
            lines.setdefault(row.y, []).append((row.x, row.text))
    head, *told = [[text for _, text in sorted(lines[y])] for y in sorted(lines)]
    counted = name.endswith("neighbours")
    assert head == ["firing order", "M1", "M2", "neighbours"]
    for place, (line, row) in enumerate(zip(told, answer.rows, strict=True), 1):
        order = "-".join(map(str, firing_order(answer.question.stars, row.star)))
        values = [number(value, digits=4) for value in row.values] + (
            [] if counted else [str(row.neighbours)]
        )
        assert line == [str(place), order, *values]


def placing(chart: Any) -> Callable[[float, float], np.ndarray]:
    """From values to px in the panel of a front."""
    panel = chart.to_dict()["vconcat"][0]
    scales = [panel["layer"][-1]["encoding"][side]["scale"] for side in "xy"]

    def place(x: float, y: float) -> np.ndarray:
        out = []
        for value, scale, length in zip(
            (x, y), scales, (panel["width"], panel["height"]), strict=True
        ):
            low, high = scale["domain"]
            share = (
                np.log(value / low) / np.log(high / low)
                if scale.get("type") == "log"
                else (value - low) / (high - low)
            )
            out.append(share * length)
        return np.array(out)

    return place


@pytest.mark.many(first=8)
@pytest.mark.parametrize("logarithmic", [False, True])
@pytest.mark.parametrize(
    "name", ["6", "7", "9 with neighbours", "5 four-stroke", "seven, three couples"]
)
def test_a_number_stands_nearest_to_its_own_point_or_has_a_line_to_it(
    name: str, logarithmic: bool
) -> None:
    chart = charts.pareto_front(found(name), logarithmic=logarithmic)
    rows, _ = layers(chart)
    place = placing(chart)
    points = {row.row: place(row.x, row.y) for row in rows["points"]}
    leaders = [(place(row.x, row.y), place(row.x2, row.y2)) for row in rows["leaders"]]
    alone = 0
    for text in rows["texts"]:
        here, own = place(text.x, text.y), points[int(text.text)]
        half = np.array([text_width(text.text, SMALL) / 2, SMALL / 2])
        gaps = {
            row: np.linalg.norm(np.maximum(np.abs(spot - here) - half, 0))
            for row, spot in points.items()
        }
        if any(
            np.linalg.norm(start - own) < 6 and np.linalg.norm(end - here) < 14
            for start, end in leaders
        ):
            continue
        alone += 1
        assert gaps[int(text.text)] < 8
        assert all(
            gaps[int(text.text)] < gap
            for row, gap in gaps.items()
            if not np.allclose(points[row], own)
        )
    assert alone + len(leaders) == len(rows["texts"])


@pytest.mark.release
def test_where_a_number_is_left_out_the_figure_says_so() -> None:
    assert "numbers where there is room" in words_of(
        charts.saved(charts.pareto_front(found("9 with neighbours")), "svg", title="nine")
    )
    assert "numbers where" not in words_of(
        charts.saved(charts.pareto_front(found("7")), "svg", title="seven")
    )


@pytest.mark.many(first=8)
@pytest.mark.parametrize("logarithmic", [False, True])
@pytest.mark.parametrize(
    "name", ["6", "7", "8 with neighbours", "5 four-stroke", "seven, three couples"]
)
def test_numbers_stand_off_each_other_and_off_the_points(name: str, logarithmic: bool) -> None:
    chart = charts.pareto_front(found(name), logarithmic=logarithmic)
    rows, _ = layers(chart)
    where = placing(chart)

    def place(row: Any) -> np.ndarray:
        return where(row.x, row.y)

    halves = np.array([text_width("1", SMALL) / 2, SMALL / 2 - 1])
    texts = [(place(row), halves * [len(row.text), 1]) for row in rows["texts"]]
    assert len(texts) >= min(4, len(found(name).rows))
    for (one, size), (other, wide) in combinations(texts, 2):
        assert (np.abs(one - other) > size + wide - 1).any()
    for text, size in texts:
        assert all((np.abs(text - place(row)) > size + 3).any() for row in rows["points"])


@pytest.mark.parametrize("name", ["6", "8", "6 four-stroke", "5 four-stroke"])
def test_every_point_of_a_short_front_has_its_number_also_where_it_stands_on_an_axis(
    name: str,
) -> None:
    rows, _ = layers(charts.pareto_front(found(name)))
    assert {int(row.text) for row in rows["texts"]} == {row.row for row in rows["points"]}


@pytest.mark.release
def test_a_third_objective_gives_the_colour() -> None:
    for name, scale in (("7 with neighbours", "ordinal"), ("seven, three couples", "quantitative")):
        answer = found(name)
        chart = charts.pareto_front(answer)
        colours = [
            (layer["encoding"]["color"], rows)
            for layer, rows in drawn(chart)[0]
            if "field" in layer["encoding"].get("color", {})
        ]
        ((colour, rows),) = colours
        assert colour["type"] == scale
        assert [row[colour["field"]] for row in rows] == [row.values[2] for row in answer.rows]
        sound(charts.saved(chart, "svg", title=name))


@pytest.mark.release
def test_a_list_is_called_one_and_of_very_many_stars_those_that_are_covered_are_not_drawn() -> None:
    stars = space(9)
    every = answer_to(
        Question(stars, couples(stars, (1, 2)), limits=(Limit(couple(stars, 1), 8.0),), ask=All())
    )
    assert len(every.rows) > 2000
    chart = charts.pareto_front(every, logarithmic=False)
    rows, _ = layers(chart)
    assert chart.to_dict()["title"]["text"] == ["Crank stars by M1 and M2"]
    assert 1000 < len(rows["points"]) < len(every.rows)
    values = np.array([row.values for row in every.rows])
    scale = np.array([330, 250]) / values.max(axis=0)
    shown = np.array([(row.x, row.y) for row in rows["points"]]) * scale
    # px: every star is drawn, or covered by one that is
    assert all(np.abs(one * scale - shown).max(axis=1).min() < 2.5 for one in values)


def test_a_third_objective_that_is_the_same_for_all_gives_no_colour() -> None:
    stars = space(8, "four-stroke")
    answer = answer_to(Question(stars, (*couples(stars, (1, 2)), neighbours())))
    assert [row.values for row in answer.rows] == [(0.0, 0.0, 0.0)]
    assert all(
        "field" not in layer["encoding"].get("color", {})
        for layer, _ in drawn(charts.pareto_front(answer))[0]
    )


@pytest.mark.release
def test_a_crowd_is_listed_as_far_as_it_can_be_read_and_the_rest_is_counted() -> None:
    picture = charts.saved(charts.pareto_front(found("seven, three couples")), "svg", title="seven")
    assert f"and {len(found('seven, three couples').rows) - 20} more" in words_of(picture)


def test_long_firing_orders_are_folded() -> None:
    stars = space(24)
    row = AnswerRow(tuple(range(24)), (0.0, 0.0), 23, 1, 1)
    lines = order_lines(firing_order(stars, row.star), width=150.0)
    assert "".join(lines) == "-".join(map(str, range(1, 25)))
    assert len(lines) == 3
    assert all(line.endswith("-") for line in lines[:-1])
    answer = Answer(Question(stars, couples(stars, (1, 2))), (row,), 1, found("7").certificate)
    sound(charts.saved(charts.pareto_front(answer), "svg", title="24"))
    sound(charts.saved(charts.best_stars(answer), "svg", title="24"))


@pytest.mark.many(first=1)
@pytest.mark.parametrize("draw", [charts.pareto_front, charts.best_stars])
@pytest.mark.parametrize(
    ("suffix", "begins"),
    [("svg", b"<svg"), ("png", b"\x89PNG"), ("pdf", b"%PDF"), ("html", b"<!DOCTYPE html>")],
)
def test_figures_of_a_search_are_saved_as_all_kinds_of_files(
    draw: Any, suffix: str, begins: bytes
) -> None:
    assert (
        charts.saved(draw(found("7 with neighbours")), suffix, title="seven")
        .lstrip()
        .startswith(begins)
    )


def test_their_description_is_the_chart() -> None:
    spec = json.loads(charts.saved(charts.pareto_front(found("7")), "json", title="seven"))
    assert spec["title"] == {
        "text": ["Pareto front of M1 and M2"],
        "subtitle": ["7 cylinders, two-stroke"],
    }


@pytest.mark.many(first=3)
@pytest.mark.parametrize("name", ["7", "5 four-stroke", "8"])
@pytest.mark.parametrize("theta", [0.0, 0.7])
def test_the_winners_have_their_throws_where_they_say_and_their_values_above(
    name: str, theta: float
) -> None:
    answer = found(name)
    chart = charts.best_stars(answer, theta=theta, count=3)
    n = answer.question.stars.directions
    for place, (panel, row) in enumerate(zip(drawn(chart), answer.rows[:3], strict=False), 1):
        assert close(
            arrows(panel, BLUE), [np.exp(1j * (theta - 2 * np.pi * d / n)) for d in row.star]
        )
        texts = {row.text for layer, rows in panel if kind(layer) == "text" for row in rows}
        assert {str(cylinder) for cylinder in range(1, len(row.star) + 1)} <= texts
        title = list(titles(chart.to_dict()))[place - 1]
        order = "-".join(map(str, firing_order(answer.question.stars, row.star)))
        assert title[0] == f"{place}:  {order}"
        assert title[1] == ", ".join(
            f"M{k} {number(value, digits=4)}" for k, value in enumerate(row.values, 1)
        )
        assert title[2] == f"neighbours {row.neighbours}"
    assert len(drawn(chart)) == min(3, len(answer.rows))


def titles(spec: Any) -> Any:
    for key in ("vconcat", "hconcat"):
        for inner in spec.get(key, []):
            yield from titles(inner)
    if "layer" in spec:
        yield spec["title"]["text"]


@pytest.mark.release
def test_where_more_stars_were_found_than_are_drawn_the_figure_says_so() -> None:
    answer = found("9 with neighbours")
    part = f"6 of {len(answer.rows)} stars"
    assert part in charts.best_stars(answer).to_dict()["title"]["subtitle"]
    assert not any(
        " of " in line for line in charts.best_stars(found("7")).to_dict()["title"]["subtitle"]
    )


def test_where_two_cylinders_share_a_throw_both_are_named() -> None:
    stars = space(8, "four-stroke")
    answer = answer_to(Question(stars, (*couples(stars, (1, 2)), neighbours())))
    ((panel),) = drawn(charts.best_stars(answer))
    texts = {row.text for layer, rows in panel if kind(layer) == "text" for row in rows}
    assert texts == {"1, 8", "2, 7", "3, 6", "4, 5"}


@pytest.mark.release
def test_what_python_judged_is_drawn_too() -> None:
    stars = space(7)
    judge = FunctionObjective("spread", lambda star: float(abs(star[0] - star[6])), unit="steps")
    answer = answer_to(
        Question(
            stars,
            (of(couple(stars, 1)),),
            functions=(judge,),
            limits=(Limit(couple(stars, 2), 4.0),),
        )
    )
    assert "spread (steps)" in words_of(
        charts.saved(charts.pareto_front(answer), "svg", title="judged")
    )


def test_fixed_throws_and_unequal_pitches_are_said() -> None:
    places = (*(Fraction(3 - j) for j in range(6)), Fraction(-4))
    stars = Stars(7, "two-stroke", places, fixed=((1, 0), (4, 3)))
    answer = answer_to(Question(stars, couples(stars, (1, 2))))
    words = words_of(charts.saved(charts.pareto_front(answer), "svg", title="fixed"))
    assert "unequal pitches" in words
    assert "throws of 1, 4 fixed" in words


def test_what_cannot_be_drawn_is_refused_in_a_sentence() -> None:
    stars = space(6)
    one = answer_to(Question(stars, couples(stars, (1,))))
    none = answer_to(
        Question(
            stars,
            couples(stars, (3, 1)),
            limits=(Limit(couple(stars, 1), 0), Limit(couple(stars, 2), 3.0)),
        )
    )
    with pytest.raises(charts.ChartError, match="the search has 1; draw the stars"):
        charts.pareto_front(one)
    with pytest.raises(charts.ChartError, match="found none within the limits"):
        charts.pareto_front(none)
    with pytest.raises(charts.ChartError, match="found none within the limits"):
        charts.best_stars(none)
    with pytest.raises(charts.ChartError, match="other objectives"):
        charts.pareto_front(found("6"), others=answer_to(Question(stars, couples(stars, (1, 3)))))
    with pytest.raises(charts.ChartError, match="25 stars do not fit"):
        charts.best_stars(found("6"), count=25)
    with pytest.raises(charts.ChartError, match="the crank angle is nan"):
        charts.best_stars(found("6"), theta=float("nan"))
