import { type Disc, reach } from './extent'
import type { Camera } from './stage'
import type { Vector } from './vector'

/** The unit vectors `right` and `up` of the screen, and `back` from the engine to the eye. */
export interface Look {
  readonly right: Vector
  readonly up: Vector
  readonly back: Vector
}

/** A look, its middle, and half of the visible height, before zooming. */
export interface Frame {
  readonly look: Look
  readonly centre: Vector
  readonly half: number
}

/** A free look: angles from the front to the right and above the horizon, zoom and shift. */
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
  /** Share of the height, at the lower edge, that is kept for labels. */
  readonly foot: number
  /** How much larger than the engine the picture is. */
  readonly margin: number
}

/**
 * The looks of the drawing. Plan and side view have the front of the engine at the left, so that
 * they stand under each other
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
  return {
    right: [cos, 0, -sin],
    up: [-rise * sin, level, -rise * cos],
    back: [level * sin, rise, level * cos],
  }
}

/**
 * What a camera sees on a screen. Each room is what discs fill; the first is looked at, and all of
 * them would fit in, so that engines side by side are drawn to one scale.
 */
export function frameOf(
  camera: Camera,
  orbit: Readonly<Orbit>,
  rooms: readonly (readonly Disc[])[],
  { aspect, foot, margin }: Screen,
): Frame {
  const look = lookOf(camera, orbit)
  const extents = rooms.map((discs) => (camera === 'orbit' ? ball(discs) : box(look, discs)))
  const halves = extents.map(({ wide, tall }) => Math.max(tall / (1 - foot), wide / aspect))
  const half = margin * Math.max(...halves)
  const middle = extents[0]?.middle ?? [0, 0, 0]
  return { look, centre: sum(middle, look.up, -half * foot), half }
}

/** The middle of things, and how far they reach from it to either side and up and down. */
interface Extent {
  readonly middle: Vector
  readonly wide: number
  readonly tall: number
}

function box({ right, up, back }: Look, discs: readonly Disc[]): Extent {
  let middle: Vector = [0, 0, 0]
  const [wide = 0, tall = 0] = [right, up, back].map((axis) => {
    const [low, high] = reach(discs, axis, [0, 0])
    middle = sum(middle, axis, (low + high) / 2)
    return (high - low) / 2
  })
  return { middle, wide, tall }
}

/** A free look keeps its middle and its size while it turns: those of a ball round everything. */
function ball(discs: readonly Disc[]): Extent {
  const { middle } = box({ right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] }, discs)
  const radii = discs.map(({ centre, radius }) => Math.hypot(...sum(centre, middle, -1), radius))
  const radius = FILLED * Math.max(...radii)
  return { middle, wide: radius, tall: radius }
}

function sum(a: Vector, b: Vector, factor: number): Vector {
  return [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]]
}

/** A frame at a `share` from 0 to 1 of the way: the look turns, the rest slides. */
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
