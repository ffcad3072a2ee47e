"""Verbs about engine files: check, new, schema."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import Annotated, Any

from cyclopts import Parameter

from crankstar.cli.options import Output, option, read_engine, together
from crankstar.cli.output import complain, display, is_file, writable_form, write, write_bytes
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.files import EngineFileError, tree_of
from crankstar.files.changes import stale_sources
from crankstar.files.read_files import STANDARD_INPUT
from crankstar.files.tolerances import tolerances_of, wide
from crankstar.language.messages import _, _n
from crankstar.language.quoting import one_line
from crankstar.options.values import RequestError, choice, refusal
from crankstar.tables.scales import scales

SHOWN = 6
"""Weights that are named."""


def check(
    *files: Annotated[str, Parameter(help="Engine files, or names from the catalog.")],
) -> int:
    """Check engine files and list every mistake in them."""
    from rich.text import Text

    from crankstar.tables.assumptions import part_lines

    if not files:
        raise RequestError("check: name at least one engine file")
    failed = 0
    for name in files:
        try:
            loaded = read_engine(name, chains=True)
        except EngineFileError as error:
            failed += 1
            complain(error.listed())
        else:
            own, tree = loaded.source, loaded.tree
            if isinstance(own, Chain):
                display(_good_chain(name, own))
                continue
            lines = [
                _good(name, own),
                *(f"  {line}" for line in part_lines(own.left_out)),
                *_far(own),
                *_stale(tree),
                *(f"  {line}" for line in wide(tolerances_of(tree).values())),
                *_twice(tree),
                *_hardly(own, tree),
            ]
            display(Text("\n".join(lines)))
    return 2 if failed else 0


def _far(engine: Engine) -> list[str]:
    """A line on weights that stand far from their crankshaft, as after a slip in the unit."""
    from crankstar.remedy.counterweights import BEYOND, weights_beyond

    along = scales(engine).along
    far = weights_beyond(engine)
    places = ", ".join(along.text(z) for _shaft, z in far[:SHOWN])
    line = _n(
        "  The weight at z = {places} is more than {count} bore pitches beyond the crankshaft, "
        "farther than a vibration damper or flywheel; check its z.",
        "  The weights at z = {places} are more than {count} bore pitches beyond the crankshaft, "
        "farther than a vibration damper or flywheel; check their z.",
        len(far),
        places=places if len(far) <= SHOWN else f"{places}, ...",
        count=f"{BEYOND:g}",
    )
    return [line] if far else []


def _hardly(engine: Engine, tree: Mapping[str, Any]) -> list[str]:
    """Lines on values that hardly any engine has, and on cycles that cannot be."""
    from crankstar.engine.firing_angles import firing_doubts
    from crankstar.files.forms import is_explicit
    from crankstar.files.read import in_file
    from crankstar.mechanics.central_rods import central_doubts
    from crankstar.mechanics.magnitudes import magnitude_doubts
    from crankstar.mechanics.mass_doubts import body_doubts, piston_doubts, rod_doubts, size_doubts
    from crankstar.mechanics.stiffness_doubts import beam_doubts
    from crankstar.mechanics.usual_values import oil_doubts

    rods = any(cylinder.rod is not None for cylinder in engine.cylinders)
    if engine.gas is engine.drive is engine.torsion is None and not rods:
        # libraries of cycles stay unread
        own = [*firing_doubts(engine), *size_doubts(engine), *rod_doubts(engine)]
        own += [*central_doubts(engine), *piston_doubts(engine), *body_doubts(engine)]
        own += magnitude_doubts(engine)
        own += [*beam_doubts(engine), *oil_doubts(engine)]
    else:
        from crankstar.dynamics.uneven_doubts import doubts_of_points
        from crankstar.mechanics.doubts import doubts

        own = [*doubts(engine), *doubts_of_points(engine)]
    if engine.mounts:
        from crankstar.dynamics.mount_doubts import mount_doubts

        own += mount_doubts(engine)
    found = in_file(dict(tree), own, explicit=is_explicit(dict(tree)))
    return [f"  {fault.sentence}" for fault in found]


def _stale(tree: Mapping[str, Any]) -> list[str]:
    """A line on the sources of values that the file has no more; they do no harm."""
    paths = stale_sources(dict(tree))
    line = _n(
        "  The source of {paths} is of an entry that the file does not have; leave it out.",
        "  The sources of {paths} are of entries that the file does not have; leave them out.",
        len(paths),
        paths=one_line(", ".join(paths), longest=400),
    )
    return [line] if paths else []


def _twice(tree: Mapping[str, Any]) -> list[str]:
    """A line on counterweights that are there twice: given, and by a balance factor."""
    crank = tree.get("crankshaft")
    crankshafts = crank if isinstance(crank, list) else [crank]
    weighted = any(isinstance(each, Mapping) and each.get("weight") for each in crankshafts)
    line = _(
        "  The crankshaft has its own weights and those of balance_factor besides; leave "
        "balance_factor out if the weights are all there are."
    )
    return [line] if weighted and "balance_factor" in tree else []


def _good(name: str, engine: Engine) -> str:
    """The line on a file without a mistake: the engine, its pistons, its firing intervals."""
    from crankstar.tables.headings import firing_text

    count = len(engine.cylinders)
    engine_text = _n(
        "{name}, {count} piston", "{name}, {count} pistons", count, name=engine.name, count=count
    )
    if engine.firing_order:
        fires = firing_text(engine)
        engine_text = _("{engine}; fires {firing}", engine=engine_text, firing=fires)
    file = _("standard input") if name == STANDARD_INPUT else one_line(name)
    return _("{file}: good ({engine})", file=file, engine=engine_text)


def _good_chain(name: str, chain: Chain) -> str:
    """The line on a drive line without a mistake."""
    count = len(chain.discs)
    discs = _n("{name}, {count} disc", "{name}, {count} discs", count, name=chain.name, count=count)
    file = _("standard input") if name == STANDARD_INPUT else one_line(name)
    return _("{file}: good ({engine})", file=file, engine=discs)


def new(
    layout: Annotated[
        str, Parameter(help="inline, vee, boxer, tandem, opposed, radial or explicit.")
    ],
    /,
    *,
    output: Output = None,
    overwrite: Annotated[bool, option("--overwrite")] = False,
) -> None:
    """Write a commented engine file to start from, in TOML or as a spreadsheet (.xlsx)."""
    from crankstar.engine.layouts import LAYOUTS
    from crankstar.files.starters import STARTERS

    def read_layout() -> str:
        if layout not in STARTERS and layout in LAYOUTS:
            raise refusal("layout", layout, "a package adds this layout, which has no template")
        return choice("layout", layout, STARTERS)

    def refuse_old() -> None:
        if output is not None and not overwrite and is_file(output):
            raise refusal("-o", output, "it already exists; --overwrite replaces it")

    _layout, form, _old = together(
        read_layout, partial(writable_form, output, ("toml", "xlsx")), refuse_old
    )
    if form == "toml":
        write(STARTERS[layout], output)
        return
    from crankstar.files.sheets import sheets_of
    from crankstar.files.workbook import workbook_bytes

    write_bytes(workbook_bytes(sheets_of(tree_of(STARTERS[layout]), blank=True)), output)


def schema(*, output: Output = None) -> None:
    """Print the JSON Schema of engine files, for completion and checks in an editor."""
    from crankstar.files import schema as file_schema
    from crankstar.tables.machine import json_text

    writable_form(output, ("json",))
    write(json_text(file_schema()), output)
