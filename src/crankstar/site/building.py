"""A whole site: its engines in processes side by side, beside its place, then moved there.

A site that is there is updated file by file: its own list says which files are crankstar's.
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import tempfile
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from contextlib import contextmanager
from hashlib import sha256
from multiprocessing import get_context
from pathlib import Path, PurePosixPath
from urllib.parse import quote

from crankstar.files.read_files import was_read
from crankstar.language.messages import MessageError, language, speak
from crankstar.language.quoting import one_line
from crankstar.language.shown_units import Choice, choice, shown_in
from crankstar.page.standalone import BUNDLE, SHARED_POLICY, PageError, figures_script, plain_script
from crankstar.site.gallery import Gallery, html, style
from crankstar.site.pages import Scripts, Subject, card_of, files_of, picture_of, write
from crankstar.stars.interrupts import held_back

PROCESSES = 2
INDEX = "index.html"
LIST = "crankstar-site.json"
"""The files of a site, for the next one in its place."""
MARK = '<meta name="generator" content="crankstar">'
"""In the index of a site, by which it is known."""
GREATEST_PAGE = 2_000_000
"""Bytes."""
Tell = Callable[[int, int, str], None]
"""Called with the engines done, all of them, and the last one."""


class SiteError(MessageError):
    """A place where no site can be written, as a sentence that says what would be right."""


def check_place(path: Path) -> None:
    """Refuse a place that holds something other than a site. Raises SiteError."""
    if not path.parent.is_dir():
        raise SiteError(
            "{folder}: there is no directory to write it in", folder=one_line(str(path))
        )
    if not os.access(path.parent, os.W_OK):
        raise SiteError(
            "{folder} cannot be written, since the directory in which it is to stand is "
            "write-protected; name another place with -o",
            folder=one_line(str(path)),
        )
    if not path.exists() and not path.is_symlink():
        return
    if not path.is_dir():
        raise SiteError("{folder} is not a directory; name a directory", folder=one_line(str(path)))
    index = path / INDEX
    ours = index.is_file() and MARK in index.read_text(encoding="utf-8", errors="replace")[:2000]
    if any(path.iterdir()) and not ours:
        raise SiteError(
            "{folder} holds other files; name a directory that is empty or that is a site of "
            "crankstar",
            folder=one_line(str(path)),
        )


def build(subjects: Sequence[Subject], path: Path, *, tell: Tell) -> None:
    """Write a site, whole or not at all. Raises SiteError, EngineFileError, PageError."""
    path = path.resolve()
    check_place(path)
    try:
        _build(subjects, path, tell)
    except OSError as error:  # a full disk; the draft that it names is of no concern
        raise SiteError(
            "{folder} cannot be written ({reason}); free some space, or name another place with -o",
            folder=one_line(str(path)),
            reason=error.strerror or error,
        ) from None


def _build(subjects: Sequence[Subject], path: Path, tell: Tell) -> None:
    """Write a site, whole or not at all. Raises OSError and what `build` does."""
    with _draft(path) as draft:
        scripts = _shared(draft)
        cards = [card_of(subject) for subject in subjects]
        _engines(subjects, draft, scripts=scripts, tell=tell)
        names = {card.name: card for card in cards}
        gallery = Gallery(
            cards=[*names.values()],
            picture=lambda name, look: quote(picture_of(name, look)),
            style="gallery.css",
            script="gallery.js",
            policy=SHARED_POLICY,
        )
        write(draft, INDEX, html(gallery).encode())
        draft.chmod(0o755)
        _moved(draft, path)


@contextmanager
def _draft(path: Path) -> Iterator[Path]:
    """A directory beside a place, gone at the end unless it has been moved there."""
    draft = Path(tempfile.mkdtemp(dir=path.parent, prefix=f".{path.name[:50]}."))
    try:
        yield draft
    finally:
        shutil.rmtree(draft, ignore_errors=True)


def _shared(draft: Path) -> Scripts:
    """Write what all pages share; the places of the scripts of the engines."""
    places: list[str] = []
    for name, text in (("crankstar", plain_script()), ("figures", figures_script())):
        script = text.encode()
        places.append(f"{name}-{sha256(script).hexdigest()[:12]}.js")
        write(draft, places[-1], script)
    write(draft, "gallery.css", style().encode())
    for name in ("gallery.js", "third-party-licences.txt"):
        try:
            write(draft, name, BUNDLE.with_name(name).read_bytes())
        except FileNotFoundError:
            raise PageError(
                "this copy of crankstar lacks the script of the page; build it with "
                "`python web/bundle.py`, or install crankstar from a wheel"
            ) from None
    return Scripts(*places)


def _engines(subjects: Sequence[Subject], draft: Path, *, scripts: Scripts, tell: Tell) -> None:
    """Write the files of all engines, the largest work of a site."""
    count = min(PROCESSES, os.cpu_count() or 1, len(subjects))
    tell(0, len(subjects), "")
    if count < 2:
        for done, subject in enumerate(subjects):
            _engine(subject, draft, scripts)
            tell(done + 1, len(subjects), subject.name)
        return
    pool = ProcessPoolExecutor(
        count, get_context("spawn"), initializer=_begin, initargs=(language(), choice())
    )
    try:
        with held_back():  # processes begin as work is given
            work = {pool.submit(_engine, subject, draft, scripts): subject for subject in subjects}
        for done, each in enumerate(as_completed(work)):
            each.result()
            tell(done + 1, len(subjects), work[each].name)
    except BaseException:
        for process in [*(pool._processes or {}).values()]:  # what is begun is not waited for
            process.terminate()
        pool.shutdown(cancel_futures=True)
        raise
    pool.shutdown()


def _begin(spoken: str, units: Choice) -> None:
    """Begin a process: the language and units of the others, interrupts left to the first."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    speak(spoken)
    shown_in(units).__enter__()


def _engine(subject: Subject, draft: Path, scripts: Scripts) -> None:
    """Write the files of one engine."""
    for place, contents in files_of(subject, scripts=scripts):
        write(draft, place, contents)


def _listed(path: Path) -> list[str]:
    """The files of the site that is there by its own list; none where the list cannot be read."""
    try:
        files = json.loads((path / LIST).read_bytes())["files"]
    except (OSError, ValueError, KeyError, TypeError):
        return []
    if not isinstance(files, list):
        return []
    return [file for file in files if isinstance(file, str) and _is_inside(file, path)]


def _is_inside(file: str, place: Path) -> bool:
    """Whether a file of a list lies in the site, so that no list can name others."""
    path = PurePosixPath(file)
    if path.is_absolute() or not path.name or ".." in path.parts or "\0" in file:
        return False
    return (place / path).parent.resolve().is_relative_to(place)


def _list(files: Iterable[str]) -> bytes:
    return f"{json.dumps({'files': sorted(files)}, indent=1)}\n".encode()


def _moved(draft: Path, place: Path) -> None:
    """Put a complete site in its place, file by file where one is; other files are left alone.

    The list names old and new files until the old ones are gone, the index comes after its pages.
    Raises SiteError for a file that this command has read, itself or through another.
    """
    new = {path.relative_to(draft).as_posix() for path in draft.rglob("*") if path.is_file()}
    new.add(LIST)
    if not place.exists():
        write(draft, LIST, _list(new))
        draft.rename(place)
        return
    old = {*_listed(place)} - new
    for file in sorted(old | new):
        if (place / file).exists() and was_read(place / file):
            raise SiteError(
                "{file} is read by this command and would be lost; name another directory with -o",
                file=one_line(str(place / file)),
            )
    write(draft, LIST, _list({*old, *new}))
    for file in (LIST, *sorted(new - {LIST, INDEX}), INDEX):
        (place / file).parent.mkdir(parents=True, exist_ok=True)
        (draft / file).replace(place / file)
    for file in old:
        (place / file).unlink(missing_ok=True)
    write(draft, LIST, _list(new))
    (draft / LIST).replace(place / LIST)
