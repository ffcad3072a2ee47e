"""The documents are true: screens, Python examples, engine files, tables, links, figures.

That the pages build is checked by `make docs`, strictly.
"""

from __future__ import annotations

import ast
import doctest
import io
import json
import os
import re
import shlex
import sys
import tomllib
from contextlib import redirect_stderr, redirect_stdout, suppress
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import get_args
from xml.etree import ElementTree

import numpy as np
import pytest
from markdown import Markdown
from tests.scripts import script

import crankstar
from crankstar import cli
from crankstar.derive.expansion import cosine_coefficients, place_coefficients, root_coefficients
from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import LAYOUTS
from crankstar.engine.quantities import ANGLE, LENGTH, POSITION, SPEED, Quantity
from crankstar.engine.records import Record
from crankstar.engine.torsion import Chain
from crankstar.files import EngineFileError, engine_of, units
from crankstar.files.chains import chain_of, is_chain
from crankstar.files.forms import by_key, record_in, short_form
from crankstar.language import glossary
from crankstar.language.faults import ValueFaultError
from crankstar.mechanics.balance import Grouping

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
FRAME = ROOT / "src" / "crankstar" / "report" / "frame.svg"


screens, hooks, doctests = script("screens"), script("hooks"), script("doctests")
mathematics, tables = script("mathematics"), script("tables")
PAGES: list[Path] = screens.pages()
EVERY_PAGE = pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
FULL_OF_SCREENS = {"analyse.md", "command-line.md", "gears.md", "inline-six.md"}
WRONG_ON_PURPOSE = {"mistakes.toml", "wrong-side.toml"}


def text_of(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


def fences(page: Path, kind: str) -> list[str]:
    return re.findall(
        rf"^```{kind}[^\n]*\n(.*?)^```$", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL
    )


def printed(command: str, folder: Path) -> str:
    """The output of a command: a plain crankstar line in this process, any other in a shell.

    In this process nothing has to be imported again.
    """
    own, pipe, rest = command.partition(" | ")
    name, *words = [command] if re.search(r"[|<>&;$*?~`]", own) else shlex.split(own)
    if name != "crankstar":
        return screens.shown(command, folder)
    out = io.StringIO()
    beside = io.StringIO() if pipe else out
    with (
        pytest.MonkeyPatch.context() as patch,
        redirect_stdout(out),
        redirect_stderr(beside),
        suppress(SystemExit),
    ):
        patch.chdir(folder)
        patch.setenv("HOME", str(folder))
        patch.setenv("COLUMNS", screens.WIDTH)
        cli.main(words)
    if pipe:  # what is said of files does not go through it
        (folder / ".screen").write_text(out.getvalue(), encoding="utf-8")
        return beside.getvalue() + screens.shown(f"cat .screen | {rest}", folder)
    return screens.trimmed(out.getvalue())


@pytest.mark.many(first=10)
@pytest.mark.parametrize(
    "page",
    [
        pytest.param(page, marks=[pytest.mark.release] * (page.name in FULL_OF_SCREENS))
        for page in PAGES
    ],
    ids=lambda page: page.name,
)
def test_every_screen_is_what_the_command_prints(page: Path) -> None:
    """If this fails: is the program or the page wrong? `docs/build/screens.py` updates pages."""
    written = page.read_text(encoding="utf-8")
    assert screens.alike(screens.up_to_date(written, printed)) == screens.alike(written)


@EVERY_PAGE
def test_screens_fit_the_column_of_their_page(page: Path) -> None:
    """Data are written as they are: CSV, JSON, engine files."""
    for screen in fences(page, "console"):
        command = ""
        for line in screen.splitlines():
            command = line if line.startswith("$ ") else command
            if not re.search(r"--csv|--json|schema|--explicit|crankstar new", command):
                assert line.startswith("$ ") or len(line) <= int(screens.WIDTH), command


@pytest.mark.many(first=3)
@EVERY_PAGE
def test_every_python_example_prints_what_it_says(
    page: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(Path(sys.executable).parent) + os.pathsep + os.environ["PATH"])
    assert not [block for block in fences(page, "python") if ">>>" in block], "a pycon block"
    examples = "\n".join(fences(page, "pycon"))
    test = doctest.DocTestParser().get_doctest(examples, {}, page.name, str(page), 0)
    said: list[str] = []
    doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test, out=said.append)
    assert "".join(said) == ""


QUESTION = re.compile(r"^## (How do I [^\n]+\?)$\n(.*?)(?=^## |\Z)", re.MULTILINE | re.DOTALL)


def test_questions_are_asked_once_and_answered_with_something_that_runs() -> None:
    asked: list[str] = []
    for page in sorted((DOCS / "how-to").glob("*.md")):
        for question, answer in QUESTION.findall(page.read_text(encoding="utf-8")):
            asked.append(question)
            assert re.search(r"^```(?:console|pycon|html)$", answer, re.MULTILINE), question
    assert len(asked) == len(set(asked)) >= 25


@pytest.mark.parametrize(
    "page",
    [
        page
        for page in PAGES
        if page.parent.name == "tutorials" or "## How do I" in page.read_text("utf-8")
    ],
    ids=lambda page: page.name,
)
def test_no_command_of_a_lesson_or_an_answer_fails(page: Path) -> None:
    for screen in fences(page, "console"):
        assert not re.search(r"^crankstar: |^See: crankstar|Traceback", screen, re.MULTILINE)


def test_readme_has_python_and_a_screen() -> None:
    readme = ROOT / "README.md"
    assert (
        6
        <= sum(
            line.startswith(">>>")
            for block in fences(readme, "pycon")
            for line in block.splitlines()
        )
        <= 12
    )
    assert any("crankstar analyze v8-flat-plane" in block for block in fences(readme, "console"))


@EVERY_PAGE
def test_every_engine_file_in_the_documents_loads(page: Path) -> None:
    named = dict(screens.FILE.findall(page.read_text(encoding="utf-8")))
    for name, content in named.items():
        if is_chain(tomllib.loads(content)):
            assert chain_of(tomllib.loads(content), name=name).discs
            continue
        if name not in WRONG_ON_PURPOSE:
            assert isinstance(engine_of(tomllib.loads(content), name=name), Engine)
            continue
        with pytest.raises(EngineFileError):
            engine_of(tomllib.loads(content), name=name)


def test_the_part_of_a_file_that_shows_provenance_fits_a_file() -> None:
    (part,) = [
        block
        for block in fences(DOCS / "reference" / "engine-files.md", "toml")
        if block.startswith("[provenance]")
    ]
    whole = tomllib.loads(
        dict(screens.FILE.findall(text_of("docs/reference/engine-files.md")))["my-v8.toml"] + part
    )
    assert engine_of(whole).provenance["cylinder.bore"].status == "published"


def records(start: type[Record]) -> set[type[Record]]:
    """A record and all that can stand in it."""
    inner = {record_in(info.annotation) for info in by_key(start).values()} - {None, start}
    return {start}.union(*(records(record) for record in inner if record is not None))


def every_record() -> set[type[Record]]:
    kinds = [Engine, Chain, *map(short_form, LAYOUTS)]
    whole = set().union(*(records(kind) for kind in kinds))
    return {record for record in whole if record not in map(short_form, LAYOUTS)} | {
        short_form(None)
    }


def test_every_table_of_an_engine_file_has_its_keys_on_the_page() -> None:
    shown = {
        hooks.TABLES[name]
        for kind, name in hooks.MARK.findall(text_of("docs/reference/engine-files.md"))
        if kind == "keys"
    }
    assert shown == every_record()


@pytest.mark.parametrize("name", hooks.TABLES)
def test_every_key_is_there_with_value_default_and_meaning(name: str) -> None:
    rows = [row.strip("| ").split(" | ") for row in hooks.table(name).splitlines()[2:]]
    assert sorted(row[0].strip("`") for row in rows) == sorted(by_key(hooks.TABLES[name]))
    assert all(len(row) == 4 and all(cell.strip() for cell in row) for row in rows)


def test_every_unit_on_the_page_is_understood() -> None:
    marks = {
        "length": LENGTH,
        "mass": Quantity("mass", "650 g"),
        "angle": ANGLE,
        "rotational speed": SPEED,
        "unbalance": Quantity("unbalance", "0.02 kg*m"),
        "moment of inertia": Quantity("moment of inertia", "0.002 kg*m^2"),
    }
    rows = re.findall(
        r"^\| ([\w ]+) \| (`[^|]+) \|$",
        text_of("docs/reference/engine-files.md").split("## Values and units")[1],
        re.MULTILINE,
    )
    listed = {kind: re.findall(r"`([^`]+)`", names) for kind, names in rows if kind in marks}
    assert set(listed) == set(marks)
    for kind, names in listed.items():
        assert all(units.si(f"1 {unit}", marks[kind]) > 0 for unit in names)
    assert units.si("1 µm", LENGTH) == pytest.approx(1e-6)
    assert units.si("90°", ANGLE) == pytest.approx(units.si("90 deg", ANGLE))
    assert units.si("2 g·mm", marks["unbalance"]) == pytest.approx(2e-6)
    assert units.si("2 kg·m²", marks["moment of inertia"]) == pytest.approx(2.0)


@pytest.mark.parametrize("bare", [82.5, -90.0])
def test_a_bare_number_nobody_can_have_meant_is_refused(bare: float) -> None:
    for mark in (LENGTH, ANGLE, POSITION, SPEED):
        with pytest.raises(ValueFaultError) as error:
            units.si(bare, mark)
        assert error.value.code in ("unit.missing", "unit.implausible")


@pytest.mark.many(first=3)
@EVERY_PAGE
def test_what_the_program_makes_is_in_the_text_as_it_is_now(page: Path) -> None:
    """If this fails: `python docs/build/tables.py` updates pages."""
    if page.is_relative_to(DOCS):
        written = page.read_text(encoding="utf-8")
        place = page.relative_to(DOCS).as_posix()
        assert tables.up_to_date(written, place) == written


@EVERY_PAGE
def test_no_page_is_empty_where_the_program_fills_it(page: Path) -> None:
    """On a code host the text has tables where the built page has them."""
    for mark in hooks.MARK.finditer(page.read_text(encoding="utf-8")):
        lines = [line for line in mark[0].splitlines()[1:-1] if line.strip()]
        assert lines, mark[0]
        assert not any(re.search(r"<(?:svg|math|figure|div)\b", line) for line in lines)


NO_TERMS = {
    *("", "engine", "engines", "unverified", "unverified values", "part", "name", "row", "cranks"),
    *("quantity", "unit", "before", "now", "removes", "left", "order"),
    *("value", "typical", "low", "high", "source", "estimated", "moves_with", "estimated values"),
    *("{quantity}, order {order}", "force, resultant", "couple, resultant", "cylinders"),
    "all orders together at these crank angles",
    *("shafts, throws and weights", "turning vectors", "main bearings by order", "crankshaft"),
    *("number", "place", "share", "speed_rpm", "file_speed_rpm", "{engine}, of the first"),
    *("order {order}", "amplitude", "result", "alike", "torque by order"),
    *("each cylinder", "cylinders {numbers}", "moves", "whole", "measured"),
    *("theta_deg", "mean", "least", "forward", "backward"),
    *("{quantity} forward", "{quantity} backward"),
    *("crank angle", "after firing", "other side", "pa", "even speed", "uneven speed"),
    "imep {pressure}",
    *("forces that the uneven speed changes", "torque of gas and inertia", "exhaust pulses"),
    *("torque by order, gas at {pressure}", "rolling moment on the block"),
    *("diameter", "inertia", "masses", "response", "at speed", "where", "from", "to", "heat"),
    *("journal", "mean load", "pressed most at", "pressed least at"),
    *("greatest pressure", "mean pressure", "least film", "eccentricity"),
    *(
        "free end",
        "torque in {shaft}",
        "sum of amplitudes",
        "sum of amplitudes there",
        "by order at this speed",
    ),
    *("strongest order", "its mode", "pendulums", "pendulum on", "count", "mass of one", "length"),
    *("family", "chosen", "of order", "power", "place along the crankshaft"),
    *("force, vertical", "force, horizontal", "one engine", "all in phase", "rms over all phases"),
    "exceeded {share} % of the time",
    *("radius of the pivot", "holds back order", "along", "status", "point", "of the file"),
    *("best found", "up, right, along"),
    *("what goes where", "what is left", "what changes", "what to add", "add at", "at most"),
    *("line", "direction", "size", "difference", "of that before", "parts", "matched"),
}
"""Headings that are plain words."""


def headings() -> set[str]:
    """The headings of all tables of the program, as they stand in the source."""
    out: set[str] = set()
    for path in (ROOT / "src" / "crankstar" / "tables").glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            named = isinstance(node, ast.Call) and getattr(node.func, "id", "")
            if isinstance(node, ast.Call) and named in ("Column", "Table") and node.args:
                inner = [part for part in ast.walk(node.args[0]) if isinstance(part, ast.Constant)]
                out |= {str(part.value).lower() for part in inner if isinstance(part.value, str)}
    return out


@pytest.mark.release
def test_every_heading_of_a_table_is_in_the_glossary() -> None:
    known = {word.lower() for term in glossary.terms() for word in (term.term, *term.also)}
    assert {"aₖ", "rolling moment", "balance shafts"} <= headings()
    assert headings() - known - NO_TERMS == set()


def test_every_term_has_its_names_in_three_languages_once() -> None:
    names = [term.term for term in glossary.terms()]
    assert len(names) == len(set(names)) >= 70
    for term in glossary.terms():
        assert len({*term.meanings.values()}) == 3, term.term
        assert re.search(r"[\u3040-\u30ff\u4e00-\u9fff]", term.japanese), term.term
        assert re.search(r"[\u0400-\u04ff]", term.russian), term.term
        assert not any(meaning.endswith((".", "。")) for meaning in term.meanings.values())


def test_the_words_of_the_design_are_in_the_glossary() -> None:
    wanted = ("二次", "ピッチング", "バランスシャフト", "すりこ木運動", "コンロッド長", "点火順序")
    said = "".join(term.japanese for term in glossary.terms()).replace("バランサー", "バランス")
    assert all(word in said for word in wanted)


@pytest.mark.release
def test_the_page_of_commands_has_every_option_of_every_command() -> None:
    page = text_of("docs/reference/commands.md")
    for name in cli.app:
        if name.startswith("-"):
            continue
        section = page.partition(f"\n## {name}\n")[2].partition("\n## ")[0]
        arguments = cli.app[name].assemble_argument_collection()
        for argument in arguments:
            for option in argument.names:
                assert option == "*" or f"`{option}`" in section, (name, option)


@cache
def anchors(page: Path) -> set[str]:
    """The places in a page that a link can go to: its headings, and names given by hand."""
    written = page.read_text(encoding="utf-8")
    prose = re.sub(r"^```.*?^```$", "", written, flags=re.MULTILINE | re.DOTALL)
    headings = re.findall(r"^#+ (.+)$", prose, re.MULTILINE)
    slugs = {
        re.sub(r"[\s-]+", "-", re.sub(r"[^\w\s-]", "", heading).strip().lower())
        for heading in headings
    }
    return slugs | set(re.findall(r'<a id="([\w-]+)">', prose))


def test_the_page_of_json_has_every_key_of_an_answer_and_no_other() -> None:
    """Of `analyze` and `strokes`, whose tables name the keys of their objects."""
    page = text_of("docs/reference/json.md")
    for title, words in (
        ("# Machine", ["analyze", "i4"]),
        ("## Strokes", ["strokes", "triumph-675"]),
    ):
        section = page.partition(title)[2].partition("\n## ")[0]
        rows = re.findall(r"^\| (`[^|]+`) \|", section, re.MULTILINE)
        named = {key for row in rows for key in re.findall(r"`(\w+)`", row)}
        out = io.StringIO()
        with redirect_stdout(out), suppress(SystemExit):
            cli.main([*words, "--json"])
        answer = json.loads(out.getvalue())
        keys = answer.keys() | answer.get("orders", [{}])[0].keys()
        assert keys - {"format", "engine"} <= named, title
        assert named <= keys | {"format", "engine"}, title


@EVERY_PAGE
def test_every_link_between_documents_goes_somewhere(page: Path) -> None:
    for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text(encoding="utf-8")):
        if "://" in target:
            continue
        path, _, place = target.partition("#")
        there = (page.parent / path) if path else page
        assert there.exists(), target
        assert not place or place in anchors(there), target


def test_every_page_is_in_the_table_of_contents() -> None:
    listed = re.findall(r"^ +- .+: ([\w/-]+\.md)$", text_of("mkdocs.yml"), re.MULTILINE)
    assert sorted(listed) == sorted(
        page.relative_to(DOCS).as_posix() for page in DOCS.rglob("*.md")
    )


def test_every_source_cited_is_in_the_bibliography() -> None:
    known = set(hooks.entries(text_of("docs/reference/references.bib")))
    cited = {
        key
        for page in PAGES
        for key in re.findall(
            r"@([\w-]+)", "".join(hooks.CITATION.findall(page.read_text("utf-8")))
        )
    }
    assert cited <= known
    assert len(known) == text_of("docs/reference/references.bib").count("\n@")


@pytest.mark.parametrize(
    "page", [ROOT / "README.md", DOCS / "reference" / "command-line.md"], ids=lambda page: page.name
)
def test_the_table_of_commands_names_every_command(page: Path) -> None:
    rows = re.findall(r"^\| `crankstar (\w+)", page.read_text(encoding="utf-8"), re.MULTILINE)
    assert sorted(rows) == sorted(name for name in cli.app if not name.startswith("-"))


def test_the_page_of_the_command_line_names_every_option_of_analyze() -> None:
    arguments = cli.app["analyze"].assemble_argument_collection()
    options = {name for argument in arguments for name in argument.names if name.startswith("--")}
    page = text_of("docs/reference/command-line.md")
    assert {name for name in options - {"--output"} if name not in page} == set()
    assert all(f"`{kind}`" in page or f"--by {kind}" in page for kind in get_args(Grouping))


def terms(series: str) -> dict[int, Fraction]:
    """The powers of lambda in a series as the page writes it in LaTeX, and their factors."""
    out: dict[int, Fraction] = {}
    overall = -1 if series.startswith(r"-\left(") else 1
    for sign, factor, power, below, alone in re.findall(
        r"([-+]?) ?(?:\\frac\{(\d*) ?\\lambda\^?(\d*)\}\{(\d+)\}|(\\lambda))",
        series.removeprefix(r"-\left("),
    ):
        value = Fraction(1) if alone else Fraction(int(factor or 1), int(below))
        out[int(power or 1)] = value * overall * (-1 if sign == "-" else 1)
    return out


def test_the_series_on_the_page_of_theory_is_the_exact_one() -> None:
    rows = dict(
        re.findall(
            r"^\| (\d) \| \$(.*lambda.*)\$ \|$", text_of("docs/explanation/theory.md"), re.MULTILINE
        )
    )
    assert sorted(rows) == ["2", "4", "6", "8"]
    for order, series in rows.items():
        exact = {power: motion.series_coefficient(int(order), power) for power in range(8)}
        assert terms(series) == {power: value for power, value in exact.items() if value}


def test_the_steps_before_the_series_are_the_exact_ones() -> None:
    """The root, the powers of the sine, and x_2 of the page, against the derivation's numbers."""
    page = text_of("docs/explanation/theory.md")
    root = re.findall(r"- \\frac\{(\d*) ?u\^?(\d*)\}\{(\d+)\}", page)
    written = {int(n or 1): -Fraction(int(above or 1), int(below)) for above, n, below in root}
    assert written == dict(enumerate(root_coefficients(4)[1:], 1))
    for half in range(1, 5):
        (above, below) = re.findall(
            rf"\\sin\^{2 * half}\\psi &= \\frac\{{(.*?)\}}\{{(\d+)\}}", page
        )[0]
        cosines = {0: Fraction(int(above.split()[0]), int(below))}
        for sign, size, angle in re.findall(r"([-+]) (\d*) ?\\cos (\d)\\psi", above):
            value = Fraction(int(size or 1), int(below))
            cosines[int(angle) // 2] = -value if sign == "-" else value
        assert cosines == dict(enumerate(cosine_coefficients(half)))
    x2 = page[page.index("\nx_2 = ") :].partition("```")[0].rpartition("=")[2]
    assert terms(x2) == dict(place_coefficients(2, 3))


def test_the_numbers_on_the_page_of_theory_are_so() -> None:
    at_four = np.real(motion.piston_harmonics(crank_radius=1, rod_length=4))
    assert [f"{at_four[k]:.2g}" for k in (4, 6)] == ["-0.0041", "7.4e-05"]
    assert all(0.016 < abs(at_four[k + 2] / at_four[k]) < 0.0185 for k in (2, 4, 6, 8))
    assert 1 - 0.25 / at_four[2] == pytest.approx(0.016, abs=5e-4)
    at_three = motion.piston_harmonics(crank_radius=1, rod_length=3)[2].real
    assert 1 - float(motion.series(2, ratio=1 / 3)) / at_three == pytest.approx(7e-6, rel=0.05)


def test_the_figure_can_be_read_by_those_who_do_not_see_it() -> None:
    drawing = ElementTree.parse(FRAME).getroot()  # noqa: S314 - our own
    space = "{http://www.w3.org/2000/svg}"
    assert drawing.get("role") == "img"
    labels = (drawing.get("aria-labelledby") or "").split()
    assert labels == [
        part.get("id")
        for part in (drawing.find(f"{space}title"), drawing.find(f"{space}desc"))
        if part is not None
    ]
    assert "report/frame.svg" in text_of("docs/explanation/conventions.md")


@EVERY_PAGE
def test_every_formula_becomes_mathematics(page: Path) -> None:
    """Each is set alone, and the page has as many `math` elements as formulas, none in error."""
    written = page.read_text(encoding="utf-8")
    formulas = mathematics.formulas(written)
    for formula in formulas:
        root = ElementTree.fromstring(mathematics.mathml(formula))  # noqa: S314 - our own
        tags = {node.tag.rpartition("}")[2] for node in root.iter()}
        assert "merror" not in tags, formula
        assert not any("\\" in (node.text or "") for node in root.iter()), formula
        for node in root.iter():
            parts = {"mfrac": 2, "msup": 2, "msub": 2, "msubsup": 3, "mover": 2}
            tag = node.tag.rpartition("}")[2]
            assert len(node) == parts.get(tag, len(node)), formula
    fence = {"name": "math", "class": "math", "format": mathematics.fence}
    html = Markdown(
        extensions=["tables", "md_in_html", "pymdownx.superfences", mathematics.Mathematics()],
        extension_configs={"pymdownx.superfences": {"custom_fences": [fence]}},
    ).convert(written)
    assert html.count("<math ") == len(formulas)
    assert not re.search(r"\$[^$<]*\\", re.sub(r"<(pre|code).*?</\1>", "", html, flags=re.DOTALL))


@pytest.mark.parametrize("formula", [r"\nosuchthing x", r"\frac{1", r"x^"])
def test_a_formula_that_cannot_be_set_stops_the_build(formula: str) -> None:
    with pytest.raises(mathematics.MathematicsError):
        mathematics.mathml(formula)


def test_no_law_of_the_theory_is_left_as_code() -> None:
    for name in ("theory", "conventions", "derivations"):
        blocks = fences(DOCS / "explanation" / f"{name}.md", "text")
        assert not any("=" in block or "exp(" in block for block in blocks), name


def test_nothing_on_a_page_comes_from_another_place() -> None:
    """The pages can be read without a network: no fonts, scripts or pictures from elsewhere."""
    assert "font: false" in text_of("mkdocs.yml")
    assert "extra_javascript" not in text_of("mkdocs.yml")
    for path in (*PAGES, FRAME, DOCS / "stylesheets" / "extra.css"):
        written = path.read_text(encoding="utf-8")
        assert not re.search(
            r'!\[[^\]]*\]\(\w+://|(?:src|xlink:href)="\w+://|url\(["\']?\w+://|@import', written
        )


def test_the_version_is_the_same_everywhere() -> None:
    assert tomllib.loads(text_of("pyproject.toml"))["project"]["version"] == crankstar.__version__
    assert f"\nversion: {crankstar.__version__}\n" in text_of("CITATION.cff")
    assert f"## [{crankstar.__version__}]" in text_of("CHANGELOG.md")


def test_every_command_of_make_that_is_promised_is_there() -> None:
    targets = set(re.findall(r"^([\w-]+):", text_of("Makefile"), re.MULTILINE))
    promised = {
        name
        for page in PAGES
        for name in re.findall(r"\bmake ([a-z-]+)\b", page.read_text("utf-8"))
    }
    assert {
        name
        for name in promised
        if name in ("demo", "quick", "test", "release", "docs", "bench", "lint")
    } <= targets


def test_doctests_of_docstrings_become_blocks() -> None:
    shown = doctests.fenced("A sentence.\n\n>>> 1 + 1\n2\n\nAnother.")
    assert shown == "A sentence.\n\n```pycon\n>>> 1 + 1\n2\n```\n\nAnother."


def test_the_answer_of_make_demo_is_of_an_engine_in_the_catalog() -> None:
    used = re.findall(
        r"^\t@\$\(BIN\)/crankstar (?:analyze|show) ([\w-]+)", text_of("Makefile"), re.MULTILINE
    )
    assert used
    assert set(used) <= set(crankstar.names())


@pytest.mark.release
def test_screens_reports_what_a_command_complains_of(tmp_path: Path) -> None:
    assert screens.shown("crankstar check nothing.toml; echo $?", tmp_path).splitlines()[-1] == "2"


def test_the_first_page_leads_to_the_gallery_where_it_is_built(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    first = text_of("docs/index.md")
    monkeypatch.delenv("CRANKSTAR_GALLERY", raising=False)
    assert "engines/index.html" not in hooks.filled(first)
    monkeypatch.setenv("CRANKSTAR_GALLERY", "engines")
    assert '<a href="engines/index.html">' in hooks.filled(first)
