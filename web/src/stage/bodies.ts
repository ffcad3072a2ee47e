import type { Scene } from '../exhibit'
import { boreEnd } from './extent'
import { band, circle, gear, type Outline, sector, strip, towards } from './outlines'
import type { Palette } from './palette'
import { toothBearings } from './parts/meshing'
import { PIN } from './parts/pistons'
import { cheek, halves, journals } from './parts/shafts'
import type { Crank, Mark } from './twist'

/**
 * What a body moves with: a shaft, a piston or a rod, by its index; or it stands on the axis of a
 * cylinder; or it is of a mount. A charge is 1 high from the crown of its piston to the end of its bore.
 */
export type Carrier = 'shaft' | 'piston' | 'rod' | 'bore' | 'charge' | 'mount'
export type Fill =
  | 'crankshaft'
  | 'balanceShaft'
  | 'gear'
  | 'piston'
  | 'rod'
  | 'slave'
  | 'mount'
  | 'plate'
  | 'glass'
  | 'charge'

/** A convex body between two equal caps: the points [x, y, z] of one cap, then the other. */
export interface Body {
  readonly points: Float64Array
  readonly carrier: Carrier
  readonly index: number
  readonly fill: Fill
  /** Bearing at which it sits on its shaft. */
  readonly bearing: number
  /** What it goes with on a crank that twists; null on others. */
  readonly mark: Mark | null
}

/** Everything of a scene as convex bodies, in the frames of what carries them. */
export function bodiesOf(scene: Scene, crank: Crank | null = null): Body[] {
  return [...turning(scene, crank), ...wheels(scene), ...reciprocating(scene)]
}

function turning(scene: Scene, first: Crank | null): Body[] {
  return scene.shafts.flatMap((shaft, index) => {
    const crank = index === 0 ? first : null
    const fill = shaft.kind === 'crankshaft' ? 'crankshaft' : 'balanceShaft'
    const body = (outline: Outline, from: number, to: number, mark: Mark | null = null) => ({
      ...prism(outline, from, to, 'shaft', index, fill),
      mark,
    })
    const bars = journals(shaft).map(([from, to]) =>
      body(circle(0, 0, shaft.journal_radius, 20), from, to, crank?.journal(from, to)),
    )
    const pins = shaft.throws.flatMap((pin, place) => {
      const [x, y] = towards(pin.angle)
      const outline = circle(x * pin.radius, y * pin.radius, pin.pin_radius, 18)
      return halves(pin, place, crank).map(([from, to, mark]) => body(outline, from, to, mark))
    })
    const webs = shaft.webs.flatMap((web) => {
      const pin = shaft.throws[web.throw]
      return pin ? [body(cheek(shaft, pin), web.z_from, web.z_to, crank?.web(web))] : []
    })
    const weights = shaft.weights.map((weight) => {
      const { angle, half_angle, outer_radius, z, thickness } = weight
      const outline = sector(0, outer_radius, angle, Math.min(half_angle, 1.57))
      return body(outline, z - thickness / 2, z + thickness / 2, crank?.weight(weight))
    })
    return [...bars, ...pins, ...webs, ...weights]
  })
}

function wheels(scene: Scene): Body[] {
  const bearings = toothBearings(scene)
  return scene.gears.map((wheel, index) => {
    const [from, to] = [wheel.z - wheel.thickness / 2, wheel.z + wheel.thickness / 2]
    const outline = gear(wheel.radius, wheel.teeth)
    return prism(outline, from, to, 'shaft', wheel.shaft, 'gear', bearings[index])
  })
}

function reciprocating(scene: Scene): Body[] {
  return scene.cylinders.flatMap((c, index) => {
    const pin = scene.shafts[c.shaft]?.throws[c.throw]?.pin_radius ?? 0.2 * c.crank_radius
    const big = c.rod === 'slave' ? 0.8 * pin : 1.36 * pin
    const half = c.rod_width / 2
    const fill = c.rod === 'slave' || c.rod === 'blade' ? 'slave' : 'rod'
    const small = 1.5 * PIN * c.bore
    const rod = (outline: Outline, reach = half) =>
      prism(outline, -reach, reach, 'rod', index, fill)
    return [
      upright(0.5 * c.bore, c.bore_from, boreEnd(scene, c), 'bore', index, 'glass'),
      upright(0.485 * c.bore, 0, 1, 'charge', index, 'charge'),
      upright(0.49 * c.bore, -c.skirt, c.pin_height, 'piston', index, 'piston'),
      rod(circle(0, 0, big, 20)),
      rod(strip(0, c.rod_length, 0.6 * big, 0.7 * small), 0.5 * half),
      rod(circle(0, c.rod_length, small, 16)),
      ...knuckles(scene, index).map((outline) => rod(outline)),
    ]
  })
}

/** What carries the knuckle pins of a master rod. */
function knuckles(scene: Scene, index: number): Outline[] {
  const slaves = scene.cylinders.filter((other) => other.master === index)
  const pin = (radius: number) => 0.3 * radius
  if (slaves.length > 3)
    return [
      circle(0, 0, Math.max(...slaves.map((c) => c.knuckle_radius + pin(c.knuckle_radius))), 28),
    ]
  return slaves.map((c) =>
    band(c.knuckle_radius * 0.6, c.knuckle_radius, c.knuckle_angle, pin(c.knuckle_radius)),
  )
}

function prism(
  outline: Outline,
  from: number,
  to: number,
  carrier: Carrier,
  index: number,
  fill: Fill,
  bearing = 0,
): Body {
  const cap = (z: number) => outline.flatMap(([x, y]) => [x, y, z])
  const points = Float64Array.from([...cap(from), ...cap(to)])
  return { points, carrier, index, fill, bearing, mark: null }
}

/** A cylinder about the carrier's own y-axis. */
function upright(
  radius: number,
  low: number,
  high: number,
  carrier: Carrier,
  index: number,
  fill: Fill,
): Body {
  const ring = circle(0, 0, radius, 24)
  const cap = (y: number) => ring.flatMap(([x, z]) => [x, y, -z])
  return {
    points: Float64Array.from([...cap(low), ...cap(high)]),
    carrier,
    index,
    fill,
    bearing: 0,
    mark: null,
  }
}

/** The two colours of a body: its side, and the cap that faces the eye. */
export function coloursOf(fill: Fill, palette: Palette): readonly [number, number] {
  if (fill === 'mount') return [palette.mount[0], palette.mount[0]]
  if (fill === 'plate') return [palette.mount[1], palette.mount[1]]
  return fill === 'glass' || fill === 'charge' ? [palette.glass, palette.glass] : palette[fill]
}
