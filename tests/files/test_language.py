"""The language of a command line: asked for, by a variable, of the system; none for machines."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from tests.commands import Run

NO_FORCE = {"en": "No primary force.", "ja": "一次慣性力なし。", "ru": "Силы 1-го порядка нет."}
MACHINE = [
    "analyze kr250-racer --by shaft --csv",
    "analyze v8-cross-plane --json",
    "bearings audi-25-tfsi --json",
    "compare i4 v8-flat-plane --csv",
    "orders v8-cross-plane --json",
    "search 3 --json",
    "strokes v8-cross-plane --json",
    "sweep i4 --over cylinder.rod_ratio=3..4/2 --csv",
]


def told(run: Run, *words: str) -> str:
    """The language of a verdict."""
    out = run(*words, "verdict", "i4").out
    (language,) = [language for language, sentence in NO_FORCE.items() if sentence in out]
    return language


@pytest.mark.release
def test_a_language_is_asked_for_by_its_long_name_or_by_its_short_one(run: Run) -> None:
    for language in NO_FORCE:
        assert told(run, "--language", language) == language
        assert told(run, f"--lang={language}") == language


def test_an_option_goes_before_the_variable_and_that_before_the_system(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert told(run) == "en"
    monkeypatch.setenv("LC_ALL", "ru_RU.UTF-8")
    assert told(run) == "ru"
    monkeypatch.setenv("CRANKSTAR_LANG", "ja")
    assert told(run) == "ja"
    assert told(run, "--language", "en") == "en"


@pytest.mark.parametrize(
    ("system", "language"),
    [
        ({"LANG": "ja_JP.UTF-8"}, "ja"),
        ({"LANG": "ja"}, "ja"),
        ({"LANG": "C", "LC_MESSAGES": "ja_JP.eucJP"}, "ja"),
        ({"LANG": "ja_JP", "LC_MESSAGES": "ru_RU@cyrillic", "LC_ALL": ""}, "ru"),
        ({"LANG": "ja_JP", "LC_ALL": "C.UTF-8"}, "en"),
        ({"LANG": "de_DE.UTF-8"}, "en"),
        ({"LANG": "ja_JP", "LC_MESSAGES": "POSIX"}, "en"),
        ({}, "en"),
    ],
)
def test_the_first_variable_of_the_system_that_is_set_decides(
    system: dict[str, str], language: str, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("LC_ALL", "LC_MESSAGES", "LANG"):
        monkeypatch.delenv(name, raising=False)
    for name, value in system.items():
        monkeypatch.setenv(name, value)
    assert told(run) == language


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ("analyze", "コマンド analyze の ENGINE に値がない。"),
        ("analyze i4 --jsn", "未知のオプション: --jsn。--json の誤りではないか。"),
        ("analyse i4", '未知のコマンド "analyse"。"analyze" の誤りではないか。'),
        ("list --cylinders x", '--cylinders の値 "x" は整数ではない。'),
        ("analyze i4 --json=maybe", '--json の値 "maybe" は yes でも no でもない。'),
        ("search 4 --limit M1", "--limit: M1: 量とその上限を与える"),
    ],
)
def test_what_is_wrong_with_a_command_line_is_told_in_the_language_asked_for(
    words: str, sentence: str, refused: Callable[..., str]
) -> None:
    first, *others = refused("--language", "ja", *words.split()).splitlines()
    assert sentence in first
    assert not others or others[0].startswith("参照: crankstar ")


def test_a_language_that_is_not_there_is_refused_with_those_that_are(
    refused: Callable[..., str], monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = refused("--language", "fr", "list")
    assert asked == 'crankstar: --language "fr": the languages are en, ja, ru\n'
    monkeypatch.setenv("CRANKSTAR_LANG", "fr")
    assert refused("list") == 'crankstar: CRANKSTAR_LANG "fr": the languages are en, ja, ru\n'


@pytest.mark.release
@pytest.mark.parametrize("words", MACHINE)
def test_what_programs_read_is_the_same_in_every_language(words: str, run: Run) -> None:
    english = run(*words.split()).out
    assert len(english) > 100
    assert run("--language", "ja", *words.split()).out == english
    assert run("--language", "ru", *words.split()).out == english
