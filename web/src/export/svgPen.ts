import type { Pen } from '../stage/pen'

/** What `save` keeps: the ways of drawing, where the pen stands, what clips it. */
const WAYS = [
  'fillStyle',
  'strokeStyle',
  'lineWidth',
  'lineCap',
  'lineJoin',
  'globalAlpha',
  'font',
  'textAlign',
  'textBaseline',
] as const
type Ways = { -readonly [K in (typeof WAYS)[number]]: Pen[K] }

const NAMESPACE = 'http://www.w3.org/2000/svg'
const ANCHOR: Readonly<Partial<Record<CanvasTextAlign, string>>> = {
  center: 'middle',
  right: 'end',
  end: 'end',
}
/** From a line of the letters to their base line, in sizes: no attribute for it is read everywhere. */
const BELOW: Readonly<Partial<Record<CanvasTextBaseline, number>>> = {
  top: 0.8,
  middle: 0.32,
  bottom: -0.2,
}
const DECIMALS = 100
const short = (value: number): string => String(Math.round(value * DECIMALS) / DECIMALS)

/** A pen that writes down what it draws, as SVG with attributes alone: no style, no script. */
export class SvgPen implements Pen {
  fillStyle: Pen['fillStyle'] = '#000000'
  strokeStyle: Pen['strokeStyle'] = '#000000'
  lineWidth = 1
  lineCap: CanvasLineCap = 'butt'
  lineJoin: CanvasLineJoin = 'miter'
  globalAlpha = 1
  font = '10px sans-serif'
  textAlign: CanvasTextAlign = 'left'
  textBaseline: CanvasTextBaseline = 'alphabetic'
  readonly #root = document.createElementNS(NAMESPACE, 'svg')
  readonly #measure = document.createElement('canvas').getContext('2d')
  #into: Element = this.#root
  #kept: { ways: Ways; x: number; y: number; clip: string }[] = []
  #path = ''
  #box: readonly number[] = []
  #dash: readonly number[] = []
  #x = 0
  #y = 0
  #clip = ''
  #clips = 0

  constructor(width: number, height: number, title: string) {
    this.#root.setAttribute('width', short(width))
    this.#root.setAttribute('height', short(height))
    this.#root.setAttribute('viewBox', `0 0 ${short(width)} ${short(height)}`)
    this.#root.setAttribute('role', 'img')
    this.#add('title', {}).textContent = title
  }

  get text(): string {
    const text = new XMLSerializer().serializeToString(this.#root)
    return `<?xml version="1.0" encoding="UTF-8"?>\n${text}\n`
  }

  named(part: string | null): void {
    if (part === null) this.#into = this.#into.parentElement ?? this.#root
    else {
      const [kind = ''] = part.split(' ')
      this.#into = this.#add('g', { class: kind, 'aria-label': part })
    }
  }

  save(): void {
    const ways = Object.fromEntries(WAYS.map((way) => [way, this[way]])) as unknown as Ways
    this.#kept.push({ ways, x: this.#x, y: this.#y, clip: this.#clip })
  }

  restore(): void {
    const kept = this.#kept.pop()
    if (!kept) return
    Object.assign(this, kept.ways)
    this.#x = kept.x
    this.#y = kept.y
    this.#clip = kept.clip
  }

  translate(x: number, y: number): void {
    this.#x += x
    this.#y += y
  }

  beginPath(): void {
    this.#path = ''
    this.#box = []
  }

  moveTo(x: number, y: number): void {
    this.#path += `M${short(this.#x + x)} ${short(this.#y + y)}`
  }

  lineTo(x: number, y: number): void {
    this.#path += `${this.#path ? 'L' : 'M'}${short(this.#x + x)} ${short(this.#y + y)}`
  }

  rect(x: number, y: number, width: number, height: number): void {
    this.#box = [this.#x + x, this.#y + y, width, height]
    this.moveTo(x, y)
    this.#path += `h${short(width)}v${short(height)}h${short(-width)}z`
  }

  arc(x: number, y: number, radius: number, from: number, to: number, back = false): void {
    const at = (angle: number): string =>
      `${short(this.#x + x + radius * Math.cos(angle))} ${short(this.#y + y + radius * Math.sin(angle))}`
    const sweep = back ? from - to : to - from
    this.#path += `${this.#path ? 'L' : 'M'}${at(from)}`
    const way = back ? 0 : 1
    const bend = (angle: number, large: 0 | 1): string =>
      `A${short(radius)} ${short(radius)} 0 ${large} ${way} ${at(angle)}`
    if (sweep >= 2 * Math.PI - 1e-9) this.#path += `${bend(from + Math.PI, 0)}${bend(from, 0)}z`
    else this.#path += bend(to, sweep > Math.PI ? 1 : 0)
  }

  closePath(): void {
    this.#path += 'z'
  }

  clip(): void {
    const [x = 0, y = 0, width = 0, height = 0] = this.#box
    const id = `clip-${++this.#clips}`
    const clip = document.createElementNS(NAMESPACE, 'clipPath')
    clip.setAttribute('id', id)
    const box = document.createElementNS(NAMESPACE, 'rect')
    for (const [name, value] of Object.entries({ x, y, width, height }))
      box.setAttribute(name, short(value))
    clip.append(box)
    this.#root.append(clip)
    this.#clip = `url(#${id})`
  }

  /** Nothing has been drawn below that is to be taken away. */
  clearRect(): void {}

  setLineDash(dash: number[]): void {
    this.#dash = dash
  }

  fill(): void {
    if (this.#path) this.#add('path', { d: this.#path, ...this.#filled() })
  }

  stroke(): void {
    if (this.#path) this.#add('path', { d: this.#path, fill: 'none', ...this.#stroked() })
  }

  fillRect(x: number, y: number, width: number, height: number): void {
    const place = { x: this.#x + x, y: this.#y + y, width, height }
    const written = Object.entries(place).map(([name, value]) => [name, short(value)])
    this.#add('rect', { ...Object.fromEntries(written), ...this.#filled() })
  }

  fillText(text: string, x: number, y: number): void {
    this.#letters(text, x, y, this.#filled())
  }

  /** The halo round letters; who reads the file aloud need not hear them twice. */
  strokeText(text: string, x: number, y: number): void {
    this.#letters(text, x, y, { ...this.#stroked(), fill: 'none', 'aria-hidden': 'true' })
  }

  measureText(text: string): TextMetrics {
    const to = this.#measure
    if (!to) throw new Error('no canvas to measure letters on')
    to.font = this.font
    return to.measureText(text)
  }

  #letters(text: string, x: number, y: number, look: Record<string, string>): void {
    const [, weight = '', size = '10', family = 'sans-serif'] =
      /^(?:(\d+|bold) )?([\d.]+)px (.*)$/.exec(this.font) ?? []
    const below = (BELOW[this.textBaseline] ?? 0) * Number(size)
    this.#add('text', {
      x: short(this.#x + x),
      y: short(this.#y + y + below),
      'font-family': family.replace('system-ui', FAMILY),
      'font-size': size,
      ...(weight && { 'font-weight': weight }),
      ...(ANCHOR[this.textAlign] && { 'text-anchor': ANCHOR[this.textAlign] as string }),
      ...look,
    }).textContent = text.replaceAll('  ', '\u00a0 ') // SVG makes one of two
  }

  #filled(): Record<string, string> {
    return paint('fill', this.fillStyle, this.globalAlpha)
  }

  #stroked(): Record<string, string> {
    const dash = this.#dash.length > 0 && { 'stroke-dasharray': this.#dash.join(' ') }
    return {
      ...paint('stroke', this.strokeStyle, this.globalAlpha),
      'stroke-width': short(this.lineWidth),
      'stroke-linecap': this.lineCap,
      'stroke-linejoin': this.lineJoin,
      ...dash,
    }
  }

  #add(name: string, attributes: Readonly<Record<string, string>>): Element {
    const element = document.createElementNS(NAMESPACE, name)
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value)
    if (this.#clip && this.#into === this.#root) element.setAttribute('clip-path', this.#clip)
    this.#into.append(element)
    return element
  }
}

/** Letters without feet that one of every system has, the last by its kind. */
export const FAMILY =
  "Helvetica Neue, Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', 'Noto Sans', 'Noto Sans CJK JP'"

/** A colour as every program reads it: `#rrggbb`, and how opaque apart. */
export function paint(
  name: 'fill' | 'stroke',
  colour: Pen['fillStyle'],
  alpha = 1,
): Record<string, string> {
  const numbers = /^rgba?\(([^)]*)\)$/.exec(String(colour))?.[1]?.match(/[\d.]+(?:e-?\d+)?/g)
  if (!numbers) return { [name]: String(colour), ...opacity(name, alpha) }
  const [red = 0, green = 0, blue = 0, opaque = 1] = numbers.map(Number)
  const hex = [red, green, blue].map((part) => Math.round(part).toString(16).padStart(2, '0'))
  return { [name]: `#${hex.join('')}`, ...opacity(name, alpha * opaque) }
}

const opacity = (name: string, share: number): Record<string, string> =>
  share < 1 ? { [`${name}-opacity`]: String(Math.round(share * 1000) / 1000) } : {}
