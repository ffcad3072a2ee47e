import { DynamicDrawUsage, type Group, InstancedBufferAttribute } from 'three'
import type { Exhibit, StrokeColours } from '../../exhibit'
import type { Places } from '../../motion'
import { Batch } from '../batch'
import { boreEnd } from '../extent'
import type { Materials } from '../materials'
import { BAR, Solid } from '../solid'
import { tint, windowsOf } from '../strokes'
import { stand } from './bores'
import type { Part } from './part'

/** The charge of the cylinders: a volume between crown and head, tinted by its stroke. */
export function glow(
  parent: Group,
  exhibit: Exhibit,
  colours: StrokeColours,
  paint: Materials,
): Part & { visible: boolean } {
  const { scene, cycle_deg: cycle } = exhibit
  const windows = windowsOf(exhibit, colours)
  const { cylinders } = scene
  const body = new Solid().turned(BAR, 0, 2 * Math.PI, 28)
  const batch = new Batch(parent, body, cylinders.length, paint.glow, null, 2)
  const hues = new InstancedBufferAttribute(new Float32Array(4 * cylinders.length), 4)
  hues.setUsage(DynamicDrawUsage)
  batch.attribute('hue', hues)
  const ends = cylinders.map((c) => boreEnd(scene, c))
  const axes = cylinders.map((c) => [Math.cos(c.bearing), Math.sin(c.bearing)] as const)
  const part = {
    visible: true,
    move: ({ piston }: Places, theta: number) => {
      batch.visible = part.visible
      if (!part.visible) return
      const degrees = (theta * 180) / Math.PI
      for (let index = 0; index < cylinders.length; index++) {
        const c = cylinders[index] as (typeof cylinders)[number]
        const shaft = scene.shafts[c.shaft]
        const axis = axes[index] as readonly [number, number]
        const up = (piston[2 * index] as number) - (shaft?.up ?? 0)
        const right = (piston[2 * index + 1] as number) - (shaft?.right ?? 0)
        const crown = up * axis[0] + right * axis[1] + c.pin_height
        const high = Math.max(1e-6 * c.bore, (ends[index] as number) - crown)
        stand(batch, index, c, scene, crown, high, 0.49 * c.bore)
        tint(windows[index] ?? [], degrees, cycle, hues.array as Float32Array, 4 * index)
      }
      hues.needsUpdate = true
      batch.placed()
    },
    dispose: () => batch.dispose(),
  }
  return part
}
