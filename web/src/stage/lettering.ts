import type { Exhibit } from '../exhibit'
import { message, t } from '../language/messages'
import type { Plane } from '../phasor'
import { along, facesAnother } from './extent'
import { heat } from './heat'
import { ROLL } from './load'
import { FORCES } from './mounts'
import { css, type Palette } from './palette'
import { type Pane, pixelsOf, placed } from './panes'
import type { Pen } from './pen'
import type { Instant } from './picture'
import { quantity, roundValue } from './round'
import type { Slice } from './section'
import type { Camera } from './stage'
import { dot, type Vector } from './vector'
import { displaced } from './whirl'

const FONT = 'system-ui, sans-serif'
/** Labels nearer to each other than this are written as one, pixels. */
const CLOSE = 15
/** Least from a head to the middle of its number, pixels. */
const CLEAR = 13
/** From a label to the edge of its pane, pixels; an engine beside begins there. */
const RIM = 6
/** Below this width, pixels, the scales of arrows go beneath the axes. */
const NARROW = 300
/** From these widths on there is room for a sentence beside an arrow, pixels: a sheet has its axes
 * at the right. */
const WIDE = 560
const WIDE_SHEET = 720
const AXES = [
  { along: [1, 0, 0], name: message('x right') },
  { along: [0, 1, 0], name: message('y up') },
  { along: [0, 0, 1], name: message('z front') },
] as const satisfies readonly { along: Vector; name: string }[]

/** An instant on a stage of so many pixels. */
export interface Writing extends Instant {
  readonly width: number
  readonly height: number
}

/** Puts a point (x, y, z) of the block on the stage: x, y, and how near it is to the eye. */
export function projected(
  { moved, magnification }: Pick<Instant, 'moved' | 'magnification'>,
  pane: Pane,
  { whirl }: Exhibit,
  point: Vector,
): Vector {
  return placed(pane, displaced(whirl, moved, magnification, point, [0, 0, 0]))
}

/** Kept at the lower edge for axes and two lines of scales, or a third; at most a share of the height. */
export function footOf(width: number, height: number, third = false): number {
  if (width < NARROW) return Math.min(0.43, 112 / height)
  return Math.min(0.25, (third && width >= WIDE ? 80 : 58) / height)
}

/** Writes the labels of the drawing: names of views, cylinder numbers, axes, scales of arrows. */
export function write(to: Pen, exhibit: Exhibit, writing: Writing): void {
  const { width, height, palette, panes, slice, view } = writing
  to.clearRect(0, 0, width, height)
  to.lineCap = 'round'
  const sheet = panes.length > 1
  for (const pane of panes) {
    numbers(to, exhibit, writing, pane)
    if (sheet || slice) named(to, writing, pane, sheet)
    if (slice && pane.camera !== 'front' && sheet) cutting(to, exhibit, writing, pane, slice)
  }
  const [first] = panes
  if (!first) return
  if (writing.twisted)
    heat(to, exhibit, writing.twisted.twist, { ...writing, small: width < WIDE, rim: RIM })
  const corner = { x: axesAt(to, width), y: 0 }
  corner.y = height - (width < NARROW ? 48 + below(first) : 50)
  axes(to, writing, first, sheet ? { x: width - 84 - axesAt(to, width), y: height - 31 } : corner)
  if (sheet) thirdAngle(to, palette, width - 62, height - 24)
  const couple =
    width < (sheet ? WIDE_SHEET : WIDE)
      ? t('Couple')
      : view.arrows.axes
        ? t('Couple, as pitch (upright) and yaw (level)')
        : t('Couple, as a pair of forces in its plane')
  const names = { force: t('Force'), couple }
  const kinds = (['couple', 'force'] as const).filter((kind) => writing.load[kind] > 0)
  // where no words fit beside the force, the roll has the third line of the foot
  const third = writing.load.roll > 0 && width >= NARROW && width < WIDE && kinds.length > 1
  const [foot, step] = width < NARROW || third ? [12, 18] : [20, 22]
  const pixels = pixelsOf(panes[panes.length - 1] ?? first)
  const beside = sheet ? 12 : 2 * axesAt(to, width) + (width < WIDE ? 4 : 10)
  let end = 0
  kinds.forEach((kind, above) => {
    const { units } = exhibit
    const factor = kind === 'force' ? units.force_factor : units.couple_factor
    const value = writing.load[kind] * factor
    const line = { value, unit: units[kind], colour: palette[kind], name: names[kind] }
    end = scale(to, writing, line, pixels, { x: beside, y: height - foot - step * above })
  })
  const shake = writing.mounted?.shake ?? null
  const printed = exhibit.mount_numbers
  if (shake && view.arrows.force && printed && shake.most > 0 && width >= NARROW) {
    const { factor, label: unit } = printed.force_unit
    const value = (shake.most * factor) / FORCES
    const line = {
      value,
      unit,
      colour: palette.reaction,
      name: shake.free
        ? t('Force of a mount at 1 mm')
        : t('Force of a mount at {rpm} rpm', { rpm: Math.round(shake.rpm) }),
    }
    // where there is little room, above the engine and below what is written there
    const small = width < WIDE && !sheet
    const head = 14 + (slice ? 20 : 0) + (writing.twisted ? 20 : 0)
    const y = small ? head : height - foot - step * kinds.length
    // beside it the paths of the whirl stand: its name on a line of its own
    if (small) {
      scale(to, writing, { ...line, name: '' }, pixels, { x: 12, y })
      to.fillText(line.name, 12, y + 16)
    } else scale(to, writing, line, pixels, { x: beside, y })
  }
  if (writing.load.roll > 0 && width >= NARROW) {
    // beside the force, whose words are few; a couple alone leaves the line above
    const after = kinds.includes('force') && width >= WIDE
    const y = height - foot - step * (after ? kinds.length - 1 : kinds.length)
    roll(to, writing, exhibit, { x: after ? end + 24 : beside, y })
  }
}

const VIEWS = {
  front: message('Front'),
  plan: message('Plan'),
  side: message('Side, from the right'),
  isometric: message('Isometric, not to scale'),
  orbit: message('Orbit'),
} as const satisfies Record<Camera, string>

/** The name of a view at the head of its pane; a section says so. */
function named(to: Pen, { palette, slice }: Writing, { camera, x, y }: Pane, sheet: boolean): void {
  const cut = slice && camera === 'front'
  if (!cut && !sheet) return
  const which = slice?.cylinders.join(' · ')
  to.font = `12px ${FONT}`
  to.textAlign = 'left'
  to.textBaseline = 'top'
  to.fillStyle = cut ? palette.text : palette.quiet
  to.fillText(
    cut ? t('Section A–A: cylinders {numbers}', { numbers: which ?? '' }) : t(VIEWS[camera]),
    x + 12,
    sheet ? y - 14 : 8,
  )
}

/** Where the section is taken: a chain line, its ends thick, with the letter and the way it looks. */
function cutting(to: Pen, exhibit: Exhibit, writing: Writing, pane: Pane, slice: Slice): void {
  if (pane.camera === 'isometric') return
  const [across] = projected(writing, pane, exhibit, [0, 0, slice.to])
  const [top, bottom] = [pane.y + 4, pane.y + pane.height - 4]
  to.strokeStyle = to.fillStyle = writing.palette.text
  to.lineWidth = 1
  to.setLineDash([10, 3, 2, 3])
  line(to, across, top, across, bottom)
  to.setLineDash([])
  to.font = `600 12px ${FONT}`
  to.textAlign = 'right'
  to.textBaseline = 'middle'
  for (const [y, inward] of [
    [top, 1],
    [bottom, -1],
  ] as const) {
    to.lineWidth = 2.5
    line(to, across, y, across, y + 10 * inward)
    to.lineWidth = 1.4
    line(to, across - 12, y, across, y)
    to.beginPath()
    to.moveTo(across, y)
    to.lineTo(across - 6, y - 3)
    to.lineTo(across - 6, y + 3)
    to.fill()
    to.fillText('A', across - 15, y + 3 * inward)
  }
}

/** The symbol of third-angle projection after ISO 5456-2, about a point: circles, then the cone. */
function thirdAngle(to: Pen, palette: Palette, x: number, y: number): void {
  to.strokeStyle = palette.quiet
  to.lineWidth = 1.2
  for (const radius of [4, 8]) {
    to.beginPath()
    to.arc(x, y, radius, 0, 2 * Math.PI)
    to.stroke()
  }
  const [from, long] = [x + 18, 20]
  to.beginPath()
  to.moveTo(from, y - 4)
  to.lineTo(from + long, y - 8)
  to.lineTo(from + long, y + 8)
  to.lineTo(from, y + 4)
  to.closePath()
  to.stroke()
  to.setLineDash([6, 2, 1, 2])
  line(to, x - 12, y, x + 12, y)
  line(to, x, y - 12, x, y + 12)
  line(to, from - 3, y, from + long + 4, y)
  to.setLineDash([])
}

/** The cylinder numbers beyond the heads; those behind each other in one label. */
function numbers(to: Pen, exhibit: Exhibit, writing: Writing, pane: Pane): void {
  const { scene } = exhibit
  const only = pane.camera === 'front' ? writing.slice : null
  const pixels = pixelsOf(pane)
  const labels: { x: number; y: number; near: number; out: number; names: number[] }[] = []
  for (const c of scene.cylinders) {
    if (only && !only.cylinders.includes(c.number)) continue
    const facing = facesAnother(c, scene.cylinders)
    const place = (distance: number) => projected(writing, pane, exhibit, along(scene, c, distance))
    const head = place(c.bore_to)
    const [outX, outY] = outward(place(c.bore_from), head, pixels)
    const beyond = facing ? 0 : Math.max(0.22 * c.bore * pixels, CLEAR)
    const [x, y, near] = [head[0] + beyond * outX, head[1] + beyond * outY, head[2]]
    const label = labels.find((other) => Math.hypot(other.x - x, other.y - y) < CLOSE)
    if (label) label.names.push(c.number)
    else labels.push({ x, y, near, out: facing ? 0 : outX, names: [c.number] })
  }
  to.font = `600 12px ${FONT}`
  to.textAlign = 'center'
  to.textBaseline = 'middle'
  const taken: { x: number; y: number; half: number }[] = []
  for (const { x: middle, y: level, out, names } of labels.sort((a, b) => b.near - a.near)) {
    const all = names.join(' · ')
    // there is room for as much at the other side
    const long = 2 * (to.measureText(all).width + 2 * RIM) > pane.width
    const short = names.length > 4 || (long && names.length > 2)
    const text = short ? `${names[0]} … ${names[names.length - 1]}` : all
    const half = to.measureText(text).width / 2 + 2
    // a long text stands clear of the head too
    const beyond = middle + out * Math.max(0, half - CLEAR)
    const edge = half + RIM
    const x = Math.min(Math.max(beyond, pane.x + edge), pane.x + pane.width - edge)
    const y = Math.max(level, pane.y + RIM + 4)
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

/** How an axis runs on the screen; less the more it runs toward the eye. */
function outward(from: Vector, to: Vector, pixels: number): Plane {
  const [x, y] = [to[0] - from[0], to[1] - from[1]]
  const long = Math.hypot(x, y, pixels * (to[2] - from[2])) || 1
  return [x / long, y / long]
}

/** A place on the stage, pixels. */
interface Place {
  readonly x: number
  readonly y: number
}

/** How far from the left the axes stand, so that there is room for their names. */
function axesAt(to: Pen, width: number): number {
  to.font = `11px ${FONT}`
  const names = AXES.map(({ name }) => to.measureText(t(name)).width)
  return (width < NARROW ? 28 : 40) + Math.max(...names)
}

/** How far the axes and their names reach below their origin, pixels. */
function below({ frame: { look } }: Pane): number {
  const depths = AXES.map(({ along }) => {
    const [right, up] = [dot(along, look.right), dot(along, look.up)]
    const long = Math.hypot(right, up)
    return long < 0.12 ? 18 : -20 * up - (6 * up) / long + (up < -0.5 * long ? 12 : 6)
  })
  return Math.max(...depths)
}

/** The axes in the lower left corner; a dot points at the eye, a cross away. */
function axes(to: Pen, { width, palette, panes }: Writing, { frame }: Pane, { x, y }: Place): void {
  to.font = `11px ${FONT}`
  const length = width < NARROW || panes.length > 1 ? 20 : 30
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

function end(to: Pen, x: number, y: number, towardsEye: boolean): void {
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

function line(to: Pen, x: number, y: number, toX: number, toY: number): void {
  to.beginPath()
  to.moveTo(x, y)
  to.lineTo(toX, toY)
  to.stroke()
}

/** An arrow of a round value beside what it is. */
function scale(
  to: Pen,
  { arrow, width, palette }: Writing,
  { value, unit, colour, name }: { value: number; unit: string; colour: number; name: string },
  pixels: number,
  { x: beside, y }: Place,
): number {
  const perPixel = value / (arrow * pixels)
  const round = roundValue(perPixel * Math.min(96, width / 5))
  const long = round / perPixel
  to.font = `12px ${FONT}`
  const full = `${quantity(round, unit)}  ${name}`
  const room = (text: string): number => width - long - 12 - to.measureText(text).width
  // a name that would push the arrow over the axes is left out; the unit tells a force from a couple
  const text = width < NARROW || room(full) >= beside ? full : quantity(round, unit)
  const right = room(text)
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
  return x + long + 8 + to.measureText(text).width
}

/** How far a curved arrow of a round moment bends. */
function roll(
  to: Pen,
  { load, palette, width }: Writing,
  { units }: Exhibit,
  { x, y }: Place,
): void {
  const most = load.roll * units.roll_factor
  const value = roundValue(most)
  const [from, end] = [-Math.PI / 2, -Math.PI / 2 + (ROLL.angle * value) / most]
  const [middle, level, radius] = width < WIDE ? [x + 6, y + 2, 7] : [x + 8, y + 3, 9]
  to.strokeStyle = to.fillStyle = css(palette.roll)
  to.lineWidth = 2.5
  to.beginPath()
  to.arc(middle, level, radius, from, end)
  to.stroke()
  const tip = (out: number, on: number): [number, number] => [
    middle + out * Math.cos(end) - on * Math.sin(end),
    level + out * Math.sin(end) + on * Math.cos(end),
  ]
  to.beginPath()
  to.moveTo(...tip(radius - 4, 0))
  to.lineTo(...tip(radius, 7))
  to.lineTo(...tip(radius + 4, 0))
  to.fill()
  to.font = `12px ${FONT}`
  to.fillStyle = palette.text
  to.textAlign = 'left'
  to.textBaseline = 'middle'
  const name = t('Roll')
  to.fillText(`${quantity(value, units.roll)}  ${name}`, x + 26, y)
}
