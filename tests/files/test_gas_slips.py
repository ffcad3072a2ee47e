"""Slips in `[gas]`: keys without effect, units, traces, values that hardly any engine has."""

from __future__ import annotations

import json
import re
from math import cos, degrees, pi, radians
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run
from tests.marine import marine_engine
from tests.texts import SHORT, spoilt

import crankstar
from crankstar import spectra
from crankstar.engine import motion
from crankstar.engine.gas import Gas
from crankstar.engine.valves import timing
from crankstar.files import EngineFileError, engine_of, explicit, tree_of
from crankstar.firing.intervals import firing
from crankstar.mechanics.doubts import doubts
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.operating_points import SCAVENGING, ignition
from crankstar.tables.bobweights import bobweights
from crankstar.tables.cures import proposal


def mistakes(**tables: Any) -> list[str]:
    with pytest.raises(EngineFileError) as refusal:
        engine_of(spoilt(SHORT, **tables))
    return [fault.code for fault in refusal.value.faults]


def pressures(angles: range, place: float = 0.0) -> list[float]:
    return [1 + 49 * max(cos(radians((angle - place) / 4)), 0.0) ** 40 for angle in angles]


def trace(place: float = 0.0, angles: range = range(-360, 360, 2)) -> dict[str, Any]:
    """A pressure with its peak at a place."""
    return {
        "angle": [f"{angle} deg" for angle in angles],
        "pressure": [[f"{pressure} bar" for pressure in pressures(angles, place)]],
    }


@pytest.mark.parametrize("process", ["otto", "diesel", "limited-pressure"])
@pytest.mark.parametrize(
    "key",
    [
        {"variable_gamma": True},
        {"wiebe_a": 5.0},
        {"wiebe_m": 2.0},
        {"combustion_start": "0 deg"},
        {"combustion_duration": "50 deg"},
        {"wall_temperature": "450 K"},
    ],
)
def test_a_key_of_a_heat_release_is_refused_with_an_ideal_cycle(
    process: str, key: dict[str, Any]
) -> None:
    assert mistakes(gas={"process": process, **key}) == ["gas.not-of-process"]


@pytest.mark.parametrize(
    ("gas", "code"),
    [
        ({"gamma": 1.3, "variable_gamma": True}, "gas.gamma-twice"),
        ({"friction": "diesel", "friction_pressure": "2 bar"}, "gas.friction-twice"),
        ({"trace": trace(), "wiebe_m": 2.0}, "gas.not-of-trace"),
        ({"trace": trace(), "point": [{"name": "a", "imep": "3 bar"}]}, "gas.trace-and-load"),
    ],
)
def test_a_key_without_effect_is_told(gas: dict[str, Any], code: str) -> None:
    assert mistakes(gas=gas) == [code]


def test_a_point_names_its_key_without_effect_as_the_file_does() -> None:
    gas = {"process": "otto", "point": [{"name": "a", "combustion_start": "-9 deg"}]}
    with pytest.raises(EngineFileError) as refusal:
        engine_of(spoilt(SHORT, gas=gas))
    assert [fault.path for fault in refusal.value.faults] == [
        ("gas", "point", 0, "combustion_start")
    ]


@pytest.mark.parametrize("place", [360.0, -360.0, 180.0, 100.0])
def test_a_trace_whose_peak_is_elsewhere_is_refused(place: float) -> None:
    assert mistakes(gas={"trace": trace(place, range(-360, 360, 2))})[0] in (
        "trace.peak",
        "trace.jump",
    )
    late = trace(place, range(int(place) - 360, int(place) + 360, 2))
    assert mistakes(gas={"trace": late}) == ["trace.peak"]


def test_a_trace_that_hardly_changes_is_refused() -> None:
    flat = trace() | {"pressure": [["30 bar"] * 360]}
    assert mistakes(gas={"trace": flat}) == ["trace.constant"]


@pytest.mark.release
def test_a_trace_with_one_slip_in_every_sample_has_one_fault() -> None:
    for wrong in ("5 furlong", "-5 bar", "5 barg", 5):
        assert len(mistakes(gas={"trace": trace() | {"pressure": [[wrong] * 360]}})) == 1


@pytest.mark.parametrize(
    ("text", "kelvin"),
    [
        ("60 degC", 333.15),
        ("60 \u00b0C", 333.15),
        ("60\u00b0C", 333.15),
        ("60 \u2103", 333.15),
        ("140 degF", 333.15),
        ("-10 degC", 263.15),
        ("333.15 K", 333.15),
    ],
)
def test_temperatures_are_read_on_every_scale(text: str, kelvin: float) -> None:
    gas = {"variable_gamma": True, "intake_temperature": text}
    found = engine_of(spoilt(SHORT, gas=gas)).gas
    assert found is not None
    assert found.intake_temperature == pytest.approx(kelvin)


def test_no_temperature_is_below_absolute_nought() -> None:
    gas = {"variable_gamma": True, "intake_temperature": "-300 degC"}
    assert mistakes(gas=gas) == ["greater-than.example"]


@pytest.mark.parametrize("text", ["0.2 barg", "3 psig", "0.2 bar(g)", "20 kPa gauge"])
def test_a_gauge_pressure_is_refused_with_advice(text: str) -> None:
    assert mistakes(gas={"intake_pressure": text}) == ["unit.gauge"]


def test_an_absolute_pressure_may_say_so() -> None:
    for text in ("1.2 bara", "1.2 bar(a)", "1.2 bar"):
        found = engine_of(spoilt(SHORT, gas={"intake_pressure": text})).gas
        assert found is not None
        assert found.intake_pressure == pytest.approx(1.2e5)


def with_csv(tmp_path: Path, head: str, factor: float = 1.0, turn: float = 1.0) -> str:
    angles = range(-360, 360)
    rows = zip(angles, pressures(angles), strict=True)
    lines = [head, *(f"{angle * turn:.9g},{factor * p:.9g}" for angle, p in rows)]
    (tmp_path / "p.csv").write_text("\n".join(lines), encoding="utf-8")
    place = tmp_path / "mine.toml"
    place.write_text(SHORT + '\n[gas]\ntrace = "p.csv"\n', encoding="utf-8")
    return str(place)


@pytest.mark.many(first=2)
@pytest.mark.parametrize(
    ("head", "factor", "turn"),
    [
        ("angle,p [atm]", 1e5 / 101_325, 1.0),
        ("angle,p_atm", 1e5 / 101_325, 1.0),
        ("angle [rad],p [MPa]", 0.1, radians(1)),
        ("CA [\u00b0CA],p (cyl 1) [bar]", 1.0, 1.0),
        ("angle,p [kgf/cm2]", 1e5 / 98_066.5, 1.0),
        ("angle,pressure bara", 1.0, 1.0),
        ("angle,cylinder 1", 1.0, 1.0),
    ],
)
def test_the_heads_of_a_trace_say_its_units(
    head: str, factor: float, turn: float, run: Run, tmp_path: Path
) -> None:
    result = run("torque", with_csv(tmp_path, head, factor, turn), "--json")
    assert json.loads(result.out)["peak_pressure"] == pytest.approx(50e5, rel=1e-6)


@pytest.mark.parametrize(
    ("head", "words"),
    [
        ("angle,p [furlong]", "the unit of a pressure"),
        ("angle,p [barg]", "gauge pressure"),
        ("angle,p barg", "gauge pressure"),
        ("angle [mm],p [bar]", "the unit of an angle"),
    ],
)
def test_a_head_with_no_unit_of_its_column_is_refused(
    head: str, words: str, run: Run, tmp_path: Path
) -> None:
    assert words in " ".join(run("check", with_csv(tmp_path, head)).err.split())


def test_a_column_below_nought_is_told_to_be_gauge(run: Run, tmp_path: Path) -> None:
    place = with_csv(tmp_path, "angle,p [bar]")
    text = (tmp_path / "p.csv").read_text(encoding="utf-8")
    (tmp_path / "p.csv").write_text(text.replace("\n200,1", "\n200,-0"), encoding="utf-8")
    assert "absolute pressures are above 0" in " ".join(run("check", place).err.split())


def test_ignition_follows_process_ratio_and_bore_and_what_the_file_says() -> None:
    small, large = crankstar.load("honda-b18c"), crankstar.load("man-s90mc-c")
    assert ignition(small, Gas()) == ("spark", False)
    assert ignition(large, Gas()) == ("compression", False)
    assert ignition(small, Gas(compression_ratio=14.0)) == ("spark", False)
    assert ignition(small, Gas(compression_ratio=14.1)) == ("compression", False)
    assert ignition(large, Gas(compression_ratio=12.0)) == ("spark", False)
    assert ignition(small, Gas(process="diesel")) == ("compression", True)
    assert ignition(small, Gas(friction="diesel")) == ("compression", True)
    assert ignition(small, Gas(ignition="compression", compression_ratio=9)) == (
        "compression",
        True,
    )


@pytest.mark.release
def test_what_is_assumed_of_ignition_is_told(run: Run) -> None:
    changes = ("--set", "gas.compression_ratio=18")
    shown = " ".join(run("torque", "honda-b18c", *changes).out.split())
    assert "gas.ignition: compression assumed" in shown
    assert "Friction as of motored Diesel engines" in shown
    given = run("torque", "honda-b18c", *changes, "--set", "gas.ignition=spark").out
    assert not re.search(r"gas\.ignition[:(]| gas\.ignition \(", given)
    assert "motored spark-ignition engines" in " ".join(given.split())


def test_an_assumed_two_stroke_charge_drives_the_exhaust_out() -> None:
    engine = crankstar.load("kr250-racer")
    for changes in ({}, {"gas.intake_pressure": "3 bar"}, {"gas.exhaust_pressure": "2 bar"}):
        given = engine if not changes else crankstar.load("kr250-racer", changes=changes)
        values = cycle(given, speed=500.0, imep=9e5).values
        assert values["intake_pressure"] == pytest.approx(SCAVENGING * values["exhaust_pressure"])


def test_intake_pressure_of_two_strokes_is_that_at_the_later_closing() -> None:
    """Of the seven, whose exhaust closes last; p V^gamma holds from there and not before."""
    engine = marine_engine()
    found = cycle(engine)
    times = timing(engine.valves, cycle=engine.cycle)
    assert times.exhaust_closes > times.intake_closes
    least = found.volumes.swept[0] / (found.values["compression_ratio"] - 1)
    volume, pressure = found.volumes.above[0] + least, found.pressure[0]
    exponent = found.values["gamma"]
    per_degree = pressure.size / 360
    at = {
        name: round((180 + degrees(getattr(times, name)) + 0.2) * per_degree)
        for name in ("intake_closes", "exhaust_closes")
    }
    later = at["exhaust_closes"]
    for place in (later, later + 100):
        charge = pressure[place] * (volume[place] / volume[later]) ** exponent
        assert charge == pytest.approx(found.values["intake_pressure"], rel=0.01)
    assert pressure[at["intake_closes"]] < 0.99 * found.values["intake_pressure"]
    said = Gas.model_fields["intake_pressure"].description
    assert said is not None
    assert "two strokes the later of intake and exhaust" in said


def test_a_given_friction_pressure_replaces_the_correlation() -> None:
    engine = crankstar.load("honda-b18c", changes={"gas.friction_pressure": "2 bar"})
    computed = cycle(engine, bmep=8e5)
    assert computed.friction == pytest.approx(2e5)
    assert computed.imep == pytest.approx(10e5)
    assert "friction" not in computed.assumed


@pytest.mark.parametrize(
    ("gas", "code"),
    [
        ({"compression_ratio": 18, "ignition": "spark"}, "doubt.spark-ratio"),
        ({"compression_ratio": 8, "ignition": "compression"}, "doubt.diesel-ratio"),
        ({"gamma": 1.6}, "doubt.gamma"),
        ({"combustion_duration": "170 deg"}, "doubt.late"),
        ({"peak_pressure": "260 bar", "intake_pressure": "4 bar"}, "doubt.peak"),
        ({"imep": "36 bar", "intake_pressure": "4 bar"}, "doubt.imep"),
        ({"imep": "25 bar", "intake_pressure": "1 bar"}, "doubt.charge"),
        ({"speed": "9000 rpm"}, "doubt.friction"),
        ({"friction_pressure": "50 bar"}, "doubt.great-friction"),
        ({"process": "diesel", "ignition": "spark"}, "doubt.ignition"),
        ({"friction": "diesel", "ignition": "spark"}, "doubt.ignition"),
        ({"process": "otto", "friction": "diesel"}, "doubt.process-ignition"),
        ({"process": "diesel", "friction": "spark-ignition"}, "doubt.process-ignition"),
        ({"imep": "0.2 bar", "intake_pressure": "1.5 bar"}, "doubt.no-cycle"),
    ],
)
def test_a_value_that_hardly_any_engine_has_is_told_by_check(
    gas: dict[str, Any], code: str
) -> None:
    changes = {f"gas.{key}": value for key, value in gas.items()}
    engine = crankstar.load("bmw-m52b28", changes={"gas": {}})
    assert doubts(engine) == ()
    engine = crankstar.load("bmw-m52b28", changes={"gas": {}, **changes})
    assert code in [fault.code for fault in doubts(engine)]


@pytest.mark.release
def test_a_point_at_the_speed_of_the_load_of_the_table_is_told_by_check_and_torque(
    run: Run,
) -> None:
    points = [{"name": "part", "speed": "6000 rpm", "imep": "5 bar"}]
    changes = {"gas": {"imep": "9 bar", "speed": "6000 rpm", "point": points}}
    engine = crankstar.load("bmw-m52b28", changes=changes)
    assert [fault.code for fault in doubts(engine)] == ["doubt.shadowed"]
    assert "at 6000 rpm, where the load of the table" in doubts(engine)[0].sentence
    assert cycle(engine, speed=6000 * pi / 30).imep == pytest.approx(9e5)
    Path("six.json").write_text(json.dumps(explicit(engine)))
    for words in ([], ["--speed", "6000 rpm"]):
        assert "gas.point[1] (part) is at 6000 rpm" in " ".join(
            run("torque", "six.json", *words).out.split()
        )
    assert "(part) is at" not in " ".join(run("torque", "six.json", "--point", "part").out.split())


def test_a_course_of_the_load_ends_as_it_began() -> None:
    tree = {"load_angle": ["0 deg", "360 deg", "720 deg"], "load_torque": [1, 2, 3]}
    with pytest.raises(EngineFileError, match="which is the same angle"):
        crankstar.load("bmw-m52b28", changes={"drive": tree})
    for last in ({"load_torque": [1, 2, 1]}, {"load_angle": ["0 deg", "360 deg", "719 deg"]}):
        crankstar.load("bmw-m52b28", changes={"drive": {**tree, **last}})


def test_an_exhaust_above_the_charge_of_a_two_stroke_is_doubted() -> None:
    changes = {"gas.intake_pressure": "1.0 bar", "gas.exhaust_pressure": "1.1 bar"}
    engine = crankstar.load("kr250-racer", changes=changes)
    assert [fault.code for fault in doubts(engine)] == ["doubt.scavenging"]


def test_moments_of_inertia_out_of_proportion_are_told_once(run: Run, tmp_path: Path) -> None:
    text = """
name = "four"
firing_order = [1, 3, 4, 2]
[cylinder]
bore = "82 mm"
stroke = "90 mm"
rod_length = "145 mm"
reciprocating_mass = "480 g"
rod = { mass = "500 g", centre = "45 mm", inertia = "0.00002 kg*m^2" }
[layout]
type = "inline"
bore_pitch = "91 mm"
[drive]
inertia = "0.0002 kg*m^2"
"""
    (tmp_path / "four.toml").write_text(text, encoding="utf-8")
    shown = " ".join(run("check", str(tmp_path / "four.toml")).out.split())
    assert shown.count("cylinder.rod.inertia is 2e-05 kg m²") == 1
    assert "drive.inertia is 0.0002 kg m², less than" in shown
    good = text.replace("0.00002", "0.002").replace("0.0002", "0.2")
    (tmp_path / "four.toml").write_text(good, encoding="utf-8")
    assert "kg m²" not in run("check", str(tmp_path / "four.toml")).out


CASES = Path(__file__).parents[1] / "cases"


def test_late_combustion_is_told_with_its_angles() -> None:
    engine = crankstar.load("bmw-m52b28", changes={"gas.combustion_duration": "160 deg"})
    late = next(fault for fault in doubts(engine) if fault.code == "doubt.late")
    assert late.values == {"end": pytest.approx(140.0), "opened": pytest.approx(130.0)}
    assert degrees(radians(130)) == pytest.approx(late.values["opened"])


@pytest.mark.parametrize("ratio", [1.63, 2.4])
def test_a_rod_ratio_that_is_one_to_the_stroke_is_doubted(ratio: float, run: Run) -> None:
    """1.63 strokes are 3.26 crank radii; taken as radii it has 2.2 times the secondary force."""
    engine = crankstar.load("i4", changes={"cylinder.rod_ratio": ratio})
    (fault,) = doubts(engine)
    assert (fault.code, fault.path) == ("doubt.rod-ratio", ("cylinder", "rod_ratio"))
    assert (fault.values["value"], fault.values["meant"]) == (ratio, 2 * ratio)
    said = run("analyze", "i4", "--set", f"cylinder.rod_ratio={ratio}").out
    assert f"rod_ratio is {2 * ratio:g}. With l/r = {2 * ratio:g} the " in " ".join(said.split())
    rests = json.loads(run("analyze", "i4", "--set", f"cylinder.rod_ratio={ratio}", "--json").out)
    moves = rests["rests_on"][0]["moves"]
    sizes = [motion.piston_harmonics(crank_radius=1, rod_length=k * ratio)[2].real for k in (1, 2)]
    assert (moves["quantity"], moves["order"]) == ("force", 2)
    assert moves["low"] == moves["high"] == pytest.approx(4 * abs(sizes[1]))
    assert moves["now"] == pytest.approx(4 * abs(sizes[0]))


@pytest.mark.parametrize("name", ["man-s50mc-c", "mwm-6-diesel", "radial-9", "i4"])
def test_rods_of_crosshead_engines_and_usual_ones_are_not_doubted(name: str) -> None:
    assert "doubt.rod-ratio" not in [fault.code for fault in doubts(crankstar.load(name))]


def test_a_doubt_of_a_point_names_the_key_where_it_stands() -> None:
    """Points have no key friction: it is that of the table which all of them share."""
    point = {"name": "high", "speed": "3000 rpm", "imep": "0.01 bar"}
    own = {"ignition": "compression", "friction": "spark-ignition", "compression_ratio": 18}
    engine = crankstar.load("honda-b18c", changes={"gas": {**own, "point": [point]}})
    found = {fault.code: fault.path for fault in doubts(engine)}
    assert found["doubt.ignition"] == ("gas", "friction")
    assert found["doubt.small-load"] == ("gas", "point", 0, "imep")


@pytest.mark.release
@pytest.mark.parametrize("key", ["intake_pressure", "exhaust_pressure"])
def test_pressures_beside_a_trace_are_said_to_be_of_the_file_or_measured(
    key: str, run: Run
) -> None:
    idle = str(CASES / "v6-idle-trace.toml")
    words = ("torque", idle, "--off", "2")
    measured = " ".join(run(*words).out.split())
    assert measured.count("(as measured)") == 2
    given = " ".join(run(*words, "--set", f"gas.{key}=0.7 bar").out.split())
    assert given.count("(as measured)") == given.count("0.7 bar (of the file)") == 1


CROSSHEAD = """
name = "six with crossheads"
firing_order = [1, 5, 3, 4, 2, 6]
speed = "105 rpm"
[cylinder]
stroke = "2400 mm"
rod_length = "2460 mm"
reciprocating_mass = "5600 kg"
rotating_mass = "4300 kg"
[layout]
type = "inline"
bore_pitch = "1020 mm"
"""
"""Without a cycle: its throws are those of four strokes, and it fires every 120 degrees."""


@pytest.mark.parametrize("bore", ["600 mm", None])
def test_four_strokes_of_an_engine_with_crossheads_are_doubted(
    bore: str | None, run: Run, tmp_path: Path
) -> None:
    """Two strokes fire every 60 deg, and of six even throws no primary couple is left."""
    sized = CROSSHEAD.replace(
        "[cylinder]", f'[cylinder]\nbore = "{bore}"' if bore else "[cylinder]"
    )
    (tmp_path / "ship.toml").write_text(sized, encoding="utf-8")
    four = crankstar.load(tmp_path / "ship.toml")
    (fault,) = doubts(four)
    assert fault.path == ("cycle",)
    assert fault.code == ("doubt.cycle" if bore else "doubt.cycle-of-stroke")
    if bore:
        assert fault.values["ratio"] == 2400 / 600
    for words in (["marine"], ["verdict"], ["analyze"], ["strokes"]):
        out = run(*words, str(tmp_path / "ship.toml")).out
        rests = out.partition("This rests on:\n")[2]
        assert rests.startswith("cycle is four-stroke, given or by default"), words
    two = crankstar.load(tmp_path / "ship.toml", changes={"cycle": "two-stroke"})
    assert doubts(two) == ()
    couples = [crankstar.total(crankstar.balance(each)).couple for each in (four, two)]
    first = [float(spectra.peak(spectra.selected(each, [1.0])).value) for each in couples]
    assert first[0] > 1e6
    assert first[1] < 1e-6


def test_valves_that_are_ports_are_doubted() -> None:
    """Of a two-stroke moped: ports are open as long before bottom dead centre as after it."""
    own = {
        "intake_opens": "58 deg", "intake_closes": "58 deg",
        "exhaust_opens": "80 deg", "exhaust_closes": "80 deg",
    }  # fmt: skip
    (fault,) = doubts(crankstar.load("i4", changes={"valves": own}))
    assert (fault.code, fault.path) == ("doubt.overlap", ("valves",))
    assert fault.values["value"] == pytest.approx(58 + 80)
    own["exhaust_closes"] = "60 deg"
    assert doubts(crankstar.load("i4", changes={"valves": own})) == ()


def test_a_pin_split_that_makes_firing_less_even_is_doubted() -> None:
    even = crankstar.load("v8-cross-plane")
    assert "doubt.pin-split" not in [fault.code for fault in doubts(even)]
    split = crankstar.load("v8-cross-plane", changes={"layout.pin_split": "30 deg"})
    (fault,) = [fault for fault in doubts(split) if fault.code == "doubt.pin-split"]
    assert fault.path == ("layout", "pin_split")
    assert fault.values["intervals"] == "60-90-120-60-120-90-60-120"
    assert fault.values["without"] == "-".join(["90"] * 8)


def test_a_crank_that_fires_in_a_bunch_is_doubted_with_what_fires_evenly() -> None:
    """By dead centres: cylinder of bank b on pin p fires at b - p, in either turn, 720 deg long."""
    text = V6.replace("[1, 6, 5, 4, 3, 2]", "[1, 2, 3, 4, 5, 6]")
    text = text.replace('"120 deg", "240 deg"', '"240 deg", "120 deg"')
    engine = engine_of(tree_of(text))
    assert firing(engine).intervals_deg == pytest.approx([60.0] * 5 + [420.0])
    (fault,) = [each for each in doubts(engine) if each.code.startswith("doubt.firing")]
    assert fault.values["intervals"] == "60-60-60-60-60-420"
    pins = [float(angle) for angle in fault.values["throws"].split(", ")]
    split = float(fault.values["split"])
    assert (pins, split) == ([0, 120, 240], -30)
    dead = {}
    for number in range(1, 7):
        bank = (number - 1) % 2
        pin = pins[(number - 1) // 2] + bank * split
        dead[number] = ((-45, 45)[bank] - pin + 45) % 360
    assert [dead[number] for number in range(1, 7)] == [120 * k % 360 for k in range(6)]
    proposed = text.replace('"240 deg", "120 deg"', '"120 deg", "240 deg"')
    proposed = proposed.replace('"30 deg"', '"-30 deg"')
    assert firing(engine_of(tree_of(proposed))).intervals_deg == pytest.approx([120.0] * 6)


@pytest.mark.parametrize("name", ["v8-cross-plane", "harley-45", "vw-vr6"])
def test_uneven_engines_that_are_built_are_not_doubted(name: str) -> None:
    found = doubts(crankstar.load(name))
    assert not [each for each in found if each.code.startswith("doubt.firing")]


V6 = """
name = "V6"
firing_order = [1, 6, 5, 4, 3, 2]
[cylinder]
rod_ratio = 3.5
[layout]
type = "vee"
banks = [
  { bearing = "-45 deg", cylinders = [1, 3, 5] },
  { bearing = "45 deg", cylinders = [2, 4, 6] },
]
throws = ["0 deg", "120 deg", "240 deg"]
pin_split = "30 deg"
"""


def test_an_even_arrangement_is_proposed_before_an_uneven_one() -> None:
    """The other rotation would fire at 180-60-180-60; turned round with its pins it is even."""
    with pytest.raises(EngineFileError) as refused:
        engine_of(tree_of(V6))
    (fault,) = refused.value.faults
    assert fault.code == "firing_order.unfit-other-pins"
    assert fault.values["banks"] == {"1, 3, 5": "+45", "2, 4, 6": "-45"}
    assert fault.values["throws"] == [0, 240, 120]
    proposed = (
        V6.replace('"-45 deg"', '"@"')
        .replace('"45 deg"', '"-45 deg"')
        .replace('"@"', '"45 deg"')
        .replace('"120 deg", "240 deg"', '"240 deg", "120 deg"')
    )
    assert firing(engine_of(tree_of(proposed))).intervals_deg == pytest.approx([120.0] * 6)


@pytest.mark.parametrize(
    ("order", "change"), [([1, 2, 6, 5, 4, 3], "banks"), ([1, 2, 4, 3, 6, 5], "rotation")]
)
def test_an_uneven_arrangement_is_proposed_with_its_intervals(
    order: list[int], change: str
) -> None:
    """On common pins this V6 fires evenly in no order: what fits is named with its intervals."""
    text = V6.replace('pin_split = "30 deg"', "").replace("[1, 6, 5, 4, 3, 2]", str(order))
    with pytest.raises(EngineFileError) as refused:
        engine_of(tree_of(text))
    (fault,) = refused.value.faults
    assert fault.code == f"firing_order.unfit-uneven-{change}"
    assert fault.values["intervals"] == "270-120-90-30-90-120"


def test_shares_of_the_reciprocating_mass_are_not_headed_as_bobweights(run: Run) -> None:
    """Half of 492 g is 246 g; the rotating mass, which is not in the file, would be the most."""
    bare = run("bobweight", "i4", "--set", 'cylinder.reciprocating_mass="492 g"').out
    assert "No bobweights: the rotating masses are missing" in bare
    assert "The file gives no rotating mass" in bare
    whole = run(
        "bobweight",
        "i4",
        "--set",
        'cylinder.reciprocating_mass="492 g"',
        "--set",
        'cylinder.rotating_mass="600 g"',
    ).out
    assert "No bobweights" not in whole
    assert "846" in whole


@pytest.mark.parametrize("name", ["i4", "bmw-f800", "honda-b18c", "v8-cross-plane"])
def test_without_a_rotating_mass_nothing_is_a_bobweight_in_any_unit(name: str) -> None:
    """It is the rotating mass that makes one, not the kilograms."""
    engine = crankstar.load(name)
    headed = bobweights(crankstar.load("audi-25-tfsi"), 0.5)
    lacking = bobweights(engine, 0.5)
    assert (lacking.title, lacking.columns[-1].heading) == (
        headed.title,
        headed.columns[-1].heading,
    )
    assert "bobweight " not in proposal(engine)
    whole = bobweights(crankstar.load(name, changes={"cylinder.rotating_mass": 1.2}), 0.5)
    assert whole.title != headed.title
    assert whole.columns[-1].heading != headed.columns[-1].heading


@pytest.mark.many(first=1)
@pytest.mark.parametrize("path", ["gas", "gas.point[1]"])
def test_a_starved_charge_says_what_enough_of_it_would_change(path: str, run: Run) -> None:
    """With the pressure at which it is tried the roll is that of the command itself."""
    load = {"imep": "20 bar", "intake_pressure": "1 bar", "exhaust_pressure": "1 bar"}
    gas = load if path == "gas" else {"point": [{"name": "full", "speed": "4000 rpm", **load}]}
    engine = crankstar.load("bmw-m52b28", changes={"gas": {"ignition": "compression", **gas}})
    Path("six.json").write_text(json.dumps(explicit(engine)))
    rests = json.loads(run("torque", "six.json", "--json").out)["rests_on"]
    [doubt] = [each for each in rests if each["status"] == "doubtful"]
    assert doubt["path"] == f"{path}.intake_pressure"
    assert doubt["low"] == doubt["high"] > 1
    change = f'{path}.intake_pressure="{doubt["low"]} bar"'
    enough = json.loads(run("torque", "six.json", "--set", change, "--json").out)
    assert enough["air_fuel_ratio"] == pytest.approx(29, rel=0.15)  # by the heat of another charge
    assert doubt["moves"]["quantity"] == "roll"
    order = doubt["moves"]["order"]
    [roll] = [each["roll"] for each in enough["orders"] if each["order"] == order]
    assert doubt["moves"]["high"] == pytest.approx(abs(complex(*roll)), rel=1e-9)


@pytest.mark.parametrize(
    ("other", "key"), [("fmep", "friction_pressure"), ("boost", "intake_pressure")]
)
def test_a_name_that_the_field_has_for_a_key_is_understood(other: str, key: str) -> None:
    with pytest.raises(EngineFileError, match=f'did you mean "{key}"'):
        crankstar.load("bmw-m52b28", changes={f"gas.{other}": "1 bar"})


def test_a_piston_faster_than_any_is_doubted() -> None:
    """84 mm of stroke: 33 m/s at 11786 rpm by 2 S n; a speed in Hz for one in rpm is far more."""
    swift = crankstar.load("bmw-m52b28", changes={"gas": {}, "speed": "12000 rpm"})
    assert [fault.code for fault in doubts(swift)].count("doubt.piston-speed") == 1
    stroke = 2 * swift.throw(swift.first).radius
    [fault] = [each for each in doubts(swift) if each.code == "doubt.piston-speed"]
    assert fault.values["value"] == pytest.approx(2 * stroke * 12000 / 60, rel=5e-3)
    slow = f"{0.99 * 32 / stroke * 30} rpm"
    same = crankstar.load("bmw-m52b28", changes={"gas": {}, "speed": slow})
    assert "doubt.piston-speed" not in [each.code for each in doubts(same)]


def test_a_mean_pressure_of_next_to_nothing_is_doubted() -> None:
    """A number of bar without its unit is a number of pascal in Python."""
    for key in ("imep", "bmep"):
        own = crankstar.load("honda-b18c", changes={"gas": {key: "5 Pa"}})
        assert [fault.code for fault in doubts(own)].count("doubt.small-load") == 1
    told = crankstar.torque("honda-b18c", imep=5).to_dict()["rests_on"]
    assert any("next to nothing" in each["reason"] for each in told)
    idle = crankstar.load("honda-b18c", changes={"gas": {"imep": "1 bar"}})
    assert "doubt.small-load" not in [fault.code for fault in doubts(idle)]


@pytest.mark.release
def test_set_names_the_csv_file_of_a_trace_as_a_file_does(run: Run, tmp_path: Path) -> None:
    """The same numbers as of the file that names it; the measurement cannot be written over."""
    place = with_csv(tmp_path, "angle,p [bar]")
    given = json.loads(run("torque", place, "--json").out)
    file = tmp_path / "p.csv"
    told = json.loads(run("torque", place, "--set", f"gas.trace={file}", "--json").out)
    assert told["mean_torque"] == given["mean_torque"]
    lost = run("torque", place, "--set", "gas.trace=no.csv")
    assert lost.code == 2
    assert "no.csv" in lost.err
    before = file.read_bytes()
    over = run("torque", place, "--set", f"gas.trace={file}", "--csv", "-o", str(file))
    assert over.code == 2
    assert file.read_bytes() == before


@pytest.mark.many(first=1)
@pytest.mark.parametrize("process", ["heat-release", "otto"])
def test_the_temperature_of_the_charge_is_that_of_the_air_fuel_ratio(process: str) -> None:
    """Mass of air is p V/(R T): at 300 K for 340 K it is 13 % more."""
    own = {"imep": "9 bar", "process": process}
    found = [
        crankstar.torque("honda-b18c", changes={"gas": {**own, "intake_temperature": f"{at} K"}})
        for at in (340, 300)
    ]
    warm, cool = (each.to_dict()["air_fuel_ratio"] for each in found)
    assert cool == pytest.approx(warm * 340 / 300, rel=1e-12)
