import type { GearShown, Scene } from '../../exhibit'

/** Share of the radii by which the distance of shafts of meshing gears may differ. */
const NEAR = 0.03

/**
 * The bearing of the first tooth of every gear at theta = 0, so that the teeth of two that mesh
 * stand in each other's gaps.
 *
 * On the line from gear A to gear B, at bearing b, a tooth of A stands `a` of a pitch clockwise of
 * the line. A point of B that is clockwise of the line moves the other way, so B's tooth has to
 * stand `-(a + 1/2)` of its pitch from it.
 */
export function toothBearings(scene: Scene): number[] {
  const { gears } = scene
  const bearings: number[] = []
  const place = (index: number, bearing: number): void => {
    bearings[index] = bearing
    const own = gears[index] as GearShown
    gears.forEach((other, next) => {
      const line = bearings[next] === undefined ? lineOf(scene, own, other) : null
      if (line === null) return
      const share = (bearing - line) / pitch(own)
      place(next, line + Math.PI - pitch(other) * (share + 0.5))
    })
  }
  for (let index = 0; index < gears.length; index++)
    if (bearings[index] === undefined) place(index, 0)
  return bearings
}

function pitch(gear: GearShown): number {
  return (2 * Math.PI) / gear.teeth
}

/** The bearing from one gear to another that it meshes with, null if it does not. */
function lineOf(scene: Scene, one: GearShown, other: GearShown): number | null {
  const [a, b] = [scene.shafts[one.shaft], scene.shafts[other.shaft]]
  if (!a || !b || a === b || Math.abs(one.z - other.z) > (one.thickness + other.thickness) / 2)
    return null
  const distance = Math.hypot(b.up - a.up, b.right - a.right)
  const both = one.radius + other.radius
  return Math.abs(distance - both) < NEAR * both ? Math.atan2(b.right - a.right, b.up - a.up) : null
}
