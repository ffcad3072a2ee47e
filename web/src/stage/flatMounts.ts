import type { Exhibit } from '../exhibit'
import { straight } from './arrow'
import type { Body } from './bodies'
import { BOX, BOXES, FORCES, KINDS, type Mounted } from './mounts'
import { css } from './palette'
import { type Pane, placed } from './panes'
import type { Pen } from './pen'
import type { Instant } from './picture'

/** A body on the screen: points [x, y], nearness, its place along z, the first point of the nearer cap. */
export interface Flattened {
  readonly z: number
  readonly body: Body
  readonly flat: Float64Array
  readonly depth: number
  readonly nearer: number
}

/** The boxes of mounts as bodies, which have their places at each instant. */
export function mountBodies({ mounts }: Exhibit): Body[] {
  return (mounts?.mounts ?? []).flatMap((_, index) =>
    KINDS.map((kind): Body => {
      const fill = kind === 'rubber' ? 'mount' : 'plate'
      const none = { points: new Float64Array(), bearing: 0, mark: null }
      return { ...none, carrier: 'mount', index, fill }
    }),
  )
}

/** The eight corners of a box: which way from where it begins along each of its axes. */
const CORNERS = [
  [-1, 0, -1],
  [1, 0, -1],
  [1, 0, 1],
  [-1, 0, 1],
  [-1, 1, -1],
  [1, 1, -1],
  [1, 1, 1],
  [-1, 1, 1],
] as const

/** The boxes of mounts on the screen; they stand beside the block and do not move with it. */
export function flattenedMounts(
  bodies: readonly Body[],
  { boxes }: Mounted,
  pane: Pane,
): Flattened[] {
  return bodies.map((body, place) => {
    const first = place * BOX
    const number = (index: number) => boxes[first + index] as number
    const flat = new Float64Array(2 * CORNERS.length)
    const depths = [0, 0] as [number, number]
    let z = 0
    CORNERS.forEach(([across, along, deep], corner) => {
      const at = (axis: number) =>
        number(axis) +
        across * number(3 + axis) +
        along * number(6 + axis) +
        deep * number(9 + axis)
      const [right, down, near] = placed(pane, [at(0), at(1), at(2)])
      flat[2 * corner] = right
      flat[2 * corner + 1] = down
      depths[along] += near / 4
      z += at(2) / CORNERS.length
    })
    const nearer = depths[1] > depths[0] ? CORNERS.length / 2 : 0
    return { body, flat, depth: (depths[0] + depths[1]) / 2, z, nearer }
  })
}

/** The forces of mounts on what is below them. */
export function mountArrows(to: Pen, { mounted, arrow, palette, view }: Instant, pane: Pane): void {
  if (!mounted?.shake || !view.arrows.force) return
  const { boxes, feet, forces } = mounted
  const long = FORCES * arrow
  for (let index = 0; index < boxes.length / BOX / BOXES; index++) {
    const [x, y, z] = feet.subarray(3 * index, 3 * index + 3) as unknown as Triple
    const [fx, fy, fz] = forces.subarray(3 * index, 3 * index + 3) as unknown as Triple
    const tip = placed(pane, [x + long * fx, y + long * fy, z + long * fz])
    straight(to, placed(pane, [x, y, z]), tip, css(palette.reaction), 3)
  }
}

type Triple = [number, number, number]
