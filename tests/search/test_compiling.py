"""A cache without room, or without a place, stops no search."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from tests.holding import PATIENCE

DOUBLED = """
import resource, sys
from crankstar.stars.compiling import compiled

@compiled
def doubled(value):
    return 2 * value

if sys.argv[1] == "full":
    resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))
print(doubled(21))
"""


@pytest.mark.many(first=1)
@pytest.mark.parametrize("disk", ["full", "unwritable", "ready"])
def test_a_loop_is_compiled_whatever_becomes_of_its_cache(disk, tmp_path: Path):
    script, cache = tmp_path / "doubled.py", tmp_path / "cache"
    script.write_text(DOUBLED)
    cache.mkdir()
    if disk == "unwritable":
        cache = Path("/dev/null/cache")
    ran = subprocess.run(
        [sys.executable, str(script), disk],
        check=False,
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        env=os.environ | {"NUMBA_CACHE_DIR": str(cache)},
    )
    assert (ran.stdout, ran.stderr, ran.returncode) == ("42\n", "", 0)
    assert any(cache.rglob("*.nbc")) == (disk == "ready")


FIRST = """
import sys
from typing import NamedTuple
from crankstar.stars.compiling import compiled

class Point(NamedTuple):
    right: float

@compiled
def first(point):
    return point.right

print(first(Point(42.0)), "scipy.linalg" in sys.modules)
"""


@pytest.mark.release
def test_code_that_is_kept_is_loaded_without_numba_learning_scipy_and_outlives_a_renaming(
    tmp_path: Path,
):
    script = tmp_path / "first.py"

    def said(source: str) -> str:
        script.write_text(source)
        return subprocess.run(
            [sys.executable, "-c", "import first"],
            cwd=tmp_path,
            check=True,
            capture_output=True,
            text=True,
            timeout=PATIENCE,
            env=os.environ | {"NUMBA_CACHE_DIR": str(tmp_path / "cache")},
        ).stdout

    assert said(FIRST) == "42.0 True\n"
    assert said(FIRST) == "42.0 False\n"
    assert said(FIRST.replace("Point", "Place")) == "42.0 True\n"
