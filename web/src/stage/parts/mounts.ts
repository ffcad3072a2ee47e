import { Group, type Scene } from 'three'
import { Batch } from '../batch'
import type { Materials } from '../materials'
import { BOX, BOXES, FORCES, KINDS, type Mounted } from '../mounts'
import { BAR, Solid } from '../solid'

/** How thick the arrow of a force is, as a share of the longest; its head is three times that. */
const THICK = 0.06

/** A box of breadth and depth 2, from 0 to 1 along y. */
const box = (tint: number) =>
  new Solid().prism(
    [
      [-1, 0],
      [1, 0],
      [1, 1],
      [-1, 1],
    ],
    -1,
    1,
    tint,
  )

/** The mounts, which stand beside the block and not on it, and what goes through them. */
export function mounts(scene: Scene, count: number, paint: Materials) {
  const parent = new Group()
  parent.matrixAutoUpdate = false
  scene.add(parent)
  const rubber = new Batch(parent, box(0), count, paint.mount, paint.partLines)
  const metal = new Batch(parent, box(1), 3 * count, paint.mount, paint.partLines)
  const shafts = new Batch(
    parent,
    new Solid().turned(BAR, 0, 2 * Math.PI, 12),
    count,
    paint.reaction,
    null,
    18,
  )
  const cone = [
    [0, 0, 0],
    [1, 0, 0],
    [0, 1, 0],
  ] as const
  const tips = new Solid().turned(cone, 0, 2 * Math.PI, 18)
  const heads = new Batch(parent, tips, count, paint.reaction, null, 19)
  const item = new Float64Array(BOX)
  return {
    /** Puts them as they are; the greatest force is as long as `arrow` says, 0 for no arrows. */
    move(mounted: Mounted, arrow: number): void {
      const { boxes, forces, feet } = mounted
      for (let index = 0; index < count; index++) {
        for (let part = 0; part < BOXES; part++) {
          const from = (index * BOXES + part) * BOX
          if (KINDS[part] === 'rubber') rubber.set(index, boxes, from)
          else metal.set(3 * index + part - 1, boxes, from)
        }
      }
      rubber.placed()
      metal.placed()
      const long = FORCES * arrow
      shafts.visible = long > 0
      heads.visible = long > 0
      if (!(long > 0)) return
      for (let index = 0; index < count; index++) {
        const length = long * size(forces, 3 * index)
        const thick = THICK * long
        const tip = length < 0.2 * thick ? 0 : Math.min(3.6 * thick, 0.75 * length)
        stand(item, feet, forces, 3 * index, 0, length - tip, Math.min(thick / 2, tip / 3.6))
        shafts.set(index, item, 0)
        stand(item, feet, forces, 3 * index, length - tip, tip, (tip / 3.6) * 1.45)
        heads.set(index, item, 0)
      }
      shafts.placed()
      heads.placed()
    },
    /** The matrices they were drawn with. */
    drawn: { rubber, metal },
    dispose(): void {
      for (const batch of [rubber, metal, shafts, heads]) batch.dispose()
      parent.removeFromParent()
    },
  }
}

const size = (vectors: Float64Array, at: number): number =>
  Math.hypot(vectors[at] as number, vectors[at + 1] as number, vectors[at + 2] as number)

/** Stands something round along a vector, `from` its foot; nothing is of no size. */
function stand(
  out: Float64Array,
  feet: Float64Array,
  vectors: Float64Array,
  at: number,
  from: number,
  long: number,
  radius: number,
): void {
  const length = size(vectors, at)
  const share = long > 0 && length > 0 ? 1 / length : 0
  const x = share * (vectors[at] as number)
  const y = share * (vectors[at + 1] as number)
  const z = share * (vectors[at + 2] as number)
  // any direction across: from the axis that is least along it
  const level = Math.hypot(x, y)
  const [ax, ay] = level > 0.1 ? [y / level, -x / level] : [1, 0]
  const az = level > 0.1 ? 0 : -x / (z || 1)
  const norm = radius / Math.hypot(ax, ay, az)
  out[0] = (feet[at] as number) + from * x
  out[1] = (feet[at + 1] as number) + from * y
  out[2] = (feet[at + 2] as number) + from * z
  out[3] = ax * norm
  out[4] = ay * norm
  out[5] = az * norm
  out[6] = long * x
  out[7] = long * y
  out[8] = long * z
  // across x along, so that they are right-handed
  out[9] = norm * (ay * z - az * y)
  out[10] = norm * (az * x - ax * z)
  out[11] = norm * (ax * y - ay * x)
}
