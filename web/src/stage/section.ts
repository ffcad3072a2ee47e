import type { Scene } from '../exhibit'

/** A slice of the engine between two planes square to the shafts: pins, and what works on them. */
export interface Slice {
  /** Ends along z; the front is the greater. */
  readonly from: number
  readonly to: number
  /** Numbers of the cylinders whose rods work on its pins. */
  readonly cylinders: readonly number[]
}

/** Room before and behind a slice, as a share of its length. */
const ROOM = 1e-3

/** The slices of an engine, front first: a pin with its webs, or pins that stand side by side. */
export function slicesOf(scene: Scene): readonly Slice[] {
  const slices: {
    pins: readonly [number, number]
    from: number
    to: number
    cylinders: number[]
  }[] = []
  for (const pin of pinsOf(scene)) {
    const same = slices.find(({ pins: [from, to] }) => from < pin.pins[1] && pin.pins[0] < to)
    if (same) {
      same.from = Math.min(same.from, pin.from)
      same.to = Math.max(same.to, pin.to)
      same.cylinders.push(...pin.cylinders)
    } else slices.push({ ...pin, cylinders: [...pin.cylinders] })
  }
  return slices
    .sort((one, other) => other.to - one.to)
    .map(({ from, to, cylinders }) => {
      const room = ROOM * (to - from)
      return { from: from - room, to: to + room, cylinders: cylinders.sort((a, b) => a - b) }
    })
}

/** Each pin: its ends, those of it with webs, weights and rods, and the cylinders on it. */
function pinsOf(scene: Scene) {
  return scene.shafts.flatMap((shaft, index) =>
    shaft.throws.map((pin, place) => {
      const on = scene.cylinders.filter((c) => c.shaft === index && c.throw === place)
      const webs = shaft.webs.filter((web) => web.throw === place)
      const ends = [
        pin.pin_from,
        pin.pin_to,
        ...webs.flatMap(({ z_from, z_to }) => [z_from, z_to]),
        ...on.flatMap(({ z, rod_z }) => [z, rod_z]),
      ]
      const [low, high] = [Math.min(...ends), Math.max(...ends)]
      const weights = shaft.weights
        .filter(({ z }) => z >= low && z <= high)
        .flatMap(({ z, thickness }) => [z - thickness / 2, z + thickness / 2])
      return {
        pins: [pin.pin_from, pin.pin_to] as const,
        from: Math.min(low, ...weights),
        to: Math.max(high, ...weights),
        cylinders: on.map(({ number }) => number),
      }
    }),
  )
}
