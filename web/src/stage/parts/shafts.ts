import type { Group } from 'three'
import type { GearShown, Scene, ShaftShown, ThrowShown } from '../../exhibit'
import { type Places, turned } from '../../motion'
import { Batch } from '../batch'
import type { Materials } from '../materials'
import { band, circle, gear, type Outline, sector, towards } from '../outlines'
import { Solid, solidOf } from '../solid'
import type { Crank, Mark } from '../twist'
import { toothBearings } from './meshing'
import type { Part } from './part'

export interface Shafts extends Part {
  /** What each shaft of the scene is drawn as. */
  readonly drawn: readonly Batch[]
}

/**
 * Crankshafts, balance shafts and the gears on them; `sense` is that of the exhibit. The first shaft
 * can twist where it is given as a `crank`; gears turn evenly.
 */
export function shafts(
  parent: Group,
  scene: Scene,
  sense: number,
  paint: Materials,
  crank: Crank | null = null,
): Shafts {
  const turning = scene.shafts.map((shaft, index) => {
    const twists = index === 0 ? crank : null
    const colour = shaft.kind === 'crankshaft' ? paint.crankshaft : paint.balanceShaft
    const [own, ink] = twists ? [paint.twisting, paint.twistingLines] : [colour, paint.lines]
    const key = JSON.stringify(['shaft', shaft, twists?.places])
    const solid = solidOf(key, () => shapeOf(shaft, twists))
    const batch = new Batch(parent, solid, 1, own, ink)
    return { batch, shaft, z: 0, start: 0 }
  })
  const drawn = turning.map(({ batch }) => batch)
  const bearings = toothBearings(scene)
  scene.gears.forEach((wheel, index) => {
    const shaft = scene.shafts[wheel.shaft]
    if (!shaft) return
    const key = JSON.stringify(['gear', wheel, shaft.journal_radius])
    const solid = solidOf(key, () => wheelOf(wheel, shaft))
    const batch = new Batch(parent, solid, 1, paint.gear, paint.lines)
    turning.push({ batch, shaft, z: wheel.z, start: bearings[index] ?? 0 })
  })
  return {
    drawn,
    move: (_: Places, theta: number) => {
      for (const { batch, shaft, z, start } of turning) {
        const bearing = start + turned(shaft, sense, theta)
        batch.put(0, shaft.right, shaft.up, z, Math.cos(bearing), Math.sin(bearing))
        batch.placed()
      }
    },
    dispose: () => {
      for (const { batch } of turning) batch.dispose()
    },
  }
}

/** A shaft as it stands at theta = 0, its axis at the origin: journals, pins, webs, weights. */
function shapeOf(shaft: ShaftShown, crank: Crank | null): Solid {
  const solid = new Solid()
  for (const [from, to] of journals(shaft))
    solid
      .marked(crank?.journal(from, to) ?? null)
      .prism(circle(0, 0, shaft.journal_radius, 36), from, to, 1)
  shaft.throws.forEach((pin, index) => {
    const [x, y] = towards(pin.angle)
    const outline = circle(x * pin.radius, y * pin.radius, pin.pin_radius, 36)
    for (const [from, to, mark] of halves(pin, index, crank))
      solid.marked(mark).prism(outline, from, to, 1)
  })
  for (const web of shaft.webs) {
    const pin = shaft.throws[web.throw]
    if (!pin) continue
    solid.marked(crank?.web(web) ?? null).prism(cheek(shaft, pin), web.z_from, web.z_to)
  }
  for (const weight of shaft.weights) {
    const { inner_radius, outer_radius, angle, half_angle, z, thickness } = weight
    const inner =
      shaft.kind === 'crankshaft' ? Math.min(inner_radius, shaft.journal_radius) : inner_radius
    const outline = sector(inner, outer_radius, angle, half_angle)
    solid.marked(crank?.weight(weight) ?? null).prism(outline, z - thickness / 2, z + thickness / 2)
  }
  return solid
}

/** A pin along z as it is drawn: whole, or of a crank that twists in halves, each with its mark. */
export function halves(
  { pin_from, pin_to }: ThrowShown,
  index: number,
  crank: Crank | null,
): readonly (readonly [number, number, Mark | null])[] {
  if (!crank) return [[pin_from, pin_to, null]]
  const [front, rear] = crank.pin(index)
  const [low, high] = [Math.min(pin_from, pin_to), Math.max(pin_from, pin_to)]
  const middle = (low + high) / 2
  return [
    [low, middle, rear],
    [middle, high, front],
  ]
}

/** The outline of a web that carries a pin. */
export function cheek({ journal_radius }: ShaftShown, pin: ThrowShown): Outline {
  return band(1.28 * journal_radius, pin.radius, pin.angle, 1.26 * pin.pin_radius)
}

/**
 * Where along z the shaft itself is: everywhere but between the webs of its throws. It ends inside
 * a web, never in the plane of its cheek, where the two would flicker through each other.
 */
export function journals(shaft: ShaftShown): [number, number][] {
  const gaps = shaft.throws.map((pin) => gap(pin, shaft)).sort((a, b) => a[0] - b[0])
  const whole: [number, number][] = []
  let from = shaft.z_from
  for (const [low, high] of gaps) {
    if (low > from) whole.push([from, low])
    from = Math.max(from, high)
  }
  if (shaft.z_to > from) whole.push([from, shaft.z_to])
  return whole
}

/** From the middle of the web at one end of a pin to the middle of that at the other. */
function gap(pin: ThrowShown, { webs, journal_radius }: ShaftShown): [number, number] {
  const touching = (a: number, b: number) => Math.abs(a - b) < 1e-6 * journal_radius
  const inside = (end: number) => {
    const web = webs.find(({ z_from, z_to }) => touching(z_from, end) || touching(z_to, end))
    return web ? (web.z_from + web.z_to) / 2 : end
  }
  return [Math.min(inside(pin.pin_from), pin.pin_from), Math.max(inside(pin.pin_to), pin.pin_to)]
}

/** A gear wheel with holes where there is room for them, its first tooth up. */
function wheelOf(wheel: GearShown, shaft: ShaftShown): Solid {
  const hub = 1.5 * shaft.journal_radius
  const rim = 0.8 * wheel.radius
  const room = rim - hub
  const hole = 0.36 * room
  const ring = (hub + rim) / 2
  const holes =
    hole > 0.07 * wheel.radius
      ? Array.from({ length: 5 }, (_, index) => {
          const [x, y] = towards((index * 2 * Math.PI) / 5)
          return circle(x * ring, y * ring, hole, 24)
        })
      : []
  const half = wheel.thickness / 2
  const solid = new Solid().prism(gear(wheel.radius, wheel.teeth), -half, half, 0, holes)
  return solid.prism(circle(0, 0, 1.25 * shaft.journal_radius, 28), -1.25 * half, 1.25 * half, 1)
}
