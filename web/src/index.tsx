import type { Host } from './host/host'

/** What anywidget calls, and what our own pages call: shows the engine in an element until the returned function is called. */
function render({ el }: { model: unknown; el: HTMLElement }): () => void {
  el.textContent = 'crankstar'
  return () => el.replaceChildren()
}

export type { Host }
export default { render }
