"""What a broken package adds is skipped with one line, and refused only by its own name."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import crankstar
from crankstar.analysis import registry
from crankstar.analysis.reader import asked
from crankstar.analysis.record import Later
from crankstar.cli import application, exporting
from crankstar.engine import layouts
from crankstar.engine.packages import Added, PackageError, PackageWarning
from crankstar.exports.added import ADDED
from crankstar.language.messages import MessageError
from crankstar.python.functions import meaning_of

Run = Callable[..., Any]
MODULE = """
from dataclasses import replace
from crankstar.analysis.record import Later
from crankstar.analysis.registry import analysis
THREE = 3
LOST = replace(analysis("torque"), name="lost", compute=Later("nowhere:compute"))
RENAMED = replace(analysis("torque"), name="other")
def lay(basis): return None
def wrong(basis): return "nope"
def raises(basis): raise RuntimeError("boom \\x1b[31m")
def noannot(basis, x): return None
def untyped(basis, *, x=1): return None
def anything(basis, *args, **keys): return None
def mess(basis, y=[]): return None
def odd(basis, *, y: int = object()): return None
def typed(basis, *, type: int = 1): return None
def crash(engine): raise RuntimeError("boom \\x1b[31m")
def none(engine): return None
def lone(engine): return "\\udcff x"
def two(engine, other): return "x"
def text(engine): return engine.name
"""
ANALYSES = {"a": "nowhere:x", "three": "bad_adds:THREE", "lost": "bad_adds:LOST"}
ANALYSES.update({"renamed": "bad_adds:RENAMED", "torque": "bad_adds:THREE", "zero": "bad_zero:x"})
LAYOUTS = {"gone": "nowhere.at:all", "three": "bad_adds:THREE", "inline": "bad_adds:lay"}
LAYOUTS.update(
    {
        name: f"bad_adds:{name}"
        for name in (
            "noannot",
            "untyped",
            "anything",
            "mess",
            "odd",
            "typed",
            "raises",
            "wrong",
            "lay",
        )
    }
)
EXPORTS = {"gone": "nowhere:x", "three": "bad_adds:THREE", "exudyn": "bad_adds:text"}
EXPORTS.update({name: f"bad_adds:{name}" for name in ("crash", "none", "lone", "two", "text")})


@pytest.fixture
def bad(
    tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> Iterator[None]:
    """A package `bad` all of whose entry points are broken, but one export."""
    folder = tmp_path_factory.mktemp("site")
    (folder / "bad_adds.py").write_text(MODULE, encoding="utf-8")
    (folder / "bad_zero.py").write_text("1/0", encoding="utf-8")
    facts = folder / "bad-1.0.dist-info"
    facts.mkdir()
    (facts / "METADATA").write_text("Metadata-Version: 2.1\nName: bad\nVersion: 1.0\n")
    groups = {"analyses": ANALYSES, "layouts": LAYOUTS, "exports": EXPORTS}
    lines = [
        f"[crankstar.{group}]\n" + "".join(f"{name} = {path}\n" for name, path in entries.items())
        for group, entries in groups.items()
    ]
    (facts / "entry_points.txt").write_text("\n".join(lines), encoding="utf-8")
    monkeypatch.syspath_prepend(folder)
    caches: list[Any] = [registry.names, registry.analysis, registry.measures]
    for cache in caches:
        cache.cache_clear()
    for added in (registry.added(), layouts.LAYOUTS._others, ADDED):
        for name, value in (("_entries", None), ("_found", {}), ("_told", set())):
            monkeypatch.setattr(added, name, value)
    yield
    for cache in caches:
        cache.cache_clear()
    for name in ANALYSES:
        if name not in registry.NAMES and application.VERBS.pop(name, None):
            del application.app[name]
    for module in ("bad_adds", "bad_zero"):
        sys.modules.pop(module, None)


def lines_of(text: str, kind: str) -> dict[str, int]:
    """How often each name of a kind of entry point is told of."""
    told = [line for line in text.splitlines() if line.startswith(f"package bad: its {kind} ")]
    names = [line.split(f"its {kind} ")[1].split()[0] for line in told]
    return {name: names.count(name) for name in names}


@pytest.mark.usefixtures("bad")
def test_a_broken_analysis_is_skipped_with_one_line(run: Run) -> None:
    done = run("verdict", "i4")
    assert done.code == 0
    assert lines_of(done.err, "analysis") == dict.fromkeys(ANALYSES, 1)
    why = "package bad: its analysis a cannot be loaded (No module named 'nowhere')"
    assert why in done.err.splitlines()
    assert (
        "analysis zero cannot be loaded (ZeroDivisionError: division by zero, bad_zero.py:1)"
        in done.err
    )
    again = run("--help")
    assert (again.code, again.err) == (0, "")  # told in this process already
    assert "nowhere" not in again.out
    for words in (["a", "i4"], ["a", "--help"]):
        refused = run(*words)
        assert (refused.code, refused.err) == (2, f"crankstar: {why}\n")


@pytest.mark.usefixtures("bad")
def test_python_warns_of_a_broken_analysis_and_has_no_function_of_it() -> None:
    with pytest.warns(PackageWarning, match="its analysis torque is left out"):
        assert not hasattr(crankstar, "a")
    with pytest.raises(AttributeError, match="package bad: its analysis a cannot be loaded"):
        _function = crankstar.a
    assert "a" not in dir(crankstar)
    with pytest.warns(PackageWarning) as told:
        names = [record.name for record in registry.analyses()]
    assert names == [*registry.NAMES]
    assert len(told) == len(ANALYSES) - 1
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert len([*registry.analyses()]) == len(names)


SHORT = """name = "p"
speed = "1000 rpm"
[cylinder]
stroke = "80 mm"
rod_length = "140 mm"
reciprocating_mass = "500 g"
[layout]
type = "KIND"
"""


@pytest.mark.usefixtures("bad")
@pytest.mark.parametrize(
    ("kind", "why"),
    [
        ("gone", "its layout gone cannot be loaded (No module named 'nowhere')"),
        ("three", "its layout three cannot be loaded (a layout is a function (basis,"),
        ("noannot", "its layout noannot cannot be loaded (a layout is a function (basis,"),
        ("untyped", "its layout untyped cannot be loaded (a layout is a function (basis,"),
        ("anything", "its layout anything cannot be loaded (a layout is a function (basis,"),
        ("mess", "its layout mess cannot be loaded (a layout is a function (basis,"),
        ("odd", "its layout odd cannot be loaded ("),
        ("typed", "its layout typed cannot be loaded ("),
        ("raises", "its layout raises ends with an error (RuntimeError: boom ?[31m, bad_adds.py:"),
        ("wrong", 'its layout wrong gives "nope", where a layout gives an Engine'),
        ("lay", "its layout lay gives None, where a layout gives an Engine"),
    ],
)
def test_a_broken_layout_is_one_mistake_of_the_file_that_names_it(
    kind: str, why: str, run: Run, tmp_path: Path
) -> None:
    (tmp_path / "p.toml").write_text(SHORT.replace("KIND", kind), encoding="utf-8")
    refused = run("analyze", "p.toml")
    assert refused.code == 2
    assert "p.toml: 1 mistake\n" in refused.err
    assert f"layout.type: package bad: {why}" in refused.err
    assert set(lines_of(refused.err, "layout")) == {"inline"}


@pytest.mark.usefixtures("bad")
def test_the_schema_skips_broken_layouts_and_names_ours_once(run: Run) -> None:
    done = run("schema")
    assert done.code == 0
    usable = {"raises", "wrong", "lay"}
    assert lines_of(done.err, "layout") == dict.fromkeys(LAYOUTS.keys() - usable, 1)
    assert "its layout inline is left out, since that name is taken" in done.err
    names = [*layouts.LAYOUTS]
    assert sorted(names) == sorted({*layouts.Layouts._own, *usable})
    assert len(layouts.LAYOUTS) == len(names)


@pytest.mark.usefixtures("bad")
@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("gone", "cannot be loaded (No module named 'nowhere')"),
        ("three", "cannot be loaded (an export is a function (engine) of an Engine"),
        ("two", "cannot be loaded (an export is a function (engine) of an Engine"),
        ("crash", "ends with an error (RuntimeError: boom ?[31m, bad_adds.py:"),
        ("none", "gives None, where an export gives text or bytes"),
        ("lone", "ends with an error (UnicodeEncodeError: "),
    ],
)
def test_a_broken_export_is_refused_with_its_package(
    name: str, why: str, run: Run, tmp_path: Path
) -> None:
    refused = run("export", "i4", "--to", name, "-o", "x.txt")
    assert refused.code == 2
    assert f"crankstar: package bad: its export {name} {why}" in refused.err
    assert not (tmp_path / "x.txt").exists()


@pytest.mark.usefixtures("bad")
def test_a_good_export_beside_broken_ones_is_written_and_names_are_listed_once(
    run: Run, tmp_path: Path
) -> None:
    done = run("export", "i4", "--to", "text", "-o", "x.txt")
    assert (tmp_path / "x.txt").read_text(encoding="utf-8") == crankstar.load("i4").name
    assert lines_of(done.err, "export") == {"exudyn": 1}
    refused = run("export", "i4", "--to", "nothing", "-o", "x.txt")
    assert lines_of(refused.err, "export") == {"gone": 1, "three": 1, "two": 1}
    listed = ["exudyn", *exporting.PROGRAMS, "crash", "lone", "none", "text"]
    assert f"choose from {', '.join(listed)}\n" in refused.err


def test_of_two_packages_with_one_name_the_first_is_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    from importlib.metadata import EntryPoint, EntryPoints

    points = EntryPoints([EntryPoint("x", f"math:{name}", "g") for name in ("pi", "tau")])
    monkeypatch.setattr("importlib.metadata.entry_points", lambda **_group: points)
    added = Added("g", "layout", [], lambda found, _words: found)
    with pytest.warns(PackageWarning, match="its layout x is left out"):
        assert added.names() == ("x",)
    assert added["x"] == pytest.approx(3.141592653589793)
    failing = Added("g", "layout", [], lambda found, _words: {}[found])
    with pytest.warns(PackageWarning), pytest.raises(PackageError, match="KeyError"):
        failing["x"]


ASKED = """
from dataclasses import dataclass
from typing import Annotated
from crankstar.options import readers

@dataclass(frozen=True)
class Question:
    whole: Annotated[bool, readers.flag("--whole-thing"OWN)] = False
"""


@pytest.mark.parametrize("own", ["", ', own="All of it."'])
def test_an_option_that_no_command_has_needs_what_it_means(
    own: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without, the analysis cannot be loaded, and is left out with a line."""
    (tmp_path / "bad_asked.py").write_text(ASKED.replace("OWN", own), encoding="utf-8")
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.delitem(sys.modules, "bad_asked", raising=False)
    record = replace(
        registry.analysis("torque"), name="asked", question=Later("bad_asked:Question")
    )
    if own:
        assert registry._checked(record, {"name": "asked"}) is record
        assert meaning_of(asked(record.question.value)[0]) == "All of it."
        return
    with pytest.raises(MessageError, match="--whole-thing is none of crankstar"):
        registry._checked(record, {"name": "asked"})
