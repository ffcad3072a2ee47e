import { expect, test } from 'vitest'
import { typeset, unset } from '../../src/language/typeset'

test.each([
  ['order 6: 7.4379e-05 m r ω² a.', 'order 6: 7.4379·10⁻⁵ m r ω² a.'],
  ['2 ∠ -90° of 1-5-3-6-2-4', '2 ∠ −90° of 1-5-3-6-2-4'],
  ['1e+12 of V6-60, sedan-2e-05x', '1·10¹² of V6-60, sedan-2e-05x'],
  ['−4.2e−05 ∠ 180°, 1.43e-4', '−4.2·10⁻⁵ ∠ 180°, 1.43·10⁻⁴'],
  ['порядок 6: 7,4e-05', 'порядок 6: 7,4·10⁻⁵'],
])('numbers of a sentence are set as they are printed: %s', (written, expected) => {
  expect(typeset(written)).toBe(expected)
})

test('a number that is set is read back by spreadsheets, a text stays as it is', () => {
  const cells = ['−4.2075e-05', '−53.897', '1e+12', '0.5', '3.2 ∠ −90°', '1-5-3']
  const read = ['-4.2075e-5', '-53.897', '1e12', '0.5', '3.2 ∠ −90°', '1-5-3']
  expect(cells.map((cell) => unset(typeset(cell)))).toEqual(read)
})
