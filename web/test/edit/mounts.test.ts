import { describe, expect, test } from 'vitest'
import {
  fourMounts,
  lengthLike,
  metres,
  mountsIn,
  oneMore,
  placedAt,
  placeIn,
  withEstimate,
} from '../../src/edit/mounts'
import { at } from '../../src/edit/tree'
import { type Place, placeAt, SIDES, seen, within } from '../../src/ui/layoutView'
import { exhibit } from '../stage/engine'

const tree = {
  name: 'mine',
  mounts: [
    { name: 'left', up: '-50 mm', right: '-0.3 m', z: 0.1, stiffness: '100 N/mm' },
    { name: 'right', right: '12 in', stiffness: '100 N/mm' },
    { name: 'odd', right: '2 cubits', stiffness: '100 N/mm' },
  ],
}

describe('lengths of a file', () => {
  test('are metres whatever their unit, nought where they are left out', () => {
    expect(['-50 mm', '-0.3 m', 0.1, '30 cm', '2 cubits', undefined].map(metres)).toEqual([
      -0.05,
      -0.3,
      0.1,
      0.3,
      null,
      0,
    ])
    expect(metres('12 in')).toBeCloseTo(0.3048, 12)
  })

  test('keep their unit when they change, in whole steps', () => {
    expect(lengthLike(-0.1234, '-50 mm', 0.005)).toBe('-125 mm')
    expect(lengthLike(-0.1234, '-0.3 m', 0.001)).toBe('-0.123 m')
    expect(lengthLike(0.1234, 0.1, 0.001)).toBe(0.123)
    expect(lengthLike(0.1234, undefined, 0.001)).toBe('123 mm')
    expect(lengthLike(0, '5 mm', 0.001)).toBe('0 mm')
  })
})

describe('mounts of a file', () => {
  test('have their places; one in a unit that is not known here has none', () => {
    const [left, right, odd] = mountsIn(tree)
    expect(left).toEqual({ index: 0, name: 'left', place: [-0.05, -0.3, 0.1] })
    expect(right?.place?.[1]).toBeCloseTo(0.3048, 12)
    expect(odd?.place).toBeNull()
    expect(placeIn({}, ['block'], [0.1, 0, -0.2])).toEqual([0.1, 0, -0.2])
  })

  test('that are dragged change what they are dragged along, and nothing else', () => {
    const was: Place = [-0.05, -0.3, 0.1]
    const next = placedAt(tree, ['mounts', 0], was, [-0.05, -0.2514, 0.1], 0.005)
    expect(at(next, ['mounts', 0])).toEqual({ ...tree.mounts[0], right: '-0.25 m' })
    expect(at(next, ['mounts', 1])).toEqual(tree.mounts[1])
  })

  test('are one more at the other side, under a name of its own', () => {
    const [left] = tree.mounts
    const more = oneMore([left, { name: 'mount 3' }, left])
    expect(more).toEqual({ ...left, name: 'mount 4', right: '0.3 m' })
    const pair = [left, { ...left, right: '300 mm' }]
    expect(oneMore(pair)).toMatchObject({ right: '-300 mm', z: 0.2 })
    expect(oneMore([{ name: 'rear', z: '-0.4 m' }])).toEqual({
      name: 'mount 2',
      right: '200 mm',
      z: '-0.4 m',
    })
  })

  test('that are offered carry the block where its centre of mass is, and let it bounce', () => {
    const { scene } = exhibit()
    const mounts = fourMounts(scene, { centre: [0.1, -0.02, 0.05], mass: 160 })
    expect(mounts).toHaveLength(4)
    const place = (key: string) => mounts.map((mount) => metres(mount[key]) ?? Number.NaN)
    const mean = (values: number[]) => values.reduce((sum, each) => sum + each, 0) / 4
    expect(mean(place('up'))).toBeCloseTo(0.1, 9)
    expect(mean(place('right'))).toBeCloseTo(-0.02, 2)
    expect(mean(place('z'))).toBeCloseTo(0.05, 2)
    const [first] = (mounts[0]?.stiffness ?? []) as string[]
    const frequency = Math.sqrt((4 * 1000 * Number.parseFloat(first ?? '')) / 160) / 2 / Math.PI
    expect(frequency).toBeGreaterThan(8)
    expect(frequency).toBeLessThan(10)
  })

  test('take an estimated mass, marked as a guess', () => {
    const next = withEstimate({ name: 'mine' }, 183.6, 'usual')
    expect(next).toEqual({
      name: 'mine',
      block: { mass: '184 kg' },
      provenance: { 'block.mass': { status: 'placeholder', source: 'usual' } },
    })
  })
})

test('a spot of a view is a place again, as far from the eye as it was', () => {
  const place: Place = [0.1, -0.3, 0.25]
  for (const side of SIDES) expect(placeAt(side, seen(side, place), place)).toEqual(place)
  expect(seen('front', place)).toEqual([-0.3, -0.1])
  expect(seen('side', place)).toEqual([-0.25, -0.1])
  expect(seen('plan', place)).toEqual([-0.25, -0.3])
})

test('a line is cut to its frame, and one that passes by is none', () => {
  const frame = { x: -1, y: -1, width: 2, height: 2 }
  expect(within(frame, [-5, 0.5], [5, 0.5])).toEqual([
    [-1, 0.5],
    [1, 0.5],
  ])
  expect(within(frame, [-2, -2], [2, 2])).toEqual([
    [-1, -1],
    [1, 1],
  ])
  expect(within(frame, [0, -3], [0, 0])).toEqual([
    [0, -1],
    [0, 0],
  ])
  expect(within(frame, [-5, 3], [5, 3])).toBeNull()
  expect(within(frame, [3, -5], [3, 5])).toBeNull()
  expect(within(frame, [0, 4], [4, 0])).toBeNull()
})
