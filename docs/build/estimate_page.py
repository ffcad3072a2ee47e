"""The page on estimated masses: the engines they come from, and how far predictions are off."""

from __future__ import annotations

from typing import NamedTuple, get_args

from crankstar.engine.proportions import dressed, piston_speed, proportion
from crankstar.engine.weighed import ENGINES, EngineType, Weighed

SHOWN = ("piston group", "rod", "crank pin", "small end", "rod length", "bore pitch", "stroke")
NAMES = {
    "piston group": "piston group / D³ [kg/m³]",
    "rod": "rod / D³ [kg/m³]",
    "crank pin": "crank pin / D³ [kg/m³]",
    "small end": "small end / rod",
    "rod length": "rod length / crank radius",
    "bore pitch": "bore pitch / D",
    "stroke": "stroke / D",
}

MASSES = ("piston [g]", "piston group [g]", "rod [g]", "small end [g]")
HEADS = ("engine", "type", "bore [mm]", *MASSES, "source")


class Prediction(NamedTuple):
    """A published value beside the one that all other engines predict for its bore."""

    engine: Weighed
    part: str
    published: float
    predicted: float
    low: float
    high: float

    @property
    def error(self) -> float:
        """Predicted over published, less 1."""
        return self.predicted / self.published - 1

    @property
    def inside(self) -> bool:
        """Whether the published value lies in the predicted range."""
        return self.low <= self.published <= self.high


def page(part: str) -> str:
    """A part of the page: data, proportions or errors."""
    return {"data": data, "proportions": proportions, "errors": errors}[part]()


def predictions() -> list[Prediction]:
    """Every published mass of piston and rod with what the other engines predict for it."""
    out: list[Prediction] = []
    for engine in ENGINES:
        if not engine.bore or engine.kind == "crosshead":
            continue
        group = engine.piston_group or (engine.piston and engine.piston * dressed())
        for part, mass in (("piston group", group), ("rod", engine.rod)):
            if mass is None:
                continue
            try:
                law = proportion(part, engine.kind, without=engine.name)
            except KeyError:
                continue
            low, typical, high = (size * engine.bore**3 for size in law.sizes)
            out.append(Prediction(engine, part, mass, typical, low, high))
    return out


def errors() -> str:
    """Each published mass beside its prediction, and how many lie in the range."""
    rows = [
        "| engine | part | published [g] | predicted [g] | range [g] | error |",
        "|---|---|---|---|---|---|",
    ]
    every = predictions()
    for one in every:
        out = "" if one.inside else " (outside)"
        own = "" if one.part == "rod" or one.engine.piston_group else " (piston, dressed)"
        rows.append(
            f"| {one.engine.name} | {one.part}{own} | {1000 * one.published:.0f} | "
            f"{1000 * one.predicted:.0f} | {1000 * one.low:.0f} to {1000 * one.high:.0f}{out} | "
            f"{100 * one.error:+.0f} % |"
        )
    inside = sum(one.inside for one in every)
    middle = sorted(abs(one.error) for one in every)[len(every) // 2]
    words = f"{inside} of {len(every)} published masses lie in the range that the other engines "
    return "\n".join([*rows, "", f"{words}give; the median error is {100 * middle:.0f} %."])


def proportions() -> str:
    """The coefficients of each type: typical, range, number of engines."""
    kinds = [kind for kind in get_args(EngineType) if kind != "crosshead"]
    rows = [f"| | {' | '.join(kinds)} |", "|---" * (len(kinds) + 1) + "|"]
    for part in SHOWN:
        cells: list[str] = []
        for kind in kinds:
            law = proportion(part, kind)
            mark = "" if not law.scarce else " *"
            cells.append(f"{law.typical:.3g} ({law.low:.3g} to {law.high:.3g}){mark}")
        rows.append(f"| {NAMES[part]} | {' | '.join(cells)} |")
    speeds = [f"{piston_speed(kind)[1]:g}" for kind in kinds]
    rows.append(f"| mean piston speed [m/s] | {' | '.join(speeds)} |")
    return "\n".join(rows)


def data() -> str:
    """The engines with what is published of each."""
    rows = [f"| {' | '.join(HEADS)} |", "|---" * len(HEADS) + "|"]
    for engine in ENGINES:
        masses = (engine.piston, engine.piston_group, engine.rod, engine.small_end)
        cells = ["" if mass is None else f"{1000 * mass:.4g}" for mass in masses]
        bore = f"{1000 * engine.bore:.4g}" if engine.bore else ""
        source = f"[@{engine.reference}], {engine.locator}"
        rows.append(f"| {engine.name} | {engine.kind} | {bore} | {' | '.join(cells)} | {source} |")
    return "\n".join(rows)
