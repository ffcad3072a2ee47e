"""The message catalogs fit the sources, and the translations fit the sentences they translate."""

from __future__ import annotations

import ast
import gettext
import json
import re
import runpy
import string
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from babel.messages.catalog import Catalog

import crankstar
from crankstar import charts, cli
from crankstar.analyses.strokes import RECORD as STROKES
from crankstar.language.messages import LANGUAGES, _, _n, spoken

pytestmark = pytest.mark.quick

TOOL = runpy.run_path(str(Path(__file__).resolve().parents[2] / "tools/messages.py"))
DOMAINS = {"python": TOOL["PYTHON"], "page": TOOL["PAGE"]}
TRANSLATIONS = [
    pytest.param(domain, language, path, id=f"{name} {language}")
    for name, domain in DOMAINS.items()
    for language, path in domain.translations().items()
]
CALL = re.compile(r"(?<![.\w])(?:t|message|plural)\(\s*['\"`]")
"""A call with a message in TypeScript, seen without any knowledge of the language."""
LETTERS = {"ja": "[\u3040-\u30ff\u4e00-\u9fff]", "ru": "[\u0400-\u04ff]"}
"""A letter that a translation has."""
NAMES = {
    "PNG, {times} ×",
    "SI",
    "The Kawasaki KR250",
    "at z = {z}",
    "escape",
    "page up, page down",
    "rpm",
    "zero",
    "{low} to {high}",
    "{angle} deg",
    "{name} of {owner}",
    "{size} at {angle}°",
    "{speed} rpm",
    "{values} in {unit}",
    "({low} to {high})",
    "° of {cycle}",
}
"""Texts of names, numbers and units, in which a translation may have no letter of its own."""
TYPED = re.compile(
    r"`[^`]+`|--[a-z][a-z-]*|\b[a-z]{2,}(?:[._][a-z]{2,})+\b|(?<!\S)\.[a-z]{2,}\b"
    r"|\"[^\"{.?, ][^\"{]*\""
)
"""What a reader types: commands, options, key paths, suffixes, examples in quotation marks."""


def forms(text: str | tuple[str, ...] | list[str]) -> list[str]:
    return [text] if isinstance(text, str) else list(text)


def placeholders(text: str) -> list[str]:
    """In order of the alphabet, each as often as it stands there: a sentence is not said twice."""
    return sorted(name for _, name, _, _ in string.Formatter().parse(text) if name is not None)


def bare(sentence: str) -> str:
    """A sentence without its placeholders and what is typed."""
    return TYPED.sub("", re.sub(r"{\w*}", "", sentence))


def entries(path: Path, language: str | None = None) -> dict[Any, Any]:
    return {message.id: message.string for message in TOOL["read"](path, language) if message.id}


@cache
def collected(name: str) -> list[Any]:
    """The sentences of the sources of a domain, whatever its template has."""
    return [message.id for message in DOMAINS[name].collected() if message.id]


@pytest.mark.release
@pytest.mark.parametrize("domain", DOMAINS.values(), ids=DOMAINS)
def test_the_template_has_every_sentence_of_the_sources_and_no_other(domain: Any) -> None:
    assert domain.template.read_text(encoding="utf-8") == TOOL["text"](domain.collected()), (
        "run `make messages`"
    )


@pytest.mark.release
def test_the_extractor_sees_every_sentence_in_python() -> None:
    """It passes over one in parentheses of its own, or in an f-string."""
    domain = DOMAINS["python"]
    known = {form for sentence in collected("python") for form in forms(sentence)}
    for path in domain.sources.rglob("*.py"):
        for call in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.args:
                count = {"_": 1, "N_": 1, "_n": 2, "Plural": 2}.get(call.func.id, 0)
                said = [part.value for part in call.args[:count] if isinstance(part, ast.Constant)]
                assert set(said) <= known, path


def test_the_extractor_sees_every_call_in_typescript() -> None:
    page = DOMAINS["page"]
    sources = [path for path in page.sources.rglob("*.ts*") if path.name != "messages.ts"]
    calls = sum(len(CALL.findall(path.read_text(encoding="utf-8"))) for path in sources)
    assert len(page.extracted()) - len(page.more()) == calls > 200


@pytest.mark.parametrize("domain", DOMAINS.values(), ids=DOMAINS)
def test_there_is_a_catalog_for_every_language_but_english(domain: Any) -> None:
    assert ("en", *domain.translations()) == LANGUAGES


@pytest.mark.release
@pytest.mark.parametrize(("domain", "language", "path"), TRANSLATIONS)
def test_a_translation_has_the_sentences_of_the_template(
    domain: Any, language: str, path: Path
) -> None:
    assert list(entries(path, language)) == list(entries(domain.template)), "run `make messages`"


@pytest.mark.parametrize(("domain", "language", "path"), TRANSLATIONS)
def test_a_translation_has_as_many_forms_as_its_language_has_plurals(
    domain: Any, language: str, path: Path
) -> None:
    """Of sentences that have none, `make release` prints a list."""
    del domain
    count = TOOL["read"](path, language).num_plurals
    wrong = [
        forms(sentence)[0]
        for sentence, translation in entries(path, language).items()
        if any(forms(translation))
        and len(forms(translation)) != (1 if isinstance(sentence, str) else count)
    ]
    assert wrong == [], path


def without(path: Path, target: Path, sentence: str) -> Path:
    """A copy of a translation in which one sentence is not translated."""
    language = path.parts[-3]
    catalog = TOOL["read"](path, language)
    catalog[sentence].string = ("",) * catalog.num_plurals if catalog[sentence].pluralizable else ""
    target.mkdir(parents=True)
    (target / path.name).write_text(TOOL["text"](catalog), encoding="utf-8")
    return target / path.name


@pytest.mark.parametrize("language", LANGUAGES[1:])
def test_what_is_not_translated_is_said_in_english_and_listed(
    language: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A sentence, one with a plural, and one that no catalog has heard of."""
    python = DOMAINS["python"]
    path, plural = python.translations()[language], "{name}, {count} piston"
    once = without(path, tmp_path / "once" / language / "LC_MESSAGES", "No primary force.")
    twice = without(once, tmp_path / "all" / language / "LC_MESSAGES", plural)
    copied = python._replace(template=tmp_path / "all" / "crankstar.pot")
    monkeypatch.setitem(TOOL["compile_all"].__globals__, "PYTHON", copied)
    TOOL["compile_all"]()
    catalog = gettext.translation("crankstar", tmp_path / "all", [language])
    monkeypatch.setattr("crankstar.language.messages._catalog", lambda _: catalog)
    sources = Catalog()
    for sentence in ("No primary force.", (plural, "{name}, {count} pistons"), "Of {age}."):
        sources.add(sentence)
    with spoken(language):
        assert _("No primary force.") == "No primary force."
        assert _("Of {age}.", age="today") == "Of today."
        assert [
            _n(plural, "{name}, {count} pistons", count, name="V8", count=count)
            for count in (1, 2, 5, 21)
        ] == ["V8, 1 piston", "V8, 2 pistons", "V8, 5 pistons", "V8, 21 pistons"]
    assert TOOL["untranslated"](path, language, sources) == ["Of {age}."]
    assert TOOL["untranslated"](twice, language, sources) == [
        "No primary force.",
        plural,
        "Of {age}.",
    ]


@pytest.mark.parametrize(("domain", "language", "path"), TRANSLATIONS)
def test_a_translation_is_no_copy_of_an_english_sentence(
    domain: Any, language: str, path: Path
) -> None:
    del domain
    letters = re.compile(LETTERS[language])
    copied = [
        forms(sentence)[0]
        for sentence, translation in entries(path, language).items()
        if re.search("[A-Za-z]{2}", bare(forms(sentence)[0]))
        and not all(map(letters.search, filter(None, forms(translation))))
    ]
    assert [sentence for sentence in copied if sentence not in NAMES] == [], path


@pytest.mark.parametrize(("domain", "language", "path"), TRANSLATIONS)
def test_a_translation_has_the_placeholders_of_its_sentence(
    domain: Any, language: str, path: Path
) -> None:
    del domain
    for sentence, translation in entries(path, language).items():
        wanted = placeholders(forms(sentence)[-1])
        for form in filter(None, forms(translation)):
            assert placeholders(form) == wanted, f"{form} ({path})"


@pytest.mark.parametrize(("domain", "language", "path"), TRANSLATIONS)
def test_a_translation_has_what_is_typed_as_it_stands_in_its_sentence(
    domain: Any, language: str, path: Path
) -> None:
    """Options, commands, key paths, suffixes and examples in quotation marks; line breaks too."""
    del domain
    for sentence, translation in entries(path, language).items():
        wanted = set(TYPED.findall(forms(sentence)[-1]))
        for form in filter(None, forms(translation)):
            assert {typed for typed in wanted if typed not in form} == set(), f"{form} ({path})"
            assert form.count("\n") == forms(sentence)[-1].count("\n"), form


@pytest.mark.parametrize(("domain", "language", "path"), TRANSLATIONS)
def test_no_translation_is_marked_as_doubtful(domain: Any, language: str, path: Path) -> None:
    """The program does not read those that are."""
    del domain
    assert [message.id for message in TOOL["read"](path, language) if message.fuzzy] == []


@pytest.mark.parametrize("name", DOMAINS)
def test_sentences_name_their_placeholders(name: str) -> None:
    for sentence in collected(name):
        for form in forms(sentence):
            assert all(name.isidentifier() for name in placeholders(form)), form


def test_a_compiled_form_is_whole_for_who_reads_it_meanwhile(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One that is up to date is not touched; one that is not is replaced, not written over."""
    path = without(DOMAINS["python"].translations()["ja"], tmp_path / "ja", "No primary force.")
    copied = DOMAINS["python"]._replace(template=tmp_path / "crankstar.pot")
    monkeypatch.setitem(TOOL["compile_all"].__globals__, "PYTHON", copied)
    monkeypatch.setattr(type(copied), "translations", lambda _: {"ja": path})
    TOOL["compile_all"]()
    form = path.with_suffix(".mo")
    first, whole = form.stat(), form.read_bytes()
    TOOL["compile_all"]()
    assert form.stat() == first
    form.write_bytes(whole[:3])
    with form.open("rb") as reader:
        TOOL["compile_all"]()
        assert reader.read() == whole[:3]
    assert form.read_bytes() == whole
    assert sorted(tmp_path.rglob("*")) == [tmp_path / "ja", form, path]


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", ["V8, 1 piston", "V8, 2 pistons", "V8, 5 pistons", "V8, 21 pistons"]),
        ("ru", ["V8, 1 поршень", "V8, 2 поршня", "V8, 5 поршней", "V8, 21 поршень"]),
        ("ja", [f"V8、ピストン {count} 個" for count in (1, 2, 5, 21)]),
    ],
)
def test_numbers_of_pistons_take_their_plural(language: str, said: list[str]) -> None:
    TOOL["compile_all"]()
    with spoken(language):
        assert [
            _n("{name}, {count} piston", "{name}, {count} pistons", count, name="V8", count=count)
            for count in (1, 2, 5, 21)
        ] == said


@pytest.mark.parametrize(
    ("language", "said"),
    [("en", "No primary force."), ("ja", "一次慣性力なし。"), ("ru", "Силы 1-го порядка нет.")],
)
def test_a_verdict_is_in_the_language_asked_for(
    language: str, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    TOOL["compile_all"]()
    with pytest.raises(SystemExit):
        cli.main(["--lang", language, "verdict", "i4"])
    assert said in capsys.readouterr().out


def test_firing_angles_and_exhaust_groups_are_in_the_language() -> None:
    engine = crankstar.load("i4")
    with spoken("ja"):
        chart = json.dumps(charts.stroke_chart(engine).to_dict(), ensure_ascii=False)
        lines = str(STROKES.told(engine, STROKES.question.value()))
    assert "全気筒" in chart
    assert "all cylinders:" not in chart
    assert "1 は 0, 3 は 180" in lines
