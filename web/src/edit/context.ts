import { computed } from '@preact/signals'
import { createContext } from 'preact'
import { useContext, useMemo } from 'preact/hooks'
import { type Session, sentencesAt } from './session'
import { at, type Path, written } from './tree'

const Editing = createContext<Session | null>(null)

/** Gives a session to all fields below. */
export const Provider = Editing.Provider

export function useSession(): Session {
  const session = useContext(Editing)
  if (!session) throw new Error('a field of the editor stands outside of it')
  return session
}

/** The id of a field's element, so that an error can lead there. */
export function idOf(path: Path): string {
  return `edit:${written(path).replace(/\s/g, '_')}`
}

/** The value at a path; a component that uses it is drawn again only when it changes. */
export function useValue(path: Path): unknown {
  const session = useSession()
  const key = written(path)
  // a path is made anew at each drawing; what it says is its key
  return useMemo(() => computed(() => at(session.tree.value, path)), [session, key]).value
}

/** The sentences beside a field. */
export function useSentences(path: Path, below: boolean): string[] {
  return sentencesAt(useSession().problems.value, path, below)
}
