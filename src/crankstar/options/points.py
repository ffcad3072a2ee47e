"""Points, planes and lengths of an engine, read from text in its units."""

from __future__ import annotations

from dataclasses import replace

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import LEAST, LENGTH, POSITION, Quantity
from crankstar.files import bare_numbers, units
from crankstar.language.messages import _
from crankstar.language.quoting import seen
from crankstar.mechanics.excitation import Reference
from crankstar.options.refusals import RequestError, refusal
from crankstar.options.values import listed, not_positive, reading
from crankstar.tables.scales import along_in_radii, scales


def reference(
    text: str | None, engine: Engine | None, *, option: str = "--reference"
) -> Reference | None:
    """A point of reference, or another of the engine, in its units; without one as `places`."""
    if text is None:
        return None
    parts = [part.strip() for part in text.split(",")]
    example = _('as in "-120 mm" (z) or "0 mm, 35 mm, 0 mm" (z, up, right)')
    if len(parts) not in (1, 3):
        raise refusal(option, text, "give z, or z, up and right, {example}", example=example)
    return Reference(*places(option, parts, [POSITION, LENGTH, LENGTH], engine, example))


def block_point(text: str | None, engine: Engine) -> tuple[float, float, float] | None:
    """The point of --at as up, right, z; one of [[block.points]] by its name."""
    points = () if engine.block is None else engine.block.points
    for own in points:
        if text is not None and text.strip() == own.name:
            return own.place
    if text is not None and text.strip()[:1].isalpha():
        raise _no_point(text, [own.name for own in points], engine)
    place = reference(text, engine, option="--at")
    return None if place is None else (place.up, place.right, place.z)


def _no_point(text: str, names: list[str], engine: Engine) -> RequestError:
    """The refusal of a name that no point of the block has."""
    below = () if engine.foundation is None else engine.foundation.points
    asked = (text.strip(), text.strip().partition(": ")[2])  # as tables have it: "foundation: rail"
    if any(own.name in asked for own in below):
        return refusal(
            "--at",
            text,
            "this is a point of the foundation, whose vibration is in the tables of points; --at "
            "takes a point of the block",
        )
    if not names:
        return refusal(
            "--at",
            text,
            "the engine file names no point in [[block.points]]; give z, or z, up and right, as in "
            '"300 mm, 200 mm, 0 mm"',
        )
    return refusal(
        "--at",
        text,
        "no point of the block has this name; there are: {names}",
        names=", ".join(map(seen, names)),
    )


def planes(option: str, text: str, engine: Engine) -> list[float]:
    """Places along the shaft in the units of the engine."""
    parts, example = listed(text), _('as in "-200 mm, 200 mm"')
    if not 1 <= len(parts) <= 64:
        raise refusal(option, text, "give places along the shaft, {example}", example=example)
    return places(option, parts, [POSITION] * len(parts), engine, example)


def length(
    option: str, text: str | None, engine: Engine, *, positive: bool = False
) -> float | None:
    """A length across the crankshaft in the units of the engine."""
    if text is None:
        return None
    value = places(option, [text.strip()], [LENGTH], engine, _('as in "60 mm"'))[0]
    if positive and not value > 0:
        raise not_positive(option, text, LENGTH)
    if positive and value < LEAST:
        least = scales(engine).across.text(LEAST)
        raise refusal(option, text, "it is too small; give {least} or more", least=least)
    return value


def places(
    option: str, parts: list[str], marks: list[Quantity], engine: Engine | None, example: str
) -> list[float]:
    """Lengths with their units, or bare where the engine counts in units of its own.

    Without an engine, which is refused itself, what none of them could have is refused.
    """
    relative = frozenset[str]() if engine is None else frozenset(engine.relative)
    if engine is not None and along_in_radii(engine):
        marks = [replace(mark, relative_to=LENGTH.relative_to) for mark in marks]
    read = bare_numbers.reader(relative)
    values: list[float] = []
    for part, mark in zip(parts, marks, strict=False):
        if engine is None and units.is_bare(part):
            values.append(float(part))
            continue
        counted = mark.relative_to & relative
        if units.is_bare(part) and not counted:
            raise refusal(option, part, "write it with a unit, {example}", example=example)
        with reading(option, example="" if counted else example):
            values.append(read(part, mark))
    return values
