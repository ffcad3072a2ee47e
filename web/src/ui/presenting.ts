import type { App } from '../app'
import { set } from '../state'

/** Whether the browser lets a page fill the screen; in a frame only where its page allows that. */
export const canFill = (): boolean => document.fullscreenEnabled

export const isFull = (): boolean => document.fullscreenElement !== null

/** Fills the screen with the page, or gives it back. */
export async function toggleFull(page: HTMLElement | null): Promise<void> {
  try {
    if (isFull()) await document.exitFullscreen()
    else await page?.requestFullscreen()
  } catch {
    // the browser has said no; everything is as before
  }
}

/** Begins or ends a presentation; what fills the screen is given back with it. */
export function present({ store }: App, on: boolean): void {
  set(store.present, on)
  if (!on && isFull()) void document.exitFullscreen().catch(() => {})
}

/** Opens the panel `step` places after the one that is open. */
export function stepPanel(page: HTMLElement, step: number): void {
  const tabs = [...page.querySelectorAll<HTMLElement>('.tabs [role=tab]')]
  const place = tabs.findIndex((tab) => tab.ariaSelected === 'true')
  tabs[(place + step + tabs.length) % tabs.length]?.click()
}

/** What single keys do; undefined for those without a meaning. */
export function actionOf(app: App, page: HTMLElement, key: string): (() => void) | undefined {
  const { dialog, store, explained } = app
  const actions: Readonly<Record<string, () => void>> = {
    f: () => canFill() && void toggleFull(page),
    p: () => present(app, !store.present.peek()),
    e: () => set(dialog, 'export'),
    '?': () => set(dialog, 'keys'),
    '[': () => stepPanel(page, -1),
    ']': () => stepPanel(page, 1),
  }
  if (key === 'Escape' && store.present.peek() && !explained.peek())
    return () => present(app, false)
  return actions[key.length === 1 ? key.toLowerCase() : '']
}
