import type { Group } from 'three'
import { Batch } from '../batch'
import { type Load, ROLL } from '../load'
import type { Arrow, Materials } from '../materials'
import { BAR, Solid } from '../solid'

/** How thick an arrow is, as a share of the design length; heads are three times that wide. */
const THICK: Readonly<Record<Exclude<Arrow, 'reaction'>, number>> = {
  ...{ force: 0.045, couple: 0.038, part: 0.026, roll: 0.036 },
}
/** Straight pieces of a curved arrow. */
const PIECES = 24

const CONE = [
  [0, 0, 0],
  [1, 0, 0],
  [0, 1, 0],
] as const

/** Arrows for what pulls at the block: the total, the couple as a pair, each cylinder's, the roll. */
export function arrows(
  parent: Group,
  load: Load,
  paint: Materials,
): { move(length: number): void; dispose(): void } {
  const shaft = () => new Solid().turned(BAR, 0, 2 * Math.PI, 12)
  const head = () => new Solid().turned(CONE, 0, 2 * Math.PI, 18)
  const kinds = ['part', 'couple', 'force'] as const
  const drawn = kinds.map((kind, rank) => {
    const pulls = load.pulls.filter((pull) => pull.kind === kind)
    const material = paint[kind]
    const shafts = new Batch(parent, shaft(), pulls.length, material, null, 10 + 2 * rank)
    const heads = new Batch(parent, head(), pulls.length, material, null, 11 + 2 * rank)
    return { kind, pulls, shafts, heads }
  })
  const bend = {
    pieces: new Batch(parent, shaft(), PIECES, paint.roll, null, 16),
    tip: new Batch(parent, head(), 1, paint.roll, null, 17),
  }
  return {
    /** Puts the arrows as the load says; the greatest is `length` long. */
    move: (length: number) => {
      for (const { kind, pulls, shafts, heads } of drawn) {
        const thick = THICK[kind] * length
        let some = false
        for (let index = 0; index < pulls.length; index++) {
          const pull = pulls[index] as (typeof pulls)[number]
          const share = Math.hypot(pull.up, pull.right)
          const long = share * length
          if (long < 0.2 * thick) {
            shafts.put(index, pull.x, pull.y, pull.z, 1, 0, 0, 0, 0)
            heads.put(index, pull.x, pull.y, pull.z, 1, 0, 0, 0, 0)
            continue
          }
          some = true
          const [up, right] = [pull.up / share, pull.right / share]
          // A short arrow is all head, and a smaller one.
          const tip = Math.min(3.6 * thick, 0.75 * long)
          const wide = (tip / 3.6) * 1.45
          const stick = long - tip
          shafts.put(index, pull.x, pull.y, pull.z, up, right, Math.min(thick / 2, wide / 2), stick)
          const [x, y] = [pull.x + right * stick, pull.y + up * stick]
          heads.put(index, x, y, pull.z, up, right, wide, tip)
        }
        shafts.visible = some
        heads.visible = some
        if (!some) continue
        shafts.placed()
        heads.placed()
      }
      curve(bend.pieces, bend.tip, load, length)
    },
    dispose: () => {
      for (const { shafts, heads } of drawn) {
        shafts.dispose()
        heads.dispose()
      }
      bend.pieces.dispose()
      bend.tip.dispose()
    },
  }
}

/** Bends an arrow about the crank axis, from the top clockwise by the share of the roll. */
function curve(pieces: Batch, tip: Batch, { turning, about }: Load, length: number): void {
  const sweep = ROLL.angle * turning
  const radius = ROLL.radius * length
  const thick = THICK.roll * length
  const long = Math.abs(sweep) * radius
  const some = long > 0.2 * thick
  pieces.visible = some
  tip.visible = some
  if (!some) return
  const sense = Math.sign(sweep)
  const point = Math.min(3.6 * thick, 0.75 * long)
  const stick = sweep * (1 - point / long)
  const piece = Math.abs(stick / PIECES)
  const [x, y, z] = about
  for (let index = 0; index < PIECES; index++) {
    const from = (stick * index) / PIECES
    const way = from + (sense * piece) / 2
    // the tangent of a clockwise turn stands at a right angle after the radius
    const [up, right] = [-sense * Math.sin(way), sense * Math.cos(way)]
    const chord = 2 * radius * Math.sin(piece / 2)
    const [px, py] = [x + radius * Math.sin(from), y + radius * Math.cos(from)]
    pieces.put(index, px, py, z, up, right, thick / 2, chord)
  }
  const [up, right] = [-sense * Math.sin(stick), sense * Math.cos(stick)]
  const wide = (point / 3.6) * 1.45
  const [px, py] = [x + radius * Math.sin(stick), y + radius * Math.cos(stick)]
  tip.put(0, px, py, z, up, right, wide, point)
  pieces.placed()
  tip.placed()
}
