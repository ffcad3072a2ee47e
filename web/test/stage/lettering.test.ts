import { afterEach, expect, test } from 'vitest'
import type { Exhibit } from '../../src/exhibit'
import { language } from '../../src/language/messages'
import { HOME, lookOf } from '../../src/stage/cameras'
import { footOf, type Writing, write } from '../../src/stage/lettering'
import { LIGHT } from '../../src/stage/palette'
import { CAMERAS } from '../../src/stage/stage'
import { exhibit } from './engine'

afterEach(() => {
  language.value = 'en'
})

const LETTER = 11
const LOOKS = { orbit: HOME, azimuth: Math.PI / 4 }

/** What is written on a sheet, and how far up from its baseline, middle or top it reaches, pixels. */
function written(
  width: number,
  height: number,
  camera: (typeof CAMERAS)[number],
  shake: object | null = null,
  roll = 0,
) {
  const texts: { text: string; top: number }[] = []
  const above = { bottom: LETTER, middle: LETTER / 2, top: 0 }
  const sheet: Record<string, unknown> = {
    measureText: (text: string) => ({ width: 6 * text.length }),
    fillText: (text: string, _x: number, y: number) =>
      texts.push({ text, top: y - above[sheet.textBaseline as keyof typeof above] }),
  }
  for (const name of ['arc', 'beginPath', 'clearRect', 'fill', 'lineTo', 'moveTo', 'stroke'])
    sheet[name] = sheet.strokeText = () => {}
  const writing = {
    panes: [
      {
        ...{ camera, x: 0, y: 0, width, height },
        frame: { look: lookOf(camera, LOOKS), centre: [0, 0, 0], half: 1 },
      },
    ],
    slice: null,
    view: { whirl: { magnification: 0, orders: null }, arrows: { force: true } },
    mounted: shake && { shake },
    moved: { up: 0, right: 0, tiltUp: 0, tiltRight: 0, turn: 0 },
    load: { force: 1, couple: 1, roll },
    arrow: 0.28,
    palette: LIGHT,
    width,
    height,
  } as unknown as Writing
  const numbers = { force_unit: { label: 'N', factor: 1 } }
  const shown = { ...exhibit(), ...(shake ? { mount_numbers: numbers } : {}) } as Exhibit
  write(sheet as unknown as CanvasRenderingContext2D, shown, writing)
  return texts
}

test.each([...CAMERAS])(
  'axes and scales keep to the foot of a narrow sheet, camera %s',
  (camera) => {
    for (const height of [250, 290, 640])
      for (const { text, top } of written(195, height, camera))
        if (text !== '1')
          expect(top, text).toBeGreaterThanOrEqual(height * (1 - footOf(195, height)))
  },
)

test('a long name does not push the scale of an arrow over the axes', () => {
  language.value = 'ru'
  const names = (width: number) =>
    written(width, 264, 'isometric').filter(({ text }) => text.includes('Продольный момент'))
  expect(names(320)).toEqual([])
  expect(names(520)).toHaveLength(1)
})

test('the arrow of the forces of mounts says at which speed they are, or at what movement', () => {
  const texts = (shake: object) =>
    written(900, 500, 'isometric', { most: 100, ...shake }).map(({ text }) => text)
  expect(texts({ free: false, rpm: 749.6 }).join()).toMatch(/ N {2}Force of a mount at 750 rpm/)
  expect(texts({ free: true, rpm: 0 }).join()).toMatch(/ N {2}Force of a mount at 1 mm/)
})

test('on a phone the roll has its scale and name too, above the others and within the foot', () => {
  for (const [width, height] of [
    [390, 265],
    [320, 240],
  ] as const) {
    const texts = written(width, height, 'isometric', null, 1)
    const top = (name: string) => texts.find(({ text }) => text.endsWith(name))?.top ?? Number.NaN
    expect(top('Roll')).toBeGreaterThanOrEqual(height * (1 - footOf(width, height)))
    expect(top('Force') - top('Roll')).toBeGreaterThanOrEqual(LETTER)
    expect(top('Couple') - top('Force')).toBeGreaterThanOrEqual(LETTER)
  }
})
