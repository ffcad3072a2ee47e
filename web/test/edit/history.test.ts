import { expect, test } from 'vitest'
import { after, begun, type History, LONGEST, type Move } from '../../src/edit/history'

const walked = (start: number, ...moves: Move<number>[]): History<number> =>
  moves.reduce(after<number>, begun(start))
const undo: Move<number> = { kind: 'undo' }
const redo: Move<number> = { kind: 'redo' }
const edit = (to: number, gesture?: string): Move<number> =>
  gesture === undefined ? { kind: 'edit', to } : { kind: 'edit', to, gesture }

test('undo and redo walk through what was edited', () => {
  expect(walked(0, edit(1), edit(2), undo).present).toBe(1)
  expect(walked(0, edit(1), edit(2), undo, undo, redo).present).toBe(1)
  expect(walked(0, edit(1), edit(2), undo, undo, redo, redo).present).toBe(2)
})

test('a drag is one step', () => {
  const dragged = walked(0, edit(1), edit(2, 'drag a'), edit(3, 'drag a'), edit(4, 'drag a'))
  expect(dragged.present).toBe(4)
  expect(after(dragged, undo).present).toBe(1)
})

test('the same gesture after a rest, and another gesture, are steps of their own', () => {
  expect(walked(0, edit(1, 'a'), { kind: 'rest' }, edit(2, 'a'), undo).present).toBe(1)
  expect(walked(0, edit(1, 'a'), edit(2, 'b'), undo).present).toBe(1)
})

test('after an undo a gesture does not go on', () => {
  expect(walked(0, edit(1), edit(2, 'a'), undo, edit(3, 'a'), undo).present).toBe(1)
})

test('an edit forgets what was undone', () => {
  const history = walked(0, edit(1), undo, edit(2))
  expect(history.future).toEqual([])
  expect(after(history, redo)).toBe(history)
})

test('nothing to do is nothing done', () => {
  const history = begun(0)
  for (const move of [undo, redo, edit(0), { kind: 'rest' } as const])
    expect(after(history, move)).toBe(history)
})

test('the oldest steps are forgotten, never the newest', () => {
  const moves = Array.from({ length: LONGEST + 50 }, (_, place) => edit(place + 1))
  const history = walked(0, ...moves)
  expect(history.past.length).toBe(LONGEST)
  expect(history.present).toBe(LONGEST + 50)
  expect(after(history, undo).present).toBe(LONGEST + 49)
})
