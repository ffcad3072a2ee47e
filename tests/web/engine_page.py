"""Pages with engines on them: written, opened, and asked where things stand."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from playwright.sync_api import Page
from tests import newton

from crankstar.engine.engine import Engine
from crankstar.files.catalog import load
from crankstar.page import exhibition
from crankstar.page.library import held
from crankstar.page.standalone import document

READY = "async () => await document.querySelector('[data-crankstar]').crankstar.ready"
HEARD = """state => new Promise(done => {
    const before = location.href
    addEventListener('hashchange', () => done(), { once: true })
    location.hash = state
    if (location.href === before) done()
})"""
"""Another state in the address, and the page's own listeners, which come first, have heard it."""
AT = (
    "([index, angles]) => angles.map(a => { const page = HANDLE; page.theta = a; return "
    "page.read(index).pistons })"
)
HANDLE = "document.querySelector('[data-crankstar]').crankstar"
EIGHT = [0.0, 12.5, 77.0, 90.0, 181.25, 333.0, 450.0, 700.125]
"""Crank angles, degrees, at which places are compared: no symmetry hides a sign."""
CARD = """const told = WebGL2RenderingContext.prototype.getParameter
WebGL2RenderingContext.prototype.getParameter = function (name) {
  return name === 0x9246 ? 'a card' : told.call(this, name)
}
const ask = HTMLCanvasElement.prototype.getContext
HTMLCanvasElement.prototype.getContext = function (kind, how) {
  return ask.call(this, kind, how && { ...how, failIfMajorPerformanceCaveat: false })
}"""
"""Chromium as with a graphics card: a still image is not redrawn more finely later."""
COUNTED = """const clear = WebGL2RenderingContext.prototype.clear
window.drawings = 0
WebGL2RenderingContext.prototype.clear = function (...what) {
  window.drawings++; clear.apply(this, what)
}"""
"""Each drawing of the stage, counted as `drawings`, begins with an empty canvas."""
FRAMES = """async count => {
    for (; count; count--) await new Promise(requestAnimationFrame)
}"""
"""So many frames have come, however long they took."""
MOVES = "start => Math.abs(HANDLE.theta - start) > 1"


def written(folder: Path, *names: str, figures: bool) -> Path:
    """The page of catalog engines as a file, quickly without figures and derivations."""
    path = folder / f"{'-and-'.join(names)}{'' if figures else '-plain'}.html"
    if not path.exists():
        new = path.with_suffix(f".{id(path)}")
        new.write_text(
            document(_tree([load(name) for name in names], figures=figures)), encoding="utf-8"
        )
        new.replace(path)
    return path


def written_of(folder: Path, engine: Engine) -> Path:
    """The page of an engine that is not of the catalog, without figures and derivations."""
    path = folder / "engine.html"
    path.write_text(document(_tree([engine], figures=False)), encoding="utf-8")
    return path


def _tree(engines: Sequence[Engine], *, figures: bool) -> dict[str, Any]:
    if figures:
        return held(engines)
    empty = [{"charts": {}, "derivations": {}} for _ in engines]
    return {
        "exhibition": exhibition(engines).model_dump(mode="json"),
        "libraries": empty,
        "fitted": empty,
    }


def opened(page: Page, path: Path, state: str = "a=0") -> Page:
    """The page when its first frame has been drawn, in a state as it stands in an address.

    Of one that is open already the address changes alone, which the page has then heard of.
    """
    if page.url.partition("#")[0] == path.as_uri():
        page.evaluate(HEARD, state)
    else:
        page.goto(f"{path.as_uri()}#{state}")
    page.evaluate(READY)
    return page


def handle(page: Page, expression: str) -> Any:
    """What JavaScript says of the page: `handle(page, "theta")`, `handle(page, "read().paths")`."""
    return page.evaluate(f"() => {HANDLE}.{expression}")


def turns_on(page: Page) -> None:
    """Returns once the engine has turned on from where it is."""
    page.wait_for_function(MOVES.replace("HANDLE", HANDLE), arg=handle(page, "theta"))


def drawn(
    page: Page, *, index: int = 0, angles: Sequence[float] = EIGHT
) -> list[dict[int, list[float]]]:
    """Drawn piston positions at each angle (degrees): [up, right, z] by cylinder."""
    told = page.evaluate(AT.replace("HANDLE", HANDLE), [index, list(angles)])
    return [{int(number): place for number, place in at.items()} for at in told]


def expected(engine: Engine, angles: Sequence[float] = EIGHT) -> list[dict[int, list[float]]]:
    """[up, right] of the pistons at each angle (degrees) by plane geometry.

    The second road of the tests; lengths of the engine.
    """
    theta = np.radians(np.array(angles, np.longdouble))
    axes = {shaft.name: (shaft.up, shaft.right) for shaft in engine.shafts}
    found: list[dict[int, list[float]]] = [{} for _ in angles]
    for cylinder in engine.cylinders:
        _, pistons, _ = newton.placed(engine, cylinder, theta)
        up, right = axes[cylinder.shaft]
        for at, (x, y) in zip(found, pistons, strict=True):
            at[cylinder.number] = [up + float(y), right + float(x)]
    return found


def farthest_off(
    engine: Engine, read: list[dict[int, list[float]]], angles: Sequence[float] = EIGHT
) -> float:
    """The greatest error of a piston position over the stroke; infinite if one is missing."""
    radius = min(throw.radius for shaft in engine.shafts for throw in shaft.throws)
    most = 0.0
    for at, should in zip(read, expected(engine, angles), strict=True):
        if at.keys() != should.keys():
            return math.inf
        most = max(most, *(math.dist(at[number][:2], should[number]) for number in should))
    return most / (2 * radius)
