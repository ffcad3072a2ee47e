import type { Answer } from '../host/host'

/** How long a question may be on its way while a newer one waits, milliseconds; then it is given up. */
export const PATIENCE = 150

/** A question that is asked again and again while its subject changes. */
export interface Asked<Q> {
  /** Asks about the newest subject as soon as it can be; what was to be asked before and has not been sent is dropped. */
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
}

/**
 * One question at a time, the newest last, each sent as soon as it can be: at once, or when the one before is answered, so that a
 * drag shows what it passes. One that takes longer than PATIENCE is given up for a newer one.
 */
export function asked<Q, A>({ send, answered, waiting }: Asking<Q, A>): Asked<Q> {
  let next: { subject: Q } | null = null
  let way: { abort: AbortController; since: number } | null = null
  let patience: ReturnType<typeof setTimeout> | undefined

  const giveUp = () => {
    way?.abort.abort()
    way = null
    void go()
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
    const newest = next === null
    void go() // before the answer is shown, which takes a while
    answered(answer, subject, newest)
    if (way === null && next === null) waiting(false)
  }

  return {
    ask(subject) {
      next = { subject }
      waiting(true)
      if (way === null) void go()
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
