import { expect, test } from 'vitest'
import { FASTEST, paceAt, paceWords, placeOf, SLOWEST } from '../src/pace'

test('the slider reaches from slowest to fastest in equal ratios', () => {
  expect(paceAt(0)).toBe(SLOWEST)
  expect(paceAt(1)).toBe(FASTEST)
  expect(paceAt(0.5) ** 2).toBeCloseTo(SLOWEST * FASTEST, 2)
  for (const place of [0, 0.2, 0.55, 1]) expect(placeOf(paceAt(place))).toBeCloseTo(place, 2)
  expect(paceAt(-3)).toBe(SLOWEST)
  expect(placeOf(99)).toBe(1)
})

test('the factor is the speed of the engine over that of the page', () => {
  expect(paceWords(1.25, 6000)).toBe('as at 6000 rpm, slowed 80 times')
  expect(paceWords(0.4, 6000)).toBe('as at 6000 rpm, slowed 250 times')
  expect(paceWords(1, 60)).toBe('as at 60 rpm, as fast as the engine')
  expect(paceWords(5, 100)).toBe('as at 100 rpm, 3 times as fast')
  expect(paceWords(1, null)).toBe('the engine file names no speed')
})
