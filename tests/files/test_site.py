"""`crankstar site`: where a site is written, what is refused, and that it is whole or not there."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.commands import Run

from crankstar.site import building, pages


def test_a_site_of_one_engine_has_its_page_and_may_be_written_again(
    run: Run, tmp_path: Path
) -> None:
    assert run("site", "single", "-o", "mine").err.startswith("Wrote 1 engine into mine")
    first = sorted(path.relative_to(tmp_path) for path in (tmp_path / "mine").rglob("*"))
    assert Path("mine/engines/single.html") in first
    (tmp_path / "mine" / "left.txt").write_text("of the old one")
    assert run("site", "single", "-o", "mine").code == 0
    assert sorted(path.relative_to(tmp_path) for path in (tmp_path / "mine").rglob("*")) == first


def test_an_engine_file_of_ones_own_is_on_the_site(run: Run, tmp_path: Path) -> None:
    run("new", "inline", "-o", "ours.toml")
    assert run("site", "ours.toml", "-o", "site").code == 0
    assert (tmp_path / "site/engines/ours.html").is_file()


def test_a_directory_with_other_files_is_not_replaced(
    refused: Callable[..., str], tmp_path: Path
) -> None:
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs" / "thesis.txt").write_text("years of work")
    assert "holds other files" in refused("site", "single", "-o", "docs")
    assert (tmp_path / "docs" / "thesis.txt").read_text() == "years of work"
    assert "not a directory" in refused("site", "single", "-o", "docs/thesis.txt")
    assert "no directory" in refused("site", "single", "-o", "nowhere/site")


def test_what_is_no_engine_is_refused_before_anything_is_written(
    refused: Callable[..., str], tmp_path: Path
) -> None:
    assert "no-such" in refused("site", "single", "no-such", "-o", "site")
    assert "two engines" in refused("site", "single", "single", "-o", "site")
    assert [*tmp_path.iterdir()] == []


@pytest.mark.parametrize("error", [KeyboardInterrupt, OSError])
def test_a_site_that_fails_half_way_leaves_the_old_one_and_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: type[BaseException]
) -> None:
    place = tmp_path / "site"
    place.mkdir()
    (place / building.INDEX).write_text(f"the old one {building.MARK}")

    def failing(subject: pages.Subject, folder: Path, script: str) -> None:
        pages.write(folder, f"{subject.name}{script}", b"a half")
        raise error

    monkeypatch.setattr(building, "_engine", failing)
    monkeypatch.setattr(building, "PROCESSES", 1)
    subjects = [pages.Subject("i4", pages_tree("i4"), "i4")]
    with pytest.raises(error):
        building.build(subjects, place, tell=lambda _done, _of, _name: None)
    assert [path.name for path in tmp_path.rglob("*")] == ["site", building.INDEX]
    assert (place / building.INDEX).read_text().startswith("the old one")


def pages_tree(name: str) -> dict[str, object]:
    from crankstar.files.catalog import tree_of

    return tree_of(name)[1]


@pytest.mark.usefixtures("interruptible")
def test_a_site_that_is_interrupted_leaves_nothing(tmp_path: Path) -> None:
    """Also while its processes write: an interrupt comes to all of them, as in a terminal."""
    words = [sys.executable, "-m", "crankstar", "site", "-o", "site"]
    process = subprocess.Popen(words, cwd=tmp_path, start_new_session=True)
    try:
        ends = time.monotonic() + 60
        while not [*tmp_path.glob(".site.*/pictures/*")] and time.monotonic() < ends:
            time.sleep(0.05)
        os.killpg(process.pid, signal.SIGINT)
        assert process.wait(60) == 130
    finally:
        process.kill()
    assert [*tmp_path.iterdir()] == []
