"""Files that broke the program, data that was lost: each input that was found, and its kind."""

from __future__ import annotations

import asyncio
import json
import os
import subprocess
import sys
import tomllib
import zipfile
from cmath import rect
from collections.abc import Callable
from math import radians
from pathlib import Path

import openpyxl
import pytest
from tests.commands import Run, csv_rows

from crankstar.engine.engine import Engine
from crankstar.engine.gas import Trace
from crankstar.engine.provenance import Provenance
from crankstar.files import EngineFileError, read_file, tree_of
from crankstar.files.estimate import estimated
from crankstar.files.read import engine_of
from crankstar.mechanics.gas import cycle
from crankstar.server.watching import Watched

CASES = Path(__file__).parents[1] / "cases"
Refused = Callable[..., str]


def codes_of(path: Path) -> list[str]:
    with pytest.raises(EngineFileError) as caught:
        read_file(path)
    return [fault.code for fault in caught.value.faults]


def test_a_spreadsheet_damaged_anywhere_is_one_sentence(tmp_path: Path) -> None:
    assert codes_of(CASES / "damaged.xlsx") == ["file.not-spreadsheet"]
    raw = (CASES / "damaged.xlsx").read_bytes()
    with zipfile.ZipFile(CASES / "damaged.xlsx") as packed:
        places = [entry.header_offset + 60 for entry in packed.infolist()]
    for number, place in enumerate(places):
        path = tmp_path / f"{number}.xlsx"
        path.write_bytes(raw[:place] + bytes(40) + raw[place + 40 :])
        assert codes_of(path) == ["file.not-spreadsheet"]


def test_a_watched_file_is_followed_after_whatever_was_in_it(tmp_path: Path) -> None:
    path, looks = tmp_path / "mine.toml", 0
    path.write_text("a = 1")

    def tree() -> dict[str, object]:
        if path.read_text() == "broken":
            raise ZeroDivisionError
        return dict(tree_of(path.read_text()))

    watched = Watched(path, tree(), tree)

    async def followed() -> None:
        nonlocal looks
        path.write_text("broken")
        watching = asyncio.create_task(watched.watch())
        while watched.version == 1:
            await asyncio.sleep(0.05)
            looks += 1
            if looks == 10:
                path.write_text("b = 22")
        watching.cancel()

    asyncio.run(asyncio.wait_for(followed(), 20))
    assert watched.tree == {"b": 22}


@pytest.mark.parametrize("end", [10**400, "1e999", "nan"])
def test_a_range_that_is_no_number_is_a_fault_at_its_place(end: object, tmp_path: Path) -> None:
    text = (CASES / "range-overflow.toml").read_text()
    head = text[: text.index("range =")]
    path = tmp_path / "x.toml"
    path.write_text(f"{head}range = [{json.dumps(0.5)}, {json.dumps(end)}] }}\n")
    with pytest.raises(EngineFileError) as caught:
        read_file(path)
    assert [fault.path for fault in caught.value.faults] == [
        ("provenance", "cylinder.bore", "range")
    ] or [fault.path[:3] for fault in caught.value.faults] == [
        ("provenance", "cylinder.bore", "range")
    ]


def test_a_range_is_of_estimated_values_alone(tmp_path: Path) -> None:
    """It would be ignored: what else is varied for its effect is varied by a per cent."""
    path = tmp_path / "x.toml"
    text = (CASES / "range-overflow.toml").read_text()
    head = text[: text.index("range =")].replace('"estimated"', '"unverified"')
    path.write_text(f"{head}range = [0.8, 1.2] }}\n")
    assert codes_of(path) == ["provenance.range-known"]


def test_the_range_of_the_case_is_told_and_a_range_of_whole_numbers_is_read() -> None:
    assert codes_of(CASES / "range-overflow.toml") == ["provenance.multiples"]
    assert Provenance.model_validate({"status": "estimated", "range": [1, 2]}).range == (1.0, 2.0)


@pytest.mark.parametrize("name", ["explicit-without-bore", "geared-explicit"])
def test_an_explicit_file_with_masses_needs_no_bore_to_be_estimated(name: str) -> None:
    found = estimated(tree_of((CASES / f"{name}.toml").read_text()))
    assert [each.path for each in found.filled] == ["speed"]
    assert found.filled[0].source.endswith("with a bore equal to the stroke: the file has no bore")


def test_an_explicit_file_without_masses_and_bore_is_told_what_it_needs(refused: Refused) -> None:
    text = (CASES / "explicit-without-bore.toml").read_text()
    bare = 'relative = ["mass"]\n' + text.replace('"500 g"', "1")
    for displacement in (None, 2e-3):
        with pytest.raises(EngineFileError) as caught:
            estimated(tree_of(bare), displacement=displacement)
        assert [fault.code for fault in caught.value.faults] == ["file.explicit-without-bore"]
    told = refused("estimate", str(CASES / "geared-explicit.toml"), "--displacement", "2 l")
    assert "give bore in every entry" in told


def test_no_file_that_was_read_is_written_over(refused: Refused, run: Run, tmp_path: Path) -> None:
    for name in ("v6-idle-trace.toml", "pressure.csv"):
        (tmp_path / name).write_bytes((CASES / name).read_bytes())
    (tmp_path / "linked.csv").symlink_to("pressure.csv")
    (tmp_path / "hard.csv").hardlink_to(tmp_path / "pressure.csv")
    before = (tmp_path / "pressure.csv").read_bytes()
    for place in ("pressure.csv", "./pressure.csv", "linked.csv", "hard.csv"):
        for asked in (["torque", "v6-idle-trace.toml", "--csv"], ["analyze", "v6-idle-trace.toml"]):
            said = refused(*asked, "-o", place)
            assert f"{place} is read by this command and would be lost" in said
    assert (tmp_path / "pressure.csv").read_bytes() == before
    assert run("torque", "v6-idle-trace.toml", "--csv", "-o", "new.csv").code == 0
    assert run("torque", "v6-idle-trace.toml", "--csv", "-o", "new.csv").code == 0


def test_lists_and_readings_are_not_written_over(refused: Refused, tmp_path: Path) -> None:
    (tmp_path / "e.toml").write_bytes((CASES / "match-engine.toml").read_bytes())
    (tmp_path / "w.csv").write_bytes((CASES / "match-weights.csv").read_bytes())
    (tmp_path / "same.csv").hardlink_to(tmp_path / "w.csv")
    assert "would be lost" in refused("match", "e.toml", "w.csv", "--csv", "-o", "same.csv")
    assert (tmp_path / "same.csv").read_bytes() == (CASES / "match-weights.csv").read_bytes()


ESCAPED = "no., piston [g]\nA\x1b[31mX, 411.3\n=1+2, 413\nC, 412.4\n@D, 410.8\n"


@pytest.fixture
def escaped(tmp_path: Path) -> None:
    """An engine with a name like a formula, and weights with names that are commands."""
    text = (CASES / "match-engine.toml").read_text().replace("in-line four", "=1+2")
    (tmp_path / "e.toml").write_text(text)
    (tmp_path / "w.csv").write_text(ESCAPED)


@pytest.mark.many(first=1)
@pytest.mark.usefixtures("escaped")
@pytest.mark.parametrize(
    "asked",
    [
        ("analyze", "e.toml"),
        ("compare", "e.toml", "i4"),
        ("show", "e.toml"),
        ("match", "e.toml", "w.csv"),
    ],
)
def test_no_text_of_a_user_is_a_formula_in_a_spreadsheet(
    run: Run, tmp_path: Path, asked: tuple[str, ...]
) -> None:
    assert run(*asked, "-o", "x.xlsx").code == 0
    book = openpyxl.load_workbook(tmp_path / "x.xlsx")
    cells = [cell for page in book for row in page.iter_rows() for cell in row]
    assert [cell.coordinate for cell in cells if cell.data_type == "f"] == []
    assert any("=1+2" in str(cell.value) for cell in cells)


@pytest.mark.usefixtures("escaped")
def test_no_text_of_a_list_is_a_command_to_the_terminal(run: Run, tmp_path: Path) -> None:
    (tmp_path / "twice.csv").write_bytes((CASES / "weights-escape.csv").read_bytes())
    ran = run("match", "e.toml", "twice.csv")
    assert (ran.code, "A?[31mX" in ran.err) == (2, True)
    assert "\x1b" not in ran.err
    for form in ([], ["--csv"], ["--json"]):
        assert "\x1b" not in run("match", "e.toml", "w.csv", *form).out
    answer = json.loads(run("match", "e.toml", "w.csv", "--json").out)
    assert {row["piston"] for row in answer["cylinders"]} == {"A\x1b[31mX", "=1+2", "C", "@D"}
    rows = csv_rows(run("match", "e.toml", "w.csv", "--csv").out, "cylinders")
    assert {row["piston"] for row in rows} == {"A?[31mX", "'=1+2", "C", "'@D"}


@pytest.mark.release
@pytest.mark.parametrize("encoding", ["cp1252", "ascii", "utf-16"])
def test_what_programs_read_is_utf_8_in_every_pipe(encoding: str, tmp_path: Path) -> None:
    name = "Überengine 日本 ²"
    file = str(CASES / "unicode-name.toml")
    for asked in (["show", file, "--explicit"], ["analyze", file, "--json"]):
        out = subprocess.run(
            [sys.executable, "-m", "crankstar", *asked],
            env={**os.environ, "PYTHONIOENCODING": encoding},
            capture_output=True,
            check=True,
            cwd=tmp_path,
        ).stdout
        tree = tree_of(out.decode("utf-8"))
        assert tree.get("name", tree.get("engine")) == name


@pytest.mark.parametrize(
    "text",
    [
        f"{'a.' * 50_000}a = 1",
        f"[{'a.' * 50_000}a]",
        f"x = {{{'a . ' * 25_000}a = 1}}",
        f"""{'"a".' * 25_000}a = 1""",
    ],
    ids=["key", "table", "inline", "quoted"],
)
def test_a_key_with_very_many_dots_is_refused_before_it_is_read(
    text: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tomllib.loads", lambda _text: pytest.fail("it is quadratic in the dots"))
    with pytest.raises(EngineFileError) as caught:
        tree_of(text)
    assert [fault.code for fault in caught.value.faults] == ["file.too-deep"]


def test_texts_and_keys_with_some_dots_are_read() -> None:
    text = f'source = "{"see p. 3. " * 30}"\n{".".join("abcdefghij")} = 1.5\n'
    assert tree_of(text)["a"]["b"]["c"]["d"]["e"]["f"]["g"]["h"]["i"]["j"] == 1.5


@pytest.mark.parametrize(
    "asked",
    [
        ("analyze", "i4"),
        ("analyze", "i4", "--json"),
        ("analyze", "i4", "--speeds", "1000..3000 rpm by 1000"),
        ("bearings", "i4"),
        ("compare", "i4", "i6"),
    ],
)
def test_an_order_that_no_engine_of_the_kind_has_is_refused(
    refused: Refused, asked: tuple[str, ...]
) -> None:
    assert "order 0.3 does not occur" in refused(*asked, "--orders", "1,0.3")


@pytest.mark.release
def test_an_option_that_changes_nothing_in_a_derivation_is_named(run: Run) -> None:
    ran = run("derive", "i4", "--orders", "1", "--speed", "3000 rpm", "--power", "3")
    assert ran.code == 0
    assert ran.err.splitlines() == [
        "--speed changes nothing in this derivation.",
        "--power changes nothing in this derivation.",
    ]
    assert run("derive", "i4", "--orders", "2", "--power", "3", "--notation", "stroke").err == ""
    gas = run("derive", "i4", "--quantity", "gas", "--notation", "stroke")
    assert gas.err == "--notation changes nothing in this derivation.\n"


def traced(tmp_path: Path, first: float, *, more: float) -> Engine:
    """The V6 with its trace from another angle, closed by `more` times its first sample."""
    lines = (CASES / "pressure.csv").read_text().split()[1:]
    own = [tuple(map(float, line.split(","))) for line in lines]
    rows = sorted(((angle - first) % 720 + first, pressure) for angle, pressure in own)
    rows.append((first + 720, rows[0][1] * more))
    text = "".join(f"{angle},{pressure}\n" for angle, pressure in rows)
    (tmp_path / "pressure.csv").write_text(f"crank_deg,pressure_bar\n{text}")
    path = tmp_path / "v6.toml"
    path.write_bytes((CASES / "v6-idle-trace.toml").read_bytes())
    return read_file(path)


@pytest.mark.many(first=1)
@pytest.mark.parametrize("more", [1.0, 1.1])
def test_a_trace_is_the_same_cycle_wherever_it_begins(tmp_path: Path, more: float) -> None:
    """One cycle and the next differ at their peak: a trace from 0 to 720 deg ends there."""
    usual, other = (traced(tmp_path, first, more=more) for first in (-360.0, 0.0))
    assert other.gas is not None
    assert other.gas.trace is not None
    assert len(other.gas.trace.angle) == 1441
    one, two = (cycle(each, speed=73.3).pressure for each in (usual, other))
    assert two == pytest.approx(one, rel=1e-9)


@pytest.mark.release
@pytest.mark.parametrize("form", ["list", "lists"])
def test_a_table_of_a_trace_may_repeat_its_first_sample(tmp_path: Path, form: str) -> None:
    """[gas.trace] with 0 and 720 deg both is the file with them; where they differ it is refused.

    The list whose ends differ is named.
    """
    whole = traced(tmp_path, 0.0, more=1.0)
    assert whole.gas is not None
    assert whole.gas.trace is not None
    angle, (pressure,) = whole.gas.trace.angle, whole.gas.trace.pressure
    given = {
        "angle": [f"{each} rad" for each in angle],
        "pressure": [f"{each} Pa" for each in pressure],
    }
    named = {} if form == "list" else {"chambers": [1, 2, 3, 4, 5, 6]}
    lists = given["pressure"] if form == "list" else [given["pressure"]] * 6
    text = (CASES / "v6-idle-trace.toml").read_text().replace('trace = "pressure.csv"\n', "")
    tree = tomllib.loads(text)
    tree["gas"]["trace"] = {"angle": given["angle"], "pressure": lists, **named}
    found = engine_of(tree)
    assert cycle(found, speed=73.3).pressure == pytest.approx(
        cycle(whole, speed=73.3).pressure, rel=1e-9
    )
    apart = [*given["pressure"][:-1], "90 bar"]
    tree["gas"]["trace"]["pressure"] = apart if form == "list" else [*lists[:5], apart]
    with pytest.raises(EngineFileError) as refusal:
        engine_of(tree)
    faults = [(fault.code, fault.path) for fault in refusal.value.faults]
    place = 0 if form == "list" else 5
    assert (("trace.jump", ("gas", "trace", "pressure", place))) in faults


def test_one_list_of_pressures_is_that_of_every_chamber(tmp_path: Path) -> None:
    whole = traced(tmp_path, -360.0, more=1.0).gas
    assert whole is not None
    assert whole.trace is not None
    angle, (pressure,) = whole.trace.angle, whole.trace.pressure
    assert Trace.model_validate({"angle": angle, "pressure": pressure}) == whole.trace
    assert Trace.model_validate({"angle": angle, "pressure": [pressure]}) == whole.trace


def test_json_of_corrections_has_all_digits(run: Run) -> None:
    """Two planes that are the measuring planes: what was put in comes out, to the last digit."""
    spots = "12.3 g*mm at 123.4567 deg, 4.5 g*mm at 359.987 deg"
    planes = ("--measuring-planes", "0 mm, 400 mm", "--correction-planes", "0 mm, 400 mm")
    asked = ("correct", "--unbalance", spots, *planes)
    answer = json.loads(run(*asked, "--json").out)
    whole = {row["name"]: row for row in answer["unbalance"]}
    first, second = rect(12.3e-6, radians(123.4567)), rect(4.5e-6, radians(359.987))
    assert whole["static"]["size"] == pytest.approx(abs(first + second), rel=1e-12)
    assert whole["couple"]["couple"] == pytest.approx(0.2 * abs(second - first), rel=1e-12)
    assert [row["heavy_spot_deg"] for row in answer["planes"]] == pytest.approx(
        [123.4567, 359.987], abs=1e-9
    )
    assert [row["at_deg"] for row in answer["added"]] == pytest.approx(
        [303.4567, 179.987], abs=1e-9
    )
    assert "123.5" in run(*asked).out


@pytest.mark.release
def test_json_of_mounts_has_the_stiffness_of_the_file(run: Run, tmp_path: Path) -> None:
    text = (CASES / "match-engine.toml").read_text().replace('"80 N/mm"', '"81.2345 N/mm"')
    (tmp_path / "e.toml").write_text(text)
    asked = ("isolate", "e.toml", "--stiffness", "50..400 N/mm", "--starts", "1", "--minimise")
    answer = json.loads(run(*asked, "roll", "--json").out)
    assert answer["mounts"][0]["stiffness_before"] == pytest.approx([200, 81.2345, 81.2345])
