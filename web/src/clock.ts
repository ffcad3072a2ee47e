import { type ReadonlySignal, type Signal, signal } from '@preact/signals'
import { begin } from './activity'
import { withinCycle } from './angle'

/** Shows the engine at an angle (radians); a promise is awaited. */
export type Follower = (theta: number) => unknown

/** The one thing on the page that knows what time it is. Everything that moves follows it. */
export interface Clock {
  readonly playing: ReadonlySignal<boolean>
  /** Turns of the crankshaft after which everything is back at the start; theta stays within. */
  readonly turns: Signal<number>
  /** Crank angle in degrees within the cycle. */
  degrees(): number
  /** Turns the engine to an angle, degrees; shown with the next frame. */
  turnTo(degrees: number): void
  play(): void
  stop(): void
  follow(follower: Follower): () => void
  /**
   * For what takes long: while the engine turns, such followers take turns, one a frame; one that
   * gives no promise had nothing to show and passes its turn on. At rest all show the angle.
   */
  followInTurn(follower: Follower): () => void
  /** Something else than the angle has changed: everything is shown again with the next frame. */
  refresh(): void
  /** Shows everything now, not with the next frame. */
  flush(): Promise<void>
  /** Whether something that was asked for is not shown yet. */
  waiting(): boolean
  /** Milliseconds of script of the last frames, at most 600. */
  frameTimes(): number[]
  dispose(): void
}

const KEPT = 600
/** A frame that comes later than this, seconds, is a pause: the engine does not jump over it. */
const LONGEST = 0.25

export function createClock(
  pace: ReadonlySignal<number>,
  stopped: (degrees: number | null) => void,
): Clock {
  const playing = signal(false)
  const turns = signal(1)
  const followers = new Set<Follower>()
  const inTurn = new Set<Follower>()
  const times: number[] = []
  // kept in degrees, so that 450 stays 450 in links
  let angle = 0
  let before: number | null = null
  let asked = 0
  let showing = 0

  async function show(): Promise<void> {
    const began = performance.now()
    showing += 1
    // an engine that turns never settles, one at rest has when this is shown
    const end = playing.peek() ? undefined : begin()
    const theta = (angle * Math.PI) / 180
    try {
      const waiting = [...followers].map((follower) => follower(theta))
      waiting.push(...(playing.peek() ? next(theta) : [...inTurn].map((each) => each(theta))))
      if (waiting.some((done) => done instanceof Promise)) await Promise.all(waiting)
    } finally {
      showing -= 1
      end?.()
    }
    times.push(performance.now() - began)
    if (times.length > KEPT) times.shift()
  }

  /** Has the first in turn that has something to show show it, and puts it last. */
  function next(theta: number): readonly unknown[] {
    for (const follower of [...inTurn]) {
      const shown = follower(theta)
      if (!(shown instanceof Promise)) continue
      if (inTurn.delete(follower)) inTurn.add(follower)
      return [shown]
    }
    return []
  }

  function frame(now: number): void {
    asked = 0
    if (playing.peek()) {
      const passed = before === null ? 0 : (now - before) / 1000
      if (passed < LONGEST) angle = withinCycle(angle + passed * pace.peek() * 360, turns.peek())
      before = now
    }
    void show()
    if (playing.peek()) ask()
  }

  function ask(): void {
    // a hidden tab gets no frames; the clock goes on when it is visible
    if (!asked && document.visibilityState !== 'hidden') asked = requestAnimationFrame(frame)
  }

  function seen(): void {
    before = null
    ask()
  }
  document.addEventListener('visibilitychange', seen)

  const degrees = (): number => withinCycle(angle, turns.peek())
  return {
    playing,
    turns,
    degrees,
    turnTo(wanted) {
      angle = withinCycle(wanted, turns.peek())
      if (!playing.peek()) stopped(degrees())
      ask()
    },
    play() {
      if (playing.peek()) return
      before = null
      playing.value = true
      stopped(null)
      ask()
    },
    stop() {
      if (!playing.peek()) return
      playing.value = false
      stopped(degrees())
      ask()
    },
    follow(follower) {
      followers.add(follower)
      ask()
      return () => followers.delete(follower)
    },
    followInTurn(follower) {
      inTurn.add(follower)
      ask()
      return () => inTurn.delete(follower)
    },
    refresh: ask,
    flush: show,
    waiting: () => asked + showing > 0,
    frameTimes: () => [...times],
    dispose() {
      document.removeEventListener('visibilitychange', seen)
      cancelAnimationFrame(asked)
      playing.value = false
      followers.clear()
      inTurn.clear()
    },
  }
}
