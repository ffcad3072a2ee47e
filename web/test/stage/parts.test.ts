import { Group, type InstancedMesh, Matrix4, Vector3 } from 'three'
import { describe, expect, test } from 'vitest'
import type { Exhibit, GearShown, Scene } from '../../src/exhibit'
import { mountChoiceOf } from '../../src/mounts'
import { along, boreEnd, facesAnother } from '../../src/stage/extent'
import { hull } from '../../src/stage/hull'
import { type Load, Loads, ROLL } from '../../src/stage/load'
import { materials } from '../../src/stage/materials'
import type { Detail } from '../../src/stage/mould'
import { band, circle, gear, type Outline, sector } from '../../src/stage/outlines'
import { arrows } from '../../src/stage/parts/arrows'
import { toothBearings } from '../../src/stage/parts/meshing'
import { journals } from '../../src/stage/parts/shafts'
import { quantity, roundValue } from '../../src/stage/round'
import { BAR, Solid, solidOf } from '../../src/stage/solid'
import type { View } from '../../src/stage/stage'
import { tint, windowsOf } from '../../src/stage/strokes'
import { twistChoiceOf } from '../../src/torsion'
import { COLOURS, cylinder, exhibit, shaft } from './engine'

const area = (ring: Outline) =>
  ring.reduce((sum, [x, y], index) => {
    const [nextX, nextY] = ring[(index + 1) % ring.length] as [number, number]
    return sum + (x * nextY - nextX * y) / 2
  }, 0)

describe('outlines run counter-clockwise', () => {
  test.each([
    ['a circle', circle(1, 2, 3, 400), 9 * Math.PI],
    ['a band', band(1, 3, 0.7, 1), Math.PI + 6],
    ['a sector', sector(1, 2, 2, 0.5), 1.5],
    ['a gear', gear(1, 40), Math.PI],
  ])('%s', (_, ring, expected) => {
    expect(area(ring) / expected).toBeGreaterThan(0.97)
    expect(area(ring) / expected).toBeLessThan(1.01)
  })
})

function volume(solid: Solid, detail: Detail = 'fine'): number {
  const { faces } = solid.shape(detail)
  const at = faces.getAttribute('position')
  const index = faces.getIndex()?.array ?? []
  let sum = 0
  for (let step = 0; step < index.length; step += 3) {
    const corner = (turn: number) => {
      const point = index[step + turn] as number
      // Seen from a point that is in the plane of no face, so that each of them counts.
      return [at.getX(point) + 0.7, at.getY(point) - 0.4, at.getZ(point) + 1.3] as const
    }
    const [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = [corner(0), corner(1), corner(2)]
    sum += (ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx)) / 6
  }
  return sum
}

test('drawn coarsely, round things have half the corners and nearly the same volume, edges stay', () => {
  const corners = (solid: Solid, detail: Detail) => solid.shape(detail).faces.getIndex()?.count ?? 0
  const hexagon = circle(0, 0, 1, 6)
  const round = new Solid().prism(circle(0, 0, 1, 36), 0, 1)
  const cheek = new Solid().prism(band(1, 3, 0.7, 1), 0, 1)
  const bar = new Solid().turned(BAR)
  for (const solid of [round, cheek, bar]) {
    const share = corners(solid, 'coarse') / corners(solid, 'fine')
    expect(share).toBeGreaterThan(0.45)
    expect(share).toBeLessThan(0.65)
    expect(volume(solid, 'coarse') / volume(solid)).toBeGreaterThan(0.96)
  }
  const sharp = new Solid().prism(hexagon, 0, 1)
  expect(volume(sharp, 'coarse')).toBe(volume(sharp))
  const lines = (solid: Solid) => solid.shape('coarse').lines.getAttribute('position').count
  // two rings of eighteen lines: no corner of a round outline has become an edge
  expect(lines(round)).toBe(2 * 18 * 2)
})

test('drawn roughly, round things have a third of the corners, and ten at least', () => {
  const corners = (solid: Solid, detail: Detail) =>
    solid.shape(detail).lines.getAttribute('position').count / 4
  const ring = (count: number) => new Solid().prism(circle(0, 0, 1, count), 0, 1)
  expect([36, 24, 20].map((count) => corners(ring(count), 'rough'))).toEqual([12, 10, 10])
  expect([36, 24, 20].map((count) => corners(ring(count), 'coarse'))).toEqual([18, 12, 10])
  for (const count of [20, 24, 36])
    expect(volume(ring(count), 'rough') / volume(ring(count))).toBeGreaterThan(0.93)
  // sharp corners stay, and what is round between them is thinned evenly
  const weight = new Solid().prism(sector(1, 2, 2, 0.9), 0, 1)
  expect(volume(weight, 'rough') / volume(weight)).toBeGreaterThan(0.97)
  const teeth = new Solid().prism(gear(1, 24), 0, 1)
  expect(volume(teeth, 'rough')).toBe(volume(teeth))
})

test('drawn coarsely, what is turned has lines only where it is widest, at the ends of that', () => {
  const grooved = new Solid().turned([
    [0, 0, 0],
    [0.8, 0, 0],
    [0.8, 0.3, 0],
    [1, 0.3, 0],
    [1, 0.5, 0],
    [1, 0.5, 1],
    [1, 0.6, 1],
    [1, 0.6, 0],
    [1, 0.9, 0],
    [0.9, 1, 0],
    [0, 1, 0],
  ])
  const heights = (detail: Detail) => {
    const at = grooved.shape(detail).lines.getAttribute('position')
    const places = Array.from({ length: at.count }, (_, index) => at.getY(index).toFixed(2))
    return [...new Set(places)].sort().map(Number)
  }
  expect(heights('fine')).toEqual([0, 0.3, 0.5, 0.6, 0.9, 1])
  expect(heights('coarse')).toEqual([0.3, 0.9])
})

test('a solid is made once from what its key says, and each that draws it has its own geometry', () => {
  let made = 0
  const bar = () => {
    made++
    return new Solid().turned(BAR)
  }
  const first = solidOf('a bar', bar)
  expect(solidOf('a bar', bar)).toBe(first)
  expect(made).toBe(1)
  const [one, other] = [first.shape().faces, first.shape().faces]
  expect(one).not.toBe(other)
  expect(one.getAttribute('position')).toBe(other.getAttribute('position'))
  expect(one.getIndex()).toBe(other.getIndex())
  one.setAttribute('hue', one.getAttribute('tint'))
  expect(first.shape().faces.hasAttribute('hue')).toBe(false)
  // what was not drawn for long is forgotten
  for (let index = 0; index < 96; index++) solidOf(`another ${index}`, () => new Solid())
  solidOf('a bar', bar)
  expect(made).toBe(2)
})

test('the faces of a solid are closed and look outward: its volume is that of the prism and the turned shape', () => {
  const square: Outline = [
    [0, 0],
    [2, 0],
    [2, 1],
    [0, 1],
  ]
  const hole: Outline = [
    [0.5, 0.25],
    [1, 0.25],
    [1, 0.75],
    [0.5, 0.75],
  ]
  expect(volume(new Solid().prism(square, 1, 4))).toBeCloseTo(6, 5)
  expect(volume(new Solid().prism(square, 4, 1, 0, [hole]))).toBeCloseTo(6 - 0.75, 5)
  const ring: [number, number, number][] = [
    [1, 0, 0],
    [2, 0, 0],
    [2, 1, 0],
    [1, 1, 0],
    [1, 0, 0],
  ]
  expect(volume(new Solid().turned(ring, 0, 2 * Math.PI, 400))).toBeCloseTo(3 * Math.PI, 2)
  expect(volume(new Solid().turned(ring, 0.3, 1.3, 400))).toBeCloseTo(1.5, 2)
})

test('a journal ends inside the web beside it, not in the plane of a cheek, where the two would flicker', () => {
  const one = shaft({
    z_from: -2,
    z_to: 3,
    throws: [
      { angle: 0, radius: 1, z: 0, pin_radius: 0.2, pin_from: -0.5, pin_to: 0.5, cylinders: [1] },
      { angle: 2, radius: 1, z: 1.75, pin_radius: 0.2, pin_from: 1.5, pin_to: 2, cylinders: [2] },
    ],
    webs: [
      { z_from: -0.9, z_to: -0.5, throw: 0 },
      { z_from: 0.5, z_to: 0.9, throw: 0 },
      { z_from: 1.1, z_to: 1.5, throw: 1 },
    ],
  })
  const expected = [
    [-2, -0.7],
    [0.7, 1.3],
    [2, 3],
  ]
  expect(journals(one).map((ends) => ends.map((z) => Number(z.toFixed(9))))).toEqual(expected)
})

test('the hull of points is what a rubber band round them would be', () => {
  const points = [0, 0, 2, 0, 1, 0.5, 2, 2, 0, 2, 1, 1, 1, 0]
  expect(new Set(hull(points))).toEqual(new Set([0, 1, 3, 4]))
})

test('teeth of gears that mesh stand in the gaps of each other, at any crank angle and whatever way they turn', () => {
  const wheel = (index: number, radius: number, teeth: number): GearShown => ({
    shaft: index,
    radius,
    z: 0,
    thickness: 0.1,
    teeth,
  })
  const shafts = [
    shaft(),
    shaft({ up: 2.1, right: 2.8, speed_ratio: -2 / 1.5 }),
    shaft({ up: 2.1, right: 6.8, speed_ratio: 0.8 }),
  ]
  const gears = [wheel(0, 2, 40), wheel(1, 1.5, 30), wheel(2, 2.5, 50)]
  const scene: Scene = { ...exhibit().scene, shafts, gears }
  const bearings = toothBearings(scene)
  for (const theta of [0, 0.37, 5]) {
    for (const [a, b] of [
      [0, 1],
      [1, 2],
    ] as const) {
      const [from, to] = [shafts[a], shafts[b]] as [
        ReturnType<typeof shaft>,
        ReturnType<typeof shaft>,
      ]
      const line = Math.atan2(to.right - from.right, to.up - from.up)
      const share = (index: number, away: number) => {
        const bearing = (bearings[index] as number) + (shafts[index]?.speed_ratio ?? 0) * theta
        return ((bearing - away) * (gears[index]?.teeth ?? 0)) / (2 * Math.PI)
      }
      const both = share(a, line) + share(b, line + Math.PI)
      expect(Math.abs(both - Math.round(both - 0.5) - 0.5)).toBeLessThan(1e-9)
    }
  }
})

test('opposed pistons share a bore to the middle between them, others end at their heads', () => {
  const pair = [cylinder({ number: 1, bearing: Math.PI }), cylinder({ number: 2, shaft: 1 })]
  const scene: Scene = { ...exhibit().scene, cylinders: pair, shafts: [shaft({ up: 14 }), shaft()] }
  expect(pair.map((c) => facesAnother(c, pair))).toEqual([true, true])
  expect(boreEnd(scene, pair[0] as (typeof pair)[0])).toBeCloseTo(7, 12)
  expect(boreEnd(exhibit().scene, cylinder())).toBe(6.2)
  expect(
    along(scene, cylinder({ bearing: Math.PI / 2, offset: 0.5 }), 3).map(
      (part) => +part.toFixed(12),
    ),
  ).toEqual([3, 13.5, 0])
})

describe('arrows', () => {
  const view = (arrows: Partial<View['arrows']>): View => ({
    theta: 0,
    camera: 'front',
    arrows: {
      force: true,
      couple: true,
      roll: false,
      axes: false,
      each: 'cylinders',
      orders: null,
      scale: 1,
      ...arrows,
    },
    whirl: { magnification: 0, orders: null },
    twist: twistChoiceOf({}),
    mounts: mountChoiceOf({}),
    glass: true,
    glow: true,
    section: 0,
    dark: false,
  })
  const loaded: Exhibit = exhibit({
    total: {
      force: { forward: [[3, 0]], backward: [[0, 0]] },
      couple: { forward: [[0, 2]], backward: [[0, 0]] },
      roll: [[0, 0]],
      torque: [[0, 0]],
    },
    cylinders: [{ number: 1, bank: '1', z: 0, force: { forward: [[2, 0]], backward: [[2, 0]] } }],
  })

  test('the longest of those shown has the design length, all forces have one scale', () => {
    const { pulls, force } = new Loads(loaded).at(view({}))
    expect(force).toBeCloseTo(4, 12)
    const rounded = (value: number) => +value.toFixed(12) + 0
    expect(pulls.map((pull) => [pull.kind, rounded(pull.up), rounded(pull.right)])).toEqual([
      ['force', 0.75, 0],
      ['couple', 0, 1],
      ['couple', 0, -1],
      ['couple', 0, 0],
      ['couple', 0, 0],
      ['part', 1, 0],
    ])
    expect(new Loads(loaded).at(view({ each: 'engine' })).force).toBeCloseTo(3, 12)
  })

  test('engines side by side share the scale of their arrows, in other units by m r w^2', () => {
    const twice = exhibit({
      ...loaded,
      total: { ...loaded.total, force: { forward: [[6, 0]], backward: [[0, 0]] } },
    })
    const loads = new Loads(loaded)
    loads.beside = [twice]
    expect(loads.at(view({ each: 'engine' })).force).toBeCloseTo(6, 12)
    const counted: [string, string] = ['m r ω²', 'm r ω² a']
    const units = { ...twice.units, counted }
    loads.beside = [{ ...twice, units, scale: { length: 1, force: 4, couple: 4, roll: 4 } }]
    // 6 of 4 in units of m r w^2, 3 of 1 here
    expect(loads.at(view({ each: 'engine' })).force).toBeCloseTo(3, 12)
    loads.beside = [{ ...twice, units, scale: { length: 1, force: 0.5, couple: 1, roll: 1 } }]
    expect(loads.at(view({ each: 'engine' })).force).toBeCloseTo(12, 12)
  })

  test('a couple is drawn in its plane, or as pitch upright and yaw level', () => {
    const couple = { forward: [[3, 4]], backward: [[0, 0]] } as Exhibit['total']['couple']
    const loads = new Loads({ ...loaded, total: { ...loaded.total, couple } })
    const pairs = (axes: boolean) =>
      loads
        .at(view({ axes }))
        .pulls.filter((pull) => pull.kind === 'couple')
        .map((pull) => [+(5 * pull.up).toFixed(9) + 0, +(5 * pull.right).toFixed(9) + 0])
    expect(pairs(false)).toEqual([
      [3, 4],
      [-3, -4],
      [0, 0],
      [0, 0],
    ])
    expect(pairs(true)).toEqual([
      [3, 0],
      [-3, 0],
      [0, 4],
      [0, -4],
    ])
  })

  test('the force of a bank is the sum of those of its cylinders, in their middle', () => {
    const force = (up: number) => ({ forward: [[up, 0]], backward: [[0, 0]] }) as const
    const part = (number: number, bank: string, up: number) => ({
      ...{ number, bank, z: number },
      force: force(up) as unknown as Exhibit['total']['force'],
    })
    const numbers = [1, 2, 3]
    const { scene } = exhibit()
    const banks = exhibit({
      ...loaded,
      scene: { ...scene, cylinders: numbers.map((number) => cylinder({ number, z: number })) },
      cylinders: [part(1, 'left', 2), part(2, 'right', 5), part(3, 'left', 1)],
    })
    const load = new Loads(banks).at(view({ each: 'banks' }))
    const shown = load.pulls.filter((pull) => pull.kind === 'part' && pull.up)
    expect(shown.map((pull) => [+(load.force * pull.up).toFixed(9), pull.z])).toEqual([
      [3, 2],
      [5, 2],
    ])
  })

  test('what is not wanted is not drawn', () => {
    const loads = new Loads(loaded)
    expect(
      loads
        .at(view({ force: false }))
        .pulls.filter((pull) => pull.up || pull.right)
        .map((pull) => pull.kind),
    ).toEqual(['couple', 'couple'])
    expect(loads.at(view({ orders: [2] })).pulls.every((pull) => !pull.up && !pull.right)).toBe(
      true,
    )
  })

  test('a sum that is rounding beside its parts is no arrow', () => {
    const little = { forward: [[1e-9, 0]], backward: [[0, 0]] } as Exhibit['total']['force']
    const [total] = new Loads({ ...loaded, total: { ...loaded.total, force: little } }).at(
      view({ each: 'engine' }),
    ).pulls
    expect(total?.up).toBeLessThan(1e-6)
  })
})

test('a cylinder is tinted by its stroke; a flash dies away', () => {
  const windows = windowsOf(
    exhibit({
      stroke_windows: [
        { chamber: 1, stroke: 'intake', from_deg: 300, to_deg: 580 },
        { chamber: 1, stroke: 'power', from_deg: 700, to_deg: 880 },
      ],
    }),
    COLOURS,
  )
  const out = new Float32Array(4)
  const at = (degrees: number) => {
    tint(windows[0] ?? [], degrees, 720, out, 0)
    return [...out]
  }
  const [begun, later] = [at(-20), at(120)]
  expect(begun[3]).toBeGreaterThan(0.8)
  expect(later[3]).toBeLessThan(0.3)
  expect(at(700 + 720 * 5)).toEqual(begun)
  expect(at(170)[3]).toBe(0)
  expect(at(400)[2]).toBeGreaterThan(at(400)[0] as number)
})

test('scales are round numbers with units', () => {
  expect([0.0034, 1, 4.9, 51, 199].map(roundValue).map((value) => +value.toPrecision(3))).toEqual([
    0.002, 1, 2, 50, 100,
  ])
  expect([quantity(2000, 'N'), quantity(0.005, 'N*m'), quantity(0.2, 'm r w^2')]).toEqual([
    '2000 N',
    '0.005 N*m',
    '0.2 m r w^2',
  ])
})

test.each([0.5, -0.5])(
  'a curved arrow begins at the top and turns clockwise where the roll is positive: %d',
  (share) => {
    const group = new Group()
    const load: Load = {
      ...{ pulls: [], force: 0, couple: 0, roll: 1, turning: share },
      about: [3, 2, 1],
    }
    const drawn = arrows(group, load, materials())
    drawn.move(1)
    const visible = group.children.filter(
      (child): child is InstancedMesh => child.visible && 'count' in child,
    )
    const pieces = visible.find(({ count }) => count > 1) as InstancedMesh
    const bearings = Array.from({ length: pieces.count }, (_, index) => {
      const place = new Matrix4()
      pieces.getMatrixAt(index, place)
      const [x, y, z] = new Vector3().setFromMatrixPosition(place).toArray()
      expect(Math.hypot(x - 3, y - 2)).toBeCloseTo(ROLL.radius, 5)
      expect(z).toBeCloseTo(1, 6)
      return Math.atan2(x - 3, y - 2)
    })
    expect(bearings[0]).toBeCloseTo(0, 6)
    const last = bearings[bearings.length - 1] as number
    expect(Math.sign(last)).toBe(Math.sign(share))
    expect(Math.abs(last)).toBeLessThan(Math.abs(share) * ROLL.angle)
    expect(Math.abs(last)).toBeGreaterThan(0.7 * Math.abs(share) * ROLL.angle)
    drawn.dispose()
  },
)
