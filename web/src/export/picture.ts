import type { App } from '../app'
import { t } from '../language/messages'
import { DARK, LIGHT, type Palette } from '../stage/palette'
import type { Pen } from '../stage/pen'
import type { Stage, View } from '../stage/stage'
import { SIGHT } from '../ui/Layers'
import { viewOf } from '../ui/StageView'
import { angleWord, fileName } from './fileNames'
import { SvgPen } from './svgPen'

/** On what ground a picture is drawn. */
export const GROUNDS = ['light', 'dark'] as const
export type Ground = (typeof GROUNDS)[number]

/** Height of the head above the stage, and the room at its left, pixels. */
const [HEAD, LEFT] = [50, 16]
const FONT = 'system-ui, sans-serif'
/** How much finer a still picture and a frame of a film are drawn than kept. */
const [STILL, MOVING] = [2, 4 / 3]
/** Most pixels across that a browser makes a picture of. */
const WIDEST = 8192

/** The stages side by side below a head with names, view and crank angle. */
interface Sheet {
  readonly width: number
  readonly height: number
  readonly parts: readonly { readonly stage: Stage; readonly name: string; readonly x: number }[]
}

function sheetOf(app: App): Sheet {
  let width = 0
  let height = 0
  const parts = app.shown.peek().flatMap((exhibit, index) => {
    const stage = app.stages.get(index)
    if (!stage) return []
    const part = { stage, name: exhibit.name, x: width }
    width += stage.size.width
    height = Math.max(height, stage.size.height)
    return [part]
  })
  return { width, height: height + HEAD, parts }
}

export const paletteOf = (ground: Ground): Palette => (ground === 'dark' ? DARK : LIGHT)

/** What is on the stages at a crank angle, degrees. */
function viewAt(app: App, degrees: number, ground: Ground): View {
  return { ...viewOf(app, (degrees * Math.PI) / 180), dark: ground === 'dark' }
}

/** Degrees with the decimals that they have, at most two. */
const degreesOf = (degrees: number): string => String(Number(degrees.toFixed(2)))

/** Ground and head of a picture: each engine's name, then view and crank angle. */
function begin(pen: Pen, app: App, sheet: Sheet, degrees: string, ground: Ground): void {
  const palette = paletteOf(ground)
  pen.fillStyle = palette.paper
  pen.fillRect(0, 0, sheet.width + 2, sheet.height + 2) // sides may be rounded up
  pen.named?.('head')
  pen.textAlign = 'left'
  pen.textBaseline = 'alphabetic'
  for (const { stage, name, x } of sheet.parts) {
    pen.fillStyle = palette.text
    pen.font = `600 16px ${FONT}`
    pen.fillText(fitting(pen, name, stage.size.width - 2 * LEFT), x + LEFT, 23)
  }
  pen.fillStyle = palette.quiet
  pen.font = `13px ${FONT}`
  const view = t(SIGHT[app.sight.peek()])
  const cycle = 360 * app.clock.turns.peek()
  pen.fillText(t('{view}, θ = {angle}° of {cycle}°', { view, angle: degrees, cycle }), LEFT, 42)
  pen.named?.(null)
}

/** A text, cut with an ellipsis where it is too long. */
function fitting(pen: Pen, text: string, width: number): string {
  if (pen.measureText(text).width <= width) return text
  let end = text.length
  while (end > 1 && pen.measureText(`${text.slice(0, end)} …`).width > width) end -= 1
  return `${text.slice(0, end)} …`
}

/** Pictures of the stages, one after the other on the same canvas, until `end`. */
export interface Camera {
  readonly canvas: HTMLCanvasElement
  /** Draws the stages at a crank angle; `angle` is how it is written. */
  take(degrees: number, angle?: string): void
  end(): void
}

/** Sets a camera before the stages; `even` for films, whose sides are even numbers. */
export function cameraOf(
  app: App,
  density: number,
  ground: Ground,
  { even = false }: { even?: boolean } = {},
): Camera {
  const sheet = sheetOf(app)
  const sharp = Math.min(density, WIDEST / sheet.width, WIDEST / sheet.height)
  const side = (length: number): number =>
    even ? 2 * Math.round((length * sharp) / 2) : Math.round(length * sharp)
  const canvas = document.createElement('canvas')
  canvas.width = side(sheet.width)
  canvas.height = side(sheet.height)
  // a film reads every frame back
  const to = canvas.getContext('2d', { willReadFrequently: even })
  if (!to) throw new Error(t('This browser cannot draw the picture.'))
  const finer = even ? MOVING : STILL
  const shots = new Map(sheet.parts.map(({ stage }) => [stage, stage.shots(sharp, finer)] as const))
  return {
    canvas,
    take(degrees, angle = degreesOf(degrees)) {
      const view = viewAt(app, degrees, ground)
      to.setTransform(sharp, 0, 0, sharp, 0, 0)
      begin(to, app, sheet, angle, ground)
      for (const { stage, x } of sheet.parts) {
        const drawn = shots.get(stage)?.take(view)
        if (drawn) to.drawImage(drawn, x, HEAD, stage.size.width, stage.size.height)
      }
    },
    end() {
      for (const each of shots.values()) each.end()
    },
  }
}

/** What is on the stages now, as a canvas with `density` pixels to one of the page. */
export function photographed(app: App, density: number, ground: Ground): HTMLCanvasElement {
  const camera = cameraOf(app, density, ground)
  try {
    camera.take(app.clock.degrees())
    return camera.canvas
  } finally {
    camera.end()
  }
}

/** What is on the stages now, as SVG: flat, of lines and letters. */
export function drawnAsSvg(app: App, ground: Ground): string {
  const sheet = sheetOf(app)
  const degrees = app.clock.degrees()
  const names = sheet.parts.map(({ name }) => name).join(' · ')
  const pen = new SvgPen(sheet.width, sheet.height, names)
  begin(pen, app, sheet, degreesOf(degrees), ground)
  const view = viewAt(app, degrees, ground)
  for (const { stage, x, name } of sheet.parts) {
    pen.save()
    pen.named(`engine ${name}`)
    pen.translate(x, HEAD)
    stage.sketch(view, pen)
    pen.named(null)
    pen.restore()
  }
  return pen.text
}

/** The name of a picture of the stages: engines, view, and the angle where it stands still. */
export function pictureName(app: App, kind: string, ...words: readonly string[]): string {
  const still = words.length ? [] : [angleWord(app.clock.degrees())]
  return fileName(app, kind, app.sight.peek(), ...still, ...words)
}
