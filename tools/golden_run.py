"""Every command for every engine, written to a folder, and two such folders compared.

`python tools/golden_run.py write FOLDER [ENGINE ...]` before and after a change of the structure,
`python tools/golden_run.py compare BEFORE AFTER` for what is different: numbers by more than 1e-12
of the largest of their file, keys, and letters of what a terminal shows.
"""

from __future__ import annotations

import io
import json
import os
import re
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import redirect_stderr, redirect_stdout
from itertools import product
from math import isclose
from pathlib import Path
from typing import NamedTuple

import openpyxl

from crankstar import cli
from crankstar.files.catalog import names

CLOSE = 1e-12
"""Of the largest number of a file, by which a number may move."""
MOST_SHOWN = 5
"""Differences of one file that are listed."""
COMMANDS = (
    "analyze {}",
    "analyze {} --speeds 1000..3000rpm/3",
    "analyze {} --estimate",
    "balance {} --factor 0.5",
    "balance {} --shafts needed --level",
    "bearings {}",
    "bearings {} --gas",
    "bobweight {}",
    "check {}",
    "compare {} v8-cross-plane",
    "derive {} --orders 1 --quantity force",
    "derive {} --orders 2 --quantity couple",
    "estimate {}",
    "fault {} --cut 1",
    "genset {}",
    "guide {}",
    "isolate {}",
    "marine {}",
    "mounts {}",
    "orders {}",
    "show {}",
    "strokes {}",
    "sweep {} --over balance_factor=0..1/3",
    "tolerance {} --typical",
    "torque {}",
    "torque {} --off 1",
    "torsion {}",
    "verdict {}",
)
FORMS = ("", "--json", "--csv", "-o out.xlsx")
WRITTEN = (
    "draw {} -o out.svg",
    "export {} -o out.stl",
    "page {} -o out.html",
    "plot {} spectrum -o out.svg",
    "plot {} torque -o out.json",
    "report {} -o out.html",
)
"""Commands whose answer is a file; each is compared by its bytes."""


class Case(NamedTuple):
    """A command line, and the name of the file with what came of it."""

    words: tuple[str, ...]
    name: str


def cases(engine: str) -> Iterator[Case]:
    """All command lines of an engine."""
    for command, form in product(COMMANDS, FORMS):
        line = f"{command.format(engine)} {form}".strip()
        yield Case(tuple(line.split()), re.sub(r"[^\w.=-]+", "_", f"{command} {form}".format("")))
    for command in WRITTEN:
        yield Case(tuple(command.format(engine).split()), re.sub(r"[^\w.-]+", "_", command))


def ran(case: Case) -> str:
    """What a command line prints and writes, and how it ends."""
    out, err = io.StringIO(), io.StringIO()
    code: object = 0
    with redirect_stdout(out), redirect_stderr(err):
        try:
            cli.main(case.words)
        except SystemExit as left:
            code = left.code
    parts = [f"code {code}", out.getvalue(), err.getvalue()]
    for path in sorted(Path().iterdir()):
        if path.suffix == ".xlsx":
            sheets = openpyxl.load_workbook(path).worksheets
            rows = ([s.title, *r] for s in sheets for r in s.iter_rows(values_only=True))
            parts.append("\n".join(json.dumps(row, ensure_ascii=False) for row in rows))
        else:
            parts.append(path.read_text(encoding="utf-8", errors="replace"))
        path.unlink()
    return "\n".join(parts)


def write_engine(folder: Path, engine: str) -> int:
    """All answers of an engine in its folder; how many."""
    os.environ["COLUMNS"] = "100"
    own = folder / engine
    own.mkdir(parents=True, exist_ok=True)
    lines = list(cases(engine))
    with tempfile.TemporaryDirectory() as away:
        os.chdir(away)
        for case in lines:
            (own / f"{case.name}.txt").write_text(ran(case), encoding="utf-8")
        os.chdir(folder)
    return len(lines)


def write(folder: Path, engines: list[str]) -> None:
    """All answers of engines, two at a time."""
    folder.mkdir(parents=True, exist_ok=True)
    with ProcessPoolExecutor(2) as pool:
        tasks = [pool.submit(write_engine, folder, engine) for engine in engines]
        for engine, task in zip(engines, tasks, strict=True):
            print(f"{engine}: {task.result()} answers", flush=True)


def numbers(text: str) -> tuple[list[float], str]:
    """The numbers of a text, and the text without them."""
    found = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.])")
    return [float(each) for each in found.findall(text)], found.sub("#", text)


def differences(before: str, after: str) -> list[str]:
    """What is different in two answers."""
    if before == after:
        return []
    (old, plain), (new, other) = numbers(before), numbers(after)
    if plain != other or len(old) != len(new):
        lines = zip(plain.splitlines(), other.splitlines(), strict=False)
        first = next(((a, b) for a, b in lines if a != b), ("", "more or fewer lines"))
        return [f"{first[0][:160]!r} is now {first[1][:160]!r}"]
    most = max(map(abs, (*old, *new)), default=0.0)
    pairs = zip(old, new, strict=True)
    return [
        f"{a!r} is now {b!r}"
        for a, b in pairs
        if not isclose(a, b, rel_tol=0, abs_tol=CLOSE * most)
    ]


def compare(before: Path, after: Path) -> int:
    """Print what two folders have different; how many files are."""
    paths = sorted({p.relative_to(f) for f in (before, after) for p in f.rglob("*.txt")})
    bad = 0
    for path in paths:
        sides = [folder / path for folder in (before, after)]
        if not all(side.exists() for side in sides):
            told = ["only " + ("before" if sides[0].exists() else "after")]
        else:
            told = differences(*(side.read_text(encoding="utf-8") for side in sides))
        bad += bool(told)
        for line in told[:MOST_SHOWN]:
            print(f"{path}: {line}")
    print(f"{bad} of {len(paths)} answers are different")
    return bad


def main(words: list[str]) -> int:
    """Run one of the two commands."""
    match words:
        case ["write", folder, *engines]:
            write(Path(folder).resolve(), engines or list(names()))
            return 0
        case ["compare", before, after]:
            return int(compare(Path(before), Path(after)) > 0)
        case _:
            print(__doc__)
            return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
