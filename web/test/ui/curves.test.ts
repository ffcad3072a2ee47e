import { expect, test } from 'vitest'
import { coarseOf, sizeText } from '../../src/ui/Bars'
import { extentOf, HIGH, pathOf, ticksOf, tickText, WIDE } from '../../src/ui/Curves'

test('a curve goes from edge to edge, its greatest value at the top', () => {
  expect(pathOf(Float64Array.of(-1, 3, -1), -1, 3)).toBe(
    `M0.0 ${HIGH}.0L${WIDE / 2}.0 0.0L${WIDE}.0 ${HIGH}.0`,
  )
})

test('nought is always seen', () => {
  expect(extentOf([Float64Array.of(2, 5)])).toEqual([0, 5])
  expect(extentOf([])).toEqual([0, 0])
})

test('ticks are round and within the drawing', () => {
  expect(ticksOf(-130, 540, 4)).toEqual([0, 200, 400])
  expect(ticksOf(-0.13, 0.13, 4).map(tickText)).toEqual(['−0.1', '0', '0.1'])
  expect(ticksOf(0, 0, 4)).toEqual([0])
  expect(ticksOf(-450, 420, 4)).toEqual([-400, -200, 0, 200, 400])
})

test('what is exactly nought is 0, what is small is not', () => {
  expect([0, 1e-9, 252.84].map(sizeText)).toEqual(['0', '1e-9', '252.8'])
})

test('of many orders few have a name on a phone', () => {
  const halves = (most: number) => Array.from({ length: 2 * most }, (_, index) => (index + 1) / 2)
  expect([...coarseOf(halves(8))]).toEqual([1, 2, 3, 4, 5, 6, 7, 8])
  expect([...coarseOf(halves(24))]).toEqual([2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24])
})
