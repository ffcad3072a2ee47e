import { expect, test } from 'vitest'
import { HOME } from '../../src/stage/cameras'
import { clearestAzimuth, hiddenShare } from '../../src/stage/clearest'
import type { Disc } from '../../src/stage/extent'
import { type Pane, pixelsOf, placed, sheetOf } from '../../src/stage/panes'
import { slicesOf } from '../../src/stage/section'
import type { Camera } from '../../src/stage/stage'
import type { Vector } from '../../src/stage/vector'
import { next } from '../../src/ui/gestures'
import { cylinder, exhibit, shaft } from './engine'

const LOOKS = { orbit: HOME, azimuth: Math.PI / 3 }
const STAGE = { width: 770, height: 560, foot: 58, margin: 1.06 }
/** Engines whose greatest length is each way, [x, y, z]. */
const SHAPES: readonly Vector[] = [
  [1, 3, 9],
  [8, 2, 1],
  [2, 7, 2],
  [1, 1, 1],
]
const roomOf = ([x, y, z]: Vector, at: Vector = [0.3, -1, 2]): Disc[] =>
  [-0.5, 0.5].map((side) => ({
    centre: [at[0] + side * x, at[1] + side * y, at[2] + side * z],
    facing: [0, 0, 1],
    radius: 0,
  }))
const viewsOf = (panes: readonly Pane[]) =>
  Object.fromEntries(panes.map((pane) => [pane.camera, pane])) as Record<Camera, Pane>

test.each(SHAPES)(
  'front, side and plan of a sheet have one scale and stand in line (%d, %d, %d)',
  (...shape) => {
    const { front, side, plan } = viewsOf(sheetOf(LOOKS, [roomOf(shape)], STAGE))
    expect(pixelsOf(side)).toBeCloseTo(pixelsOf(front), 9)
    expect(pixelsOf(plan)).toBeCloseTo(pixelsOf(front), 9)
    const point: Vector = [0.7, -1.4, 2.2]
    const [inFront, inSide, inPlan] = [front, side, plan].map((pane) => placed(pane, point)) as [
      Vector,
      Vector,
      Vector,
    ]
    expect(inFront[1]).toBeCloseTo(inSide[1], 9)
    expect(inPlan[0]).toBeCloseTo(inSide[0], 9)
    expect(plan.y + plan.height).toBeLessThanOrEqual(side.y)
    expect(front.x + front.width).toBeLessThanOrEqual(side.x)
  },
)

test('as third-angle projection has it, what is nearer stands next to the side view', () => {
  const { front, plan } = viewsOf(sheetOf(LOOKS, [roomOf([1, 3, 9])], STAGE))
  const [left, right] = [placed(front, [0, 0, 0]), placed(front, [1, 0, 0])]
  expect(right[0]).toBeGreaterThan(left[0])
  expect(placed(plan, [1, 0, 0])[1]).toBeGreaterThan(placed(plan, [0, 0, 0])[1])
})

test.each(SHAPES)(
  'each view of a sheet holds the engine, above the foot (%d, %d, %d)',
  (...shape) => {
    const room = roomOf(shape)
    for (const pane of sheetOf(LOOKS, [room], STAGE)) {
      expect(pane.y + pane.height).toBeLessThanOrEqual(STAGE.height - STAGE.foot + 1e-9)
      for (const { centre } of room) {
        const [x, y] = placed(pane, centre)
        expect(x).toBeGreaterThanOrEqual(pane.x - 1e-9)
        expect(x).toBeLessThanOrEqual(pane.x + pane.width + 1e-9)
        expect(y).toBeGreaterThanOrEqual(pane.y - 1e-9)
        expect(y).toBeLessThanOrEqual(pane.y + pane.height + 1e-9)
      }
    }
  },
)

test('sheets of engines side by side have one scale', () => {
  const [small, large] = [roomOf([1, 2, 3]), roomOf([2, 3, 9])]
  const scale = (rooms: Disc[][]) => pixelsOf(viewsOf(sheetOf(LOOKS, rooms, STAGE)).front)
  expect(scale([small, large])).toBeCloseTo(scale([large, small]), 9)
  expect(scale([small])).toBeGreaterThan(scale([small, large]))
})

/** A V of two banks with so many pins. */
const vee = (pins: number) => {
  const base = exhibit().scene
  const places = Array.from({ length: pins }, (_, place) => -3 * place)
  return {
    ...base,
    shafts: [
      shaft({
        throws: places.map((z, place) => ({
          ...{ angle: 0, radius: 1, z, pin_radius: 0.3, pin_from: z - 0.6, pin_to: z + 0.6 },
          cylinders: [2 * place + 1, 2 * place + 2],
        })),
        webs: places.flatMap((z, index) => [
          { z_from: z - 0.8, z_to: z - 0.6, throw: index },
          { z_from: z + 0.6, z_to: z + 0.8, throw: index },
        ]),
      }),
    ],
    cylinders: places.flatMap((z, index) =>
      [-1, 1].map((side) =>
        cylinder({
          number: 2 * index + (side < 0 ? 1 : 2),
          throw: index,
          bearing: (side * Math.PI) / 4,
          z: z - 0.3 * side,
          rod_z: z - 0.3 * side,
        }),
      ),
    ),
  }
}

test('a section shows a pin with its webs, and its cylinders, front first', () => {
  const slices = slicesOf(vee(3))
  expect(slices.map(({ cylinders }) => cylinders)).toEqual([
    [1, 2],
    [3, 4],
    [5, 6],
  ])
  for (const [place, { from, to }] of slices.entries()) {
    expect(from).toBeCloseTo(-3 * place - 0.8, 2)
    expect(to).toBeCloseTo(-3 * place + 0.8, 2)
  }
})

test('pins of two shafts that stand side by side are in one slice', () => {
  const one = vee(1)
  const [first] = one.shafts
  const scene = {
    ...one,
    shafts: [...one.shafts, { ...shaft({ right: 5 }), throws: first?.throws ?? [] }],
    cylinders: [...one.cylinders, cylinder({ number: 3, shaft: 1 })],
  }
  expect(slicesOf(scene).map(({ cylinders }) => cylinders)).toEqual([[1, 2, 3]])
})

test('the isometric view is turned so that least of the bores is hidden', () => {
  const scene = vee(4)
  const look = (azimuth: number) => {
    const [sin, cos] = [Math.sin(azimuth), Math.cos(azimuth)]
    const [rise, level] = [Math.sqrt(1 / 3), Math.sqrt(2 / 3)]
    return {
      right: [cos, 0, -sin] as const,
      up: [-rise * sin, level, -rise * cos] as const,
      back: [level * sin, rise, level * cos] as const,
    }
  }
  const chosen = clearestAzimuth(scene)
  expect(hiddenShare(scene, look(chosen))).toBeLessThan(hiddenShare(scene, look(Math.PI / 9)))
  const front = { right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] } as const
  expect(hiddenShare(scene, front)).toBeGreaterThanOrEqual(0.75)
  expect(clearestAzimuth(vee(1))).toBeCloseTo(Math.PI / 4, 12)
})

test('swipes go round through the four views', () => {
  let camera: Camera = 'isometric'
  const seen = new Set<Camera>()
  for (let step = 0; step < 4; step++) {
    seen.add(camera)
    camera = next(camera, 1)
  }
  expect(seen.size).toBe(4)
  expect(camera).toBe('isometric')
  expect(next('front', -1)).toBe('isometric')
})
