import type { Exhibit } from '../exhibit'
import {
  type Coefficients,
  coefficientsOf,
  type Phase,
  type Plane,
  phaseOf,
  signalAt,
  signalOf,
  turn,
  vectorAt,
} from '../phasor'
import type { Vector } from './vector'

/**
 * The small motion of the rigid engine at an instant: the centre goes by `up`, `right` and, on its
 * mounts, `along`; the axis by
 * `tiltUp`, `tiltRight` more for each unit of z in front of the centre; the block turns clockwise
 * by `turn` (radians).
 */
export interface Displacement {
  up: number
  right: number
  along: number
  tiltUp: number
  tiltRight: number
  turn: number
}

/** Nothing moves. */
export const REST_AT: Readonly<Displacement> = {
  ...{ up: 0, right: 0, along: 0 },
  ...{ tiltUp: 0, tiltRight: 0, turn: 0 },
}

/** Steps of a drawn path for each turn of the first shaft. */
const STEPS = 120

export class Whirling {
  readonly #exhibit: Exhibit
  readonly #shift: Coefficients
  readonly #tilt: Coefficients
  readonly #turn: Coefficients
  readonly #phase: Phase
  readonly #place: Plane = [0, 0]
  readonly #now: Displacement = { ...REST_AT }
  /** Places of the two ends of the first shaft along z, front first. */
  readonly ends: readonly [number, number]

  constructor(exhibit: Exhibit) {
    const { whirl, scene } = exhibit
    this.#exhibit = exhibit
    this.#shift = coefficientsOf(whirl.shift)
    this.#tilt = coefficientsOf(whirl.tilt)
    this.#turn = signalOf(whirl.turn)
    this.#phase = phaseOf(exhibit.orders.length, exhibit.sense)
    const shaft = scene.shafts[0]
    this.ends = shaft
      ? [Math.max(shaft.z_from, shaft.z_to), Math.min(shaft.z_from, shaft.z_to)]
      : [scene.high[2], scene.low[2]]
  }

  /** The displacement at a crank angle, of the chosen orders (null: all). Reuses its record. */
  at(theta: number, chosen: readonly number[] | null): Displacement {
    const now = this.#now
    turn(this.#phase, this.#exhibit.orders, theta, chosen)
    vectorAt(this.#shift, this.#phase, this.#place)
    now.up = this.#place[0]
    now.right = this.#place[1]
    vectorAt(this.#tilt, this.#phase, this.#place)
    now.tiltUp = this.#place[0]
    now.tiltRight = this.#place[1]
    now.turn = signalAt(this.#turn, this.#phase)
    return now
  }

  /** Writes where the crank axis at z has gone, [up, right] from where it stands at rest. */
  axis(moved: Displacement, z: number, out: Plane): Plane {
    const { whirl, scene } = this.#exhibit
    const shaft = scene.shafts[0]
    const up = (shaft?.up ?? 0) - whirl.centre[0]
    const right = (shaft?.right ?? 0) - whirl.centre[1]
    const along = z - whirl.centre[2]
    // A clockwise turn moves what is above the centre to the right, and what is at its right down.
    out[0] = moved.up + moved.tiltUp * along - moved.turn * right
    out[1] = moved.right + moved.tiltRight * along + moved.turn * up
    return out
  }

  /** The closed path of the crank axis at z over a whole cycle, [up, right]. */
  path(z: number, chosen: readonly number[] | null): [number, number][] {
    const turns = Math.max(1, this.#exhibit.turns)
    return Array.from({ length: STEPS * turns + 1 }, (_, step): Plane => {
      return this.axis(this.at((step / STEPS) * 2 * Math.PI, chosen), z, [0, 0])
    })
  }
}

/**
 * The rotation vector (x, y, z) of a displacement. Tilting the front up is a turn about the axis to
 * the right, backwards; tilting it to the right is a turn about the vertical; clockwise is
 * backwards about z.
 */
export function rotation(
  moved: Readonly<Displacement>,
  magnification: number,
): [number, number, number] {
  return [
    -moved.tiltUp * magnification,
    moved.tiltRight * magnification,
    -moved.turn * magnification,
  ]
}

/**
 * Where a point of the block (x, y, z) is drawn: a true rotation about the centre of mass by the
 * small angles times the magnification, and the shift. Written into `out`.
 */
export function displaced(
  { centre: [cy, cx, cz] }: { readonly centre: readonly [number, number, number] },
  moved: Readonly<Displacement>,
  magnification: number,
  [x, y, z]: Vector,
  out: [number, number, number],
): [number, number, number] {
  const [wx, wy, wz] = rotation(moved, magnification)
  const angle = Math.hypot(wx, wy, wz)
  const [rx, ry, rz] = [x - cx, y - cy, z - cz]
  // Rodrigues' formula with sin(a)/a and (1 - cos(a))/a^2, which have limits where nothing turns.
  const first = angle > 1e-9 ? Math.sin(angle) / angle : 1
  const second = angle > 1e-9 ? (1 - Math.cos(angle)) / angle ** 2 : 0.5
  const along = second * (wx * rx + wy * ry + wz * rz)
  const cosine = Math.cos(angle)
  out[0] = cx + rx * cosine + first * (wy * rz - wz * ry) + along * wx + moved.right * magnification
  out[1] = cy + ry * cosine + first * (wz * rx - wx * rz) + along * wy + moved.up * magnification
  out[2] = cz + rz * cosine + first * (wx * ry - wy * rx) + along * wz + moved.along * magnification
  return out
}

/** A path that is shorter than this share of the engine's size is none. */
export const REST = 1e-7
