"""A watched page: its console messages, its script errors, its network requests."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from playwright.sync_api import (
    Browser,
    ConsoleMessage,
    Error,
    Locator,
    Page,
    Route,
    ViewportSize,
    WebError,
    WebSocketRoute,
    expect,
    sync_playwright,
)
from tests.front_end import WEB
from tests.tools import path_of

NOT_WANTED = (
    "WebUIOmniboxPopup",  # pages of the browser's own, which cost as much as ours
    "WebUIOmniboxAimPopup",
    # playwright's own list, which this one takes the place of
    "AvoidUnnecessaryBeforeUnloadCheckSync",
    "DestroyProfileOnBrowserClose",
    "HttpsUpgrades",
    "LensOverlay",
    "MediaRouter",
    "OptimizationHints",
    "ThirdPartyStoragePartitioning",
)
ARGUMENTS = [
    f"--disable-features={','.join(NOT_WANTED)}",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-gpu",
    "--disable-quic",
    "--disable-sync",
    "--no-first-run",
    # also what is no request yet: preconnections, look-ups
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
]
ELSEWHERE = re.compile(r"^(?!file:///|data:|blob:|https?://127\.0\.0\.1[:/])")
"""An address that a page of ours has no business with."""
NEWS = frozenset({"error", "warning", "assert"})
"""The kinds of console messages that are complaints."""
DRIVER = re.compile(r"^\[\.WebGL-0x[0-9a-f]+\]GL Driver Message \(OpenGL, Performance, ")
"""How Chromium says that drawing without a graphics card is slow, which it is."""
HANG = 120_000
"""Milliseconds after which what has not come is given up: it ends a hang, it measures nothing."""
SETTLED = """async hang => {
    await new Promise(done => requestAnimationFrame(() => setTimeout(done)))
    const pages = [...document.querySelectorAll('*')].map(element => element.crankstar)
    const late = new Promise((_, fail) => setTimeout(
        () => fail(new Error('the page draws itself again and again and does not settle')), hang))
    await Promise.race([late, Promise.allSettled(pages.map(page => page?.settled()))])
}"""
"""The next frame is there, and our pages have ended all that was begun; an error after HANG."""
READINGS = {
    Locator: (
        "all",
        "all_inner_texts",
        "all_text_contents",
        "bounding_box",
        "count",
        "evaluate",
        "evaluate_all",
        "get_attribute",
        "inner_text",
        "input_value",
        "is_visible",
        "screenshot",
        "text_content",
    ),
    Page: ("evaluate",),
}
"""What tells of a page as it is at that moment, where `expect` and `wait_for` ask again."""

AXE = WEB / "node_modules" / "axe-core" / "axe.min.js"
BARRIERS = """async only => {
    const why = node => node.any.concat(node.all, node.none)[0]?.message
    const { violations } = await axe.run(
        document, { resultTypes: ['violations'], ...(only && { runOnly: only }) })
    return violations.flatMap(rule => rule.nodes.map(
        node => `${rule.id}: ${node.target.join(' ')}: ${why(node) ?? rule.help}`))
}"""
TOO_WIDE = """() => {
    const edge = document.documentElement.clientWidth
    const style = element => getComputedStyle(element)
    const whole = element => element === document.body || element === document.documentElement
    const lineage = element =>
        element && !whole(element) ? [element, ...lineage(element.parentElement)] : []
    const scrolls = element => ['auto', 'scroll'].includes(style(element).overflowX)
    const hides = element =>
        ['hidden', 'clip'].includes(style(element).overflowX)
        && element.matches('main *:not(input)')
    const free = ([element, ...above]) =>
        [element, ...above].every(one => style(one).position !== 'fixed') && !above.some(scrolls)
    const wrong = element => {
        const { left, right, width, height } = element.getBoundingClientRect()
        const over = right > edge + 1 || left < -1
        const wide = over || element.scrollWidth > element.clientWidth + 1
        if (width <= 1 || height <= 1 || !wide) return ''
        if (!element.checkVisibility() || !free(lineage(element))) return ''
        if (over) return `reaches from ${Math.round(left)} to ${Math.round(right)} of ${edge}`
        return hides(element) ? 'hides a part of what it holds' : ''
    }
    const name = element => [element.tagName.toLowerCase(), ...element.classList].join('.')
    const told = element =>
        `${name(element)} ${wrong(element)}: ${element.textContent.trim().slice(0, 60)}`
    const across = document.documentElement.scrollWidth
    const found = [...document.body.querySelectorAll('*')].filter(wrong).map(told)
    return across > edge ? [`the page is ${across} wide, the window ${edge}`, ...found] : found
}"""


@contextmanager
def settled() -> Iterator[None]:
    """Every reading of a page waits until the page has settled: none falls between two frames."""
    evaluate = Page.evaluate

    def wait(page: Page) -> None:
        while True:
            try:
                return evaluate(page, SETTLED, HANG)
            except Error as error:
                if "Execution context was destroyed" not in error.message:
                    raise
                page.wait_for_load_state()  # another page came in its place, and is waited for

    def patient(reading: Callable[..., Any]) -> Callable[..., Any]:
        def read(place: Page | Locator, *arguments: Any, **options: Any) -> Any:
            wait(place.page if isinstance(place, Locator) else place)
            return reading(place, *arguments, **options)

        return read

    with pytest.MonkeyPatch.context() as patch:
        for kind, names in READINGS.items():
            for name in names:
                patch.setattr(kind, name, patient(getattr(kind, name)))
        yield


def root() -> bool:
    """Chromium's sandbox does not work for root."""
    return os.geteuid() == 0


@contextmanager
def chromium() -> Iterator[Browser]:
    """The Chromium of tests, measurements and pictures, without a window."""
    expect.set_options(timeout=HANG)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=path_of("chromium"), chromium_sandbox=not root(), args=ARGUMENTS
        )
        yield browser
        browser.close()


@contextmanager
def watched(
    browser: Browser, complaints: list[str], *, width: int = 1280, height: int = 800
) -> Iterator[Page]:
    """An empty page in a browser profile of its own.

    What is wrong with it is added to the complaints until it is closed.

    Less motion is wished, so that engines are at rest when they are opened: what turns is drawn all
    the time, which without a graphics card takes most of the time of a test.
    `page.emulate_media(reduced_motion="no-preference")` for tests of motion.
    """

    def said(message: ConsoleMessage) -> None:
        if message.type in NEWS and not DRIVER.match(message.text):
            place = message.location
            complaints.append(
                f"console {message.type}: {message.text} ({place['url']}:{place['lineNumber'] + 1})"
            )

    def broke(error: WebError) -> None:
        complaints.append(f"error on the page: {error.error.stack or error.error}")

    def refused(route: Route) -> None:
        complaints.append(f"request to elsewhere: {route.request.url}")
        route.abort("blockedbyclient")

    def refused_socket(socket: WebSocketRoute) -> None:
        complaints.append(f"request to elsewhere: {socket.url}")
        socket.close()

    size = ViewportSize(width=width, height=height)
    context = browser.new_context(viewport=size, service_workers="block", reduced_motion="reduce")
    try:
        context.on("console", said)
        context.on("weberror", broke)
        context.route(ELSEWHERE, refused)
        context.route_web_socket(re.compile(""), refused_socket)
        context.set_default_timeout(HANG)
        page = context.new_page()
        page.on("crash", lambda _: complaints.append("the page crashed"))
        yield page
        for still_open in context.pages:
            still_open.evaluate(SETTLED, HANG)  # so that what the page has begun is seen
    finally:
        context.close()


def drag(page: Page, *places: tuple[float, float], hold: bool = False) -> None:
    """Presses the mouse at the first of these places, drags it to each other, and releases it.

    The page has settled after each event before the next one comes. `hold`: it is not released.
    """
    for step, (x, y) in enumerate(places):
        page.mouse.move(x, y)
        page.evaluate(SETTLED, HANG)
        if step == 0:
            page.mouse.down()
            page.evaluate(SETTLED, HANG)
    if not hold:
        release(page)


def release(page: Page) -> None:
    """Releases the mouse; the page has settled then."""
    page.mouse.up()
    page.evaluate(SETTLED, HANG)


def too_wide(page: Page) -> list[str]:
    """Elements cut off or beyond an edge of the window, except scrollers and overlays."""
    return page.evaluate(TOO_WIDE)


def barriers(page: Page, *only: str) -> list[str]:
    """Barriers to accessibility by the rules of axe-core, contrast included; or by some rules."""
    if not page.evaluate("'axe' in window"):
        page.evaluate(AXE.read_text(encoding="utf-8"))
    return page.evaluate(BARRIERS, list(only) or None)
