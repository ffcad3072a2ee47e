"""The Python versions in which `make release` installs the package."""

from __future__ import annotations

import os
import re
import subprocess
from functools import cache
from itertools import chain
from pathlib import Path
from typing import NamedTuple

SUPPORTED = (3, 11)
ASKED = "import sys; print(*sys.version_info[:2], sys.executable)"


class Python(NamedTuple):
    """A version, and the program."""

    version: tuple[int, int]
    path: str


@cache
def installable() -> dict[str, Python]:
    """The oldest and the newest of those on the PATH and of pyenv, which may be the same one."""
    folders = [Path(folder) for folder in os.get_exec_path()]
    folders += [*(Path.home() / ".pyenv" / "versions").glob("*/bin")]
    named = chain.from_iterable(folder.glob("python3.*") for folder in folders)
    pythons = [found(path) for path in named if re.fullmatch(r"python3\.\d+", path.name)]
    usable = [python for python in pythons if python and python.version >= SUPPORTED]
    return {"oldest": min(usable), "newest": max(usable)}


def found(path: Path) -> Python | None:
    """None of one that does not start, as a shim of pyenv may not."""
    answer = subprocess.run([path, "-c", ASKED], capture_output=True, text=True, check=False)
    if answer.returncode:
        return None
    major, minor, program = answer.stdout.split(maxsplit=2)
    return Python((int(major), int(minor)), program.strip())
