import type { Exhibit, Load, Sum, Torque, Vectors, Whirl } from './exhibit'
import { type Coefficients, phaseOf, sameOrder, signalAt, signalOf, turn } from './phasor'
import type { Choices } from './state'

type Pair = [number, number]

/** What the gas does: it burns, it is only compressed, or there is none. */
export type Gas = 'burning' | 'still' | 'none'

/** What is chosen of the torque of an engine. */
export interface Setting {
  /** The name of the load that is shown; the first one of an engine that has none of that name. */
  readonly load: string
  readonly gas: Gas
  /** Numbers of the cylinders that do not burn. */
  readonly off: readonly number[]
}

/** The gas torque of a chamber over the crank angle. */
export interface ChamberTorque {
  readonly number: number
  readonly fires: number
  readonly burns: boolean
  readonly wave: Coefficients
  readonly mean: number
}

/** Torque over a working cycle as signals at `orders`; in N m where `counted` is null. */
export interface Torques {
  readonly orders: readonly number[]
  /** Turns of the crank in a working cycle. */
  readonly turns: number
  readonly load: Load | null
  readonly chambers: readonly ChamberTorque[]
  readonly gas: Coefficients | null
  readonly inertia: Coefficients | null
  readonly together: Coefficients
  readonly roll: Coefficients
  /** The mean of the gas torque; of the sum too, for moving parts give none. */
  readonly mean: number
  readonly unit: string
  readonly factor: number
}

const GAS: readonly Gas[] = ['burning', 'still', 'none']

/** What is chosen, as links have it. */
export function settingOf(choices: Choices): Setting {
  const gas = GAS.find((each) => each === choices['torque.gas'])
  return {
    load: choices['torque.load'] ?? '',
    gas: gas ?? 'burning',
    off: offOf(choices['torque.off'] ?? ''),
  }
}

/** Numbers of cylinders as a link has them: `2-3`. */
export function offOf(text: string): number[] {
  const numbers = text.split('-').flatMap((part) => (/^\d{1,4}$/.test(part) ? [Number(part)] : []))
  return [...new Set(numbers)].sort((one, other) => one - other)
}

export const offText = (off: readonly number[]): string =>
  [...off].sort((one, other) => one - other).join('-')

/** A sum smaller than this share of what it was added up from is the rounding of what is sent. */
const ROUNDING = 1e-9

/** A wave that begins at the crank angle `at`, radians. */
export function delayed(wave: Coefficients, orders: readonly number[], at: number): Coefficients {
  const out = new Float64Array(wave.length)
  orders.forEach((order, index) => {
    const [real = 0, imaginary = 0] = [wave[2 * index], wave[2 * index + 1]]
    const [cos, sin] = [Math.cos(order * at), Math.sin(order * at)]
    out[2 * index] = real * cos + imaginary * sin
    out[2 * index + 1] = imaginary * cos - real * sin
  })
  return out
}

/** The sum of signals, what is only rounding set to zero. */
export function together(all: readonly Coefficients[], count: number): Coefficients {
  const out = new Float64Array(2 * count)
  for (let index = 0; index < out.length; index += 2) {
    let [real, imaginary, most] = [0, 0, 0]
    for (const each of all) {
      const [one = 0, other = 0] = [each[index], each[index + 1]]
      real += one
      imaginary += other
      most += Math.hypot(one, other)
    }
    const rounding = ROUNDING * most
    out[index] = Math.abs(real) <= rounding ? 0 : real
    out[index + 1] = Math.abs(imaginary) <= rounding ? 0 : imaginary
  }
  return out
}

const times = (wave: Coefficients, factor: number): Coefficients =>
  wave.map((each) => each * factor)

/** The torque of an engine as chosen; of one whose gas cannot be computed that of its parts. */
export function torquesOf(exhibit: Exhibit, setting: Setting): Torques {
  const { torque } = exhibit
  return torque ? withGas(exhibit, torque, setting) : ofParts(exhibit)
}

/** The load that is shown of an engine. */
export const loadOf = ({ loads }: Torque, { load }: Pick<Setting, 'load'>): Load | undefined =>
  loads.find(({ name }) => name === load) ?? loads[0]

function withGas(exhibit: Exhibit, torque: Torque, setting: Setting): Torques {
  const { orders } = torque
  const load = loadOf(torque, setting) as Load
  const squared = (load.speed ?? 0) ** 2
  const moving = torque.moving && load.speed !== null ? torque.moving : null
  const inertia = moving && times(signalOf(moving), squared)
  const axis = times(signalOf(torque.axis), squared)
  const chambers = setting.gas === 'none' ? [] : chambersOf(torque, load, setting)
  const gas =
    setting.gas === 'none'
      ? null
      : together(
          chambers.map(({ wave }) => wave),
          orders.length,
        )
  const parts = [gas, inertia].filter((each) => each !== null)
  const reaction = parts.map((each) => times(each, -exhibit.sense))
  return {
    orders,
    turns: torque.cycle / (2 * Math.PI),
    load,
    chambers,
    gas,
    inertia,
    together: together(parts, orders.length),
    roll: together([axis, ...reaction], orders.length),
    mean: chambers.reduce((sum, { mean }) => sum + mean, 0),
    unit: exhibit.torque_unit.label,
    factor: exhibit.torque_unit.factor,
  }
}

function chambersOf(torque: Torque, load: Load, setting: Setting): ChamberTorque[] {
  return torque.chambers.map(({ number, fires, wave }) => {
    const burns = setting.gas === 'burning' && !setting.off.includes(number)
    const own = signalOf((burns ? load.burning : load.still)[wave] ?? [])
    return {
      number,
      fires,
      burns,
      wave: delayed(own, torque.orders, fires),
      mean: (burns ? load.burning_mean : load.still_mean)[wave] ?? 0,
    }
  })
}

function ofParts(exhibit: Exhibit): Torques {
  const { orders, total, units } = exhibit
  const inertia = signalOf(total.torque)
  return {
    orders,
    turns: exhibit.cycle_deg / 360,
    load: null,
    chambers: [],
    gas: null,
    inertia,
    together: inertia,
    roll: signalOf(total.roll),
    mean: 0,
    unit: units.roll,
    factor: units.roll_factor,
  }
}

/** Amplitude of a signal at its order with this index. */
export const sizeAt = (wave: Coefficients | null, index: number): number =>
  wave ? Math.hypot(wave[2 * index] ?? 0, wave[2 * index + 1] ?? 0) : 0

/** Steps of a curve over a turn of the crank. */
const STEPS = 360

/** Signals at equal steps of the crank over `turns` turns, both ends included. */
export function curvesOf(
  waves: readonly { readonly wave: Coefficients; readonly mean: number }[],
  orders: readonly number[],
  turns: number,
): readonly Float64Array[] {
  const count = Math.round(STEPS * turns)
  const out = waves.map(() => new Float64Array(count + 1))
  const phase = phaseOf(orders.length, 1)
  for (let step = 0; step <= count; step++) {
    turn(phase, orders, (step / STEPS) * 2 * Math.PI, null)
    waves.forEach(({ wave, mean }, index) => {
      const curve = out[index]
      if (curve) curve[step] = mean + signalAt(wave, phase)
    })
  }
  return out
}

/** The linear estimate of the degree of irregularity; null where it cannot be told. */
export function unevenness({ together: wave, orders, turns, load }: Torques): number | null {
  if (!load?.inertia || load.speed === null) return null
  // the integral over the angle, order by order
  const work = new Float64Array(wave.length)
  orders.forEach((order, index) => {
    if (order === 0) return
    work[2 * index] = (wave[2 * index + 1] ?? 0) / order
    work[2 * index + 1] = -(wave[2 * index] ?? 0) / order
  })
  const [curve = new Float64Array()] = curvesOf([{ wave: work, mean: 0 }], orders, turns)
  return (Math.max(...curve) - Math.min(...curve)) / (load.inertia * load.speed ** 2)
}

/** Share of the greatest amplitude from which an order is drawn. */
const NOTED = 0.02
const LEAST_SHOWN = 6

/** Places in `orders` of those that are drawn: all up to the last of note, steady parts left out. */
export function noted(
  waves: readonly (Coefficients | null)[],
  orders: readonly number[],
): number[] {
  const sizes = orders.map((_, index) => Math.max(...waves.map((wave) => sizeAt(wave, index))))
  const least = NOTED * Math.max(...sizes, 0)
  const last = orders.reduce(
    (most, order, index) => ((sizes[index] ?? 0) > least ? Math.max(most, order) : most),
    LEAST_SHOWN,
  )
  return orders.flatMap((order, index) => (order > 0 && order <= last ? [index] : []))
}

/** Radians per second for each turn per minute. */
const PER_RPM = Math.PI / 30

/** Whether gas can be added to the rolling moment of an engine: both are in N m at one speed. */
export function takesGas({ torque, units, speed_rpm }: Exhibit, setting: Setting): boolean {
  const speed = torque && loadOf(torque, setting)?.speed
  return (
    torque?.moving != null &&
    units.counted[0] === 'N' &&
    speed != null &&
    Math.abs(speed - (speed_rpm ?? 0) * PER_RPM) < 1e-6 * speed
  )
}

/** The engine as the stage shows it where chambers do not burn: without their power strokes. */
export function withoutPower(exhibit: Exhibit, off: readonly number[]): Exhibit {
  if (!off.length) return exhibit
  const stroke_windows = exhibit.stroke_windows.filter(
    ({ chamber, stroke }) => stroke !== 'power' || !off.includes(chamber),
  )
  return { ...exhibit, stroke_windows }
}

/** The engine with gas in its rolling moment, for the stage; as it is where that cannot be. */
export function withGasRoll(exhibit: Exhibit, setting: Setting): Exhibit {
  if (!exhibit.torque || !takesGas(exhibit, setting)) return exhibit
  const gas = setting.gas === 'none' ? 'burning' : setting.gas
  const torques = torquesOf(exhibit, { ...setting, gas })
  const place = (order: number) => exhibit.orders.findIndex((each) => sameOrder(each, order))
  const orders = [
    ...exhibit.orders,
    ...torques.orders.filter((order, index) => sizeAt(torques.gas, index) && place(order) < 0),
  ]
  const added = orders.map((order): Pair => {
    const index = torques.orders.findIndex((each) => sameOrder(each, order))
    // minus the torque, in the sense of rotation, wherever the load stands
    const share = -exhibit.sense
    return [share * (torques.gas?.[2 * index] ?? 0), share * (torques.gas?.[2 * index + 1] ?? 0)]
  })
  const longer = (signal: readonly Pair[]): Pair[] => orders.map((_, at) => signal[at] ?? [0, 0])
  const vectors = ({ forward, backward }: Vectors): Vectors => ({
    forward: longer(forward),
    backward: longer(backward),
  })
  const sum = ({ force, couple, roll, torque }: Sum): Sum => ({
    force: vectors(force),
    couple: vectors(couple),
    torque: longer(torque),
    roll: longer(roll).map(([real, imaginary], at): Pair => {
      const [more = 0, other = 0] = added[at] ?? []
      return [real + more, imaginary + other]
    }),
  })
  const { whirl } = exhibit
  const moved = (each: Whirl): Whirl => ({
    ...each,
    shift: vectors(each.shift),
    tilt: vectors(each.tilt),
    turn: longer(each.turn),
  })
  return {
    ...exhibit,
    orders,
    total: sum(exhibit.total),
    ends: exhibit.ends.map(sum),
    cylinders: exhibit.cylinders.map((part) => ({ ...part, force: vectors(part.force) })),
    whirl: moved(whirl),
    whirl_ends: exhibit.whirl_ends.map(moved),
  }
}
