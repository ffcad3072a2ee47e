import { expect, test } from 'vitest'
import type { Vectors } from '../src/exhibit'
import { telling } from '../src/telling'
import { exhibit } from './stage/engine'

const going = (up: number): Vectors => ({ forward: [[up, 0]], backward: [[up, 0]] })

/** Two cylinders at -1 and 1, each with 1 N; in all so much force and couple. */
function engine(force: number, couple: number) {
  return exhibit({
    reference_z: 0,
    total: { force: going(force), couple: going(couple), roll: [[0, 0]], torque: [[0, 0]] },
    cylinders: [
      { number: 1, z: 1, force: going(0.5) },
      { number: 2, z: -1, force: going(0.5) },
    ],
  })
}

test('what is greater in the engine is looked at first', () => {
  expect(telling(engine(1, 0))).toBe('force')
  expect(telling(engine(0, 1))).toBe('couple')
  expect(telling(engine(0.1, 0.9))).toBe('couple')
  expect(telling(engine(0, 0))).toBe('force')
})

test('arms are counted in the unit of length of the couples', () => {
  expect(telling({ ...engine(1, 0.9), couple_length: 1 })).toBe('force')
  expect(telling({ ...engine(1, 0.9), couple_length: 2 })).toBe('couple')
})
