"""Parts of what is estimated given: rods known in part, sources, refusals, bounds of peaks."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from tests.commands import Run

from crankstar import spectra
from crankstar.files import tree_of
from crankstar.files.catalog import tree_of as tree_named
from crankstar.files.estimate import estimated
from crankstar.files.read import engine_of
from crankstar.mechanics.bounds import of_peak

TRUE = {"mass": "520 g", "centre": "44 mm", "inertia": "0.0021 kg*m^2"}
PARTIAL = [(key,) for key in TRUE] + [("mass", "centre"), ("centre", "inertia")]


@pytest.mark.parametrize("keys", PARTIAL, ids=" ".join)
def test_what_a_file_gives_of_a_rod_is_kept_and_the_rest_estimated(keys: tuple[str, ...]) -> None:
    name, tree = tree_named("toyota-2jz")
    whole = estimated(tree, name=name).tree
    given = {key: TRUE[key] for key in keys}
    partly = estimated({**tree, "cylinder": {**tree["cylinder"], "rod": given}}, name=name).tree
    rod = partly["cylinder"]["rod"]
    assert {key: rod[key] for key in keys} == given
    for key in TRUE.keys() - set(keys) - {"inertia"}:
        assert rod[key] == whole["cylinder"]["rod"][key]
    marked = {path for path in partly["provenance"] if path.startswith("cylinder.rod.")}
    assert marked == {f"cylinder.rod.{key}" for key in TRUE.keys() - set(keys)}
    engine_of(partly, name=name)


def test_the_estimated_inertia_is_that_of_the_given_mass_and_centre() -> None:
    """Two masses at the ends, m b (l - b), over the proportion of nineteen rods."""
    name, tree = tree_named("toyota-2jz")
    rod = {"mass": TRUE["mass"], "centre": TRUE["centre"]}
    made = estimated({**tree, "cylinder": {**tree["cylinder"], "rod": rod}}, name=name)
    (row,) = [each for each in made.filled if each.path == "cylinder.rod.inertia"]
    engine = engine_of(made.tree, name=name)
    length, own = engine.first.rod_length, engine.first.rod
    assert own is not None
    assert row.typical == pytest.approx(
        own.mass * own.centre * (length - own.centre) / 1.0965, rel=1e-3
    )
    assert row.low < row.typical < row.high


@pytest.mark.release
def test_set_replaces_an_estimate_by_the_true_value(run: Run) -> None:
    printed = run("analyze", "toyota-2jz", "--estimate", "--set", 'cylinder.rod.mass="520 g"')
    assert printed.code == 0
    assert "cylinder.rod.centre" in printed.out
    assert "cylinder.rod.mass" not in printed.out


FILE = """name = "four"
firing_order = [1, 3, 4, 2]
speed = "6000 rpm"
[cylinder]
bore = "80 mm"
stroke = "82 mm"
rod_length = "140 mm"
reciprocating_mass = "480 g"
[layout]
type = "inline"
throws = ["0 deg", "180 deg", "180 deg", "0 deg"]
bore_pitch = "94 mm"
[provenance]
"""


@pytest.mark.parametrize(
    ("entry", "said"),
    [
        ('"cylinder.reciprocating_mass" = { status = "estimated" }', "has no range"),
        (
            '"cylinder.reciprocating_mass" = { status = "estimated", range = [1, 1] }',
            "has no range",
        ),
        (
            '"cylinder.throw_mass" = { status = "estimated", range = [0.5, 2] }',
            "the file does not have the value",
        ),
    ],
)
def test_an_estimate_without_range_or_value_is_a_mistake(
    entry: str, said: str, tmp_path: Path, refused: Callable[..., str]
) -> None:
    place = tmp_path / "four.toml"
    place.write_text(FILE + entry, encoding="utf-8")
    assert said in " ".join(refused("analyze", str(place)).split())


@pytest.mark.release
def test_parts_that_a_file_does_not_weigh_are_named(run: Run) -> None:
    words = ("--estimate", "--set", 'cylinder.parts.piston="300 g"')
    for verb in ("analyze", "bobweight"):
        printed = " ".join(run(verb, "bmw-f800", *words).out.split())
        for name in ("pin", "rings", "small_end"):
            assert f"cylinder.parts.{name}: no " in printed


def test_an_estimated_speed_says_how_far_it_moves_a_grade(run: Run, tmp_path: Path) -> None:
    """U = G m / omega, so that its ends are those of the speed the other way round."""
    place = tmp_path / "kr250.toml"
    assert run("estimate", "kr250-production", "-o", str(place)).code == 0
    low, high = tree_of(place.read_text(encoding="utf-8"))["provenance"]["speed"]["range"]
    printed = run("grade", str(place), "--mass", "5 kg", "--grade", "6.3").out
    row = next(line for line in printed.splitlines() if line.strip().startswith("6.3"))
    value = float(row.split()[1])
    told = " ".join(printed.partition("Permissible")[0].split())
    assert "speed: estimated" in told
    least, most, now = map(
        float, re.findall(r"is ([\d.]+) to ([\d.]+) g mm, not ([\d.]+)", told)[0]
    )
    assert (least, most, now) == pytest.approx((value / high, value / low, value), rel=3e-3)
    assert "cylinder" not in told  # nothing else moves it


@pytest.mark.release
def test_refusals_over_estimates_are_marked(refused: Callable[..., str]) -> None:
    words = ("--minimise", "force", "--limit", "couple=1 N m")
    told = " ".join(refused("balance", "triumph-675", "--estimate", *words).split())
    assert re.search(r"\d N m.*\(estimated\)", told)


@pytest.mark.release
def test_drill_says_the_factor_of_its_bobweights(run: Run, tmp_path: Path) -> None:
    holes = ("--diameter", "30 mm", "--at-radius", "80 mm", "--greatest-depth", "60 mm")
    place = str(tmp_path / "v8.toml")
    run("balance", "bmw-s65", "--estimate", "--weights", "ends", "-o", place)
    printed = run("drill", place, "--factor", "48%", *holes)
    assert "48 % of the reciprocating masses" in printed.out


def test_a_file_with_weights_twice_hears_of_it(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "twin.toml"
    run("balance", "i2-360", "--factor", "0.5", "--weights", "ends", "-o", str(place))
    assert "balance_factor" not in run("check", str(place)).out
    place.write_text("balance_factor = 0.5\n" + place.read_text("utf-8"), encoding="utf-8")
    assert "leave balance_factor out" in " ".join(run("check", str(place)).out.split())


def test_a_peak_is_no_less_than_its_rows_say() -> None:
    """Every row that bounds a peak lies below the peak, found on a fine grid of crank angles."""
    random = np.random.default_rng(5)
    for count in (1, 2, 4):
        orders = np.sort(random.choice(np.arange(1, 17), count, replace=False)) / 2
        forward, backward = random.normal(size=(2, 30, count, 2)) @ np.array([1, 1j])
        spectrum = spectra.Spectrum(orders, forward, backward)
        fine = np.linspace(0, 4 * np.pi, 7201)
        peak = abs(spectra.value(spectrum, fine)).max(axis=-1)
        rows = abs(of_peak(spectrum)).sum(axis=-1).max(axis=-1)
        assert np.all(rows <= peak * (1 + 1e-5))
        assert np.all(rows >= 0.75 * peak / count)


@pytest.mark.release
def test_peaks_at_quite_other_angles_tell_none(run: Run, tmp_path: Path) -> None:
    place = str(tmp_path / "twin.toml")
    run("balance", "bmw-f800", "--estimate", "--recommended", "-o", place)
    printed = " ".join(run("analyze", place).out.split())
    peaks = printed.split("Peaks ")[-1]
    assert "its crank angle and bearing depend on what is estimated" in peaks
    assert not re.search(r"\(0 to 3\d\d, estimated\) deg", peaks)
