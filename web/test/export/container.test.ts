import { describe, expect, test } from 'vitest'
import { bytes, float64, uint } from '../../src/export/bytes'
import type { Track } from '../../src/export/container'
import { mp4 } from '../../src/export/mp4'
import { webm } from '../../src/export/webm'

const frames = [40, 7, 9, 31, 8].map((length, index) => ({
  data: new Uint8Array(length).fill(index + 1),
  key: index % 3 === 0,
}))
const TRACK: Track = {
  codec: 'vp09.00.40.08',
  description: Uint8Array.of(1, 100, 0, 40),
  width: 640,
  height: 480,
  perSecond: 25,
  chunks: frames,
}
const of = async (blob: Blob) => new Uint8Array(await blob.arrayBuffer())
const number = (data: Uint8Array, at: number, count: number): number =>
  data.subarray(at, at + count).reduce((sum, byte) => 256 * sum + byte, 0)
const letters = (data: Uint8Array, at: number): string =>
  String.fromCharCode(...data.subarray(at, at + 4))

describe('numbers as bytes', () => {
  test('whole ones have the greatest byte first, beyond 32 bits too', () => {
    expect([...uint(258, 4)]).toEqual([0, 0, 1, 2])
    expect([...uint(2 ** 40 + 1, 8)]).toEqual([0, 0, 1, 0, 0, 0, 0, 1])
  })
  test('pieces stand one after the other', () => {
    expect([...bytes('ab', 7, Uint8Array.of(9))]).toEqual([97, 98, 7, 9])
    expect([...float64(1)]).toEqual([0x3f, 0xf0, 0, 0, 0, 0, 0, 0])
  })
})

describe('a film as MP4', () => {
  test('has boxes that fill it, and every frame where its table says', async () => {
    const data = await of(mp4(TRACK))
    const names: string[] = []
    let at = 0
    for (; at < data.length; at += number(data, at, 4)) names.push(letters(data, at + 4))
    expect(at).toBe(data.length)
    expect(names).toEqual(['ftyp', 'moov', 'mdat'])
    const text = String.fromCharCode(...data)
    const sizes = text.indexOf('stsz') + 12
    expect(number(data, sizes, 4)).toBe(frames.length)
    let place = number(data, text.indexOf('stco') + 12, 4)
    frames.forEach((frame, index) => {
      const size = number(data, sizes + 4 + 4 * index, 4)
      expect([...data.subarray(place, place + size)]).toEqual([...frame.data])
      place += size
    })
    expect(place).toBe(data.length)
  })
})

describe('a film as WebM', () => {
  /** Elements in a range: identifier and range of the contents. */
  function elements(data: Uint8Array, from: number, to: number) {
    const found: { id: number; from: number; to: number }[] = []
    for (let at = from; at < to; ) {
      const length = Math.clz32(data[at] as number) - 23
      const id = number(data, at, length)
      const size = number(data, at + length + 1, 7)
      const inside = at + length + 8
      found.push({ id, from: inside, to: inside + size })
      at = inside + size
    }
    return found
  }
  test('has a cluster for each key frame, found by the cues', async () => {
    const data = await of(webm(TRACK))
    const [, segment] = elements(data, 0, data.length)
    if (!segment) throw new Error('no segment')
    expect(segment.to).toBe(data.length)
    const parts = elements(data, segment.from, segment.to)
    const clusters = parts.filter(({ id }) => id === 0x1f43b675)
    expect(clusters).toHaveLength(2)
    const cues = parts.find(({ id }) => id === 0x1c53bb6b)
    const places = elements(data, cues?.from ?? 0, cues?.to ?? 0).map((cue) => {
      const place = elements(data, cue.from, cue.to).find(({ id }) => id === 0xb7)
      const at = elements(data, place?.from ?? 0, place?.to ?? 0).find(({ id }) => id === 0xf1)
      return segment.from + number(data, at?.from ?? 0, 8)
    })
    expect(places.map((place) => number(data, place, 4))).toEqual([0x1f43b675, 0x1f43b675])
    const blocks = clusters.flatMap(({ from, to }) =>
      elements(data, from, to).filter(({ id }) => id === 0xa3),
    )
    expect(blocks.map(({ from, to }) => [...data.subarray(from + 4, to)])).toEqual(
      frames.map((frame) => [...frame.data]),
    )
  })
})
