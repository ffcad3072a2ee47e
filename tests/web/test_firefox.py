"""The page in another browser, where this machine has it."""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Page
from tests.web.engine_page import AT, EIGHT, HANDLE, READY, farthest_off, opened
from tests.web.firefox import Window, firefox, window

from crankstar.files.catalog import load

ENGINE = "v8-cross-plane"
PANELS = """async () => {
  const said = {}
  for (const tab of [...document.querySelectorAll('[role=tab]')]) {
    tab.click()
    await HANDLE.settled()
    said[tab.dataset.tab] =
      document.querySelector('[role=tabpanel]').textContent.replace(/\\s+/g, '')
  }
  return said
}""".replace("HANDLE", HANDLE)
"""What each panel says, without its spaces: browsers put them between texts as they like."""

pytestmark = [
    pytest.mark.release,
    pytest.mark.skipif(firefox() is None, reason="Firefox is not on this machine"),
]


@pytest.fixture(scope="module")
def fox(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Window]:
    program = firefox()
    assert program is not None
    with window(program, tmp_path_factory.mktemp("firefox")) as opened_window:
        yield opened_window


def shown(fox: Window, path: Path, state: str) -> None:
    fox.goto("about:blank")
    fox.goto(f"{path.as_uri()}#{state}")
    fox.evaluate(READY)
    fox.evaluate(f"() => {HANDLE}.settled()")


@pytest.mark.parametrize("language", ["en", "ja", "ru"])
def test_firefox_says_in_every_panel_what_chromium_says(
    language: str, fox: Window, built_page: Callable[..., Path], page: Page
) -> None:
    path = built_page(ENGINE, figures=True)
    shown(fox, path, f"a=40&lang={language}")
    opened(page, path, f"a=40&lang={language}")
    expected = page.evaluate(PANELS)
    assert len(expected) >= 10
    assert all(expected.values())
    assert fox.evaluate(PANELS) == expected
    assert fox.complaints == []


def test_firefox_draws_every_piston_where_it_is(
    fox: Window, built_page: Callable[..., Path]
) -> None:
    shown(fox, built_page(ENGINE), "a=0&camera=front")
    asked = f"() => ({AT.replace('HANDLE', HANDLE)})({json.dumps([0, EIGHT])})"
    told = [{int(number): place for number, place in at.items()} for at in fox.evaluate(asked)]
    assert farthest_off(load(ENGINE), told) < 1e-9
    with Image.open(io.BytesIO(fox.screenshot())) as picture:
        pixels = np.asarray(picture.convert("RGB"), int)
    red, green, blue = pixels[:, :640].transpose(2, 0, 1)
    assert np.mean((red > 1.8 * green) & (red > 1.8 * blue)) > 0.005  # the crankshaft
    assert fox.complaints == []
