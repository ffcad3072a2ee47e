"""The tables and pictures of the page on the Kawasaki KR250, computed when it is built."""

from __future__ import annotations

from math import pi
from typing import NamedTuple

import numpy as np

from crankstar import charts, load, spectra, total
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import balance
from crankstar.mechanics.excitation import Reference
from crankstar.studies.best_value import best
from crankstar.studies.sweep import swept, watched

A2 = 0.25
"""The second harmonic of the essay: r/l, the first term of the series."""
ANGLES = (0.0, pi / 2, pi)


class Layout(NamedTuple):
    """An engine of the essay: its name there, that of the catalog, and the balance factor."""

    words: str
    name: str
    factor: float

    @property
    def engine(self) -> Engine:
        """The engine with this balance factor."""
        return load(self.name, changes={"balance_factor": self.factor})


LAYOUTS = (
    Layout("parallel twin, one shaft, 180°", "parallel-twin-180", 0.5),
    Layout("racer, counter-rotating, 180°", "kr250-racer", 0.5),
    Layout("racer, counter-rotating, simultaneous", "kr250-racer-simultaneous", 0.5),
    Layout("racer, counter-rotating, 180°", "kr250-racer", 0.75),
    Layout("racer, counter-rotating, simultaneous", "kr250-racer-simultaneous", 0.75),
    Layout("production, same sense, 180°", "kr250-production", 0.5),
)


def page(part: str) -> str:
    """A part of the page: cylinder, table, couples, pictures, factors or the sweep of remedies."""
    makers = {
        "cylinder": cylinder,
        "table": table,
        "couples": couples,
        "pictures": pictures,
        "factors": factors,
    }
    return {**makers, "sweep": sweep_figure}[part]()


def forces(engine: Engine, *, essay: bool) -> np.ndarray:
    """The force at 0, 90 and 180 degrees in P = m r w^2, up + i right.

    With `essay`: orders 1 and 2 with A_2 = 1/4; else all orders, exact.
    """
    sums = total(balance(engine)).force
    if not essay:
        return spectra.value(sums, np.array(ANGLES))
    second = spectra.scaled(spectra.selected(sums, [2.0]), A2 / exact_second())
    return spectra.value(spectra.selected(sums, [1.0]), np.array(ANGLES)) + spectra.value(
        second, np.array(ANGLES)
    )


def exact_second() -> float:
    """The exact second harmonic of the essay's pistons, in units of r w^2."""
    return float(
        np.real(spectra.vertical(spectra.selected(total(balance(load("single"))).force, [2.0]))[0])
    )


def cylinder() -> str:
    """One cylinder without a counterweight."""
    engine = load("single")
    rows = ["| crank | primary | secondary | sum | all orders, exact |", "|---|---|---|---|---|"]
    sums = total(balance(engine)).force
    for angle, name in zip(
        (0.0, pi / 2, pi, 3 * pi / 2),
        ("top dead centre", "90°", "bottom dead centre", "270°"),
        strict=True,
    ):
        one = complex(spectra.value(spectra.selected(sums, [1.0]), angle)).real
        two = (
            complex(spectra.value(spectra.selected(sums, [2.0]), angle)).real * A2 / exact_second()
        )
        exact = complex(spectra.value(sums, angle)).real
        rows.append(f"| {name} | {_p(one)} | {_p(two)} | {_p(one + two)} | {_p(exact, 4)} |")
    return _numbers(rows)


def table() -> str:
    """The essay's table: the force at three crank angles, its own numbers and exact ones."""
    rows = [
        "| engine | balance factor | TDC | 90° | BDC | peak over a turn, exact |",
        "|---|---|---|---|---|---|",
    ]
    for layout in LAYOUTS:
        essay, exact = (forces(layout.engine, essay=which) for which in (True, False))
        cells = [
            f"{_vector(one)}<br>*{_vector(other, 4)}*"
            for one, other in zip(essay, exact, strict=True)
        ]
        top = spectra.peak(total(balance(layout.engine)).force).value
        rows.append(
            f"| {layout.words} | {layout.factor:.0%} | {' | '.join(cells)} | {_p(top, 4)} |"
        )
    return _numbers(rows)


def couples() -> str:
    """The couple at top dead centre in P L about the middle and about one cylinder's line."""
    rows = [
        "| engine | balance factor | about the middle | about cylinder 1 |",
        "|---|---|---|---|",
    ]
    for layout in LAYOUTS:
        about = [couple(layout.engine, middle=which) for which in (True, False)]
        cells = [f"{_p(abs(one))} L" if abs(one) > 1e-9 else "0" for one in about]
        rows.append(f"| {layout.words} | {layout.factor:.0%} | {' | '.join(cells)} |")
    return _numbers(rows)


def couple(engine: Engine, *, middle: bool) -> float:
    """The couple at top dead centre, orders 1 and 2 with A_2 = 1/4, in P L; tandem: the roll."""
    tandem = sum(bool(shaft.throws) for shaft in engine.shafts) > 1
    first = min(engine.cylinders, key=lambda one: one.number)
    if tandem:
        length = abs(engine.shafts[1].right)
        point = Reference(0.0, 0.0, engine.shafts[1].right / 2 if middle else 0.0)
        radius = engine.throw(first).radius
        # m r^2 w^2 to P L
        sums, scale = total(balance(engine, reference=point)).axis_moment, radius / length
    else:
        z = [one.z for one in engine.cylinders]
        point = Reference(sum(z) / len(z) if middle else first.z)
        sums, scale = (
            total(balance(engine, reference=point)).couple,
            engine.pitch / abs(z[0] - z[1]),
        )
    one = complex(spectra.value(spectra.selected(sums, [1.0]), 0.0))
    two = complex(spectra.value(spectra.selected(sums, [2.0]), 0.0)) * A2 / exact_second()
    return float((one + two).real * scale)


def pictures() -> str:
    """The forces on each cylinder of each layout at three crank angles."""
    out: list[str] = []
    for layout in LAYOUTS:
        title = f"{layout.words}, balance factor {layout.factor:.0%}"
        drawing = charts.svg(
            charts.force_arrows(layout.engine), f"{title}: forces on each cylinder"
        )
        out.append(
            f'<figure class="chart">{drawing.replace(charts.GREY, "currentColor")}'
            f"<figcaption>{title}</figcaption></figure>"
        )
    return '<div class="charts" markdown="0">\n' + "\n".join(out) + "\n</div>"


def factors() -> str:
    """The balance factors with the least force and the least couple about the middle, by sweeps.

    Also the curves of the force.
    """
    heads = (
        "engine",
        "smallest peak force",
        "at the factor",
        "smallest peak couple",
        "at the factor",
    )
    rows = [f"| {' | '.join(heads)} |", "|---|---|---|---|---|"]
    figures: list[str] = []
    for words, name in dict.fromkeys((layout.words, layout.name) for layout in LAYOUTS):
        engine = load(name)
        tandem = sum(bool(shaft.throws) for shaft in engine.shafts) > 1
        middle = Reference(0.0, 0.0, engine.shafts[1].right / 2) if tandem else None
        sweep = swept(name, over="balance_factor", values=np.linspace(0, 1, 101), reference=middle)
        force, moment = (
            watched(sweep, "force"),
            watched(sweep, "axis_moment" if tandem else "couple"),
        )
        scale = engine.throw(engine.first).radius / abs(engine.shafts[1].right) if tandem else 1.0
        cells = [words]
        for curve, factor, unit in ((force, 1.0, ""), (moment, scale, " L")):
            found = best(sweep, curve)
            size = _p(found.result * factor, 4)
            cells += [
                size + (unit if size != "0" else ""),
                "any" if found.flat else f"{found.value:.4g}",
            ]
        rows.append(f"| {' | '.join(cells)} |")
        found = best(sweep, force)
        if not found.flat:
            drawing = charts.svg(
                charts.swept(sweep, [force], best=[found]),
                f"{words}: force over the balance factor",
            )
            shown = drawing.replace(charts.GREY, "currentColor")
            figures.append(
                f'<figure class="chart">{shown}<figcaption>{words}</figcaption></figure>'
            )
    return (
        _numbers(rows) + '\n\n<div class="charts" markdown="0">\n' + "\n".join(figures) + "\n</div>"
    )


def _numbers(rows: list[str]) -> str:
    """A table of numbers, in narrow columns."""
    return '<div class="numbers" markdown="1">\n\n' + "\n".join(rows) + "\n\n</div>"


def sweep_figure() -> str:
    """The force of a single over the balance factor, of all orders and of the first."""
    sweep = swept("single", over="balance_factor", values=np.linspace(0, 1, 101))
    curves = [watched(sweep, "force"), watched(sweep, "force", order=1)]
    chart = charts.swept(sweep, curves, best=[best(sweep, curve) for curve in curves])
    drawing = charts.svg(chart, "A single: force over the balance factor").replace(
        charts.GREY, "currentColor"
    )
    return f'<figure class="chart" markdown="0">{drawing}</figure>'


def _p(value: float, digits: int = 3) -> str:
    shown = f"{value:.{digits}g}" if abs(value) > 1e-9 else "0"
    return ("−" + shown[1:] if shown.startswith("-") else shown) + (" P" if shown != "0" else "")


def _vector(force: complex, digits: int = 3) -> str:
    """A force in words: so much up or down, so much sideways, how much in all."""
    up, right = force.real, force.imag
    parts = [f"{_p(abs(up), digits)} {'up' if up > 0 else 'down'}"] if abs(up) > 1e-9 else []
    parts += [f"{_p(abs(right), digits)} sideways"] if abs(right) > 1e-9 else []
    whole = f" ({_p(abs(force), digits)} in total)" if len(parts) == 2 else ""
    return (" and ".join(parts) or "0") + whole
