/** A hyphen that is a sign; the one in 1-5-3 or V6-60 is none. */
const MINUS = /(?<![\w.\])°-])-(?=\d)/g
/** A number with an exponent, as programs write it; its sign may be a minus already. */
const POWER = /(?<![\w.])(-?\d+(?:[.,]\d+)?)e([-+−]\d+)(?!\w)/g
const RAISED: Record<string, string> = Object.fromEntries(
  [...'-0123456789'].map((letter, place) => [letter, [...'⁻⁰¹²³⁴⁵⁶⁷⁸⁹'][place] ?? '']),
)
const LOWERED = Object.fromEntries(Object.entries(RAISED).map(([plain, raised]) => [raised, plain]))

/** A number that `typeset` has set. */
const SET = /^−?\d+(?:[.,]\d+)?(?:·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?$/

/** A number as programs read it, of one that is set: -7.4e-5 of −7.4·10⁻⁵; other texts stay. */
export function unset(text: string): string {
  const [, raised] = text.match(SET) ?? []
  const plain = (letter: string): string => LOWERED[letter] ?? letter
  const digits = SET.test(text) ? text.replace('−', '-') : text
  return raised ? digits.replace(`·10${raised}`, `e${[...raised].map(plain).join('')}`) : digits
}

/**
 * A sentence with its numbers as they are printed: a minus is no hyphen, and powers of ten stand
 * raised: 7.4·10⁻⁵, of 7.4e-05. The report does the same.
 */
export function typeset(sentence: string): string {
  const raised = (power: string): string =>
    [...String(Number(power.replace('−', '-')))].map((letter) => RAISED[letter] ?? letter).join('')
  return sentence
    .replace(POWER, (_, digits: string, power: string) => `${digits}·10${raised(power)}`)
    .replace(MINUS, '−')
}
