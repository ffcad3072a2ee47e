import type { Exhibit, MountShown, Mounts } from '../exhibit'
import { type Shake, SIX } from '../mounts'
import { type Coefficients, type Phase, phaseOf, signalAt, turn } from '../phasor'
import type { Disc } from './extent'
import type { Vector } from './vector'
import { type Displacement, displaced, REST_AT, Whirling } from './whirl'

/** Half the height of a mount as a share of the engine's size, half its breadth of that. */
const [HALF, BROAD] = [0.045, 0.7]
/** Of the plates at its ends: thickness and breadth; of its bracket: thickness. */
const [PLATE, BRIM, BRACKET] = [0.28, 1.35, 0.22]
/** The boxes of a mount: its rubber, the plates above and below, its bracket. */
export const BOXES = 4
export const KINDS = ['rubber', 'plate', 'plate', 'bracket'] as const
/** The longest arrow of a mount's force, as a share of the longest of forces. */
export const FORCES = 0.6
/** Numbers of a box: where it begins (x, y, z), half its breadth, its height, half its depth. */
export const BOX = 12

/** The mounts as they are drawn at an instant. */
export interface Mounted {
  /** The boxes of each mount. */
  readonly boxes: Float64Array
  /** The force of each on what is below it, x, y, z in shares of the greatest over a cycle. */
  readonly forces: Float64Array
  /** Where that force acts, x, y, z. */
  readonly feet: Float64Array
  /** How the block moves; null where it stands, or whirls freely. */
  readonly shake: Shake | null
}

/** The block as it moves on its mounts, in the way of a free one. */
export class Shaking extends Whirling {
  readonly shake: Shake
  readonly #phase: Phase
  readonly #now: Displacement = { ...REST_AT }
  readonly #below: Displacement = { ...REST_AT }

  constructor(exhibit: Exhibit, shake: Shake) {
    super(exhibit)
    this.shake = shake
    this.#phase = phaseOf(shake.orders.length, 1)
  }

  override at(theta: number, chosen: readonly number[] | null): Displacement {
    const { orders, motion, free } = this.shake
    turn(this.#phase, orders, theta, free ? null : chosen)
    put(motion, 0, this.#phase, this.#now)
    if (motion.length > SIX) put(motion, SIX, this.#phase, this.#below)
    return this.#now
  }

  /** What is below the mounts of the block, at the angle that was asked for last. */
  get below(): Displacement {
    return this.#below
  }

  /** Writes the forces at that angle in shares of the greatest: x, y, z of each mount. */
  forces(out: Float64Array): void {
    const { forces, most } = this.shake
    for (let index = 0; index < forces.length; index++) {
      const [up, right, along] = forces[index] as readonly Coefficients[]
      out[3 * index] = most > 0 ? signalAt(right as Coefficients, this.#phase) / most : 0
      out[3 * index + 1] = most > 0 ? signalAt(up as Coefficients, this.#phase) / most : 0
      out[3 * index + 2] = most > 0 ? signalAt(along as Coefficients, this.#phase) / most : 0
    }
  }
}

function put(motion: Shake['motion'], from: number, phase: Phase, to: Displacement): void {
  const value = (freedom: number) => signalAt(motion[from + freedom] as Coefficients, phase)
  to.up = value(0)
  to.right = value(1)
  to.along = value(2)
  to.tiltRight = value(3)
  to.tiltUp = value(4)
  to.turn = value(5)
}

/** A mount as it stands at rest; all in x, y, z. */
interface Stand {
  readonly below: boolean
  /** Where the block and what is below it hold its rubber. */
  readonly upper: Vector
  readonly lower: Vector
  /** From the lower end to the upper one, of length 1. */
  readonly way: Vector
  /** Half its breadth and its depth; with the way they are right-handed in the order of a box. */
  readonly across: Vector
  readonly deep: Vector
  /** Where its bracket ends in the engine, and half its breadth and depth. */
  readonly held: Vector
  readonly bar: readonly [Vector, Vector]
}

const turned = ([up, right, z]: readonly [number, number, number]): Vector => [right, up, z]
const scaled = ([x, y, z]: Vector, by: number): Vector => [x * by, y * by, z * by]
const sum = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]

/** The mounts of an engine as they stand, and as they are drawn. */
export class Mounting {
  readonly #centres: readonly { readonly centre: readonly [number, number, number] }[]
  readonly #stands: readonly Stand[]
  readonly #half: number
  readonly #now: { -readonly [K in keyof Mounted]: Mounted[K] }
  readonly #ends = {
    upper: [0, 0, 0] as [number, number, number],
    lower: [0, 0, 0] as [number, number, number],
    held: [0, 0, 0] as [number, number, number],
  }

  constructor(exhibit: Exhibit, { mounts, centres }: Mounts) {
    this.#half = halfOf(exhibit)
    this.#stands = mounts.map((mount) => standOf(exhibit, mount, centres, this.#half))
    this.#centres = centres.map((centre) => ({ centre }))
    this.#now = {
      boxes: new Float64Array(mounts.length * BOXES * BOX),
      forces: new Float64Array(3 * mounts.length),
      feet: new Float64Array(3 * mounts.length),
      shake: null,
    }
  }

  /** The mounts where the block has moved so. Reuses its record. */
  at(moved: Displacement, magnification: number, shaking: Shaking | null): Mounted {
    const { boxes, feet } = this.#now
    const { upper, lower, held } = this.#ends
    const [block, base = block] = this.#centres
    this.#now.shake = shaking?.shake ?? null
    if (shaking) shaking.forces(this.#now.forces)
    const below = shaking && this.#centres.length > 1 ? shaking.below : REST_AT
    if (!block || !base) return this.#now
    for (let index = 0; index < this.#stands.length; index++) {
      const stand = this.#stands[index] as Stand
      const [above, under] = stand.below ? [below, REST_AT] : [moved, below]
      const carrier = stand.below ? base : block
      displaced(carrier, above, magnification, stand.upper, upper)
      displaced(base, under, magnification, stand.lower, lower)
      displaced(carrier, above, magnification, stand.held, held)
      const first = index * BOXES * BOX
      this.#box(first, stand.across, stand.deep, lower, upper)
      this.#plate(first + BOX, stand, upper, 1)
      this.#plate(first + 2 * BOX, stand, lower, -1)
      this.#box(first + 3 * BOX, stand.bar[0], stand.bar[1], upper, held)
      for (let axis = 0; axis < 3; axis++)
        feet[3 * index + axis] = boxes[first + 2 * BOX + axis] as number
    }
    return this.#now
  }

  /** A box from one place to another. */
  #box(first: number, across: Vector, deep: Vector, from: Vector, to: Vector): void {
    const { boxes } = this.#now
    for (let axis = 0; axis < 3; axis++) {
      boxes[first + axis] = from[axis] as number
      boxes[first + 3 + axis] = across[axis] as number
      boxes[first + 6 + axis] = (to[axis] as number) - (from[axis] as number)
      boxes[first + 9 + axis] = deep[axis] as number
    }
  }

  /** The plate at an end, on the side away from the rubber. */
  #plate(first: number, { across, deep, way }: Stand, end: Vector, side: number): void {
    const { boxes } = this.#now
    const thick = PLATE * this.#half
    for (let axis = 0; axis < 3; axis++) {
      const high = thick * (way[axis] as number)
      boxes[first + axis] = (end[axis] as number) + (side < 0 ? -high : 0)
      boxes[first + 3 + axis] = BRIM * (across[axis] as number)
      boxes[first + 6 + axis] = high
      boxes[first + 9 + axis] = BRIM * (deep[axis] as number)
    }
  }
}

function halfOf({ scene: { low, high } }: Exhibit): number {
  return HALF * Math.max(high[0] - low[0], high[1] - low[1], high[2] - low[2])
}

function standOf(
  exhibit: Exhibit,
  { place, axes, load, below }: MountShown,
  centres: Mounts['centres'],
  half: number,
): Stand {
  const [first, second, third] = axes.map(turned) as [Vector, Vector, Vector]
  // what it bears pushes its foot away from the block
  const pressed = turned(load).reduce((all, each, axis) => all + each * (first[axis] as number), 0)
  const way = scaled(first, pressed > 0 ? -1 : 1)
  const [middle, broad] = [turned(place), BROAD * half]
  const across = scaled(second, broad)
  const deep = scaled(third, handed(across, way, third) > 0 ? broad : -broad)
  const upper = sum(middle, scaled(way, half))
  const base = turned(centres[1] ?? centres[0] ?? [0, 0, 0])
  const held = below ? base : heldAt(exhibit, upper)
  const lower = sum(middle, scaled(way, -half))
  return { below, upper, lower, way, across, deep, held, bar: barOf(upper, held, BRACKET * broad) }
}

/** Half the breadth and depth of a bar between two places. */
function barOf(from: Vector, to: Vector, half: number): [Vector, Vector] {
  const way: Vector = [to[0] - from[0], to[1] - from[1], to[2] - from[2]]
  const long = Math.hypot(...way)
  if (!(long > 0)) return [scaled([1, 0, 0], 0), scaled([0, 0, 1], 0)]
  const level = Math.hypot(way[0], way[1])
  const across: Vector = level > 0.01 * long ? [way[1] / level, -way[0] / level, 0] : [1, 0, 0]
  const deep: Vector = [
    (across[1] * way[2] - across[2] * way[1]) / long,
    (across[2] * way[0] - across[0] * way[2]) / long,
    (across[0] * way[1] - across[1] * way[0]) / long,
  ]
  return [scaled(across, half), scaled(deep, half)]
}

/** The crank axis nearest to a place. */
function heldAt({ scene }: Exhibit, [, , z]: Vector): Vector {
  const [shaft] = scene.shafts
  const [rear, front] = [scene.low[2], scene.high[2]]
  return [shaft?.right ?? 0, shaft?.up ?? 0, Math.min(front, Math.max(rear, z))]
}

/** Of three directions: above nought where they are right-handed. */
function handed(a: Vector, b: Vector, c: Vector): number {
  return (
    (a[1] * b[2] - a[2] * b[1]) * c[0] +
    (a[2] * b[0] - a[0] * b[2]) * c[1] +
    (a[0] * b[1] - a[1] * b[0]) * c[2]
  )
}

/** The room that mounts need. */
export function mountDiscs(exhibit: Exhibit): Disc[] {
  const { mounts } = exhibit
  if (!mounts) return []
  const radius = 2 * halfOf(exhibit)
  return mounts.mounts.flatMap(({ place }) => ballOf(turned(place), radius))
}

/** The room that the arrows of their forces need, where the longest is `arrow` long. */
export function forceDiscs({ mounts }: Exhibit, shake: Shake | null, arrow: number): Disc[] {
  if (!mounts || !shake || !(shake.most > 0)) return []
  return mounts.mounts.flatMap(({ place }, index) => {
    const reach = shake.forces[index]?.map((wave) => (arrow * sizeOf(wave)) / shake.most)
    const [up = 0, right = 0, along = 0] = reach ?? []
    const [x, y, z] = turned(place)
    const tip = (side: number): Disc => ({
      centre: [x + side * Math.min(arrow, right), y + side * Math.min(arrow, up), z + side * along],
      facing: [0, 0, 1],
      radius: 0,
    })
    return [tip(1), tip(-1)]
  })
}

/** At most so great is a signal. */
function sizeOf(wave: Coefficients): number {
  let all = 0
  for (let index = 0; index < wave.length; index += 2)
    all += Math.hypot(wave[index] as number, wave[index + 1] as number)
  return all
}

function ballOf(centre: Vector, radius: number): Disc[] {
  const ways: readonly Vector[] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ]
  return ways.map((facing) => ({ centre, facing, radius }))
}
