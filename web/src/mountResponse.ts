import type { Driving, Mounts, Spring } from './exhibit'
import { type Coefficients, signalOf } from './phasor'

/**
 * The steady vibration of the block at any speed, as in dynamics/mount_response.py: order by order
 *
 *     (-W^2 M + i W C + K(W)) q = Q        W = k w
 */
export interface Answer {
  /** Each freedom of the block, then of a foundation: m and rad. */
  readonly motion: readonly Coefficients[]
  /** Of each mount on what is below it: up, right, along; N. */
  readonly forces: readonly (readonly Coefficients[])[]
  /** Of each mount the rms force over that of forces that change slowly; null where next to none. */
  readonly through: readonly (number | null)[]
  /** What each mount turns into heat, W. */
  readonly heat: readonly number[]
}

/** Share of the greatest slow force of all mounts from which a ratio to one counts, as there. */
const COUNTS = 0.01
/** The place of roll among the freedoms. */
const ROLL = 5
const AXES = [0, 1, 2] as const
/** Where the receptance along each axis stands. */
const FOOT = [1, 2, 3] as const

/** The vibration at a speed (rad/s); with this gas on the roll, else as it is over the speeds. */
export function answerAt(
  { orders, mounts }: Mounts,
  driving: Driving,
  speed: number,
  gas: Coefficients | null,
): Answer {
  const { springs, inertia } = driving
  const count = driving.mass.length
  const still = systemOf(driving, 0, (spring) => AXES.map((axis) => [spring.stiffness[axis], 0]))
  const roll = gas ?? gasAt(driving, speed)
  const pushed = inertia.map((wave) => signalOf(wave).map((each) => each * speed ** 2))
  pushed[ROLL] = (pushed[ROLL] as Coefficients).map((each, at) => each + (roll[at] ?? 0))
  const empty = () => new Float64Array(2 * orders.length)
  const motion = Array.from({ length: count }, empty)
  const forces = springs.map(() => AXES.map(empty))
  const heat = springs.map(() => 0)
  const [sums, slow] = [springs.map(() => 0), springs.map(() => 0)]
  orders.forEach((order, place) => {
    const push = new Float64Array(2 * count)
    pushed.forEach((wave, freedom) => {
      push[freedom] = wave[2 * place] as number
      push[count + freedom] = wave[2 * place + 1] as number
    })
    const frequency = order * speed
    const rates = springs.map((spring) => ratesOf(spring, frequency))
    const dynamic = systemOf(driving, frequency, (_, index) => (rates[index] as Rates).joined)
    const [now, slowly] = [solved(dynamic, push), solved(still, push)]
    motion.forEach((wave, freedom) => {
      wave[2 * place] = now[freedom] as number
      wave[2 * place + 1] = now[count + freedom] as number
    })
    springs.forEach((spring, index) => {
      const { joined, lost } = rates[index] as Rates
      for (const axis of AXES) {
        const gap = across(spring.arms[axis], now)
        const force = product(joined[axis] as Pair, gap)
        const direction = (mounts[index] as Mounts['mounts'][0]).axes[axis]
        for (const way of AXES) {
          const wave = (forces[index] as Coefficients[])[way] as Coefficients
          wave[2 * place] = (wave[2 * place] as number) + force[0] * direction[way]
          wave[2 * place + 1] = (wave[2 * place + 1] as number) + force[1] * direction[way]
        }
        const slack = across(spring.arms[axis], slowly)
        add(sums, index, force[0] ** 2 + force[1] ** 2)
        add(slow, index, spring.stiffness[axis] ** 2 * (slack[0] ** 2 + slack[1] ** 2))
        add(heat, index, ((lost[axis] as number) * (gap[0] ** 2 + gap[1] ** 2) * frequency) / 2)
      }
    })
  })
  const most = Math.max(0, ...slow.filter((_, index) => !mounts[index]?.below))
  const through = sums.map((sum, index) => {
    const least = slow[index] as number
    return least > 0 && least >= COUNTS ** 2 * most ? Math.sqrt(sum / least) : null
  })
  return { motion, forces, through, heat }
}

/** Straight between known speeds, kept beyond the first and the last. */
function gasAt({ gas_speeds, gas }: Driving, speed: number): Coefficients {
  const [low, high, share] = between(gas_speeds, speed)
  const [from, to] = [low, high].map((place) => signalOf(gas[place] ?? []))
  return (from as Coefficients).map((each, at) => each + share * ((to?.[at] ?? 0) - each))
}

/** The places of the numbers on either side of one, and its share of the way between them. */
function between(numbers: readonly number[], at: number): [number, number, number] {
  const after = numbers.findIndex((each) => each >= at)
  if (after <= 0) return after < 0 ? [numbers.length - 1, numbers.length - 1, 0] : [0, 0, 0]
  const [low, high] = [numbers[after - 1] as number, numbers[after] as number]
  return [after - 1, after, (at - low) / (high - low)]
}

type Pair = readonly [number, number]

const product = ([a, b]: Pair, [c, d]: Pair): Pair => [a * c - b * d, a * d + b * c]

function quotient([a, b]: Pair, [c, d]: Pair): Pair {
  const size = c * c + d * d
  return [(a * c + b * d) / size, (b * c - a * d) / size]
}

/** Force over what the ends of a mount approach, and the part that is lost, axis by axis. */
interface Rates {
  readonly joined: readonly Pair[]
  readonly lost: readonly number[]
}

/** A mount at an angular frequency, in series with its foot. */
function ratesOf({ stiffness, damping, loss, stiffening, foot }: Spring, frequency: number): Rates {
  const knots: Spring['stiffening'] = [[0, 1], ...stiffening]
  const factor = mixed(knots, frequency, ([, each]) => each)
  const pairs = AXES.map((axis): [Pair, number] => {
    const stiff = factor * stiffness[axis]
    const own: Pair = [stiff, stiff * loss + frequency * damping[axis]]
    if (!foot.length) return [own, own[1]]
    const yields = product(own, [
      mixed(foot, frequency, (knot) => knot[FOOT[axis]][0]),
      mixed(foot, frequency, (knot) => knot[FOOT[axis]][1]),
    ])
    const share = quotient([1, 0], [1 + yields[0], yields[1]])
    return [product(own, share), own[1] * (share[0] ** 2 + share[1] ** 2)]
  })
  return { joined: pairs.map(([joined]) => joined), lost: pairs.map(([, lost]) => lost) }
}

/** A value that is known at some frequencies: straight between, kept beyond. */
function mixed<Knot extends readonly [number, ...unknown[]]>(
  knots: readonly Knot[],
  frequency: number,
  value: (knot: Knot) => number,
): number {
  const frequencies = knots.map(([at]) => at)
  const [low, high, share] = between(frequencies, frequency)
  const [from, to] = [value(knots[low] as Knot), value(knots[high] as Knot)]
  return from + share * (to - from)
}

const add = (all: number[], index: number, value: number): void => {
  all[index] = (all[index] as number) + value
}

/** What freedoms do along an axis; the imaginary parts stand behind the real ones. */
function across(arm: readonly number[], motion: Float64Array): Pair {
  let [real, imaginary] = [0, 0]
  arm.forEach((each, freedom) => {
    real += each * (motion[freedom] as number)
    imaginary += each * (motion[arm.length + freedom] as number)
  })
  return [real, imaginary]
}

/** The complex system -W^2 M + K as a real one of twice the size, row by row. */
function systemOf(
  { mass, springs }: Driving,
  frequency: number,
  rates: (spring: Spring, index: number) => readonly (readonly [number, number])[],
): Float64Array[] {
  const count = mass.length
  const rows = Array.from({ length: 2 * count }, () => new Float64Array(2 * count))
  const put = (row: number, column: number, real: number, imaginary: number): void => {
    const [upper, lower] = [rows[row] as Float64Array, rows[count + row] as Float64Array]
    upper[column] = (upper[column] as number) + real
    upper[count + column] = (upper[count + column] as number) - imaginary
    lower[column] = (lower[column] as number) + imaginary
    lower[count + column] = (lower[count + column] as number) + real
  }
  mass.forEach((line, row) => {
    line.forEach((each, column) => {
      put(row, column, -(frequency ** 2) * each, 0)
    })
  })
  springs.forEach((spring, index) => {
    rates(spring, index).forEach(([real, imaginary], axis) => {
      const arm = spring.arms[axis as 0 | 1 | 2]
      arm.forEach((one, row) => {
        arm.forEach((other, column) => {
          const both = one * other
          if (both !== 0) put(row, column, real * both, imaginary * both)
        })
      })
    })
  })
  return rows
}

/** The solution of a linear system by elimination with pivots. */
function solved(system: readonly Float64Array[], right: Float64Array): Float64Array {
  const size = right.length
  const rows = system.map((row, index) => Float64Array.of(...row, right[index] as number))
  type Line = (typeof rows)[0]
  for (let column = 0; column < size; column++) {
    let pivot = column
    for (let row = column + 1; row < size; row++)
      if (Math.abs(rows[row]?.[column] ?? 0) > Math.abs(rows[pivot]?.[column] ?? 0)) pivot = row
    const top = rows[pivot] as Line
    rows[pivot] = rows[column] as Line
    rows[column] = top
    for (let row = column + 1; row < size; row++) {
      const own = rows[row] as Float64Array
      const share = (own[column] as number) / (top[column] as number)
      if (share)
        for (let at = column; at <= size; at++)
          own[at] = (own[at] as number) - share * (top[at] as number)
    }
  }
  const out = new Float64Array(size)
  for (let row = size - 1; row >= 0; row--) {
    const own = rows[row] as Float64Array
    let sum = own[size] as number
    for (let at = row + 1; at < size; at++) sum -= (own[at] as number) * (out[at] as number)
    out[row] = sum / (own[row] as number)
  }
  return out
}

/** The rms value over a cycle of a vector by its waves. */
export const rmsOf = (waves: readonly Coefficients[]): number =>
  Math.sqrt(
    waves.reduce((sum, wave) => sum + wave.reduce((all, each) => all + each ** 2, 0), 0) / 2,
  )

/** The waves of the rate at which waves change at a speed (rad/s). */
export function rateOf(wave: Coefficients, orders: readonly number[], speed: number): Coefficients {
  const out = new Float64Array(wave.length)
  orders.forEach((order, place) => {
    out[2 * place] = -order * speed * (wave[2 * place + 1] as number)
    out[2 * place + 1] = order * speed * (wave[2 * place] as number)
  })
  return out
}
