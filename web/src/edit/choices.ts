import { message, t } from '../language/messages'

/** The words of keys in engine files that are chosen from a list. */
const WORDS = [
  message('two-stroke'),
  message('four-stroke'),
  message('clockwise'),
  message('counter-clockwise'),
  message('inline'),
  message('vee'),
  message('boxer'),
  message('opposed'),
  message('radial'),
  message('tandem'),
  message('mass'),
  message('pitch'),
  message('radius'),
  message('true'),
  message('false'),
  message('published'),
  message('computed'),
  message('unverified'),
  message('placeholder'),
  message('estimated'),
] as const

/** A value of a list as a word in the language of the page. */
export function choiceText(value: string): string {
  const word = WORDS.find((each) => each === value)
  return word === undefined ? value : t(word)
}
