import type { Answer } from '../host/host'

/** How long a question may be on its way while a newer one waits, milliseconds; then it is given up. */
export const PATIENCE = 150

/** A question that is asked again and again while its subject changes. */
export interface Asked<Q> {
  /** Asks about the newest subject soon; what was to be asked before and has not been sent is dropped. */
  ask(subject: Q): void
  /** Whether an answer about the newest subject is still to come. */
  busy(): boolean
  stop(): void
}

export interface Asking<Q, A> {
  readonly send: (subject: Q, signal: AbortSignal) => Promise<Answer<A>>
  /** Told of answers in the order of their questions; `newest` is false while a newer subject waits. */
  readonly answered: (answer: Answer<A>, subject: Q, newest: boolean) => void
  /** Told when it begins to wait and when it has all answers. */
  readonly waiting: (busy: boolean) => void
  /** Calls back after a breath. Returns what calls it off. */
  readonly soon?: (call: () => void) => () => void
}

/** How long changes are gathered before they are sent, milliseconds: what comes in one breath is one question. */
const BREATH = 4

// Not the next frame: where frames are slow, that would be the longest part of the wait.
const afterABreath = (call: () => void): (() => void) => {
  const id = setTimeout(call, BREATH)
  return () => clearTimeout(id)
}

/**
 * One question at a time, the newest last. While one is on its way the newest waits for it, so that a drag shows what it passes;
 * one that takes longer than PATIENCE is given up for it.
 */
export function asked<Q, A>({ send, answered, waiting, soon = afterABreath }: Asking<Q, A>): Asked<Q> {
  let next: { subject: Q } | null = null
  let callOff: (() => void) | null = null
  let way: { abort: AbortController; since: number } | null = null
  let patience: ReturnType<typeof setTimeout> | undefined

  const schedule = () => {
    callOff ??= soon(() => {
      callOff = null
      if (way === null) void go()
    })
  }

  const giveUp = () => {
    way?.abort.abort()
    way = null
    if (next) schedule()
  }

  const go = async () => {
    if (next === null) return
    const { subject } = next
    next = null
    const mine = { abort: new AbortController(), since: performance.now() }
    way = mine
    let answer: Answer<A>
    try {
      answer = await send(subject, mine.abort.signal)
    } catch (reason) {
      if (mine.abort.signal.aborted) return
      answer = { ok: false, problems: [{ path: '', message: sentence(reason) }] }
    }
    if (way !== mine) return
    way = null
    clearTimeout(patience)
    patience = undefined
    answered(answer, subject, next === null)
    if (next) schedule()
    else waiting(false)
  }

  return {
    ask(subject) {
      next = { subject }
      waiting(true)
      if (way === null) schedule()
      else if (patience === undefined) {
        const left = Math.max(0, PATIENCE - (performance.now() - way.since))
        patience = setTimeout(() => {
          patience = undefined
          giveUp()
        }, left)
      }
    },
    busy: () => way !== null || next !== null,
    stop() {
      next = null
      callOff?.()
      callOff = null
      clearTimeout(patience)
      patience = undefined
      giveUp()
    },
  }
}

/** What went wrong outside of the engine, as a sentence. */
export function sentence(reason: unknown): string {
  const told = reason instanceof Error ? reason.message : String(reason)
  return /fetch|network/i.test(told) ? 'The server does not answer. Is crankstar serve still running?' : told
}
