import type { Unit } from '../exhibit'
import { t } from '../language/messages'
import { lengthText, lengthUnit } from '../lengths'
import { roundValue } from './lettering'
import { css, type Palette } from './palette'
import type { Pen } from './pen'
import { REST } from './whirl'

/** Side of the inset, pixels: greatest, least, share of the stage; width of its words. */
const [LARGEST, SMALLEST, SHARE] = [148, 76, 0.27]
const [WORDS, BELOW] = [140, 50]
/** From the edge of the stage, pixels. */
const EDGE = 10
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

  /** Takes the measure of the stage, before paths are traced. */
  fit(width: number, height: number): void {
    this.#side = Math.round(
      Math.max(SMALLEST, Math.min(LARGEST, SHARE * width, 1.3 * SHARE * height)),
    )
    this.canvas.style.width = `${Math.max(WORDS, this.#side)}px`
    this.canvas.style.height = `${this.#side + BELOW}px`
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
    const high = Math.round((side + BELOW) * density)
    if (this.canvas.width !== wide) this.canvas.width = wide
    if (this.canvas.height !== high) this.canvas.height = high
    to.setTransform(density, 0, 0, density, 0, 0)
    to.clearRect(0, 0, across, side + BELOW)
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
    write(t('front end'), 'right', colours[0], -6)
    write(t('rear end'), 'left', colours[1], 6)
    write(this.#label, 'center', palette.text, 0, 18)
    const factor = Number(magnification.toPrecision(2))
    write(t('exaggerated × {factor}', { factor }), 'center', palette.text, 0, 33)
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

const DASHED = [4, 3]
const WHOLE: number[] = []
