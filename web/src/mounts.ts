import type { Exhibit, MountedMode, MountedPoint, Mounts, MountVibration } from './exhibit'
import { roundFactor } from './magnification'
import { type Answer, answerAt } from './mountResponse'
import { type Coefficients, type Phase, phaseOf, signalAt, signalOf, turn } from './phasor'
import type { Choices } from './state'

/** What moves the block on the stage. */
export type Show = 'still' | 'mode' | 'forced'
export const SHOWS: readonly [Show, ...Show[]] = ['still', 'mode', 'forced']

/** What is chosen of the block on its mounts, for any engine. */
export interface MountChoice {
  readonly show: Show
  /** Number of the mode. */
  readonly mode: number
  /** Which of the speeds of note, from 0. */
  readonly vibration: number
  /** A speed of one's own, rpm; null for one of note. */
  readonly rpm: number | null
  /** Which of the points, from 0. */
  readonly point: number
  /** Magnification; null for one that is seen well. */
  readonly times: number | null
}

/** The freedoms of a body: up, right, along, yaw, pitch, roll. */
export const SIX = 6
/** Radians per second for each turn per minute. */
export const PER_RPM = Math.PI / 30
/** How far the corner of the engine that goes farthest goes in a mode, m. */
export const UNIT = 1e-3
/** Share of the engine's size that the usual magnification gives the greatest movement. */
const SHARE = 0.05
/** Angles of a turn at which the greatest of a course is looked for. */
const STEPS = 120

/** How the block moves on its mounts over the crank angle, not magnified. */
export interface Shake {
  readonly orders: readonly number[]
  /** Each freedom of the block, then of a foundation: m and rad. */
  readonly motion: readonly Coefficients[]
  /** Of each mount on what is below it: up, right, along; N. */
  readonly forces: readonly (readonly Coefficients[])[]
  /** The greatest of them over a cycle. */
  readonly most: number
  /** Whether it is a mode, which has no size of its own. */
  readonly free: boolean
  /** The speed at which the engine runs; 0 for a mode. */
  readonly rpm: number
  readonly times: number
}

const count = (text: string | undefined, otherwise: number): number =>
  /^\d{1,6}$/.test(text ?? '') ? Number(text) : otherwise

/** What is chosen, as links have it. */
export function mountChoiceOf(choices: Choices): MountChoice {
  return {
    show: SHOWS.find((each) => each === choices['mounts.show']) ?? 'still',
    mode: count(choices['mounts.mode'], 1),
    vibration: count(choices['mounts.at'], 0),
    rpm: Number.parseFloat(choices['mounts.rpm'] ?? '') || null,
    point: count(choices['mounts.point'], 0),
    times: count(choices['mounts.times'], 0) || null,
  }
}

/** The mode of a number; the first without such a one. */
export const modeOf = ({ modes }: Mounts, number: number): MountedMode | undefined =>
  modes.find((mode) => mode.number === number) ?? modes[0]

/** The speed that is shown: a chosen one within the range, else of note, the first without such. */
export function vibrationOf(
  { vibrations, over }: Mounts,
  { rpm, vibration }: Pick<MountChoice, 'rpm' | 'vibration'>,
): MountVibration | undefined {
  const [slowest, fastest] = [over?.speeds_rpm[0], over?.speeds_rpm.at(-1)]
  if (rpm === null || slowest === undefined || fastest === undefined)
    return vibrations[vibration] ?? vibrations[0]
  const speed_rpm = Math.min(Math.max(rpm, slowest), fastest)
  return { point: '', gas: null, speed_rpm, peak: false }
}

/** The point of which motion is told; the first without such a one. */
export const pointOf = ({ points }: Mounts, { point }: Pick<MountChoice, 'point'>): MountedPoint =>
  (points[point] ?? points[0]) as MountedPoint

/** The steady vibration at a speed; null where no speed is known. */
export const answerOf = (mounts: Mounts, { speed_rpm, gas }: MountVibration): Answer | null =>
  mounts.driving && answerAt(mounts, mounts.driving, speed_rpm * PER_RPM, gas && signalOf(gas))

/** How the block moves as chosen; null where it does not. */
export function shakeOf(exhibit: Exhibit, choice: MountChoice): Shake | null {
  const { mounts, turns } = exhibit
  if (!mounts || choice.show === 'still') return null
  const corners = cornersOf(exhibit, mounts)
  const waves = choice.show === 'mode' ? ofMode(mounts, choice, corners) : forced(mounts, choice)
  if (!waves) return null
  const { orders, motion, forces } = waves
  const { low, high } = exhibit.scene
  const size = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2])
  const going = new Going(motion)
  let [most, greatest] = [0, 0]
  over(orders, turns, (phase) => {
    for (const force of forces) {
      const [up, right, along] = force.map((wave) => signalAt(wave, phase)) as Place
      most = Math.max(most, Math.hypot(up, right, along))
    }
    going.at(phase)
    for (const place of corners) greatest = Math.max(greatest, Math.hypot(...going.of(place)))
  })
  const usual = greatest > 1e-12 * size ? roundFactor((SHARE * size) / greatest) : 1
  return { ...waves, most, times: choice.times ?? usual }
}

type Place = [number, number, number]
type Waves = Omit<Shake, 'times' | 'most'>

function ofMode(mounts: Mounts, choice: MountChoice, corners: readonly Place[]): Waves | null {
  const mode = modeOf(mounts, choice.mode)
  if (!mode) return null
  const unit = UNIT / farthest(mode, corners)
  const swing = (size: number): Coefficients => Float64Array.of(unit * size, 0)
  return {
    orders: [1],
    motion: mode.shape.map(swing),
    forces: mode.forces.map((force) => force.map(swing)),
    free: true,
    rpm: 0,
  }
}

/** How far the corner of the engine goes that goes farthest, or a foundation its own way. */
function farthest({ shape }: MountedMode, corners: readonly Place[]): number {
  const going = new Going(shape.map((size) => Float64Array.of(size, 0)))
  going.at(turn(phaseOf(1, 1), [1], 0, null))
  const below = Math.hypot(...shape.slice(SIX, SIX + 3))
  return Math.max(below, ...corners.map((corner) => Math.hypot(...going.of(corner)))) || 1
}

function forced(mounts: Mounts, choice: MountChoice): Waves | null {
  const vibration = vibrationOf(mounts, choice)
  const answer = vibration && answerOf(mounts, vibration)
  if (!answer) return null
  const { motion, forces } = answer
  return { orders: mounts.orders, motion, forces, free: false, rpm: vibration.speed_rpm }
}

/** Runs through the angles of a cycle. */
function over(orders: readonly number[], turns: number, each: (phase: Phase) => void): void {
  const phase = phaseOf(orders.length, 1)
  const steps = STEPS * turns
  for (let step = 0; step < steps; step++)
    each(turn(phase, orders, (2 * Math.PI * turns * step) / steps, null))
}

/** The corners of what is drawn, from the centre of mass: up, right, along. */
function cornersOf({ scene: { low, high } }: Exhibit, { centres }: Mounts): Place[] {
  const [up, right, z] = centres[0] ?? [0, 0, 0]
  return [low, high].flatMap(([u]) =>
    [low, high].flatMap(([, r]) =>
      [low, high].map(([, , along]): Place => [u - up, r - right, along - z]),
    ),
  )
}

/** The motion of points of the block at an instant. */
class Going {
  readonly #motion: readonly Coefficients[]
  readonly #now = new Float64Array(SIX)

  constructor(motion: readonly Coefficients[]) {
    this.#motion = motion
  }

  at(phase: Phase): void {
    for (let freedom = 0; freedom < SIX; freedom++)
      this.#now[freedom] = signalAt(this.#motion[freedom] as Coefficients, phase)
  }

  /** Of a point at a place from the centre of mass. */
  of([u, r, z]: Readonly<Place>): Place {
    const [up, right, along, yaw, pitch, roll] = this.#now as unknown as number[] & Six
    return [up + z * pitch - r * roll, right + z * yaw + u * roll, along - r * yaw - u * pitch]
  }
}

type Six = [number, number, number, number, number, number]

/** The waves of a point of the block, or of a foundation, at a vibration: up, right, along, m. */
export function pointWaves(
  { centres }: Mounts,
  motion: readonly Coefficients[],
  { place, below }: Pick<MountedPoint, 'place' | 'below'>,
): Coefficients[] {
  const centre = centres[below ? 1 : 0] ?? [0, 0, 0]
  const own = motion.slice(below ? SIX : 0)
  const [u, r, z] = place.map((each, axis) => each - (centre[axis] as number)) as Place
  const sum = (...terms: readonly (readonly [number, number])[]): Coefficients =>
    (own[0] as Coefficients).map((_, index) =>
      terms.reduce((all, [at, by]) => all + by * ((own[at] as Coefficients)[index] as number), 0),
    )
  return [sum([0, 1], [4, z], [5, -r]), sum([1, 1], [3, z], [5, u]), sum([2, 1], [3, -r], [4, -u])]
}

/** The waves of the force on the ground of a vibration: up, right, along, N. */
export function groundWaves({ mounts }: Mounts, forces: Shake['forces']): Coefficients[] {
  const below = mounts.some((mount) => mount.below)
  const standing = forces.filter((_, index) => mounts[index]?.below === below)
  return [0, 1, 2].map((axis) =>
    (standing[0]?.[axis] ?? new Float64Array()).map((_, index) =>
      standing.reduce((sum, force) => sum + (force[axis]?.[index] ?? 0), 0),
    ),
  )
}
