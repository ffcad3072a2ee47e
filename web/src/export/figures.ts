import { type Ground, paletteOf } from './picture'
import { png } from './saving'
import { FAMILY, paint } from './svgPen'

/** A figure or a table of the panel that is open. */
export interface Exported<T extends Element> {
  readonly label: string
  readonly element: T
}

/** Pixels of a picture for one of the page, and the room round a figure. */
const [SHARP, ROOM] = [2, 12]

/** The figures of a panel, each with what it is called. */
export function figuresIn(panel: Element, engine: string): Exported<SVGSVGElement>[] {
  const found: Exported<SVGSVGElement>[] = []
  for (const figure of panel.querySelectorAll('figure')) {
    const element = figure.querySelector('svg')
    if (!element || element.getBoundingClientRect().width === 0) continue
    const named = figure.querySelector('[aria-label]')?.getAttribute('aria-label')
    const label = named ?? figure.querySelector('figcaption')?.textContent ?? element.ariaLabel
    found.push({ label: tidy((label ?? '').replace(`. ${engine}.`, '')), element })
  }
  return numbered(found)
}

/** The tables of a panel, each called by its caption or by the heading above it. */
export function tablesIn(panel: Element): Exported<HTMLTableElement>[] {
  const headings = [...panel.querySelectorAll('h2, h3, h4, summary')]
  const found = [...panel.querySelectorAll('table')].map((element) => {
    const above = headings.findLast(
      (each) => each.compareDocumentPosition(element) & Node.DOCUMENT_POSITION_FOLLOWING,
    )
    return { label: tidy((element.caption ?? above)?.textContent ?? ''), element }
  })
  return numbered(found)
}

const tidy = (text: string): string => text.replace(/\s+/g, ' ').replace(/\.$/, '').trim()

/** Names of which none is twice. */
function numbered<T extends Element>(found: readonly Exported<T>[]): Exported<T>[] {
  const seen = new Map<string, number>()
  return found.map((each) => {
    const count = (seen.get(each.label) ?? 0) + 1
    seen.set(each.label, count)
    return count > 1 ? { ...each, label: `${each.label} ${count}` } : each
  })
}

/** What of its look an element of a figure has from the style of the page. */
const LOOKS = [
  'fill-opacity',
  'stroke-opacity',
  'opacity',
  'stroke-width',
  'stroke-linecap',
  'stroke-linejoin',
  'stroke-dasharray',
  'paint-order',
] as const
const LETTERS = ['font-size', 'font-weight', 'font-style', 'text-anchor', 'dominant-baseline']
const DRAWN = 'path, line, rect, circle, ellipse, polygon, polyline, text, tspan'

/** A figure that stands alone: with its colours and letters in itself, on a ground of its own. */
export function standalone(figure: SVGSVGElement, ground: Ground, name: string): string {
  const { dressed, take } = onGround(figure, ground)
  try {
    const copy = dressed.cloneNode(true) as SVGSVGElement
    const originals = [...dressed.querySelectorAll<SVGElement>(DRAWN)]
    const copies = [...copy.querySelectorAll<SVGElement>(DRAWN)]
    copies.forEach((element, index) => {
      const original = originals[index]
      if (original) dress(element, getComputedStyle(original), original.tagName)
    })
    for (const element of [copy, ...copy.querySelectorAll('*')])
      for (const attribute of ['style', 'class', 'tabindex']) element.removeAttribute(attribute)
    return framed(copy, paletteOf(ground).paper, name)
  } finally {
    take()
  }
}

/** A copy of a figure as it looks on a light or a dark page. */
function onGround(figure: SVGSVGElement, ground: Ground) {
  const page = figure.closest<HTMLElement>('.crankstar')
  const dressed = figure.cloneNode(true) as SVGSVGElement
  let inner: Element = dressed
  for (let above = figure.parentElement; above && above !== page; above = above.parentElement) {
    const shell = above.cloneNode(false) as Element
    shell.removeAttribute('id')
    shell.append(inner)
    inner = shell
  }
  const outer = (page ?? document.createElement('div')).cloneNode(false) as HTMLElement
  outer.classList.remove('light', 'dark', 'present')
  outer.classList.add(ground)
  outer.inert = true
  Object.assign(outer.style, { position: 'fixed', left: '-9999px', top: '0', width: '900px' })
  outer.append(inner)
  page?.parentElement?.append(outer)
  return { dressed, take: () => outer.remove() }
}

function dress(element: SVGElement, style: CSSStyleDeclaration, tag: string): void {
  for (const name of ['fill', 'stroke'] as const) {
    const opacity = Number(style.getPropertyValue(`${name}-opacity`))
    for (const [key, value] of Object.entries(paint(name, style.getPropertyValue(name), opacity)))
      element.setAttribute(key, value)
  }
  for (const look of LOOKS) {
    const value = style.getPropertyValue(look)
    if (!look.endsWith('-opacity') && value) element.setAttribute(look, value)
  }
  if (tag !== 'text' && tag !== 'tspan') return
  for (const look of LETTERS) element.setAttribute(look, style.getPropertyValue(look))
  element.setAttribute('font-family', `${FAMILY}, sans-serif`)
}

/** A figure with room round it, its ground and its name. */
function framed(svg: SVGSVGElement, colour: string, name: string): string {
  const { x, y, width, height } = svg.viewBox.baseVal
  const scale = width > 0 && width < 10 ? 320 / width : 1 // some count in shares, not pixels
  const room = ROOM / scale
  const box = [x - room, y - room, width + 2 * room, height + 2 * room] as const
  svg.setAttribute('viewBox', box.join(' '))
  svg.setAttribute('width', String(box[2] * scale))
  svg.setAttribute('height', String(box[3] * scale))
  const back = document.createElementNS(svg.namespaceURI, 'rect')
  ;['x', 'y', 'width', 'height'].forEach((side, index) => {
    back.setAttribute(side, String(box[index]))
  })
  back.setAttribute('fill', colour)
  const title = document.createElementNS(svg.namespaceURI, 'title')
  title.textContent = name
  svg.prepend(title, back)
  return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(svg)}\n`
}

/** SVG as a PNG, with more pixels than its own. */
export async function rastered(text: string, sharp = SHARP): Promise<Blob> {
  const image = new Image()
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`
  await image.decode()
  const canvas = document.createElement('canvas')
  canvas.width = Math.ceil(image.naturalWidth * sharp)
  canvas.height = Math.ceil(image.naturalHeight * sharp)
  canvas.getContext('2d')?.drawImage(image, 0, 0, canvas.width, canvas.height)
  return png(canvas)
}
