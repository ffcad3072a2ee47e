"""A watched engine file: read again when it is saved, whatever an editor does to it."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest

from crankstar.cli.options import read_engine
from crankstar.server.watching import PATIENCE, Watched

RIGHT = """format = 1
name = "Mine"
firing_order = [1, 2]
[layout]
type = "inline"
throws = ["0 deg", "180 deg"]
[cylinder]
rod_ratio = 3.5
"""


def look(watched: Watched, times: int = 1) -> int:
    for _ in range(times):
        asyncio.run(watched.look())
    return watched.version


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "mine.toml"
    path.write_text(RIGHT)
    return path


@pytest.fixture
def watched(file: Path) -> Watched:
    def read() -> dict[str, object]:
        return read_engine(str(file)).tree

    return Watched(file, read(), read)


def save(path: Path, text: str) -> None:
    """As editors do: a new file in the place of the old."""
    draft = path.with_suffix(".swp")
    draft.write_text(text)
    draft.replace(path)


def test_a_file_that_is_saved_is_read_again(watched: Watched, file: Path) -> None:
    assert look(watched) == 1
    save(file, RIGHT.replace("3.5", "4.0"))
    assert look(watched) == 2
    assert watched.tree["cylinder"] == {"rod_ratio": 4.0}
    assert look(watched) == 2


def test_a_file_with_mistakes_tells_all_and_leaves_the_engine(watched: Watched, file: Path) -> None:
    before = watched.tree
    save(file, RIGHT.replace("3.5", "-1").replace('"180 deg"', '"180 metres"'))
    assert look(watched) == 2
    assert watched.tree == before
    assert {problem["path"] for problem in watched.problems} == {
        "cylinder.rod_ratio",
        "layout.throws[2]",
    }
    save(file, "no [toml")
    assert look(watched) == 3
    assert len(watched.problems) == 1
    save(file, RIGHT)
    assert look(watched) == 4
    assert (watched.tree, watched.problems) == (before, [])


def test_a_file_may_be_away_for_a_moment_and_come_back(watched: Watched, file: Path) -> None:
    away = file.rename(file.with_suffix(".bak"))
    assert look(watched, PATIENCE - 1) == 1
    assert watched.problems == []
    assert look(watched, 3) == 2
    assert len(watched.problems) == 1
    away.rename(file)
    assert look(watched) == 3
    assert watched.problems == []


def test_a_file_that_was_away_for_a_moment_is_read_when_it_is_back(
    watched: Watched, file: Path
) -> None:
    file.unlink()
    look(watched)
    file.write_text(RIGHT.replace("3.5", "4.0"))
    assert look(watched) == 2
    assert watched.tree["cylinder"] == {"rod_ratio": 4.0}


def test_a_save_that_changes_nothing_is_no_news(watched: Watched, file: Path) -> None:
    save(file, f"# the same\n{RIGHT}")
    assert look(watched) == 1
