"""The rules of the package: size, docstrings, lists of modules, the cost of its import."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from statistics import quantiles
from typing import NamedTuple

import pytest

import crankstar
from crankstar import charts
from tools import rooms

pytestmark = pytest.mark.quick

PACKAGE = Path(crankstar.__file__).parent
ROOT = PACKAGE.parent.parent
MODULES = sorted(PACKAGE.rglob("*.py"))
ROOMS = pytest.mark.parametrize(
    "room", rooms.rooms(), ids=lambda room: room.relative_to(PACKAGE).as_posix()
)
GREATEST_BODY, USUAL_BODY = 60, 30


def body_lines(function: ast.FunctionDef) -> int:
    first = (
        function.body[1:]
        if ast.get_docstring(function) and len(function.body) > 1
        else function.body
    )
    return (function.end_lineno or 0) - first[0].lineno + 1


class Survey(NamedTuple):
    """What the sources show: lines of each function, what has no docstring, numbers in a row."""

    lengths: dict[str, int]
    silent: list[str]
    swappable: list[str]


@cache
def survey() -> Survey:
    """Every module read once for all tests."""
    out = Survey({}, [], [])
    for path in MODULES:
        tree = ast.parse(path.read_text(encoding="utf-8"))
        out.silent.extend(silent(path, tree))
        for function in ast.walk(tree):
            if isinstance(function, ast.FunctionDef):
                name = f"{path.stem}.{function.name}"
                out.lengths[name] = body_lines(function)
                if not function.name.startswith("_") and numbers_in_a_row(function) > 1:
                    out.swappable.append(name)
    return out


def silent(path: Path, tree: ast.Module) -> Iterator[str]:
    if not ast.get_docstring(tree):
        yield path.name
    for node in tree.body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("_"):
            overload = "overload" in map(ast.unparse, node.decorator_list)
            if not overload and not ast.get_docstring(node):
                yield f"{path.name}: {node.name}"


def numbers_in_a_row(function: ast.FunctionDef) -> int:
    plain = [ast.unparse(a.annotation) for a in function.args.args if a.annotation]
    return sum(name in ("float", "ArrayLike", "complex") for name in plain)


def test_functions_are_short() -> None:
    lengths = survey().lengths
    assert {name: lines for name, lines in lengths.items() if lines > GREATEST_BODY} == {}
    assert quantiles(lengths.values(), n=10)[-1] <= USUAL_BODY


def test_every_public_function_and_class_says_what_it_is() -> None:
    assert survey().silent == []


def test_the_map_in_the_package_docstring_names_every_module_and_no_other() -> None:
    there = {path.stem for path in PACKAGE.glob("*.py") if not path.stem.startswith("__")}
    there |= {path.parent.name for path in PACKAGE.glob("*/__init__.py")}
    assert sorted(rooms.listed(crankstar.__doc__ or "")) == sorted(there)


@ROOMS
def test_a_room_lists_its_modules(room: Path) -> None:
    """In any order."""
    assert sorted(rooms.listed(text_of(room))) == sorted(rooms.modules(room))


@pytest.mark.release
@ROOMS
def test_a_room_lists_its_modules_from_bottom_to_top(room: Path) -> None:
    assert text_of(room) == rooms.sorted_text(room), "run `make rooms`"


def text_of(room: Path) -> str:
    return (room / "__init__.py").read_text(encoding="utf-8")


def test_every_exported_name_is_there_and_completed() -> None:
    assert all(hasattr(crankstar, name) for name in crankstar.__all__)
    assert {*crankstar.__all__} <= {*dir(crankstar)}
    assert {"load", "names", "widget", "derivation"} <= {*dir(crankstar)}


def test_the_package_tells_type_checkers_that_it_is_typed() -> None:
    assert (PACKAGE / "py.typed").is_file()


def test_a_running_notebook_shows_engines_and_balances_as_tables(tmp_path: Path) -> None:
    code = (
        "from IPython.core.interactiveshell import InteractiveShell; "
        "shell = InteractiveShell.instance(); "
        "import crankstar; engine = crankstar.load('i4'); "
        "shown = [shell.display_formatter.format(it)[0] "
        "for it in (engine, crankstar.balance(engine))]; "
        "print(*('text/html' in it for it in shown))"
    )
    printed = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", code],
        check=True,
        capture_output=True,
        text=True,
        env={**os.environ, "IPYTHONDIR": str(tmp_path)},
    ).stdout
    assert printed.split() == ["True", "True"]


@pytest.mark.parametrize(
    ("statement", "loaded"),
    [
        ("import crankstar", ""),
        ("import crankstar; dir(crankstar)", ""),
        ("from crankstar import Engine, balance", "numpy pydantic"),
    ],
)
def test_the_package_loads_numpy_and_pydantic_when_they_are_used(
    statement: str, loaded: str
) -> None:
    code = (
        f"{statement}; import sys; "
        f"print(*sorted({{name.partition('.')[0] for name in sys.modules}} "
        "& {'pint', 'rich', 'cyclopts', 'scipy', 'tomli_w', 'altair', 'numba', 'numpy', "
        "'pydantic'}))"
    )
    printed = subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, text=True
    ).stdout
    assert printed.strip() == loaded


def test_every_exported_name_comes_with_a_star_import() -> None:
    names: dict[str, object] = {}
    exec("from crankstar import *", names)  # noqa: S102
    assert all(names[name] is getattr(crankstar, name) for name in crankstar.__all__)


@pytest.mark.parametrize(
    "how", [["-m", "crankstar"], ["-c", "from crankstar.__main__ import *; main()"]]
)
@pytest.mark.parametrize("library", ["numpy", "pydantic", "cyclopts"])
def test_an_interrupt_while_a_library_is_loaded_ends_it_with_130_without_a_word(
    tmp_path: Path, how: list[str], library: str
) -> None:
    interrupted = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler); "
    (tmp_path / f"{library}.py").write_text(f"{interrupted}signal.raise_signal(signal.SIGINT)")
    path = os.pathsep.join([str(tmp_path), str(PACKAGE.parent)])
    ran = subprocess.run(
        [sys.executable, *how, "list"],
        check=False,
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": path},
    )
    assert (ran.returncode, ran.stdout, ran.stderr) == (130, "", "")


def test_lock_files_and_sources_name_no_address_to_install_from() -> None:
    text = (ROOT / "constraints.txt").read_text(encoding="utf-8")
    assert "://" not in text
    assert not re.search(r"^\s*-", text, flags=re.MULTILINE)
    assert all(re.fullmatch(r"[A-Za-z0-9_.-]+==[A-Za-z0-9_.+!-]+", line) for line in text.split())


def test_physics_arguments_are_keyword_only() -> None:
    """Two numbers of one type side by side can be swapped; they must be named."""
    # `ellipse` and `greatest` (forward, backward) are the law |f| + |b|, the same either way but
    # for the sense; `number(value, largest)` is text.
    symmetric = {"spectrum.ellipse", "bounds.greatest"}
    assert {*survey().swappable} <= {*symmetric, "numbers.number", "numbers.wave"}


def test_records_are_copied_with_changes_in_one_place_only():
    """`model_copy` checks nothing; `engine.copies` does."""
    users = {
        path.relative_to(PACKAGE).as_posix()
        for path in MODULES
        if "model_copy" in path.read_text("utf-8")
    }
    assert users <= {"engine/copies.py"}


def test_no_figure_has_the_name_of_a_module_of_its_room() -> None:
    """The module would take the place of the figure as soon as anything loads it."""
    modules = {path.stem for path in (ROOT / "src" / "crankstar" / "charts").glob("*.py")}
    assert {*charts.__all__} & modules == set()
