"""Scripts for openTorsion and ROSS: run, and their frequencies compared with ours."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run
from tests.methods.test_torsion_charts import fan_drive, tree

import crankstar
from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_modes import torsion_modes
from crankstar.dynamics.torsion_system import TorsionError
from crankstar.engine.torsion import Chain, Disc
from crankstar.exports.torsion import Program, torsion_script
from crankstar.files import engine_of


def six() -> crankstar.Engine:
    return engine_of(tree(), name="six")


def ringed() -> Chain:
    """A branched line with a rigid hub, a geared branch and a ring that a fluid takes along."""
    return Chain(
        name="ringed",
        discs=(
            Disc(name="engine", inertia=3),
            Disc(name="hub", inertia=0.4, to="engine"),
            Disc(name="ring", inertia=1.5, to="hub", damping=200),
            Disc.model_validate(
                {"name": "pump", "inertia": 0.2, "to": "engine", "stiffness": 9e4, "speed_ratio": 2}
            ),
            Disc(name="rotor", inertia=12, to="engine", stiffness=4e5, absolute_damping=30),
        ),
    )


def printed(script: str, place: Path) -> list[float]:
    """The frequencies that a script prints."""
    place.write_text(script, encoding="utf-8")
    ran = subprocess.run([sys.executable, str(place)], capture_output=True, text=True, check=True)
    head, *lines = ran.stdout.splitlines()
    assert head == "natural frequencies, Hz"
    assert [int(line.split()[0]) for line in lines] == list(range(1, len(lines) + 1))
    return [float(line.split()[1]) for line in lines]


@pytest.mark.release
@pytest.mark.parametrize("source", [six(), fan_drive(), ringed()], ids=lambda each: each.name)
def test_the_opentorsion_script_prints_our_frequencies(source: Any, tmp_path: Path) -> None:
    found = printed(torsion_script(source, to="opentorsion"), tmp_path / "chain.py")
    own = [mode.frequency for mode in torsion_modes(torsion_chain(source))]
    assert found == pytest.approx(own, rel=1e-9)
    assert own


STAND_IN = """
'''The part of ROSS that the script uses, for it is too heavy a program to be installed here.

The sixth freedom of a node turns about the shaft; a shaft has G pi (d^4 - b^4)/(32 L) there, a disc
its polar inertia.
'''
from types import SimpleNamespace as Namespace
import numpy as np

def Material(name, *, rho, E, G_s):
    return Namespace(rho=rho, E=E, G_s=G_s)

def ShaftElement(*, L, idl, odl, material, n):
    return Namespace(n=n, k=material.G_s * np.pi * (odl**4 - idl**4) / 32 / L)

def DiskElement(*, n, m, Id, Ip):
    return Namespace(n=n, Ip=Ip)

class Rotor:
    def __init__(self, shafts, discs, bearings):
        self.shafts, self.discs, self.size = shafts, discs, 6 * (len(shafts) + 1)

    def K(self, speed):
        out = np.eye(self.size)
        out[5::6, 5::6] = 0
        for each in self.shafts:
            at = np.ix_([6 * each.n + 5, 6 * each.n + 11], [6 * each.n + 5, 6 * each.n + 11])
            out[at] += each.k * np.array([[1, -1], [-1, 1]])
        return out

    def M(self):
        out = np.eye(self.size)
        for each in self.discs:
            out[6 * each.n + 5, 6 * each.n + 5] = each.Ip
        return out
"""


@pytest.mark.release
@pytest.mark.parametrize("source", [six(), fan_drive()], ids=lambda each: each.name)
def test_the_ross_script_prints_our_frequencies(source: Any, tmp_path: Path) -> None:
    (tmp_path / "ross.py").write_text(STAND_IN, encoding="utf-8")
    found = printed(torsion_script(source, to="ross"), tmp_path / "chain.py")
    own = [mode.frequency for mode in torsion_modes(torsion_chain(source))]
    assert found == pytest.approx(own, rel=1e-8)  # its shafts have a little mass


@pytest.mark.parametrize("to", ["opentorsion", "ross"])
def test_the_numbers_of_a_script_have_our_frequencies(to: Program) -> None:
    """Both scripts start with the same lists, which make the stiffness matrix."""
    for source in (six(), fan_drive()):
        known: dict[str, Any] = {
            target.id: ast.literal_eval(line.value)
            for line in ast.parse(torsion_script(source, to=to)).body[:3]
            if isinstance(line, ast.Assign)
            for target in line.targets
            if isinstance(target, ast.Name)
        }
        inertia = np.array([mass[0] for mass in known["MASSES"]])
        stiff = np.zeros((inertia.size, inertia.size))
        for one, other, k, _c in known["SHAFTS"]:
            stiff[one, one] += k
            stiff[other, other] += k
            stiff[one, other] -= k
            stiff[other, one] -= k
        root = np.sqrt(inertia)
        squared = np.linalg.eigvalsh(stiff / np.outer(root, root))[known["RIGID"] :]
        own = [mode.frequency for mode in torsion_modes(torsion_chain(source))]
        assert np.sqrt(squared) / (2 * np.pi) == pytest.approx(own, rel=1e-9)


def test_ross_has_no_branches() -> None:
    with pytest.raises(TorsionError, match="openTorsion has branches"):
        torsion_script(ringed(), to="ross")


def test_a_script_says_what_it_leaves_out() -> None:
    own = tree()
    own["torsion"]["pendulum"] = [
        {"on": "front", "mass": "0.6 kg", "radius": "80 mm", "length": "20 mm"}
    ]
    script = torsion_script(engine_of(own, name="six"), to="opentorsion")
    assert "# Pendulums are at rest" in script
    assert "# Loss factors are left out" in script


def test_export_writes_the_script_of_a_drive_line(run: Run, tmp_path: Path) -> None:
    file, place = tmp_path / "fan.toml", tmp_path / "fan.py"
    file.write_text(
        'name = "fan drive"\n[[disc]]\nname = "motor"\ninertia = "2 kg*m^2"\n[[disc]]\n'
        'name = "fan"\ninertia = "3 kg*m^2"\nto = "motor"\nstiffness = "6 kN*m/rad"\n',
        encoding="utf-8",
    )
    ran = run("export", str(file), "--to", "opentorsion", "-o", str(place))
    assert ran.code == 0, ran.err
    assert "(0, 1, 6000.0, 0.0),  # motor - fan" in place.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("i4", "--to", "opentorsion", "-o", "x.py"), "give the table [torsion]"),
        (("i4", "--to", "ross", "--speed", "9 rpm", "-o", "x.py"), "--speed"),
        (("i4", "--to", "adams", "-o", "x.py"), "exudyn, opentorsion, ross"),
        (("i4", "--to", "ross", "-o", "x.glb"), "--to"),
    ],
)
def test_export_says_what_does_not_go(
    run: Run, words: tuple[str, ...], said: str, tmp_path: Path
) -> None:
    *given, name = words
    ran = run("export", *given, str(tmp_path / name))
    assert ran.code == 2
    assert said in ran.err
    assert not (tmp_path / name).exists()
