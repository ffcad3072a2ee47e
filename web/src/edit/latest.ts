import type { Answer } from '../host/host'
import { reasonOf } from '../reason'

/** Milliseconds after which a request is given up for a newer one. */
export const PATIENCE = 150

/** Requests about a subject that changes; the newest counts. */
export interface Latest<Q> {
  /** Requests the newest subject as soon as possible; an older one not yet sent is dropped. */
  ask(subject: Q): void
  /** Whether an answer about the newest subject is still to come. */
  busy(): boolean
  stop(): void
}

export interface Requests<Q, A> {
  readonly send: (subject: Q, signal: AbortSignal) => Promise<Answer<A>>
  /** Called in the order of requests; `newest` is false while a newer subject waits. */
  readonly answered: (answer: Answer<A>, subject: Q, newest: boolean) => void
  /** Told when it begins to wait and when it has all answers. */
  readonly waiting: (busy: boolean) => void
}

/**
 * One question at a time, the newest last, each sent as soon as it can be: at once, or when the one
 * before is answered, so that a drag shows what it passes. One that takes longer than PATIENCE is
 * given up for a newer one.
 */
export function latest<Q, A>({ send, answered, waiting }: Requests<Q, A>): Latest<Q> {
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
      answer = { ok: false, problems: [{ path: '', message: reasonOf(reason) }] }
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
