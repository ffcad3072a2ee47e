import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { session } from '../../src/edit/session'
import type { Exhibit } from '../../src/exhibit'
import type { Answer, Service, Tree } from '../../src/host/host'

beforeEach(() => void vi.useFakeTimers())
afterEach(() => void vi.useRealTimers())

const settle = () => vi.advanceTimersByTimeAsync(1000)
const placed = (file: Tree) => ({ file, relative: [], weight_throws: [] })
const wrong = { path: 'layout.banks[1].bearing', message: 'is "xx"' }

/** A session with a server that finds `xx` wrong, and what it put on the stage. */
function begun(more: Partial<Service> = {}) {
  const onStage: Tree[] = []
  const service = {
    exhibit: async (tree: Tree): Promise<Answer<Exhibit>> =>
      JSON.stringify(tree).includes('xx')
        ? { ok: false, problems: [wrong] }
        : { ok: true, value: { file: tree } as unknown as Exhibit },
    schema: async () => ({ anyOf: [] }),
    catalog: async () => [],
    ...more,
  } as Service
  const tree = { name: 'V2', layout: { type: 'vee', banks: [{ bearing: '45 deg' }] } }
  return {
    onStage,
    tree,
    now: session(service, placed(tree), (exhibit) => onStage.push(exhibit.file)),
  }
}

const bearing = ['layout', 'banks', 0, 'bearing']

test('what is valid comes on the stage, what is not does not and is told where it is', async () => {
  const { now, onStage } = begun()
  now.set(bearing, 'xx')
  await settle()
  expect(onStage).toEqual([])
  expect(now.problems.value).toEqual([{ ...wrong, at: bearing }])
  now.set(bearing, '30 deg')
  await settle()
  expect(onStage).toHaveLength(1)
  expect(now.problems.value).toEqual([])
})

test('a throw that is turned takes its weights along, by any way of typing', async () => {
  const weight = (angle: string) => ({ unbalance: '1 kg*m', angle })
  const shaft = {
    throw: [{ angle: '0 deg' }, { angle: '90 deg' }],
    weight: [weight('180 deg'), weight('-90 deg'), weight('-90 deg')],
  }
  const { now } = begun()
  now.adopt({ file: { shaft: [shaft] }, relative: [], weight_throws: [[1, 2, 2]] })
  const path = ['shaft', 0, 'throw', 1, 'angle']
  for (const typed of ['', '2', '210 deg']) now.set(path, typed)
  const at = (now.tree.value.shaft as (typeof shaft)[])[0]
  expect(at?.throw.map(({ angle }) => angle)).toEqual(['0 deg', '210 deg'])
  expect(at?.weight.map(({ angle }) => angle)).toEqual(['180 deg', '30 deg', '30 deg'])
  now.set(['shaft', 0, 'weight', 1, 'angle'], '5 deg')
  expect((now.tree.value.shaft as (typeof shaft)[])[0]?.weight[1]?.angle).toBe('5 deg')
})

test('an engine that others put on the stage is taken over as a step that can be undone', async () => {
  const { now, onStage } = begun()
  const other = { name: 'I4' }
  now.set(['name'], 'V2, mine')
  await settle()
  const mine = now.tree.value
  onStage.length = 0
  now.adopt(placed(other))
  await settle()
  expect(now.tree.value).toEqual(other)
  expect(onStage).toEqual([])
  now.undo()
  await settle()
  expect(onStage).toEqual([mine])
})

test('until something is changed, a session begins with what others put on the stage', async () => {
  const { now } = begun()
  now.adopt(placed({ name: 'I4' }))
  await settle()
  expect(now.tree.value).toEqual({ name: 'I4' })
  expect(now.canUndo.value).toBe(false)
})

test('the engine that the form itself put on the stage is not taken over, and a draft with a mistake stays', async () => {
  const { now, onStage } = begun()
  now.set(['name'], 'V2 b')
  await settle()
  now.adopt(placed({ ...onStage[0] }))
  expect(now.canRedo.value).toBe(false)
  now.set(bearing, 'xx')
  await settle()
  now.adopt(placed({ ...onStage[0] }))
  expect(now.tree.value).toMatchObject({ layout: { banks: [{ bearing: 'xx' }] } })
  now.undo()
  now.undo()
  expect(now.canUndo.value).toBe(false)
})

test('typing is one step until a pause', async () => {
  const { now, tree } = begun()
  now.set(['name'], 'a', 'type name')
  now.set(['name'], 'ab', 'type name')
  await vi.advanceTimersByTimeAsync(2000)
  now.set(['name'], 'abc', 'type name')
  now.undo()
  expect(now.tree.value.name).toBe('ab')
  now.undo()
  expect(now.tree.value).toEqual(tree)
})

test('a file that is no engine changes nothing, and makes nothing in the form wrong', async () => {
  const { now, tree, onStage } = begun()
  const opened = await now.open(Promise.resolve({ ok: false, problems: [wrong] }), 'x.toml')
  await settle()
  expect(opened).toBe(false)
  expect(now.tree.value).toEqual(tree)
  expect(onStage).toEqual([])
  expect(now.problems.value).toEqual([])
  expect(now.refused.value?.problems).toEqual([wrong])
  expect(now.refused.value?.what).toContain('x.toml could not be opened')
})

test('what the form is made of is asked for once, and again after a failure', async () => {
  let asked = 0
  const { now } = begun({
    schema: async () => {
      asked += 1
      if (asked === 1) throw new TypeError('Failed to fetch')
      return { anyOf: [] }
    },
  })
  now.load()
  await settle()
  expect(now.note.value).toContain('Failed to fetch')
  now.load()
  now.load()
  await settle()
  expect(asked).toBe(2)
})

test('a value that is changed is no longer the one that a source gives', () => {
  const { now } = begun()
  now.edit({
    ...now.tree.value,
    provenance: { speed: { status: 'published' }, cylinder: { status: 'published' } },
  })
  now.set(['speed'], '900 rpm')
  expect(now.tree.value.provenance).toEqual({ cylinder: { status: 'published' } })
})

test('a direct control leaves out a firing order that no longer fits, in one step', async () => {
  const { now, onStage } = begun({
    exhibit: async (tree: Tree): Promise<Answer<Exhibit>> =>
      'firing_order' in tree && JSON.stringify(tree).includes('30 deg')
        ? { ok: false, problems: [{ path: 'firing_order', message: 'cannot fire' }] }
        : { ok: true, value: { file: tree } as unknown as Exhibit },
  })
  now.replace({ ...now.tree.value, firing_order: [1, 2] })
  now.direct({ ...now.tree.value, layout: { type: 'vee', banks: [{ bearing: '30 deg' }] } }, 'v')
  await settle()
  expect(onStage.at(-1)).toMatchObject({ name: 'V2, edited' })
  expect(onStage.at(-1)).not.toHaveProperty('firing_order')
  expect(now.problems.value).toEqual([])
  expect(now.note.value).toContain('left out')
  now.undo()
  expect(now.tree.value).toMatchObject({ name: 'V2', firing_order: [1, 2] })
})

test('the history leads to any of its steps and back', () => {
  const { now } = begun()
  for (const to of ['10 deg', '20 deg', '30 deg']) now.set(bearing, to)
  now.goTo(1)
  expect(now.steps.value).toMatchObject({ at: 1 })
  expect(now.steps.value.all).toHaveLength(4)
  expect(now.tree.value.layout).toMatchObject({ banks: [{ bearing: '10 deg' }] })
  now.goTo(3)
  expect(now.tree.value.layout).toMatchObject({ banks: [{ bearing: '30 deg' }] })
  expect(now.canRedo.value).toBe(false)
})

test('a direct control takes weights along and leaves out the source of what it changes', () => {
  const weight = { unbalance: '1 kg*m', angle: '-90 deg' }
  const shaft = { throw: [{ angle: '0 deg' }, { angle: '90 deg' }], weight: [weight] }
  const provenance = { 'shaft.throw.angle': { status: 'published', source: 'x' } }
  const { now } = begun()
  const file = { shaft: [shaft], provenance }
  now.adopt({ file, relative: [], weight_throws: [[2]] })
  const turned = { ...shaft, throw: [shaft.throw[0], { angle: '120 deg' }] }
  now.direct({ ...file, shaft: [turned] }, 'pin')
  expect(now.tree.value).toEqual({
    shaft: [{ ...turned, weight: [{ ...weight, angle: '-60 deg' }] }],
  })
})
