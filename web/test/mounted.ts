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

/** A block on two mounts: it rolls in its first mode; in all orders it goes up, and rolls. */
export const mounts: Mounts = {
  centres: [[0.1, 0, 0]],
  point: [0.3, 0, 0],
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
  vibrations: [
    {
      point: 'idle',
      gas: true,
      speed_rpm: 800,
      peak: false,
      motion: [
        [
          [2e-5, 0],
          [0, 0],
        ],
        NONE,
        NONE,
        NONE,
        NONE,
        [
          [0, 0],
          [0, 1e-4],
        ],
      ],
      forces: [
        [
          [
            [3, 0],
            [0, 4],
          ],
          NONE,
          NONE,
        ],
        [
          [
            [1, 0],
            [0, -4],
          ],
          NONE,
          NONE,
        ],
      ],
    },
  ],
}

/** A single with the crank radius 1, on these mounts. */
export function standing(): Exhibit {
  const plain = exhibit()
  return { ...plain, whirl: { ...plain.whirl, centre: [0.1, 0, 0] }, mounts, turns: 2 }
}
