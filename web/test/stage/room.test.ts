import { expect, test } from 'vitest'
import type { Exhibit } from '../../src/exhibit'
import { mountChoiceOf } from '../../src/mounts'
import { reach } from '../../src/stage/extent'
import { Loads } from '../../src/stage/load'
import { Room } from '../../src/stage/room'
import type { View } from '../../src/stage/stage'
import { twistChoiceOf } from '../../src/torsion'
import { exhibit } from './engine'

const view = (arrows: Partial<View['arrows']>): View => ({
  theta: 0,
  camera: 'front',
  arrows: {
    force: true,
    couple: true,
    roll: false,
    axes: false,
    each: 'engine',
    orders: null,
    scale: 1,
    ...arrows,
  },
  whirl: { magnification: 0, orders: null },
  twist: twistChoiceOf({}),
  mounts: mountChoiceOf({}),
  glass: true,
  glow: true,
  section: 0,
  dark: false,
})
/** A force that goes up and down by 2, and a couple to the sides. */
const shaking = (): Exhibit => {
  const plain = exhibit()
  const force = { forward: [[1, 0]], backward: [[1, 0]] } as Exhibit['total']['force']
  const couple = { forward: [[0, 3]], backward: [[0, 3]] } as Exhibit['total']['couple']
  const total = { ...plain.total, force, couple }
  return { ...plain, total, cylinders: [{ number: 1, bank: '1', z: 1, force }] }
}

test('there is room for every arrow over the whole cycle, and for no more', () => {
  const loads = new Loads(shaking())
  const seen = { up: 0, right: 0 }
  const shown = view({})
  for (let step = 0; step < 36; step++) {
    const load = loads.at({ ...shown, theta: (step * Math.PI) / 18 })
    for (const { kind, up, right } of load.pulls) {
      if (kind === 'part') continue
      seen.up = Math.max(seen.up, Math.abs(up))
      seen.right = Math.max(seen.right, Math.abs(right))
    }
  }
  expect(seen.up).toBeCloseTo(1, 12)
  const discs = loads.room(shown, 5)
  expect(reach(discs, [0, 1, 0], [0, 0])).toEqual([
    expect.closeTo(-5 * seen.up, 6),
    expect.closeTo(5 * seen.up, 6),
  ])
  expect(reach(discs, [1, 0, 0], [0, 0])[1]).toBeCloseTo(5 * seen.right, 6)
  expect(loads.room(shown, 5)).toBe(discs)
})

test('what is not shown needs no room', () => {
  const loads = new Loads(shaking())
  const shown = view({ force: false, couple: false })
  loads.at(shown)
  expect(loads.room(shown, 5)).toEqual([])
  const parts = view({ each: 'cylinders' })
  loads.at(parts)
  expect(loads.room(parts, 5)).toHaveLength(8)
})

test('the room of an engine beside is in the unit of the engine looked at, or in crank radii', () => {
  const small = exhibit()
  const size = (room: Room) => reach(room.discs(view({}), 0), [1, 0, 0], [0, 0])[1]
  const own = size(new Room(small))
  expect(size(new Room(small, small))).toBe(own)
  const metres = { ...small, scale: { length: 0.05, force: 1, couple: 1, roll: 1 } }
  const radii = { ...small, scene: { ...small.scene, length_unit: 'crank radii' } }
  expect(size(new Room(radii, metres))).toBeCloseTo(0.05 * own, 12)
  expect(size(new Room(metres, radii))).toBeCloseTo(20 * own, 10)
})
