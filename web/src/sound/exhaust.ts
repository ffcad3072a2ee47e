import type { Exhaust, Pipe } from '../exhibit'

/**
 * The exhaust of a pipe as a sum of orders of the working cycle, as in sound.py: equal pulses at
 * the firings, the mean left out.
 *
 * `x(a) = sum of real[n] cos(n a) + imag[n] sin(n a)`, a the share of the cycle times 2 pi: what a
 * PeriodicWave takes.
 */
export interface Heard {
  readonly real: Float32Array<ArrayBuffer>
  readonly imag: Float32Array<ArrayBuffer>
}

/** The loudest sample, of 1. */
const LOUDEST = 0.9
/** A wave that is never greater, a pulse being about 10, is rounding. */
const SILENT = 1e-3
/** Grid on which the greatest value of a wave is sought. */
const STEPS = 2048

/** The sum of unit pulses at an order of the cycle: `sum over j of exp(-i n 2 pi theta_j/C)`. */
export function pulses({ fires }: Pipe, cycle: number, harmonic: number): [number, number] {
  let [real, imaginary] = [0, 0]
  for (const angle of fires) {
    // whole cycles are left out before sine and cosine, which would lose their digits
    const part = ((harmonic * angle) / cycle) % 1
    real += Math.cos(2 * Math.PI * part)
    imaginary -= Math.sin(2 * Math.PI * part)
  }
  const rounding = 1e-12 * fires.length
  return [Math.abs(real) <= rounding ? 0 : real, Math.abs(imaginary) <= rounding ? 0 : imaginary]
}

/** The exhaust without the pulses of some chambers. */
export function silenced(exhaust: Exhaust, off: readonly number[]): Exhaust {
  if (!off.length) return exhaust
  const pipes = exhaust.pipes.map((pipe) => {
    const kept = pipe.chambers.flatMap((chamber, place) => (off.includes(chamber) ? [] : [place]))
    return {
      ...pipe,
      chambers: kept.map((place) => pipe.chambers[place] as number),
      fires: kept.map((place) => pipe.fires[place] as number),
    }
  })
  return { ...exhaust, pipes }
}

/** What pipes give together, each with its share. */
export function heard({ cycle, pulse, pipes }: Exhaust, shares: readonly number[]): Heard {
  const real = new Float32Array(pulse.length + 1)
  const imag = new Float32Array(pulse.length + 1)
  pulse.forEach((size, index) => {
    const harmonic = index + 1
    pipes.forEach((pipe, place) => {
      const [one, other] = pulses(pipe, cycle, harmonic)
      const share = size * (shares[place] ?? 0)
      real[harmonic] = (real[harmonic] ?? 0) + share * one
      imag[harmonic] = (imag[harmonic] ?? 0) - share * other
    })
  })
  return { real, imag }
}

/** The share of each pipe in each channel: they stand from left to right, as in sound.py. */
export function channelsOf({ pipes }: Exhaust): readonly (readonly number[])[] {
  if (pipes.length < 2) return [pipes.map(() => 1)]
  const right = pipes.map((_, place) => place / (pipes.length - 1))
  return [right.map((share) => 1 - share), right]
}

/** The greatest absolute value of a wave over the cycle. */
export function peakOf({ real, imag }: Heard): number {
  let most = 0
  for (let step = 0; step < STEPS; step++) {
    let sum = 0
    for (let n = 1; n < real.length; n++) {
      const angle = (2 * Math.PI * ((n * step) % STEPS)) / STEPS
      sum += (real[n] as number) * Math.cos(angle) + (imag[n] as number) * Math.sin(angle)
    }
    most = Math.max(most, Math.abs(sum))
  }
  return most
}

/** What waves are multiplied with, so that no echo ever makes them louder than a file may be. */
export function gainOf(waves: readonly Heard[], reflected: number): number {
  return (LOUDEST * (1 - reflected)) / Math.max(...waves.map(peakOf), SILENT)
}

/** Share of a wave below which its echoes are left out. */
const FAINT = 1e-5

/** A wave and its echoes from the open end of a pipe, each upside down to the one before. */
export function echoesOf(reflected: number): number[] {
  const taps = [1]
  for (let tap = -reflected; Math.abs(tap) > FAINT; tap *= -reflected) taps.push(tap)
  return taps
}

/** Working cycles in a second. */
export const cyclesAt = (rpm: number, { cycle }: Exhaust): number =>
  ((rpm / 60) * 2 * Math.PI) / cycle

/** How many times faster than on the page the engine is heard: slower, a pulse is no sound. */
export const FASTER = 50

/** The speed at which an engine is heard while the page turns it `pace` times a second, rpm. */
export const heardAt = (pace: number): number => Math.round(60 * FASTER * pace)
