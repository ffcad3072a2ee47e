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

/** The place of the engine that a part of a panel is about; null for the first that they show. */
export const Subject = createContext<number | null>(null)

/** The place of the engine that this part of a panel shows. */
export function useSubject(): number {
  const { subject } = useApp()
  return useContext(Subject) ?? subject.value
}

/** The engines on the stage that the panels show. */
export function useExhibits(): readonly Exhibit[] {
  const { shown, subjects } = useApp()
  return subjects.value.flatMap((place) => shown.value[place] ?? [])
}

/** The engine on the stage that this part of a panel shows. */
export function useExhibit(): Exhibit {
  const { shown } = useApp()
  const exhibit = shown.value[useSubject()]
  if (!exhibit) throw new Error('There is no engine.')
  return exhibit
}

/** Calls `follower` with every crank angle; anew when an input changes. */
export function useFollower(follower: Follower, inputs: readonly unknown[]): void {
  const { clock } = useApp()
  useEffect(() => clock.follow(follower), [clock, ...inputs])
}

/** A choice within a panel that goes into links as `name`, such as `bearings.on`; the first is how it opens. */
export function useChoice<T extends string>(
  name: string,
  choices: readonly [T, ...T[]],
): readonly [T, (value: T) => void] {
  const { store } = useApp()
  const chosen = store.choices.value[name]
  const value = choices.find((each) => each === chosen) ?? choices[0]
  const choose = (next: T): void => {
    const { [name]: _, ...others } = store.choices.value
    store.choices.value = next === choices[0] ? others : { ...others, [name]: next }
  }
  return [value, choose]
}
