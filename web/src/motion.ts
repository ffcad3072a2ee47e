import type { CylinderShown, Scene, ShaftShown } from './exhibit'

/**
 * Exact places of pins, rods and pistons at a crank angle (docs, theory: motion), the same chain as
 * in motion.py.
 *
 * Everything is a pair [up, right] of the clock plane, seen from the front, in the scene's unit.
 * The pin of a shaft stands at bearing `angle + sense * speed_ratio * theta`; a piston pin stays on
 * its cylinder's axis, `offset` to the clockwise side, one rod length from its big end; a knuckle
 * pin is carried by its master's rod.
 */
export interface Chain {
  readonly count: number
  /** Indices of cylinders, masters before their slaves. */
  readonly order: Int32Array
  readonly master: Int32Array
  /** [up, right] of the shaft each cylinder works on. */
  readonly shaft: Float64Array
  /** Signed turns of its shaft, clockwise seen from the front, for each turn of the first. */
  readonly speed: Float64Array
  readonly angle: Float64Array
  readonly radius: Float64Array
  readonly length: Float64Array
  readonly offset: Float64Array
  /** Unit vector [up, right] along each cylinder's axis. */
  readonly axis: Float64Array
  /** From the master's big end to the knuckle pin: [along its rod, to its clockwise side]. */
  readonly knuckle: Float64Array
}

/** Where the rods are: pairs [up, right] one after the other, cylinder by cylinder. */
export interface Places {
  readonly bigEnd: Float64Array
  readonly piston: Float64Array
  /** Unit vectors from big end to piston pin. */
  readonly direction: Float64Array
}

/** Angle of a shaft at crank angle `theta`, clockwise seen from the front. */
export const turned = (shaft: ShaftShown, sense: number, theta: number): number =>
  sense * shaft.speed_ratio * theta

/** The rods of a scene as arrays; `sense` is that of the exhibit. */
export function chainOf(scene: Scene, sense: number): Chain {
  const { cylinders, shafts } = scene
  const shaftOf = (cylinder: CylinderShown) => {
    const shaft = shafts[cylinder.shaft]
    if (!shaft)
      throw new RangeError(
        `cylinder ${cylinder.number} works on shaft ${cylinder.shaft}, which is not there`,
      )
    return shaft
  }
  const numbers = (of: (cylinder: CylinderShown) => number) => Float64Array.from(cylinders, of)
  const pairs = (of: (cylinder: CylinderShown) => [number, number]) =>
    Float64Array.from(cylinders.flatMap(of))
  return {
    count: cylinders.length,
    order: Int32Array.from(inOrder(cylinders.map((cylinder) => cylinder.master))),
    master: Int32Array.from(cylinders, (cylinder) => cylinder.master),
    shaft: pairs((cylinder) => [shaftOf(cylinder).up, shaftOf(cylinder).right]),
    speed: numbers((cylinder) => turned(shaftOf(cylinder), sense, 1)),
    angle: numbers((cylinder) => cylinder.throw_angle),
    radius: numbers((cylinder) => cylinder.crank_radius),
    length: numbers((cylinder) => cylinder.rod_length),
    offset: numbers((cylinder) => cylinder.offset),
    axis: pairs(({ bearing }) => [Math.cos(bearing), Math.sin(bearing)]),
    knuckle: pairs((c) => [
      c.knuckle_radius * Math.cos(c.knuckle_angle),
      c.knuckle_radius * Math.sin(c.knuckle_angle),
    ]),
  }
}

/** Indices so that every master comes before its slaves. */
function inOrder(master: readonly number[]): number[] {
  const depth = (index: number): number => {
    const above = master[index] ?? -1
    return above < 0 ? 0 : 1 + depth(above)
  }
  return master.map((_, index) => index).sort((a, b) => depth(a) - depth(b) || a - b)
}

/** Room for the places of a chain. */
export function placesOf(chain: Chain): Places {
  const room = () => new Float64Array(2 * chain.count)
  return { bigEnd: room(), piston: room(), direction: room() }
}

/**
 * Writes all places at crank angle `theta` (radians) into `out`. Makes no garbage. Of a crankshaft
 * that is seen to twist, the pin of each cylinder is `ahead` (radians) the way its shaft turns.
 */
export function moved(
  chain: Chain,
  theta: number,
  out: Places,
  ahead: Float64Array | null = null,
): Places {
  for (let step = 0; step < chain.count; step++) {
    const index = chain.order[step] as number
    joint(chain, index, theta + (ahead ? at(ahead, index) : 0), out)
    reach(chain, index, out)
  }
  return out
}

/** The big end: on the crank pin, or on the knuckle pin of the master's rod. */
function joint(chain: Chain, index: number, theta: number, out: Places): void {
  const up = 2 * index
  const master = chain.master[index] as number
  if (master < 0) {
    const bearing = at(chain.angle, index) + at(chain.speed, index) * theta
    out.bigEnd[up] = at(chain.shaft, up) + at(chain.radius, index) * Math.cos(bearing)
    out.bigEnd[up + 1] = at(chain.shaft, up + 1) + at(chain.radius, index) * Math.sin(bearing)
    return
  }
  const above = 2 * master
  const rodUp = at(out.direction, above)
  const rodRight = at(out.direction, above + 1)
  const along = at(chain.knuckle, up)
  const across = at(chain.knuckle, up + 1)
  out.bigEnd[up] = at(out.bigEnd, above) + along * rodUp - across * rodRight
  out.bigEnd[up + 1] = at(out.bigEnd, above + 1) + along * rodRight + across * rodUp
}

/** The piston pin: on the axis, one rod length from the big end. */
function reach(chain: Chain, index: number, out: Places): void {
  const up = 2 * index
  const axisUp = at(chain.axis, up)
  const axisRight = at(chain.axis, up + 1)
  const fromUp = at(out.bigEnd, up) - at(chain.shaft, up)
  const fromRight = at(out.bigEnd, up + 1) - at(chain.shaft, up + 1)
  const offset = at(chain.offset, index)
  const length = at(chain.length, index)
  const across = fromRight * axisUp - fromUp * axisRight - offset
  const height =
    fromUp * axisUp + fromRight * axisRight + Math.sqrt(length * length - across * across)
  const pinUp = at(chain.shaft, up) + height * axisUp - offset * axisRight
  const pinRight = at(chain.shaft, up + 1) + height * axisRight + offset * axisUp
  out.piston[up] = pinUp
  out.piston[up + 1] = pinRight
  out.direction[up] = (pinUp - at(out.bigEnd, up)) / length
  out.direction[up + 1] = (pinRight - at(out.bigEnd, up + 1)) / length
}

/** An element that is known to be there. */
function at(values: Float64Array, index: number): number {
  return values[index] as number
}
