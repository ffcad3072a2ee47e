"""What is asked of a correction in two planes: runs or unbalance, planes, allowed places."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from math import pi, radians
from typing import Annotated

from crankstar.analyses.correct.coefficients import Coefficients, coefficients_of
from crankstar.analyses.correct.trial_runs import trial_runs
from crankstar.analysis.reader import Reader, is_given
from crankstar.engine.quantities import POSITION
from crankstar.files import units
from crankstar.files.lists import Listed, list_given, read_list
from crankstar.language.messages import N_
from crankstar.options import values as request
from crankstar.options.holes import Hole, refuse_lacking
from crankstar.options.refusals import RequestError, refusal, refuse_unused
from crankstar.options.unbalances import Measured, measured

RUNS = N_("CSV file (or .xlsx) with an initial run, and one with a trial weight in each plane.")
MOST_POSITIONS = 360
APART = 1e-4
"""Metres: planes of a rotor nearer to each other are at one place."""
DRILLED = {
    "--diameter": "diameter",
    "--greatest-depth": "greatest_depth",
    "--tip": "tip",
    "--density": "density",
    "--slug": "slug",
}
"""What describes a hole; the radius does not alone, since weights are added there too."""


def _positions(text: str) -> Sequence[float]:
    """Allowed positions: so many at equal steps from 0, or their angles."""
    parts = request.listed(text)
    if len(parts) == 1 and parts[0].isdecimal():
        count = int(parts[0])
        if not 3 <= count <= MOST_POSITIONS:
            raise refusal("--positions", text, "give from 3 to {most} of them", most=MOST_POSITIONS)
        return [2 * pi * at / count for at in range(count)]
    if len(parts) < 2:
        raise refusal(
            "--positions",
            text,
            "give how many there are at equal steps, as in 12, or the angles of two or more, as in "
            '"0, 45, 90 deg"',
        )
    return [radians(each) for each in request.degrees("--positions", text)]


def _planes(text: str, *, option: str) -> Sequence[float]:
    """Two places along the rotor."""
    parts = request.listed(text)
    if len(parts) != 2:
        raise refusal(option, text or '""', 'give two places, as in "0 mm, 400 mm"')
    found: list[float] = []
    for part in parts:
        if units.is_bare(part):
            raise refusal(option, part, "write it with a unit, {example}", example='"400 mm"')
        with request.reading(option):
            found.append(units.si(part, POSITION))
    if abs(found[0] - found[1]) < APART:
        raise refusal(option, text, "the two are at one place; give planes apart")
    return found


def _coefficients(text: str) -> Coefficients:
    return coefficients_of(read_list(text))


def _coefficients_given(given: object) -> Coefficients:
    return coefficients_of(list_given(given, name="coefficients"))


def _measured(text: str, *, at_radius: float | None) -> Sequence[Measured]:
    spots = measured(text, radius=at_radius, most=2)
    if len(spots) != 2 or any(spot.angle is None for spot in spots):
        raise refusal("--unbalance", text, "give two, each with its direction: heavy spots")
    return spots


@dataclass(frozen=True)
class Question(Hole):
    """The runs with trial weights, or the unbalance in two measuring planes (m along the rotor).

    What corrects it is in the correction planes: holes, or weights at angles or at allowed
    positions (rad). `coefficients` are influence coefficients of other runs.
    """

    runs: Annotated[
        Listed | None, Reader("runs", read_list, RUNS, number=partial(list_given, name="runs"))
    ] = None
    unbalance: Annotated[
        Sequence[Measured] | None,
        Reader(
            "--unbalance",
            _measured,
            "Two, in the measuring planes, with directions.",
            beside=("at_radius",),
        ),
    ] = None
    measuring_planes: Annotated[
        Sequence[float] | None,
        Reader("--measuring-planes", partial(_planes, option="--measuring-planes")),
    ] = None
    correction_planes: Annotated[
        Sequence[float] | None,
        Reader("--correction-planes", partial(_planes, option="--correction-planes")),
    ] = None
    coefficients: Annotated[
        Coefficients | None, Reader("--coefficients", _coefficients, number=_coefficients_given)
    ] = None
    positions: Annotated[Sequence[float] | None, Reader("--positions", _positions)] = None

    @property
    def drills(self) -> bool:
        """Whether a hole is described."""
        return self.axial or any(is_given(self, name) for name in DRILLED.values())


def refuse(_source: None, question: Question) -> None:
    """Refuse what is of the other way, lacks something or has no effect. Raises RequestError."""
    listed = is_given(question, "runs")
    if listed == is_given(question, "unbalance"):
        raise RequestError(
            "give either a list of runs with trial weights, or what a balancing machine shows, as "
            'in --unbalance "850 g*mm at 20 deg, 400 g*mm at 200 deg"'
        )
    planes = {
        f"--{name}-planes": is_given(question, f"{name}_planes")
        for name in ("measuring", "correction")
    }
    if listed:
        refuse_unused(planes, beside="RUNS")
    else:
        refuse_unused({"--coefficients": is_given(question, "coefficients")}, beside="--unbalance")
        for option, given in planes.items():
            if not given:
                raise refusal(option, '""', 'give two places, as in "0 mm, 400 mm"')
    if question.drills:
        refuse_unused({"--positions": is_given(question, "positions")}, beside="--diameter")
        refuse_lacking(question)
    if question.runs is not None:
        trial_runs(question.runs, known=is_given(question, "coefficients"))


def refuse_saving(question: Question) -> None:
    """Refuse to write coefficients that are given, or that there are none of."""
    saving = {"--save-coefficients": True}
    if is_given(question, "unbalance"):
        refuse_unused(saving, beside="--unbalance")
    if is_given(question, "coefficients"):
        refuse_unused(saving, beside="--coefficients")
