"""What `analyze` says first, and the amplitudes as engineers name them: pitch, yaw and roll."""

from __future__ import annotations

import cmath
import re
from io import StringIO
from math import pi

import numpy as np
import pytest
from rich.cells import cell_len
from rich.console import Console
from tests.catalog import EVERY_ENGINE

from crankstar import load, names, spectra
from crankstar.analysis.document import Remarks, Table
from crankstar.engine.copies import with_values
from crankstar.files import engine_of, explicit
from crankstar.mechanics.balance import balance
from crankstar.mechanics.remains import Sums, summed
from crankstar.tables.analysis import Analysis, analysis, document
from crankstar.tables.balance_orders import answer
from crankstar.tables.cells import cell, heading
from crankstar.tables.conversion import in_units
from crankstar.tables.machine import tree
from crankstar.tables.peaks import part_peaks
from crankstar.tables.terminal import rendered

WAVE = re.compile(r"(\S+) ∠ (\S+)°")


def printed(name: str, *, speed: float | None = None) -> list[str]:
    file = StringIO()
    console = Console(file=file, width=80, highlight=False, markup=False)
    console.print(rendered(document(analysis(load(name), speed=speed)), width=80), crop=False)
    return [line.rstrip() for line in file.getvalue().splitlines()]


@pytest.mark.many(first=2)
@EVERY_ENGINE
def test_the_first_ten_lines_say_how_an_engine_shakes(name: str) -> None:
    lines = printed(name)
    first = lines[: lines.index("")]
    assert len(first) <= 10 + bool(load(name).left_out)  # a line on parts that the file leaves out
    assert max(map(cell_len, first)) <= 80
    text = " ".join(first)
    assert "Forces and moments at" in text or "In m r ω². For newtons" in text
    assert "orce" in text.partition(". ")[2]
    assert "roll" in text.lower()
    assert "Peaks: " in text
    remedies = ("removed by", "No primary or secondary force or couple", "No counterweights in")
    assert any(words in text for words in remedies)


def test_a_bare_crankshaft_is_told_with_what_counterweights_would_leave() -> None:
    said = " ".join(printed("single"))
    assert (
        "No counterweights in the file; with 50 % balanced: a primary force of 0.5 m r ω², "
        "rotating against the crankshaft. Cures: crankstar verdict."
    ) in said
    assert "with two on the end webs: a primary" in " ".join(printed("vw-vr6"))
    for weighted in ("parallel-twin-180", "i4"):  # its own, or none needed
        assert "No counterweights" not in " ".join(printed(weighted))


@pytest.mark.release
@pytest.mark.parametrize(("name", "left"), [("man-s90mc-c", False), ("v12-60", True)])
def test_a_peak_of_less_than_a_millionth_of_what_is_pushed_is_left_out(
    name: str, left: bool
) -> None:
    peaks = next(line for line in printed(name) if line.startswith("Peaks: "))
    assert ("vertical" in peaks) == left
    force = spectra.peak(summed(balance(load(name))).force).value
    assert (force > 1e-6 * len(load(name).cylinders)) == left


@pytest.mark.release
def test_the_first_lines_compare_the_peak_force_with_the_weight_where_it_is_known() -> None:
    from crankstar.engine.records import Block

    engine = with_values(load("v2-90"), block=Block(mass=120.0), relative=())
    sums = summed(balance(engine, speed=600.0))
    share = spectra.peak(sums.force).value / (120.0 * 9.80665)
    text = " ".join(document(analysis(engine, speed=600.0)).parts[0].lines)  # pyright: ignore[reportAttributeAccessIssue]
    said = re.search(r"peak force is (\S+) times the weight of the block of the file, 120 kg", text)
    assert said
    assert float(said[1]) == pytest.approx(share, rel=0.006)
    assert "times the weight" not in " ".join(printed("audi-25-tfsi"))


@pytest.mark.release
def test_the_missing_keys_are_named_and_with_them_the_engine_has_newtons() -> None:
    from crankstar.files.catalog import load as loaded

    example = {
        "cylinder.stroke": "90 mm",
        "cylinder.reciprocating_mass": "500 g",
        "layout.bore_pitch": "100 mm",
        "layout.row_pitch": "150 mm",
        "speed": "5000 rpm",
    }
    count = 0
    for name in names():
        lines = " ".join(printed(name)[:4])
        told = re.search(
            r"(?:newtons|in N m)(?:, add to the file: |: --estimate, or add )([\w., ]+?)\.(?= |$)",
            lines,
        )
        if told is None:
            continue
        count += 1
        if name == "radial-9":  # its knuckle pins are given in crank radii, which are then metres
            continue
        keys = told[1].split(", ")
        engine = loaded(name, changes={key: example[key] for key in keys})
        result = balance(engine, speed=engine.speed)
        assert result.units == ("N", "N*m", "N*m"), (name, keys)
    assert count > 50


def signals(sums: Sums, count: int = 720) -> dict[str, np.ndarray]:
    """Each part over one turn, from the vectors themselves."""
    angles = np.arange(count) * 2 * pi / count
    force, couple = (
        np.asarray(spectra.value(vector, angles), complex) for vector in (sums.force, sums.couple)
    )
    return {
        "vertical": np.real(force),
        "horizontal": np.imag(force),
        "pitch": np.real(couple),
        "yaw": np.imag(couple),
        "roll": np.real(np.asarray(spectra.value(sums.roll, angles))),
    }


def columns_of(table: Table, order: float) -> dict[str, complex]:
    """The printed amplitudes of an order, read back, by the first word of their heading."""
    shown = in_units(table)
    row = next(row for row in shown.rows if row[0] == order)
    out: dict[str, complex] = {}
    for column, value in zip(shown.columns, row, strict=True):
        if column.kind != "wave":
            continue
        text, factor = cell(column, value), 1e3 if heading(column)[1].startswith("[k") else 1.0
        match = WAVE.fullmatch(text)
        word = heading(column)[0].split()[0]
        size, phase = (float(match[1]), float(match[2])) if match else (0.0, 0.0)
        out[word] = cmath.rect(size * factor, np.radians(phase))
    return out


@pytest.mark.release
@pytest.mark.parametrize("name", ["audi-25-tfsi", "subaru-ej25", "v8-cross-plane", "harley-45"])
def test_printed_amplitudes_are_those_of_the_turning_engine(name: str) -> None:
    engine = with_values(load(name), relative=())
    parts = document(analysis(engine, speed=100.0)).parts
    tables = {part.title: part for part in parts if isinstance(part, Table)}
    over_turn = signals(summed(balance(engine, speed=100.0)))
    spectrum = {key: np.fft.rfft(values) / 360 for key, values in over_turn.items()}
    largest = {"force": 0.0, "moment": 0.0}
    for key, values in over_turn.items():
        kind = "force" if key in ("vertical", "horizontal") else "moment"
        largest[kind] = max(largest[kind], float(np.abs(values).max()))
    compared = 0
    for title, words in (
        ("Force on the block", ("vertical", "horizontal")),
        ("Couple on the block", ("pitch", "yaw")),
        ("Moments about the crank axis", ("rolling",)),
    ):
        for row in tables[title].rows:
            order = row[0]
            assert isinstance(order, float)
            found = columns_of(tables[title], order)
            for word in words:
                expected = complex(spectrum["roll" if word == "rolling" else word][int(order)])
                least = 1e-8 * largest["force" if title.startswith("Force") else "moment"]
                assert found[word] == pytest.approx(expected, rel=3e-4, abs=least)
                compared += 1
    assert compared > 3


@pytest.mark.release
@pytest.mark.parametrize("name", ["audi-25-tfsi", "v8-cross-plane", "kr250-racer", "radial-9"])
def test_the_peak_of_a_part_is_the_greatest_of_many_angles(name: str) -> None:
    result = balance(load(name), speed=None)
    sums = summed(result)
    sampled = {key: np.abs(values).max() for key, values in signals(sums, 7200).items()}
    for key, (size, angle, _unit) in part_peaks(result, sums).items():
        assert size == pytest.approx(sampled[key], rel=1e-5, abs=1e-9), key
        assert 0 <= angle < 4 * pi


def test_positive_pitch_lifts_the_front() -> None:
    """Cylinder 1 of a twin at 180 deg is in front; at its top dead centre it pulls the front up."""
    engine = load("parallel-twin-180")
    front = min(engine.cylinders, key=lambda cylinder: cylinder.number)
    assert front.z == max(cylinder.z for cylinder in engine.cylinders)
    first = tree(answer(engine, balance(engine)))["orders"][0]
    assert first["pitch"]["amplitude"] > 0.1
    assert first["pitch"]["phase_deg"] == pytest.approx(0.0, abs=1e-9)


def test_json_has_pitch_yaw_and_the_peaks() -> None:
    engine = load("audi-25-tfsi")
    result = balance(engine, speed=engine.speed)
    shown = tree(answer(engine, result))
    for row in shown["orders"]:
        assert row["pitch"] == row["couple"]["vertical"]
        assert row["yaw"] == row["couple"]["horizontal"]
    peaks = {row["quantity"]: row for row in shown["peaks"]}
    assert [*peaks] == ["vertical", "horizontal", "pitch", "yaw", "roll"]
    assert peaks["pitch"]["peak"] == pytest.approx(spectra.peak(summed(result).couple).value)
    assert peaks["pitch"]["unit"] == "N*m"


def test_turning_vectors_are_printed_where_they_are_asked_for() -> None:
    shown = analysis(load("boxer-2"), speed=None)
    assert "Turning vectors" not in [part.title for part in document(shown).parts]
    parts = document(shown, vectors=True).parts
    table = next(part for part in parts if part.title == "Turning vectors")
    assert isinstance(table, Table)
    sums = summed(shown.best)
    for order, *vectors in table.rows:
        assert isinstance(order, float)
        expected = [
            complex(getattr(spectra.selected(vector, [order]), way)[0])
            for vector in (sums.force, sums.couple)
            for way in ("forward", "backward")
        ]
        assert vectors == pytest.approx(expected, abs=1e-9)


@pytest.mark.release
def test_a_rod_that_is_assumed_is_told_at_the_head_and_one_that_is_given_is_not() -> None:
    layout = {"type": "inline", "throws": ["0 deg", "180 deg"]}
    bare = engine_of({"name": "twin", "layout": layout})
    for engine in (bare, engine_of(explicit(bare))):
        first, *_rest, doubt = read(analysis(engine, speed=None))
        assert "Assumed: rod length (r/l = 0.25)." in first
        assert "Unverified" not in doubt
    known = engine_of({"name": "twin", "layout": layout, "cylinder": {"rod_ratio": 4.0}})
    assert "Assumed" not in " ".join(read(analysis(known, speed=None)))


def read(shown: Analysis) -> list[str]:
    """The lines before the tables."""
    return [
        line for part in document(shown).parts if isinstance(part, Remarks) for line in part.lines
    ]
