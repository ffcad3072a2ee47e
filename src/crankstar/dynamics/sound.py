"""The exhaust of an engine as a sound: equal pulses at its firings through plain pipes.

Each chamber gives its pipe one pulse a cycle, centred on its firing angle: a raised cosine, WIDTH
degrees of crank angle wide at its foot, the same at every speed,

    p(a) = (1 + cos(2 pi a/WIDTH))/2   for |a| < WIDTH/2

The mean is left out. A pipe of length L delays what goes into it by t = L/c and sends a part r
back from its open end, upside down; it returns from the valve at the next 2t:

    y(s) = x(s - t) - r y(s - 2t)

with c = SPEED_OF_SOUND and r = REFLECTED. 2t is rounded to a sample, and t is not. Pipes of a group
meet in the air; the sound of a group is their sum. One group is one channel; several stand side by
side, the first at the left, the last at the right, those between heard from both sides. So two are
a channel each, and groups that would cancel each other in one channel are heard.

At a constant speed the lines of a group with equal pipes stand at the orders of `exhaust_orders`,
with |S_q| |P_q| |H|: P_q of the pulse (`pulse_order`), H of the pipe, 1/|1 + r exp(-2 i w t)|.

What is left out: the pressure and the temperature in the pipe, steep waves, what a pulse does to
the next one and one cylinder to another, muffler and catalyst, the intake, radiation into the
room, and everything that rattles and hums in an engine. The pulses are equal at every speed and
load. So this is no recording: what can be heard is the rhythm of the firings.

Source: the sums as in `firing.exhaust_orders`; plane waves in a pipe with an open end from any book
on acoustics, such as M. L. Munjal, Acoustics of Ducts and Mufflers.
"""

from __future__ import annotations

import io
import wave
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from math import ceil, log, pi

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.firing.intervals import firing
from crankstar.firing.strokes import exhaust_groups
from crankstar.language.faults import EngineError, Fault
from crankstar.language.messages import N_, MessageError
from crankstar.spectra import Real

RATE = 44_100
"""Samples in a second."""
WIDTH = 60.0
"""Of a pulse at its foot, degrees of crank angle."""
SPEED_OF_SOUND = 520.0
"""In exhaust gas of about 400 deg C, m/s."""
REFLECTED = 0.5
"""The part of a wave that the open end of a pipe sends back."""
PIPE = 1.0
"""The usual length of a pipe, m."""
FADE = 0.02
"""Seconds in which a sound comes and goes."""
LOUDEST = 0.9
"""The greatest sample, of 1."""
FAINT = 1e-5
"""Share of a wave below which its echoes are left out before the sound begins."""
NO_PIPE = N_("there is no exhaust of a cylinder {number}; those that have one are {numbers}")
STEPS = 1 << 16
"""Steps of the crank angle over a cycle at which the pulses are tabulated."""


@dataclass(frozen=True)
class Ride:
    """Speeds [rad/s] from the first to the last at a constant rate, in so many seconds; the pipes.

    `pipe` is the length of all pipes [m] but those in `pipes`, by the number of the chamber.
    """

    first: float
    last: float
    seconds: float = 8.0
    pipe: float = PIPE
    pipes: Mapping[int, float] = field(default_factory=dict)

    def turns(self, time: Real) -> Real:
        """The angle of the crankshaft at these times, turns; before the beginning, at `first`."""
        gained = (self.last - self.first) / (2 * self.seconds) * np.maximum(time, 0.0) ** 2
        return (self.first * time + gained) / (2 * pi)


@dataclass(frozen=True)
class Sound:
    """Samples [channel, sample] from -1 to 1, RATE in a second; the group that each is of.

    Of more than two groups the channels are named after the first and the last.
    """

    channels: tuple[str, ...]
    samples: Real


def pulse_order(order: float) -> float:
    """The amplitude of one pulse at an order of a long time, of that at order 0.

    >>> round(pulse_order(6.0), 12), round(pulse_order(4.0), 4)  # half a height at 360/WIDTH
    (0.5, 0.7443)
    """
    share = order * WIDTH / 360
    if abs(share - 1) < 1e-9:
        return 0.5
    return float(np.sinc(share) / (1 - share**2))


def sound(
    engine: Engine, *, ride: Ride, tell: Callable[[int, int], None] = lambda _done, _of: None
) -> Sound:
    """The exhaust of an engine over a ride; the same samples every time.

    `tell` is given how many pipes are done, and of how many. Raises EngineError without a firing
    order, and MessageError where a pipe is that of no cylinder.

    >>> from crankstar.files.catalog import load
    >>> heard = sound(load("v8-cross-plane"), ride=Ride(300.0, 300.0, seconds=0.1))
    >>> heard.channels, heard.samples.shape
    (('bank odd', 'bank even'), (2, 4410))
    """
    if not engine.firing_order:
        raise EngineError([Fault(("firing_order",), "strokes.no-firing-order")])
    groups = exhaust_groups(engine)
    for number in sorted({*ride.pipes} - {*engine.firing_order}):
        raise MessageError(
            NO_PIPE, number=number, numbers=", ".join(map(str, sorted(engine.firing_order)))
        )
    parts = [
        (index, length, [number for number in group.chambers if _pipe(ride, number) == length])
        for index, group in enumerate(groups)
        for length in sorted({_pipe(ride, number) for number in group.chambers})
    ]
    count = round(ride.seconds * RATE)
    heard = np.zeros((len(groups), count))
    for done, (place, length, chambers) in enumerate(parts):
        tell(done, len(parts))
        heard[place] += _piped(_table(engine, chambers), engine, ride, length, count)
    samples = channel_shares(len(groups)) @ heard
    names = tuple(group.name for group in (groups if len(groups) < 3 else (groups[0], groups[-1])))
    edge = max(1, min(round(FADE * RATE), count // 2))
    rise = (1 - np.cos(pi * np.arange(edge) / edge)) / 2
    samples[:, :edge] *= rise
    samples[:, count - edge :] *= rise[::-1]
    return Sound(names, samples * (LOUDEST / max(float(np.abs(samples).max()), FAINT)))


def channel_shares(groups: int) -> Real:
    """The share of each group in each channel, [channel, group].

    >>> channel_shares(3).tolist()
    [[1.0, 0.5, 0.0], [0.0, 0.5, 1.0]]
    """
    if groups < 2:
        return np.ones((1, groups))
    right = np.arange(groups) / (groups - 1)
    return np.array([1 - right, right])


def _pipe(ride: Ride, number: int) -> float:
    return ride.pipes.get(number, ride.pipe)


def echo(length: float) -> int:
    """Samples after which a wave comes back from the open end of a pipe of that length, m.

    >>> echo(1.0)
    170
    """
    return max(1, round(2 * length / SPEED_OF_SOUND * RATE))


def _table(engine: Engine, chambers: Sequence[int]) -> Real:
    """The pulses of chambers, less their mean, at STEPS equal steps of a cycle and its end."""
    fired = firing(engine)
    angles = np.linspace(0.0, fired.cycle_deg, STEPS + 1)
    places = dict(zip(fired.order, fired.angles_deg, strict=True))
    out = np.full(angles.size, -len(chambers) * WIDTH / 2 / fired.cycle_deg)
    for number in chambers:
        half = fired.cycle_deg / 2
        apart = (angles - places[number] + half) % fired.cycle_deg - half
        out += np.where(np.abs(apart) < WIDTH / 2, (1 + np.cos(2 * pi * apart / WIDTH)) / 2, 0.0)
    return out


def _piped(table: Real, engine: Engine, ride: Ride, length: float, count: int) -> Real:
    """What comes out of the pipes of one length, with the echoes of what was before."""
    delay = length / SPEED_OF_SOUND
    back = echo(length)
    before = back * ceil(log(FAINT) / log(REFLECTED))
    time = np.arange(-before, count) / RATE - delay
    steps = ride.turns(time) * (STEPS * 360 / engine.cycle_angle) % STEPS
    heard = np.interp(steps, np.arange(STEPS + 1), table)
    rows = np.append(heard, np.zeros(-heard.size % back)).reshape(-1, back)
    for row in range(1, len(rows)):
        rows[row] -= REFLECTED * rows[row - 1]
    return rows.ravel()[before : before + count]


def wav(heard: Sound) -> bytes:
    """A sound as a WAV file of 16 bits, one channel or two.

    >>> wav(Sound(("x",), np.zeros((1, 10))))[:4]
    b'RIFF'
    """
    content = io.BytesIO()
    with wave.open(content, "wb") as file:
        file.setnchannels(len(heard.samples))
        file.setsampwidth(2)
        file.setframerate(RATE)
        file.writeframes(np.round(heard.samples.T * 32767).astype("<i2").tobytes())
    return content.getvalue()
