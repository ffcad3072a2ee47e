import { type Frame, frameOf, type Looks, lookOf } from './cameras'
import { type Disc, reach } from './extent'
import type { Camera } from './stage'
import { dot, type Vector } from './vector'

/** A view of the engine and its place on the stage, pixels from the upper left corner. */
export interface Pane {
  readonly camera: Camera
  readonly x: number
  readonly y: number
  readonly width: number
  readonly height: number
  readonly frame: Frame
}

/** Between the panes of a sheet, and above what each shows for its name, pixels. */
const GAP = 14
const HEAD = 20
/** Shares of breadth and height that the pictorial view has at least. */
const PICTORIAL = [0.36, 0.4] as const

/**
 * The views of a drawing sheet in third-angle projection: the front at the left of the side view,
 * which is seen from the right, the plan above that, and in the free corner the engine as it
 * stands. Front, side and plan have one scale, and what belongs together stands in line.
 */
export function sheetOf(
  looks: Looks,
  rooms: readonly (readonly Disc[])[],
  { width, height, foot, margin }: { width: number; height: number; foot: number; margin: number },
): readonly Pane[] {
  const spans = [0, 1, 2].map((axis) => spanOf(rooms, axis, margin)) as unknown as Span[]
  const [x, y, z] = spans as [Span, Span, Span]
  const across = width - GAP
  const upward = height - foot - GAP - 2 * HEAD
  const [corner, top] = [PICTORIAL[0] * across, PICTORIAL[1] * upward]
  const scale = Math.min(
    across / (x.long + z.long),
    (across - corner) / z.long,
    upward / (x.long + y.long),
    (upward - top) / y.long,
  )
  const right = shared(across, z.long * scale, Math.max(corner, x.long * scale))
  const lower = shared(upward, y.long * scale, Math.max(top, x.long * scale))
  const columns = [
    { x: 0, width: across - right },
    { x: width - right, width: right },
  ] as const
  const rows = [
    { y: HEAD, height: upward - lower },
    { y: height - foot - lower, height: lower },
  ] as const
  const centre: Vector = [x.middle, y.middle, z.middle]
  const flat = (camera: Camera, column: 0 | 1, row: 0 | 1): Pane => {
    const place = { ...columns[column], ...rows[row] }
    const frame = { look: lookOf(camera, looks), centre, half: place.height / 2 / scale }
    return { camera, ...place, frame }
  }
  const free = { ...columns[0], ...rows[0] }
  const screen = { aspect: free.width / free.height, foot: 0, margin }
  return [
    { camera: 'isometric', ...free, frame: frameOf('isometric', looks, rooms, screen) },
    flat('plan', 1, 0),
    flat('front', 0, 1),
    flat('side', 1, 1),
  ]
}

/** What an engine covers of an axis: the middle, and the length, that of the longest engine. */
interface Span {
  readonly middle: number
  readonly long: number
}

function spanOf(rooms: readonly (readonly Disc[])[], axis: number, margin: number): Span {
  const along = [0, 1, 2].map((index) => (index === axis ? 1 : 0)) as unknown as Vector
  const ends = rooms.map((discs) => reach(discs, along, [0, 0]))
  const [low, high] = ends[0] ?? [-1, 1]
  const long = margin * Math.max(...ends.map(([from, to]) => to - from))
  return { middle: (low + high) / 2, long }
}

/** The part of a length for one of two that need `own` and `other`; what is left is shared. */
function shared(length: number, own: number, other: number): number {
  return own + Math.max(0, length - own - other) / 2
}

/** Pixels to one unit of length in a pane. */
export function pixelsOf({ frame, height }: Pane): number {
  return height / 2 / frame.half
}

/** Puts a point (x, y, z) on the stage: x, y, and how near it is to the eye. */
export function placed(pane: Pane, point: Vector): Vector {
  const { look, centre } = pane.frame
  const from: Vector = [point[0] - centre[0], point[1] - centre[1], point[2] - centre[2]]
  const pixels = pixelsOf(pane)
  return [
    pane.x + pane.width / 2 + pixels * dot(from, look.right),
    pane.y + pane.height / 2 - pixels * dot(from, look.up),
    dot(from, look.back),
  ]
}
