/// <reference types="node" />
import { readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import type { Exhibit } from '../src/exhibit'
import { chainOf, moved, placesOf } from '../src/motion'
import {
  coefficientsOf,
  type Plane,
  phaseOf,
  signalAt,
  signalOf,
  turn,
  vectorAt,
} from '../src/phasor'
import { clearestAzimuth } from '../src/stage/clearest'
import { Loads } from '../src/stage/load'
import type { View } from '../src/stage/stage'

/**
 * What Python says of an engine at an angle; written by tests/methods/test_motion_ts.py, which runs
 * this file.
 */
interface Said {
  theta: number
  /** [up, right] of every cylinder. */
  big_end: [number, number][]
  piston: [number, number][]
  chosen: number[] | null
  force: [number, number]
  couple: [number, number]
  roll: number
  parts: [number, number][]
}

const file = process.env.CRANKSTAR_ROADS
interface Road {
  exhibit: Exhibit
  stroke: number
  said: Said[]
  /** Of pictures without a browser: the isometric view, and what the longest arrows stand for. */
  azimuth: number
  longest: { force: number; couple: number }
}

const roads: Road[] = file ? JSON.parse(readFileSync(file, 'utf8')) : []

describe.skipIf(!file).each(roads)(
  'the browser and Python agree: $exhibit.name',
  ({ exhibit, stroke, said, azimuth, longest }) => {
    test('pictures are seen from the same side, with arrows of the same scale', () => {
      expect(clearestAzimuth(exhibit.scene)).toBeCloseTo(azimuth, 12)
      const arrows = { force: true, couple: true, roll: false, cylinders: false }
      const view = { theta: 0, arrows: { ...arrows, orders: null, scale: 1 } } as unknown as View
      const load = new Loads(exhibit).at(view)
      for (const kind of ['force', 'couple'] as const)
        expect(load[kind] * exhibit.units[`${kind}_factor`]).toBeCloseTo(longest[kind], 9)
    })

    test.each(said)('at $theta', (one) => {
      const chain = chainOf(exhibit.scene, exhibit.sense)
      const places = moved(chain, one.theta, placesOf(chain))
      for (let index = 0; index < chain.count; index++) {
        for (const part of [0, 1] as const) {
          expect(
            Math.abs((places.piston[2 * index + part] as number) - at(one.piston, index, part)),
          ).toBeLessThan(1e-12 * stroke)
          expect(
            Math.abs((places.bigEnd[2 * index + part] as number) - at(one.big_end, index, part)),
          ).toBeLessThan(1e-12 * stroke)
        }
      }
    })

    test.each(said)('forces at $theta of orders $chosen', (one) => {
      const phase = turn(
        phaseOf(exhibit.orders.length, exhibit.sense),
        exhibit.orders,
        one.theta,
        one.chosen,
      )
      const { total, cylinders } = exhibit
      const pairs = [
        [total.force, one.force],
        [total.couple, one.couple],
        ...cylinders.map((part, index) => [part.force, one.parts[index]]),
      ] as [Exhibit['total']['force'], Plane][]
      for (const [vectors, expected] of pairs) {
        const place = vectorAt(coefficientsOf(vectors), phase, [0, 0])
        const size = 1e-12 * sizeOf([...vectors.forward, ...vectors.backward])
        expect(Math.hypot(place[0] - expected[0], place[1] - expected[1])).toBeLessThanOrEqual(size)
      }
      const roll = signalAt(signalOf(total.roll), phase)
      expect(Math.abs(roll - one.roll)).toBeLessThanOrEqual(1e-12 * sizeOf(total.roll))
    })
  },
)

test.skipIf(file)('(compared with Python by tests/methods/test_motion_ts.py)', () => {})

function at(pairs: readonly [number, number][], index: number, part: 0 | 1): number {
  return (pairs[index] as [number, number])[part]
}

function sizeOf(pairs: readonly (readonly [number, number])[]): number {
  return pairs.reduce((sum, [a, b]) => sum + Math.hypot(a, b), 0)
}
