"""The verbs that draw the engine itself: draw, animate."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from functools import partial
from typing import TYPE_CHECKING, Annotated

from crankstar.cli.options import (
    FLAT,
    EngineName,
    Estimating,
    Settings,
    engine_read,
    once,
    option,
    or_none,
    read_engine,
    together,
)
from crankstar.cli.output import complain, progress, working, writable, write_result
from crankstar.language.messages import _
from crankstar.options.forms import form_of, refuse_terminal, require, usual_place

if TYPE_CHECKING:
    from crankstar.engine.engine import Engine
    from crankstar.pictures.drawings import Picture
    from crankstar.pictures.films import Pace


@dataclass(frozen=True)
class Sight:
    """How the engine is seen: from where, how large, in which colours, with which arrows."""

    view: Annotated[str | None, option("--view")] = None
    size: Annotated[str | None, option("--size")] = None
    theme: Annotated[str | None, option("--theme")] = None
    arrows: Annotated[str | None, option("--arrows")] = None
    orders: Annotated[str | None, option("--orders", "Those of the arrows; default: all.")] = None


def draw(
    engine: EngineName,
    /,
    *,
    theta: Annotated[str | None, option("--theta", "One; default: 0 deg.")] = None,
    sight: Annotated[Sight, FLAT] = Sight(),  # it is frozen
    settings: Settings = None,
    estimate: Estimating = False,
    output: Annotated[
        str | None, option("--output", ".svg, .png or .pdf; default: ENGINE.svg.")
    ] = None,
) -> None:
    """Draw the engine itself at a crank angle, with its forces: a picture without a browser."""
    from crankstar.pictures import options as request
    from crankstar.pictures.films import STILLS

    usual = usual_place(engine, kind="svg")
    place = usual if output is None else output
    read_kind = once(partial(form_of, place, STILLS))
    loaded, picture, angle, kind, *_checked = together(
        partial(read_engine, engine, settings, estimate=estimate),
        partial(request.picture, **asdict(sight)),
        partial(request.angle, theta),
        read_kind,
        partial(refuse_terminal, output, STILLS),
        partial(writable, place),
        lambda: read_kind() == "svg" or require("chart"),
    )
    with working(_("Drawing")):
        from crankstar.pictures.drawings import drawing
        from crankstar.pictures.films import still

        content = still(drawing(loaded.engine, picture, theta=angle), kind)
    write_result(content, output, usual)
    _tell_absent(loaded.engine, picture)


def animate(
    engine: EngineName,
    /,
    *,
    sight: Annotated[Sight, FLAT] = Sight(),
    seconds: Annotated[float | None, option("--seconds")] = None,
    frames_per_second: Annotated[float | None, option("--frames-per-second")] = None,
    settings: Settings = None,
    estimate: Estimating = False,
    output: Annotated[
        str | None, option("--output", ".gif, .webp, .png (animated) or .mp4; default: ENGINE.gif.")
    ] = None,
) -> None:
    """Write the turning engine as a film that loops without a seam, without a browser."""
    from crankstar.pictures import options as request
    from crankstar.pictures.films import FILMS, film
    from crankstar.pictures.motions import turns_of
    from crankstar.stars.interrupts import ended_once

    usual = usual_place(engine, kind="gif")
    place = usual if output is None else output
    load = once(partial(read_engine, engine, settings, estimate=estimate))
    read_kind = once(partial(form_of, place, FILMS))

    def read_pace() -> Pace:
        own = engine_read(load)
        turns = 1 if own is None else turns_of(own)
        kind = or_none(read_kind) or ""
        return request.pace(kind, seconds=seconds, rate=frames_per_second, turns=turns)

    loaded, picture, pace, kind, *_checked = together(
        load,
        partial(request.picture, **asdict(sight)),
        read_pace,
        read_kind,
        partial(refuse_terminal, output, FILMS),
        partial(writable, place),
        partial(require, "chart"),
        partial(require, "film"),
    )
    with ended_once(), progress(_("Drawing")) as tell:
        content = film(
            loaded.engine,
            kind,
            picture=picture,
            pace=pace,
            tell=lambda done, of: tell(done, of, f"{done}/{of}"),
        )
    write_result(content, output, usual)
    _tell_absent(loaded.engine, picture)


def _tell_absent(engine: Engine, picture: Picture) -> None:
    """Say of which orders that are asked for there is nothing, as the tables do."""
    if picture.orders is None or not picture.arrows:
        return
    from crankstar.pictures.arrows import absent
    from crankstar.tables.by_order import none_line

    for line in none_line(absent(engine, picture.arrows, picture.orders)):
        complain(line)
