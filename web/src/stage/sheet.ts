import type { Exhibit } from '../exhibit'
import { message, t } from '../language/messages'
import { along, facesAnother } from './extent'
import { css } from './palette'
import type { Instant } from './picture'
import { dot, type Vector } from './vector'
import { displaced } from './whirl'

const FONT = 'system-ui, sans-serif'
/** Labels nearer to each other than this are written as one, pixels. */
const CLOSE = 15
/** Below this width, pixels, the scales of arrows go beneath the axes. */
const NARROW = 300
/** From this width on there is room for a sentence beside an arrow, pixels. */
const WIDE = 560
const AXES = [
  { along: [1, 0, 0], name: message('x right') },
  { along: [0, 1, 0], name: message('y up') },
  { along: [0, 0, 1], name: message('z front') },
] as const satisfies readonly { along: Vector; name: string }[]

/** An instant on a screen of so many pixels. */
export interface Writing extends Instant {
  readonly width: number
  readonly height: number
}

/** Puts a point (x, y, z) of the block on the screen: x, y, and how near it is to the eye. */
export function projected(
  { frame, width, height, moved, view }: Omit<Writing, 'places'>,
  { whirl }: Exhibit,
  point: Vector,
): Vector {
  const { look, centre, half } = frame
  const at = displaced(whirl, moved, view.whirl.magnification, point, [0, 0, 0])
  const from: Vector = [at[0] - centre[0], at[1] - centre[1], at[2] - centre[2]]
  const pixels = height / 2 / half
  return [
    width / 2 + pixels * dot(from, look.right),
    height / 2 - pixels * dot(from, look.up),
    dot(from, look.back),
  ]
}

/** Kept at the lower edge for axes and scales: pixels, and at most a share of the height. */
export function footOf(width: number, height: number): number {
  return width < NARROW ? Math.min(0.4, 98 / height) : Math.min(0.25, 58 / height)
}

/** Writes the labels of the drawing: cylinder numbers, axes, scales of the arrows. */
export function write(to: CanvasRenderingContext2D, exhibit: Exhibit, writing: Writing): void {
  const { width, height, palette } = writing
  to.clearRect(0, 0, width, height)
  to.lineCap = 'round'
  numbers(to, exhibit, writing)
  axes(to, writing)
  const couple = width < WIDE ? t('Couple') : t('Couple, as a pair of forces in its plane')
  const names = { force: t('Force'), couple }
  const [foot, step] = width < NARROW ? [12, 18] : [20, 22]
  const kinds = (['couple', 'force'] as const).filter((kind) => writing.load[kind] > 0)
  kinds.forEach((kind, above) => {
    const { units } = exhibit
    const factor = kind === 'force' ? units.force_factor : units.couple_factor
    const value = writing.load[kind] * factor
    const line = { value, unit: units[kind], colour: palette[kind], name: names[kind] }
    scale(to, writing, line, height - foot - step * above)
  })
}

/** The cylinder numbers beyond the heads; those behind each other in one label. */
function numbers(to: CanvasRenderingContext2D, exhibit: Exhibit, writing: Writing): void {
  const { scene } = exhibit
  const labels: { x: number; y: number; near: number; names: number[] }[] = []
  for (const c of scene.cylinders) {
    const beyond = facesAnother(c, scene.cylinders) ? 0 : 0.22 * c.bore
    const [x, y, near] = projected(writing, exhibit, along(scene, c, c.bore_to + beyond))
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

/** How far from the left the axes stand, so that there is room for their names. */
function axesAt(to: CanvasRenderingContext2D, width: number): number {
  to.font = `11px ${FONT}`
  const names = AXES.map(({ name }) => to.measureText(t(name)).width)
  return (width < NARROW ? 28 : 40) + Math.max(...names)
}

/** The axes in the lower left corner; a dot points at the eye, a cross away. */
function axes(to: CanvasRenderingContext2D, { frame, height, width, palette }: Writing): void {
  const [x, y] = [axesAt(to, width), height - (width < NARROW ? 58 : 50)]
  const length = width < NARROW ? 22 : 30
  to.strokeStyle = palette.quiet
  to.fillStyle = palette.quiet
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
    const [tipX, tipY] = [x + length * right, y - length * up]
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
  const beside = 2 * axesAt(to, width) + (width < WIDE ? -6 : 10)
  to.font = `12px ${FONT}`
  const text = `${quantity(round, unit)}  ${name}`
  const right = width - long - 12 - to.measureText(text).width
  const x = width < NARROW ? 12 : Math.max(4, Math.min(beside, right))
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

/** A round value with its unit. */
export function quantity(value: number, unit: string): string {
  return `${+value.toPrecision(3)} ${unit}`
}
