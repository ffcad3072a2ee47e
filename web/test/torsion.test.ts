import { describe, expect, test } from 'vitest'
import type { Exhibit, Torsion } from '../src/exhibit'
import { roundFactor } from '../src/magnification'
import { phaseOf, signalAt, turn } from '../src/phasor'
import { stateOf, stateText } from '../src/state'
import { orderOf, ordersOfMode, topText, twistChoiceOf, twistOf, UNIT } from '../src/torsion'
import { exhibit } from './stage/engine'

/** Two throws and a flywheel: a shaft between them, one without a diameter behind, none ahead. */
const torsion: Torsion = {
  masses: ['throw 1', 'throw 2', 'flywheel'],
  throws: [1, 0],
  masses_of_throws: [0, 1],
  pieces: [null, { name: 'throw 1 - throw 2', modulus: 2 }, { name: 'rear', modulus: null }],
  estimated: false,
  modes: [
    { number: 1, frequency_hz: 50, shape: [1, -2, 0.5], torque: [0, 8, 6] },
    { number: 2, frequency_hz: 90, shape: [1, 0, -4], torque: [0, -4, 12] },
  ],
  criticals: [
    { mode: 1, order: 3, speed_rpm: 1000, strength: 1 },
    { mode: 1, order: 2.5, speed_rpm: 1200, strength: 9 },
    { mode: 1, order: 4, speed_rpm: 750, strength: 2 },
  ],
  orders: [1, 2.5],
  vibrations: [
    {
      ...{ point: '', gas: true, speed_rpm: 1200, critical: null, peak: [0, 10, 7] },
      turns: [
        [
          [0.01, 0.002],
          [0, -0.03],
        ],
        [
          [0.02, 0],
          [0.001, 0],
        ],
      ],
      torque: [
        [],
        [
          [6, 2],
          [0, 3],
        ],
        [
          [1, 0],
          [2, 0],
        ],
      ],
    },
  ],
}
const engine = exhibit({ torsion }) as Exhibit
const choice = (text: string) => twistChoiceOf(stateOf(text).choices)

describe('what is chosen', () => {
  test('a crank stands as it is until something is chosen', () => {
    expect(choice('').show).toBe('still')
    expect(twistOf(engine, choice(''))).toBeNull()
    expect(twistOf(exhibit(), choice('twist.show=mode'))).toBeNull()
  })

  test('half orders go into a link and come back', () => {
    const text = 'twist.mode=2&twist.order=2.5&twist.show=mode&twist.times=30'
    expect(choice(text)).toEqual({
      ...{ show: 'mode', mode: 2, order: 2.5, vibration: 0, times: 30 },
    })
    expect(stateText(stateOf(text))).toBe(text)
  })

  test('nonsense is as a page opens', () => {
    expect(choice('twist.show=fast&twist.mode=-1&twist.order=<b>&twist.times=1e9')).toEqual(
      choice(''),
    )
  })
})

test('orders of a mode are those that meet it, and the strongest is shown first', () => {
  expect(ordersOfMode(torsion, 1)).toEqual([2.5, 3, 4])
  expect(orderOf(torsion, 1, null)).toBe(2.5)
  expect(orderOf(torsion, 1, 4)).toBe(4)
  expect(orderOf(torsion, 1, 7)).toBe(2.5)
  expect(orderOf(torsion, 2, null)).toBe(1)
})

test('in a mode the mass that turns most turns by a degree, others by their shape', () => {
  const twist = twistOf(engine, choice('twist.show=mode'))
  expect(twist?.orders).toEqual([2.5])
  expect(twist?.turns.map(([size]) => size)).toEqual([UNIT / 2, -UNIT])
  // the torque for that over the modulus; what has no diameter has no stress
  expect(twist?.loads.map((load) => load?.[0] ?? null)).toEqual([null, (UNIT * 4) / 2, null])
  expect(twist?.top).toBeCloseTo(2 * UNIT, 15)
  expect([twist?.of, twist?.free, twist?.times]).toEqual(['stress', true, 10])
})

test('driven, each throw turns by the sum of all orders', () => {
  const twist = twistOf(engine, choice('twist.show=forced&twist.times=40'))
  const phase = turn(phaseOf(2, 1), torsion.orders, 0.7, null)
  const [first] = twist?.turns ?? []
  const expected = 0.01 * Math.cos(0.7) - 0.002 * Math.sin(0.7) + 0.03 * Math.sin(2.5 * 0.7)
  expect(signalAt(first as Float64Array, phase)).toBeCloseTo(expected, 15)
  expect(twist?.times).toBe(40)
  expect(twist?.top).toBe(5)
})

test('without any diameter the colours are those of the torque', () => {
  const pieces = torsion.pieces.map((piece) => piece && { ...piece, modulus: null })
  const bare = exhibit({ torsion: { ...torsion, pieces } })
  const twist = twistOf(bare, choice('twist.show=forced'))
  expect([twist?.of, twist?.top]).toEqual(['torque', 10])
  expect(twist?.loads.map((load) => load?.[0] ?? null)).toEqual([null, 6, 1])
})

test('the last colour is told in the unit of the numbers', () => {
  const numbers = {
    stress_unit: { label: 'MPa', factor: 1e-6 },
    torque_unit: { label: 'N m', factor: 1 },
  } as unknown as NonNullable<Exhibit['torsion_numbers']>
  const twist = twistOf(engine, choice('twist.show=forced'))
  if (!twist) throw new Error('nothing twists')
  const told = exhibit({ torsion, torsion_numbers: numbers })
  expect(topText(told, { ...twist, top: 31_491_234 })).toBe('31.49 MPa')
  expect(topText(told, { ...twist, of: 'torque', top: 1234.5678 })).toBe('1235 N m')
})

test.each([
  [1.4, 1],
  [1.6, 2],
  [34, 20],
  [36, 50],
  [80, 100],
  [0.0024, 0.002],
])('a magnification near %d is %d', (value, round) => {
  expect(roundFactor(value)).toBe(round)
})
