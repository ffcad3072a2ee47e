"""The command line: every verb, the machine-readable answers, and clumsy use."""

from __future__ import annotations

import cmath
import csv
import io
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.catalog import EVERY_ENGINE
from tests.commands import Ran, Run
from tests.holding import PATIENCE
from tests.texts import EXPLICIT, SHORT

import crankstar
from crankstar import cli, spectra
from crankstar.files import catalog, engine_of, explicit, schema, tree_of, tree_text
from crankstar.files.starters import STARTERS
from crankstar.mechanics.balance import balance, total

pytestmark = pytest.mark.quick

COMMAND = [sys.executable, "-c", "from crankstar.cli import main; main()"]
VERBS = [
    "list",
    "show",
    "analyze",
    "sound",
    "strokes",
    "derive",
    "orders",
    "vees",
    "search",
    "balance",
    "compare",
    "torque",
    "export",
    "errata",
    "check",
    "new",
    "schema",
]
ANALYSES = [[], ["--json"], ["--csv"]]


@pytest.fixture
def file(tmp_path: Path) -> str:
    """An engine file with sizes and masses."""
    (tmp_path / "mine.toml").write_text(SHORT, encoding="utf-8")
    return "mine.toml"


def test_without_arguments_and_with_help_it_tells_its_verbs(run: Run) -> None:
    for arguments in ([], ["--help"], ["-h"]):
        result = run(*arguments)
        assert result.code == 0
        assert all(re.search(rf"^│ {verb} +\w{{3}}", result.out, re.MULTILINE) for verb in VERBS)


@pytest.mark.many(first=1)
@pytest.mark.parametrize("words", [(), ("--language", "ja"), ("--lang", "ru")])
def test_a_new_process_tells_what_each_verb_does(words: tuple[str, ...]) -> None:
    """The verbs are loaded when they are asked for; the list of all of them has to ask."""
    told = subprocess.run([*COMMAND, *words], capture_output=True, check=True, encoding="utf-8")
    assert all(re.search(rf"^│ {verb} +\w{{3}}", told.stdout, re.MULTILINE) for verb in VERBS)


def test_completion_is_installed_with_the_options_of_all_verbs(tmp_path: Path) -> None:
    home = {**os.environ, "HOME": str(tmp_path), "SHELL": "/bin/bash"}
    asked = [*COMMAND, "--install-completion", "--shell", "bash"]
    subprocess.run(asked, env=home, capture_output=True, check=True)
    (script,) = tmp_path.rglob("completions/crankstar")
    text = script.read_text(encoding="utf-8")
    assert all(option in text for option in ("--speeds", "--minimise", "--greatest-depth"))
    before = (tmp_path / ".bashrc").read_bytes()
    told = subprocess.run([*asked, "-o", "-"], env=home, capture_output=True, check=False)
    assert told.returncode == 2
    assert b"writes a file that the shell reads" in told.stderr
    assert (tmp_path / ".bashrc").read_bytes() == before


@pytest.mark.many(first=2)
@pytest.mark.parametrize("columns", ["²", "-3", "x", "0", ""])
def test_a_width_that_is_none_is_passed_over(columns: str) -> None:
    """Rich takes a superscript for a digit, and int does not."""
    sized = {**os.environ, "COLUMNS": columns, "LINES": columns}
    told = subprocess.run([*COMMAND, "list"], env=sized, capture_output=True, check=True)
    assert b"kr250-racer" in told.stdout


@pytest.mark.many(first=15)
@pytest.mark.parametrize("verb", VERBS)
def test_every_verb_has_a_help(run: Run, verb: str) -> None:
    shown = run(verb, "--help").out
    assert shown.startswith(f"Usage: crankstar {verb}")
    assert "Every command also takes --units" in shown


def test_it_tells_its_version(run: Run) -> None:
    assert run("--version").out.strip() == crankstar.__version__


def test_list_shows_every_engine_of_the_catalog(run: Run) -> None:
    out = run("list").out
    assert all(re.search(rf"^{name} ", out, re.MULTILINE) for name in crankstar.names())


def test_list_can_be_narrowed(run: Run) -> None:
    out = run("list", "--cylinders", "8", "--layout", "vee").out
    assert "v8-flat-plane" in out
    assert "v8-cross-plane" in out
    assert not re.search(r"^(single|v2-90|boxer-6) ", out, re.MULTILINE)


@pytest.mark.release
@EVERY_ENGINE
def test_every_engine_of_the_catalog_can_be_shown_analyzed_and_checked(run: Run, name: str) -> None:
    title = crankstar.load(name).name
    assert run("show", name).out.startswith(title)
    assert run("analyze", name).out.startswith(title)
    assert json.loads(run("analyze", name, "--json").out)["engine"] == title
    assert run("check", name).out.startswith(f"{name}: good (")


def test_show_prints_the_explicit_form_as_a_file_that_reads_back(run: Run, file: str) -> None:
    out = run("show", file, "--explicit").out
    assert tomllib.loads(out) == explicit(engine_of(tree_of(SHORT)))
    assert run("check", "-", stdin=out.encode()).out == (
        "standard input: good (V8, cross-plane, 90 deg, 8 pistons; fires 1-8-4-3-6-5-7-2 "
        "every 90 deg)\n"
    )


def test_show_tells_throws_cylinders_and_dead_centres(run: Run, file: str) -> None:
    out = run("show", file).out
    for words in (
        "Fires 1-8-4-3-6-5-7-2 every 90 deg",
        "throw 4",
        "top dead centre",
        "reciprocating",
    ):
        assert words in out


def test_analyze_tells_force_couple_and_what_can_be_removed(run: Run, file: str) -> None:
    out = run("analyze", file, "--speed", "6000 rpm").out
    for words in (
        "Force on the block",
        "Couple on the block",
        "[N]",
        "[N m]",
        "Primary couple: counterweights remove all of it",
        "Peak inertia torque",
    ):
        assert words in out
    flat = run("analyze", "v8-flat-plane").out
    assert re.search(r"^ +2 .* 5\.6569 ∠ 180° +5\.6569$", flat, re.MULTILINE)
    assert re.search(r"^ +2 .* 1\.437 ∠ 180° +horizontal line +1\.437$", flat, re.MULTILINE)


ORDER = ["order", "harmonic", "force", "couple", "pitch", "yaw", "roll", "torque", "axis_moment"]
WAYS = ["forward", "backward", "vertical", "horizontal", "greatest"]
PARTS = {("couple", "vertical"): "pitch", ("couple", "horizontal"): "yaw"}


def test_json_has_the_shape_of_the_design(run: Run, file: str) -> None:
    answer = json.loads(run("analyze", file, "--speed", "6000 rpm", "--json").out)
    assert list(answer) == [
        "format",
        "engine",
        "rotation",
        "speed_rpm",
        "reference",
        "units",
        "rests_on",
        "orders",
        "peaks",
    ]
    assert (answer["format"], answer["engine"], answer["speed_rpm"]) == (
        2,
        "V8, cross-plane, 90 deg",
        6000.0,
    )
    assert answer["reference"] == pytest.approx({"z": 0, "up": 0, "right": 0}, abs=1e-12)
    assert answer["units"] == {"force": "N", "couple": "N*m", "moment": "N*m"}
    assert [row["order"] for row in answer["orders"]] == [1.0, 2.0, 4.0, 6.0]
    for row in answer["orders"]:
        assert list(row) == ORDER
        assert list(row["force"]) == list(row["couple"]) == WAYS
        pairs = [row[name] for name in ("harmonic", "roll", "torque", "axis_moment")]
        pairs += [row[name][way] for name in ("force", "couple") for way in WAYS[:2]]
        assert all(
            len(pair) == 2 and all(type(number) is float for number in pair) for pair in pairs
        )


def test_json_holds_the_numbers_of_the_balance(run: Run, file: str) -> None:
    answer = json.loads(run("analyze", file, "--speed", "6000 rpm", "--json").out)
    sums = total(balance(engine_of(tree_of(SHORT)), speed=200 * np.pi))
    for row in answer["orders"]:
        for name in ("force", "couple"):
            one = spectra.selected(getattr(sums, name), row["order"])
            assert complex(*row[name]["forward"]) == pytest.approx(
                complex(one.forward[0]), abs=1e-6
            )
            assert complex(*row[name]["backward"]) == pytest.approx(
                complex(one.backward[0]), abs=1e-6
            )
        moment = spectra.amplitude(spectra.selected(sums.axis_moment, row["order"]))
        assert complex(*row["axis_moment"]) == pytest.approx(complex(moment[0]), abs=1e-6)


@pytest.mark.parametrize(
    ("engine", "speed", "units"),
    [
        (SHORT, [], {"force": "m*r*w^2", "couple": "m*r*w^2*a", "moment": "m*r^2*w^2"}),
        ("single", [], {"force": "m*r*w^2", "couple": "m*r*w^2*a", "moment": "m*r^2*w^2"}),
        (
            "single",
            ["--speed", "6000 rpm"],
            {"force": "m*r*w^2", "couple": "m*r*w^2*a", "moment": "m*r^2*w^2"},
        ),
    ],
)
def test_json_without_speed_or_sizes_is_in_units_of_m_r_w2(
    run: Run, engine: str, speed: list[str], units: dict[str, str]
) -> None:
    name = "-" if "\n" in engine else engine
    answer = json.loads(run("analyze", name, "--json", *speed, stdin=engine.encode()).out)
    assert answer["units"] == units
    assert answer["speed_rpm"] is None


def test_json_of_an_engine_with_a_speed_of_its_own_is_at_that_speed(run: Run) -> None:
    text = 'speed = "5000 rpm"\n' + SHORT
    assert json.loads(run("analyze", "-", "--json", stdin=text.encode()).out)["speed_rpm"] == 5000.0
    other = json.loads(
        run("analyze", "-", "--json", "--speed", "100 rad/s", stdin=text.encode()).out
    )
    assert other["speed_rpm"] == pytest.approx(954.929658551)


def test_json_orders_are_those_asked_for_in_the_order_asked(run: Run, file: str) -> None:
    for asked, orders in (("2,1", [2, 1]), ("4, 4, 3", [4, 3]), ("1e0", [1])):
        answer = json.loads(run("analyze", file, "--orders", asked, "--json").out)
        assert [row["order"] for row in answer["orders"]] == orders
    every = json.loads(run("analyze", file, "--orders", "all", "--json").out)["orders"]
    assert [row["order"] for row in every] == list(range(1, len(every) + 1))
    assert len(every) > 8


def test_json_about_another_point_names_it(run: Run, file: str) -> None:
    along = json.loads(run("analyze", file, "--reference", "-120 mm", "--json").out)
    assert along["reference"] == {"z": -0.12, "up": 0.0, "right": 0.0}
    beside = json.loads(run("analyze", file, "--reference", "0 mm, 35 mm, -10 mm", "--json").out)
    assert beside["reference"] == {"z": 0.0, "up": 0.035, "right": -0.01}


def wave_of(row: dict[str, str]) -> complex:
    return cmath.rect(float(row["amplitude"]), math.radians(float(row["phase_deg"])))


def test_csv_has_the_same_numbers_a_row_per_amplitude(run: Run, file: str) -> None:
    answer = json.loads(run("analyze", file, "--speed", "6000 rpm", "--json").out)
    text = run("analyze", file, "--speed", "6000 rpm", "--csv").out
    rows = list(csv.DictReader(io.StringIO(text)))
    assert list(rows[0]) == [
        *("engine", "speed_rpm", "part", "order", "quantity", "direction", "amplitude"),
        *("phase_deg", "unit"),
    ]
    waves = {(row["quantity"], row["direction"], float(row["order"])): row for row in rows}
    assert len(waves) == len(rows) == 11 * len(answer["orders"])
    for expected in answer["orders"]:
        for name, unit in (("force", "N"), ("couple", "N*m")):
            for way in WAYS[:4]:
                row = waves[PARTS.get((name, way), name), way, expected["order"]]
                assert (row["engine"], row["part"], row["unit"]) == (
                    answer["engine"],
                    "engine",
                    unit,
                )
                assert float(row["speed_rpm"]) == 6000
                wave = expected[name][way]
                if isinstance(wave, list):
                    given = cmath.rect(
                        float(row["amplitude"]), math.radians(float(row["phase_deg"]))
                    )
                    assert given == pytest.approx(complex(*wave), rel=1e-12)
                else:
                    assert float(row["amplitude"]) == wave["amplitude"]
                    assert float(row["phase_deg"]) == pytest.approx(wave["phase_deg"])
        for name in ("roll", "torque", "axis_moment"):
            row = waves[name, "axial", expected["order"]]
            given = wave_of(row)
            assert given == pytest.approx(complex(*expected[name]), rel=1e-12)


def test_csv_by_bank_has_the_shares_of_which_the_whole_is_the_sum(run: Run, file: str) -> None:
    rows = list(csv.DictReader(io.StringIO(run("analyze", file, "--csv", "--by", "bank").out)))
    sums: dict[tuple[str, ...], list[complex]] = {}
    for row in rows:
        wave = wave_of(row)
        key = (row["order"], row["quantity"], row["direction"])
        both = sums.setdefault(key, [0j, 0j])
        both[row["part"] == "engine"] += wave
    assert {row["part"] for row in rows} >= {"engine", "bank bank 1", "bank bank 2", "no bank"}
    assert max(abs(whole) for _, whole in sums.values()) > 1
    for shares, whole in sums.values():
        assert shares == pytest.approx(whole, abs=1e-12)


@pytest.mark.parametrize("name", ["=1+2", "+x", "-x", "@x"])
def test_a_spreadsheet_takes_no_name_for_a_formula(run: Run, file: str, name: str) -> None:
    rows = list(
        csv.reader(io.StringIO(run("analyze", file, "--csv", "--set", f'name="{name}"').out))
    )
    assert rows[1][0] == f"'{name}"


def test_values_can_be_set_on_the_command_line(run: Run, file: str) -> None:
    settings = [
        "--set",
        "layout.bore_pitch=100 mm",
        "--set",
        'name="other"',
        "--set",
        "cylinder.rod_ratio=4",
    ]
    assert run("show", file, *settings[:4]).out.startswith("other\n")
    assert json.loads(run("analyze", file, *settings[2:4], "--json").out)["engine"] == "other"
    shown = tomllib.loads(
        run(
            "show", file, "--explicit", *settings[:2], "--set", "layout.banks[1].bearing=45 deg"
        ).out
    )
    assert shown["bore_pitch"] == "100 mm"
    assert Path(file).read_text(encoding="utf-8") == SHORT


def test_compare_shows_several_engines_side_by_side(run: Run, file: str) -> None:
    out = run("compare", file, "v8-flat-plane", "single").out
    assert "in its own m r ω²" in out
    assert "unverified" in out
    together = run("compare", file, file, "--speed", "6000 rpm").out
    assert re.search(r"^order +\[(k?N)\] +\[\1\]( +\[%\])?$", together, re.MULTILINE)


def test_check_tells_of_sources_whose_entry_was_deleted(run: Run) -> None:
    name = "layout.throws[9]"
    source = f'\n[provenance."{name}"]\nsource = "a book"\nstatus = "published"\n'
    Path("stale.toml").write_text(tree_text(catalog.tree_of("i4")[1]) + source, encoding="utf-8")
    told = run("check", "stale.toml")
    assert told.code == 0
    assert told.out.splitlines() == [
        "stale.toml: good (Four in line, flat crank, 4 pistons; fires 1-3-4-2 every 180 deg)",
        f"  The source of {name} is of an entry that the file does not have; leave it out.",
    ]


@pytest.mark.release
def test_one_key_is_set_once(run: Run, refused: Callable[..., str]) -> None:
    both = ["--set", "speed=90 rpm", "--set", "speed = 80 rpm"]
    assert '--set speed = 80 rpm: "speed" is set before; give it once' in refused(
        "show", "i4", *both
    )
    two = ["--set", "speed=90 rpm", "--set", "2:speed=80 rpm", "--csv"]
    told = run("compare", "bmw-m52b28", "bmw-m52b28", "--estimate", *two).out
    assert {row["speed_rpm"] for row in csv.DictReader(told.splitlines())} == {"90.0", "80.0"}


def test_speeds_in_another_unit_are_quoted_as_they_were_written(
    refused: Callable[..., str],
) -> None:
    told = refused("analyze", "i4", "--speeds", "600..6000 mm by 200")
    assert 'speed is "600 mm", a length; a rotational speed is needed' in told


def test_check_tells_of_every_file_and_fails_if_one_fails(
    run: Run, file: str, tmp_path: Path
) -> None:
    (tmp_path / "bad.toml").write_text(
        SHORT.replace('"82.5 mm"', '"82 kg"').replace("2]", "9]"), encoding="utf-8"
    )
    result = run("check", file, "bad.toml", "none.toml", "single")
    assert result.code == 2
    assert [line.partition(":")[0] for line in result.out.splitlines()] == ["mine.toml", "single"]
    assert "bad.toml: 3 mistakes\n  cylinder.stroke is " in result.err
    assert "none.toml: 1 mistake\n  there is no such file" in result.err
    assert run("check", file, "single").code == 0


@pytest.mark.many(first=5)
@pytest.mark.parametrize("kind", STARTERS)
def test_new_writes_a_file_that_checks(run: Run, kind: str) -> None:
    text = run("new", kind).out
    assert text == STARTERS[kind]
    assert run("new", kind, "-o", "new.toml") == (0, "", "Wrote new.toml\n")
    assert Path("new.toml").read_text(encoding="utf-8") == text
    assert run("check", "new.toml").code == 0
    assert run("analyze", "new.toml").code == 0


def test_new_overwrites_nothing_unless_told(
    run: Run, refused: Callable[..., str], file: str
) -> None:
    assert "-o mine.toml: it already exists; --overwrite replaces it" in refused(
        "new", "vee", "-o", file
    )
    assert Path(file).read_text(encoding="utf-8") == SHORT
    assert run("new", "vee", "-o", file, "--overwrite").code == 0
    assert Path(file).read_text(encoding="utf-8") == STARTERS["vee"]


def test_schema_prints_the_schema(run: Run) -> None:
    assert json.loads(run("schema").out) == schema()


@pytest.mark.release
def test_a_lone_hyphen_is_standard_input(run: Run, file: str) -> None:
    plain = run("analyze", file).out
    assert run("analyze", "-", stdin=SHORT.encode()).out == plain
    assert run("analyze", "--orders", "1,2,4,6", "-", stdin=SHORT.encode()).out == plain
    assert run("analyze", "-", stdin=json.dumps(tomllib.loads(SHORT)).encode()).out == plain
    assert run("compare", "-", file, stdin=SHORT.encode()).code == 0
    assert "standard input: 1 mistake\n  the file is empty" in run("show", "-").err
    assert run("check", "-", "-", stdin=SHORT.encode()).code == 2


@pytest.mark.parametrize("options", ANALYSES)
def test_what_goes_to_a_file_is_what_is_printed(run: Run, file: str, options: list[str]) -> None:
    printed = run("analyze", file, *options).out
    assert run("analyze", file, *options, "-o", "out.txt") == (0, "", "Wrote out.txt\n")
    assert Path("out.txt").read_text(encoding="utf-8") == printed
    assert oct(Path("out.txt").stat().st_mode & 0o777) == oct(0o666 & ~current_mask())


def current_mask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["analyse"], 'Неизвестная команда "analyse". Возможно, имелось в виду "analyze"?'),
        (["analyze"], "параметр ENGINE требует значения."),
        (["analyze", "i4", "--jsn"], "Неизвестный параметр: --jsn."),
        (["list", "--cylinders", "x"], '--cylinders: "x" не является целым числом.'),
        (["search", "5", "--cycle", "x"], "возможны: "),
    ],
)
def test_what_the_parser_refuses_is_told_in_the_reader_s_language(
    words: list[str], said: str, run: Run
) -> None:
    result = run(*words, "--lang", "ru")
    assert result.code == 2
    assert said in result.err


BAD_LINES = [
    (["analyse", "X"], 'Unknown command "analyse". Did you mean "analyze"?'),
    (["X"], 'Unknown command "mine.toml"'),
    (["--frob"], 'Unknown command "--frob"'),
    (["analyze"], "ENGINE requires an argument"),
    (["analyze", "X", "X"], 'too many arguments: "mine.toml"'),
    (["analyze", "X", "--jsn"], "Unknown option: --jsn. Did you mean --json?"),
    (["analyze", "X", "-v"], "Unknown option: -v"),
    (["analyze", "X", "--json", "--csv"], "--json and --csv exclude each other"),
    (["analyze", "X", "--json", "--theta", "0 deg"], "--theta has no effect with --json"),
    (["analyze", "X", "--json", "--by", "bank"], "--by has no effect with --json"),
    (["analyze", "X", "--csv", "--theta", "0 deg"], "--theta has no effect with --csv"),
    (["analyze", "X", "--json=maybe"], 'unable to convert "maybe" into yes or no'),
    (["analyze", "X", "--speed"], "--speed requires an argument"),
    (["analyze", "X", "--speed", "1 rpm", "--speed", "2 rpm"], "--speed specified multiple "),
    (["analyze", "X", "--speed", "0 rpm"],
        '--speed is "0 rpm"; it must be greater than 0, such as "6000 rpm"'),
    (["analyze", "X", "--speed", "-5 rpm"],
        '--speed is "-5 rpm"; it must be greater than 0, such as "6000 rpm"'),
    (["analyze", "X", "--speed", "6000"], '--speed is "6000", a number without a unit'),
    (["analyze", "X", "--speed", "6000 mm"],
        '--speed is "6000 mm", a length; a rotational speed is needed'),
    (["analyze", "X", "--speed", "1e400 rpm"], "too large for an engine"),
    (["analyze", "X", "--speed", "1e-9 rpm"], "too small for an engine"),
    (["analyze", "X", "--speed", "nan rpm"], "not a number with a unit"),
    (["analyze", "X", "--speed", ""], 'is "", not a number with a unit'),
    (["analyze", "X", "--speed", "9" * 5000], "not a number with a unit"),
    (["analyze", "X", "--speed", "6\x1b[31m rpm"], 'whose unit "?[31m rpm" is not known'),
    *((["analyze", "X", "--speeds", f"1000..{speed} rpm"], "too large for an engine; give one")
        for speed in ("1e6", "1e100", "1e300")),
    *((["analyze", "X", form, "-o", f"x.{suffix}"], f"the name must end in .{form[2:]}")
        for form in ("--json", "--csv") for suffix in ("svg", "png", "pdf", "html", "toml")),
    *((["analyze", "X", "--orders", orders],
        "give numbers above 0 up to 1000 with commas") for orders in (
        "garbage", "nan", "inf", "1e999", "0", "-1", "", ",", "1;2", "1/0", "1001", "1,x",
        "\x1b[31m", "ALL",
        ",".join(["1"] * 5000) + "x", ",".join(map(str, range(1, 500))),
    )),
    *((["analyze", "X", "--reference", point], "--reference") for point in (
        "garbage", "1,2", "1,2,3,4", "", "nan", "inf mm", "3 kg", "1e400 mm", "\x1b[31m",
        "0 mm, 5 kg, 0 mm", "200",
    )),
    (["analyze", "v8-flat-plane", "--reference", "1 mm"], "the file gives no bore pitch"),
    (["analyze", "X", "--theta", "frog"],
        '--theta is "frog", not a number with a unit; an angle is needed'),
    (["analyze", "X", "--by", "frog"], "--by frog: choose from"),
    *((["analyze", "X", "--set", setting], "--set") for setting in ("garbage", "=1", "", " =1",
        "\x1b[31m")),
    (["analyze", "X", "--set"], "--set requires an argument"),
    (["analyze", "X", "--set", "a.b.c=1"], "a is not a key of an engine file; there are: "),
    (["analyze", "X", "--set", "layout.throws.0=1"],
        "layout.throws.0 cannot be set; layout.throws is a list of 4"),
    (["analyze", "X", "--set", "layout.throws[9]=1"],
        "layout.throws[9] cannot be set; layout.throws is a list of 4"),
    (["analyze", "X", "--set", "layout.throws=[0, 0]"], "layout.throws has 2 angles; give 4"),
    (["analyze", "X", "--set", "cylinder.stroke=inf"],
        "cylinder.stroke is inf, which is not finite; a length is needed"),
    (["analyze", "X", "--set", "cylinder.stroke=[1]"],
        "cylinder.stroke is a list; a length is needed"),
    (["analyze", "X", "--set", "name="], "name is empty"),
    (["analyze", "X", "--set", "balance_factor=50 %"],
        'balance_factor is "50 %"; a number is needed'),
    (["analyze", "X", "--set", "cylinder.rod_ratio=" + "9" * 5000], "cylinder.rod_ratio is "),
    (["analyze", "X", "--set", "name=" + "[" * 300 + "]" * 300], "nested too deeply"),
    (["analyze", "X", "--set", "\x1b[31m=1"], '"\\u001b[31m" is not a key'),
    (["strokes", "X", "--set", "valves.exhaust_opens=60"],
        "valves.exhaust_opens is 60 rad; the largest plausible value"),
    (["strokes", "X", "--set", "valves.manifolds=[[1]]"],
        "valves.manifolds misses cylinders 2, 3, 4"),
    (["strokes", "X", "--set", "firing_order=[]"], "firing_order is missing, and the stroke"),
    (["compare", "X"], "SECOND requires an argument"),
    (["compare", "X", "none"], "none: 1 mistake"),
    (["compare", "-", "-"], "- is standard input, which can be read only once"),
    (["check"], "check: name at least one engine file"),
    (["new"], "LAYOUT requires an argument"),
    (["new", "veee"], "layout veee: choose from inline, vee, boxer"),
    (["new", "\x1b[31m"], "layout ?[31m: choose from"),
    (["new", "vee", "x"], 'too many arguments: "x"'),
    (["new", "vee", "-o"], "-o requires an argument"),
    (["list", "--cylinders", "x"], 'unable to convert "x" into a whole number'),
    (["list", "--cylinders", "1.5"], 'unable to convert "1.5" into a whole number'),
    (["list", "--cylinders", "9" * 5000], 'unable to convert "9999'),
    (["list", "--cylinders", "99"], "the catalog has no such engine"),
    (["list", "--layout", "delta"], "--layout delta: choose from boxer"),
    (["list", "--layout", "\x1b[31m"], "--layout ?[31m: choose from"),
    (["schema", "x"], 'too many arguments: "x"'),
    (["\x1b[31m"], 'Unknown command "?[31m"'),
    (["[bold]x[/]"], 'Unknown command "[bold]x[/]"'),
    (["analyze", "X", "--[bold]x[/]"], "Unknown option: --[bold]x[/]"),
    (["analyze", "X", "--\x1b[31m"], "Unknown option: --?[31m"),
    (["analyze", ""], '"": 1 mistake\n  there is no such engine'),
    (["list", "--layout", " "], '--layout " ": choose from'),
    (["plot", "X", ""], 'chart "": choose from '),
    *(
        ([verb, *words, "-o", ""], '-o "": it is empty; leave it out')
        for verb, *words in (
            ["plot", "X", "spectrum"],
            ["page", "X"],
            ["animate", "X"],
            ["site", "X"],
            ["site", "X", ""],
        )
    ),
    (["match", "X", "w.csv", "--engine-file", "z.toml", "-o", "./z.toml"],
        "--engine-file and -o name the same file"),
    (["animate", "X", "--arrows", "none,force"], "--arrows none,force: none stands alone"),
    (["animate", "X", "--arrows", "x"], "--arrows x: choose from force, couple, none"),
    (["match", "X", "w.csv", "--engine-file="], '--engine-file "": it is empty'),
    (["fault", "X", "--cut", "3", "--point", ""], '--point "": it is empty; leave it out'),
    (["analyze", "\x1b[31m"], "?[31m: 1 mistake\n  there is no such engine"),
    (["analyze", "n" * 100_000], "there is no such engine"),
    (["analyze", "v8-flatplane"], "did you mean v8-flat-plane"),
    (["page", "kr250", "-o", "x.html"],
        "did you mean kr250-production, kr250-racer, kr250-racer-simultaneous?"),
    (["analyze", "Plane"], "did you mean v8-cross-plane, v8-flat-plane, yamaha-r1-crossplane?"),
    (["analyze", "."], "is a directory; name a file in it"),
    (["analyze", "/dev/zero"], "is not a regular file; use - to read standard input"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("arguments", "words"),
    BAD_LINES,
    ids=[" ".join(line)[:50].encode("unicode_escape").decode() for line, _ in BAD_LINES],
)
def test_a_bad_command_line_is_refused_in_a_sentence(
    refused: Callable[..., str], file: str, arguments: list[str], words: str
) -> None:
    message = refused(*(file if word == "X" else word for word in arguments))
    assert words in message
    assert len(message) < 1500


@pytest.mark.parametrize(
    ("wanted", "content", "found"),
    [
        *(
            (wanted, content, found)
            for content, found in (
                ("<svg xmlns='x'></svg>", "a picture (SVG)"),
                ("<?xml version='1.0'?>\n<svg></svg>", "a picture (SVG)"),
                ("<!doctype html><title>x</title>", "a page (HTML)"),
            )
            for wanted in ("an engine file", "a list with headings")
        ),
        ("an engine file", "no., piston [g]\n1, 412.3\n2, 411", "a list (CSV)"),
        ("an engine file", "no;piston [g]\n1;412,3", "a list (CSV)"),
        ("a list with headings", EXPLICIT, "an engine file"),
        ("a list with headings", None, "a directory"),
        ("an engine file", None, "a directory"),
    ],
)
def test_a_file_of_another_kind_is_said_to_be_one(
    refused: Callable[..., str], wanted: str, content: str | None, found: str
) -> None:
    if content is None:
        Path("x").mkdir()
    else:
        Path("x").write_text(content, encoding="utf-8")
    if wanted == "an engine file":
        verbs = [["analyze", "x"], ["compare", "i4", "x"]]
    else:
        verbs = [["match", "i4", "x"], ["diagnose", "i4", "x"]]
    for verb in verbs:
        told = refused(*verb)
        assert f"is {found}" in told
        assert wanted in told or content is None


def test_an_option_is_proposed_only_where_it_is_like_the_typed_one(
    refused: Callable[..., str],
) -> None:
    assert "Did you mean" not in refused("analyze", "i4", "--nope")
    assert "Did you mean --json?" in refused("analyze", "i4", "--jsn")


@pytest.mark.parametrize(
    ("arguments", "places"),
    [
        (["compare", "i4", "nosuch1", "nosuch2"], ["nosuch1: ", "nosuch2: "]),
        (["page", "nosuch1", "--beside", "nosuch2", "-o", "x.html"], ["nosuch1: ", "nosuch2: "]),
        (["analyze", "i4", "--set", "foo=3", "--speed", "x"], ["  foo is", "--speed is"]),
        (["derive", "i4", "--set", "foo=3", "--speed", "x"], ["  foo is", "--speed is"]),
        (["verdict", "i4", "--set", "foo", "--speed", "x"], ["--set foo", "--speed is"]),
        (["balance", "i4", "--set", "foo=3", "--speed", "x"], ["  foo is", "--speed is"]),
        (["search", "i4", "--set", "foo=3", "--speed", "x"], ["  foo is", "--speed is"]),
        (
            ["plot", "i4", "spectrum", "--beside", "nosuch", "--speed", "x", "-o", "x.svg"],
            ["nosuch: ", "--speed is"],
        ),
        (
            ["report", "nosuch1", "--beside", "nosuch2", "--speed", "x", "-o", "x.html"],
            ["nosuch1: ", "nosuch2: ", "--speed is"],
        ),
    ],
)
def test_faults_of_engines_and_speed_are_reported_together(
    refused: Callable[..., str], arguments: list[str], places: list[str]
) -> None:
    lines = refused(*arguments).removeprefix("crankstar: ").splitlines()
    assert all(sum(line.startswith(place) for line in lines) == 1 for place in places), lines


@pytest.mark.release
@pytest.mark.parametrize(
    ("place", "reason"),
    [
        ("folder", "it is a directory"),
        (".", "it is a directory"),
        ("none/out.txt", "there is no such directory"),
        ("mine.toml/out.txt", "Not a directory"),
        ("/dev/full", "No space left on device"),
        ("loop", "Too many levels of symbolic links"),
        ("pipe", "No such device or address"),
        ("n" * 300, "File name too long"),
        ("a\0b", "a file cannot have this name"),
        ("/proc/out.txt", ""),
        ("\x1b[31m/out.txt", "there is no such directory"),
    ],
)
def test_output_to_an_unwritable_place_is_refused(
    refused: Callable[..., str], file: str, place: str, reason: str
) -> None:
    Path("folder").mkdir()
    Path("loop").symlink_to("loop")
    os.mkfifo("pipe")
    before = sorted(Path().iterdir())
    for suffix, *verb in (
        (".txt", "analyze", file),
        (".txt", "analyze", file, "--json"),
        (".toml", "show", file, "--explicit"),
        (".json", "schema"),
    ):
        message = refused(*verb, "-o", place.replace(".txt", suffix))
        assert f"cannot be written ({reason}" in message
        assert message.rstrip().endswith("Name another file with -o")
    assert sorted(Path().iterdir()) == before


def test_output_that_fails_loses_nothing(
    refused: Callable[..., str], file: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    Path("kept.txt").write_text("precious", encoding="utf-8")
    real = tempfile.mkstemp

    def full(**arguments: Any) -> tuple[int, str]:
        handle, name = real(**arguments)
        os.close(handle)
        return os.open("/dev/full", os.O_WRONLY), name

    monkeypatch.setattr(tempfile, "mkstemp", full)
    assert "kept.txt: cannot be written (No space left on device); nothing was changed" in refused(
        "analyze", file, "-o", "kept.txt"
    )
    monkeypatch.setattr(
        Path, "replace", lambda *_: (_ for _ in ()).throw(PermissionError(13, "Permission denied"))
    )
    monkeypatch.setattr(tempfile, "mkstemp", real)
    assert "(Permission denied); nothing was changed" in refused("analyze", file, "-o", "kept.txt")
    assert Path("kept.txt").read_text(encoding="utf-8") == "precious"
    assert {path.name for path in Path().iterdir()} == {"kept.txt", file}


def test_a_write_protected_file_is_kept(
    refused: Callable[..., str], file: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    Path("kept.txt").write_text("precious", encoding="utf-8")
    monkeypatch.setattr(os, "access", lambda *_: False)
    assert "cannot be written (it is write-protected)" in refused("analyze", file, "-o", "kept.txt")
    assert Path("kept.txt").read_text(encoding="utf-8") == "precious"


def test_a_bad_request_leaves_the_output_as_it_was(refused: Callable[..., str], file: str) -> None:
    Path("kept.txt").write_text("precious", encoding="utf-8")
    refused("analyze", file, "--orders", "x", "-o", "kept.txt")
    refused("analyze", "none.toml", "-o", "kept.txt")
    assert Path("kept.txt").read_text(encoding="utf-8") == "precious"


def test_output_through_a_link_and_to_a_device_keeps_link_and_device(run: Run, file: str) -> None:
    Path("link").symlink_to("real.txt")
    assert run("analyze", file, "-o", "link").code == 0
    assert Path("link").is_symlink()
    assert Path("real.txt").read_text(encoding="utf-8").startswith("V8")
    assert run("analyze", file, "-o", "/dev/null").code == 0
    assert Path("/dev/null").is_char_device()


def test_output_keeps_the_permissions_of_a_file(run: Run, file: str) -> None:
    Path("out.txt").touch()
    Path("out.txt").chmod(0o640)
    assert run("analyze", file, "-o", "out.txt").code == 0
    assert Path("out.txt").stat().st_mode & 0o777 == 0o640


@pytest.mark.release
def test_names_with_markup_and_odd_file_names_are_only_text(run: Run, tmp_path: Path) -> None:
    title = "[bold]V8[/] [link=http://x]y[/link] <b>z</b> :smile:"
    for name in (
        "[red]a[bold].toml",
        "line\nbreak.toml",
        "esc\x1b[31m.toml",
        "\u202eright.toml",
        "latin\udcff.toml",
        "empty .toml",
    ):
        (tmp_path / name).write_text(
            SHORT.replace("V8, cross-plane, 90 deg", title), encoding="utf-8"
        )
        assert title in run("check", name).out
        assert title in run("analyze", name).out
        assert "[bold]V8[/]" in run("compare", name, name).out
        assert json.loads(run("analyze", name, "--json").out)["engine"] == title


@pytest.mark.parametrize("verb", ["analyze", "balance", "show", "orders"])
def test_a_file_that_is_read_is_not_written_over(run: Run, file: str, verb: str) -> None:
    before = Path(file).read_bytes()
    answer = run(verb, file, "-o", str(Path(file).resolve()))
    assert answer.code == 2
    assert "name another file" in answer.err
    assert Path(file).read_bytes() == before


@pytest.mark.release
def test_a_pipe_is_as_wide_as_columns_says_and_always_plain(
    run: Run, file: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain = run("analyze", file).out
    for name, value in {"TERM": "dumb", "NO_COLOR": "1"}.items():
        monkeypatch.setenv(name, value)
        assert run("analyze", file).out == plain
    for columns in ("0", "-5", "abc", ""):
        monkeypatch.setenv("COLUMNS", columns)
        assert run("analyze", file).out == plain
    monkeypatch.setenv("COLUMNS", "400")
    assert run("analyze", file).out.split() == plain.split()
    monkeypatch.setenv("COLUMNS", "60")
    narrow = run("analyze", file).out
    assert max(map(len, narrow.splitlines())) <= 60 < max(map(len, plain.splitlines()))


@pytest.mark.many(first=12)
@pytest.mark.parametrize("columns", ["1", "20", "80", "400"])
@pytest.mark.parametrize("verb", [["list"], ["show", "X"], ["analyze", "X"], ["compare", "X", "X"]])
def test_on_a_terminal_of_any_width_it_prints_in_bold_dim_and_yellow_only(
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    file: str,
    columns: str,
    verb: list[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", columns)
    monkeypatch.setenv("TTY_COMPATIBLE", "1")
    monkeypatch.setenv("FORCE_COLOR", "1")
    monkeypatch.setenv("TERM", "xterm")
    with pytest.raises(SystemExit) as left:
        cli.main([file if word == "X" else word for word in verb])
    out = capsys.readouterr().out
    assert left.value.code == 0
    assert out
    assert set(re.findall("\x1b[^m]*m", out)) <= {
        f"\x1b[{style}m" for style in ("0", "1", "2", "33", "2;33", "1;33")
    }


def test_it_ends_with_130_when_interrupted(
    run: Run, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    assert run("check", "single").code == 0
    monkeypatch.setattr("crankstar.options.sources.tree_of", interrupted)
    with pytest.raises(SystemExit) as left:
        cli.main(["analyze", "single"])
    assert left.value.code == 130
    assert capsys.readouterr() == ("", "")


def test_it_tells_when_there_is_not_enough_memory(
    refused: Callable[..., str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def huge(*_: object, **__: object) -> None:
        raise MemoryError

    monkeypatch.setattr("crankstar.options.sources.tree_of", huge)
    assert "not enough memory for this engine" in refused("analyze", "single")


def shell(script: str, folder: Path, **environment: str) -> Ran:
    """What a shell gives; $C is the command."""
    quoted = " ".join(f"'{word}'" for word in COMMAND)
    done = subprocess.run(
        ["/bin/bash", "-c", f'C() {{ {quoted} "$@"; }}; {script}'],
        cwd=folder,
        env={**os.environ, "PYTHONUNBUFFERED": "", **environment},
        capture_output=True,
        timeout=PATIENCE,
        check=False,
    )
    return Ran(
        done.returncode, done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace")
    )


@pytest.mark.many(first=4)
@pytest.mark.parametrize(
    ("script", "code", "words"),
    [
        (
            "C analyze mine.toml > /dev/full",
            2,
            (
                "standard output or a temporary file (TMPDIR) cannot be written (No space "
                "left on device)"
            ),
        ),
        (
            "C analyze mine.toml --json > /dev/full",
            2,
            (
                "standard output or a temporary file (TMPDIR) cannot be written (No space "
                "left on device)"
            ),
        ),
        ("C analyze mine.toml >&-", 2, "standard output is closed; name a file with -o"),
        ("C analyze none 2> /dev/full", 2, ""),
        ("C analyze none >&- 2>&-", 2, ""),
        ("C analyze - <&-", 2, "standard input: 1 mistake\n  standard input is closed"),
        ("C analyze mine.toml <&- > /dev/null", 0, ""),
        ("C analyze mine.toml | true; exit ${PIPESTATUS[0]}", 0, ""),
        ("C schema | head -1 > /dev/null; exit ${PIPESTATUS[0]}", 0, ""),
        ("C analyze none 2>&1 | true; exit ${PIPESTATUS[0]}", 2, ""),
    ],
)
def test_closed_and_full_streams_are_told_and_never_a_traceback(
    file: str, tmp_path: Path, script: str, code: int, words: str
) -> None:
    result = shell(script, tmp_path)
    assert file
    assert (result.code, result.out) == (code, "")
    assert words in result.err
    assert result.err.count("\n") <= 3
    assert bool(result.err) == bool(words)


def test_a_terminal_that_knows_only_ascii_is_served(file: str, tmp_path: Path) -> None:
    assert file
    result = shell(
        "C analyze mine.toml", tmp_path, LC_ALL="C", PYTHONIOENCODING="ascii", PYTHONUTF8="0"
    )
    assert (result.code, result.err) == (0, "")
    assert result.out.isascii()
    assert "[m r w^2]" in result.out
    assert "?" not in result.out


@pytest.mark.many(first=1)
@pytest.mark.parametrize("language", ["ja", "ru"])
def test_a_language_that_the_terminal_lacks_letters_for_is_doubted_in_ascii(
    file: str, tmp_path: Path, language: str
) -> None:
    line = f"C check {file} --language {language}"
    result = shell(line, tmp_path, LC_ALL="C", PYTHONIOENCODING="ascii", PYTHONUTF8="0")
    assert result.code == 0
    assert f"ascii, cannot show the language {language}; set PYTHONIOENCODING=utf-8" in result.err
    assert shell(line, tmp_path, PYTHONUTF8="1").err == ""


def test_the_command_itself_is_installed(tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text(EXPLICIT, encoding="utf-8")
    script = Path(sys.executable).parent / "crankstar"
    done = subprocess.run(
        [script, "check", "mine.toml"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
        timeout=PATIENCE,
    )
    assert done.stdout == "mine.toml: good (two and a balance shaft, 2 pistons)\n"


GEARED = """
format = 1
name = "geared"
[cylinder]
stroke = "80 mm"
rod_length = "146 mm"
reciprocating_mass = "500 g"
[layout]
type = "tandem"
bore_pitch = "100 mm"
cranks = [
  { banks = [{ cylinders = [1] }], throws = ["0 deg"] },
  { banks = [{ cylinders = [2] }], throws = ["0 deg"], speed_ratio = "29/31", right = "120 mm" },
]
"""


def test_an_order_is_named_as_a_fraction_or_as_it_was_printed(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "geared.toml"
    path.write_text(GEARED, encoding="utf-8")
    for asked in ("29/31", "0.93548"):
        told = json.loads(run("analyze", str(path), "--orders", asked, "--json").out)["orders"]
        assert told[0]["order"] == pytest.approx(29 / 31, abs=1e-12)
        assert told[0]["force"]["greatest"] > 0


def test_a_file_that_is_read_is_not_written_over_however_it_is_named(
    refused: Callable[..., str], file: str
) -> None:
    for option in (f"-o{file}", f"-o={file}", f"--output={file}"):
        assert "would be lost" in refused("balance", file, option)


@pytest.mark.many(first=1)
@pytest.mark.parametrize("columns", ["1", "9" * 20, "abc"])
def test_help_is_printed_in_any_width(columns: str) -> None:
    for words in (["--help"], ["analyze", "--help"]):
        done = subprocess.run(
            [*COMMAND, *words],
            env={**os.environ, "COLUMNS": columns},
            capture_output=True,
            text=True,
            timeout=PATIENCE,
            check=True,
        )
        assert 20 < len(done.stdout.splitlines()) < 700


@pytest.mark.release
def test_a_length_for_couples_is_told_where_there_are_several_places_or_it_is_a_unit(
    run: Run,
) -> None:
    def told(*more: str) -> str:
        lines = run("analyze", *more).out.splitlines()
        return next(line for line in lines if line.startswith("m = "))

    sizes = ["--set", "cylinder.stroke=60 mm", "--set", "cylinder.reciprocating_mass=300 g"]
    assert told("v2-90", *sizes) == "m = 300 g, r = 30 mm, a = 1000 mm."
    assert told("v2-90", *sizes, "--speed", "6000 rpm") == "m = 300 g, r = 30 mm."
    pitch = ["--set", "layout.bore_pitch=90 mm", "--speed", "6000 rpm"]
    assert told("i4", *sizes, *pitch) == "m = 300 g, r = 30 mm, a = 90 mm."
