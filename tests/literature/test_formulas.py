"""The formulas of the page of theory, evaluated where they stand, give what the program has."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from tests.literature.formulas import formulas, value

from crankstar import spectra
from crankstar.dynamics.oil_film import mobility
from crankstar.dynamics.whirl import body, response
from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.files.catalog import load
from crankstar.mechanics.excitation import Reference, part_spectra, rolling_moment, total
from crankstar.mechanics.mechanism import mechanism
from crankstar.mechanics.pin_loads import guide_samples, pin_loads

PAGE = formulas("explanation/theory.md")
OMEGA, STEPS = 3.0, 64
"""A speed other than 1 rad/s, at which the program computes, and steps of a turn."""
PSI = np.arange(STEPS) * 2 * np.pi / STEPS
EVALUATED = (
    "P = r",
    "s s' =",
    "s s'' =",
    "Q = Q_m",
    r"x = r \cos\psi +",
    r"\sqrt{1 - u}",
    *(rf"\sin^{power}\psi" for power in (2, 4, 6, 8)),
    r"x = r \left( \cos\psi + x_0",
    r"F = m r \omega^2 \left(",
    "A_k = ",
    "F = -m",
    r"\text{force } F",
    r"\text{couple } C",
    r"\text{moment } M",
    r"\text{torque } T",
    r"\cos\theta = \tfrac12",
    r"\operatorname{Im}(\bar{P} f",
    r"|\text{roll of",
    "P^* = r",
    "c_1 + c_2",
    "u_1 - u_2",
    r"\operatorname{Re}(\overline{P - Q}",
    r"\dot\varepsilon",
    r"\text{shift}_k",
    r"\text{tilt}_k",
    r"\text{turn}_k",
)
"""How the formulas begin that a test of this module evaluates."""
ELSEWHERE = {
    r"|A_k| \propto": "a rate, no equation: the tests of the motion have the length of spectra",
    r"\sin^{2n}\psi": "compared by number where the documents are tested",
    "x_2 = ": "compared by number where the documents are tested",
    "M(z) =": "a sum over what is in front: the laws of bending loads have it by statics",
}
"""How those begin that are no equation to evaluate, and why."""


def test_every_formula_of_the_page_is_evaluated_or_excused() -> None:
    begins = [*EVALUATED, *ELSEWHERE]
    found = [
        [begin for begin in begins if each.replace("&", "").startswith(begin)] for each in PAGE
    ]
    assert [each for each, known in zip(PAGE, found, strict=True) if len(known) != 1] == []
    assert sorted(begin for known in found for begin in known) == sorted(begins)


def sides(start: str) -> list[str]:
    """The sides of the formula of the page that begins so, without layout and words beside it."""
    (found,) = [each for each in PAGE if each.replace("&", "").startswith(start)]
    assert start in EVALUATED
    own = found.partition("&&")[0].partition(r"\qquad")[0]
    own = own.replace(r"+ \cdots", "").replace(r"- \cdots", "").replace("P^*", "P_s")
    return [side.strip(" &,") for side in own.split("=")]


def beside(start: str, at: int) -> str:
    """The right side of what stands beside a formula, after so many wide spaces."""
    (found,) = [each for each in PAGE if each.replace("&", "").startswith(start)]
    return found.split(r"\qquad")[at].partition("=")[2].split(r"\ \ ")[0].strip(" ,")


def rigid() -> Engine:
    """A single with a rod as a rigid body that is no pair of masses, and an offset of its axis."""
    rod = {"mass": "0.55 kg", "centre": "42 mm", "inertia": "0.0041 kg*m^2"}
    own = {"offset": "6 mm", "rod": rod, "stroke": "86 mm", "rod_length": "143 mm"}
    changes = {f"cylinder.{key}": own[key] for key in own}
    return load(
        "single",
        changes={**changes, "cylinder.rod_ratio": None, "cylinder.reciprocating_mass": "0.4 kg"},
    )


class Moving:
    """The parts of the single over a turn: what the letters of the page stand for."""

    def __init__(self) -> None:
        self.engine = rigid()
        self.machine = mechanism(self.engine)
        self.rods = motion.rods(self.machine.links, PSI)
        self.direction = motion.Path(*(each[0] for each in self.rods.direction))
        self.piston = motion.Path(*(each[0] for each in self.rods.piston))
        self.pin = motion.Path(*(each[0] for each in self.rods.big_end))
        (cylinder,) = self.engine.cylinders
        assert cylinder.rod is not None
        self.rod, self.mass = cylinder.rod, cylinder.reciprocating_mass
        self.radius, self.length = self.engine.throw(cylinder).radius, cylinder.rod_length
        self.offset = cylinder.offset
        self.theta = PSI - (self.engine.throw(cylinder).angle - cylinder.bearing)
        self.centre = motion.Path(
            *(a + self.rod.centre * b for a, b in zip(self.pin, self.direction, strict=True))
        )
        spin = np.imag(np.conj(self.direction.place) * self.direction.second)
        self.names: dict[str, Any] = {"omega": OMEGA, "I": self.rod.inertia, "beta''": spin}

    def force(self, mass: float, path: motion.Path) -> Any:
        """The inertia force of a body by the page's own law."""
        return value(sides(r"\text{force } F")[1], {**self.names, "m": mass, "P''": path.second})


@pytest.fixture(scope="module")
def moving() -> Moving:
    return Moving()


def test_the_place_of_the_piston_and_its_derivatives(moving: Moving) -> None:
    r, length, offset = moving.radius, moving.length, moving.offset
    names = {"r": r, "l": length, "e": offset, "psi": PSI}
    assert value(sides("P = r")[1], names) == pytest.approx(moving.piston.place, abs=1e-12)
    y = r * np.sin(PSI) - offset
    s, first = np.sqrt(length**2 - y**2), np.real(moving.piston.first) + r * np.sin(PSI)
    second = np.real(moving.piston.second) + r * np.cos(PSI)
    names = {"y": y, "y'": r * np.cos(PSI), "y''": -r * np.sin(PSI)}
    names |= {"s": s, "s'": first, "s''": second}
    for start in ("s s' =", "s s'' ="):
        left, right = (value(side, names) for side in sides(start))
        assert left == pytest.approx(right, abs=1e-12)


def test_the_big_end_of_an_articulated_rod() -> None:
    links = mechanism(load("radial-9")).links
    found = motion.rods(links, PSI)
    slave = next(i for i, master in enumerate(links.master) if master >= 0)
    master = links.master[slave]
    names = {
        "Q_m": found.big_end.place[master],
        "P_m": found.piston.place[master],
        "l_m": links.rod_length[master],
        "rho": links.knuckle_radius[slave],
        "kappa": links.knuckle_angle[slave],
    }
    assert value(sides("Q = Q_m")[1], names) == pytest.approx(found.big_end.place[slave], abs=1e-12)


def test_the_steps_to_the_secondary_force_are_equations() -> None:
    ratio, r = 0.3, 2.0
    names = {"lambda": ratio, "r": r, "l": r / ratio, "psi": PSI, "u": 0.01}
    first, second = (value(side, names) for side in sides(r"x = r \cos\psi +")[1:])
    assert first == pytest.approx(second, abs=1e-12)
    left, *_sum, right = sides(r"\sqrt{1 - u}")
    assert value(left, names) == pytest.approx(value(right, names), abs=1e-11)
    for power in (2, 4, 6, 8):
        left, right = (value(side, names) for side in sides(rf"\sin^{power}\psi"))
        assert left == pytest.approx(right, abs=1e-12)
    harmonics = np.real(motion.piston_harmonics(crank_radius=1, rod_length=1 / ratio))
    names |= {f"A_{k}": harmonics[k] for k in (2, 4, 6)} | {"m": 0.4, "omega": OMEGA}
    names |= {f"x_{k}": harmonics[k] / k**2 for k in (2, 4, 6)} | {"x_0": 0.0}
    place = value(sides(r"x = r \left( \cos\psi + x_0")[1], names)
    assert place - place.mean() == pytest.approx(first - first.mean(), abs=1e-5 * r)
    force = value(sides(r"F = m r \omega^2 \left(")[1], names)
    rate = np.fft.rfft(first) * (1j * np.arange(STEPS // 2 + 1)) ** 2
    assert force == pytest.approx(-0.4 * OMEGA**2 * np.fft.irfft(rate, STEPS), abs=1e-3)
    for k in (2, 4, 6):
        own = {
            "k": k,
            f"x_{k}": harmonics[k] / k**2,
            "lambda": ratio,
            "psi": np.pi * (PSI / 2 / np.pi),
        }
        law = beside(r"F = m r \omega^2 \left(", 1).replace("x_k", f"x_{k}")
        assert value(law, own) == pytest.approx(harmonics[k])
        front, integrand = sides("A_k = ")[1].split(r"\int_0^{\pi}")
        at = (np.arange(400) + 0.5) * np.pi / 400
        inside = value(integrand.replace(r"d\psi", ""), {**own, "psi": at})
        assert value(front, own) * inside.mean() * np.pi == pytest.approx(harmonics[k], rel=1e-9)


def test_force_moment_and_torque_of_moving_parts(moving: Moving) -> None:
    """Summed over piston and rod, the laws of the page are the sums of the program."""
    up, right, z0 = 0.02, -0.01, 0.03
    machine = moving.machine
    sums = total(part_spectra(machine, reference=Reference(z0, up, right)))
    pairs = [(moving.mass, moving.piston), (moving.rod.mass, moving.centre)]
    forces = [moving.force(mass, path) for mass, path in pairs]
    scale = OMEGA**2
    assert sum(forces) == pytest.approx(scale * spectra.value(sums.force, moving.theta), abs=1e-9)
    piston = sides("F = -m")[1]
    names = {**moving.names, "m": moving.mass, "P''": moving.piston.second}
    assert value(piston, names) == pytest.approx(forces[0])
    couple = sides(r"\text{couple } C")[1]
    z = moving.engine.cylinders[0].z
    arms = [value(couple, {"z": z, "z_0": z0, "F": force}) for force in forces]
    assert sum(arms) == pytest.approx(scale * spectra.value(sums.couple, moving.theta), abs=1e-9)
    law = sides(r"\text{moment } M")[1]
    moment = np.zeros(STEPS)
    for (_mass, path), force, inertia in zip(pairs, forces, (0.0, moving.rod.inertia), strict=True):
        own = {"P": path.place, "P_0": up + 1j * right, "F": force, "I": inertia}
        moment += value(law, {**moving.names, **own})
    found = np.real(spectra.value(sums.axis_moment, moving.theta))
    assert moment == pytest.approx(scale * found, abs=1e-9)
    turned = np.imag(np.conj(moving.direction.place) * moving.direction.first)
    assert moving.rod.inertia is not None
    energy = sum(mass / 2 * np.abs(path.first) ** 2 for mass, path in pairs)
    energy = scale * (energy + moving.rod.inertia / 2 * turned**2)
    rate = np.fft.irfft(np.fft.rfft(energy) * 1j * np.arange(STEPS // 2 + 1), STEPS)
    (torque,) = sides(r"\text{torque } T")[1:]
    assert torque == r"-\frac{dE}{d\theta}"
    assert -rate == pytest.approx(
        scale * np.real(spectra.value(sums.torque, moving.theta)), abs=1e-9
    )


def test_guide_force_and_pin_load(moving: Moving) -> None:
    """At a speed other than 1 rad/s: the turning of the rod has the square of it, too."""
    piston, rod = (
        moving.force(mass, path)
        for mass, path in ((moving.mass, moving.piston), (moving.rod.mass, moving.centre))
    )
    start = r"\operatorname{Re}(\overline{P - Q}"
    names = {**moving.names, "F_p": piston, "F_r": rod, "F_b": 0.0, "a": 1.0}
    names |= {"P": moving.piston.place, "Q": moving.pin.place, "C": moving.centre.place}
    left, right = sides(start)
    along = value(left, {**names, "g": 1.0})
    guide = value(beside(start, 1), {**names, "g": value(right, names) / along})
    found = guide_samples(moving.machine, motion.rods(moving.machine.links, PSI))[0]
    assert np.abs(guide).max() > 0.05
    assert guide == pytest.approx(OMEGA**2 * found, abs=1e-9)
    pin = value(beside(start, 2), {**names, "G": guide})
    at_pin = spectra.value(pin_loads(moving.machine).pin, moving.theta)[0]
    assert pin == pytest.approx(OMEGA**2 * at_pin, abs=1e-9)


def test_where_a_balance_shaft_belongs() -> None:
    chance = np.random.default_rng(3)
    vector, place, other, c0 = chance.normal(size=4) + 1j * chance.normal(size=4)
    start = r"\operatorname{Im}(\bar{P} f"
    left, right = sides(start)
    for sense, at in ((1, 1), (-1, 2)):
        names = {"P": place, "f": vector, "s": sense, "k": 2.0, "theta": PSI}
        c = value(beside(start, at), names)
        assert value(left, names) == pytest.approx(value(right, {**names, "c": c}), abs=1e-12)
    least = 1j * c0 / np.conj(vector)
    names = {"f": vector, "P": place, "P_s": least}
    c = value(beside(start, 2), names)
    assert value(sides(r"|\text{roll of")[1], names) == pytest.approx(abs(c0 + c))
    first, second = sides("c_1 + c_2")[1:]
    push = 1.7
    pair = {"f": push, "P_1": place, "P_2": other, "u_1": place.real, "v_1": place.imag}
    pair |= {"u_2": other.real, "v_2": other.imag}
    whole = value(beside(start, 1), {"P": place, "f": push})
    whole += value(beside(start, 2), {"P": other, "f": push})
    assert value(first, pair) == pytest.approx(whole)
    assert value(second, pair) == pytest.approx(whole)
    half = {"theta": PSI, "f": 0.35}
    whole, after = sides(r"\cos\theta = \tfrac12")[1].split(r"\to")
    assert value(whole.replace(r"\quad", ""), half) == pytest.approx(np.cos(PSI))
    assert value(after, half) == pytest.approx(np.cos(PSI) - 0.35 * np.exp(1j * PSI))


def test_the_places_of_shafts_without_roll_by_their_series() -> None:
    ratio = 0.25
    at = np.arange(4096) * 2 * np.pi / 4096
    place = np.cos(at) + np.sqrt(1 / ratio**2 - np.sin(at) ** 2)
    step = np.arange(2049) * 1j
    speed, rate = (np.fft.irfft(np.fft.rfft(place) * step**n, 4096) for n in (1, 2))
    torque = 2 * np.fft.rfft(-speed * rate) / 4096  # of 1 m r^2 w^2, by order
    harmonics = np.real(motion.piston_harmonics(crank_radius=1, rod_length=4))
    names = {"lambda": ratio, "r": 1.0, "l": 4.0, "A_2": harmonics[2]}
    single = value(sides("P^* = r")[1].partition(r"\text")[0], names)
    assert single == pytest.approx(abs(torque[1]) / 0.5, rel=1e-4)
    first, second = (value(side, names) for side in sides("u_1 - u_2")[1:])
    exact = 4 * abs(torque[2]) / (2 * 2 * harmonics[2])  # both of f = 2 A_2: c0 = f (u1 - u2)
    assert first == pytest.approx(exact * 2, rel=1e-3)
    assert second == pytest.approx(exact * 2, rel=1e-3)


def test_the_mobility_of_a_short_bearing() -> None:
    start = r"\dot\varepsilon"
    epsilon = 0.4 - 0.3j
    names = {"xi": epsilon.real, "eta": epsilon.imag, "L": 0.4, "D": 1.0}
    sides(start)
    found = mobility(epsilon, length_ratio=0.4)
    assert value(beside(start, 1), names) == pytest.approx(found.real)
    assert value(beside(start, 2), names) == pytest.approx(found.imag)


def test_the_motion_of_the_free_engine() -> None:
    engine = load("v8-cross-plane")
    own = body(engine)
    orders = (1.0, 2.0, 4.0)
    found = response(engine, of=own, orders=orders)
    up, right, z = own.centre
    machine = mechanism(engine)
    sums = total(part_spectra(machine, reference=Reference(z, up, right), orders=orders))
    roll = rolling_moment(sums)
    speed = OMEGA**2
    names: dict[str, Any] = {"M": own.mass, "omega": OMEGA}
    names |= {f"I_{key}": size for key, size in zip(("up", "right", "z"), own.inertia, strict=True)}
    for at, k in enumerate(orders):
        now = {**names, "k": k, "theta": 0.0}
        for way in ("vertical", "horizontal"):
            part: Callable[..., Any] = getattr(spectra, way)
            force = {"F_k": speed * part(sums.force)[at]}
            shift = value(sides(r"\text{shift}_k")[1], {**now, **force})
            assert shift == pytest.approx(part(found.shift)[at], abs=1e-12)
        couple = {
            "C_k,up": speed * spectra.vertical(sums.couple)[at],
            "C_k,right": speed * spectra.horizontal(sums.couple)[at],
        }
        law = sides(r"\text{tilt}_k")[1]
        upward, across = (
            value(law, {**now, **{key: couple[key] * (key == one) for key in couple}})
            for one in couple
        )
        assert upward == pytest.approx(spectra.vertical(found.tilt)[at], abs=1e-12)
        assert across == pytest.approx(1j * spectra.horizontal(found.tilt)[at], abs=1e-12)
        turn = value(sides(r"\text{turn}_k")[1], {**now, "R_k": speed * spectra.vertical(roll)[at]})
        assert turn == pytest.approx(spectra.vertical(found.turn)[at], abs=1e-12)
