"""The verb that writes an engine for another tool: export."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Annotated, Any

from crankstar.cli.options import (
    EngineName,
    Estimating,
    ReferencePoint,
    Settings,
    Speed,
    engine_read,
    once,
    option,
    or_none,
    read_engine,
    together,
)
from crankstar.cli.output import complain, writable_form, write, write_bytes
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _, passage
from crankstar.options import points
from crankstar.options import values as request
from crankstar.options.values import refusal
from crankstar.tables.ranges import estimated_paths, listed

PROGRAMS = ("opentorsion", "ross")
"""For what twists."""
OWN = (None, "exudyn", *PROGRAMS)
"""What `--to` may be without another package."""
FORMS = ("py", "glb", "stl")


def export(
    engine: EngineName,
    /,
    *,
    speed: Speed = None,
    reference: ReferencePoint = None,
    theta: Annotated[
        str | None, option("--theta", "For the parts in .glb and .stl (default: 0 deg).")
    ] = None,
    to: Annotated[str | None, option("--to")] = None,
    settings: Settings = None,
    estimate: Estimating = False,
    output: Annotated[
        str | None,
        option("--output", "A model for another program (.py), or the moving parts (.glb, .stl)."),
    ] = None,
) -> None:
    """Write an engine for another tool: a script (.py: EXUDYN, openTorsion, ROSS) or solids."""
    read_form = once(partial(writable_form, output, FORMS))
    load = once(
        partial(
            read_engine, engine, settings, estimate=estimate, speed=speed, chains=to in PROGRAMS
        )
    )
    given = {"--theta": theta, "--speed": speed, "--reference": reference, "--to": to}
    added = _added(to)
    program, form, found, turning, point, angle, *_checked = together(
        partial(_program, to),
        read_form if to in OWN else partial(or_none, read_form),
        load,
        partial(request.speed, speed),
        lambda: points.reference(reference, engine_read(load)),
        partial(_angle, theta),
        *_unused(given, "" if added else or_none(read_form) or "", added=added),
    )
    if added or program in PROGRAMS:
        _write(program, found.source, output)
    elif form == "py":
        from crankstar.exports.exudyn import exudyn_script

        write(exudyn_script(found.engine, speed=turning, reference=point), output)
    else:
        from crankstar.exports.solids import assumed, glb_bytes, stl_bytes

        content = glb_bytes if form == "glb" else stl_bytes
        write_bytes(content(found.engine, theta=angle), output)
        for sentence in assumed(found.engine):
            complain(sentence)
    if isinstance(found.source, Engine):
        _tell_estimated(found.source)


def _added(to: str | None) -> bool:
    """Whether another package has this export."""
    from crankstar.exports.added import ADDED

    return to not in OWN and to in ADDED.names()


def _program(to: str | None) -> str:
    """For what an engine is written. Raises RequestError, and PackageError for what is broken."""
    from crankstar.exports.added import ADDED

    if to is None or to in OWN:
        return to or "exudyn"
    names = ADDED.names() if to in ADDED.names() else ADDED.usable()
    program = request.choice("--to", to, ("exudyn", *PROGRAMS, *names))
    ADDED[program]
    return program


def _angle(text: str | None) -> float:
    """The one crank angle of the parts, radians. Raises RequestError."""
    angles = request.angles(text)
    if len(angles) > 1:
        raise refusal("--theta", text, N_('give one crank angle, such as "30 deg"'))
    return angles[0] if angles else 0.0


def _unused(
    given: Mapping[str, str | None], form: str, *, added: bool
) -> Iterator[Callable[[], None]]:
    """What refuses options without effect on a file of this form; empty where it is not known."""

    def beside(what: str, *names: str) -> Callable[[], None]:
        unused = {name: given[name] for name in names}
        return partial(request.refuse_unused, unused, beside=what)

    to = given["--to"]
    if added:
        yield beside(f"--to {to}", "--theta", "--speed", "--reference")
        return
    if form:
        names = ("--theta",) if form == "py" else ("--speed", "--reference", "--to")
        yield beside(f"-o .{form}", *names)
    if to in PROGRAMS and form in ("", "py"):
        yield beside(f"--to {to}", "--speed", "--reference")


def _write(program: str, source: Any, output: str | None) -> None:
    """Write an engine as another package does, or the chain that twists of it or a drive line."""
    if program not in PROGRAMS:
        from crankstar.exports.added import ADDED

        write_bytes(ADDED[program](source), output)
        return
    from crankstar.exports.torsion import torsion_script

    script: Any = torsion_script
    write(script(source, to=program), output)


def _tell_estimated(engine: Engine) -> None:
    if estimated_paths(engine):
        complain(passage((listed(engine), _("The file has their typical values."))))
