import type { Exhibit, Row } from '../exhibit'
import {
  coefficientsOf,
  type Plane,
  phaseOf,
  sameOrder,
  signalAt,
  signalOf,
  turn,
  vectorAt,
} from '../phasor'

/** Where the dot of a row stands at an angle, [x, y] of its drawing. */
export type Dot = (theta: number) => Plane

/** What moves the dot of a row: its order alone, `share` where it is greatest. */
export function dotOf(exhibit: Exhibit, row: Row, share: number): Dot {
  const index = exhibit.orders.findIndex((order) => sameOrder(order, row.order))
  const orders = [row.order]
  const phase = phaseOf(1, exhibit.sense)
  const place: Plane = [0, 0]
  const still: Dot = () => place
  if (index < 0 || !row.remains) return still
  if (row.quantity === 'force' || row.quantity === 'couple') {
    const { forward, backward } = exhibit.total[row.quantity]
    const [ahead, against] = [forward[index], backward[index]]
    const size = (row.semi_axes?.[0] ?? 0) / share
    if (!ahead || !against || !(size > 0)) return still
    const coefficients = coefficientsOf({ forward: [ahead], backward: [against] })
    return (theta) => {
      const [up, right] = vectorAt(coefficients, turn(phase, orders, theta, null), place)
      place[0] = right / size
      place[1] = -up / size
      return place
    }
  }
  const pair = exhibit.total[row.quantity][index]
  const size = pair ? Math.hypot(pair[0], pair[1]) / share : 0
  if (!pair || !(size > 0)) return still
  const coefficients = signalOf([pair])
  return (theta) => {
    place[0] = signalAt(coefficients, turn(phase, orders, theta, null)) / size
    return place
  }
}

/** The size of each row in shares of the greatest of its quantity, 0 where nothing remains. */
export function sharesOf(rows: readonly Row[]): ReadonlyMap<Row, number> {
  const most = (quantity: Row['quantity']): number =>
    Math.max(...rows.filter((row) => row.quantity === quantity).map(({ size }) => size))
  return new Map(rows.map((row) => [row, row.size > 0 ? row.size / most(row.quantity) : 0]))
}

/** Moves the dots in the drawings below an element, row by row. */
export function moveDots(element: Element | null, dots: readonly Dot[], theta: number): void {
  const circles = element?.querySelectorAll('svg.path circle.now, svg.path circle.still')
  circles?.forEach((circle, index) => {
    const place = dots[index]?.(theta)
    if (!place) return
    circle.setAttribute('cx', place[0].toFixed(3))
    circle.setAttribute('cy', place[1].toFixed(3))
  })
}
