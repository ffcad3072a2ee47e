"""The verb that makes the exhaust heard: sound."""

from __future__ import annotations

from functools import partial
from typing import Annotated

from crankstar.cli.options import EngineName, Settings, option, read_engine, together
from crankstar.cli.output import progress, writable, write_result
from crankstar.language.messages import _
from crankstar.options.forms import form_of, refuse_terminal, usual_place

SOUNDS = ("wav",)


def sound(
    engine: EngineName,
    /,
    *,
    rpm: Annotated[str | None, option("--rpm")] = None,
    seconds: Annotated[float | None, option("--seconds", "From 0.2 to 60.")] = None,
    pipe: Annotated[list[str] | None, option("--pipe")] = None,
    settings: Settings = None,
    output: Annotated[str | None, option("--output", ".wav; default: ENGINE.wav.")] = None,
) -> None:
    """Write the rhythm of the exhaust as a sound, without muffler, intake and mechanical noise."""
    from crankstar.dynamics import sound as acoustics
    from crankstar.options import sounds as request
    from crankstar.stars.interrupts import ended_once

    usual = usual_place(engine, kind="wav")
    place = usual if output is None else output
    loaded, ride, *_places = together(
        partial(read_engine, engine, settings, ranged=False),
        partial(request.ride, rpm=rpm, seconds=seconds, pipe=pipe),
        partial(refuse_terminal, output, SOUNDS),
        partial(form_of, place, SOUNDS),
        partial(writable, place),
    )
    with ended_once(), progress(_("Adding up the pulses")) as tell:
        heard = acoustics.sound(
            loaded.engine, ride=ride, tell=lambda done, of: tell(done, of, f"{done}/{of}")
        )
    write_result(acoustics.wav(heard), output, usual)
