"""Writes the weights with which test_bare.py compares those of `--bare`.

They are those of the program when it could not yet keep the weights of a file; `--bare` is to find
the same ones. There is no reason to write them again but an intended change of those weights.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from crankstar import load
from crankstar.engine.copies import with_weights
from crankstar.engine.engine import Engine
from crankstar.engine.records import Weight
from crankstar.remedy import Aim, fitting

FILE = Path(__file__).parent / "bare_weights.json"
OWN = ("parallel-twin-180", "kr250-racer", "brough-golden-dream")
"""Engines of the catalog whose files give counterweights."""


def engines() -> dict[str, Engine]:
    """Engines whose crankshafts have weights already."""
    weights = (
        Weight(unbalance=0.4, angle=-1.1, z=1.9),
        Weight(unbalance=0.7, angle=2.0, z=0.5),
        Weight(unbalance=0.3, angle=2.5, z=-2.2),
    )
    added = {
        name: with_weights(load(name), {"crank": weights})
        for name in ("v8-cross-plane", "vw-vr6", "triple-120")
    }
    return {name: load(name) for name in OWN} | added


def bare(**choice: Any) -> dict[str, Any]:
    """By engine and by the way they were found, the weights of its crankshafts.

    `choice` is passed to the functions of `fitting`.
    """
    out: dict[str, Any] = {}
    for name, engine in engines().items():
        for where in ("pins", "webs", "ends"):
            for factor in (0.3, 0.5):
                made = fitting.by_factor(engine, factor=factor, weights=where, **choice)
                out[f"{name} {where} {factor}"] = _weights(made)
        couple = fitting.best(engine, weights="ends", aim=Aim("couple", rms=True), **choice)
        out[f"{name} ends rms couple"] = _weights(couple.engine)
        fitted = fitting.recommended(engine, **choice)
        out[f"{name} recommended"] = _weights(fitted.after) if fitted else None
    return out


def _weights(engine: Engine) -> list[list[Any]]:
    return [
        [shaft.name, weight.unbalance, weight.angle, weight.z, weight.throw]
        for shaft in engine.shafts
        for weight in shaft.weights
    ]


if __name__ == "__main__":
    FILE.write_text(json.dumps(bare(), indent=1) + "\n", encoding="utf-8")
