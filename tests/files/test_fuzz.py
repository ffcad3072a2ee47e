"""Files spoilt at random give an engine with finite forces or a refusal in sentences."""

from __future__ import annotations

import copy
import json
import random
import sys
import tomllib
from collections.abc import Callable
from io import BytesIO, TextIOWrapper

import jsonschema
import numpy as np
import pytest
from rich.console import Console
from tests.spoilt import NUMBERS, TEXTS, TREES, WORDS, mutated, places
from tests.texts import SHORT, check_sentences

from crankstar import cli
from crankstar.engine.engine import Engine
from crankstar.files import EngineFileError, engine_of, schema, toml, tree_of
from crankstar.firing.intervals import firing
from crankstar.mechanics.balance import balance
from crankstar.tables import analysis as tables
from crankstar.tables import engines as description
from crankstar.tables.terminal import rendered


def accepted(read: Callable[[], Engine]) -> Engine | None:
    """The engine, or None if it is refused in sentences."""
    try:
        return read()
    except EngineFileError as error:
        check_sentences(error)
        return None


def check_answers(engine: Engine) -> None:
    """What is accepted has finite forces, fires, and can be written out and read again."""
    result = balance(engine, speed=engine.speed)
    for spectrum in (result.force, result.couple, result.axis_moment, result.torque):
        assert np.isfinite(spectrum.forward).all()
        assert np.isfinite(spectrum.backward).all()
    if engine.firing_order:
        assert sum(firing(engine).intervals_deg) == pytest.approx(engine.cycle_angle)
    assert engine_of(tree_of(toml(engine))).name == engine.name


def check_pages(engine: Engine) -> None:
    """What is accepted can be shown."""
    page = Console(width=140, markup=False, force_terminal=False)
    with page.capture() as printed:
        for document in (
            tables.document(tables.analysis(engine, speed=engine.speed)),
            description.description(engine),
        ):
            page.print(rendered(document, width=140))
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
                [
                    "",
                    "\n",
                    '"',
                    "[",
                    "]",
                    "{",
                    "=",
                    "#",
                    ",",
                    "0",
                    "-",
                    "e",
                    "\x00",
                    "\x1b",
                    "\u202e",
                    "'''",
                    "\\u0000",
                    "[[x]]\n",
                ]
            )
            text = text[:at] + new + text[at + length :]
        engine = accepted(lambda text=text: engine_of(tree_of(text, name="FILE"), name="FILE"))
        if engine is not None:
            check_answers(engine)


@pytest.mark.release
def test_spoilt_trees_are_engines_or_refused() -> None:
    good = try_trees(range(700))
    assert 100 < good < 600


@pytest.mark.release
@pytest.mark.parametrize("start", range(10_000, 20_000, 2000))
def test_many_more_spoilt_trees_are_engines_or_refused(start: int) -> None:
    assert try_trees(range(start, start + 2000)) > 300


@pytest.mark.release
def test_spoilt_texts_are_engines_or_refused() -> None:
    try_texts(range(500))


@pytest.mark.release
@pytest.mark.parametrize("start", range(10_000, 20_000, 2000))
def test_many_more_spoilt_texts_are_engines_or_refused(start: int) -> None:
    try_texts(range(start, start + 2000))


def test_random_bytes_are_refused() -> None:
    chance = random.Random(1)  # noqa: S311
    for length in (1, 2, 3, 10, 100, 1000, 100_000):
        for _ in range(10):
            text = chance.randbytes(length).decode("latin-1")
            assert accepted(lambda text=text: engine_of(tree_of(text, name="FILE"))) is None


@pytest.mark.release
def test_what_is_accepted_fits_the_schema() -> None:
    validator = jsonschema.Draft202012Validator(schema())
    plain = [
        *(value for value in NUMBERS if abs(value) < 1e300),
        *WORDS,
        None,
        True,
        [],
        {},
        [[]],
        [{}],
        [1, 2],
        ["x"],
    ]
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
        "--theta",
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
        chance.choice([chance.choice(names), chance.choice(options), chance.choice(values)])
        for _ in range(chance.randrange(6))
    ]
    return [chance.choice([*verbs, "analyze", "analyze", "show"]), chance.choice(names[:3]), *rest]


def try_words(
    seeds: range, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for seed in seeds:
        monkeypatch.setattr(
            sys, "stdin", TextIOWrapper(BytesIO(SHORT.encode() if seed % 2 else b""))
        )
        words = spoilt_words(random.Random(seed))  # noqa: S311
        with pytest.raises(SystemExit) as left:
            cli.main(words)
        out, err = capsys.readouterr()
        assert left.value.code in (0, 2), words
        assert (left.value.code == 2) == bool(err), words
        assert all(line.isprintable() for line in [*out.split("\n"), *err.split("\n")]), words


@pytest.mark.release
def test_spoilt_command_lines_end_with_0_or_2(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    try_words(range(150), monkeypatch, capsys)


@pytest.mark.release
def test_many_more_spoilt_command_lines_end_with_0_or_2(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    try_words(range(1000, 4000), monkeypatch, capsys)
