import { describe, expect, test } from 'vitest'
import documents from '../../docs/how-to/page.md?raw'
import { OPENING, type State, stateOf, stateText } from '../src/state'

const OTHER: State = {
  engine: '~eJyrVkrOSCxKzVOyUoguS8xRslJQSk',
  angle: 450.125,
  camera: 'front',
  section: 2,
  tab: 'derivation',
  force: false,
  couple: false,
  roll: false,
  axes: true,
  each: 'banks',
  orders: [0.5, 1, 2],
  quantity: 'couple',
  scale: 1.5,
  whirl: 250,
  glass: false,
  glow: false,
  pace: 0.05,
  theme: 'dark',
  present: true,
  fitted: true,
  beside: 'v8 & "flat" <b>#plane</b>',
  panel: '2',
  units: 'kN, kN m',
  language: 'ru',
  choices: { 'bearings.on': 'pin' },
}

describe('the state as text', () => {
  test('a page as it opens needs no words', () => {
    expect(stateText(OPENING)).toBe('')
    expect(stateOf('')).toEqual(OPENING)
  })

  test('every part comes back from its text', () => {
    for (const name of Object.keys(OTHER) as (keyof State)[])
      expect(OTHER[name], name).not.toEqual(OPENING[name])
    expect(stateOf(stateText(OTHER))).toEqual(OTHER)
    expect(stateOf(`#${stateText(OTHER)}`)).toEqual(OTHER)
  })

  test('each part has a key of its own', () => {
    for (const name of Object.keys(OTHER) as (keyof State)[]) {
      const one = { ...OPENING, [name]: OTHER[name] }
      expect(stateOf(stateText(one)), name).toEqual(one)
    }
  })

  test('short and legible', () => {
    expect(stateText({ ...OPENING, angle: 450, camera: 'front', orders: [1, 2] })).toBe(
      'a=450&camera=front&orders=1_2',
    )
    expect(stateText({ ...OPENING, angle: 0 })).toBe('a=0')
  })

  test.each([
    'a=abc',
    'a=',
    'a=1e99',
    'a=NaN',
    'camera=above',
    'tab=__proto__',
    'bearings.on=<b>',
    '__proto__.on=1',
    'a.b.c=1',
    'orders=',
    'orders=1_x',
    'orders=-1',
    'scale=0',
    'scale=Infinity',
    'whirl=-3',
    'speed=1000',
    'force=yes',
    'theme=<script>',
    'nonsense',
    '%E0%A4%A',
    'toString=1&constructor=2',
    `engine=${'x'.repeat(70_000)}`,
  ])('nonsense is as a page opens: %.40s', (text) => {
    expect(stateOf(text)).toEqual(OPENING)
  })

  test('nonsense in one part leaves the others', () => {
    expect(stateOf('a=90&camera=above&tab=stars')).toEqual({ ...OPENING, angle: 90, tab: 'stars' })
  })

  test('every key is told of in the documents', () => {
    for (const key of new URLSearchParams(stateText(OTHER)).keys())
      expect(documents).toContain(`\`${key}=`)
  })

  test('orders come sorted and once', () => {
    expect(stateOf('orders=2_1_2').orders).toEqual([1, 2])
  })
})
