"""A whole site: its engines in processes side by side, beside its place, then moved there."""

from __future__ import annotations

import os
import shutil
import signal
import tempfile
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from hashlib import sha256
from multiprocessing import get_context
from pathlib import Path

from crankstar.language.messages import MessageError, language, speak
from crankstar.language.quoting import one_line
from crankstar.language.shown_units import Choice, choice, shown_in
from crankstar.page.standalone import BUNDLE, SHARED_POLICY, PageError, plain_script
from crankstar.site.gallery import Gallery, html, style
from crankstar.site.pages import Subject, card_of, files_of, picture_of, write

PROCESSES = 2
INDEX = "index.html"
MARK = '<meta name="generator" content="crankstar">'
"""In the index of a site, so that it may be replaced."""
GREATEST_PAGE = 2_000_000
"""Bytes."""
Tell = Callable[[int, int, str], None]
"""Called with the engines done, all of them, and the last one."""


class SiteError(MessageError):
    """A place where no site can be written, as a sentence that says what would be right."""


def check_place(place: Path) -> None:
    """Refuse a place that holds something other than a site. Raises SiteError."""
    if not place.parent.is_dir():
        raise SiteError(
            "{folder}: there is no directory to write it in", folder=one_line(str(place))
        )
    if not place.exists() and not place.is_symlink():
        return
    if not place.is_dir():
        raise SiteError("{folder} is not a directory; name another", folder=one_line(str(place)))
    index = place / INDEX
    ours = index.is_file() and MARK in index.read_text(encoding="utf-8", errors="replace")[:2000]
    if any(place.iterdir()) and not ours:
        raise SiteError(
            "{folder} holds other files, which would be lost; name a directory that is empty or "
            "that is a site of crankstar",
            folder=one_line(str(place)),
        )


def build(subjects: Sequence[Subject], place: Path, *, tell: Tell) -> None:
    """Write a site, all of it or nothing. Raises SiteError, EngineFileError, PageError, OSError."""
    place = place.resolve()
    check_place(place)
    draft = Path(tempfile.mkdtemp(dir=place.parent, prefix=f".{place.name[:50]}."))
    try:
        script = _shared(draft)
        cards = [card_of(subject) for subject in subjects]
        _engines(subjects, draft, script=script, tell=tell)
        names = {card.name: card for card in cards}
        gallery = Gallery(
            cards=[*names.values()],
            picture=picture_of,
            style="gallery.css",
            script="gallery.js",
            policy=SHARED_POLICY,
        )
        write(draft, INDEX, html(gallery).encode())
        draft.chmod(0o755)
        _moved(draft, place)
    except BaseException:
        shutil.rmtree(draft, ignore_errors=True)
        raise


def _shared(draft: Path) -> str:
    """Write what all pages share; the place of the script of the engines."""
    script = plain_script().encode()
    place = f"crankstar-{sha256(script).hexdigest()[:12]}.js"
    write(draft, place, script)
    write(draft, "gallery.css", style().encode())
    for name in ("gallery.js", "third-party-licences.txt"):
        try:
            write(draft, name, BUNDLE.with_name(name).read_bytes())
        except FileNotFoundError:
            raise PageError(
                "this copy of crankstar lacks the script of the page; build it with "
                "`python web/bundle.py`, or install crankstar from a wheel"
            ) from None
    return place


def _engines(subjects: Sequence[Subject], draft: Path, *, script: str, tell: Tell) -> None:
    """Write the files of all engines, the largest work of a site."""
    count = min(PROCESSES, os.cpu_count() or 1, len(subjects))
    tell(0, len(subjects), "")
    if count < 2:
        for done, subject in enumerate(subjects):
            _engine(subject, draft, script)
            tell(done + 1, len(subjects), subject.name)
        return
    pool = ProcessPoolExecutor(
        count, get_context("spawn"), initializer=_begin, initargs=(language(), choice())
    )
    try:
        work = {pool.submit(_engine, subject, draft, script): subject for subject in subjects}
        for done, each in enumerate(as_completed(work)):
            each.result()
            tell(done + 1, len(subjects), work[each].name)
    except BaseException:
        pool.shutdown(wait=False, cancel_futures=True)
        for process in (pool._processes or {}).values():  # what is begun is not waited for
            process.terminate()
        raise
    pool.shutdown()


def _begin(spoken: str, units: Choice) -> None:
    """Begin a process: the language and units of the others, interrupts left to the first."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    speak(spoken)
    shown_in(units).__enter__()


def _engine(subject: Subject, draft: Path, script: str) -> None:
    """Write the files of one engine."""
    for place, contents in files_of(subject, script=script):
        write(draft, place, contents)


def _moved(draft: Path, place: Path) -> None:
    """Put a complete site in its place; one that was there goes when the new one is."""
    if not place.exists():
        draft.rename(place)
        return
    old = Path(tempfile.mkdtemp(dir=place.parent, prefix=f".{place.name[:50]}."))
    place.rename(old / place.name)
    try:
        draft.rename(place)
    except BaseException:
        (old / place.name).rename(place)
        raise
    finally:
        shutil.rmtree(old, ignore_errors=True)
