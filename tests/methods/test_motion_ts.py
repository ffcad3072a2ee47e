"""Motion and phasors in TypeScript against Python: to 1e-12 of the stroke and of the forces."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.front_end import node

from crankstar import spectra
from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.files.catalog import load
from crankstar.page import exhibit
from crankstar.page.records import Exhibit, Pair, Vectors
from crankstar.pictures.arrows import load_of
from crankstar.pictures.looks import clearest_azimuth

ENGINES = [
    "v8-cross-plane",
    "audi-25-tfsi",
    "pratt-whitney-wasp",  # counter-clockwise, articulated rods
    "radial-9",
    "kr250-racer",
    "jumo-205",
    "napier-deltic",
    "boxer-6",
    "vw-vr6",
    "merlin",
    "man-s90mc-c",
    "yamaha-r1-crossplane",
]
ANGLES = [0.0, 0.3, np.pi / 2, 2.5, -0.5235987755982988, 7.853981633974483, 11.0, -19.7]


def test_typescript_moves_and_adds_up_as_python_does(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    roads, report = tmp_path / "roads.json", tmp_path / "report.json"
    roads.write_text(json.dumps([road(load(name)) for name in ENGINES]))
    monkeypatch.setenv("CRANKSTAR_ROADS", str(roads))
    node(
        "node_modules/vitest/vitest.mjs",
        "run",
        "test/roads.test.ts",
        "--reporter=default",
        "--reporter=json",
        f"--outputFile={report}",
    )
    told = json.loads(report.read_text())
    assert told["numPassedTests"] == len(ENGINES) * (2 * len(ANGLES) + 1)


def road(engine: Engine) -> dict[str, Any]:
    """An engine as the page is told of it, and where Python puts its parts."""
    shown = exhibit(engine, relatives=False)
    stroke = min(2 * engine.throw(cylinder).radius for cylinder in engine.cylinders) * scale(
        engine, shown
    )
    said = [
        at(engine, shown, theta, None if i % 2 else shown.orders[: 1 + i])
        for i, theta in enumerate(ANGLES)
    ]
    longest = {kind: size for kind, size, _unit in load_of(engine, shown.scene, [0.0]).values}
    return {
        "exhibit": json.loads(shown.model_dump_json()),
        "stroke": stroke,
        "said": said,
        "azimuth": clearest_azimuth(shown.scene),
        "longest": {"force": 0.0, "couple": 0.0} | longest,
    }


def scale(engine: Engine, shown: Exhibit) -> float:
    """The engine's unit of length over the drawing's: crank radii for an engine without sizes."""
    return shown.scene.cylinders[0].crank_radius / engine.throw(engine.cylinders[0]).radius


def at(
    engine: Engine, shown: Exhibit, theta: float, chosen: tuple[float, ...] | None
) -> dict[str, Any]:
    """Places and vectors at a crank angle, of chosen orders."""
    big_end, piston = places(engine, theta)
    unit = scale(engine, shown)

    def vector(of: Vectors) -> Pair:
        value = complex(
            spectra.value(kept(spectrum(shown, of.forward, of.backward), chosen), theta)
        )
        return (value.real, value.imag)

    roll = spectra.real_signal(np.array(shown.orders), plane(shown.total.roll))
    return {
        "theta": theta,
        "big_end": [(place.real * unit, place.imag * unit) for place in big_end],
        "piston": [(place.real * unit, place.imag * unit) for place in piston],
        "chosen": chosen,
        "force": vector(shown.total.force),
        "couple": vector(shown.total.couple),
        "roll": float(np.real(spectra.value(kept(roll, chosen), theta))),
        "parts": [vector(part.force) for part in shown.cylinders],
    }


def places(engine: Engine, theta: float) -> tuple[list[complex], list[complex]]:
    """Big ends and piston pins, `up + i*right` in the engine's frame, as `motion.rods` has them."""
    links = motion.linkage(engine)
    shafts = {shaft.name: shaft for shaft in engine.shafts}
    root = [engine.cylinders[index].bearing for index in motion.roots(links.master)]
    own = [shafts[cylinder.shaft] for cylinder in engine.cylinders]
    turned = [engine.sense * float(shaft.speed_ratio) * theta for shaft in own]
    psi = [
        engine.throw(c).angle + turn - bearing
        for c, turn, bearing in zip(engine.cylinders, turned, root, strict=True)
    ]
    rods = motion.rods(links, psi)

    def placed(path: motion.Path) -> list[complex]:
        # The i-th angle is that of the i-th cylinder and of its masters.
        return [
            complex(shaft.up, shaft.right) + complex(np.exp(1j * bearing) * path.place[i, i])
            for i, (shaft, bearing) in enumerate(zip(own, root, strict=True))
        ]

    return placed(rods.big_end), placed(rods.piston)


def plane(pairs: tuple[Pair, ...]) -> np.ndarray:
    return np.array([complex(*pair) for pair in pairs])


def spectrum(
    shown: Exhibit, forward: tuple[Pair, ...], backward: tuple[Pair, ...]
) -> spectra.Spectrum:
    return spectra.Spectrum(np.array(shown.orders), plane(forward), plane(backward), shown.sense)


def kept(whole: spectra.Spectrum, chosen: tuple[float, ...] | None) -> spectra.Spectrum:
    return whole if chosen is None else spectra.selected(whole, chosen)
