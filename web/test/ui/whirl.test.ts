import { expect, test } from 'vitest'
import type { Exhibit, Vectors } from '../../src/exhibit'
import { rollOf, suggestedMagnification } from '../../src/ui/whirl'
import { exhibit } from '../stage/engine'

const vectors = (up: number): Vectors => ({ forward: [[up, 0]], backward: [[0, 0]] })
const whirling = (changes: Partial<Exhibit['whirl']>): Exhibit => {
  const plain = exhibit()
  return { ...plain, whirl: { ...plain.whirl, ...changes } }
}

test('an engine that hardly shifts but rolls is not magnified until it spins', () => {
  const rolls = whirling({ shift: vectors(1e-7), turn: [[0, 1e-3]] })
  const most = suggestedMagnification(rolls)
  expect(most * rollOf(rolls, null)).toBeLessThan(0.2)
  expect(most * rollOf(rolls, null)).toBeGreaterThan(0.02)
  expect(suggestedMagnification(whirling({ shift: vectors(1e-7) }))).toBeGreaterThan(100 * most)
})

test('an engine that only rolls does move', () => {
  expect(suggestedMagnification(whirling({ turn: [[1e-4, 0]] }))).toBeGreaterThan(0)
  expect(suggestedMagnification(whirling({}))).toBe(0)
})

test('the roll is the amplitude of a signal of one order, of the chosen orders alone', () => {
  expect(rollOf(whirling({ turn: [[3e-3, 4e-3]] }), null)).toBeCloseTo(5e-3, 5)
  expect(rollOf(whirling({ turn: [[3e-3, 4e-3]] }), [2])).toBe(0)
})
