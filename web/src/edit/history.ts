import { same } from './tree'

/** Engine files in time, one the present; a gesture (a drag, typing) is one step. */
export interface History<T> {
  readonly past: readonly T[]
  readonly present: T
  readonly future: readonly T[]
  /** What the present came from, while that may go on; null once it is over. */
  readonly gesture: string | null
}

export type Move<T> =
  | { readonly kind: 'edit'; readonly to: T; readonly gesture?: string }
  | { readonly kind: 'rest' }
  | { readonly kind: 'undo' }
  | { readonly kind: 'redo' }
  /** To a step of all, counted from the first, undone ones included. */
  | { readonly kind: 'go'; readonly step: number }

/** Steps that are kept: a day's work, and no more memory than a photograph. */
export const LONGEST = 500

export function begun<T>(present: T): History<T> {
  return { past: [], present, future: [], gesture: null }
}

/** The history after a move; a move that changes nothing gives the same history. */
export function after<T>(history: History<T>, move: Move<T>): History<T> {
  const { past, present, future } = history
  switch (move.kind) {
    case 'edit': {
      if (same(move.to, present)) return history
      const gesture = move.gesture ?? null
      const goesOn = gesture !== null && gesture === history.gesture && past.length > 0
      return {
        past: goesOn ? past : [...past, present].slice(-LONGEST),
        present: move.to,
        future: [],
        gesture,
      }
    }
    case 'rest':
      return history.gesture === null ? history : { ...history, gesture: null }
    case 'undo': {
      const before = past.at(-1)
      if (before === undefined) return history
      return {
        past: past.slice(0, -1),
        present: before,
        future: [present, ...future],
        gesture: null,
      }
    }
    case 'redo': {
      const [next, ...rest] = future
      if (next === undefined) return history
      return { past: [...past, present], present: next, future: rest, gesture: null }
    }
    case 'go': {
      const all = [...past, present, ...future]
      const there = all[move.step]
      if (there === undefined || move.step === past.length) return history
      return {
        past: all.slice(0, move.step),
        present: there,
        future: all.slice(move.step + 1),
        gesture: null,
      }
    }
  }
}
