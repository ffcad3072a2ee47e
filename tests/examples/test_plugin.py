"""The package in examples/plugin, built and installed, adds all that a package can."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import zipfile
from math import pi
from pathlib import Path

import pytest

PLUGIN = Path(__file__).parents[2] / "examples" / "plugin"
STROKE, ROD, SPEED = 92.8e-3, 144e-3, 200 * pi
"""Of the five of the catalog [m], and 6000 rpm [rad/s]."""


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """The environment of programs that find the package."""
    folder = tmp_path_factory.mktemp("plugin")
    source = shutil.copytree(PLUGIN, folder / "source")
    subprocess.run(
        [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(folder)],
        cwd=source,
        check=True,
        capture_output=True,
    )
    [wheel] = folder.glob("*.whl")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder / "site")
    return {**os.environ, "PYTHONPATH": str(folder / "site"), "CRANKSTAR_LANG": "en"}


def run(environment: dict[str, str], *words: str) -> subprocess.CompletedProcess[str]:
    """A program of this Python, in an environment."""
    return subprocess.run(
        [sys.executable, *words], env=environment, capture_output=True, text=True, check=False
    )


def test_it_is_a_command_that_computes(installed: dict[str, str]) -> None:
    words = ("-m", "crankstar", "piston-speed", "audi-25-tfsi", "--speed", "6000 rpm", "--json")
    [row] = json.loads(run(installed, *words).stdout)["piston_speed"]
    radius = STROKE / 2
    assert row["mean_speed"] == pytest.approx(2 * STROKE * 100)
    assert row["acceleration"] == pytest.approx(radius * SPEED**2 * (1 + radius / ROD))
    refused = run(installed, "-m", "crankstar", "piston-speed", "i4", "--speed", "quick")
    assert refused.returncode == 2
    assert "--speed" in refused.stderr
    assert "cylinder.stroke" in refused.stderr


@pytest.mark.release
def test_it_is_in_the_help_and_in_the_report(installed: dict[str, str], tmp_path: Path) -> None:
    assert "piston-speed" in run(installed, "-m", "crankstar", "--help").stdout
    place = tmp_path / "report.html"
    run(installed, "-m", "crankstar", "report", "audi-25-tfsi", "-o", str(place))
    assert "acceleration at top dead centre" in place.read_text(encoding="utf-8")


PANEL = """
import json
import crankstar
from crankstar.page.exhibits import exhibition

shown = exhibition([crankstar.load("audi-25-tfsi"), crankstar.load("i4")], relatives=False)
labels = {panel.key: panel.label for panel in shown.panels}
audi, four = (engine.told for engine in shown.engines)
print(labels["piston-speed"], len(audi["piston-speed"]), "piston-speed" in four)
print(audi["piston-speed"][0].rows[0])
"""


@pytest.mark.release
def test_it_is_a_panel_of_the_page_of_engines_that_have_it(installed: dict[str, str]) -> None:
    made = run(installed, "-c", PANEL)
    labels, row = made.stdout.splitlines()
    assert labels == "Piston speed 1 False"
    assert f"{2 * STROKE * 6500 / 60:.5g}" in row


def test_it_is_a_function_of_python(installed: dict[str, str]) -> None:
    code = (
        "import crankstar; found = crankstar.piston_speed('audi-25-tfsi', speed='6000 rpm'); "
        "print(found.mean, *found.to_frame().columns)"
    )
    mean, *columns = run(installed, "-c", code).stdout.split()
    assert float(mean) == pytest.approx(2 * STROKE * 100)
    assert columns == ["speed_rpm", "mean_speed_m_per_s", "acceleration_m_per_s2"]


HELIX = """name = "helix"
cycle = "two-stroke"
[layout]
type = "helix"
cylinders = 5
step = "72 deg"
[cylinder]
rod_ratio = 4
"""


@pytest.mark.release
def test_its_layout_is_one_of_engine_files(installed: dict[str, str], tmp_path: Path) -> None:
    """Five throws 72 deg apart: no force of order 1; a mistake in it is told like any other."""
    place = tmp_path / "helix.toml"
    throws = ", ".join(f'"{72 * number} deg"' for number in range(5))
    own = f'type = "inline"\nthrows = [{throws}]\n'
    in_line = HELIX.replace('type = "helix"\ncylinders = 5\nstep = "72 deg"\n', own)
    answers = []
    for text in (HELIX, in_line):
        place.write_text(text, encoding="utf-8")
        answers.append(run(installed, "-m", "crankstar", "analyze", str(place), "--json"))
    assert answers[0].returncode == 0, answers[0].stderr
    assert json.loads(answers[0].stdout) == json.loads(answers[1].stdout)
    place.write_text(HELIX.replace("step", "stp"), encoding="utf-8")
    refused = run(installed, "-m", "crankstar", "check", str(place))
    assert refused.returncode == 2
    assert 'did you mean "step"' in refused.stderr + refused.stdout
    place.write_text(HELIX.replace("cylinders = 5", "cylinders = 40"), encoding="utf-8")
    refused = run(installed, "-m", "crankstar", "check", str(place))
    assert "layout.cylinders is 40" in refused.stderr + refused.stdout
    assert "24" in refused.stderr + refused.stdout


@pytest.mark.release
def test_its_export_is_named_by_to(installed: dict[str, str], tmp_path: Path) -> None:
    place = tmp_path / "places.csv"
    made = run(
        installed,
        *("-m", "crankstar", "export", "audi-25-tfsi", "--to", "places", "-o", str(place)),
    )
    assert made.returncode == 0, made.stderr
    heads, *rows = place.read_text(encoding="utf-8").splitlines()
    assert heads.startswith("cylinder,")
    assert len(rows) == 5
    assert float(rows[0].split(",")[-1]) == pytest.approx(ROD / (STROKE / 2), rel=1e-5)
    refused = run(installed, *("-m", "crankstar", "export", "i4", "--to", "nothing", "-o", "x.csv"))
    assert refused.returncode == 2
    assert "exudyn, opentorsion, ross, places" in " ".join(refused.stderr.split())
