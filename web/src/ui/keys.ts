import type { Clock } from '../clock'

const STEPS: Readonly<Record<string, number>> = {
  ',': -1,
  '.': 1,
  '<': -10,
  '>': 10,
  ArrowLeft: -1,
  ArrowDown: -1,
  ArrowRight: 1,
  ArrowUp: 1,
  PageUp: 90,
  PageDown: -90,
}
/** Steps that also scroll or move through something: only where nothing else wants them. */
const SHARED = new Set(['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'PageUp', 'PageDown'])
const WRITTEN_IN =
  'input:not([type=range], [type=checkbox], [type=radio]), textarea, select, [contenteditable]'
/** What the space bar already does something to. */
const PRESSED = 'button, a, summary, [role=tab], [role=option], input'
const MOVED_IN =
  'input, [role=tablist], [role=listbox], [role=radiogroup], [role=grid], dialog, .panels'

/**
 * Play, stop and step by keys, in `root` or where nothing has the focus; what other keys do is
 * asked for by their names.
 */
export function listenForKeys(
  target: Document | HTMLElement,
  root: HTMLElement,
  clock: Clock,
  other: (key: string) => (() => void) | undefined,
): () => void {
  function pressed(event: Event): void {
    if (!(event instanceof KeyboardEvent) || event.defaultPrevented) return
    if (event.ctrlKey || event.metaKey || event.altKey || !(event.target instanceof Element)) return
    const { key, target: where } = event
    if (where.closest(WRITTEN_IN) || where.closest('dialog')) return
    if (where !== document.body && where !== document.documentElement && !root.contains(where))
      return
    if (key === ' ' && !where.closest(PRESSED)) {
      event.preventDefault()
      if (clock.playing.peek()) clock.stop()
      else clock.play()
      return
    }
    const step = STEPS[key]
    if (step === undefined) {
      const act = event.repeat ? undefined : other(key)
      if (act) event.preventDefault()
      act?.()
      return
    }
    if (SHARED.has(key) && where.closest(MOVED_IN)) return
    event.preventDefault()
    clock.stop()
    const shifted = event.shiftKey && Math.abs(step) === 1
    clock.turnTo(Math.round((clock.degrees() + step * (shifted ? 10 : 1)) * 1e6) / 1e6)
  }
  target.addEventListener('keydown', pressed)
  return () => target.removeEventListener('keydown', pressed)
}
