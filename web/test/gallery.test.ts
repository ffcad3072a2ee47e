import { expect, test } from 'vitest'
import { matches } from '../src/gallery/filter'

const engine = { words: 'bmw-s65 bmw s65 v8 vee, 8 cylinders', layout: 'vee', cylinders: '8' }
const all = { words: '', layout: '', cylinders: '' }

test.each([
  [all, true],
  [{ ...all, words: ' S65  bmw ' }, true],
  [{ ...all, words: 'bmw boxer' }, false],
  [{ ...all, layout: 'vee', cylinders: '8' }, true],
  [{ ...all, layout: 'boxer' }, false],
  [{ ...all, cylinders: '6' }, false],
])('a gallery shows what has every word, the layout and the cylinders: %o', (wanted, shown) => {
  expect(matches(engine, wanted)).toBe(shown)
})
