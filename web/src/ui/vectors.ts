import type { Exhibit, Vectors } from '../exhibit'

/** Which of the exhibit's orders count: a factor for each, 1 or 0. */
export function weightsOf(exhibit: Exhibit, chosen: readonly number[] | null): readonly number[] {
  return exhibit.orders.map((order) => (chosen === null || chosen.some((one) => Math.abs(one - order) < 1e-9) ? 1 : 0))
}

/** [up, right] of a vector at an angle: forward turns with the crank, backward against it. */
export function vectorAt(
  exhibit: Exhibit,
  vectors: Vectors,
  weights: readonly number[],
  theta: number,
): [number, number] {
  let up = 0
  let right = 0
  exhibit.orders.forEach((order, index) => {
    const forward = vectors.forward[index]
    const backward = vectors.backward[index]
    if (!weights[index] || !forward || !backward) return
    const cos = Math.cos(order * theta)
    const sin = exhibit.sense * Math.sin(order * theta)
    up += (forward[0] + backward[0]) * cos + (backward[1] - forward[1]) * sin
    right += (forward[1] + backward[1]) * cos + (forward[0] - backward[0]) * sin
  })
  return [up, right]
}

/** A signal, such as the roll, at an angle. */
export function signalAt(
  exhibit: Exhibit,
  pairs: readonly (readonly [number, number])[],
  weights: readonly number[],
  theta: number,
): number {
  return exhibit.orders.reduce((sum, order, index) => {
    const pair = pairs[index]
    return weights[index] && pair ? sum + pair[0] * Math.cos(order * theta) - pair[1] * Math.sin(order * theta) : sum
  }, 0)
}

/** No vector of these becomes longer than this. */
export function bound({ forward, backward }: Vectors): number {
  return [...forward, ...backward].reduce((sum, [up, right]) => sum + Math.hypot(up, right), 0)
}
