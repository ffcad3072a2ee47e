import { describe, expect, test } from 'vitest'
import type { Exhibit } from '../../src/exhibit'
import { mountChoiceOf, shakeOf } from '../../src/mounts'
import { BOX, BOXES, Mounting, Shaking } from '../../src/stage/mounts'
import { REST_AT, Whirling } from '../../src/stage/whirl'
import { stateOf } from '../../src/state'
import { mounts, standing } from '../mounted'

const shaking = (exhibit: Exhibit, text: string): Shaking => {
  const shake = shakeOf(exhibit, mountChoiceOf(stateOf(text).choices))
  if (!shake) throw new Error('nothing shakes')
  return new Shaking(exhibit, shake)
}
/** Of a mount: the lower end of its rubber and what leads from it to the upper one, x, y, z. */
const rubber = (boxes: Float64Array, index: number) => {
  const first = index * BOXES * BOX
  return {
    lower: Array.from(boxes.subarray(first, first + 3)),
    along: Array.from(boxes.subarray(first + 6, first + 9)),
  }
}
type Nine = [number, number, number, number, number, number, number, number, number]
const sums = (a: readonly number[], b: readonly number[]) =>
  a.map((each, at) => each + (b[at] ?? 0))

describe('a mount', () => {
  const exhibit = standing()
  const still = () => new Mounting(exhibit, mounts).at(REST_AT, 0, null)

  test('stands about its place, its rubber between the block above and what is below', () => {
    const { lower, along } = rubber(still().boxes.slice(), 0)
    expect(along[1]).toBeGreaterThan(0)
    const middle = sums(
      lower,
      along.map((each) => each / 2),
    )
    expect(middle).toEqual([-0.4, expect.closeTo(0, 12), 0])
  })

  test('that is pulled hangs from what is above it', () => {
    const [left, right] = mounts.mounts
    if (!left || !right) throw new Error('no mounts')
    const pulled = {
      ...mounts,
      mounts: [{ ...left, load: [700, 0, 0] as typeof left.load }, right],
    }
    const { along } = rubber(new Mounting(exhibit, pulled).at(REST_AT, 0, null).boxes, 0)
    expect(along[1]).toBeLessThan(0)
  })

  test('has boxes that are right-handed, as the graphics card wants them', () => {
    const { boxes } = still()
    for (let first = 0; first < boxes.length; first += BOX) {
      const [ax, ay, az, bx, by, bz, cx, cy, cz] = boxes.subarray(
        first + 3,
        first + BOX,
      ) as unknown as Nine
      const volume = (ay * bz - az * by) * cx + (az * bx - ax * bz) * cy + (ax * by - ay * bx) * cz
      expect(volume).toBeGreaterThan(0)
    }
  })

  test('follows the block with its upper end and stays where it is below', () => {
    const rest = rubber(still().boxes.slice(), 1)
    const road = shaking(exhibit, 'mounts.show=mode&mounts.mode=2')
    const moved = road.at(0, null)
    const now = rubber(new Mounting(exhibit, mounts).at(moved, 50, road).boxes, 1)
    expect(now.lower).toEqual(rest.lower)
    const went = sums(
      sums(now.lower, now.along),
      sums(rest.lower, rest.along).map((each) => -each),
    )
    expect(went).toEqual([expect.closeTo(0, 12), expect.closeTo(0.05, 12), expect.closeTo(0, 12)])
  })

  test('moves like any point of the block, free or not', () => {
    const rest = rubber(still().boxes.slice(), 0)
    const upper = sums(rest.lower, rest.along)
    const free = new Whirling(exhibit)
    const tilted = { ...REST_AT, turn: 1e-6, up: 2e-6 }
    const now = rubber(new Mounting(exhibit, mounts).at(tilted, 1, null).boxes, 0)
    const [up, right] = free.axis(tilted, 0, [0, 0])
    const [x = 0, y = 0] = sums(
      sums(now.lower, now.along),
      upper.map((each) => -each),
    )
    // the upper end is so far from the crank axis that a clockwise turn lifts it, being at the left
    const [sideX = 0, highY = 0] = upper
    const { scene } = exhibit
    const [axisUp, axisRight] = [scene.shafts[0]?.up ?? 0, scene.shafts[0]?.right ?? 0]
    expect(y).toBeCloseTo(up - tilted.turn * (sideX - axisRight), 11)
    expect(x).toBeCloseTo(right + tilted.turn * (highY - axisUp), 11)
  })
})

describe('the block as it is driven', () => {
  const exhibit = standing()

  test('goes by the orders that are chosen, and a mode by its own', () => {
    const road = shaking(exhibit, 'mounts.show=forced')
    expect(road.at(0, null).up).toBeCloseTo(2e-5, 15)
    expect(road.at(0, [2.5]).up).toBe(0)
    expect(road.at(0.2, [2.5]).turn).toBeCloseTo(-1e-4 * Math.sin(0.5), 15)
    const mode = shaking(exhibit, 'mounts.show=mode&mounts.mode=2')
    expect(mode.at(0, [2.5]).up).toBeCloseTo(1e-3, 15)
  })

  test('turns the same way whichever way the crankshaft does', () => {
    const other = shaking({ ...exhibit, sense: -1 }, 'mounts.show=forced')
    expect(other.at(0.3, null)).toEqual(shaking(exhibit, 'mounts.show=forced').at(0.3, null))
  })

  test('presses on what is below by shares of the greatest force', () => {
    const road = shaking(exhibit, 'mounts.show=forced')
    const out = new Float64Array(6)
    road.at(0.2, null)
    road.forces(out)
    const [straight, rolling] = [2 * Math.cos(0.2), 4 * Math.sin(0.5)]
    expect(out[1]).toBeCloseTo((straight - rolling) / road.shake.most, 12)
    expect(out[4]).toBeCloseTo((straight + rolling) / road.shake.most, 12)
    expect([out[0], out[2]]).toEqual([0, 0])
  })

  test('carries a foundation with it, which its mounts hold above the ground', () => {
    const [left, right] = mounts.mounts
    const [mode] = mounts.modes
    if (!left || !right || !mode) throw new Error('no mounts')
    const based = {
      ...mounts,
      centres: [
        [0.1, 0, 0],
        [-1, 0, 0],
      ] as [number, number, number][],
      mounts: [left, { ...right, below: true }],
      modes: [{ ...mode, shape: [0.2, 0, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 0] }],
    }
    const own = { ...exhibit, mounts: based }
    const road = shaking(own, 'mounts.show=mode')
    const rest = new Mounting(own, based).at(REST_AT, 0, null).boxes.slice()
    const { boxes } = new Mounting(own, based).at(road.at(0, null), 1, road)
    const went = (index: number) => {
      const [from, to] = [rubber(rest, index), rubber(boxes, index)]
      return [
        (to.lower[1] ?? 0) - (from.lower[1] ?? 0),
        (to.lower[1] ?? 0) + (to.along[1] ?? 0) - (from.lower[1] ?? 0) - (from.along[1] ?? 0),
      ]
    }
    expect(went(0)).toEqual([expect.closeTo(0.5e-3, 12), expect.closeTo(1e-3, 12)])
    expect(went(1)).toEqual([expect.closeTo(0, 12), expect.closeTo(0.5e-3, 12)])
  })
})
