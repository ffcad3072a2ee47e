"""The catalog: every file loads, fires as it says, and says of every value where it comes from."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from tools.catalog_lists import lists

import crankstar
from crankstar import spectra
from crankstar.analyses.verdict.relatives import BALANCES
from crankstar.files import engine_of, toml, tree_of
from crankstar.files.catalog import SUMMARIES, path_of
from crankstar.firing.intervals import firing
from crankstar.mechanics.balance import balance, total

pytestmark = pytest.mark.quick

NAMES = crankstar.names()
NOT_VALUES = {
    "format": "the version of the file format",
    "name": "what we call the engine",
    "cycle": "part of what the engine is",
    "source": "provenance itself",
    "notes": "words",
    "left_out": "words",
    "provenance": "provenance itself",
    "layout.type": "part of what the engine is",
}
NAMES_IN_TABLES = {"name", "bank"}
"""What banks and shafts are called, wherever it stands."""
WITHOUT_FIRING_ORDER = {"napier-lion": "not known"}
REAL = {
    "single": {"bmw-g650"},
    "in-line two": {"bmw-f800", "fiat-twinair", "parallel-twin-180", "yamaha-mt-07"},
    "in-line three": {"triumph-675"},
    "in-line four": {"suzuki-hayabusa", "honda-b18c"},
    "cross-plane four": {"yamaha-r1-crossplane"},
    "in-line five": {"audi-25-tfsi"},
    "in-line six": {"toyota-2jz", "bmw-m52b28", "mwm-6-diesel", "rolls-royce-six-1928"},
    "V2": {"harley-45", "ducati-90", "ducati-900ss"},
    "V6 60": {"ford-cologne"},
    "V6 90 split-pin": {"gm-3800", "ford-essex-42", "international-vt275"},
    "VR6": {"vw-vr6"},
    "V8 cross-plane": {
        "bmw-s65",
        "ford-coyote",
        "ford-46-sohc",
        "gm-l76",
        "porsche-cayenne-48",
        "toyota-1uz-fe",
        "cadillac-ld8",
        "rover-v8-39",
    },
    "V8 flat-plane": {"ferrari-f136"},
    "V12": {"merlin"},
    "W12": {"napier-lion"},
    "H4": {"brough-golden-dream"},
    "boxer": {"bmw-r1200", "subaru-ej25"},
    "radial with articulated rods": {"pratt-whitney-wasp"},
    "opposed piston": {"jumo-205", "napier-deltic"},
    "tandem twin": {"kr250-racer", "kr250-racer-simultaneous", "kr250-production"},
    "marine two-stroke": {"man-s50mc-c", "man-s90mc-c"},
}


def tree(name: str) -> dict[str, Any]:
    path = path_of(name)
    assert path is not None
    return tomllib.loads(path.read_text(encoding="utf-8"))


def leaves(value: Any, path: str = "") -> Iterator[str]:
    """The key path of every value in a file, without the indices of lists."""
    if isinstance(value, dict):
        for key, item in value.items():
            yield from leaves(item, f"{path}.{key}" if path else key)
    elif isinstance(value, list) and any(isinstance(item, dict | list) for item in value):
        for item in value:
            yield from leaves(item, path)
    else:
        yield path


def covers(key: str, path: str) -> bool:
    """Whether an entry is of a value; `gas.point[2].speed` is that of one table in a list."""
    key = re.sub(r"\[\d+\]", "", key)
    return path == key or path.startswith(f"{key}.")


def values(name: str) -> list[str]:
    """The key paths of all that is a value rather than a name or words."""
    paths = dict.fromkeys(leaves(tree(name)))
    return [
        path
        for path in paths
        if not any(covers(key, path) for key in NOT_VALUES)
        and path.rpartition(".")[2] not in NAMES_IN_TABLES
    ]


@pytest.mark.parametrize("name", NAMES)
def test_every_value_of_every_engine_has_a_provenance(name: str) -> None:
    told = tree(name)["provenance"]
    assert [path for path in values(name) if not any(covers(key, path) for key in told)] == []


@pytest.mark.parametrize("name", NAMES)
def test_every_provenance_points_to_a_value_that_is_there_and_names_its_source(name: str) -> None:
    present = list(leaves(tree(name)))
    for key, told in tree(name)["provenance"].items():
        assert any(covers(key, path) for path in present), key
        assert set(told) == {"status", "source"}, key
        assert told["source"].strip(), key


@pytest.mark.parametrize("name", NAMES)
def test_every_engine_says_where_it_comes_from_and_how_long_its_rods_are(name: str) -> None:
    whole = tree(name)
    assert whole["source"].strip()
    told = set(whole.get("cylinder", {})) | {
        key for cylinder in whole.get("cylinders", []) for key in cylinder
    }
    assert told & {"rod_length", "rod_ratio"}  # none is silently assumed


@pytest.mark.parametrize("name", NAMES)
def test_every_engine_fires_as_it_says(name: str) -> None:
    engine = crankstar.load(name)
    fired = firing(engine)
    assert bool(fired.order) == (name not in WITHOUT_FIRING_ORDER)
    if fired.order:
        assert sum(fired.intervals_deg) == pytest.approx(engine.cycle_angle, abs=1e-6)


@pytest.mark.parametrize("name", NAMES)
def test_every_engine_begins_with_cylinder_1_in_front(name: str) -> None:
    engine = crankstar.load(name)
    assert engine.first.number == 1
    assert engine.first.z >= max(cylinder.z for cylinder in engine.cylinders) - 1e-12


@pytest.mark.parametrize("name", NAMES)
def test_every_engine_is_the_same_when_written_out_and_read_again(name: str) -> None:
    engine = crankstar.load(name)
    again = engine_of(tree_of(toml(engine)))
    for ours, theirs in zip(total(balance(engine)), total(balance(again)), strict=True):
        same = spectra.selected(theirs, ours.orders)  # the highest orders come and go with rounding
        assert np.allclose(ours.forward, same.forward, rtol=0, atol=1e-9)
        assert np.allclose(ours.backward, same.backward, rtol=0, atol=1e-9)


@pytest.mark.parametrize("name", NAMES)
def test_lengths_along_the_shaft_are_counted_in_pitches_where_the_file_gives_none(
    name: str,
) -> None:
    engine, layout = crankstar.load(name), tree(name).get("layout", {})
    given = any(key in layout for key in ("bore_pitch", "row_pitch", "positions")) or isinstance(
        layout.get("bank_offset"), str
    )
    spread = len({cylinder.z for cylinder in engine.cylinders}) > 1
    if spread and layout:
        assert ("pitch" in engine.relative) is not given


def test_names_are_kebab_case_and_titles_unique() -> None:
    titles = [crankstar.load(name).name for name in NAMES]
    assert len(set(titles)) == len(titles)
    assert [name for name in NAMES if not re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", name)] == []


def test_the_lists_of_the_catalog_are_those_that_its_engines_give() -> None:
    """Titles and counts to the letter, balances to rounding; `make catalog` writes them."""
    made = lists()
    assert SUMMARIES.read_text(encoding="utf-8") == made[SUMMARIES]
    kept, anew = (
        [line.split("\t") for line in text.splitlines()]
        for text in (BALANCES.read_text(encoding="utf-8"), made[BALANCES])
    )
    assert [name for name, *_values in kept] == [name for name, *_values in anew]
    numbers = (np.array([values for _name, *values in rows], float) for rows in (kept, anew))
    assert np.allclose(*numbers, rtol=1e-9, atol=1e-12)


def test_real_engines_of_every_layout_are_there() -> None:
    real = set().union(*REAL.values())
    assert sorted(real - set(NAMES)) == []
    with_a_source = {
        name
        for name in real
        if any(told["status"] == "published" for told in tree(name)["provenance"].values())
    }
    assert len(with_a_source) >= 12
