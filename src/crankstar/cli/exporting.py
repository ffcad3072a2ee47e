"""The verb that writes an engine for another tool: export."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any

from crankstar.cli.options import (
    EngineName,
    Estimating,
    ReferencePoint,
    Settings,
    Speed,
    option,
    read_engine,
    together,
)
from crankstar.cli.output import complain, write, write_bytes
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _, passage
from crankstar.options import points
from crankstar.options import values as request
from crankstar.options.forms import form_of
from crankstar.options.values import refusal
from crankstar.tables.ranges import estimated_paths, listed

PROGRAMS = ("opentorsion", "ross")
"""For what twists."""


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
    from crankstar.exports.added import ADDED

    if to is not None and to not in ("exudyn", *PROGRAMS):
        added = [*ADDED.names()] if to in ADDED.names() else [*ADDED.usable()]
        program = request.choice("--to", to, ("exudyn", *PROGRAMS, *added))
        request.refuse_unused(
            {"--theta": theta, "--speed": speed, "--reference": reference}, beside=f"--to {program}"
        )
        export_by = ADDED[program]
        loaded = read_engine(engine, settings, estimate=estimate).engine
        write_bytes(export_by(loaded), output)
        _tell_estimated(loaded)
        return
    form = form_of(output, ("py", "glb", "stl"))
    other = {"--theta": theta} if form == "py" else {"--speed": speed, "--reference": reference}
    request.refuse_unused(other | ({} if form == "py" else {"--to": to}), beside=f"-o .{form}")
    program = "exudyn" if to is None else to
    if program in PROGRAMS:
        options = {"--speed": speed, "--reference": reference}
        request.refuse_unused(options, beside=f"--to {program}")
        _write_chain(engine, settings, output, to=program, estimate=estimate)
        return
    found, turning = together(
        partial(read_engine, engine, settings, estimate=estimate, speed=speed),
        partial(request.speed, speed),
    )
    loaded = found.engine
    if form == "py":
        from crankstar.exports.exudyn import exudyn_script

        point = points.reference(reference, loaded)
        write(exudyn_script(loaded, speed=turning, reference=point), output)
    else:
        from crankstar.exports.solids import assumed, glb_bytes, stl_bytes

        angles = request.angles(theta)
        if len(angles) > 1:
            raise refusal("--theta", theta, N_('give one crank angle, such as "30 deg"'))
        content = glb_bytes if form == "glb" else stl_bytes
        write_bytes(content(loaded, theta=angles[0] if angles else 0.0), output)
        for sentence in assumed(loaded):
            complain(sentence)
    _tell_estimated(loaded)


def _write_chain(
    name: str, settings: list[str] | None, output: str | None, *, to: Any, estimate: bool
) -> None:
    """Write the chain that twists of an engine or a drive line."""
    from crankstar.exports.torsion import torsion_script

    source = read_engine(name, settings, estimate=estimate, chains=True).source
    write(torsion_script(source, to=to), output)
    if isinstance(source, Engine):
        _tell_estimated(source)


def _tell_estimated(engine: Engine) -> None:
    if estimated_paths(engine):
        complain(passage((listed(engine), _("The file has their typical values."))))
