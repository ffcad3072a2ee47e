"""The same vibration with the inertia of the moving parts as it is at each crank angle.

A throw turns by theta = W t + delta, and the inertia that it feels is J(theta). The equation of
Lagrange,

    J theta.. + J' theta.^2/2 = M

about steady running at W, with tau = W t, a dash for d/dtau, and delta small, is

    W^2 [(J delta')' + J'' delta/2] + (K + i H) delta + W C delta' = T(tau) - W^2 J'/2

whose right side is the torque of the first model: J' = -2 torque at 1 rad/s. With delta = sum
D_m exp(i m b tau) and J = sum j_n exp(i n b tau), b the lowest order, the bracket couples the
orders by

    -b^2 (m^2 + n^2)/2 j_(m-n) D_n

which for a steady J is the -k^2 J of the first model. The steady twist, m = 0, is left out as
there; so is that gas, too, is a function of the angle that the throw has, not of the even one.
"""

from __future__ import annotations

import numpy as np

from crankstar.dynamics.torsion_excitation import Excitation
from crankstar.dynamics.torsion_modes import twists
from crankstar.dynamics.torsion_response import Response
from crankstar.dynamics.torsion_system import TorsionChain
from crankstar.spectra import Complex, Real


def inertia_waves(chain: TorsionChain, excitation: Excitation) -> Complex:
    """The change of J of each freedom, amplitudes c of Re(c exp(i k theta)) [freedom, order].

    >>> from crankstar.dynamics.torsion_chain import torsion_chain
    >>> from crankstar.dynamics.torsion_excitation import excitation
    >>> from crankstar.files.catalog import load
    >>> own = {"torsion": {"inertia": "0.01 kg*m^2", "stiffness": "0.5 MN*m/rad"}}
    >>> engine = load("audi-25-tfsi", changes=own)
    >>> chain = torsion_chain(engine)
    >>> wave = inertia_waves(chain, excitation(chain, engine, None, orders=[2.0]))[0, 0]
    >>> light = engine.first.reciprocating_mass * 0.0464**2 / 2
    >>> round(float(abs(wave) / light), 2)  # half the reciprocating mass comes and goes twice
    1.0
    """
    if excitation.inertia is None:
        return np.zeros((chain.freedoms, excitation.orders.size), complex)
    waves = -2 * excitation.inertia / (1j * excitation.orders)
    # the torque of a mass on its own shaft, referred to the freedom, is -J'/2 of the freedom
    return chain.transform.T @ waves


def variable_response(
    chain: TorsionChain, excitation: Excitation, *, speed: float, lowest: float = 0.5
) -> Response:
    """The steady vibration at one speed (rad/s) with J of the angle, in all multiples of `lowest`.

    The orders of the excitation must be such multiples; the answer has all up to the highest.
    Without a change of J it is the first model:

    >>> from crankstar.dynamics.torsion_chain import torsion_chain
    >>> from crankstar.dynamics.torsion_response import response
    >>> from crankstar.engine.torsion import Chain, Disc
    >>> pair = [Disc(name="a", inertia=2), Disc(name="b", inertia=2, to="a", stiffness=4)]
    >>> chain = torsion_chain(Chain(name="pair", discs=pair))
    >>> push = Excitation(np.array([1.0, 2.0]), np.array([[6.0 + 0j, 1], [0, 0]]), None)
    >>> one = variable_response(chain, push, speed=1.0, lowest=1.0).turns
    >>> bool(np.allclose(one, response(chain, push, speeds=np.array([1.0])).turns))
    True
    """
    places = np.rint(excitation.orders / lowest).astype(int)
    count = int(places.max())
    numbers = np.array([*range(-count, 0), *range(1, count + 1)])
    freedoms = chain.freedoms
    matrix = np.zeros((numbers.size, freedoms, numbers.size, freedoms), complex)
    one = np.arange(numbers.size)
    w = speed * lowest * numbers
    _inertia, stiffness, damping = chain.matrices()
    lossy = np.imag(chain.complex_stiffness())
    matrix[one, :, one, :] = (
        stiffness + 1j * np.sign(numbers)[:, None, None] * lossy + 1j * w[:, None, None] * damping
    )
    steady = chain.inertias(np.abs(numbers) * lowest)
    for freedom in range(freedoms):
        matrix[one, freedom, one, freedom] -= w**2 * steady[:, freedom]
    _couple(matrix, numbers, places, inertia_waves(chain, excitation), speed * lowest)
    driving = np.zeros((1, count, len(chain.names)), complex)
    driving[0, places - 1] = excitation.torque(speed).T
    half = driving[0] @ chain.transform / 2
    push = np.concatenate([np.conj(half[::-1]), half])
    size = numbers.size * freedoms
    found = np.linalg.solve(matrix.reshape(size, size), push.reshape(size))
    turns = 2 * found.reshape(numbers.size, freedoms)[count:] @ chain.transform.T
    orders = lowest * np.arange(1, count + 1)
    between = twists(chain, turns[None])
    return Response(
        chain,
        np.array([speed]),
        orders,
        turns[None],
        between,
        _stiffnesses(chain, speed * orders) * between,
        driving,
        excitation.inertia is None,
    )


def _couple(matrix: Complex, numbers: Real, places: Real, waves: Complex, base: float) -> None:
    """Add what the change of J of each freedom couples between the orders."""
    apart = numbers[:, None] - numbers[None, :]
    weight = -(base**2) * (numbers[:, None] ** 2 + numbers[None, :] ** 2) / 2
    one = np.arange(numbers.size)
    for freedom, wave in enumerate(waves):
        lines = np.zeros(2 * int(np.abs(apart).max()) + 1, complex)
        middle = lines.size // 2
        lines[middle + places] = wave / 2
        lines[middle - places] = np.conj(wave) / 2
        matrix[one[:, None], freedom, one[None, :], freedom] += weight * lines[middle + apart]


def _stiffnesses(chain: TorsionChain, w: Real) -> Complex:
    """The dynamic stiffness of each section on its own shaft [order, section]."""
    own = np.array([each.stiffness * (1 + 1j * each.loss_factor) for each in chain.sections])
    return own + 1j * np.multiply.outer(w, [each.damping for each in chain.sections])
