import type { Group } from 'three'
import type { CylinderShown, Scene } from '../../exhibit'
import type { Places } from '../../motion'
import { alike, Batch } from '../batch'
import type { Materials } from '../materials'
import { band, circle, strip, towards } from '../outlines'
import { Solid, solidOf } from '../solid'
import type { Part } from './part'
import { PIN, shank } from './pistons'

/** What a rod's shape depends on, beside its own record. */
interface Rod {
  readonly cylinder: CylinderShown
  readonly index: number
  /** Radius of the pin its big end sits on. */
  readonly pin: number
  /** Width of the blade in a fork, and of the slaves in a master. */
  readonly gap: number
  /** Knuckle pins it carries: bearing from the rod, distance, radius. */
  readonly knuckles: readonly { angle: number; radius: number; pin: number }[]
}

export function rods(parent: Group, scene: Scene, paint: Materials): Part {
  const key = (rod: Rod) =>
    JSON.stringify(['rod', sizes(rod.cylinder), rod.pin, rod.gap, rod.knuckles])
  const groups = alike(rodsOf(scene), key)
  const batches = groups.map((group) => {
    const first = group[0] as Rod
    const inner = first.cylinder.rod === 'slave' || first.cylinder.rod === 'blade'
    const colour = inner ? paint.slave : paint.rod
    const solid = solidOf(key(first), () => shapeOf(first))
    return new Batch(parent, solid, group.length, colour, paint.partLines)
  })
  return {
    move: ({ bigEnd, direction }: Places) => {
      for (let which = 0; which < groups.length; which++) {
        const group = groups[which] as Rod[]
        const batch = batches[which] as Batch
        for (let place = 0; place < group.length; place++) {
          const { index, cylinder } = group[place] as Rod
          const up = 2 * index
          batch.put(
            place,
            bigEnd[up + 1] as number,
            bigEnd[up] as number,
            cylinder.rod_z,
            direction[up] as number,
            direction[up + 1] as number,
          )
        }
        batch.placed()
      }
    },
    dispose: () => {
      for (const batch of batches) batch.dispose()
    },
  }
}

function sizes(c: CylinderShown): (number | string)[] {
  return [c.rod, c.rod_length, c.rod_width, c.bore]
}

function rodsOf(scene: Scene): Rod[] {
  const { cylinders } = scene
  const crankPin = (c: CylinderShown) =>
    scene.shafts[c.shaft]?.throws[c.throw]?.pin_radius ?? 0.2 * c.crank_radius
  const slavesOf = (index: number) => cylinders.filter((other) => other.master === index)
  const knuckle = (c: CylinderShown) => {
    const count = c.master < 0 ? 0 : slavesOf(c.master).length
    const room = 0.4 * 2 * c.knuckle_radius * Math.sin(Math.PI / Math.max(4, count + 1))
    return Math.min(0.55 * crankPin(c), room, PIN * c.bore * 1.1)
  }
  return cylinders.map((cylinder, index): Rod => {
    const slaves = slavesOf(index)
    const beside = cylinders.filter(
      (c) => c.rod === 'blade' && c.shaft === cylinder.shaft && c.throw === cylinder.throw,
    )
    const between = cylinder.rod === 'fork' ? beside : slaves
    return {
      cylinder,
      index,
      pin: cylinder.master < 0 ? crankPin(cylinder) : knuckle(cylinder),
      gap: Math.max(0, ...between.map((c) => c.rod_width)),
      knuckles: slaves.map((c) => ({
        angle: c.knuckle_angle,
        radius: c.knuckle_radius,
        pin: knuckle(c),
      })),
    }
  })
}

/** A rod, big end at the origin, piston pin up: I-section, eyes, fork, master's cheeks. */
function shapeOf(rod: Rod): Solid {
  const { cylinder: c, pin } = rod
  const solid = new Solid()
  const big = (c.rod === 'slave' ? 1.5 : 1.36) * pin
  const small = 1.55 * PIN * c.bore
  const depth = shank(c)
  const foot = shapedFoot(solid, rod, big)
  solid.prism(circle(0, c.rod_length, small, 28), -depth / 2, depth / 2)
  const low = 0.8 * foot
  const high = c.rod_length - 0.82 * small
  const wide = Math.min(0.62 * big, 0.34 * c.bore)
  const narrow = Math.min(0.66 * small, 0.9 * wide)
  solid.prism(strip(low, high, wide, narrow), -0.2 * depth, 0.2 * depth, 0.55)
  for (const side of [-1, 1]) {
    solid.prism(flange(low, high, wide, narrow, side), -0.42 * depth, 0.42 * depth)
  }
  return solid
}

/** One of the two ribs of an I-section. */
function flange(
  low: number,
  high: number,
  wide: number,
  narrow: number,
  side: number,
): [number, number][] {
  const rib: [number, number][] = [
    [0.62 * wide, low],
    [wide, low],
    [narrow, high],
    [0.62 * narrow, high],
  ]
  return side > 0 ? rib : rib.map(([x, y]): [number, number] => [-x, y]).reverse()
}

/** The big end; gives its reach along the rod. */
function shapedFoot(solid: Solid, { cylinder: c, pin, gap, knuckles }: Rod, big: number): number {
  const half = c.rod_width / 2
  if (knuckles.length > 0) return cheeks(solid, half, gap / 2, pin, big, knuckles)
  if (c.rod === 'fork' && gap > 0 && gap < c.rod_width) {
    for (const side of [-1, 1]) {
      solid.prism(circle(0, 0, big, 36), (side * gap) / 2, side * half)
      solid.prism(strip(0.5 * big, 1.9 * big, 0.8 * big, 0.55 * big), (side * gap) / 2, side * half)
    }
    solid.prism(strip(1.35 * big, 1.9 * big, 0.68 * big, 0.55 * big), -half, half)
    return 1.9 * big
  }
  solid.prism(circle(0, 0, big, 36), -half, half)
  // The cap's parting line and the seats of its bolts.
  if (c.rod !== 'slave')
    solid.prism(strip(-0.62 * big, 0.5 * big, 1.16 * big, 1.16 * big), -0.36 * half, 0.36 * half)
  return big
}

/** Two plates that carry the knuckle pins, with room for the slaves between. */
function cheeks(
  solid: Solid,
  half: number,
  gap: number,
  pin: number,
  big: number,
  knuckles: Rod['knuckles'],
): number {
  const reach = Math.max(...knuckles.map((k) => k.radius + 1.5 * k.pin))
  const inner = Math.min(gap * 1.06, 0.72 * half)
  for (const side of [-1, 1]) {
    if (knuckles.length > 3) solid.prism(circle(0, 0, reach, 48), side * inner, side * half)
    else
      for (const k of knuckles)
        solid.prism(band(big, k.radius, k.angle, 1.5 * k.pin), side * inner, side * half)
  }
  const eye = Math.max(1.15 * pin, Math.min(big, 0.9 * (reach - 2 * (knuckles[0]?.pin ?? 0))))
  solid.prism(circle(0, 0, eye, 36), -half, half)
  for (const k of knuckles) {
    const [x, y] = towards(k.angle)
    solid.prism(circle(x * k.radius, y * k.radius, k.pin, 20), -1.04 * half, 1.04 * half, 1)
  }
  return knuckles.length > 3 ? reach : big
}
