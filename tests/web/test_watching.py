"""The page follows a file: saved in an editor, it is drawn anew where one looks."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect
from tests.server.test_watching import RIGHT, save
from tests.web.browsing import barriers, too_wide
from tests.web.engine_page import READY, handle
from tests.web.serving import Server, serving


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "mine.toml"
    path.write_text(RIGHT)
    return path


@pytest.fixture
def following(file: Path) -> Iterator[Server]:
    with serving(str(file)) as running:
        yield running


@pytest.mark.release
def test_a_page_is_redrawn_when_its_file_is_saved_and_tells_mistakes(
    page: Page, following: Server, file: Path
) -> None:
    page.goto(f"{following.address}#a=77&camera=side&tab=verdict")
    page.evaluate(READY)
    before = handle(page, "read().pistons")
    save(file, RIGHT.replace("3.5", "2.2").replace("Mine", "Shorter rods"))
    expect(page.get_by_role("heading", level=1)).to_have_text("Shorter rods")
    expect(page.get_by_role("tab", name="Verdict")).to_have_attribute("aria-selected", "true")
    assert handle(page, "theta") == 77
    assert handle(page, "state.camera") == "side"
    after = handle(page, "read().pistons")
    assert after["1"] != before["1"]
    save(file, RIGHT.replace("3.5", "-1").replace('"180 deg"', '"180 metres"'))
    told = page.get_by_role("alert")
    expect(told).to_contain_text("mine.toml: 2 mistakes")
    expect(told.get_by_role("listitem")).to_have_count(2)
    expect(told).to_contain_text("rod_ratio")
    assert handle(page, "read().pistons") == after
    assert [*barriers(page), *too_wide(page)] == []
    file.unlink()
    save(file, RIGHT)
    expect(page.get_by_role("heading", level=1)).to_have_text("Mine")
    expect(told).to_have_count(0)
    page.reload()
    page.evaluate(READY)
    assert handle(page, "read().pistons") == before
    page.goto("about:blank")  # before its server ends


@pytest.mark.release
def test_a_saved_file_takes_the_place_of_what_was_edited_on_the_page(
    page: Page, following: Server, file: Path
) -> None:
    page.goto(f"{following.address}#a=0&tab=edit")
    page.evaluate(READY)
    name = page.locator('[id="edit:name"]')
    name.fill("Edited")
    expect(page.get_by_role("heading", level=1)).to_have_text("Edited")
    save(file, RIGHT.replace("Mine", "Saved"))
    expect(page.get_by_role("heading", level=1)).to_have_text("Saved")
    expect(name).to_have_value("Saved")
    page.goto("about:blank")  # before its server ends


def test_a_server_of_the_catalog_watches_nothing(server: Server) -> None:
    assert server.ask("api/watched").json["version"] == 0
