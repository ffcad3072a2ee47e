import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { latest, PATIENCE } from '../../src/edit/latest'
import type { Answer } from '../../src/host/host'

beforeEach(() => void vi.useFakeTimers())
afterEach(() => void vi.useRealTimers())

/** A server that answers a question with the question, after a while that is its own. */
function server(takes: (subject: number) => number) {
  const sent: number[] = []
  const given: number[] = []
  const aborted: number[] = []
  const told: [number, boolean][] = []
  const waits: boolean[] = []
  const live = latest<number, number>({
    send: (subject, signal) => {
      sent.push(subject)
      return new Promise<Answer<number>>((done, failed) => {
        setTimeout(() => done({ ok: true, value: subject }), takes(subject))
        signal.addEventListener('abort', () => {
          aborted.push(subject)
          failed(new Error('aborted'))
        })
      })
    },
    answered: (answer, _subject, newest) => {
      if (answer.ok) told.push([answer.value, newest])
      else given.push(answer.problems.length)
    },
    waiting: (busy) => waits.push(busy),
  })
  return { live, sent, told, waits, aborted, given }
}

test('a change is sent at once, and of those that come meanwhile the last', async () => {
  const { live, sent, told, waits } = server(() => 5)
  live.ask(1)
  expect(sent).toEqual([1])
  live.ask(2)
  live.ask(3)
  await vi.advanceTimersByTimeAsync(100)
  expect(sent).toEqual([1, 3])
  expect(told).toEqual([
    [1, false],
    [3, true],
  ])
  expect(waits.at(-1)).toBe(false)
  expect(live.busy()).toBe(false)
})

test('a drag shows what it passes, in order, and ends with its end', async () => {
  const { live, told, aborted } = server(() => 50)
  for (let place = 1; place <= 40; place++) {
    live.ask(place)
    await vi.advanceTimersByTimeAsync(16)
  }
  await vi.advanceTimersByTimeAsync(200)
  const values = told.map(([value]) => value)
  expect(values.length).toBeGreaterThan(5)
  expect(values).toEqual(values.toSorted((one, other) => one - other))
  expect(told.at(-1)).toEqual([40, true])
  expect(told.filter(([, newest]) => newest)).toHaveLength(1)
  expect(aborted).toEqual([])
})

test('a question that takes long is given up for a newer one, and its answer is not told', async () => {
  const { live, told, aborted } = server((subject) => (subject === 1 ? 5000 : 10))
  live.ask(1)
  await vi.advanceTimersByTimeAsync(20)
  live.ask(2)
  await vi.advanceTimersByTimeAsync(PATIENCE + 50)
  expect(aborted).toEqual([1])
  expect(told).toEqual([[2, true]])
  await vi.advanceTimersByTimeAsync(6000)
  expect(told).toEqual([[2, true]])
})

test('what is slow but alone is waited for', async () => {
  const { live, told, aborted } = server(() => 3000)
  live.ask(1)
  await vi.advanceTimersByTimeAsync(3100)
  expect(aborted).toEqual([])
  expect(told).toEqual([[1, true]])
})

test('after a stop nothing is told, and it can be asked again', async () => {
  const { live, told } = server(() => 50)
  live.ask(1)
  await vi.advanceTimersByTimeAsync(20)
  live.stop()
  await vi.advanceTimersByTimeAsync(100)
  expect(told).toEqual([])
  live.ask(2)
  await vi.advanceTimersByTimeAsync(100)
  expect(told).toEqual([[2, true]])
})

test('a server that does not answer is a problem, and the next question is asked', async () => {
  const problems: string[] = []
  let there = false
  const live = latest<number, number>({
    send: async (subject) => {
      if (!there) throw new Error('no server')
      return { ok: true, value: subject }
    },
    answered: (answer) => problems.push(answer.ok ? 'well' : (answer.problems[0]?.message ?? '')),
    waiting: () => undefined,
  })
  live.ask(1)
  await vi.advanceTimersByTimeAsync(5)
  there = true
  live.ask(2)
  await vi.advanceTimersByTimeAsync(5)
  expect(problems).toEqual(['no server', 'well'])
})

test('an answer that comes although its question was given up is not told', async () => {
  const told: number[] = []
  const live = latest<number, number>({
    send: (subject) =>
      new Promise((done) =>
        setTimeout(() => done({ ok: true, value: subject }), subject === 1 ? PATIENCE + 500 : 10),
      ),
    answered: (answer) => answer.ok && told.push(answer.value),
    waiting: () => undefined,
  })
  live.ask(1)
  await vi.advanceTimersByTimeAsync(20)
  live.ask(2)
  await vi.advanceTimersByTimeAsync(5000)
  expect(told).toEqual([2])
})
