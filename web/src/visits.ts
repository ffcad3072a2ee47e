import type { State } from './state'

/** Milliseconds within which edits of an engine are one visit: a drag, typing, a few clicks. */
export const BURST = 1500

/** Decides which states become entries that Back and Forward step through. */
export interface Visits {
  /** Whether a state that is written now is another visit; `now` in milliseconds. */
  isNew(state: State, now: number): boolean
  /** Takes over a state that came from outside, as by Back. */
  seen(state: State): void
}

const isEdited = ({ engine }: State): boolean => engine.startsWith('~')

/**
 * Another engine, another panel, the engine beside, and an engine after a rest of editing are
 * visits of their own; angles, arrows and what else one turns within a view are not.
 */
export function visits(first: State): Visits {
  let last = first
  let edited = Number.NEGATIVE_INFINITY
  return {
    isNew(state, now) {
      const moved = (['tab', 'beside', 'fitted'] as const).some((key) => state[key] !== last[key])
      const another = state.engine !== last.engine
      const goesOn = another && isEdited(state) && isEdited(last) && now - edited < BURST
      if (another && isEdited(state)) edited = now
      last = state
      return moved || (another && !goesOn)
    },
    seen(state) {
      last = state
      edited = Number.NEGATIVE_INFINITY
    },
  }
}
