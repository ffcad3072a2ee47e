"""What is written fits the name of its file: every verb with -o, every suffix."""

from __future__ import annotations

import csv
import io
import json
import shlex
import tomllib
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.commands import Run
from tests.rules.test_options import COMMANDS, options

from crankstar.options.forms import DERIVATIONS

LINES = [
    "analyze i4 --speeds '600..1200 rpm/3'",
    "analyze single",
    "animate single --seconds 0.2 --frames-per-second 10 --size 96x72",
    "balance single --factor 0.5",
    "bearings i4",
    "bobweight single",
    "compare single i4",
    (
        "correct --unbalance '850 g*mm at 20 deg, 400 g*mm at 110 deg' "
        "--measuring-planes '0 mm, 400 mm' --correction-planes '60 mm, 340 mm'"
    ),
    "derive single --orders 1 --quantity force",
    "diagnose audi-25-tfsi measured.csv",
    "draw single",
    "drill --unbalance '850 g*mm at 20 deg' --at-radius '60 mm' --diameter '12 mm'",
    "errata --source kr250",
    "estimate single --displacement '250 cc'",
    "export single --set cylinder.stroke='80 mm'",
    "fault audi-25-tfsi --cut 2",
    "genset audi-25-tfsi --engines 2",
    "grade --mass '28 kg' --speed '6000 rpm'",
    "guide man-s90mc-c --numbers 5",
    "marine man-s90mc-c",
    "match audi-25-tfsi weights.csv",
    (
        'mounts audi-25-tfsi --set \'mounts=[{name="a", right="-0.4 m", stiffness="90 N/mm"}, '
        '{name="b", right="0.4 m", stiffness="90 N/mm"}, {name="c", z="-1 m", stiffness="1 N/m"}]\''
    ),
    (
        'isolate audi-25-tfsi --set \'mounts=[{name="a", right="-0.4 m", stiffness="90 N/mm"}, '
        '{name="b", right="0.4 m", stiffness="90 N/mm"}, {name="c", z="-1 m", stiffness="9 N/m"}]\''
        ' --minimise roll --stiffness "80..100 N/mm" --starts 1'
    ),
    "new inline",
    "orders i4 --row 1",
    "orders i4",
    "page single",
    "plot single spectrum",
    "report single",
    "schema",
    "search 3 --row 1",
    "search 3",
    "show single --explicit",
    "show single",
    "sound v8-cross-plane --rpm 3000 --seconds 1",
    "strokes i4",
    "sweep single --over balance_factor=0..1/3",
    "tolerance i4 --builds 1000 --orders 1 --set 'cylinder.rotating_mass=0.5 +- 0.01'",
    "torque audi-25-tfsi",
    "torsion audi-25-tfsi --set torsion.inertia='10 g*m^2' --set torsion.stiffness='500 kN*m/rad'",
    "vees 4 --row 1",
    "vees 4",
    "verdict single",
]
LISTS = {
    "weights.csv": "piston [g]\n410\n411\n412\n413\n414\n",
    "measured.csv": (
        "order,direction,amplitude [mm/s],phase\n1,up,5,0\n1,right,3,90\n2,up,4,30\n2,right,1,9\n"
    ),
}
"""Lists that some of them read."""
FOLDERS = {"site"}
"""Verbs that write a directory; tests/files/test_site.py."""
NEVER = ("nc", "docx", "dat", "jpg", "ods", "zip")


def starting(*marks: bytes) -> Callable[[bytes], bool]:
    return lambda content: content.lstrip().startswith(marks)


def is_readable(content: bytes) -> bool:
    return content.decode().isprintable() or b"\n" in content


def is_table(content: bytes) -> bool:
    rows = [*csv.reader(io.StringIO(content.decode()))]
    return len({len(row) for row in rows}) <= 1


FITS: dict[str, Callable[[bytes], bool]] = {
    "csv": is_table,
    "gif": starting(b"GIF89a"),
    "glb": starting(b"glTF"),
    "htm": starting(b"<!doctype", b"<!DOCTYPE"),
    "html": starting(b"<!doctype", b"<!DOCTYPE"),
    "json": lambda content: isinstance(json.loads(content), dict | list),
    "md": starting(b"# "),
    "mp4": lambda content: content[4:8] == b"ftyp",
    "parquet": starting(b"PAR1"),
    "pdf": starting(b"%PDF"),
    "png": starting(b"\x89PNG"),
    "py": lambda content: compile(content, "model", "exec") is not None,
    "stl": lambda content: len(content) > 84,
    "svg": starting(b"<svg"),
    "tex": starting(b"\\documentclass"),
    "toml": lambda content: "format" in tomllib.loads(content.decode()),
    "txt": is_readable,
    "wav": starting(b"RIFF"),
    "webp": lambda content: content[8:12] == b"WEBP",
    "xlsx": starting(b"PK"),
}
"""Whether what stands in a file is what its name promises, by suffix."""


def test_every_verb_that_writes_a_file_is_tried() -> None:
    verbs = {shlex.split(line)[0] for line in LINES}
    assert verbs | FOLDERS == {name for name in COMMANDS if "--output" in options(name)}


@pytest.mark.release
@pytest.mark.parametrize("line", LINES)
def test_a_file_holds_what_its_name_promises_or_is_refused(
    run: Run, tmp_path: Path, line: str
) -> None:
    for name, text in LISTS.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    written = []
    for suffix in [*FITS, *NEVER]:
        if (shlex.split(line)[0], suffix) == ("report", "pdf"):
            continue  # printed by a browser
        file = tmp_path / f"made.{suffix}"
        said = run(*shlex.split(line), "-o", file.name)
        if said.code == 0:
            written.append(suffix)
            assert FITS[suffix](file.read_bytes()), suffix
        else:
            assert not file.exists()
            assert "must end in" in said.err, suffix
    assert written
    assert not {*written} & {*NEVER}


@pytest.mark.parametrize("suffix", DERIVATIONS)
def test_a_derivation_is_in_the_format_that_its_name_says(
    run: Run, tmp_path: Path, suffix: str
) -> None:
    words = ("derive", "single", "--orders", "1", "--quantity", "force")
    run(*words, "-o", f"named.{suffix}")
    run(*words, "--format", DERIVATIONS[suffix], "-o", "asked")
    assert (tmp_path / f"named.{suffix}").read_bytes() == (tmp_path / "asked").read_bytes()
    others = [other for other in DERIVATIONS if other != suffix]
    for other in others:
        said = run(*words, "--format", DERIVATIONS[suffix], "-o", f"other.{other}")
        assert f"-o other.{other}: the name must end in .{suffix}" in said.err


def test_every_format_of_a_derivation_has_a_suffix() -> None:
    from crankstar.derive.documents import FORMATS

    assert {*DERIVATIONS.values()} == {"text", *FORMATS}
