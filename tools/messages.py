"""Message catalogs: every sentence of the Python and TypeScript sources, and its translations.

`python tools/messages.py` extracts the sentences into the templates and brings each translation up
to date with them; `compile` writes what the program reads, as the build hook does; `lacking` prints
which sentences have no translation yet and are shown in English.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from typing import NamedTuple

from babel.core import Locale
from babel.messages.catalog import Catalog, Message
from babel.messages.extract import extract_from_dir
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po, write_po

ROOT = Path(__file__).resolve().parents[1]


class Domain(NamedTuple):
    """Sources in one language, and the catalogs of their sentences."""

    sources: Path
    extractors: tuple[tuple[str, str], ...]
    """Extractor of Babel by file pattern."""
    keywords: dict[str, tuple[int, ...] | None]
    """Functions that take sentences, and which of their arguments are."""
    template: Path
    catalogs: str
    """Pattern of the translations beside the template; `*` is the language."""

    more: Callable[[], list[str]] = list
    """Sentences that are not in calls."""

    def extracted(self) -> list[str | tuple[str, ...]]:
        """The sentence of every call that takes one, and the others."""
        calls = extract_from_dir(self.sources, list(self.extractors), keywords=self.keywords)
        return [*(sentence for _, _, sentence, _, _ in calls), *self.more()]

    def collected(self) -> Catalog:
        """The template as it should be."""
        template = Catalog(charset="utf-8")
        for sentence in self.extracted():
            template.add(sentence)
        return template

    def translations(self) -> dict[str, Path]:
        """The catalog of each language, one file for translators to edit."""
        before, _, after = self.catalogs.partition("*")
        paths = sorted(self.template.parent.glob(self.catalogs))
        places = [path.relative_to(self.template.parent).as_posix() for path in paths]
        names = [place.removeprefix(before).removesuffix(after) for place in places]
        return dict(zip(names, paths, strict=True))


def help_sentences() -> list[str]:
    """The help of the command line, which cyclopts makes from docstrings and parameters."""
    from crankstar.cli import app
    from crankstar.cli.help import sentences

    return sentences(app)


def other_sentences() -> list[str]:
    """Sentences in no call: help, meanings of the glossary, words of forms and of the frame."""
    from crankstar.language.glossary import terms
    from crankstar.page.form_words import words_of_forms

    meanings = [term.meanings["en"] for term in terms()]
    words = [*help_sentences(), *meanings, *words_of_forms(), *frame_words()]
    return [*dict.fromkeys(words)]


def frame_words() -> list[str]:
    """What is written in the drawing of axes, angles and signs, which report and page show."""
    from crankstar.report import frame

    return frame.words()


MESSAGE_ERRORS = [
    "BearingError",
    "ChartError",
    "DerivationError",
    "ErrataError",
    "ExportError",
    "FatigueError",
    "GasError",
    "MarineError",
    "NoSuchKeyError",
    "OilFilmError",
    "OutputError",
    "PackageError",
    "PageError",
    "PrintingError",
    "RemedyError",
    "RequestError",
    "SiteError",
    "TorsionError",
    "UnevenError",
    "SweepError",
    "UnitsError",
    "WeighingError",
    "JudgingError",
    "DiagnosisError",
    "ListError",
    "MatchingError",
    "MountError",
    "ScatterError",
    "TypicalError",
]
"""Errors that are raised with a sentence and its values."""
PYTHON = Domain(
    sources=ROOT / "src",
    extractors=(("**.py", "python"),),
    keywords={
        **dict.fromkeys(("_", "N_", *MESSAGE_ERRORS)),
        **dict.fromkeys(("_n", "Plural"), (1, 2)),
        "refusal": (3,),
    },
    template=ROOT / "src/crankstar/language/catalogs/crankstar.pot",
    catalogs="*/LC_MESSAGES/crankstar.po",
    more=other_sentences,
)
PAGE = Domain(
    sources=ROOT / "web/src",
    extractors=(("**.ts", "javascript"), ("**.tsx", "javascript")),
    keywords={"t": None, "message": None, "plural": (1, 2)},
    template=ROOT / "web/src/language/crankstar-page.pot",
    catalogs="*.po",
    more=frame_words,
)
DOMAINS = (PYTHON, PAGE)


def read(path: Path, language: str | None = None) -> Catalog:
    """A catalog from its file; a template has no language."""
    with path.open("rb") as file:
        return read_po(file, locale=language)


def text(catalog: Catalog) -> str:
    """A catalog as its file has it: sorted, without dates and places, which differ every time."""
    header = ["Content-Type: text/plain; charset=utf-8"]
    if catalog.locale is not None:
        header += [f"Language: {catalog.locale}", f"Plural-Forms: {catalog.plural_forms}"]
    body = BytesIO()
    write_po(
        body,
        catalog,
        width=100,
        no_location=True,
        omit_header=True,
        sort_output=True,
        ignore_obsolete=True,
    )
    lines = "".join(f'"{line}\\n"\n' for line in header)
    return f'msgid ""\nmsgstr ""\n{lines}\n{body.getvalue().decode().rstrip()}\n'


def updated(path: Path, language: str, template: Catalog) -> Catalog:
    """A translation with the sentences of the template: new ones empty, unused ones left out."""
    catalog = read(path, language)
    catalog.update(template, no_fuzzy_matching=True)
    catalog.locale = Locale.parse(language)
    return catalog


def untranslated(path: Path, language: str, sources: Catalog) -> list[str]:
    """The sentences of the sources that are shown in English, for want of a form or altogether."""
    catalog = read(path, language)
    known = {message.id: message for message in catalog}
    return [
        message.id if isinstance(message.id, str) else message.id[0]
        for message in sources
        if message.id and not _is_translated(known.get(message.id))
    ]


def _is_translated(message: Message | None) -> bool:
    """Whether a translation has all of its forms."""
    if message is None or message.fuzzy:
        return False
    return all(message.string) if isinstance(message.string, tuple) else bool(message.string)


def compile_all() -> None:
    """Write the compiled form of the Python translations beside them; the page reads its own.

    Plurals without a translation are left out; Babel would write their English singular for all.
    A form that is up to date stays, another takes its place at once: who reads it sees a whole one.
    """
    for language, path in PYTHON.translations().items():
        catalog = read(path, language)
        for message in catalog:
            if not _is_translated(message):
                message.string = ""
        form = BytesIO()
        write_mo(form, catalog)
        place = path.with_suffix(".mo")
        if not place.exists() or place.read_bytes() != form.getvalue():
            whole = place.with_suffix(f".{os.getpid()}")
            whole.write_bytes(form.getvalue())
            whole.replace(place)


def update_all() -> None:
    """Bring templates and translations up to date with the sources."""
    for domain in DOMAINS:
        template = domain.collected()
        domain.template.write_text(text(template), encoding="utf-8")
        for language, path in domain.translations().items():
            path.write_text(text(updated(path, language, template)), encoding="utf-8")


def report() -> str:
    """How many sentences each language lacks, and which: a page for its translators."""
    lines: list[str] = []
    for domain in DOMAINS:
        sources = domain.collected()
        for language, path in domain.translations().items():
            lacking = untranslated(path, language, sources)
            place = path.relative_to(ROOT).as_posix()
            lines.append(f"{place}: {len(lacking)} of {len(sources)} sentences not translated")
            lines += [f"  {sentence!r}" for sentence in lacking]
    return "\n".join(lines)


def main() -> None:
    """Update and compile; only one of both, or a report, where it is named."""
    match sys.argv[1:]:
        case ["lacking"]:
            print(report())
        case ["compile"]:
            compile_all()
        case _:
            update_all()
            compile_all()


if __name__ == "__main__":
    main()
