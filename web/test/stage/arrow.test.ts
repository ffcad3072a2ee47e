import { expect, test } from 'vitest'
import { straight } from '../../src/stage/arrow'
import type { Pen } from '../../src/stage/pen'

type Way = [string, number, number]

/** What a pen was asked to draw. */
function drawn([fromX, fromY]: [number, number], [tipX, tipY]: [number, number]): Way[] {
  const ways: Way[] = []
  const written =
    (name: string) =>
    (x = Number.NaN, y = Number.NaN) =>
      ways.push([name, x, y])
  const pen = Object.fromEntries(
    ['moveTo', 'lineTo', 'beginPath', 'stroke', 'fill'].map((name) => [name, written(name)]),
  )
  straight(pen as unknown as Pen, [fromX, fromY, 0], [tipX, tipY, 0], '#000000', 2)
  return ways.filter(([name]) => name.endsWith('To'))
}

test.each([
  [0, 0, 40, 0],
  [5, 5, 5, -60],
  [10, 20, -20, 60],
])('an arrow from %d, %d to %d, %d has its head at its tip', (fromX, fromY, tipX, tipY) => {
  const [start, neck, tip, one, other] = drawn([fromX, fromY], [tipX, tipY])
  const long = Math.hypot(tipX - fromX, tipY - fromY)
  const along = (way: Way | undefined): number =>
    way
      ? ((way[1] - fromX) * (tipX - fromX) + (way[2] - fromY) * (tipY - fromY)) / long
      : Number.NaN
  expect(start).toEqual(['moveTo', fromX, fromY])
  expect(tip).toEqual(['moveTo', tipX, tipY])
  for (const barb of [neck, one, other]) expect(along(barb)).toBeCloseTo(long - 12, 9)
})

test('an arrow that is hardly long is left out', () => {
  expect(drawn([0, 0], [2, 2])).toEqual([])
})
