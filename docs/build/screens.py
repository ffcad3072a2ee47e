"""The screens in the documents: each shows what its command prints.

In a block of kind `console` a line `$ command` is what is typed, and the lines under it are what
appears. The engine files and lists of the page that have a title (```toml title="mine.toml") lie
in the directory where the commands run. `python docs/build/screens.py` brings all pages up to date,
what `tables.py` makes for them included; a test compares them.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from runpy import run_path

ROOT = Path(__file__).parents[2]
WIDTH = "80"
"""Columns of a screen, which must fit the column of its page."""
CONSOLE = re.compile(r"^```console\n(.*?)^```$", re.MULTILINE | re.DOTALL)
FILE = re.compile(r'^```toml title="([\w.-]+)"\n(.*?)^```$', re.MULTILINE | re.DOTALL)
LIST = re.compile(r'^```csv title="([\w.-]+)"\n(.*?)^```$', re.MULTILINE | re.DOTALL)


def pages() -> list[Path]:
    """The documents in which people read: those at the top, and those of the site."""
    return [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]


Printed = Callable[[str, Path], str]
"""What a command prints, errors included, that is typed in a directory."""


def up_to_date(text: str, printed: Printed | None = None) -> str:
    """The text of a page with every screen as it is now.

    `printed` says what a command prints (by default a shell is asked).
    """
    if not CONSOLE.search(text):
        return text
    with tempfile.TemporaryDirectory() as folder:
        for name, content in (*FILE.findall(text), *LIST.findall(text)):
            (Path(folder) / name).write_text(content, encoding="utf-8")
        return CONSOLE.sub(
            lambda found: (
                f"```console\n{_screen(found.group(1), Path(folder), printed or shown)}```"
            ),
            text,
        )


def _screen(block: str, folder: Path, printed: Printed) -> str:
    commands = [line.removeprefix("$ ") for line in block.splitlines() if line.startswith("$ ")]
    return "".join(f"$ {command}\n{printed(command, folder)}" for command in commands)


def shown(command: str, folder: Path) -> str:
    """What a shell shows of a command."""
    here = os.pathsep.join((str(Path(sys.executable).parent), os.environ.get("PATH", "")))
    environment = {"PATH": here, "HOME": str(folder), "PYTHONUTF8": "1", "COLUMNS": WIDTH}
    environment["PYTHONPATH"] = str(ROOT / "src")
    done = subprocess.run(  # noqa: S602 - our own documents
        command,
        shell=True,
        cwd=folder,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )
    return trimmed(done.stdout.decode("utf-8"))


def trimmed(text: str) -> str:
    """What was printed without spaces at the ends of lines."""
    return "".join(f"{line.rstrip()}\n" for line in text.splitlines())


def alike(text: str) -> str:
    """A page without the last digits of very long numbers, which differ between machines."""
    return re.sub(
        r"-?\d+\.\d{11,}(?:e-?\d+)?", lambda found: str(float(f"{float(found.group()):.9g}")), text
    )


def main() -> None:
    """Bring every page up to date, or those named, and say which have changed."""
    wanted = [Path(name).resolve() for name in sys.argv[1:]]
    for page in wanted or pages():
        before = page.read_text(encoding="utf-8")
        after = up_to_date(before)
        if alike(after) != alike(before):
            page.write_text(after, encoding="utf-8")
            print(f"changed: {page.relative_to(ROOT)}")
    if not wanted:
        run_path(str(Path(__file__).with_name("tables.py")))["main"]()


if __name__ == "__main__":
    main()
