import { expect, test } from 'vitest'
import type { Exhibit } from '../../src/exhibit'
import { AMPLITUDES, amplitudes, csv } from '../../src/export/csv'
import { angleWord, slug } from '../../src/export/fileNames'
import { paint } from '../../src/export/svgPen'
import { exhibit } from '../stage/engine'

test('cells with commas and quotes stand in quotes, and no cell is a formula', () => {
  expect(
    csv([
      ['a', 1.5, null],
      ['V8, "90"', '=1+1', '-2.5'],
    ]),
  ).toBe('\ufeffa,1.5,\r\n"V8, ""90""",\'=1+1,-2.5\r\n')
})

test('names of files have letters and digits of any script, and dashes', () => {
  expect(slug('V8, cross-plane crank, 90 deg')).toBe('v8-cross-plane-crank-90-deg')
  expect(slug(' ../直列4気筒 / x ')).toBe('直列4気筒-x')
  expect(angleWord(40)).toBe('40deg')
  expect(angleWord(12.5)).toBe('12p5deg')
})

test('colours are written as every program reads them', () => {
  expect(paint('fill', 'rgb(200 53 43 / 0.5)')).toEqual({ fill: '#c8352b', 'fill-opacity': '0.5' })
  expect(paint('stroke', 'rgba(0, 0, 0, 0)')).toEqual({ stroke: '#000000', 'stroke-opacity': '0' })
  expect(paint('fill', '#28323c')).toEqual({ fill: '#28323c' })
})

test('an amplitude has its size and its phase in degrees, in both directions of turning', () => {
  const turning = { forward: [[1, 0]], backward: [[0, 0]] } as Exhibit['total']['force']
  const shown = exhibit()
  const rows = amplitudes({ ...shown, sense: 1, total: { ...shown.total, force: turning } })
  const force = rows.filter((row) => row[AMPLITUDES.indexOf('unit')] === shown.units.force)
  const found = force.map((row) => [row[5], row[6], row[7]])
  expect(found).toEqual([
    ['vertical', shown.units.force_factor, 0],
    ['horizontal', shown.units.force_factor, -90],
    ['forward', shown.units.force_factor, 0],
    ['backward', 0, 0],
  ])
})
