"""The rules of the house, as tests: size, docstrings, the map of the package, what importing it loads."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from pathlib import Path
from statistics import quantiles

import pytest

import crankstar

PACKAGE = Path(crankstar.__file__).parent
ROOT = PACKAGE.parent.parent
MODULES = sorted(PACKAGE.rglob("*.py"))
GREATEST_MODULE, GREATEST_BODY, USUAL_BODY = 400, 60, 30


def functions(path: Path) -> list[ast.FunctionDef]:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]


def body_lines(function: ast.FunctionDef) -> int:
    first = function.body[1:] if ast.get_docstring(function) and len(function.body) > 1 else function.body
    return (function.end_lineno or 0) - first[0].lineno + 1


@pytest.mark.parametrize("path", MODULES, ids=lambda path: str(path.relative_to(PACKAGE)))
def test_a_module_is_short_enough_to_hold_in_the_head(path: Path) -> None:
    assert len(path.read_text(encoding="utf-8").splitlines()) <= GREATEST_MODULE


def test_functions_are_short() -> None:
    lengths = {f"{path.stem}.{function.name}": body_lines(function) for path in MODULES for function in functions(path)}
    assert {name: lines for name, lines in lengths.items() if lines > GREATEST_BODY} == {}
    assert quantiles(lengths.values(), n=10)[-1] <= USUAL_BODY


def test_every_public_function_and_class_says_what_it_is() -> None:
    silent: list[str] = []
    for path in MODULES:
        tree = ast.parse(path.read_text(encoding="utf-8"))
        if not ast.get_docstring(tree):
            silent.append(path.name)
        public = [node for node in tree.body if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("_")]
        silent += [f"{path.name}: {node.name}" for node in public if not ast.get_docstring(node)]
    assert silent == []


def test_the_map_in_the_package_docstring_names_every_module_and_no_other() -> None:
    rows = re.findall(r"^\| (`[^|]*`) \|", crankstar.__doc__ or "", flags=re.MULTILINE)
    named = {name.rstrip("/") for row in rows for name in re.findall(r"`([^`]+)`", row)}
    there = {path.stem for path in PACKAGE.glob("*.py") if not path.stem.startswith("__")}
    there |= {path.parent.name for path in PACKAGE.glob("*/__init__.py")}
    assert named == there


def test_every_exported_name_is_there() -> None:
    assert all(hasattr(crankstar, name) for name in crankstar.__all__)


def test_importing_the_package_loads_numpy_and_pydantic_only() -> None:
    code = (
        "import sys, crankstar; import importlib.metadata as m; "
        "print(sorted({name.partition('.')[0] for name in sys.modules} & "
        "{'pint', 'rich', 'cyclopts', 'scipy', 'sympy', 'tomli_w', 'altair', 'numba', 'numpy', 'pydantic'}))"
    )
    printed = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout
    assert printed.strip() == "['numpy', 'pydantic']"


def test_lock_files_and_sources_name_no_address_to_install_from() -> None:
    text = (ROOT / "constraints.txt").read_text(encoding="utf-8")
    assert "://" not in text
    assert not re.search(r"^\s*-", text, flags=re.MULTILINE)
    assert all(re.fullmatch(r"[A-Za-z0-9_.-]+==[A-Za-z0-9_.+!-]+", line) for line in text.split())


def test_physics_arguments_are_keyword_only() -> None:
    """Two numbers of one type side by side can be swapped; they must be named."""
    swappable: list[str] = []
    for path in MODULES:
        for function in functions(path):
            if function.name.startswith("_"):
                continue
            plain = [ast.unparse(a.annotation) for a in function.args.args if a.annotation]
            numeric = [name for name in plain if name in ("float", "ArrayLike", "complex")]
            if len(numeric) > 1:
                swappable.append(f"{path.stem}.{function.name}")
    # `ellipse(forward, backward)` is the law |f| + |b|, the same either way but for the sense; `number(value, largest)` is text.
    assert set(swappable) <= {"phasor.ellipse", "wording.number", "wording.wave"}
