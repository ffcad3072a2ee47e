import type { GearShown, Scene } from '../../exhibit'

/** Share of the radii by which the distance of shafts of meshing gears may differ. */
const NEAR = 0.03

/**
 * The bearing of the first tooth of every gear at theta = 0, so that the teeth of two that mesh
 * stand in each other's gaps.
 *
 * On the line from gear A to gear B, at bearing b, a tooth of A stands `a` of a pitch clockwise of
 * the line. A point of B that is
 * clockwise of the line moves the other way, so B's tooth has to stand `-(a + 1/2)` of its pitch
 * from it.
 */
export function toothBearings(scene: Scene): number[] {
  const { gears } = scene
  const bearings = gears.map((): number | null => null)
  const place = (start: number) => {
    const queue = [start]
    bearings[start] ??= 0
    for (let index = queue.shift(); index !== undefined; index = queue.shift()) {
      for (let other = 0; other < gears.length; other++) {
        if (bearings[other] !== null) continue
        const line = lineOf(scene, gears[index] as GearShown, gears[other] as GearShown)
        if (line === null) continue
        const [own, next] = [pitch(gears[index] as GearShown), pitch(gears[other] as GearShown)]
        const share = ((bearings[index] as number) - line) / own
        bearings[other] = line + Math.PI - next * (share + 0.5)
        queue.push(other)
      }
    }
  }
  for (let index = 0; index < gears.length; index++) if (bearings[index] === null) place(index)
  return bearings.map((bearing) => bearing ?? 0)
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
