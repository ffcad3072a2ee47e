import type { App } from '../app'
import type { Stage } from '../stage/stage'
import { CAMERAS, type Camera } from '../stage/stage'

/** How far a finger goes for a swipe, pixels, and how much more to the side than up or down. */
const [FAR, FLAT] = [40, 1.6]
/** What a swipe steps through. */
const SWIPED: readonly Camera[] = CAMERAS.filter((camera) => camera !== 'orbit')

/**
 * A click on a view of the sheet enlarges it, a click on an enlarged one goes back to the sheet;
 * where there is no room for a sheet, a swipe shows the next view. Returns what ends it.
 */
export function listenForSights(element: HTMLElement, app: App, stage: Stage): () => void {
  let from: { x: number; y: number; touch: boolean } | null = null
  function pressed({ clientX, clientY, pointerType, isPrimary }: PointerEvent): void {
    from = isPrimary ? { x: clientX, y: clientY, touch: pointerType !== 'mouse' } : null
  }
  function released({ clientX, clientY }: PointerEvent): void {
    if (!from) return
    const [dx, dy, touch] = [clientX - from.x, clientY - from.y, from.touch]
    from = null
    const sight = app.sight.peek()
    if (sight === 'orbit') return
    if (Math.hypot(dx, dy) < 4) {
      const chosen = goal(clientX, clientY)
      if (chosen !== undefined) app.store.camera.value = chosen
    } else if (touch && !app.roomy.peek() && Math.abs(dx) > Math.max(FAR, FLAT * Math.abs(dy)))
      app.store.camera.value = next(sight === 'sheet' ? 'isometric' : sight, dx < 0 ? 1 : -1)
  }
  /** What a click shows; null for as wide as there is room. */
  function goal(clientX: number, clientY: number): Camera | null | undefined {
    if (!app.roomy.peek()) return undefined
    if (app.sight.peek() !== 'sheet') return null
    const box = element.getBoundingClientRect()
    const enlarged = box.width / element.clientWidth // in a presentation
    const [x, y] = [(clientX - box.left) / enlarged, (clientY - box.top) / enlarged]
    return stage
      .read()
      .panes.find(
        (pane) =>
          x >= pane.x && x <= pane.x + pane.width && y >= pane.y && y <= pane.y + pane.height,
      )?.camera
  }
  const dropped = (): void => {
    from = null
  }
  element.addEventListener('pointerdown', pressed)
  element.addEventListener('pointerup', released)
  element.addEventListener('pointercancel', dropped)
  return () => {
    element.removeEventListener('pointerdown', pressed)
    element.removeEventListener('pointerup', released)
    element.removeEventListener('pointercancel', dropped)
  }
}

/** The view `step` places after another one, round and round. */
export function next(camera: Camera, step: number): Camera {
  const place = SWIPED.indexOf(camera) + step
  return SWIPED[(place + SWIPED.length) % SWIPED.length] ?? 'isometric'
}
