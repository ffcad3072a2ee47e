import type { Exhibit } from './exhibit'
import { type Coefficients, coefficientsOf, greatest } from './phasor'

const ROUNDING = 1e-9

/** What of an engine is worth looking at first: whichever of force and couple is the greater share of what its parts do. */
export function telling({ orders, turns, total, cylinders, reference_z, couple_length }: Exhibit): 'force' | 'couple' {
  const most = (of: Coefficients) => greatest(of, orders, null, turns)
  const alone = Math.max(0, ...cylinders.map((part) => most(coefficientsOf(part.force))))
  const arm = Math.max(0, ...cylinders.map((part) => Math.abs(part.z - reference_z))) / couple_length
  return most(coefficientsOf(total.couple)) > (1 + ROUNDING) * arm * most(coefficientsOf(total.force)) &&
    alone * arm > 0
    ? 'couple'
    : 'force'
}
