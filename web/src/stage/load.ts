import type { Exhibit } from '../exhibit'
import {
  type Coefficients,
  coefficientsOf,
  greatest,
  highest,
  type Phase,
  type Plane,
  phaseOf,
  signalAt,
  signalOf,
  spans,
  summed,
  turn,
  vectorAt,
} from '../phasor'
import { banksOf } from './banks'
import { along, type Disc } from './extent'
import type { View } from './stage'
import type { Vector } from './vector'

/** An arrow: its origin (x, y, z) and its vector in shares of the longest of its kind. */
export interface Pull {
  readonly kind: 'force' | 'part' | 'couple'
  readonly x: number
  readonly y: number
  readonly z: number
  up: number
  right: number
}

/** All that pulls at the block at an instant. */
export interface Load {
  readonly pulls: Pull[]
  /** Values of an arrow of the design length at scale 1; 0 where none is drawn. */
  force: number
  couple: number
  /** The rolling moment of the longest curved arrow; 0 where none is drawn. */
  roll: number
  /** The rolling moment now in shares of it, clockwise. */
  turning: number
  /** Middle of the curved arrow, x, y, z. */
  readonly about: Vector
}

/** The longest curved arrow: its angle, radians, and its radius in lengths of the longest arrow. */
export const ROLL = { angle: (140 * Math.PI) / 180, radius: 1.15 }

/** A sum below this share of its parts is a rounding error and not drawn. */
const ROUNDING = 1e-9
/** A sum below this share of a cylinder's greatest force (or couple) is drawn small. */
const LITTLE = 0.1
/** Arrows of the couple: two at each end. */
const COUPLES = 4

/** The arrows of an exhibit; a couple is a pair of forces at the two ends, in its plane. */
export class Loads {
  readonly #exhibit: Exhibit
  readonly #force: Coefficients
  readonly #couple: Coefficients
  readonly #roll: Coefficients
  /** The forces of cylinders and of banks, in the order of their arrows. */
  readonly #parts: readonly Part[]
  readonly #phase: Phase
  readonly #load: Load
  readonly #place: Plane = [0, 0]
  #beside: readonly Exhibit[] = []
  /** The view for which the lengths of arrows have been worked out. */
  #scaled = ''
  /** Length of arrows for which the room they need has been worked out, and that room. */
  #long = -1
  #room: readonly Disc[] = []

  constructor(exhibit: Exhibit) {
    this.#exhibit = exhibit
    this.#force = coefficientsOf(exhibit.total.force)
    this.#couple = coefficientsOf(exhibit.total.couple)
    this.#roll = signalOf(exhibit.total.roll)
    this.#parts = partsOf(exhibit)
    this.#phase = phaseOf(exhibit.orders.length, exhibit.sense)
    const [shaft] = exhibit.scene.shafts
    const about: Vector = [shaft?.right ?? 0, shaft?.up ?? 0, exhibit.scene.high[2]]
    this.#load = { pulls: this.#begun(), force: 0, couple: 0, roll: 0, turning: 0, about }
  }

  /** Engines beside this one: arrows of the same length mean the same in all of them. */
  set beside(exhibits: readonly Exhibit[]) {
    this.#beside = exhibits
    this.#scaled = ''
  }

  /** Arrows begin at the reference point, at both ends (couple) and above the heads. */
  #begun(): Pull[] {
    const { scene, reference_z } = this.#exhibit
    const axis = { x: scene.shafts[0]?.right ?? 0, y: scene.shafts[0]?.up ?? 0, up: 0, right: 0 }
    const [from, to] = [scene.low[2], scene.high[2]]
    const parts = scene.cylinders.map((c): Pull => {
      const [x, y] = along(scene, c, c.bore_to + 0.12 * c.bore)
      return { kind: 'part', x, y, z: c.z, up: 0, right: 0 }
    })
    return [
      { kind: 'force', z: reference_z, ...axis },
      // in the plane, or upright (pitch); the others are level (yaw)
      { kind: 'couple', z: to, ...axis },
      { kind: 'couple', z: from, ...axis },
      { kind: 'couple', z: to, ...axis },
      { kind: 'couple', z: from, ...axis },
      ...parts,
      ...this.#banks(parts),
    ]
  }

  /** The force of a bank stands in the middle of it. */
  #banks(parts: readonly Pull[]): Pull[] {
    return banksOf(this.#exhibit).map(({ cylinders }) => {
      const own = cylinders.flatMap((place) => parts[place] ?? [])
      const mean = (of: (pull: Pull) => number): number =>
        own.reduce((sum, pull) => sum + of(pull), 0) / own.length
      const [x, y, z] = [mean((pull) => pull.x), mean((pull) => pull.y), mean((pull) => pull.z)]
      return { kind: 'part', x, y, z, up: 0, right: 0 }
    })
  }

  /** The arrows at the view's crank angle; those that are not wanted, or nothing, are zero. */
  at(view: View): Load {
    const { theta, arrows } = view
    const load = this.#load
    const { orders } = this.#exhibit
    this.#scale(view)
    turn(this.#phase, orders, theta, arrows.orders)
    this.#put(0, this.#force, load.force, 1)
    for (let pair = 0; pair < COUPLES; pair++)
      this.#put(1 + pair, this.#couple, load.couple, pair % 2 ? -1 : 1)
    this.#split(arrows.axes)
    load.turning = load.roll > 0 ? signalAt(this.#roll, this.#phase) / load.roll : 0
    for (let index = 0; index < this.#parts.length; index++) {
      const part = this.#parts[index] as Part
      this.#put(1 + COUPLES + index, part.force, arrows.each === part.of ? load.force : 0, 1)
    }
    return load
  }

  /** The room that arrows need over the whole cycle, where the longest is `arrow` long. */
  room(view: View, arrow: number): readonly Disc[] {
    const { arrows } = view
    this.#scale(view)
    if (arrow === this.#long) return this.#room
    this.#long = arrow
    const { orders, turns } = this.#exhibit
    const { pulls, force, couple, roll, about } = this.#load
    const ring: Disc = { centre: about, facing: [0, 0, 1], radius: ROLL.radius * arrow }
    const tips = (pull: Pull | undefined, coefficients: Coefficients, scale: number): Disc[] => {
      if (!pull || !(scale > 0)) return []
      const [up, right] = spans(coefficients, orders, arrows.orders, turns).map(
        (most) => (most / scale) * arrow,
      ) as Plane
      const tip = (x: number, y: number): Disc => ({
        centre: [x, y, pull.z],
        facing: [0, 0, 1],
        radius: 0,
      })
      return [tip(pull.x - right, pull.y - up), tip(pull.x + right, pull.y + up)]
    }
    this.#room = [
      ...(roll > 0 ? [ring] : []),
      ...tips(pulls[0], this.#force, force),
      ...tips(pulls[1], this.#couple, couple),
      ...tips(pulls[2], this.#couple, couple),
      ...this.#parts.flatMap((part, index) =>
        tips(pulls[1 + COUPLES + index], part.force, arrows.each === part.of ? force : 0),
      ),
    ]
    return this.#room
  }

  /** Leaves of the pairs of the couple one in its plane, or one upright and one level. */
  #split(axes: boolean): void {
    const [, ...couples] = this.#load.pulls
    for (let index = 0; index < COUPLES; index++) {
      const pull = couples[index]
      if (!pull) return
      const level = index > 1
      if (level) pull.up = 0
      if (level ? !axes : axes) pull.right = 0
    }
  }

  #put(index: number, coefficients: Coefficients, scale: number, sign: number): void {
    const pull = this.#load.pulls[index]
    if (!pull) return
    vectorAt(coefficients, this.#phase, this.#place)
    pull.up = scale > 0 ? (sign * this.#place[0]) / scale : 0
    pull.right = scale > 0 ? (sign * this.#place[1]) / scale : 0
  }

  /** The greatest of what is shown here and beside, whenever the choice changes. */
  #scale({ arrows }: View): void {
    const key = `${arrows.force} ${arrows.couple} ${arrows.roll} ${arrows.each} ${arrows.orders?.join() ?? 'all'}`
    if (key === this.#scaled) return
    this.#scaled = key
    this.#long = -1
    this.#load.force = 0
    this.#load.couple = 0
    this.#load.roll = 0
    const { units, scale } = this.#exhibit
    for (const exhibit of [this.#exhibit, ...this.#beside]) {
      const { force, couple, roll } = longest(exhibit, arrows)
      // in other units, as multiples of m r w^2 of the first cylinder
      const alike = `${exhibit.units.counted}` === `${units.counted}`
      const own = exhibit.scale
      const [forces, couples, rolls] = alike
        ? [1, 1, 1]
        : [scale.force / own.force, scale.couple / own.couple, scale.roll / own.roll]
      this.#load.force = Math.max(this.#load.force, forces * force)
      this.#load.couple = Math.max(this.#load.couple, couples * couple)
      this.#load.roll = Math.max(this.#load.roll, rolls * roll)
    }
  }
}

/** The force of a cylinder or of a bank. */
interface Part {
  readonly of: 'cylinders' | 'banks'
  readonly force: Coefficients
}

/** The forces of the cylinders, then those of the banks, each the sum of its cylinders. */
function partsOf(exhibit: Exhibit): readonly Part[] {
  const { cylinders } = exhibit
  const alone = cylinders.map((part) => coefficientsOf(part.force))
  const sums = banksOf(exhibit).map((bank) =>
    summed(alone.filter((_, place) => bank.cylinders.includes(place))),
  )
  return [
    ...alone.map((force) => ({ of: 'cylinders' as const, force })),
    ...sums.map((force) => ({ of: 'banks' as const, force })),
  ]
}

/** What the longest arrows of an engine stand for; 0 where nothing is to be drawn. */
function longest(exhibit: Exhibit, arrows: View['arrows']) {
  const { orders, turns, cylinders, reference_z, couple_length, total } = exhibit
  const most = (of: Coefficients) => greatest(of, orders, arrows.orders, turns)
  const [force, couple] = [most(coefficientsOf(total.force)), most(coefficientsOf(total.couple))]
  const parts = partsOf(exhibit)
  const greatestOf = (which: Part['of']): number =>
    Math.max(0, ...parts.filter((part) => part.of === which).map((part) => most(part.force)))
  const alone = greatestOf('cylinders')
  const shown = arrows.each === 'engine' ? force : Math.max(force, greatestOf(arrows.each))
  const arm =
    Math.max(0, ...cylinders.map((part) => Math.abs(part.z - reference_z))) / couple_length
  const pair = alone * arm
  // about the torque of one cylinder: its force at the crank radius
  const { scale } = exhibit
  const lever = (alone * scale.roll) / scale.force
  const [roll, torque] = [total.roll, total.torque].map((signal) =>
    highest(signalOf(signal), orders, arrows.orders, turns),
  ) as Plane
  return {
    force: arrows.force && shown > ROUNDING * alone ? Math.max(shown, LITTLE * alone) : 0,
    couple: arrows.couple && couple > ROUNDING * pair ? Math.max(couple, LITTLE * pair) : 0,
    roll:
      arrows.roll && roll > ROUNDING * Math.max(roll, torque) ? Math.max(roll, LITTLE * lever) : 0,
  }
}
