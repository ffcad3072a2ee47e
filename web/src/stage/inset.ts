import type { Unit } from '../exhibit'
import { t } from '../language/messages'
import { lengthText, lengthUnit } from '../lengths'
import { css, type Palette } from './palette'
import type { Pen } from './pen'
import { roundValue } from './round'
import { REST } from './whirl'

/** Side of the inset, pixels: greatest, least, share of the stage; width of its words. */
const [LARGEST, SMALLEST, SHARE] = [148, 76, 0.27]
const [WORDS, BELOW, LINE] = [140, 50, 15]
/** From the edge of the stage, pixels. */
const EDGE = 10
/** Below this breadth of the stage, pixels, it stands before the engine. */
const SMALL = 480
const FONT = '11px system-ui, sans-serif'

/** Paths of the crank axis at its two ends, [up, right], in the scene's unit. */
export interface Paths {
  readonly front: [number, number][]
  readonly rear: [number, number][]
}

/** An inset: how the crank axis moves at front and rear, seen from the front. */
export class Inset {
  readonly canvas: HTMLCanvasElement
  #paths: Paths = { front: [], rear: [] }
  #side = LARGEST
  /** Whether the names of the ends stand below each other, being too long for one line. */
  #apart = false
  #pixels = 0
  #ring = 0
  #label = ''

  constructor(parent: HTMLElement) {
    this.canvas = document.createElement('canvas')
    Object.assign(this.canvas.style, {
      position: 'absolute',
      right: `${EDGE}px`,
      top: `${EDGE}px`,
      pointerEvents: 'none',
      // where there is little room it stands before the engine, and must still be read
      background: 'color-mix(in srgb, var(--ground, Canvas) 76%, transparent)',
      borderRadius: '10px',
    })
    this.canvas.setAttribute('aria-hidden', 'true')
    parent.append(this.canvas)
  }

  get paths(): Paths {
    return this.#paths
  }

  /** What it takes of the breadth of the stage, pixels. */
  get breadth(): number {
    return Math.max(WORDS, this.#side) + 2 * EDGE
  }

  get #high(): number {
    return this.#side + BELOW + (this.#apart ? LINE : 0)
  }

  /** Takes the measure of the stage, before paths are traced. */
  fit(width: number, height: number): void {
    this.#side = Math.round(
      Math.max(SMALLEST, Math.min(LARGEST, SHARE * width, 1.3 * SHARE * height)),
    )
    const to = this.canvas.getContext('2d')
    if (to) {
      to.font = FONT
      const long = Math.max(...ends().map((end) => to.measureText(end).width))
      this.#apart = 2 * (long + 6) > Math.max(WORDS, this.#side)
    }
    // beneath it no number is half covered where the stage is small
    this.canvas.style.top = `${width < SMALL ? 2 : EDGE}px`
    this.canvas.style.width = `${Math.max(WORDS, this.#side)}px`
    this.canvas.style.height = `${this.#high}px`
  }

  /** Takes new paths; `units` are the scene's, `size` the engine's. */
  trace(paths: Paths, units: readonly Unit[], size: number): void {
    this.#paths = paths
    const most = Math.max(
      ...[...paths.front, ...paths.rear].map(([up, right]) => Math.hypot(up, right)),
      0,
    )
    const some = most > REST * size
    this.#pixels = some ? (0.4 * this.#side) / most : 0
    const { factor } = lengthUnit(most, units)
    this.#ring = some ? roundValue(1.0001 * most * factor) / factor : 0
    this.#label = some
      ? t('ring: {radius}', { radius: lengthText(this.#ring, units) })
      : t('crank axis at rest')
  }

  #outline(to: Pen, path: readonly [number, number][]): void {
    to.beginPath()
    for (const [up, right] of path) to.lineTo(right * this.#pixels, -up * this.#pixels)
    to.stroke()
  }

  /** Draws the paths, and dots where the two ends are now; says how far the stage exaggerates. */
  draw(
    front: readonly number[],
    rear: readonly number[],
    palette: Palette,
    { density, magnification }: { density: number; magnification: number },
  ): void {
    const to = this.canvas.getContext('2d')
    if (!to) return
    const side = this.#side
    const across = Math.max(WORDS, side)
    const wide = Math.round(across * density)
    const high = Math.round(this.#high * density)
    if (this.canvas.width !== wide) this.canvas.width = wide
    if (this.canvas.height !== high) this.canvas.height = high
    to.setTransform(density, 0, 0, density, 0, 0)
    to.clearRect(0, 0, across, this.#high)
    this.sketch(to, front, rear, palette, magnification)
  }

  /** Draws the same with any pen, from its upper left corner. */
  sketch(
    to: Pen,
    front: readonly number[],
    rear: readonly number[],
    palette: Palette,
    magnification: number,
  ): void {
    const side = this.#side
    to.translate(Math.max(WORDS, side) / 2, side / 2)
    this.#ground(to, palette)
    const colours = [css(palette.crankshaft[0]), css(palette.force)] as const
    for (const end of [0, 1] as const) {
      to.strokeStyle = to.fillStyle = colours[end]
      to.lineWidth = 1.8
      to.setLineDash(end === 1 ? DASHED : WHOLE)
      this.#outline(to, end === 0 ? this.#paths.front : this.#paths.rear)
      const at = end === 0 ? front : rear
      to.beginPath()
      to.arc((at[1] as number) * this.#pixels, -(at[0] as number) * this.#pixels, 4, 0, 2 * Math.PI)
      to.fill()
    }
    to.setLineDash(WHOLE)
    to.font = FONT
    to.textBaseline = 'top'
    const write = (
      text: string,
      align: CanvasTextAlign,
      colour: string,
      x: number,
      y = 3,
    ): void => {
      to.textAlign = align
      to.fillStyle = colour
      to.fillText(text, x, side / 2 + y)
    }
    const [frontEnd, rearEnd] = ends()
    const room = Math.max(WORDS, side)
    const apart = this.#apart
    write(frontEnd, apart ? 'center' : 'right', colours[0], apart ? 0 : -6)
    write(rearEnd, apart ? 'center' : 'left', colours[1], apart ? 0 : 6, apart ? 18 : 3)
    const factor = Number(magnification.toPrecision(2))
    const said = [this.#label, t('exaggerated × {factor}', { factor })]
    said.forEach((text, line) => {
      to.font = fitting(to, text, room)
      write(text, 'center', palette.text, 0, LINE * line + (apart ? 33 : 18))
    })
  }

  #ground(to: Pen, palette: Palette): void {
    const half = this.#side / 2
    to.fillStyle = palette.paper
    to.globalAlpha = 0.72
    to.beginPath()
    to.arc(0, 0, half - 1, 0, 2 * Math.PI)
    to.fill()
    to.globalAlpha = 1
    to.strokeStyle = palette.quiet
    to.lineWidth = 1
    to.globalAlpha = 0.45
    to.beginPath()
    to.moveTo(-half + 6, 0)
    to.lineTo(half - 6, 0)
    to.moveTo(0, -half + 6)
    to.lineTo(0, half - 6)
    to.stroke()
    if (this.#ring > 0) {
      to.setLineDash(DASHED)
      to.beginPath()
      to.arc(0, 0, this.#ring * this.#pixels, 0, 2 * Math.PI)
      to.stroke()
      to.setLineDash(WHOLE)
    }
    to.globalAlpha = 1
  }

  set visible(shown: boolean) {
    this.canvas.style.display = shown ? '' : 'none'
  }
}

const ends = (): readonly [string, string] => [t('front end'), t('rear end')]

/** The font of the words, less where a line would be wider than its room. */
function fitting(to: Pen, text: string, room: number): string {
  to.font = FONT
  const share = Math.min(1, (room - 4) / to.measureText(text).width)
  return FONT.replace('11px', `${Math.floor(110 * share) / 10}px`)
}

const DASHED = [4, 3]
const WHOLE: number[] = []
