import { describe, expect, test } from 'vitest'
import { commonTurns, degreesText, typedAngle, withinCycle } from '../src/angle'

describe('an angle that is typed', () => {
  test.each([
    ['450', 450],
    ['-30', -30],
    ['−30', -30],
    [' 90 deg ', 90],
    ['90deg', 90],
    ['90°', 90],
    ['22.5 Degrees', 22.5],
    ['22,5', 22.5],
    ['.5', 0.5],
    ['1.5 rad', (1.5 * 180) / Math.PI],
    ['2 turns', 720],
    ['-0.25 turn', -90],
    ['1e2', 100],
  ])('%s', (text, degrees) => {
    const typed = typedAngle(text)
    expect(typed.ok && typed.degrees).toBeCloseTo(degrees, 10)
  })

  test.each([
    '',
    ' ',
    'abc',
    '90 bananas',
    '1 2',
    '--3',
    '1e99',
    'NaN',
    'Infinity',
    '90 constructor',
    '<b>90</b>',
  ])('is refused where it is none: %j', (text) => {
    const typed = typedAngle(text)
    expect(typed.ok).toBe(false)
  })
})

test.each([
  [450, 2, 450],
  [450, 1, 90],
  [-30, 2, 690],
  [-30, 1, 330],
  [720, 2, 0],
  [-720, 2, 0],
  [-1e-15, 1, 0],
])('%d degrees within %d turns are %d', (degrees, turns, expected) => {
  expect(withinCycle(degrees, turns)).toBe(expected)
})

test('degrees are written without noise', () => {
  expect([450, 22.5, 0.1 + 0.2, 1e-9, -0.0001, 100].map(degreesText)).toEqual([
    '450',
    '22.5',
    '0.3',
    '0',
    '0',
    '100',
  ])
})

test('two engines are both back at the start', () => {
  expect(commonTurns(2, 1)).toBe(2)
  expect(commonTurns(4, 6)).toBe(12)
  expect(commonTurns(1, 1)).toBe(1)
})
