import { expect, test } from 'vitest'
import { typeset } from '../../src/language/typeset'

test.each([
  ['order 6: 7.4379e-05 m r ω² a.', 'order 6: 7.4379·10⁻⁵ m r ω² a.'],
  ['2 ∠ -90° of 1-5-3-6-2-4', '2 ∠ −90° of 1-5-3-6-2-4'],
  ['1e+12 of V6-60, sedan-2e-05x', '1·10¹² of V6-60, sedan-2e-05x'],
  ['порядок 6: 7,4e-05', 'порядок 6: 7,4·10⁻⁵'],
])('numbers of a sentence are set as they are printed: %s', (written, expected) => {
  expect(typeset(written)).toBe(expected)
})
