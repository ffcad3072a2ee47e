"""`crankstar page`: a file that is whole or not there, what is refused, and what is said of it."""

from __future__ import annotations

import gzip
import json
import os
import re
from base64 import b64decode
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run
from tests.texts import SHORT

from crankstar.page import library
from crankstar.page import standalone as page

SCRIPTS = ["crankstar.js", "figures.js"]


@pytest.fixture(autouse=True)
def plain(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A front-end of a few words, and no figures: what takes seconds is tested elsewhere."""
    script = tmp_path / "crankstar.js"
    script.write_text("export default {}\n", encoding="utf-8")
    (tmp_path / "figures.js").write_text("figures\n", encoding="utf-8")
    monkeypatch.setattr(page, "BUNDLE", script)
    monkeypatch.setattr(library, "chart", lambda _engine, key, **_: {"drawn": key})
    monkeypatch.setattr(library, "derivation", lambda _engine, key: f"<p>{key}</p>")


def held_in(path: Path) -> dict[str, Any]:
    found = re.search(r'id="crankstar-data">(.*?)</script>', path.read_text(encoding="utf-8"))
    assert found is not None
    return json.loads(gzip.decompress(b64decode(json.loads(found.group(1))["data"])))


@pytest.mark.release
@pytest.mark.parametrize("language", ["en", "ru"])
def test_a_page_names_the_language_that_it_is_written_in(
    run: Run, tmp_path: Path, language: str
) -> None:
    place = tmp_path / "i4.html"
    run("--lang", language, "page", "i4", "-o", str(place))
    assert f'<html lang="{language}">' in place.read_text(encoding="utf-8")


@pytest.mark.release
def test_a_page_holds_the_engine_with_its_figures_and_the_fitted_one(
    run: Run, tmp_path: Path
) -> None:
    place = tmp_path / "v8.html"
    ran = run("page", "v8-cross-plane", "-o", str(place))
    assert (ran.code, ran.out, ran.err) == (0, "", f"Wrote {place}\n")
    data = held_in(place)
    shown = data["exhibition"]
    assert [engine["name"] for engine in shown["engines"]] == ["V8, cross-plane crank, 90 deg"]
    assert shown["sources"] == ["v8-cross-plane"]
    assert shown["command"] == "crankstar page v8-cross-plane -o v8-cross-plane.html"
    assert data["libraries"][0]["charts"]["crank-star"] == {"drawn": "crank-star"}
    assert data["libraries"][0]["derivations"]["force:1"] == "<p>force:1</p>"
    assert shown["fitted"][0]["remedies"]
    assert set(data["fitted"][0]["charts"]) == {
        chart["key"] for chart in shown["fitted"][0]["charts"]
    }
    title = place.read_text(encoding="utf-8")
    assert "<title>V8, cross-plane crank, 90 deg</title>" in title


@pytest.mark.release
def test_two_engines_and_changed_values(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "two.html"
    changes = ("--set", "balance_factor=0.5", "--set", "name=mine & yours")
    assert run("page", "i4", "--beside", "i6", *changes, "-o", str(place)).code == 0
    data = held_in(place)
    one, other = data["exhibition"]["engines"]
    assert (one["name"], one["file"]["balance_factor"]) == ("mine & yours", 0.5)
    assert "balance_factor" not in other["file"]
    assert data["exhibition"]["fitted"][1] is None
    assert data["fitted"][1] is None
    assert data["exhibition"]["command"] == (
        "crankstar page i4 --beside i6 --set balance_factor=0.5 --set 'name=mine & yours' "
        "-o i4.html"
    )
    assert "<title>mine &amp; yours and " in place.read_text(encoding="utf-8")


@pytest.mark.release
def test_a_page_does_not_tell_where_on_this_machine_its_engine_lies(
    run: Run, tmp_path: Path
) -> None:
    home = tmp_path / "secret-folder"
    home.mkdir()
    file = home / "mine.toml"
    file.write_text(SHORT, encoding="utf-8")
    place = home / "mine.html"
    assert run("page", str(file), "-o", str(place)).code == 0
    assert "secret-folder" not in json.dumps(held_in(place))
    assert "secret-folder" not in place.read_text(encoding="utf-8")
    assert held_in(place)["exhibition"]["sources"] == ["mine.toml"]


@pytest.mark.release
def test_a_page_of_what_comes_in_says_a_command_that_reads_it_again(
    run: Run, tmp_path: Path
) -> None:
    place = tmp_path / "page.html"
    assert run("page", "-", "-o", str(place), stdin=SHORT.encode()).code == 0
    assert held_in(place)["exhibition"]["command"] == "crankstar page - -o engine.html"


@pytest.mark.release
def test_a_file_whose_name_is_no_text_has_a_page(run: Run, tmp_path: Path) -> None:
    file = tmp_path / os.fsdecode(b"mine\xff.toml")
    file.write_text(SHORT, encoding="utf-8")
    place = tmp_path / "page.html"
    assert run("page", str(file), "-o", str(place)).code == 0
    assert held_in(place)["exhibition"]["sources"] == ["mine?.toml"]


@pytest.mark.release
def test_it_is_the_same_file_every_time(run: Run, tmp_path: Path) -> None:
    one, other = tmp_path / "one.html", tmp_path / "other.html"
    for place in (one, other):
        assert run("page", "single", "-o", str(place)).code == 0
    assert one.read_bytes() == other.read_bytes()


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("page", "no-such-engine"), "no such engine"),
        (("page", "i4", "--beside", "no-such-engine"), "no such engine"),
        (("page", "i4", "--set", "firing_order=[1, 1, 2, 3]"), "firing_order"),
        (("page", "i4", "--set", "firing_order"), "--set"),
    ],
)
def test_what_is_no_engine_makes_no_page(
    run: Run, tmp_path: Path, words: tuple[str, ...], sentence: str
) -> None:
    place = tmp_path / "page.html"
    ran = run(*words, "-o", str(place))
    assert ran.code == 2
    assert sentence in ran.err
    assert "Traceback" not in ran.err
    assert not place.exists()


@pytest.mark.release
def test_a_page_without_a_place_is_named_after_the_engine(run: Run, tmp_path: Path) -> None:
    assert run("page", "i4") == (0, "", "Wrote i4.html\n")
    first = (tmp_path / "i4.html").read_bytes()
    assert run("page", "i4") == (0, "", "Replaced i4.html\n")
    assert (tmp_path / "i4.html").read_bytes() == first


@pytest.mark.parametrize("place", ["missing/folder/page.html", "."])
def test_a_place_that_cannot_be_written_is_told_of_before_anything_is_drawn(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, place: str
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(library, "chart", lambda _engine, key, **_: pytest.fail(f"{key} was drawn"))
    ran = run("page", "i4", "-o", place)
    assert ran.code == 2
    assert "cannot be written" in ran.err
    assert sorted(path.name for path in tmp_path.iterdir()) == SCRIPTS


def test_a_page_is_not_written_over_an_engine_file(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text(SHORT, encoding="utf-8")
    ran = run("page", str(file), "-o", str(file))
    assert ran.code == 2
    assert "is read by this command" in ran.err
    assert file.read_text(encoding="utf-8") == SHORT


@pytest.mark.release
def test_a_disk_that_is_full_leaves_what_was_there(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = tmp_path / "page.html"
    place.write_text("the old one", encoding="utf-8")

    def full(*_: Any) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    ran = run("page", "single", "-o", str(place))
    assert ran.code == 2
    assert "No space left on device" in ran.err
    assert place.read_text(encoding="utf-8") == "the old one"
    assert sorted(path.name for path in tmp_path.iterdir()) == [*SCRIPTS, "page.html"]


def test_without_a_bundle_nothing_is_drawn_and_it_is_said_how_to_build_it(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(page, "BUNDLE", tmp_path / "none.js")
    monkeypatch.setattr(library, "chart", lambda _engine, key, **_: pytest.fail(f"{key} was drawn"))
    ran = run("page", "i4", "-o", str(tmp_path / "page.html"))
    assert ran.code == 2
    assert "python web/bundle.py" in ran.err
