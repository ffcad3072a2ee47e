import type { Unit } from './exhibit'
import { t } from './language/messages'

/** A number with four figures. */
function figures(value: number): string {
  if (value === 0) return '0'
  const size = Math.abs(value)
  const text =
    size >= 1e5 || size < 1e-4 ? value.toExponential(3) : Number(value.toPrecision(4)).toString()
  return text.replace('-', '−')
}

/** The unit that a length is shown in: the greatest of which it is a tenth or more, else the least. */
export function lengthUnit(length: number, units: readonly Unit[]): Unit {
  const fits = units.filter(({ factor }) => Math.abs(length) * factor >= 0.1 * (1 - 1e-9))
  return fits.at(-1) ?? units[length === 0 ? units.length - 1 : 0] ?? { label: '', factor: 1 }
}

/** A length of a scene in the unit that fits it; one too small to be real is 0. */
export function lengthText(length: number, units: readonly Unit[]): string {
  const size = Math.abs(length)
  const scaled = units.length > 1 || (units[0]?.factor ?? 1) !== 1
  if (scaled && size < 1e-9) return '0'
  const unit = lengthUnit(length, units)
  return quantityText(length * unit.factor, unit.label)
}

/** A number with its unit. */
export function quantityText(value: number, unit: string): string {
  return `${figures(value)} ${unit}`
}

/** A number with its unit; with others of the same quantity, the range that they span. */
export function rangedText(
  value: number,
  others: readonly number[],
  { label, factor }: Unit,
): string {
  const [low, high] = [Math.min(value, ...others), Math.max(value, ...others)]
  if (high - low <= 1e-6 * Math.abs(value)) return quantityText(value * factor, label)
  const [typical, least, most] = [value, low, high].map((each) => rough(each * factor)) as [
    string,
    string,
    string,
  ]
  if (least === most) return `${typical} ${label}`
  const text = t('{typical} ({low} to {high})', { typical, low: least, high: most })
  return `${text} ${label}`
}

/** A number that rests on estimates, with three figures. */
function rough(value: number): string {
  return figures(Number(value.toPrecision(3)))
}
