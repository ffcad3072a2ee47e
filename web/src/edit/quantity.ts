import { degreesOf, halfWidth } from '../angle'

/** A number with its unit; '' for a bare number, in SI or in the engine's own units. */
export interface Quantity {
  readonly number: number
  readonly unit: string
}

export type Dimension = 'angle' | 'length' | 'mass' | 'speed' | 'other'

/** The ends of a slider, and its step. */
export interface Scale {
  readonly low: number
  readonly high: number
  readonly step: number
}

/** A value as number and unit; null where it is neither. */
export function parsed(value: unknown): Quantity | null {
  if (typeof value === 'number') return Number.isFinite(value) ? { number: value, unit: '' } : null
  if (typeof value !== 'string') return null
  const match = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(\S.*?)?\s*$/.exec(
    halfWidth(value),
  )
  return match ? { number: Number(match[1]), unit: match[2] ?? '' } : null
}

/** A number in the unit and form (bare or text) of the value that it replaces. */
export function rewritten(number: number, was: unknown, usual: string): unknown {
  const before = parsed(was)
  const plain = Number(number.toPrecision(12))
  if (before === null) return usual ? `${plain} ${usual}` : plain
  if (before.unit) return `${plain} ${before.unit}`
  return typeof was === 'string' ? `${plain}` : plain
}

/** Typed text as a value: a bare number as a number, all else as text. */
export function typed(text: string): unknown {
  const trimmed = halfWidth(text).trim()
  return /^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/.test(trimmed) ? Number(trimmed) : text
}

/** A value as text in a field: lists with commas, lists of lists with semicolons. */
export function textOf(value: unknown): string {
  if (value === undefined || value === null) return ''
  if (Array.isArray(value)) return value.map(textOf).join(value.some(Array.isArray) ? '; ' : ', ')
  return String(value)
}

/** How much a full turn is in the unit of an angle; without one, in radians. */
export function turn(unit: string): number {
  return unit === '' ? 2 * Math.PI : 360 / (degreesOf(unit) ?? 1)
}

/** An angle in degrees, for a dial; null where it is no angle. */
export function degrees(value: unknown): number | null {
  const quantity = parsed(value)
  return quantity && (quantity.number / turn(quantity.unit)) * 360
}

/** An angle from degrees, in the unit of the value it takes the place of. */
export function angle(deg: number, was: unknown): unknown {
  const unit = parsed(was)?.unit ?? 'deg'
  return rewritten((deg / 360) * turn(unit), was, 'deg')
}

/** An angle between -180 (left out) and 180 degrees, rounded to a step. */
export function wrapped(deg: number, step: number): number {
  const rounded = Math.round(deg / step) * step
  const within = rounded - 360 * Math.ceil((rounded - 180) / 360)
  return Object.is(within, -0) ? 0 : within
}

/** The next number from above among 1, 2, 5, 10, 20, ... */
export function roundNumber(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value))
  return power * ([1, 2, 5, 10].find((step) => step * power >= value * (1 - 1e-9)) ?? 10)
}

/** A slider's scale about a value: twice it and more, both ways where it may be negative. */
export function scale(value: Quantity, dimension: Dimension, positive: boolean): Scale {
  if (dimension === 'angle') {
    const whole = turn(value.unit)
    return { low: -whole / 2, high: whole / 2, step: whole === 360 ? 1 : whole / 360 }
  }
  const size = Math.abs(value.number) || (value.unit === 'mm' ? 25 : 0.5)
  const high = roundNumber(1.5 * size)
  return { low: positive ? high / 200 : -high, high, step: high / 200 }
}

/** A scale within another whose every stop is a whole number of steps: 10.3, not 10.305. */
export function ruled({ low, high, step }: Scale): Scale {
  const stop = (count: number): number => Number((count * step).toPrecision(12))
  const [first, last] = [Math.ceil(low / step - 1e-9), Math.floor(high / step + 1e-9)]
  return last > first ? { low: stop(first), high: stop(last), step } : { low, high, step }
}
