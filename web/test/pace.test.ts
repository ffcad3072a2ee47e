import { expect, test } from 'vitest'
import { FASTEST, paceAt, paceText, placeOf, SLOWEST } from '../src/pace'

test('the slider reaches from slowest to fastest in equal ratios', () => {
  expect(paceAt(0)).toBe(SLOWEST)
  expect(paceAt(1)).toBe(FASTEST)
  expect(paceAt(0.5) ** 2).toBeCloseTo(SLOWEST * FASTEST, 2)
  for (const place of [0, 0.2, 0.55, 1]) expect(placeOf(paceAt(place))).toBeCloseTo(place, 2)
  expect(paceAt(-3)).toBe(SLOWEST)
  expect(placeOf(99)).toBe(1)
})

test('the factor is the speed of the engine over that of the page', () => {
  expect(paceText(1.25, 6000)).toContain('80 times slower than 6000 rpm')
  expect(paceText(0.4, 6000)).toContain('250 times slower')
  expect(paceText(1, 60)).toContain('as fast as')
  expect(paceText(5, 100)).toContain('3 times faster than 100 rpm')
  expect(paceText(1, null)).toContain('no speed')
})
