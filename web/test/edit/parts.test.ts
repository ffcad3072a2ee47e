import { expect, test } from 'vitest'
import { matching } from '../../src/edit/catalog'
import { fileName } from '../../src/edit/files'
import { numbersOf, TYPES, withLayout } from '../../src/edit/layouts'
import { measured } from '../../src/edit/schema'
import { EMPTY, optionsOf, otherSentences, sentencesOf } from '../../src/edit/searchForm'
import { sentencesAt } from '../../src/edit/session'
import { withoutSources } from '../../src/edit/sources'

const entries = [
  {
    name: 'v8-cross-plane',
    title: 'V8, cross-plane crank, 90 deg',
    layout: 'vee',
    cylinders: 8,
    cycle: 'four-stroke',
  },
  {
    name: 'kr250-racer',
    title: 'Kawasaki KR250 racer',
    layout: 'tandem',
    cylinders: 2,
    cycle: 'two-stroke',
  },
  { name: 'v12-60', title: 'V12, 60 deg', layout: 'vee', cylinders: 12, cycle: 'four-stroke' },
]

test.each([
  ['', ['v8-cross-plane', 'kr250-racer', 'v12-60']],
  ['KR250', ['kr250-racer']],
  ['vee 12', ['v12-60']],
  ['two-stroke', ['kr250-racer']],
  ['8 cyl', ['v8-cross-plane']],
  ['cross crank', ['v8-cross-plane']],
  ['steam', []],
])('the catalog searched for "%s"', (typed, names) => {
  expect(matching(entries, typed).map((entry) => entry.name)).toEqual(names)
})

test('an engine is saved under a name that every system takes', () => {
  expect(fileName('V8, cross-plane crank, 90 deg')).toBe('v8-cross-plane-crank-90-deg.toml')
  expect(fileName('</script><img src=x onerror=alert(1)>')).toBe(
    'script-img-src-x-onerror-alert-1.toml',
  )
  expect(fileName('../../etc/passwd')).toBe('etc-passwd.toml')
  expect(fileName(undefined)).toBe('engine.toml')
})

const vee = {
  name: 'V4',
  firing_order: [1, 3, 4, 2],
  cylinder: { stroke: '80 mm' },
  layout: {
    type: 'vee',
    banks: [{ cylinders: [1, 3] }, { cylinders: [2, 4] }],
    throws: ['0 deg', '180 deg'],
    bore_pitch: '100 mm',
  },
}

test.each(TYPES)('a layout %s has all the cylinders and is of its type', (type) => {
  const tree = withLayout(vee, type)
  expect(tree.layout).toMatchObject({ type })
  expect(numbersOf(tree)).toEqual([1, 2, 3, 4])
  expect(tree).toMatchObject({ name: 'V4', cylinder: { stroke: '80 mm' } })
  expect(tree).not.toHaveProperty('firing_order')
})

test('an unknown layout changes nothing', () => {
  expect(withLayout(vee, 'explicit')).toBe(vee)
})

test('the options of a search are only those that were given', () => {
  expect(optionsOf(EMPTY)).toEqual({})
  expect(optionsOf({ ...EMPTY, objectives: ['M1'] })).toEqual({ minimise: 'M1' })
  expect(
    optionsOf({
      ...EMPTY,
      of: 'number',
      cylinders: '9',
      cycle: 'four-stroke',
      objectives: ['M2'],
      more: ' F1 ,2*M4',
    }),
  ).toEqual({
    cylinders: 9,
    cycle: 'four-stroke',
    minimise: 'M2,F1,2*M4',
  })
  expect(
    optionsOf({
      ...EMPTY,
      objectives: [],
      best: '20',
      limit: 'M2=1.5, neighbours=1',
      zero: 'M1',
      fix: '1=0',
      symmetric: true,
      apart: true,
    }),
  ).toEqual({
    best: 20,
    limit: ['M2=1.5', 'neighbours=1'],
    zero: 'M1',
    fix: '1=0',
    symmetric: true,
    avoid_adjacent: true,
  })
})

test('a sentence stands beside the field that it names, and with those above only where they ask for it', () => {
  const problems = [
    { path: 'layout.throws[2]', message: 'no angle', at: ['layout', 'throws', 1] },
    { path: 'the file', message: 'broken', at: [] },
  ]
  expect(sentencesAt(problems, ['layout', 'throws', 1], false)).toEqual(['no angle'])
  expect(sentencesAt(problems, ['layout', 'throws'], false)).toEqual([])
  expect(sentencesAt(problems, ['layout', 'throws'], true)).toEqual(['no angle'])
  expect(sentencesAt(problems, [], true)).toEqual(['no angle'])
})

test('a value that was changed loses the source of the old one, and nothing else does', () => {
  const published = { status: 'published' }
  const tree = {
    provenance: {
      'layout.banks': published,
      'layout.throws': published,
      'cylinder.bore': published,
    },
  }
  const left = (path: (string | number)[]) =>
    Object.keys((withoutSources(tree, path).provenance ?? {}) as object)
  expect(left(['layout', 'banks', 0, 'bearing'])).toEqual(['layout.throws', 'cylinder.bore'])
  expect(left(['layout'])).toEqual(['cylinder.bore'])
  expect(left(['cylinder', 'stroke'])).toEqual(['layout.banks', 'layout.throws', 'cylinder.bore'])
  expect(withoutSources(tree, ['provenance', 'cylinder.bore'])).toBe(tree)
  expect(withoutSources({ provenance: { speed: published } }, ['speed'])).toEqual({})
})

test('what an engine counts in its own units has none', () => {
  const inertia = { is: 'quantity', dimension: 'other', positive: true } as const
  const beside = (...relativeTo: string[]) => ({ ...inertia, relativeTo })
  expect(measured(beside('radius'), ['pitch'])).toBe(true)
  expect(measured(beside('mass', 'radius'), ['radius'])).toBe(false)
  expect(measured(beside(), ['mass', 'radius', 'pitch'])).toBe(true)
})

test('a fault of a search stands beside the field that it is about', () => {
  const problems = [
    { path: 'zero', message: 'not neighbours' },
    { path: 'limit[1]', message: 'give a letter' },
    { path: '', message: 'too much' },
    { path: 'engine.layout', message: 'is missing' },
  ]
  expect(sentencesOf(problems, ['zero'])).toEqual(['not neighbours'])
  expect(sentencesOf(problems, ['limit', 'fix'])).toEqual(['give a letter'])
  expect(otherSentences(problems)).toEqual(['too much', 'engine.layout: is missing'])
})
