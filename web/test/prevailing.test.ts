import { expect, test } from 'vitest'
import type { Vectors } from '../src/exhibit'
import { prevailing } from '../src/prevailing'
import { exhibit } from './stage/engine'

const going = (up: number): Vectors => ({ forward: [[up, 0]], backward: [[up, 0]] })

/** An engine from z = -1 to 1 with so much force and couple. */
function engine(force: number, couple: number) {
  const one = exhibit({
    total: { force: going(force), couple: going(couple), roll: [[0, 0]], torque: [[0, 0]] },
  })
  return {
    ...one,
    couple_length: 1,
    scene: { ...one.scene, low: [-1, -1, -1], high: [1, 1, 1] },
  } as typeof one
}

test('what is greater in the engine is looked at first, a couple as a pair of forces at its ends', () => {
  expect(prevailing(engine(1, 0))).toBe('force')
  expect(prevailing(engine(0, 1))).toBe('couple')
  expect(prevailing(engine(0.1, 0.3))).toBe('couple')
  expect(prevailing(engine(0.1, 0.1))).toBe('force')
  expect(prevailing(engine(0, 0))).toBe('force')
})

test('its length is counted in what the couples are counted in', () => {
  expect(prevailing({ ...engine(1, 1.5), couple_length: 1 })).toBe('force')
  expect(prevailing({ ...engine(1, 1.5), couple_length: 2 })).toBe('couple')
})
