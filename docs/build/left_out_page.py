"""The table of what the model leaves out, each with its size in an engine of the catalog."""

from __future__ import annotations

from functools import cache
from math import degrees, pi, sqrt

import numpy as np

from crankstar import load, spectra
from crankstar.dynamics.torsion_analysis import torsion
from crankstar.dynamics.uneven import running
from crankstar.dynamics.uneven_forces import changes
from crankstar.dynamics.whirl import body
from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import gas_torque, piston_torque

FIVE, DIESEL, EIGHT = "audi-25-tfsi", "mwm-6-diesel", "cadillac-ld8"
GRAVITY = 9.80665
CLEARANCE = 50e-6
"""m: radial play of a main bearing or of a piston in its bore that is about the greatest usual."""
SHANK = 3e-4
"""m^2: section of a connecting rod of a car."""
STEEL = 210e9
VALVE, LIFT, OPEN = 0.09, 0.010, 240.0
"""kg of a valve with its spring and follower, its lift in m, degrees of the crankshaft open."""
FLYWHEEL = 0.15
"""kg m^2 of a car engine's flywheel."""
CRANKCASE = 5e3
"""Pa by which the pressure below the pistons is taken to swing with each turn."""
SPREAD = 0.05
"""Share by which the pressure of one cylinder differs from the others'."""
SCATTER = 0.001
"""kg by which reciprocating masses scatter."""


Row = tuple[str, str, str, str]


def page(part: str) -> str:
    """A part of the page: what is left out, or what is assumed here and computed elsewhere."""
    return {"table": table, "elsewhere": elsewhere}[part]()


def table() -> str:
    """What is left out, and its share of what is computed."""
    play_of, swing = f"play of {CLEARANCE * 1e6:g} µm", f"{CRANKCASE / 1e3:g} kPa"
    one, valve = "inertia force of order 1", "a valve with its spring and follower"
    rows: list[tuple[str, str, float, str]] = [
        ("weight of the moving parts", f"{one}, 750 rpm", weight(750), "1/ω²"),
        ("the same", f"{one}, 6500 rpm", weight(6500), "1/ω²"),
        ("gyroscopic couple as a V8 rocks", "couple of order k = 1", gyroscopic(), "1/k"),
        (f"{play_of} in main bearings", one, play(), "play/r"),
        (f"a piston that crosses {play_of}", one, slap(), "play/r, and it knocks"),
        ("elastic rods", "order 1 at 6500 rpm", rod_compression(1), "(k ω)²"),
        ("the same", "order 4 at 6500 rpm", rod_compression(4), "(k ω)²"),
        (f"inertia force of {valve}", f"{one} of a piston", valves(), "as the pistons'"),
        (f"crankcase pressure ± {swing}", "gas torque of order 2 of a cylinder", crankcase(), "-"),
        (
            f"pressure of one cylinder {percent(SPREAD)} off",
            "mean torque: order ½, not there before",
            spread(),
            "load",
        ),
        (
            "elastic block",
            "motion on mounts, at ⅓ of its first frequency",
            block_bending(1 / 3),
            "f²",
        ),
        ("the same", "at ½ of its first frequency", block_bending(1 / 2), "f²"),
    ]
    heads = ("left out", "beside what", "share", "grows with")
    return _table(heads, [(what, beside, percent(n), how) for what, beside, n, how in rows])


def elsewhere() -> str:
    """Unevenness, twist and scatter, which commands compute."""
    order, change, swing = unevenness()
    driving, angle, force = twisted()
    idle = f"{load(FIVE).name} at idle, flywheel {FLYWHEEL:g} kg m²: the speed swings by "
    worst = f"{load(DIESEL).name}, order {driving:g} at its strongest critical speed: "
    pistons = f"a six at 6000 rpm, pistons that scatter by {SCATTER * 1e3:g} g rms"
    rows = [
        (
            "the crankshaft turns evenly",
            "`crankstar torque`",
            idle + percent(swing),
            f"couple of order {order:g}: {percent(change)} of the greatest order",
        ),
        (
            "the crankshaft is rigid",
            "`crankstar torsion`",
            f"{worst}{degrees(angle):.2g}° of twist",
            f"force of order 1: {percent(force)} of one piston's, where there was none",
        ),
        (
            "all cylinders are alike",
            "`crankstar tolerance`",
            pistons,
            f"force of order 1: {scatter(6000):.3g} N rms, where there was none",
        ),
    ]
    return _table(("assumed", "computed by", "example", "what it changes"), rows)


def _table(heads: Row, rows: list[Row]) -> str:
    return "\n".join(f"| {' | '.join(each)} |" for each in (heads, ("---",) * 4, *rows))


def percent(share: float) -> str:
    """A share with two digits."""
    return f"{share * 100:.2g} %"


def weight(rpm: float) -> float:
    """The weight of moving parts beside their inertia force, g/(r w^2)."""
    return GRAVITY / (_radius(load(FIVE)) * (rpm * pi / 30) ** 2)


def gyroscopic() -> float:
    """The gyroscopic couple of a rocking engine beside the couple that rocks it, J/(I k) at k = 1.

    A couple C of order k turns the block at the rate C/(I k w); J w times that is the couple.
    """
    engine = load(EIGHT)
    turning = float(torsion(engine).chain.inertia.sum())
    return turning / min(body(engine).inertia[:2])


def play() -> float:
    """Play in a main bearing beside the crank radius: what it changes of a force of order 1."""
    return CLEARANCE / _radius(load(FIVE))


def slap() -> float:
    """A piston that crosses its play twice a turn, beside the inertia force of order 1."""
    return 2**2 * CLEARANCE / 2 / _radius(load(FIVE))


def rod_compression(order: float) -> float:
    """How much an elastic rod raises a force of an order: the square of k w/w_n."""
    engine = load(FIVE)
    first = engine.cylinders[0]
    natural = STEEL * SHANK / first.rod_length / first.reciprocating_mass
    return (order * (engine.speed or 0.0)) ** 2 / natural


def valves() -> float:
    """The inertia force of one valve beside that of order 1 of a piston.

    The lift goes as half of a cosine while it is open: m (h/2) (360/OPEN w)^2.
    """
    engine = load(FIVE)
    piston = engine.cylinders[0].reciprocating_mass * _radius(engine)
    return VALVE * LIFT / 2 * (360 / OPEN) ** 2 / piston


@cache
def unevenness() -> tuple[float, float, float]:
    """At idle with a flywheel: the order whose couple changes most, and by which share; the swing.

    Share of the greatest couple of all orders; swing of the speed from least to greatest.
    """
    engine = load(FIVE)
    found = cycle(engine, point="idle")
    swung = running(engine, found, flywheel=FLYWHEEL)
    told = [each for each in changes(engine, swung) if each.quantity == "couple"]
    most = max(told, key=lambda each: abs(each.uneven - each.even))
    top = max(each.even for each in told)
    swing = float(np.ptp(swung.speed) / swung.mean_speed)
    return most.order, abs(most.uneven - most.even) / top, swing


@cache
def twisted() -> tuple[float, float, float]:
    """The worst critical speed: its order, the twist (rad), and the force that is no longer zero.

    The force, of that of one piston, is of the crank whose throws stand as far from their places
    as they swing.
    """
    engine = load(DIESEL)
    found = torsion(engine)
    worst = found.noted[0]
    nodes = list(found.chain.throws)
    at = torsion(engine, speed=worst.speed).at
    assert at is not None  # noqa: S101  # a speed was asked for
    column = int(np.argmin(np.abs(at.orders - worst.order)))
    turn = np.abs(at.turns[0, column][nodes])
    mode = found.modes[worst.mode - 1].shape[nodes]
    swing = float(turn[np.argmax(np.abs(mode))])
    bent = mode / np.abs(mode).max() * swing
    angles = [throw.angle for throw in engine.shafts[0].throws]
    force = abs(np.exp(1j * (np.array(angles) + bent)).sum())
    return worst.order, swing, float(force)


def crankcase() -> float:
    """A pressure below a piston that swings once a turn, beside its gas torque of order 2.

    P cos theta on the area A with the lever r sin theta has order 2, P A r/2.
    """
    engine = load(FIVE)
    found = spectra.selected(piston_torque(engine, cycle(engine)), [2.0])
    area = pi / 4 * (engine.cylinders[0].bore or 0.0) ** 2
    torque = CRANKCASE * area * _radius(engine) / 2
    return torque / float(abs(spectra.amplitude(found)[0, 0]))


def spread() -> float:
    """The torque of order 1/2 of one cylinder that differs, beside the mean torque of all."""
    engine = load(FIVE)
    found = cycle(engine)
    half = spectra.selected(piston_torque(engine, found), [0.5])
    mean = gas_torque(found).mean.sum()
    return float(SPREAD * abs(spectra.amplitude(half)[0, 0]) / mean)


def scatter(rpm: float) -> float:
    """The force of order 1, N rms, of a balanced six with unequal pistons: sqrt(N) sigma r w^2."""
    return sqrt(6) * SCATTER * 0.045 * (rpm * pi / 30) ** 2


def block_bending(share: float) -> float:
    """How much more a block moves that is not rigid, at a share of its first bending frequency."""
    return 1 / (1 - share**2) - 1


def _radius(engine: Engine) -> float:
    return engine.shafts[0].throws[0].radius
