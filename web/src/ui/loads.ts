import type { LoadShown } from '../exhibit'
import { coefficientsOf, type Plane, phaseOf, turn, vectorAt } from '../phasor'

/** Where a load is looked at from: the block, or its own shaft, which turns. */
export type Frame = 'block' | 'shaft'

/** Dots on the path of a turn. */
export const STEPS = 4
const SAMPLES = 180

/** The load [up, right] at a crank angle; the same array every time. */
export function loadVector(
  load: LoadShown,
  orders: readonly number[],
  sense: number,
  frame: Frame,
): (theta: number) => Plane {
  const coefficients = coefficientsOf(load.load)
  const phase = phaseOf(orders.length, sense)
  const rate = frame === 'shaft' ? sense * load.speed_ratio : 0
  const place: Plane = [0, 0]
  return (theta) => {
    vectorAt(coefficients, turn(phase, orders, theta, null), place)
    if (rate !== 0) {
      // back by the angle that the shaft has turned
      const [up, right] = place
      const cos = Math.cos(rate * theta)
      const sin = Math.sin(rate * theta)
      place[0] = up * cos + right * sin
      place[1] = right * cos - up * sin
    }
    return place
  }
}

/** The place of a vector in a drawing whose y points down. */
export function pointText([up, right]: Plane, scale: number): [string, string] {
  return [(right * scale).toFixed(4), (-up * scale).toFixed(4)]
}

/** The path over some turns, and the places at every quarter of the first. */
export function pathOf(
  at: (theta: number) => Plane,
  turns: number,
  scale: number,
): { readonly path: string; readonly dots: readonly [string, string][] } {
  const points = Array.from({ length: SAMPLES * turns + 1 }, (_, index) =>
    pointText(at((2 * Math.PI * index) / SAMPLES), scale).join(' '),
  )
  const dots = Array.from({ length: STEPS }, (_, index) =>
    pointText(at((2 * Math.PI * index) / STEPS), scale),
  )
  return { path: `M${points.join('L')}`, dots }
}

/** How far a label stands from its dot, and how close two may come, across and upright. */
const AWAY = [0.25, 0.16] as const
const ROOM = [0.45, 0.17] as const

/** The places of labels outside of dots; null for one that would stand on another. */
export function labelsOf(
  dots: readonly (readonly [string, string])[],
): ([number, number] | null)[] {
  const kept: [number, number][] = []
  return dots.map(([across, upright]) => {
    const [x, y] = [Number(across), Number(upright)]
    const far = Math.hypot(x, y)
    const [right, down] = far > 0 ? [x / far, y / far] : [0, 1]
    const place: [number, number] = [round(x + AWAY[0] * right), round(y + AWAY[1] * down)]
    const crowded = kept.some(
      ([otherX, otherY]) =>
        Math.abs(otherX - place[0]) < ROOM[0] && Math.abs(otherY - place[1]) < ROOM[1],
    )
    if (crowded) return null
    kept.push(place)
    return place
  })
}

function round(value: number): number {
  return Math.round(value * 1000) / 1000
}
