import type { Exhibit, ShaftShown, Web, WeightShown } from '../exhibit'
import { phaseOf, signalAt, turn } from '../phasor'
import type { Twist } from '../torsion'
import { channels } from './palette'

/** Throws that can be seen to twist. */
export const MOST = 48

/**
 * Where a body of the crank belongs. Throws are numbered from the front: its rear end (the lower z)
 * turns as `low` says, its front end as `high`, between two throws by a fraction. `piece` is the
 * shaft that it is a part of: 0 ahead of the first throw, n between the throws n - 1 and n.
 */
export interface Mark {
  readonly low: number
  readonly high: number
  readonly piece: number
}

/** The throws of a crank from front to rear, and what of it goes with which. */
export class Crank {
  readonly #shaft: ShaftShown
  /** Place from the front of each throw of the scene. */
  readonly places: readonly number[]

  constructor(shaft: ShaftShown, throws: readonly number[]) {
    this.#shaft = shaft
    this.places = shaft.throws.map((_, index) => throws.indexOf(index))
  }

  /** The two halves of a pin, front first: which of it is in front of its middle. */
  pin(index: number): readonly [Mark, Mark] {
    const place = this.places[index] ?? 0
    return [whole(place, place), whole(place, place + 1)]
  }

  web(web: Web): Mark {
    const place = this.places[web.throw] ?? 0
    const pin = this.#shaft.throws[web.throw]
    const middle = (web.z_from + web.z_to) / 2
    return whole(place, middle > (pin?.z ?? 0) ? place : place + 1)
  }

  /** A weight sits on the web that is nearest, or goes with the throw that is. */
  weight({ z }: WeightShown): Mark {
    const { webs, throws } = this.#shaft
    const web = nearest(webs, (each) => Math.abs((each.z_from + each.z_to) / 2 - z))
    if (web) return this.web(web)
    const pin = nearest(throws, (each) => Math.abs(each.z - z))
    const place = pin ? (this.places[throws.indexOf(pin)] ?? 0) : 0
    return whole(place, z > (pin?.z ?? 0) ? place : place + 1)
  }

  /** A journal twists from the throw behind it to that in front of it. */
  journal(from: number, to: number): Mark {
    const { throws } = this.#shaft
    const middle = (from + to) / 2
    const piece = throws.filter((each) => each.z > middle).length
    const last = throws.length - 1
    return { low: Math.min(piece, last), high: Math.max(0, piece - 1), piece }
  }
}

const whole = (place: number, piece: number): Mark => ({ low: place, high: place, piece })

function nearest<T>(all: readonly T[], distance: (each: T) => number): T | undefined {
  return all.toSorted((one, other) => distance(one) - distance(other))[0]
}

/** The crank of an engine that can be seen to twist; null of others. */
export function crankOf({ scene, torsion }: Exhibit): Crank | null {
  const [shaft] = scene.shafts
  if (!torsion || !shaft || torsion.throws.length > MOST || torsion.throws.length === 0) return null
  return new Crank(shaft, torsion.throws)
}

/** The twist of the crank as it is drawn at an instant; throws and pieces front first. */
export interface Twisted {
  readonly twist: Twist
  /** How far each throw is ahead, magnified, radians. */
  readonly ahead: Float32Array
  /** The same of the pin of each cylinder; 0 on other shafts. */
  readonly cylinders: Float64Array
  /** Red, green, blue and how much of them, 0 or 1, of each piece; grey where no load is known. */
  readonly heat: Float32Array
}

/** Colours of loads from none to the greatest, at equal steps. */
export const HEAT: readonly number[] = [0xf4efd2, 0xf7c95c, 0xee8232, 0xc83232, 0x6d0f36]
const STOPS = HEAT.map(channels)
const UNKNOWN = channels(0xa3abb3)

/** Writes the colour of a share of the greatest load, from 0 to 1, at a place of `out`. */
export function tinted(share: number, out: Float32Array, at: number): void {
  const scaled = Math.min(1, Math.max(0, share)) * (STOPS.length - 1)
  const first = Math.min(STOPS.length - 2, Math.floor(scaled))
  const [low, high] = [STOPS[first], STOPS[first + 1]] as [number[], number[]]
  for (let channel = 0; channel < 3; channel++) {
    const [from, to] = [low[channel] as number, high[channel] as number]
    out[at + channel] = from + (scaled - first) * (to - from)
  }
}

/** The colour of a share of the greatest load: red, green, blue. */
export function tintOf(share: number): Float32Array {
  const out = new Float32Array(3)
  tinted(share, out, 0)
  return out
}

/** Turns a crank by its twist. */
export class Twisting {
  readonly #twist: Twist
  readonly #phase: ReturnType<typeof phaseOf>
  readonly #places: readonly number[]
  readonly #now: Twisted

  constructor({ scene }: Exhibit, crank: Crank, twist: Twist) {
    this.#twist = twist
    this.#phase = phaseOf(twist.orders.length, 1)
    this.#places = scene.cylinders.map((c) => (c.shaft === 0 ? (crank.places[c.throw] ?? -1) : -1))
    this.#now = {
      twist,
      ahead: new Float32Array(MOST),
      cylinders: new Float64Array(scene.cylinders.length),
      heat: new Float32Array(4 * (MOST + 1)),
    }
  }

  /** The twist at a crank angle (radians). Reuses its record. */
  at(theta: number): Twisted {
    const { orders, turns, loads, top, times } = this.#twist
    const { ahead, cylinders, heat } = this.#now
    turn(this.#phase, orders, theta, null)
    for (let place = 0; place < turns.length; place++)
      ahead[place] = times * signalAt(turns[place] as Float64Array, this.#phase)
    for (let index = 0; index < cylinders.length; index++) {
      const place = this.#places[index] as number
      cylinders[index] = place < 0 ? 0 : (ahead[place] as number)
    }
    for (let piece = 0; piece < loads.length; piece++) {
      const load = loads[piece]
      heat[4 * piece + 3] = top > 0 ? 1 : 0
      if (load && top > 0) tinted(Math.abs(signalAt(load, this.#phase)) / top, heat, 4 * piece)
      else heat.set(UNKNOWN, 4 * piece)
    }
    return this.#now
  }
}
