/** A hyphen that is a sign; the one in 1-5-3 or V6-60 is none. */
const MINUS = /(?<![\w.\])°-])-(?=\d)/g
/** A number with an exponent, as programs write it. */
const POWER = /(?<![\w.])(-?\d+(?:[.,]\d+)?)e([-+]\d{2,})(?!\w)/g
const RAISED: Record<string, string> = Object.fromEntries(
  [...'-0123456789'].map((letter, place) => [letter, [...'⁻⁰¹²³⁴⁵⁶⁷⁸⁹'][place] ?? '']),
)

/**
 * A sentence with its numbers as they are printed: a minus is no hyphen, and powers of ten stand
 * raised: 7.4·10⁻⁵, of 7.4e-05. The report does the same.
 */
export function typeset(sentence: string): string {
  const raised = (power: string): string =>
    [...String(Number(power))].map((letter) => RAISED[letter] ?? letter).join('')
  return sentence
    .replace(POWER, (_, digits: string, power: string) => `${digits}·10${raised(power)}`)
    .replace(MINUS, '−')
}
