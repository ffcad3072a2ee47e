"""Good files spoilt at random: each is an engine with finite forces, or refused in sentences; nothing else, and soon."""

from __future__ import annotations

import copy
import datetime
import json
import random
import sys
import time
import tomllib
from collections.abc import Callable
from contextlib import suppress
from io import BytesIO, TextIOWrapper
from typing import Any

import jsonschema
import numpy as np
import pytest
from rich.console import Console
from tests.texts import EXPLICIT, SHORT, check_sentences

import crankstar
from crankstar import cli, description, tables
from crankstar.balance import balance
from crankstar.catalog import path_of
from crankstar.engine import Engine
from crankstar.files import EngineFileError, engine_of, explicit, schema, toml, tree_of
from crankstar.files.starters import STARTERS
from crankstar.firing import firing

GREATEST_TIME = 2.0
"""Seconds that any file at all may take, on a machine that has other things to do."""

TEXTS = [path.read_text(encoding="utf-8") for name in crankstar.names() if (path := path_of(name))]
TEXTS += [*STARTERS.values(), SHORT, EXPLICIT]
SHORT_TREES = [tomllib.loads(text) for text in TEXTS]
TREES = SHORT_TREES + [explicit(engine_of(tree)) for tree in SHORT_TREES]

NUMBERS: list[Any] = [0, 1, -1, 2, 0.0, -0.0, 1e-300, 1e300, float("nan"), float("inf"), -float("inf"), 10**30, 10**400, 3.5]
WORDS = ["", " ", "x", "1 mm", "-1 mm", "0 mm", "nan mm", "1e400 mm", "90 deg", "650 g", "6000 rpm", "1/0", "29/31", "-1", "vee"]
WORDS += ["\x1b[31m", "\u202e", "a" * 300, "\ud800", "bank 1", "crank"]
OTHERS: list[Any] = [
    None,
    True,
    False,
    [],
    {},
    [[]],
    [{}],
    {"a": 1},
    [1, 2],
    ["x"],
    datetime.date(2020, 1, 1),
    (1, 2),
    b"x",
    1 + 2j,
]
ODD = [*NUMBERS, *WORDS, *OTHERS]

Box = Any
"""A table or a list of a tree."""


def places(tree: Box) -> list[tuple[Box, Any]]:
    """Every key of every table and every index of every list, each with the table or list it is in."""
    pairs = tree.items() if isinstance(tree, dict) else enumerate(tree) if isinstance(tree, list) else ()
    return [place for key, value in pairs for place in ((tree, key), *places(value))]


def delete(box: Box, key: Any, _: random.Random) -> None:
    del box[key]


def replace(box: Box, key: Any, chance: random.Random) -> None:
    box[key] = copy.deepcopy(chance.choice(ODD))


def scale(box: Box, key: Any, chance: random.Random) -> None:
    value, factor = box[key], 10.0 ** chance.choice([-9, -6, -4, -3, -2, -1, 1, 2, 3, 4, 6, 9, 12])
    if isinstance(value, str):
        number, _, unit = value.partition(" ")
        box[key] = f"{float(number) * factor:g} {unit}"
    else:
        box[key] = value * (chance.choice([-1, 0, 2, 10, 1000]) if isinstance(value, int) else factor)


def duplicate(box: Box, key: Any, _: random.Random) -> None:
    if isinstance(box, list):
        box.insert(key, copy.deepcopy(box[key]))
    else:
        box[f"{key}s"] = copy.deepcopy(box[key])


def rename(box: Box, key: Any, chance: random.Random) -> None:
    box[f"{key}{chance.choice(['s', '_', 'x'])}"] = box[key]
    del box[key]


def shift(box: Box, key: Any, chance: random.Random) -> None:
    box[key] += chance.choice([-1, 1, 0.5])


def shuffle(box: Box, key: Any, chance: random.Random) -> None:
    chance.shuffle(box[key])


def misspell(box: Box, key: Any, chance: random.Random) -> None:
    at = chance.randrange(len(box[key]))
    box[key] = box[key][:at] + chance.choice("0-+e. mxdegk\x00") + box[key][at + 1 :]


Mutation = Callable[[Box, Any, random.Random], None]
MUTATIONS: list[Mutation] = [delete, replace, scale, scale, duplicate, rename, shift, shuffle, misspell]


def mutated(tree: dict[str, Any], chance: random.Random) -> dict[str, Any]:
    """A copy of a tree with one to six things changed."""
    out = copy.deepcopy(tree)
    for _ in range(chance.choice([1, 1, 1, 2, 3, 6])):
        there = places(out)
        if there:
            box, key = chance.choice(there)
            with suppress(TypeError, ValueError, OverflowError, AttributeError, KeyError):  # not all changes go with all values
                chance.choice(MUTATIONS)(box, key, chance)
    return out


def accepted(read: Callable[[], Engine]) -> Engine | None:
    """The engine, or None if it is refused in sentences; in good time."""
    begin = time.process_time()
    try:
        engine = read()
    except EngineFileError as error:
        check_sentences(error)
        engine = None
    assert time.process_time() - begin < GREATEST_TIME
    return engine


def check_answers(engine: Engine) -> None:
    """What is accepted has finite forces, fires, and can be written out and read again."""
    result = balance(engine, speed=engine.speed)
    for spectrum in (result.force, result.couple, result.roll, result.torque):
        assert np.isfinite(spectrum.forward).all()
        assert np.isfinite(spectrum.backward).all()
    if engine.firing_order:
        assert sum(firing(engine).intervals_deg) == pytest.approx(engine.cycle_angle)
    assert engine_of(tree_of(toml(engine))).name == engine.name


def check_pages(engine: Engine) -> None:
    """What is accepted can be shown."""
    page = Console(width=140, markup=False, force_terminal=False)
    with page.capture() as printed:
        page.print(tables.report(tables.analysis(engine, speed=engine.speed)), description.description(engine))
    assert engine.name in printed.get()


def try_trees(seeds: range) -> int:
    """Change trees at random and read them; how many were accepted."""
    good = 0
    for seed in seeds:
        chance = random.Random(seed)  # noqa: S311
        tree = mutated(chance.choice(TREES), chance)
        engine = accepted(lambda tree=tree: engine_of(tree, name="FILE"))
        if engine is not None:
            good += 1
            check_answers(engine)
            if seed % 10 == 0:
                check_pages(engine)
    return good


def try_texts(seeds: range) -> None:
    """Change the letters of files at random and read them."""
    for seed in seeds:
        chance = random.Random(seed)  # noqa: S311
        text = chance.choice(TEXTS)
        text = json.dumps(tomllib.loads(text)) if seed % 3 == 0 else text
        for _ in range(chance.choice([1, 1, 2, 10])):
            at, length = chance.randrange(len(text) + 1), chance.choice([0, 0, 1, 1, 5, 50])
            new = chance.choice(
                ["", "\n", '"', "[", "]", "{", "=", "#", ",", "0", "-", "e", "\x00", "\x1b", "\u202e", "'''", "\\u0000", "[[x]]\n"]
            )
            text = text[:at] + new + text[at + length :]
        engine = accepted(lambda text=text: engine_of(tree_of(text, name="FILE"), name="FILE"))
        if engine is not None:
            check_answers(engine)


def test_spoilt_trees_are_engines_or_refused() -> None:
    good = try_trees(range(700))
    assert 100 < good < 600


@pytest.mark.long
@pytest.mark.parametrize("start", range(10_000, 20_000, 2000))
def test_many_more_spoilt_trees_are_engines_or_refused(start: int) -> None:
    assert try_trees(range(start, start + 2000)) > 300


def test_spoilt_texts_are_engines_or_refused() -> None:
    try_texts(range(500))


@pytest.mark.long
@pytest.mark.parametrize("start", range(10_000, 20_000, 2000))
def test_many_more_spoilt_texts_are_engines_or_refused(start: int) -> None:
    try_texts(range(start, start + 2000))


def test_random_bytes_are_refused() -> None:
    chance = random.Random(1)  # noqa: S311
    for length in (1, 2, 3, 10, 100, 1000, 100_000):
        for _ in range(10):
            text = chance.randbytes(length).decode("latin-1")
            assert accepted(lambda text=text: engine_of(tree_of(text, name="FILE"))) is None


def test_what_is_accepted_fits_the_schema() -> None:
    validator = jsonschema.Draft202012Validator(schema())
    plain = [*(value for value in NUMBERS if abs(value) < 1e300), *WORDS, None, True, [], {}, [[]], [{}], [1, 2], ["x"]]
    for seed in range(300):
        chance = random.Random(seed)  # noqa: S311
        tree = copy.deepcopy(chance.choice(TREES))
        box, key = chance.choice(places(tree))
        box[key] = copy.deepcopy(chance.choice(plain))
        engine = accepted(lambda tree=tree: engine_of(tree))
        assert engine is None or box[key] is None or validator.is_valid(tree), (seed, key, box[key])


def spoilt_words(chance: random.Random) -> list[str]:
    """A command line as a cat writes it."""
    verbs = ["list", "show", "analyze", "compare", "check", "new", "schema"]
    options = [
        "--speed",
        "--orders",
        "--reference",
        "--set",
        "--json",
        "--csv",
        "--explicit",
        "--cylinders",
        "--layout",
        "--by",
        "--at",
    ]
    names = ["single", "v8-flat-plane", "-", "none", "vee", "", "x.toml", "--", "."]
    values = [
        *WORDS,
        "1,2",
        "1,,2",
        "all",
        "nan",
        "1e999",
        "0 mm, 1 mm, 0 mm",
        "layout.x=1",
        "name=y",
        "a.b.c=1",
        "bank",
        "9" * 400,
    ]
    rest = [
        chance.choice([chance.choice(names), chance.choice(options), chance.choice(values)]) for _ in range(chance.randrange(6))
    ]
    return [chance.choice([*verbs, "analyze", "analyze", "show"]), chance.choice(names[:3]), *rest]


def try_words(seeds: range, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    for seed in seeds:
        monkeypatch.setattr(sys, "stdin", TextIOWrapper(BytesIO(SHORT.encode() if seed % 2 else b"")))
        words = spoilt_words(random.Random(seed))  # noqa: S311
        begin = time.process_time()
        with pytest.raises(SystemExit) as left:
            cli.main(words)
        assert time.process_time() - begin < GREATEST_TIME
        out, err = capsys.readouterr()
        assert left.value.code in (0, 2), words
        assert (left.value.code == 2) == bool(err), words
        assert all(line.isprintable() for line in [*out.split("\n"), *err.split("\n")]), words


def test_spoilt_command_lines_end_with_0_or_2(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    try_words(range(150), monkeypatch, capsys)


@pytest.mark.long
def test_many_more_spoilt_command_lines_end_with_0_or_2(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    try_words(range(1000, 4000), monkeypatch, capsys)
