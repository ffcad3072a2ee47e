import { describe, expect, test } from 'vitest'
import type { Mounts } from '../src/exhibit'
import { groundWaves, mountChoiceOf, pointWaves, shakeOf, UNIT } from '../src/mounts'
import { phaseOf, signalAt, signalOf, turn } from '../src/phasor'
import { stateOf } from '../src/state'
import { mounts, standing } from './mounted'
import { exhibit } from './stage/engine'

const choice = (text: string) => mountChoiceOf(stateOf(text).choices)

describe('what is chosen', () => {
  test('opens with a block that stands, and so does an engine without mounts', () => {
    expect(shakeOf(standing(), choice(''))).toBeNull()
    expect(shakeOf(exhibit(), choice('mounts.show=mode'))).toBeNull()
  })

  test('stands in links, and nonsense in them is as it opens', () => {
    expect(choice('mounts.show=forced&mounts.mode=2&mounts.at=3&mounts.times=50')).toEqual({
      show: 'forced',
      mode: 2,
      vibration: 3,
      times: 50,
    })
    expect(choice('mounts.show=fast&mounts.mode=-1&mounts.at=<b>&mounts.times=1e9')).toEqual(
      choice(''),
    )
  })
})

test('in a mode the corner that goes farthest goes a millimetre, once a turn', () => {
  const shake = shakeOf(standing(), choice('mounts.show=mode&mounts.mode=2'))
  expect(shake?.orders).toEqual([1])
  expect(shake?.motion[0]).toEqual(Float64Array.of(UNIT, 0))
  // 10 N for 0.1 m: 0.1 N for a millimetre
  expect(shake?.most).toBeCloseTo(0.1, 12)
  expect(shake?.free).toBe(true)
  const rolling = shakeOf(standing(), choice('mounts.show=mode'))
  const { low, high } = standing().scene
  const reach = Math.max(
    ...[low, high].flatMap(([up]) => [low, high].map(([, right]) => Math.hypot(up - 0.1, right))),
  )
  expect((rolling?.motion[5]?.[0] ?? 0) * reach).toBeCloseTo(UNIT, 12)
})

test('as it is driven it has all orders, and the greatest force of a mount over the cycle', () => {
  const shake = shakeOf(standing(), choice('mounts.show=forced&mounts.times=40'))
  expect(shake?.orders).toEqual([1, 2.5])
  expect([shake?.times, shake?.free]).toEqual([40, false])
  const { orders = [], forces = [] } = shake ?? {}
  const phase = phaseOf(2, 1)
  let most = 0
  for (let step = 0; step < 7200; step++) {
    turn(phase, orders, (step * 4 * Math.PI) / 7200, null)
    for (const [up] of forces) most = Math.max(most, Math.abs(signalAt(up as Float64Array, phase)))
  }
  expect(shake?.most).toBeGreaterThan(0.999 * most)
  expect(shake?.most).toBeLessThanOrEqual(most + 1e-12)
})

test('a point of the block goes as the freedoms say', () => {
  const [vibration] = mounts.vibrations
  const motion = (vibration?.motion ?? []).map(signalOf)
  const [up, right, along] = pointWaves(mounts, motion, [0.3, 0.5, 2])
  expect(up).toEqual(Float64Array.of(2e-5, 0, 0, -0.5e-4))
  expect(Array.from(right ?? [])).toEqual([0, 0, 0, expect.closeTo(0.2e-4, 15)])
  expect(Array.from(along ?? []).map((each) => each + 0)).toEqual([0, 0, 0, 0])
})

test('the force on the ground is that of the mounts that stand on it', () => {
  const [vibration] = mounts.vibrations
  const forces = (vibration?.forces ?? []).map((force) => force.map(signalOf))
  expect(groundWaves(mounts, forces)[0]).toEqual(Float64Array.of(4, 0, 0, 0))
  const [left, right] = mounts.mounts as [Mounts['mounts'][0], Mounts['mounts'][0]]
  const based = { ...mounts, mounts: [left, { ...right, below: true }] }
  expect(groundWaves(based, forces)[0]).toEqual(Float64Array.of(1, 0, 0, -4))
})
