"""EXUDYN, a multibody program, moves the block on its mounts as this package does."""

from __future__ import annotations

from importlib import import_module
from typing import Any

import numpy as np
import pytest
from tests.laws.test_mounts import BLOCK, LOOSE, PRODUCTS, v8

from crankstar.dynamics.mount_excitation import mount_excitation
from crankstar.dynamics.mount_modes import mount_modes
from crankstar.dynamics.mount_response import MountResponse, mount_response
from crankstar.dynamics.mounted_block import MountedBlock, mounted_block
from crankstar.engine.rigid_block import mount_axes

exu: Any = import_module("exudyn")
items: Any = import_module("exudyn.itemInterface")
FLUID = [{**each, "loss_factor": 0.0, "damping": [180.0, 90.0, 120.0]} for each in LOOSE]
TO_THERE = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
"""x to the right, y up, z to the front of (up, right, z)."""
TURNED = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])
"""Rotations about x, y and z of (yaw, pitch, roll)."""
SMALL = 1e-2
"""Of the forces: the program is not linear, so that motions are kept small."""
SPEED = 65.0
STEPS = 6000


class Model:
    """The block as a rigid body in EXUDYN, on spring-dampers between it and the ground."""

    def __init__(self, block: MountedBlock, start: np.ndarray, rates: np.ndarray) -> None:
        self.container = exu.SystemContainer()
        self.system = self.container.AddSystem()
        centre = TO_THERE @ block.centres[0]
        ground = self.system.AddObject(items.ObjectGround())
        self.node = self.system.AddNode(
            items.NodeRigidBodyRxyz(
                referenceCoordinates=[*centre, 0, 0, 0],
                initialCoordinates=there(start).tolist(),
                initialVelocities=there(rates).tolist(),
            )
        )
        up, right, along = (block.mass[place, place] for place in (3, 4, 5))
        yaw_pitch, yaw_roll, pitch_roll = block.mass[3, 4], block.mass[3, 5], block.mass[4, 5]
        self.body = self.system.AddObject(
            items.ObjectRigidBody(
                mass=block.mass[0, 0],
                # xx, yy, zz, yz, xz, xy: the tensor has minus the products of inertia
                inertia=[right, up, along, -yaw_roll, pitch_roll, -yaw_pitch],
                nodeNumber=self.node,
            )
        )
        for mount, along_axes, viscous in zip(
            block.mounts, block.along, block.viscous, strict=True
        ):
            place = TO_THERE @ np.array([mount.up, mount.right, mount.z])
            axes = TO_THERE @ mount_axes(mount).T
            axes[:, 2] *= np.sign(np.linalg.det(axes))  # right-handed; a spring has no sense
            markers = [
                self.system.AddMarker(
                    items.MarkerBodyRigid(bodyNumber=number, localHT=frame(axes, at))
                )
                for number, at in ((ground, place), (self.body, place - centre))
            ]
            zero = np.zeros(3)
            self.system.AddObject(
                items.ObjectConnectorRigidBodySpringDamper(
                    markerNumbers=markers,
                    stiffness=np.diag([*along_axes, *zero]),
                    damping=np.diag([*viscous, *zero]),
                )
            )

    def pushed(self, push: Any) -> None:
        """Loads on the centre of mass: force and moment by `push(t)` on our six freedoms."""
        marker = self.system.AddMarker(items.MarkerBodyRigid(bodyNumber=self.body))

        def force(_mbs: Any, t: float, _load: Any) -> list[float]:
            return (TO_THERE @ push(t)[:3]).tolist()

        def moment(_mbs: Any, t: float, _load: Any) -> list[float]:
            return (TURNED @ push(t)[3:]).tolist()

        self.system.AddLoad(
            items.LoadForceVector(markerNumber=marker, loadVectorUserFunction=force)
        )
        self.system.AddLoad(
            items.LoadTorqueVector(markerNumber=marker, loadVectorUserFunction=moment)
        )


def frame(axes: np.ndarray, place: np.ndarray) -> np.ndarray:
    """Axes and a place as a 4 x 4 matrix."""
    out = np.eye(4)
    out[:3, :3], out[:3, 3] = axes, place
    return out


def there(motion: np.ndarray) -> np.ndarray:
    """Our six freedoms as coordinates of the program."""
    return np.concatenate([TO_THERE @ motion[:3], TURNED @ motion[3:]])


def shaken() -> MountResponse:
    engine = v8(FLUID, block={**BLOCK, **PRODUCTS}, gas=True)
    block = mounted_block(engine)
    return mount_response(block, mount_excitation(block, engine, speeds=np.array([SPEED])))


def course(found: MountResponse, amplitudes: np.ndarray, t: float) -> np.ndarray:
    """Of amplitudes [order, freedom] at a time."""
    wave = np.exp(1j * found.orders * SPEED * t)
    return SMALL * np.real(wave @ amplitudes)


def test_natural_frequencies_of_a_multibody_model_are_ours() -> None:
    engine = v8(LOOSE, block={**BLOCK, **PRODUCTS})
    block = mounted_block(engine)
    model = Model(block, np.zeros(6), np.zeros(6))
    model.system.Assemble()
    values, _vectors = model.system.ComputeODE2Eigenvalues()
    theirs = np.sort(np.sqrt(np.maximum(values, 0.0)))
    assert theirs == pytest.approx([mode.speed for mode in mount_modes(block)], rel=1e-6)


@pytest.mark.release
def test_a_multibody_run_stays_on_our_steady_answer_in_all_orders() -> None:
    """Started on the harmonic answer, EXUDYN integrates inertia and gas over a whole cycle."""
    found = shaken()
    motion, push = found.motion[0], found.excitation.push[0]
    rates = 1j * found.vibration[0][:, None] * motion
    model = Model(found.block, course(found, motion, 0.0), course(found, rates, 0.0))
    model.pushed(lambda t: course(found, push, t))
    sensor = model.system.AddSensor(
        items.SensorNode(
            nodeNumber=model.node,
            storeInternal=True,
            outputVariableType=exu.OutputVariableType.Coordinates,
        )
    )
    model.system.Assemble()
    settings = exu.SimulationSettings()
    period = 4 * np.pi / SPEED
    settings.timeIntegration.numberOfSteps = STEPS
    settings.timeIntegration.endTime = period
    settings.timeIntegration.generalizedAlpha.spectralRadius = 1.0
    settings.timeIntegration.verboseMode = 0
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = period / STEPS
    model.system.SolveDynamic(settings)
    kept = np.asarray(model.system.GetSensorStoredData(sensor))
    ours = np.array([there(course(found, motion, t)) for t in kept[:, 0]])
    for freedom in range(6):
        greatest = np.abs(ours[:, freedom]).max()
        assert greatest > 0
        assert np.abs(kept[:, 1 + freedom] - ours[:, freedom]).max() < 5e-3 * greatest, freedom
