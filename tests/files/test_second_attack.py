"""What a second attack and a second examiner found: one mistake is told once, and where it is."""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run
from tests.texts import problems

import crankstar
from crankstar.files import engine_of, tree_of

pytestmark = pytest.mark.quick

WRONG: Any = {}
HUGE: Any = 10**400
KEYS: Any = {"name": "x", 1: 2}

FIVE = """
name = "five"
cycle = "two-stroke"
speed = "900 rpm"
firing_order = [1, 4, 3, 2, 5]
[cylinder]
bore = "171 mm"
stroke = "223 mm"
rod_length = "411 mm"
reciprocating_mass = "7.3 kg"
rotating_mass = "4.1 kg"
[layout]
type = "inline"
bore_pitch = "197 mm"
positions = ["0 mm", "200 mm", "390 mm", "620 mm", "810 mm"]
"""


def five(*changes: tuple[str, str]) -> str:
    text = FIVE
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return text


def test_a_bore_pitch_beside_positions_is_the_unit_of_couples() -> None:
    given = engine_of(tree_of(FIVE))
    without = engine_of(tree_of(five(('bore_pitch = "197 mm"\n', ""))))
    assert (given.bore_pitch, without.bore_pitch) == (0.197, pytest.approx(0.190))
    one, other = (
        crankstar.balance(each, units="relative").couple.forward for each in (given, without)
    )
    assert one * 0.197 == pytest.approx(other * 0.190)


def test_an_order_that_is_wrong_hides_no_other_mistake() -> None:
    text = five(
        ("[1, 4, 3, 2, 5]", "[1, 4, 3, 2, 2]"), ('rod_length = "411 mm"', 'rod_length = "30 mm"')
    )
    paths = [problem.path for problem in problems(tree_of(text))]
    assert "cylinder.rod_length" in paths
    assert paths.count("firing_order") == 1


def test_a_mount_that_is_wrong_does_not_make_its_foundation_stand_alone() -> None:
    mount = {"up": "-0.2 m", "right": "0.3 m", "z": "0.2 m", "stiffness": "500 N/mm"}
    mounts = [
        {"name": name, **mount, "right": f"{right} m", "z": f"{z} m"}
        for name, right, z in (("a", -0.3, 0.2), ("b", 0.3, 0.2), ("c", 0.0, -0.9))
    ]
    below: dict[str, Any] = {"up": "-1 m", "mass": "2000 kg"}
    below |= {f"inertia_{way}": "400 kg*m^2" for way in ("up", "right", "z")}
    below |= {"mounts": [{"name": "soil", "stiffness": "9 kN/mm"}]}
    tree: dict[str, Any] = {**tree_of(FIVE), "foundation": below, "mounts": mounts}
    tree["block"] = {"mass": "900 kg", "inertia_up": "80 kg*m^2"}
    tree["block"] |= {"inertia_right": "90 kg*m^2", "inertia_z": "40 kg*m^2"}
    mounts[0]["stiffness"] = "-5 N/mm"
    assert not [each for each in problems(tree) if "without mounts" in each.message]
    del tree["mounts"]
    assert [each for each in problems(tree) if "without mounts" in each.message]


def test_an_empty_list_of_throws_is_told_as_throws() -> None:
    tree = tree_of(FIVE)
    tree["layout"] = {"type": "inline", "throws": [], "bore_pitch": "197 mm"}
    assert [problem.path for problem in problems(tree)] == ["layout.throws"]


def test_the_mass_of_a_block_may_be_estimated(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "block.toml"
    more = '[block]\nmass = "900 kg"\n[provenance]\n"block.mass" = '
    place.write_text(f'{FIVE}{more}{{ status = "estimated", source = "x", range = [0.7, 1.6] }}\n')
    assert "Estimated values" in run("estimate", str(place)).out


def test_a_name_as_long_as_names_may_be_gets_no_longer(run: Run, tmp_path: Path) -> None:
    place, balanced = tmp_path / "long.toml", tmp_path / "balanced.toml"
    place.write_text(five(('"five"', f'"{"L" * 200}"')))
    run("balance", str(place), "--weights", "pins", "-o", str(balanced))
    assert len(crankstar.load(str(balanced)).name) == 200


def test_a_check_lists_every_mistake(run: Run, refused: Callable[..., str], tmp_path: Path) -> None:
    place = tmp_path / "many.toml"
    keys = "".join(f"a{number} = 1\n" for number in range(24))
    place.write_text(five(("[cylinder]\n", f"[cylinder]\n{keys}")))
    assert sum("cylinder.a" in line for line in run("check", str(place)).err.splitlines()) == 24
    assert (
        refused("analyze", str(place)).splitlines()[-1].endswith("more (crankstar check lists all)")
    )


@pytest.mark.parametrize(
    "line",
    [
        "analyze i4 -o /nowhere/x.csv",
        "balance i4 --weights pins -o /nowhere/x.toml",
        "compare i4 i6 -o /nowhere/x.txt",
        "derive i4 -o /nowhere/x.md",
        "estimate i4 -o /nowhere/x.toml",
        "export i4 -o /nowhere/x.glb",
        "new inline -o /nowhere/x.toml",
        "plot i4 forces -o /nowhere/x.svg",
        "schema -o /nowhere/x.json",
        "show i4 -o /nowhere/x.csv",
        "verdict i4 -o /nowhere/x.txt",
    ],
)
def test_a_place_that_cannot_be_written_is_told_before_anything_is_computed(
    refused: Callable[..., str], line: str
) -> None:
    """Where it is told when the file is written, the system's own words are printed."""
    assert "there is no such directory" in refused(*shlex.split(line))


def test_a_frame_is_told_its_moments_up_and_across(run: Run, tmp_path: Path) -> None:
    """What a sentence says that M_V is, stands in the table below it."""
    place = tmp_path / "five.toml"
    place.write_text(f'{FIVE}[gas]\nimep = "8 bar"\nignition = "compression"\n')
    for verb in ("marine", "genset"):
        tree = json.loads(run(verb, str(place), "--json").out)
        named = {each["moves"]["quantity"] for each in tree["rests_on"] if each["moves"]}
        assert "couple" not in named
        told = " ".join(run(verb, str(place)).out.split())
        said = re.search(r"moment M_V of order 1 is [\d.]+ N m, not (\d+) N m", told)
        assert said is not None
        table = tree["moments"] if verb == "marine" else tree["sums"]
        sizes = _vertical(verb, table)
        assert float(said[1]) == pytest.approx(sizes, rel=5e-3)


def _vertical(verb: str, table: list[dict[str, Any]]) -> float:
    if verb == "genset":
        return next(row["one"] for row in table if (row["quantity"], row["order"]) == ("pitch", 1))
    return next(row["vertical"]["amplitude"] for row in table if row["order"] == 1)


def test_of_less_effect_is_what_moves_less_than_what_stands_above(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "five.toml"
    gas = '[gas]\nimep = "8.1 bar"\ncompression_ratio = 13\nignition = "compression"\n'
    place.write_text(FIVE + gas)
    effects = {
        each["path"]: each["moves"]["effect"]
        for each in json.loads(run("marine", str(place), "--json").out)["rests_on"]
        if each["moves"] is not None
    }
    out = run("marine", str(place)).out.partition("External")[0]
    above, _less, below = " ".join(out.split()).partition("Of less effect: ")
    less = re.findall(r"[a-z_]+\.[a-z_]+", below.partition(". ")[0])
    sized = [path for path in effects if f"{path}: " in above]
    assert less
    assert sized
    assert max(effects[path] for path in less) <= min(effects[path] for path in sized) + 1e-9


def test_an_array_without_dimensions_is_its_number() -> None:
    name = "audi-25-tfsi"
    box: Any = np.array
    assert crankstar.vees(box(6)).document == crankstar.vees(6).document
    one, other = (crankstar.grade(mass=5.0, speed=300.0, grade=each) for each in (box(6.3), 6.3))
    assert one.document == other.document
    with pytest.raises(TypeError, match="orders takes numbers such as"):
        crankstar.balance(name, orders=box(5.0))


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: crankstar.vees(WRONG), "cylinders takes no dict"),
        (lambda: crankstar.grade(mass=HUGE, speed=300.0), "mass is inf; it must be finite"),
        (lambda: crankstar.balance(KEYS), "one with the key 1"),
        (lambda: crankstar.correct(runs=np.array(5.0)), "runs takes the name of a CSV file"),
    ],
)
def test_what_python_is_given_wrong_is_told(call: Callable[[], object], told: str) -> None:
    with pytest.raises((TypeError, ValueError), match=told):
        call()
