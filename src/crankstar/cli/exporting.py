"""The verb that writes an engine for another tool: export."""

from __future__ import annotations

from functools import partial
from typing import Annotated

from crankstar.cli.options import (
    EngineName,
    Estimating,
    ReferencePoint,
    Settings,
    Speed,
    loaded_values,
    option,
    together,
)
from crankstar.cli.output import complain, write, write_bytes
from crankstar.language.messages import N_, _
from crankstar.options import values as request
from crankstar.options.forms import form_of
from crankstar.options.values import refusal
from crankstar.tables.ranges import estimated_paths


def export(
    engine: EngineName,
    /,
    *,
    speed: Speed = None,
    reference: ReferencePoint = None,
    theta: Annotated[
        str | None, option("--theta", "For the parts in .glb and .stl (default: 0 deg).")
    ] = None,
    settings: Settings = None,
    estimate: Estimating = False,
    output: Annotated[
        str | None,
        option("--output", "A model for EXUDYN (.py), or the moving parts (.glb, .stl)."),
    ] = None,
) -> None:
    """Write an engine for another tool: a model for EXUDYN (.py), solids (.glb, .stl)."""
    form = form_of(output, ("py", "glb", "stl"))
    other = {"--theta": theta} if form == "py" else {"--speed": speed, "--reference": reference}
    request.refuse_unused(other, beside=f"-o .{form}")
    (loaded, _spread), turning = together(
        partial(loaded_values, engine, settings, estimate=estimate), partial(request.speed, speed)
    )
    if form == "py":
        from crankstar.exports.exudyn import exudyn_script

        point = request.reference(reference, loaded)
        write(exudyn_script(loaded, speed=turning, reference=point), output)
    else:
        from crankstar.exports.solids import glb_bytes, stl_bytes

        angles = request.angles(theta)
        if len(angles) > 1:
            raise refusal("--theta", theta, N_('give one crank angle, such as "30 deg"'))
        content = glb_bytes if form == "glb" else stl_bytes
        write_bytes(content(loaded, theta=angles[0] if angles else 0.0), output)
    if paths := estimated_paths(loaded):
        complain(
            _("Estimated: {paths}. The file has their typical values.", paths=", ".join(paths))
        )
