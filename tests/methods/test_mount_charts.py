"""The figures of mounts: what is drawn is what the analysis says, measured on the rows."""

from __future__ import annotations

from math import hypot
from typing import Any

import numpy as np
import pytest
from tests.charted import bare_canvas, rows_drawn
from tests.files.test_gas_views import curve, rows_of
from tests.files.test_mounts import BLOCK, GROUND, THREE
from tests.texts import SHORT, spoilt

import crankstar
from crankstar import charts
from crankstar.charts.canvas import Canvas, drawn_on
from crankstar.charts.drawing import ChartError
from crankstar.dynamics.mount_response import rms
from crankstar.files import engine_of

RPM = 30 / np.pi
pytestmark = pytest.mark.usefixtures(bare_canvas.__name__)
KINDS = ("mount-layout", "mount-modes", "mount-response", "transmissibility")
GAS = {"imep": "4 bar", "compression_ratio": 10, "speed": "900 rpm"}
SPEEDS = np.array([60.0, 90.0, 200.0, 420.0])


def mounted(**more: Any) -> crankstar.Engine:
    return engine_of(spoilt(SHORT, **{"block": BLOCK, "mounts": THREE, "gas": GAS, **more}))


def text_of(chart: Any) -> str:
    head = chart.to_dict()["title"]
    return " ".join([*head["text"], *head.get("subtitle", ())])


def said(chart: Any) -> str:
    """All texts of a figure, folded lines joined."""
    return str(chart.to_dict()).replace("', '", " ")


@pytest.mark.many(first=1)
@pytest.mark.parametrize("ground", [None, GROUND])
def test_each_row_of_the_modes_is_the_energy_of_a_mode(ground: Any) -> None:
    engine = mounted(**({} if ground is None else {"foundation": ground}))
    found = crankstar.mounts(engine)
    rows = [row for row in rows_of(charts.mount_mode_chart(engine).to_dict()) if "share" in row]
    columns = 6 if ground is None else 7
    for place, mode in enumerate(found.modes):
        shares = [row["share"] for row in rows if row["y"] == place + 0.5][:columns]
        assert shares[:6] == pytest.approx(100 * mode.energy[:6], abs=1e-3)
        assert sum(shares) == pytest.approx(100, abs=0.01)
    drawn = str(charts.mount_mode_chart(engine).to_dict())
    assert f"{found.modes[0].frequency:.3g} Hz" in drawn


@pytest.mark.release
@pytest.mark.parametrize(
    ("quantity", "factor"), [("velocity", 1e3), ("displacement", 1e6), ("force", 1.0)]
)
def test_the_thick_line_is_the_rms_of_all_orders(quantity: Any, factor: float) -> None:
    engine, at = mounted(), (0.15, -0.02, 0.4)
    over = crankstar.mounts(engine, speeds=SPEEDS, at=at).over
    assert over is not None
    drawn = charts.mount_response_chart(engine, quantity=quantity, speeds=SPEEDS.tolist(), at=at)
    x, y = curve(drawn, "all orders")
    assert x == pytest.approx(over.speeds * RPM)
    amplitudes = {
        "velocity": over.velocity(at),
        "displacement": over.displacement(at),
        "force": over.ground_force[..., :3],
    }[quantity]
    theta = np.linspace(0, 4 * np.pi, 4000, endpoint=False)  # the whole cycle, in time
    waves = np.exp(1j * np.multiply.outer(over.orders, theta))
    course = np.real(np.einsum("soa,ot->sat", amplitudes, waves))
    assert y == pytest.approx(factor * np.sqrt((course**2).sum(axis=1).mean(axis=-1)), rel=1e-4)
    assert ("at 150 mm up" in text_of(drawn)) is (quantity != "force")


def test_an_order_that_is_asked_for_is_drawn_and_no_other_on_mounts() -> None:
    engine = mounted()
    drawn = charts.mount_response_chart(engine, speeds=SPEEDS.tolist(), orders=[2.0])
    names = {row["what"] for row in rows_of(drawn.to_dict()) if "what" in row}
    assert names == {"all orders", "order 2"}
    found = crankstar.mounts(engine, speeds=SPEEDS)
    assert found.over is not None
    own = found.over.orders == 2
    wanted = 1e3 * rms(found.over.velocity(found.point)[:, own])
    assert curve(drawn, "order 2")[1] == pytest.approx(wanted, rel=1e-5)


def test_forces_of_the_mounts_add_up_to_that_on_the_ground() -> None:
    """Of mounts along the axes, in phase: four alike under a force straight up."""
    engine = mounted()
    drawn = charts.mount_response_chart(engine, quantity="mounts", speeds=SPEEDS.tolist())
    over = crankstar.mounts(engine, speeds=SPEEDS).over
    assert over is not None
    for place, name in enumerate(("left", "right", "rear")):
        assert curve(drawn, name)[1] == pytest.approx(rms(over.mount_force[:, :, place]), rel=1e-5)
    through = charts.transmissibility_chart(engine, speeds=SPEEDS.tolist())
    for place, name in enumerate(("left", "right", "rear")):
        assert curve(through, name)[1] == pytest.approx(over.transmissibility[:, place], rel=1e-5)


def test_the_layout_shows_every_mount_where_it_is_in_all_views() -> None:
    engine = mounted()
    views = rows_drawn(charts.mount_layout_chart(engine).to_dict())
    shown = (  # upward and to the right in the picture, of (up, right, z)
        ((1, 0, 0), (0, 1, 0)),
        ((0, 0, -1), (0, 1, 0)),
        ((1, 0, 0), (0, 0, -1)),
    )
    centre = crankstar.mounts(engine).block.centres[0]
    places = [*((m.up, m.right, m.z) for m in engine.mounts), tuple(centre)]
    for view, ways in zip(views, shown, strict=True):
        dots = [row for row in rows_of(view) if "atUp" in row and "colour" in row]
        for place in places:
            wanted = tuple(1e3 * np.dot(way, place) for way in ways)
            assert any((d["atUp"], d["atRight"]) == pytest.approx(wanted) for d in dots), place


@pytest.mark.release
def test_drawn_axes_go_through_their_points_in_their_directions() -> None:
    engine = mounted(block={**BLOCK, "product_up_z": "-0.5 kg*m^2"})
    found = crankstar.mounts(engine)
    _front, plan, _side = rows_drawn(charts.mount_layout_chart(engine).to_dict())
    rows = [row for row in rows_of(plan) if "line" in row]
    for axis, colour in ((found.torque_roll, "#009e73"), (found.elastic, "#e69f00")):
        one, other = (row for row in rows if row["colour"] == colour)
        run, rise = other["x2"] - one["x2"], other["y2"] - one["y2"]
        assert abs(run) * abs(axis.direction[2]) == pytest.approx(
            abs(rise) * abs(axis.direction[1]), abs=1e-6
        )
        at = axis.point * 1e3
        off = run * (-at[2] - one["y2"]) - rise * (at[1] - one["x2"])
        assert abs(off) / hypot(run, rise) < 1e-6


@pytest.mark.parametrize("kind", KINDS)
def test_an_engine_without_mounts_is_told_what_is_needed(kind: str) -> None:
    assert "[[mounts]]" in said(charts.CHARTS[kind].draw(crankstar.load("i4")))


@pytest.mark.release
def test_what_is_missing_of_mounts_is_said() -> None:
    still = engine_of(spoilt(SHORT, block=BLOCK, mounts=THREE))
    for chart in (charts.mount_response_chart, charts.transmissibility_chart):
        assert "give --speeds" in said(chart(still))
    assert "Without gas" in text_of(charts.mount_response_chart(still, speeds=[100.0, 200.0]))
    with drawn_on(Canvas()):
        notes = charts.mount_response_chart(still, speeds=[100.0]).notes
    assert any("mounts.loss_factor" in line for line in notes)
    with pytest.raises(ChartError):
        charts.mount_response_chart(still, quantity="speed")


@pytest.mark.parametrize(("moved", "lines"), [(0, 3), (150, 4)])
def test_mounts_whose_lines_cover_each_other_share_one(moved: int, lines: int) -> None:
    """Two mounts in one place have one line, with both names."""
    second = {**THREE[0], "name": "second", "right": f"{-300 + moved} mm"}
    engine = mounted(mounts=[THREE[0], second, *THREE[1:]])
    for chart in (
        charts.transmissibility_chart(engine, speeds=SPEEDS.tolist()),
        charts.mount_response_chart(engine, quantity="mounts", speeds=SPEEDS.tolist()),
    ):
        drawn = {row["what"] for row in rows_of(chart.to_dict()) if "what" in row}
        names = {name for name in drawn if "stiff" not in name}
        assert ("left, second" in names) == (lines == 3)
        assert len(names) == lines


def test_many_mounts_on_a_foundation_are_drawn_apart() -> None:
    engine = mounted(foundation=GROUND)
    drawn = charts.mount_response_chart(engine, quantity="mounts", speeds=SPEEDS.tolist())
    names = {row["what"] for row in rows_of(drawn.to_dict()) if "what" in row}
    assert len(names) == 7
    assert sum(name.startswith("foundation: ") for name in names) == 4
