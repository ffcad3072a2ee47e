"""No English is left on a page in Japanese or Russian: texts, titles, names read aloud, hints."""

from __future__ import annotations

import re
import runpy
from pathlib import Path
from typing import NamedTuple

import pytest
from playwright.sync_api import Browser, Page
from tests.web.browsing import watched
from tests.web.engine_page import HANDLE, READY
from tests.web.serving import serving

ENGINES = ["v8-cross-plane", "kr250-racer", "audi-25-tfsi"]
"""Even and odd, two crankshafts, and one with sizes and masses that is out of balance."""
ONCE = {"edit", "about", "derivation"}
"""Panels that are much the same for every engine."""
GUIDE = 6
"""Its steps, with the drawing of the frame."""
SHOWN = """() => {
    const out = []
    const foreign = '[lang=en], pre, code, kbd, math, script, style, h1, output'
    const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT)
    while (walk.nextNode()) {
        const element = walk.currentNode.parentElement
        if (element.closest(foreign)) continue
        const there = element.tagName === 'OPTION' ? element.closest('select') : element
        if (there.checkVisibility()) out.push(walk.currentNode.data)
    }
    const names = ['title', 'alt', 'placeholder', 'aria-label', 'aria-description',
        'aria-valuetext', 'aria-roledescription']
    for (const element of document.body.querySelectorAll('*'))
        if (!element.parentElement.closest('[role=img], [lang=en]'))
            for (const name of names)
                if (name !== 'placeholder' || !element.closest('[id^="edit:"]'))
                    out.push(element.getAttribute(name) ?? '')
    for (const image of document.body.querySelectorAll('img[src^="data:image/svg"]')) {
        const svg = decodeURIComponent(image.src).replace(/<style>.*?<\\/style>/s, '')
        for (const [, text] of svg.matchAll(/>([^<]*)</g)) out.push(text)
    }
    return out
}"""
"""What is read, without examples in an empty form: they are what a file says."""
HELD = """() => HANDLE.exhibits
    .flatMap(({ name, file }) => [name, file.source, file.notes, file.left_out]).flat(3)"""
OPENED = "document.querySelectorAll('details').forEach(each => each.open = true)"
TYPED = re.compile(
    r"`[^`]*`|“[^”]*”|--[a-z-]+|\[\[?[a-z.]+\]?\]|\b[a-z]+(?:[._]\w+)+(?:\[\d\])?(?: = \"\w+\")?"
    r"|\w+\(MIT\)|\.(?:toml|json|xlsx)\b|[A-Z]_?[A-Za-z0-9]*=[\d.]+|\bneighbours=1\b"
)
"""What is typed in any language: commands, options, key paths, limits of a search."""
WORD = re.compile(r"[A-Za-z]{2,}")
AS_THEY_STAND = """
crankstar serve analyze derive verdict balance TOML JSON Excel JavaScript PNG SVG URL HTTP MB
Ctrl Shift Esc Escape Home Page Up Down cos sin pi rpm deg rad turns mm cm in ft kg lb oz mg
kN MN mPa MPa GPa kgf lbf KR VR kW bar exp Wiebe English null
speed neighbours front rear odd even crank balancer all full half power most torque idle
output crankshafts otto limited pressure heat release spark ignition compression none diesel
published computed unverified placeholder estimated determinate continuous
"""
KNOWN = set(AS_THEY_STAND.split())
"""Units, keys of the keyboard, programs, what is typed; names that files give."""


def english(texts: list[str], names: set[str]) -> dict[str, list[str]]:
    """The English words of each text that are neither names nor typed."""
    found = {}
    for text in dict.fromkeys(" ".join(each.split()) for each in texts):
        if any(text in name for name in names):  # on several lines
            continue
        rest = text
        for name in sorted(names, key=len, reverse=True):
            rest = rest.replace(name, " ")
        words = [word for word in WORD.findall(TYPED.sub(" ", rest)) if word not in KNOWN]
        if words:
            found[text] = words
    return found


class Seen(NamedTuple):
    """What was seen on a page: texts, and names of engines and what their files say of sources."""

    texts: list[str]
    names: set[str]

    def read(self, page: Page) -> None:
        page.evaluate(f"async () => await {HANDLE}.settled()")
        self.texts.extend(page.evaluate(SHOWN))
        self.names.update(filter(None, page.evaluate(HELD.replace("HANDLE", HANDLE))))


def through_engines(page: Page, seen: Seen) -> None:
    """Every panel of several engines, details opened."""
    for place, engine in enumerate(ENGINES):
        page.evaluate("state => { location.hash = state }", f"engine={engine}&a=30&beside=i4")
        page.wait_for_function(f"name => {HANDLE}.state.engine === name", arg=engine)
        seen.read(page)
        for tab in page.get_by_role("tab").all():
            if place and tab.get_attribute("data-tab") in ONCE:
                continue
            tab.click()
            for _ in range(2):  # what stands in them comes when they are open
                page.evaluate(OPENED)
                page.evaluate(f"async () => await {HANDLE}.settled()")
            seen.read(page)


def through_dialogs(page: Page, seen: Seen) -> None:
    """The guide, step by step, and the dialog of the search."""
    page.locator("header.head .tools button[aria-pressed]").first.click()
    for _ in range(GUIDE):
        seen.read(page)
        forth = page.locator(".guide-steps button").last
        forth.click()
    page.keyboard.press("Escape")
    page.locator('[data-tab="edit"]').click()
    page.wait_for_selector("dialog.search", state="attached")
    page.evaluate("document.querySelector('dialog.search').showModal()")
    seen.read(page)


def untranslated(language: str) -> set[str]:
    """English that is expected: the sentences without a translation, which a report lists."""
    tool = runpy.run_path(str(Path(__file__).parents[2] / "tools/messages.py"))
    sentences = [
        sentence
        for domain in tool["DOMAINS"]
        for sentence in tool["untranslated"](
            domain.translations()[language], language, domain.collected()
        )
    ]
    parts = [part.strip() for sentence in sentences for part in re.split(r"{\w+}", sentence)]
    return {part for part in parts if WORD.search(part)}


@pytest.mark.release
@pytest.mark.parametrize("language", ["ja", "ru"])
def test_no_english_is_left_on_a_page_in_another_language(language: str, browser: Browser) -> None:
    seen, complaints = Seen([], untranslated(language)), list[str]()
    with serving("--language", language) as server, watched(browser, complaints) as page:
        page.goto(f"{server.address}?lang={language}#engine={ENGINES[0]}&a=30")
        page.evaluate(READY)
        through_engines(page, seen)
        through_dialogs(page, seen)
    assert complaints == []
    assert len(seen.texts) > 1000
    left = english(*seen)
    assert left == {}, "\n".join(f"{text}: {words}" for text, words in left.items())
