import { Group, type InstancedMesh } from 'three'
import { describe, expect, test } from 'vitest'
import type { ShaftShown, Torsion } from '../../src/exhibit'
import { chainOf, moved, placesOf } from '../../src/motion'
import { bodiesOf } from '../../src/stage/bodies'
import { materials } from '../../src/stage/materials'
import { shafts } from '../../src/stage/parts/shafts'
import { Crank, crankOf, HEAT, MOST, Twisting, tintOf } from '../../src/stage/twist'
import type { Twist } from '../../src/torsion'
import { cylinder, exhibit, shaft } from './engine'

const pin = (z: number, angle = 0) => ({
  ...{ angle, radius: 1, z, cylinders: [] },
  ...{ pin_from: z - 0.3, pin_to: z + 0.3, pin_radius: 0.2 },
})
/** Throws of which the file names the rear one first; webs at both ends of each pin, one weight. */
const SHAFT: ShaftShown = shaft({
  ...{ z_from: -3, z_to: 3 },
  throws: [pin(-1), pin(1, Math.PI)],
  webs: [-1, 1].flatMap((z, place) => [
    { z_from: z - 0.5, z_to: z - 0.3, throw: place },
    { z_from: z + 0.3, z_to: z + 0.5, throw: place },
  ]),
  weights: [
    {
      ...{ angle: Math.PI, z: 0.6, unbalance: 1, inner_radius: 0.2, outer_radius: 1 },
      ...{ half_angle: 1, thickness: 0.2 },
    },
  ],
})
const plain = exhibit()
const torsion = { throws: [1, 0], pieces: [null, null, null] } as unknown as Torsion
const engine = exhibit({
  torsion,
  scene: {
    ...plain.scene,
    shafts: [SHAFT, shaft({ name: 'other' })],
    cylinders: [
      cylinder({ number: 1, throw: 1, throw_angle: Math.PI, z: 1 }),
      cylinder({ number: 2, throw: 0, z: -1 }),
      cylinder({ number: 3, shaft: 1, z: 0 }),
    ],
  },
})
const crank = new Crank(SHAFT, torsion.throws)
const twist: Twist = {
  ...{ orders: [2], of: 'stress', free: false, top: 4, greatest: 0.02, times: 10 },
  turns: [Float64Array.of(0.02, 0), Float64Array.of(0, -0.01)],
  loads: [null, Float64Array.of(-4, 0), Float64Array.of(0, 0)],
}

describe('what goes with which throw', () => {
  test('throws are numbered from the front', () => {
    expect(crank.places).toEqual([1, 0])
  })

  test('a pin is parted between the shafts at its sides', () => {
    expect(crank.pin(1)).toEqual([
      { low: 0, high: 0, piece: 0 },
      { low: 0, high: 0, piece: 1 },
    ])
    expect(crank.pin(0).map(({ piece }) => piece)).toEqual([1, 2])
  })

  test('a web is of the shaft at its side of the pin, and a weight of its web', () => {
    const pieces = SHAFT.webs.map((web) => [crank.web(web).low, crank.web(web).piece])
    expect(pieces).toEqual([
      [1, 2],
      [1, 1],
      [0, 1],
      [0, 0],
    ])
    const [weight] = SHAFT.weights
    expect(weight && crank.weight(weight)).toEqual({ low: 0, high: 0, piece: 1 })
  })

  test('a journal twists from the throw behind it to that in front, the ends go with theirs', () => {
    expect(crank.journal(-0.6, 0.6)).toEqual({ low: 1, high: 0, piece: 1 })
    expect(crank.journal(1.4, 3)).toEqual({ low: 0, high: 0, piece: 0 })
    expect(crank.journal(-3, -1.4)).toEqual({ low: 1, high: 1, piece: 2 })
  })

  test('an engine without torsion has no crank that twists, nor has one with too many throws', () => {
    expect(crankOf(plain)).toBeNull()
    const throws = Array.from({ length: MOST + 1 }, (_, index) => index)
    expect(crankOf({ ...engine, torsion: { ...torsion, throws } })).toBeNull()
  })
})

test('a throw is ahead by its turn times the magnification, and so are the pins on it', () => {
  const { ahead, cylinders } = new Twisting(engine, crank, twist).at(0.3)
  expect(ahead[0]).toBeCloseTo(0.2 * Math.cos(0.6), 7)
  expect(ahead[1]).toBeCloseTo(0.1 * Math.sin(0.6), 7)
  expect([...cylinders]).toEqual([ahead[0], ahead[1], 0])
})

test('a shaft has the colour of its load, whichever way that goes, or grey', () => {
  const { heat } = new Twisting(engine, crank, twist).at(0)
  const colour = (piece: number) => [...heat.subarray(4 * piece, 4 * piece + 3)]
  expect(colour(1)).toEqual([...tintOf(1)])
  expect(colour(2)).toEqual([...tintOf(0)])
  const [red = 0, green = 0, blue = 0] = colour(0)
  expect(Math.max(red, green, blue) - Math.min(red, green, blue)).toBeLessThan(0.1)
})

test('more load is darker all along', () => {
  const light = (share: number) => {
    const [red = 0, green = 0, blue = 0] = tintOf(share)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue
  }
  const steps = Array.from({ length: 41 }, (_, step) => light(step / 40))
  for (let step = 1; step < steps.length; step++)
    expect(steps[step]).toBeLessThan(steps[step - 1] as number)
  expect(HEAT.length).toBeGreaterThan(2)
})

test.each([1, -1])('a big end goes ahead the way its shaft turns, sense %d', (sense) => {
  const chain = chainOf(engine.scene, sense)
  const ahead = Float64Array.of(0.2, -0.1, 0)
  const places = placesOf(chain)
  moved(chain, 0.5, places, ahead)
  const expected = [Math.PI + sense * 0.7, sense * 0.4, sense * 0.5]
  expected.forEach((bearing, index) => {
    expect(places.bigEnd[2 * index]).toBeCloseTo(Math.cos(bearing), 12)
    expect(places.bigEnd[2 * index + 1]).toBeCloseTo(Math.sin(bearing), 12)
  })
})

test('each point of the drawn crank knows its throw and its shaft', () => {
  const group = new Group()
  shafts(group, engine.scene, 1, materials(), crank)
  const [mesh] = group.children as InstancedMesh[]
  const geometry = mesh?.geometry
  const [at, mark] = ['position', 'mark'].map((name) => geometry?.getAttribute(name))
  expect(mark?.count).toBe(at?.count)
  for (let index = 0; index < (at?.count ?? 0); index++) {
    const [x = 0, y = 0, z = 0] = [at?.getX(index), at?.getY(index), at?.getZ(index)]
    const [node, piece] = [mark?.getX(index), mark?.getY(index)]
    if (Math.hypot(x, y) > 0.5) expect(node).toBe(z > 0 ? 0 : 1)
    const off = (edge: number) => Math.abs(z - edge) < 1e-6
    if (!off(1) && !off(-1)) expect(piece).toBe(z > 1 ? 0 : z > -1 ? 1 : 2)
  }
})

test('other engines are drawn without marks, their pins whole', () => {
  const group = new Group()
  shafts(group, engine.scene, 1, materials())
  const [mesh] = group.children as InstancedMesh[]
  expect(mesh?.geometry.getAttribute('mark')).toBeUndefined()
  const pins = (all: ReturnType<typeof bodiesOf>) =>
    all.filter(({ carrier, index }) => carrier === 'shaft' && index === 0)
  const [whole, parted] = [bodiesOf(engine.scene), bodiesOf(engine.scene, crank)].map(pins)
  expect(parted?.length).toBe((whole?.length ?? 0) + 2)
  expect(whole?.every(({ mark }) => mark === null)).toBe(true)
  expect(parted?.every(({ mark }) => mark !== null)).toBe(true)
})
