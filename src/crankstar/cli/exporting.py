"""The verb that writes an engine for another tool: export."""

from __future__ import annotations

from functools import partial
from typing import Annotated

from crankstar.cli.application import app
from crankstar.cli.options import (
    EngineName,
    ReferencePoint,
    Settings,
    Speed,
    engine_and_speed,
    option,
    together,
)
from crankstar.cli.output import write
from crankstar.options import values as request
from crankstar.options.forms import form_of


@app.command
def export(
    engine: EngineName,
    /,
    *,
    speed: Speed = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    output: Annotated[
        str | None, option("--output", "model.py: a multibody model for EXUDYN, as a script.")
    ] = None,
) -> None:
    """Write an engine for another tool: a multibody model for EXUDYN (.py)."""
    from crankstar.exports.exudyn import exudyn_script

    form_of(output, ("py",))
    ((loaded, turning),) = together(partial(engine_and_speed, engine, settings, speed))
    point = request.reference(reference, loaded)
    write(exudyn_script(loaded, speed=turning, reference=point), output)
