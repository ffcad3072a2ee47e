import type { Exhibit } from '../exhibit'
import { message, t } from '../language/messages'
import type { Frame } from './cameras'
import { along, facesAnother } from './extent'
import type { Load } from './load'
import { css, type Palette } from './palette'
import { dot, type Vector } from './vector'
import { type Displacement, displaced } from './whirl'

const FONT = 'system-ui, sans-serif'
/** Length of the frame's axes on the screen, pixels. */
const AXIS = 30
/** Labels nearer to each other than this are written as one, pixels. */
const CLOSE = 15
/** Below this width, pixels, the scales of arrows go beneath the axes. */
export const NARROW = 300
/** From this width on there is room for a sentence beside an arrow, pixels. */
const WIDE = 560
const AXES = [
  { along: [1, 0, 0], name: message('x right') },
  { along: [0, 1, 0], name: message('y up') },
  { along: [0, 0, 1], name: message('z front') },
] as const satisfies readonly { along: Vector; name: string }[]

/** The labels of the drawing: cylinder numbers, axes, scales of the arrows. */
export interface Writing {
  readonly frame: Frame
  readonly width: number
  readonly height: number
  readonly palette: Palette
  readonly load: Load
  /** Length of the longest arrow, in the scene's unit, with its scale. */
  readonly arrow: number
  /** How the block has moved, and how much that is magnified. */
  readonly moved: Displacement
  readonly magnification: number
}

/** Puts a point of the scene on the screen. */
export function projected({ frame, width, height }: Writing, point: Vector): [number, number] {
  const pixels = height / 2 / frame.half
  const from: Vector = [
    point[0] - frame.centre[0],
    point[1] - frame.centre[1],
    point[2] - frame.centre[2],
  ]
  return [
    width / 2 + pixels * dot(from, frame.look.right),
    height / 2 - pixels * dot(from, frame.look.up),
  ]
}

/** Writes the sheet afresh. */
export function write(to: CanvasRenderingContext2D, exhibit: Exhibit, writing: Writing): void {
  const { width, height, palette } = writing
  to.clearRect(0, 0, width, height)
  to.lineCap = 'round'
  numbers(to, exhibit, writing)
  axes(to, writing)
  const lines = [
    {
      value: writing.load.force,
      unit: exhibit.units.force,
      colour: palette.force,
      name: t('Force'),
    },
    {
      value: writing.load.couple,
      unit: exhibit.units.couple,
      colour: palette.couple,
      name: width < WIDE ? t('Couple') : t('Couple, as a pair of forces in its plane'),
    },
  ].filter((line) => line.value > 0)
  lines.forEach((line, index) => {
    const step = width < NARROW ? 18 : 22
    scale(
      to,
      writing,
      line,
      height - (width < NARROW ? 12 : 20) - step * (lines.length - 1 - index),
    )
  })
}

/** The cylinder numbers beyond the heads; those behind each other in one label. */
function numbers(to: CanvasRenderingContext2D, { scene, whirl }: Exhibit, writing: Writing): void {
  const labels: { x: number; y: number; near: number; names: number[] }[] = []
  for (const c of scene.cylinders) {
    const beyond = facesAnother(c, scene.cylinders) ? 0 : 0.22 * c.bore
    const rest = along(scene, c, c.bore_to + beyond)
    const point = displaced(whirl, writing.moved, writing.magnification, rest, [0, 0, 0])
    const [x, y] = projected(writing, point)
    const near = dot(point, writing.frame.look.back)
    const label = labels.find((other) => Math.hypot(other.x - x, other.y - y) < CLOSE)
    if (label) label.names.push(c.number)
    else labels.push({ x, y, near, names: [c.number] })
  }
  to.font = `600 12px ${FONT}`
  to.textAlign = 'center'
  to.textBaseline = 'middle'
  const taken: { x: number; y: number; half: number }[] = []
  for (const { x: beyond, y, names } of labels.sort((a, b) => b.near - a.near)) {
    const text = names.length > 4 ? `${names[0]} … ${names[names.length - 1]}` : names.join(' · ')
    const half = to.measureText(text).width / 2 + 2
    const x = Math.min(Math.max(beyond, half), writing.width - half)
    if (
      taken.some((label) => Math.abs(label.x - x) < label.half + half && Math.abs(label.y - y) < 13)
    )
      continue
    taken.push({ x, y, half })
    to.lineWidth = 3
    to.strokeStyle = writing.palette.paper
    to.strokeText(text, x, y)
    to.fillStyle = writing.palette.text
    to.fillText(text, x, y)
  }
}

/** The axes in the lower left corner; a dot points at the eye, a cross away. */
function axes(to: CanvasRenderingContext2D, { frame, height, width, palette }: Writing): void {
  const [x, y] = width < NARROW ? [66, height - 66] : [78, height - 50]
  to.strokeStyle = palette.quiet
  to.fillStyle = palette.quiet
  to.font = `11px ${FONT}`
  to.lineWidth = 1.4
  for (const { along, name } of AXES) {
    const [right, up] = [dot(along, frame.look.right), dot(along, frame.look.up)]
    const long = Math.hypot(right, up)
    if (long < 0.12) {
      end(to, x, y, dot(along, frame.look.back) > 0)
      to.textAlign = 'right'
      to.textBaseline = 'top'
      to.fillText(t(name), x - 7, y + 6)
      continue
    }
    const [tipX, tipY] = [x + AXIS * right, y - AXIS * up]
    line(to, x, y, tipX, tipY)
    to.textAlign = right > 0.3 * long ? 'left' : right < -0.3 * long ? 'right' : 'center'
    to.textBaseline = up > 0.5 * long ? 'bottom' : up < -0.5 * long ? 'top' : 'middle'
    to.fillText(t(name), tipX + (6 * right) / long, tipY - (6 * up) / long)
  }
}

function end(to: CanvasRenderingContext2D, x: number, y: number, towardsEye: boolean): void {
  to.beginPath()
  to.arc(x, y, 5, 0, 2 * Math.PI)
  to.stroke()
  if (towardsEye) {
    to.beginPath()
    to.arc(x, y, 1.8, 0, 2 * Math.PI)
    to.fill()
  } else {
    for (const side of [-1, 1]) line(to, x - 3.5, y - 3.5 * side, x + 3.5, y + 3.5 * side)
  }
}

function line(to: CanvasRenderingContext2D, x: number, y: number, toX: number, toY: number): void {
  to.beginPath()
  to.moveTo(x, y)
  to.lineTo(toX, toY)
  to.stroke()
}

/** An arrow of a round value beside what it is. */
function scale(
  to: CanvasRenderingContext2D,
  { arrow, frame, height, width, palette }: Writing,
  { value, unit, colour, name }: { value: number; unit: string; colour: number; name: string },
  y: number,
): void {
  const perPixel = value / ((arrow * height) / 2 / frame.half)
  const round = roundValue(perPixel * Math.min(96, width / 5))
  const long = round / perPixel
  to.font = `12px ${FONT}`
  const text = `${quantity(round, unit)}  ${name}`
  const right = width - long - 12 - to.measureText(text).width
  const x = width < NARROW ? 12 : Math.max(4, Math.min(width < WIDE ? 150 : 166, right))
  to.strokeStyle = to.fillStyle = css(colour)
  to.lineWidth = 3
  line(to, x, y, x + long - 6, y)
  to.beginPath()
  to.moveTo(x + long, y)
  to.lineTo(x + long - 9, y - 5)
  to.lineTo(x + long - 9, y + 5)
  to.fill()
  to.fillStyle = palette.text
  to.textAlign = 'left'
  to.textBaseline = 'middle'
  to.fillText(text, x + long + 8, y)
}

/** The greatest of 1, 2, 5, 10, ... that is not above a value. */
export function roundValue(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value))
  const step = value / power
  return power * (step >= 5 ? 5 : step >= 2 ? 2 : 1)
}

/** A round value with its unit, in thousands where SI has a letter for them. */
export function quantity(value: number, unit: string): string {
  const si = unit === 'N' || unit.startsWith('N')
  if (si && value >= 1e6) return `${+(value / 1e6).toPrecision(3)} M${unit}`
  if (si && value >= 1e3) return `${+(value / 1e3).toPrecision(3)} k${unit}`
  if (si && value < 1e-2) return `${+(value * 1e3).toPrecision(3)} m${unit}`
  return `${+value.toPrecision(3)} ${unit}`
}
