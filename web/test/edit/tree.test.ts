import { expect, test } from 'vitest'
import { at, moved, put, read, same, within, written } from '../../src/edit/tree'

const engine = {
  name: 'V2',
  layout: { banks: [{ bearing: '-45 deg' }, { bearing: '45 deg' }], throws: ['0 deg', '90 deg'] },
}

test('a value is put where its path leads, and nothing else changes', () => {
  const turned = put(engine, ['layout', 'banks', 1, 'bearing'], '30 deg')
  expect(at(turned, ['layout', 'banks', 1, 'bearing'])).toBe('30 deg')
  expect(at(engine, ['layout', 'banks', 1, 'bearing'])).toBe('45 deg')
  expect(turned.layout.banks[0]).toBe(engine.layout.banks[0])
  expect(Object.keys(turned)).toEqual(['name', 'layout'])
})

test('tables and lists are made on the way', () => {
  expect(put({}, ['a', 'b', 0, 'c'], 1)).toEqual({ a: { b: [{ c: 1 }] } })
})

test('undefined takes a key or an item away', () => {
  expect(put(engine, ['layout', 'throws', 0], undefined).layout.throws).toEqual(['90 deg'])
  expect('name' in put(engine, ['name'], undefined)).toBe(false)
  expect(at(put(engine, ['layout', 'throws'], undefined), ['layout'])).not.toHaveProperty('throws')
})

test('an item is moved within its list and never out of it', () => {
  expect(moved({ list: [1, 2, 3] }, ['list'], 0, 2)).toEqual({ list: [2, 3, 1] })
  const tree = { list: [1, 2, 3] }
  expect(moved(tree, ['list'], 0, -1)).toBe(tree)
  expect(moved(tree, ['list'], 2, 3)).toBe(tree)
})

test('trees are the same whatever the order of their keys, and not if a list is in another order', () => {
  expect(same({ a: 1, b: [1, { c: 2 }] }, { b: [1, { c: 2 }], a: 1 })).toBe(true)
  expect(same([1, 2], [2, 1])).toBe(false)
  expect(same({ a: undefined }, { b: 1 })).toBe(false)
  expect(same([], {})).toBe(false)
})

test.each([
  ['layout.banks[2].bearing', ['layout', 'banks', 1, 'bearing']],
  ['provenance."cylinder.bore"', ['provenance', 'cylinder.bore']],
  ['shaft[1].throw[3].radius', ['shaft', 0, 'throw', 2, 'radius']],
  ['firing_order', ['firing_order']],
])('%s is read and written alike', (text, path) => {
  expect(read(text)).toEqual(path)
  expect(written(path)).toBe(text)
})

test('what is no path leads nowhere', () => {
  expect(read('the file')).toEqual([])
  expect(read('')).toEqual([])
  expect(read('a..b')).toEqual([])
})

test('a path lies within another one only below it', () => {
  expect(within(['a', 1, 'b'], ['a', 1])).toBe(true)
  expect(within(['a'], ['a', 1])).toBe(false)
  expect(within(['b', 1], ['a'])).toBe(false)
})
