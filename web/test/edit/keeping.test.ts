import { expect, test } from 'vitest'
import {
  exported,
  imported,
  type Kept,
  keep,
  keepLast,
  keptIn,
  lastIn,
  type Store,
  withEngine,
  withName,
  without,
} from '../../src/edit/keeping'

const engine = (id: string, name = id): Kept => ({
  id,
  name,
  at: '2026-01-02T03:04:05Z',
  summary: 'inline, 4',
  likeness: { axes_deg: [0], throws_deg: [0, 180], radial: false },
  tree: { name },
})

function store(): Store & { readonly held: Map<string, string> } {
  const held = new Map<string, string>()
  return {
    held,
    getItem: (key) => held.get(key) ?? null,
    setItem: (key, text) => void held.set(key, text),
    removeItem: (key) => void held.delete(key),
  }
}

test('what is kept is there again, the newest first, and can be renamed and deleted', () => {
  const kept = store()
  expect(keep(kept, withEngine([engine('a')], engine('b')))).toBeNull()
  expect(keptIn(kept).map(({ id }) => id)).toEqual(['b', 'a'])
  const named = withName(keptIn(kept), 'a', 'my four')
  expect(named[1]).toMatchObject({ name: 'my four', tree: { name: 'my four' } })
  expect(without(named, 'b').map(({ id }) => id)).toEqual(['a'])
  keepLast(kept, engine('c'))
  expect(lastIn(kept)?.name).toBe('c')
})

test('a store that is full, and one that may not be used, are told apart', () => {
  const refusing = (name: string): Store => ({
    ...store(),
    setItem: () => {
      throw new DOMException('no', name)
    },
  })
  expect(keep(refusing('QuotaExceededError'), [])).toBe('full')
  expect(keep(refusing('SecurityError'), [])).toBe('off')
  expect(keep(null, [])).toBe('off')
  expect(keptIn(null)).toEqual([])
})

test('nonsense in the store or in a file is no engine', () => {
  const kept = store()
  kept.setItem('crankstar.engines', '[1, null, {"tree": 3}, {"tree": {"name": "x"}}]')
  expect(keptIn(kept).map(({ name }) => name)).toEqual(['x'])
  kept.setItem('crankstar.engines', '{oops')
  kept.setItem('crankstar.last', '7')
  expect([keptIn(kept), lastIn(kept)]).toEqual([[], null])
  expect(imported('{oops', 1)).toBeNull()
  expect(imported('{"engines": 3}', 1)).toBeNull()
})

test('all engines go into one file and come back under ids of their own', () => {
  const engines = [engine('a'), engine('b')]
  const back = imported(exported(engines), 7)
  expect(back?.map(({ name, tree }) => [name, tree])).toEqual([
    ['a', { name: 'a' }],
    ['b', { name: 'b' }],
  ])
  expect(back?.map(({ id }) => id)).toEqual(['7-0', '7-1'])
})
