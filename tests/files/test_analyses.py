"""Analyses are records: what they name is there, hosts go over them, other packages add some."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, fields, replace
from importlib.metadata import EntryPoint
from pathlib import Path
from typing import Annotated, Any

import pytest
from tests.commands import Run

from crankstar import charts
from crankstar.analysis import registry
from crankstar.analysis.assumptions import Answer
from crankstar.analysis.document import Column, Document, Table
from crankstar.analysis.reader import asked
from crankstar.analysis.record import Analysis, Chart, Later
from crankstar.charts import registry as drawn
from crankstar.cli import application
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import LAYOUTS
from crankstar.options import readers
from crankstar.options.vocabulary import OPTIONS
from crankstar.python.functions import function

PACKAGE = Path(registry.__file__).parents[1]
HOSTS = (
    "cli/analyses.py",
    "cli/command_lines.py",
    "report/analyses.py",
    "report/document.py",
    "analyses/verdict/facts.py",
    "tables/comparison.py",
    "tables/sweeps.py",
    "studies/sweep.py",
    "studies/sweep_answers.py",
    "studies/answers.py",
    "charts/registry.py",
)
"""Modules that go over all analyses and know none of them."""
QUANTITIES = ("torque", "bearings")
"""Analyses with the name of a quantity or a part."""


@pytest.mark.parametrize("record", [*registry.analyses()], ids=lambda record: record.name)
def test_all_that_a_record_names_is_there(record: Analysis) -> None:
    named = {field.name: getattr(record, field.name) for field in fields(record)}
    for name, value in named.items():
        if isinstance(value, Later):
            assert value.value is not None, name
    options = {one.reader.option for one in asked(record.question.value) if not one.reader.follows}
    assert options <= OPTIONS.keys()
    assert {figure.chart for figure in record.figures} <= charts.CHARTS.keys()
    names = {one.name for one in asked(record.question.value)}
    assert set(record.chains) <= names
    assert {name for one in asked(record.question.value) for name in one.reader.beside} <= names


@pytest.mark.parametrize("module", HOSTS)
def test_a_host_names_no_analysis(module: str) -> None:
    source = (PACKAGE / module).read_text(encoding="utf-8")
    others = [name for name in registry.names() if not module.startswith(f"analyses/{name}/")]
    named = [name for name in others if f"analyses.{name}" in source]
    named += [name for name in others if name not in QUANTITIES and f'"{name}"' in source]
    assert named == []


@dataclass(frozen=True)
class Question:
    """Of which speed, rad/s."""

    speed: Annotated[float | None, readers.SPEED] = None


def mean_piston_speed(engine: Engine, question: Question) -> float | None:
    """2 s n, m/s."""
    turning = engine.speed if question.speed is None else question.speed
    stroke = 2 * engine.throw(engine.first).radius
    return None if turning is None else stroke * turning / 3.141592653589793


def piston_document(engine: Engine, found: float | None, question: Question) -> Document:
    """One row."""
    del question
    column = Column("mean piston speed", "m/s", key="mean_piston_speed")
    return Document(engine.name, (Table("Pistons", (column,), ((found,),), key="pistons"),))


def nothing(engine: Engine, question: Question) -> Answer:
    """Rests on no figure."""
    del engine, question
    return Answer(figures=lambda _engine: {}, unit=lambda _quantity, _engine: "")


RECORD = Analysis(
    name="piston-speed",
    about="Mean piston speed.",
    takes="An engine.",
    doing="Computing ...",
    title="Pistons",
    example="i4",
    question=Later(f"{__name__}:Question"),
    compute=Later(f"{__name__}:mean_piston_speed"),
    document=Later(f"{__name__}:piston_document"),
    answer=Later(f"{__name__}:nothing"),
    lacks=lambda _engine, _speed: False,
)


@pytest.fixture
def added(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """One more analysis, as a package that is installed adds it."""
    point = EntryPoint("piston-speed", f"{__name__}:RECORD", registry.added().group)
    monkeypatch.setattr(registry.added(), "_entries", {"piston-speed": point})
    caches: list[Any] = [registry.names, registry.analysis, registry.measures]
    for cache in caches:
        cache.cache_clear()
    yield
    for cache in caches:
        cache.cache_clear()
    if application.VERBS.pop("piston-speed", None):
        del application.app["piston-speed"]


@pytest.mark.release
@pytest.mark.usefixtures("added")
def test_an_analysis_of_another_package_is_a_command_and_a_section_of_the_report(run: Run) -> None:
    found = json.loads(run("piston-speed", "audi-25-tfsi", "--speed", "6000 rpm", "--json").out)
    assert found["pistons"][0]["mean_piston_speed"] == pytest.approx(2 * 92.8e-3 * 100)
    assert "piston-speed" in run("--help").out
    refused = run("piston-speed", "audi-25-tfsi", "--speed", "quick")
    assert (refused.code, refused.err.count("\n")) == (2, 1)
    written = run("report", "audi-25-tfsi", "-o", "-").out
    assert "mean piston speed" in written


@pytest.mark.release
@pytest.mark.usefixtures("added")
def test_one_that_fails_is_named_with_its_package(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(_engine: Engine, _question: Question) -> float:
        raise ZeroDivisionError("division by zero")

    monkeypatch.setitem(RECORD.compute.__dict__, "value", fails)
    failed = run("piston-speed", "audi-25-tfsi")
    words = f"package {__name__}: its analysis piston-speed fails (ZeroDivisionError: division by"
    assert failed.code == 2
    assert words in failed.err
    assert words in run("report", "audi-25-tfsi", "-o", "-").err
    with pytest.raises(ZeroDivisionError):
        function("piston_speed")("audi-25-tfsi")


def failing(*_words: object, **_options: object) -> list[str]:
    """Of whatever it is asked."""
    raise ZeroDivisionError("division by zero")


FAILS = f"package {__name__}: its analysis piston-speed fails (ZeroDivisionError: division by zero"


@pytest.mark.usefixtures("added")
@pytest.mark.parametrize("part", ["facts", "compared"])
def test_one_that_fails_beside_others_is_told_and_left_out(
    part: str, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    with_part = replace(RECORD, **{part: Later(f"{__name__}:failing")})
    monkeypatch.setattr(registry.added(), "_found", {"piston-speed": with_part})
    monkeypatch.setattr(registry.added(), "_told", set())
    engines = ["audi-25-tfsi"] if part == "facts" else ["audi-25-tfsi", "i4"]
    done = run("verdict" if part == "facts" else "compare", *engines)
    assert done.code == 0, done.err
    assert done.err.count(FAILS) == 1
    assert "Traceback" not in done.err


@pytest.mark.usefixtures("added")
def test_one_whose_options_or_charts_fail_is_named_with_its_package(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    refusing = replace(RECORD, refuse=Later(f"{__name__}:failing"))
    monkeypatch.setattr(registry.added(), "_found", {"piston-speed": refusing})
    refused = run("piston-speed", "audi-25-tfsi")
    assert refused.code == 2
    assert refused.err.startswith(f"crankstar: {FAILS}, {Path(__file__).name}:")
    assert refused.err.count("\n") == 1
    chart = Chart("pistons", f"{__name__}:failing", "the pistons")
    monkeypatch.setitem(charts.CHARTS, "pistons", chart)
    monkeypatch.setitem(drawn._ANALYSES, "pistons", "piston-speed")
    refused = run("plot", "audi-25-tfsi", "pistons", "-o", "-")
    assert refused.code == 2
    assert refused.err.startswith(f"crankstar: {FAILS}, {Path(__file__).name}:")
    assert refused.err.count("\n") == 1


def test_a_layout_of_a_package_has_no_template(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    point = EntryPoint("helix", "crankstar.engine.layouts:inline", "crankstar.layouts")
    monkeypatch.setattr(LAYOUTS._others, "_entries", {"helix": point})
    monkeypatch.setattr(LAYOUTS._others, "_found", {})
    refused = run("new", "helix")
    assert "a package adds this layout, which has no template" in refused.err
    assert "choose from inline" in run("new", "helic").err


def test_what_does_not_go_together_is_refused_next_to_what_cannot_be_read(
    run: Run, tmp_path: Path
) -> None:
    words = {
        "--speed": "quick",
        "--phase-error": "3 deg",
        "--save": str(tmp_path / "new.toml"),
        "--orders": "99",
    }
    refused = run("marine", "audi-25-tfsi", *(word for pair in words.items() for word in pair))
    assert refused.code == 2
    assert [option for option in words if option not in refused.err] == []
    assert not (tmp_path / "new.toml").exists()
