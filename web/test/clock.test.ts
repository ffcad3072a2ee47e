import { signal } from '@preact/signals'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { type Clock, createClock } from '../src/clock'

let frames: ((now: number) => void)[] = []
let hidden = false
let listeners: (() => void)[] = []

/** Runs the frames that are asked for at a time, milliseconds. */
function frame(now: number): void {
  const asked = frames
  frames = []
  for (const run of asked) run(now)
}

beforeEach(() => {
  frames = []
  hidden = false
  listeners = []
  vi.stubGlobal('requestAnimationFrame', (run: (now: number) => void) => frames.push(run))
  vi.stubGlobal('cancelAnimationFrame', () => {
    frames = []
  })
  vi.stubGlobal('document', {
    get visibilityState() {
      return hidden ? 'hidden' : 'visible'
    },
    addEventListener: (_: string, told: () => void) => listeners.push(told),
    removeEventListener: () => undefined,
  })
})
afterEach(() => vi.unstubAllGlobals())

function clockOf(pace = 0.5): { clock: Clock; stood: (number | null)[]; seen: number[] } {
  const stood: (number | null)[] = []
  const seen: number[] = []
  const clock = createClock(signal(pace), (angle) => stood.push(angle))
  clock.turns.value = 2
  clock.follow((theta) => seen.push(theta))
  return { clock, stood, seen }
}

test('half a turn a second is 18 degrees in a tenth of a second', () => {
  const { clock, stood, seen } = clockOf()
  clock.play()
  frame(1000)
  frame(1100)
  expect(clock.degrees()).toBeCloseTo(18, 9)
  frame(1200)
  expect(clock.degrees()).toBeCloseTo(36, 9)
  expect(seen.at(-1)).toBeCloseTo(Math.PI / 5, 9)
  clock.stop()
  expect(stood).toEqual([null, clock.degrees()])
  frame(1300)
  expect(clock.degrees()).toBeCloseTo(36, 9)
  expect(frames).toHaveLength(0)
})

test('the cycle has no seam, and no angle leaves it', () => {
  const { clock } = clockOf()
  clock.turnTo(715)
  clock.play()
  frame(0)
  frame(100)
  expect(clock.degrees()).toBeCloseTo(13, 9)
  clock.turnTo(-30)
  expect(clock.degrees()).toBe(690)
  clock.turns.value = 1
  expect(clock.degrees()).toBe(330)
})

test('a hidden page asks for no frames, and the engine does not jump when it is seen again', () => {
  const { clock } = clockOf()
  clock.play()
  frame(0)
  frame(100)
  hidden = true
  frame(200)
  expect(frames).toHaveLength(0)
  const stood = clock.degrees()
  hidden = false
  for (const told of listeners) told()
  frame(60_000)
  expect(clock.degrees()).toBe(stood)
  frame(60_100)
  expect(clock.degrees()).toBeCloseTo(stood + 18, 9)
})

test('while nothing changes nothing is drawn', () => {
  const { clock, seen } = clockOf()
  frame(0)
  expect(seen).toHaveLength(1)
  expect(frames).toHaveLength(0)
  clock.refresh()
  clock.refresh()
  expect(frames).toHaveLength(1)
  frame(10)
  expect(seen).toHaveLength(2)
})

test('a follower that left is not called, and all are waited for', async () => {
  const { clock, seen } = clockOf()
  const leave = clock.follow(() => seen.push(99))
  leave()
  let done = false
  clock.follow(
    () =>
      new Promise<void>((resolve) =>
        setTimeout(() => {
          done = true
          resolve()
        }),
      ),
  )
  await clock.flush()
  expect(done).toBe(true)
  expect(seen).toEqual([0])
  expect(clock.frameTimes()).toHaveLength(1)
})

test('what was asked for is waited for until it is shown', async () => {
  const { clock } = clockOf()
  let shown = (): void => {}
  clock.follow(
    () =>
      new Promise<void>((done) => {
        shown = done
      }),
  )
  expect(clock.waiting()).toBe(true)
  frame(0)
  expect(clock.waiting()).toBe(true)
  shown()
  await new Promise((done) => setTimeout(done))
  expect(clock.waiting()).toBe(false)
})

test('what takes long takes turns while the engine turns, and is right at rest', async () => {
  const { clock } = clockOf()
  const shown: string[] = []
  const slow = (name: string) => () => {
    shown.push(name)
    return Promise.resolve()
  }
  clock.followInTurn(slow('star'))
  clock.followInTurn(() => undefined) // scrolled away
  const ended = clock.followInTurn(slow('polygon'))
  clock.play()
  for (let now = 1000; now < 1400; now += 100) frame(now)
  expect(shown).toEqual(['star', 'polygon', 'star', 'polygon'])
  clock.stop()
  frame(1400)
  expect(shown.slice(4).sort()).toEqual(['polygon', 'star'])
  ended()
  clock.turnTo(40)
  frame(1500)
  expect(shown.slice(6)).toEqual(['star'])
})
