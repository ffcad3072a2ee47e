"""Speed of crankstar: `make bench` prints it, --write puts it in the docs.

Times are medians of several runs in one go on whatever machine this is; only ratios and orders of
size travel.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from itertools import count
from math import pi
from statistics import median
from time import perf_counter

import numpy as np

import search
import tables
from crankstar import Reference, derivation, load, names, total
from crankstar.engine.banks import Bank, Crank
from crankstar.engine.basis import Basis, Sizes
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import Row, inline, radial, tandem, vee
from crankstar.mechanics.balance import balance
from crankstar.mechanics.batches import totals
from crankstar.mechanics.mechanism import mechanism
from crankstar.studies import sweep
from crankstar.studies.best_value import best

SIZES = Sizes(
    bore=0.0875, stroke=0.0825, rod_length=0.146, reciprocating_mass=0.65, rotating_mass=0.7
)
VARIANTS = 100_000


def engines() -> dict[str, Engine]:
    """One engine for each number of cylinders in the budget, and one with geared shafts."""
    basis = Basis(name="benchmark", cylinder=SIZES)
    turn = 2 * pi
    six = [k * turn / 3 for k in (0, 1, 2, 2, 1, 0)]
    stars = tuple(
        Row(cylinders=tuple(range(7 * k + 1, 7 * k + 8)), throw=k * turn / 4) for k in range(4)
    )
    pair = tuple(
        Crank(
            banks=(Bank(cylinders=(2 * k + 1, 2 * k + 2)),),
            throws=(0.0, pi),
            right=0.1 * k,
            speed_ratio=Fraction(31, 29) ** k,
        )
        for k in range(2)
    )
    eight = (
        Bank(bearing=-pi / 4, cylinders=(1, 3, 5, 7)),
        Bank(bearing=pi / 4, cylinders=(2, 4, 6, 8)),
    )
    twelve = (
        Bank(bearing=-pi / 6, cylinders=tuple(range(1, 12, 2))),
        Bank(bearing=pi / 6, cylinders=tuple(range(2, 13, 2))),
    )
    return {
        "1 cylinder": inline(basis, throws=(0.0,)),
        "4, in line": inline(basis, throws=(0.0, pi, pi, 0.0), bore_pitch=0.1),
        "8, V": vee(
            basis, banks=eight, throws=(0.0, pi / 2, -pi / 2, pi), bore_pitch=0.1, bank_offset=0.02
        ),
        "12, V": vee(basis, banks=twelve, throws=tuple(six), bore_pitch=0.1),
        "28, four stars with slave rods": radial(
            basis, rows=stars, row_pitch=0.2, knuckle_radius=0.03
        ),
        "4, two shafts geared 31:29": tandem(basis, cranks=pair, bore_pitch=0.1),
    }


def timed(work: Callable[[], object], *, runs: int) -> float:
    """The median time of some runs, in seconds, after one that is not counted."""
    work()
    times: list[float] = []
    for _ in range(runs):
        start = perf_counter()
        work()
        times.append(perf_counter() - start)
    return median(times)


def whole_process(*words: str) -> float:
    """The median time of a whole process, in seconds."""
    return timed(
        lambda: subprocess.run([sys.executable, *words], check=True, capture_output=True), runs=9
    )


def batch_rate() -> float:
    """Variants of a V8 per second: throw angles and masses as arrays, orders 1, 2, 4, 6."""
    engine = engines()["8, V"]
    machine = mechanism(engine)
    random = np.random.default_rng(1)
    throws = random.uniform(-pi, pi, (VARIANTS, 4))
    varied = replace(
        machine,
        throw_angle=throws[:, [cylinder.throw - 1 for cylinder in engine.cylinders]],
        unbalance_angle=throws,
        reciprocating_mass=machine.reciprocating_mass * random.uniform(0.9, 1.1, (VARIANTS, 8)),
    )
    return VARIANTS / timed(lambda: totals(varied, orders=(1, 2, 4, 6)), runs=3)


def derived(engine: Engine) -> None:
    """All that `crankstar derive --orders all` derives."""
    for order in (1, 2, 4, 6):
        for quantity in ("force", "couple"):
            derivation(engine, order, quantity)


def derivations() -> list[tables.Row]:
    """A complete derivation as a whole process, and warm: a V8 and the slowest catalog engine."""
    warm = {name: timed(lambda name=name: derived(load(name)), runs=1) for name in names()}
    dearest = max(warm, key=lambda name: warm[name])
    out: list[tables.Row] = []
    for name in ("v8-cross-plane", dearest):
        engine = load(name)
        seconds = timed(lambda engine=engine: derived(engine), runs=9)
        cold = whole_process("-m", "crankstar", "derive", name, "--orders", "all")
        out.append((f"crankstar derive {name} --orders all", f"{cold:.2f} s", "2 s"))
        out.append(
            (
                f"the same, warm, not printed ({len(engine.cylinders)} pistons)",
                f"{seconds * 1e3:.0f} ms",
                "300 ms",
            )
        )
    return out


def sweeps() -> list[tables.Row]:
    """1000 values of one number of a V8, all orders, peaks over a turn, best value, warm."""
    out: list[tables.Row] = []
    for path, end, unit, what in (
        ("layout.banks[1].bearing", 90, "deg", "force"),
        ("balance_factor", 1, None, "couple"),
    ):

        def curve(
            path: str = path, end: float = end, unit: str | None = unit, what: str = what
        ) -> tuple[sweep.Sweep, sweep.Curve]:
            found = sweep.swept(
                "v8-cross-plane", over=path, values=np.linspace(0, end, 1000), unit=unit
            )
            return found, sweep.watched(found, what)

        made = curve()
        out.append(
            (
                f"1000 V8s over {path}, greatest {what}",
                f"{timed(curve, runs=9) * 1e3:.0f} ms",
                "200 ms",
            )
        )
        out.append(
            (
                "the best of them, between the values",
                f"{timed(lambda made=made: best(*made), runs=9) * 1e3:.0f} ms",
                "",
            )
        )
    return out


def pairs() -> list[tables.Row]:
    """100,000 engines over two numbers, the usual orders, peaks of one of them, warm."""
    out: list[tables.Row] = []
    for over in (
        ("balance_factor=0..1/316", "layout.throws[2]=10..80 deg/316"),
        ("speed=600..6000 rpm/316", "layout.banks[1].bearing=-90..0 deg/316"),
    ):

        def made(over: tuple[str, str] = over) -> sweep.Curve:
            both = sweep.sweep("v8-cross-plane", over, orders=(1, 2, 4, 6))
            return sweep.watched(both, "couple", order=1)

        names = " and ".join(text.partition("=")[0] for text in over)
        out.append((f"316 x 316 V8s over {names}", f"{timed(made, runs=3):.2f} s", "1.5 s"))
    return out


def pictures() -> list[tables.Row]:
    """A chart to SVG: the whole command, and warm; best weights of a V8 in eight webs."""
    from crankstar import charts
    from crankstar.remedy import Aim, Plane, best_weights, webs

    engine = load("v8-cross-plane")
    warm = timed(lambda: charts.svg(charts.hodograph(engine), "hodograph"), runs=9)
    planes = [Plane("crank", z) for z in webs(engine, engine.shafts[0])]
    best = timed(lambda: best_weights(engine, planes=planes, aim=Aim("couple")), runs=9)
    return [
        ("a hodograph to SVG, warm", f"{warm * 1e3:.0f} ms", ""),
        ("best weights of a V8 in eight webs, peak couple, warm", f"{best * 1e3:.0f} ms", ""),
    ]


PLACES = count()


def elsewhere() -> Reference:
    """Another point each time: spectra about the same one are kept."""
    return Reference(1e-6 * next(PLACES))


def rows() -> list[tables.Row]:
    """What is measured, the figure, and the budget where there is one."""
    out: list[tables.Row] = []
    for name, engine in engines().items():
        seconds = timed(lambda e=engine: total(balance(e, reference=elsewhere())), runs=101)
        cylinders = len(engine.cylinders)
        out.append(
            (
                f"Balance, {name}",
                f"{seconds * 1e3:.2f} ms ({seconds / cylinders * 1e6:.0f} us a cylinder)",
                "2 ms" if cylinders == 12 else "",
            )
        )
    out += derivations()
    out += sweeps()
    out += pairs()
    out += pictures()
    out += search.rows()
    out.append((f"batch of {VARIANTS:,} V8s", f"{batch_rate():,.0f} engines/s", ""))
    return out


if __name__ == "__main__":
    tables.show("benchmarks", rows())
