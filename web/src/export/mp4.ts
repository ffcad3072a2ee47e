import { type Bytes, bytes, uint } from './bytes'
import type { Track } from './container'

const MILLISECONDS = 1000
/** Units of time in which a frame is counted. */
const TICKS = 1000
/** The unit matrix, in fixed-point numbers. */
const MATRIX = bytes(...[0x10000, 0, 0, 0, 0x10000, 0, 0, 0, 0x40000000].map((n) => uint(n, 4)))
const LANGUAGE = 0x55c4 // undetermined
const DPI_72 = 0x480000
/** Marks of a track: it is shown, in the film and its preview. */
const SHOWN = 7
const WITHIN = 1

const zeros = (count: number): Bytes => new Uint8Array(count)

/** A box of ISO/IEC 14496-12: size, name, contents. */
function box(name: string, ...contents: readonly (Bytes | string | number)[]): Bytes {
  const inside = bytes(...contents)
  return bytes(uint(8 + inside.length, 4), name, inside)
}

/** A box with a version (0) and marks. */
const full = (name: string, marks: number, ...contents: readonly (Bytes | string)[]): Bytes =>
  box(name, uint(marks, 4), ...contents)

/** A film as MP4: H.264, the contents before the frames, so that it plays while it comes. */
export function mp4(track: Track): Blob {
  const start = box('ftyp', 'isom', uint(0x200, 4), 'isomiso2avc1mp41')
  const frames = box('mdat', ...track.chunks.map(({ data }) => data))
  // as long wherever the frames are
  const place = start.length + contents(track, 0).length + 8
  return new Blob([start, contents(track, place), frames], { type: 'video/mp4' })
}

function contents(track: Track, place: number): Bytes {
  const { width, height, perSecond, chunks } = track
  const seconds = chunks.length / perSecond
  const shown = uint(Math.round(MILLISECONDS * seconds), 4)
  const mvhd = full(
    'mvhd',
    0,
    ...[zeros(8), uint(MILLISECONDS, 4), shown, uint(0x10000, 4), uint(0x100, 2)],
    ...[zeros(10), MATRIX, zeros(24), uint(2, 4)],
  )
  const tkhd = full(
    'tkhd',
    SHOWN,
    ...[zeros(8), uint(1, 4), zeros(4), shown, zeros(16), MATRIX],
    ...[uint(width * 0x10000, 4), uint(height * 0x10000, 4)],
  )
  const mdhd = full(
    'mdhd',
    0,
    ...[zeros(8), uint(TICKS * perSecond, 4), uint(TICKS * chunks.length, 4)],
    ...[uint(LANGUAGE, 2), zeros(2)],
  )
  const hdlr = full('hdlr', 0, zeros(4), 'vide', zeros(12), 'crankstar\0')
  const dinf = box('dinf', full('dref', 0, uint(1, 4), full('url ', WITHIN)))
  const minf = box('minf', full('vmhd', 1, zeros(8)), dinf, sampleTable(track, place))
  return box('moov', mvhd, box('trak', tkhd, box('mdia', mdhd, hdlr, minf)))
}

/** How the frames are coded, how long each lasts, which stand alone, how large, and where. */
function sampleTable({ width, height, description, chunks }: Track, place: number): Bytes {
  const count = uint(chunks.length, 4)
  const keys = chunks.flatMap(({ key }, frame) => (key ? [uint(frame + 1, 4)] : []))
  const avc1 = box(
    'avc1',
    ...[zeros(6), uint(1, 2), zeros(16), uint(width, 2), uint(height, 2)],
    ...[uint(DPI_72, 4), uint(DPI_72, 4), zeros(4), uint(1, 2), zeros(32)],
    ...[uint(24, 2), uint(0xffff, 2), box('avcC', description)],
  )
  return box(
    'stbl',
    full('stsd', 0, uint(1, 4), avc1),
    full('stts', 0, uint(1, 4), count, uint(TICKS, 4)),
    full('stss', 0, uint(keys.length, 4), ...keys),
    full('stsc', 0, uint(1, 4), uint(1, 4), count, uint(1, 4)),
    full('stsz', 0, zeros(4), count, ...chunks.map(({ data }) => uint(data.length, 4))),
    full('stco', 0, uint(1, 4), uint(place, 4)),
  )
}
