"""The cost of the page: sizes, time to ready, script of a frame, delay of an edit.

`make bench` prints it; --write puts it in the docs. In a Chromium without a window and, where there
is no graphics card, with drawing done by the processor. Only script is counted in a frame: what the
stage, the figures and the numbers take until they have said what is to be drawn, not the drawing;
in an edit the drawing is counted, too. How fast the machine is at the time stands beside it.
"""

from __future__ import annotations

import json
import sys
import tempfile
from pathlib import Path
from statistics import median, quantiles

sys.path.insert(0, str(Path(__file__).parents[1]))

from playwright.sync_api import Browser, ViewportSize
from start import NUMPY, seconds
from tests.front_end import BUNDLE, FIGURES
from tests.mounted_engines import FOUNDATION, standing
from tests.web.browsing import chromium
from tests.web.engine_page import HANDLE, opened, written, written_of
from tests.web.serving import serving

import tables

MEASURED = "v12-60"
V18 = {
    "format": 1,
    "name": "V18, 40 deg",
    "cycle": "four-stroke",
    "firing_order": [1, 10, 9, 18, 8, 17, 7, 16, 6, 15, 5, 14, 4, 13, 3, 12, 2, 11],
    "cylinder": {"rod_ratio": 4},
    "layout": {
        "type": "vee",
        "banks": [
            {"name": "left", "bearing": "-20 deg", "cylinders": [*range(1, 10)]},
            {"name": "right", "bearing": "20 deg", "cylinders": [*range(10, 19)]},
        ],
        "throws": [f"{angle} deg" for angle in (0, 80, 160, 240, 320, 40, 120, 200, 280)],
    },
}
"""The longest engine whose edits are measured; none of the catalog has eighteen cylinders."""
EDIT = """async bearing => {
    const box = document.getElementById('edit:layout.banks[2].bearing')
    const took = []
    for (let step = 1; step <= 25; step++) {
        const [before, from] = [HANDLE.exhibits[0], performance.now()]
        box.value = `${bearing + step / 10} deg`
        box.dispatchEvent(new Event('input', { bubbles: true }))
        while (HANDLE.exhibits[0] === before) {
            if (performance.now() - from > 20000) throw new Error(`${box.value} is refused`)
            await new Promise(requestAnimationFrame)
        }
        await new Promise(done => setTimeout(done))  // until the frame that shows it is handed over
        took.push(performance.now() - from)
        // drawn finely by then, where no card draws
        await new Promise(done => setTimeout(done, 900))
    }
    return took
}"""
FRAMES = 240
SIZE = ViewportSize(width=1280, height=800)
OPENINGS = 7


def ready(browser: Browser, path: Path) -> list[float]:
    """Seconds from the navigation until the first frame is drawn, each time in a fresh profile."""
    found: list[float] = []
    for _ in range(OPENINGS):
        with browser.new_context(viewport=SIZE) as context, context.new_page() as page:
            opened(page, path, "a=0")
            found.append(
                page.evaluate("() => performance.getEntriesByName('crankstar ready')[0].startTime")
                / 1000
            )
    return found


def frames(browser: Browser, path: Path, state: str) -> list[float]:
    """Milliseconds of script of each frame while the engine turns."""
    with browser.new_context(viewport=SIZE) as context, context.new_page() as page:
        opened(page, path, state)
        page.wait_for_timeout(2000)  # figures are there, the machine is warm
        before = page.evaluate(f"() => {HANDLE}.frameTimes().length")
        page.wait_for_function(
            f"() => {HANDLE}.frameTimes().length >= {before + FRAMES}", timeout=120_000
        )
        return page.evaluate(f"() => {HANDLE}.frameTimes()")[before:]


def edits(browser: Browser, engine: str, bearing: float) -> list[float]:
    """Milliseconds from the last letter of a bank angle until the new engine is drawn.

    `bearing` (deg) is that of the second bank.
    """
    with (
        serving(engine) as server,
        browser.new_context(viewport=SIZE) as context,
        context.new_page() as page,
    ):
        page.goto(f"{server.address}#tab=edit&a=0")
        page.locator(".editor .form .field").first.wait_for()
        page.wait_for_timeout(1000)
        return page.evaluate(EDIT.replace("HANDLE", HANDLE), bearing)


def rows() -> list[tables.Row]:
    """All of it."""
    out = [
        (
            "the bundle, scripts of page and figures",
            f"{(BUNDLE.stat().st_size + FIGURES.stat().st_size) / 1e6:.2f} MB",
            "2 MB",
        )
    ]
    with chromium() as browser, tempfile.TemporaryDirectory() as folder:
        path = written(Path(folder), MEASURED, figures=True)
        out.append(
            (
                f"the page of {MEASURED}, all figures in it",
                f"{path.stat().st_size / 1e6:.2f} MB",
                "2 MB",
            )
        )
        with tempfile.TemporaryDirectory() as place:
            numpy = median(seconds(("-c", NUMPY), place) for _ in range(OPENINGS))
        first = median(ready(browser, path))
        out.append((f"{NUMPY} at that time, for the speed of the machine", f"{numpy:.3f} s", ""))
        out.append(("its first frame is drawn after", f"{first:.2f} s", "0.3 s"))
        mounted = written_of(Path(folder), standing(foundation=FOUNDATION))
        for what, state in (
            ("a frame, table of orders", "tab=orders"),
            ("a frame, loads on bearings", "tab=bearings"),
            ("a frame, two figures that follow the angle", "tab=forces"),
            ("a frame, forces of each cylinder and bank", "tab=cylinders"),
            ("a frame, star and polygon of twelve cylinders", "tab=stars"),
            (
                "a frame, two figures, all arrows and the whirl",
                "tab=forces&couple=1&each=cylinders&whirl=1000",
            ),
            (
                "a frame, a five driven on its mounts and a foundation",
                "tab=mounts&mounts.show=forced",
            ),
        ):
            times = frames(browser, mounted if "mounts" in state else path, state)
            late = quantiles(times, n=20)[-1]
            out.append(
                (
                    f"script of {what}",
                    f"{median(times):.2f} ms (19 of 20 within {late:.2f} ms)",
                    "4 ms",
                )
            )
        long = Path(folder) / "v18.json"
        long.write_text(json.dumps(V18), encoding="utf-8")
        for engine, name, bearing, budget in (
            (MEASURED, MEASURED, 30, "100 ms"),
            (str(long), "a V18", 20, "150 ms"),
        ):
            typed = median(edits(browser, engine, bearing))
            what = f"a bank angle of {name} typed, until its new engine is drawn"
            out.append((what, f"{typed:.0f} ms", budget))
    return out


if __name__ == "__main__":
    tables.show("page", rows())
