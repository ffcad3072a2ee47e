"""What stands beside a number: the point it is about, the part that lacks, the type it is of."""

from __future__ import annotations

import re
from math import pi
from pathlib import Path

import numpy as np
import pytest
from tests.commands import Run

import crankstar
from crankstar.files import engine_of, tree_of

quick = pytest.mark.quick
"""What a ranged torsion of six cylinders takes is for the whole gate."""

TWIN = """
name = "parallel twin"
firing_order = [1, 2]
speed = "6000 rpm"
[cylinder]
bore = "76 mm"
stroke = "80 mm"
rod_length = "160 mm"
reciprocating_mass = "500 g"
[layout]
type = "inline"
throws = ["0 deg", "0 deg"]
bore_pitch = "100 mm"
"""
VEE = """
name = "vee"
firing_order = [1, 2]
speed = "3000 rpm"
[cylinder]
bore = "80 mm"
stroke = "90 mm"
rod_length = "150 mm"
offset = "7 mm"
reciprocating_mass = "500 g"
[layout]
type = "vee"
banks = [{ bearing = "30 deg", cylinders = [1] }, { bearing = "-45 deg", cylinders = [2] }]
throws = ["0 deg"]
bank_offset = "24 mm"
"""
SIX = """
name = "six"
firing_order = [1, 5, 3, 6, 2, 4]
speed = "1500 rpm"
[cylinder]
bore = "130 mm"
stroke = "150 mm"
rod_length = "270 mm"
reciprocating_mass = "5 kg"
rotating_mass = "4 kg"
[layout]
type = "inline"
bore_pitch = "165 mm"
[gas]
bmep = "16 bar"
[torsion]
bare_inertia = "0.08 kg*m^2"
stiffness = "3 MN*m/rad"
diameter = "90 mm"
shear_limit = "{limit}"
"""


def written(place: Path, text: str) -> str:
    place.write_text(text, encoding="utf-8")
    return str(place)


@quick
def test_what_counterweights_leave_is_about_the_point_that_is_asked_for(
    run: Run, tmp_path: Path
) -> None:
    """Half of m r w^2 of two pistons turns backwards, in the middle of the cylinders."""
    place = written(tmp_path / "twin.toml", TWIN)
    force = 0.5 * 2 * 0.5 * 0.04 * (6000 * pi / 30) ** 2
    told = {
        z: " ".join(run("analyze", place, "--reference", z, "--orders", "1").out.split())
        for z in ("0 mm", "200 mm")
    }
    assert f"with 50 % balanced: a primary force of {force:.1f} N, rotating" in told["0 mm"]
    found = re.search(
        r"a primary force of ([\d.]+) N and a primary couple of ([\d.]+) N m", told["200 mm"]
    )
    assert found is not None
    assert [float(each) for each in found.groups()] == pytest.approx([force, force * 0.2], rel=1e-4)


@quick
def test_a_star_times_its_harmonic_is_the_amplitude(run: Run, tmp_path: Path) -> None:
    """Also in phase, which the harmonics of a cylinder that stands off the crankshaft have."""
    out = run("analyze", written(tmp_path / "vee.toml", VEE), "--orders", "1,2,3").out
    wave = r"(-?[\d.]+) ∠ (-?[\d.]+)°"

    def rows(title: str, waves: int) -> dict[str, list[complex]]:
        body = out[out.index(title) :].split("\n\n")[0]
        return {
            line.split()[0]: [
                float(size) * np.exp(1j * np.radians(float(angle)))
                for size, angle in re.findall(wave, line)
            ][:waves]
            for line in body.splitlines()
            if re.search(wave, line)
        }

    sizes, stars = rows("Force on the block", 1), rows("Force by the vector stars", 2)
    assert sizes.keys() == stars.keys() == {"1", "2", "3"}
    unit = 0.5 * 0.045 * (3000 * pi / 30) ** 2
    for order, (amplitude,) in sizes.items():
        harmonic, vertical = stars[order]
        assert unit * harmonic * vertical == pytest.approx(amplitude, rel=3e-3)


@pytest.mark.release
def test_a_crankshaft_without_a_flywheel_says_so_with_what_one_would_change(
    run: Run, tmp_path: Path
) -> None:
    text = SIX.format(limit="60 MPa")
    told = " ".join(run("torsion", written(tmp_path / "six.toml", text)).out.split())
    found = re.search(
        r"torsion\.disc: no flywheel and nothing driven in the file, counted as none\. With "
        r"([\d.]+) kg m² to ([\d.]+) kg m²",
        told,
    )
    assert found is not None
    low, high = map(float, found.groups())
    throws = crankstar.torsion(engine_of(tree_of(text))).value.chain.inertia.sum()
    assert (low, high) == pytest.approx((throws, 10 * throws), rel=2e-3)
    disc = '[[torsion.disc]]\nname = "flywheel"\ninertia = "4 kg*m^2"\nto = "rear"\n'
    assert "torsion.disc" not in run("torsion", written(tmp_path / "w.toml", text + disc)).out


@pytest.mark.release
@pytest.mark.parametrize(("limit", "told"), [("400 MPa", True), ("1 MPa", False)])
def test_a_limit_that_no_stress_passes_is_told(
    run: Run, tmp_path: Path, limit: str, told: bool
) -> None:
    out = run("torsion", written(tmp_path / "six.toml", SIX.format(limit=limit))).out
    assert (f"the limit of {limit}" in " ".join(out.split())) is told
    assert ("Barred speeds" in out) is not told


@quick
def test_a_bore_that_is_supposed_says_of_what_type(run: Run, tmp_path: Path) -> None:
    text = TWIN.replace('bore = "76 mm"\n', "") + '[gas]\nimep = "9 bar"\n'
    for ignition, kind in (("spark", "petrol|motorcycle"), ("compression", "diesel")):
        place = written(tmp_path / "twin.toml", f'{text}ignition = "{ignition}"\n')
        told = " ".join(run("analyze", place).out.split())
        assert re.search(rf"With a bore of [\d.]+ mm to [\d.]+ mm \(type ({kind})", told)


@quick
def test_a_missing_firing_order_is_named_where_gas_is_left_out(run: Run, tmp_path: Path) -> None:
    place = written(tmp_path / "twin.toml", TWIN.replace("firing_order = [1, 2]\n", ""))
    assert "its torque needs firing_order" in " ".join(run("analyze", place).out.split())


@quick
def test_a_mass_without_a_unit_is_no_length(run: Run) -> None:
    told = " ".join(run("analyze", "v2-90").out.split())
    assert re.search(r"With [\d.]+ times m to [\d.]+ times m", told)


@quick
@pytest.mark.parametrize("verb", ["torque", "genset"])
def test_a_flywheel_asked_for_is_doubted_as_one_of_the_file(
    run: Run, tmp_path: Path, verb: str
) -> None:
    text = f'{TWIN}\n[gas]\nimep = "9 bar"\nignition = "spark"\n'
    light = "0.0001 kg*m^2"
    asked = run(verb, written(tmp_path / "twin.toml", text), "--flywheel", light).out
    filed = written(tmp_path / "filed.toml", f'{text}[drive]\ninertia = "{light}"\n')
    assert "drive.inertia is 0.0001 kg m²" in asked
    assert asked == run(verb, filed).out
