"""Output: a terminal in its width and colours, a pipe, or a file written whole or not at all."""

from __future__ import annotations

import os
import shutil
import stat
import sys
import tempfile
import textwrap
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from io import StringIO
from pathlib import Path
from typing import Any, NoReturn

from crankstar.language.messages import N_, MessageError, _
from crankstar.language.quoting import CONTROL, one_line
from crankstar.options.forms import STANDARD_OUTPUT, form_of

PIPED = 140
"""Columns where there is no terminal."""
LOST = N_("{file} is read by this command and would be lost; name another file with {option}")
WRITE_PROTECTED = N_("it is write-protected")


class OutputError(MessageError):
    """A place that cannot be written to, as one sentence that says what would be right."""


def terminal_width() -> int:
    """Columns of the terminal; of a pipe those that COLUMNS names, else PIPED."""
    from rich.console import Console

    console = Console()
    if console.is_terminal:
        return console.width
    named = os.environ.get("COLUMNS", "")
    return int(named) if named.isdecimal() and int(named) else PIPED


def display(shown: Any, path: str | None = None) -> None:
    """Print a Document, or what rich can print, in the width of the terminal; plain into a file."""
    from rich.console import Console

    from crankstar.analysis.document import Document
    from crankstar.tables.terminal import rendered

    plain = {} if path is None else {"file": StringIO(), "force_terminal": False}
    width = terminal_width() if path is None else PIPED
    console = Console(highlight=False, markup=False, width=width, **plain)
    drawn = rendered(shown, width=width) if isinstance(shown, Document) else shown
    if path is None:
        _opened()
    if console.is_terminal:
        console.print(drawn, crop=False)
        return
    with console.capture() as captured:
        console.print(drawn, crop=False)
    text = "".join(f"{line.rstrip()}\n" for line in captured.get().splitlines())
    if path in STANDARD_OUTPUT:
        _opened()
        sys.stdout.write(text)
    else:
        write(text, path)


def write(text: str, path: str | None, *, option: str = "-o") -> None:
    """Write text that programs read to standard output, or to a file, whole or not at all.

    It is UTF-8 also in a pipe whose encoding is another one; a terminal shows what it can. Raises
    OutputError.
    """
    if path in STANDARD_OUTPUT:
        _opened()
        if sys.stdout.isatty() or not hasattr(sys.stdout, "buffer"):
            sys.stdout.write(text)
            return
    write_bytes(text.encode("utf-8", errors="replace"), path, option=option)


def write_bytes(content: bytes, path: str | None, *, option: str = "-o") -> None:
    """Write bytes to standard output, or to a file, whole or not at all; raises OutputError.

    A file is named on standard error once it is written, so that a pipe stays clean. `option` is
    the one that names it.
    """
    if path in STANDARD_OUTPUT:
        _opened()
        sys.stdout.flush()
        rest = memoryview(content)
        while rest:  # unbuffered, a full disk takes a part without an error, and then none
            rest = rest[sys.stdout.buffer.write(rest) :]
        return
    with _refusing(path, option):
        mode = _mode(path)
        if mode is None or stat.S_ISREG(mode):
            _refuse_read(path, mode, option)
            _replace(Path(path).resolve(), content, option)
            said = N_("Wrote {file}") if mode is None else N_("Replaced {file}")
            complain(_(said, file=one_line(path)))
        else:
            _pour(path, content)


def write_result(content: str | bytes, output: str | None, usual: str) -> None:
    """Write to the file of -o, without one to the usual file."""
    place = usual if output is None else output
    if isinstance(content, str):
        write(content, place)
    else:
        write_bytes(content, place)


def writable(path: str, *, option: str = "-o") -> None:
    """Refuse, before long work, a place that cannot be written to; raises OutputError."""
    if path in STANDARD_OUTPUT:
        return
    with _refusing(path, option):
        mode = _mode(path)
        _refuse_read(path, mode, option)
        if mode is None and not Path(path).resolve().parent.is_dir():
            _refuse(path, N_("there is no such directory"), option)
        if not os.access(path if mode is not None else Path(path).resolve().parent, os.W_OK):
            _refuse(path, WRITE_PROTECTED, option)


def writable_form(path: str | None, forms: Sequence[str], **flags: bool) -> str:
    """`form_of` of a file that can be written. Raises RequestError, OutputError."""
    form = form_of(path, forms, **flags)
    if path is not None:
        writable(path)
    return form


def _refuse_read(path: str, mode: int | None, option: str) -> None:
    """Refuse a file that this command has read, itself or through another. Raises OutputError."""
    from crankstar.files.read_files import was_read

    if mode is not None and was_read(path):
        raise OutputError(LOST, file=one_line(path), option=option)


@contextmanager
def _refusing(path: str, option: str) -> Iterator[None]:
    """Have what is wrong with a place told as an OutputError; first, that it is a directory."""
    try:
        mode = _mode(path)
        if path.endswith(os.sep) or (mode is not None and stat.S_ISDIR(mode)):
            _refuse(path, N_("it is a directory"), option)
        yield
    except OSError as error:
        _refuse(path, error.strerror or str(error), option)
    except (ValueError, RuntimeError) as error:
        if isinstance(error, OutputError):
            raise
        _refuse(path, N_("a file cannot have this name"), option)


def is_file(path: str) -> bool:
    """Whether a file that would be overwritten is there."""
    with suppress(OSError, ValueError):
        return stat.S_ISREG(_mode(path) or 0)
    return False


def _opened() -> None:
    if sys.stdout is None:
        raise OutputError("standard output is closed; name a file with -o")


def _mode(path: str) -> int | None:
    """What kind of file is there, None if none."""
    try:
        return Path(path).stat().st_mode
    except FileNotFoundError:
        return None


def _replace(target: Path, content: bytes, option: str) -> None:
    """Replace the target by a complete new file; links to it stay links."""
    there = target.exists()
    if there and not os.access(target, os.W_OK):
        _refuse(str(target), WRITE_PROTECTED, option)
    handle, draft = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name[:50]}.")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        mask = os.umask(0)
        os.umask(mask)
        Path(draft).chmod(target.stat().st_mode & 0o777 if there else 0o666 & ~mask)
        Path(draft).replace(target)
    except BaseException:
        Path(draft).unlink(missing_ok=True)
        raise


def _pour(path: str, content: bytes) -> None:
    """Write into a device or a pipe, in place, without waiting for a reader."""
    handle = os.open(path, os.O_WRONLY | os.O_NONBLOCK)
    os.set_blocking(handle, True)
    with os.fdopen(handle, "wb") as file:
        file.write(content)


def _refuse(path: str, reason: str, option: str) -> NoReturn:
    raise OutputError(
        "{file}: cannot be written ({reason}); nothing was changed. Name another file with "
        "{option}",
        file=one_line(path),
        reason=_(reason),
        option=option,
    )


@contextmanager
def working(text: str) -> Iterator[Callable[[str], None]]:
    """Show the present step on a terminal's standard error; call the result with the next step."""
    from rich.console import Console
    from rich.markup import escape

    console = Console(stderr=True)
    if not console.is_terminal:
        yield lambda _: None
        return
    with console.status(escape(text)) as status:
        yield lambda now: status.update(escape(now))


@contextmanager
def progress(text: str) -> Iterator[Callable[[int, int, str], None]]:
    """A progress bar on a terminal's standard error; call the result with done, total, note."""
    from rich.console import Console

    console = Console(stderr=True)
    if not console.is_terminal:
        yield lambda _done, _of, _note: None
        return
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn

    columns = (
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        TaskProgressColumn(),
        TextColumn("{task.fields[note]}"),
    )
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task(text, total=None, note="")
        yield lambda done, of, note: bar.update(task, completed=done, total=of, note=note)


def complain(text: str) -> None:
    """Write lines to standard error, if there is one, in the width of the terminal."""
    with suppress(OSError, ValueError):
        if sys.stderr is not None:
            sys.stderr.write(f"{_in_width(CONTROL.sub('?', text))}\n")
            sys.stderr.flush()


def _in_width(text: str) -> str:
    """Lines broken between words where a terminal, or COLUMNS, is narrower; indented alike."""
    width = shutil.get_terminal_size((0, 0)).columns
    return "\n".join(
        textwrap.fill(
            line,
            max(width, 20),
            subsequent_indent=" " * (len(line) - len(line.lstrip())),
            break_long_words=False,
            break_on_hyphens=False,
        )
        if 0 < width < len(line)
        else line
        for line in text.split("\n")
    )


def abandon() -> None:
    """Discard output that cannot be written, so that the interpreter does not complain.

    A reader has gone, or a disk is full.
    """
    for stream in (sys.stdout, sys.stderr):
        if stream is None:
            continue
        try:
            stream.flush()
        except OSError:
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
