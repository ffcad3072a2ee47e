import { describe, expect, test } from 'vitest'
import type { Exhibit, Vectors } from '../../src/exhibit'
import { type Displacement, displaced, REST_AT, rotation, Whirling } from '../../src/stage/whirl'
import { exhibit } from './engine'

const vectors = (forward: [number, number], backward: [number, number] = [0, 0]): Vectors => ({
  forward: [forward],
  backward: [backward],
})
const whirling = (changes: Partial<Exhibit['whirl']>): Exhibit => {
  const plain = exhibit()
  return { ...plain, whirl: { ...plain.whirl, ...changes } }
}
const moved: Displacement = {
  ...{ up: 2e-6, right: -1e-6, along: 0 },
  ...{ tiltUp: 3e-6, tiltRight: 5e-6, turn: -4e-6 },
}

describe('the motion of the block', () => {
  test('of the axis is what is drawn, as far as small angles go', () => {
    const shown = whirling({})
    const road = new Whirling(shown)
    for (const z of [-1, 0.5, 2]) {
      const [up, right] = road.axis(moved, z, [0, 0])
      const [x, y] = displaced(shown.whirl, moved, 1, [0, 0, z], [0, 0, 0])
      expect(x).toBeCloseTo(right, 9)
      expect(y).toBeCloseTo(up, 9)
      expect(Math.abs(x - right)).toBeLessThan(1e-10)
      expect(Math.abs(y - up)).toBeLessThan(1e-10)
    }
  })

  test('is rigid at any magnification', () => {
    const { whirl } = whirling({})
    const [a, b] = [
      displaced(whirl, moved, 3e5, [1, 2, 3], [0, 0, 0]),
      displaced(whirl, moved, 3e5, [-2, 0.5, 1], [0, 0, 0]),
    ]
    expect(Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2])).toBeCloseTo(Math.hypot(3, 1.5, 2), 12)
  })

  test('leaves the centre where the shift puts it', () => {
    const { whirl } = whirling({})
    const [up, right, z] = whirl.centre
    expect(displaced(whirl, moved, 1000, [right, up, z], [0, 0, 0])).toEqual([
      right + 1000 * moved.right,
      up + 1000 * moved.up,
      z,
    ])
  })

  test('tilts the front up by a turn backwards about the axis to the right', () => {
    const [x, y, z] = rotation({ ...REST_AT, tiltUp: 1 }, 2)
    expect([x, y, z].map((part) => part + 0)).toEqual([-2, 0, 0])
  })
})

test('a tilt that turns with the crank makes circles, opposite each other on the two sides of the centre', () => {
  const shown = whirling({ centre: [0, 0, 0.5], tilt: vectors([1e-3, 0]) })
  const road = new Whirling(shown)
  const [front, rear] = [road.path(2, null), road.path(-1, null)]
  for (const [up, right] of [...front, ...rear])
    expect(Math.hypot(up, right)).toBeCloseTo(1.5e-3, 12)
  front.forEach(([up, right], step) => {
    expect(up).toBeCloseTo(-(rear[step]?.[0] ?? 0), 12)
    expect(right).toBeCloseTo(-(rear[step]?.[1] ?? 0), 12)
  })
  // Clockwise seen from the front: up, then right.
  const quarter = front[30] as [number, number]
  expect(quarter[1]).toBeCloseTo(1.5e-3, 12)
  expect(new Whirling({ ...shown, sense: -1 }).path(2, null)[30]?.[1]).toBeCloseTo(-1.5e-3, 12)
})

test('orders that are not chosen do not move it', () => {
  const road = new Whirling(whirling({ shift: vectors([1, 0]) }))
  expect(road.at(0.4, [2]).up).toBe(0)
  expect(road.at(0.4, [1]).up).toBeCloseTo(Math.cos(0.4), 12)
})
