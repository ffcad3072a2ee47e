import { afterAll, beforeAll, expect, test, vi } from 'vitest'
import { SvgPen } from '../../src/export/svgPen'

/** As much of a document as a pen needs to write lines. */
class Element {
  readonly attributes = new Map<string, string>()
  readonly within: Element[] = []
  setAttribute(name: string, value: string): void {
    this.attributes.set(name, value)
  }
  append(...parts: Element[]): void {
    this.within.push(...parts)
  }
}
const made: Element[] = []

beforeAll(() => {
  vi.stubGlobal('document', {
    createElementNS: () => made[made.push(new Element()) - 1],
    createElement: () => ({ getContext: () => null }),
  })
})
afterAll(() => vi.unstubAllGlobals())

/** The numbers of the only arc of a path: radius, radius, turn, long way, clockwise, x, y. */
function arc(from: number, to: number, back = false): number[] {
  const pen = new SvgPen(100, 100, 'arcs')
  pen.beginPath()
  pen.arc(50, 50, 10, from, to, back)
  pen.stroke()
  const path = made.at(-1)?.attributes.get('d') ?? ''
  expect(path.split('A')).toHaveLength(2)
  return (path.split('A')[1] ?? '').split(' ').map(Number)
}

test('an arc of more than half a turn takes the long way', () => {
  expect(arc(0, Math.PI / 2)).toEqual([10, 10, 0, 0, 1, 50, 60])
  expect(arc(0, (3 * Math.PI) / 2)).toEqual([10, 10, 0, 1, 1, 50, 40])
})

test('an arc that is drawn back goes the other way round', () => {
  expect(arc(Math.PI / 2, 0, true)).toEqual([10, 10, 0, 0, 0, 60, 50])
  expect(arc((3 * Math.PI) / 2, 0, true)).toEqual([10, 10, 0, 1, 0, 60, 50])
})
