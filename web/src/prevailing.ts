import type { Exhibit } from './exhibit'
import { type Coefficients, coefficientsOf, greatest } from './phasor'

/** The greater of force and couple, the couple as a pair of forces at the ends of the engine. */
export function prevailing(exhibit: Exhibit): 'force' | 'couple' {
  const { orders, turns, total, scene, couple_length } = exhibit
  const most = (of: Coefficients) => greatest(of, orders, null, turns)
  const length = (scene.high[2] - scene.low[2]) / couple_length
  return most(coefficientsOf(total.couple)) > length * most(coefficientsOf(total.force))
    ? 'couple'
    : 'force'
}
