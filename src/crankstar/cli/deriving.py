"""The verb that derives."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from crankstar.cli.options import (
    EngineName,
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
from crankstar.cli.output import complain, display, working, writable, write
from crankstar.language.messages import _
from crankstar.options import points
from crankstar.options import values as request
from crankstar.options.forms import DERIVATIONS, format_of
from crankstar.options.values import refusal

if TYPE_CHECKING:
    from crankstar.engine.engine import Engine


def derive(
    engine: EngineName,
    /,
    *,
    orders: Annotated[str | None, option("--orders", "Default: 1,2; all is 1,2,4,6.")] = None,
    quantity: Annotated[
        str | None,
        option(
            "--quantity",
            "Also motion (one piston, up to its harmonics A_2, A_4, A_6), torque, gas (which "
            "orders of gas torque vanish), and twist (which twist the crankshaft, in a straight "
            "shape). Default: motion, force and couple; force and couple with --orders.",
        ),
    ] = None,
    asked: Annotated[
        str | None, option("--format", "Default: as the name of -o ends, else text.")
    ] = None,
    notation: Annotated[str | None, option("--notation")] = None,
    power: Annotated[int | None, option("--power")] = None,
    symbolic: Annotated[str | None, option("--symbolic")] = None,
    signs: Annotated[bool, option("--signs")] = False,
    off: Annotated[str | None, option("--off", "For --quantity gas.")] = None,
    speed: Speed = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    output: Annotated[
        str | None, option("--output", ".txt, .tex, .md or .html. Default: standard output.")
    ] = None,
) -> None:
    """Derive the exact closed form of each order, step by step, from one cylinder to the sum."""
    from crankstar.derive import documents, notations

    names = request.listed(quantity)
    given = {
        "--orders": orders,
        "--quantity": quantity,
        "--power": power,
        "--speed": speed,
        "--reference": reference,
    }
    given |= {"--signs": signs, "--symbolic": symbolic, "--quantity": quantity, "--off": off}
    usual = "sinitsyn" if signs else "crankstar"
    load = once(partial(read_engine, engine, settings, ranged=False))
    read_kinds = once(partial(request.quantities, quantity))
    form, found, turning, point, kinds, silent, numbers, letters, *_checked = together(
        partial(_format, output, asked),
        load,
        partial(request.speed, speed),
        lambda: points.reference(reference, engine_read(load)),
        read_kinds,
        partial(request.cylinders_off, off),
        partial(request.derived_orders, "1,2" if orders is None else orders),
        partial(notations.chosen, usual if notation is None else notation),
        partial(_check_power, power),
        *(_unused(given, names) if or_none(read_kinds) is not None else ()),
    )
    loaded = found.engine
    wanted: list[tuple[Fraction, request.Derived]] = [
        (number, kind) for number in numbers for kind in kinds
    ]
    whole = orders is None and quantity is None and symbolic is None and not signs
    own = _Asked(wanted, names, orders, signs, symbolic, point, silent, whole)
    with working(_("Deriving ...")) as tell:
        derived = partial(_chapters, loaded, own, tell)
        chapters = derived(turning, power)
        without = notations.chosen(usual)
        _say_unused(
            documents.FORMATS["markdown"],
            (chapters, letters),
            {
                "--speed": None if speed is None else lambda: (derived(None, power), letters),
                "--power": None if power is None else lambda: (derived(turning, None), letters),
                "--notation": None if notation is None else lambda: (chapters, without),
            },
        )
    if form == "text":
        display(documents.rendered(chapters, letters), output)
    else:
        write(documents.FORMATS[form](chapters, letters), output)


def _format(output: str | None, asked: str | None) -> str:
    """The format of the derivation. Raises RequestError."""
    if asked is not None:
        request.choice("--format", asked, [*DERIVATIONS.values()])
    form = format_of(output, DERIVATIONS, asked=asked)
    if output is not None:
        writable(output)
    return form


def _check_power(power: int | None) -> None:
    if power is not None and not 1 <= power <= 24:
        raise refusal("--power", power, "give a power of λ from 1 to 24")


class _Asked(NamedTuple):
    """What is to be derived; `whole`: nothing was named, so that the motion comes first."""

    wanted: list[tuple[Fraction, request.Derived]]
    names: Sequence[str]
    orders: str | None
    signs: bool
    symbolic: str | None
    point: Any
    silent: tuple[int, ...]
    whole: bool


def _chapters(
    loaded: Engine,
    given: _Asked,
    tell: Callable[[str], None],
    turning: float | None,
    power: int | None,
) -> list[Any]:
    """The chapters of what is asked for, at a speed and to a power of λ."""
    from crankstar import derive as exact
    from crankstar.tables.resting_derivations import with_record

    signs, names, orders, symbolic = given.signs, given.names, given.orders, given.symbolic
    point = given.point
    chapters = [exact.signs_chapter(loaded, reference=point)] if signs else []
    if given.whole or "motion" in names:
        chapters.append(exact.motion_chapter(loaded, power=power or 7))
    if "gas" in names and not signs:
        asked_for = () if orders is None else request.derived_orders(orders)
        chapters.append(exact.gas_orders(loaded, asked_for, off=given.silent))
    if "twist" in names and not signs:
        asked_for = () if orders is None else request.derived_orders(orders)
        chapters.append(exact.twist_orders(loaded, asked_for))
    for number, kind in [] if signs else given.wanted:
        tell(_("Deriving the {quantity} of order {order} ...", quantity=_(kind), order=number))
        if symbolic is not None:
            chapters.append(exact.family(loaded, number, kind, symbol=symbolic))
            continue
        made = (
            exact.inertia_torque(loaded, number, speed=turning, power=power or 7)
            if kind == "torque"
            else exact.derivation(
                loaded, number, kind, reference=point, speed=turning, power=power or 7
            )
        )
        about = {"order": number, "quantity": kind, "speed": turning, "reference": point}
        chapters.append(with_record(made, loaded, **about))
    return chapters


def _say_unused(
    written: Callable[..., str], made: Any, without: Mapping[str, Callable[[], Any] | None]
) -> None:
    """Say of each option that is given whether the text is the same `without` it."""
    for name, other in without.items():
        if other is not None and written(*other()) == written(*made):
            complain(_("{option} changes nothing in this derivation.", option=name))


def _unused(given: Mapping[str, Any], names: Sequence[str]) -> Iterator[Callable[[], None]]:
    """What refuses options that have no effect on what is derived."""
    signs, symbolic = given["--signs"], given["--symbolic"]
    of_order = ("--orders", "--quantity", "--power", "--speed", "--reference")

    def beside(what: str, *left_out: str) -> Callable[[], None]:
        unused = {name: given[name] for name in left_out}
        return partial(request.refuse_unused, unused, beside=what)

    if "gas" not in names or signs or symbolic is not None:
        silent = {"--off": given["--off"]}
        yield partial(request.refuse_unused, silent, without="--quantity gas")
    if signs:
        yield beside("--signs", "--orders", "--quantity", "--power", "--speed", "--symbolic")
    elif symbolic is not None:
        if names and not BY_ORDER & {*names}:  # none is derived order by order
            yield beside(f"--quantity {','.join(names)}", "--symbolic")
        yield beside("--symbolic", *of_order[2:])
    elif names and not BY_ORDER & {*names}:
        also = "--power" if "motion" not in names else ""
        yield beside(
            f"--quantity {','.join(names)}", *filter(None, (also, "--speed", "--reference"))
        )
    elif names and "couple" not in names:
        yield beside(f"--quantity {','.join(names)}", "--reference")
    if names == ["motion"]:
        yield beside("--quantity motion", "--orders")


BY_ORDER = {"force", "couple", "torque"}
"""Quantities that are derived order by order, in newtons where there is a speed."""
