"""The figures of torsion: what is drawn is what the analysis says, measured on the rows."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest
from tests.charted import bare_canvas, rows_drawn
from tests.files.test_gas_views import curve, rows_of

import crankstar
from crankstar import charts
from crankstar.dynamics.torsion_analysis import torsion
from crankstar.dynamics.torsion_criticals import strength, stresses
from crankstar.dynamics.torsion_excitation import firing_phases
from crankstar.engine.torsion import Chain, Disc
from crankstar.files import engine_of

RPM = 30 / np.pi
pytestmark = pytest.mark.usefixtures(bare_canvas.__name__)
KINDS = ("torsion-modes", "campbell", "torsion-response", "torsion-star")


def tree(**more: Any) -> dict[str, Any]:
    """An in-line six with a pulley and a flywheel."""
    return {
        "name": "in-line six",
        "firing_order": [1, 5, 3, 6, 2, 4],
        "cylinder": {
            "bore": "85 mm",
            "stroke": "90 mm",
            "rod_length": "145 mm",
            "reciprocating_mass": "520 g",
            "rotating_mass": "480 g",
        },
        "layout": {"type": "inline", "bore_pitch": "95 mm"},
        "gas": {
            "compression_ratio": 10.5,
            "imep": "11 bar",
            "point": [{"name": "slow", "speed": "1000 rpm"}, {"name": "fast", "speed": "6500 rpm"}],
        },
        "torsion": {
            "bare_inertia": "0.006 kg*m^2",
            "stiffness": "0.75 MN*m/rad",
            "damping": "1.5 N*m*s/rad",
            "diameter": "60 mm",
            "shear_limit": "25 MPa",
            "disc": [
                {
                    "name": "hub",
                    "inertia": "0.004 kg*m^2",
                    "to": "front",
                    "stiffness": "0.5 MN*m/rad",
                    "diameter": "38 mm",
                },
                {
                    "name": "flywheel",
                    "inertia": "0.16 kg*m^2",
                    "to": "rear",
                    "stiffness": "1.3 MN*m/rad",
                    "diameter": "60 mm",
                },
            ],
        },
        **more,
    }


@pytest.fixture(scope="module")
def six() -> crankstar.Engine:
    return engine_of(tree(), name="six")


def fan_drive() -> Chain:
    shaft = {"to": "gear", "stiffness": 8e3, "speed_ratio": "5/2"}
    return Chain(
        name="fan drive",
        discs=(
            Disc(name="motor", inertia=2),
            Disc(name="gear", inertia=0.5, to="motor", stiffness=2e4),
            Disc.model_validate({"name": "fan", "inertia": 0.4, **shaft}),
        ),
    )


def panels(chart: Any) -> list[dict[str, Any]]:
    """The layered panels of a figure, in reading order."""
    out = []
    for row in rows_drawn(chart.to_dict()):
        out += row.get("hconcat", [row])
    return out


def text_of(chart: Any) -> str:
    head = chart.to_dict()["title"]
    return " ".join([*head["text"], *head.get("subtitle", ())])


def test_dots_of_the_mode_shapes_are_the_turns_of_the_masses(six: Any) -> None:
    found = torsion(six).modes
    drawn = panels(charts.mode_shapes(six))
    assert len(drawn) == 3
    for mode, panel in zip(found, drawn, strict=False):
        dots = [row for row in rows_of(panel) if "size" in row and "y" in row]
        assert [row["x"] for row in dots] == list(range(8))
        assert [row["y"] for row in dots] == pytest.approx(mode.shape.tolist(), rel=1e-5)
        assert f"{mode.frequency:.4g} Hz" in panel["title"]["text"][0]


def test_nodes_lie_where_the_drawn_line_crosses_nought(six: Any) -> None:
    for panel in panels(charts.mode_shapes(six)):
        rows = rows_of(panel)
        lines = [row for row in rows if "x2" in row]
        crossings = sorted(
            line["x"] + (line["x2"] - line["x"]) * line["y"] / (line["y"] - line["y2"])
            for line in lines
            if line["y"] * line["y2"] < 0
        )
        marks = sorted(row["x"] for row in rows if "x" in row and row.get("y") == 0)
        assert marks == pytest.approx(crossings, abs=1e-4)
        assert marks


def test_a_geared_drive_line_is_drawn_referred_to_its_first_mass() -> None:
    found = torsion(fan_drive()).modes[0]
    [panel, _second] = panels(charts.mode_shapes(fan_drive()))
    dots = [row["y"] for row in rows_of(panel) if "size" in row and "y" in row]
    assert dots == pytest.approx((found.shape / [1, 1, 2.5]).tolist(), rel=1e-5)
    assert "referred to the crankshaft" in text_of(charts.mode_shapes(fan_drive()))


@pytest.mark.release
def test_marks_of_the_campbell_diagram_are_the_critical_speeds(six: Any) -> None:
    orders = [3.0, 4.5, 6.0]
    found = torsion(six, orders=orders).criticals
    rows = rows_of(charts.campbell(six, orders=orders).to_dict())
    marks = [row for row in rows if "order" in row]
    assert [row["order"] for row in marks] == [each.order for each in found]
    assert [row["x"] for row in marks] == pytest.approx([each.speed * RPM for each in found])
    for row in marks:  # on its ray, and on the level line of its mode
        assert row["y"] == pytest.approx(row["order"] * row["x"] / 60)
        assert row["y"] == pytest.approx(torsion(six).modes[row["mode"] - 1].frequency)
    sizes = [row["size"] for row in marks]
    strengths = [strength(each) for each in found]
    assert np.argsort(sizes).tolist() == np.argsort(strengths).tolist()


@pytest.mark.release
def test_the_campbell_diagram_names_the_strongest_critical_speed(six: Any) -> None:
    found = torsion(six).criticals
    top = max(found, key=strength)
    said = f"order {top.order:g} at {round(top.speed * RPM)} rpm, mode {top.mode}"
    assert said in text_of(charts.campbell(six))


@pytest.mark.release
def test_rays_of_the_campbell_diagram_have_their_order_as_slope(six: Any) -> None:
    rays = [row for row in rows_of(charts.campbell(six).to_dict()) if "x0" in row]
    named = [row for row in rays if row["text"]]
    assert len(named) >= 4
    for row in named:
        assert row["y"] / row["x"] * 60 == pytest.approx(float(row["text"]))


def test_a_drive_line_has_a_campbell_diagram_with_speeds() -> None:
    over = [20.0, 200.0]
    plain = charts.campbell(fan_drive(), speeds=over)
    assert not [row for row in rows_of(plain.to_dict()) if "order" in row]
    asked = charts.campbell(fan_drive(), speeds=over, orders=[1.0])
    [mark] = [row for row in rows_of(asked.to_dict()) if "order" in row]
    assert mark["x"] == pytest.approx(60 * torsion(fan_drive()).modes[0].frequency)
    assert "--speeds" in str(charts.campbell(fan_drive()).to_dict())


@pytest.mark.many(first=1)
@pytest.mark.parametrize("quantity", ["amplitude", "stress", "torque"])
def test_the_thick_line_is_the_peak_over_the_cycle(six: Any, quantity: Any) -> None:
    speeds = [300.0, 500.0, 585.0]
    found = torsion(six, speeds=speeds).response
    assert found is not None
    drawn = charts.torsion_response_chart(six, quantity=quantity, speeds=speeds)
    x, y = curve(drawn, "all orders")
    at = [int(np.argmin(np.abs(x - speed * RPM))) for speed in speeds]
    assert x[at] == pytest.approx(np.array(speeds) * RPM)
    theta = np.linspace(0, 4 * np.pi, 20001)
    waves = np.exp(1j * np.multiply.outer(found.orders, theta))
    if quantity == "amplitude":
        signal = np.degrees(np.real(found.turns[:, :, 0] @ waves))
    else:
        names = [found.chain.section_name(n) for n in range(len(found.chain.sections))]
        assert "throw 5 - throw 6" in text_of(drawn)
        signal = np.real(found.torque[:, :, names.index("throw 5 - throw 6")] @ waves)
        modulus = np.pi / 16 * 0.060**3
        signal = signal / modulus / 1e6 if quantity == "stress" else signal
    peaks = np.abs(signal).max(axis=1)
    factor = 1e-3 if quantity == "torque" and "kN" in str(drawn.to_dict()) else 1.0
    asked = np.searchsorted(found.speeds, speeds)
    assert y[at] == pytest.approx((peaks * factor)[asked], rel=1e-4)
    _x, added = curve(drawn, "sum of amplitudes (dashed)")
    assert np.all(added >= y * (1 - 1e-6))


def test_the_sum_of_amplitudes_is_dashed_in_the_legend_too(six: Any) -> None:
    """Vega-Lite makes one legend of two channels with the same field and the same legend."""
    drawn = charts.torsion_response_chart(six, speeds=[400.0, 585.0])
    [encoding] = [
        layer["encoding"]
        for row in drawn.to_dict()["vconcat"]
        for panel in row.get("hconcat", [row])
        for layer in panel["layer"]
        if "strokeDash" in layer["encoding"]
    ]
    dash, colour = encoding["strokeDash"], encoding["color"]
    assert (dash["field"], dash["legend"]) == (colour["field"], colour["legend"])
    assert dash["scale"]["domain"] == colour["scale"]["domain"]
    dashes = dict(zip(dash["scale"]["domain"], dash["scale"]["range"], strict=True))
    assert dashes["sum of amplitudes (dashed)"] == [4, 3]
    assert dashes["all orders"] == [1, 0]


def test_an_order_that_is_asked_for_is_drawn_and_no_other(six: Any) -> None:
    drawn = charts.torsion_response_chart(six, orders=[4.5], speeds=[400.0, 585.0])
    names = {row["what"] for row in rows_of(drawn.to_dict()) if "what" in row}
    assert names == {"all orders", "sum of amplitudes (dashed)", "order 4.5"}
    titles = set(re.findall(r"'x': {.*?'title': '([^']*)'", str(drawn.to_dict())))
    assert titles == {"speed (rpm)"}
    whole = torsion(six, speeds=[400.0, 585.0]).response
    assert whole is not None
    place = whole.orders.tolist().index(4.5)
    x, y = curve(drawn, "order 4.5")
    wanted = np.degrees(np.abs(whole.turns[[0, -1], place, 0]))
    assert y[[0, -1]] == pytest.approx(wanted, rel=1e-5)
    assert x[[0, -1]] == pytest.approx(np.array([400.0, 585.0]) * RPM)


@pytest.mark.release
def test_shaded_speeds_are_those_at_which_the_stress_passes_the_limit(six: Any) -> None:
    drawn = charts.torsion_response_chart(six, quantity="stress")
    shades = [row for row in rows_of(drawn.to_dict()) if set(row) == {"x", "x2"}]
    x, y = curve(drawn, "all orders")
    assert shades
    inside = np.zeros(x.size, bool)
    for shade in shades:
        inside |= (x >= shade["x"]) & (x <= shade["x2"])
    assert inside[y > 25.0].all()
    whole = torsion(six).response  # a shade may be of another shaft
    assert whole is not None
    over = stresses(whole)[0].max(axis=1) / 25e6
    clear = np.abs(over - 1) > 1e-4  # crossings are found to 1e-6 of the speed
    assert whole.speeds * RPM == pytest.approx(x)
    assert inside[clear].tolist() == (over > 1)[clear].tolist()


@pytest.mark.parametrize("mode", [1, 2])
def test_the_star_has_the_vectors_of_the_cylinders_and_their_sum(six: Any, mode: int) -> None:
    drawn = charts.torsion_star(six, quantity=f"mode-{mode}", orders=[5.5])
    arrows = [row for row in rows_of(drawn.to_dict()) if "endUp" in row and "head" in row]
    ends = [complex(row["endUp"], row["endRight"]) for row in arrows if row["width"] < 3]
    [whole] = {complex(row["endUp"], row["endRight"]) for row in arrows if row["width"] > 3}
    own = torsion(six).modes[mode - 1]
    fires = np.radians([0, 480, 240, 600, 120, 360])  # 1-5-3-6-2-4 every 120 degrees
    assert firing_phases(six) == pytest.approx(fires)
    wanted = own.shape[1:7] * np.exp(5.5j * fires)
    for vector in wanted:
        assert min(abs(end - vector) for end in ends) < 1e-9
    assert whole == pytest.approx(complex(wanted.sum()))
    assert f"sum {abs(wanted.sum()):.3g}" in panels(drawn)[0]["title"]["text"][0]


def test_a_star_that_closes_has_no_sum() -> None:
    """All torques join in order 3 of a six; in order 1 of a rigid one they cancel."""
    own = tree()
    own["torsion"] = {
        "inertia": "0.01 kg*m^2",
        "stiffness": "1e6 MN*m/rad",
        "disc": [
            {"name": "fan", "inertia": "0.1 kg*m^2", "to": "front", "stiffness": "1 kN*m/rad"}
        ],
    }
    drawn = charts.torsion_star(engine_of(own, name="six"), orders=[1.0, 3.0])
    first, third = (panel["title"]["text"][0] for panel in panels(drawn))
    assert third.endswith("sum 10")  # six throws that turn 0.1/0.06 of the fan, the other way
    assert float(first.rsplit(" ", 1)[1]) < 1e-3


@pytest.mark.release
def test_without_a_name_the_star_shows_the_orders_that_count(six: Any) -> None:
    heads = [panel["title"]["text"][0] for panel in panels(charts.torsion_star(six))]
    top = max(torsion(six).criticals, key=lambda each: each.equilibrium or 0)
    assert any(head.startswith(f"order {top.order:g}:") for head in heads)
    assert len(heads) == 4


@pytest.mark.parametrize("kind", KINDS)
def test_an_engine_without_the_table_is_told_what_is_needed(kind: str) -> None:
    assert "[torsion]" in str(charts.CHARTS[kind].draw(crankstar.load("i4")).to_dict())


def test_what_is_missing_is_said() -> None:
    own = tree()
    del own["gas"]
    still = engine_of(own, name="six")
    assert "--speeds" in str(charts.campbell(still).to_dict())
    assert "--speeds" in str(charts.torsion_response_chart(still).to_dict())
    for part in (own["torsion"], *own["torsion"]["disc"]):
        part.pop("diameter", None)
    own["torsion"].pop("shear_limit")
    own["speed"] = "5000 rpm"
    thin = engine_of(own, name="six")
    said = charts.torsion_response_chart(thin, quantity="stress").to_dict()
    assert "torsion.diameter" in str(said)


@pytest.mark.parametrize("kind", KINDS)
def test_options_that_are_none_are_refused(six: Any, kind: str) -> None:
    figure = charts.CHARTS[kind]
    if "orders" in figure.options:
        with pytest.raises(charts.ChartError):
            figure.draw(six, orders=[-1.0])
    if figure.quantities:
        with pytest.raises(charts.ChartError):
            figure.draw(six, quantity="noise")


@pytest.mark.release
def test_the_limit_of_the_stress_is_named_where_its_line_is() -> None:
    engine = engine_of(tree(), changes={"torsion.shear_limit": "24 MPa"})
    drawn = charts.CHARTS["torsion-response"].draw(engine, quantity="stress")
    assert "the limit, 24 MPa" in text_of(drawn)
    without = charts.CHARTS["torsion-response"].draw(engine, quantity="amplitude")
    assert "the limit" not in text_of(without)
