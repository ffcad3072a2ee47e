import { expect, test } from 'vitest'
import type { Exhaust, Pipe } from '../../src/exhibit'
import {
  channelsOf,
  cyclesAt,
  echoesOf,
  gainOf,
  heard,
  heardAt,
  peakOf,
  pulses,
  silenced,
} from '../../src/sound/exhaust'

const DEG = Math.PI / 180
const CYCLE = 720 * DEG
const WIDTH = 60

const pipe = (...degrees: number[]): Pipe => ({
  name: '',
  chambers: degrees.map((_, place) => place + 1),
  fires: degrees.map((at) => at * DEG),
})

const CROSS = pipe(0, 180, 450, 630)
const FLAT = pipe(0, 180, 360, 540)

/** The amplitude of a raised cosine at an order of the crank, of that at order 0. */
function pulse(order: number): number {
  const share = (order * WIDTH) / 360
  if (Math.abs(share - 1) < 1e-9) return 0.5
  return Math.sin(Math.PI * share) / (Math.PI * share) / (1 - share ** 2)
}

const exhaust = (...pipes: Pipe[]): Exhaust => ({
  cycle: CYCLE,
  pulse: Array.from({ length: 96 }, (_, index) => pulse((index + 1) / 2)),
  back: 0.004,
  reflected: 0.5,
  pipes,
})

test('a bank of a cross-plane engine has half orders, one of a flat-plane engine none', () => {
  const sizes = (own: Pipe) =>
    [1, 2, 3, 4, 5, 6, 7, 8].map((each) => Math.hypot(...pulses(own, CYCLE, each)))
  expect(sizes(FLAT)).toEqual([0, 0, 0, 4, 0, 0, 0, 4])
  const cross = [1.0824, 0, 2.6131, 0, 2.6131, 0, 1.0824, 4]
  for (const [place, size] of sizes(CROSS).entries()) expect(size).toBeCloseTo(cross[place] ?? 0, 4)
})

test('the wave is that of the pulses at their firings, less their mean', () => {
  const { real, imag } = heard(exhaust(CROSS), [1])
  // one pulse is 2 (WIDTH/2)/720 of its amplitude at order 0
  const share = WIDTH / 720
  for (const angle of [0, 17, 95, 180, 300, 449.5, 640]) {
    let sum = 0
    for (let n = 1; n < real.length; n++) {
      const at = (2 * Math.PI * n * angle) / 720
      sum += (real[n] ?? 0) * Math.cos(at) + (imag[n] ?? 0) * Math.sin(at)
    }
    const direct = [0, 180, 450, 630].reduce((all, fires) => {
      const apart = ((((angle - fires + 360) % 720) + 720) % 720) - 360
      return (
        all + (Math.abs(apart) < WIDTH / 2 ? (1 + Math.cos((2 * Math.PI * apart) / WIDTH)) / 2 : 0)
      )
    }, 0)
    expect(share * sum).toBeCloseTo(direct - (4 * share) / 2, 2)
  }
})

test('pipes stand from left to right', () => {
  expect(channelsOf(exhaust(CROSS))).toEqual([[1]])
  expect(channelsOf(exhaust(CROSS, FLAT))).toEqual([
    [1, 0],
    [0, 1],
  ])
  expect(channelsOf(exhaust(CROSS, FLAT, CROSS))).toEqual([
    [1, 0.5, 0],
    [0, 0.5, 1],
  ])
})

test('no echo makes it louder than a file may be', () => {
  const own = heard(exhaust(FLAT), [1])
  const gain = gainOf([own], 0.5)
  // the echoes of a steady wave at its worst: 1 + r + r^2 + ...
  expect((gain * peakOf(own)) / (1 - 0.5)).toBeCloseTo(0.9, 6)
  expect(gainOf([heard(exhaust(), [])], 0.5)).toBeGreaterThan(0)
})

test('echoes are each upside down to the one before and end where they are faint', () => {
  const taps = echoesOf(0.5)
  expect(taps.slice(0, 4)).toEqual([1, -0.5, 0.25, -0.125])
  expect(taps).toHaveLength(17)
  expect(echoesOf(0)).toEqual([1])
})

test('an engine is heard at its speed, which the slider of the page sets', () => {
  expect(heardAt(0.4)).toBe(1200)
  expect(cyclesAt(1200, exhaust())).toBeCloseTo(10, 12)
})

test('a chamber without combustion sends no pulse, the others as before', () => {
  const exhaust = { cycle: CYCLE, pulse: [1, 1], back: 0, reflected: 0, pipes: [FLAT] }
  const [left] = silenced(exhaust, [2]).pipes
  expect(left?.chambers).toEqual([1, 3, 4])
  expect(left && pulses(left, CYCLE, 1)).toEqual([expect.closeTo(0, 12), expect.closeTo(1, 12)])
  expect(silenced(exhaust, [])).toBe(exhaust)
})
