import { expect, test } from 'vitest'
import type { Exhibit } from '../src/exhibit'
import { lengthText, rangedText } from '../src/lengths'
import { rangeText } from '../src/ui/Now'
import { InUnits } from '../src/units'
import { exhibit } from './stage/engine'

const METRIC = [
  { label: 'µm', factor: 1e6 },
  { label: 'mm', factor: 1e3 },
]
const INCHES = [{ label: 'in', factor: 1 / 0.0254 }]
const RADII = [{ label: 'crank radii', factor: 1 }]

test('a length has the unit of which it is a tenth or more', () => {
  expect(lengthText(0.0864, METRIC)).toBe('86.4 mm')
  expect(lengthText(1e-4, METRIC)).toBe('0.1 mm')
  expect(lengthText(9.9e-5, METRIC)).toBe('99 µm')
  expect(lengthText(-0.002, METRIC)).toBe('−2 mm')
  expect(lengthText(0, METRIC)).toBe('0')
})

test('a length in a chosen unit has no other', () => {
  expect(lengthText(0.0254, INCHES)).toBe('1 in')
  expect(lengthText(0.00127, INCHES)).toBe('0.05 in')
  expect(lengthText(1e-12, INCHES)).toBe('0')
})

test('lengths without a size are in crank radii', () => {
  expect(lengthText(2.5, RADII)).toBe('2.5 crank radii')
  expect(lengthText(0, RADII)).toBe('0 crank radii')
})

test('a length over a range has three figures and its ends', () => {
  const unit = { label: 'mm', factor: 1e3 }
  expect(rangedText(0.0123456, [], unit)).toBe('12.35 mm')
  expect(rangedText(0.0123456, [0.0123456], unit)).toBe('12.35 mm')
  expect(rangedText(0.0123456, [0.01, 0.015678], unit)).toBe('12.3 (10 to 15.7) mm')
  expect(rangedText(0.0123456, [0.012347], unit)).toBe('12.3 mm')
})

test('a range goes from the least to the greatest', () => {
  expect(rangeText([1.26, -0.5, 3.04], 1)).toBe('(−0.5 to +3.0)')
  expect(rangeText([7, 7], 0)).toBe('')
})

test('an engine is in the units it came in until others have come', () => {
  const own: Exhibit = exhibit()
  const others = new InUnits()
  expect(others.of(own, '')).toBe(own)
  expect(others.of(own, 'si')).toBe(own)
  expect(others.of(own, 'us')).toBeUndefined()
  const inPounds = { ...own, units: { ...own.units, chosen: 'us' } }
  others.put(own, 'us', inPounds)
  expect(others.of(own, 'us')).toBe(inPounds)
  expect(others.of(own, 'kN')).toBeUndefined()
})
