import type { Group } from 'three'
import type { CylinderShown, Scene } from '../../exhibit'
import { Batch } from '../batch'
import { along, boreEnd, facesAnother } from '../extent'
import type { Materials } from '../materials'
import { BAR, Solid } from '../solid'

/** Thickness of a cylinder head as a share of the bore, and how much wider than the bore it is. */
const HEAD = 0.09
const BRIM = 1.14

/** Cylinder bores of glass, each with its head; opposed pistons share a bore and have none. */
export function bores(parent: Group, scene: Scene, paint: Materials): Batch[] {
  const { cylinders } = scene
  const tube = new Solid().turned([
    [1, 0, 0],
    [1, 1, 0],
  ])
  const tubes = new Batch(parent, tube, cylinders.length, paint.glass, paint.glassLines, 4)
  cylinders.forEach((c, index) => {
    stand(tubes, index, c, scene, c.bore_from, boreEnd(scene, c) - c.bore_from, c.bore / 2)
  })
  tubes.placed()
  const headed = cylinders.filter((c) => !facesAnother(c, cylinders))
  if (headed.length === 0) return [tubes]
  const disc = new Solid().turned(BAR)
  const heads = new Batch(parent, disc, headed.length, paint.glass, paint.glassLines, 4)
  headed.forEach((c, index) => {
    stand(heads, index, c, scene, c.bore_to, HEAD * c.bore, (BRIM * c.bore) / 2)
  })
  heads.placed()
  return [tubes, heads]
}

/** Puts an item of height and radius 1 on a cylinder's axis, `from` the shaft. */
export function stand(
  batch: Batch,
  index: number,
  cylinder: CylinderShown,
  scene: Scene,
  from: number,
  high: number,
  radius: number,
): void {
  const [x, y, z] = along(scene, cylinder, from)
  batch.put(index, x, y, z, Math.cos(cylinder.bearing), Math.sin(cylinder.bearing), radius, high)
}
