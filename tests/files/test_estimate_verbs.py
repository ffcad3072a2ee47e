"""Every verb on an engine with estimated masses: nothing in newtons or grams without its mark."""

from __future__ import annotations

import csv
import re
from collections.abc import Callable
from io import StringIO
from pathlib import Path

import pytest
from tests.commands import Run

UNIT = r"(?:[kM]?N(?: m)?|k?g(?: mm| m)?)"
"""Units of what rests on masses, as they are printed."""
SHOWN = re.compile(rf"\[{UNIT}\]|[\d)] {UNIT}(?![\w/])")
RECORD = re.compile(r"[^\n]* (?:also )?rests? on:\n")
"""What numbers rest on, with ranges of its own."""
COLUMN = re.compile(r"(.+?)(?:_amplitude|_up|_right)? \[(N|N\*m|g|kg|kg\*m)\]")
HOLES = ("--at-radius", "80 mm", "--diameter", "30 mm", "--greatest-depth", "35 mm")
VERBS = (
    ("analyze",),
    ("analyze", "--by", "cylinder"),
    ("analyze", "--theta", "30 deg"),
    ("analyze", "--vectors"),
    ("analyze", "--speeds", "1000..3000 rpm by 1000"),
    ("balance", "--factor", "0.4"),
    ("bearings",),
    ("bobweight",),
    ("compare", "audi-25-tfsi"),
    ("derive",),
    ("drill", "--factor", "0.3", *HOLES),
    ("show",),
    ("sweep", "--over", "speed=1000..3000 rpm/3"),
    ("verdict",),
)
READ = ("balance", "derive", "show", "verdict")
"""Verbs that print for readers only, as --theta and --vectors do."""
TABLES = tuple(
    words for words in VERBS if words[0] not in READ and not {"--theta", "--vectors"} & {*words}
)


@pytest.fixture
def weighted(run: Run, tmp_path: Path) -> str:
    """A V8 with estimated masses and the counterweights that suit the typical ones."""
    place = tmp_path / "v8.toml"
    run("balance", "bmw-s65", "--estimate", "--weights", "ends", "-o", str(place))
    return str(place)


@pytest.mark.release
@pytest.mark.many(first=1)
@pytest.mark.parametrize("words", VERBS, ids=" ".join)
def test_what_is_printed_in_newtons_or_grams_is_marked(
    words: tuple[str, ...], run: Run, weighted: str
) -> None:
    """Where a table or a paragraph has a number that rests on masses it says "estimated"."""
    verb, *options = words
    printed = run(verb, weighted, *options)
    assert printed.code == 0, printed.err
    blocks = printed.out.split("\n\n")
    blocks = [block for block in blocks if not RECORD.match(block)]
    weighed = [block for block in blocks if SHOWN.search(block)]
    assert weighed or verb == "derive"  # which tells rounding from zero: nothing is left
    assert [block for block in weighed if "estimated" not in block] == []


@pytest.mark.release
@pytest.mark.parametrize("words", TABLES, ids=" ".join)
def test_what_is_written_for_machines_has_its_range(
    words: tuple[str, ...], run: Run, weighted: str
) -> None:
    """A column of CSV in a unit of mass has its ends beside it, or its rows say what they are."""
    verb, *options = words
    rows = csv.reader(StringIO(run(verb, weighted, *options, "--csv").out))
    head = next(rows)
    values = dict(zip(head, zip(*rows, strict=False), strict=False))
    for name in head:
        column = COLUMN.fullmatch(name)
        if column is None or name.endswith(("_low [g]", "_high [g]")):
            continue
        stem = re.sub("_(low|high)$", "", column[1])
        told = f"{stem}_estimated" in head or "made_for" in head
        assert told or not any(float(value or 0) for value in values[name]), name


@pytest.mark.release
def test_holes_for_estimated_weights_are_those_for_the_typical_ones(
    run: Run, weighted: str
) -> None:
    """The unbalance has its range, the hole is what the typical unbalance needs by itself."""
    (row,) = list(
        csv.DictReader(StringIO(run("drill", weighted, "--factor", "0.3", *HOLES, "--csv").out))
    )[:1]
    unbalance = float(row["unbalance [kg*m]"])
    assert float(row["unbalance_low [kg*m]"]) < unbalance < float(row["unbalance_high [kg*m]"])
    measured = f"{unbalance!r} kg*m"
    (alone,) = csv.DictReader(StringIO(run("drill", "--unbalance", measured, *HOLES, "--csv").out))
    for name in ("count", "depth_mm [mm]", "mass_g [g]"):
        assert float(row[name]) == pytest.approx(float(alone[name]), rel=1e-9)
    assert row["made_for"] == "typical unbalance (estimated)"
    assert "made_for" not in alone


def test_holes_that_are_too_few_for_estimated_weights_are_refused_in_plain_numbers(
    refused: Callable[..., str],
) -> None:
    """The values that numbers carry for their ranges are in no refusal."""
    told = refused("drill", "bmw-s65", "--estimate", *HOLES)
    assert told.replace("\n", "").isprintable()
    assert re.search(r"an unbalance of [\d.]+ kg mm is more than holes of 30 mm", told)


def test_an_estimate_without_an_engine_has_no_effect_on_a_measured_unbalance(
    refused: Callable[..., str],
) -> None:
    """What the machine shows is not estimated."""
    told = refused("drill", "--unbalance", "850 g*mm", "--estimate", *HOLES)
    assert "--estimate has no effect without ENGINE" in told


@pytest.mark.release
def test_a_length_that_replaces_its_estimate_leaves_what_moved_with_it(
    run: Run, tmp_path: Path
) -> None:
    """The centre of a rod has its own range where the length is no longer estimated."""
    place, file = str(tmp_path / "twin.toml"), tmp_path / "bare.toml"
    file.write_text(
        'name = "Twin"\ncycle = "four-stroke"\nspeed = "7000 rpm"\n'
        '[layout]\ntype = "inline"\nthrows = ["0 deg", "0 deg"]\n'
        '[cylinder]\nbore = "83 mm"\nstroke = "60 mm"\n'
    )
    assert run("estimate", str(file), "-o", place).code == 0
    assert 'moves_with = "cylinder.rod_length"' in Path(place).read_text()
    given = ("--set", 'cylinder.rod_length="120 mm"')
    shown = run("analyze", place, *given)
    assert (shown.code, shown.err) == (0, "")
    estimated = shown.out.split("What rests on them")[0]
    assert "cylinder.rod.centre" in estimated
    assert "rod_length" not in estimated
    assert "(estimated)" in shown.out
    swept = run("sweep", place, "--over", "cylinder.rod_length=110..130 mm/3")
    assert (swept.code, swept.err) == (0, "")
