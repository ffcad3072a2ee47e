"""Ctrl-C while the program is being loaded: exit code 130, and no traceback.

Each program is held at a named point: a module on PYTHONPATH has the name of one that is loaded
there, opens a named pipe to say so, and stays until the interrupt comes. The pipe is opened without
a file object: what comes while Python ends one that nobody keeps is lost.
"""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from tests.holding import PATIENCE, reached

ANALYZE = ["analyze", "i4"]
PLOT = ["plot", "i4", "spectrum", "-o", "chart.svg"]
POINTS = [
    (ANALYZE, "__future__"),
    (ANALYZE, "contextlib"),
    (ANALYZE, "cyclopts"),
    (ANALYZE, "tomllib"),
    (ANALYZE, "pydantic"),
    (ANALYZE, "pydantic_core"),
    (ANALYZE, "numpy"),
    (ANALYZE, "rich"),
    (PLOT, "threading"),
    (PLOT, "numpy"),
]
STAY = "while True: time.sleep(0.01)\n"
"""Not in one call, into which an interrupt that comes just before it would not break."""
UNMEASURED = {name: each for name, each in os.environ.items() if not name.startswith("COVERAGE_")}
"""A measurement of coverage loads some of these modules itself, before there is a program."""
START = "from crankstar.__main__ import main; main()"
"""What the script of the package does."""


LOST = """
class Thing:
    pass

def stay(_reference):
    os.open(pipe, os.O_RDONLY)
    while True:
        time.sleep(0.01)

thing = Thing()
reference = weakref.ref(thing, stay)
del thing
"""
"""A callback as Python's import has one for each module: no exception passes through it."""


@pytest.mark.many(first=2)
@pytest.mark.parametrize(("words", "module"), POINTS)
def test_an_interrupt_at_any_import_ends_the_program_quietly(
    words: list[str], module: str, tmp_path: Path
) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    held = f"import os, time\nos.open({str(pipe)!r}, os.O_RDONLY)\n{STAY}"
    (tmp_path / f"{module}.py").write_text(held, encoding="utf-8")
    interrupted(words, tmp_path, pipe)


def test_an_interrupt_in_a_callback_of_an_import_ends_the_program(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    held = f"import os, time, weakref\npipe = {str(pipe)!r}\n{LOST}{STAY}"
    (tmp_path / "numpy.py").write_text(held, encoding="utf-8")
    interrupted(ANALYZE, tmp_path, pipe)


def interrupted(words: list[str], tmp_path: Path, pipe: Path) -> None:
    """Interrupts a program where it is held, which has to end as one that is interrupted."""
    with (
        subprocess.Popen(
            [sys.executable, "-c", START, *words],
            cwd=tmp_path,
            env={**UNMEASURED, "PYTHONPATH": str(tmp_path)},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        ) as process,
        reached(pipe),
    ):
        process.send_signal(signal.SIGINT)
        try:
            out, err = process.communicate(timeout=PATIENCE)
        finally:
            process.kill()
    assert (process.returncode, out, err) == (130, "", "")


def test_nothing_is_loaded_before_the_program_can_be_interrupted() -> None:
    """What Python itself loads apart: the package, and what runs its command line."""
    bare = "import sys; before = {*sys.modules}; from crankstar.__main__ import main; "
    shown = bare + "print(sorted({*sys.modules} - before))"
    run = [sys.executable, "-c", shown]
    made = subprocess.run(run, env=UNMEASURED, capture_output=True, text=True, check=True)
    assert made.stdout.strip() == "['crankstar', 'crankstar.__main__', 'gc']"
