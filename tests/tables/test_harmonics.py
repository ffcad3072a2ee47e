"""A_k has one definition, and every digit that is printed of it is true."""

from __future__ import annotations

from cmath import exp

import mpmath
import pytest

from crankstar import load, spectra
from crankstar.charts.vectors import harmonic
from crankstar.engine.basis import Basis, Sizes
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import inline
from crankstar.engine.motion import first_harmonic, piston_harmonics
from crankstar.engine.quantities import Rotation
from crankstar.files import catalog
from crankstar.mechanics.balance import balance, total
from crankstar.tables import analysis, engines
from crankstar.tables.balance_orders import answer


def exact(order: int, length: float, offset: float) -> complex:
    """A_k by the trapezoidal rule with 60 digits."""
    with mpmath.workdps(60):
        count, length_, offset_ = 1024, mpmath.mpf(length), mpmath.mpf(offset)
        angles = [2 * mpmath.pi * j / count for j in range(count)]
        places = [
            mpmath.cos(a) + mpmath.sqrt(length_**2 - (mpmath.sin(a) - offset_) ** 2) for a in angles
        ]
        terms = (p * mpmath.expj(-order * a) for p, a in zip(places, angles, strict=True))
        return complex(2 * order**2 * mpmath.fsum(terms) / count)


@pytest.mark.many(first=1)
@pytest.mark.parametrize(("length", "offset"), [(10.0, 0.0), (4.0, 0.0), (4.0, 0.3), (2.5, 1.2)])
def test_harmonics_are_true_to_twelve_figures_however_small(length: float, offset: float) -> None:
    found = piston_harmonics(crank_radius=1.0, rod_length=length, offset=offset)
    for order in (1, 2, 4, 6, 8):
        expected = exact(order, length, offset)
        assert abs(found[order] - expected) <= 1e-12 * abs(expected)


@pytest.mark.release
def test_show_prints_the_true_digits_of_the_eighth_harmonic() -> None:
    engine = load("i4", changes={"cylinder.rod_ratio": 10})
    (table,) = engines.harmonics(engine)
    printed = {row[0]: row[1] for row in table.rows}
    assert printed[8] == pytest.approx(exact(8, 10.0, 0.0).real, rel=1e-12)
    assert [row[0] for row in table.rows] == [1, 2, 4, 6, 8]


def offset_engines() -> list[Engine]:
    return [engine for engine in map(load, catalog.names()) if engine.first.offset]


@pytest.mark.release
def test_tables_charts_and_json_have_one_a_k_for_engines_with_offset() -> None:
    assert offset_engines()
    for engine in offset_engines():
        rows = next(answer(engine, balance(engine)).tables).rows
        for row in rows:
            order, size = row[0], row[1]
            assert isinstance(order, float)
            assert size == first_harmonic(engine, order)
            if size:
                assert harmonic(engine, order)[0] == pytest.approx(abs(complex(str(size))))
        (described,) = engines.harmonics(engine)
        for order, size, _phase in described.rows:
            assert size == pytest.approx(abs(first_harmonic(engine, float(str(order)))))
        shown = analysis.document(analysis.analysis(engine, speed=None))
        for table in shown.tables:
            for place, column in enumerate(table.columns):
                if column.heading == "Aₖ":
                    for row in table.rows:
                        expected = abs(first_harmonic(engine, float(str(row[0]))))
                        assert abs(complex(str(row[place]))) == pytest.approx(expected)


def test_the_first_harmonic_is_one_for_a_centred_crank_only() -> None:
    assert first_harmonic(load("i4"), 1) == pytest.approx(1)
    assert abs(first_harmonic(load("vw-vr6"), 1)) == pytest.approx(1.0031, abs=5e-5)


@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
def test_the_harmonic_is_the_force_of_the_piston_over_the_angle_of_its_crank(
    rotation: Rotation,
) -> None:
    sizes = Sizes(stroke=0.08, rod_length=0.12, offset=0.01, reciprocating_mass=1.0)
    single = inline(Basis(name="desaxe", rotation=rotation, cylinder=sizes), throws=(0.0,))
    crank = single.sense * single.shafts[0].throws[0].angle
    force = total(balance(single)).force
    for order in (1, 2, 3):
        (upward,) = spectra.vertical(spectra.selected(force, order))
        assert first_harmonic(single, order) * exp(1j * order * crank) == pytest.approx(upward)
