import { describe, expect, test } from 'vitest'
import { between, type Frame, frameOf, HOME, type Look, lookOf } from '../../src/stage/cameras'
import { type Disc, reach } from '../../src/stage/extent'
import { dragged, pressed, zoomed } from '../../src/stage/orbit'
import { CAMERAS } from '../../src/stage/stage'
import { dot, type Vector } from '../../src/stage/vector'

const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
]
const near = (a: Vector, b: Vector) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2])
const LOOKS = { orbit: HOME, azimuth: Math.PI / 4 }
const SCREEN = { aspect: 1.5, foot: 0.1, margin: 1.1 }
const discs: Disc[] = [
  { centre: [0.3, 1, 0.5], facing: [0, 1, 0], radius: 0.4 },
  { centre: [-1, -0.5, -2], facing: [0, 0, 1], radius: 0.7 },
  { centre: [0.2, 0, 1.5], facing: [0, 0, 1], radius: 0.2 },
]

describe.each([...CAMERAS])('camera %s', (camera) => {
  test('looks along a right-handed frame of unit vectors', () => {
    const { right, up, back } = lookOf(camera, LOOKS)
    expect(near(cross(right, up), back)).toBeLessThan(1e-15)
    for (const axis of [right, up, back]) expect(dot(axis, axis)).toBeCloseTo(1, 14)
  })

  test('sees everything between the head and the foot of the screen', () => {
    const { look, centre, half } = frameOf(camera, LOOKS, [discs], SCREEN)
    const spans = [look.right, look.up].map((axis) => {
      const [low, high] = reach(discs, axis, [0, 0])
      return [low - dot(axis, centre), high - dot(axis, centre)] as const
    })
    const [across, upward] = spans as [readonly [number, number], readonly [number, number]]
    expect(Math.max(-across[0], across[1])).toBeLessThan(half * SCREEN.aspect)
    expect(upward[1]).toBeLessThan(half)
    expect(upward[0]).toBeGreaterThan(-half * (1 - 2 * SCREEN.foot))
  })
})

test.each([...CAMERAS])('engines side by side have one scale on camera %s', (camera) => {
  const large = discs.map((disc) => ({ ...disc, radius: 3 * disc.radius }))
  const [one, other] = [
    frameOf(camera, LOOKS, [discs, large], SCREEN),
    frameOf(camera, LOOKS, [large, discs], SCREEN),
  ]
  expect(one.half).toBe(other.half)
  expect(one.half).toBeGreaterThan(frameOf(camera, LOOKS, [discs], SCREEN).half)
})

test('the reach of a disc is that of the points on its rim', () => {
  const axis: Vector = [0.6, 0, 0.8]
  const rim = discs.flatMap(({ centre, facing, radius }) => {
    const first: Vector = [1, 0, 0]
    const second = cross(facing, first)
    return Array.from({ length: 4000 }, (_, step) => {
      const angle = (step / 4000) * 2 * Math.PI
      const [c, s] = [radius * Math.cos(angle), radius * Math.sin(angle)]
      return dot(axis, centre) + c * dot(axis, first) + s * dot(axis, second)
    })
  })
  const [low, high] = reach(discs, axis, [0, 0])
  expect(low).toBeCloseTo(Math.min(...rim), 5)
  expect(high).toBeCloseTo(Math.max(...rim), 5)
})

test('plan and side have the front at the left, the front view has x to the right and y up', () => {
  const front = lookOf('front', LOOKS)
  expect([front.right, front.up]).toEqual([
    [1, 0, 0],
    [0, 1, 0],
  ])
  for (const camera of ['plan', 'side'] as const)
    expect(lookOf(camera, LOOKS).right).toEqual([0, 0, -1])
  expect(
    lookOf('isometric', LOOKS)
      .back.map((part) => part * Math.sqrt(3))
      .every((part) => Math.abs(part - 1) < 1e-12),
  ).toBe(true)
})

test('the way from one camera to another begins and ends at them, and never distorts', () => {
  const frame = (look: Look): Frame => ({ look, centre: [0, 0, 0], half: 1 })
  for (const from of CAMERAS) {
    for (const to of CAMERAS) {
      const [a, b] = [frame(lookOf(from, LOOKS)), frame(lookOf(to, LOOKS))]
      expect(near(between(a, b, 0).look.up, a.look.up)).toBeLessThan(1e-12)
      expect(near(between(a, b, 1).look.right, b.look.right)).toBeLessThan(1e-12)
      const { right, up, back } = between(a, b, 0.37).look
      expect(near(cross(right, up), back)).toBeLessThan(1e-12)
    }
  }
})

test('a look is found again from its rotation, also one that is turned by half a turn', () => {
  const frame = (look: Look): Frame => ({ look, centre: [0, 0, 0], half: 1 })
  const back: Look = { right: [-1, 0, 0], up: [0, 1, 0], back: [0, 0, -1] }
  for (const look of [lookOf('plan', LOOKS), back]) {
    const there = between(frame(lookOf('front', LOOKS)), frame(look), 1).look
    for (const axis of ['right', 'up', 'back'] as const)
      expect(near(there[axis], look[axis])).toBeLessThan(1e-12)
  }
})

test('dragging to the right turns the engine to the right; keys do the same; nothing goes over the top', () => {
  const orbit = { ...HOME }
  const front = () => dot([0, 0, 1], lookOf('orbit', { ...LOOKS, orbit }).right)
  const before = front()
  dragged(orbit, 20, 0)
  expect(front()).toBeGreaterThan(before)
  const dragged20 = front()
  expect(pressed(orbit, 'ArrowRight')).toBe(true)
  expect(front()).toBeGreaterThan(dragged20)
  dragged(orbit, 0, 1e5)
  expect(orbit.elevation).toBeCloseTo(Math.PI / 2, 12)
  zoomed(orbit, 1e9)
  expect(orbit.zoom).toBeLessThan(100)
  expect(pressed(orbit, 'Home') && orbit.zoom).toBe(1)
  expect(pressed(orbit, 'x')).toBe(false)
})
