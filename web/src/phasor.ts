import type { Vectors } from './exhibit'

/**
 * Spectra over crank order evaluated at a crank angle, as in phasor.py.
 *
 * A vector of order k is `forward exp(i s k theta) + backward exp(-i s k theta)`, s the exhibit's
 * sense, as `up + i right`; a signal is `Re(c exp(i k theta))`.
 */
export interface Phase {
  readonly sense: number
  /** cos(k theta) and sin(k theta), order by order; both 0 for an order that is not chosen. */
  readonly cos: Float64Array
  readonly sin: Float64Array
}

/** A vector of the clock plane, [up, right]. */
export type Plane = [number, number]

/** Four numbers an order: forward up and right, backward up and right. */
export type Coefficients = Float64Array

/** Orders that are closer together than this are the same. */
const SAME = 1e-6

export function phaseOf(count: number, sense: number): Phase {
  return { sense, cos: new Float64Array(count), sin: new Float64Array(count) }
}

/** Turns `phase` to `theta` (radians), without the orders outside `chosen`; null keeps all. */
export function turn(
  phase: Phase,
  orders: readonly number[],
  theta: number,
  chosen: readonly number[] | null,
): Phase {
  for (let index = 0; index < orders.length; index++) {
    const order = orders[index] as number
    const kept = chosen === null || among(order, chosen)
    phase.cos[index] = kept ? Math.cos(order * theta) : 0
    phase.sin[index] = kept ? Math.sin(order * theta) : 0
  }
  return phase
}

/** Whether two orders are one but for rounding. */
export const sameOrder = (one: number, other: number): boolean => Math.abs(one - other) < SAME

/** Whether an order is one of these. */
export function among(order: number, orders: readonly number[]): boolean {
  for (let index = 0; index < orders.length; index++)
    if (sameOrder(orders[index] as number, order)) return true
  return false
}

/** The vectors of an exhibit as coefficients that are quick to add up. */
export function coefficientsOf(vectors: Vectors): Coefficients {
  return Float64Array.from(
    vectors.forward.flatMap((forward, index) => {
      const backward = vectors.backward[index] ?? [0, 0]
      return [forward[0], forward[1], backward[0], backward[1]] as number[]
    }),
  )
}

/** The signals of an exhibit, two numbers an order: real and imaginary. */
export function signalOf(pairs: readonly (readonly [unknown, unknown])[]): Coefficients {
  return Float64Array.from(pairs.flatMap(([real, imaginary]) => [real, imaginary] as number[]))
}

/** The sum of vectors. */
export function summed(all: readonly Coefficients[]): Coefficients {
  const [first = new Float64Array()] = all
  return first.map((_, index) => all.reduce((sum, each) => sum + (each[index] as number), 0))
}

/** Writes the vector at the phase into `out`, and gives it back. Makes no garbage. */
export function vectorAt(coefficients: Coefficients, phase: Phase, out: Plane): Plane {
  let up = 0
  let right = 0
  for (let index = 0; index < phase.cos.length; index++) {
    const cos = phase.cos[index] as number
    const sin = phase.sense * (phase.sin[index] as number)
    const first = 4 * index
    const forwardUp = coefficients[first] as number
    const forwardRight = coefficients[first + 1] as number
    const backwardUp = coefficients[first + 2] as number
    const backwardRight = coefficients[first + 3] as number
    up += (forwardUp + backwardUp) * cos - (forwardRight - backwardRight) * sin
    right += (forwardRight + backwardRight) * cos + (forwardUp - backwardUp) * sin
  }
  out[0] = up
  out[1] = right
  return out
}

/** The signal at the phase. */
export function signalAt(coefficients: Coefficients, phase: Phase): number {
  let sum = 0
  for (let index = 0; index < phase.cos.length; index++) {
    sum += (coefficients[2 * index] as number) * (phase.cos[index] as number)
    sum -= (coefficients[2 * index + 1] as number) * (phase.sin[index] as number)
  }
  return sum
}

/** The greatest length of the vector over `turns` turns, on a grid. */
export function greatest(
  coefficients: Coefficients,
  orders: readonly number[],
  chosen: readonly number[] | null,
  turns: number,
): number {
  const place: Plane = [0, 0]
  return mostOver(orders, chosen, turns, (phase) =>
    Math.hypot(...vectorAt(coefficients, phase, place)),
  )
}

/** The greatest absolute value of a signal over `turns` turns, on a grid. */
export function highest(
  coefficients: Coefficients,
  orders: readonly number[],
  chosen: readonly number[] | null,
  turns: number,
): number {
  return mostOver(orders, chosen, turns, (phase) => Math.abs(signalAt(coefficients, phase)))
}

/** The greatest vertical and horizontal reach of the vector over `turns` turns. */
export function spans(
  coefficients: Coefficients,
  orders: readonly number[],
  chosen: readonly number[] | null,
  turns: number,
): Plane {
  const place: Plane = [0, 0]
  const most: Plane = [0, 0]
  mostOver(orders, chosen, turns, (phase) => {
    const [up, right] = vectorAt(coefficients, phase, place)
    most[0] = Math.max(most[0], Math.abs(up))
    most[1] = Math.max(most[1], Math.abs(right))
    return 0
  })
  return most
}

/** The greatest of what `size` gives over `turns` turns, on a grid. */
function mostOver(
  orders: readonly number[],
  chosen: readonly number[] | null,
  turns: number,
  size: (phase: Phase) => number,
): number {
  const phase = phaseOf(orders.length, 1)
  const steps = 180 * turns
  let most = 0
  for (let step = 0; step < steps; step++)
    most = Math.max(most, size(turn(phase, orders, (step / steps) * turns * 2 * Math.PI, chosen)))
  return most
}
