import { describe, expect, test } from 'vitest'
import type { Exhibit, Mounts } from '../src/exhibit'
import {
  answerOf,
  groundWaves,
  mountChoiceOf,
  pointOf,
  pointWaves,
  shakeOf,
  UNIT,
  vibrationOf,
} from '../src/mounts'
import { phaseOf, signalAt, turn } from '../src/phasor'
import { stateOf } from '../src/state'
import { mounts, standing } from './mounted'
import { exhibit } from './stage/engine'

const SPEED = (800 * Math.PI) / 30
const near = (value: number, within: number) => ({
  asymmetricMatch: (other: unknown) => Math.abs(Number(other) - value) <= within,
})

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
      rpm: null,
      point: 0,
      times: 50,
    })
    expect(choice('mounts.rpm=812.5&mounts.point=1')).toMatchObject({ rpm: 812.5, point: 1 })
    const nonsense = 'mounts.show=fast&mounts.mode=-1&mounts.at=<b>&mounts.times=1e9'
    expect(choice(`${nonsense}&mounts.rpm=-3&mounts.point=x`)).toEqual(choice(''))
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

test('a block that rises and rolls clockwise goes farthest on its left', () => {
  const engine = standing()
  const [mode] = (engine.mounts as Mounts).modes
  const shaken = {
    ...engine,
    scene: { ...engine.scene, low: [0, -0.2, 0], high: [0.3, 0.6, 1] },
    mounts: { ...engine.mounts, modes: [{ ...mode, shape: [1, 0, 0, 0, 0, 1] }] },
  } as Exhibit
  const rising = shakeOf(shaken, choice('mounts.show=mode'))
  // up by 1 + 0.2 there, sideways by the height over the centre of mass
  expect((rising?.motion[0]?.[0] ?? 0) * Math.hypot(1.2, 0.2)).toBeCloseTo(UNIT, 12)
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

/** The vibration of the fixture. */
function answer() {
  const own = answerOf(mounts, mounts.vibrations[0] as Mounts['vibrations'][0])
  if (!own) throw new Error('no speed')
  return own
}

test("a speed of one's own is kept within the range that is known", () => {
  const own = { ...mounts, over: { speeds_rpm: [700, 900], force: [], transmissibility: [] } }
  const at = (rpm: number | null) => vibrationOf(own, { rpm, vibration: 7 })?.speed_rpm
  expect([at(null), at(650), at(812.5), at(2000)]).toEqual([800, 700, 812.5, 900])
  expect(vibrationOf(mounts, { rpm: 650, vibration: 0 })?.speed_rpm).toBe(800)
})

test('the block answers to what drives it as a mass on its springs', () => {
  const { motion, through, heat } = answer()
  expect(Array.from(motion[0] ?? [])).toEqual([2e-5, 0, 0, 0].map((each) => near(each, 1e-17)))
  expect(Array.from(motion[5] ?? [])).toEqual([0, 0, 0, 1e-4].map((each) => near(each, 1e-16)))
  const still = Math.hypot(
    2e-5 * (2e5 - 10 * SPEED ** 2),
    (0.4 / 0.16) * 1e-4 * (3.2e4 - (2.5 * SPEED) ** 2),
  )
  expect(through[0]).toBeCloseTo(Math.hypot(4, 8) / still, 12)
  expect(heat).toEqual([0, 0])
})

test('a point of the block goes as the freedoms say', () => {
  const [up, right, along] = pointWaves(mounts, answer().motion, pointOf(mounts, { point: 1 }))
  expect(Array.from(up ?? [])).toEqual([2e-5, 0, 0, -0.5e-4].map((each) => near(each, 1e-16)))
  expect(Array.from(right ?? [])).toEqual([0, 0, 0, 0.2e-4].map((each) => near(each, 1e-16)))
  expect(Array.from(along ?? []).map((each) => each + 0)).toEqual([0, 0, 0, 0])
})

test('the force on the ground is that of the mounts that stand on it', () => {
  const { forces } = answer()
  const ground = (own: Mounts) => Array.from(groundWaves(own, forces)[0] ?? [])
  expect(ground(mounts)).toEqual([4, 0, 0, 0].map((each) => near(each, 1e-11)))
  const [left, right] = mounts.mounts as [Mounts['mounts'][0], Mounts['mounts'][0]]
  const based = { ...mounts, mounts: [left, { ...right, below: true }] }
  expect(ground(based)).toEqual([2, 0, 0, -4].map((each) => near(each, 1e-11)))
})
