"""The unbalance in the correction planes of a rotor, and what is added there."""

from __future__ import annotations

from cmath import rect
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from crankstar.analyses.correct.coefficients import Coefficients, coefficients_text, in_units_of
from crankstar.analyses.correct.question import Question
from crankstar.analyses.correct.trial_runs import Shown, trial_runs
from crankstar.analyses.correct.two_planes import (
    Split,
    effects,
    in_planes,
    influence,
    share_left,
    split,
)
from crankstar.files.lists import Listed
from crankstar.options.refusals import RequestError
from crankstar.spectra import Complex, Real


class Corrections(NamedTuple):
    """The unbalance in the correction planes, what is added there, and what led to it.

    `measured` and `at` are those of a balancing machine; `left` is what a check run shows,
    `left_share` its vibration beside that before, `effects` how much the trial weights changed it.
    `known`: the influence coefficients, in the units that are `shown`, come from other runs.
    """

    unbalance: Complex
    added: tuple[tuple[Split, ...], ...]
    radius: float | None
    measured: Complex | None = None
    at: Sequence[float] = ()
    left: Complex | None = None
    effects: Real | None = None
    influence: Complex | None = None
    left_share: float | None = None
    known: bool = False
    shown: tuple[Shown, Shown] | None = None


def compute(_source: None, question: Question) -> Corrections:
    """By influence coefficients of the runs or by known ones; or from what a machine shows.

    Raises RequestError, ListError.
    """
    if question.runs is not None:
        return _of_runs(question.runs, question)
    spots = question.unbalance or ()
    measured = np.array([rect(spot.unbalance, spot.angle or 0.0) for spot in spots])
    at, planes = question.measuring_planes or (), question.correction_planes or ()
    found = in_planes(measured, at=at, planes=planes)
    return Corrections(found, _added(found, question.positions), question.at_radius, measured, at)


def _of_runs(listed: Listed, question: Question) -> Corrections:
    """Corrections by influence coefficients of trial runs, or by known ones."""
    known = question.coefficients
    runs = trial_runs(listed, known=known is not None)
    if not runs.initial.any():
        raise RequestError("the initial run has no vibration: there is nothing to correct")
    if known is not None:
        matrix = in_units_of(known, runs.shown, option="--coefficients")
    else:
        matrix = influence(runs.initial, runs.trials, runs.runs)
    found = np.linalg.solve(matrix, runs.initial)
    check = runs.check
    return Corrections(
        found,
        _added(found, question.positions),
        question.at_radius,
        left=None if check is None else np.linalg.solve(matrix, check),
        effects=None if known is not None else effects(runs.initial, runs.runs),
        influence=matrix,
        left_share=None if check is None else share_left(matrix, runs.initial, check),
        known=known is not None,
        shown=runs.shown,
    )


def _added(unbalance: Complex, allowed: Sequence[float] | None) -> tuple[tuple[Split, ...], ...]:
    """What to add in each plane: opposite the heavy spot, or at allowed positions beside that."""
    if allowed is not None:
        return tuple(split(complex(-each), allowed) for each in unbalance)
    return tuple(
        (Split(float(np.angle(-each)), float(abs(each))),) if abs(each) else ()
        for each in unbalance
    )


def saved(result: Corrections) -> str:
    """The influence coefficients of the runs as a list."""
    assert result.influence is not None and result.shown is not None  # noqa: S101, PT018
    return coefficients_text(Coefficients(result.influence, result.shown))
