import type { Scene } from '../exhibit'
import { along } from '../stage/extent'
import { hull } from '../stage/hull'

/** A view of the layout of mounts: as on the drawing sheet, the side from the right. */
export type Side = 'front' | 'side' | 'plan'
export const SIDES: readonly [Side, ...Side[]] = ['front', 'side', 'plan']
/** A place: up, right, z; metres. */
export type Place = readonly [number, number, number]
/** On a view: to the right, down; metres. */
export type Spot = readonly [number, number]

/** Where a place is seen. */
export function seen(side: Side, [up, right, z]: Place): Spot {
  if (side === 'front') return [right, -up]
  return side === 'side' ? [-z, -up] : [-z, right]
}

/** The place that is seen at a spot, as far from the eye as `at`. */
export function placeAt(side: Side, [x, y]: Spot, at: Place): Place {
  if (side === 'front') return [-y, x, at[2]]
  return side === 'side' ? [-y, at[1], -x] : [at[0], y, -x]
}

/** The corners of the outlines of cylinders on a view. */
export function outlinesOf(side: Side, scene: Scene): Spot[][] {
  return scene.cylinders.map((c) => {
    const [up, right] = [Math.cos(c.bearing), Math.sin(c.bearing)]
    const half = c.bore / 2
    const corners = [c.bore_from, c.bore_to].flatMap((far) => {
      const [x, y, z] = along(scene, c, far)
      return [-half, half].flatMap((across) =>
        [-half, half].map((deep) => seen(side, [y - across * right, x + across * up, z + deep])),
      )
    })
    return hull(corners.flat()).map((index) => corners[index] as Spot)
  })
}

/** The line of the first shaft on a view, or its middle from the front. */
export function shaftOf(side: Side, scene: Scene): readonly [Spot, Spot] {
  const [shaft] = scene.shafts
  const [up, right] = [shaft?.up ?? 0, shaft?.right ?? 0]
  const [front, rear] = [scene.high[2], scene.low[2]]
  return [seen(side, [up, right, front]), seen(side, [up, right, rear])]
}

/** What a view must have room for: left, upper edge, width, height; metres. */
export interface Frame {
  readonly x: number
  readonly y: number
  readonly width: number
  readonly height: number
}

/** The part of a line within a frame; null where it passes by (after Y. Liang and B. Barsky). */
export function within(frame: Frame, from: Spot, to: Spot): readonly [Spot, Spot] | null {
  let [first, last] = [0, 1]
  const ends = [
    [frame.x, frame.x + frame.width],
    [frame.y, frame.y + frame.height],
  ] as const
  for (const axis of [0, 1] as const) {
    const [low, high] = ends[axis]
    const way = to[axis] - from[axis]
    if (Math.abs(way) < 1e-12) {
      if (from[axis] < low || from[axis] > high) return null
      continue
    }
    const cuts = [(low - from[axis]) / way, (high - from[axis]) / way]
    first = Math.max(first, Math.min(...cuts))
    last = Math.min(last, Math.max(...cuts))
  }
  if (first > last) return null
  const at = (share: number): Spot => [
    from[0] + share * (to[0] - from[0]),
    from[1] + share * (to[1] - from[1]),
  ]
  return [at(first), at(last)]
}

/** Room beside what is drawn, as a share of it, and the least share of the breadth that is high. */
const [ROOM, LEAST] = [0.16, 0.5]

/** The frame about an engine and some places. */
export function frameOf(side: Side, scene: Scene, places: readonly Place[]): Frame {
  const { low, high } = scene
  const spots = [
    ...outlinesOf(side, scene).flat(),
    ...shaftOf(side, scene),
    ...places.map((place) => seen(side, place)),
    seen(side, [low[0], low[1], low[2]]),
    seen(side, [high[0], high[1], high[2]]),
  ]
  const [xs, ys] = [spots.map(([x]) => x), spots.map(([, y]) => y)]
  const [left, top] = [Math.min(...xs), Math.min(...ys)]
  const [wide, tall] = [Math.max(...xs) - left, Math.max(...ys) - top]
  const room = ROOM * Math.max(wide, tall)
  const height = Math.max(tall + 2 * room, LEAST * (wide + 2 * room))
  const width = Math.max(wide + 2 * room, height)
  return {
    x: left - (width - wide) / 2,
    y: top - (height - tall) / 2,
    width,
    height,
  }
}
