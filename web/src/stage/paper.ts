/** Pixels on paper for each on the screen. */
const DENSITY = 3

/**
 * Prints the canvases in an element as one picture, for a WebGL canvas is printed empty, and what
 * another one clears is cleared below it too. `draw` is called with the density before, and with
 * null after. Returns what ends it.
 */
export function printable(root: HTMLElement, draw: (density: number | null) => void): () => void {
  const paper = document.createElement('canvas')
  // the element has another shape on paper than on the screen
  const place = { position: 'absolute', inset: '0', width: '100%', height: '100%' }
  Object.assign(paper.style, place, { objectFit: 'contain' })
  const begin = (): void => {
    draw(DENSITY)
    paper.width = DENSITY * root.clientWidth
    paper.height = DENSITY * root.clientHeight
    // a canvas that is read often is printed as it is, not drawn again
    const to = paper.getContext('2d', { willReadFrequently: true })
    to?.scale(DENSITY, DENSITY)
    for (const canvas of root.querySelectorAll('canvas')) {
      const { offsetLeft, offsetTop, offsetWidth, offsetHeight } = canvas
      if (offsetWidth > 0) to?.drawImage(canvas, offsetLeft, offsetTop, offsetWidth, offsetHeight)
      canvas.style.visibility = 'hidden'
    }
    root.append(paper)
  }
  const end = (): void => {
    paper.remove()
    for (const canvas of root.querySelectorAll('canvas')) canvas.style.visibility = ''
    draw(null)
  }
  addEventListener('beforeprint', begin)
  addEventListener('afterprint', end)
  return () => {
    removeEventListener('beforeprint', begin)
    removeEventListener('afterprint', end)
  }
}
