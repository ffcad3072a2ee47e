import { expect, test } from 'vitest'
import { greatestOf, pointsOf, WIDE } from '../../src/edit/Curves'
import { changes } from '../../src/edit/changes'
import {
  angleIn,
  moved,
  snapped,
  snappedAngle,
  throwSnaps,
  turnedPin,
  valueIn,
} from '../../src/edit/control'
import { renamed } from '../../src/edit/naming'
import { stepText } from '../../src/edit/Steps'
import { type Grip, handleAt } from '../../src/edit/stageDrag'
import type { Control, Pin, Slider } from '../../src/exhibit'

const BANKS: Control = {
  key: 'layout.bank_angle',
  label: 'Bank angle',
  help: '',
  value: 90,
  unit: 'deg',
  low: 0,
  high: 180,
  step: 1,
  snaps: [60, 90],
  sets: [
    { path: 'layout.banks[1].bearing', factor: 0.5, added: 10 },
    { path: 'layout.banks[2].bearing', factor: -0.5, added: 10 },
  ],
  swept: true,
}
const V8 = {
  name: 'V8',
  layout: { banks: [{ bearing: '55 deg' }, { bearing: '-35 deg' }], throws: ['0 deg', '90 deg'] },
}

test('a bank angle turns both banks about the middle between them', () => {
  const to = moved(V8, BANKS, 60)
  expect(to.layout).toMatchObject({ banks: [{ bearing: '40 deg' }, { bearing: '-20 deg' }] })
  expect([valueIn(V8, BANKS), valueIn(to, BANKS)]).toEqual([90, 60])
  const below = { layout: { banks: [{ bearing: '100 deg' }, { bearing: '-100 deg' }] } }
  expect(valueIn(below, BANKS)).toBe(160)
})

test('a control reads the number of its file, in radians too, and keeps what is bare', () => {
  const factor = { ...BANKS, unit: '', sets: [{ path: 'balance_factor', factor: 1, added: 0 }] }
  expect(moved({}, factor, 0.55)).toEqual({ balance_factor: 0.55 })
  expect(valueIn({}, { ...factor, value: 0.2 })).toBe(0.2)
  const pin = { ...BANKS, high: 360, sets: [{ path: 'layout.throws[2]', factor: 1, added: 0 }] }
  expect(valueIn({ layout: { throws: [0, -Math.PI / 2] } }, pin)).toBe(270)
})

test('a drag comes to rest near an angle that makes sense, and nowhere else', () => {
  expect([58, 63.9, 65].map((angle) => snapped(angle, [60, 90], 4))).toEqual([60, 60, 65])
  const snaps = throwSnaps(5)
  expect(snappedAngle(143, snaps, 4)).toBe(144)
  expect(snappedAngle(-178, snaps, 4)).toBe(180)
  expect(snappedAngle(181, snaps, 4)).toBe(180)
})

test('a throw is turned in the unit of its list, which is written out if there is none', () => {
  const pin = (place: number, angle: number): Pin => ({
    path: `layout.throws[${place}]`,
    label: `${place}`,
    angle_deg: angle,
    bearing_deg: angle,
    fixed: place === 1,
  })
  const pins = [pin(1, 0), pin(2, -120), pin(3, 120)]
  expect(turnedPin(V8, pins, pins[1] as Pin, 75).layout).toMatchObject({
    throws: ['0 deg', '75 deg'],
  })
  const triple = { layout: { type: 'inline' } }
  expect(angleIn(triple, pins[1] as Pin)).toBe(-120)
  expect(turnedPin(triple, pins, pins[1] as Pin, -90).layout).toEqual({
    type: 'inline',
    throws: ['0 deg', '-90 deg', '120 deg'],
  })
})

test('a name that is no longer true says that the engine was edited, once', () => {
  const edited = (name: string): string => `${name}, edited`
  const known = new Set(['V8'])
  const other = moved(V8, BANKS, 60)
  expect(renamed(V8, other, known, edited).name).toBe('V8, edited')
  expect(renamed(V8, { ...V8, speed: '6000 rpm' } as typeof V8, known, edited).name).toBe('V8')
  const overbalanced = { ...V8, balance_factor: 0.6 }
  expect(renamed(V8, overbalanced as typeof V8, known, edited).name).toBe('V8, edited')
  expect(renamed(V8, { ...other, name: 'mine' }, known, edited).name).toBe('mine')
  const mine = { ...V8, name: 'mine' }
  expect(renamed(mine, moved(mine, BANKS, 60), known, edited).name).toBe('mine')
  const again = { ...V8, name: 'V8, edited' }
  expect(renamed(again, moved(again, BANKS, 60), new Set(['V8, edited']), edited).name).toBe(
    'V8, edited',
  )
})

test('a step of the history is told by what it changed', () => {
  const to = { ...V8, balance_factor: 0.5 }
  expect(changes(V8, to)).toEqual([{ path: 'balance_factor', from: '', to: '0.5' }])
  expect(stepText(V8, to)).toBe('balance_factor: nothing → 0.5')
  expect(stepText(undefined, V8)).toBe('Opened: V8')
  expect(stepText(V8, moved(V8, BANKS, 60))).toContain('layout.banks[1].bearing: 55 deg → 40 deg')
  expect(stepText(V8, moved(V8, BANKS, 60), [BANKS])).toBe('Bank angle: 90 → 60 deg')
  expect(stepText(V8, to, [BANKS])).toBe('balance_factor: nothing → 0.5')
})

test('curves of one quantity are drawn to one scale, over the whole range', () => {
  const curve = (what: string, results: number[]) => ({
    label: '',
    what,
    order: 1,
    unit: 'N',
    results,
    present: 0,
  })
  const curves = [curve('force', [0, 4]), curve('force', [2, 1]), curve('couple', [9, 9])]
  const slider: Slider = { key: '', present: 0, values: [10, 20], curves, range: '' }
  const most = greatestOf(curves)
  expect([...most]).toEqual([
    ['force', 4],
    ['couple', 9],
  ])
  const [first, last] = pointsOf(slider, curves[0] as (typeof curves)[0], 4).split(' ')
  expect([first, last]).toEqual(['0,40', `${WIDE},3`])
})

test('a bank is taken hold of on the front view, beside its cylinders only, and follows', () => {
  const said: unknown[] = []
  const session = {
    tree: { peek: () => V8 },
    direct: (to: unknown) => said.push(to),
  }
  const pane = {
    camera: 'front',
    x: 0,
    y: 0,
    width: 200,
    height: 200,
    scale: 20,
    origin: [100, 150],
  }
  const grip = {
    panes: [pane],
    scene: { cylinders: [{ crank_radius: 1, bore_to: 6 }], shafts: [], length_unit: 'm' },
    controls: [BANKS],
    session,
  } as unknown as Grip
  const at = (bearing: number, away: number): [number, number] => [
    100 + 20 * away * Math.sin((bearing * Math.PI) / 180),
    150 - 20 * away * Math.cos((bearing * Math.PI) / 180),
  ]
  expect(handleAt(grip, ...at(10, 4))).toBeNull()
  expect(handleAt(grip, ...at(55, 0.5))).toBeNull()
  const handle = handleAt(grip, ...at(55, 4))
  expect(handle?.follow(...at(41, 4), false)).toBe('Bank angle: 60°')
  expect(handle?.follow(...at(41, 4), true)).toBe('Bank angle: 62°')
  expect(said).toEqual([moved(V8, BANKS, 60), moved(V8, BANKS, 62)])
})

test('a weight is taken hold of on the side view where its file says z, and follows', () => {
  const weight = { unbalance: '1 kg*m', z: '50 mm' }
  const tree = { shaft: [{ weight: [weight, { ...weight, z: '-50 mm' }] }] }
  const said: unknown[] = []
  const drawn = (z: number) => ({ z, outer_radius: 0.1 })
  const grip = {
    panes: [
      { camera: 'side', x: 0, y: 0, width: 400, height: 200, scale: 1000, origin: [200, 100] },
    ],
    scene: {
      cylinders: [],
      shafts: [{ up: 0, weights: [drawn(0.05), drawn(-0.05)] }],
      length_unit: 'm',
    },
    controls: [],
    session: { tree: { peek: () => tree }, direct: (to: unknown) => said.push(to) },
  } as unknown as Grip
  expect(handleAt(grip, 200, 100)).toBeNull()
  const handle = handleAt(grip, 152, 120)
  expect(handle?.follow(142.2, 120, false)).toBe('z: 60 mm')
  expect(said).toEqual([
    { shaft: [{ weight: [{ ...weight, z: '60 mm' }, tree.shaft[0]?.weight[1]] }] },
  ])
  const without = { shaft: [{ weight: [{ unbalance: '1 kg*m' }, weight] }] }
  const other = { ...grip, session: { tree: { peek: () => without } } } as unknown as Grip
  expect(handleAt(other, 152, 120)).toBeNull()
})
