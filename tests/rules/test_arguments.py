"""Every public function reads engines, speeds and points as people give them."""

from __future__ import annotations

import inspect
import math
import re
import tomllib
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.texts import SHORT

import crankstar
import crankstar.charts
import crankstar.mechanics.balance
import crankstar.remedy
from crankstar.engine.copies import with_values
from crankstar.mechanics.excitation import Reference
from crankstar.python import public
from crankstar.tables.comparison import told_apart

pytestmark = pytest.mark.quick

BURNING: Any = "audi-25-tfsi"
"""An engine with bore and firing order, whose gas can be computed."""
CYCLE = crankstar.cycle(BURNING, speed=300.0, imep=9e5)
PLACES = (("left", "-0.4 m", "0 m"), ("right", "0.4 m", "0 m"), ("rear", "0 m", "-0.3 m"))
RUBBER = [{"name": n, "right": r, "z": z, "stiffness": "90 N/mm"} for n, r, z in PLACES]
MORE: dict[str, dict[str, Any]] = {
    "driven": {"cycle": CYCLE, "flywheel": 0.5},
    "flywheel_for": {"cycle": CYCLE, "irregularity": 0.05},
    "side_thrust": {"cycle": CYCLE},
    "derivation": {"order": 2},
    "family": {"order": 1, "quantity": "force", "symbol": "alpha"},
    "sweep": {"over": "balance_factor=0..1/3"},
    "with_balance_shaft": {"ratio": -1, "planes": [0.5, -0.5]},
    "with_counterweights": {"factor": 0.5},
}
"""What the functions need besides an engine."""
GAS = ("cycle", "driven", "flywheel_for", "side_thrust")
ANALYSES = (*("bearings", "genset", "marine", "mounts", "orders", "torque", "torsion", "verdict"),)
ASKING = ("diagnose", "drill", "fault", "grade", "guide", "isolate", "match")
"""Analyses that are asked for more than an engine, or search long."""
OWN = {"load", "names", "tolerance", "widget", *ANALYSES, *ASKING}
"""They load engines themselves, or ask for more of one than others have."""


BANKS: Any = "banks"
"""No label of a part, though it looks like one."""


NOWHERE: Any = math.nan
NOTHING: Any = None
FAR: Any = 1e300
UNHASHABLE: Any = []
ODD_OVER: Any = ["balance_factor=0..1", 1]
CONTNUOUS: Any = "contnuous"
SOME: Any = np.array([1.0, 2.0])


def functions() -> list[str]:
    return [name for name in crankstar.__all__ if inspect.isfunction(getattr(crankstar, name))]


def of_engines() -> list[str]:
    """The public functions with an argument for an engine."""
    asked = {name: inspect.signature(getattr(crankstar, name)).parameters for name in functions()}
    return [name for name in functions() if {"engine", "engines"} & {*asked[name]}]


def of(argument: str) -> list[str]:
    return [
        name
        for name in of_engines()
        if name not in OWN and argument in inspect.signature(getattr(crankstar, name)).parameters
    ]


@pytest.mark.parametrize("name", of_engines())
def test_a_name_a_path_and_an_engine_give_the_same(name: str, tmp_path: Path) -> None:
    function, more = getattr(crankstar, name), MORE.get(name, {})
    if name in OWN:
        return
    own = {"with_balance_shaft": "single", **dict.fromkeys(GAS, BURNING)}.get(name, "v2-90")
    place = tmp_path / f"{own}.toml"
    engine = crankstar.load(own)
    place.write_text(crankstar.files.toml(engine), encoding="utf-8")
    results = [repr(function(given, **more)) for given in (own, engine, place, str(place))]
    assert results[0] == results[1]
    assert len(results[2]) > 0
    assert results[2] == results[3]


@pytest.mark.parametrize("name", [name for name in of_engines() if name not in OWN])
@pytest.mark.parametrize("given", [None, 5, {3: "i4"}, b"i4"])
def test_what_is_no_engine_is_refused_with_what_to_give(name: str, given: Any) -> None:
    with pytest.raises(TypeError, match=f"^{name} takes an Engine, a name of the catalog, a path "):
        getattr(crankstar, name)(given, **MORE.get(name, {}))


def test_without_a_speed_that_of_the_file_counts_in_every_function() -> None:
    """6500 rpm of the file: the second couple of a five is about 1534 N m, as its verdict says."""
    own = crankstar.balance(BURNING)
    assert own.units == ("N", "N*m", "N*m")
    assert own.speed == crankstar.load(BURNING).speed
    assert own.speed == crankstar.sweep(BURNING, "balance_factor=0..1/2").speed
    assert crankstar.cycle(BURNING).speed == own.speed
    assert (crankstar.bearing_loads(BURNING).speed, crankstar.bending_moment(BURNING).speed) == (
        own.speed,
        own.speed,
    )
    assert own.speed is not None
    half = crankstar.balance(BURNING, speed=own.speed / 2)
    assert np.allclose(half.couple.forward * 4, own.couple.forward)
    relative = crankstar.balance(BURNING, units="relative")
    assert relative.units.force == crankstar.balance("i4").units.force == "m*r*w^2"
    assert crankstar.bearing_loads(BURNING, units="relative").unit == "m*r*w^2"
    wrong: Any = "newtons"
    with pytest.raises(ValueError, match=r'^units is "SI" or "relative", not "newtons"'):
        crankstar.balance(BURNING, units=wrong)
    with pytest.raises(ValueError, match="leave speed out"):
        crankstar.balance(BURNING, units="relative", speed=100)


def test_values_of_a_sweep_are_a_dict_and_what_is_watched_are_columns() -> None:
    factors = np.linspace(0, 1, 5)
    swept = crankstar.sweep("v2-90", {"balance_factor": factors}, watch=["force", ("force", 1)])
    table = swept.to_frame()
    assert [*table.columns] == ["balance_factor", "force_m_r_w2", "force_order_1_m_r_w2"]
    assert table["balance_factor"].tolist() == factors.tolist()
    # a V-twin at 90 degrees: |1 - 2 f| of order 1, half of it in each direction twice over
    assert table["force_order_1_m_r_w2"].tolist() == pytest.approx(abs(1 - 2 * factors))
    data = swept.to_xarray()
    assert data["force_order_1"].attrs == {"units": "m*r*w^2"}
    assert data["force"].dims == ("balance_factor",)
    text = crankstar.sweep("v2-90", "balance_factor=0..1/5", watch="force")
    assert text.curves[0].values.tolist() == swept.curves[0].values.tolist()
    for wrong, kind, words in (
        ({"over": {}}, ValueError, "0 values are to be varied"),
        ({"over": {"balance_factor": 3}}, TypeError, "over takes a list of numbers or text"),
        ({"over": {"balance_factor": [NOTHING]}}, TypeError, "over takes a list of numbers"),
        ({"over": {"balance_factor": [0, 1]}, "watch": [3]}, TypeError, "watch takes names"),
        ({"over": {"balance_factor": [0, 1]}, "watch": "forces"}, ValueError, "choose from force"),
    ):
        arguments: Any = wrong
        with pytest.raises(kind, match=words):
            crankstar.sweep("v2-90", **arguments)


@pytest.mark.parametrize("name", ANALYSES)
def test_an_analysis_takes_an_engine_its_name_its_path_and_its_keys(
    name: str, tmp_path: Path
) -> None:
    function, path = getattr(crankstar, name), tmp_path / "mine.toml"
    changes: Any = {"torsion": TWISTING, "mounts": RUBBER}
    engine = crankstar.load(BURNING, changes=changes)
    path.write_text(crankstar.files.toml(engine), encoding="utf-8")
    tree = tomllib.loads(path.read_text(encoding="utf-8"))
    own, read, *others = (function(given).tables for given in (engine, path, str(path), tree))
    assert all(read == other for other in others)
    assert read.keys() == own.keys()
    named = function(BURNING, changes=changes).tables
    assert named.keys() == own.keys()
    for given in (None, 5, {3: "i4"}, b"i4"):
        with pytest.raises(
            TypeError, match=f"^{name} takes an Engine, a name of the catalog, a path"
        ):
            function(given)
    with pytest.raises(ValueError, match="no_such"):
        function({"no_such": 1})
    with pytest.raises(TypeError, match="takes no argument spead; it takes engine, "):
        function(engine, spead=3)


@pytest.mark.parametrize("name", ["total", "grouped", "of_parts"])
@pytest.mark.parametrize("given", [crankstar.load("i4"), "i4", None])
def test_what_is_no_balance_is_refused_with_what_to_write(name: str, given: Any) -> None:
    more = ("bank",) if name == "grouped" else ()
    with pytest.raises(TypeError, match=rf"write {name}\(crankstar.balance\(engine\)\)$"):
        getattr(crankstar, name)(given, *more)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda b: crankstar.grouped(b, BANKS), '"banks" is no label of a part; give one of kind'),
        (lambda b: b.to_frame(by=BANKS), '"banks" is no label of a part; give one of kind'),
        (lambda b: crankstar.of_parts(b, row=1), '"row" is no label of a part; give one of kind'),
        (
            lambda b: crankstar.of_parts(b, cylinder=5),
            "no part has the cylinder 5; give one of 1, 2",
        ),
        (
            lambda b: crankstar.of_parts(b, bank="lft"),
            'no part has the bank "lft"; give one of left',
        ),
        (
            lambda b: crankstar.of_parts(b, kind="rods"),
            'no part has the kind "rods"; give one of pi',
        ),
    ],
)
def test_a_label_that_no_part_has_is_refused_with_those_there_are(call: Any, words: str) -> None:
    with pytest.raises(ValueError, match=f"^{words}"):
        call(crankstar.balance(crankstar.load("v4-90")))


WRONG: Any = 5
HALF: Any = "50%"
PINS: Any = "pins"
BALANCE: Any = crankstar.balance
TWIN: Any = crankstar.load("v2-90")


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: crankstar.load(WRONG), "load takes a name of the catalog or the path of an en"),
        (lambda: crankstar.load(TWIN), 'of an engine file, not Engine "V-twin, 90 deg'),
        (lambda: crankstar.load("i4", changes=WRONG), "changes takes a dict of values by key"),
        (lambda: crankstar.load("i4", changes={WRONG: 1}), "not one with the key 5"),
        (lambda: crankstar.widget(NOTHING), "widget takes an Engine, a name of the catalog"),
        (lambda: crankstar.widget("i4", WRONG), "widget takes an Engine, a name of the cat"),
        (lambda: crankstar.widget("i4", units=WRONG), "units takes text such as"),
        (crankstar.compare, "compare takes one engine or more, as in compare"),
        (lambda: crankstar.balance(NOTHING), "or a dict of keys, not None$"),
        (lambda: BALANCE(TWIN, WRONG), r"it is called balance\(engine, \*, speed=None"),
        (lambda: crankstar.sweep(TWIN, "balance_factor=0..1", tell=WRONG), "tell takes a func"),
        (lambda: crankstar.with_counterweights(TWIN, factor=1, planes=WRONG), "planes takes pl"),
        (lambda: crankstar.with_counterweights(TWIN, factor=1, planes=[NOTHING]), "planes takes"),
        (lambda: crankstar.with_counterweights(TWIN, factor=1, bare=WRONG), "bare takes True or"),
        (lambda: crankstar.with_balance_shaft(TWIN, ratio=-1, planes=WRONG), "planes takes pl"),
    ],
)
def test_an_argument_of_the_wrong_kind_is_refused_with_what_is_wanted(
    call: Any, words: str
) -> None:
    with pytest.raises(TypeError, match=words) as refused:
        call()
    assert "\n" not in str(refused.value)


def test_planes_may_be_text_with_a_unit() -> None:
    engine = crankstar.load("audi-25-tfsi")
    metres = crankstar.with_counterweights(engine, factor=0.5, planes=[0.2, -0.2])
    places: Any = ["200 mm", "-20 cm"]
    heavy: Any = ["200 mm", "3 kg"]
    assert crankstar.with_counterweights(engine, factor=0.5, planes=places) == metres
    with pytest.raises(ValueError, match=r"^planes is .*a mass; a length is needed"):
        crankstar.with_counterweights(engine, factor=0.5, planes=heavy)


@pytest.mark.parametrize(
    "names", [["V8"] * 3, ["V8", "V8", "V8 (1)"], ["V8 (2)", "V8", "V8", "V8 (3)"]]
)
def test_engines_of_one_name_are_told_apart_in_a_comparison(names: list[str]) -> None:
    own = told_apart(names)
    assert len({*own}) == len(names)
    twice = crankstar.compare(*[with_values(TWIN, name=name) for name in names], orders=[1])
    heads = [column.heading for column in next(twice.tables).columns]
    assert heads[1 : len(names) + 1] == own


@pytest.mark.parametrize("name", of("orders"))
@pytest.mark.parametrize(
    ("orders", "words"),
    [
        (5, "orders takes numbers such as"),
        ("1,2", "orders takes numbers such as"),
        (["1"], "orders takes numbers such as"),
        ([1, math.nan], "each must be greater than 0"),
        ([0], "each must be greater than 0"),
        ([-1], "each must be greater than 0"),
    ],
)
def test_what_are_no_orders_is_refused(name: str, orders: Any, words: str) -> None:
    with pytest.raises((TypeError, ValueError), match=words):
        getattr(crankstar, name)("i4", **{**MORE.get(name, {}), "orders": orders})


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda i4: crankstar.balance(i4, reference=NOWHERE), "reference is nan; it must be fin"),
        (lambda i4: crankstar.balance(i4, reference=FAR), r"reference is 1e\+300; it must be wi"),
        (lambda i4: crankstar.balance(i4, reference=-FAR), r"reference is -1e\+300; it must be w"),
        (lambda i4: crankstar.balance(i4, reference=UNHASHABLE), "reference takes a crankstar"),
        (lambda i4: crankstar.sweep(i4, ODD_OVER), "or a dict of values by key path, not 1"),
        (lambda i4: crankstar.derivation(i4, NOWHERE), "The order is nan; give a crank order"),
        (lambda i4: crankstar.family(i4, 2, "force", symbol=UNHASHABLE), "a list cannot be kept"),
        (lambda i4: crankstar.with_counterweights(i4, factor=NOWHERE), "factor is nan; it must"),
        (lambda i4: crankstar.with_counterweights(i4, factor=NOTHING), "factor takes a number"),
        (
            lambda i4: crankstar.with_balance_shaft(i4, ratio=2, planes=[0], share=math.inf),
            "share is inf; it must be finite",
        ),
        (
            lambda i4: crankstar.bearing_loads(i4, model=CONTNUOUS),
            "no model of a crankshaft; give one of determinate, continuous",
        ),
        (
            lambda i4: crankstar.bending_moment(i4, model=CONTNUOUS),
            "no model of a crankshaft; give one of determinate, continuous",
        ),
        *(
            (partial(call, **{name: SOME}), f"{name} takes a name, not a ndarray")
            for call, name in (
                (crankstar.bearing_loads, "model"),
                (crankstar.bending_moment, "shaft"),
                (crankstar.cycle, "point"),
            )
        ),
        (lambda _i4: crankstar.search(5, workers=SOME), "workers is from 1 to 1024, not a ndarray"),
        (lambda _i4: crankstar.search(5, tell=SOME), "tell takes a function that is called"),
        (
            lambda i4: crankstar.bending_moment(i4, shaft="rear"),
            'there is no shaft "rear"; the shafts are "crank"',
        ),
    ],
)
def test_a_number_or_a_name_that_means_nothing_is_refused(call: Any, words: str) -> None:
    with pytest.raises((TypeError, ValueError), match=words):
        call(crankstar.load("i4"))


@pytest.mark.parametrize("name", of("speed"))
def test_a_speed_as_text_is_the_number_in_rad_per_second(name: str, tmp_path: Path) -> None:
    function, more = getattr(crankstar, name), MORE.get(name, {})
    place = tmp_path / "mine.toml"
    place.write_text(SHORT, encoding="utf-8")
    given = (200 * math.pi, "100 Hz")
    number, text = (repr(function(place, speed=speed, **more)) for speed in given)
    assert number == text
    if name != "derivation":  # whose forms are the same at every speed
        assert number != repr(function(place, speed="50 Hz", **more))


@pytest.mark.parametrize("name", of("speed"))
@pytest.mark.parametrize(
    ("speed", "kind", "why"),
    [
        (6000, ValueError, 'write speed="6000 rpm"'),
        ("6000", ValueError, "a number without a unit"),
        ("6000 kg", ValueError, "a rotational speed is needed"),
        (0, ValueError, "greater than 0"),
        (math.nan, ValueError, "greater than 0"),
        ([6000], TypeError, "a number in rad/s or text"),
        (True, TypeError, "a number in rad/s or text"),
    ],
)
def test_a_speed_in_rpm_or_without_unit_is_refused(
    name: str, speed: Any, kind: type[Exception], why: str
) -> None:
    with pytest.raises(kind) as refused:
        getattr(crankstar, name)("i4", speed=speed, **MORE.get(name, {}))
    assert why in str(refused.value)


@pytest.mark.parametrize("name", of("reference"))
def test_a_point_as_text_is_the_point(name: str, tmp_path: Path) -> None:
    function, more = getattr(crankstar, name), MORE.get(name, {})
    place = tmp_path / "mine.toml"
    place.write_text(SHORT, encoding="utf-8")
    point = Reference(-0.12, 0.0, 0.0)
    given = (point, "-120 mm", "-120 mm, 0 mm, 0 mm", -0.12)
    results = {repr(function(place, reference=reference, **more)) for reference in given}
    assert len(results) == 1
    with pytest.raises(ValueError, match=r"^reference"):
        function(place, reference="here", **more)
    with pytest.raises(TypeError, match=r"^reference takes a crankstar\.Reference"):
        function(place, reference=[1, 2], **more)


def test_equal_engines_have_equal_hashes() -> None:
    first, again = crankstar.load("i4"), crankstar.load("i4")
    assert hash(first) == hash(again)
    assert len({first, again, crankstar.load("i6")}) == 2


@pytest.mark.parametrize("name", of("speed"))
@pytest.mark.parametrize("given", [10**400, 1e300, math.inf, math.nan, -1, 0])
def test_no_engine_turns_at_such_a_speed(name: str, given: Any) -> None:
    with pytest.raises(ValueError, match=r"^speed is .*; it must be greater than 0 and that of an"):
        getattr(crankstar, name)("i4", **MORE.get(name, {}) | {"speed": given})


@pytest.mark.parametrize("name", of("speed"))
@pytest.mark.parametrize("given", [np.array([600.0, 700.0]), True, [600.0]])
def test_a_speed_is_one_number(name: str, given: Any) -> None:
    with pytest.raises(TypeError, match=r"^speed takes a number in rad/s or text such as"):
        getattr(crankstar, name)("i4", **MORE.get(name, {}) | {"speed": given})


@pytest.mark.parametrize("name", of("orders"))
@pytest.mark.parametrize("given", [1e300, 10**400, 1001, math.inf, math.nan, 0, -1])
def test_an_order_is_one_that_an_engine_may_have(name: str, given: Any) -> None:
    with pytest.raises(ValueError, match=r"^orders has .*; each must be greater than 0 and at"):
        getattr(crankstar, name)("i4", **MORE.get(name, {}) | {"orders": [1, given]})


@pytest.mark.parametrize(
    "place", [{"planes": [1e9, -1]}, {"up": 10**400}, {"right": math.inf}, {"up": math.nan}]
)
def test_a_balance_shaft_is_near_its_engine(place: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=r"must be (within 1000 m of the engine|finite)$"):
        crankstar.with_balance_shaft(
            crankstar.load("i4"), **{"ratio": 2, "planes": [1, -1]} | place
        )


def of_rooms() -> list[Any]:
    """The functions of the rooms for people that take an Engine first."""
    rooms = (crankstar.remedy, crankstar.charts, crankstar.files)
    every = [getattr(room, name) for room in rooms for name in room.__all__]
    return [
        each
        for each in every
        if callable(each)
        and not inspect.isclass(each)
        and next(iter(inspect.signature(each).parameters), "") == "engine"
    ]


def test_functions_of_rooms_that_take_an_engine_are_found() -> None:
    names = {each.__name__ for each in of_rooms()}
    assert {
        "with_counterweights",
        "best_weights",
        "needs",
        "spectrum",
        "hodograph",
        "toml",
    } <= names


@pytest.mark.parametrize("function", of_rooms(), ids=lambda each: each.__name__)
def test_a_function_of_a_room_says_what_to_write_for_a_name(function: Any) -> None:
    name = function.__name__
    words = f'{name} takes an Engine, not "i4.toml"; write {name}(crankstar.load("i4.toml"))'
    for given in ("i4.toml", Path("i4.toml")):
        with pytest.raises(TypeError, match=f"^{re.escape(words)}$"):
            function(given)
    with pytest.raises(TypeError, match=r"as crankstar.load.* gives it, not 3$"):
        function(engine=3)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: crankstar.remedy.with_counterweights(TWIN, factor=HALF), "factor takes a numb"),
        (
            lambda: crankstar.remedy.with_counterweights(TWIN, factor=0.5, planes=PINS),
            r'planes takes places along the shaft in metres, such as \[-0.2, 0.2\], not "pins"',
        ),
        (
            lambda: crankstar.remedy.with_balance_shaft(TWIN, ratio=-1, planes=PINS),
            "planes takes places",
        ),
    ],
)
def test_numbers_of_rooms_are_refused_as_those_of_the_top(call: Any, words: str) -> None:
    with pytest.raises(TypeError, match=words):
        call()


def test_a_reference_that_is_nowhere_is_refused() -> None:
    with pytest.raises(ValueError, match="reference is inf, 0, 0; give z, up and right"):
        crankstar.mechanics.balance.balance(TWIN, reference=Reference(math.inf))


STIFF: Any = "i4"
TWISTING: dict[str, Any] = {
    "inertia": "0.01 kg*m^2",
    "stiffness": "0.6 MN*m/rad",
    "disc": [{"name": "wheel", "inertia": "0.2 kg*m^2", "to": "rear", "stiffness": "1 MN*m/rad"}],
}
FAN = """
name = "fan drive"
[[disc]]
name = "motor"
inertia = "2 kg*m^2"
[[disc]]
name = "fan"
inertia = "3 kg*m^2"
to = "motor"
stiffness = "6 kN*m/rad"
"""


def test_torsion_reads_engines_drive_lines_and_their_files(tmp_path: Path) -> None:
    five = crankstar.load(BURNING, changes={"torsion": TWISTING})
    place = tmp_path / "five.toml"
    place.write_text(crankstar.files.toml(five), encoding="utf-8")
    sources: Any = (five, place, str(place))
    found = [crankstar.torsion(given).modes[0].speed for given in sources]
    assert len({round(each, 6) for each in found}) == 1
    fan: Any = tmp_path / "fan.toml"
    fan.write_text(FAN, encoding="utf-8")
    [mode] = crankstar.torsion(fan).modes
    assert mode.speed == pytest.approx(math.sqrt(6e3 * (1 / 2 + 1 / 3)))
    with pytest.raises(ValueError, match=r"give the table \[torsion\]"):
        crankstar.torsion(STIFF)
    for given in (NOTHING, WRONG, UNHASHABLE):
        with pytest.raises(TypeError, match=r"^torsion takes an Engine, a name of the catalog,"):
            crankstar.torsion(given)


def test_mounts_reads_engines_their_files_and_speeds(tmp_path: Path) -> None:
    asked: Any = crankstar.mounts
    five = crankstar.load(BURNING, changes={"mounts": RUBBER})
    path = tmp_path / "five.toml"
    path.write_text(crankstar.files.toml(five), encoding="utf-8")
    sources: list[Any] = [five, path, str(path)]
    found = [asked(given, speeds="1000..6000 rpm/3") for given in sources]
    assert all(each.over is not None and each.asked.size == 3 for each in found)
    with pytest.raises(ValueError, match=r"give \[\[mounts\]\]"):
        asked(BURNING)
    for given in (None, 5, {3: "i4"}, b"i4"):
        with pytest.raises(TypeError, match=r"^mounts takes an Engine, a name of the catalog,"):
            asked(given)


def test_marine_reads_its_arguments_as_people_give_them() -> None:
    asked: Any = crankstar.marine
    found = asked(BURNING, rated_power="250 kW", compensate={2: (0.4, -0.4)}, node=None)
    assert found.power == 250e3
    assert len(found.compensators) == 2
    texts = asked(BURNING, rated_power=250e3, compensate={2: ["0.4 m", "-0.4 m"]})
    assert texts.to_dict() == found.to_dict()
    for wrong, words in (
        ({"compensate": [2, 0.4]}, "compensate takes orders with places along the shaft"),
        ({"compensate": {2: 0.4}}, "compensate takes orders with places along the shaft"),
        ({"compensate": {2: ["x"]}}, "compensate"),
        ({"node": "far"}, "node"),
        ({"rated_power": PINS}, "rated_power"),
        ({"first_order": "much"}, "first_order"),
        ({"phase_error": []}, "phase_error"),
    ):
        with pytest.raises((TypeError, ValueError), match=words):
            asked(BURNING, **wrong)


def test_torsion_reads_speeds_as_people_give_them() -> None:
    five = crankstar.load(BURNING, changes={"torsion": TWISTING})
    texts: Any = "1000..3000 rpm/3"
    listed: Any = ["1000 rpm", "2000 rpm", 100 * math.pi]
    wanted = [1000 * math.pi / 30, 2000 * math.pi / 30, 3000 * math.pi / 30]
    for given in (texts, listed, wanted, np.array(wanted)):
        found = crankstar.torsion(five, speeds=given).speeds
        assert np.abs(np.subtract.outer(wanted, found)).min(axis=1).max() < 1e-9
        assert (found.min(), found.max()) == pytest.approx((wanted[0], wanted[-1]))
    for wrong, kind in ((5, TypeError), ("x", ValueError), ([6000], ValueError), ([0], ValueError)):
        given_speeds: Any = wrong
        with pytest.raises(kind, match="speed"):
            crankstar.torsion(five, speeds=given_speeds)
    with pytest.raises(ValueError, match=r'write speed="6000 rpm"'):
        crankstar.torsion(five, speed=6000)
    with pytest.raises(ValueError, match="each must be greater than 0"):
        crankstar.torsion(five, orders=[-1])


def test_signatures_have_the_types_that_are_read() -> None:
    """An engine by its name, a speed with its unit: what is documented is no error of types."""
    asked = inspect.signature(crankstar.cycle).parameters
    types = {name: asked[name].annotation for name in ("engine", "speed", "off", "point")}
    wanted = ("EngineLike", "float | str | None", "Iterable[int] | int | str", "str")
    assert tuple(types.values()) == wanted
    for name in public.NAMES:
        function = getattr(crankstar, name)
        for each in inspect.signature(function).parameters.values():
            assert not {"Engine", "Reference"} & {each.annotation}, (name, each)


NONE: Any = None


def test_none_leaves_an_argument_out_that_is_never_none() -> None:
    assert crankstar.cycle("audi-25-tfsi", off=NONE).imep == crankstar.cycle("audi-25-tfsi").imep
    assert crankstar.compare("i4", "i6", orders=NONE) == crankstar.compare("i4", "i6")
    with pytest.raises(TypeError, match="planes takes places along the shaft"):
        crankstar.with_balance_shaft("i4", ratio=2, planes=NONE)
