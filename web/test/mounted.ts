import type { Exhibit, Mounts } from '../src/exhibit'
import { exhibit } from './stage/engine'

const AXES: Mounts['mounts'][0]['axes'] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
]
const NONE: [number, number][] = [
  [0, 0],
  [0, 0],
]

const SPEED = (800 * Math.PI) / 30
const [MASS, STIFF] = [10, 1e5]

/** A block on two mounts: it rolls in its first mode; in all orders it goes up, and rolls. */
export const mounts: Mounts = {
  centres: [[0.1, 0, 0]],
  points: [
    { name: 'head', place: [0.3, 0, 0], below: false, displacement: [], velocity: [] },
    { name: 'grip', place: [0.3, 0.5, 2], below: false, displacement: [], velocity: [] },
  ],
  mounts: [
    { name: 'left', place: [0, -0.4, 0], axes: AXES, below: false, load: [-700, 0, 0] },
    { name: 'right', place: [0, 0.4, 0], axes: AXES, below: false, load: [-500, 0, 0] },
  ],
  modes: [
    {
      number: 1,
      frequency_hz: 9,
      damping: 0.05,
      energy: [0, 0, 0, 0, 0, 1],
      shape: [0, 0, 0, 0, 0, 0.5],
      forces: [
        [20, 0, 0],
        [-20, 0, 0],
      ],
    },
    {
      number: 2,
      frequency_hz: 12,
      damping: 0.05,
      energy: [1, 0, 0, 0, 0, 0],
      shape: [0.1, 0, 0, 0, 0, 0],
      forces: [
        [10, 0, 0],
        [10, 0, 0],
      ],
    },
  ],
  torque_roll: { point: [0.1, 0, 0], direction: [0, 0, 1] },
  elastic: { point: [0, 0, 0], direction: [0, 0, 1] },
  over: null,
  orders: [1, 2.5],
  driving: {
    mass: [0, 1, 2, 3, 4, 5].map((row) =>
      [0, 1, 2, 3, 4, 5].map((column) => (row === column ? (row ? 1 : MASS) : 0)),
    ),
    springs: [-0.4, 0.4].map((right) => ({
      arms: [
        [1, 0, 0, 0, 0, -right],
        [0, 1, 0, right, 0, 0],
        [0, 0, 1, 0, right, 0],
      ],
      stiffness: [STIFF, STIFF, STIFF],
      damping: [0, 0, 0],
      loss: 0,
      stiffening: [],
      foot: [],
    })),
    inertia: [
      // 0.02 mm up: the stiffness less the mass times the frequency squared
      [
        [(2e-5 * (2 * STIFF - MASS * SPEED ** 2)) / SPEED ** 2, 0],
        [0, 0],
      ],
      NONE,
      NONE,
      NONE,
      NONE,
      NONE,
    ],
    gas_speeds: [SPEED],
    // 0.1 mrad of roll
    gas: [
      [
        [0, 0],
        [0, 1e-4 * (2 * STIFF * 0.4 ** 2 - (2.5 * SPEED) ** 2)],
      ],
    ],
  },
  vibrations: [{ point: 'idle', gas: null, speed_rpm: 800, peak: false }],
}

/** A single with the crank radius 1, on these mounts. */
export function standing(): Exhibit {
  const plain = exhibit()
  return { ...plain, whirl: { ...plain.whirl, centre: [0.1, 0, 0] }, mounts, turns: 2 }
}
