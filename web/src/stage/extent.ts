import type { CylinderShown, Scene } from '../exhibit'
import { dot, type Vector } from './vector'

/** A disc that must be visible: its centre (x, y, z), the way it faces, its radius. */
export interface Disc {
  readonly centre: Vector
  readonly facing: Vector
  readonly radius: number
}

/** Room for the number of a cylinder beyond its head, as a share of the bore. */
const LABEL = 0.3

/** What an engine fills: the ends of its bores, and what turns on its shafts. */
export function discsOf(scene: Scene): Disc[] {
  const turning = scene.shafts.flatMap((shaft) => {
    const disc = (z: number, radius: number): Disc => ({
      centre: [shaft.right, shaft.up, z],
      facing: [0, 0, 1],
      radius,
    })
    return [
      disc(shaft.z_from, shaft.journal_radius),
      disc(shaft.z_to, shaft.journal_radius),
      ...shaft.throws.flatMap((pin) =>
        [pin.pin_from, pin.pin_to].map((z) => disc(z, pin.radius + 1.4 * pin.pin_radius)),
      ),
      ...shaft.weights.flatMap((weight) => {
        return [-0.5, 0.5].map((side) =>
          disc(weight.z + side * weight.thickness, weight.outer_radius),
        )
      }),
    ]
  })
  const wheels = scene.gears.flatMap((wheel) => {
    const shaft = scene.shafts[wheel.shaft]
    return shaft
      ? [
          {
            centre: [shaft.right, shaft.up, wheel.z] as Vector,
            facing: [0, 0, 1] as Vector,
            radius: wheel.radius,
          },
        ]
      : []
  })
  return [...turning, ...wheels, ...scene.cylinders.flatMap((cylinder) => ends(scene, cylinder))]
}

function ends(scene: Scene, c: CylinderShown): Disc[] {
  const facing: Vector = [Math.sin(c.bearing), Math.cos(c.bearing), 0]
  const head = facesAnother(c, scene.cylinders) ? 0 : LABEL * c.bore
  return [
    { centre: along(scene, c, c.bore_from), facing, radius: 0.5 * c.bore },
    { centre: along(scene, c, c.bore_to + head), facing, radius: 0.57 * c.bore },
  ]
}

/** A point on a cylinder's axis, so far from its shaft: x, y, z. */
export function along(scene: Scene, cylinder: CylinderShown, distance: number): Vector {
  const shaft = scene.shafts[cylinder.shaft]
  const [up, right] = [Math.cos(cylinder.bearing), Math.sin(cylinder.bearing)]
  const x = (shaft?.right ?? 0) + distance * right + cylinder.offset * up
  const y = (shaft?.up ?? 0) + distance * up - cylinder.offset * right
  return [x, y, cylinder.z]
}

/** Whether another piston works in the same chamber from the other side. */
export function facesAnother(
  cylinder: CylinderShown,
  cylinders: readonly CylinderShown[],
): boolean {
  return cylinders.some(
    (other) =>
      other.chamber === cylinder.chamber && Math.cos(other.bearing - cylinder.bearing) < -0.99,
  )
}

/** Where a bore ends: at its head, or halfway to the piston that faces its own. */
export function boreEnd(scene: Scene, cylinder: CylinderShown): number {
  if (!facesAnother(cylinder, scene.cylinders)) return cylinder.bore_to
  const other = scene.cylinders.find((c) => c !== cylinder && c.chamber === cylinder.chamber)
  if (!other) return cylinder.bore_to
  const [own, facing] = [
    along(scene, cylinder, cylinder.bore_to),
    along(scene, other, other.bore_to),
  ]
  return cylinder.bore_to + Math.hypot(facing[0] - own[0], facing[1] - own[1]) / 2
}

/** The least and the greatest of what discs reach along a direction, written into `out`. */
export function reach(
  discs: readonly Disc[],
  axis: Vector,
  out: [number, number],
): [number, number] {
  out[0] = Number.POSITIVE_INFINITY
  out[1] = Number.NEGATIVE_INFINITY
  for (const { centre, facing, radius } of discs) {
    const lean = dot(axis, facing)
    const half = radius * Math.sqrt(Math.max(0, 1 - lean * lean))
    const at = dot(axis, centre)
    out[0] = Math.min(out[0], at - half)
    out[1] = Math.max(out[1], at + half)
  }
  return out
}
