import { expect, test } from 'vitest'
import type { LoadShown } from '../../src/exhibit'
import { labelsOf, loadVector, pathOf, pointText } from '../../src/ui/loads'

const load = (changes: Partial<LoadShown>): LoadShown => ({
  on: 'bearing',
  name: 'bearing 1',
  speed_ratio: 1,
  load: {
    forward: [
      [0, 0],
      [1, 0],
    ],
    backward: [
      [0, 0],
      [0, 0],
    ],
  },
  peak: 1,
  peak_theta: 0,
  ...changes,
})

test('a load that turns with the crank stands still on its journal', () => {
  for (const sense of [1, -1]) {
    const still = loadVector(load({}), [0, 1], sense, 'shaft')
    const block = loadVector(load({}), [0, 1], sense, 'block')
    for (const theta of [0, 0.7, 3, 5.5]) {
      const [up, right] = still(theta)
      expect(up).toBeCloseTo(1, 12)
      expect(right).toBeCloseTo(0, 12)
      expect(block(theta)[1]).toBeCloseTo(sense * Math.sin(theta), 12)
    }
  }
})

test('a steady load turns back on the journal of a shaft at twice crank speed', () => {
  const steady = {
    forward: [
      [1, 0],
      [0, 0],
    ],
    backward: [
      [0, 0],
      [0, 0],
    ],
  } as LoadShown['load']
  const at = loadVector(load({ load: steady, speed_ratio: 2 }), [0, 1], 1, 'shaft')
  const [up, right] = at(Math.PI / 4)
  expect(up).toBeCloseTo(0, 12)
  expect(right).toBeCloseTo(-1, 12)
})

test('up is upward and right is to the right in the drawing', () => {
  expect(pointText([1, 0.5], 2)).toEqual(['1.0000', '-2.0000'])
  const { dots, path } = pathOf(loadVector(load({}), [0, 1], 1, 'block'), 1, 1)
  expect(dots.map((dot) => dot.map(Number))).toEqual([
    [0, -1],
    [1, -0],
    [0, 1],
    [-1, 0],
  ])
  expect(path.startsWith('M0.0000 -1.0000L')).toBe(true)
})

test('labels stand outside of their dots, and none on another', () => {
  const apart = labelsOf([
    ['0', '-1'],
    ['1', '0'],
    ['0', '1'],
    ['-1', '0'],
  ])
  expect(apart.map((place) => place && Math.hypot(...place) > 1.1)).toEqual(Array(4).fill(true))
  // two dots at one place have one label, one beyond has its own
  const [first, second, third] = labelsOf([
    ['0.10', '0'],
    ['0.09', '0.01'],
    ['-0.1', '0'],
  ])
  expect([first, second, third]).toEqual([[0.35, 0], null, [-0.35, 0]])
  // four letters are 0.43 wide: beside each other they would touch
  expect(
    labelsOf([
      ['0.1', '0.9'],
      ['-0.2', '0.9'],
    ])[1],
  ).toBeNull()
})
