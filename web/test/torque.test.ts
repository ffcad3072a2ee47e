import { expect, test } from 'vitest'
import type { Exhibit, Load, Torque } from '../src/exhibit'
import { phaseOf, signalAt, turn } from '../src/phasor'
import {
  curvesOf,
  delayed,
  loadOf,
  noted,
  offOf,
  offText,
  type Setting,
  settingOf,
  sizeAt,
  takesGas,
  together,
  torquesOf,
  unevenness,
  withGasRoll,
  withoutPower,
} from '../src/torque'
import { exhibit } from './stage/engine'

const ORDERS = [0.5, 1, 1.5, 2]
const WAVE: [number, number][] = [
  [3, 1],
  [2, -1],
  [0.5, 0.25],
  [1, 0],
]
const STILL = WAVE.map(([real, imaginary]): [number, number] => [real / 4, imaginary / 4])

const load = (changes: Partial<Load> = {}): Load => ({
  name: '',
  assumed: true,
  speed: 100,
  burning: [WAVE],
  burning_mean: [5],
  still: [STILL],
  still_mean: [-0.5],
  friction: 1,
  irregularity: null,
  inertia: null,
  notes: [],
  doubts: [],
  tables: [],
  ...changes,
})

/** A four-stroke twin that fires evenly, with an inertia torque of order 2. */
const torque = (changes: Partial<Torque> = {}): Torque => ({
  orders: ORDERS,
  cycle: 4 * Math.PI,
  displacement: 1e-3,
  chambers: [
    { number: 1, fires: 0, wave: 0 },
    { number: 2, fires: 2 * Math.PI, wave: 0 },
  ],
  moving: [
    [0, 0],
    [0, 0],
    [0, 0],
    [0, 2e-4],
  ],
  axis: [
    [0, 0],
    [1e-4, 0],
    [0, 0],
    [0, 0],
  ],
  loads: [load()],
  ...changes,
})

const twin = (changes: Partial<Torque> = {}): Exhibit => exhibit({ torque: torque(changes) })
const BOTH: Setting = { load: '', gas: 'burning', off: [] }

test('a wave that begins later is the same wave, later', () => {
  const wave = Float64Array.from(WAVE.flat())
  const phase = phaseOf(ORDERS.length, 1)
  for (const [theta, at] of [
    [0.3, 1],
    [5, 2.5],
    [11, 7],
  ] as const) {
    const later = signalAt(delayed(wave, ORDERS, at), turn(phase, ORDERS, theta, null))
    const own = signalAt(wave, turn(phase, ORDERS, theta - at, null))
    expect(later).toBeCloseTo(own, 12)
  }
})

test('what cancels is exactly nought, and what is small is not', () => {
  const [one, other] = [Float64Array.of(1, 1e-5), Float64Array.of(-1 + 1e-12, 0)]
  expect([...together([one, other], 1)]).toEqual([0, 1e-5])
})

test('even firing leaves no half order, and a cylinder without combustion brings them back', () => {
  const even = torquesOf(twin(), BOTH)
  expect([0, 2].map((place) => sizeAt(even.gas, place))).toEqual([0, 0])
  expect(sizeAt(even.gas, 3)).toBeCloseTo(2, 12)
  expect(even.mean).toBe(10)
  const lame = torquesOf(twin(), { ...BOTH, off: [2] })
  expect(sizeAt(lame.gas, 0)).toBeCloseTo(0.75 * Math.hypot(3, 1), 12)
  expect(lame.mean).toBe(4.5)
  expect(lame.chambers.map(({ burns }) => burns)).toEqual([true, false])
})

test('the inertia torque grows with the square of the speed of the load', () => {
  const loads = [load(), load({ name: 'fast', speed: 200 })]
  const [slow, fast] = ['', 'fast'].map((name) =>
    torquesOf(twin({ loads }), { ...BOTH, load: name }),
  )
  expect(sizeAt(slow?.inertia ?? null, 3)).toBeCloseTo(2, 12)
  expect(sizeAt(fast?.inertia ?? null, 3)).toBeCloseTo(8, 12)
})

test('the block takes the reaction of gas and inertia, or the moment about the axis alone', () => {
  for (const sense of [1, -1] as const) {
    const engine = { ...twin(), sense }
    const driven = torquesOf(engine, BOTH)
    expect(driven.roll[2 * 3]).toBeCloseTo(-sense * 2, 12)
    expect(driven.roll[2 * 3 + 1]).toBeCloseTo(-sense * 2, 12)
  }
})

test('an engine without gas has the torque of its moving parts, in its own unit', () => {
  const plain = exhibit({
    sense: -1,
    total: { ...exhibit().total, roll: [[1, 0]], torque: [[2, 0]] },
  })
  const own = torquesOf(plain, BOTH)
  expect(own.gas).toBeNull()
  expect([...own.together]).toEqual([2, 0])
  expect([...own.roll]).toEqual([1, 0])
})

test('a curve begins and ends with the cycle, and its mean is that of the gas', () => {
  const { gas, mean, orders, turns } = torquesOf(twin(), BOTH)
  const [curve = new Float64Array()] = curvesOf(gas ? [{ wave: gas, mean }] : [], orders, turns)
  expect(curve[0]).toBeCloseTo(curve[curve.length - 1] ?? 0, 9)
  const inner = curve.slice(1)
  expect(inner.reduce((sum, value) => sum + value, 0) / inner.length).toBeCloseTo(10, 9)
})

test('the linear estimate is the swing of the work over the energy', () => {
  const loads = [load({ inertia: 0.5, burning: [WAVE.map((): [number, number] => [0, 0])] })]
  const own = torquesOf(twin({ loads }), BOTH)
  // 2 sin(2 theta) N m swings its work by 2 J
  expect(unevenness(own)).toBeCloseTo(2 / (0.5 * 100 ** 2), 6)
  expect(unevenness(torquesOf(twin(), BOTH))).toBeNull()
})

test('orders are drawn up to the last of note', () => {
  const orders = [0, 0.5, 4, 8, 12]
  const wave = Float64Array.of(9, 0, 0, 0, 10, 0, 0, 3, 0.1, 0)
  expect(noted([wave, null], orders)).toEqual([1, 2, 3])
})

test('the gas is in the rolling moment of the stage, and in nothing else', () => {
  const engine: Exhibit = { ...twin(), orders: [2], speed_rpm: (100 * 30) / Math.PI }
  expect(takesGas({ ...engine, speed_rpm: 3000 }, BOTH)).toBe(false)
  const staged = withGasRoll(engine, BOTH)
  expect(staged.orders).toEqual([2, 1])
  const rolled = [-2, 0, -4, 2]
  for (const [place, value] of staged.total.roll.flat().entries())
    expect(value).toBeCloseTo(rolled[place] ?? 0, 12)
  expect(staged.total.force.forward).toEqual([
    [0, 0],
    [0, 0],
  ])
  expect(withGasRoll({ ...engine, speed_rpm: 3000 }, BOTH).orders).toEqual([2])
})

test('what is chosen goes into links and comes back', () => {
  expect(offText([10, 2])).toBe('2-10')
  expect(offOf('2-10-x-2')).toEqual([2, 10])
  const chosen = settingOf({ 'torque.gas': 'still', 'torque.off': '3' })
  expect(chosen).toEqual({ load: '', gas: 'still', off: [3] })
  expect(settingOf({ 'torque.gas': '<b>' })).toEqual(BOTH)
})

test('a load is found by its name, and the first stands for one that is not there', () => {
  const one = torque({ loads: [load({ name: 'full' }), load({ name: 'idle' })] })
  expect(loadOf(one, { load: 'idle' })?.name).toBe('idle')
  expect(loadOf(one, { load: 'half' })?.name).toBe('full')
  expect(loadOf(one, { load: '' })?.name).toBe('full')
})

test('a chamber that is off has no power stroke on the stage, the others have theirs', () => {
  const window = (chamber: number, stroke: 'power' | 'exhaust') =>
    ({ chamber, stroke, from_deg: 0, to_deg: 180 }) as const
  const stroke_windows = [window(1, 'power'), window(2, 'power'), window(2, 'exhaust')]
  const whole = exhibit({ stroke_windows })
  expect(withoutPower(whole, [])).toBe(whole)
  expect(withoutPower(whole, [2]).stroke_windows).toEqual([
    window(1, 'power'),
    window(2, 'exhaust'),
  ])
})
