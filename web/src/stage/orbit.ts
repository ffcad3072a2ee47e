import { HOME, type Orbit } from './cameras'

const RADIANS_PER_PIXEL = 0.008
const KEY_STEP = Math.PI / 24
const ZOOM_STEP = 1.15
const [NEAREST, FARTHEST] = [12, 0.4]

/** Turns a free look by so many pixels of dragging. */
export function dragged(orbit: Orbit, dx: number, dy: number): void {
  orbit.azimuth = (orbit.azimuth - dx * RADIANS_PER_PIXEL) % (2 * Math.PI)
  orbit.elevation = Math.max(
    -Math.PI / 2,
    Math.min(Math.PI / 2, orbit.elevation + dy * RADIANS_PER_PIXEL),
  )
}

export function zoomed(orbit: Orbit, factor: number): void {
  orbit.zoom = Math.max(FARTHEST, Math.min(NEAREST, orbit.zoom * factor))
}

const STEP = KEY_STEP / RADIANS_PER_PIXEL
const KEYS: Readonly<Record<string, (orbit: Orbit) => void>> = {
  ArrowLeft: (orbit) => dragged(orbit, -STEP, 0),
  ArrowRight: (orbit) => dragged(orbit, STEP, 0),
  ArrowUp: (orbit) => dragged(orbit, 0, -STEP),
  ArrowDown: (orbit) => dragged(orbit, 0, STEP),
  '+': (orbit) => zoomed(orbit, ZOOM_STEP),
  '=': (orbit) => zoomed(orbit, ZOOM_STEP),
  '-': (orbit) => zoomed(orbit, 1 / ZOOM_STEP),
  Home: (orbit) => Object.assign(orbit, HOME),
}

/** Does what a key asks for; false if the key means nothing here. */
export function pressed(orbit: Orbit, key: string): boolean {
  KEYS[key]?.(orbit)
  return key in KEYS
}

/**
 * Lets mouse, fingers and keys turn a free look on an element: dragging turns, two fingers or the
 * wheel zoom, dragging with another button, the shift key or two fingers shifts. `active` tells
 * whether the free look is on. Gives back what ends it.
 */
export function listened(
  element: HTMLElement,
  orbit: Orbit,
  active: () => boolean,
  changed: () => void,
): () => void {
  const fingers = new Map<number, { x: number; y: number }>()
  const ending = new AbortController()
  const on = <K extends keyof HTMLElementEventMap>(
    name: K,
    does: (event: HTMLElementEventMap[K]) => void,
  ) => element.addEventListener(name, does, { signal: ending.signal, passive: false })
  const shifted = (dx: number, dy: number) => {
    orbit.x -= (2 * dx) / element.clientHeight
    orbit.y += (2 * dy) / element.clientHeight
  }
  on('pointerdown', (event) => {
    if (!active()) return
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY })
    element.setPointerCapture(event.pointerId)
  })
  on('pointermove', (event) => {
    const before = fingers.get(event.pointerId)
    if (!before || !active()) return
    const [dx, dy] = [event.clientX - before.x, event.clientY - before.y]
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1]
    if (other) {
      const was = Math.hypot(before.x - other.x, before.y - other.y)
      if (was > 0) zoomed(orbit, Math.hypot(event.clientX - other.x, event.clientY - other.y) / was)
      shifted(dx / 2, dy / 2)
    } else if (event.shiftKey || event.buttons > 1) shifted(dx, dy)
    else dragged(orbit, dx, dy)
    before.x = event.clientX
    before.y = event.clientY
    changed()
  })
  for (const name of ['pointerup', 'pointercancel'] as const)
    on(name, (event) => fingers.delete(event.pointerId))
  on('contextmenu', (event) => active() && event.preventDefault())
  on('wheel', (event) => {
    if (!active()) return
    event.preventDefault()
    zoomed(orbit, Math.exp(-event.deltaY * 0.0015))
    changed()
  })
  on('keydown', (event) => {
    if (!active() || event.ctrlKey || event.metaKey || event.altKey || !pressed(orbit, event.key))
      return
    event.preventDefault()
    event.stopPropagation()
    changed()
  })
  return () => ending.abort()
}
