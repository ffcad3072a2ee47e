/** Draws what all canvases in an element show, `density` pixels to one of the page. */
export function composed(
  root: HTMLElement,
  density: number,
  paper: HTMLCanvasElement,
  settings: CanvasRenderingContext2DSettings = {},
): readonly HTMLCanvasElement[] {
  paper.width = Math.round(density * root.clientWidth)
  paper.height = Math.round(density * root.clientHeight)
  const to = paper.getContext('2d', settings)
  const canvases = [...root.querySelectorAll('canvas')].filter((canvas) => canvas !== paper)
  if (!to) return canvases
  to.imageSmoothingQuality = 'high'
  to.scale(density, density)
  for (const canvas of canvases) {
    const { offsetLeft, offsetTop, offsetWidth, offsetHeight } = canvas
    if (offsetWidth > 0) to.drawImage(canvas, offsetLeft, offsetTop, offsetWidth, offsetHeight)
  }
  return canvases
}

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
    // a canvas that is read often is printed as it is, not drawn again
    const canvases = composed(root, DENSITY, paper, { willReadFrequently: true })
    for (const canvas of canvases) canvas.style.visibility = 'hidden'
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
