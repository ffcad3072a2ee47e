"""Doubts of an engine file: every command that computes with its gas prints them."""

from pathlib import Path

import pytest
from tests.commands import Run
from tests.lacking import RUBBER

from crankstar.files.catalog import path_of

TWISTING = """
[torsion]
inertia = "0.03 kg*m^2"
stiffness = "1.2 MN*m/rad"
[[torsion.disc]]
name = "flywheel"
inertia = "0.3 kg*m^2"
to = "rear"
"""
MOUNTED = f'\n[block]\nmass = "150 kg"\n{RUBBER}'
COMMANDS = [
    ("check",),
    ("verdict",),
    ("analyze",),
    ("torque",),
    ("bearings", "--gas"),
    ("genset",),
    ("marine",),
    ("torsion",),
    ("mounts",),
    ("fault", "--cut", "3"),
    ("compare", "audi-25-tfsi"),
    ("sweep", "--over", "cylinder.rod_length=140..144 mm/2", "--quantity", "mean_torque"),
    ("isolate", "--stiffness", "100..400 N/mm"),
]

SLOW = ("isolate", "mounts", "torsion")
"""Those that compute long; the others are in the gate."""
MARKED = [
    pytest.param(each, marks=[pytest.mark.release] if each[0] in SLOW else []) for each in COMMANDS
]
TABLES = {"torsion": TWISTING, "mounts": MOUNTED, "fault": MOUNTED, "isolate": MOUNTED}
"""What a command needs beside the engine."""


def doubted(folder: Path, tables: str = "", ratio: str = "1.2") -> str:
    """The file of an engine with some more tables, of a compression ratio that no engine has."""
    text = (path_of("audi-25-tfsi") or Path()).read_text(encoding="utf-8")
    text = text.replace("compression_ratio = 10.0", f"compression_ratio = {ratio}")
    path = folder / "doubted.toml"
    path.write_text(text.replace("[provenance]", f"{tables}[provenance]"), encoding="utf-8")
    return str(path)


@pytest.mark.many(first=1)
@pytest.mark.parametrize("command", MARKED, ids=lambda command: command[0])
@pytest.mark.parametrize("ratio", ["1.2", "60"])
def test_an_impossible_compression_ratio_is_doubted_once_by_every_command_with_gas(
    command: tuple[str, ...], ratio: str, tmp_path: Path, run: Run
) -> None:
    verb, *options = command
    made = run(verb, doubted(tmp_path, TABLES.get(verb, ""), ratio), *options)
    assert made.code == 0, made.err
    assert " ".join(made.out.split()).count("compression_ratio is") == 1


@pytest.mark.release
def test_a_report_and_a_chart_doubt_it_too(run: Run, tmp_path: Path) -> None:
    engine = doubted(tmp_path)
    for number, words in enumerate((["report", engine], ["plot", engine, "torque"])):
        path = tmp_path / f"{number}.html"
        assert run(*words, "-o", str(path)).code == 0
        assert "compression_ratio is" in " ".join(path.read_text(encoding="utf-8").split())
