import { Matrix4, Quaternion, Vector3 } from 'three'
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

export const HOME: Readonly<Orbit> = { azimuth: 0.6, elevation: 0.42, zoom: 1, x: 0, y: 0 }

/** What looks depend on: how the free one stands, and the azimuth of the isometric one. */
export interface Looks {
  readonly orbit: Readonly<Orbit>
  readonly azimuth: number
}

/** Elevation of an isometric view: at an azimuth of 45 degrees its axes are foreshortened alike. */
export const ISOMETRIC = Math.atan(Math.SQRT1_2)

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
 * they stand under each other as on a drawing sheet: the plan is seen from above, the side from the
 * right.
 */
export function lookOf(camera: Camera, { orbit, azimuth }: Looks): Look {
  if (camera === 'front') return { right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] }
  if (camera === 'plan') return { right: [0, 0, -1], up: [-1, 0, 0], back: [0, 1, 0] }
  if (camera === 'side') return { right: [0, 0, -1], up: [0, 1, 0], back: [1, 0, 0] }
  if (camera === 'isometric') return upright(azimuth, ISOMETRIC)
  return upright(orbit.azimuth, orbit.elevation)
}

/** The look from an azimuth and an elevation, the vertical upright. */
export function upright(azimuth: number, elevation: number): Look {
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
  looks: Looks,
  rooms: readonly (readonly Disc[])[],
  { aspect, foot, margin }: Screen,
): Frame {
  const look = lookOf(camera, looks)
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
  const turn = turnOf(from.look).slerp(turnOf(to.look), share)
  const axis = (x: number, y: number, z: number): Vector =>
    new Vector3(x, y, z).applyQuaternion(turn).toArray()
  return {
    look: { right: axis(1, 0, 0), up: axis(0, 1, 0), back: axis(0, 0, 1) },
    centre: new Vector3(...from.centre).lerp(new Vector3(...to.centre), share).toArray(),
    half: from.half * (to.half / from.half) ** share,
  }
}

/** The rotation that takes the axes to a look. */
function turnOf({ right, up, back }: Look): Quaternion {
  const [x, y, z] = [new Vector3(...right), new Vector3(...up), new Vector3(...back)]
  return new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(x, y, z))
}
