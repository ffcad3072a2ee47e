import type { Group } from 'three'
import type { CylinderShown, Scene } from '../../exhibit'
import type { Places } from '../../motion'
import { alike, Batch } from '../batch'
import type { Materials } from '../materials'
import { circle } from '../outlines'
import { Solid, solidOf } from '../solid'
import type { Part } from './part'

/** Radius of a piston pin as a share of the bore. */
export const PIN = 0.125
/** How far the bosses of the pin reach to either side, as a share of the bore. */
const BOSSES = 0.36

export interface Pistons extends Part {
  /** Which of which batch each cylinder is, in the order of the scene. */
  readonly places: readonly { batch: Batch; index: number }[]
}

export function pistons(parent: Group, scene: Scene, paint: Materials): Pistons {
  const numbered = scene.cylinders.map((cylinder, index) => ({ cylinder, index }))
  const key = ({ cylinder: c }: (typeof numbered)[number]) =>
    ['piston', c.bore, c.pin_height, c.skirt, shank(c)].join()
  const groups = alike(numbered, key)
  const batches = groups.map((group) => {
    const first = group[0] as (typeof group)[number]
    const solid = solidOf(key(first), () => piston(first.cylinder))
    return new Batch(parent, solid, group.length, paint.piston, paint.partLines)
  })
  const places = numbered.map(({ index }) => {
    const which = groups.findIndex((group) => group.some((one) => one.index === index))
    const place = groups[which]?.findIndex((one) => one.index === index) ?? 0
    return { batch: batches[which] as Batch, index: place }
  })
  const axes = scene.cylinders.map(({ bearing }) => [Math.cos(bearing), Math.sin(bearing)] as const)
  const z = scene.cylinders.map((cylinder) => cylinder.z)
  return {
    places,
    move: ({ piston: at }: Places) => {
      for (let index = 0; index < z.length; index++) {
        const place = places[index] as (typeof places)[number]
        const axis = axes[index] as readonly [number, number]
        place.batch.put(
          place.index,
          at[2 * index + 1] as number,
          at[2 * index] as number,
          z[index] as number,
          axis[0],
          axis[1],
        )
      }
      for (const batch of batches) batch.placed()
    },
    dispose: () => {
      for (const batch of batches) batch.dispose()
    },
  }
}

/** How thick a rod is where it runs through its piston. */
export function shank(cylinder: CylinderShown): number {
  return Math.min(cylinder.rod_width, 0.26 * cylinder.bore)
}

/** A piston, its pin at the origin, crown up: ring lands, skirts, bosses and pin. */
function piston(cylinder: CylinderShown): Solid {
  const { bore, pin_height: crown, skirt } = cylinder
  const radius = 0.492 * bore
  const wall = 0.055 * bore
  const pin = PIN * bore
  const belt = Math.max(0.42 * crown, Math.min(1.25 * pin, 0.8 * crown))
  const solid = new Solid()
  const land = (crown - belt) / 8
  const rings = [1.6, 3.6, 5.6].flatMap((place): [number, number, number][] => [
    [radius, belt + place * land, 0],
    [radius, belt + place * land, 1],
    [radius, belt + (place + 0.7) * land, 1],
    [radius, belt + (place + 0.7) * land, 0],
  ])
  const under = Math.min(crown - 0.08 * bore, belt + 3 * land)
  solid.turned([
    [0, under, 0],
    [radius - wall, under, 0],
    [radius - wall, belt, 0],
    [radius, belt, 0],
    ...rings,
    [radius, crown - 0.015 * bore, 0],
    [radius - 0.015 * bore, crown, 0],
    [0, crown, 0],
  ])
  const shell: [number, number, number][] = [
    [radius - wall, -skirt, 0],
    [radius, -skirt, 0],
    [radius, belt, 0],
    [radius - wall, belt, 0],
    [radius - wall, -skirt, 0],
  ]
  const half = 0.72
  solid.turned(shell, -half, half, 14)
  solid.turned(shell, Math.PI - half, Math.PI + half, 14)
  const inner = Math.min(0.53 * shank(cylinder), (BOSSES - 0.06) * bore)
  for (const side of [-1, 1]) {
    solid.prism(boss(1.75 * pin, under), side * inner, side * BOSSES * bore)
  }
  solid.prism(circle(0, 0, pin, 24), -(BOSSES + 0.012) * bore, (BOSSES + 0.012) * bore, 1)
  return solid
}

/** The outline of a pin boss that hangs from the crown. */
function boss(radius: number, top: number): [number, number][] {
  const round = Array.from({ length: 17 }, (_, step): [number, number] => {
    const angle = Math.PI + (Math.PI * step) / 16
    return [radius * Math.cos(angle), radius * Math.sin(angle)]
  })
  return [...round, [radius, top], [-radius, top]]
}
