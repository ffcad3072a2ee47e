import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { afterRest, begin, counted, revision, settled } from '../src/activity'

let frames: (() => void)[] = []

/** So many frames, each with what its timers and promises do. */
async function passed(count: number): Promise<void> {
  for (let frame = 0; frame < count; frame++) {
    const asked = frames
    frames = []
    for (const run of asked) run()
    await vi.advanceTimersByTimeAsync(0)
  }
}

/** What `settled` has come to: a list that is empty until then. */
function awaited(busy = () => false, moving = () => false): number[] {
  const at: number[] = []
  void settled(busy, moving).then((revision) => at.push(revision))
  return at
}

beforeEach(() => {
  vi.useFakeTimers()
  frames = []
  vi.stubGlobal('requestAnimationFrame', (run: () => void) => frames.push(run))
})
afterEach(() => {
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

test('a page with nothing to do settles after quiet frames, at its revision', async () => {
  const at = awaited()
  await passed(1)
  expect(at).toEqual([])
  await passed(5)
  expect(at).toEqual([revision()])
})

test('what is begun raises the revision, and the page settles when it has ended', async () => {
  const before = revision()
  const end = begin()
  const at = awaited()
  await passed(9)
  expect(at).toEqual([])
  end()
  end() // counts once
  const other = begin()
  await passed(9)
  expect(at).toEqual([])
  other()
  await passed(5)
  expect(at).toEqual([before + 2])
})

test('what begins and ends between two frames starts the quiet anew', async () => {
  const at = awaited()
  for (let frame = 0; frame < 9; frame++) {
    begin()()
    await passed(1)
  }
  expect(at).toEqual([])
  await passed(5)
  expect(at).toEqual([revision()])
})

test('a promise that is refused has ended too, and is refused to who asked', async () => {
  let refuse = (_: Error): void => {}
  const promise = counted(
    new Promise((_, reject) => {
      refuse = reject
    }),
  )
  const at = awaited()
  await passed(9)
  expect(at).toEqual([])
  refuse(new Error('no'))
  await expect(promise).rejects.toThrow('no')
  await passed(5)
  expect(at).toHaveLength(1)
})

test('what waits for a rest is done once: at its time, at once to settle, or not at all', async () => {
  const done: string[] = []
  afterRest(() => done.push('in time'), 300)
  await vi.advanceTimersByTimeAsync(299)
  expect(done).toEqual([])
  await vi.advanceTimersByTimeAsync(1)
  expect(done).toEqual(['in time'])
  afterRest(() => done.push('called off'), 300)()
  afterRest(() => done.push('to settle'), 300)
  const at = awaited()
  await passed(6)
  expect(at).toHaveLength(1)
  await vi.advanceTimersByTimeAsync(600)
  expect(done).toEqual(['in time', 'to settle'])
})

test('what is not counted here is asked for at every frame', async () => {
  let busy = true
  const at = awaited(() => busy)
  await passed(9)
  expect(at).toEqual([])
  busy = false
  await passed(5)
  expect(at).toHaveLength(1)
})

test('what waits for a rest waits on while something moves, and is not waited for', async () => {
  const done: string[] = []
  const off = afterRest(() => done.push('rest'), 300)
  const at = awaited(
    () => false,
    () => true,
  )
  await passed(6)
  expect(at).toEqual([revision()])
  expect(done).toEqual([])
  off()
})
