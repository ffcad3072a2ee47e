"""What a new user, an attacker and a second computation found unsaid: each is said, or refused."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Callable
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run
from tests.files.test_answers_rest_on import rows_by_path
from tests.lacking import FIVE, RUBBER
from tests.mounted_engines import standing

import crankstar
from crankstar import spectra
from crankstar.dynamics.whirl import body, outline
from crankstar.engine.gas import Gas
from crankstar.engine.main_bearings import main_bearings
from crankstar.files import engine_of, tree_text
from crankstar.files.errors import EngineFileError
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.mass_doubts import size_doubts
from crankstar.mechanics.operating_points import ignition
from crankstar.studies.answers import amplitudes, rests_on, torques
from crankstar.studies.assumed_gas import AT_SAME_CHARGE

SHIP: dict[str, Any] = {
    **FIVE,
    "name": "ship",
    "cycle": "two-stroke",
    "firing_order": [1, 5, 3, 4, 2, 6],
    "speed": "120 rpm",
    "cylinder": {
        "bore": "500 mm",
        "stroke": "1950 mm",
        "rod_length": "2050 mm",
        "reciprocating_mass": "3200 kg",
        "rotating_mass": "3400 kg",
    },
    "layout": {"type": "inline", "bore_pitch": "890 mm"},
    "torsion": {
        "bare_inertia": ["2600 kg*m^2"],
        "stiffness": ["700 MN*m/rad"],
        "disc": [
            {"name": "wheel", "inertia": "3000 kg*m^2", "to": "rear"},
            {
                "name": "propeller",
                "inertia": "24000 kg*m^2",
                "to": "wheel",
                "stiffness": "45 MN*m/rad",
                "diameter": "380 mm",
            },
        ],
    },
}
"""With a propeller whose damping is not known."""


def written(tmp_path: Path, tree: dict[str, Any]) -> str:
    path = tmp_path / "engine.toml"
    path.write_text(tree_text(tree), encoding="utf-8")
    return str(path)


@pytest.mark.release
def test_what_a_propeller_damps_is_in_the_record_as_it_is_by_hand(tmp_path: Path, run: Run) -> None:
    ship = written(tmp_path, SHIP)
    row = rows_by_path(json.loads(run("torsion", ship, "--json").out))[
        "torsion.disc[2].absolute_damping"
    ]
    torque = float(json.loads(run("torque", ship, "--json").out)["mean_torque"])
    assert (row["status"], row["low"], row["unit"]) == ("missing", 0.0, "N*m*s/rad")
    assert row["high"] == pytest.approx(5 * torque / (4 * pi), rel=1e-6)  # 120 rpm


def test_a_shaft_of_one_mass_that_nothing_drives_is_answered(run: Run) -> None:
    answer = run("torsion", "single", "--set", "torsion.inertia=0.01 kg*m^2", "--json")
    assert answer.code == 0
    assert json.loads(answer.out)["modes"] == []


def test_crankpins_that_new_counterweights_do_not_balance_are_named(
    tmp_path: Path, run: Run
) -> None:
    """What they leave is what the fitted engine has with such pins."""
    tree = {**FIVE, "cylinder": {**FIVE["cylinder"], "rotating_mass": "400 g"}}
    fitted = str(tmp_path / "fitted.toml")
    told = run("balance", written(tmp_path, tree), "--weights", "ends", "-o", fitted).out
    assert "cylinder.throw_mass: no mass of the crankpins in the file" in told
    own = crankstar.load(fitted)
    assert own.shafts[0].weights
    answer = amplitudes(own)
    [pins] = [each for each in rests_on(own, answer) if each.path == "cylinder.throw_mass"]
    assert pins.high is not None
    assert pins.moved is not None
    heavy = crankstar.load(fitted, changes={"cylinder.throw_mass": f"{pins.high!r} kg"})
    key = pins.moved.quantity, pins.moved.order
    assert pins.moved.high == pytest.approx(amplitudes(heavy).figures(heavy)[key])
    assert pins.moved.high > 2 * pins.moved.now


@pytest.mark.release
def test_axes_are_as_uncertain_of_an_estimated_block_as_of_a_given_one() -> None:
    from crankstar.analyses.mounts.figures import on_mounts

    engine = standing()
    assert engine.block is not None
    bare = engine.model_copy(
        update={
            "block": engine.block.model_copy(
                update=dict.fromkeys(("inertia_up", "inertia_right", "inertia_z"))
            )
        }
    )
    found = {each.path: each for each in rests_on(bare, on_mounts(bare, speed=300.0))}
    own = body(bare).inertia
    up_z = found["block.product_up_z"]
    assert up_z.high == pytest.approx(0.2 * (own[0] * own[2]) ** 0.5)
    assert up_z.vary is not None
    tilted = up_z.vary(bare, 0.1).block
    assert tilted is not None
    assert (tilted.inertia, tilted.product_up_z) == (own, 0.1)


def test_the_box_about_a_radial_reaches_as_far_over_slave_rods_as_over_the_master() -> None:
    engine = crankstar.load("tests/cases/radial-clockwise.toml")
    radius = engine.throw(engine.first).radius
    bore = engine.first.bore or 2 * radius
    master = next(each for each in engine.cylinders if each.articulated is None)
    top = radius + master.rod_length + bore
    corners = np.array(
        [
            np.exp(1j * each.bearing) * (top + side * 0.5j * bore)
            for each in engine.cylinders
            for side in (-1, 1)
        ]
    )
    up, right, _along = outline(engine)
    assert (up, right) == pytest.approx(
        (np.ptp(np.real(corners)), np.ptp(np.imag(corners))), rel=0.05
    )


def test_pistons_that_face_each_other_ignite_by_compression() -> None:
    assert ignition(crankstar.load("jumo-205"), Gas()) == ("compression", False)


def test_the_usual_load_of_a_diesel_reaches_to_that_with_a_charger() -> None:
    engine = engine_of(SHIP)
    [gas] = [each for each in rests_on(engine, amplitudes(engine)) if each.path == "gas"]
    assert (gas.low, gas.high) == pytest.approx((0.7 * 9, 2.4 * 9))


@pytest.mark.parametrize(
    ("bore", "codes"),
    [
        ("84 m", ["doubt.bore-pitch", "doubt.stroke"]),
        ("95 mm", ["doubt.bore-pitch"]),
        ("8 mm", ["doubt.stroke"]),
        ("82 mm", []),
    ],
)
def test_a_slip_of_the_unit_of_a_bore_is_doubted(bore: str, codes: list[str]) -> None:
    engine = engine_of({**FIVE, "cylinder": {**FIVE["cylinder"], "bore": bore}})
    assert [fault.code for fault in size_doubts(engine)] == codes


def test_a_wrong_number_of_throws_hides_no_other_mistake() -> None:
    wrong = {
        **SHIP,
        "firing_order": [1, 5, 3, 4, 2, 2],
        "layout": {**SHIP["layout"], "throws": ["0 deg"] * 5},
        "torsion": {**SHIP["torsion"], "disc": [{"name": "a", "inertia": 1.0, "to": "raer"}]},
    }
    with pytest.raises(EngineFileError) as caught:
        engine_of(wrong)
    places = {fault.path[:2] for fault in caught.value.faults}
    assert {("firing_order",), ("torsion", "disc")} <= places


@pytest.mark.parametrize("offset", ["0 mm", "24 mm"])
def test_rods_side_by_side_do_not_stand_in_the_planes_of_their_bearings(offset: str) -> None:
    twin = engine_of(
        {
            **FIVE,
            "firing_order": [1, 2],
            "layout": {
                "type": "vee",
                "throws": ["0 deg"],
                "bank_offset": offset,
                "banks": [
                    {"bearing": "-45 deg", "cylinders": [1]},
                    {"bearing": "45 deg", "cylinders": [2]},
                ],
            },
        }
    )
    front, rear = main_bearings(twin, twin.shafts[0])
    assert front - rear == pytest.approx(0.090)  # the stroke
    assert all(rear < each.z < front for each in twin.cylinders)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("mount_mode_1", "--reference", "30 mm"), "--reference has no effect"),
        (("mount_mode_1", "--speed", "900 rpm"), "--speed has no effect"),
        (("mount_force", "--reference", "30 mm"), "--reference has no effect"),
    ],
)
def test_a_sweep_refuses_what_no_watched_quantity_depends_on(
    words: tuple[str, ...], told: str, tmp_path: Path, refused: Callable[..., str]
) -> None:
    path = tmp_path / "five.toml"
    block = f'\n[block]\nmass = "150 kg"\n{RUBBER}'
    path.write_text(tree_text(FIVE) + block, encoding="utf-8")
    over = ("--over", "block.mass=140..160 kg/2")
    assert told in refused("sweep", str(path), *over, "--quantity", *words)


@pytest.mark.parametrize(
    ("at", "error"),
    [
        ("123", ValueError),
        ("lever", ValueError),
        ([float("nan")] * 3, ValueError),
        ((1e9, 0, 0), ValueError),
        ((1, 2), TypeError),
        ((1, 2, 3, 4), TypeError),
        (3, TypeError),
        (b"abc", TypeError),
    ],
)
def test_what_is_no_point_of_the_block_is_refused(at: Any, error: type[Exception]) -> None:
    with pytest.raises(error, match=r"^at "):
        crankstar.mounts(standing(), at=at)


@pytest.mark.parametrize(
    ("at", "place"), [("100 mm", (0.0, 0.0, 0.1)), (np.array([0.1, 0.0, 0.2]), (0.1, 0.0, 0.2))]
)
def test_a_point_of_the_block_may_be_text(at: Any, place: tuple[float, ...]) -> None:
    assert crankstar.mounts(standing(), at=at).point == place


def test_where_a_charge_is_kept_that_a_run_by_hand_would_change_it_is_said() -> None:
    """At 70 deg the air of 1 bar no longer burns 9 bar: by hand a charger is assumed."""
    cylinder = {"bore": "104 mm", "stroke": "118 mm", "rod_length": "190 mm"}
    gas = {"ignition": "compression", "bmep": "9 bar"}
    four = {**FIVE, "firing_order": [1, 3, 4, 2], "speed": "1500 rpm", "gas": gas}
    engine = engine_of({**four, "cylinder": {**FIVE["cylinder"], **cylinder}})
    found = rests_on(engine, torques(engine, cycle))
    [closing] = [each for each in found if each.path == "valves.intake_closes"]
    [opening] = [each for each in found if each.path == "valves.exhaust_opens"]
    assert closing.reason == AT_SAME_CHARGE
    assert opening.reason != AT_SAME_CHARGE
    late = engine_of(
        {
            **four,
            "cylinder": {**FIVE["cylinder"], **cylinder},
            "valves": {"intake_closes": "70 deg"},
        }
    )
    pressures = [cycle(each).values["intake_pressure"] for each in (engine, late)]
    assert pressures[1] > 1.5 * pressures[0]


def test_gas_that_a_file_does_not_give_has_its_size_on_the_mounts() -> None:
    from crankstar.analyses.mounts.figures import on_mounts

    tree = tomllib.loads(tree_text(FIVE) + f'\n[block]\nmass = "150 kg"\n{RUBBER}')
    engine, speeds = engine_of(tree), [3000 * pi / 30]
    [gas] = [
        each
        for each in rests_on(engine, on_mounts(engine, speeds=speeds))
        if each.path.startswith("gas")
    ]
    assert (gas.status, gas.unit) == ("left out", "bar")
    assert (gas.low, gas.high) == pytest.approx((6.3, 21.6))
    assert gas.moved is not None
    key = gas.moved.quantity, gas.moved.order
    loaded = engine_of({**tree, "gas": {"imep": "21.6 bar", "ignition": "compression"}})
    assert gas.moved.high == pytest.approx(on_mounts(loaded, speeds=speeds).figures(loaded)[key])
    assert gas.moved.now < gas.moved.low


def test_how_a_crankshaft_stands_on_its_bearings_is_a_choice_with_a_figure(run: Run) -> None:
    usual = json.loads(run("bearings", "audi-25-tfsi", "--json").out)
    other = json.loads(run("bearings", "audi-25-tfsi", "--model", "continuous", "--json").out)
    row = rows_by_path(usual)["--model"]
    assert row["value"] == "determinate"
    assert "--model" not in rows_by_path(other)
    engine = crankstar.load("audi-25-tfsi")
    loads = [
        float(
            spectra.peaks(
                crankstar.bearing_loads(engine, speed=engine.speed, model=model).load
            ).max()
        )
        for model in ("determinate", "continuous")
    ]
    moved = row["moves"]
    assert (moved["now"], max(moved["low"], moved["high"])) == pytest.approx(tuple(loads))


def test_rods_on_one_pin_that_may_stand_side_by_side_have_their_couple_named() -> None:
    """As wide apart as the range goes: what a file with that offset of its banks has."""
    twin: dict[str, Any] = {
        **FIVE,
        "firing_order": [1, 2],
        "layout": {
            "type": "vee",
            "throws": ["0 deg"],
            "banks": [
                {"bearing": "-45 deg", "cylinders": [1]},
                {"bearing": "45 deg", "cylinders": [2]},
            ],
        },
    }
    engine = engine_of(twin)
    found = {each.path: each for each in rests_on(engine, amplitudes(engine))}
    apart = found["layout.bank_offset"]
    assert (apart.low, apart.high) == pytest.approx((-0.3 * 82, 0.3 * 82))
    assert apart.moved is not None
    layout = {**twin["layout"], "bank_offset": f"{apart.high} mm"}
    wide = engine_of({**twin, "layout": layout})
    key = apart.moved.quantity, apart.moved.order
    assert apart.moved.high == pytest.approx(amplitudes(wide).figures(wide)[key])
    given = [each.path for each in rests_on(wide, amplitudes(wide))]
    assert "layout.bank_offset" not in given


def test_guide_force_moments_of_a_ship_without_gas_are_told_as_a_range(run: Run) -> None:
    """Six even firings leave the sixth order; the upper end is that of a file with that load."""
    ship = {key: value for key, value in SHIP.items() if key != "gas"}
    typed = tree_text(ship).encode()
    printed = run("marine", "-", stdin=typed).out
    gas = rows_by_path(json.loads(run("marine", "-", "--json", stdin=typed).out))["gas"]
    moved = gas["moves"]
    assert (moved["quantity"], moved["order"]) == ("H moment", 6)
    engine = engine_of({**ship, "gas": {"imep": f"{gas['high']} bar"}})
    guide = crankstar.marine(engine).guide
    assert guide is not None
    [sixth] = abs(guide.h[guide.orders == 6])
    assert moved["high"] == pytest.approx(sixth)
    assert "H moment of order 6" in printed
    assert "not 0" not in printed


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (
            ["torque", "audi-25-tfsi", "--motored", "--off", "2"],
            "--off has no effect with --motored",
        ),
        (["torsion", "five.json", "--modes", "99"], "--modes 99: there are 4 modes"),
        (["derive", "i4", "--orders", "99"], "--orders 99: give crank orders above 0 and up to 24"),
    ],
)
def test_an_option_that_can_do_nothing_is_named(run: Run, words: list[str], told: str) -> None:
    Path("five.json").write_text(json.dumps({**FIVE, "torsion": TWISTED}))
    ran = run(*words)
    assert ran.code == 2
    assert told in " ".join(ran.err.split())


TWISTED = {"inertia": ["0.01 kg*m^2"], "stiffness": ["0.5 MN*m/rad"]}


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"cylinder.bore": float("nan")}, "cylinder.bore is nan, which is not finite; a length is"),
        ({"cylinder.bore": float("inf")}, "cylinder.bore is inf, which is not finite; a length is"),
        ({"cylinder": 5}, "cylinder is 5; a table is needed"),
    ],
)
def test_a_value_that_is_none_is_the_one_mistake(
    tmp_path: Path, changes: dict[str, Any], told: str
) -> None:
    file = tmp_path / "five.json"
    file.write_text(json.dumps({**FIVE, "drive": {"inertia": "0.1 kg*m^2"}}))
    with pytest.raises(EngineFileError) as caught:
        crankstar.load(file, changes=changes)
    assert told in str(caught.value)
    assert len(caught.value.faults) == 1
