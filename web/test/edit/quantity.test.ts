import { expect, test } from 'vitest'
import {
  angle,
  degrees,
  parsed,
  rewritten,
  roundNumber,
  ruled,
  scale,
  textOf,
  turn,
  typed,
  wrapped,
} from '../../src/edit/quantity'

test.each([
  ['82.5 mm', 82.5, 'mm'],
  ['-45deg', -45, 'deg'],
  ['.5 in', 0.5, 'in'],
  ['1e-3 kg*m^2', 0.001, 'kg*m^2'],
  ['7', 7, ''],
  [0.25, 0.25, ''],
])('%s is a number and a unit', (value, number, unit) => {
  expect(parsed(value)).toEqual({ number, unit })
})

test.each(['', 'deg', 'forty deg', '--4 deg', null, undefined, Number.NaN, [1]])(
  '%s is none',
  (value) => {
    expect(parsed(value)).toBeNull()
  },
)

test('a number that a slider gives is written as the one before it', () => {
  expect(rewritten(60, '45 deg', 'deg')).toBe('60 deg')
  expect(rewritten(0.3, 0.2, 'mm')).toBe(0.3)
  expect(rewritten(3.25, '3 in', 'mm')).toBe('3.25 in')
  expect(rewritten(80, undefined, 'mm')).toBe('80 mm')
  expect(rewritten(0.1 + 0.2, '1 mm', 'mm')).toBe('0.3 mm')
})

test('what is typed is a number only if it is one', () => {
  expect(typed(' 2 ')).toBe(2)
  expect(typed('2 mm')).toBe('2 mm')
  expect(typed('')).toBe('')
  expect(typed('0x10')).toBe('0x10')
})

test('values stand in a field as they stand in the file', () => {
  expect(textOf([1, 3, 4, 2])).toBe('1, 3, 4, 2')
  expect(
    textOf([
      [1, 4],
      [2, 3],
    ]),
  ).toBe('1, 4; 2, 3')
  expect(textOf(null)).toBe('')
  expect(textOf('<b>')).toBe('<b>')
})

test('an angle keeps its unit on the way to a dial and back', () => {
  for (const value of ['90 deg', '0.25 turn', '1.5707963267948966 rad', Math.PI / 2]) {
    expect(degrees(value)).toBeCloseTo(90, 9)
    expect(degrees(angle(30, value))).toBeCloseTo(30, 9)
    expect(parsed(angle(30, value))?.unit).toBe(parsed(value)?.unit)
  }
  expect(angle(30, undefined)).toBe('30 deg')
  expect(degrees('up')).toBeNull()
  expect(turn('radians')).toBeCloseTo(2 * Math.PI, 12)
})

test.each([
  [190, 1, -170],
  [-180, 1, 180],
  [-180.4, 1, 180],
  [-0.2, 1, 0],
  [22.26, 0.1, 22.3],
  [100, 15, 105],
])('%f deg in steps of %f is %f', (from, step, to) => {
  expect(wrapped(from, step)).toBeCloseTo(to, 9)
  expect(Object.is(wrapped(from, step), -0)).toBe(false)
})

test('a slider has its value between its ends', () => {
  expect(scale({ number: 82.5, unit: 'mm' }, 'length', true)).toEqual({
    low: 1,
    high: 200,
    step: 1,
  })
  expect(scale({ number: 0, unit: 'mm' }, 'length', false)).toEqual({
    low: -50,
    high: 50,
    step: 0.25,
  })
  expect(scale({ number: 45, unit: 'deg' }, 'angle', false)).toEqual({
    low: -180,
    high: 180,
    step: 1,
  })
  for (const number of [0.0123, 3, 1e-9, 4711, -82]) {
    const { low, high } = scale({ number, unit: '' }, 'length', number > 0)
    expect(low).toBeLessThan(number)
    expect(high).toBeGreaterThan(number)
  }
})

test.each([
  [1, 1],
  [1.01, 2],
  [3, 5],
  [0.07, 0.1],
  [730, 1000],
])('%f is rounded up to %f', (value, round) => {
  expect(roundNumber(value)).toBeCloseTo(round, 12)
})

test.each([
  [
    { low: 1.01, high: 60, step: 0.5 },
    { low: 1.5, high: 60, step: 0.5 },
  ],
  [
    { low: 1.005, high: 20, step: 0.1 },
    { low: 1.1, high: 20, step: 0.1 },
  ],
  [
    { low: 0, high: 1, step: 0.005 },
    { low: 0, high: 1, step: 0.005 },
  ],
  [
    { low: -0.3, high: 0.7, step: 0.1 },
    { low: -0.3, high: 0.7, step: 0.1 },
  ],
  [
    { low: 1.01, high: 1.02, step: 0.5 },
    { low: 1.01, high: 1.02, step: 0.5 },
  ],
])('a scale stops at whole steps: %j', (given, expected) => {
  expect(ruled(given)).toEqual(expected)
})
