import { type Disc, reach } from './extent'
import type { Camera } from './stage'

/** A point or direction of the drawing: x to the right, y up, z to the front of the engine. */
export type Vector = readonly [number, number, number]

/** How one looks at the engine: unit vectors of the screen (`right`, `up`) and `back` from the engine to the eye. */
export interface Look {
  readonly right: Vector
  readonly up: Vector
  readonly back: Vector
}

/** A look, what it looks at, and half of what is seen of it upward, before zooming. */
export interface Frame {
  readonly look: Look
  readonly centre: Vector
  readonly half: number
}

/** A free look: angle round the vertical from the front to the right, angle above the horizon, radians; zoom and shift. */
export interface Orbit {
  azimuth: number
  elevation: number
  zoom: number
  /** Shift of the picture, in halves of the stage's height. */
  x: number
  y: number
}

const ISOMETRIC = { azimuth: Math.PI / 4, elevation: Math.atan(Math.SQRT1_2) }
export const HOME: Readonly<Orbit> = { azimuth: 0.6, elevation: 0.42, zoom: 1, x: 0, y: 0 }

/** Share of the ball round an engine that it fills from where one mostly looks. */
const FILLED = 0.92

/** What the picture is fitted into. */
export interface Screen {
  /** Width over height. */
  readonly aspect: number
  /** Share of the height, at the lower edge, that is kept for what is written there. */
  readonly foot: number
  /** How much larger than the engine the picture is. */
  readonly margin: number
}

/**
 * The looks of the drawing. Plan and side view have the front of the engine at the left, so that they stand under each other
 * as on a drawing sheet: the plan is seen from above, the side from the right.
 */
export function lookOf(camera: Camera, orbit: Readonly<Orbit>): Look {
  if (camera === 'front') return { right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] }
  if (camera === 'plan') return { right: [0, 0, -1], up: [-1, 0, 0], back: [0, 1, 0] }
  if (camera === 'side') return { right: [0, 0, -1], up: [0, 1, 0], back: [1, 0, 0] }
  return upright(camera === 'isometric' ? ISOMETRIC : orbit)
}

/** The look from an azimuth and an elevation, the vertical upright. */
function upright({ azimuth, elevation }: { azimuth: number; elevation: number }): Look {
  const [sin, cos] = [Math.sin(azimuth), Math.cos(azimuth)]
  const [rise, level] = [Math.sin(elevation), Math.cos(elevation)]
  return { right: [cos, 0, -sin], up: [-rise * sin, level, -rise * cos], back: [level * sin, rise, level * cos] }
}

export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/** What a camera sees of things that fill these discs, on a screen. */
export function frameOf(camera: Camera, orbit: Readonly<Orbit>, discs: readonly Disc[], screen: Screen): Frame {
  const look = lookOf(camera, orbit)
  const spans = [look.right, look.up, look.back].map((axis) => reach(discs, axis, [0, 0]))
  const [wide, tall, deep] = spans as [Span, Span, Span]
  const middle = ([low, high]: Span) => (low + high) / 2
  const at = (index: 0 | 1 | 2) =>
    middle(wide) * look.right[index] + middle(tall) * look.up[index] + middle(deep) * look.back[index]
  if (camera === 'orbit') return around(look, discs, screen)
  return raised(look, [at(0), at(1), at(2)], (wide[1] - wide[0]) / 2, (tall[1] - tall[0]) / 2, screen)
}

/** A free look keeps its middle and its size while it turns: those of a ball round everything. */
function around(look: Look, discs: readonly Disc[], screen: Screen): Frame {
  const span = (axis: Vector) => reach(discs, axis, [0, 0])
  const spans = [span([1, 0, 0]), span([0, 1, 0]), span([0, 0, 1])]
  const centre = spans.map(([low, high]) => (low + high) / 2) as unknown as Vector
  const ball = Math.max(
    ...discs.map((disc) => Math.hypot(...disc.centre.map((at, i) => at - (centre[i] as number)), disc.radius)),
  )
  return raised(look, centre, FILLED * ball, FILLED * ball, screen)
}

/** The frame in which so much to either side and up and down fits between the screen's top and its foot. */
function raised(look: Look, middle: Vector, wide: number, tall: number, { aspect, foot, margin }: Screen): Frame {
  const half = margin * Math.max(tall / (1 - foot), wide / aspect)
  const down = half * foot
  const centre = middle.map((at, index) => at - down * (look.up[index] as number)) as unknown as Vector
  return { look, centre, half }
}

type Span = [number, number]

/** A frame part of the way from one to another, `share` from 0 to 1: the look turns, the rest slides. */
export function between(from: Frame, to: Frame, share: number): Frame {
  const mixed = (a: Vector, b: Vector): Vector => [
    a[0] + (b[0] - a[0]) * share,
    a[1] + (b[1] - a[1]) * share,
    a[2] + (b[2] - a[2]) * share,
  ]
  return {
    look: lookOfTurn(slerp(turnOf(from.look), turnOf(to.look), share)),
    centre: mixed(from.centre, to.centre),
    half: from.half * (to.half / from.half) ** share,
  }
}

type Quaternion = readonly [number, number, number, number]

/** The rotation that takes the axes to a look, as a quaternion (x, y, z, w). */
export function turnOf({ right, up, back }: Look): Quaternion {
  // The greatest of the four squares is taken first, so that nothing small is divided by.
  const trace = right[0] + up[1] + back[2]
  if (trace > 0) {
    const s = 2 * Math.sqrt(trace + 1)
    return [(up[2] - back[1]) / s, (back[0] - right[2]) / s, (right[1] - up[0]) / s, s / 4]
  }
  if (right[0] > up[1] && right[0] > back[2]) {
    const s = 2 * Math.sqrt(1 + right[0] - up[1] - back[2])
    return [s / 4, (up[0] + right[1]) / s, (back[0] + right[2]) / s, (up[2] - back[1]) / s]
  }
  if (up[1] > back[2]) {
    const s = 2 * Math.sqrt(1 + up[1] - right[0] - back[2])
    return [(up[0] + right[1]) / s, s / 4, (back[1] + up[2]) / s, (back[0] - right[2]) / s]
  }
  const s = 2 * Math.sqrt(1 + back[2] - right[0] - up[1])
  return [(back[0] + right[2]) / s, (back[1] + up[2]) / s, s / 4, (right[1] - up[0]) / s]
}

function lookOfTurn([x, y, z, w]: Quaternion): Look {
  return {
    right: [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
    up: [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
    back: [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
  }
}

function slerp(a: Quaternion, b: Quaternion, share: number): Quaternion {
  const cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
  const angle = Math.acos(Math.min(1, Math.abs(cosine)))
  const near = angle < 1e-6
  const first = near ? 1 - share : Math.sin((1 - share) * angle) / Math.sin(angle)
  const second = (near ? share : Math.sin(share * angle) / Math.sin(angle)) * (cosine < 0 ? -1 : 1)
  const sum = [0, 1, 2, 3].map((i) => first * (a[i] as number) + second * (b[i] as number))
  const length = Math.hypot(...sum)
  return sum.map((value) => value / length) as unknown as Quaternion
}
