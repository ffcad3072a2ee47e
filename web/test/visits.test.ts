import { expect, test } from 'vitest'
import { OPENING, type State } from '../src/state'
import { BURST, visits } from '../src/visits'

const state = (part: Partial<State>): State => ({ ...OPENING, ...part })

test('another panel or engine is a visit, an angle is none', () => {
  const made = visits(OPENING)
  expect(made.isNew(state({ angle: 30 }), 0)).toBe(false)
  expect(made.isNew(state({ tab: 'verdict' }), 0)).toBe(true)
  expect(made.isNew(state({ tab: 'verdict', scale: 2 }), 0)).toBe(false)
  expect(made.isNew(state({ tab: 'verdict', engine: 'i4' }), 0)).toBe(true)
  expect(made.isNew(state({ tab: 'verdict', engine: 'i6' }), 1)).toBe(true)
  expect(made.isNew(state({ tab: 'verdict', engine: 'i6', beside: 'i4' }), 2)).toBe(true)
})

test('edits that follow each other are one visit, those after a rest another', () => {
  const made = visits(OPENING)
  const at = (engine: string, now: number): boolean => made.isNew(state({ engine }), now)
  expect([at('~a', 0), at('~b', 300), at('~c', 1200), at('~d', 1200 + BURST)]).toEqual([
    true,
    false,
    false,
    true,
  ])
})

test('what comes from Back is no visit of its own', () => {
  const made = visits(state({ tab: 'verdict' }))
  made.seen(OPENING)
  expect(made.isNew(OPENING, 0)).toBe(false)
  expect(made.isNew(state({ engine: '~a' }), 1)).toBe(true)
})
