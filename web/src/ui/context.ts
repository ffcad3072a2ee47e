import { createContext } from 'preact'
import { useContext, useEffect } from 'preact/hooks'
import type { App } from '../app'
import type { Follower } from '../clock'
import type { Exhibit } from '../exhibit'

export const Shared = createContext<App | null>(null)

/** What all parts of the page share. */
export function useApp(): App {
  const app = useContext(Shared)
  if (!app) throw new Error('A part of the page stands outside of it.')
  return app
}

/** The engine on the stage that the panels show. */
export function useExhibit(): Exhibit {
  const { shown, subject } = useApp()
  const exhibit = shown.value[subject.value]
  if (!exhibit) throw new Error('There is no engine.')
  return exhibit
}

/** Calls `follower` with every crank angle; anew when an input changes. */
export function useFollower(follower: Follower, inputs: readonly unknown[]): void {
  const { clock } = useApp()
  useEffect(() => clock.follow(follower), [clock, ...inputs])
}
