import type { Exhibit, ModeShown, Torsion, Vibration } from './exhibit'
import { t } from './language/messages'
import { roundFactor } from './magnification'
import { type Coefficients, highest, sameOrder, signalOf } from './phasor'
import type { Choices } from './state'

/** What twists the crank on the stage. */
export type Show = 'still' | 'mode' | 'forced'
export const SHOWS: readonly [Show, ...Show[]] = ['still', 'mode', 'forced']

/** What is chosen of the twist of the crank, for any engine. */
export interface TwistChoice {
  readonly show: Show
  /** Number of the mode. */
  readonly mode: number
  /** How often a mode swings in a turn; null for the order that counts most in it. */
  readonly order: number | null
  /** Which of the vibrations, from 0. */
  readonly vibration: number
  /** Magnification; null for one that is seen well. */
  readonly times: number | null
}

/** The twist of a crank over the crank angle, not magnified; throws and pieces front first. */
export interface Twist {
  readonly orders: readonly number[]
  /** How far each throw is ahead, radians. */
  readonly turns: readonly Coefficients[]
  /** Shear stress (Pa) or torque (N m) in each piece; null where it is not known. */
  readonly loads: readonly (Coefficients | null)[]
  readonly of: 'stress' | 'torque'
  /** Whether it is a mode, whose loads are those at `UNIT`. */
  readonly free: boolean
  /** The greatest load over a cycle. */
  readonly top: number
  /** The greatest turn of a throw over a cycle, radians. */
  readonly greatest: number
  readonly times: number
}

/** The turn of the mass that turns most in a mode, which has no size of its own. */
export const UNIT = Math.PI / 180
/** The greatest turn that the usual magnification gives. */
const SEEN = 10 * UNIT
/** Orders that are offered for a mode. */
const MOST_ORDERS = 6

const count = (text: string | undefined, otherwise: number): number =>
  /^\d{1,6}$/.test(text ?? '') ? Number(text) : otherwise

/** What is chosen, as links have it. */
export function twistChoiceOf(choices: Choices): TwistChoice {
  const order = Number(choices['twist.order'] ?? 0)
  return {
    show: SHOWS.find((each) => each === choices['twist.show']) ?? 'still',
    mode: count(choices['twist.mode'], 1),
    order: order > 0 ? order : null,
    vibration: count(choices['twist.at'], 0),
    times: count(choices['twist.times'], 0) || null,
  }
}

/** The mode of a number; the first without such a one. */
export const modeOf = ({ modes }: Torsion, number: number): ModeShown | undefined =>
  modes.find((mode) => mode.number === number) ?? modes[0]

/** The orders that count in a mode, ascending. */
export function ordersOfMode({ criticals }: Torsion, mode: number): number[] {
  return strongest(criticals.filter((each) => each.mode === mode)).sort((a, b) => a - b)
}

const strongest = (criticals: Torsion['criticals']): number[] =>
  criticals
    .toSorted((one, other) => other.strength - one.strength)
    .slice(0, MOST_ORDERS)
    .map(({ order }) => order)

/** The order of a mode that is shown: the chosen one, else that which counts most, else 1. */
export function orderOf(torsion: Torsion, mode: number, chosen: number | null): number {
  const met = strongest(torsion.criticals.filter((each) => each.mode === mode))
  return met.find((order) => chosen !== null && sameOrder(order, chosen)) ?? met[0] ?? 1
}

/** The vibration that is shown; the first without such a one. */
export const vibrationOf = ({ vibrations }: Torsion, place: number): Vibration | undefined =>
  vibrations[place] ?? vibrations[0]

/** The twist as chosen; null where nothing twists. */
export function twistOf({ torsion, turns }: Exhibit, choice: TwistChoice): Twist | null {
  if (!torsion || torsion.throws.length === 0 || choice.show === 'still') return null
  const waves =
    choice.show === 'mode' ? ofMode(torsion, choice) : forced(torsion, choice.vibration, turns)
  if (!waves) return null
  const usual = waves.greatest > 0 ? roundFactor(SEEN / waves.greatest) : 1
  return { ...waves, times: choice.times ?? usual }
}

/** What a load is divided by: where a shaft has stresses, those that have none are left out. */
function divisors({ pieces }: Torsion): readonly (number | null)[] {
  const stress = hasStress(pieces)
  return pieces.map((piece) => (piece === null ? null : stress ? piece.modulus : 1))
}

const hasStress = (pieces: Torsion['pieces']): boolean =>
  pieces.some((piece) => piece?.modulus != null)

function ofMode(torsion: Torsion, choice: TwistChoice): Omit<Twist, 'times'> | null {
  const mode = modeOf(torsion, choice.mode)
  if (!mode) return null
  const unit = UNIT / Math.max(...mode.shape.map(Math.abs))
  const turns = torsion.masses_of_throws.map((mass) => unit * (mode.shape[mass] ?? 0))
  const loads = divisors(torsion).map((divisor, place) =>
    divisor === null ? null : (unit * (mode.torque[place] ?? 0)) / divisor,
  )
  const swing = (size: number): Coefficients => Float64Array.of(size, 0)
  return {
    orders: [orderOf(torsion, mode.number, choice.order)],
    turns: turns.map(swing),
    loads: loads.map((load) => (load === null ? null : swing(load))),
    of: hasStress(torsion.pieces) ? 'stress' : 'torque',
    free: true,
    top: Math.max(0, ...loads.map((load) => Math.abs(load ?? 0))),
    greatest: Math.max(0, ...turns.map(Math.abs)),
  }
}

function forced(torsion: Torsion, place: number, turns: number): Omit<Twist, 'times'> | null {
  const vibration = vibrationOf(torsion, place)
  if (!vibration) return null
  const { orders } = torsion
  const divided = divisors(torsion)
  const waves = vibration.turns.map(signalOf)
  return {
    orders,
    turns: waves,
    loads: divided.map((divisor, index) =>
      divisor === null ? null : signalOf(vibration.torque[index] ?? []).map((n) => n / divisor),
    ),
    of: hasStress(torsion.pieces) ? 'stress' : 'torque',
    free: false,
    top: Math.max(0, ...divided.map((each, at) => (each ? (vibration.peak[at] ?? 0) / each : 0))),
    greatest: Math.max(0, ...waves.map((wave) => highest(wave, orders, null, turns))),
  }
}

/** What the crank is coloured by. */
export function loadName({ of, free }: Twist): string {
  if (free) return of === 'stress' ? t('Shear stress at 1°') : t('Torque at 1°')
  return of === 'stress' ? t('Shear stress of vibration') : t('Torque of vibration')
}

/** The load of the last colour, with its unit. */
export function topText({ torsion_numbers: numbers }: Exhibit, { of, top }: Twist): string {
  const unit = of === 'stress' ? numbers?.stress_unit : numbers?.torque_unit
  return `${Number((top * (unit?.factor ?? 1)).toPrecision(4))} ${unit?.label ?? ''}`.trim()
}
