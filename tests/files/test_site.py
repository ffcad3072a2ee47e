"""`crankstar site`: where a site is written, what is refused, and that it is whole or not there."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from urllib.parse import unquote

import pytest
from tests.commands import Run
from tests.holding import PATIENCE, awaited, reached

from crankstar.files.read_files import files_noted, note
from crankstar.site import building, pages


@pytest.mark.release
def test_a_site_of_one_engine_has_its_page_and_may_be_written_again(
    run: Run, tmp_path: Path
) -> None:
    assert run("site", "single", "-o", "mine").err.startswith("Wrote 1 engine into mine")
    first = sorted(path.relative_to(tmp_path) for path in (tmp_path / "mine").rglob("*"))
    assert Path("mine/engines/single.html") in first
    assert run("site", "single", "-o", "mine").code == 0
    assert sorted(path.relative_to(tmp_path) for path in (tmp_path / "mine").rglob("*")) == first


def site_of(name: str, place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A site of an engine without its pictures, which take longest."""

    def quick(subject: pages.Subject, folder: Path, _scripts: pages.Scripts) -> None:
        pages.write(folder, pages.page_of(subject.name), name.encode())

    monkeypatch.setattr(building, "_engine", quick)
    subjects = [pages.Subject(name, pages_tree("i4"), name)]
    building.build(subjects, place, tell=lambda _done, _of, _name: None)


def test_a_site_written_again_loses_its_old_pages_and_keeps_files_of_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = tmp_path / "site"
    site_of("before", place, monkeypatch)
    kept = ["CNAME", ".git/HEAD", "engines/own.html"]
    for name in kept:
        pages.write(place, name, b"mine")
    pages.write(tmp_path, "precious.html", b"mine")
    listed = json.loads((place / building.LIST).read_text())["files"]
    assert "engines/before.html" in listed
    assert building.INDEX in listed
    bad = ["../precious.html", str(tmp_path / "precious.html"), "", ".", 3, "a\0"]
    (place / building.LIST).write_text(json.dumps({"files": [*listed, *bad]}))
    site_of("after", place, monkeypatch)
    assert all((place / name).read_bytes() == b"mine" for name in kept)
    assert (tmp_path / "precious.html").exists()
    assert not (place / "engines/before.html").exists()
    assert (place / "engines/after.html").read_text() == "after"
    now = json.loads((place / building.LIST).read_text())["files"]
    assert "engines/before.html" not in now
    assert "engines/after.html" in now
    assert sorted(path.name for path in tmp_path.iterdir()) == ["precious.html", "site"]


def test_a_site_writes_over_no_file_that_it_was_made_from(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An engine file where the site has a page, or one that its list names as an old page."""
    place = tmp_path / "site"
    site_of("mine", place, monkeypatch)
    for file in ("engines/mine.html", "engines/old.html"):
        listed = json.loads((place / building.LIST).read_text())["files"]
        (place / building.LIST).write_text(json.dumps({"files": [*listed, "engines/old.html"]}))
        (place / file).write_text("the only copy")
        with files_noted():
            with (place / file).open("rb") as opened:
                note(opened)
            with pytest.raises(building.SiteError, match="is read by this command"):
                site_of("mine", place, monkeypatch)
        assert (place / file).read_text() == "the only copy"


@pytest.mark.parametrize("contents", ["", "[]", '{"files": 3}', "\xff"])
def test_a_site_whose_list_cannot_be_read_loses_no_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, contents: str
) -> None:
    site_of("before", tmp_path / "site", monkeypatch)
    (tmp_path / "site" / building.LIST).write_text(contents, encoding="latin-1")
    site_of("after", tmp_path / "site", monkeypatch)
    assert (tmp_path / "site/engines/before.html").exists()


def test_links_of_a_gallery_lead_to_files_with_any_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    name = '#?%41 ü, "b"'
    site_of(name, tmp_path / "site", monkeypatch)
    index = (tmp_path / "site" / building.INDEX).read_text(encoding="utf-8")
    links = re.findall(r'<a href="(.*?)"', index)
    assert [unquote(link) for link in links] == [f"engines/{name}.html"]
    assert not set("#? ,") & set(links[0])
    sources = re.findall(r'(?:srcset|src)="(pictures.*?)"', index)
    assert unquote(sources[0]).startswith(f"pictures/{name}-")
    assert not set("#? ,") & set(sources[0])


@pytest.mark.release
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
    assert "name a directory" in refused("site", "single", "-o", "docs/thesis.txt")
    assert refused("site", "single", "-o", "-").startswith("crankstar: -o -: name a directory")
    assert "no directory" in refused("site", "single", "-o", "nowhere/site")


def test_what_is_no_engine_is_refused_before_anything_is_written(
    refused: Callable[..., str], tmp_path: Path
) -> None:
    assert "no-such" in refused("site", "single", "no-such", "-o", "site")
    assert "two engines" in refused("site", "single", "single", "-o", "site")
    assert [*tmp_path.iterdir()] == []


@pytest.mark.parametrize(
    ("error", "told"), [(KeyboardInterrupt, KeyboardInterrupt), (OSError, building.SiteError)]
)
def test_a_site_that_fails_half_way_leaves_the_old_one_and_nothing_else(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    error: type[BaseException],
    told: type[BaseException],
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
    with pytest.raises(told):
        building.build(subjects, place, tell=lambda _done, _of, _name: None)
    assert [path.name for path in tmp_path.rglob("*")] == ["site", building.INDEX]
    assert (place / building.INDEX).read_text().startswith("the old one")


def pages_tree(name: str) -> dict[str, object]:
    from crankstar.files.catalog import tree_of

    return tree_of(name)[1]


HELD = """
import os, signal, sys
from pathlib import Path
from crankstar.site import building

def held(subject, draft, scripts):
    def ending(*_):
        with open("../pipe", "rb", buffering=0) as pipe:
            pipe.read(1)
        os._exit(0)

    woken, wakes = os.pipe()
    os.set_blocking(wakes, False)
    signal.set_wakeup_fd(wakes)  # what comes just before the wait ends it too
    signal.signal(signal.SIGTERM, ending)
    building.write(draft, f"pictures/{subject.name}.svg", b"half a picture")
    while True:
        os.read(woken, 1)

if __name__ == "__main__":
    building._engine = held
    building.PROCESSES, os.cpu_count = 2, lambda: 2
    from crankstar.__main__ import main
    main()
"""
"""A site whose processes never end what they have begun, and end only when a pipe lets them."""


@pytest.mark.release
@pytest.mark.parametrize("sent", [[signal.SIGINT], [signal.SIGINT] * 3, [signal.SIGTERM]])
def test_a_site_that_is_interrupted_leaves_nothing(tmp_path: Path, sent: list[int]) -> None:
    """Also while its processes write: an interrupt comes to all of them, as in a terminal."""
    folder, pipe, script = tmp_path / "folder", tmp_path / "pipe", tmp_path / "held.py"
    folder.mkdir()
    os.mkfifo(pipe)
    script.write_text(HELD)
    words = [sys.executable, str(script), "site", "single", "i4", "-o", "site"]
    process = subprocess.Popen(words, cwd=folder, start_new_session=True, stderr=-1)
    try:
        awaited(lambda: len([*folder.glob(".site.*/pictures/*")]) == 2)
        send = os.killpg if signal.SIGINT in sent else os.kill
        send(process.pid, sent[0])
        with reached(pipe) as ending:
            for number in sent[1:]:
                send(process.pid, number)
            ending.write(bytes(64))  # a process that is ended again while it ends reads again
            _out, said = process.communicate(timeout=PATIENCE)
        assert process.returncode == (130 if sent[0] == signal.SIGINT else -signal.SIGTERM)
        assert said == b""
    finally:
        process.kill()
    assert [*folder.iterdir()] == []


def test_a_site_in_a_write_protected_directory_is_refused_before_it_is_drawn(
    refused: Callable[..., str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(os, "access", lambda *_: False)
    told = refused("site", "single", "-o", "docs")
    assert "docs cannot be written" in told
    assert "name another place with -o" in told


def test_a_full_disk_is_told_of_by_the_place_that_was_asked_for(
    refused: Callable[..., str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Not by the hidden draft beside it, which nobody named."""

    def full(draft: Path, place: str, _contents: bytes) -> None:
        raise OSError(28, "No space left on device", str(draft / place))

    monkeypatch.setattr(building, "write", full)
    told = refused("site", "single", "-o", "mine")
    assert "mine cannot be written (No space left on device); free some space" in told
    assert "name another place with -o" in told
    assert [*tmp_path.iterdir()] == []
