"""A chain that twists as a Python script for openTorsion or ROSS, which prints its frequencies.

The script stands alone: it has the masses and shafts as numbers and builds the model of the other
program from them. Rigidly coupled masses are one, and what is behind a gear is referred to the
speed of the crankshaft, J n^2 and k n^2, so that all turn on one shaft. Structural damping and
pendulums that swing are not in it: neither program has them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from importlib.resources import files
from typing import Literal

from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_system import TorsionChain, TorsionError
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.language.quoting import one_line

Program = Literal["opentorsion", "ross"]
PROGRAMS: dict[Program, tuple[str, str]] = {
    "opentorsion": ("openTorsion", "opentorsion, numpy and scipy"),
    "ross": ("ROSS", "ross-rotordynamics, numpy and scipy"),
}


def torsion_script(source: Engine | Chain, *, to: Program) -> str:
    """The script of an engine with a table [torsion], or of a drive line.

    Raises TorsionError for an engine without it, and for a branched chain in ROSS, whose shafts go
    from one node to the next.

    >>> from crankstar.engine.torsion import Disc
    >>> pair = [Disc(name="motor", inertia=2), Disc(name="fan", inertia=3, to="motor", stiffness=6)]
    >>> script = torsion_script(Chain(name="fan drive", discs=pair), to="opentorsion")
    >>> [line for line in script.splitlines() if line.startswith("    (0")]
    ['    (0, 1, 6.0, 0.0),  # motor - fan']
    """
    chain = torsion_chain(source)
    shafts = list(_shafts(chain))
    if to == "ross":
        _check_row(shafts)
    name, needs = PROGRAMS[to]
    inertia = chain.inertias()[0]
    damping = (chain.transform**2).T @ chain.absolute_damping
    rigid = 1 + sum(1 for each in chain.sections if each.stiffness == 0)
    head = [
        f"# {one_line(source.name)}: torsional vibration for {name}, written by crankstar.",
        f"# Run it with python; it needs {needs}.",
        "# All at the speed of the crankshaft: behind a gear of ratio n, J n^2 and k n^2.",
        *_left_out(chain),
        "",
        "MASSES = [  # inertia (kg m^2), damping against what stands still (N m s/rad)",
        *(
            f"    ({float(inertia[n])!r}, {float(damping[n])!r}),  # {_names(chain, n)}"
            for n in range(chain.freedoms)
        ),
        "]",
        "SHAFTS = [  # masses from 0, stiffness (N m/rad), damping (N m s/rad)",
        *(f"    ({a}, {b}, {k!r}, {c!r}),  # {said}" for a, b, k, c, said in shafts),
        "]",
        f"RIGID = {rigid}  # turns without a frequency: of the whole, and of rings held by a fluid",
    ]
    model = files("crankstar.exports").joinpath(f"{to}.txt").read_text("utf-8")
    return "\n".join(head) + "\n\n" + model


def _names(chain: TorsionChain, freedom: int) -> str:
    pairs = zip(chain.names, chain.freedom, strict=True)
    return one_line(" + ".join(name for name, own in pairs if own == freedom))


def _shafts(chain: TorsionChain) -> Iterator[tuple[int, int, float, float, str]]:
    """The sections between freedoms, referred to the crankshaft, from front to rear."""
    for index in chain.along:
        own = chain.sections[index]
        squared = float(chain.ratio[own.after] ** 2)
        ends = sorted((chain.freedom[own.before], chain.freedom[own.after]))
        said = one_line(chain.section_name(index))
        yield ends[0], ends[1], own.stiffness * squared, own.damping * squared, said


def _check_row(shafts: Sequence[tuple[int, int, float, float, str]]) -> None:
    """Refuse a chain that is not one row of masses. Raises TorsionError."""
    if [each[:2] for each in shafts] != [(n, n + 1) for n in range(len(shafts))]:
        raise TorsionError(
            "a shaft of ROSS is one row of masses, and this chain branches; "
            "openTorsion has branches"
        )


def _left_out(chain: TorsionChain) -> Iterator[str]:
    """What the other program does not have."""
    if chain.pendulums:
        yield "# Pendulums are at rest: they turn with what they hang on."
    if any(each.loss_factor for each in chain.sections):
        yield "# Loss factors are left out; natural frequencies are without damping."
    if chain.estimated:
        yield "# ESTIMATED: the stiffness between the throws, from their dimensions."
